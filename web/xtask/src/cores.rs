//! Several cargo runs side by side share the cores as make's jobs do: each holds one, and takes a token for every further one.

use crate::shell::{Failure, run, target};
use std::fs::File;
use std::io::Write;
use std::path::PathBuf;
use std::process::Command;

/// The tokens, in a named pipe that cargo and rustc take them from and give them back to.
#[derive(Debug)]
pub struct Cores {
    /// The pipe and the end of it that keeps it open; none where the system has no such pipes: then each run takes all cores.
    pipe: Option<(PathBuf, File)>,
}

impl Cores {
    /// A token for every core but the first. Without them, three runs on two cores are a tenth slower than one after the other.
    #[must_use]
    pub fn shared() -> Self {
        Self {
            pipe: tokens().ok(),
        }
    }

    /// Lets a cargo command share them.
    #[must_use]
    pub fn give(&self, mut command: Command) -> Command {
        if let Some((path, _)) = &self.pipe {
            let flags = format!("-j --jobserver-auth=fifo:{}", path.display());
            command.env("MAKEFLAGS", flags);
        }
        command
    }
}

impl Drop for Cores {
    fn drop(&mut self) {
        if let Some((path, _)) = &self.pipe {
            // It is empty, and in the folder of things that may be deleted.
            let _removed = std::fs::remove_file(path);
        }
    }
}

fn tokens() -> Result<(PathBuf, File), Failure> {
    let path = target().join(format!("cores-{}", std::process::id()));
    let failed = |error: std::io::Error| Failure::file(&path, &error);
    std::fs::create_dir_all(target()).map_err(failed)?;
    run(Command::new("mkfifo").arg(&path))?;
    let mut pipe = File::options()
        .read(true)
        .write(true)
        .open(&path)
        .map_err(failed)?;
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    pipe.write_all(&vec![b'+'; cores - 1]).map_err(failed)?;
    Ok((path, pipe))
}
