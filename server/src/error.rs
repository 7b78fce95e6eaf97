//! What can keep the program from doing its work: one line for the user, exit code 2.

use std::fmt;
use std::net::SocketAddr;

/// Why something was not done.
#[derive(Debug)]
pub(crate) enum Error {
    /// The configuration says something that cannot be.
    Config {
        /// The file.
        file: String,
        /// The line in it, from 1, where one can be named.
        line: Option<usize>,
        /// What is wrong, and what is allowed.
        text: String,
    },
    /// The address cannot be listened on.
    Listen {
        /// Which.
        address: SocketAddr,
        /// Why.
        source: std::io::Error,
    },
    /// A port of the configuration cannot be had although its device is there.
    Port {
        /// Its name.
        name: String,
        /// Why.
        text: String,
    },
    /// A file cannot be read or written.
    File {
        /// Which.
        path: String,
        /// Why.
        source: std::io::Error,
    },
    /// Anything else, in words.
    Other(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Config {
                file,
                line: Some(line),
                text,
            } => write!(f, "{file}:{line}: {text}"),
            Self::Config {
                file,
                line: None,
                text,
            } => write!(f, "{file}: {text}"),
            Self::Listen { address, source } if source.kind() == std::io::ErrorKind::AddrInUse => {
                write!(
                    f,
                    "address {address} is in use by another program; choose another with --listen"
                )
            }
            Self::Listen { address, source } => {
                write!(f, "cannot listen on {address}: {}", reason(source))
            }
            Self::Port { name, text } => write!(f, "port {name}: {text}"),
            Self::File { path, source } => write!(f, "{path}: {}", reason(source)),
            Self::Other(text) => f.write_str(text),
        }
    }
}

impl std::error::Error for Error {}

/// The system's own words for a failure, lower case and without its number.
pub(crate) fn reason(error: &std::io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or_default();
    let mut letters = text.chars();
    match letters.next() {
        Some(first) => first.to_lowercase().chain(letters).collect(),
        None => error.kind().to_string(),
    }
}
