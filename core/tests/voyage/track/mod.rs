//! TRACK in closed loop: a plotter's route is sailed by its APB (AP-14, EMC-3, EMC-5).

pub(crate) mod plotter;

use crate::rig::{Rig, route};
use plotter::{Plotter, whole};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::{Reference, SteeringMode, TurnMode};
use wheelover_core::route::Route;
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// Two legs that the ship, heading 090, begins on.
pub(crate) fn plan() -> Route {
    route(&[(90.0, 2.0), (130.0, 2.7)], 0.5)
}

/// A ship in AUTO whose plotter has spoken for a few seconds.
pub(crate) fn in_auto(plotter: &mut Plotter, current: f64) -> Rig {
    let mut rig = Rig::heading_east(&[("plotter", Profile::Plotter)], current);
    rig.run(2.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.follow(plotter, 5, &whole);
    rig
}

/// The same in TRACK.
pub(crate) fn in_track(plotter: &mut Plotter, current: f64) -> Rig {
    let mut rig = in_auto(plotter, current);
    rig.command(Order::Mode(ModeRequest::Track)).unwrap();
    assert_eq!(rig.mode(), ModeName::Track);
    rig
}

fn off(rig: &Rig, leg: usize) -> f64 {
    let ship = rig.world().truth().position;
    plan().leg(leg).cross_track(ship).m()
}

// AP-14, EMC-3, FA6: in miles and kilometres, true and magnetic, by the plotter's heading and by the leg's course.
#[test]
fn a_plotters_route_is_sailed_leg_by_leg() {
    for (kilometres, variation, heading_to_steer, current) in [
        (false, None, false, 1.5),
        (true, None, false, -1.5),
        (false, Some(-7.5), false, 0.0),
        (true, Some(12.0), true, 0.0),
        (false, None, true, 0.0),
    ] {
        let mut plotter = Plotter {
            kilometres,
            variation,
            heading_to_steer,
            ..Plotter::new(&plan())
        };
        let mut rig = Rig::heading_east(&[("plotter", Profile::Plotter)], current);
        if let Some(variation) = variation {
            rig.set("variation", variation).unwrap();
        }
        rig.run(2.0);
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        rig.follow(&mut plotter, 5, &whole);
        let answer = rig.command(Order::Mode(ModeRequest::Track)).unwrap();
        assert!(answer.starts_with("TRACK to WP1 on "), "{answer}");
        rig.follow(&mut plotter, 330, &whole);
        let case = format!("{kilometres} {variation:?} {heading_to_steer} {current}");
        assert_eq!((rig.mode(), plotter.leg), (ModeName::Track, 0), "{case}");
        assert!(off(&rig, 0).abs() < 20.0, "{case}: {} m", off(&rig, 0));
        // AP-14: HTD says T, the set rudder limit, the leg's course by the north of the compass.
        let htd = rig.last_htd().clone();
        assert_eq!(
            htd.steering_mode,
            Some(SteeringMode::TrackControl),
            "{case}"
        );
        assert_eq!(htd.turn_mode, Some(TurnMode::NotControlled), "{case}");
        assert_eq!(htd.reference, Some(Reference::True), "{case}");
        assert_eq!(htd.rudder_limit, Some(20.0), "{case}");
        assert!((htd.track.unwrap() - 90.0).abs() < 0.06, "{case}: {htd:?}");
        assert_eq!((htd.radius, htd.rate_of_turn), (None, None), "{case}");
        let shown = rig.autopilot().cross_track().unwrap().m();
        assert!((shown - off(&rig, 0)).abs() < 10.0, "{case}: {shown}");
        // The waypoint is reached, said, and the next leg taken.
        rig.follow(&mut plotter, 90, &whole);
        assert!(rig.raised(Alert::Arrival), "{case}");
        rig.follow(&mut plotter, 540, &whole);
        assert_eq!((rig.mode(), plotter.leg), (ModeName::Track, 1), "{case}");
        assert!(off(&rig, 1).abs() < 25.0, "{case}: {} m", off(&rig, 1));
        let track = rig.last_htd().track.unwrap();
        assert!((track - 130.0).abs() < 0.06, "{case}: {track}");
        for alert in [
            Alert::OffTrack,
            Alert::TrackDataRefused,
            Alert::TrackFail,
            Alert::TrackDataLate,
        ] {
            assert!(!rig.raised(alert), "{case}: {}", rig.text(alert));
        }
        rig.check_orders();
    }
}

// AP-14: a leg that lies abeam is met by a smooth, bounded intercept.
#[test]
fn a_leg_abeam_is_met_without_a_step_and_without_overshoot() {
    for side in [-90.0, 90.0] {
        let mut plotter = Plotter::new(&route(&[(90.0, 4.0), (130.0, 2.0)], 0.5));
        let mut rig = in_auto(&mut plotter, 0.0);
        // Off the leg by hand.
        rig.command(Order::SetHeading(90.0 + side / 2.0)).unwrap();
        rig.follow(&mut plotter, 120, &whole);
        rig.command(Order::SetHeading(90.0)).unwrap();
        rig.follow(&mut plotter, 90, &whole);
        let begun = off(&rig, 0);
        assert!(begun * side > 40_000.0, "{begun}");
        rig.command(Order::Mode(ModeRequest::Track)).unwrap();
        let (mut beyond, mut steepest) = (0.0_f64, 0.0_f64);
        for _ in 0..420 {
            rig.follow(&mut plotter, 1, &whole);
            beyond = beyond.max(-off(&rig, 0) * side.signum());
            let hts = rig.last_htd().heading_to_steer.unwrap();
            steepest = steepest.max((hts - 90.0).abs());
        }
        assert!(off(&rig, 0).abs() < 20.0, "{side}: {}", off(&rig, 0));
        assert!(beyond < 40.0, "{side}: {beyond} m beyond the leg");
        assert!((15.0..=40.1).contains(&steepest), "{side}: {steepest}");
        rig.check_orders();
    }
}

// EMC-5, AP-10: the plotter is told the heading by the compass in use, and the rudder.
#[test]
fn the_plotter_is_told_heading_and_rudder_once_a_second() {
    let of = |rig: &Rig, formatter: &str| {
        let told = rig.sent.iter().filter(|(_, line)| line.contains(formatter));
        told.map(|(_, line)| line.clone()).collect::<Vec<_>>()
    };
    let mut gyro = Rig::heading_east(&[("plotter", Profile::Plotter)], 0.0);
    gyro.run(10.0);
    let heading = of(&gyro, "HEHDT,");
    assert!((9..=11).contains(&heading.len()), "{heading:?}");
    assert!(
        (9..=11).contains(&of(&gyro, "AGRSA,").len()),
        "{:?}",
        gyro.sent
    );
    assert_eq!((of(&gyro, "HDG,"), of(&gyro, "HDM,")), (vec![], vec![]));

    let mut magnetic = Rig::heading_east(
        &[("plotter", Profile::Plotter), ("magn", Profile::Magn)],
        0.0,
    );
    magnetic.silence(Profile::Gyro1, "");
    for _ in 0..10 {
        magnetic.say(Profile::Magn, "HCHDG,95.5,2.0,E,7.5,W");
        magnetic.run(1.0);
    }
    let told = |formatter: &str| of(&magnetic, formatter).pop().unwrap_or_default();
    assert!(
        told("HDG,").starts_with("$HCHDG,095.5,2.0,E,7.5,W*"),
        "{}",
        told("HDG,")
    );
    assert!(
        told("HDM,").starts_with("$HCHDM,097.5,M*"),
        "{}",
        told("HDM,")
    );
    assert!(
        told("HDT,").starts_with("$HCHDT,090.0,T*"),
        "{}",
        told("HDT,")
    );
}

// AP-26 in little: what the button is closed by is what a press is refused by.
#[test]
fn track_is_selected_from_auto_with_a_proven_apb_only() {
    let closed = |rig: &Rig| {
        let refusal = rig.autopilot().may_select(rig.now, ModeRequest::Track);
        refusal.err().map(|refusal| refusal.text)
    };
    let mut plotter = Plotter::new(&plan());
    let mut rig = Rig::heading_east(&[("plotter", Profile::Plotter)], 0.0);
    rig.follow(&mut plotter, 5, &whole);
    assert_eq!(
        closed(&rig).as_deref(),
        Some("TRACK is selected from AUTO only")
    );
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    assert_eq!(closed(&rig), None);
    rig.run(6.0);
    assert_eq!(closed(&rig).as_deref(), Some("no valid APB"));
    // FA14: three in a row.
    rig.follow(&mut plotter, 2, &whole);
    assert_eq!(closed(&rig).as_deref(), Some("no valid APB"));
    let refused = rig.command(Order::Mode(ModeRequest::Track));
    assert_eq!(refused.unwrap_err(), "no valid APB");
    rig.follow(&mut plotter, 1, &whole);
    rig.command(Order::Mode(ModeRequest::Track)).unwrap();
    assert_eq!(closed(&rig).as_deref(), Some("TRACK is active already"));
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    assert_eq!(rig.mode(), ModeName::Auto);
}

// FA7: without a heading the rudder is held, as in every mode that steers by one.
#[test]
fn a_lost_heading_holds_the_rudder() {
    let mut plotter = Plotter::new(&plan());
    let mut rig = in_track(&mut plotter, 0.0);
    rig.silence(Profile::Gyro1, "");
    rig.follow(&mut plotter, 4, &whole);
    assert_eq!(rig.mode(), ModeName::RudderHold);
    rig.check_orders();
}

// AP-21, FA6: round something and back to the plotter's leg; where the plotter has fallen silent meanwhile, to AUTO.
#[test]
fn dodge_leaves_track_and_comes_back_to_it_where_the_plotter_still_speaks() {
    for silent in [false, true] {
        let mut plotter = Plotter::new(&plan());
        let mut rig = in_track(&mut plotter, 0.0);
        rig.follow(&mut plotter, 20, &whole);
        rig.command(Order::Mode(ModeRequest::Dodge)).unwrap();
        rig.command(Order::SetDodge(20.0)).unwrap();
        rig.follow(&mut plotter, 90, &whole);
        assert_eq!(
            rig.last_htd().steering_mode,
            Some(SteeringMode::RudderControl)
        );
        assert!(off(&rig, 0) > 50.0, "{} m", off(&rig, 0));
        if silent {
            rig.run(8.0);
        }
        let answer = rig.command(Order::Mode(ModeRequest::Dodge)).unwrap();
        let expect = if silent {
            ModeName::Auto
        } else {
            ModeName::Track
        };
        assert_eq!(rig.mode(), expect, "{answer}");
        if !silent {
            rig.follow(&mut plotter, 400, &whole);
            assert!(off(&rig, 0).abs() < 15.0, "{} m", off(&rig, 0));
        }
        rig.check_orders();
    }
}
