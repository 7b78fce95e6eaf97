//! A race: everyone in every round, in processor time, so that a machine that is busy for a while does not decide.

/// How often everyone runs.
pub const ROUNDS: usize = 9;

/// Processor time of this thread in seconds, so that a busy machine does not count.
pub fn now() -> f64 {
    let clock = nix::time::ClockId::CLOCK_THREAD_CPUTIME_ID;
    let time = nix::time::clock_gettime(clock).expect("a clock of the thread");
    time.tv_sec() as f64 + time.tv_nsec() as f64 / 1e9
}

/// What a race showed; ours is the last.
pub struct Race<const N: usize> {
    /// Best of the rounds in millions of lines a second.
    pub best: [f64; N],
    /// Median over the rounds of ours to the best rival's, a round's runs measured right after each other.
    pub ratio: f64,
    /// What each gave typed.
    pub typed: [usize; N],
}

/// Runs all in every round, so that a machine that is slow for a while is slow for all. Each gives what it typed.
pub fn race<const N: usize>(count: usize, mut runs: [&mut dyn FnMut() -> usize; N]) -> Race<N> {
    let mut best = [f64::INFINITY; N];
    let mut ratios = Vec::with_capacity(ROUNDS);
    let mut typed = [0; N];
    for _ in 0..ROUNDS {
        let mut times = [0.0; N];
        for (n, run) in runs.iter_mut().enumerate() {
            let start = now();
            typed[n] = run();
            times[n] = now() - start;
            best[n] = best[n].min(times[n]);
        }
        let [rivals @ .., ours] = &times[..] else {
            unreachable!("a race has runners")
        };
        ratios.push(rivals.iter().copied().fold(f64::INFINITY, f64::min) / ours);
    }
    ratios.sort_by(f64::total_cmp);
    Race {
        best: best.map(|time| count as f64 / time / 1e6),
        ratio: ratios[ROUNDS / 2],
        typed,
    }
}

/// The lines of a file, the same way for all.
pub fn split(text: &str) -> impl Iterator<Item = &str> {
    let mut start = 0;
    memchr::memchr_iter(b'\n', text.as_bytes()).filter_map(move |end| {
        let line = text.get(start..end);
        start = end + 1;
        line
    })
}
