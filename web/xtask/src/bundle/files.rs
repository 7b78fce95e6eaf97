//! Files of the bundle: names by content, compressed forms, base64.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use xtask::shell::{Failure, Outcome};

/// Writes the compressed forms of files beside them (`.br`, `.gz`), on all cores.
///
/// # Errors
/// A file cannot be read or written.
pub(crate) fn pack(paths: &[PathBuf], compression: Compression) -> Outcome {
    let next = AtomicUsize::new(0);
    let work = || -> Outcome {
        while let Some(path) = paths.get(next.fetch_add(1, Ordering::Relaxed)) {
            let content = std::fs::read(path).map_err(|error| Failure::file(path, &error))?;
            let beside = |end: &str| PathBuf::from(format!("{}{end}", path.display()));
            write(&beside(".br"), &brotli(&content, compression)?)?;
            write(&beside(".gz"), &gzip(&content, compression)?)?;
        }
        Ok(())
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..cores).map(|_| scope.spawn(work)).collect();
        let lost = |_| Err(Failure::new("a compression was lost"));
        workers
            .into_iter()
            .try_for_each(|worker| worker.join().unwrap_or_else(lost))
    })
}

/// Writes a file; makes its folder where that is missing.
pub(crate) fn write(path: &Path, content: &[u8]) -> Outcome {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|error| Failure::file(folder, &error))?;
    }
    std::fs::write(path, content).map_err(|error| Failure::file(path, &error))
}

/// How hard to compress.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Compression {
    /// For a development build: at once.
    Quick,
    /// For a release: small.
    Small,
}

fn brotli(content: &[u8], compression: Compression) -> Result<Vec<u8>, Failure> {
    let parameters = brotli::enc::BrotliEncoderParams {
        quality: if compression == Compression::Small {
            11
        } else {
            1
        },
        lgwin: 22,
        ..Default::default()
    };
    let mut packed = Vec::new();
    brotli::BrotliCompress(&mut &content[..], &mut packed, &parameters)
        .map_err(|error| Failure::new(format!("brotli: {error}")))?;
    Ok(packed)
}

fn gzip(content: &[u8], compression: Compression) -> Result<Vec<u8>, Failure> {
    let level = if compression == Compression::Small {
        flate2::Compression::best()
    } else {
        flate2::Compression::fast()
    };
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), level);
    encoder
        .write_all(content)
        .and_then(|()| encoder.finish())
        .map_err(|error| Failure::new(format!("gzip: {error}")))
}

/// Twelve hexadecimal digits that change with the content (FNV-1a).
pub(crate) fn fingerprint(content: &[u8]) -> String {
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for byte in content {
        hash = (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    }
    format!("{:012x}", hash >> 16)
}

/// SHA-256, as a browser computes it for a content security policy.
pub(crate) fn sha256(content: &[u8]) -> [u8; 32] {
    use sha2::Digest;
    sha2::Sha256::digest(content).into()
}

/// Standard base64 with padding.
pub(crate) fn base64(content: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(content.len().div_ceil(3) * 4);
    for chunk in content.chunks(3) {
        let byte = |index: usize| u32::from(chunk.get(index).copied().unwrap_or(0));
        let group = byte(0) << 16 | byte(1) << 8 | byte(2);
        for place in 0..4 {
            if place <= chunk.len() {
                text.push(char::from(
                    LETTERS[(group >> (18 - 6 * place)) as usize & 63],
                ));
            } else {
                text.push('=');
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_pads_as_the_standard_does() {
        assert_eq!(base64(b""), "");
        assert_eq!(base64(b"f"), "Zg==");
        assert_eq!(base64(b"fo"), "Zm8=");
        assert_eq!(base64(b"foobar"), "Zm9vYmFy");
    }

    #[test]
    fn fingerprint_changes_with_the_content() {
        assert_ne!(fingerprint(b"a"), fingerprint(b"b"));
        assert_eq!(fingerprint(b"a").len(), 12);
    }
}
