//! What the core may not use, the linter knows: an expectation that it does not fulfil is a warning, and so a failure.

#[test]
fn clocks_and_maps_without_an_order_are_refused() {
    #[expect(clippy::disallowed_types, reason = "a clock")]
    let now = std::time::Instant::now();
    #[expect(clippy::disallowed_types, reason = "another")]
    let date = std::time::SystemTime::now();
    #[expect(clippy::disallowed_types, reason = "an order of its own in each run")]
    let map = std::collections::HashMap::<u8, u8>::new();
    #[expect(clippy::disallowed_types, reason = "the same")]
    let set = std::collections::HashSet::<u8>::new();
    assert!(map.is_empty() && set.is_empty() && now.elapsed().as_secs() < 60);
    assert!(date > std::time::UNIX_EPOCH);
}

#[test]
fn arithmetic_that_differs_from_machine_to_machine_is_refused() {
    #[expect(clippy::disallowed_methods, reason = "fused")]
    let fused = 2.0_f64.mul_add(3.0, 1.0);
    #[expect(
        clippy::disallowed_methods,
        reason = "a power by the compiler's own way"
    )]
    let power = 7.0_f64.powi(1);
    #[expect(clippy::disallowed_methods, reason = "fused, by the library")]
    let library = libm::fma(2.0, 3.0, 1.0);
    assert_eq!([fused, power, library], [7.0; 3]);
}
