//! A route that a plotter offers (TCS-13): gathered, checked, and loaded by an officer's order alone.

use super::*;
use crate::nmea::{Wpl, with_checksum};
use crate::station::{ChecksumPolicy, PortSetup, Profile};
use alloc::format;

const PLOTTER: usize = 4;

/// The ship on her route, with a plotter that has said nothing.
fn with_plotter() -> Bench {
    let mut bench = Bench::new();
    let mut config = bench.chart.config.clone();
    config.ports.push(PortSetup {
        name: "plotter".into(),
        profile: Profile::Plotter,
        checksum: ChecksumPolicy::Required,
        talkers: Vec::new(),
        baud: 4800,
        output: false,
    });
    bench.chart = ChartSystem::new(config);
    bench.chart.handle(Stamp(0), Input::Tick, &mut vec![]);
    bench
}

impl Bench {
    fn plot(&mut self, body: &str) {
        self.hear(PLOTTER, &with_checksum(body), &mut vec![]);
    }

    /// WPL of places one after the other, each so many miles on 245 from the one before.
    fn places(&mut self, ids: &[&str], miles: f64) {
        let (mut place, _) = self.place();
        for id in ids {
            let wpl = Wpl {
                position: Some(place),
                waypoint: Some((*id).into()),
            };
            self.hear(PLOTTER, &wpl.line("GP"), &mut vec![]);
            // Every second leg turns by 30 degrees.
            let course = Course::from_deg(if ids.len().is_multiple_of(2) {
                245.0
            } else {
                275.0
            });
            place = rhumb::destination(place, course, Distance::from_nm(miles));
        }
    }

    fn number(&self) -> u64 {
        self.chart.offer().expect("an offer").number
    }

    fn fault(&self) -> Option<String> {
        let number = self.number();
        self.chart
            .may_load(number)
            .err()
            .map(|refusal| refusal.text)
    }
}

#[test]
fn a_route_is_gathered_over_several_sentences_and_loaded_by_an_order() {
    let mut bench = with_plotter();
    bench.second();
    assert_eq!(bench.chart.offer(), None);
    bench.places(&["HOME", "A1", "B2", "QUAY"], 2.0);
    assert_eq!(bench.chart.offer(), None, "places alone are no route");
    bench.plot("GPRTE,2,1,c,R7,HOME,A1");
    assert_eq!(bench.chart.offer(), None, "half of it");
    bench.plot("GPRTE,2,2,c,R7,B2,QUAY");
    let offer = bench.chart.offer().unwrap().clone();
    assert_eq!((offer.name.as_str(), offer.complete), ("R7", true));
    assert_eq!(offer.waypoints, ["HOME", "A1", "B2", "QUAY"]);
    // Nothing is taken by itself.
    let before = bench.chart.revision();
    for _ in 0..30 {
        bench.second();
    }
    assert_eq!(bench.chart.revision(), before);
    assert_eq!(bench.chart.route(), Some(&route()));

    let answer = bench.order(&Order::LoadRoute(offer.number));
    assert_eq!(answer, Ok("route R7 loaded, 3 legs".into()));
    let loaded = bench.chart.route().unwrap();
    let ids: Vec<&str> = loaded.waypoints().iter().map(|w| w.id.as_str()).collect();
    assert_eq!(ids, ["HOME", "A1", "B2", "QUAY"]);
    // Radius and corridor of the configuration; the ends have no turn.
    let radii: Vec<_> = loaded.waypoints().iter().map(|w| w.radius).collect();
    let turn = Some(Radius::from_nm(0.5));
    assert_eq!(radii, [None, turn, turn, None]);
    for waypoint in loaded.waypoints() {
        near(waypoint.limit_port.m(), 185.2, 1e-9);
        near(waypoint.limit_starboard.m(), 185.2, 1e-9);
    }
    let said = bench.second();
    assert_eq!(said.pney2.waypoint.as_deref(), Some("A1"));
}

#[test]
fn a_waypoint_without_a_place_is_named_and_refused() {
    let mut bench = with_plotter();
    bench.places(&["A", "C"], 2.0);
    bench.plot("GPRTE,1,1,c,R1,A,B,C");
    assert_eq!(bench.fault().as_deref(), Some("no WPL for waypoint B"));
    let number = bench.number();
    let refused = bench.order(&Order::LoadRoute(number));
    assert_eq!(refused, Err("no WPL for waypoint B".into()));
    bench.plot("GPRTE,1,1,c,R1,A,D,E,F,G,C");
    let fault = "no WPL for waypoint D, E, F and 1 more";
    assert_eq!(bench.fault().as_deref(), Some(fault));
    // Its place comes after the route.
    bench.plot("GPRTE,1,1,c,R1,A,B,C");
    bench.places(&["A", "B", "C"], 2.0);
    assert_eq!(bench.fault(), None);
}

// TCS-11
#[test]
fn what_is_offered_is_judged_by_the_rules_of_every_route() {
    let mut bench = with_plotter();
    bench.places(&["A", "B"], 2.0);
    bench.plot("GPRTE,1,1,c,R1,A");
    assert_eq!(
        bench.fault().as_deref(),
        Some("a route needs at least two waypoints")
    );
    // Two miles out and back again: no ship turns like that.
    bench.plot("GPRTE,1,1,c,R1,A,B,A");
    let fault = bench.fault().unwrap();
    assert!(
        fault.starts_with("course change of 180.0 deg at waypoint B"),
        "{fault}"
    );
    // A right angle on legs of 0.8 miles, with a radius of half a mile and the way to settle.
    let (place, _) = bench.place();
    let east = Course::from_deg(90.0);
    let north = Course::from_deg(0.0);
    let short = Distance::from_nm(0.8);
    let corner = rhumb::destination(place, east, short);
    for (id, position) in [
        ("K", place),
        ("L", corner),
        ("M", rhumb::destination(corner, north, short)),
    ] {
        let wpl = Wpl {
            position: Some(position),
            waypoint: Some(id.into()),
        };
        bench.hear(PLOTTER, &wpl.line("GP"), &mut vec![]);
    }
    bench.plot("GPRTE,1,1,c,R2,K,L,M");
    let fault = bench.fault().unwrap();
    assert!(
        fault.starts_with("radius 0.500 nm at waypoint L does not fit leg 1"),
        "{fault}"
    );
    // More waypoints than any plan has.
    let many: Vec<String> = (0..201).map(|n| format!("W{n}")).collect();
    for (part, ids) in many.chunks(9).enumerate() {
        bench.plot(&format!("GPRTE,23,{},c,LONG,{}", part + 1, ids.join(",")));
    }
    assert_eq!(
        bench.fault().as_deref(),
        Some("201 waypoints; at most 200 are taken")
    );
}

#[test]
fn under_control_and_with_another_number_nothing_is_loaded() {
    let mut bench = with_plotter();
    bench.second();
    assert_eq!(
        bench.order(&Order::LoadRoute(1)),
        Err("no route is offered".into())
    );
    bench.places(&["A", "B", "C", "D"], 2.0);
    bench.plot("GPRTE,1,1,c,R1,A,B,C,D");
    let number = bench.number();
    for request in [ChartRequest::Track, ChartRequest::Heading] {
        bench.request(request).unwrap();
        let refused = bench.order(&Order::LoadRoute(number)).unwrap_err();
        assert!(
            refused.ends_with("control is active: stop it first"),
            "{refused}"
        );
    }
    bench.request(ChartRequest::Stop).unwrap();
    // The same again is the same offer; another order of its waypoints is another.
    bench.plot("GPRTE,1,1,c,R1,A,B,C,D");
    assert_eq!(bench.number(), number);
    bench.plot("GPRTE,1,1,c,R1,B,C,D");
    assert_ne!(bench.number(), number);
    assert_eq!(
        bench.order(&Order::LoadRoute(number)),
        Err("another route is offered now: look at it first".into())
    );
    // A waypoint that was moved is another offer too.
    let number = bench.number();
    bench.run += 4_000.0;
    bench.places(&["C"], 1.0);
    assert_ne!(bench.number(), number);
    assert_eq!(bench.chart.route(), Some(&route()));
}

#[test]
fn the_complete_route_goes_before_what_is_still_to_be_sailed() {
    let mut bench = with_plotter();
    bench.places(&["A", "B", "C", "D"], 2.0);
    bench.plot("GPRTE,1,1,c,R1,A,B,C,D");
    bench.plot("GPRTE,1,1,w,R1,B,C,D");
    assert!(bench.chart.offer().unwrap().complete);
    // Another route, or the complete one no longer said.
    bench.plot("GPRTE,1,1,w,R2,B,C,D");
    let offer = bench.chart.offer().unwrap();
    assert_eq!((offer.name.as_str(), offer.complete), ("R2", false));
    bench.plot("GPRTE,1,1,c,R1,A,B,C,D");
    bench.now += 61_000;
    bench.plot("GPRTE,1,1,w,R1,B,C,D");
    assert!(!bench.chart.offer().unwrap().complete);
}

#[test]
fn a_damaged_part_or_another_port_offers_nothing() {
    let mut bench = with_plotter();
    bench.places(&["A", "B", "C", "D"], 2.0);
    bench.plot("GPRTE,2,1,c,R1,A,B");
    let wrong = with_checksum("GPRTE,2,2,c,R1,C,D").replace("C,D", "C,A");
    bench.hear(PLOTTER, &wrong, &mut vec![]);
    assert_eq!(bench.chart.offer(), None);
    for port in [ECDIS, GPS, GYRO, LOG] {
        bench.hear(port, &with_checksum("GPRTE,1,1,c,R1,A,B,C"), &mut vec![]);
        assert_eq!(bench.chart.offer(), None);
    }
}
