//! `GET /guide/`: the guide, a folder that `scripts/site.sh` makes of the documents.
//!
//! The folder is read once, at the start: a request names an entry of a table and no file of the
//! machine. Every page may run the scripts that stood in it then, by their digests, and no others.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::Arc;
use std::{fs, io};

use axum::extract::State;
use axum::http::{HeaderMap, Uri};
use axum::response::{Redirect, Response};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use bytes::Bytes;
use sha2::{Digest as _, Sha256};

use super::problem::Problem;
use super::problem_type::ProblemType;
use super::static_file::{Sent, answer};

/// What a file may load, without its own scripts.
const POLICY: &str = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; \
                      object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors \
                      'self'; script-src 'self'";

/// The files of the guide by their paths below `/guide/`.
#[derive(Debug, Default)]
pub struct Guide(HashMap<String, File>);

#[derive(Debug)]
struct File {
    data: Bytes,
    digest: u128,
    policy: String,
}

impl Guide {
    /// Reads all files of a folder.
    ///
    /// # Errors
    /// If the folder or a file in it cannot be read.
    pub fn read(folder: &Path) -> io::Result<Self> {
        let mut guide = Self::default();
        guide.take(folder, "")?;
        Ok(guide)
    }

    /// Whether there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn take(&mut self, folder: &Path, above: &str) -> io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if path.is_dir() {
                self.take(&path, &format!("{above}{name}/"))?;
            } else {
                self.0.insert(format!("{above}{name}"), File::new(fs::read(&path)?.into()));
            }
        }
        Ok(())
    }
}

impl File {
    fn new(data: Bytes) -> Self {
        let whole: [u8; 32] = Sha256::digest(&data).into();
        let digest = whole.first_chunk().copied().map_or(0, u128::from_be_bytes);
        let policy = policy(&String::from_utf8_lossy(&data));
        Self { data, digest, policy }
    }
}

/// The policy of a page, with the digest of each script that stands in it.
fn policy(page: &str) -> String {
    let scripts = page.split("<script").skip(1).filter_map(|rest| {
        let (attributes, rest) = rest.split_once('>')?;
        let (script, _) = rest.split_once("</script>")?;
        (!attributes.contains("src=")).then_some(script)
    });
    scripts.fold(POLICY.to_owned(), |mut policy, script| {
        let _ = write!(policy, " 'sha256-{}'", STANDARD.encode(Sha256::digest(script)));
        policy
    })
}

/// `GET /guide`: addresses in the guide are relative to `/guide/`.
pub(super) async fn to_guide() -> Redirect {
    Redirect::permanent("guide/")
}

/// `GET /guide/` and `GET /guide/{path}`. Names of the guide's files need no escapes.
pub(super) async fn file(
    State(guide): State<Arc<Guide>>,
    uri: Uri,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let mut path = uri.path().trim_start_matches("/guide/").to_owned();
    if path.is_empty() || path.ends_with('/') {
        path.push_str("index.html");
    }
    let file = guide.0.get(&path).ok_or_else(|| nothing(&guide))?;
    let File { data, digest, policy } = file;
    let sent = Sent { path: &path, data: data.clone(), digest: *digest, kept: "no-cache", policy };
    answer(sent, &headers)
}

fn nothing(guide: &Guide) -> Problem {
    let detail = if guide.is_empty() {
        "this service has no guide: scripts/site.sh makes one, --guide FOLDER serves it"
    } else {
        "the guide has no such page"
    };
    Problem::new(ProblemType::NotFound, detail)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_may_run_the_scripts_that_stand_in_it() {
        assert_eq!(policy("<p>no script</p>"), POLICY);
        let page = "<script src=\"a.js\"></script><script>alert(1)</script>";
        // printf 'alert(1)' | openssl dgst -sha256 -binary | base64
        let digest = "bhHHL3z2vDgxUt0W3dWQOrprscmda2Y5pLsLg4GF+pI=";
        assert_eq!(policy(page), format!("{POLICY} 'sha256-{digest}'"));
    }
}
