//! The views of the page, and their addresses.

/// Which view is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// The bridge view.
    Bridge,
    /// The modes besides AUTO and AutoNAV, and what is set in them.
    Modes,
    /// Both directions of the dialogue.
    Dialogue,
    /// Lines explained.
    Decoder,
    /// What this is.
    About,
}

impl View {
    /// The view that an address names.
    #[must_use]
    pub fn of(hash: &str) -> Self {
        match hash {
            "#/modes" => Self::Modes,
            "#/dialogue" => Self::Dialogue,
            "#/decoder" => Self::Decoder,
            "#/about" => Self::About,
            _ => Self::Bridge,
        }
    }
}
