//! Values across the border: JSON-like in, typed arrays out.
//!
//! Inwards, a value passes through `Strict` to JSON and from there to the readers of [`crate::json`]: one path for
//! all input, so that every error names its field in the same way. NaN and infinities are refused here, because JSON
//! has no word for them and would turn them into null, which means "absent".
//!
//! Outwards, typed arrays are copies in JavaScript's memory: they stay valid when the module's memory grows or the
//! planner is freed.
//!
//! Small objects take one detour: they become JSON values first and JavaScript objects then. Each type that is
//! written directly would add its own copy of the serializer to the module, which is loaded before the first picture.

use std::fmt;

use js_sys::{Float32Array, Float64Array, Int8Array, Int32Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::de::{Deserializer, Error as _, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Number, Value};
use wasm_bindgen::JsValue;

use crate::error::{Error, ErrorCode};

/// Separates the steps of a path from each other and from the message; no message contains it.
const STEP: char = '\u{1}';

/// A JSON value that refuses NaN and infinities, which JSON would turn into null.
/// JavaScript has one kind of number, so whole ones below 9·10¹⁵ become integers; integer fields would refuse 3.0.
struct Strict(Value);

impl<'de> Deserialize<'de> for Strict {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(StrictVisitor).map(Self)
    }
}

/// Builds the JSON value; each layer of an array or object adds its step to the message of an error.
struct StrictVisitor;

impl<'de> Visitor<'de> for StrictVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("plain data")
    }

    fn visit_bool<E>(self, v: bool) -> Result<Value, E> {
        Ok(Value::Bool(v))
    }

    fn visit_i64<E>(self, v: i64) -> Result<Value, E> {
        Ok(v.into())
    }

    fn visit_u64<E>(self, v: u64) -> Result<Value, E> {
        Ok(v.into())
    }

    fn visit_f64<E: serde::de::Error>(self, v: f64) -> Result<Value, E> {
        // JS has one kind of number; integers must reach integer fields as integers.
        if v.fract() == 0.0 && v.abs() < 9e15 {
            return Ok((v as i64).into());
        }
        Number::from_f64(v)
            .map(Value::Number)
            .ok_or_else(|| E::custom(message!("must be a finite number, got {}", v)))
    }

    fn visit_str<E>(self, v: &str) -> Result<Value, E> {
        Ok(v.into())
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_none<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_some<D: Deserializer<'de>>(self, inner: D) -> Result<Value, D::Error> {
        inner.deserialize_any(self)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Value, A::Error> {
        let mut items = Vec::new();
        while let Some(Strict(item)) =
            seq.next_element().map_err(|e| A::Error::custom(format!("[{}]{STEP}{e}", items.len())))?
        {
            items.push(item);
        }
        Ok(Value::Array(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        let mut fields = Map::new();
        while let Some(key) = map.next_key::<String>()? {
            let Strict(value) = map.next_value().map_err(|e| A::Error::custom(format!("{key}{STEP}{e}")))?;
            fields.insert(key, value);
        }
        Ok(Value::Object(fields))
    }
}

/// Any plain JS value as JSON, or an error that names the first field that is not plain or not finite.
///
/// # Errors
/// `code` with the path of the first field that is a function, a symbol, NaN or infinite.
pub(super) fn json(value: JsValue, code: ErrorCode) -> Result<Value, Error> {
    if value.is_function() || value.is_symbol() {
        return Err(Error::new(code, "", "must be plain data"));
    }
    Strict::deserialize(serde_wasm_bindgen::Deserializer::from(value)).map(|Strict(value)| value).map_err(
        |error| {
            let message = error.to_string();
            // Strip the `Error: ` prefix that each layer adds.
            let mut steps: Vec<&str> =
                message.split(STEP).map(|step| step.strip_prefix("Error: ").unwrap_or(step)).collect();
            let rule = steps.pop().unwrap_or_default();
            steps.into_iter().rev().fold(Error::new(code, "", message!("{}", rule)), Error::within)
        },
    )
}

/// A small value as plain JS objects.
/// Sizes are small; what has thousands of numbers goes through typed arrays.
pub(super) fn write(value: &impl Serialize) -> JsValue {
    // By way of JSON: one instance of the JS serializer instead of one for every type.
    let value = serde_json::to_value(value).unwrap_or_default();
    value.serialize(&serde_wasm_bindgen::Serializer::json_compatible()).unwrap_or(JsValue::NULL)
}

/// A `ParkadeError` for JS: name, message, code, path.
/// `message` holds path and rule, `path` the path alone, so that programs need not take the text apart.
pub(super) fn js_error(error: &Error) -> JsValue {
    let js = js_sys::Error::new(&error.to_string());
    js.set_name("ParkadeError");
    set(&js, "code", &error.code.as_str().into());
    set(&js, "path", &error.path.as_str().into());
    set(&js, "template", &error.template.into());
    set(&js, "values", &error.values.iter().map(JsValue::from).collect::<js_sys::Array>().into());
    js.into()
}

/// Sets a field of an object that was made here.
pub(super) fn set(target: &JsValue, key: &str, value: &JsValue) {
    // Setting an own property of a fresh object cannot fail.
    let _ = Reflect::set(target, &key.into(), value);
}

/// An object from its fields.
pub(super) fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let target = Object::new().into();
    for (key, value) in fields {
        set(&target, key, value);
    }
    target
}

/// Coordinates, lengths and times: columns of the crate as JavaScript sees them.
pub(super) fn f64s(values: &[f64]) -> JsValue {
    Float64Array::from(values).into()
}

pub(super) fn f32s(values: &[f32]) -> JsValue {
    Float32Array::from(values).into()
}

pub(super) fn u32s(values: &[u32]) -> JsValue {
    Uint32Array::from(values).into()
}

pub(super) fn u8s(values: &[u8]) -> JsValue {
    Uint8Array::from(values).into()
}

pub(super) fn i32s(values: &[i32]) -> JsValue {
    Int32Array::from(values).into()
}

pub(super) fn i8s(values: &[i8]) -> JsValue {
    Int8Array::from(values).into()
}
