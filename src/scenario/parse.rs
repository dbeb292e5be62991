//! From JSON to [`Scenario`], with errors that name the field, however deep it is.
//!
//! serde's own tagged and untagged enums forget where inside them an error arose; here each alternative is read by its
//! own struct, and the inner path travels in the message until [`Scenario::from_json`] joins it to the outer one.

use serde::de::{DeserializeOwned, Deserializer, Error as _};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::{Goal, Obstacle, Scenario, SlotGoal, VehicleSpec};
use crate::error::{Error, ErrorCode};
use crate::geometry::Pose;

/// Separates an inner path from its message; no message of serde's contains it.
const MARK: char = '\u{1}';

/// Reads a typed value from JSON.
///
/// # Errors
/// `code`, the path of the offending field and serde's words for what is wrong with it.
pub(crate) fn typed<T: DeserializeOwned>(value: Value, code: ErrorCode) -> Result<T, Error> {
    serde_path_to_error::deserialize(value).map_err(|error| {
        let path = error.path().to_string();
        let message = error.inner().to_string();
        let outer = if path == "." { String::new() } else { path };
        match message.split_once(MARK) {
            Some((inner, rest)) => Error::new(code, inner, rest).within(&outer),
            None => Error::new(code, outer, message),
        }
    })
}

/// Reads one alternative of an enum, keeping the inner path.
fn alternative<T: DeserializeOwned, E: serde::de::Error>(value: Value) -> Result<T, E> {
    typed(value, ErrorCode::Scenario).map_err(|e| E::custom(format!("{}{MARK}{}", e.path, e.message)))
}

impl Scenario {
    /// Reads and validates a scene.
    ///
    /// # Errors
    /// [`ErrorCode::Scenario`] or [`ErrorCode::Vehicle`] with the field and the rule it breaks.
    ///
    /// # Examples
    /// ```
    /// let error = parkade::scenario::Scenario::from_json(serde_json::json!({ "version": 1 })).unwrap_err();
    /// assert_eq!(error.to_string(), "missing field `map`");
    /// ```
    pub fn from_json(value: Value) -> Result<Self, Error> {
        let scenario: Self = typed(value, ErrorCode::Scenario)?;
        scenario.validate()?;
        Ok(scenario)
    }
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct Cells {
    id: Option<String>,
    runs: Vec<[u32; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Wall {
    id: Option<String>,
    points: Vec<[f64; 2]>,
    #[serde(default)]
    thickness: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Polygon {
    id: Option<String>,
    points: Vec<[f64; 2]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Rectangle {
    id: Option<String>,
    center: [f64; 2],
    size: [f64; 2],
    #[serde(default)]
    heading: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Car {
    id: Option<String>,
    pose: Pose,
    #[serde(default)]
    vehicle: VehicleSpec,
}

impl<'de> Deserialize<'de> for Obstacle {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut fields = serde_json::Map::deserialize(deserializer)?;
        let kind = match fields.remove("type") {
            Some(Value::String(kind)) => kind,
            Some(other) => {
                let message = format!("type{MARK}must be a string, got {other}");
                return Err(D::Error::custom(message));
            }
            None => return Err(D::Error::missing_field("type")),
        };
        let value = Value::Object(fields);
        Ok(match kind.as_str() {
            "cells" => {
                let Cells { id, runs } = alternative(value)?;
                Self::Cells { id, runs }
            }
            "wall" => {
                let Wall { id, points, thickness } = alternative(value)?;
                Self::Wall { id, points, thickness }
            }
            "polygon" => {
                let Polygon { id, points } = alternative(value)?;
                Self::Polygon { id, points }
            }
            "rectangle" => {
                let Rectangle { id, center, size, heading } = alternative(value)?;
                Self::Rectangle { id, center, size, heading }
            }
            "car" => {
                let Car { id, pose, vehicle } = alternative(value)?;
                Self::Car { id, pose, vehicle }
            }
            other => {
                let message =
                    format!("type{MARK}must be cells, wall, polygon, rectangle or car, got \"{other}\"");
                return Err(D::Error::custom(message));
            }
        })
    }
}

impl<'de> Deserialize<'de> for Goal {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        if value.get("slot").is_some() {
            alternative::<SlotGoal, _>(value).map(Self::Slot)
        } else {
            alternative::<Pose, _>(value).map(Self::Pose)
        }
    }
}

impl<'de> Deserialize<'de> for VehicleSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Value::deserialize(deserializer)? {
            Value::String(name) => Ok(Self::Profile(name)),
            other => alternative(other).map(Self::Custom),
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn scene() -> Value {
        json!({
            "version": 1,
            "map": { "origin": [0.0, 0.0], "width": 40, "height": 40, "resolution": 0.5 },
            "start": { "x": 2.0, "y": 5.0, "heading": 0.0 },
            "goal": { "x": 12.0, "y": 5.0, "heading": 0.0 },
        })
    }

    fn refused(change: impl Fn(&mut Value)) -> String {
        let mut value = scene();
        change(&mut value);
        Scenario::from_json(value).unwrap_err().to_string()
    }

    #[test]
    fn a_plain_scene_reads_and_writes_back() {
        let scenario = Scenario::from_json(scene()).unwrap();
        let again = Scenario::from_json(serde_json::to_value(&scenario).unwrap()).unwrap();
        assert_eq!(scenario, again);
    }

    #[test]
    fn every_obstacle_type_survives_a_round_trip() {
        let mut value = scene();
        value["obstacles"] = json!([
            { "type": "cells", "id": "brush", "runs": [[3, 3, 2]] },
            { "type": "wall", "points": [[1, 1], [2, 2]], "thickness": 0.2 },
            { "type": "polygon", "points": [[8, 8], [9, 8], [9, 9]] },
            { "type": "rectangle", "center": [15, 15], "size": [2, 1], "heading": 0.3 },
            { "type": "car", "pose": { "x": 5, "y": 15, "heading": 1 }, "vehicle": "sedan" },
        ]);
        let scenario = Scenario::from_json(value).unwrap();
        assert_eq!(scenario.obstacles.len(), 5);
        assert_eq!(scenario, Scenario::from_json(serde_json::to_value(&scenario).unwrap()).unwrap());
    }

    #[test]
    fn errors_name_the_field_at_any_depth() {
        let cases = [
            (refused(|s| s["map"]["widht"] = json!(3)), "map.widht: unknown field `widht`"),
            (refused(|s| s["start"]["x"] = json!("a")), "start.x: invalid type: string \"a\", expected f64"),
            (
                refused(|s| {
                    s["obstacles"] = json!([{ "type": "polygon", "points": [[1, 2], [3, "x"], [4, 5]] }]);
                }),
                "obstacles[0].points[1][1]: invalid type: string \"x\"",
            ),
            (
                refused(|s| s["obstacles"] = json!([{ "type": "hole" }])),
                "obstacles[0].type: must be cells, wall",
            ),
            (refused(|s| s["goal"] = json!({ "slot": "a" })), "goal: missing field `entry`"),
            (refused(|s| s["vehicle"] = json!({ "wheelbase": "x" })), "vehicle.wheelbase: invalid type"),
            (
                refused(|s| s["vehicle"] = json!("truck")),
                "vehicle: must be paper, sedan or dimensions, got \"truck\"",
            ),
            (refused(|s| s["version"] = json!(2)), "version: must be 1, got 2"),
        ];
        for (got, expected) in cases {
            assert!(got.starts_with(expected), "{got}\nis not\n{expected}");
        }
    }
}
