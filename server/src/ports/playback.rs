//! A recording in the place of a line: its lines are heard once, at their times on board or at the pace of a 4800 baud line.

use crate::bus::{Inlet, Link};
use crate::clock::Tempo;
use std::io;
use std::path::Path;
use std::time::Duration;
use tokio::fs::File;
use tokio::io::{AsyncBufReadExt, AsyncReadExt, BufReader};
use tokio::time::{Instant, sleep, sleep_until};

/// A line that is longer is heard in pieces.
const LONGEST: u64 = 1024;

/// Plays a recording to its end.
pub(super) async fn play(path: &Path, link: &Link, inlet: &Inlet, tempo: Tempo) -> io::Result<()> {
    let mut file = BufReader::new(File::open(path).await?);
    inlet.port_up(link, true);
    let start = Instant::now();
    let mut first = None;
    let mut line = Vec::new();
    loop {
        line.clear();
        let heard = (&mut file).take(LONGEST).read_until(b'\n', &mut line).await;
        match heard {
            Ok(0) | Err(_) => {
                inlet.port_up(link, false);
                return heard.map(|_| ());
            }
            Ok(_) => {}
        }
        let (at, text) = stamped(&line);
        match at {
            Some(at) => {
                let zero = *first.get_or_insert(at);
                let after = Duration::from_secs_f64((at - zero).clamp(0.0, 1e6));
                sleep_until(start + tempo.wall(after)).await;
            }
            None => {
                let long = Duration::from_secs_f64(text.len() as f64 / 480.0);
                sleep(tempo.wall(long)).await;
            }
        }
        let bytes = text.to_vec();
        if !bytes.is_empty() {
            let _ = inlet.hear(link, bytes);
        }
    }
}

/// Splits `12.250 < $EIHTC…` into its time and what was heard; what was sent (`>`) is not heard.
fn stamped(line: &[u8]) -> (Option<f64>, &[u8]) {
    let mut parts = line.splitn(3, |byte| *byte == b' ');
    let (Some(at), Some(way), Some(text)) = (parts.next(), parts.next(), parts.next()) else {
        return (None, line);
    };
    let at = std::str::from_utf8(at)
        .ok()
        .and_then(|at| at.parse::<f64>().ok());
    match (at.filter(|at| at.is_finite()), way) {
        (Some(at), b"<") => (Some(at), text),
        (Some(at), b">") => (Some(at), &[]),
        _ => (None, line),
    }
}

#[cfg(test)]
mod tests {
    use super::stamped;

    #[test]
    fn a_time_before_a_line_is_its_time() {
        assert_eq!(
            stamped(b"12.250 < $EIHTC,V\r\n"),
            (Some(12.25), &b"$EIHTC,V\r\n"[..])
        );
        assert_eq!(stamped(b"12.5 > $AGHTD,V\r\n"), (Some(12.5), &b""[..]));
        assert_eq!(stamped(b"$EIHTC,V\r\n"), (None, &b"$EIHTC,V\r\n"[..]));
        assert_eq!(stamped(b"nan < $A\r\n"), (None, &b"nan < $A\r\n"[..]));
    }
}
