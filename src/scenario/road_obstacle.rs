//! A road as it is drawn: a line with rounded corners, lanes to both sides, kerbs.
//!
//! The geometry of a bend: two straight lines meet at an angle that turns by δ. An arc of radius r touches both at
//! the distance
//!
//! ```text
//! t = r · tan(δ/2)
//! ```
//!
//! from the corner. A line between two corners has room for two such tangents, so each bend may use half of it and a
//! bend beside an end all of it; where that is too short for the radius, the radius shrinks. The inner edge of the
//! road then has the radius r less half the width, which must stay above half a metre.
//!
//! Kerbs are polylines that stray from their arcs by a millimetre at most: an arc of radius r may be cut into chords
//! of √(8·r·s) for a deviation of s. Where another road's surface lies, the kerb is cut out, which makes junctions
//! without naming them.

use serde::Serialize;
use serde_json::Value;

use super::checks::{bad, corners, positive};
use super::places::point;
use super::road::{Lane, LanePiece, SpeedLimit};
use crate::error::Error;
use crate::geometry::{Point, Pose, math, polygon};
use crate::json::{Fields, count, exactly, flag, list, number, owned};

/// Most lanes of a direction.
const MOST_LANES: u32 = 8;
/// The inner edge of a bend has at least this radius, metres.
const INNER: f64 = 0.5;
/// How far edges of arcs stray from them, metres.
const STRAY: f64 = 0.001;

/// A road. Its kerbs, where it has any, are walls without thickness at both sides, open where another road meets it;
/// its ends are open. Traffic keeps to the right.
/// Right-hand traffic: lanes along the line lie to the right of its middle where both directions have the same
/// number.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename = "road", rename_all = "camelCase")]
pub struct Road {
    /// Name for messages and selection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// Corners of its middle line, metres.
    pub points: Vec<[f64; 2]>,
    /// Radius of the middle line at corners, metres; smaller where the way to the next corner is too short.
    pub radius: f64,
    /// Lanes along the line, and against it.
    pub lanes: [u32; 2],
    /// Width of one lane, metres.
    pub lane_width: f64,
    /// Speed limit, metres per second.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// True if its sides are kerbs.
    pub kerbs: bool,
}

/// A straight line (curvature 0) or an arc.
///
/// The length is in metres, the curvature in 1/m and positive to the left.
#[derive(Clone, Copy)]
struct Piece {
    length: f64,
    curvature: f64,
}

impl Road {
    /// Reads a road: lanes of 3.5 m, one each way, corners of 20 m and kerbs where nothing else is said.
    pub(super) fn read(value: &Value) -> Result<Self, Error> {
        let known = ["type", "id", "points", "radius", "lanes", "laneWidth", "speed", "kerbs"];
        let f = Fields::of(value, &known)?;
        Ok(Self {
            id: f.maybe("id", owned)?,
            points: f.need("points", list(point))?,
            radius: f.maybe("radius", number)?.unwrap_or(20.0),
            lanes: f.maybe("lanes", exactly(count))?.unwrap_or([1, 1]),
            lane_width: f.maybe("laneWidth", number)?.unwrap_or(3.5),
            speed: f.maybe("speed", number)?,
            kerbs: f.maybe("kerbs", flag)?.unwrap_or(true),
        })
    }

    /// Distinct corners, 1 to 16 lanes, and bends whose inner edge is no point.
    pub(super) fn validate(&self) -> Result<(), Error> {
        corners("points", &self.points, 2)?;
        positive("radius", self.radius)?;
        positive("laneWidth", self.lane_width)?;
        if let Some(speed) = self.speed {
            positive("speed", speed)?;
        }
        if self.lanes.iter().any(|&n| n > MOST_LANES) || self.lanes == [0, 0] {
            let [with, against] = self.lanes;
            return bad(
                "lanes",
                message!("must be 0 to {} each, one at least, got [{}, {}]", MOST_LANES, with, against),
            );
        }
        for (i, pair) in self.points.windows(2).enumerate() {
            if pair[0] == pair[1] {
                return bad(&format!("points[{}]", i + 1), "must differ from the point before it".into());
            }
        }
        for (i, corner) in self.bends().into_iter().enumerate() {
            let radius = corner.curvature.abs().recip();
            if radius < self.half() + INNER {
                let message = message!(
                    "must turn less or have longer ways beside it: the middle's radius is {} m, half the \
                     road {} m wide",
                    format_args!("{:.2}", radius),
                    format_args!("{:.2}", self.half())
                );
                return bad(&format!("points[{}]", i + 1), message);
            }
        }
        Ok(())
    }

    /// Half its width, metres.
    fn half(&self) -> f64 {
        self.lane_width * f64::from(self.lanes[0] + self.lanes[1]) / 2.0
    }

    /// Length and heading of each straight line between two corners.
    fn ways(&self) -> Vec<(f64, f64)> {
        let way = |w: &[[f64; 2]]| {
            let (dx, dy) = (w[1][0] - w[0][0], w[1][1] - w[0][1]);
            (math::hypot(dx, dy), math::atan2(dy, dx))
        };
        self.points.windows(2).map(way).collect()
    }

    /// The arc at every inner corner; a straight line of no length where it does not turn.
    fn bends(&self) -> Vec<Piece> {
        let ways = self.ways();
        let last = ways.len() - 1;
        let bend = |i: usize| {
            let turn = math::turn(ways[i].1, ways[i + 1].1);
            if turn.abs() < 1e-9 {
                return Piece { length: 0.0, curvature: 0.0 };
            }
            // A way between two corners is half each one's.
            let room = |k: usize, end: bool| if end { ways[k].0 } else { ways[k].0 / 2.0 };
            let room = room(i, i == 0).min(room(i + 1, i + 1 == last));
            let radius = self.radius.min(room / math::tan(turn.abs() / 2.0));
            Piece { length: radius * turn.abs(), curvature: turn.signum() / radius }
        };
        (0..last).map(bend).collect()
    }

    /// Its middle line.
    fn line(&self) -> (Pose, Vec<Piece>) {
        let (ways, bends) = (self.ways(), self.bends());
        let tangent = |bend: Option<&Piece>| {
            bend.filter(|b| b.length > 0.0)
                .map_or(0.0, |b| math::tan(b.length * b.curvature.abs() / 2.0) / b.curvature.abs())
        };
        let mut pieces = Vec::new();
        for (i, (length, _)) in ways.iter().enumerate() {
            let before = tangent(i.checked_sub(1).and_then(|k| bends.get(k)));
            let straight = length - before - tangent(bends.get(i));
            if straight > 1e-9 {
                pieces.push(Piece { length: straight, curvature: 0.0 });
            }
            pieces.extend(bends.get(i).filter(|b| b.length > 0.0));
        }
        (Pose::new(self.points[0][0], self.points[0][1], ways[0].1), pieces)
    }

    /// The line `left` metres to the left of its middle.
    fn edge(&self, left: f64) -> Vec<Point> {
        let (mut at, pieces) = self.line();
        let mut points = vec![at.to_world(Point::new(0.0, left))];
        for Piece { length, curvature } in pieces {
            let radius = curvature.abs().recip() + left.abs();
            let parts =
                if curvature == 0.0 { 1.0 } else { (length / (8.0 * STRAY * radius).sqrt()).ceil().max(1.0) };
            for k in 1..=parts as u32 {
                let pose = at.advance(curvature, length * f64::from(k) / parts);
                points.push(pose.to_world(Point::new(0.0, left)));
            }
            at = at.advance(curvature, length);
        }
        points
    }

    /// Its surface.
    fn outline(&self) -> Vec<Point> {
        let mut outline = self.edge(-self.half());
        outline.extend(self.edge(self.half()).into_iter().rev());
        outline
    }
}

/// The kerbs of `roads[i]`: its sides where no other road's surface is.
pub(super) fn kerbs(roads: &[&Road], i: usize) -> Vec<(Point, Point)> {
    let road = roads[i];
    if !road.kerbs {
        return Vec::new();
    }
    let others: Vec<Vec<Point>> =
        roads.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, r)| r.outline()).collect();
    let mut kerbs = Vec::new();
    for side in [-road.half(), road.half()] {
        for pair in road.edge(side).windows(2) {
            outside(pair[0], pair[1], &others, &mut kerbs);
        }
    }
    kerbs
}

/// The parts of a segment in none of these polygons.
/// The segment is cut where it crosses an edge, and the middle of each part decides about the part. O(edges).
fn outside(a: Point, b: Point, polygons: &[Vec<Point>], parts: &mut Vec<(Point, Point)>) {
    let way = b - a;
    let mut cuts = vec![0.0, 1.0];
    for polygon in polygons {
        for (i, &p) in polygon.iter().enumerate() {
            let edge = polygon[(i + 1) % polygon.len()] - p;
            let across = way.perp(&edge);
            if across == 0.0 {
                continue;
            }
            let (along, there) = ((p - a).perp(&edge) / across, (p - a).perp(&way) / across);
            if (0.0..=1.0).contains(&there) && along > 0.0 && along < 1.0 {
                cuts.insert(cuts.partition_point(|c| *c < along), along);
            }
        }
    }
    for pair in cuts.windows(2).filter(|w| w[1] - w[0] > 1e-9) {
        let middle = a + way * f64::midpoint(pair[0], pair[1]);
        if !polygons.iter().any(|polygon| polygon::contains(polygon, middle)) {
            parts.push((a + way * pair[0], a + way * pair[1]));
        }
    }
}

impl Road {
    /// The lanes on which a car gets from near one point to near the other: those along the line where it comes first
    /// on it, those against it otherwise; where there are none, the others.
    pub(super) fn lanes_between(&self, start: Point, goal: Point) -> Vec<Lane> {
        let [with, against] = self.lanes;
        let forward = self.station(start) <= self.station(goal);
        let (start, pieces) = self.line();
        let half = self.half();
        let lane = |left: f64, back: bool| {
            let beside = |p: &Piece| LanePiece {
                length: p.length * (1.0 - left * p.curvature),
                curvature: p.curvature / (1.0 - left * p.curvature),
            };
            let from = start.to_world(Point::new(0.0, left));
            let mut lane = Lane {
                id: self.id.clone(),
                start: Pose::new(from.x, from.y, start.heading),
                pieces: pieces.iter().map(beside).collect(),
                width: self.lane_width,
            };
            if back {
                let length = lane.pieces.iter().fold(0.0, |sum, p| sum + p.length);
                let end = lane.point(length, 0.0);
                lane.start = Pose::new(end.x, end.y, math::wrap(end.heading + math::PI));
                lane.pieces.reverse();
                lane.pieces.iter_mut().for_each(|p| p.curvature = -p.curvature);
            }
            lane
        };
        let middle = |k: u32| self.lane_width * (f64::from(k) + 0.5) - half;
        if (forward && with > 0) || against == 0 {
            (0..with).map(|k| lane(middle(k), false)).collect()
        } else {
            (0..against).map(|k| lane(-middle(k), true)).collect()
        }
    }

    /// Its surface with its limit, if it has one.
    pub(super) fn limit(&self) -> Option<SpeedLimit> {
        let points = || self.outline().iter().map(|p| [p.x, p.y]).collect();
        self.speed.map(|speed| SpeedLimit { points: points(), speed })
    }

    /// How far along the middle line the point nearest to `p` is.
    fn station(&self, p: Point) -> f64 {
        let mut best = (f64::INFINITY, 0.0);
        let mut station = 0.0;
        for pair in self.edge(0.0).windows(2) {
            let (way, length) = (pair[1] - pair[0], (pair[1] - pair[0]).norm());
            let along = ((p - pair[0]).dot(&way) / length).clamp(0.0, length);
            let away = (p - (pair[0] + way * (along / length))).norm();
            if away < best.0 {
                best = (away, station + along);
            }
            station += length;
        }
        best.1
    }
}
