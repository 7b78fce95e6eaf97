//! Places along a path, beside it and back.

use super::*;

pub(super) fn right_turn() -> Path {
    let centre = Point {
        north: 1000.0,
        east: 500.0,
    };
    Path::turn(
        Course::from_deg(0.0),
        centre,
        Radius::from_m(500.0),
        Course::from_deg(90.0),
    )
}

fn check(path: &Path, north: f64, east: f64, part: Part, along: f64, across: f64) {
    let at = path.progress(Point { north, east });
    assert_eq!(at.part, part, "{at:?}");
    assert!(
        (at.along - along).abs() < 0.01 && (at.cross_track - across).abs() < 0.01,
        "{at:?}"
    );
}

#[test]
fn progress_runs_over_leg_arc_and_leg() {
    let path = right_turn();
    check(&path, 400.0, 10.0, Part::LegIn, -600.0, 10.0);
    let quarter = 500.0 * PI / 4.0;
    let diagonal = 500.0 / 2.0_f64.sqrt();
    check(
        &path,
        1000.0 + diagonal,
        500.0 - diagonal,
        Part::Arc,
        quarter,
        0.0,
    );
    check(
        &path,
        1480.0,
        800.0,
        Part::LegOut,
        2.0 * quarter + 300.0,
        20.0,
    );
}

#[test]
fn a_port_turn_counts_right_of_the_track_as_positive_too() {
    let centre = Point {
        north: 1000.0,
        east: -500.0,
    };
    let path = Path::turn(
        Course::from_deg(0.0),
        centre,
        Radius::from_m(500.0),
        Course::from_deg(270.0),
    );
    check(&path, 400.0, 10.0, Part::LegIn, -600.0, 10.0);
    let out = 510.0 / 2.0_f64.sqrt();
    check(
        &path,
        1000.0 + out,
        -500.0 + out,
        Part::Arc,
        500.0 * PI / 4.0,
        10.0,
    );
    check(
        &path,
        1480.0,
        -800.0,
        Part::LegOut,
        500.0 * PI / 2.0 + 300.0,
        -20.0,
    );
}

#[test]
fn what_is_left_counts_down_to_the_end_of_the_arc() {
    let path = right_turn();
    let length = path.arc_length();
    let check = |north, east, expect: Option<f64>| match (path.left(Point { north, east }), expect)
    {
        (Some(left), Some(expect)) => {
            assert!((left - expect).abs() < 1.0, "{left} {expect}")
        }
        (left, expect) => assert_eq!(left, expect),
    };
    check(900.0, 0.0, Some(length + 100.0));
    check(1353.553, 146.447, Some(length / 2.0));
    check(1510.0, 700.0, None);
    assert_eq!(path.leg_out().left(Point::default()), None);
}

#[test]
fn a_point_along_the_path_lies_there() {
    for path in [right_turn(), right_turn().leg_out()] {
        for (along, starboard) in [(-300.0, 25.0), (0.0, -10.0), (200.0, 40.0), (900.0, -30.0)] {
            let progress = path.progress(path.at(along, starboard));
            assert!((progress.along - along).abs() < 1e-6, "{progress:?}");
            assert!((progress.cross_track - starboard).abs() < 1e-6);
        }
    }
    let line = right_turn().drawn(0.0, 0.0);
    assert!(line[0].distance(right_turn().start()) < 1e-6 && line.len() > 20);
    assert!(line[line.len() - 1].distance(right_turn().leg_out().point) < 1e-6);
}

#[test]
fn a_turn_laid_at_its_corner_is_the_one_about_its_centre() {
    for (course_in, course_out) in [(245.0, 330.0), (330.0, 300.0), (10.0, 350.0), (90.0, 215.0)] {
        let (course_in, course_out) = (Course::from_deg(course_in), Course::from_deg(course_out));
        let radius = Radius::from_m(700.0);
        let corner = Point {
            north: -300.0,
            east: 800.0,
        };
        let path = Path::corner(corner, course_in, radius, course_out);
        let about = Path::turn(course_in, path.turn.unwrap().centre, radius, course_out);
        let reach = tangent(path.angle(), radius).m();
        assert!(path.point.distance(about.point) < 1e-9);
        assert!((corner.distance(path.start()) - reach).abs() < 1e-9);
        assert!((corner.distance(path.leg_out().point) - reach).abs() < 1e-9);
        let abeam = path.at(path.arc_length() / 2.0, 35.0);
        assert!((path.beside_arc(abeam) - 35.0).abs() < 1e-9, "{path:?}");
        let beyond = path.at(-400.0, 0.0);
        assert!(
            path.beside_arc(beyond) * path.side() < 0.0,
            "outside the circle"
        );
    }
}
