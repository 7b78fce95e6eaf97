//! DODGE: the offset, and the way back to each mode it was selected in (AP-21).

use super::{check_htd, refused, sea, select, turned};
use crate::rig::Rig;
use wheelover_core::view::{ChartRequest, ModeName, ModeRequest, Order};

// AP-21, AP-1
#[test]
fn dodge_goes_round_and_comes_back_to_the_set_heading_of_auto() {
    for (side, release) in [(1.0, ModeRequest::Dodge), (-1.0, ModeRequest::Cancel)] {
        let mut rig = sea();
        let set = rig.set_heading();
        select(&mut rig, ModeRequest::Dodge);
        rig.run(20.0);
        assert!(turned(&rig, set).abs() < 1.5, "no offset at first");
        rig.command(Order::SetDodge(20.0 * side)).unwrap();
        rig.run(120.0);
        assert!((turned(&rig, set) - 20.0 * side).abs() < 1.5);
        assert_eq!(rig.autopilot().hts().map(|hts| hts.deg()), {
            Some((set + 20.0 * side).rem_euclid(360.0))
        });
        check_htd(&rig.last_htd().clone(), 35.0);
        refused(&mut rig, Order::SetDodge(91.0), "allowed are -90 to 90 deg");
        refused(&mut rig, Order::SetHeading(20.0), "in AUTO only");
        let answer = select(&mut rig, release);
        assert_eq!(answer, "DODGE released: AUTO");
        assert_eq!((rig.mode(), rig.set_heading()), (ModeName::Auto, set));
        rig.run(120.0);
        assert!(turned(&rig, set).abs() < 1.5);
        rig.check_orders();
    }
}

// AP-21, TCS-13: our chart system stops commanding one who leaves its control; what it has not taken up again is AUTO.
#[test]
fn dodge_comes_back_to_autonav_only_where_the_chart_system_commands_by_then() {
    let mut rig = Rig::tracking();
    rig.run(10.0);
    select(&mut rig, ModeRequest::Dodge);
    rig.command(Order::SetDodge(5.0)).unwrap();
    rig.run(30.0);
    let heading = rig.heading().deg();
    let answer = select(&mut rig, ModeRequest::Dodge);
    assert!(
        answer.contains("AUTO on the present heading, waits for"),
        "{answer}"
    );
    assert_eq!(rig.autopilot().why(), answer);
    assert!(
        turned(&rig, rig.set_heading()).abs() < 0.6 && (rig.set_heading() - heading).abs() < 0.6
    );
    rig.run(20.0);
    rig.check_orders();

    let mut rig = Rig::tracking();
    rig.run(10.0);
    select(&mut rig, ModeRequest::Dodge);
    rig.command(Order::SetDodge(2.0)).unwrap();
    rig.run(8.0);
    rig.ask(ChartRequest::Track).unwrap();
    rig.run(6.0);
    assert_eq!(rig.mode(), ModeName::Dodge, "HTC is not obeyed");
    let answer = select(&mut rig, ModeRequest::Dodge);
    assert_eq!(answer, "DODGE released: AutoNAV Ti");
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    rig.run(20.0);
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    rig.check_orders();
}

#[test]
fn dodge_is_selected_where_there_is_a_mode_to_return_to() {
    let mut rig = sea();
    for mode in [
        ModeRequest::FfuOverride,
        ModeRequest::RiverPilot,
        ModeRequest::Standby,
    ] {
        select(&mut rig, mode);
        refused(
            &mut rig,
            Order::Mode(ModeRequest::Dodge),
            "DODGE is selected from",
        );
    }
    rig.run(1.0);
    // AUTO pressed in DODGE holds the present heading (AP-21).
    select(&mut rig, ModeRequest::Auto);
    rig.run(2.0);
    select(&mut rig, ModeRequest::Dodge);
    rig.command(Order::SetDodge(30.0)).unwrap();
    rig.run(25.0);
    select(&mut rig, ModeRequest::Auto);
    assert!(turned(&rig, rig.set_heading()).abs() < 0.6);
}
