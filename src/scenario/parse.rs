//! From JSON to [`Scenario`], with errors that name the field, however deep it is.
//!
//! One reader for each kind of thing, made of the readers of [`crate::json`]. Readers know shapes and types only;
//! ranges, outlines and references are checked by [`Scenario::validate`], which sees the whole scene. An unknown
//! field is an error here, because a misspelt one would otherwise be a setting that has no effect.
//!
//! Fields with a default may be left out: `obstacles`, `slots` and `costs` are empty then, and the car is `paper`.
use serde::de::{Deserialize, Deserializer, Error as _};
use serde_json::Value;
use std::collections::BTreeMap;

use super::places::{point, pose};
use super::run_length;
use super::vehicle_spec::vehicle;
use super::{CostArea, Entry, Goal, Lean, MapFrame, Obstacle, Road, Scenario, Slot, SlotGoal, SlotKind};
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::json::{Fields, bad, count, exactly, flag, list, number, object, owned, text, word};

type Result<T> = core::result::Result<T, Error>;

/// Reads the lattice; sides and outline are not checked yet.
fn map(value: &Value) -> Result<MapFrame> {
    let f = Fields::of(value, &["origin", "width", "height", "resolution", "boundary"])?;
    Ok(MapFrame {
        origin: f.need("origin", point)?,
        width: f.need("width", count)?,
        height: f.need("height", count)?,
        resolution: f.need("resolution", number)?,
        boundary: f.maybe("boundary", list(point))?,
    })
}

/// Runs of cells: threes of numbers, or packed.
fn runs(value: &Value) -> Result<Vec<[u32; 3]>> {
    value.as_str().map_or_else(|| list(exactly(count))(value), run_length::unpack)
}

/// Reads one obstacle of the kind that `type` names.
fn obstacle(value: &Value) -> Result<Obstacle> {
    let kind = match value.get("type") {
        Some(kind) => text(kind).map_err(|e| e.within("type"))?,
        None if value.is_object() => return bad("type", "missing field".into()),
        None => return bad("", message!("must be an object, got {}", value)),
    };
    let id = |f: Fields| f.maybe("id", owned);
    Ok(match kind {
        "cells" => {
            let f = Fields::of(value, &["type", "id", "runs"])?;
            Obstacle::Cells { id: id(f)?, runs: f.need("runs", runs)? }
        }
        "wall" => {
            let f = Fields::of(value, &["type", "id", "points", "thickness"])?;
            let thickness = f.maybe("thickness", number)?.unwrap_or(0.0);
            Obstacle::Wall { id: id(f)?, points: f.need("points", list(point))?, thickness }
        }
        "polygon" => {
            let f = Fields::of(value, &["type", "id", "points"])?;
            Obstacle::Polygon { id: id(f)?, points: f.need("points", list(point))? }
        }
        "rectangle" => {
            let f = Fields::of(value, &["type", "id", "center", "size", "heading"])?;
            let (center, size) = (f.need("center", point)?, f.need("size", point)?);
            Obstacle::Rectangle {
                id: id(f)?,
                center,
                size,
                heading: f.maybe("heading", number)?.unwrap_or(0.0),
            }
        }
        "road" => Obstacle::Road(Road::read(value)?),
        "car" => {
            let f = Fields::of(value, &["type", "id", "pose", "vehicle"])?;
            let vehicle = f.maybe("vehicle", vehicle)?.unwrap_or_default();
            Obstacle::Car { id: id(f)?, pose: f.need("pose", pose)?, vehicle }
        }
        _ => {
            return bad(
                "type",
                message!("must be cells, wall, polygon, rectangle, road or car, got \"{}\"", kind),
            );
        }
    })
}

/// Reads an area with a weight.
fn cost_area(value: &Value) -> Result<CostArea> {
    let f = Fields::of(value, &["id", "runs", "weight"])?;
    Ok(CostArea { id: f.maybe("id", owned)?, runs: f.need("runs", runs)?, weight: f.need("weight", count)? })
}

/// Reads a slot; `angle` and `lean` matter only for angled ones.
fn slot(value: &Value) -> Result<Slot> {
    let known = ["id", "kind", "x", "y", "heading", "width", "length", "angle", "lean", "occupied"];
    let f = Fields::of(value, &known)?;
    let kinds = word(&[
        ("perpendicular", SlotKind::Perpendicular),
        ("parallel", SlotKind::Parallel),
        ("angled", SlotKind::Angled),
    ]);
    Ok(Slot {
        id: f.maybe("id", owned)?,
        kind: f.need("kind", kinds)?,
        x: f.need("x", number)?,
        y: f.need("y", number)?,
        heading: f.need("heading", number)?,
        width: f.need("width", number)?,
        length: f.need("length", number)?,
        angle: f.maybe("angle", number)?,
        lean: f.maybe("lean", word(&[("left", Lean::Left), ("right", Lean::Right)]))?,
        occupied: f.maybe("occupied", flag)?.unwrap_or(false),
    })
}

/// Reads a goal: a pose, a slot, or a set of goals. Its fields tell which.
pub(crate) fn goal(value: &Value) -> Result<Goal> {
    if IS_COMPLETE {
        if let Some(set) = super::GoalSet::read(value)? {
            return Ok(Goal::Set(set));
        }
    } else if value.is_array() || value.get("slots").or(value.get("region")).is_some() {
        return bad(
            "",
            "must be one pose or slot, got a set of goals: not in parkade/core, but in parkade".into(),
        );
    }
    if value.get("slot").or(value.get("entry")).is_none() {
        return pose(value).map(Goal::Pose);
    }
    let f = Fields::of(value, &["slot", "entry"])?;
    let entry = word(&[("reverse-in", Entry::ReverseIn), ("head-in", Entry::HeadIn)]);
    Ok(Goal::Slot(SlotGoal { slot: f.need("slot", owned)?, entry: f.need("entry", entry)? }))
}

impl Scenario {
    /// Reads and validates a scene.
    ///
    /// # Errors
    /// [`ErrorCode::Scenario`] or [`ErrorCode::Vehicle`] with the field and the rule it breaks.
    ///
    /// # Examples
    /// ```
    /// let error = parkade::scenario::Scenario::from_json(&serde_json::json!({ "version": 1 })).unwrap_err();
    /// assert_eq!(error.to_string(), "map: missing field");
    /// ```
    ///
    /// ```
    /// use parkade::scenario::Scenario;
    ///
    /// let mut scene = serde_json::to_value(parkade::scenario::catalog::scenario("parallel").unwrap()).unwrap();
    /// scene["obstacles"][0]["points"][2] = serde_json::json!([1, "north"]);
    /// let error = Scenario::from_json(&scene).unwrap_err();
    /// assert_eq!(error.to_string(), "obstacles[0].points[2][1]: must be a number, got \"north\"");
    /// ```
    pub fn from_json(value: &Value) -> Result<Self> {
        let scenario = Self::read(value).map_err(|e| e.with_code(ErrorCode::Scenario))?;
        scenario.validate()?;
        Ok(scenario)
    }

    /// Reads the scene's fields without checking what they mean.
    fn read(value: &Value) -> Result<Self> {
        let known = [
            "version",
            "name",
            "map",
            "obstacles",
            "slots",
            "costs",
            "moving",
            "lanes",
            "speedLimits",
            "vehicle",
            "start",
            "goal",
            "planners",
        ];
        let f = Fields::of(value, &known)?;
        let settings = |value| {
            let mut settings = BTreeMap::new();
            for (id, config) in object(value)? {
                settings.insert(id.clone(), object(config).map_err(|e| e.within(id))?.clone());
            }
            Ok(settings)
        };
        Ok(Self {
            version: f.need("version", count)?,
            name: f.maybe("name", owned)?,
            map: f.need("map", map)?,
            obstacles: f.maybe("obstacles", list(obstacle))?.unwrap_or_default(),
            slots: f.maybe("slots", list(slot))?.unwrap_or_default(),
            costs: f.maybe("costs", list(cost_area))?.unwrap_or_default(),
            moving: traffic(f, "moving", super::moving::read_all)?,
            lanes: traffic(f, "lanes", super::road::read_lanes)?,
            speed_limits: traffic(f, "speedLimits", super::road::read_limits)?,
            vehicle: f.maybe("vehicle", vehicle)?.unwrap_or_default(),
            start: f.need("start", pose)?,
            goal: f.need("goal", goal)?,
            planners: f.maybe("planners", settings)?.unwrap_or_default(),
        })
    }
}

/// A scene inside another value, as in files of several scenes; the path of an error is then part of its message.
impl<'de> Deserialize<'de> for Scenario {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> core::result::Result<Self, D::Error> {
        Self::from_json(&Value::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

/// A list of what moves on a road or is valid there. No planner of `core` sees these: it leaves them to the complete
/// module.
fn traffic<'a, T>(f: Fields<'a>, name: &str, read: fn(&'a Value) -> Result<Vec<T>>) -> Result<Vec<T>> {
    if IS_COMPLETE { Ok(f.maybe(name, read)?.unwrap_or_default()) } else { Ok(Vec::new()) }
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
        Scenario::from_json(&value).unwrap_err().to_string()
    }

    #[test]
    fn a_plain_scene_reads_and_writes_back() {
        let scenario = Scenario::from_json(&scene()).unwrap();
        let again = Scenario::from_json(&serde_json::to_value(&scenario).unwrap()).unwrap();
        assert_eq!(scenario, again);
    }

    #[test]
    fn moving_obstacles_read_and_write_back() {
        let mut value = scene();
        value["moving"] = json!([{ "points": [[1, 2], [9, 2]], "size": [5, 1], "speed": 2 }]);
        let scenario = Scenario::from_json(&value).unwrap();
        assert_eq!((scenario.moving[0].start, scenario.moving[0].size), (0.0, [5.0, 1.0]));
        assert_eq!(scenario, Scenario::from_json(&serde_json::to_value(&scenario).unwrap()).unwrap());
        let error =
            refused(|s| s["moving"] = json!([{ "points": [[1, 2], [9]], "size": [5, 1], "speed": 2 }]));
        assert!(error.starts_with("moving[0].points[1]: must have 2 items"), "{error}");
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
        let scenario = Scenario::from_json(&value).unwrap();
        assert_eq!(scenario.obstacles.len(), 5);
        assert_eq!(scenario, Scenario::from_json(&serde_json::to_value(&scenario).unwrap()).unwrap());
    }

    #[test]
    fn errors_name_the_field_at_any_depth() {
        let cases = [
            (refused(|s| s["map"]["widht"] = json!(3)), "map.widht: unknown field; there are origin, width"),
            (refused(|s| s["start"]["x"] = json!("a")), "start.x: must be a number, got \"a\""),
            (
                refused(|s| {
                    s["obstacles"] = json!([{ "type": "polygon", "points": [[1, 2], [3, "x"], [4, 5]] }]);
                }),
                "obstacles[0].points[1][1]: must be a number, got \"x\"",
            ),
            (
                refused(|s| s["obstacles"] = json!([{ "type": "hole" }])),
                "obstacles[0].type: must be cells, wall",
            ),
            (refused(|s| s["goal"] = json!({ "slot": "a" })), "goal.entry: missing field"),
            (
                refused(|s| s["vehicle"] = json!({ "wheelbase": "x" })),
                "vehicle.wheelbase: must be a number, got \"x\"",
            ),
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
