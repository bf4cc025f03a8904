//! A two-dimensional array of numpy's file format, in Base64: heights as numbers, not as text.
//!
//! The header is the dictionary that numpy writes, with its three keys in any order; Python is not
//! parsed beyond it.
//!
//! # Reference
//! numpy.lib.format, versions 1 to 3.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

const MAGIC: &[u8] = b"\x93NUMPY";

/// Figures `[i * shape[1] + j]`.
pub(super) struct Grid {
    pub shape: [usize; 2],
    pub values: Vec<f64>,
}

/// Reads an array of at most so many figures.
///
/// # Errors
/// What is wrong with it, as the end of a sentence.
pub(super) fn read(text: &str, most: usize) -> Result<Grid, String> {
    let bytes = STANDARD.decode(text).map_err(|error| format!("must be Base64: {error}"))?;
    let rest = bytes.strip_prefix(MAGIC).ok_or("must be an array as numpy.save writes it")?;
    let cut = || "ends before its header does".to_owned();
    let (version, rest) = rest.split_at_checked(2).ok_or_else(cut)?;
    let digits = if version[0] == 1 { 2 } else { 4 };
    let (length, rest) = rest.split_at_checked(digits).ok_or_else(cut)?;
    let length = length.iter().rev().fold(0_usize, |sum, byte| sum << 8 | usize::from(*byte));
    let (header, data) = rest.split_at_checked(length).ok_or_else(cut)?;
    let header = std::str::from_utf8(header).map_err(|_| "has a header that is no text")?;

    let kind = entry(header, "descr").unwrap_or_default().trim_matches(['\'', '"']);
    let size = match kind {
        "<f8" => 8,
        "<f4" => 4,
        _ => return Err(format!("must be of little-endian floats, `<f8` or `<f4`, not `{kind}`")),
    };
    let shape = entry(header, "shape").unwrap_or_default();
    let sides = shape.trim_matches(['(', ')']).split(',').map(str::trim);
    let sides: Option<Vec<usize>> =
        sides.filter(|side| !side.is_empty()).map(|side| side.parse().ok()).collect();
    let Some([rows, columns]) = sides.and_then(|sides| <[usize; 2]>::try_from(sides).ok()) else {
        return Err(format!("must have two dimensions, not the shape `{shape}`"));
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
    let by_columns = entry(header, "fortran_order") == Some("True");
    let at = |k: usize| if by_columns { k % columns * rows + k / columns } else { k };
    Ok(Grid { shape: [rows, columns], values: (0..count).map(|k| figure(at(k))).collect() })
}

/// What stands behind a key of the header, without the blanks around it.
fn entry<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let quoted = ['\'', '"'].map(|quote| format!("{quote}{key}{quote}"));
    let (at, key) = quoted.iter().find_map(|key| Some((header.find(key)?, key)))?;
    let value = header[at + key.len()..].trim_start().strip_prefix(':')?.trim_start();
    let end =
        if value.starts_with('(') { value.find(')')? + 1 } else { value.find([',', '}'])? };
    Some(value[..end].trim_end())
}
