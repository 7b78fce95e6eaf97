//! The speed that the gains are made of: entered by hand, and over ground calculated from positions (AP-7, AP-9).

use crate::rig::{Rig, route};
use wheelover_core::alerts::Alert;
use wheelover_core::geo::{Plane, Point, Position};
use wheelover_core::nmea::{self, Gll, with_checksum};
use wheelover_core::settings::Value;
use wheelover_core::station::Profile;
use wheelover_core::units::{METRES_PER_SECOND_PER_KNOT, wrap_180};
use wheelover_core::view::{ChartRequest, FaultKind, ModeName, ModeRequest, Order, Own, own};

fn select(rig: &mut Rig, mode: ModeRequest) -> Result<String, String> {
    rig.command(Order::Mode(mode))
}

fn source(rig: &mut Rig, source: &str) -> Result<String, String> {
    let (key, value) = ("speed_source".into(), Value::Choice(source.into()));
    rig.command(Order::Setting { key, value })
}

/// A ship in AUTO.
fn in_auto() -> Rig {
    let mut rig = Rig::new(route(&[(245.0, 4.0), (305.0, 2.5)], 0.5), 3);
    rig.run(5.0);
    select(&mut rig, ModeRequest::Auto).unwrap();
    rig.run(5.0);
    rig
}

fn shown(rig: &Rig) -> Own {
    own(rig.autopilot(), rig.now)
}

fn source_of(rig: &Rig, quantity: &str) -> Option<String> {
    let sources = shown(rig).sources;
    let found = sources.into_iter().find(|(name, _)| name == quantity);
    found.map(|(_, source)| source)
}

// AP-9: what is entered is what the gains are made of, marked as such, and nothing that is measured is missed.
#[test]
fn a_speed_entered_by_hand_makes_the_gains_and_is_marked() {
    let largest = |knots: f64| {
        let mut rig = in_auto();
        assert_eq!(
            (shown(&rig).manual_speed, source_of(&rig, "speed")),
            (None, None)
        );
        rig.set("manual_speed", knots).unwrap();
        let measured = rig.autopilot().speed().knots();
        assert!((measured - 15.0).abs() < 0.5, "not yet: {measured}");
        source(&mut rig, "manual").unwrap();
        assert_eq!(rig.autopilot().speed().knots(), knots);
        assert_eq!(shown(&rig).manual_speed, Some(knots));
        assert_eq!(source_of(&rig, "speed").as_deref(), Some("manual"));
        // Neither the log nor a receiver is asked.
        rig.filter(|_, from, line| {
            let speed = ["VTG,", "VHW,", "GLL,"]
                .iter()
                .any(|name| line.contains(name));
            let speed = speed || from == Profile::Log;
            (!speed).then(|| line.to_string())
        });
        rig.run(8.0);
        for alert in [Alert::SpeedLost, Alert::LowSpeed] {
            assert!(!rig.raised(alert), "{alert:?}: {}", rig.text(alert));
        }
        rig.command(Order::AdjustHeading(20.0)).unwrap();
        let from = rig.orders.len();
        rig.run(15.0);
        rig.check_orders();
        let orders = rig.orders[from..].iter().filter_map(|(_, order)| *order);
        orders.fold(0.0_f64, |most, order| most.max(order.abs()))
    };
    let (slow, fast) = (largest(7.0), largest(25.0));
    assert!((slow - fast).abs() > 1.0, "{slow} and {fast} degrees");
    let mut rig = in_auto();
    assert!(rig.set("manual_speed", 0.5).is_err());
    assert!(source(&mut rig, "wind").is_err());
}

// AP-7, App. B: AutoNAV is refused with CHANGE SPEED SOURCE; STANDBY and another source end that, in either order.
#[test]
fn autonav_is_refused_with_a_speed_entered_by_hand() {
    for (request, mode) in [
        (ChartRequest::Track, ModeName::AutonavTi),
        (ChartRequest::Heading, ModeName::AutonavTn),
    ] {
        for standby_first in [true, false] {
            let mut rig = in_auto();
            source(&mut rig, "manual").unwrap();
            assert!(!rig.raised(Alert::ChangeSpeedSource), "nothing was asked");
            rig.ask(request).unwrap();
            rig.run(4.0);
            let refused = select(&mut rig, ModeRequest::Autonav).unwrap_err();
            assert!(refused.starts_with("CHANGE SPEED SOURCE"), "{refused}");
            assert!(rig.raised(Alert::ChangeSpeedSource));
            let text = rig.text(Alert::ChangeSpeedSource);
            assert!(text.starts_with("CHANGE SPEED SOURCE: "), "{text}");
            rig.run(10.0);
            assert_eq!(rig.mode(), ModeName::Auto);
            if standby_first {
                select(&mut rig, ModeRequest::Standby).unwrap();
                rig.run(1.0);
                assert!(rig.raised(Alert::ChangeSpeedSource), "still by hand");
                source(&mut rig, "automatic").unwrap();
            } else {
                source(&mut rig, "automatic").unwrap();
                rig.run(1.0);
                assert!(rig.raised(Alert::ChangeSpeedSource), "not yet STANDBY");
                assert!(select(&mut rig, ModeRequest::Autonav).is_err());
                select(&mut rig, ModeRequest::Standby).unwrap();
            }
            rig.run(0.2);
            assert!(!rig.raised(Alert::ChangeSpeedSource));
            select(&mut rig, ModeRequest::Auto).unwrap();
            rig.run(3.0);
            let _ = rig.ask(request);
            select(&mut rig, ModeRequest::Autonav).unwrap();
            rig.until("AutoNAV", 20.0, |rig| rig.mode() == mode);
            rig.check_orders();
        }
    }
}

// AP-7: who is in AutoNAV, or has selected it, does not enter a speed; after it he may.
#[test]
fn no_speed_is_entered_by_hand_in_autonav() {
    let mut rig = Rig::tracking();
    let refused = source(&mut rig, "manual").unwrap_err();
    assert!(refused.contains("in AutoNAV"), "{refused}");
    assert_eq!(shown(&rig).manual_speed, None);
    select(&mut rig, ModeRequest::Dodge).unwrap();
    source(&mut rig, "manual").unwrap();
    // Back from DODGE there is no AutoNAV by it.
    rig.run(3.0);
    let back = select(&mut rig, ModeRequest::Dodge).unwrap();
    assert!(back.contains("CHANGE SPEED SOURCE"), "{back}");
    assert_eq!(rig.mode(), ModeName::Auto);
    let mut rig = in_auto();
    select(&mut rig, ModeRequest::Autonav).unwrap();
    assert!(source(&mut rig, "manual").is_err(), "it waits");
    select(&mut rig, ModeRequest::Cancel).unwrap();
    source(&mut rig, "manual").unwrap();
}

/// The position as GGA has it, with so many decimals of a minute.
fn gga(place: Position, decimals: usize) -> String {
    let part = |degrees: f64, width: usize| {
        let whole = degrees.abs().floor();
        let minutes = (degrees.abs() - whole) * 60.0;
        let size = decimals + 3;
        format!("{whole:0width$.0}{minutes:0size$.decimals$}")
    };
    let (lat, lon) = (part(place.lat, 2), part(place.lon, 3));
    with_checksum(&format!(
        "GPGGA,120000.00,{lat},N,{lon},E,2,09,0.9,20.0,M,17.0,M,2.0,0120"
    ))
}

/// From now on the own receiver says GGA once a second and nothing else, and nobody else where the ship is or how fast.
fn gga_only(rig: &mut Rig, decimals: usize) {
    rig.filter(move |_, from, line| {
        let gll = Gll::from_sentence(&nmea::decode(line.as_bytes())).and_then(|gll| gll.position);
        match (from, gll) {
            (Profile::Gps, Some(place)) => Some(gga(place, decimals)),
            (_, None) if line.contains("VTG,") || line.contains("VHW,") => None,
            (Profile::Ecdis, Some(_)) | (Profile::Log, _) => None,
            _ => Some(line.to_string()),
        }
    });
}

/// Sails on: the largest errors of the calculated course and speed, degrees and knots; it is there all the time.
fn errors(rig: &mut Rig, seconds: u32) -> (f64, f64) {
    let mut worst = (0.0_f64, 0.0_f64);
    for _ in 0..seconds {
        let before = rig.world().truth().position;
        rig.run(1.0);
        let made = Plane::at(before).point(rig.world().truth().position);
        let (course, speed) = (
            Point::default().bearing(made),
            made.distance(Point::default()) / METRES_PER_SECOND_PER_KNOT,
        );
        let (said, knots) = shown(rig).calculated.expect("a calculated speed");
        worst.0 = worst.0.max(wrap_180(said.unwrap() - course).abs());
        worst.1 = worst.1.max((knots - speed).abs());
    }
    worst
}

// AP-9: straight and in turns, by GGA of three and of four decimals; it is used where SOG is, and marked C.
#[test]
fn positions_make_a_speed_over_ground_where_nothing_measures_it() {
    for (decimals, course, speed) in [(4, 3.0, 0.6), (3, 4.0, 0.9)] {
        let mut rig = Rig::new(route(&[(245.0, 4.0), (305.0, 2.5)], 0.5), 3);
        gga_only(&mut rig, decimals);
        rig.run(15.0);
        assert_eq!(source_of(&rig, "ground").as_deref(), Some("gps/GP/C"));
        select(&mut rig, ModeRequest::Auto).unwrap();
        let straight = errors(&mut rig, 90);
        rig.command(Order::AdjustHeading(150.0)).unwrap();
        let turning = errors(&mut rig, 240);
        for (name, off) in [("straight", straight), ("turning", turning)] {
            assert!(
                off.0 < course && off.1 < speed,
                "{name}, {decimals} decimals: {off:?}"
            );
        }
        let (_, knots) = shown(&rig).calculated.unwrap();
        assert!((rig.autopilot().speed().knots() - knots).abs() < 1e-9);
        assert!(!rig.raised(Alert::SpeedLost) && !rig.raised(Alert::SpeedSource));
        rig.check_orders();
    }
}

// AP-9: a measured one always goes before; its loss is said as any change of source that nobody made.
#[test]
fn a_measured_speed_goes_before_a_calculated_one() {
    let mut rig = in_auto();
    rig.run(20.0);
    assert_eq!(shown(&rig).calculated, None);
    assert_eq!(source_of(&rig, "ground").as_deref(), Some("gps/GP/VTG"));
    gga_only(&mut rig, 4);
    rig.until("C", 6.0, |rig| shown(rig).calculated.is_some());
    rig.run(1.0);
    let text = rig.text(Alert::SpeedSource);
    let said = "Speed over ground from gps/GP/C instead of gps/GP/VTG";
    assert!(text.contains(said), "{text}");
    assert!(!rig.raised(Alert::SpeedLost));
    rig.run(20.0);
    rig.filter(|_, _, line| Some(line.to_string()));
    rig.run(1.5);
    assert_eq!(shown(&rig).calculated, None);
    assert!(!rig.raised(Alert::SpeedSource), "the better one is back");
    rig.check_orders();
}

// AP-9, FA9, FA10: without positions it ends at its age limit; what jumps makes no speed.
#[test]
fn a_calculated_speed_ends_with_its_positions_and_never_jumps() {
    let mut rig = in_auto();
    gga_only(&mut rig, 4);
    rig.run(30.0);
    let (_, before) = shown(&rig).calculated.unwrap();
    rig.injure(Profile::Gps, FaultKind::Jump, true);
    for _ in 0..400 {
        rig.step();
        if rig.raised(Alert::PositionJump) {
            assert_eq!(shown(&rig).calculated, None, "the receiver is not believed");
        }
        let knots = shown(&rig).calculated.map_or(before, |(_, knots)| knots);
        assert!((knots - before).abs() < 1.0, "{before} -> {knots} kn");
    }
    assert!(shown(&rig).calculated.is_some(), "steady again");
    rig.filter(|_, from, line| {
        let silent = matches!(from, Profile::Gps | Profile::Log)
            || ["GLL,", "VTG,", "VHW,"]
                .iter()
                .any(|name| line.contains(name));
        (!silent).then(|| line.to_string())
    });
    rig.run(4.0);
    assert!(shown(&rig).calculated.is_some());
    rig.run(2.2);
    assert_eq!(shown(&rig).calculated, None);
    assert!(rig.raised(Alert::SpeedLost));
    assert_eq!(rig.mode(), ModeName::Auto);
    rig.check_orders();
}
