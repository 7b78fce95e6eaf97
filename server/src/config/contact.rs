//! One `[[contact]]` as written, and what makes it a contact that can be read (AP-22).

use super::port::Mistake;
use super::types::{At, Contact, ControlLine, Place, Port};
use serde::Deserialize;
use std::ops::Range;
use std::path::PathBuf;
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
    line: ControlLine,
    #[serde(default)]
    inverted: bool,
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
    let at = match (&form.port, &form.path) {
        (Some(port), None) => At::Port(serial(port, ports)?),
        (None, Some(path)) => {
            let path = path.get_ref().clone();
            let taken = |port: &&Port| matches!(&port.place, Place::Serial(of, _) if *of == path);
            if let Some(port) = ports.iter().find(taken) {
                let text = format!(
                    "contact \"{name}\": {} is the device of a port; allowed is port = \"{}\"",
                    path.display(),
                    port.setup.name
                );
                return Err((span, text));
            }
            At::Device(path)
        }
        _ => {
            let text = format!("contact \"{name}\" needs one of the keys port and path");
            return Err((span, text));
        }
    };
    let taken = |other: &&Contact| other.at == at && other.line == form.line;
    if let Some(other) = others.iter().find(taken) {
        let text = format!(
            "contacts \"{}\" and \"{name}\" are both the line {} of one device",
            other.switch.name(),
            form.line.name()
        );
        return Err((span, text));
    }
    Ok(Contact {
        switch,
        at,
        line: form.line,
        inverted: form.inverted,
    })
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
