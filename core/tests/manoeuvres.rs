//! The Mariner sails the reference manoeuvres.
#![allow(clippy::unwrap_used)]

use std::f64::consts::PI;
use wheelover_core::world::{Drive, Hull};

const STEP: f64 = 0.05;

fn rows(name: &str) -> Vec<Vec<f64>> {
    let path = format!(
        "{}/../tests/data/manoeuvres/{name}",
        env!("CARGO_MANIFEST_DIR")
    );
    let text = std::fs::read_to_string(path).unwrap();
    text.lines()
        .skip(1)
        .map(|l| l.split(',').map(|x| x.parse().unwrap()).collect())
        .collect()
}

/// Sails with the orders of the file; gives the largest distance to it and both largest headings.
fn sail(name: &str, mut order: impl FnMut(f64, &Hull) -> f64) -> (f64, f64, f64) {
    let rows = rows(name);
    let speed = 15.0 * 1852.0 / 3600.0;
    let mut hull = Hull::running(0.0, speed);
    let mut worst = (0.0_f64, 0.0_f64, 0.0_f64);
    let per_row = (1.0 / STEP).round() as usize;
    for (i, row) in rows.iter().enumerate() {
        let distance = (hull.north - row[4]).hypot(hull.east - row[5]);
        worst.0 = worst.0.max(distance);
        worst.1 = worst.1.max(hull.heading.abs() * 180.0 / PI);
        worst.2 = worst.2.max(row[6].abs());
        for k in 0..per_row {
            let t = i as f64 + k as f64 * STEP;
            let drive = Drive {
                order: order(t, &hull) * PI / 180.0,
                approach_speed: speed,
                ..Drive::default()
            };
            hull.step(&drive, STEP);
        }
    }
    worst
}

#[test]
fn turning_circles_within_half_a_metre() {
    for (name, angle) in [
        ("mariner_15kn_turn35_stbd.csv", 35.0),
        ("mariner_15kn_turn10_stbd.csv", 10.0),
    ] {
        let (distance, ..) = sail(name, |t, _| if t >= 100.0 - 1e-9 { angle } else { 0.0 });
        println!("{name}: {distance:.4} m");
        assert!(distance < 0.5, "{name}: {distance} m");
    }
}

#[test]
fn zigzags_within_half_a_metre_and_a_fiftieth_of_a_degree() {
    for (name, angle) in [
        ("mariner_15kn_zigzag_20_20.csv", 20.0),
        ("mariner_15kn_zigzag_10_10.csv", 10.0),
    ] {
        let mut side = 0.0;
        let (distance, ours, theirs) = sail(name, |t, hull| {
            let heading = hull.heading * 180.0 / PI;
            if side == 0.0 && t >= 10.0 - 1e-9 {
                side = 1.0;
            } else if side != 0.0 && side * heading >= angle {
                side = -side;
            }
            side * angle
        });
        println!("{name}: {distance:.4} m, largest heading {ours:.4} and {theirs:.4}");
        assert!(distance < 0.5, "{name}: {distance} m");
        assert!(
            (ours - theirs).abs() < 0.02,
            "{name}: {ours} and {theirs} degrees"
        );
    }
}

#[test]
fn steady_turns_as_in_the_spiral() {
    for row in rows("mariner_15kn_spiral.csv") {
        let speed = 15.0 * 1852.0 / 3600.0;
        let mut hull = Hull::running(0.0, speed);
        let drive = Drive {
            order: row[0] * PI / 180.0,
            approach_speed: speed,
            ..Drive::default()
        };
        for _ in 0..20_000 {
            hull.step(&drive, 0.1);
        }
        let rate = hull.rate * 180.0 / PI;
        assert!(
            (rate - row[1]).abs() < 2e-3,
            "{}: {rate} for {}",
            row[0],
            row[1]
        );
        assert!(
            (hull.speed() - row[2]).abs() < 2e-3,
            "{}: {}",
            row[0],
            hull.speed()
        );
    }
}
