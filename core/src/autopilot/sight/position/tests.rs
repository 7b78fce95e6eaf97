//! Receivers that jump, come back, and stand in for each other (AP-9, FA9).

use super::*;

const HOME: Position = Position {
    lat: 54.0,
    lon: 6.0,
};
const STEP: f64 = 40.0;

fn source(port: usize) -> Source {
    Source {
        port,
        talker: "GP".into(),
        formatter: "GLL".into(),
    }
}

fn place(north: f64) -> Position {
    Plane::at(HOME).position(Point { north, east: 0.0 })
}

/// Each second every receiver says how far north the ship is; gives what was judged.
fn second(guard: &mut PositionGuard, at: u64, said: &[f64]) -> Judged {
    let now = Stamp(at * 1_000);
    let sources: Vec<_> = (0..said.len()).map(source).collect();
    let said = said.iter().zip(&sources).enumerate();
    let said: Vec<_> = said
        .map(|(rank, (north, source))| Said {
            source,
            rank: rank as u8,
            position: place(*north),
            at: now,
        })
        .collect();
    guard.judge(now, &said, STEP, false)
}

fn north(guard: &PositionGuard, at: u64) -> Option<f64> {
    let believed = guard.position(Stamp(at * 1_000))?;
    Some(libm::round(Plane::at(HOME).point(believed).north))
}

// FA9
#[test]
fn three_positions_off_in_a_row_or_one_far_off_are_a_jump() {
    for (off, jump) in [(60.0, 3), (300.0, 1)] {
        let mut guard = PositionGuard::default();
        assert!(!second(&mut guard, 0, &[0.0]).jumped);
        for at in 1..=jump {
            assert_eq!(guard.doubted().count(), usize::from(at > 1));
            assert_eq!(
                second(&mut guard, at, &[off]).jumped,
                at == jump,
                "{off} {at}"
            );
            assert_eq!(north(&guard, at), Some(0.0), "not used");
        }
    }
}

// AP-9: what jumped is bridged for five seconds, then there is none, and after ten steady ones it is believed again.
#[test]
fn a_receiver_that_jumped_is_believed_again_when_it_has_been_steady() {
    let mut guard = PositionGuard::default();
    second(&mut guard, 0, &[0.0]);
    let mut seen = Vec::new();
    for at in 1..=12 {
        // It leaps once more in the third second.
        second(&mut guard, at, &[if at < 3 { 500.0 } else { 900.0 }]);
        seen.push(north(&guard, at));
    }
    assert_eq!(seen[..5], [Some(0.0); 5]);
    assert_eq!(seen[5..], [None; 7]);
    second(&mut guard, 13, &[900.0]);
    assert_eq!(north(&guard, 13), Some(900.0));
    assert_eq!(guard.doubted().count(), 0);
}

// AP-9: the next good one, without a step in the plane; the better one again after ten seconds of agreement.
#[test]
fn the_next_receiver_is_taken_without_a_step_and_given_back_after_agreement() {
    let mut guard = PositionGuard::default();
    second(&mut guard, 0, &[0.0, 15.0]);
    let point = guard.dead_reckoning(Stamp(1_000));
    let judged = second(&mut guard, 1, &[400.0, 15.0]);
    assert!(judged.jumped && guard.in_use() == Some(&source(1)));
    let by = judged.moved.unwrap();
    assert!(
        (by.north - 15.0).abs() < 0.01 && by.east.abs() < 0.01,
        "{by:?}"
    );
    let after = guard.dead_reckoning(Stamp(1_000));
    assert!(
        point.unwrap().distance(after.unwrap()) < 0.01,
        "no step in the plane"
    );
    assert_eq!(north(&guard, 1), Some(15.0), "where the one in use says");
    // Steady somewhere else it is not taken back, however long.
    for at in 2..40 {
        assert_eq!(second(&mut guard, at, &[400.0, 15.0]).moved, None);
    }
    assert_eq!(guard.in_use(), Some(&source(1)));
    // Back from there it must be steady again, and agree.
    let mut back = None;
    for at in 40..70 {
        second(&mut guard, at, &[0.0, 15.0]);
        if guard.in_use() == Some(&source(0)) {
            back.get_or_insert(at);
        }
    }
    assert_eq!(back, Some(60), "ten seconds steady, ten of agreement");
}
