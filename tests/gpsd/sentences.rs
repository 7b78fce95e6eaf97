//! The sentences whose values gpsd 3.22 prints. THS, ROT, VHW, HDM, DPT, MTW, VLW and XDR it takes and prints nothing of.

use crate::random::Random;
use crate::{Case, rounds};
use wheelover_core::geo::Position;
use wheelover_core::nmea::*;

const TPV: &str = "TPV";
const SKY: &str = "SKY";
const GST: &str = "GST";
/// Metres a second of a knot.
const KNOT: f64 = 1852.0 / 3600.0;

fn one(line: String) -> Case {
    Case::new(vec![line])
}

/// After a fix, without which gpsd shows neither course nor speed.
fn after_a_fix(line: String) -> Case {
    let mut case = one(line);
    let body = "GPRMC,120000.12,A,5445.3450,S,01234.5670,W,12.5,234.5,221126,3.5,W,A";
    case.before.push(with_checksum(body));
    case
}

fn place(case: Case, position: Position) -> Case {
    case.both(TPV, "/lat", ("latitude", position.lat, 1.0), 9)
        .both(TPV, "/lon", ("longitude", position.lon, 1.0), 9)
}

fn stamp(date: Date, time: UtcTime) -> String {
    let (second, hundredth) = (time.centisecond / 100, time.centisecond % 100);
    format!(
        "20{:02}-{:02}-{:02}T{:02}:{:02}:{second:02}.{hundredth:02}0Z",
        date.year, date.month, date.day, time.hour, time.minute
    )
}

fn mode(random: &mut Random) -> Option<ModeIndicator> {
    Some(random.pick(&[ModeIndicator::Autonomous, ModeIndicator::Differential]))
}

/// A line of which no typed view is made, written by our encoder from the values that it read.
fn encoded(body: &str) -> String {
    let line = with_checksum(body);
    encode(&decode(line.as_bytes())).unwrap()
}

#[test]
fn gga_position_and_heights() {
    rounds("GGA", |random| {
        let position = random.position();
        let (altitude, separation) = (random.tenths(-90, 9_000), random.tenths(-100, 80));
        let gga = Gga {
            time: Some(random.time()),
            position: Some(position),
            quality: Some(random.pick(&[FixQuality::Standard, FixQuality::Differential])),
            satellites: Some(random.from(4, 24) as u32),
            hdop: Some(random.tenths(1, 9)),
            altitude: Some(altitude),
            separation: Some(separation),
            ..Gga::default()
        };
        place(one(gga.line("GP")), position)
            .both(TPV, "/altMSL", ("altitude", altitude, 1.0), 4)
            .both(TPV, "/geoidSep", ("separation", separation, 1.0), 3)
            .exact(TPV, "/mode", 3)
    });
}

#[test]
fn gll_position() {
    rounds("GLL", |random| {
        let position = random.position();
        let gll = Gll {
            position: Some(position),
            time: Some(random.time()),
            status: Some(DataStatus::Valid),
            mode: mode(random),
        };
        place(one(gll.line("GP")), position)
    });
}

#[test]
fn rmc_position_time_motion_and_variation() {
    rounds("RMC", |random| {
        let (position, date, time) = (random.position(), random.date(), random.time());
        let (speed, course) = (random.tenths(1, 99), random.direction());
        let variation = random.tenths(-30, 30);
        let rmc = Rmc {
            time: Some(time),
            status: Some(DataStatus::Valid),
            position: Some(position),
            speed: Some(speed),
            course: Some(course),
            date: Some(date),
            variation: Some(variation),
            mode: mode(random),
            ..Rmc::default()
        };
        place(one(rmc.line("GP")), position)
            .exact(TPV, "/time", stamp(date, time))
            .both(TPV, "/speed", ("speed", speed, KNOT), 3)
            .both(TPV, "/track", ("course", course, 1.0), 4)
            .both(TPV, "/magvar", ("variation", variation, 1.0), 1)
    });
}

#[test]
fn vtg_course_and_speed() {
    rounds("VTG", |random| {
        let (course, speed) = (random.direction(), random.tenths(1, 99));
        let vtg = Vtg {
            course_true: Some(course),
            speed_knots: Some(speed),
            speed_kmh: Some(speed * 1.852),
            mode: mode(random),
            ..Vtg::default()
        };
        after_a_fix(vtg.line("GP"))
            .both(TPV, "/track", ("course_true", course, 1.0), 4)
            .both(TPV, "/speed", ("speed_knots", speed, KNOT), 3)
    });
}

#[test]
fn zda_time_and_date() {
    rounds("ZDA", |random| {
        let (date, time) = (random.date(), random.time());
        let zda = Zda {
            time: Some(time),
            day: Some(date.day.into()),
            month: Some(date.month.into()),
            year: Some(2000 + u32::from(date.year)),
            zone_hours: Some(0.0),
            zone_minutes: Some(0.0),
        };
        one(zda.line("GP")).exact(TPV, "/time", stamp(date, time))
    });
}

#[test]
fn gns_position_and_heights() {
    rounds("GNS", |random| {
        let (altitude, separation) = (random.tenths(-90, 9_000), random.tenths(-100, 80));
        let (degrees, minutes) = (random.from(0, 89), random.from(0, 5_999_999));
        let side = random.pick(&["N", "S"]);
        let minutes = format!("{:02}.{:05}", minutes / 100_000, minutes % 100_000);
        let body = format!(
            "GNGNS,120001.00,{degrees:02}{minutes},{side},01234.5670,E,AA,12,1.1,{altitude:.1},{separation:.1},,"
        );
        let case = one(encoded(&body));
        let size = degrees as f64 + minutes.parse::<f64>().unwrap() / 60.0;
        let latitude = if side == "S" { -size } else { size };
        case.both(TPV, "/lat", ("latitude", latitude, 1.0), 9)
            .both(TPV, "/altMSL", ("altitude", altitude, 1.0), 4)
            .both(TPV, "/geoidSep", ("separation", separation, 1.0), 3)
    });
}

#[test]
fn gsa_and_gsv_satellites() {
    rounds("GSA, GSV", |random| {
        let mut case = Case::new(Vec::new());
        let mut ids = Vec::new();
        while ids.len() < random.from(5, 12) as usize {
            let id = random.from(1, 32) as u32;
            if !ids.contains(&id) {
                ids.push(id);
            }
        }
        // The third and every second one after it is not used.
        let used = |at: usize| at < 2 || at.is_multiple_of(2);
        let in_use: Vec<u32> = (0..ids.len())
            .filter(|at| used(*at))
            .map(|at| ids[at])
            .collect();
        let (pdop, hdop, vdop) = (
            random.tenths(1, 9),
            random.tenths(1, 9),
            random.tenths(1, 9),
        );
        let mut list: Vec<String> = in_use.iter().map(|id| format!("{id:02}")).collect();
        list.resize(12, String::new());
        let gsa = format!("GPGSA,A,3,{},{pdop:.1},{hdop:.1},{vdop:.1}", list.join(","));
        case.lines.push(encoded(&gsa));
        let seen: Vec<GsvSatellite> = ids
            .iter()
            .map(|id| GsvSatellite {
                id: Some(*id),
                elevation: Some(random.from(1, 90) as f64),
                azimuth: Some(random.from(0, 359) as f64),
                signal: Some(random.from(1, 60) as f64),
            })
            .collect();
        let parts: Vec<&[GsvSatellite]> = seen.chunks(4).collect();
        for (at, part) in parts.iter().enumerate() {
            let gsv = Gsv {
                total: Some(parts.len() as u32),
                number: Some(at as u32 + 1),
                in_view: Some(seen.len() as u32),
                satellites: part.to_vec(),
                signal_id: None,
            };
            case.lines.push(gsv.line("GP"));
        }
        case = case
            .number(SKY, "/pdop", pdop, 2)
            .number(SKY, "/hdop", hdop, 2)
            .number(SKY, "/vdop", vdop, 2)
            .exact(SKY, "/nSat", seen.len());
        for (at, satellite) in seen.iter().enumerate() {
            let place = |key: &str| format!("/satellites/{at}/{key}");
            case = case
                .exact(SKY, &place("PRN"), satellite.id.unwrap())
                .exact(SKY, &place("used"), used(at))
                .number(SKY, &place("el"), satellite.elevation.unwrap(), 1)
                .number(SKY, &place("az"), satellite.azimuth.unwrap(), 1)
                .number(SKY, &place("ss"), satellite.signal.unwrap(), 1);
        }
        case
    });
}

#[test]
fn gst_errors() {
    rounds("GST", |random| {
        let mut values = [0.0; 7];
        for value in &mut values {
            *value = random.tenths(0, 90);
        }
        let text = values.map(|value| format!("{value:.1}")).join(",");
        let mut case = one(encoded(&format!("GPGST,120001.00,{text}")));
        let ours = [
            "rms",
            "major",
            "minor",
            "orientation",
            "latitude_error",
            "longitude_error",
            "altitude_error",
        ];
        let theirs = ["rms", "major", "minor", "orient", "lat", "lon", "alt"];
        for ((name, key), value) in ours.into_iter().zip(theirs).zip(values) {
            case = case.both(GST, &format!("/{key}"), (name, value, 1.0), 3);
        }
        case
    });
}

#[test]
fn hdt_true_heading() {
    rounds("HDT", |random| {
        let heading = random.direction();
        let hdt = Hdt {
            heading: Some(heading),
        };
        // gpsd knows no gyro's talker HE.
        one(hdt.line("II")).both("ATT", "/heading", ("heading", heading, 1.0), 3)
    });
}

#[test]
fn hdg_magnetic_heading() {
    rounds("HDG", |random| {
        let heading = random.direction();
        let hdg = Hdg {
            heading: Some(heading),
            // gpsd takes the sensor's heading as it stands.
            deviation: Some(random.tenths(-9, 9)),
            variation: Some(random.tenths(-30, 30)),
        };
        after_a_fix(hdg.line("HC")).both(TPV, "/magtrack", ("heading", heading, 1.0), 4)
    });
}

#[test]
fn dbt_depth() {
    rounds("DBT", |random| {
        let depth = random.tenths(0, 900);
        let mut case = after_a_fix(encoded(&format!("SDDBT,,f,{depth:.1},M,,F")));
        case = case.both(TPV, "/depth", ("metres", depth, 1.0), 3);
        case.after = Vec::new();
        case
    });
}

#[test]
fn mwv_apparent_wind() {
    rounds("MWV", |random| {
        let (angle, speed) = (random.direction(), random.tenths(1, 90));
        let mwv = Mwv {
            angle: Some(angle),
            reference: Some(WindReference::Relative),
            speed: Some(speed),
            unit: Some(WindUnit::Knots),
            status: Some(DataStatus::Valid),
        };
        one(mwv.line("WI"))
            .both(TPV, "/wangler", ("angle", angle, 1.0), 1)
            .both(TPV, "/wspeedr", ("speed", speed, KNOT), 1)
    });
}

#[test]
fn mwd_wind_direction() {
    rounds("MWD", |random| {
        let (true_, magnetic) = (random.direction(), random.direction());
        let speed = random.tenths(1, 40);
        let mwd = Mwd {
            direction_true: Some(true_),
            direction_magnetic: Some(magnetic),
            speed_knots: Some(speed / KNOT),
            speed_mps: Some(speed),
        };
        one(mwd.line("WI"))
            .both(TPV, "/wanglet", ("direction_true", true_, 1.0), 1)
            .both(TPV, "/wanglem", ("direction_magnetic", magnetic, 1.0), 1)
            .both(TPV, "/wspeedt", ("speed_mps", speed, 1.0), 1)
    });
}
