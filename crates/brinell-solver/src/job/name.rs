//! Names that people give: to a job, to a material. They change no figure.

use super::reader::Cursor;
use super::tags::check;

/// Longest name in characters.
pub const MAX_NAME: usize = 80;

/// Reads a name of 1 to [`MAX_NAME`] printable characters.
pub(super) fn read(cursor: Cursor<'_>) -> Option<String> {
    let name = cursor.text()?;
    check(cursor, "the name", name, 1, MAX_NAME).then(|| name.to_owned())
}
