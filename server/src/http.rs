//! HTTP: the accept loop with its limits, and the few addresses that the server answers.

use crate::guard::{self, Ends, Hosts};
use crate::page;
use axum::Router;
use axum::body::Body;
use axum::extract::{Request, State};
use axum::http::{Method, Response, StatusCode};
use axum::middleware::{self, Next};
use axum::routing::get;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, watch};

/// A request whose head takes longer than this is closed (FC12).
const HEADER_TIMEOUT: Duration = Duration::from_secs(4);
/// Connections served at once; more wait in the kernel's queue.
const CONNECTIONS: usize = 4096;

/// What the answers are made from.
#[derive(Debug)]
pub struct Site {
    /// By which names this machine may be addressed.
    pub hosts: Hosts,
}

/// The addresses that are answered.
pub fn router(site: Arc<Site>) -> Router {
    Router::new()
        .route("/healthz", get(healthz))
        .fallback(file)
        .layer(middleware::from_fn_with_state(site.clone(), check))
        .with_state(site)
}

/// Serves connections until `stop` is raised.
pub async fn accept(listener: TcpListener, router: Router, mut stop: watch::Receiver<bool>) {
    let places = Arc::new(Semaphore::new(CONNECTIONS));
    loop {
        let Ok(place) = places.clone().acquire_owned().await else {
            return;
        };
        let accepted = tokio::select! {
            accepted = listener.accept() => accepted,
            () = stopped(&mut stop) => return,
        };
        match accepted {
            Ok((stream, peer)) => {
                let (router, stop) = (router.clone(), stop.clone());
                tokio::spawn(async move {
                    connection(stream, peer, router, stop).await;
                    drop(place);
                });
            }
            // Out of file handles, or a client that is gone already: neither ends the service.
            Err(_) => tokio::time::sleep(Duration::from_millis(50)).await,
        }
    }
}

/// Waits until `stop` is raised, or until nobody is left to raise it.
pub(crate) async fn stopped(stop: &mut watch::Receiver<bool>) {
    let _ = stop.wait_for(|stop| *stop).await;
}

async fn connection(
    stream: TcpStream,
    peer: std::net::SocketAddr,
    router: Router,
    mut stop: watch::Receiver<bool>,
) {
    let Ok(local) = stream.local_addr() else {
        return;
    };
    let _ = stream.set_nodelay(true);
    let ends = Ends { peer, local };
    let service = TowerToHyperService::new(router.layer(axum::Extension(ends)));
    let serving = hyper::server::conn::http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEADER_TIMEOUT)
        .max_buf_size(16 * 1024)
        .serve_connection(TokioIo::new(stream), service)
        .with_upgrades();
    tokio::pin!(serving);
    tokio::select! {
        _ = &mut serving => {}
        () = stopped(&mut stop) => {
            serving.as_mut().graceful_shutdown();
            let _ = tokio::time::timeout(Duration::from_millis(500), serving).await;
        }
    }
}

/// Host first, headers of safety last, on every answer.
async fn check(State(site): State<Arc<Site>>, request: Request, next: Next) -> Response<Body> {
    let local = request
        .extensions()
        .get::<Ends>()
        .map(|ends| ends.local.ip());
    let ours = match (guard::host_of(&request), local) {
        (Some(host), Some(local)) => site.hosts.allow(host, local),
        _ => false,
    };
    let mut answer = if ours {
        next.run(request).await
    } else {
        let mut answer = Response::new(Body::empty());
        *answer.status_mut() = StatusCode::MISDIRECTED_REQUEST;
        answer
    };
    guard::harden(answer.headers_mut());
    answer
}

async fn healthz() -> Response<Body> {
    page::plain(StatusCode::OK, "ok\n")
}

async fn file(request: Request) -> Response<Body> {
    let method = request.method();
    if method != Method::GET && method != Method::HEAD {
        return page::plain(StatusCode::METHOD_NOT_ALLOWED, "read only\n");
    }
    page::answer(
        request.uri().path(),
        request.headers(),
        method == Method::GET,
    )
}
