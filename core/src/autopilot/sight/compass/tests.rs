//! Compasses that jump, stick, drift and fall silent (AP-9, FA8).

use super::*;

fn source(port: usize) -> Source {
    Source {
        port,
        talker: "HE".into(),
        formatter: "HDT".into(),
    }
}

struct Bench {
    compasses: Compasses,
    now: Stamp,
}

impl Bench {
    fn step(&mut self, said: &[Option<f64>], rate: f64) -> (Option<f64>, Option<usize>) {
        self.now = self.now + 100;
        let sources: Vec<_> = (0..said.len()).map(source).collect();
        let readings: Vec<_> = said
            .iter()
            .zip(&sources)
            .enumerate()
            .filter_map(|(rank, (said, source))| {
                Some(Reading {
                    source,
                    rank: rank as u8,
                    said: Heading::from_deg((*said)?),
                    age: 0.0,
                })
            })
            .collect();
        let turning = Turning {
            rate: RateOfTurn::from_deg_per_min(rate),
            measured: true,
            course: None,
            dt: 0.1,
        };
        let heading = self
            .compasses
            .look(self.now, &readings, turning, 8.0, false);
        let port = self.compasses.in_use().map(|source| source.port);
        (heading.map(Heading::deg), port)
    }
}

fn bench() -> Bench {
    Bench {
        compasses: Compasses::default(),
        now: Stamp(0),
    }
}

// AP-9: two and three compasses; the first jumps, the next good one is taken, and given back after ten seconds.
#[test]
fn a_jump_of_one_compass_leads_to_the_next_good_one() {
    for further in [1, 2] {
        let mut bench = bench();
        let all = |first: Option<f64>| {
            let mut all = alloc::vec![first];
            all.extend((0..further).map(|_| Some(101.0)));
            all
        };
        assert_eq!(bench.step(&all(Some(100.0)), 0.0).1, Some(0));
        let mut used = Vec::new();
        for _ in 0..12 {
            used.push(bench.step(&all(Some(120.0)), 0.0));
        }
        assert_eq!(used[8], (Some(100.0), Some(0)), "bridged for a second");
        assert_eq!(used[11], (Some(101.0), Some(1)), "then the next good one");
        assert_eq!(bench.compasses.fallen_from(), Some(&source(0)));
        for _ in 0..350 {
            used.push(bench.step(&all(Some(100.0)), 0.0));
        }
        assert_eq!(used.last(), Some(&(Some(100.0), Some(0))), "taken back");
        assert_eq!(bench.compasses.fallen_from(), None);
    }
}

// AP-9: silent, and the next one has another opinion by more than a jump.
#[test]
fn a_silent_compass_leads_to_the_next_however_much_it_differs() {
    let mut bench = bench();
    bench.step(&[Some(100.0), Some(110.0)], 0.0);
    assert_eq!(
        bench.step(&[None, Some(110.0)], 0.0),
        (Some(110.0), Some(1))
    );
    for _ in 0..200 {
        let back = bench.step(&[Some(100.0), Some(110.0)], 0.0);
        assert_eq!(back.1, Some(1), "not taken back without agreement");
    }
    assert_eq!(bench.step(&[None, None], 0.0), (None, None));
}

// FA8
#[test]
fn a_compass_that_stands_still_while_the_ship_turns_is_stuck_within_ten_seconds() {
    let mut bench = bench();
    let mut since = None;
    for step in 0..100 {
        let second = 100.0 + 0.025 * f64::from(step);
        let seen = bench.step(&[Some(100.0), Some(second)], 15.0);
        if bench.compasses.doubted().next().is_some() {
            since.get_or_insert(step);
            assert_eq!(seen.1, Some(1));
        }
    }
    assert!(since.is_some_and(|step| step < 100), "{since:?}");
}

// AP-9: one goes its own way slowly, or by less than a jump; the other goes as the rate of turn says.
#[test]
fn a_compass_that_drifts_is_left_for_one_that_does_not() {
    for (name, drift) in [
        (
            "a ramp",
            (|step: u32| 0.1 * f64::from(step)) as fn(u32) -> f64,
        ),
        ("a step", |step| if step > 10 { 4.0 } else { 0.0 }),
        ("a turn that the ship does not make", |step| {
            -0.06 * f64::from(step)
        }),
    ] {
        for rate in [0.0, 30.0] {
            let mut bench = bench();
            let mut left = None;
            for step in 0..150_u32 {
                let turned = 100.0 + rate / 600.0 * f64::from(step);
                let all = [Some(turned + drift(step)), Some(turned)];
                if bench.step(&all, rate).1 == Some(1) {
                    left.get_or_insert(step);
                }
            }
            assert!(
                left.is_some_and(|step| step < 70),
                "{name}, {rate}: {left:?}"
            );
            assert!(bench.compasses.doubted().all(|(who, _)| *who == source(0)));
        }
    }
}

// A noise of one degree and a single reading that is off are no drift.
#[test]
fn a_noisy_compass_is_not_left() {
    let mut bench = bench();
    for step in 0..3_000_u32 {
        let noise = f64::from(step * 7_919 % 101) / 101.0 * 4.0 - 2.0;
        let off = if step % 100 == 50 { 4.0 } else { noise };
        let seen = bench.step(&[Some(100.0 + off), Some(100.0)], 0.0);
        assert_eq!(seen.1, Some(0), "{step}");
    }
}

// A rate of turn that lies is no witness against both.
#[test]
fn compasses_that_agree_are_believed_against_the_rate_of_turn() {
    let mut bench = bench();
    for _ in 0..300 {
        let seen = bench.step(&[Some(100.0), Some(101.0)], 90.0);
        assert_eq!(seen.1, Some(0));
    }
}

#[test]
fn a_steady_course_is_not_stuck() {
    let mut bench = bench();
    for _ in 0..6_000 {
        bench.step(&[Some(100.0)], 1.0);
    }
    assert_eq!(bench.compasses.doubted().count(), 0);
}
