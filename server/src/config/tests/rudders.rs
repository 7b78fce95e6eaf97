//! How the rudders hang together, as it is written in a configuration (AP-4).

use super::super::in_force;
use super::check;
use crate::config::read::from_text;
use wheelover_core::settings::Rudders;

// AP-4
#[test]
fn the_rudders_are_the_ships_for_autopilot_and_world() {
    let rudders = |text: &str| {
        let config = from_text("w.toml", text, None).unwrap();
        (config.settings.rudders, config.voyage().world.pair)
    };
    let told = |name: &str| format!("[ship]\nrudders = \"{name}\"\n");
    assert_eq!(rudders(""), (Rudders::Single, false));
    assert_eq!(rudders(&told("single")), (Rudders::Single, false));
    assert_eq!(rudders(&told("linked")), (Rudders::Linked, false));
    assert_eq!(rudders(&told("independent")), (Rudders::Independent, true));
    assert_eq!(
        rudders("[autopilot]\nrudders = \"independent\"\n"),
        (Rudders::Independent, true)
    );
    check(
        &told("twin"),
        2,
        &["`twin`", "`single`, `linked`, `independent`"],
    );
    let shown = in_force(&from_text("w.toml", &told("independent"), None).unwrap());
    assert!(shown.contains("\nrudders = \"independent\"\n"), "{shown}");
    assert_eq!(shown, in_force(&from_text("w.toml", &shown, None).unwrap()));
}
