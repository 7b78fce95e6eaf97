//! Contacts at control lines and at lines of a GPIO chip: what may be written, and what is said about the rest (AP-22).

use super::check;
use crate::config::read::from_text;
use crate::config::{At, Bias, Wire, in_force};
use std::path::PathBuf;

#[test]
fn a_contact_is_read_at_a_line_of_a_gpio_chip() {
    let text = "roles = [\"autopilot\"]\n[[contact]]\nwhat = \"nfu\"\ngpio = \"/dev/gpiochip0\"\nline = 17\nbias = \"pull_up\"\ninverted = true\n\
                [[contact]]\nwhat = \"autopilot\"\ngpio = \"/dev/gpiochip0\"\nline = 27\n";
    let config = from_text("w.toml", text, None).unwrap();
    let [nfu, autopilot] = config.contacts.as_slice() else {
        panic!("{:?}", config.contacts)
    };
    assert_eq!(nfu.at, At::Chip(PathBuf::from("/dev/gpiochip0")));
    assert_eq!(
        (nfu.line, nfu.inverted),
        (Wire::Gpio(17, Bias::PullUp), true)
    );
    assert_eq!(autopilot.line, Wire::Gpio(27, Bias::AsIs));
    // What is printed as in force is read as the same.
    let printed = in_force(&config);
    let again = from_text("w.toml", &printed, None).unwrap();
    assert_eq!(again.contacts, config.contacts, "{printed}");
}

#[test]
fn what_cannot_be_wired_is_refused_at_its_line() {
    let contact =
        |keys: &str| format!("roles = [\"autopilot\"]\n[[contact]]\nwhat = \"nfu\"\n{keys}\n");
    let chip = "gpio = \"/dev/gpiochip0\"";
    for (keys, line, words) in [
        (
            format!("{chip}\nline = \"cts\""),
            5,
            "is a number, as in line = 17",
        ),
        (format!("{chip}\nline = -1"), 5, "-1"),
        (format!("{chip}\nline = 1.5"), 5, "number of a line"),
        (format!("{chip}\nline = \"rts\""), 5, "unknown value `rts`"),
        (
            format!("{chip}\nline = 17\nbias = \"up\""),
            6,
            "unknown value `up`",
        ),
        (
            "gpio = \"gpiochip0\"\nline = 17".into(),
            4,
            "\"/dev/gpiochip0\"",
        ),
        (
            "path = \"/dev/ttyS9\"\nline = 17".into(),
            5,
            "by the key gpio",
        ),
        (
            "path = \"/dev/ttyS9\"\nline = \"ri\"\nbias = \"pull_up\"".into(),
            6,
            "bias is of a GPIO line",
        ),
        (
            format!("path = \"/dev/ttyS9\"\n{chip}\nline = 17"),
            2,
            "needs one of the keys port, path and gpio",
        ),
    ] {
        check(&contact(&keys), line, &[words]);
    }
    let one = format!("[[contact]]\nwhat = \"nfu\"\n{chip}\nline = 17\n");
    let other = one
        .replace("nfu", "ffu")
        .replace("17", "17\nbias = \"pull_up\"");
    let both = format!("roles = [\"autopilot\"]\n{one}{other}");
    check(&both, 6, &["are both the line 17 of one device"]);
}

// AP-22
#[test]
fn a_contact_is_read_at_a_control_line_of_a_port_or_of_a_device_of_its_own() {
    let with = |contacts: &str| {
        let port = "[[port]]\nname = \"ecdis\"\nkind = \"serial\"\npath = \"/dev/ttyS8\"\nprofile = \"ecdis\"\n";
        let text = format!("roles = [\"autopilot\"]\n{port}{contacts}");
        from_text("w.toml", &text, None)
    };
    let both = "[[contact]]\nwhat = \"nfu\"\nport = \"ecdis\"\nline = \"cts\"\n[[contact]]\nwhat = \"autopilot\"\npath = \"/dev/ttyS9\"\nline = \"ri\"\ninverted = true\n";
    let config = with(both).unwrap();
    assert_eq!(config.contacts.len(), 2);
    let again = from_text("w.toml", &in_force(&config), None).unwrap();
    assert_eq!(again.contacts, config.contacts);
    let refused = |contacts: &str| with(contacts).unwrap_err().to_string();
    for (keys, said) in [
        (
            "what = \"nfu\"\nline = \"cts\"",
            "needs one of the keys port, path and gpio",
        ),
        (
            "what = \"nfu\"\nport = \"gyro\"\nline = \"cts\"",
            "is no serial port",
        ),
        (
            "what = \"horn\"\nport = \"ecdis\"\nline = \"cts\"",
            "unknown value `horn`",
        ),
        (
            "what = \"nfu\"\nport = \"ecdis\"\nline = \"rts\"",
            "unknown value `rts`",
        ),
        (
            "what = \"nfu\"\nchip = \"gpiochip0\"\nline = \"cts\"",
            "unknown key `chip`",
        ),
    ] {
        let text = refused(&format!("[[contact]]\n{keys}\n"));
        assert!(text.contains(said), "{keys}: {text}");
    }
    let twice = "[[contact]]\nwhat = \"nfu\"\nport = \"ecdis\"\nline = \"cts\"\n";
    assert!(refused(&twice.repeat(2)).contains("stands twice"));
    let other = twice.replace("nfu", "ffu");
    assert!(refused(&format!("{twice}{other}")).contains("are both the line cts"));
}
