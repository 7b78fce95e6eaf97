//! Two programs, one the ship with her chart system and one the autopilot, joined by null modems: two legs and the turn.

use crate::pair::{Pair, mode, parts, waypoints};
use std::time::Duration;
use wheelover_core::geo::{Position, rhumb};
use wheelover_core::nmea::{self, Htd, TurnMode};
use wheelover_core::station::Direction;
use wheelover_core::units::{Course, Distance, Radius};
use wheelover_core::view::ModeName;
use wheelover_tests::page::Page;

#[tokio::test]
async fn two_legs_and_the_turn_between_them_over_serial_lines() {
    let mut place = Position {
        lat: 59.8,
        lon: 25.0,
    };
    let legs = [
        ("one", 0.0, 0.0, None),
        ("two", 245.0, 0.62, Some(0.4)),
        ("three", 275.0, 1.6, None),
    ];
    let route = legs.map(|(id, course, miles, radius)| {
        place = rhumb::destination(place, Course::from_deg(course), Distance::from_nm(miles));
        (id, place, radius.map(Radius::from_nm))
    });
    let ship = "[ship]\ncurrent_set = 330\ncurrent_drift_kn = 1.0\n".to_owned()
        + &waypoints(route.into_iter());
    let pair = Pair::begin("two", "1", &ship, None);
    let mut page = Page::open(pair.autopilot.address).await;
    pair.track(&mut page).await;
    page.until("the leg after the turn", Duration::from_secs(330), |page| {
        assert_eq!(mode(page), Some(ModeName::AutonavTi), "{:?}", page.snapshot);
        parts(page).last().is_some_and(|part| part.situation == 5)
    })
    .await;
    page.follow(Duration::from_secs(20)).await;
    let parts = parts(&page);
    let seen: Vec<u8> = parts.iter().map(|part| part.situation).collect();
    assert_eq!(seen, [2, 3, 4, 5]);
    let worst = parts
        .iter()
        .fold(0.0_f64, |worst, part| worst.max(part.off));
    assert!(worst < 50.0, "{worst} m off the track");
    assert_eq!(page.gaps, [] as [u64; 0]);
    let htd = page.lines.iter().filter(|line| line.dir == Direction::Out);
    let htd: Vec<Htd> = htd
        .filter_map(|line| Htd::from_sentence(&nmea::decode(line.text.as_bytes())))
        .collect();
    let turning = htd
        .iter()
        .filter(|htd| htd.turn_mode == Some(TurnMode::Radius));
    assert!(turning.clone().count() > 40);
    assert!(turning.clone().all(|htd| htd.radius == Some(0.4)));
    assert_eq!(htd.last().unwrap().turn_mode, Some(TurnMode::NotControlled));
    println!(
        "largest cross-track distance {worst:.1} m, {} lines",
        page.lines.len()
    );
}
