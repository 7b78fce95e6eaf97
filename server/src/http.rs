//! HTTP: the accept loop with its limits, and the few addresses that the server answers.

use crate::bus::{Document, Inlet};
use crate::feed::{Feed, encode};
use crate::guard::{self, Ends, Hosts, Origin};
use crate::page::{self, Bundle};
use crate::ws::{self, Rights, Source};
use axum::body::Body;
use axum::extract::ws::rejection::WebSocketUpgradeRejection;
use axum::extract::ws::{Utf8Bytes, WebSocketUpgrade};
use axum::extract::{RawQuery, Request, State};
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{Method, Response, StatusCode};
use axum::middleware::{self, Next};
use axum::response::IntoResponse;
use axum::routing::get;
use axum::{Extension, Router};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Semaphore;
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;
use tower_http::catch_panic::CatchPanicLayer;
use wheelover_core::view::Down;

/// A request whose head takes longer than this is closed (FC12).
const HEADER_TIMEOUT: Duration = Duration::from_secs(4);
/// Connections served at once; more wait in the kernel's queue.
const CONNECTIONS: usize = 4096;

/// What the answers are made from.
#[derive(Debug)]
pub(crate) struct Site {
    /// By which names this machine may be addressed.
    pub(crate) hosts: Hosts,
    /// The way to the control thread.
    pub(crate) inlet: Inlet,
    /// What pages are told.
    pub(crate) feed: Arc<Feed>,
    /// Cancelled when the server ends.
    pub(crate) stop: CancellationToken,
    /// Every task of the server, so that its end can be waited for.
    pub(crate) tasks: TaskTracker,
    /// Commands reach nothing but the embedded voyage.
    pub(crate) simulated: bool,
    /// Opened to the network for reading (`--lan`).
    pub(crate) lan: bool,
    /// The files of the page.
    pub(crate) page: Bundle,
}

impl Site {
    /// What a client at `ends` may command: until there are roles, real equipment is commanded from
    /// this computer only, the embedded voyage from anywhere unless opened for reading.
    fn rights(&self, ends: &Ends) -> Rights {
        let here = ends.peer.ip().to_canonical().is_loopback();
        if here || self.simulated && !self.lan {
            Rights::All
        } else {
            Rights::Look
        }
    }
}

/// The addresses that are answered.
fn router(site: Arc<Site>) -> Router {
    let router = Router::new()
        .route("/healthz", get(healthz))
        .route("/api/hello", get(hello))
        .route("/api/route", get(route))
        .route("/api/alerts", get(alerts))
        .route("/api/dialogue", get(dialogue))
        .route("/api/offered", get(offered))
        .route("/ws", get(socket))
        .fallback(file)
        .layer(middleware::from_fn_with_state(site.clone(), check))
        .with_state(site);
    guard::harden(router).layer(CatchPanicLayer::new())
}

/// Serves connections until the server ends.
pub(crate) async fn accept(listener: TcpListener, site: Arc<Site>) {
    let places = Arc::new(Semaphore::new(CONNECTIONS));
    let router = router(site.clone());
    loop {
        let Ok(place) = places.clone().acquire_owned().await else {
            return;
        };
        let accepted = tokio::select! {
            accepted = listener.accept() => accepted,
            () = site.stop.cancelled() => return,
        };
        match accepted {
            Ok((stream, peer)) => {
                let (router, stop) = (router.clone(), site.stop.clone());
                site.tasks.spawn(async move {
                    connection(stream, peer, router, stop).await;
                    drop(place);
                });
            }
            // Out of file handles, or a client that is gone already: neither ends the service.
            Err(_) => tokio::time::sleep(Duration::from_millis(50)).await,
        }
    }
}

async fn connection(stream: TcpStream, peer: SocketAddr, router: Router, stop: CancellationToken) {
    let Ok(local) = stream.local_addr() else {
        return;
    };
    let _ = stream.set_nodelay(true);
    let ends = Ends { peer, local };
    let service = TowerToHyperService::new(router.layer(Extension(ends)));
    let serving = hyper::server::conn::http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEADER_TIMEOUT)
        .max_buf_size(16 * 1024)
        .serve_connection(TokioIo::new(stream), service)
        .with_upgrades();
    tokio::pin!(serving);
    tokio::select! {
        _ = &mut serving => {}
        () = stop.cancelled() => {
            serving.as_mut().graceful_shutdown();
            let _ = tokio::time::timeout(Duration::from_millis(500), serving).await;
        }
    }
}

/// The host first: another name than ours is not answered.
async fn check(State(site): State<Arc<Site>>, request: Request, next: Next) -> Response<Body> {
    let local = request
        .extensions()
        .get::<Ends>()
        .map(|ends| ends.local.ip());
    let ours = match (guard::host_of(&request), local) {
        (Some(host), Some(local)) => site.hosts.allow(host, local),
        _ => false,
    };
    if ours {
        next.run(request).await
    } else {
        let mut answer = Response::new(Body::empty());
        *answer.status_mut() = StatusCode::MISDIRECTED_REQUEST;
        answer
    }
}

async fn healthz(State(site): State<Arc<Site>>) -> Response<Body> {
    if site.feed.is_alive() {
        page::plain(StatusCode::OK, "ok\n")
    } else {
        page::plain(
            StatusCode::SERVICE_UNAVAILABLE,
            "the control loop is silent\n",
        )
    }
}

/// What is said where the control thread does not answer any more.
fn ended() -> Response<Body> {
    page::plain(
        StatusCode::SERVICE_UNAVAILABLE,
        "the control loop has ended\n",
    )
}

/// The alerts that stand, and those that have been (DSP-5).
async fn alerts(State(site): State<Arc<Site>>) -> Response<Body> {
    match site.inlet.alerts().await {
        Some(document) => json(encode(&document).unwrap_or_default()),
        None => ended(),
    }
}

async fn hello(State(site): State<Arc<Site>>, Extension(ends): Extension<Ends>) -> Response<Body> {
    let Some(mut hello) = site.inlet.hello().await else {
        return ended();
    };
    hello.may_command = site.rights(&ends) == Rights::All;
    json(encode(&Down::Hello(hello)).unwrap_or_default())
}

async fn route(State(site): State<Arc<Site>>) -> Response<Body> {
    json(site.feed.document(Document::Route))
}

/// What the checker of the dialogue has found since the start (CON-2).
async fn dialogue(State(site): State<Arc<Site>>) -> Response<Body> {
    json(encode(&site.feed.dialogue().found()).unwrap_or_default())
}

/// The route that a plotter offers to our chart-system side, or null (TCS-13).
async fn offered(State(site): State<Arc<Site>>) -> Response<Body> {
    match site.inlet.offered().await {
        Some(offered) => json(encode(&offered).unwrap_or_default()),
        None => page::plain(
            StatusCode::SERVICE_UNAVAILABLE,
            "the control loop has ended\n",
        ),
    }
}

fn json(text: Utf8Bytes) -> Response<Body> {
    let mut answer = page::plain(StatusCode::OK, "");
    *answer.body_mut() = Body::from(axum::body::Bytes::from(text));
    answer.headers_mut().insert(
        header::CONTENT_TYPE,
        HeaderValue::from_static("application/json"),
    );
    answer
}

async fn socket(
    State(site): State<Arc<Site>>,
    Extension(ends): Extension<Ends>,
    RawQuery(query): RawQuery,
    headers: HeaderMap,
    upgrade: Result<WebSocketUpgrade, WebSocketUpgradeRejection>,
) -> Response<Body> {
    let host = headers
        .get(header::HOST)
        .and_then(|host| host.to_str().ok());
    if guard::origin(&headers, host.unwrap_or_default()) == Origin::Foreign {
        return page::plain(
            StatusCode::FORBIDDEN,
            "pages from elsewhere are not served\n",
        );
    }
    let upgrade = match upgrade {
        Ok(upgrade) => upgrade,
        Err(refused) => return refused.into_response(),
    };
    let source = Source {
        inlet: site.inlet.clone(),
        feed: site.feed.clone(),
        stop: site.stop.clone(),
        rights: site.rights(&ends),
        will_resume: query.as_deref() == Some("lines=resumed"),
    };
    let tasks = site.tasks.clone();
    ws::limit(upgrade).on_upgrade(move |socket| tasks.track_future(ws::serve(socket, source)))
}

async fn file(State(site): State<Arc<Site>>, request: Request) -> Response<Body> {
    let method = request.method();
    if method != Method::GET && method != Method::HEAD {
        return page::plain(StatusCode::METHOD_NOT_ALLOWED, "read only\n");
    }
    page::answer(
        site.page,
        request.uri().path(),
        request.headers(),
        method == Method::GET,
    )
}
