//! Compressed texts that can be joined into one gzip stream without compressing again.
//!
//! Each text is a run of deflate blocks (RFC 1951) that ends at a byte boundary and refers to no
//! earlier text. Its checksum and length are stored beside it, because a gzip stream (RFC 1952)
//! ends with the checksum and length of the whole.
//!
//! ```text
//! offset   bytes   content
//! 0        1       1, the version of this form
//! 1        4       CRC-32 of the text, little-endian
//! 5        8       length of the text, little-endian
//! 13               deflate blocks, none of which is marked as the last
//! ```

use bytes::Bytes;
use crc32fast::Hasher;
use flate2::{Compress, Compression, Decompress, FlushCompress, FlushDecompress, Status};
use thiserror::Error;

const VERSION: u8 = 1;
const HEAD: usize = 13;

/// An empty block that is marked as the last, with fixed codes.
const LAST_BLOCK: [u8; 2] = [3, 0];

/// End of the empty block by which a flush is marked.
const FLUSHED: [u8; 4] = [0, 0, 0xff, 0xff];

/// The head of a gzip stream: deflate, no name, no time, unknown system.
const GZIP_HEAD: [u8; 10] = [0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 255];

/// Longest text \[bytes\] of one block that is stored as it is.
const MAX_STORED: usize = 0xffff;

/// Largest size \[bytes\] of an unpacked text; a damaged row could claim any.
pub const UNPACKED_LIMIT: u64 = 1 << 30;

/// An error for bytes that are not a compressed text.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("not a compressed text: {0}")]
pub struct DeflateError(&'static str);

/// A compressed text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Deflated(Bytes);

impl Deflated {
    /// Compresses a text.
    ///
    /// # Errors
    /// [`DeflateError`] if the compressor fails, which it does not.
    pub fn compress(text: &[u8]) -> Result<Self, DeflateError> {
        // One call compresses everything: a compressor that runs out of room during a flush needs
        // more text to end the flush.
        let mut packed = Vec::with_capacity(HEAD + longest(text.len()));
        head_of(text, &mut packed);
        let mut compress = Compress::new(Compression::fast(), false);
        compress
            .compress_vec(text, &mut packed, FlushCompress::Full)
            .map_err(|_| DeflateError("the compressor failed"))?;
        let is_whole = compress.total_in() == text.len() as u64 && packed.ends_with(&FLUSHED);
        if !is_whole {
            return Err(DeflateError("the compressor did not come to an end"));
        }
        packed.shrink_to_fit();
        Ok(Self(packed.into()))
    }

    /// Stores a short text without compression, for the JSON between two compressed texts.
    pub fn stored(text: &'static [u8]) -> Self {
        let text = &text[..text.len().min(MAX_STORED)];
        let mut packed = Vec::with_capacity(HEAD + 5 + text.len());
        head_of(text, &mut packed);
        #[expect(clippy::cast_possible_truncation, reason = "at most 0xffff")]
        let length = text.len() as u16;
        packed.push(0);
        packed.extend(length.to_le_bytes());
        packed.extend((!length).to_le_bytes());
        packed.extend_from_slice(text);
        Self(packed.into())
    }

    /// Parses the bytes of [`Deflated::into_bytes`]; `None` if they have another form.
    pub fn from_bytes(bytes: Bytes) -> Option<Self> {
        (bytes.len() >= HEAD && bytes[0] == VERSION).then_some(Self(bytes))
    }

    /// Returns the bytes to store.
    pub fn into_bytes(self) -> Bytes {
        self.0
    }

    /// Borrows the bytes to store.
    pub fn packed(&self) -> &[u8] {
        &self.0
    }

    /// Returns the CRC-32 of the text.
    fn crc(&self) -> u32 {
        self.0[1..5].try_into().map_or(0, u32::from_le_bytes)
    }

    /// Returns the length of the text \[bytes\].
    fn text_len(&self) -> u64 {
        self.0[5..HEAD].try_into().map_or(0, u64::from_le_bytes)
    }

    /// The text.
    ///
    /// # Errors
    /// [`DeflateError`] if the bytes are damaged.
    pub fn text(&self) -> Result<Bytes, DeflateError> {
        let length = Some(self.text_len()).filter(|length| *length <= UNPACKED_LIMIT);
        let length = length.and_then(|length| usize::try_from(length).ok());
        let length = length.ok_or(DeflateError("an impossible length"))?;
        let mut text = Vec::with_capacity(length);
        let mut decompress = Decompress::new(false);
        let damaged = |_| DeflateError("damaged blocks");
        decompress
            .decompress_vec(&self.0[HEAD..], &mut text, FlushDecompress::None)
            .map_err(damaged)?;
        // One spare byte shows whether the text is longer than its header says.
        text.reserve(1);
        let end = decompress
            .decompress_vec(&LAST_BLOCK, &mut text, FlushDecompress::Finish)
            .map_err(damaged)?;
        let is_whole = end == Status::StreamEnd
            && text.len() == length
            && crc32fast::hash(&text) == self.crc();
        if is_whole {
            Ok(text.into())
        } else {
            Err(DeflateError("the text is not the one that was compressed"))
        }
    }
}

/// Returns the largest compressed size of a text of this length: a fixed code takes up to nine
/// bits for eight.
const fn longest(length: usize) -> usize {
    length + length / 8 + 1024
}

fn head_of(text: &[u8], packed: &mut Vec<u8>) {
    packed.push(VERSION);
    packed.extend(crc32fast::hash(text).to_le_bytes());
    packed.extend((text.len() as u64).to_le_bytes());
}

/// Joins compressed texts into one gzip stream.
#[derive(Debug, Default)]
pub struct GzipStream {
    checksum: Hasher,
    length: u64,
}

impl GzipStream {
    /// Starts a stream and returns its first bytes.
    pub fn begin() -> (Self, Bytes) {
        (Self::default(), Bytes::from_static(&GZIP_HEAD))
    }

    /// Appends a text and returns its bytes of the stream.
    pub fn append(&mut self, text: &Deflated) -> Bytes {
        self.checksum.combine(&Hasher::new_with_initial_len(text.crc(), text.text_len()));
        self.length += text.text_len();
        text.0.slice(HEAD..)
    }

    /// Ends the stream and returns its last bytes.
    pub fn end(self) -> Bytes {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "the format wants the length modulo 2^32"
        )]
        let length = self.length as u32;
        [&LAST_BLOCK[..], &self.checksum.finalize().to_le_bytes(), &length.to_le_bytes()]
            .concat()
            .into()
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use flate2::read::GzDecoder;

    use super::*;

    fn texts() -> Vec<Vec<u8>> {
        let figures: Vec<String> =
            (0..40_000).map(|k| (f64::from(k) * 0.37).sin().to_string()).collect();
        let figures = figures.join(",");
        vec![Vec::new(), b"{}".to_vec(), vec![b' '; 200_000], figures.into_bytes()]
    }

    #[test]
    fn compressed_texts_read_back() {
        for text in texts() {
            let packed = Deflated::compress(&text).unwrap();
            assert_eq!(packed.text().unwrap(), text);
            assert_eq!(Deflated::from_bytes(packed.clone().into_bytes()), Some(packed));
        }
        assert!(Deflated::compress(&vec![b' '; 200_000]).unwrap().into_bytes().len() < 2000);
        assert_eq!(Deflated::stored(b",").text().unwrap(), ",");
    }

    /// Texts of many lengths exhaust the compressor's room at different places.
    #[test]
    fn texts_of_any_length_are_read_back() {
        let figures = texts().pop().unwrap();
        for length in (40_000..120_000).step_by(331) {
            let text = &figures[..length];
            assert!(Deflated::compress(text).unwrap().text().unwrap() == text, "{length} bytes");
        }
        // Nothing to compress.
        let mut seed = 1_u32;
        let noise: Vec<u8> = std::iter::repeat_with(|| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            seed.to_be_bytes()[0]
        })
        .take(300_000)
        .collect();
        for length in (0..noise.len()).step_by(7919) {
            let text = &noise[..length];
            assert!(
                Deflated::compress(text).unwrap().text().unwrap() == text,
                "{length} bytes of noise"
            );
        }
    }

    #[test]
    fn parts_make_one_gzip_stream() {
        let (mut stream, mut gzip) = {
            let (stream, begin) = GzipStream::begin();
            (stream, begin.to_vec())
        };
        let mut expected = Vec::new();
        for text in texts() {
            gzip.extend(stream.append(&Deflated::compress(&text).unwrap()));
            gzip.extend(stream.append(&Deflated::stored(b",")));
            expected.extend(text);
            expected.push(b',');
        }
        gzip.extend(stream.end());
        let mut read = Vec::new();
        // A decoder of one member, as browsers have it.
        GzDecoder::new(gzip.as_slice()).read_to_end(&mut read).unwrap();
        assert!(read == expected, "{} bytes for {}", read.len(), expected.len());
    }

    #[test]
    fn damage_is_an_error() {
        let packed = Deflated::compress(b"a text of some length, and then some more of it")
            .unwrap()
            .into_bytes();
        for place in 1..packed.len() {
            let mut spoilt = packed.to_vec();
            spoilt[place] ^= 0x55;
            let spoilt = Deflated::from_bytes(spoilt.into()).unwrap();
            assert!(spoilt.text().is_err() || place >= HEAD, "byte {place} of the head");
        }
        let cut = Deflated::from_bytes(packed.slice(..packed.len() - 8)).unwrap();
        assert!(cut.text().is_err());
        assert_eq!(Deflated::from_bytes(Bytes::from_static(b"not this")), None);
    }
}
