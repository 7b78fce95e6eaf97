//! Real-time priority for the control thread, and below it for the ports, where the system permits it (FC9).

/// Above ordinary work, below the kernel's own threads.
pub(crate) const CONTROL: i32 = 20;
/// What is heard and said goes before ordinary work too, or an order that was given in time would leave late.
pub(crate) const PORTS: i32 = 10;

/// Asks for this real-time priority for the calling thread; whether it was granted.
#[cfg(target_os = "linux")]
#[expect(
    unsafe_code,
    reason = "the system call has no safe form in the libraries at hand"
)]
pub(crate) fn ask(priority: i32) -> bool {
    use nix::libc;
    let parameter = libc::sched_param {
        sched_priority: priority,
    };
    // SAFETY: the pointer is to a valid value that outlives the call; 0 names the calling thread.
    let done = unsafe { libc::sched_setscheduler(0, libc::SCHED_FIFO, &raw const parameter) };
    done == 0
}

/// Elsewhere ordinary priority has to do.
#[cfg(not(target_os = "linux"))]
pub(crate) fn ask(_priority: i32) -> bool {
    false
}
