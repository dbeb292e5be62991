//! Reading JSON values, with errors that name the field, however deep it is.
//!
//! By hand: serde's tagged and untagged enums forget where inside them an error arose, and derived readers of
//! scenes and settings would be a quarter of the wasm file. The errors' code is the caller's to set.
//!
//! Unknown fields are errors: a misspelt setting must not be ignored.
//!
//! A reader is a function from a [`Value`] to a result. Readers are put together: `list(exactly(number))` reads a
//! list of pairs or triples. Each layer adds its own step to the path of an error ([`Error::within`]), from the
//! inside outwards, so that a reader of a point need not know where in a scene the point stands:
//! `obstacles[3].points[0][1]: must be a number, got "2"`.
//!
//! Absent and `null` mean the same for fields that may be left out, because JavaScript programs write either.

use serde_json::{Map, Value};

use crate::error::{Error, ErrorCode, Message};

type Result<T> = core::result::Result<T, Error>;

/// An error about a value: the path to it from where the reader stands, and the rule that it breaks.
pub(crate) fn bad<T>(path: &str, message: Message) -> Result<T> {
    Err(Error::new(ErrorCode::Input, path, message))
}

/// The fields of an object whose keys are all known.
#[derive(Clone, Copy)]
pub(crate) struct Fields<'a>(&'a Map<String, Value>);

impl<'a> Fields<'a> {
    /// The fields of an object, or an error if the value is none, or has a field that is not in `known`.
    pub(crate) fn of(value: &'a Value, known: &[&str]) -> Result<Self> {
        let Value::Object(map) = value else { return bad("", message!("must be an object, got {}", value)) };
        match map.keys().find(|k| !known.contains(&k.as_str())) {
            Some(key) => bad(key, message!("unknown field; there are {}", known.join(", "))),
            None => Ok(Self(map)),
        }
    }

    /// A field that may be absent or null.
    pub(crate) fn maybe<T>(self, name: &str, read: impl Fn(&'a Value) -> Result<T>) -> Result<Option<T>> {
        match self.0.get(name) {
            None | Some(Value::Null) => Ok(None),
            Some(value) => read(value).map(Some).map_err(|e| e.within(name)),
        }
    }

    /// A field that must be there; `null` counts as missing.
    pub(crate) fn need<T>(self, name: &str, read: impl Fn(&'a Value) -> Result<T>) -> Result<T> {
        match self.maybe(name, read)? {
            Some(value) => Ok(value),
            None => bad(name, "missing field".into()),
        }
    }
}

/// A number; integers count, strings of digits do not.
pub(crate) fn number(value: &Value) -> Result<f64> {
    value.as_f64().map_or_else(|| bad("", message!("must be a number, got {}", value)), Ok)
}

/// A whole number from 0 to 2³² − 1.
pub(crate) fn count(value: &Value) -> Result<u32> {
    let whole = value.as_u64().and_then(|v| u32::try_from(v).ok());
    whole
        .map_or_else(|| bad("", message!("must be a whole number from 0 to {}, got {}", u32::MAX, value)), Ok)
}

/// `true` or `false`, and no other value that might stand for one.
pub(crate) fn flag(value: &Value) -> Result<bool> {
    value.as_bool().map_or_else(|| bad("", message!("must be true or false, got {}", value)), Ok)
}

/// A string, borrowed.
pub(crate) fn text(value: &Value) -> Result<&str> {
    value.as_str().map_or_else(|| bad("", message!("must be a string, got {}", value)), Ok)
}

/// A string of its own, for data that outlives the JSON.
pub(crate) fn owned(value: &Value) -> Result<String> {
    text(value).map(str::to_owned)
}

/// One of some words.
/// The error lists all words, so a misspelt one can be corrected from the message.
pub(crate) fn word<T: Copy>(choices: &'static [(&'static str, T)]) -> impl Fn(&Value) -> Result<T> {
    move |value| index_of_word(value, &mut choices.iter().map(|choice| choice.0)).map(|at| choices[at].1)
}

/// Compiled once, for words of every type.
#[inline(never)]
fn index_of_word(value: &Value, words: &mut dyn Iterator<Item = &'static str>) -> Result<usize> {
    let known: Vec<_> = words.collect();
    match known.iter().position(|&word| value.as_str() == Some(word)) {
        Some(at) => Ok(at),
        None => bad("", message!("must be {}, got {}", known.join(" or "), value)),
    }
}

/// An array of any length, each item by the same reader.
pub(crate) fn list<T>(read: impl Fn(&Value) -> Result<T>) -> impl Fn(&Value) -> Result<Vec<T>> {
    move |value| {
        let mut all = Vec::new();
        each(value, &mut |item| read(item).map(|item| all.push(item)))?;
        Ok(all)
    }
}

/// The loop over any list: compiled once, where collecting results would be compiled for each kind of item.
#[inline(never)]
fn each(value: &Value, read: &mut dyn FnMut(&Value) -> Result<()>) -> Result<()> {
    let Value::Array(items) = value else { return bad("", message!("must be an array, got {}", value)) };
    for (i, item) in items.iter().enumerate() {
        read(item).map_err(|e| e.within(&format!("[{i}]")))?;
    }
    Ok(())
}

/// Exactly `N` of something.
/// `exactly(number)` in the place of an array of two numbers reads a point.
pub(crate) fn exactly<T, const N: usize>(
    read: impl Fn(&Value) -> Result<T>,
) -> impl Fn(&Value) -> Result<[T; N]> {
    let all = list(read);
    move |value| {
        all(value)?
            .try_into()
            .or_else(|items: Vec<T>| bad("", message!("must have {} items, got {}", N, items.len())))
    }
}

/// An object whose keys are not known beforehand.
pub(crate) fn object(value: &Value) -> Result<&Map<String, Value>> {
    value.as_object().map_or_else(|| bad("", message!("must be an object, got {}", value)), Ok)
}

/// A type whose values have names.
/// Names are in lower case with hyphens, as in JSON; each value has exactly one.
pub(crate) trait Words: Copy + PartialEq + 'static {
    /// Each value with its name.
    const WORDS: &'static [(&'static str, Self)];

    /// The name.
    fn word(self) -> &'static str {
        Self::WORDS.iter().find(|word| word.1 == self).map_or("", |word| word.0)
    }
}

/// Names the values of an enum. Those behind `complete` are named in the complete module only.
macro_rules! words {
    ($type:ty: $($word:literal = $variant:ident),+ $(,)?) => {
        impl $crate::json::Words for $type {
            const WORDS: &'static [(&'static str, Self)] = &[$(($word, Self::$variant)),+];
        }
    };
    ($type:ty: $($word:literal = $variant:ident),+; complete: $($more:literal = $other:ident),+ $(,)?) => {
        impl $crate::json::Words for $type {
            const WORDS: &'static [(&'static str, Self)] = if $crate::IS_COMPLETE {
                &[$(($word, Self::$variant),)+ $(($more, Self::$other)),+]
            } else {
                &[$(($word, Self::$variant)),+]
            };
        }
    };
}
pub(crate) use words;

/// True of what is told only where there is some; the small module never tells it.
pub(crate) fn is_left_out<'a, T: 'a>(told: impl IntoIterator<Item = &'a T>) -> bool {
    !crate::IS_COMPLETE || told.into_iter().next().is_none()
}

/// A value inside a config.
/// A config is a list of settings with names, so that one loop reads and writes the settings of every planner.
pub(crate) trait Setting {
    /// Takes its value from JSON.
    fn read(&mut self, value: &Value) -> Result<()>;
    /// Its value as JSON.
    fn write(&self) -> Value;
    /// Its value, where that is a number.
    fn number(&self) -> Option<f64> {
        None
    }
}

impl Setting for f64 {
    fn read(&mut self, value: &Value) -> Result<()> {
        number(value).map(|v| *self = v)
    }
    fn write(&self) -> Value {
        (*self).into()
    }
    fn number(&self) -> Option<f64> {
        Some(*self)
    }
}

impl Setting for u32 {
    fn read(&mut self, value: &Value) -> Result<()> {
        count(value).map(|v| *self = v)
    }
    fn write(&self) -> Value {
        (*self).into()
    }
    fn number(&self) -> Option<f64> {
        Some((*self).into())
    }
}

impl Setting for bool {
    fn read(&mut self, value: &Value) -> Result<()> {
        flag(value).map(|v| *self = v)
    }
    fn write(&self) -> Value {
        (*self).into()
    }
}

/// `null` means that the setting is absent, which is a value of its own: the planner then chooses by its level or
/// scene.
impl<T: Setting + Default> Setting for Option<T> {
    fn read(&mut self, value: &Value) -> Result<()> {
        *self = if value.is_null() {
            None
        } else {
            let mut inner = T::default();
            inner.read(value)?;
            Some(inner)
        };
        Ok(())
    }
    fn write(&self) -> Value {
        self.as_ref().map_or(Value::Null, Setting::write)
    }
    fn number(&self) -> Option<f64> {
        self.as_ref().and_then(Setting::number)
    }
}

impl<T: Words> Setting for T {
    fn read(&mut self, value: &Value) -> Result<()> {
        word(T::WORDS)(value).map(|v| *self = v)
    }
    fn write(&self) -> Value {
        self.word().into()
    }
}

/// A setting's name and place.
type Named<'a> = (&'static str, &'a mut dyn Setting);

/// Lays JSON fields over settings.
/// Fields that are left out keep their value. An unknown name or a value of another type is an error; ranges are
/// checked later, by the config as a whole.
pub(crate) fn overlay(settings: &mut [Named], fields: &Map<String, Value>) -> Result<()> {
    for (name, value) in fields {
        let read = if let Some((_, setting)) = settings.iter_mut().find(|s| s.0 == name) {
            setting.read(value)
        } else {
            let known: Vec<_> = settings.iter().map(|s| s.0).collect();
            bad("", message!("no such setting; there are {}", known.join(", ")))
        };
        read.map_err(|e| e.within(name).with_code(ErrorCode::Config))?;
    }
    Ok(())
}

/// Settings as JSON fields.
/// The inverse of [`overlay`]: what it writes can be read back to the same settings.
pub(crate) fn written(settings: &[Named]) -> Map<String, Value> {
    let mut fields = Map::new();
    for (name, setting) in settings {
        fields.insert((*name).to_owned(), setting.write());
    }
    fields
}

/// Makes a struct readable from JSON and writable to it, by the names of its fields there.
macro_rules! settings {
    ($type:ty: $($name:literal = $($field:ident).+),+ $(,)?) => {
        impl $type {
            /// These settings with JSON fields laid over them. Ranges are checked by `validate`.
            ///
            /// # Errors
            /// [`ErrorCode::Config`](crate::error::ErrorCode::Config) with the field and the rule.
            pub fn with(
                mut self,
                fields: &serde_json::Map<String, serde_json::Value>,
            ) -> Result<Self, $crate::error::Error> {
                $crate::json::overlay(&mut [$(($name, &mut self.$($field).+)),+], fields)?;
                Ok(self)
            }

            /// These settings as JSON fields.
            pub fn to_json(&self) -> serde_json::Map<String, serde_json::Value> {
                let mut own = self.clone();
                $crate::json::written(&[$(($name, &mut own.$($field).+)),+])
            }
        }
    };
}
pub(crate) use settings;
