//! Runs of cells as text, two characters for most: maps of millions of cells stay small and are read quickly.
//!
//! Two numbers per run, ascending and apart: the cells between it and the one before, and its own. Cells are counted
//! row by row from the south-west on a lattice of 4096 columns, whatever the map's width. A number is written five bits
//! a digit, the lowest first, with Base64's digits, to which 32 is added when another one follows.
//!
//! Example: the runs of three cells at (2, 0) and of forty at (2, 1) are `CD9/DoB`: a gap of 2, 3 cells, a gap of
//! 4093, 40 cells. A number below 32 takes one character, one below 1024 two. A map of large rooms takes two or three
//! characters a run, where JSON takes ten and an array of numbers costs an allocation.
//!
//! The reader refuses a text that is broken, with the place of the character: runs that pass the end of their row or
//! the last row, numbers that are too large, and characters that are no digits.

use super::MAX_CELLS;
use crate::error::{Error, Message};
use crate::json;

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Runs in order, written as text.
/// The runs must be sorted by row, then by column, and lie apart; no run passes the end of a row.
///
/// ```
/// use parkade::scenario::run_length::pack;
///
/// assert_eq!(pack(&[[2, 0, 3], [2, 1, 40]]), "CD9/DoB");
/// ```
pub fn pack(runs: &[[u32; 3]]) -> String {
    let mut text = String::new();
    let mut number = |mut n: u32| {
        loop {
            let more = u32::from(n > 31) << 5;
            text.push(char::from(DIGITS[(n & 31 | more) as usize]));
            n >>= 5;
            if n == 0 {
                break;
            }
        }
    };
    let mut at = 0;
    for &[x, y, count] in runs {
        let start = y * MAX_CELLS + x;
        number(start - at);
        number(count);
        at = start + count;
    }
    text
}

/// The runs that a text stands for.
/// Inverse of [`pack`]. O(characters).
pub(super) fn unpack(text: &str) -> Result<Vec<[u32; 3]>, Error> {
    let mut runs = Vec::with_capacity(text.len() / 2);
    let (mut value, mut shift, mut gap, mut at) = (0_u32, 0, None, 0_u32);
    for (i, byte) in text.bytes().enumerate() {
        let bad = |what: Message| json::bad("", message!("character {}: {}", i + 1, what));
        let digit = match byte {
            b'A'..=b'Z' => byte - b'A',
            b'a'..=b'z' => byte - b'a' + 26,
            b'0'..=b'9' => byte - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return bad("must be a digit of Base64".into()),
        };
        value |= u32::from(digit & 31) << shift;
        if digit > 31 {
            shift += 5;
            if shift > 20 {
                return bad("must end a number of at most 25 bits".into());
            }
            continue;
        }
        match gap.take() {
            None => gap = Some(value),
            Some(gap) => {
                let start = at + gap;
                let [x, y] = [start % MAX_CELLS, start / MAX_CELLS];
                if y >= MAX_CELLS || value == 0 || x + value > MAX_CELLS {
                    return bad(message!(
                        "must be a run inside a row, got {} cells at ({}, {})",
                        value,
                        x,
                        y
                    ));
                }
                runs.push([x, y, value]);
                at = start + value;
            }
        }
        (value, shift) = (0, 0);
    }
    if gap.is_some() || shift > 0 {
        return json::bad("", "must be a list of runs or text that ends with a whole run".into());
    }
    Ok(runs)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_survive_packing() {
        let all: [&[[u32; 3]]; 4] = [
            &[],
            &[[0, 0, 1], [1, 0, 1], [4095, 0, 1], [0, 1, 4096], [7, 4095, 4089]],
            &[[31, 0, 32], [1055, 0, 1024]],
            &[[0, 4095, 4096]],
        ];
        for runs in all {
            assert_eq!(unpack(&pack(runs)).unwrap(), runs);
        }
        assert_eq!(pack(&[[2, 0, 3], [2, 1, 40]]), "CD9/DoB");
    }

    #[test]
    fn broken_text_is_named_by_its_character() {
        let cases = [
            ("C", "must be a list of runs or text that ends with a whole run"),
            ("CDg", "must be a list of runs or text that ends with a whole run"),
            ("C-", "character 2: must be a digit of Base64"),
            ("CA", "character 2: must be a run inside a row, got 0 cells at (2, 0)"),
            ("BggE", "character 4: must be a run inside a row, got 4096 cells at (1, 0)"),
            ("gggggB", "character 5: must end a number of at most 25 bits"),
            ("///////////", "character 5: must end a number"),
            ("ggggfB", "character 6: must be a run inside a row"),
        ];
        for (text, message) in cases {
            let error = unpack(text).unwrap_err().to_string();
            assert!(error.starts_with(message), "{text}: {error}");
        }
    }
}
