//! Many pages that take everything and acknowledge each snapshot, as cheaply as can be.

use futures_util::{SinkExt, StreamExt};
use std::io::Read;
use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};
use tokio::net::TcpStream;
use tokio_tungstenite::client_async;
use tokio_tungstenite::tungstenite::Message;

/// Opens the pages, says so in a line, and when its input ends says how many snapshots a second the worst served got.
pub(crate) fn run(address: SocketAddr, pages: usize) {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()
        .unwrap();
    let counts: Vec<Arc<AtomicU64>> = (0..pages).map(|_| Arc::default()).collect();
    let shared = counts.clone();
    let over = std::thread::spawn(move || {
        let wait = Instant::now();
        while shared
            .iter()
            .any(|count| count.load(Ordering::Relaxed) == 0)
        {
            assert!(
                wait.elapsed() < Duration::from_secs(60),
                "pages that get nothing"
            );
            std::thread::sleep(Duration::from_millis(50));
        }
        let read = || {
            shared
                .iter()
                .map(|count| count.load(Ordering::Relaxed))
                .collect::<Vec<_>>()
        };
        let (began, before) = (Instant::now(), read());
        println!("open");
        let _ = std::io::stdin().read_to_end(&mut Vec::new());
        let time = began.elapsed().as_secs_f64();
        let worst = read()
            .iter()
            .zip(&before)
            .map(|(now, before)| now - before)
            .min();
        println!("{}", worst.unwrap_or(0) as f64 / time);
        std::process::exit(0);
    });
    runtime.block_on(async {
        let pages: Vec<_> = counts
            .into_iter()
            .map(|count| tokio::spawn(page(address, count)))
            .collect();
        for page in pages {
            page.await.unwrap();
        }
    });
    over.join().unwrap();
}

async fn page(address: SocketAddr, count: Arc<AtomicU64>) {
    let stream = TcpStream::connect(address).await.unwrap();
    stream.set_nodelay(true).unwrap();
    let (mut socket, _) = client_async(format!("ws://{address}/ws"), stream)
        .await
        .unwrap();
    while let Some(Ok(message)) = socket.next().await {
        if let Message::Text(text) = message
            && let Some(frame) = frame(&text)
        {
            count.fetch_add(1, Ordering::Relaxed);
            let ack = format!(r#"{{"type":"ack","frame":{frame}}}"#);
            if socket.send(Message::text(ack)).await.is_err() {
                return;
            }
        }
    }
}

/// Number of a snapshot, read without the rest of it.
fn frame(text: &str) -> Option<u64> {
    let rest = text.strip_prefix(r#"{"type":"snapshot","frame":"#)?;
    rest.split(',').next()?.parse().ok()
}
