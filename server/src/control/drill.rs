//! A drill for tests of the program as a whole: the control thread fails when told to. No release has it.

/// How it fails.
#[derive(Clone, Copy)]
enum Failure {
    Panic,
    Leave,
    Hang,
}

/// A failure, so many microseconds after the start.
pub(super) struct Drill {
    failure: Failure,
    after: u64,
}

impl Drill {
    /// `WHEELOVER_DRILL=panic:1500`: `panic`, `leave` or `hang`, and milliseconds.
    pub(super) fn from_environment() -> Option<Self> {
        let told = std::env::var("WHEELOVER_DRILL").ok()?;
        let (failure, after) = told.split_once(':')?;
        let failure = match failure {
            "panic" => Failure::Panic,
            "leave" => Failure::Leave,
            "hang" => Failure::Hang,
            _ => return None,
        };
        let after: u64 = after.parse().ok()?;
        Some(Self {
            failure,
            after: after * 1_000,
        })
    }

    /// Fails when it is time; whether the thread is to leave.
    pub(super) fn hold(&self, wall: u64) -> bool {
        if wall < self.after {
            return false;
        }
        match self.failure {
            Failure::Panic => panic!("a drill"),
            Failure::Leave => true,
            Failure::Hang => loop {
                std::thread::sleep(std::time::Duration::from_secs(1));
            },
        }
    }
}
