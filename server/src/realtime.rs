//! Real-time priority for the control thread, where the system permits it (FC9).

/// Asks for real-time priority for the calling thread; whether it was granted.
#[cfg(target_os = "linux")]
#[expect(
    unsafe_code,
    reason = "the system call has no safe form in the libraries at hand"
)]
pub(crate) fn ask() -> bool {
    use nix::libc;
    /// Above ordinary work, below the kernel's own threads.
    const PRIORITY: libc::c_int = 20;
    let parameter = libc::sched_param {
        sched_priority: PRIORITY,
    };
    // SAFETY: the pointer is to a valid value that outlives the call; 0 names the calling thread.
    let done = unsafe { libc::sched_setscheduler(0, libc::SCHED_FIFO, &raw const parameter) };
    done == 0
}

/// Elsewhere ordinary priority has to do.
#[cfg(not(target_os = "linux"))]
pub(crate) fn ask() -> bool {
    false
}
