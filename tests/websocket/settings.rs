//! Settings changed from the page: checked as the configuration is, and kept whatever happens to the program.

use std::path::Path;
use std::time::Duration;
use wheelover_core::settings::Value;
use wheelover_core::view::Order;
use wheelover_tests::folder;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;

fn set(key: &str, value: f64) -> Order {
    let key = key.to_string();
    let value = Value::Number(value);
    Order::Setting { key, value }
}

/// A configuration of the autopilot in a folder; gives the arguments that name it.
fn configured(folder: &Path, text: &str) -> [String; 2] {
    let file = folder.join("wheelover.toml");
    std::fs::write(&file, format!("roles = [\"autopilot\"]\n{text}")).unwrap();
    ["--config".to_string(), file.display().to_string()]
}

fn start(arguments: &[String]) -> Program {
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    Program::start(&arguments)
}

/// A setting as the page is shown it.
async fn shown(program: &Program, key: &str) -> f64 {
    let mut page = Page::open(program.address).await;
    page.until("the settings", SOON, |page| page.settings.is_some())
        .await;
    let values = &page.settings.as_ref().unwrap().values;
    match &values.iter().find(|(name, _)| name == key).unwrap().1 {
        Value::Number(number) => *number,
        other => panic!("{other:?}"),
    }
}

#[tokio::test]
async fn the_last_change_is_in_force_after_the_program_was_stopped() {
    let folder = folder("kept");
    let config = configured(&folder, "");
    for value in [11.0, 12.5, 13.25] {
        let mut program = start(&config);
        let mut page = Page::open(program.address).await;
        for before in [5.0, 6.0, 7.0, value] {
            assert!(page.command(set("rudder_limit", before)).await.ok);
        }
        page.leave().await;
        assert_eq!(program.stop(), Some(0));
        let program = start(&config);
        assert_eq!(shown(&program, "rudder_limit").await, value);
    }
    let kept = std::fs::read_to_string(folder.join("wheelover.settings.toml")).unwrap();
    assert!(kept.contains("version = 1\n"), "{kept}");
}

#[tokio::test]
async fn an_unreadable_file_is_kept_aside_and_said() {
    let folder = folder("foreign");
    let config = configured(&folder, "");
    let file = folder.join("wheelover.settings.toml");
    for foreign in [
        "version = 9\nsails = true\n",
        "rudder_limit = 12.0\n",
        "\0\0",
    ] {
        std::fs::write(&file, foreign).unwrap();
        let mut program = start(&config);
        let mut page = Page::open(program.address).await;
        assert!(page.command(set("rudder_limit", 9.0)).await.ok);
        page.leave().await;
        program.stop();
        let said = program.last_words();
        let aside = said.iter().find_map(|line| {
            let line = line.strip_prefix("caution: ")?;
            Some(line.split_once("the file is kept as ")?.1.to_string())
        });
        let aside = aside.unwrap_or_else(|| panic!("{said:?}"));
        assert_eq!(std::fs::read_to_string(aside).unwrap(), foreign);
        let program = start(&config);
        assert_eq!(shown(&program, "rudder_limit").await, 9.0);
    }
}

// FD1: killed while a page changes settings without a pause, the file is always whole.
#[tokio::test]
async fn a_kill_during_a_write_leaves_a_whole_file() {
    let folder = folder("killed");
    let config = configured(&folder, "");
    let mut last = None;
    for round in 0..12_u64 {
        let mut program = start(&config);
        let said = program.said();
        assert!(
            !said.iter().any(|line| line.contains("kept as")),
            "{said:?}"
        );
        let found = shown(&program, "rudder_limit").await;
        if let Some((low, high)) = last {
            assert!((low..=high).contains(&found), "{low} to {high}: {found}");
        }
        let mut page = Page::open(program.address).await;
        let mut value = 2.0 + round as f64;
        let low = value;
        for _ in 0..20 + round * 5 {
            value += 1.0 / 128.0;
            assert!(page.command(set("rudder_limit", value)).await.ok);
        }
        program.kill();
        // The first round may be killed before anything was kept.
        last = (round > 0 || found < 20.0).then_some((low.min(found), value));
    }
}

#[tokio::test]
async fn a_setting_is_checked_as_the_configuration_is() {
    let folder = folder("checked");
    let port = "allow_output = true\n[[port]]\nname = \"gear\"\nkind = \"serial\"\npath = \"/dev/no-such\"\n\
                profile = \"gear\"\noutput = true\n";
    let config = configured(&folder, port);
    let mut program = start(&config);
    let mut page = Page::open(program.address).await;
    for (key, value, words) in [
        ("step_hz", 20.0, ["gear", "80 %"]),
        ("track_caution", 6.0, ["track_caution", "track_fail"]),
        ("track_fail", 2.5, ["track_caution", "track_fail"]),
    ] {
        let answer = page.command(set(key, value)).await;
        assert!(!answer.ok, "{key} = {value}");
        for word in words {
            assert!(answer.text.contains(word), "{word}: {}", answer.text);
        }
    }
    assert!(page.command(set("track_fail", 6.0)).await.ok);
    assert!(page.command(set("track_caution", 5.5)).await.ok);
    page.leave().await;
    program.stop();
    // The same from the file of kept settings: said, and not in force.
    let file = folder.join("wheelover.settings.toml");
    std::fs::write(&file, "version = 1\n[settings]\nstep_hz = 20.0\n").unwrap();
    let program = start(&config);
    assert_eq!(shown(&program, "step_hz").await, 10.0);
    let said = program.said().join("\n");
    assert!(
        said.contains("80 %") && said.contains("not in force"),
        "{said}"
    );
    page = Page::open(program.address).await;
    page.follow(Duration::from_millis(300)).await;
    assert!(page.snapshot.is_some());
}
