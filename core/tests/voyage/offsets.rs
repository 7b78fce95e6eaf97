//! The own receiver stands elsewhere than the chart system's: the ship is on the chart system's track all the same (TCS-4, AP-16).

use crate::rig::{Rig, edited, off_path, route};
use wheelover_core::alerts::Alert;
use wheelover_core::geo::{Plane, Point, Position};
use wheelover_core::nmea::{self, Gll, Hdt, Pney1, Xte};
use wheelover_core::station::Profile;
use wheelover_core::view::ModeName;

/// Moves what the own receiver says by `ahead` and `right` metres, of north or of the bow.
fn displace(rig: &mut Rig, (ahead, right): (f64, f64), of_the_bow: bool) {
    let mut bow = 245.0;
    rig.filter(move |_, from, line| {
        let sentence = nmea::decode(line.as_bytes());
        if let (Profile::Gyro1, Some(hdt)) = (from, Hdt::from_sentence(&sentence)) {
            bow = hdt.heading.unwrap_or(bow);
        }
        let gll = Gll::from_sentence(&sentence).and_then(|gll| gll.position);
        Some(match (from, gll) {
            (Profile::Gps, Some(place)) => {
                let axis = if of_the_bow { bow } else { 0.0 };
                let moved = Point::default()
                    .towards(axis, ahead)
                    .towards(axis + 90.0, right);
                let [lat, lon] = text(Plane::at(place).position(moved));
                edited(line, &[(1, &lat), (3, &lon)])
            }
            _ => line.into(),
        })
    });
}

fn text(place: Position) -> [String; 2] {
    let part = |degrees: f64, width: usize| {
        let whole = degrees.abs().floor();
        format!("{whole:0width$.0}{:08.5}", (degrees.abs() - whole) * 60.0)
    };
    [part(place.lat, 2), part(place.lon, 3)]
}

/// Sails leg, arc and leg; how far she is off the leg at its end by PNEY,001, off the arc at most, off the next leg, and
/// how far the believed place was from the true one on the arc.
fn sail(mut rig: Rig) -> [f64; 4] {
    let control = |rig: &Rig| {
        let line = rig.line("PNEY,001").to_string();
        let pney1 = Pney1::from_sentence(&nmea::decode(line.as_bytes())).unwrap();
        pney1.cross_track.unwrap().abs() * 1852.0
    };
    rig.until("wheel-over", 900.0, |rig| rig.chart().situation() == 3);
    let before = control(&rig);
    rig.until("the arc", 100.0, |rig| rig.chart().situation() == 4);
    let (mut arc, mut wrong) = (0.0_f64, 0.0_f64);
    while rig.chart().situation() == 4 {
        rig.step();
        let place = rig.world().truth().position;
        if rig.chart().situation() == 4 {
            arc = arc.max(off_path(&rig.route, rig.chart(), place));
            let believed = rig.autopilot().believed_position(rig.now).unwrap();
            wrong = wrong.max(Plane::at(place).point(believed).distance(Point::default()));
        }
    }
    rig.run(200.0);
    assert_eq!(rig.chart().situation(), 5);
    rig.check_orders();
    [before, arc, control(&rig), wrong]
}

// TCS-4: 20 m in eight directions; the averaged difference of the two positions takes them out.
#[test]
fn a_receiver_beside_the_chart_systems_does_not_move_the_track() {
    let [_, sound, ..] = sail(Rig::tracking());
    for bearing in 0..8 {
        let angle = f64::from(bearing) * 45.0_f64.to_radians();
        let mut rig = Rig::tracking();
        displace(&mut rig, (20.0 * angle.cos(), 20.0 * angle.sin()), false);
        let [before, arc, after, _] = sail(rig);
        assert!(
            before < 4.0 && after < 4.0,
            "{bearing}: {before} and {after} m off the legs"
        );
        assert!(
            arc < sound + 5.0,
            "{bearing}: {arc} m off the arc, {sound} without"
        );
    }
}

/// From now on the chart system sees the ship `metres` to starboard of where she is, in all that it says.
fn displace_chart(rig: &mut Rig, metres: f64) {
    let track = rig.route.leg(0).course().deg();
    rig.filter(move |_, from, line| {
        let sentence = nmea::decode(line.as_bytes());
        if from != Profile::Ecdis {
            return Some(line.into());
        }
        if let Some(place) = Gll::from_sentence(&sentence).and_then(|gll| gll.position) {
            let moved = Point::default().towards(track + 90.0, metres);
            let [lat, lon] = text(Plane::at(place).position(moved));
            return Some(edited(line, &[(1, &lat), (3, &lon)]));
        }
        let (said, field) = match sentence.formatter {
            "XTE" => (Xte::from_sentence(&sentence).and_then(|x| x.cross_track), 3),
            "PNEY,001" => (
                Pney1::from_sentence(&sentence).and_then(|x| x.cross_track),
                4,
            ),
            _ => (None, 0),
        };
        let Some(said) = said.map(|said| said + metres / 1852.0) else {
            return Some(line.into());
        };
        let side = if said > 0.0 { "L" } else { "R" };
        Some(edited(
            line,
            &[(field, &format!("{:.4}", said.abs())), (field + 1, side)],
        ))
    });
}

// TCS-4: the chart system's position jumps and stays, and its distances with it: refused at once, TRACK FAIL, never followed.
#[test]
fn a_jump_of_the_chart_systems_position_is_refused_and_not_followed() {
    for metres in [-150.0, -80.0, 80.0, 150.0] {
        let mut rig = Rig::tracking();
        rig.run(150.0);
        displace_chart(&mut rig, metres);
        rig.until("TRACK FAIL", 12.0, |rig| rig.mode() != ModeName::AutonavTi);
        assert!(rig.raised(Alert::TrackFail));
        let why = rig.autopilot().why().to_string();
        assert!(why.contains("moved apart by"), "{why}");
        let off = off_path(&rig.route, rig.chart(), rig.world().truth().position);
        assert!(off < 10.0, "{metres}: followed by {off} m");
    }
    // A step that receivers make is learned like a drift.
    let mut rig = Rig::tracking();
    rig.run(150.0);
    displace_chart(&mut rig, 20.0);
    rig.run(60.0);
    assert_eq!(rig.mode(), ModeName::AutonavTi);
}

// AP-16: an antenna 120 m aft and 20 m to port of the conning position.
#[test]
fn an_antenna_away_from_the_conning_position_does_not_carry_her_off_the_arc() {
    let [_, sound, ..] = sail(Rig::tracking());
    let mut rig = Rig::new(route(&[(245.0, 2.5), (305.0, 2.5)], 0.5), 3);
    displace(&mut rig, (-120.0, -20.0), true);
    for (key, value) in [
        ("antenna_forward_m", -120.0),
        ("antenna_starboard_m", -20.0),
    ] {
        rig.set(key, value).unwrap();
    }
    rig.engage();
    rig.run(30.0);
    let used = rig.autopilot().receiver_in_use().unwrap();
    assert_eq!(rig.autopilot().source_name(used), "gps/GP/GLL");
    let [before, arc, after, wrong] = sail(rig);
    assert!(
        before < 4.0 && after < 4.0,
        "{before} and {after} m off the legs"
    );
    assert!(arc < sound + 3.0, "{arc} m off the arc, {sound} without");
    assert!(wrong < 6.0, "believed {wrong} m beside the true place");
}

/// Sails leg and arc with a conning position 60 m forward of midships: how far that was off the arc at most.
fn off_the_arc(pivot: Option<f64>) -> f64 {
    let mut rig = Rig::tracking_as(|config| {
        config.chart.conning_offset_m = [60.0, 0.0];
        config.settings.conning_forward_m = 60.0;
        config.settings.pivot_forward_m = pivot;
    });
    rig.until("the arc", 900.0, |rig| rig.chart().situation() == 4);
    let mut most = 0.0_f64;
    while rig.chart().situation() == 4 {
        rig.step();
        let truth = rig.world().truth();
        let bow = Point::default().towards(truth.heading.deg(), 60.0);
        let conning = Plane::at(truth.position).position(bow);
        if rig.chart().situation() == 4 {
            most = most.max(off_path(&rig.route, rig.chart(), conning));
        }
    }
    rig.check_orders();
    most
}

// AP-16: the conning position is what sails the arc, and where the pivot point lies says how far the bow points in.
#[test]
fn the_pivot_point_says_how_far_the_bow_points_into_the_turn() {
    let ships = off_the_arc(None);
    let given = off_the_arc(Some(73.0));
    assert_eq!(given, ships, "the Mariner's own");
    let wrong = off_the_arc(Some(-60.0));
    assert!(
        ships < 15.0 && wrong > ships + 8.0,
        "{ships} m off the arc, {wrong} by a wrong one"
    );
}
