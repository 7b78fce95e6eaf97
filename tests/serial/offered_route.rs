//! A plotter on a serial line offers a route by WPL and RTE to the chart system of the real binary: it is shown, and loaded by an
//! officer's order alone (TCS-13).

use std::time::Duration;
use wheelover_core::geo::{Position, rhumb};
use wheelover_core::nmea::Wpl;
use wheelover_core::units::{Course, Distance};
use wheelover_core::view::{ChartRequest, OfferedRoute, Order};
use wheelover_tests::http::get;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::serial::Line;
use wheelover_tests::{folder, with_checksum};

fn offered(program: &Program) -> Option<OfferedRoute> {
    let answer = get(program.address, "/api/offered", &[]);
    assert_eq!(answer.status, 200);
    serde_json::from_slice(&answer.body).unwrap()
}

#[tokio::test]
async fn a_route_by_rte_and_wpl_is_offered_and_loaded_by_an_order() {
    let folder = folder("offered");
    let names = ["ecdis", "gps", "gyro1", "plotter"];
    let [mut autopilot, gps, gyro, mut plotter] = names.map(|name| Line::new(&folder.join(name)));
    let mut text = "roles = [\"chart_system\"]\nallow_output = true\n".to_string();
    for name in names {
        text += &format!(
            "[[port]]\nname = \"{name}\"\nkind = \"serial\"\npath = \"{}\"\nbaud = 38400\nprofile = \"{name}\"\n\
             output = {}\n",
            folder.join(name).display(),
            name == "ecdis"
        );
    }
    text += "[chart_system]\noffered_radius_nm = 0.4\n";
    let config = folder.join("wheelover.toml");
    std::fs::write(&config, text).unwrap();
    let program = Program::start(&["--config", config.to_str().unwrap()]);
    let _gps = gps.talk(|tick| match tick % 10 {
        0 => vec![
            with_checksum("GPGLL,5400.000,N,01000.000,E,120000.00,A,A"),
            with_checksum("GPVTG,090.0,T,,M,12.00,N,22.20,K,A"),
        ],
        _ => vec![],
    });
    let _gyro = gyro.talk(|_| vec![with_checksum("HEHDT,090.00,T")]);
    assert_eq!(offered(&program), None);

    // The ship stands half a mile inside the first leg of the plotter's route.
    let ship = Position {
        lat: 54.0,
        lon: 10.0,
    };
    let mut place = rhumb::destination(ship, Course::from_deg(270.0), Distance::from_nm(0.5));
    for (id, course, miles) in [
        ("PIER", 90.0, 4.0),
        ("BUOY 4", 120.0, 3.0),
        ("BERTH", 0.0, 0.0),
    ] {
        let wpl = Wpl {
            position: Some(place),
            waypoint: Some(id.into()),
        };
        plotter.send(format!("{}\r\n", wpl.line("GP")).as_bytes());
        place = rhumb::destination(place, Course::from_deg(course), Distance::from_nm(miles));
    }
    plotter.say("GPRTE,2,1,c,HARBOUR,PIER,BUOY 4");
    plotter.say("GPRTE,2,2,c,HARBOUR,BERTH");
    let end = std::time::Instant::now() + SOON;
    let offer = loop {
        if let Some(offer) = offered(&program) {
            break offer;
        }
        assert!(std::time::Instant::now() < end, "no offer");
        tokio::time::sleep(Duration::from_millis(50)).await;
    };
    assert_eq!((offer.name.as_str(), offer.complete), ("HARBOUR", true));
    assert_eq!(offer.waypoints, ["PIER", "BUOY 4", "BERTH"]);
    assert_eq!(offer.refusal, "");
    assert!((offer.length_nm.unwrap() - 7.0).abs() < 0.01, "{offer:?}");

    let mut page = Page::open(program.address).await;
    // Nobody has loaded it: no route is monitored, and no track control begins.
    let refused = page.command(Order::Chart(ChartRequest::Track)).await;
    assert_eq!((refused.ok, refused.text.as_str()), (false, "no route"));
    let refused = page.command(Order::LoadRoute(offer.number + 1)).await;
    assert!(!refused.ok, "{}", refused.text);
    let answer = page.command(Order::LoadRoute(offer.number)).await;
    assert_eq!(answer.text, "route HARBOUR loaded, 2 legs");
    page.until("the route", SOON, |page| {
        page.route
            .as_ref()
            .is_some_and(|route| route.name == "HARBOUR")
    })
    .await;
    let route = page.route.clone().unwrap();
    assert_eq!(route.waypoints[1].radius_nm, Some(0.4));
    page.insist(Order::Chart(ChartRequest::Track), SOON).await;
    let begins = |line: &str| line.starts_with("$EIHTC,V,,,T,R,,,,,,,090.0,T,C");
    loop {
        let (_, line) = autopilot.hear(SOON).expect("the chart system speaks");
        if begins(&line) {
            break;
        }
        assert!(std::time::Instant::now() < end + SOON, "no track control");
    }
    let refusal = offered(&program).unwrap().refusal;
    assert_eq!(refusal, "track control is active: stop it first");
    let refused = page.command(Order::LoadRoute(offer.number)).await;
    assert_eq!((refused.ok, refused.text), (false, refusal));
}
