//! The order in which the plan is drawn (DSP-4).

use super::scene::Scene;
use super::{foreign, ship, track};
use crate::drawing::Drawing;
use crate::format;
use wheelover_core::geo::Point;
use wheelover_core::units::METRES_PER_NAUTICAL_MILE;

impl Scene<'_> {
    /// The plan as the inside of an SVG element.
    #[must_use]
    pub fn markup(&self) -> String {
        let mut drawing = Drawing::new();
        self.backdrop(&mut drawing);
        match &self.told {
            Some(told) => foreign::draw(self, told, &mut drawing),
            None => track::draw(self, &mut drawing),
        }
        // TCS-14: how far off she may be while nobody knows her place.
        if let Some((place, off)) = self.chart.and_then(|chart| chart.adrift) {
            let radius = off * self.frame.scale;
            drawing.named_circle("predictor", "two-sigma", self.frame.place(place), radius);
        }
        ship::draw(self, &mut drawing);
        drawing.markup()
    }

    /// Lines of latitude and longitude, and range rings around the ship.
    fn backdrop(&self, drawing: &mut Drawing) {
        drawing.path("grid", "", &self.frame.graticule().0);
        let (x, y) = self.frame.point(Point::default());
        for part in [0.5, 1.0] {
            let metres = self.range_nm * part * METRES_PER_NAUTICAL_MILE;
            let radius = metres * self.frame.scale;
            drawing.circle("ring", (x, y), radius);
            let place = (x + radius * 0.707 + 4.0, y + radius * 0.707 + 12.0);
            drawing.word("ring-name", "start", place, format::miles(Some(metres)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::frame::Frame;
    use crate::reading::Reading;
    use crate::readings::Readings;
    use crate::trail::Trail;
    use wheelover_core::geo::Position;
    use wheelover_core::limits::Freshness;
    use wheelover_core::view::{ChartOwn, Outline, RouteDocument, TurnView, WaypointView};

    fn place(lat: f64, lon: f64) -> Position {
        Position { lat, lon }
    }

    fn said<T>(value: T) -> Reading<T> {
        Reading {
            value: Some(value),
            state: Freshness::Valid,
            ..Reading::default()
        }
    }

    fn route() -> RouteDocument {
        let waypoint = |id: &str, lat, lon, course| WaypointView {
            id: id.to_owned(),
            position: place(lat, lon),
            radius_nm: Some(0.5),
            xtd_m: [185.0; 2],
            course,
        };
        RouteDocument {
            waypoints: vec![
                waypoint("001", 54.0, 12.0, None),
                waypoint("<2>", 54.05, 12.0, Some(0.0)),
                waypoint("003", 54.05, 12.1, Some(90.0)),
            ],
            turns: vec![TurnView {
                waypoint: 1,
                wheel_over: place(54.037, 12.0),
                start: place(54.0417, 12.0),
                end: place(54.05, 12.014),
                centre: place(54.0417, 12.014),
                turn: 90.0,
                forwarding_m: 500.0,
            }],
            ..RouteDocument::default()
        }
    }

    fn drawn(readings: &Readings) -> String {
        drawn_adrift(readings, None)
    }

    fn drawn_adrift(readings: &Readings, adrift: Option<(Position, f64)>) -> String {
        let chart = ChartOwn {
            situation: 2,
            control: "track".to_owned(),
            leg: 0,
            wheel_over_s: None,
            why: String::new(),
            adrift,
        };
        let ship = place(54.01, 12.0);
        Scene {
            frame: Frame::around(ship, (800.0, 600.0), 3.0, 0.0, 0.0),
            range_nm: 3.0,
            ship: Outline::default(),
            readings,
            route: &route(),
            chart: Some(&chart),
            told: None,
            trail: &Trail::default(),
        }
        .markup()
    }

    #[test]
    fn the_route_is_drawn_without_a_ship_and_a_ship_only_with_a_position() {
        let nothing = drawn(&Readings::default());
        for part in ["leg", "next-leg", "corridor", "arc", "wheel-over"] {
            assert!(
                nothing.contains(&format!("data-plan=\"{part}\"")),
                "{part}: {nothing}"
            );
        }
        assert!(nothing.contains("&lt;2&gt;"), "names are escaped");
        for part in ["own-ship", "heading-line", "vector", "radius-centre"] {
            assert!(!nothing.contains(part), "{part} without anything heard");
        }
        let readings = Readings {
            position: said(place(54.01, 12.0)),
            heading: said(1.0),
            cog: said(2.0),
            sog: said(15.0),
            rot: said(0.0),
            ..Readings::default()
        };
        let ship = drawn(&readings);
        for part in ["own-ship", "heading-line", "vector", "predictor"] {
            assert!(ship.contains(&format!("data-plan=\"{part}\"")), "{part}");
        }
    }

    // TCS-14
    #[test]
    fn the_circle_of_two_sigma_stands_about_the_reckoned_place_while_she_is_adrift() {
        let nothing = Readings::default();
        assert!(!drawn(&nothing).contains("two-sigma"));
        // A mile is 100 units of a view of 600 that reaches three of them; she is reckoned a mile north of its middle.
        let adrift = Some((place(54.01 + 1.0 / 60.0, 12.0), 926.0));
        let circle = |markup: &str| {
            let from = markup.find("data-plan=\"two-sigma\"").expect("a circle");
            let text = &markup[from..from + markup[from..].find("/>").unwrap()];
            ["cx=\"", "cy=\"", "r=\""].map(|name| {
                let value = text.split(name).nth(1).unwrap();
                value.split('"').next().unwrap().parse::<f64>().unwrap()
            })
        };
        let [x, y, radius] = circle(&drawn_adrift(&nothing, adrift));
        let [_, low, _] = circle(&drawn_adrift(&nothing, Some((place(54.01, 12.0), 926.0))));
        assert!((x - 400.0).abs() < 1.0, "{x}");
        assert!((low - y - 100.0).abs() < 1.0, "{low} {y}");
        assert!((radius - 50.0).abs() < 0.2, "{radius}");
    }

    #[test]
    fn the_radius_centre_stands_only_while_the_chart_system_says_it() {
        let readings = Readings {
            centre: said(place(54.0417, 12.014)),
            radius: said(0.5),
            ..Readings::default()
        };
        let turn = drawn(&readings);
        assert!(turn.contains("data-plan=\"radius-centre\" data-lat=\"54.041700\""));
        assert!(turn.contains("CENTRE R 0.50"), "{turn}");
    }
}
