//! STANDBY while an input is flooded: never "busy", never late (AP-25).

use std::io::Write;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use wheelover_core::view::{ModeName, ModeRequest, Order};
use wheelover_tests::page::{Page, SOON};
use wheelover_tests::program::Program;
use wheelover_tests::{folder, with_checksum};

/// Longest time until STANDBY is answered.
const AT_ONCE: Duration = Duration::from_millis(100);

/// Writes sentences into an address as fast as they are taken, until it is dropped.
struct Flood(Arc<AtomicBool>);

impl Flood {
    fn begin(address: SocketAddr) -> Self {
        let over = Arc::new(AtomicBool::new(false));
        let stop = over.clone();
        std::thread::spawn(move || {
            // Sentences that cost the reader most: right ones, short ones, and noise without an end.
            let mut block = Vec::new();
            for number in 0..400 {
                block.extend(with_checksum(&format!("HEHDT,{}.00,T", number % 360)).into_bytes());
                block.extend_from_slice(b"\r\n$*\r\n!,,,*00\r\n");
            }
            block.resize(block.len() + 2_000, b'A');
            while !stop.load(Ordering::Relaxed) {
                if let Ok(mut stream) = TcpStream::connect(address) {
                    while !stop.load(Ordering::Relaxed) && stream.write_all(&block).is_ok() {}
                } else {
                    std::thread::sleep(Duration::from_millis(50));
                }
            }
        });
        Self(over)
    }
}

impl Drop for Flood {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// An address that nobody listens on now.
fn free() -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    listener.local_addr().unwrap()
}

fn flooded(page: &Page) -> bool {
    let ports = page.ports.as_ref().map(|ports| &ports.ports);
    ports.is_some_and(|ports| ports.iter().any(|port| port.trouble.contains("too much")))
}

#[tokio::test]
async fn standby_is_answered_at_once_while_the_bytes_queue_is_full() {
    let folder = folder("flood");
    let (loud, compass) = (free(), free());
    let config = folder.join("wheelover.toml");
    let mut text = "roles = [\"autopilot\"]\n".to_string();
    for (name, address) in [("monitor", loud), ("gyro1", compass)] {
        text += &format!(
            "[[port]]\nname = \"{name}\"\nkind = \"tcp-server\"\naddress = \"{address}\"\nprofile = \"{name}\"\n"
        );
    }
    std::fs::write(&config, text).unwrap();
    let program = Program::start(&["--config", config.to_str().unwrap()]);
    let mut gyro = TcpStream::connect(compass).unwrap();
    let heading = format!("{}\r\n", with_checksum("HEHDT,100.00,T"));
    std::thread::spawn(move || {
        while gyro.write_all(heading.as_bytes()).is_ok() {
            std::thread::sleep(Duration::from_millis(100));
        }
    });
    // One page watches; the other is the officer's, which wants no lines of a flood.
    let mut watch = Page::open(program.address).await;
    watch
        .say_text(r#"{"type":"subscribe","rate":1,"lines":false}"#.into())
        .await;
    let mut page = Page::open(program.address).await;
    page.say_text(r#"{"type":"subscribe","rate":10,"lines":false}"#.into())
        .await;
    let _flood = Flood::begin(loud);
    watch
        .until("the flood", Duration::from_secs(60), flooded)
        .await;
    let mut waits = Vec::new();
    for round in 0..200 {
        if round % 20 == 0 {
            // The other port is still heard: AUTO needs its heading.
            page.insist(Order::Mode(ModeRequest::Auto), SOON).await;
        }
        let asked = Instant::now();
        let answer = page.command(Order::Mode(ModeRequest::Standby)).await;
        waits.push(asked.elapsed());
        assert!(answer.ok, "{}", answer.text);
        page.follow(Duration::from_millis(20)).await;
    }
    watch.ports = None;
    watch
        .until("the flood, still", Duration::from_secs(60), flooded)
        .await;
    waits.sort();
    let (median, worst) = (waits[waits.len() / 2], waits[waits.len() - 1]);
    println!("STANDBY under a flood of bytes: median {median:?}, worst {worst:?}");
    assert!(worst < AT_ONCE, "median {median:?}, worst {worst:?}");
    let own = |page: &Page| page.snapshot.as_ref()?.own.as_ref().map(|own| own.mode);
    page.until("STANDBY", SOON, |page| own(page) == Some(ModeName::Standby))
        .await;
    // Who opens a page now is let in.
    let asked = Instant::now();
    Page::open(program.address).await;
    assert!(asked.elapsed() < Duration::from_secs(2));
}

// One client that fills its own places with orders is refused; its STANDBY is not, and no other client is.
#[tokio::test]
async fn standby_is_granted_to_who_has_no_place_left() {
    let program = Program::start(&[]);
    let mut page = Page::open(program.address).await;
    let mut other = Page::open(program.address).await;
    for id in 0..150 {
        let text = format!(r#"{{"type":"command","id":{id},"do":{{"officer":false}}}}"#);
        assert!(page.say_text(text).await);
    }
    let asked = Instant::now();
    assert!(page.command(Order::Mode(ModeRequest::Standby)).await.ok);
    assert!(other.command(Order::Mode(ModeRequest::Standby)).await.ok);
    assert!(asked.elapsed() < Duration::from_secs(2));
}
