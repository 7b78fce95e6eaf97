//! The table of facts: everything that is heard of the ship, with its type, its age limits, and the sentences that say it.
//!
//! One row makes a field of the [`Picture`](crate::picture::Picture), its place in the fold, and the sentences that a page
//! needs to decode. Which port may say a sentence stands in [`ports`]; what a sentence means for a fact in `read`.

pub(crate) mod fix;
pub(crate) mod known;
pub mod limits;
pub mod ports;
pub(crate) mod read;

use serde::{Deserialize, Serialize};

/// Makes the quantities and their limits from one list.
macro_rules! quantities {
    ($($(#[$doc:meta])* $name:ident $text:literal $late:literal $lost:literal;)*) => {
        /// A quantity that is heard.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Quantity {
            $($(#[$doc])* $name,)*
        }

        impl Quantity {
            /// Every quantity, in the order of the table.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// Its name in documents and on the page.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$name => $text,)* }
            }

            /// Age limits in milliseconds: late, lost (AP-9).
            #[must_use]
            pub const fn limits(self) -> (u64, u64) {
                match self { $(Self::$name => ($late, $lost),)* }
            }
        }
    };
}

quantities! {
    /// Course and speed over ground.
    Ground "ground" 3_000 5_000;
    /// Heading.
    Heading "heading" 1_200 2_000;
    /// Heel.
    Heel "heel" 3_000 5_000;
    /// What the chart system commands and measures: HTC, XTE, PNEY.
    Control "control" 3_000 5_000;
    /// What the autopilot reports: HTD, ROR.
    Report "report" 3_000 5_000;
    /// Position.
    Position "position" 3_000 5_000;
    /// Rate of turn.
    RateOfTurn "rate" 1_200 2_000;
    /// Rudder angle.
    Rudder "rudder" 1_200 2_000;
    /// Variation; where the ship is it does not change within an hour.
    Variation "variation" 60_000 3_600_000;
    /// Speed through the water.
    WaterSpeed "water" 3_000 5_000;
    /// Angle of the wind.
    Wind "wind" 3_000 5_000;
}

/// Gives the facts to the macro `$then`, a row each: field, one value or one a source, type, and the sentences that say it
/// with how each is read. A `report` is withdrawn at once where it is not valid; the last value of a sensor counts until its age limit (SEN-4, AP-9).
/// `own` are those that count when the station itself says them on the cable between chart system
/// and autopilot.
macro_rules! facts {
    ($then:ident) => {
        $then! {
            /// Headings, one a source.
            headings: many Bearing { hdt: read::hdt, ths: read::ths, hdg: read::hdg, hdm: read::hdm };
            /// Variation where the ship is, east positive, degrees.
            variation: one f64 { rmc: read::rmc_variation, hdg: read::hdg_variation };
            /// Rates of turn, one a source.
            rates: many RateOfTurn { rot: read::rot };
            /// Positions, one a source.
            fixes: many Fix { gll: read::gll, gga: read::gga, rmc: read::rmc_fix, gns: read::gns };
            /// Courses and speeds over ground, one a source.
            grounds: many Ground { vtg: read::vtg, rmc: read::rmc_ground };
            /// Speeds through the water, one a source.
            water_speeds: many Speed { vhw: read::vhw, vbw: read::vbw };
            /// Angles of the apparent wind from the bow, one a source.
            apparent_winds: many SignedAngle { mwv: read::mwv_apparent, vwr: read::vwr };
            /// Angles of the true wind from the bow, one a source.
            true_winds: many SignedAngle { mwv: read::mwv_true, vwt: read::vwt };
            /// Rudder response: of the single rudder, of the linked ones, or of the starboard one of a pair.
            rudder: one RudderAngle { rsa: read::rsa };
            /// Response of the port rudder of a pair.
            rudder_port: one RudderAngle { rsa: read::rsa_port };
            /// Rudder order, of the same side as the response.
            order: report RudderAngle { ror: read::ror } own { ror: read::ror };
            /// Order of the port rudder of a pair.
            order_port: report RudderAngle { ror: read::ror_port } own { ror: read::ror_port };
            /// Last HTC without a checksum or count fault; `at` only where it may be obeyed.
            htc: command Commanded { htc: read::htc };
            /// Cross-track distance for display.
            xte: one Xte { xte: read::xte };
            /// Cross-track distance for control.
            pney1: one Pney1 { pney1: read::pney1 };
            /// Radius centre and waypoint.
            pney2: one Pney2 { pney2: read::pney2 };
            /// What the autopilot reports.
            htd: report Htd { htd: read::htd } own { htd: read::htd };
        }
    };
}
pub(crate) use facts;
