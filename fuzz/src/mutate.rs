//! Files that are almost right.

use serde_json::{Value, json};

use crate::random::Random;

/// Words that numbers, ends and brackets are replaced by.
const WORDS: &[&str] = &[
    "0",
    "-1",
    "1",
    "4096",
    "4097",
    "65536",
    "4294967295",
    "4294967296",
    "-9223372036854775808",
    "1e9",
    "1e308",
    "-1e308",
    "1e-320",
    "0.1",
    "NaN",
    "inf",
    "null",
    "true",
    "\"\"",
    "[]",
    "{}",
    "{",
    "]",
    ",",
    ":",
    "#",
    "\r\n",
    "\n\n",
    "\t",
    "\u{0}",
    "\u{feff}",
    "🚗",
];

/// A value with one of its parts, at any depth, replaced by a number or by another of its parts.
pub(crate) fn altered(r: &mut Random, value: &mut Value, whole: &Value) {
    let inner = match value {
        Value::Array(list) if !list.is_empty() => {
            let at = r.below(list.len());
            if r.one_in(12) {
                list.remove(at);
                return;
            }
            list.get_mut(at)
        }
        Value::Object(fields) if !fields.is_empty() => {
            let name = fields.keys().nth(r.below(fields.len())).cloned().unwrap_or_default();
            if r.one_in(20) {
                fields.remove(&name);
                return;
            }
            fields.get_mut(&name)
        }
        _ => None,
    };
    match inner {
        Some(inner) if !r.one_in(8) => altered(r, inner, whole),
        _ => {
            *value = match (r.below(6), value.as_f64()) {
                (0, _) => part(r, whole).clone(),
                (1, _) => r
                    .pick(&[
                        json!(-1),
                        json!(1e300),
                        json!(null),
                        json!("?"),
                        json!(4097),
                        json!([]),
                        json!({}),
                    ])
                    .clone(),
                (2 | 3, Some(n)) => json!(n * r.between(-1.0, 3.0)),
                (_, Some(n)) => json!(n + r.between(-2.0, 2.0)),
                _ => json!(r.between(-40.0, 40.0).round()),
            }
        }
    }
}

/// Some part of a value.
fn part<'a>(r: &mut Random, value: &'a Value) -> &'a Value {
    let inner = match value {
        Value::Array(list) if !list.is_empty() => list.get(r.below(list.len())),
        Value::Object(fields) if !fields.is_empty() => fields.values().nth(r.below(fields.len())),
        _ => None,
    };
    match inner {
        Some(inner) if !r.one_in(4) => part(r, inner),
        _ => value,
    }
}

/// The text with up to three spots damaged.
pub(crate) fn mutated(r: &mut Random, text: &[u8]) -> Vec<u8> {
    let mut bytes = text.to_vec();
    for _ in 0..r.below(4) {
        if bytes.is_empty() {
            break;
        }
        let at = r.below(bytes.len());
        match r.below(8) {
            0 => bytes[at] ^= 1 << r.below(8),
            1 => bytes.truncate(at),
            2 => drop(bytes.remove(at)),
            3 => {
                let end = at + r.below((bytes.len() - at).min(40) + 1);
                let copy = bytes[at..end].to_vec();
                let to = r.below(bytes.len());
                bytes.splice(to..to, copy);
            }
            4 => {
                let end = at + r.below((bytes.len() - at).min(40) + 1);
                bytes.drain(at..end);
            }
            5 => {
                let word = *r.pick(WORDS);
                bytes.splice(at..at, word.bytes());
            }
            _ => {
                // A whole number at once: what sizes and coordinates are.
                let digit = |byte: &u8| byte.is_ascii_digit() || b".-+e".contains(byte);
                let Some(from) = bytes[at..].iter().position(digit).map(|n| at + n) else { continue };
                let to = bytes[from..].iter().position(|byte| !digit(byte)).map_or(bytes.len(), |n| from + n);
                let word = *r.pick(WORDS);
                bytes.splice(from..to, word.bytes());
            }
        }
    }
    bytes
}
