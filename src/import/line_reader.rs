//! A text file line by line, with errors that name the line.
//!
//! The reader works on bytes, because a file may claim to be text and not be. A line becomes text only when words are
//! read from it, and only up to an ordinary length, so that a binary file is refused at its first long line. A
//! byte-order mark at the beginning is skipped.

use std::str::FromStr;

use super::file::File;
use crate::error::{Error, ErrorCode, Message};

/// Longest line of words, bytes.
const LONGEST: usize = 1000;

/// A line of a file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    file: &'a str,
    /// From 1.
    pub(super) number: usize,
    /// Without its end; not always UTF-8.
    pub(super) bytes: &'a [u8],
}

/// Lines that end in LF or CRLF.
pub(super) struct Lines<'a> {
    file: &'a str,
    rest: &'a [u8],
    number: usize,
}

impl<'a> Lines<'a> {
    /// The lines of a file from its first one on.
    pub(super) fn new(file: File<'a>) -> Self {
        let bytes = file.bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(file.bytes);
        Self { file: file.name, rest: bytes, number: 0 }
    }

    /// The next line that must be there.
    pub(super) fn need(&mut self, what: &str) -> Result<Line<'a>, Error> {
        let number = self.number + 1;
        self.next()
            .ok_or_else(|| at(self.file, number, message!("must be {}, got the end of the file", what)))
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|&b| b == b'\n');
        let (line, rest) = match end {
            Some(end) => (&self.rest[..end], &self.rest[end + 1..]),
            None => (self.rest, &[][..]),
        };
        self.rest = rest;
        self.number += 1;
        let bytes = line.strip_suffix(b"\r").unwrap_or(line);
        Some(Line { file: self.file, number: self.number, bytes })
    }
}

impl<'a> Line<'a> {
    /// An error that names this line.
    pub(super) fn error(&self, message: impl Into<Message>) -> Error {
        at(self.file, self.number, message)
    }

    /// The line as words are read from it: no format has lines as long as a file of junk may be.
    ///
    /// # Errors
    /// A line that is too long, or bytes that are not UTF-8.
    pub(super) fn text(&self) -> Result<&'a str, Error> {
        if self.bytes.len() > LONGEST {
            return Err(self.error(message!(
                "must have at most {} bytes, got {}",
                LONGEST,
                self.bytes.len()
            )));
        }
        std::str::from_utf8(self.bytes).map_err(|_| self.error("must be text"))
    }

    /// True if the line has nothing but white space; such lines may end a file.
    pub(super) fn is_blank(&self) -> bool {
        self.bytes.iter().all(u8::is_ascii_whitespace)
    }

    /// A number in one of the line's fields.
    pub(super) fn number<T: FromStr>(&self, name: &str, text: &str, what: &str) -> Result<T, Error> {
        text.parse().map_err(|_| self.error(message!("{} must be {}, got {}", name, what, quoted(text))))
    }
}

/// An error about a line.
pub(super) fn at(file: &str, line: usize, message: impl Into<Message>) -> Error {
    Error::new(ErrorCode::Import, format!("{file}:{line}"), message)
}

/// Quotes a file's text, shortened for a message.
/// Control characters are escaped, so that a message stays on one line.
pub(super) fn quoted(text: &str) -> String {
    if text.chars().count() <= 40 {
        return format!("{text:?}");
    }
    format!("{:?}…", text.chars().take(40).collect::<String>())
}
