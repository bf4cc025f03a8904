//! Room on the disk.

use std::path::{Path, PathBuf};

/// The file system of a database, and how much of it is reserved.
pub(super) struct FreeSpace {
    directory: PathBuf,
    /// Bytes kept free for the results of jobs that are accepted already.
    reserve: u64,
}

impl FreeSpace {
    pub(super) fn new(database: &Path, reserve: u64) -> Self {
        Self { directory: database.parent().unwrap_or(Path::new(".")).to_owned(), reserve }
    }

    /// Whether less than the reserve is free, `reusable` bytes within the database included. Where
    /// the system does not tell, there is room.
    pub(super) fn is_low(&self, reusable: u64) -> bool {
        free_bytes(&self.directory)
            .is_some_and(|free| free.saturating_add(reusable) < self.reserve)
    }
}

/// Bytes that this process may still write to a file system; `None` where the system does not
/// tell.
#[cfg(unix)]
fn free_bytes(directory: &Path) -> Option<u64> {
    let statistics = rustix::fs::statvfs(directory).ok()?;
    Some(statistics.f_bavail.saturating_mul(statistics.f_frsize))
}

#[cfg(not(unix))]
fn free_bytes(_: &Path) -> Option<u64> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn free_space_is_held_against_the_reserve() {
        let database = Path::new(env!("CARGO_MANIFEST_DIR")).join("brinell.db");
        assert!(!FreeSpace::new(&database, 0).is_low(0));
        assert!(FreeSpace::new(&database, u64::MAX).is_low(0));
        assert!(!FreeSpace::new(&database, u64::MAX).is_low(u64::MAX));
        assert!(!FreeSpace::new(Path::new("/no/such/directory/brinell.db"), u64::MAX).is_low(0));
    }
}
