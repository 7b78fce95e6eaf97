//! Everything that is heard and believed, as the bridge view shows it at one moment (display.md 3.1's table).

use crate::believed;
use crate::reading::Reading;
use wheelover_core::geo::Position;
use wheelover_core::limits::{Freshness, Quantity};
use wheelover_core::picture::{Heard, Picture};
use wheelover_core::time::Stamp;
use wheelover_core::units::{
    METRES_PER_NAUTICAL_MILE, METRES_PER_SECOND_PER_KNOT, RudderAngle, wrap_180,
};
use wheelover_core::view::{Own, Snapshot};

/// Everything the bridge view shows, made anew when something came, and four times a second.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Readings {
    /// Server time for which the ages hold.
    pub now: Stamp,
    /// Heading, degrees.
    pub heading: Reading<f64>,
    /// Heading to steer, degrees.
    pub hts: Reading<f64>,
    /// Commanded track, degrees.
    pub track: Reading<f64>,
    /// Course over ground, degrees.
    pub cog: Reading<f64>,
    /// Speed over ground, knots.
    pub sog: Reading<f64>,
    /// Speed through the water, knots.
    pub stw: Reading<f64>,
    /// Rate of turn, degrees a minute.
    pub rot: Reading<f64>,
    /// Commanded rate of turn, degrees a minute.
    pub rot_set: Reading<f64>,
    /// Rudder order, degrees.
    pub order: Reading<f64>,
    /// Rudder angle, degrees.
    pub rudder: Reading<f64>,
    /// Order to the port rudder of a pair, degrees.
    pub port_order: Reading<f64>,
    /// Angle of the port rudder of a pair, degrees.
    pub port_rudder: Reading<f64>,
    /// Cross-track distance for display, metres, ship right of track positive.
    pub xtd: Reading<f64>,
    /// The one for control: in a turn, to the next leg.
    pub xtd_next: Reading<f64>,
    /// Waypoint of the leg or the turn.
    pub waypoint: Reading<String>,
    /// Commanded radius, nautical miles; absent on a straight leg.
    pub radius: Reading<f64>,
    /// Radius centre; absent on a straight leg.
    pub centre: Reading<Position>,
    /// Position.
    pub position: Reading<Position>,
    /// Drift angle: course over ground less heading, degrees.
    pub drift: Reading<f64>,
}

/// Past this age there is no link: every value, heard or own, is dead at once.
pub const LINK_LOST_MS: u64 = 2_000;

impl Readings {
    /// From what was heard and what the autopilot says of itself.
    #[must_use]
    pub fn of(picture: &Picture, snapshot: Option<&Snapshot>, now: Stamp, link_age: u64) -> Self {
        use Quantity::{Control, Ground, Heading, RateOfTurn, Rudder, WaterSpeed};
        let own: Option<&Own> = snapshot.and_then(|snapshot| snapshot.own.as_ref());
        let metres = |miles: f64| miles * METRES_PER_NAUTICAL_MILE;
        let distance = |reading| believed::distance(reading, own);
        let heading = match own {
            Some(own) => believed::heading(picture, own, now),
            None => Reading::heard(picture, picture.heading(now), Heading, now, |h| {
                h.true_heading(picture.variation(now)).map(|h| h.deg())
            }),
        };
        let position = match own {
            Some(own) => believed::position(picture, own, now),
            None => Reading::heard(picture, picture.fix(now), Quantity::Position, now, |f| {
                Some(f.position)
            }),
        };
        let mut cog = Reading::heard(picture, picture.ground(now), Ground, now, |g| {
            g.course.map(|course| course.deg())
        });
        let mut sog = Reading::heard(picture, picture.ground(now), Ground, now, |g| {
            Some(g.speed.knots())
        });
        let mut stw = Reading::heard(picture, picture.water_speed(now), WaterSpeed, now, |s| {
            Some(s.knots())
        });
        // AP-9, AP-7: what nothing measures is marked as what it is.
        if let Some((course, speed)) = own.and_then(|own| own.calculated) {
            cog = Reading::marked(course, "c");
            sog = Reading::marked(Some(speed), "c");
        }
        if let Some(speed) = own.and_then(|own| own.manual_speed) {
            stw = Reading::marked(Some(speed), "manual");
        }
        let htc = picture.htc.as_ref();
        let angle = |r: &RudderAngle| Some(r.deg());
        let order = |heard: Option<&Heard<RudderAngle>>, said: fn(&Own) -> Option<f64>| match own {
            Some(own) => Reading::own(said(own)),
            None => Reading::heard(picture, heard, Quantity::Report, now, angle),
        };
        let mut readings = Self {
            now,
            hts: match own {
                Some(own) => Reading::own(own.hts),
                None => Reading::heard(
                    picture,
                    picture.htd.as_ref(),
                    Quantity::Report,
                    now,
                    |htd| htd.heading_to_steer,
                ),
            },
            track: Reading::heard(picture, htc, Control, now, |c| c.htc.track),
            sog,
            stw,
            rot: Reading::heard(picture, picture.rate(now), RateOfTurn, now, |r| {
                Some(r.deg_per_min())
            }),
            rot_set: Reading::heard(picture, htc, Control, now, |c| c.htc.rate_of_turn),
            order: order(picture.order.as_ref(), |own| own.rudder_order),
            port_order: order(picture.order_port.as_ref(), |own| own.port_order),
            rudder: Reading::heard(picture, picture.rudder.as_ref(), Rudder, now, angle),
            port_rudder: Reading::heard(picture, picture.rudder_port.as_ref(), Rudder, now, angle),
            xtd: distance(Reading::heard(
                picture,
                picture.xte.as_ref(),
                Control,
                now,
                |x| x.cross_track.map(metres),
            )),
            xtd_next: distance(Reading::heard(
                picture,
                picture.pney1.as_ref(),
                Control,
                now,
                |x| x.cross_track.map(metres),
            )),
            waypoint: Reading::heard(picture, picture.pney2.as_ref(), Control, now, |p| {
                p.waypoint.clone()
            }),
            radius: Reading::heard(picture, htc, Control, now, |c| c.htc.radius),
            centre: Reading::heard(picture, picture.pney2.as_ref(), Control, now, |p| p.centre),
            position,
            drift: Reading {
                value: cog
                    .value
                    .zip(heading.value)
                    .map(|(cog, heading)| wrap_180(cog - heading)),
                state: worse(cog.state, heading.state),
                age: cog.age.max(heading.age),
                why: heading.why.clone(),
                ..Reading::default()
            },
            heading,
            cog,
        };
        readings.side_the_set_rate(picture);
        if picture.fix(now).is_some_and(|fix| !fix.value.corrected())
            && matches!(readings.position.state, Freshness::Valid | Freshness::Late)
        {
            readings.position.state = Freshness::Low;
        }
        if link_age > LINK_LOST_MS {
            readings.lost(link_age)
        } else {
            readings
        }
    }

    /// Metres a second over ground.
    #[must_use]
    pub fn speed(&self) -> Option<f64> {
        let knots = self.sog.value?;
        Some(knots * METRES_PER_SECOND_PER_KNOT)
    }

    /// The set rate: the chart system's, else the one that the autopilot reports; its side is the way to the track.
    fn side_the_set_rate(&mut self, picture: &Picture) {
        if self.rot_set.value.is_none() {
            self.rot_set = Reading::heard(
                picture,
                picture.htd.as_ref(),
                Quantity::Report,
                self.now,
                |htd| htd.rate_of_turn,
            );
        }
        let to_turn = self
            .track
            .value
            .zip(self.heading.value)
            .map(|(t, h)| wrap_180(t - h));
        self.rot_set.value = self
            .rot_set
            .value
            .zip(to_turn)
            .map(|(rate, side)| libm::copysign(rate, side));
    }

    /// No link: no value may look alive.
    fn lost(self, age: u64) -> Self {
        Self {
            now: self.now,
            heading: self.heading.lost(age),
            hts: self.hts.lost(age),
            track: self.track.lost(age),
            cog: self.cog.lost(age),
            sog: self.sog.lost(age),
            stw: self.stw.lost(age),
            rot: self.rot.lost(age),
            rot_set: self.rot_set.lost(age),
            order: self.order.lost(age),
            rudder: self.rudder.lost(age),
            port_order: self.port_order.lost(age),
            port_rudder: self.port_rudder.lost(age),
            xtd: self.xtd.lost(age),
            xtd_next: self.xtd_next.lost(age),
            waypoint: self.waypoint.lost(age),
            radius: self.radius.lost(age),
            centre: self.centre.lost(age),
            position: self.position.lost(age),
            drift: self.drift.lost(age),
        }
    }
}

/// The state that is believed less.
const fn worse(one: Freshness, other: Freshness) -> Freshness {
    if one as u8 >= other as u8 { one } else { other }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_heard_is_never_and_nothing_stays_past_the_link() {
        let picture = Picture::default();
        let readings = Readings::of(&picture, None, Stamp(1_000), 0);
        assert_eq!(readings.heading.state, Freshness::Never);
        assert_eq!(readings.heading.value, None);
        let lost = Reading {
            value: Some(262.2),
            state: Freshness::Valid,
            age: 100,
            source: "gyro1/HE/HDT".to_owned(),
            ..Reading::default()
        };
        assert_eq!(lost.port(), "GYRO1");
        let lost = lost.lost(6_000);
        assert_eq!(
            (lost.value, lost.state, lost.age),
            (None, Freshness::Lost, 6_000)
        );
    }

    #[test]
    fn the_worse_state_wins() {
        assert_eq!(worse(Freshness::Valid, Freshness::Late), Freshness::Late);
        assert_eq!(worse(Freshness::Never, Freshness::Lost), Freshness::Never);
    }
}
