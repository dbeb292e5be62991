//! Rules that a scene must satisfy before anything is built from it.
//!
//! Scenes come from files, links and other programs, so every number is distrusted: it must be finite and within a
//! bound that keeps time and memory bounded. The first broken rule is answered as an error with the field's path,
//! its value and the rule.
//!
//! Checks are ordered from the map to the goal, so that a message never refers to something that is itself invalid.
//! Nothing is corrected: a scene that passes is used as it was written.
//!
//! Costs: linear in the scene, except for outlines. Whether one crosses itself is asked of all pairs of edges, which
//! is why corners have a limit.

use std::collections::BTreeMap;

use super::Goal;
use super::checks::{bad, corners, finite, finite_pose, outline, point, positive};
use super::{CostArea, MAX_CELLS, MapFrame, Obstacle, Scenario, Slot, SlotKind, VehicleSpec};
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::geometry::math::FRAC_PI_2;
use crate::map::Weights;
use crate::vehicle::Vehicle;

/// Most that all cells of a painted map cost together, in cells: searches count to 2⁴⁴ millionths of one.
const MAX_COSTS: u64 = 12_000_000;

impl Scenario {
    /// Checks every number and every reference.
    ///
    /// # Errors
    /// The first rule that is broken, with the field's path and its value.
    pub fn validate(&self) -> Result<(), Error> {
        if self.version != 1 {
            return bad("version", message!("must be 1, got {}", self.version));
        }
        self.map.validate().map_err(|e| e.within("map"))?;
        for (i, obstacle) in self.obstacles.iter().enumerate() {
            obstacle.validate(&self.map).map_err(|e| e.within(&format!("obstacles[{i}]")))?;
        }
        costs(&self.costs, &self.map)?;
        let mut known = BTreeMap::new();
        for (i, slot) in self.slots.iter().enumerate() {
            slot.validate().map_err(|e| e.within(&format!("slots[{i}]")))?;
            let twin = slot.id.as_ref().and_then(|id| known.insert(id, i));
            if let (Some(twin), Some(id)) = (twin, &slot.id) {
                return bad(
                    &format!("slots[{i}].id"),
                    message!("must be unique, \"{}\" is slots[{}] too", id, twin),
                );
            }
        }
        if IS_COMPLETE {
            self.validate_traffic()?;
        }
        self.vehicle.resolve().map_err(|e| e.within("vehicle"))?;
        finite_pose(self.start).map_err(|e| e.within("start"))?;
        if IS_COMPLETE && let Goal::Set(set) = &self.goal {
            return set.validate(&self.slots).map_err(|e| e.within("goal"));
        }
        self.goal_pose(&self.goal).map(|_| ()).map_err(|e| e.within("goal"))
    }

    /// Checks what moves, and the lanes and speed limits of roads.
    fn validate_traffic(&self) -> Result<(), Error> {
        for (i, moving) in self.moving.iter().enumerate() {
            moving.validate().map_err(|e| e.within(&format!("moving[{i}]")))?;
        }
        for (i, lane) in self.lanes.iter().enumerate() {
            lane.validate().map_err(|e| e.within(&format!("lanes[{i}]")))?;
        }
        for (i, limit) in self.speed_limits.iter().enumerate() {
            limit.validate().map_err(|e| e.within(&format!("speedLimits[{i}]")))?;
        }
        Ok(())
    }
}

impl VehicleSpec {
    /// The dimensions.
    ///
    /// # Errors
    /// [`ErrorCode::Vehicle`] when the profile is unknown or a dimension is not possible.
    ///
    /// # Examples
    /// ```
    /// use parkade::scenario::VehicleSpec;
    /// use parkade::vehicle::Vehicle;
    ///
    /// assert_eq!(VehicleSpec::Profile("sedan".to_owned()).resolve(), Ok(Vehicle::SEDAN));
    /// assert!(VehicleSpec::Profile("tank".to_owned()).resolve().is_err());
    /// ```
    pub fn resolve(&self) -> Result<Vehicle, Error> {
        match self {
            Self::Profile(name) => Vehicle::profile(name).ok_or_else(|| {
                let message = message!("must be paper, sedan or dimensions, got \"{}\"", name);
                Error::new(ErrorCode::Vehicle, "", message)
            }),
            Self::Custom(vehicle) => vehicle.validate().map(|()| *vehicle),
        }
    }
}

impl MapFrame {
    /// Sides, resolution and outline of the map. Corners of the outline may lie outside by a rounding of their
    /// coordinates.
    fn validate(&self) -> Result<(), Error> {
        point("origin", self.origin)?;
        for (name, cells) in [("width", self.width), ("height", self.height)] {
            if !(1..=MAX_CELLS).contains(&cells) {
                return bad(name, message!("must be 1 to {} cells, got {}", MAX_CELLS, cells));
            }
        }
        if !(self.resolution >= 0.001 && self.resolution <= 1000.0) {
            return bad("resolution", message!("must be 0.001 to 1000 m, got {}", self.resolution));
        }
        let Some(boundary) = &self.boundary else { return Ok(()) };
        outline("boundary", boundary)?;
        let [x0, y0] = self.origin;
        let slack = 1e-9 * (1.0 + x0.abs().max(y0.abs()));
        let x1 = x0 + f64::from(self.width) * self.resolution + slack;
        let y1 = y0 + f64::from(self.height) * self.resolution + slack;
        for (i, &[x, y]) in boundary.iter().enumerate() {
            if x < x0 - slack || x > x1 || y < y0 - slack || y > y1 {
                return bad(
                    &format!("boundary[{i}]"),
                    message!("must be inside the map, got [{}, {}]", x, y),
                );
            }
        }
        Ok(())
    }
}

impl Obstacle {
    /// Shapes and sizes; a car's dimensions and a road's line have rules of their own. Obstacles may lie outside the
    /// map.
    pub(crate) fn validate(&self, map: &MapFrame) -> Result<(), Error> {
        match self {
            Self::Cells { runs, .. } => on_map(runs, map),
            Self::Wall { points, thickness, .. } => {
                corners("points", points, 2)?;
                if !(*thickness >= 0.0 && *thickness <= 1000.0) {
                    return bad("thickness", message!("must be 0 to 1000 m, got {}", thickness));
                }
                Ok(())
            }
            Self::Polygon { points, .. } => outline("points", points),
            Self::Rectangle { center, size, heading, .. } => {
                point("center", *center)?;
                positive("size[0]", size[0])?;
                positive("size[1]", size[1])?;
                finite("heading", *heading)
            }
            Self::Road(road) => road.validate(),
            Self::Car { pose, vehicle, .. } => {
                finite_pose(*pose).map_err(|e| e.within("pose"))?;
                vehicle.resolve().map(|_| ()).map_err(|e| e.within("vehicle"))
            }
        }
    }
}

/// Runs that hold a cell and lie on the map.
fn on_map(runs: &[[u32; 3]], map: &MapFrame) -> Result<(), Error> {
    for (i, &[x, y, count]) in runs.iter().enumerate() {
        let end = u64::from(x) + u64::from(count);
        if count == 0 || end > u64::from(map.width) || y >= map.height {
            let (w, h) = (map.width, map.height);
            let message = message!("must lie on the {} × {} map, got [{}, {}, {}]", w, h, x, y, count);
            return bad(&format!("runs[{i}]"), message);
        }
    }
    Ok(())
}

/// Weights within their range, and a sum of all cells that searches can count to.
fn costs(areas: &[CostArea], map: &MapFrame) -> Result<(), Error> {
    let mut all = u64::from(map.width) * u64::from(map.height);
    for (i, area) in areas.iter().enumerate() {
        on_map(&area.runs, map).map_err(|e| e.within(&format!("costs[{i}]")))?;
        if !(1..=Weights::MOST).contains(&area.weight) {
            let message = message!("must be 1 to {}, got {}", Weights::MOST, area.weight);
            return bad(&format!("costs[{i}].weight"), message);
        }
        all += area.runs.iter().map(|run| u64::from(run[2]) * u64::from(area.weight - 1)).sum::<u64>();
    }
    if !areas.is_empty() && all > MAX_COSTS {
        let message = message!("all cells times their weights must be at most {}, are {}", MAX_COSTS, all);
        return bad("costs", message);
    }
    Ok(())
}

impl Slot {
    fn validate(&self) -> Result<(), Error> {
        point("x", [self.x, 0.0])?;
        point("y", [self.y, 0.0])?;
        finite("heading", self.heading)?;
        positive("width", self.width)?;
        positive("length", self.length)?;
        match self.angle {
            Some(angle) if self.kind == SlotKind::Angled && !(0.1..FRAC_PI_2).contains(&angle) => {
                bad("angle", message!("must be 0.1 to π/2, got {}", angle))
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn refused(change: impl Fn(&mut Scenario)) -> String {
        let mut scenario = Scenario::from_json(&json!({
            "version": 1,
            "map": { "origin": [0.0, 0.0], "width": 40, "height": 40, "resolution": 0.5 },
            "slots": [
                { "id": "a", "kind": "angled", "x": 5, "y": 5, "heading": 0, "width": 2.5, "length": 5 },
                { "id": "b", "kind": "parallel", "x": 5, "y": 9, "heading": 0, "width": 2.5, "length": 6 },
            ],
            "obstacles": [{ "type": "polygon", "points": [[8, 8], [9, 8], [9, 9]] }],
            "moving": [{ "points": [[1, 2], [9, 2], [9, 4]], "size": [5, 1], "speed": 2 }],
            "start": { "x": 2.0, "y": 5.0, "heading": 0.0 },
            "goal": { "slot": "a", "entry": "head-in" },
        }))
        .unwrap();
        change(&mut scenario);
        scenario.validate().unwrap_err().to_string()
    }

    fn polygon(points: &[[f64; 2]]) -> Obstacle {
        Obstacle::Polygon { id: None, points: points.to_vec() }
    }

    #[test]
    fn impossible_scenes_are_refused_with_words() {
        let bow = polygon(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]);
        let flat = polygon(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]);
        let cases = [
            (refused(|s| s.map.width = 5000), "map.width: must be 1 to 4096 cells, got 5000"),
            (refused(|s| s.map.resolution = f64::NAN), "map.resolution: must be 0.001 to 1000 m, got NaN"),
            (refused(|s| s.start.x = f64::INFINITY), "start.x: must be finite"),
            (
                refused(|s| s.obstacles.push(bow.clone())),
                "obstacles[1].points: must not cross itself: edges 0 and 2 meet",
            ),
            (refused(|s| s.obstacles.push(flat.clone())), "obstacles[1].points: must"),
            (refused(|s| s.slots[1].width = -1.0), "slots[1].width: must be positive, at most 1e6, got -1"),
            (refused(|s| s.slots[0].angle = Some(2.0)), "slots[0].angle: must be 0.1 to π/2, got 2"),
            (refused(|s| s.slots[1].id = Some("a".into())), "slots[1].id: must be unique"),
            (refused(|s| s.slots.clear()), "goal.slot: must be the id of a slot, got \"a\""),
            (
                refused(|s| s.map.boundary = Some(vec![[0.0, 0.0], [30.0, 0.0], [0.0, 9.0]])),
                "map.boundary[1]: must be inside",
            ),
            (
                refused(|s| s.obstacles.push(Obstacle::Cells { id: None, runs: vec![[39, 0, 2]] })),
                "obstacles[1].runs[0]: must lie on the 40 × 40 map, got [39, 0, 2]",
            ),
        ];
        for (got, expected) in cases {
            assert!(got.starts_with(expected), "{got}\nis not\n{expected}");
        }
    }

    #[test]
    fn impossible_movements_are_refused_with_words() {
        let cases = [
            (
                refused(|s| s.moving[0].points[1] = [1.0, 2.0]),
                "moving[0].points[1]: must differ from the point before it",
            ),
            (
                refused(|s| s.moving[0].points.truncate(1)),
                "moving[0].points: must have 2 to 2000 points, got 1",
            ),
            (
                refused(|s| s.moving[0].size[1] = 0.0),
                "moving[0].size[1]: must be positive, at most 1e6, got 0",
            ),
            (refused(|s| s.moving[0].speed = -2.0), "moving[0].speed: must be positive, at most 1e6, got -2"),
            (refused(|s| s.moving[0].start = f64::NAN), "moving[0].start: must be 0 to 1e6 s, got NaN"),
        ];
        for (got, expected) in cases {
            assert!(got.starts_with(expected), "{got}\nis not\n{expected}");
        }
    }
}
