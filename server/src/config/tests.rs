//! What a configuration may say, and what is said about the rest.

mod contacts;
mod gear;
mod rudders;
mod small_craft;

use super::in_force;
use super::read::from_text;
use crate::error::Error;

const PORT: &str = "[[port]]\nname = \"ecdis\"\nkind = \"tcp-server\"\naddress = \"127.0.0.1:0\"\nprofile = \"ecdis\"\n";

/// `text` is refused at `line`, with every one of `words` in the complaint.
fn check(text: &str, line: usize, words: &[&str]) {
    let error = from_text("w.toml", text, None).expect_err(text);
    let Error::Config {
        line: at,
        text: complaint,
        ..
    } = &error
    else {
        panic!("{error}");
    };
    assert_eq!(*at, Some(line), "{text}: {error}");
    assert!(!complaint.contains('\n'), "one line: {error}");
    for word in words {
        assert!(complaint.contains(word), "{word} is not in: {error}");
    }
    assert!(error.to_string().starts_with("w.toml:"));
}

#[test]
fn every_key_may_be_left_out() {
    let config = from_text("w.toml", "", None).unwrap();
    assert_eq!(config.roles.len(), 3);
    assert_eq!(config.listen.to_string(), "127.0.0.1:8080");
    assert!(!config.allow_output);
}

#[test]
fn unknown_keys_are_named_with_their_line_and_what_is_allowed() {
    check(
        "allow_output = true\nlissen = \"1\"\n",
        2,
        &["unknown key `lissen`", "allowed", "`listen`"],
    );
    check(
        &format!("{PORT}speed = 4800\n"),
        6,
        &["unknown key `speed`", "`baud`"],
    );
    check(
        "[autopilot]\nrudder_limits = 5.0\n",
        2,
        &["unknown key `rudder_limits`", "`rudder_limit`"],
    );
    check(
        "[ship]\nlength = 5\n",
        2,
        &["unknown key `length`", "`length_m`"],
    );
    check(
        "roles = [\"pilot\"]\n",
        1,
        &["unknown value `pilot`", "`chart_system`"],
    );
}

#[test]
fn values_that_cannot_be_are_refused() {
    check("listen = \"here\"\n", 1, &["listen", "IP:PORT"]);
    check("roles = []\n", 1, &["roles", "autopilot"]);
    check(
        "[autopilot]\nrudder_limit = 99\n",
        2,
        &["rudder_limit", "2 to 35"],
    );
    check(
        "[autopilot]\nrudder_limit = nan\n",
        2,
        &["rudder_limit", "2 to 35"],
    );
    check("[ship]\nspeed_kn = 0\n", 1, &["speed_kn", "1 to 40"]);
    check("allow_output = yes\n", 1, &[]);
    check("listen = \n", 1, &[]);
}

#[test]
fn ports_are_checked() {
    let one = "roles = [\"autopilot\"]\n";
    let serial = |rest: &str| {
        format!(
            "{one}[[port]]\nname = \"gear\"\nkind = \"serial\"\nprofile = \"gear\"\npath = \"/dev/ttyX\"\n{rest}"
        )
    };
    assert!(from_text("w.toml", &format!("{one}{PORT}"), None).is_ok());
    check(PORT, 1, &["\"ecdis\"", "station", "\"world\""]);
    check(
        &format!("{one}{PORT}station = \"world\"\n"),
        7,
        &["world", "\"autopilot\""],
    );
    check(&format!("{one}{PORT}{PORT}"), 8, &["named twice"]);
    check(
        &format!("{one}{PORT}{}", PORT.replacen("ecdis", "other", 1)),
        11,
        &["profile", "ecdis"],
    );
    check(
        &format!("{one}{PORT}checksum = \"optional\"\n"),
        7,
        &["optional", "\"required\"", "\"learned\""],
    );
    check(
        &format!("{one}{PORT}baud = 4800\n"),
        7,
        &["baud", "tcp-server"],
    );
    check(&serial("baud = 9600\n"), 7, &["9600", "4800 and 38400"]);
    let again = serial("").replace("gear", "log").replace(one, "");
    check(&(serial("") + &again), 7, &["same place", "gear", "log"]);
    let without = serial("").replace("path = \"/dev/ttyX\"\n", "");
    check(&without, 2, &["needs the key path"]);
    let file = serial("output = true\n").replace("serial", "file");
    check(&file, 2, &["only read"]);
}

// FB12
#[test]
fn a_line_that_would_be_overloaded_is_refused_with_the_sum() {
    let gear = |rate: &str| {
        format!(
            "roles = [\"autopilot\"]\n[autopilot]\nstep_hz = {rate}\n[[port]]\nname = \"gear\"\n\
             kind = \"serial\"\nprofile = \"gear\"\npath = \"/dev/ttyX\"\noutput = true\n"
        )
    };
    assert!(from_text("w.toml", &gear("10"), None).is_ok());
    check(
        &gear("20"),
        4,
        &["ROR 31 x 20 = 620", "129 %", "480", "80 %"],
    );
    assert!(
        from_text(
            "w.toml",
            &gear("20").replace("output = true", "baud = 38400"),
            None
        )
        .is_ok()
    );
}

#[test]
fn a_route_that_does_not_fit_is_refused() {
    let route = |radius: &str| {
        format!(
            "[[route.waypoint]]\nid = \"A\"\nlat = 54.0\nlon = 10.0\n[[route.waypoint]]\nid = \"B\"\nlat = 54.1\n\
             lon = 10.0\nradius_nm = {radius}\n[[route.waypoint]]\nid = \"C\"\nlat = 54.1\nlon = 10.2\n"
        )
    };
    assert!(from_text("w.toml", &route("0.5"), None).is_ok());
    check(
        &route("9"),
        1,
        &["route", "radius 9.000 nm", "B", "largest"],
    );
    check(&route("nan"), 1, &["B", "not a number"]);
}

#[test]
fn what_is_in_force_reads_back_the_same() {
    let text = format!(
        "roles = [\"autopilot\", \"chart_system\"]\nallow_output = true\n{PORT}station = \"autopilot\"\noutput = true\n\
         [autopilot]\nrudder_limit = 12\n[[route.waypoint]]\nid = \"A\"\nlat = 54.0\nlon = 10.0\n\
         [[route.waypoint]]\nid = \"B\"\nlat = 54.1\nlon = 10.0\n"
    );
    let first = in_force(&from_text("w.toml", &text, None).unwrap());
    let again = in_force(&from_text("w.toml", &first, None).unwrap());
    assert_eq!(first, again);
    assert!(first.contains("rudder_limit = 12.0"));
}

// A coordinate has no more decimals than a millimetre needs.
#[test]
fn no_coordinate_has_fifteen_decimals() {
    let given = "[[route.waypoint]]\nid = \"A\"\nlat = 54.000000000012\nlon = 10.1\n\
         [[route.waypoint]]\nid = \"B\"\nlat = 54.1\nlon = 10.3000000000004\n";
    let given = in_force(&from_text("w.toml", given, None).unwrap());
    assert!(given.contains("lat = 54.0\nlon = 10.1\n") && given.contains("lon = 10.3\n"));
    let coordinates = given
        .lines()
        .filter(|line| line.starts_with("lat = ") || line.starts_with("lon = "));
    let decimals = coordinates.map(|line| line.split('.').next_back().unwrap_or_default().len());
    let most = decimals.max();
    assert!(most.is_some_and(|most| most <= 8), "{most:?} in {given}");
}

// AP-20
#[test]
fn whose_constants_steer_is_said() {
    let says = |text: &str, words: &str| {
        let shown = in_force(&from_text("w.toml", text, None).unwrap());
        assert!(shown.contains(words), "{shown}");
    };
    let ship = "roles = [\"autopilot\"]\n[ship]\n";
    let own = "gain_per_s = 0.1\ntime_constant_s = 60.0\n";
    says(ship, "cautious ones");
    says(
        &format!("{ship}model = \"mariner\"\n"),
        "those of the model",
    );
    says(&format!("{ship}{own}"), "as given");
    says(&format!("{ship}model = \"mariner\"\n{own}"), "as given");
    says("roles = [\"autopilot\", \"world\"]\n", "those of the model");
    let both = format!("{ship}model = \"mariner\"\n{own}");
    let said = from_text("w.toml", &both, None).unwrap().two_ships();
    assert!(said.unwrap().contains("time_constant_s steer"));
}

// HTC 14
#[test]
fn a_port_says_whether_a_null_status_commands() {
    let port = |profile: &str, null: &str| {
        format!(
            "roles = [\"autopilot\"]\n[[port]]\nname = \"a\"\nkind = \"udp\"\naddress = \"127.0.0.1:1\"\nprofile = \"{profile}\"\n{null}\n"
        )
    };
    let accepts = |text: &str| {
        from_text("w.toml", text, None).map(|config| config.settings.accept_null_status)
    };
    assert!(accepts(&port("ecdis", "")).unwrap());
    assert!(!accepts(&port("ecdis", "null_status = false")).unwrap());
    assert!(accepts(&port("gyro1", "null_status = false")).is_err());
}

// What is accepted acts: the rest of the specification's names are known, and refused until they are built.
#[test]
fn what_is_not_built_yet_is_refused_by_its_name() {
    let not_built =
        |text: &str, line: usize, name: &str| check(text, line, &[name, "is not built yet"]);
    let port = PORT.replace("profile = \"ecdis\"", "profile = \"targets\"");
    not_built(&format!("roles = [\"autopilot\"]\n{port}"), 6, "targets");
    check(
        &PORT.replace("profile = \"ecdis\"", "profile = \"radar\""),
        5,
        &["unknown value `radar`", "`monitor`"],
    );
    not_built(
        "\n[commissioning]\nskipped_by = \"A\"\n",
        2,
        "commissioning",
    );
}

#[test]
fn what_no_station_here_uses_is_refused() {
    let unused = |role: &str, text: &str, words: &[&str]| {
        let words = [words, &["does not run here"]].concat();
        check(&format!("roles = [\"{role}\"]\n{text}"), 3, &words);
    };
    unused(
        "autopilot",
        "[ship]\nstart_heading = 10\n",
        &["start_heading", "world"],
    );
    unused(
        "world",
        "[ship]\nantenna_forward_m = 9\n",
        &["autopilot", "chart_system"],
    );
    unused("world", "[ship]\nrudder_max_deg = 30\n", &["autopilot"]);
    let text = "roles = [\"world\"]\n[autopilot]\nset_rate = 9\n";
    check(text, 2, &["[autopilot]", "does not run here"]);
    // What is printed is what acts, and reads back.
    for role in ["autopilot", "chart_system", "world"] {
        let text = format!("roles = [\"{role}\"]\n");
        let first = in_force(&from_text("w.toml", &text, None).unwrap());
        let again = in_force(&from_text("w.toml", &first, None).unwrap());
        assert_eq!(first, again);
    }
}

// AP-16: the offsets of the ship reach the autopilot.
#[test]
fn the_offsets_of_the_ship_are_settings_of_the_autopilot() {
    let text = "roles = [\"autopilot\"]\n[ship]\nantenna_forward_m = -40\nconning_starboard_m = 2.5\n\
                pivot_forward_m = 30\nrudder_forward_m = -55\n";
    let config = from_text("w.toml", text, None).unwrap();
    assert_eq!(config.settings.antenna_forward_m, -40.0);
    assert_eq!(config.settings.conning_starboard_m, 2.5);
    assert_eq!(config.settings.pivot_forward_m, Some(30.0));
    assert_eq!(config.settings.rudder_forward_m, Some(-55.0));
    let wrong = "roles = [\"autopilot\"]\n[ship]\nrudder_forward_m = 55\n";
    check(wrong, 2, &["rudder_forward_m", "-230 to -1"]);
}

#[test]
fn settings_that_agree_together_are_taken_in_any_order() {
    for text in [
        "[autopilot]\ntrack_caution = 6\ntrack_fail = 8\n",
        "[autopilot]\nrudder_limit = 12\n[ship]\nrudder_max_deg = 15\n",
    ] {
        assert!(from_text("w.toml", text, None).is_ok(), "{text}");
    }
    check(
        "[autopilot]\ntrack_caution = 6\n",
        2,
        &["track_caution", "track_fail"],
    );
}

// SEN-3
#[test]
fn a_port_may_believe_some_talkers_only() {
    let with = |talkers: &str| format!("roles = [\"autopilot\"]\n{PORT}talkers = {talkers}\n");
    let config = from_text("w.toml", &with("[\"EI\", \"RA\"]"), None).unwrap();
    assert_eq!(config.ports[0].setup.talkers, ["EI", "RA"]);
    assert!(in_force(&config).contains("talkers = [\"EI\", \"RA\"]"));
    for wrong in ["[]", "[\"P\"]", "[\"ei\"]", "[\"EIX\"]", "[\"EI\", \"EI\"]"] {
        check(&with(wrong), 7, &["talkers", "two capital letters"]);
    }
}

// TCS-11, TCS-13
#[test]
fn the_chart_system_side_has_its_own_times_and_what_it_tells() {
    let with = |text: &str| format!("roles = [\"chart_system\"]\n[chart_system]\n{text}\n");
    let config = from_text(
        "w.toml",
        &with("early_s = 240\nsoon_s = 45\neve = true\ndead_reckoning = true"),
        None,
    );
    let chart = config.unwrap().voyage().chart;
    assert_eq!((chart.early_s, chart.soon_s), (240.0, 45.0));
    assert!(chart.eve && chart.dead_reckoning);
    check(&with("early_s = 59"), 2, &["early_s = 59", "60 to 900 s"]);
    check(&with("soon_s = 5"), 2, &["soon_s = 5", "10 to 120 s"]);
    check(
        &with("early_s = 60\nsoon_s = 90"),
        2,
        &["soon_s", "early_s"],
    );
    check(&with("late_s = 5"), 3, &["unknown key", "late_s"]);
    let unused = "roles = [\"autopilot\"]\n[chart_system]\neve = true\n";
    check(unused, 2, &["[chart_system]", "does not run here"]);
}

// TCS-2
#[test]
fn without_a_route_a_configuration_has_none() {
    let config = from_text("w.toml", "roles = [\"chart_system\"]\n", None).unwrap();
    let voyage = wheelover_core::voyage::Voyage::configured(config.voyage());
    let waypoints = wheelover_core::view::route_document(&voyage).waypoints;
    assert_eq!(waypoints.len(), 0);
}
