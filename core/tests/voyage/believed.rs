//! What the autopilot believes of the ship is hers, whatever a sensor says; what it does not believe is named (AP-9, FA8, FA9).

use crate::rig::Rig;
use wheelover_core::facts::Quantity;
use wheelover_core::geo::{Plane, Point};
use wheelover_core::station::Profile;
use wheelover_core::view::{FaultKind, own};

/// Sources of a quantity that are not believed, by port.
fn refused(rig: &Rig, quantity: Quantity) -> Vec<String> {
    let said = own(rig.autopilot(), rig.now).refused;
    let of = said
        .into_iter()
        .filter(|refused| refused.quantity == quantity);
    of.map(|refused| format!("{} {}", refused.source, refused.why))
        .collect()
}

/// Metres between the believed place and the true one; absent where none is believed.
fn off(rig: &Rig) -> Option<f64> {
    let believed = own(rig.autopilot(), rig.now).position?;
    let off = Plane::at(rig.world().truth().position).point(believed);
    Some(off.distance(Point::default()))
}

#[test]
fn a_compass_that_jumped_is_named_and_the_heading_stays_the_ships() {
    let mut rig = Rig::tracking();
    rig.run(30.0);
    assert_eq!(refused(&rig, Quantity::Heading), [] as [String; 0]);
    rig.injure(Profile::Gyro1, FaultKind::Jump, true);
    let (mut bridged, mut none) = (0, 0);
    for step in 0..80 {
        rig.step();
        let own = own(rig.autopilot(), rig.now);
        match own.heading {
            Some(heading) => {
                let off = (heading - rig.heading().deg()).abs();
                assert!(off < 3.0, "{off} degrees off after {step} steps");
                bridged += 1;
            }
            None => none += 1,
        }
        if step > 1 {
            assert_eq!(refused(&rig, Quantity::Heading), ["gyro1/HE/HDT jumped"]);
        }
    }
    assert!((8..=14).contains(&bridged) && none > 60, "{bridged} {none}");
}

#[test]
fn a_receiver_that_jumped_is_named_and_the_place_stays_the_ships() {
    let mut rig = Rig::tracking();
    rig.run(30.0);
    assert!(off(&rig).is_some_and(|off| off < 20.0), "{:?}", off(&rig));
    rig.injure(Profile::Gps, FaultKind::Jump, true);
    let begun = rig.now;
    rig.until("the receiver is named", 1.5, |rig| {
        refused(rig, Quantity::Position)
            .iter()
            .any(|name| name.starts_with("gps/"))
    });
    let mut lost = None;
    while rig.now.since(begun) < 9_000 {
        rig.step();
        match off(&rig) {
            Some(off) => assert!(off < 40.0, "{off} m off"),
            None => {
                lost.get_or_insert(rig.now.since(begun));
            }
        }
    }
    assert!(
        lost.is_some_and(|lost| lost > 4_000),
        "no place without a fix for 5 s: {lost:?}"
    );
    // Steady where it is, it is believed again, and not named any more.
    rig.until("the new place is believed", 8.0, |rig| off(rig).is_some());
    assert!(off(&rig).is_some_and(|off| off > 300.0));
    rig.until("nothing is refused", 8.0, |rig| {
        refused(rig, Quantity::Position).is_empty()
    });
}
