//! How the program ends: with a message and a code of its own where the control loop fails, so that who watches
//! over it starts it again.

use std::time::Duration;
use wheelover_core::view::ModeName;
use wheelover_tests::http::get;
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;

/// What a program says that fails after a second, and its exit code.
fn fails(how: &str) -> (Option<i32>, String) {
    let drill = format!("{how}:1000");
    let mut program = Program::start_with(&[], &[("WHEELOVER_DRILL", &drill)]);
    let code = program.ended();
    (code, program.last_words().join("\n"))
}

// A control thread that panics leaves no server without steering.
#[test]
fn a_panic_in_the_control_loop_ends_the_program_with_a_message_and_a_code() {
    let (code, said) = fails("panic");
    assert_eq!(code, Some(3), "{said}");
    let message = "error: the control loop has failed, nothing is steered: a drill";
    assert!(said.contains(message), "{said}");
}

#[test]
fn a_control_loop_that_leaves_ends_the_program_too() {
    let (code, said) = fails("leave");
    assert_eq!(code, Some(3), "{said}");
    assert!(said.contains("nothing is steered"), "{said}");
}

#[test]
fn a_control_loop_that_hangs_is_seen_and_does_not_keep_the_program_from_ending() {
    let mut program = Program::start_with(&[], &[("WHEELOVER_DRILL", "hang:1000")]);
    // It speaks, and then it does not.
    for speaks in [true, false] {
        let end = std::time::Instant::now() + SOON;
        while (get(program.address, "/healthz", &[]).status == 200) != speaks {
            assert!(std::time::Instant::now() < end, "not seen: {speaks}");
            std::thread::sleep(Duration::from_millis(50));
        }
    }
    assert_eq!(program.stop(), Some(3));
    let said = program.last_words().join("\n");
    assert!(said.contains("error: it does not end within 8 s"), "{said}");
}

#[tokio::test]
async fn a_page_is_told_that_the_program_ends_and_finds_the_next_one_in_standby() {
    let folder = wheelover_tests::folder("again");
    let config = folder.join("wheelover.toml");
    std::fs::write(&config, "roles = [\"autopilot\"]\n").unwrap();
    let config = ["--config", config.to_str().unwrap()];
    let program = Program::start_with(&config, &[("WHEELOVER_DRILL", "panic:1500")]);
    let mut page = Page::open(program.address).await;
    let closing = page.closing(SOON).await;
    assert_eq!(closing, Some((1001, "the server ends".to_string())));
    // What a supervisor does.
    let mut program = Program::start(&config);
    let mut page = Page::open(program.address).await;
    page.until("a snapshot", SOON, |page| page.snapshot.is_some())
        .await;
    let own = page.snapshot.as_ref().unwrap().own.as_ref().unwrap();
    assert_eq!(own.mode, ModeName::Standby);
    page.leave().await;
    assert_eq!(program.stop(), Some(0), "{:?}", program.last_words());
}

// CLI-5
#[test]
fn quiet_leaves_errors_only() {
    let folder = wheelover_tests::folder("quiet");
    let config = folder.join("wheelover.toml");
    let absent = "roles = [\"autopilot\"]\n[[port]]\nname = \"gyro1\"\nkind = \"serial\"\npath = \"/dev/no-such\"\n\
                  profile = \"gyro1\"\n";
    std::fs::write(&config, absent).unwrap();
    let config = config.to_str().unwrap();
    let said = |quiet: &[&str]| {
        let arguments = [
            &["serve", "--listen", "127.0.0.1:0", "--config", config],
            quiet,
        ]
        .concat();
        wheelover_tests::program::said_within(&arguments, Duration::from_millis(1_500))
    };
    let loud = said(&[]);
    let gone = "caution: port gyro1: /dev/no-such: no such file or directory";
    assert!(loud.iter().any(|line| line == gone), "{loud:?}");
    assert_eq!(said(&["--quiet"]), [] as [&str; 0]);
}
