//! The world's sentences and its steering gear.

use super::*;
use alloc::format;
use alloc::string::ToString;

fn texts(out: &[Output], port: PortIndex) -> Vec<String> {
    let mut all = String::new();
    for output in out {
        if let Output::Send { port: p, bytes } = output
            && *p == port
        {
            all.push_str(core::str::from_utf8(bytes).unwrap());
        }
    }
    all.lines().map(ToString::to_string).collect()
}

fn order(world: &mut World, now: u64, text: &str) {
    let line = format!("{}\r\n", crate::nmea::with_checksum(text));
    let port = world.port(Profile::Gear).unwrap();
    let mut out = Vec::new();
    for part in line.as_bytes().chunks(3) {
        world.handle(Stamp(now), Input::Bytes { port, bytes: part }, &mut out);
    }
}

fn until(world: &mut World, now: u64) -> Vec<Output> {
    let mut out = Vec::new();
    world.handle(Stamp(now), Input::Tick, &mut out);
    out
}

#[test]
fn each_sensor_speaks_at_its_own_pace() {
    let mut world = World::new(WorldConfig {
        noise: Noise::NONE,
        ..WorldConfig::default()
    });
    let out = until(&mut world, 999);
    let count = |port, formatter: &str| {
        texts(&out, port)
            .iter()
            .filter(|t| t.get(3..6) == Some(formatter))
            .count()
    };
    assert_eq!(
        [count(0, "HDT"), count(0, "ROT"), count(3, "RSA")],
        [10, 10, 10]
    );
    assert_eq!(
        [count(1, "GLL"), count(1, "VTG"), count(2, "VHW")],
        [1, 1, 1]
    );
    let log = &texts(&out, 2)[0];
    assert!(
        log.starts_with("$VDVHW,,T,,M,15.0") && log.contains(",N,27.8"),
        "{log}"
    );
    let place = &texts(&out, 1)[0];
    assert!(place.starts_with("$GPGLL,5400.000"), "{place}");
    // What is said is shown, line by line.
    let lines = out.iter().filter(|o| matches!(o, Output::Line { .. }));
    let said: usize = (0..4).map(|port| texts(&out, port).len()).sum();
    assert_eq!((lines.count(), said), (33, 33));
}

#[test]
fn the_gear_follows_fresh_orders_and_holds_without() {
    let mut world = World::new(WorldConfig {
        noise: Noise::NONE,
        ..WorldConfig::default()
    });
    until(&mut world, 1000);
    for second in 1..6 {
        order(&mut world, second * 1000, "AGROR,10.0,A,,V,B");
        until(&mut world, second * 1000 + 999);
    }
    assert!(
        (world.truth().rudder.deg() - 10.0).abs() < 0.3,
        "{:?}",
        world.truth()
    );
    until(&mut world, 20_000);
    assert!((world.truth().rudder.deg() - 10.0).abs() < 0.3);
    order(&mut world, 20_000, "AGROR,-20.0,V,,V,B");
    until(&mut world, 21_000);
    assert!((world.truth().rudder.deg() - 10.0).abs() < 0.3);
    order(&mut world, 21_000, "AGROR,-20.0,A,,V,B");
    until(&mut world, 22_900);
    assert!(
        (world.truth().rudder.deg() - 0.5).abs() < 1.0,
        "{:?}",
        world.truth().rudder
    );
}

#[test]
fn a_damaged_order_moves_nothing() {
    let mut world = World::new(WorldConfig {
        noise: Noise::NONE,
        ..WorldConfig::default()
    });
    let port = world.port(Profile::Gear).unwrap();
    let bytes = b"$AGROR,30.0,A,,V,B*00\r\n$AGROR,30.0,A\r\nnoise\xff";
    world.handle(Stamp(100), Input::Bytes { port, bytes }, &mut Vec::new());
    until(&mut world, 3000);
    assert_eq!(world.truth().rudder.deg(), 0.0);
}

#[test]
fn injuries_reach_the_sentences_and_heal() {
    let mut world = World::new(WorldConfig {
        noise: Noise::NONE,
        ..WorldConfig::default()
    });
    assert!(world.injure(Profile::Gyro1, FaultKind::Jump, true));
    assert!(!world.injure(Profile::Gear, FaultKind::Jump, true));
    let heading = |out: &[Output]| {
        texts(out, 0)[0]
            .split(',')
            .nth(1)
            .unwrap()
            .parse::<f64>()
            .unwrap()
    };
    assert!((heading(&until(&mut world, 0)) - 20.0).abs() < 0.1);
    assert!(world.injure(Profile::Gyro1, FaultKind::Jump, false));
    let healed = heading(&until(&mut world, 100));
    assert!(!(0.1..=359.9).contains(&healed), "{healed}");
}

#[test]
fn the_same_seed_gives_the_same_bytes_after_a_checkpoint_too() {
    let mut world = World::new(WorldConfig::default());
    until(&mut world, 5000);
    let kept = serde_json::to_string(&world).unwrap();
    let mut again: World = serde_json::from_str(&kept).unwrap();
    assert_eq!(until(&mut world, 15_000), until(&mut again, 15_000));
}

#[test]
fn the_current_carries_the_ship_over_the_ground() {
    let config = WorldConfig {
        noise: Noise::NONE,
        current_set: Course::from_deg(90.0),
        current_drift: Speed::from_knots(2.0),
        ..WorldConfig::default()
    };
    let mut world = World::new(config.clone());
    until(&mut world, 60_000);
    let moved = Plane::at(config.start).point(world.truth().position);
    let still = {
        let mut world = World::new(WorldConfig {
            current_drift: Speed::from_knots(0.0),
            ..config
        });
        until(&mut world, 60_000);
        Plane::at(WorldConfig::default().start).point(world.truth().position)
    };
    assert!(
        (moved.east - still.east - 61.7).abs() < 0.5,
        "{moved:?} {still:?}"
    );
}
