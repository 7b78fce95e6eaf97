//! What the autopilot says: HTD, RSA, ROR, HDG, HDM, HDT, HMS, HMR, heel, and PEMC (AP-1 to AP-5, AP-10, AP-12, EMC-2, EMC-5).

use super::facts::Outlook;
use super::gear::Mount;
use super::hand_unit::{Due, told};
use super::modes::Modes;
use crate::nmea::{Hdg, Hdm, Hdt, TransducerType, TransducerUnit, Xdr, XdrReading};
use crate::settings::GearKind;
use crate::station::{Output, PortIndex, Profile, Role};
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
        let rows = rows.filter(|row| is_told(row.saying, setup.profile, outlook));
        lines.extend(rows.filter_map(|row| {
            let line = match (row.saying, setup.profile) {
                // EMC-7: to the gear its positions.
                (Saying::Ror, Profile::Gear) => {
                    let orders = outlook.gear.ror(modes.gives_orders());
                    let mount = Mount::of(outlook.facts.settings);
                    mount.positions(orders).line(row.talker?)
                }
                _ => line(row, modes, outlook, followed)?,
            };
            Some((port, line))
        }));
    }
    lines
}

/// What is owed to hand units: lines with their ports, and what becomes of settings.
pub(super) fn owed(
    all: Vec<Due>,
    modes: &Modes,
    outlook: &Outlook<'_>,
) -> (Vec<(PortIndex, String)>, Vec<Output>) {
    let (mut lines, mut outputs) = (Vec::new(), Vec::new());
    for due in all {
        match due {
            Due::Say(port, asked) => {
                let ports = &outlook.seen.picture.ports;
                let mut rows = talk::told(Role::Autopilot, ports[port].profile).iter();
                let row = rows.find(|row| row.saying == asked.saying());
                let said = row.and_then(|row| line(row, modes, outlook, true));
                lines.extend(said.map(|said| (port, said)));
            }
            Due::Changed => outputs.push(Output::Settings),
            Due::Keep(kept) => {
                let values = kept.values(outlook.facts.settings).into_iter();
                outputs.extend(values.map(|(key, value)| Output::Persist { key, value }));
            }
        }
    }
    (lines, outputs)
}

/// EMC-5: a plotter that is the compass is not told its own heading and heel.
fn is_told(saying: Saying, profile: Profile, outlook: &Outlook<'_>) -> bool {
    let of_compass = [Saying::Hdg, Saying::Hdm, Saying::Hdt, Saying::Xdr].contains(&saying);
    let external = profile == Profile::Plotter && outlook.facts.settings.external_compass;
    // A motor is told packets of its own, and would take a sentence for some.
    let motor = profile == Profile::Gear && outlook.facts.settings.gear != GearKind::Ror;
    !(external && of_compass || motor)
}

/// A sentence as it is now; absent where there is nothing to say, and what is not an autopilot's to say. `followed`: the
/// single rudder follows its order.
fn line(row: &Row, modes: &Modes, outlook: &Outlook<'_>, followed: bool) -> Option<String> {
    let (sight, gear) = (outlook.sight, outlook.gear);
    Some(match (row.saying, row.talker) {
        (Saying::Htd, Some(talker)) => modes.htd(outlook).line(talker),
        (Saying::Rsa, Some(talker)) => gear.rsa(outlook.rudders(), followed).line(talker),
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
            let (source, said) = sight.magnetic_compass(outlook.seen, outlook.facts.settings)?;
            Hdg {
                heading: Some(said.reading().deg()),
                deviation: said.deviation(),
                variation: sight.variation(outlook.seen, outlook.facts.settings),
            }
            .line(&source.talker)
        }
        (Saying::Hdm, None) => {
            let (source, said) = sight.magnetic_compass(outlook.seen, outlook.facts.settings)?;
            let heading = said.magnetic_heading().map(Heading::deg);
            Hdm { heading }.line(&source.talker)
        }
        // EMC-5
        (Saying::Xdr, Some(talker)) => {
            let heel = sight.heel(outlook.seen, outlook.facts.settings)?;
            let reading = XdrReading {
                kind: Some(TransducerType::Angle),
                reading: Some(heel),
                unit: Some(TransducerUnit::Degree),
                name: Some("HEEL".into()),
            };
            let readings = alloc::vec![reading];
            Xdr { readings }.line(talker)
        }
        (Saying::Pemc03, _) => told::installation(outlook.facts.settings),
        (Saying::Pemc05, _) => told::gains(outlook.facts.settings),
        (Saying::Pemc07, _) => told::information(modes.mode(), outlook),
        _ => return None,
    })
}
