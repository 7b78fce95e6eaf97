//! Two rudders that act as the mean of their angles, degrees (AP-4).

use super::side::Side;

/// The order of the single rudder that the pair is as good as.
pub(super) fn order(starboard: &Side, port: &Side) -> f64 {
    let given = |side: &Side| side.stands().unwrap_or(side.order());
    0.5 * (given(starboard) + given(port))
}

/// By how much limit and slew cut what was wanted of the pair: a healthy side that steers alone wants twice as much.
pub(super) fn cut(starboard: &Side, port: &Side) -> f64 {
    match (starboard.has_failed(), port.has_failed()) {
        (false, true) => 0.5 * starboard.rudder.cut(),
        (true, false) => 0.5 * port.rudder.cut(),
        _ => 0.5 * (starboard.rudder.cut() + port.rudder.cut()),
    }
}

/// Has both sides go towards the wanted rudder; whether a side that steers is at its limit. `step` moves one of them.
pub(super) fn step(
    starboard: &mut Side,
    port: &mut Side,
    wanted: f64,
    step: impl Fn(&mut Side, f64) -> bool,
) -> bool {
    let (failed, healthy) = match (starboard.has_failed(), port.has_failed()) {
        (true, false) => (starboard, port),
        (false, true) => (port, starboard),
        _ => {
            let (one, other) = (step(starboard, wanted), step(port, wanted));
            return one || other;
        }
    };
    step(failed, wanted);
    let stands = failed.stands().unwrap_or(wanted);
    step(healthy, 2.0 * wanted - stands)
}
