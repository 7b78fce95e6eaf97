//! Scenario files in, figures and tables out.

use super::*;

fn bench_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/trackbench")
}

fn fresh_folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wheelover-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn figures_have_the_names_of_the_peers_table() {
    let file = bench_folder().join("scenario.json");
    let Document::Bench(bench) = Document::parse(&read(&file).unwrap()).unwrap() else {
        panic!("not a bench");
    };
    let (name, conditions) = bench.scenarios().next().unwrap();
    let quiet = Disturbance::default();
    let mut run = BenchRun::new(&bench, *conditions, &quiet, SteeringSettings::default());
    run.step();
    let line = text(&[(name.to_owned(), run.report())], Some("wheelover"), true);
    let peers = read(&bench_folder().join("peers.csv")).unwrap();
    let mut rest = line.as_str();
    for column in peers.lines().next().unwrap().split(',') {
        let key = format!("\"{column}\":");
        let at = rest
            .find(&key)
            .unwrap_or_else(|| panic!("{column} is missing or out of order"));
        rest = &rest[at + key.len()..];
    }
    assert!(
        serde_json::from_str::<serde_json::Value>(&line).is_ok(),
        "{line}"
    );
}

// CLI-4
#[test]
fn a_scenario_writes_its_table_at_two_a_second() {
    let folder = fresh_folder("scenario");
    let csv = folder.join("out.csv");
    let file = bench_folder().join("scenario.json");
    assert_eq!(
        simulate(&file, Some("TB0_calm_15kn"), Some(&csv), true, true),
        Ok(0)
    );
    let table = read(&csv).unwrap();
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows[0].split(',').count(), 8);
    assert!(rows[1].starts_with("0.0,0.000,150.000,") && rows[2].starts_with("0.5,"));
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn manoeuvres_write_the_reference_tables() {
    let folder = fresh_folder("manoeuvre");
    let check = |name: &str, text: &str, reference: &str, tolerance: f64| {
        let (file, csv) = (folder.join(format!("{name}.json")), folder.join("out.csv"));
        std::fs::write(&file, text).unwrap();
        assert_eq!(simulate(&file, None, Some(&csv), true, true), Ok(0));
        let theirs = read(&bench_folder().join("../manoeuvres").join(reference)).unwrap();
        let ours = read(&csv).unwrap();
        assert_eq!(ours.lines().next(), theirs.lines().next());
        assert_eq!(ours.lines().count(), theirs.lines().count());
        for (ours, theirs) in ours.lines().zip(theirs.lines()).skip(1) {
            for (a, b) in ours.split(',').zip(theirs.split(',')) {
                let (a, b): (f64, f64) = (a.parse().unwrap(), b.parse().unwrap());
                assert!(
                    (a - b).abs() <= tolerance * b.abs().max(1.0),
                    "{ours}\n{theirs}"
                );
            }
        }
    };
    check(
        "turn",
        r#"{"ship": "mariner", "speed_kn": 15, "execute_s": 100, "duration_s": 1100,
            "manoeuvre": {"kind": "turn", "rudder_deg": 35}}"#,
        "mariner_15kn_turn35_stbd.csv",
        1e-4,
    );
    check(
        "zigzag",
        r#"{"ship": "mariner", "speed_kn": 15, "execute_s": 10, "duration_s": 900,
            "manoeuvre": {"kind": "zigzag", "rudder_deg": 20, "heading_deg": 20}}"#,
        "mariner_15kn_zigzag_20_20.csv",
        1e-4,
    );
    check(
        "spiral",
        r#"{"ship": "mariner", "speed_kn": 15, "manoeuvre": {"kind": "spiral"}}"#,
        "mariner_15kn_spiral.csv",
        1e-2,
    );
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn what_is_wrong_is_said_in_one_line() {
    let folder = fresh_folder("wrong");
    let check = |text: &str, said: &str| {
        let file = folder.join("wrong.json");
        std::fs::write(&file, text).unwrap();
        let error = simulate(&file, None, None, true, true).unwrap_err();
        assert!(
            error.contains(said) && error.lines().count() == 1,
            "{error}"
        );
    };
    check("{", "not JSON");
    check("{}", "neither `scenarios` nor `manoeuvre`");
    check(
        r#"{"ship": "raft", "speed_kn": 15, "manoeuvre": {"kind": "spiral"}}"#,
        "ship `raft`",
    );
    check(
        r#"{"ship": "mariner", "speed_kn": -1, "manoeuvre": {"kind": "spiral"}}"#,
        "speed_kn is -1",
    );
    check(
        r#"{"ship": "mariner", "speed_kn": 15, "manoeuvre": {"kind": "dance"}}"#,
        "dance",
    );
    let file = bench_folder().join("scenario.json");
    let error = simulate(&file, Some("TB9"), None, true, true).unwrap_err();
    assert!(
        error.contains("TB9") && error.contains("TB1_main_15kn"),
        "{error}"
    );
    let error = simulate(Path::new("absent.json"), None, None, true, true).unwrap_err();
    assert!(error.starts_with("absent.json: "), "{error}");
    std::fs::remove_dir_all(folder).unwrap();
}
