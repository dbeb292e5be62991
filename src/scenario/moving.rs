//! Boxes that move.
//!
//! A box knows nothing of the car: its position is a function of time alone, and time 0 is the moment at which the
//! car could set off. The search ignores it; a drive along a finished path stops before it and waits (`drive`).

use serde::Serialize;
use serde_json::Value;

use super::checks::{bad, corners, positive};
use super::places::point;
use crate::error::Error;
use crate::json::{Fields, list, number, owned};

/// A box that follows a line at constant speed, its length along its motion. It stands at the first point before its
/// start and at the last one after its arrival, and can be run into at any time.
/// At a corner of its line it turns at once; between two points its heading is that of the line.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MovingObstacle {
    /// Name for messages and selection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// The way of the box's centre, metres.
    pub points: Vec<[f64; 2]>,
    /// Length along the motion and width across it, metres.
    pub size: [f64; 2],
    /// Metres per second.
    pub speed: f64,
    /// When it starts to move, seconds after the car could.
    pub start: f64,
}

impl MovingObstacle {
    /// Reads one box; `start` may be left out and is 0 then.
    pub(super) fn read(value: &Value) -> Result<Self, Error> {
        let f = Fields::of(value, &["id", "points", "size", "speed", "start"])?;
        Ok(Self {
            id: f.maybe("id", owned)?,
            points: f.need("points", list(point))?,
            size: f.need("size", point)?,
            speed: f.need("speed", number)?,
            start: f.maybe("start", number)?.unwrap_or(0.0),
        })
    }

    /// Two points at least, none twice in a row, and a size, speed and start within their ranges.
    pub(super) fn validate(&self) -> Result<(), Error> {
        corners("points", &self.points, 2)?;
        if let Some(i) = self.points.windows(2).position(|pair| pair[0] == pair[1]) {
            return bad(&format!("points[{}]", i + 1), "must differ from the point before it".into());
        }
        positive("size[0]", self.size[0])?;
        positive("size[1]", self.size[1])?;
        positive("speed", self.speed)?;
        if self.start >= 0.0 && self.start <= 1e6 {
            return Ok(());
        }
        bad("start", message!("must be 0 to 1e6 s, got {}", self.start))
    }
}

/// Reads the scene's list.
pub(super) fn read_all(value: &Value) -> Result<Vec<MovingObstacle>, Error> {
    list(MovingObstacle::read)(value)
}
