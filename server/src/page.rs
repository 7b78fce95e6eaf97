//! The page: the files of the bundle, sent compressed and cached by their names.

use axum::body::Body;
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{Response, StatusCode};

/// The files of the page, as the bundler laid them. The program brings them, so that this library is built without waiting for the page.
pub type Bundle = &'static [File];

/// A file of the page.
#[derive(Clone, Copy, Debug)]
pub struct File {
    /// Its address, without the slash before it.
    pub name: &'static str,
    /// Its media type, with the character set of a text.
    pub media: &'static str,
    /// Changes with its content.
    pub hash: &'static str,
    /// Its name changes with its content too, so that it may be kept for ever.
    pub kept: bool,
    /// What stands inline in it and may run; none where nothing does.
    pub inline: Option<Inline>,
    /// Its content.
    pub plain: &'static [u8],
    /// The same, packed, best first.
    pub packed: &'static [Packed],
}

/// A packed form of a file.
#[derive(Clone, Copy, Debug)]
pub struct Packed {
    /// The name of the content coding, as in `Accept-Encoding`.
    pub coding: &'static str,
    /// The packed content.
    pub content: &'static [u8],
}

/// Hashes of what stands inline in a page, as sources of a content security policy.
#[derive(Clone, Copy, Debug)]
pub struct Inline {
    /// Its scripts.
    pub scripts: &'static str,
    /// Its styles.
    pub styles: &'static str,
}

const WITHOUT_BUNDLE: &str = "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Wheelover</title>\n\
<h1>Wheelover</h1>\n<p>The server runs, but it was built without the page.</p>\n\
<p>Stop it and start it with <code>cargo xtask serve</code>, which builds the page first.</p>\n</html>\n";

/// Answers a request for a file of the page; the head only where `body` is false.
#[must_use]
pub(crate) fn answer(bundle: Bundle, path: &str, asked: &HeaderMap, body: bool) -> Response<Body> {
    let name = match path.trim_start_matches('/') {
        "" => "index.html",
        // Views of the page have addresses of their own; the page itself tells them apart.
        view if !view.contains(['.', '/']) => "index.html",
        file => file,
    };
    let Some(file) = bundle.iter().find(|file| file.name == name) else {
        if name == "index.html" {
            return without_bundle(body);
        }
        return plain(StatusCode::NOT_FOUND, "no such page\n");
    };
    let packed = file.packed.iter().find(|one| accepts(asked, one.coding));
    let tag = etag(file, packed);
    let mut answer = Response::new(Body::empty());
    let headers = answer.headers_mut();
    let cache = if file.kept {
        "public, max-age=31536000, immutable"
    } else {
        "no-cache"
    };
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static(cache));
    headers.insert(header::VARY, HeaderValue::from_static("accept-encoding"));
    if let Ok(tag) = HeaderValue::from_str(&tag) {
        headers.insert(header::ETAG, tag);
    }
    if let Some(policy) = file.inline.and_then(inline_policy) {
        headers.insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    if has_tag(asked, &tag) {
        *answer.status_mut() = StatusCode::NOT_MODIFIED;
        return answer;
    }
    let content = packed.map_or(file.plain, |one| one.content);
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static(file.media));
    headers.insert(header::CONTENT_LENGTH, HeaderValue::from(content.len()));
    if let Some(one) = packed {
        headers.insert(
            header::CONTENT_ENCODING,
            HeaderValue::from_static(one.coding),
        );
    }
    if body {
        *answer.body_mut() = Body::from(content);
    }
    answer
}

/// The policy of the one page that carries its scripts in itself, since it also works from a disk: what the bundler found
/// in it may run, by its hash, and nothing may be fetched.
fn inline_policy(Inline { scripts, styles }: Inline) -> Option<HeaderValue> {
    let policy = format!(
        "default-src 'none'; script-src 'wasm-unsafe-eval' {scripts}; style-src {styles}; img-src data:; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    );
    HeaderValue::from_str(&policy).ok()
}

/// A short answer in plain text.
#[must_use]
pub(crate) fn plain(status: StatusCode, text: &'static str) -> Response<Body> {
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

/// Each form of a file has a tag of its own.
fn etag(file: &File, packed: Option<&Packed>) -> String {
    let coding = packed.map_or("plain", |one| one.coding);
    format!("\"{}-{coding}\"", file.hash)
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

#[cfg(test)]
mod tests {
    use super::*;
    use axum::body::HttpBody;

    const PAGE: Bundle = &[
        File {
            name: "index.html",
            media: "text/html; charset=utf-8",
            hash: "1a2b",
            kept: false,
            inline: None,
            plain: b"<!doctype html>",
            packed: &[
                Packed {
                    coding: "br",
                    content: b"B",
                },
                Packed {
                    coding: "gzip",
                    content: b"GZ",
                },
            ],
        },
        File {
            name: "assets/page-3c4d.wasm",
            media: "application/wasm",
            hash: "3c4d",
            kept: true,
            inline: Some(Inline {
                scripts: "'sha256-x'",
                styles: "'sha256-y'",
            }),
            plain: b"\0asm",
            packed: &[],
        },
    ];

    /// Status, coding, tag and length of an answer.
    fn asked(path: &str, coding: &'static str, tag: Option<&str>) -> String {
        let mut asked = HeaderMap::new();
        asked.insert(header::ACCEPT_ENCODING, HeaderValue::from_static(coding));
        if let Some(tag) = tag {
            asked.insert(header::IF_NONE_MATCH, HeaderValue::from_str(tag).unwrap());
        }
        let answer = answer(PAGE, path, &asked, true);
        let head = |name| {
            let value = answer.headers().get(name);
            value.map_or("-", |value: &HeaderValue| value.to_str().unwrap())
        };
        let (coding, tag) = (head(header::CONTENT_ENCODING), head(header::ETAG));
        let length = head(header::CONTENT_LENGTH);
        format!("{} {coding} {tag} {length}", answer.status().as_u16())
    }

    #[test]
    fn each_form_of_a_file_has_a_tag_of_its_own() {
        assert_eq!(asked("/", "gzip, br", None), "200 br \"1a2b-br\" 1");
        assert_eq!(asked("/", "gzip", None), "200 gzip \"1a2b-gzip\" 2");
        assert_eq!(
            asked("/dialogue", "identity", None),
            "200 - \"1a2b-plain\" 15"
        );
        assert_eq!(
            asked("/", "br", Some("W/\"1a2b-br\"")),
            "304 - \"1a2b-br\" -"
        );
        assert_eq!(
            asked("/", "gzip", Some("\"1a2b-br\"")),
            "200 gzip \"1a2b-gzip\" 2"
        );
        assert_eq!(
            asked("/assets/page-3c4d.wasm", "br", None),
            "200 - \"3c4d-plain\" 4"
        );
        assert_eq!(asked("/index.html.br", "br", None), "404 - - -");
    }

    #[test]
    fn only_what_is_named_by_its_content_is_kept_for_ever() {
        let kept = |path: &str| {
            let answer = answer(PAGE, path, &HeaderMap::new(), true);
            answer.headers()[header::CACHE_CONTROL] != "no-cache"
        };
        assert!(kept("/assets/page-3c4d.wasm"));
        assert!(!kept("/"));
    }

    #[test]
    fn a_server_without_a_page_says_so() {
        let answer = answer(&[], "/", &HeaderMap::new(), true);
        assert_eq!(answer.status(), StatusCode::OK);
        let length = answer.body().size_hint().exact();
        assert_eq!(length, Some(WITHOUT_BUNDLE.len() as u64));
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
