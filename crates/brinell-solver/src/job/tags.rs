//! Free labels: few, short and printable, so that any program can store, search and repeat them.

use std::collections::BTreeMap;

use super::FaultCode;
use super::reader::Cursor;

/// Most tags of a job.
pub const MAX_TAGS: usize = 32;
/// Longest key in characters.
pub const MAX_KEY: usize = 64;
/// Longest value in characters.
pub const MAX_VALUE: usize = 256;

pub(super) fn read(cursor: Cursor<'_>) -> Option<BTreeMap<String, String>> {
    let object = cursor.object()?;
    if object.len() > MAX_TAGS {
        object.fault_here(
            FaultCode::WrongLength,
            format_args!("must have at most {MAX_TAGS} tags, got {}", object.len()),
        );
        return None;
    }
    let mut tags = BTreeMap::new();
    let mut all_good = true;
    object.each(|key, cursor| {
        let key_is_good = check(cursor, "the key", key, 1, MAX_KEY);
        match cursor.text().filter(|value| check(cursor, "the value", value, 0, MAX_VALUE)) {
            Some(value) if key_is_good => drop(tags.insert(key.to_owned(), value.to_owned())),
            _ => all_good = false,
        }
    });
    all_good.then_some(tags)
}

pub(super) fn check(
    cursor: Cursor<'_>,
    what: &str,
    text: &str,
    least: usize,
    most: usize,
) -> bool {
    let length = text.chars().count();
    let fits = (least..=most).contains(&length);
    if !fits {
        cursor.fault(
            FaultCode::WrongLength,
            format_args!("{what} must have between {least} and {most} characters, got {length}"),
        );
    }
    let printable = !text.chars().any(char::is_control);
    if !printable {
        cursor.fault(
            FaultCode::Inconsistent,
            format_args!("{what} must not contain control characters"),
        );
    }
    fits && printable
}
