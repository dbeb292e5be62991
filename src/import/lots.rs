//! Parking lots as lists of numbers: line walls and polygons, `[x1, y1, x2, y2]` and `[[x, y], …]`, metres; poses
//! `[x, y, heading]` of the rear axle's middle.
//!
//! ```json
//! { "id": "bay", "vehicle": { "wheelbase": 2.7, "rear_axle_to_front": 3.7, "rear_axle_to_rear": 1.0, "width": 2.0,
//!   "max_steer": 0.6 }, "lines": [[0, 0, 30, 0]], "polygons": [],
//!   "start": [4, 5, 0], "goal": [20, 15, 1], "alternatives": [{ "start": [4, 15, 0], "goal": [20, 5, 1] }] }
//! ```
//!
//! Keys are those of the benchmark's files, with underscores. Fields that are not known are ignored here, unlike in
//! scenes, because such files carry remarks and results of other programs.

use serde::Deserialize;
use serde_json::Value;

use crate::error::{Error, ErrorCode};
use crate::geometry::Pose;
use crate::scenario::{MAX_CELLS, MapFrame, Obstacle, Scenario, VehicleSpec};
use crate::vehicle::{DEFAULT_STEER_RATE, Vehicle};

/// Side of a map cell on lots that are small enough, metres.
const CELL: f64 = 0.25;

/// One lot of the file: walls, polygons, a car, and one question at least.
#[derive(Deserialize)]
struct Lot {
    id: String,
    vehicle: Car,
    #[serde(default)]
    lines: Vec<[f64; 4]>,
    #[serde(default)]
    polygons: Vec<Vec<[f64; 2]>>,
    start: [f64; 3],
    goal: [f64; 3],
    #[serde(default)]
    alternatives: Vec<Question>,
}

#[derive(Deserialize)]
struct Question {
    start: [f64; 3],
    goal: [f64; 3],
}

/// Dimensions from the middle of the rear axle, metres; the steering angle in radians.
#[derive(Deserialize)]
struct Car {
    wheelbase: f64,
    rear_axle_to_front: f64,
    rear_axle_to_rear: f64,
    width: f64,
    max_steer: f64,
}

/// The scenes of one lot: its own question, then its alternatives, named `id`, `id-2`, ….
///
/// The map is the box around all walls and polygons.
///
/// # Errors
/// [`ErrorCode::Import`] where a field is missing or of another type; then what [`Scenario::validate`] says.
///
/// # Examples
/// ```
/// let lot = serde_json::json!({
///     "id": "bay",
///     "vehicle": {
///         "wheelbase": 2.7, "rear_axle_to_front": 3.7, "rear_axle_to_rear": 1.0, "width": 2.0, "max_steer": 0.6
///     },
///     "lines": [[0, 0, 30, 0], [0, 20, 30, 20]],
///     "start": [4, 5, 0],
///     "goal": [20, 15, 1],
///     "alternatives": [{ "start": [4, 15, 0], "goal": [20, 5, 1] }]
/// });
/// let scenes = parkade::import::lots::scenes(&lot).unwrap();
/// assert_eq!(scenes[1].name.as_deref(), Some("bay-2"));
/// assert_eq!(scenes[0].obstacles.len(), 2);
/// ```
pub fn scenes(lot: &Value) -> Result<Vec<Scenario>, Error> {
    let lot: Lot = Lot::deserialize(lot).map_err(|e| Error::new(ErrorCode::Import, "", message!("{}", e)))?;
    let first = Question { start: lot.start, goal: lot.goal };
    let questions = [first].into_iter().chain(lot.alternatives.iter().map(|q| Question { ..*q }));
    (1..).zip(questions).map(|(number, question)| lot.scene(number, &question)).collect()
}

impl Lot {
    /// The lot as a scene with one of its questions; the first has the lot's own name.
    fn scene(&self, number: u32, question: &Question) -> Result<Scenario, Error> {
        let [start, goal] = [question.start, question.goal].map(|[x, y, heading]| Pose::new(x, y, heading));
        let wall = |&[x1, y1, x2, y2]: &[f64; 4]| Obstacle::Wall {
            id: None,
            points: vec![[x1, y1], [x2, y2]],
            thickness: 0.0,
        };
        let polygon = |points: &Vec<[f64; 2]>| Obstacle::Polygon { id: None, points: points.clone() };
        let scene = Scenario {
            name: Some(if number == 1 { self.id.clone() } else { format!("{}-{number}", self.id) }),
            obstacles: self.lines.iter().map(wall).chain(self.polygons.iter().map(polygon)).collect(),
            ..Scenario::new(
                self.frame(),
                VehicleSpec::Custom(Vehicle {
                    wheelbase: self.vehicle.wheelbase,
                    width: self.vehicle.width,
                    rear_to_front: self.vehicle.rear_axle_to_front,
                    rear_to_back: self.vehicle.rear_axle_to_rear,
                    max_steer: self.vehicle.max_steer,
                    max_steer_rate: DEFAULT_STEER_RATE,
                }),
                start,
                goal,
            )
        };
        scene.validate()?;
        Ok(scene)
    }

    /// The map: the box around all walls and polygons, in cells of 0.25 m, or larger where the box is larger than
    /// [`MAX_CELLS`] of them. The box is the floor's boundary, too.
    fn frame(&self) -> MapFrame {
        let lines = self.lines.iter().flat_map(|&[x1, y1, x2, y2]| [[x1, y1], [x2, y2]]);
        let points = lines.chain(self.polygons.iter().flatten().copied());
        let empty = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        let [x0, y0, x1, y1] =
            points.fold(empty, |[x0, y0, x1, y1], [x, y]| [x0.min(x), y0.min(y), x1.max(x), y1.max(y)]);
        let resolution = CELL.max((x1 - x0).max(y1 - y0) / f64::from(MAX_CELLS));
        // What is no length becomes 0 cells, which validation refuses.
        let cells = |length: f64| ((length / resolution).ceil() as u32).min(MAX_CELLS);
        MapFrame {
            origin: [x0, y0],
            width: cells(x1 - x0),
            height: cells(y1 - y0),
            resolution,
            boundary: Some(vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::Goal;
    use serde_json::json;

    fn lot() -> Value {
        json!({
            "id": "bay", "start": [4, 5, 0], "goal": [20, 15, 1], "lines": [[0, 0, 30, 0], [30, 0, 30, 20.1]],
            "vehicle": { "wheelbase": 2.7, "rear_axle_to_front": 3.7, "rear_axle_to_rear": 1.0, "width": 2.0,
                "max_steer": 0.6 },
            "alternatives": [{ "start": [4, 15, 0], "goal": [20, 5, 1] }],
        })
    }

    #[test]
    fn a_lot_gives_a_scene_per_question() {
        let scenes = scenes(&lot()).unwrap();
        assert_eq!(scenes.iter().map(|s| s.name.as_deref().unwrap()).collect::<Vec<_>>(), ["bay", "bay-2"]);
        assert_eq!(scenes[1].goal, Goal::Pose(Pose::new(20.0, 5.0, 1.0)));
        assert_eq!((scenes[0].map.width, scenes[0].map.height), (120, 81));
        assert_eq!(scenes[0].obstacles.len(), 2);
    }

    #[test]
    fn a_missing_field_is_named() {
        let mut value = lot();
        value.as_object_mut().unwrap().remove("goal");
        assert_eq!(scenes(&value).unwrap_err().message(), "missing field `goal`");
        let mut value = lot();
        value["vehicle"]["width"] = json!(-1.0);
        assert_eq!(scenes(&value).unwrap_err().path, "vehicle.width");
        let empty = json!({ "lines": [] });
        let merged = lot().as_object().unwrap().clone().into_iter().chain(empty.as_object().unwrap().clone());
        assert!(scenes(&merged.collect()).is_err());
    }
}
