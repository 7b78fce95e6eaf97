//! A small craft's ports: what the document shows is accepted, and a hand unit's port always checks (EMC-4).

use super::check;
use crate::config::read::from_text;
use wheelover_core::station::Profile;

// The configuration of docs/hand-unit.md.
#[test]
fn the_documents_configuration_is_accepted() {
    let document = include_str!("../../../../docs/hand-unit.md");
    let (_, rest) = document.split_once("```toml\n").unwrap();
    let (text, _) = rest.split_once("```").unwrap();
    let config = from_text("w.toml", text, None).unwrap();
    let profiles = config.ports.iter().map(|port| port.setup.profile);
    let expect = [Profile::Hmi, Profile::Imu, Profile::Plotter, Profile::Gear];
    assert_eq!(profiles.collect::<Vec<_>>(), expect);
}

// EMC-4
#[test]
fn a_hand_unit_always_says_its_checksum() {
    let text = |policy: &str| {
        format!(
            "roles = [\"autopilot\"]\n[[port]]\nname = \"hand\"\nkind = \"serial\"\npath = \"/dev/null\"\n\
             baud = 4800\nprofile = \"hmi\"\nchecksum = \"{policy}\"\n"
        )
    };
    assert!(from_text("w.toml", &text("required"), None).is_ok());
    for policy in ["learned", "optional"] {
        check(&text(policy), 8, &["allowed is \"required\""]);
    }
}
