//! The page: the files of the bundle, sent compressed and cached by their names.

use axum::body::Body;
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{Response, StatusCode};
use rust_embed::EmbeddedFile;
use std::borrow::Cow;

/// Gives a file of the page by its name. The program brings it, so that this library is built without waiting for the page.
pub type Bundle = fn(&str) -> Option<EmbeddedFile>;

/// A bundle without any file.
#[must_use]
pub fn no_bundle(_: &str) -> Option<EmbeddedFile> {
    None
}

const WITHOUT_BUNDLE: &str = "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Wheelover</title>\n\
<h1>Wheelover</h1>\n<p>The server runs, but it was built without the page.</p>\n\
<p>Stop it and start it with <code>cargo xtask serve</code>, which builds the page first.</p>\n</html>\n";

/// How a text is packed, best first.
const PACKINGS: [(&str, &str); 2] = [("br", ".br"), ("gzip", ".gz")];

/// Answers a request for a file of the page; the head only where `body` is false.
#[must_use]
pub fn answer(bundle: Bundle, path: &str, asked: &HeaderMap, body: bool) -> Response<Body> {
    let path = path.trim_start_matches('/');
    let packed = PACKINGS.iter().any(|(_, end)| path.ends_with(end));
    let name = match path {
        "" => "index.html",
        // Views of the page have addresses of their own; the page itself tells them apart.
        view if !view.contains(['.', '/']) => "index.html",
        file => file,
    };
    if packed {
        return plain(StatusCode::NOT_FOUND, "no such page\n");
    }
    let Some((file, packing)) = find(bundle, name, asked) else {
        if name == "index.html" && bundle("index.html").is_none() {
            return without_bundle(body);
        }
        return plain(StatusCode::NOT_FOUND, "no such page\n");
    };
    let tag = etag(&file.metadata.sha256_hash());
    let mut answer = Response::new(Body::empty());
    let headers = answer.headers_mut();
    let cache = if is_hashed(name) {
        "public, max-age=31536000, immutable"
    } else {
        "no-cache"
    };
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static(cache));
    headers.insert(header::VARY, HeaderValue::from_static("accept-encoding"));
    if let Ok(tag) = HeaderValue::from_str(&tag) {
        headers.insert(header::ETAG, tag);
    }
    if let Some(policy) = inline_policy(bundle, name) {
        headers.insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    if has_tag(asked, &tag) {
        *answer.status_mut() = StatusCode::NOT_MODIFIED;
        return answer;
    }
    headers.insert(
        header::CONTENT_TYPE,
        HeaderValue::from_static(media_type(name)),
    );
    headers.insert(header::CONTENT_LENGTH, HeaderValue::from(file.data.len()));
    if let Some(packing) = packing {
        headers.insert(header::CONTENT_ENCODING, HeaderValue::from_static(packing));
    }
    if body {
        *answer.body_mut() = match file.data {
            Cow::Borrowed(bytes) => Body::from(bytes),
            Cow::Owned(bytes) => Body::from(bytes),
        };
    }
    answer
}

/// The policy of the one page that carries its scripts in itself, since it also works from a disk: what the bundler found
/// in it may run, by its hash, and nothing may be fetched.
fn inline_policy(bundle: Bundle, name: &str) -> Option<HeaderValue> {
    if name != "decoder.html" {
        return None;
    }
    let found = bundle("decoder.policy")?;
    let (scripts, styles) = std::str::from_utf8(&found.data).ok()?.split_once('\n')?;
    let policy = format!(
        "default-src 'none'; script-src 'wasm-unsafe-eval' {scripts}; style-src {styles}; img-src data:; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    );
    HeaderValue::from_str(&policy).ok()
}

/// A short answer in plain text.
#[must_use]
pub fn plain(status: StatusCode, text: &'static str) -> Response<Body> {
    let mut answer = Response::new(Body::from(text));
    *answer.status_mut() = status;
    let headers = answer.headers_mut();
    headers.insert(
        header::CONTENT_TYPE,
        HeaderValue::from_static("text/plain; charset=utf-8"),
    );
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
    answer
}

fn without_bundle(body: bool) -> Response<Body> {
    let mut answer = plain(StatusCode::OK, if body { WITHOUT_BUNDLE } else { "" });
    answer.headers_mut().insert(
        header::CONTENT_TYPE,
        HeaderValue::from_static("text/html; charset=utf-8"),
    );
    answer
}

fn find(
    bundle: Bundle,
    name: &str,
    asked: &HeaderMap,
) -> Option<(EmbeddedFile, Option<&'static str>)> {
    for (packing, end) in PACKINGS {
        if accepts(asked, packing)
            && let Some(file) = bundle(&format!("{name}{end}"))
        {
            return Some((file, Some(packing)));
        }
    }
    bundle(name).map(|file| (file, None))
}

/// Whether the client takes a packing: named, and not with a weight of nought.
fn accepts(asked: &HeaderMap, packing: &str) -> bool {
    asked
        .get_all(header::ACCEPT_ENCODING)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(','))
        .any(|one| {
            let mut parts = one.split(';').map(str::trim);
            parts.next() == Some(packing)
                && !parts.any(|p| p.strip_prefix("q=").is_some_and(|q| q.parse() == Ok(0.0)))
        })
}

fn etag(hash: &[u8; 32]) -> String {
    let mut tag = String::from("\"");
    for byte in &hash[..12] {
        tag.push_str(&format!("{byte:02x}"));
    }
    tag.push('"');
    tag
}

fn has_tag(asked: &HeaderMap, tag: &str) -> bool {
    asked
        .get(header::IF_NONE_MATCH)
        .and_then(|value| value.to_str().ok())
        .is_some_and(|all| {
            all.split(',')
                .any(|one| one.trim().trim_start_matches("W/") == tag)
        })
}

/// Whether a file is named by its content, so that its name changes whenever it does.
fn is_hashed(name: &str) -> bool {
    name.starts_with("assets/")
}

fn media_type(name: &str) -> &'static str {
    match name.rsplit_once('.').map_or("", |(_, end)| end) {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "json" => "application/json",
        "webmanifest" => "application/manifest+json",
        "wasm" => "application/wasm",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "txt" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_a_hash_are_kept_for_ever() {
        assert!(is_hashed("assets/page-1a2b3c4d5e6f.wasm"));
        assert!(!is_hashed("index.html"));
        assert!(!is_hashed("sw.js"));
    }

    #[test]
    fn packing_follows_what_the_client_takes() {
        let check = |value: &'static str, packing: &str, expect: bool| {
            let mut asked = HeaderMap::new();
            asked.insert(header::ACCEPT_ENCODING, HeaderValue::from_static(value));
            assert_eq!(accepts(&asked, packing), expect, "{value}");
        };
        check("gzip, deflate, br", "br", true);
        check("gzip;q=1.0, br;q=0", "br", false);
        check("identity", "gzip", false);
        check("x-gzip", "gzip", false);
    }
}
