//! What the autopilot says: HTD, RSA, ROR, HDG, HDM, HDT, HMS and HMR (AP-1 to AP-5, AP-10, AP-12).

use super::facts::Outlook;
use super::modes::Modes;
use crate::nmea::{Hdg, Hdm, Hdt};
use crate::station::{PortIndex, Role};
use crate::talk::{self, Row, Saying, When};
use crate::units::Heading;
use alloc::string::String;
use alloc::vec::Vec;

/// What is due, with its port.
pub(super) fn due(
    due: When,
    modes: &Modes,
    outlook: &Outlook<'_>,
    followed: bool,
) -> Vec<(PortIndex, String)> {
    let mut lines = Vec::new();
    for (port, setup) in outlook.seen.picture.ports.iter().enumerate() {
        let rows = talk::told(Role::Autopilot, setup.profile).iter();
        let rows = rows.filter(|row| row.when == due);
        lines.extend(rows.filter_map(|row| Some((port, line(row, modes, outlook, followed)?))));
    }
    lines
}

/// A sentence as it is now; absent where there is nothing to say, and what is not an autopilot's to say. `followed`: the
/// single rudder follows its order.
fn line(row: &Row, modes: &Modes, outlook: &Outlook<'_>, followed: bool) -> Option<String> {
    let (sight, gear) = (outlook.sight, outlook.gear);
    Some(match (row.saying, row.talker) {
        (Saying::Htd, Some(talker)) => modes.htd(outlook).line(talker),
        (Saying::Rsa, Some(talker)) => gear.rsa(outlook.seen.rudders(), followed).line(talker),
        (Saying::Ror, Some(talker)) => gear.ror(modes.gives_orders()).line(talker),
        (Saying::Hms, Some(talker)) => sight.monitor().hms().line(talker),
        (Saying::Hmr, Some(talker)) => sight.monitor().hmr().line(talker),
        // AP-12: the heading goes on with its source's talker.
        (Saying::Hdt, None) => {
            if sight.is_magnetic() {
                return None; // AP-10
            }
            let source = sight.compass()?;
            let heading = Some(sight.heading()?.deg());
            Hdt { heading }.line(&source.talker)
        }
        // EMC-5: the compass in use, where it is a magnetic one.
        (Saying::Hdg, None) => {
            let (source, said) = sight.magnetic_compass(outlook.seen)?;
            Hdg {
                heading: Some(said.reading().deg()),
                deviation: said.deviation(),
                variation: sight.variation(outlook.seen, outlook.facts.settings),
            }
            .line(&source.talker)
        }
        (Saying::Hdm, None) => {
            let (source, said) = sight.magnetic_compass(outlook.seen)?;
            let heading = said.magnetic_heading().map(Heading::deg);
            Hdm { heading }.line(&source.talker)
        }
        _ => return None,
    })
}
