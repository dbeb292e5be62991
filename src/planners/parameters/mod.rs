//! The planners' settings for people: range, unit, name and one line of why.

use serde_json::{Map, Value};

mod grid;
mod hybrid;
#[cfg(feature = "complete")]
mod road;

#[cfg(feature = "complete")]
pub(in crate::planners) use grid::{BIDIRECTIONAL, JUMP_POINT};
pub(in crate::planners) use grid::{GRID, GRID_HEURISTICS, RISK};
pub(in crate::planners) use hybrid::HYBRID;
#[cfg(feature = "complete")]
pub(in crate::planners) use road::ROAD;

use super::registry::{Parameter, Text};

#[derive(Clone, Copy)]
pub(in crate::planners) struct Row {
    name: &'static str,
    form: Form,
    unit: &'static str,
    basic: bool,
    title: [&'static str; 2],
    doc: [&'static str; 2],
}

#[derive(Clone, Copy)]
enum Form {
    Number(f64, f64, f64),
    Integer(f64, f64),
    Flag,
    Choice(&'static [&'static str]),
    /// A number or one of these words.
    NumberOr(f64, f64, f64, &'static [&'static str]),
}

impl Row {
    pub(in crate::planners) fn with_default(&self, defaults: &Map<String, Value>) -> Parameter {
        let (kind, range, choices): (_, _, &'static [&'static str]) = match self.form {
            Form::Number(min, max, step) => ("number", Some((min, max, step)), &[]),
            Form::Integer(min, max) => ("integer", Some((min, max, 1.0)), &[]),
            Form::Flag => ("boolean", None, &[]),
            Form::Choice(words) => ("choice", None, words),
            Form::NumberOr(min, max, step, words) => ("number", Some((min, max, step)), words),
        };
        Parameter {
            name: self.name,
            kind,
            unit: self.unit,
            min: range.map(|r| r.0),
            max: range.map(|r| r.1),
            step: range.map(|r| r.2),
            choices,
            default: defaults[self.name].clone(),
            basic: self.basic,
            title: Text { en: self.title[0], zh: self.title[1] },
            doc: Text { en: self.doc[0], zh: self.doc[1] },
        }
    }
}

const fn row(
    name: &'static str,
    form: Form,
    unit: &'static str,
    basic: bool,
    title: [&'static str; 2],
    doc: [&'static str; 2],
) -> Row {
    Row { name, form, unit, basic, title, doc }
}

const EXPANSIONS: Row = row(
    "maxExpansions",
    Form::Integer(1.0, 100_000_000.0),
    "1",
    false,
    ["Expansion budget", "扩展上限"],
    ["Stops after this many.", "超过此数即放弃。"],
);
