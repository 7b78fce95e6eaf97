//! The checks a route must pass before it exists (TCS-11).
//!
//! A leg must hold: the end of the turn before it, the distance to settle, the time for the early indication,
//! the forwarding distance and the beginning of the turn after it.

use super::{Leg, RouteFault, RouteLimits, Turn, Waypoint};
use crate::path::tangent;
use crate::units::Distance;

/// Each waypoint by itself.
pub(super) fn waypoints(waypoints: &[Waypoint]) -> Result<(), RouteFault> {
    if waypoints.len() < 2 {
        return Err(RouteFault::TooFewWaypoints);
    }
    for (index, waypoint) in waypoints.iter().enumerate() {
        let printable = |b: u8| (b' '..=b'}').contains(&b) && !b"$*,!\\^".contains(&b);
        let id = waypoint.id.as_bytes();
        if id.is_empty() || id.len() > 20 || !id.iter().all(|b| printable(*b)) {
            return Err(RouteFault::Identifier { number: index + 1 });
        }
        let place = waypoint.position;
        if !(libm::fabs(place.lat) <= 85.0 && libm::fabs(place.lon) <= 180.0) {
            return Err(RouteFault::Place {
                waypoint: waypoint.id.clone(),
            });
        }
        let corridor = |limit: Distance| limit.m() > 0.0 && limit.nm() <= 10.0;
        if !(corridor(waypoint.limit_port) && corridor(waypoint.limit_starboard)) {
            return Err(RouteFault::Corridor {
                waypoint: waypoint.id.clone(),
            });
        }
    }
    for (index, pair) in waypoints.windows(2).enumerate() {
        if crate::geo::rhumb::between(pair[0].position, pair[1].position)
            .1
            .m()
            < 1.0
        {
            return Err(RouteFault::NoLength { leg: index + 1 });
        }
    }
    Ok(())
}

/// The turn at one waypoint by itself.
pub(super) fn turn(
    waypoint: &Waypoint,
    leg_in: &Leg,
    leg_out: &Leg,
    limits: &RouteLimits,
) -> Result<Turn, RouteFault> {
    let name = || waypoint.id.clone();
    let Some(radius) = waypoint.radius else {
        return Err(RouteFault::NoRadius { waypoint: name() });
    };
    let angle = leg_out.course() - leg_in.course();
    if angle.abs().deg() > limits.largest_turn_deg {
        return Err(RouteFault::TurnTooSharp {
            waypoint: name(),
            turn_deg: angle.deg(),
            largest_deg: limits.largest_turn_deg,
        });
    }
    if !(radius >= limits.smallest_radius && radius.m().is_finite()) {
        return Err(RouteFault::RadiusLimit {
            waypoint: name(),
            radius_nm: radius.nm(),
            allowed_nm: (limits.smallest_radius.nm(), limits.largest_radius.nm()),
        });
    }
    let turn = Turn::between(leg_in, leg_out, radius, limits.forwarding(limits.speed));
    // A radius that cannot fit is refused for that, with the one that does, before its size is looked at.
    let alone = (leg_in.length().m()).min(leg_out.length().m());
    if turn.tangent().m() <= alone && radius > limits.largest_radius {
        return Err(RouteFault::RadiusLimit {
            waypoint: name(),
            radius_nm: radius.nm(),
            allowed_nm: (limits.smallest_radius.nm(), limits.largest_radius.nm()),
        });
    }
    let rate = limits.speed / radius;
    if rate > limits.highest_rate {
        return Err(RouteFault::Rate {
            waypoint: name(),
            rate: rate.deg_per_min(),
            highest: limits.highest_rate.deg_per_min(),
        });
    }
    Ok(turn)
}

/// The turns together with their legs.
pub(super) fn legs(
    waypoints: &[Waypoint],
    legs: &[Leg],
    turns: &[Turn],
    limits: &RouteLimits,
) -> Result<(), RouteFault> {
    for (index, leg) in legs.iter().enumerate() {
        let before = index.checked_sub(1).and_then(|k| turns.get(k));
        let after = turns.get(index);
        let taken = |turn: Option<&Turn>| turn.map_or(0.0, |turn| turn.tangent().m());
        let free = leg.length().m() - beside(index, turns, limits);
        if taken(before) + taken(after) <= free {
            continue;
        }
        // The longer tangent is the one to shorten.
        let culprit = if taken(before) > taken(after) {
            index - 1
        } else {
            index
        };
        let largest = [culprit, culprit + 1]
            .iter()
            .filter_map(|k| {
                let other = if *k == culprit {
                    k.checked_sub(1)
                } else {
                    Some(*k)
                };
                let other = taken(other.and_then(|k| turns.get(k)));
                Some(legs.get(*k)?.length().m() - beside(*k, turns, limits) - other)
            })
            .fold(f64::INFINITY, f64::min);
        let fitting = turns.get(culprit).map_or(0.0, |turn| {
            let one = tangent(turn.angle(), crate::units::Radius::from_nm(1.0)).m();
            libm::floor(largest / one * 1000.0) / 1000.0
        });
        return Err(match turns.get(culprit) {
            Some(turn) if fitting >= limits.smallest_radius.nm() => RouteFault::RadiusDoesNotFit {
                waypoint: waypoints[culprit + 1].id.clone(),
                leg: index + 1,
                radius_nm: turn.radius().nm(),
                largest_nm: fitting,
            },
            _ => RouteFault::LegTooShort {
                leg: index + 1,
                length_nm: leg.length().nm(),
                needed_nm: Distance::from_m(beside(index, turns, limits)).nm(),
            },
        });
    }
    Ok(())
}

/// What a leg must hold beside the tangents of its turns, metres.
fn beside(leg: usize, turns: &[Turn], limits: &RouteLimits) -> f64 {
    let settling = if leg > 0 { limits.settling.m() } else { 0.0 };
    let forwarding = turns.get(leg).map_or(0.0, |turn| turn.forwarding().m());
    settling + forwarding + limits.early_s * limits.speed.mps()
}
