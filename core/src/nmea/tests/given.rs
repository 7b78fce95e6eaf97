//! Values of a strategy, the same ones each time; one that fails is made as small as it goes before it is named.

use proptest::strategy::{Strategy, ValueTree as _};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use std::vec::Vec;

fn runner(cases: u32) -> TestRunner {
    let config = Config {
        cases,
        failure_persistence: None,
        max_shrink_iters: 20_000,
        ..Config::default()
    };
    // Fixed, so that a failure comes again.
    let random = TestRng::deterministic_rng(RngAlgorithm::XorShift);
    TestRunner::new_with_rng(config, random)
}

/// Checks so many values; the least one that fails is named.
pub(crate) fn for_all<S: Strategy>(
    cases: u32,
    values: &S,
    check: impl Fn(S::Value) -> Result<(), TestCaseError>,
) {
    if let Err(failure) = runner(cases).run(values, check) {
        panic!("{failure}");
    }
}

/// So many values.
pub(crate) fn some<S: Strategy>(count: u32, values: &S) -> Vec<S::Value> {
    let mut runner = runner(count);
    let one = |_| values.new_tree(&mut runner).unwrap().current();
    (0..count).map(one).collect()
}

#[test]
fn what_fails_is_made_as_small_as_it_goes() {
    let failure = runner(1_000)
        .run(&proptest::collection::vec(0..1_000_u32, 0..20), |numbers| {
            proptest::prop_assert!(numbers.iter().all(|&number| number < 700));
            Ok(())
        })
        .unwrap_err();
    let least = "minimal failing input: [\n    700,\n]";
    assert!(std::format!("{failure}").contains(least), "{failure}");
}
