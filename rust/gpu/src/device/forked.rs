//! The exit of a forked child.

/// Makes this process exit without the exit handlers that its parent's drivers registered. Those of Mesa wait for
/// driver threads, which a forked child does not have: it would hang or crash after all its work was done.
pub fn end_without_drivers() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    gnu::register_exit();
}

#[cfg(all(target_os = "linux", target_env = "gnu"))]
mod gnu {
    use std::ffi::{c_int, c_void};
    use std::ptr;

    unsafe extern "C" {
        fn on_exit(function: extern "C" fn(c_int, *mut c_void), argument: *mut c_void) -> c_int;
        fn fflush(stream: *mut c_void) -> c_int;
        fn _exit(status: c_int) -> !;
    }

    extern "C" fn flush_and_exit(status: c_int, _: *mut c_void) {
        // SAFETY: flushes all of C's streams, as `exit` does after its handlers, and does not return.
        unsafe {
            fflush(ptr::null_mut());
            _exit(status)
        }
    }

    pub fn register_exit() {
        // Handlers run in reverse order of registration: this one before the inherited ones.
        // SAFETY: the function exists until the process ends, and does not read its argument.
        unsafe { on_exit(flush_and_exit, ptr::null_mut()) };
    }
}
