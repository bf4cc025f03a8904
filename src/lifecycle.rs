//! When to stop.

use std::io;

use tokio_util::sync::CancellationToken;

/// Exit code after a second signal: the shell's for an interrupted program.
const INTERRUPTED: i32 = 130;

/// A token that the first SIGTERM or SIGINT cancels. The second ends the process at once.
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

/// Cancels `stop` when standard input is closed, as it is when the process at its other end has
/// ended, even by SIGKILL.
///
/// # Errors
/// If there can be no thread to read it.
pub fn stop_with_stdin(stop: CancellationToken) -> io::Result<()> {
    let read = move || {
        // Input that cannot be read has ended too.
        let _ = io::copy(&mut io::stdin().lock(), &mut io::sink());
        tracing::info!("standard input is closed: stopping");
        stop.cancel();
    };
    std::thread::Builder::new().name("stdin".to_owned()).spawn(read)?;
    Ok(())
}

/// Signal of a write beyond the process's limit on the size of a file (`ulimit -f`), on Linux and
/// the BSDs.
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

/// Raises the number of files that this process may have open to what the system allows, and
/// returns it; `None` where there is no such bound or it is not told. Connections are files as
/// well.
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
    /// Listens to them.
    ///
    /// # Errors
    /// If the signal cannot be listened to. Needs a Tokio runtime.
    pub fn new() -> io::Result<Self> {
        use tokio::signal::unix::{SignalKind, signal};
        signal(SignalKind::hangup()).map(Self)
    }

    /// Waits for the next; `false` if there will be none.
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
    /// Listens to none.
    pub fn new() -> io::Result<Self> {
        Ok(Self)
    }

    /// There is none.
    pub async fn next(&mut self) -> bool {
        false
    }
}
