//! Signals and limits of the process.

use std::io;

use tokio_util::sync::CancellationToken;

/// Exit code after a second signal: the shell's for an interrupted program.
const INTERRUPTED: i32 = 130;

/// Returns a token that the first SIGTERM or SIGINT cancels. A second signal ends the process at
/// once.
///
/// # Errors
/// If the signals cannot be listened to. Needs a Tokio runtime.
pub fn stop_on_signal() -> io::Result<CancellationToken> {
    let mut signals = Signals::new()?;
    survive_file_size_limit()?;
    let stop = CancellationToken::new();
    let first = stop.clone();
    tokio::spawn(async move {
        signals.next().await;
        tracing::info!("stopping; a second signal stops at once");
        first.cancel();
        signals.next().await;
        tracing::warn!("stopped at once");
        std::process::exit(INTERRUPTED);
    });
    Ok(stop)
}

/// Cancels `stop` when standard input is closed. The system closes it when the parent process
/// ends, even by SIGKILL.
///
/// # Errors
/// If the thread that reads it cannot start.
pub fn stop_with_stdin(stop: CancellationToken) -> io::Result<()> {
    let read = move || {
        // An error of reading counts as the end of input.
        let _ = io::copy(&mut io::stdin().lock(), &mut io::sink());
        tracing::info!("standard input is closed: stopping");
        stop.cancel();
    };
    std::thread::Builder::new().name("stdin".to_owned()).spawn(read)?;
    Ok(())
}

/// SIGXFSZ, sent for a write beyond the process's limit on the size of a file (`ulimit -f`), on
/// Linux and the BSDs.
#[cfg(unix)]
const SIGXFSZ: i32 = 25;

/// With a handler, a write beyond the limit on the size of a file fails; without one, it ends the
/// process.
#[cfg(unix)]
fn survive_file_size_limit() -> io::Result<()> {
    use tokio::signal::unix::{SignalKind, signal};
    let mut exceeded = signal(SignalKind::from_raw(SIGXFSZ))?;
    tokio::spawn(async move {
        while exceeded.recv().await.is_some() {
            tracing::error!("a file has reached the largest size that this process may write");
        }
    });
    Ok(())
}

#[cfg(not(unix))]
#[expect(clippy::unnecessary_wraps, reason = "listening can fail elsewhere")]
fn survive_file_size_limit() -> io::Result<()> {
    Ok(())
}

/// Raises the limit on open files to the largest value that the system allows, and returns it;
/// `None` where the system has or reports no limit. Every connection is an open file.
#[cfg(unix)]
pub fn raise_file_limit() -> Option<u64> {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    let limit = getrlimit(Resource::Nofile);
    let raised =
        setrlimit(Resource::Nofile, Rlimit { current: limit.maximum, maximum: limit.maximum });
    if raised.is_ok() { limit.maximum } else { limit.current }
}

#[cfg(not(unix))]
pub fn raise_file_limit() -> Option<u64> {
    None
}

#[cfg(unix)]
struct Signals {
    interrupt: tokio::signal::unix::Signal,
    terminate: tokio::signal::unix::Signal,
}

#[cfg(unix)]
impl Signals {
    fn new() -> io::Result<Self> {
        use tokio::signal::unix::{SignalKind, signal};
        Ok(Self {
            interrupt: signal(SignalKind::interrupt())?,
            terminate: signal(SignalKind::terminate())?,
        })
    }

    async fn next(&mut self) {
        tokio::select! { _ = self.interrupt.recv() => {}, _ = self.terminate.recv() => {} }
    }
}

#[cfg(not(unix))]
struct Signals;

#[cfg(not(unix))]
impl Signals {
    #[expect(clippy::unnecessary_wraps, reason = "listening can fail elsewhere")]
    fn new() -> io::Result<Self> {
        Ok(Self)
    }

    async fn next(&mut self) {
        let _ = tokio::signal::ctrl_c().await;
    }
}

/// SIGHUPs, by which a service is told to read its files again. Elsewhere than on Unix there are
/// none.
#[cfg(unix)]
pub struct Hangups(tokio::signal::unix::Signal);

#[cfg(unix)]
impl Hangups {
    /// Starts listening.
    ///
    /// # Errors
    /// If the signal cannot be listened to. Needs a Tokio runtime.
    pub fn new() -> io::Result<Self> {
        use tokio::signal::unix::{SignalKind, signal};
        signal(SignalKind::hangup()).map(Self)
    }

    /// Waits for the next signal; `false` if none can come.
    pub async fn next(&mut self) -> bool {
        self.0.recv().await.is_some()
    }
}

/// SIGHUPs, by which a service is told to read its files again. Elsewhere than on Unix there are
/// none.
#[cfg(not(unix))]
pub struct Hangups;

#[cfg(not(unix))]
#[expect(
    clippy::missing_errors_doc,
    clippy::unnecessary_wraps,
    reason = "listening can fail elsewhere"
)]
impl Hangups {
    /// Does nothing.
    pub fn new() -> io::Result<Self> {
        Ok(Self)
    }

    /// There is none.
    pub async fn next(&mut self) -> bool {
        false
    }
}
