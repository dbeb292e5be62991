//! Grey pictures of the Netpbm family: PGM as text (P2) and as bytes (P5).
//!
//! A head of words (the kind, width, height and the value of white, with comments from `#` to the end of a line) is
//! followed by one value a pixel, row by row from the top. In P5 a value takes one byte, or two with the higher one
//! first where white is above 255.
//!
//! The size in the head is compared with the bytes that are left before room is made for the pixels: a head that
//! claims a larger picture than its file can hold is refused.

use super::file::File;
use super::line_reader::{at, quoted};
use crate::error::{Error, Message};
use crate::scenario::MAX_CELLS;

/// A grey picture, row by row from the top.
/// `values` has width · height numbers from 0 (black) to `max`.
pub(super) struct Picture {
    /// Pixels in a row.
    pub(super) width: u32,
    /// Rows.
    pub(super) height: u32,
    /// The value of white.
    pub(super) max: u16,
    /// Lightness, the northern row first.
    pub(super) values: Vec<u16>,
}

/// Reads the first picture of a file; what follows it is ignored.
///
/// # Errors
/// Another kind of file, a number that is missing or out of range, too few bytes, or a value above white.
pub(super) fn read(file: File) -> Result<Picture, Error> {
    let mut text = Text { file, position: 2 };
    let as_text = match file.bytes.get(..2) {
        Some(b"P2") => true,
        Some(b"P5") => false,
        _ => return Err(at(file.name, 1, "must begin with P2 or P5")),
    };
    let width = text.number("width", 1, MAX_CELLS)?;
    let height = text.number("height", 1, MAX_CELLS)?;
    let max = text.number("largest value", 1, 65535)? as u16;
    let count = width as usize * height as usize;
    // A separator and a digit, but for the first; or one or two bytes.
    let least = if as_text { 2 * count } else { count * if max > 255 { 2 } else { 1 } + 1 };
    let left = file.bytes.len() - text.position;
    if left < least {
        return Err(text.error(message!(
            "must hold {} × {} values, only {} bytes are left",
            width,
            height,
            left
        )));
    }
    let values = if as_text {
        (0..count)
            .map(|_| text.number("value", 0, u32::from(max)).map(|v| v as u16))
            .collect::<Result<_, _>>()?
    } else {
        text.raw(least - 1, max)?
    };
    Ok(Picture { width, height, max, values })
}

/// The file as words, from `position` on.
struct Text<'a> {
    file: File<'a>,
    position: usize,
}

impl Text<'_> {
    /// An error that names the line of the present position.
    fn error(&self, message: impl Into<Message>) -> Error {
        let before = &self.file.bytes[..self.position];
        at(self.file.name, before.split(|&b| b == b'\n').count(), message)
    }

    /// The next byte, if there is one.
    fn peek(&self) -> Option<u8> {
        self.file.bytes.get(self.position).copied()
    }

    /// The next number after blanks and comments.
    ///
    /// # Errors
    /// No blank before it, no digits, or a value that is out of range.
    fn number(&mut self, name: &str, min: u32, max: u32) -> Result<u32, Error> {
        let before = self.position;
        while let Some(byte) = self.peek() {
            match byte {
                b'#' => {
                    while self.peek().is_some_and(|b| b != b'\n') {
                        self.position += 1;
                    }
                }
                _ if byte.is_ascii_whitespace() => self.position += 1,
                _ => break,
            }
        }
        let start = self.position;
        if start == before {
            return Err(self.error(message!("{} must follow a blank", name)));
        }
        let digits = self.file.bytes[start..].iter().take(12).take_while(|b| b.is_ascii_digit()).count();
        let value =
            self.file.bytes[start..start + digits].iter().fold(0_u64, |v, b| v * 10 + u64::from(b - b'0'));
        if digits == 0 || value < u64::from(min) || value > u64::from(max) {
            let rest = &self.file.bytes[start..];
            let word: Vec<u8> =
                rest.iter().copied().take(40).take_while(|b| !b.is_ascii_whitespace()).collect();
            let got = if rest.is_empty() {
                "the end of the file".to_owned()
            } else {
                quoted(&String::from_utf8_lossy(&word))
            };
            return Err(self.error(message!("{} must be {} to {}, got {}", name, min, max, got)));
        }
        self.position += digits;
        Ok(value as u32)
    }

    /// The values as bytes, one or two each, after a single blank.
    /// A head that was written with CRLF has two bytes there, which is told by the size of the rest.
    fn raw(&mut self, length: usize, max: u16) -> Result<Vec<u16>, Error> {
        if !self.peek().is_some_and(|b| b.is_ascii_whitespace()) {
            return Err(self.error("values must follow a blank"));
        }
        self.position += 1;
        // Written with CRLF in the head: the second byte is no value.
        let crlf = self.file.bytes[self.position - 1..].starts_with(b"\r\n");
        if crlf && self.file.bytes.len() > self.position + length {
            self.position += 1;
        }
        let bytes = &self.file.bytes[self.position..self.position + length];
        let values: Vec<u16> = if max > 255 {
            bytes.chunks_exact(2).map(|b| u16::from_be_bytes([b[0], b[1]])).collect()
        } else {
            bytes.iter().map(|&b| u16::from(b)).collect()
        };
        match values.iter().position(|&v| v > max) {
            Some(index) => {
                Err(self.error(message!("values must be 0 to {}, got {} at {}", max, values[index], index)))
            }
            None => Ok(values),
        }
    }
}
