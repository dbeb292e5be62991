//! Settings from JSON, with errors that name the field.

use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::error::{Error, ErrorCode};

/// A planner's settings from a complete set of fields.
///
/// serde does not say which field of a flat struct was wrong; reading each one by itself tells.
pub(super) fn settings<T: DeserializeOwned>(fields: &Map<String, Value>) -> Result<T, Error> {
    let read = |map: Map<String, Value>| serde_json::from_value::<T>(Value::Object(map));
    read(fields.clone()).map_err(|error| {
        let alone = |(name, value): (&String, &Value)| {
            // Not collected: that would sort, and every sort is 8 kB of wasm.
            let mut one = Map::new();
            one.insert(name.clone(), value.clone());
            read(one).is_err()
        };
        let culprit = fields.iter().find(|f| alone(*f)).map_or("", |f| f.0);
        Error::new(ErrorCode::Config, culprit, error.to_string())
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::planners::hybrid::Config;

    #[test]
    fn the_wrong_field_is_named() {
        let mut fields = json!(Config::default()).as_object().cloned().unwrap();
        assert!(settings::<Config>(&fields).is_ok());
        fields.insert("steerSamples".to_owned(), json!("many"));
        let error = settings::<Config>(&fields).unwrap_err();
        assert!(error.to_string().starts_with("steerSamples: invalid type: string"), "{error}");
    }
}
