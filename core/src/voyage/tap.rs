//! A tap on the cables inside: who watches may see, change, hold back or add what a station is about to hear.
//!
//! It is how faults are proven on the wiring that is shipped; a voyage without a tap is untouched by it.

use crate::station::{Profile, Role};
use crate::time::Stamp;
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

/// Bytes that a station is about to hear.
#[derive(Clone, Copy, Debug)]
pub struct Parcel<'a> {
    /// When.
    pub at: Stamp,
    /// Who hears them.
    pub to: Role,
    /// On which of its ports.
    pub profile: Profile,
    /// The bytes.
    pub bytes: &'a [u8],
}

/// Gives what the station hears instead; nothing, if it hears nothing.
pub type Tap = Box<dyn FnMut(Parcel<'_>) -> Option<Vec<u8>> + Send>;

/// Where a tap is set. It is no part of the voyage's state: a copy and a recording have none.
#[derive(Default)]
pub(super) struct Slot(pub(super) Option<Tap>);

impl Slot {
    /// What the tap makes of a parcel.
    pub(super) fn pass(&mut self, parcel: Parcel<'_>) -> Option<Vec<u8>> {
        match &mut self.0 {
            Some(tap) => tap(parcel),
            None => Some(parcel.bytes.to_vec()),
        }
    }

    /// Whether there is a tap.
    pub(super) const fn is_set(&self) -> bool {
        self.0.is_some()
    }
}

impl Clone for Slot {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl fmt::Debug for Slot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.is_set() { "a tap" } else { "no tap" })
    }
}
