//! Lanes and speed limits of a road.
//!
//! The drivable area is the map's boundary, whose edges are the kerbs; hatched areas are obstacles.
//!
//! A lane is told by its middle line and its width, because planners ask how far from the middle a place is and which
//! way traffic goes there. Pieces follow each other without gaps: each begins at the pose where the one before ends,
//! so heading and position are continuous by construction, and the curvature jumps at the joints.

use serde::Serialize;
use serde_json::Value;

use super::checks::{bad, finite_pose, outline, positive};
use super::places::{point, pose};
use crate::error::Error;
use crate::geometry::{Point, Pose, math};
use crate::json::{Fields, list, number, owned};

/// Most pieces of one lane.
const MAX_PIECES: usize = 2000;

/// A lane's middle, from its beginning, and its width. Driven the way it is drawn.
///
/// ```
/// use parkade::geometry::Pose;
/// use parkade::scenario::{Lane, LanePiece};
///
/// let straight = LanePiece { length: 10.0, curvature: 0.0 };
/// let lane = Lane { id: None, start: Pose::new(0.0, 2.0, 0.0), pieces: vec![straight], width: 3.5 };
/// // Four metres along the lane, one metre to the left of its middle.
/// let beside = lane.point(4.0, 1.0);
/// assert_eq!((beside.x, beside.y), (4.0, 3.0));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Lane {
    /// Name for messages and selection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// Pose at which the centre line begins.
    pub start: Pose,
    /// Straight lines and arcs, one after the other.
    pub pieces: Vec<LanePiece>,
    /// Metres.
    pub width: f64,
}

/// A straight line or an arc of a lane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LanePiece {
    /// Metres.
    pub length: f64,
    /// 1/m, positive to the left; 0 is straight.
    pub curvature: f64,
}

/// An area in which nobody may drive faster.
/// Where areas overlap, the lowest limit counts; outside of all there is none.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpeedLimit {
    /// Corners of a simple polygon, metres.
    pub points: Vec<[f64; 2]>,
    /// Metres per second.
    pub speed: f64,
}

impl Lane {
    /// Reads a lane: where it begins, its pieces and its width.
    fn read(value: &Value) -> Result<Self, Error> {
        let f = Fields::of(value, &["id", "start", "pieces", "width"])?;
        let piece = |value: &Value| {
            let f = Fields::of(value, &["length", "curvature"])?;
            let curvature = f.maybe("curvature", number)?.unwrap_or(0.0);
            Ok(LanePiece { length: f.need("length", number)?, curvature })
        };
        Ok(Self {
            id: f.maybe("id", owned)?,
            start: f.need("start", pose)?,
            pieces: f.need("pieces", list(piece))?,
            width: f.need("width", number)?,
        })
    }

    /// Pieces must be long, few and bent no tighter than 10 per metre, and no arc may turn farther than a full circle.
    pub(super) fn validate(&self) -> Result<(), Error> {
        finite_pose(self.start).map_err(|e| e.within("start"))?;
        positive("width", self.width)?;
        if self.pieces.is_empty() || self.pieces.len() > MAX_PIECES {
            return bad("pieces", message!("must be 1 to {}, got {}", MAX_PIECES, self.pieces.len()));
        }
        for (i, piece) in self.pieces.iter().enumerate() {
            positive(&format!("pieces[{i}].length"), piece.length)?;
            let turn = piece.curvature * piece.length;
            if !(piece.curvature.abs() <= 10.0 && turn.abs() <= math::TAU) {
                let message =
                    message!("must be at most 10, less than a full circle, got {}", piece.curvature);
                return bad(&format!("pieces[{i}].curvature"), message);
            }
        }
        Ok(())
    }

    /// Its pieces, each with where it begins.
    /// O(pieces).
    pub fn legs(&self) -> Vec<(Pose, LanePiece)> {
        let mut at = self.start;
        let step = |piece: &LanePiece| {
            let from = at;
            at = at.advance(piece.curvature, piece.length);
            (from, *piece)
        };
        self.pieces.iter().map(step).collect()
    }

    /// The point `station` metres along its middle, `left` metres to the left of it.
    /// The heading is that of the lane there. Stations beyond the end continue the last piece.
    pub fn point(&self, station: f64, left: f64) -> Pose {
        let mut at = self.start;
        let mut rest = station;
        for (i, piece) in self.pieces.iter().enumerate() {
            if rest <= piece.length || i + 1 == self.pieces.len() {
                at = at.advance(piece.curvature, rest);
                break;
            }
            rest -= piece.length;
            at = at.advance(piece.curvature, piece.length);
        }
        let beside = at.to_world(Point::new(0.0, left));
        Pose::new(beside.x, beside.y, at.heading)
    }
}

impl SpeedLimit {
    fn read(value: &Value) -> Result<Self, Error> {
        let f = Fields::of(value, &["points", "speed"])?;
        Ok(Self { points: f.need("points", list(point))?, speed: f.need("speed", number)? })
    }

    pub(super) fn validate(&self) -> Result<(), Error> {
        outline("points", &self.points)?;
        positive("speed", self.speed)
    }
}

/// Reads the scene's list of lanes.
pub(super) fn read_lanes(value: &Value) -> Result<Vec<Lane>, Error> {
    list(Lane::read)(value)
}

/// Reads the scene's list of limits.
pub(super) fn read_limits(value: &Value) -> Result<Vec<SpeedLimit>, Error> {
    list(SpeedLimit::read)(value)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::scenario::Scenario;

    fn scene() -> Value {
        json!({
            "version": 1,
            "map": { "origin": [0.0, 0.0], "width": 40, "height": 40, "resolution": 0.5 },
            "lanes": [{ "start": { "x": 1, "y": 2, "heading": 0 },
                "pieces": [{ "length": 4 }, { "length": 3, "curvature": 0.5 }], "width": 3.5 }],
            "speedLimits": [{ "points": [[0, 0], [4, 0], [4, 4]], "speed": 5 }],
            "start": { "x": 2.0, "y": 5.0, "heading": 0.0 },
            "goal": { "x": 12.0, "y": 5.0, "heading": 0.0 },
        })
    }

    #[test]
    fn lanes_and_limits_read_and_write_back() {
        let scenario = Scenario::from_json(&scene()).unwrap();
        assert_eq!(scenario, Scenario::from_json(&serde_json::to_value(&scenario).unwrap()).unwrap());
        let lane = &scenario.lanes[0];
        assert_eq!(lane.point(2.0, 1.0), Pose::new(3.0, 3.0, 0.0));
        assert_eq!(lane.point(7.0, 0.0), Pose::new(5.0, 2.0, 0.0).advance(0.5, 3.0));
        assert_eq!(lane.legs()[1].0, Pose::new(5.0, 2.0, 0.0));
    }

    #[test]
    fn impossible_roads_are_refused_with_words() {
        let cases: [(&str, Value, &str); 5] = [
            ("/lanes/0/pieces", json!([]), "lanes[0].pieces: must be 1 to 2000, got 0"),
            ("/lanes/0/pieces/1/length", json!(-1), "lanes[0].pieces[1].length: must be positive"),
            (
                "/lanes/0/pieces/1/curvature",
                json!(3),
                "lanes[0].pieces[1].curvature: must be at most 10, less than a full",
            ),
            ("/lanes/0/width", json!("wide"), "lanes[0].width: must be a number"),
            ("/speedLimits/0/speed", json!(0), "speedLimits[0].speed: must be positive"),
        ];
        for (place, value, expected) in cases {
            let mut wrong = scene();
            *wrong.pointer_mut(place).unwrap() = value;
            let error = Scenario::from_json(&wrong).unwrap_err().to_string();
            assert!(error.starts_with(expected), "{error}");
        }
    }
}
