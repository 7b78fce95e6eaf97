//! `[gear]`, and the yacht of the world (AP-18).

use super::super::in_force;
use crate::config::read::from_text;
use wheelover_core::motor::{MotorSetup, Protocol};
use wheelover_core::settings::{DeadBand, GearKind};
use wheelover_core::world::ShipModel;

#[test]
fn a_motor_is_told_by_its_keys() {
    let text = "roles = [\"autopilot\"]\n[gear]\nkind = \"motor\"\nprotocol = \"jrk\"\nsign = -1\ncentre = 48.0\n\
                port_end = 12.0\nstarboard_end = 85.0\ntravel_deg = 30.0\ntrim_deg = 1.5\ndead_band = \"minimum\"\n\
                dead_band_min_deg = 0.8\ndamping_s = 0.3\ncurrent_max_a = 7.0\nslew_deg_s = 9.0\n";
    let config = from_text("w.toml", text, None).unwrap();
    let settings = &config.settings;
    assert_eq!(
        (settings.gear, settings.motor_band),
        (GearKind::Jrk, DeadBand::Minimum)
    );
    assert_eq!(settings.rudder_slew, 9.0);
    let setup = MotorSetup::of(settings).unwrap();
    assert!(setup.reversed && setup.protocol == Protocol::Jrk);
    assert_eq!(
        (setup.feedback_port, setup.feedback_starboard),
        (0.12, 0.85)
    );
    assert_eq!((setup.travel_deg, setup.current_max_a), (30.0, 7.0));
    // What is printed is what is in force, and reads as the same.
    let again = from_text("w.toml", &in_force(&config), None).unwrap();
    assert_eq!(again.settings, config.settings);
}

#[test]
fn a_gear_that_cannot_be_is_refused_by_its_key() {
    let refuse = |gear: &str, words: &[&str]| {
        let text = format!("roles = [\"autopilot\"]\n[gear]\n{gear}");
        let refused = from_text("w.toml", &text, None).unwrap_err().to_string();
        for word in words {
            assert!(refused.contains(word), "{refused}");
        }
    };
    refuse("kind = \"rope\"\n", &["w.toml:3", "rope", "motor"]);
    refuse("protocol = \"jrk\"\n", &["w.toml:2", "kind"]);
    refuse("kind = \"motor\"\nsign = 0\n", &["sign = 0", "1 and -1"]);
    refuse(
        "kind = \"motor\"\ncentre = 95.0\n",
        &["motor_feedback_centre"],
    );
    refuse(
        "kind = \"motor\"\ncurrent_max_a = 900.0\n",
        &["motor_current is 900"],
    );
    refuse("speed = 1\n", &["speed", "unknown key"]);
    let pair = "kind = \"motor\"\n[ship]\nrudders = \"independent\"\n";
    refuse(pair, &["a motor turns one rudder"]);
}

#[test]
fn a_yacht_with_a_motor_sails_in_the_world() {
    let text = "[ship]\nmodel = \"yacht\"\nwind_from = 150.0\nwind_kn = 15.0\ngustiness = 0.25\n[gear]\nkind = \"motor\"\n";
    let config = from_text("w.toml", text, None).unwrap();
    let voyage = config.voyage();
    assert_eq!(voyage.world.ship, ShipModel::Yacht);
    assert_eq!(voyage.world.motor, Some(Protocol::Pypilot));
    assert_eq!(voyage.world.speed.knots().round(), 6.0);
    assert!(voyage.ship.unwrap().length < 20.0);
    assert!(in_force(&config).contains("model = \"yacht\""));
}
