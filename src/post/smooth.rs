//! Rounding corners with tangent arcs (Hu et al. 2024, 5.2).
//!
//! The heading becomes continuous; the curvature does not, it jumps between 0 and 1/R. Arcs swing inside the corner,
//! so the path gets shorter and nearer to obstacles.
//!
//! A corner with the change of heading β is replaced by an arc of radius R that touches both segments. It begins the
//! tangent length t before the corner and ends as far behind it:
//!
//! ```text
//! t = R · tan(β/2)        R = t / tan(β/2)        arc = R · β  <  2t = path over the corner
//! ```
//!
//! Two neighbouring corners share a segment, so their tangent lengths together must not exceed it. Within this, the
//! largest R is tried first, since a larger radius needs less steering; after a collision t falls by a fifth, sixteen
//! times at most (t then is 0.8¹⁵, 3.5 %, of the first).

use super::piece::{Piece, distance};
use crate::geometry::math;
use crate::json;
use crate::map::{Cell, Occupancy};

/// How corners share the segment between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SmoothMode {
    /// Each corner may use what the one before it left, and half of the segment ahead; arcs shrink until they are free.
    #[default]
    Dynamic,
    /// Each corner tries the whole segment once.
    Paper,
}

json::words!(SmoothMode: "dynamic" = Dynamic, "paper" = Paper);

/// Farthest that two checked points of an arc are apart, cells.
///
/// Between two checked points a corner of a blocked square can reach over the arc by half of this at most.
const STEP: f64 = 0.1;

/// A path of straight pieces and arcs.
///
/// Pieces join: the end of each is the beginning of the next, and the headings agree except at the `sharp` corners.
#[derive(Debug, Clone, PartialEq)]
pub struct Smoothed {
    /// The pieces from start to goal, each beginning where the one before it ends.
    pub pieces: Vec<Piece>,
    /// Length, cells.
    pub length: f64,
    /// Corners that became arcs.
    pub arcs: u32,
    /// Corners that stayed.
    pub sharp: u32,
    /// Radius of the tightest arc, cells; `None` without arcs.
    pub min_radius: Option<f64>,
}

/// Rounds the corners of a path with arcs of at least `min_radius` cells that stay in free cells and, where cells have
/// weights, cost no more.
///
/// `path` has cells with corners between them, as [`super::prune()`] makes it; a longer row of raw cells leaves no room
/// for arcs. `min_radius` is in cells. A corner for which no such arc exists stays and is counted in
/// [`Smoothed::sharp`]; so does a reversal of the direction. An empty path gives no pieces.
pub fn smooth(map: &Occupancy, path: &[Cell], min_radius: f64, mode: SmoothMode) -> Smoothed {
    let points: Vec<[f64; 2]> = path.iter().map(|c| [f64::from(c.x), f64::from(c.y)]).collect();
    let mut smoothed = Smoothed { pieces: Vec::new(), length: 0.0, arcs: 0, sharp: 0, min_radius: None };
    let Some(&(mut at)) = points.first() else { return smoothed };
    let mut used = 0.0;
    for i in 1..points.len() {
        let corner = points[i];
        let Some(&next) = points.get(i + 1) else {
            smoothed.line(at, corner);
            break;
        };
        let ahead = distance(corner, next);
        let ahead = if mode == SmoothMode::Paper || i + 2 == points.len() { ahead } else { ahead / 2.0 };
        let behind = distance(points[i - 1], corner) - used;
        used = 0.0;
        match Turn::at(points[i - 1], corner, next) {
            Turn::Straight => {}
            Turn::Hairpin => smoothed.sharp += 1,
            Turn::Bend(bend) => match bend.fit(map, behind.min(ahead), min_radius, mode) {
                Some((tangent, arc)) => {
                    smoothed.line(at, arc.point(0.0));
                    smoothed.arc(arc);
                    at = bend.leave(tangent);
                    used = tangent;
                    continue;
                }
                None => smoothed.sharp += 1,
            },
        }
        smoothed.line(at, corner);
        at = corner;
    }
    smoothed
}

impl Smoothed {
    fn line(&mut self, from: [f64; 2], to: [f64; 2]) {
        let piece = Piece::Line { from, to };
        let length = piece.length();
        self.length += length;
        if length > 1e-9 {
            self.pieces.push(piece);
        }
    }

    fn arc(&mut self, arc: Piece) {
        let radius = 1.0 / arc.curvature().abs();
        self.length += arc.length();
        self.arcs += 1;
        self.min_radius = Some(self.min_radius.map_or(radius, |r| r.min(radius)));
        self.pieces.push(arc);
    }
}

/// A corner of a path: an arc, or sharp. A change of heading below 1e-9 rad is none; above π − 0.001 it is a hairpin,
/// for which the tangent length is without bound.
enum Turn {
    Straight,
    Hairpin,
    Bend(Bend),
}

/// A corner that an arc may round.
struct Bend {
    corner: [f64; 2],
    /// Unit vectors to the point before and to the point after.
    back: [f64; 2],
    forth: [f64; 2],
    /// Change of heading, radians, positive.
    angle: f64,
    to_left: bool,
}

impl Turn {
    /// The kind of corner between two segments. Below 1e-9 rad it is no corner; within 1e-3 rad of a half turn no arc
    /// rounds it.
    fn at(before: [f64; 2], corner: [f64; 2], after: [f64; 2]) -> Self {
        let (back, forth) = (unit(corner, before), unit(corner, after));
        let cross = back[0] * forth[1] - back[1] * forth[0];
        let angle = math::atan2(cross.abs(), -(back[0] * forth[0] + back[1] * forth[1]));
        if angle < 1e-9 {
            Self::Straight
        } else if angle > math::PI - 1e-3 {
            Self::Hairpin
        } else {
            Self::Bend(Bend { corner, back, forth, angle, to_left: cross < 0.0 })
        }
    }
}

impl Bend {
    /// The longest free arc and its tangent's length.
    fn fit(&self, map: &Occupancy, longest: f64, min_radius: f64, mode: SmoothMode) -> Option<(f64, Piece)> {
        let tries = if mode == SmoothMode::Paper { 1 } else { 16 };
        let mut tangent = longest;
        for _ in 0..tries {
            let radius = tangent / math::tan(self.angle / 2.0);
            if radius < min_radius || tangent < 1e-6 {
                return None;
            }
            let arc = self.arc(tangent, radius);
            if is_free(map, &arc) && self.is_cheap(map, tangent, &arc) {
                return Some((tangent, arc));
            }
            tangent *= 0.8;
        }
        None
    }

    /// True if the arc costs no more than the corner, where cells have weights.
    fn is_cheap(&self, map: &Occupancy, tangent: f64, arc: &Piece) -> bool {
        let Some(weights) = map.weights() else { return true };
        let along =
            |points: &[[f64; 2]]| -> f64 { points.windows(2).map(|p| weights.along(p[0], p[1])).sum() };
        let start = [self.corner[0] + self.back[0] * tangent, self.corner[1] + self.back[1] * tangent];
        along(&Piece::polyline(&[*arc], STEP)) <= along(&[start, self.corner, self.leave(tangent)])
    }

    /// The arc that touches both segments `tangent` cells from the corner. Its centre is on the bisector, √(R² + t²)
    /// from the corner.
    fn arc(&self, tangent: f64, radius: f64) -> Piece {
        let middle = [self.back[0] + self.forth[0], self.back[1] + self.forth[1]];
        let reach = (radius * radius + tangent * tangent).sqrt() / distance([0.0, 0.0], middle);
        let center = [self.corner[0] + middle[0] * reach, self.corner[1] + middle[1] * reach];
        let start = [self.corner[0] + self.back[0] * tangent, self.corner[1] + self.back[1] * tangent];
        Piece::Arc {
            center,
            radius,
            start_angle: math::atan2(start[1] - center[1], start[0] - center[0]),
            sweep: if self.to_left { self.angle } else { -self.angle },
        }
    }

    /// The point at which an arc with this tangent length meets the next segment.
    fn leave(&self, tangent: f64) -> [f64; 2] {
        [self.corner[0] + self.forth[0] * tangent, self.corner[1] + self.forth[1] * tangent]
    }
}

fn unit(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let length = distance(from, to);
    [(to[0] - from[0]) / length, (to[1] - from[1]) / length]
}

/// True if no point of the arc, each [`STEP`] or less, lies in a blocked cell. The border is blocked.
fn is_free(map: &Occupancy, arc: &Piece) -> bool {
    let intervals = (arc.length() / STEP).ceil().max(1.0);
    (0..=intervals as u32).all(|k| {
        let [x, y] = arc.point(f64::from(k) / intervals);
        !map.blocked(Cell::new((x + 0.5).floor() as i32, (y + 0.5).floor() as i32))
    })
}

#[cfg(test)]
mod tests {
    use std::cell::Cell as Counter;

    use super::*;
    use crate::geometry::{Point, Pose};
    use crate::map::{Corner, line_of_sight};
    use crate::scenario::generate::{Family, SplitMix64, occupancy};

    #[test]
    fn a_right_angle_becomes_a_quarter_circle() {
        let map = Occupancy::new(9, 9);
        let path = [Cell::new(0, 0), Cell::new(4, 0), Cell::new(4, 4)];
        let smoothed = smooth(&map, &path, 1.0, SmoothMode::Dynamic);
        assert_eq!((smoothed.arcs, smoothed.sharp, smoothed.pieces.len()), (1, 0, 1));
        assert!((smoothed.min_radius.unwrap() - 4.0).abs() < 1e-12);
        assert!((smoothed.length - 2.0 * math::PI).abs() < 1e-9);
        assert!(distance(smoothed.pieces[0].point(1.0), [4.0, 4.0]) < 1e-9);
    }

    #[test]
    fn pieces_join_and_blocked_corners_stay_sharp() {
        let map = Occupancy::parse(".....\n.....\n..#..\n.....\n.....");
        let path = [Cell::new(1, 1), Cell::new(3, 1), Cell::new(3, 3), Cell::new(1, 3)];
        let smoothed = smooth(&map, &path, 0.3, SmoothMode::Dynamic);
        assert_eq!((smoothed.arcs, smoothed.sharp), (2, 0));
        for pair in smoothed.pieces.windows(2) {
            assert!(distance(pair[0].point(1.0), pair[1].point(0.0)) < 1e-9);
        }
        let sharp = smooth(&map, &path, 3.0, SmoothMode::Dynamic);
        assert_eq!((sharp.arcs, sharp.sharp, sharp.length), (0, 2, 6.0));
    }

    /// As specified, with other formulas: tangents and radii of the arcs, and how many corners stay. `None` where
    /// rounding decides whether an arc is free.
    fn plain(
        map: &Occupancy,
        points: &[Point],
        least: f64,
        mode: SmoothMode,
    ) -> Option<(Vec<[f64; 2]>, u32)> {
        let (mut arcs, mut sharp, mut used, unclear) = (Vec::new(), 0, 0.0, Counter::new(false));
        for (i, p) in points.windows(3).enumerate() {
            let (come, go) = (p[1] - p[0], p[2] - p[1]);
            let share = if mode == SmoothMode::Paper || i + 3 == points.len() { 1.0 } else { 0.5 };
            let longest = (come.norm() - used).min(share * go.norm());
            let from = math::atan2(come.y, come.x);
            let turn = math::turn(from, math::atan2(go.y, go.x));
            used = 0.0;
            if turn.abs() < 1e-9 {
                continue;
            }
            let radius = |tangent: f64| tangent / math::tan(turn.abs() / 2.0);
            let free = |tangent: f64| {
                let (start, length) = (p[1] - come.normalize() * tangent, radius(tangent) * turn.abs());
                let parts = (length / 0.1).ceil();
                (0..=parts as i32).all(|k| {
                    let along = length * f64::from(k) / parts;
                    let at =
                        Pose::new(start.x, start.y, from).advance(turn.signum() / radius(tangent), along);
                    let near = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)].map(|(x, y)| {
                        let (x, y) = (at.x + 1e-9 * x, at.y + 1e-9 * y);
                        map.blocked(Cell::new(x.round() as i32, y.round() as i32))
                    });
                    unclear.set(unclear.get() || near.contains(&!near[0]));
                    !near[0]
                })
            };
            let tries = if mode == SmoothMode::Paper { 1 } else { 16 };
            let wanted = (0..tries).map(|k| longest * 0.8_f64.powi(k));
            let mut long = wanted.take_while(|&tangent| radius(tangent) >= least && tangent >= 1e-6);
            match long.find(|&tangent| turn.abs() <= math::PI - 1e-3 && free(tangent)) {
                Some(tangent) => {
                    arcs.push([tangent, radius(tangent)]);
                    used = tangent;
                }
                None => sharp += 1,
            }
        }
        (!unclear.get()).then_some((arcs, sharp))
    }

    #[test]
    fn arcs_are_as_long_as_they_may_be() {
        let mut random = SplitMix64::new(3);
        let maps = [1, 2, 3].map(|seed| occupancy(Family::RANDOM, 20, seed).unwrap());
        let (mut round, mut corners) = (0, 0);
        for seed in 0..800 {
            let map = &maps[seed % maps.len()];
            let mut path = vec![Cell::new(0, 0)];
            while path.len() < 7 {
                let at = path[path.len() - 1];
                let to = at.offset(random.below(13) as i32 - 6, random.below(13) as i32 - 6);
                if to != at && line_of_sight(map, at, to, Corner::Strict) {
                    path.push(to);
                }
            }
            let points: Vec<Point> =
                path.iter().map(|c| Point::new(f64::from(c.x), f64::from(c.y))).collect();
            for (mode, least) in [
                (SmoothMode::Paper, 0.0),
                (SmoothMode::Paper, 1.5),
                (SmoothMode::Dynamic, 0.0),
                (SmoothMode::Dynamic, 1.0),
            ] {
                let smoothed = smooth(map, &path, least, mode);
                let Some((arcs, sharp)) = plain(map, &points, least, mode) else { continue };
                assert_eq!((smoothed.arcs as usize, smoothed.sharp), (arcs.len(), sharp), "{seed} {mode:?}");
                let turned = smoothed.pieces.iter().filter_map(|piece| match *piece {
                    Piece::Arc { radius, sweep, .. } => Some([radius * math::tan(sweep.abs() / 2.0), radius]),
                    Piece::Line { .. } => None,
                });
                for (turned, arc) in turned.zip(&arcs) {
                    assert!(distance(turned, *arc) < 1e-9 * arc[1].max(1.0), "{turned:?} {arc:?}");
                }
                let tightest = arcs.iter().map(|arc| arc[1]).reduce(f64::min);
                assert!(smoothed.min_radius.zip(tightest).is_none_or(|(a, b)| (a - b).abs() < 1e-9));
                assert_eq!(smoothed.min_radius.is_some(), tightest.is_some());
                let length: f64 = smoothed.pieces.iter().map(Piece::length).sum();
                assert!((smoothed.length - length).abs() < 1e-6);
                let ends = [&smoothed.pieces[0], &smoothed.pieces[smoothed.pieces.len() - 1]];
                let ends = [ends[0].point(0.0), ends[1].point(1.0)].map(|[x, y]| Point::new(x, y));
                assert!((ends[0] - points[0]).norm() + (ends[1] - points[points.len() - 1]).norm() < 1e-9);
                let mut kinks = 0;
                for pair in smoothed.pieces.windows(2) {
                    assert!(distance(pair[0].point(1.0), pair[1].point(0.0)) < 1e-8);
                    kinks += u32::from(math::turn(pair[0].heading(1.0), pair[1].heading(0.0)).abs() > 1e-6);
                }
                assert_eq!(kinks, sharp);
                (round, corners) = (round + arcs.len(), corners + sharp);
            }
        }
        assert!(round > 3000 && corners > 500, "{round} {corners}");
    }

    #[test]
    fn short_and_straight_paths() {
        let map = Occupancy::new(9, 9);
        let line = [Cell::new(0, 0), Cell::new(2, 2), Cell::new(5, 5)];
        assert!(smooth(&map, &line[..1], 1.0, SmoothMode::Dynamic).pieces.is_empty());
        let smoothed = smooth(&map, &line, 1.0, SmoothMode::Paper);
        assert_eq!((smoothed.arcs, smoothed.sharp, smoothed.pieces.len()), (0, 0, 2));
    }
}
