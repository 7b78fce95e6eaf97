//! The steering stand and its contacts go before what is selected here, and give the ship back only by the operator (AP-22, HTC-4,
//! FA12).

use crate::rig::Rig;
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::{OverrideStatus, SteeringMode};
use wheelover_core::station::{Profile, Switch};
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// A ship in AUTO with a stand.
fn in_auto() -> Rig {
    let mut rig = Rig::heading_east(&[("stand", Profile::Stand)], 0.0);
    rig.say(Profile::Stand, &htd("V,,,S"));
    rig.run(2.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.run(2.0);
    rig
}

fn htd(start: &str) -> String {
    format!("IIHTD,{start},,,,,,,,,T,A,A,,90.0")
}

impl Rig {
    /// The stand says this once a second.
    fn stand(&mut self, seconds: u32, start: &str) {
        for _ in 0..seconds {
            self.say(Profile::Stand, &htd(start));
            self.run(1.0);
        }
    }

    /// Nothing is ordered: HTD says so (AP-1), ROR is null.
    fn gives_nothing(&self, override_status: OverrideStatus) {
        let htd = self.last_htd();
        assert_eq!(htd.steering_mode, Some(SteeringMode::Manual));
        assert_eq!(htd.override_status, Some(override_status));
        assert_eq!((htd.rudder_angle, htd.turn_mode), (None, None));
        let limits = (htd.rudder_limit, htd.off_heading_limit);
        assert_eq!(limits, (Some(35.0), Some(20.0)));
        assert_eq!(
            (
                htd.radius,
                htd.rate_of_turn,
                htd.heading_to_steer,
                htd.track
            ),
            (None, None, None, None)
        );
        assert_eq!(self.autopilot().rudder_order(), None);
        assert!(
            self.told("ROR").starts_with("$AGROR,,V,,V,B*"),
            "{}",
            self.told("ROR")
        );
    }
}

/// What steers the ship, and what is refused meanwhile.
fn refuses_everything(rig: &mut Rig, reason: &str, standby: bool) {
    for order in [
        Order::Mode(ModeRequest::Auto),
        Order::Mode(ModeRequest::Autonav),
        Order::Mode(ModeRequest::Track),
        Order::SetHeading(120.0),
        Order::AdjustHeading(10.0),
    ] {
        let refused = rig.command(order.clone()).unwrap_err();
        assert!(
            refused.contains(reason) && refused.contains("goes before the operator"),
            "{order:?}: {refused}"
        );
    }
    let pressed = rig.command(Order::Mode(ModeRequest::Standby));
    assert_eq!(pressed.is_ok(), standby, "{pressed:?}");
}

// AP-22, FA12: by HTD and by the contact alike.
#[test]
fn the_nfu_line_takes_the_ship_at_once_and_gives_her_back_by_the_operator_only() {
    for by_contact in [false, true] {
        let mut rig = in_auto();
        let line = |rig: &mut Rig, closed: bool| {
            if by_contact {
                rig.switch(Switch::Nfu, Some(closed));
            } else {
                rig.say(Profile::Stand, &htd(if closed { "A,,,M" } else { "V,,,S" }));
            }
        };
        line(&mut rig, false);
        line(&mut rig, true);
        // Within one tick.
        assert_eq!(rig.mode(), ModeName::NfuOverride);
        assert!(rig.raised(Alert::Override));
        rig.run(1.2);
        rig.gives_nothing(OverrideStatus::InUse);
        refuses_everything(&mut rig, "the NFU line is in use", false);
        assert_eq!(rig.mode(), ModeName::NfuOverride);
        line(&mut rig, false);
        rig.run(1.5);
        assert_eq!(rig.mode(), ModeName::NfuOverride, "by the operator only");
        rig.gives_nothing(OverrideStatus::NotInUse);
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        assert_eq!(rig.mode(), ModeName::Auto);
        assert!(!rig.raised(Alert::Override));
        rig.check_orders();
    }
}

// AP-22: M is STANDBY, S gives nothing back.
#[test]
fn a_stand_at_hand_is_standby_until_the_operator_selects_something() {
    let mut rig = in_auto();
    rig.stand(2, "V,,,M");
    assert_eq!(rig.mode(), ModeName::Standby);
    assert!(rig.text(Alert::Override).contains("switched to hand"));
    rig.gives_nothing(OverrideStatus::NotInUse);
    refuses_everything(&mut rig, "the steering stand is switched to hand", true);
    rig.stand(3, "V,,,S");
    assert_eq!(rig.mode(), ModeName::Standby);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.stand(3, "V,,,S");
    assert_eq!(rig.mode(), ModeName::Auto);
    rig.check_orders();
}

// AP-22, HTC-4, FA6: R is FFU OVERRIDE with the lever's order; the operator's STANDBY goes before it.
#[test]
fn the_levers_order_is_followed_until_the_operator_takes_the_ship() {
    let mut rig = in_auto();
    rig.stand(4, "V,8.0,L,R");
    assert_eq!(rig.mode(), ModeName::FfuOverride);
    assert_eq!(
        rig.autopilot().rudder_order().map(|order| order.deg()),
        Some(-8.0)
    );
    rig.stand(4, "V,5.0,R,R");
    assert_eq!(
        rig.autopilot().rudder_order().map(|order| order.deg()),
        Some(5.0)
    );
    let refused = rig.command(Order::Mode(ModeRequest::Auto)).unwrap_err();
    assert!(refused.starts_with("the FFU lever steers"), "{refused}");
    rig.command(Order::Mode(ModeRequest::Standby)).unwrap();
    rig.stand(3, "V,9.0,R,R");
    assert_eq!(rig.mode(), ModeName::Standby);
    rig.stand(2, "V,,,S");
    rig.stand(2, "V,9.0,R,R");
    assert_eq!(rig.mode(), ModeName::FfuOverride);
    rig.stand(2, "V,,,S");
    assert_eq!(rig.mode(), ModeName::FfuOverride, "by the operator only");
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.check_orders();
}

// AP-22: nonsense and silence are said; the ship is steered as before, and the operator may do as he will.
#[test]
fn a_stand_that_is_silent_or_talks_nonsense_is_said_and_moves_nothing() {
    let mut rig = in_auto();
    for start in ["V,,,T", ",,,M", "V,,,R", "V,,,", "X,,,M"] {
        rig.stand(2, start);
        assert_eq!(rig.mode(), ModeName::Auto, "{start}");
        let text = rig.text(Alert::Stand);
        assert!(text.contains("HTD is not used: field"), "{start}: {text}");
        rig.stand(1, "V,,,S");
        assert!(!rig.raised(Alert::Stand), "{start}");
    }
    rig.run(6.0);
    assert!(
        rig.text(Alert::Stand).contains("silent"),
        "{}",
        rig.text(Alert::Stand)
    );
    assert_eq!(rig.mode(), ModeName::Auto);
    // It was at hand, and is silent then: nothing is given back by itself, and the operator is not locked out.
    rig.stand(2, "V,,,M");
    rig.run(6.0);
    assert_eq!(rig.mode(), ModeName::Standby);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    assert_eq!(rig.mode(), ModeName::Auto);
}

// AP-22: each contact; what cannot be read is said and moves nothing.
#[test]
fn contacts_of_lever_and_mode_switch_are_standby() {
    for (switch, safe, reason) in [
        (Switch::Ffu, true, "the FFU lever steers"),
        (
            Switch::Autopilot,
            false,
            "the mode switch is not at autopilot",
        ),
    ] {
        let mut rig = in_auto();
        rig.switch(switch, Some(!safe));
        rig.stand(1, "V,,,S");
        assert_eq!(rig.mode(), ModeName::Auto, "{switch:?}");
        rig.switch(switch, None);
        rig.stand(1, "V,,,S");
        assert_eq!(rig.mode(), ModeName::Auto, "{switch:?}");
        assert!(rig.text(Alert::Stand).contains(switch.name()), "{switch:?}");
        rig.switch(switch, Some(safe));
        assert_eq!(rig.mode(), ModeName::Standby, "{switch:?}");
        refuses_everything(&mut rig, reason, true);
        rig.switch(switch, Some(!safe));
        let early = rig.command(Order::Mode(ModeRequest::Auto)).unwrap_err();
        assert!(early.contains(reason), "it may still bounce: {early}");
        rig.stand(1, "V,,,S");
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        assert!(!rig.raised(Alert::Stand), "{switch:?}");
    }
}

// AP-22: HTD is told to the stand once a second.
#[test]
fn the_stand_is_told_what_the_autopilot_does() {
    let mut rig = in_auto();
    let from = rig.sent.len();
    rig.stand(10, "V,,,S");
    let told = &rig.sent[from..];
    assert!((9..=11).contains(&told.len()), "{told:?}");
    assert!(
        told.iter().all(|(_, line)| line.starts_with("$AGHTD,V,")),
        "{told:?}"
    );
}
