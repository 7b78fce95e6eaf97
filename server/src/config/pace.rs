//! At which pace ship's time may run: at another than the clock's only where no real equipment is behind a port.

use super::types::{At, Config, Place};
use crate::clock::Tempo;
use std::net::{IpAddr, SocketAddr};
use std::path::{Path, PathBuf};

/// Where Linux keeps the near ends of pseudo-terminals.
const PSEUDO_TERMINALS: &str = "/dev/pts";

impl Config {
    /// Whether ship's time may run at `speed`.
    ///
    /// # Errors
    /// The port that stands against it, and why, in one line.
    pub(crate) fn may_run_at(&self, speed: f64) -> Result<(), String> {
        if !Tempo::new(speed).is_trial() {
            return Ok(());
        }
        let ports = self.ports.iter().map(|port| {
            let name = format!("port \"{}\"", port.setup.name);
            (name, why_real(&port.place))
        });
        let contacts = self.contacts.iter().filter_map(|contact| {
            let why = match &contact.at {
                At::Port(_) => return None, // its port answers for it
                At::Device(path) => pseudo_terminal(path).err(),
                At::Chip(path) => Some(format!("{} is no pseudo-terminal", path.display())),
            };
            Some((format!("contact \"{}\"", contact.switch.name()), why))
        });
        let mut against = ports.chain(contacts);
        match against.find_map(|(name, why)| Some((name, why?))) {
            Some((name, why)) => Err(format!(
                "--speed {speed}: {name}: {why}; with real equipment ship's time runs at 1"
            )),
            None => Ok(()),
        }
    }
}

/// The device behind a name, where it is a pseudo-terminal.
///
/// # Errors
/// It is something else, or not there.
pub(crate) fn pseudo_terminal(path: &Path) -> Result<PathBuf, String> {
    let shown = path.display();
    match std::fs::canonicalize(path) {
        Ok(device) if device.starts_with(PSEUDO_TERMINALS) => Ok(device),
        Ok(_) => Err(format!("{shown} is no pseudo-terminal")),
        Err(_) => Err(format!(
            "{shown} is not there, and may be no pseudo-terminal"
        )),
    }
}

/// Why there may be real equipment at a place; none where there can be none.
fn why_real(place: &Place) -> Option<String> {
    let elsewhere = |address: &SocketAddr| {
        let here = address.ip().is_loopback();
        (!here).then(|| format!("{address} is not the loopback of this machine"))
    };
    match place {
        Place::File(_) => None,
        Place::Serial(path, _) => pseudo_terminal(path).err(),
        Place::TcpServer(address) | Place::Udp(address) => elsewhere(address),
        Place::TcpClient(address) => {
            let host = address.rsplit_once(':').map_or("", |(host, _)| host);
            let host = host.trim_start_matches('[').trim_end_matches(']');
            let ip = host.parse::<IpAddr>();
            let here = host == "localhost" || ip.is_ok_and(|ip| ip.is_loopback());
            (!here).then(|| format!("{address} is not the loopback of this machine"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::read::from_text;

    fn check(ports: &str, speed: f64, expect: Option<&str>) {
        let text = format!("roles = [\"autopilot\"]\n{ports}");
        let config = from_text("x.toml", &text, None).unwrap();
        let refused = config.may_run_at(speed).err();
        match expect {
            None => assert_eq!(refused, None, "{ports}"),
            Some(expect) => assert_eq!(
                refused.as_deref(),
                Some(
                    format!("--speed {speed}: {expect}; with real equipment ship's time runs at 1")
                        .as_str()
                ),
                "{ports}"
            ),
        }
    }

    fn port(kind: &str, place: &str) -> String {
        format!("[[port]]\nname = \"a\"\nkind = \"{kind}\"\n{place}\nprofile = \"monitor\"\n")
    }

    #[test]
    fn another_pace_is_for_what_cannot_be_real_equipment_only() {
        let pair = nix::pty::openpty(None, None).unwrap();
        let device = nix::unistd::ttyname(&pair.slave).unwrap();
        let link = std::env::temp_dir().join(format!("wheelover-pace-{}", std::process::id()));
        let _ = std::fs::remove_file(&link);
        std::os::unix::fs::symlink(&device, &link).unwrap();
        for path in [&device, &link] {
            let place = format!("path = \"{}\"", path.display());
            check(&port("serial", &place), 10.0, None);
        }
        std::fs::remove_file(&link).unwrap();
        check("", 10.0, None);
        check(&port("file", "path = \"log.txt\""), 10.0, None);
        check(&port("udp", "address = \"127.0.0.1:4000\""), 10.0, None);
        check(&port("tcp-server", "address = \"[::1]:4000\""), 10.0, None);
        check(
            &port("tcp-client", "address = \"localhost:4000\""),
            10.0,
            None,
        );
        check(&port("tcp-client", "address = \"[::1]:4000\""), 10.0, None);

        let null = "path = \"/dev/null\"";
        let elsewhere = "is not the loopback of this machine";
        for (kind, place, why) in [
            ("serial", null, "/dev/null is no pseudo-terminal".to_owned()),
            (
                "serial",
                "path = \"/dev/pts/none\"",
                "/dev/pts/none is not there, and may be no pseudo-terminal".to_owned(),
            ),
            (
                "udp",
                "address = \"0.0.0.0:4000\"",
                format!("0.0.0.0:4000 {elsewhere}"),
            ),
            (
                "tcp-server",
                "address = \"192.168.1.2:4000\"",
                format!("192.168.1.2:4000 {elsewhere}"),
            ),
            (
                "tcp-client",
                "address = \"plotter:4000\"",
                format!("plotter:4000 {elsewhere}"),
            ),
        ] {
            let port = port(kind, place);
            check(&port, 10.0, Some(&format!("port \"a\": {why}")));
            check(&port, 1.0, None);
        }
        let contact = "[[contact]]\nwhat = \"nfu\"\npath = \"/dev/null\"\nline = \"cts\"\n";
        let why = "contact \"nfu\": /dev/null is no pseudo-terminal";
        check(contact, 2.0, Some(why));
    }
}
