//! A file to import, and what its name tells.

use crate::error::{Error, ErrorCode};

/// Largest file that is read, bytes: room for the largest map, 4096 × 4096 cells, as decimal numbers.
pub const MAX_BYTES: usize = 80_000_000;

/// A file to import.
#[derive(Debug, Clone, Copy)]
pub struct File<'a> {
    /// Its name, with or without folders; its ending names its format.
    pub name: &'a str,
    /// Contents.
    pub bytes: &'a [u8],
}

/// True if the file's name ends in one of these, in small letters or capitals.
pub(super) fn has(file: &File, endings: &[&str]) -> bool {
    ending(file.name).is_some_and(|e| endings.contains(&e.as_str()))
}

/// What follows the last dot of a name, in small letters.
pub(super) fn ending(name: &str) -> Option<String> {
    name.rsplit_once('.').map(|(_, e)| e.to_ascii_lowercase())
}

/// A file's name without its folders.
pub(super) fn base(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name)
}

/// A file's name without folders and endings.
pub(super) fn stem(name: &str) -> &str {
    let base = base(name);
    base.split_once('.').map_or(base, |(stem, _)| stem)
}

/// The only file with one of these endings, if there is any.
///
/// # Errors
/// A second file of the same kind: which of them is meant would be a guess.
pub(super) fn the_one<'a>(files: &[File<'a>], endings: &[&str]) -> Result<Option<File<'a>>, Error> {
    let mut fitting = files.iter().filter(|f| has(f, endings));
    let first = fitting.next().copied();
    match fitting.next() {
        Some(second) => {
            let rule = message!("must be the only .{} file", endings[0]);
            Err(Error::new(ErrorCode::Import, second.name, rule))
        }
        None => Ok(first),
    }
}
