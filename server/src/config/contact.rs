//! One `[[contact]]` as written, and what makes it a contact that can be read (AP-22).

use super::port::Mistake;
use super::types::{At, Bias, Contact, ControlLine, Place, Port, Wire};
use serde::de::{Error, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;
use wheelover_core::station::Switch;
use wheelover_core::voyage::Role;

/// A contact as written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ContactForm {
    what: Spanned<Switch>,
    port: Option<Spanned<String>>,
    path: Option<Spanned<PathBuf>>,
    gpio: Option<Spanned<PathBuf>>,
    line: Spanned<LineForm>,
    bias: Option<Spanned<Bias>>,
    #[serde(default)]
    inverted: bool,
}

/// A line as written: the name of a control line, or the number of a GPIO line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LineForm {
    Name(ControlLine),
    Number(u32),
}

impl<'de> Deserialize<'de> for LineForm {
    fn deserialize<D: Deserializer<'de>>(form: D) -> Result<Self, D::Error> {
        struct Either;
        impl Visitor<'_> for Either {
            type Value = LineForm;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("cts, dsr, dcd or ri, or the number of a line of a GPIO chip")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<LineForm, E> {
                let lines = [
                    ControlLine::Cts,
                    ControlLine::Dsr,
                    ControlLine::Dcd,
                    ControlLine::Ri,
                ];
                let found = lines.into_iter().find(|line| line.name() == name);
                let unknown = || E::unknown_variant(name, &["cts", "dsr", "dcd", "ri"]);
                found.map(LineForm::Name).ok_or_else(unknown)
            }

            fn visit_i64<E: Error>(self, number: i64) -> Result<LineForm, E> {
                let wrong = |_| E::invalid_value(Unexpected::Signed(number), &self);
                u32::try_from(number).map(LineForm::Number).map_err(wrong)
            }
        }
        form.deserialize_any(Either)
    }
}

pub(super) fn contact(
    form: &ContactForm,
    span: Range<usize>,
    roles: &[Role],
    ports: &[Port],
    others: &[Contact],
) -> Result<Contact, Mistake> {
    let switch = *form.what.get_ref();
    let name = switch.name();
    if !roles.contains(&Role::Autopilot) {
        let text = "[[contact]]: only autopilot uses it, which does not run here".to_owned();
        return Err((span, text));
    }
    if others.iter().any(|other| other.switch == switch) {
        let text = format!("contact \"{name}\" stands twice; each stands once");
        return Err((form.what.span(), text));
    }
    let at = match (&form.port, &form.path, &form.gpio) {
        (Some(port), None, None) => At::Port(serial(port, ports)?),
        (None, Some(path), None) => device(name, path, ports)?,
        (None, None, Some(path)) => chip(name, path)?,
        _ => {
            let text = format!("contact \"{name}\" needs one of the keys port, path and gpio");
            return Err((span, text));
        }
    };
    let line = wire(name, form, &at)?;
    let same = |other: &Contact| match (other.line, line) {
        (Wire::Gpio(one, _), Wire::Gpio(other, _)) => one == other,
        (one, other) => one == other,
    };
    let taken = |other: &&Contact| other.at == at && same(other);
    if let Some(other) = others.iter().find(taken) {
        let line = match line {
            Wire::Control(line) => line.name().to_owned(),
            Wire::Gpio(number, _) => number.to_string(),
        };
        let text = format!(
            "contacts \"{}\" and \"{name}\" are both the line {line} of one device",
            other.switch.name(),
        );
        return Err((span, text));
    }
    Ok(Contact {
        switch,
        at,
        line,
        inverted: form.inverted,
    })
}

/// A serial device that carries no bytes.
fn device(name: &str, path: &Spanned<PathBuf>, ports: &[Port]) -> Result<At, Mistake> {
    let device = path.get_ref();
    let taken = |port: &&Port| matches!(&port.place, Place::Serial(of, _) if of == device);
    if let Some(port) = ports.iter().find(taken) {
        let text = format!(
            "contact \"{name}\": {} is the device of a port; allowed is port = \"{}\"",
            device.display(),
            port.setup.name
        );
        return Err((path.span(), text));
    }
    Ok(At::Device(device.clone()))
}

/// A GPIO chip; whether it is there is found out when it is read.
fn chip(name: &str, path: &Spanned<PathBuf>) -> Result<At, Mistake> {
    let device = path.get_ref();
    if !device.starts_with(Path::new("/dev")) {
        let text = format!(
            "contact \"{name}\": gpio = \"{}\" is no device; it is written as in gpio = \"/dev/gpiochip0\"",
            device.display()
        );
        return Err((path.span(), text));
    }
    Ok(At::Chip(device.clone()))
}

/// The line, as it is written where the contact is read.
fn wire(name: &str, form: &ContactForm, at: &At) -> Result<Wire, Mistake> {
    let span = form.line.span();
    match (at, form.line.get_ref(), &form.bias) {
        (At::Chip(_), LineForm::Number(number), bias) => {
            let bias = bias.as_ref().map(|bias| *bias.get_ref());
            Ok(Wire::Gpio(*number, bias.unwrap_or_default()))
        }
        (At::Chip(_), LineForm::Name(line), _) => {
            let text = format!(
                "contact \"{name}\": a line of a GPIO chip is a number, as in line = 17; {} is of a serial device",
                line.name()
            );
            Err((span, text))
        }
        (_, LineForm::Number(_), _) => {
            let text = format!(
                "contact \"{name}\": a line of a serial device is cts, dsr, dcd or ri; a number is of a GPIO chip, by the key gpio"
            );
            Err((span, text))
        }
        (_, _, Some(bias)) => {
            let text = format!("contact \"{name}\": bias is of a GPIO line, by the key gpio");
            Err((bias.span(), text))
        }
        (_, LineForm::Name(line), None) => Ok(Wire::Control(*line)),
    }
}

/// The number of a serial port that is named.
fn serial(name: &Spanned<String>, ports: &[Port]) -> Result<usize, Mistake> {
    let serial = |port: &Port| matches!(port.place, Place::Serial(..));
    let found = ports
        .iter()
        .position(|port| port.setup.name == *name.get_ref() && serial(port));
    found.ok_or_else(|| {
        let names: Vec<String> = (ports.iter().filter(|port| serial(port)))
            .map(|port| format!("\"{}\"", port.setup.name))
            .collect();
        let allowed = match names.as_slice() {
            [] => "there is none".to_owned(),
            names => format!("allowed are {}", names.join(", ")),
        };
        let text = format!("port = \"{}\" is no serial port; {allowed}", name.get_ref());
        (name.span(), text)
    })
}
