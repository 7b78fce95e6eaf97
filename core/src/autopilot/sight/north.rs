//! True or magnetic north: which of them the headings in use are of (AP-10).

use crate::picture::Bearing;
use crate::units::Heading;
use serde::{Deserialize, Serialize};

/// Which north the headings are of. It is chosen while nothing is steered, and kept while a heading is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum North {
    /// True north: every compass that knows it, and magnetic ones by the variation.
    #[default]
    True,
    /// Magnetic north, where nothing else is heard and no variation is known.
    Magnetic,
}

impl North {
    /// The reference for what is heard now; `free`: nothing is steered.
    pub(crate) fn look<'a>(
        self,
        mut said: impl Iterator<Item = &'a Bearing>,
        variation: Option<f64>,
        free: bool,
    ) -> Self {
        if !free {
            return self;
        }
        let mut heard = false;
        let known = said.any(|bearing| {
            heard = true;
            bearing.true_heading(variation).is_some()
        });
        match (heard, known) {
            (_, true) => Self::True,
            (true, false) => Self::Magnetic,
            (false, false) => self,
        }
    }

    /// The heading of this reference that a compass says; absent where it cannot say one.
    pub(crate) fn of(self, bearing: &Bearing, variation: Option<f64>) -> Option<Heading> {
        match self {
            Self::True => bearing.true_heading(variation),
            Self::Magnetic => bearing.magnetic_heading(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // AP-10
    #[test]
    fn the_reference_is_magnetic_only_where_nothing_tells_true_north() {
        let gyro = Bearing::of_true(90.0);
        let bare = Bearing::of_magnetic(90.0, Some(1.0), None);
        let varied = Bearing::of_magnetic(90.0, Some(1.0), Some(-3.0));
        let look = |from: North, said: &[Bearing], variation, free| {
            from.look(said.iter(), variation, free)
        };
        let (t, m) = (North::True, North::Magnetic);
        assert_eq!(look(t, &[bare], None, true), m);
        assert_eq!(look(t, &[bare], Some(2.0), true), t);
        assert_eq!(look(m, &[varied], None, true), t);
        assert_eq!(look(m, &[bare, gyro], None, true), t);
        assert_eq!(look(m, &[], None, true), m, "nothing is heard");
        // What is steered keeps its north.
        assert_eq!(look(m, &[bare, gyro], Some(2.0), false), m);
        assert_eq!(look(t, &[bare], None, false), t);
    }

    // N table A.12: deviation and variation are east positive
    #[test]
    fn a_magnetic_reading_is_made_true_by_deviation_and_variation() {
        let of = |reference: North, bearing: Bearing, variation| {
            reference.of(&bearing, variation).map(Heading::deg)
        };
        let (t, m) = (North::True, North::Magnetic);
        let varied = Bearing::of_magnetic(359.0, Some(2.0), Some(-3.5));
        assert_eq!(of(t, varied, Some(10.0)), Some(357.5), "its own counts");
        assert_eq!(of(m, varied, Some(10.0)), Some(1.0));
        let bare = Bearing::of_magnetic(359.0, None, None);
        assert_eq!(of(t, bare, Some(10.0)), Some(9.0));
        assert_eq!(of(t, bare, None), None);
        assert_eq!(of(m, Bearing::of_true(90.0), None), None);
    }
}
