//! One `[[port]]` as written, and what makes it a port that can be.

use super::types::{Kind, Place, Port, commands, policy_name};
use serde::Deserialize;
use std::net::SocketAddr;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;
use wheelover_core::station::{ChecksumPolicy, PortSetup, Profile};
use wheelover_core::voyage::Role;

/// A port as written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PortForm {
    name: Spanned<String>,
    station: Option<Spanned<Role>>,
    kind: Kind,
    path: Option<Spanned<PathBuf>>,
    address: Option<Spanned<String>>,
    baud: Option<Spanned<u32>>,
    profile: Spanned<Profile>,
    checksum: Option<Spanned<ChecksumPolicy>>,
    talkers: Option<Spanned<Vec<String>>>,
    /// An HTC with null status commands (HTC 14).
    pub(super) null_status: Option<Spanned<bool>>,
    #[serde(default)]
    output: Option<Spanned<bool>>,
}

/// A mistake: where in the text, and what.
pub(super) type Mistake = (Range<usize>, String);

pub(super) fn port(
    form: PortForm,
    span: Range<usize>,
    roles: &[Role],
    folder: &Path,
    others: &[Port],
) -> Result<Port, Mistake> {
    let name = form.name.get_ref().clone();
    let fine = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    if name.is_empty() || name.len() > 24 || !name.chars().all(fine) {
        let text =
            format!("name = \"{name}\"; allowed are 1 to 24 letters, digits, `-`, `_` and `.`");
        return Err((form.name.span(), text));
    }
    if others.iter().any(|other| other.setup.name == name) {
        return Err((
            form.name.span(),
            format!("port \"{name}\" is named twice; each name stands once"),
        ));
    }
    let station = station(form.station.as_ref(), roles, &span, &name)?;
    let place = place(&form, &span, folder)?;
    if let Some(other) = others.iter().find(|other| same_place(&other.place, &place)) {
        let text = format!(
            "ports \"{}\" and \"{name}\" are both at the same place; each device and address stands once",
            other.setup.name
        );
        return Err((span, text));
    }
    let profile = *form.profile.get_ref();
    let twin = |other: &&Port| other.station == station && other.setup.profile == profile;
    if profile != Profile::Monitor
        && let Some(other) = others.iter().find(twin)
    {
        let text = format!(
            "ports \"{}\" and \"{name}\" both have the profile \"{}\"; only \"monitor\" may stand twice at one station",
            other.setup.name,
            profile.name()
        );
        return Err((form.profile.span(), text));
    }
    let checksum = match form.checksum {
        None => ChecksumPolicy::Required,
        // EMC-4
        Some(policy)
            if profile == Profile::Hmi && *policy.get_ref() != ChecksumPolicy::Required =>
        {
            let text = format!(
                "checksum = \"{}\" on port \"{name}\" of the profile \"hmi\"; allowed is \"required\"",
                policy_name(*policy.get_ref())
            );
            return Err((policy.span(), text));
        }
        Some(policy) if commands(profile) && *policy.get_ref() == ChecksumPolicy::Optional => {
            let text = format!(
                "checksum = \"{}\" on port \"{name}\", which may command; allowed are \"required\", \"learned\" (SEN-2)",
                policy_name(ChecksumPolicy::Optional)
            );
            return Err((policy.span(), text));
        }
        Some(policy) => policy.into_inner(),
    };
    if let (Some(written), true) = (&form.null_status, profile != Profile::Ecdis) {
        let text = format!(
            "null_status on port \"{name}\"; allowed is it on a port of the profile \"ecdis\" only"
        );
        return Err((written.span(), text));
    }
    let talkers = talkers(form.talkers, &name)?;
    let output = form.output.is_some_and(Spanned::into_inner);
    let receives_only = match &place {
        Place::File(_) => Some("a file is only read"),
        Place::Udp(address) if address.ip().is_unspecified() => {
            Some("an unspecified address only hears; name the address to send to")
        }
        _ => None,
    };
    if let (true, Some(why)) = (output, receives_only) {
        return Err((span, format!("output = true on port \"{name}\": {why}")));
    }
    let baud = match place {
        Place::Serial(_, baud) => baud,
        _ => 0,
    };
    Ok(Port {
        station,
        setup: PortSetup {
            name,
            profile,
            checksum,
            talkers,
            baud,
            output,
        },
        place,
    })
}

fn station(
    written: Option<&Spanned<Role>>,
    roles: &[Role],
    span: &Range<usize>,
    name: &str,
) -> Result<Role, Mistake> {
    let allowed: Vec<String> = roles
        .iter()
        .map(|role| format!("\"{}\"", role.name()))
        .collect();
    let allowed = allowed.join(", ");
    match (written, roles) {
        (Some(station), _) if roles.contains(station.get_ref()) => Ok(*station.get_ref()),
        (Some(station), _) => {
            let text = format!(
                "station \"{}\" of port \"{name}\" does not run here; allowed are {allowed}",
                station.get_ref().name()
            );
            Err((station.span(), text))
        }
        (None, [only]) => Ok(*only),
        (None, _) => {
            let text = format!("port \"{name}\" needs the key station; allowed are {allowed}");
            Err((span.clone(), text))
        }
    }
}

/// SEN-3: the talkers that are believed; all where none is named.
fn talkers(written: Option<Spanned<Vec<String>>>, port: &str) -> Result<Vec<String>, Mistake> {
    let Some(written) = written else {
        return Ok(Vec::new());
    };
    let span = written.span();
    let named = written.into_inner();
    let fine = |talker: &String| {
        talker.len() == 2
            && talker
                .bytes()
                .all(|b| b.is_ascii_uppercase() || b.is_ascii_digit())
    };
    let twice = (1..named.len()).any(|n| named[..n].contains(&named[n]));
    if named.is_empty() || twice || !named.iter().all(fine) {
        let text = format!(
            "talkers of port \"{port}\"; allowed are talkers of two capital letters or digits, each once; leave the key out to believe any"
        );
        return Err((span, text));
    }
    Ok(named)
}

fn place(form: &PortForm, span: &Range<usize>, folder: &Path) -> Result<Place, Mistake> {
    let kind = form.kind;
    let by_path = matches!(kind, Kind::Serial | Kind::File);
    let missing = |key: &str| {
        let text = format!(
            "port \"{}\" of kind {} needs the key {key}",
            form.name.get_ref(),
            kind.name()
        );
        (span.clone(), text)
    };
    let needless = |key: &str, span: Range<usize>| {
        let other = if by_path { "path" } else { "address" };
        let text = format!(
            "{key} does not go with kind \"{}\"; allowed is {other}",
            kind.name()
        );
        (span, text)
    };
    if let (false, Some(path)) = (by_path, &form.path) {
        return Err(needless("path", path.span()));
    }
    if let (true, Some(address)) = (by_path, &form.address) {
        return Err(needless("address", address.span()));
    }
    let rate = match &form.baud {
        None => 4800,
        Some(baud) if kind != Kind::Serial => return Err(needless("baud", baud.span())),
        Some(baud) if matches!(baud.get_ref(), 4800 | 38_400) => *baud.get_ref(),
        Some(baud) => {
            let text = format!("baud = {}; allowed are 4800 and 38400", baud.get_ref());
            return Err((baud.span(), text));
        }
    };
    let path = || form.path.as_ref().ok_or_else(|| missing("path"));
    let address = || form.address.as_ref().ok_or_else(|| missing("address"));
    Ok(match kind {
        Kind::Serial => Place::Serial(path()?.get_ref().clone(), rate),
        Kind::File => Place::File(folder.join(path()?.get_ref())),
        Kind::TcpClient => {
            let address = address()?;
            let fits = address
                .get_ref()
                .rsplit_once(':')
                .is_some_and(|(host, port)| {
                    !host.is_empty() && port.parse::<u16>().is_ok_and(|port| port > 0)
                });
            if !fits {
                let text = format!("address = \"{}\"; allowed is HOST:PORT", address.get_ref());
                return Err((address.span(), text));
            }
            Place::TcpClient(address.get_ref().clone())
        }
        Kind::TcpServer => Place::TcpServer(socket("address", address()?)?),
        Kind::Udp => Place::Udp(socket("address", address()?)?),
    })
}

fn same_place(a: &Place, b: &Place) -> bool {
    let real = |path: &Path| std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    match (a, b) {
        (Place::Serial(a, _), Place::Serial(b, _)) => real(a) == real(b),
        (Place::TcpServer(a), Place::TcpServer(b)) | (Place::Udp(a), Place::Udp(b)) => {
            let both = a.ip() == b.ip() || a.ip().is_unspecified() || b.ip().is_unspecified();
            a.port() != 0 && a.port() == b.port() && both
        }
        _ => false,
    }
}

pub(super) fn socket(key: &str, written: &Spanned<String>) -> Result<SocketAddr, Mistake> {
    written.get_ref().parse().map_err(|_| {
        let text = format!(
            "{key} = \"{}\" is not an address; allowed is IP:PORT, such as \"127.0.0.1:8080\" or \"[::1]:8080\"",
            written.get_ref()
        );
        (written.span(), text)
    })
}
