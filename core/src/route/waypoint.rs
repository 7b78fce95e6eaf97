//! A waypoint as it is planned: its place, its turn, and the corridor of the leg that leads there.

use crate::geo::Position;
use crate::units::{Distance, Radius};
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// A waypoint as it is planned.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Waypoint {
    /// Identifier; displays show its first three characters (TCS-5).
    pub id: String,
    /// Place.
    pub position: Position,
    /// Radius of the turn there; the first and the last waypoint have none.
    pub radius: Option<Radius>,
    /// Corridor of the leg that leads here, to port.
    pub limit_port: Distance,
    /// Corridor of the leg that leads here, to starboard.
    pub limit_starboard: Distance,
}

impl Waypoint {
    /// A waypoint with the usual corridor of a tenth of a mile on each side.
    #[must_use]
    pub fn new(id: &str, position: Position, radius: Option<Radius>) -> Self {
        let corridor = Distance::from_nm(0.1);
        Self {
            id: id.into(),
            position,
            radius,
            limit_port: corridor,
            limit_starboard: corridor,
        }
    }
}
