//! Syncs the write-ahead log to the disk, once for all commits that wait for it.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use tokio::sync::Mutex;
use tokio::task::spawn_blocking;

/// The write-ahead log of a database whose commits are not synced by themselves.
///
/// A checkpoint syncs the log before it overwrites a page of the database, and the database before
/// it starts the log anew (`synchronous = NORMAL`). Hence everything committed before
/// [`WalSync::sync`] began is on the disk when it returns, either in the log or in the database.
pub(super) struct WalSync {
    file: Arc<File>,
    /// Calls so far.
    requested: AtomicU64,
    /// The number of calls that the last sync covered.
    synced: Mutex<u64>,
}

/// The log of the database at a path.
pub(super) fn path(database: &Path) -> PathBuf {
    let mut name = database.as_os_str().to_owned();
    name.push("-wal");
    name.into()
}

impl WalSync {
    /// The log of the database at `path`, which is open: the log then exists until the last
    /// connection closes.
    pub(super) async fn open(path: &Path) -> io::Result<Self> {
        let name = self::path(path);
        let open = move || File::options().create(true).append(true).open(name);
        let file = spawn_blocking(open).await.map_err(io::Error::other)??;
        Ok(Self { file: Arc::new(file), requested: AtomicU64::new(0), synced: Mutex::new(0) })
    }

    /// Returns once everything committed before the call is on the disk.
    pub(super) async fn sync(&self) -> io::Result<()> {
        let ticket = self.requested.fetch_add(1, Ordering::AcqRel) + 1;
        let mut synced = self.synced.lock().await;
        if *synced >= ticket {
            return Ok(());
        }
        let covered = self.requested.load(Ordering::Acquire);
        let file = Arc::clone(&self.file);
        spawn_blocking(move || file.sync_data()).await.map_err(io::Error::other)??;
        *synced = covered;
        Ok(())
    }
}
