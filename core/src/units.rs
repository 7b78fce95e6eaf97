//! Numbers with a unit, each a type of its own. Starboard, east and north are positive.

use core::f64::consts::PI;
use core::ops::{Add, Div, Neg, Sub};
use serde::{Deserialize, Serialize};

/// Metres in an international nautical mile.
pub const METRES_PER_NAUTICAL_MILE: f64 = 1852.0;
/// Metres a second in a knot.
pub const METRES_PER_SECOND_PER_KNOT: f64 = 1852.0 / 3600.0;

/// Wraps an angle in degrees into 0 (included) to 360 (excluded).
#[must_use]
pub fn wrap_360(degrees: f64) -> f64 {
    let wrapped = degrees - 360.0 * libm::floor(degrees / 360.0);
    if wrapped >= 360.0 { 0.0 } else { wrapped }
}

/// Wraps an angle in degrees into -180 (excluded) to 180 (included).
#[must_use]
pub fn wrap_180(degrees: f64) -> f64 {
    let wrapped = wrap_360(degrees);
    if wrapped > 180.0 {
        wrapped - 360.0
    } else {
        wrapped
    }
}

macro_rules! direction {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize, Deserialize)]
        #[serde(transparent)]
        pub struct $name(f64);

        impl $name {
            /// From degrees; wrapped into 0 to 360.
            #[must_use]
            pub fn from_deg(degrees: f64) -> Self {
                Self(wrap_360(degrees))
            }
            /// From radians; wrapped.
            #[must_use]
            pub fn from_rad(radians: f64) -> Self {
                Self::from_deg(radians * 180.0 / PI)
            }
            /// Degrees, 0 to 360.
            #[must_use]
            pub const fn deg(self) -> f64 {
                self.0
            }
            /// Radians, 0 to 2 pi.
            #[must_use]
            pub fn rad(self) -> f64 {
                self.0 * PI / 180.0
            }
        }

        impl Sub for $name {
            type Output = SignedAngle;
            fn sub(self, other: Self) -> SignedAngle {
                SignedAngle::from_deg(self.0 - other.0)
            }
        }
        impl Add<SignedAngle> for $name {
            type Output = Self;
            fn add(self, turn: SignedAngle) -> Self {
                Self::from_deg(self.0 + turn.deg())
            }
        }
    };
}

direction! {
    /// A true heading: where the bow points, from true north.
    Heading
}
direction! {
    /// A magnetic heading; meets a true one only through a variation.
    MagneticHeading
}
direction! {
    /// A true course: a direction over the ground, such as a leg's.
    Course
}

impl Heading {
    /// The same direction taken as a course.
    #[must_use]
    pub const fn as_course(self) -> Course {
        Course(self.0)
    }
}
impl Course {
    /// The same direction taken as a heading.
    #[must_use]
    pub const fn as_heading(self) -> Heading {
        Heading(self.0)
    }
}
impl MagneticHeading {
    /// The true heading, given the variation (east positive).
    #[must_use]
    pub fn to_true(self, variation: SignedAngle) -> Heading {
        Heading::from_deg(self.0 + variation.deg())
    }
}

macro_rules! quantity {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd, Serialize, Deserialize)]
        #[serde(transparent)]
        pub struct $name(f64);

        impl Neg for $name {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
        impl $name {
            /// The size without the sign.
            #[must_use]
            pub fn abs(self) -> Self {
                Self(libm::fabs(self.0))
            }
        }
    };
}

quantity! {
    /// A signed angle between two directions, degrees, -180 to 180; starboard positive.
    SignedAngle
}
impl SignedAngle {
    /// From degrees; wrapped into -180 to 180.
    #[must_use]
    pub fn from_deg(degrees: f64) -> Self {
        Self(wrap_180(degrees))
    }
    /// Degrees.
    #[must_use]
    pub const fn deg(self) -> f64 {
        self.0
    }
    /// Radians.
    #[must_use]
    pub fn rad(self) -> f64 {
        self.0 * PI / 180.0
    }
}

quantity! {
    /// A rudder angle in degrees, starboard positive.
    RudderAngle
}
impl RudderAngle {
    /// From degrees, starboard positive.
    #[must_use]
    pub const fn from_deg(degrees: f64) -> Self {
        Self(degrees)
    }
    /// Degrees, starboard positive.
    #[must_use]
    pub const fn deg(self) -> f64 {
        self.0
    }
    /// Radians, starboard positive.
    #[must_use]
    pub fn rad(self) -> f64 {
        self.0 * PI / 180.0
    }
}

quantity! {
    /// A rate of turn, kept in degrees a minute, starboard positive.
    RateOfTurn
}
impl RateOfTurn {
    /// From degrees a minute.
    #[must_use]
    pub const fn from_deg_per_min(rate: f64) -> Self {
        Self(rate)
    }
    /// From radians a second.
    #[must_use]
    pub fn from_rad_per_s(rate: f64) -> Self {
        Self(rate * 180.0 / PI * 60.0)
    }
    /// Degrees a minute.
    #[must_use]
    pub const fn deg_per_min(self) -> f64 {
        self.0
    }
    /// Degrees a second.
    #[must_use]
    pub const fn deg_per_s(self) -> f64 {
        self.0 / 60.0
    }
    /// Radians a second.
    #[must_use]
    pub fn rad_per_s(self) -> f64 {
        self.0 / 60.0 * PI / 180.0
    }
}

quantity! {
    /// A speed, kept in metres a second.
    Speed
}
impl Speed {
    /// From metres a second.
    #[must_use]
    pub const fn from_mps(speed: f64) -> Self {
        Self(speed)
    }
    /// From knots.
    #[must_use]
    pub const fn from_knots(speed: f64) -> Self {
        Self(speed * METRES_PER_SECOND_PER_KNOT)
    }
    /// Metres a second.
    #[must_use]
    pub const fn mps(self) -> f64 {
        self.0
    }
    /// Knots.
    #[must_use]
    pub const fn knots(self) -> f64 {
        self.0 / METRES_PER_SECOND_PER_KNOT
    }
}

macro_rules! length {
    ($(#[$doc:meta])* $name:ident) => {
        quantity! { $(#[$doc])* $name }
        impl $name {
            /// From metres.
            #[must_use]
            pub const fn from_m(metres: f64) -> Self {
                Self(metres)
            }
            /// From nautical miles.
            #[must_use]
            pub const fn from_nm(miles: f64) -> Self {
                Self(miles * METRES_PER_NAUTICAL_MILE)
            }
            /// Metres.
            #[must_use]
            pub const fn m(self) -> f64 {
                self.0
            }
            /// Nautical miles.
            #[must_use]
            pub const fn nm(self) -> f64 {
                self.0 / METRES_PER_NAUTICAL_MILE
            }
        }
    };
}
length! {
    /// A distance, kept in metres; a cross-track distance is positive where the ship is right of the track.
    Distance
}
length! {
    /// A radius of turn, kept in metres, unsigned.
    Radius
}

impl Div<Radius> for Speed {
    type Output = RateOfTurn;
    /// The rate at which a ship turns on that radius, unsigned.
    fn div(self, radius: Radius) -> RateOfTurn {
        RateOfTurn::from_rad_per_s(self.0 / radius.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_wrap_and_differ_the_short_way() {
        assert_eq!(Heading::from_deg(-10.0).deg(), 350.0);
        assert_eq!(Heading::from_deg(360.0).deg(), 0.0);
        assert_eq!(
            (Heading::from_deg(10.0) - Heading::from_deg(350.0)).deg(),
            20.0
        );
    }

    #[test]
    fn ten_knots_on_a_third_of_a_mile_turn_at_the_rate_the_source_prints() {
        let rate = Speed::from_knots(10.0) / Radius::from_nm(0.35);
        assert!((rate.deg_per_min() - 27.28).abs() < 0.01, "{rate:?}");
    }
}
