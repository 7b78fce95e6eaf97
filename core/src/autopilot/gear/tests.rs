//! An independent pair of rudders, and the port side of what is none (AP-4, FA6, FA11).

use super::Gear;
use crate::alerts::Alert;
use crate::autopilot::notices::Notice;
use crate::autopilot::steering::{SteeringSettings, Terms, Wanted};
use crate::settings::Rudders;
use crate::time::Stamp;
use crate::units::{Heading, RateOfTurn, RudderAngle};
use alloc::format;
use alloc::vec::Vec;

const ALERTS: [Alert; 2] = [Alert::Rudder, Alert::RudderPort];
const SIDES: [&str; 2] = ["starboard", "port"];
const SLEW: f64 = 5.0;
const LIMIT: f64 = 20.0;

/// Steers for `seconds` towards `wanted` degrees; `feedback` gives both responses from the orders.
fn steer(
    gear: &mut Gear,
    now: &mut u64,
    seconds: u64,
    wanted: f64,
    feedback: impl Fn([f64; 2]) -> [Option<f64>; 2],
) -> Vec<Notice> {
    let none = Terms {
        proportional: 0.0,
        integral: 0.0,
        rate: 0.0,
        feedforward: 0.0,
    };
    let wanted = Wanted {
        rudder: RudderAngle::from_deg(wanted),
        joins: false,
        ordered: false,
        hts: Heading::from_deg(0.0),
        rate_reference: RateOfTurn::default(),
        cross_track: None,
        terms: none,
    };
    let ship = SteeringSettings {
        slew: SLEW,
        ..SteeringSettings::default()
    };
    let orders = |gear: &Gear| {
        let ror = gear.ror(true);
        [ror.starboard.unwrap(), ror.port.unwrap()]
    };
    let mut said = Vec::new();
    for _ in 0..seconds * 10 {
        let before = orders(gear);
        gear.steer(&wanted, RudderAngle::from_deg(LIMIT), &ship, 0.1);
        let after = orders(gear);
        for (before, after) in before.into_iter().zip(after) {
            assert!((after - before).abs() <= SLEW * 0.1 + 1e-9, "FA6");
            assert!(after.abs() <= LIMIT + 1e-9, "FA6");
        }
        *now += 100;
        let responses = feedback(after).map(|angle| angle.map(RudderAngle::from_deg));
        said = gear.watch(Stamp(*now), true, responses, SLEW).collect();
    }
    said
}

// AP-4, FA11, FA6: the healthy one makes up for the one that sticks, to its limit, and no further.
#[test]
fn the_healthy_side_makes_up_for_the_one_that_sticks() {
    for swapped in [false, true] {
        let sides = |healthy: usize| if swapped { 1 - healthy } else { healthy };
        let mut gear = Gear::of(Rudders::Independent);
        let mut now = 0;
        let both = |orders: [f64; 2]| orders.map(Some);
        steer(&mut gear, &mut now, 5, 4.0, both);
        assert!((gear.order().deg() - 4.0).abs() < 1e-9);
        let (healthy, stuck) = (sides(0), sides(1));
        let sticks = |mut orders: [f64; 2]| {
            orders[stuck] = 4.0;
            orders.map(Some)
        };
        let said = steer(&mut gear, &mut now, 20, 10.0, sticks);
        assert_eq!(said[healthy], Notice::Rectified(ALERTS[healthy]));
        let text = format!(
            "the {} rudder does not follow its order: the {} rudder steers",
            SIDES[stuck], SIDES[healthy]
        );
        assert_eq!(said[stuck], Notice::Raised(ALERTS[stuck], text));
        let orders = |gear: &Gear| {
            let ror = gear.ror(true);
            [ror.starboard.unwrap(), ror.port.unwrap()]
        };
        assert!((orders(&gear)[healthy] - 16.0).abs() < 1e-9, "{gear:?}");
        assert!((orders(&gear)[stuck] - 10.0).abs() < 1e-9, "it goes on");
        assert!((gear.order().deg() - 10.0).abs() < 1e-9);
        assert!(gear.given().cut.abs() < 1e-9);
        // AP-5: at the limit of the healthy one nothing is asked in vain without being said.
        steer(&mut gear, &mut now, 10, 16.0, sticks);
        assert!((orders(&gear)[healthy] - LIMIT).abs() < 1e-9);
        assert!((gear.given().cut - 4.0).abs() < 1e-9, "{:?}", gear.given());
        assert!(gear.steered().unwrap().limited);
        let rsa = gear.rsa(sticks([0.0; 2]).map(|a| a.map(RudderAngle::from_deg)), true);
        let status = [rsa.starboard_status, rsa.port_status].map(|status| status.unwrap().letter());
        assert_eq!((status[healthy], status[stuck]), ('A', 'V'));
        // It follows again: believed after ten seconds, and not before.
        steer(&mut gear, &mut now, 9, 4.0, sticks);
        assert!((orders(&gear)[healthy] - 4.0).abs() < 1e-9);
        steer(&mut gear, &mut now, 12, 4.0, both);
        let said = steer(&mut gear, &mut now, 5, 10.0, both);
        assert_eq!(said, ALERTS.map(Notice::Rectified));
        assert!(
            orders(&gear)
                .iter()
                .all(|order| (order - 10.0).abs() < 1e-9)
        );
    }
}

// AP-4: without feedback it is taken to follow its order, which goes on.
#[test]
fn a_side_without_feedback_gets_its_order_on() {
    for lost in 0..2 {
        let mut gear = Gear::of(Rudders::Independent);
        let mut now = 0;
        let silent = |orders: [f64; 2]| {
            let mut said = orders.map(Some);
            said[lost] = None;
            said
        };
        let said = steer(&mut gear, &mut now, 5, 12.0, silent);
        let text = format!(
            "the {} rudder has no feedback: the {} rudder steers",
            SIDES[lost],
            SIDES[1 - lost]
        );
        assert_eq!(said[lost], Notice::Raised(ALERTS[lost], text));
        let ror = gear.ror(true);
        assert_eq!((ror.starboard, ror.port), (Some(12.0), Some(12.0)));
        let heard = silent([11.0, 11.0]).map(|angle| angle.map(RudderAngle::from_deg));
        assert_eq!(gear.acting(heard), Some(RudderAngle::from_deg(11.0)));
        let rsa = gear.rsa(heard, true);
        let angles = [rsa.starboard, rsa.port];
        assert_eq!((angles[lost], angles[1 - lost]), (None, Some(11.0)));
        for said in steer(&mut gear, &mut now, 1, 12.0, |_| [None, None]) {
            let by_hand = |text: &str| text.ends_with("has no feedback: steer by hand");
            assert!(
                matches!(&said, Notice::Raised(_, text) if by_hand(text)),
                "{said:?}"
            );
        }
    }
}

// AP-4: single and linked rudders stand on the starboard side, whatever is said of the port one.
#[test]
fn without_a_pair_the_port_side_is_null_with_v() {
    for rudders in [Rudders::Single, Rudders::Linked] {
        let gear = Gear::of(rudders);
        let heard = [Some(RudderAngle::from_deg(3.0)); 2];
        let (rsa, ror) = (gear.rsa(heard, true), gear.ror(true));
        assert_eq!(rsa.line("AG"), "$AGRSA,3.0,A,,V*7C");
        assert_eq!(ror.line("AG"), "$AGROR,0.0,A,,V,B*1E");
    }
}
