//! Whether a file that is open is still the one of its name.

use std::fs::Metadata;
use std::io;
use std::path::{Path, PathBuf};

/// A file that was there when it was opened. Once it has been removed or replaced, what is written
/// to it is lost with the process.
#[derive(Debug)]
pub(super) struct OwnFile {
    path: PathBuf,
    identity: [u64; 2],
}

impl OwnFile {
    /// The file of this name, which is open.
    pub(super) fn new(path: &Path) -> io::Result<Self> {
        Ok(Self { identity: identity(&path.metadata()?), path: path.to_owned() })
    }

    /// Fails if another file has its name now, or none.
    pub(super) fn check(&self) -> io::Result<()> {
        let now = self.path.metadata().map(|metadata| identity(&metadata));
        match now {
            Ok(now) if now == self.identity => Ok(()),
            Ok(_) => Err(io::Error::other(format!(
                "{} was replaced while it was open",
                self.path.display()
            ))),
            Err(error) => {
                Err(io::Error::new(error.kind(), format!("{}: {error}", self.path.display())))
            }
        }
    }
}

/// Device and number of a file; where the system has none, all are alike.
#[cfg(unix)]
fn identity(metadata: &Metadata) -> [u64; 2] {
    use std::os::unix::fs::MetadataExt as _;
    [metadata.dev(), metadata.ino()]
}

#[cfg(not(unix))]
fn identity(_: &Metadata) -> [u64; 2] {
    [0; 2]
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_file_that_is_removed_or_replaced_is_not_the_one_that_was_opened() {
        let path = std::env::temp_dir().join(format!("brinell-own-file-{}", std::process::id()));
        let open = fs::File::create(&path).unwrap();
        let own = OwnFile::new(&path).unwrap();
        own.check().unwrap();
        fs::remove_file(&path).unwrap();
        assert_eq!(own.check().unwrap_err().kind(), io::ErrorKind::NotFound);
        fs::write(&path, "another").unwrap();
        assert!(own.check().unwrap_err().to_string().contains("replaced"));
        fs::remove_file(&path).unwrap();
        drop(open);
    }
}
