//! Plain Python values as JSON and back; what is wrong with one is told with the path to it.

use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use parkade::error::{Error, ErrorCode};
use parkade::geometry::Pose;
use pyo3::prelude::*;
use pyo3::types::{
    PyBool, PyBytes, PyBytesMethods, PyDict, PyFloat, PyInt, PyList, PyMapping, PyString, PyTuple,
};
use serde_json::{Map, Number, Value};

/// Levels of lists and dictionaries in each other; none of ours has more than ten.
const DEPTH: usize = 64;

/// Whole floats below this are whole numbers, as in JavaScript: counts may come from computations.
const WHOLE: f64 = 9e15;

/// A Python exception for wrong input.
pub(crate) fn refused(py: Python<'_>, error: &Error) -> PyErr {
    let raised = || {
        let class = py.import("parkade._errors")?.getattr("ParkadeError")?;
        class.call1((error.to_string(), error.code.as_str(), &error.path))
    };
    raised().map_or_else(|failed| failed, PyErr::from_value)
}

/// Plain data as JSON.
pub(crate) fn read(value: &Bound<'_, PyAny>, code: ErrorCode) -> Result<Value, Error> {
    at_depth(value, code, 0)
}

fn at_depth(value: &Bound<'_, PyAny>, code: ErrorCode, depth: usize) -> Result<Value, Error> {
    let wrong = |rule: String| Err(Error::new(code, "", rule));
    if depth > DEPTH {
        return wrong(format!("must have at most {DEPTH} lists and dictionaries in each other"));
    }
    if value.is_none() {
        Ok(Value::Null)
    } else if let Ok(flag) = value.cast::<PyBool>() {
        Ok(flag.is_true().into())
    } else if value.is_instance_of::<PyInt>() {
        value
            .extract::<i64>()
            .map(Value::from)
            .or_else(|_| value.extract::<u64>().map(Value::from))
            .or_else(|_| wrong("must be a number, got an integer that does not fit into 64 bits".to_owned()))
    } else if let Ok(number) = value.cast::<PyFloat>() {
        float(number.value(), code)
    } else if let Ok(text) = value.cast::<PyString>() {
        text.to_str().map(Value::from).or_else(|_| wrong("must be text in Unicode".to_owned()))
    } else if let Ok(list) = value.cast::<PyList>() {
        items(list.iter(), code, depth)
    } else if let Ok(tuple) = value.cast::<PyTuple>() {
        items(tuple.iter(), code, depth)
    } else if let Ok(mapping) = value.cast::<PyMapping>() {
        fields(mapping, code, depth)
    } else if let Ok(plain) = value.call_method0("tolist") {
        // NumPy's arrays and its scalars.
        at_depth(&plain, code, depth + 1)
    } else {
        wrong(format!("must be plain data (dict, list, str, number, bool, None), got {}", kind_of(value)))
    }
}

fn float(number: f64, code: ErrorCode) -> Result<Value, Error> {
    if number.fract() == 0.0 && number.abs() < WHOLE {
        #[expect(clippy::cast_possible_truncation, reason = "checked in the line before")]
        return Ok((number as i64).into());
    }
    let rule = || Error::new(code, "", format!("must be a finite number, got {number}"));
    Number::from_f64(number).map(Value::Number).ok_or_else(rule)
}

fn items<'py>(
    items: impl Iterator<Item = Bound<'py, PyAny>>,
    code: ErrorCode,
    depth: usize,
) -> Result<Value, Error> {
    let item = |(i, item)| at_depth(&item, code, depth + 1).map_err(|e| e.within(&format!("[{i}]")));
    items.enumerate().map(item).collect::<Result<_, _>>().map(Value::Array)
}

fn fields(mapping: &Bound<'_, PyMapping>, code: ErrorCode, depth: usize) -> Result<Value, Error> {
    let unreadable = |e: PyErr| Error::new(code, "", format!("cannot be read: {e}"));
    let mut fields = Map::new();
    for pair in mapping.items().map_err(unreadable)?.iter() {
        let (key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = pair.extract().map_err(unreadable)?;
        let Ok(key) = key.extract::<String>() else {
            return Err(Error::new(code, "", format!("must have text as its keys, got {}", kind_of(&key))));
        };
        let value = at_depth(&value, code, depth + 1).map_err(|e| e.within(&key))?;
        fields.insert(key, value);
    }
    Ok(Value::Object(fields))
}

/// The name of a value's type, with its article.
pub(crate) fn kind_of(value: &Bound<'_, PyAny>) -> String {
    let name = value.get_type().name().map_or_else(|_| "another object".to_owned(), |name| name.to_string());
    let article =
        if name.starts_with(['a', 'e', 'i', 'o', 'u', 'A', 'E', 'I', 'O', 'U']) { "an" } else { "a" };
    format!("{article} {name}")
}

/// A dictionary or JSON text.
pub(crate) fn read_object(value: &Bound<'_, PyAny>, code: ErrorCode, what: &str) -> Result<Value, Error> {
    let text = value.extract::<&str>().ok().map(str::as_bytes);
    let Some(text) = text.or_else(|| value.cast::<PyBytes>().ok().map(PyBytesMethods::as_bytes)) else {
        return match read(value, code)? {
            object @ Value::Object(_) => Ok(object),
            _ => Err(Error::new(
                code,
                "",
                format!("{what} must be a dict or JSON text, got {}", kind_of(value)),
            )),
        };
    };
    serde_json::from_slice(text).map_err(|e| {
        let shown: String = String::from_utf8_lossy(text).chars().take(40).collect();
        let hint = if code == ErrorCode::Scenario && !shown.trim_start().starts_with(['{', '[']) {
            "; `parkade.scenario(id)` gives a built-in scene, `parkade.load(file)` reads one"
        } else {
            ""
        };
        Error::new(
            code,
            "",
            format!("{what} must be a dict or JSON text, got {shown:?}, which is not JSON: {e}{hint}"),
        )
    })
}

/// The fields of a dictionary that may be left out.
pub(crate) fn optional(
    value: Option<&Bound<'_, PyAny>>,
    code: ErrorCode,
    what: &str,
) -> Result<Map<String, Value>, Error> {
    match value.filter(|value| !value.is_none()).map(|value| read_object(value, code, what)).transpose()? {
        None => Ok(Map::new()),
        Some(Value::Object(fields)) => Ok(fields),
        Some(other) => Err(Error::new(code, "", format!("{what} must be a dict, got {other}"))),
    }
}

/// JSON as plain Python values.
pub(crate) fn write<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match value {
        Value::Null => py.None().into_bound(py),
        Value::Bool(flag) => PyBool::new(py, *flag).to_owned().into_any(),
        Value::Number(number) => match (number.as_i64(), number.as_u64()) {
            (Some(whole), _) => whole.into_pyobject(py)?.into_any(),
            (None, Some(whole)) => whole.into_pyobject(py)?.into_any(),
            _ => PyFloat::new(py, number.as_f64().unwrap_or(f64::NAN)).into_any(),
        },
        Value::String(text) => PyString::new(py, text).into_any(),
        Value::Array(items) => {
            let items: Vec<_> = items.iter().map(|item| write(py, item)).collect::<PyResult<_>>()?;
            PyList::new(py, items)?.into_any()
        }
        Value::Object(fields) => {
            let dict = PyDict::new(py);
            for (key, value) in fields {
                dict.set_item(key, write(py, value)?)?;
            }
            dict.into_any()
        }
    })
}

/// Numbers in rows.
pub(crate) fn rows(py: Python<'_>, numbers: Vec<f64>, columns: usize) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let shape = [numbers.len() / columns, columns];
    PyArray1::from_vec(py, numbers).reshape(shape)
}

/// x, y and heading of poses, a row each.
pub(crate) fn poses<'py>(py: Python<'py>, poses: &[Pose]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    rows(py, poses.iter().flat_map(|p| [p.x, p.y, p.heading]).collect(), 3)
}

/// The numbers of a sequence or an array of any shape, row by row.
pub(crate) fn numbers(value: &Bound<'_, PyAny>, name: &str) -> Result<Vec<f64>, Error> {
    if let Ok(array) = value.cast::<PyArray2<f64>>() {
        return Ok(array.readonly().as_array().iter().copied().collect());
    }
    // A corner's curvature is NaN.
    if let Ok(array) = value.cast::<PyArray1<f64>>() {
        return Ok(array.readonly().as_array().iter().copied().collect());
    }
    let mut numbers = Vec::new();
    flatten(&read(value, ErrorCode::Input).map_err(|e| e.within(name))?, &mut numbers)
        .map_err(|got| Error::new(ErrorCode::Input, name, format!("must be numbers, got {got}")))?;
    Ok(numbers)
}

/// Gears, ±1.
pub(crate) fn gears(value: &Bound<'_, PyAny>, name: &str) -> Result<Vec<i8>, Error> {
    let gear = |(i, number): (usize, f64)| match number {
        1.0 => Ok(1),
        -1.0 => Ok(-1),
        _ => Err(Error::new(
            ErrorCode::Input,
            format!("{name}[{i}]"),
            format!("must be 1 or -1, got {number}"),
        )),
    };
    numbers(value, name)?.into_iter().enumerate().map(gear).collect()
}

fn flatten<'v>(value: &'v Value, numbers: &mut Vec<f64>) -> Result<(), &'v Value> {
    match value {
        Value::Array(items) => items.iter().try_for_each(|item| flatten(item, numbers)),
        // A corner has no curvature; NaN is refused before, so it comes as None.
        Value::Null => {
            numbers.push(f64::NAN);
            Ok(())
        }
        value => value.as_f64().map(|number| numbers.push(number)).ok_or(value),
    }
}
