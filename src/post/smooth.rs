//! Rounding corners with tangent arcs (Hu et al. 2024, 5.2).
//!
//! The heading becomes continuous; the curvature does not, it jumps between 0 and 1/R. Arcs swing inside the corner,
//! so the path gets shorter and nearer to obstacles.

use super::piece::{Piece, distance};
use crate::geometry::math;
use crate::map::{Cell, Occupancy};
use crate::planners::settings::SmoothMode;

/// Farthest that two checked points of an arc are apart, cells.
const STEP: f64 = 0.1;

/// A path of straight pieces and arcs.
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

/// Rounds the corners of a path with arcs of at least `min_radius` cells that stay in free cells and, where cells have weights,
/// cost no more.
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

/// What a path does at a corner.
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

    /// Whether the arc costs no more than the corner, where cells have weights.
    fn is_cheap(&self, map: &Occupancy, tangent: f64, arc: &Piece) -> bool {
        let Some(weights) = map.weights() else { return true };
        let along =
            |points: &[[f64; 2]]| -> f64 { points.windows(2).map(|p| weights.along(p[0], p[1])).sum() };
        let start = [self.corner[0] + self.back[0] * tangent, self.corner[1] + self.back[1] * tangent];
        along(&Piece::polyline(&[*arc], STEP)) <= along(&[start, self.corner, self.leave(tangent)])
    }

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

    /// Where an arc with this tangent's length meets the next segment.
    fn leave(&self, tangent: f64) -> [f64; 2] {
        [self.corner[0] + self.forth[0] * tangent, self.corner[1] + self.forth[1] * tangent]
    }
}

fn unit(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let length = distance(from, to);
    [(to[0] - from[0]) / length, (to[1] - from[1]) / length]
}

fn is_free(map: &Occupancy, arc: &Piece) -> bool {
    let intervals = (arc.length() / STEP).ceil().max(1.0);
    (0..=intervals as u32).all(|k| {
        let [x, y] = arc.point(f64::from(k) / intervals);
        !map.blocked(Cell::new((x + 0.5).floor() as i32, (y + 0.5).floor() as i32))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn short_and_straight_paths() {
        let map = Occupancy::new(9, 9);
        let line = [Cell::new(0, 0), Cell::new(2, 2), Cell::new(5, 5)];
        assert!(smooth(&map, &line[..1], 1.0, SmoothMode::Dynamic).pieces.is_empty());
        let smoothed = smooth(&map, &line, 1.0, SmoothMode::Paper);
        assert_eq!((smoothed.arcs, smoothed.sharp, smoothed.pieces.len()), (0, 0, 2));
    }
}
