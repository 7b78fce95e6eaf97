//! Where the commanded leg and centre lie in the own plane, and whether the distances agree (TCS-4, AP-16).

use super::super::facts::Outlook;
use super::positions::Positions;
use crate::facts::Quantity;
use crate::geo::{Point, Position};
use crate::nmea::Pney1;
use crate::path::Path;
use crate::picture::Heard;
use crate::units::{Course, METRES_PER_NAUTICAL_MILE};
use alloc::format;
use alloc::string::String;

/// What the chart system says now, in the own plane.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Charted<'a> {
    outlook: &'a Outlook<'a>,
    positions: &'a Positions,
}

impl<'a> Charted<'a> {
    /// With the difference of the two positions as it is.
    pub(in super::super) const fn of(outlook: &'a Outlook<'a>, positions: &'a Positions) -> Self {
        Self { outlook, positions }
    }

    fn fresh<T: Clone>(self, heard: Option<&Heard<T>>) -> Option<T> {
        self.outlook.seen.fresh(heard, Quantity::Control)
    }

    /// The commanded centre in the own plane.
    pub(in super::super) fn centre(self) -> Option<Point> {
        let pney2 = self.fresh(self.outlook.seen.picture.pney2.as_ref())?;
        self.own_point(pney2.centre?)
    }

    /// A place of the chart system's in the own plane, moved by the difference of the two positions.
    fn own_point(self, place: Position) -> Option<Point> {
        let point = self.outlook.sight.plane()?.point(place);
        let offset = self.positions.offset();
        Some(Point {
            north: point.north + offset.north,
            east: point.east + offset.east,
        })
    }

    /// PNEY,001, fresh and with status A.
    pub(in super::super) fn pney1(self) -> Option<Pney1> {
        let said = self.outlook.seen.picture.pney1.as_ref();
        self.fresh(said.filter(|said| said.not_valid.is_none()))
    }

    /// Whether XTE is fresh, with status A.
    pub(in super::super) fn has_xte(self) -> bool {
        let said = self.outlook.seen.picture.xte.as_ref();
        self.fresh(said.filter(|said| said.not_valid.is_none()))
            .is_some()
    }

    /// Whether PNEY,002 is fresh, with a centre or without.
    pub(in super::super) fn has_pney2(self) -> bool {
        let said = self.outlook.seen.picture.pney2.as_ref();
        self.fresh(said).is_some()
    }

    /// The cross-track distances of XTE and PNEY,001 where they are heard, nautical miles; absent in them where none is said.
    pub(in super::super) fn distances(self) -> [Option<Option<f64>>; 2] {
        let picture = self.outlook.seen.picture;
        let xte = self.fresh(picture.xte.as_ref());
        let pney1 = self.fresh(picture.pney1.as_ref());
        [
            xte.map(|xte| xte.cross_track),
            pney1.map(|pney1| pney1.cross_track),
        ]
    }

    /// Cross-track distance for control, metres, ship right of the track positive.
    pub(in super::super) fn control_distance(self) -> Option<f64> {
        let heard = self.fresh(self.outlook.seen.picture.pney1.as_ref())?;
        Some(heard.cross_track? * METRES_PER_NAUTICAL_MILE)
    }

    /// The ship as the chart system sees her, in the second of PNEY,001; the own place where it says none.
    pub(in super::super) fn ship(self) -> Option<Point> {
        let picture = self.outlook.seen.picture;
        let heard = picture.pney1.as_ref()?;
        let charted = picture.fixes.iter().find(|fix| {
            fix.source.port == heard.source.port
                && fix.at.since(heard.at).max(heard.at.since(fix.at)) <= 1_100
        });
        charted
            .and_then(|fix| self.own_point(fix.value.position))
            .or_else(|| self.outlook.sight.place(self.outlook.facts.now))
    }

    /// Where the commanded leg passes: the chart system's position less its cross-track distance.
    pub(in super::super) fn leg(self, track: Course) -> Option<Path> {
        let distance = self.control_distance()?;
        let point = self.ship()?.towards(track.deg() + 90.0, -distance);
        Some(Path::leg(point, track))
    }

    /// The own and the chart system's position are those of one ship.
    pub(in super::super) fn positions_agree(self) -> Result<(), String> {
        self.positions.agree()
    }

    /// FA4: XTE and PNEY,001 that come without a distance are no distances; only a chart system without a route says so.
    pub(in super::super) fn distances_said(self) -> Result<(), String> {
        let said = ["XTE", "PNEY,001"].into_iter().zip(self.distances());
        match said.into_iter().find(|(_, said)| *said == Some(None)) {
            Some((name, _)) => Err(format!("{name} has no distance")),
            None => Ok(()),
        }
    }

    /// XTE is for display, but on a leg it says the same (situations 2 and 5).
    pub(in super::super) fn displays_agree(self) -> Result<(), String> {
        let [xte, pney1] = self.distances();
        let (Some(xte), Some(pney1)) = (xte.flatten(), pney1.flatten()) else {
            return Ok(());
        };
        let apart = libm::fabs(xte - pney1) * METRES_PER_NAUTICAL_MILE;
        if apart > self.outlook.facts.settings.leg_tolerance {
            return Err(format!("XTE and PNEY,001 differ by {apart:.0} m on a leg"));
        }
        Ok(())
    }
}

/// The point of a leg that is nearest to `point`.
pub(in super::super) fn nearest(leg: &Path, point: Point) -> Point {
    let leg = Path::leg(leg.point, leg.course_in);
    let along = leg.progress(point).along;
    leg.point.towards(leg.course_in.deg(), along)
}
