//! Who may speak to the server: host allow-list, origin check, and the headers that every answer carries.
//!
//! **Invariant:** no answer but 421 goes to a request whose `Host` is not one of ours (FE3), and no
//! WebSocket is opened for a page from elsewhere (FE2).

use axum::Router;
use axum::http::header::{self, HeaderName};
use axum::http::{HeaderMap, HeaderValue, Request};
use std::net::{IpAddr, SocketAddr};
use tower_http::set_header::SetResponseHeaderLayer;

/// The content security policy of every answer but `decoder.html`.
pub(crate) const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; \
    img-src 'self' data:; font-src 'self'; connect-src 'self'; manifest-src 'self'; worker-src 'self'; \
    base-uri 'none'; form-action 'self'; frame-ancestors 'none'";

/// Both ends of a connection, put into every request by the accept loop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ends {
    /// The client's address.
    pub(crate) peer: SocketAddr,
    /// The address it reached us by.
    pub(crate) local: SocketAddr,
}

/// The names by which this machine may be addressed.
#[derive(Clone, Debug)]
pub(crate) struct Hosts {
    names: Vec<String>,
}

impl Hosts {
    /// This machine's names.
    #[must_use]
    pub(crate) fn of_this_machine() -> Self {
        let mut names = vec!["localhost".to_owned()];
        let own = nix::unistd::gethostname().ok();
        if let Some(own) = own.and_then(|name| name.into_string().ok()) {
            let own = own.to_ascii_lowercase();
            if !own.is_empty() {
                names.push(format!("{own}.local"));
                names.push(own);
            }
        }
        Self { names }
    }

    /// Whether a `Host` value names this machine on a connection that came in at `local`.
    #[must_use]
    pub(crate) fn allow(&self, host: &str, local: IpAddr) -> bool {
        let name = without_port(host);
        if let Ok(ip) = name.trim_matches(['[', ']']).parse::<IpAddr>() {
            // An address cannot be rebound to another machine, but it has to be the one reached.
            return ip.to_canonical() == local.to_canonical()
                || ip.is_loopback() && local.is_loopback();
        }
        let name = name.trim_end_matches('.').to_ascii_lowercase();
        self.names.contains(&name)
    }
}

fn without_port(host: &str) -> &str {
    match host.rfind(':') {
        Some(at)
            if !host[at..].contains(']') && host[at + 1..].bytes().all(|b| b.is_ascii_digit()) =>
        {
            &host[..at]
        }
        _ => host,
    }
}

/// The `Host` of a request; none where it is missing, given twice or not text.
#[must_use]
pub(crate) fn host_of<B>(request: &Request<B>) -> Option<&str> {
    let mut all = request.headers().get_all(header::HOST).iter();
    match (all.next(), all.next()) {
        (Some(host), None) => host.to_str().ok(),
        (None, _) => request.uri().authority().map(|a| a.as_str()),
        _ => None,
    }
}

/// What the `Origin` of an upgrade says about the page that asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// Our own page.
    Own,
    /// A page from elsewhere, or one that hides where it is from.
    Foreign,
    /// No browser: a program of this user's own.
    Absent,
}

/// Judges the origin of a WebSocket upgrade (FE2).
#[must_use]
pub(crate) fn origin(headers: &HeaderMap, host: &str) -> Origin {
    let mut all = headers.get_all(header::ORIGIN).iter();
    match (all.next(), all.next()) {
        (None, _) if headers.contains_key(header::COOKIE) => Origin::Foreign,
        (None, _) => Origin::Absent,
        (Some(origin), None) => match origin.to_str().ok().and_then(|o| o.split_once("://")) {
            Some(("http" | "https", place)) if place.eq_ignore_ascii_case(host) => Origin::Own,
            _ => Origin::Foreign,
        },
        _ => Origin::Foreign,
    }
}

/// Puts the headers of safety on every answer.
pub(crate) fn harden(router: Router) -> Router {
    // The one page whose scripts stand in itself brings its own, stricter policy.
    let router = router.layer(SetResponseHeaderLayer::if_not_present(
        header::CONTENT_SECURITY_POLICY,
        HeaderValue::from_static(POLICY),
    ));
    let fixed = [
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
        (
            HeaderName::from_static("cross-origin-opener-policy"),
            "same-origin",
        ),
        (
            HeaderName::from_static("cross-origin-resource-policy"),
            "same-origin",
        ),
    ];
    fixed.into_iter().fold(router, |router, (name, value)| {
        router.layer(SetResponseHeaderLayer::overriding(
            name,
            HeaderValue::from_static(value),
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hosts_are_ours_or_refused() {
        let hosts = Hosts {
            names: vec!["localhost".into(), "bridge".into(), "bridge.local".into()],
        };
        let check = |host: &str, local: &str, expect: bool| {
            let local: IpAddr = local.parse().unwrap();
            assert_eq!(hosts.allow(host, local), expect, "{host} at {local}");
        };
        check("127.0.0.1:8080", "127.0.0.1", true);
        check("localhost:8080", "127.0.0.1", true);
        check("LOCALHOST", "127.0.0.1", true);
        check("[::1]:8080", "::1", true);
        check("bridge.local:8080", "192.168.1.4", true);
        check("192.168.1.4:8080", "192.168.1.4", true);
        check("192.168.1.4", "::ffff:192.168.1.4", true);
        check("192.168.1.5:8080", "192.168.1.4", false);
        check("10.0.0.1", "127.0.0.1", false);
        check("evil.example:8080", "127.0.0.1", false);
        check("127.0.0.1.evil.example", "127.0.0.1", false);
        check("localhost.evil.example", "127.0.0.1", false);
        check("", "127.0.0.1", false);
        check(":8080", "127.0.0.1", false);
    }

    #[test]
    fn only_our_own_page_opens_a_socket() {
        let check = |pairs: &[(HeaderName, &str)], expect: Origin| {
            let mut headers = HeaderMap::new();
            for (name, value) in pairs {
                headers.append(name.clone(), HeaderValue::from_str(value).unwrap());
            }
            assert_eq!(origin(&headers, "127.0.0.1:8080"), expect, "{pairs:?}");
        };
        check(&[], Origin::Absent);
        check(&[(header::COOKIE, "a=b")], Origin::Foreign);
        check(&[(header::ORIGIN, "http://127.0.0.1:8080")], Origin::Own);
        check(
            &[(header::ORIGIN, "http://127.0.0.1:9090")],
            Origin::Foreign,
        );
        check(&[(header::ORIGIN, "null")], Origin::Foreign);
        check(&[(header::ORIGIN, "http://evil.example")], Origin::Foreign);
        check(
            &[(header::ORIGIN, "file://127.0.0.1:8080")],
            Origin::Foreign,
        );
        let own = (header::ORIGIN, "http://127.0.0.1:8080");
        check(&[own.clone(), own], Origin::Foreign);
    }
}
