//! Heights as a two-dimensional array in numpy's file format, encoded in Base64.
//!
//! The header is a Python dictionary with three keys in any order. The reader parses no other
//! Python.
//!
//! # Reference
//! numpy.lib.format, versions 1 to 3.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::reader::text::Quoted;

const MAGIC: &[u8] = b"\x93NUMPY";

/// The figures of an array, `[i * shape[1] + j]`.
pub(super) struct Grid {
    pub shape: [usize; 2],
    pub values: Vec<f64>,
}

/// Reads an array of at most `most` figures.
///
/// # Errors
/// The fault, as the end of a sentence.
pub(super) fn read(text: &str, most: usize) -> Result<Grid, String> {
    let bytes = STANDARD.decode(text).map_err(|error| format!("must be Base64: {error}"))?;
    let rest = bytes.strip_prefix(MAGIC).ok_or("must be an array as numpy.save writes it")?;
    let cut = || "ends before its header does".to_owned();
    let (version, rest) = rest.split_at_checked(2).ok_or_else(cut)?;
    let digits = match version[0] {
        1 => 2,
        2 | 3 => 4,
        other => return Err(format!("must be of version 1 to 3 of the format, not {other}")),
    };
    let (length, rest) = rest.split_at_checked(digits).ok_or_else(cut)?;
    let length = length.iter().rev().fold(0_usize, |sum, byte| sum << 8 | usize::from(*byte));
    let (header, data) = rest.split_at_checked(length).ok_or_else(cut)?;
    let header = std::str::from_utf8(header).map_err(|_| "has a header that is no text")?;

    let Header { kind, by_columns, shape } = Header::parse(header).ok_or_else(|| {
        format!("must have a header as numpy.save writes it, not {}", Quoted(header))
    })?;
    let size = match kind {
        "<f8" => 8,
        "<f4" => 4,
        _ => {
            let kind = Quoted(kind);
            return Err(format!(
                "must be of little-endian floats, \"<f8\" or \"<f4\", not {kind}"
            ));
        }
    };
    let Ok([rows, columns]) = <[usize; 2]>::try_from(shape.as_slice()) else {
        return Err(format!("must have two dimensions, not {}", shape.len()));
    };
    let count = rows.checked_mul(columns).filter(|count| *count <= most);
    let count = count.ok_or_else(|| format!("must have at most {most} heights"))?;
    if data.len() != size * count {
        return Err(format!("must have {} bytes of data, not {}", size * count, data.len()));
    }
    let figure = |k: usize| {
        let bytes = &data[size * k..size * (k + 1)];
        match <[u8; 8]>::try_from(bytes) {
            Ok(bytes) => f64::from_le_bytes(bytes),
            Err(_) => f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
        }
    };
    let at = |k: usize| if by_columns { k % columns * rows + k / columns } else { k };
    Ok(Grid { shape: [rows, columns], values: (0..count).map(|k| figure(at(k))).collect() })
}

/// The dictionary of the header.
#[derive(Default)]
struct Header<'a> {
    kind: &'a str,
    by_columns: bool,
    shape: Vec<usize>,
}

impl<'a> Header<'a> {
    /// Reads the three entries in any order. Returns `None` for any other text.
    fn parse(header: &'a str) -> Option<Self> {
        let mut rest = header.trim().strip_prefix('{')?.strip_suffix('}')?.trim();
        let mut keys = Vec::new();
        let mut found = Self::default();
        while !rest.is_empty() {
            let (key, behind) = quoted(rest)?;
            let value = behind.trim_start().strip_prefix(':')?.trim_start();
            rest = match key {
                "descr" => {
                    let (kind, behind) = quoted(value)?;
                    found.kind = kind;
                    behind
                }
                "fortran_order" => {
                    found.by_columns = value.starts_with("True");
                    value.strip_prefix(if found.by_columns { "True" } else { "False" })?
                }
                "shape" => {
                    let (sides, behind) = value.strip_prefix('(')?.split_once(')')?;
                    let sides = sides.trim().trim_end_matches(',').split(',').map(str::trim);
                    let is_number = |side: &&str| side.bytes().all(|byte| byte.is_ascii_digit());
                    let side = |side: &str| Some(side).filter(is_number)?.parse().ok();
                    found.shape = sides.map(side).collect::<Option<_>>()?;
                    behind
                }
                _ => return None,
            };
            keys.push(key);
            rest = rest.trim_start();
            rest = if rest.is_empty() { rest } else { rest.strip_prefix(',')?.trim_start() };
        }
        keys.sort_unstable();
        (keys == ["descr", "fortran_order", "shape"]).then_some(found)
    }
}

/// Splits a text after the quoted string at its beginning.
fn quoted(text: &str) -> Option<(&str, &str)> {
    let quote = text.chars().next().filter(|first| matches!(first, '\'' | '"'))?;
    text[1..].split_once(quote)
}
