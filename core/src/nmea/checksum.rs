//! What became of a sentence's checksum (SEN-2).

/// What the checksum of a line says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Checksum {
    /// It is right.
    Right(u8),
    /// It differs.
    Wrong {
        /// What stands there; none where it cannot be read.
        given: Option<u8>,
        /// What it should be.
        computed: u8,
    },
    /// There is none.
    Missing {
        /// What it should be.
        computed: u8,
    },
}

impl Checksum {
    /// Whether it stands there and is right.
    #[must_use]
    pub const fn is_right(self) -> bool {
        matches!(self, Self::Right(_))
    }
    /// What it is or should be.
    #[must_use]
    pub const fn computed(self) -> u8 {
        match self {
            Self::Right(computed) | Self::Wrong { computed, .. } | Self::Missing { computed } => {
                computed
            }
        }
    }
}
