//! Corners and edges of obstacles, and the body's signed distances to them with derivatives.
//!
//! A corner of the body is held against edges, a corner of an obstacle against the body's rectangle; between convex
//! outlines that come near each other, one of the two is the nearest. Distances below zero are depths.
//!
//! The optimiser needs more than whether the body is free: how far it is from each obstacle, and how that changes with
//! the pose. For the corner p of the body at the arm r from the rear axle (world frame, R its quarter turn to the left)
//! and an edge with the normal n, the distance and its slopes are
//!
//! ```text
//! d = n · (p − a)        ∂d/∂(x, y) = n        ∂d/∂θ = n · R r
//! ```
//!
//! For an obstacle's corner in the car's frame it is the distance to a rectangle, whose slopes have the opposite sign,
//! because the point moves against the car. Both are exact, so Gauss–Newton steps need no differences. Behind an edge
//! the value goes on below zero as long as that edge is the nearest way out of its outline; deeper than 0.6 m it is not
//! counted, since the direction out is then arbitrary.
//!
//! All coordinates are relative to an origin near the car, so that far from the world's origin no digits are lost.

use super::segment::{HEADING, Node, X, Y};
use crate::geometry::polygon::{crosses_ray, nearest_share};
use crate::geometry::{Point, Vector, math};
use crate::scenario::resolve::{Form, Geometry};
use crate::vehicle::Vehicle;

/// Side of a bucket, metres.
const BUCKET: f64 = 2.0;
/// Most buckets on a side.
const MOST: f64 = 256.0;
/// A corner of the body deeper behind an edge than this is not held against it, metres.
const DEEPEST: f64 = 0.6;

/// Something that the body is held against.
///
/// `along` is a unit vector, and the free side's normal is its quarter turn to the left.
#[derive(Debug, Clone, Copy)]
enum Feature {
    /// A corner that sticks out.
    Corner(Point),
    /// An edge whose free side is on the left of the way from its first end to its second; of a wall without thickness
    /// both sides are free. With the number of its outline.
    Edge { a: Point, along: Vector, length: f64, outline: u32, is_wall: bool },
}

/// A signed distance and its slopes by x, y and heading.
///
/// Metres, and metres per metre or radian. The gradient of the distance by position has length 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Distance {
    pub(super) value: f64,
    pub(super) slopes: [f64; 3],
}

/// Obstacles sorted into buckets.
///
/// Outline 0 is the floor's boundary. Buckets are squares of `side` metres, row by row from `low`; what lies outside is
/// in the nearest outermost bucket.
pub(super) struct Features {
    vehicle: Vehicle,
    all: Vec<Feature>,
    outlines: Vec<Vec<Point>>,
    low: Point,
    side: f64,
    columns: usize,
    rows: usize,
    buckets: Vec<Vec<u32>>,
}

/// Positive for an outline that goes counter-clockwise.
fn doubled_area(outline: &[Point]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).fold(0.0, |sum, (a, b)| sum + a.x * b.y - b.x * a.y)
}

impl Features {
    /// The obstacles of a scene, relative to `origin`.
    ///
    /// Linear in the edges and the buckets that they cross. Edges of no length are left out.
    pub(super) fn new(geometry: &Geometry, origin: Point) -> Self {
        let local = |p: &Point| Point::from(p - origin);
        let (mut features, mut outlines) = (Vec::new(), Vec::new());
        let mut ring = |outline: &[Point], is_floor: bool| {
            // With the free side on the left: floors counter-clockwise, obstacles clockwise.
            let mut outline: Vec<Point> = outline.iter().map(local).collect();
            if (doubled_area(&outline) > 0.0) != is_floor {
                outline.reverse();
            }
            let n = outline.len();
            for i in 0..n {
                let (before, a, b) = (outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]);
                let length = (b - a).norm();
                if length > 0.0 {
                    let along = (b - a) / length;
                    features.push(Feature::Edge {
                        a,
                        along,
                        length,
                        outline: outlines.len() as u32,
                        is_wall: false,
                    });
                }
                // The way round an outline turns away from the free side where the corner sticks out.
                if (a - before).perp(&(b - a)) < 0.0 {
                    features.push(Feature::Corner(a));
                }
            }
            outlines.push(outline);
        };
        ring(&geometry.boundary, true);
        for shape in &geometry.shapes {
            if let Form::Polygon(points) = &shape.form {
                ring(points, false);
            }
        }
        for shape in &geometry.shapes {
            if let Form::Segment(a, b) = shape.form {
                let (a, b) = (local(&a), local(&b));
                let length = (b - a).norm();
                features.extend([Feature::Corner(a), Feature::Corner(b)]);
                if length > 0.0 {
                    let along = (b - a) / length;
                    features.push(Feature::Edge { a, along, length, outline: u32::MAX, is_wall: true });
                }
            }
        }
        Self::sorted(geometry, features, outlines)
    }

    /// Puts each feature into the buckets that it passes, not only those of its bounding box: a long slanting wall
    /// would fill them all.
    fn sorted(geometry: &Geometry, features: Vec<Feature>, outlines: Vec<Vec<Point>>) -> Self {
        let mut low = outlines[0][0];
        let mut high = low;
        for p in &outlines[0] {
            (low.x, low.y) = (low.x.min(p.x), low.y.min(p.y));
            (high.x, high.y) = (high.x.max(p.x), high.y.max(p.y));
        }
        let side = BUCKET.max((high.x - low.x).max(high.y - low.y) / MOST);
        let (columns, rows) =
            (((high.x - low.x) / side) as usize + 1, ((high.y - low.y) / side) as usize + 1);
        let mut sorted = Self {
            vehicle: geometry.vehicle,
            all: features,
            outlines,
            low,
            side,
            columns,
            rows,
            buckets: vec![Vec::new(); columns * rows],
        };
        for i in 0..sorted.all.len() {
            let (a, b) = match sorted.all[i] {
                Feature::Corner(p) => (p, p),
                Feature::Edge { a, along, length, .. } => (a, a + along * length),
            };
            let (lower, upper) =
                (Point::new(a.x.min(b.x), a.y.min(b.y)), Point::new(a.x.max(b.x), a.y.max(b.y)));
            for bucket in sorted.range(lower, upper) {
                let from =
                    sorted.low + Vector::new((bucket % columns) as f64, (bucket / columns) as f64) * side;
                if touches(a, b, from, side) {
                    sorted.buckets[bucket].push(i as u32);
                }
            }
        }
        sorted
    }

    /// The buckets that a box touches.
    fn range(&self, low: Point, high: Point) -> impl Iterator<Item = usize> + use<> {
        let clamp = |v: f64, n: usize| (v / self.side).floor().clamp(0.0, (n - 1) as f64) as usize;
        let (x0, x1) = (clamp(low.x - self.low.x, self.columns), clamp(high.x - self.low.x, self.columns));
        let (y0, y1) = (clamp(low.y - self.low.y, self.rows), clamp(high.y - self.low.y, self.rows));
        let columns = self.columns;
        (y0..=y1).flat_map(move |y| (x0..=x1).map(move |x| y * columns + x))
    }

    /// The features that a car at `node` may come nearer to than `reach` metres, each once. `found` is emptied first;
    /// the indices ascend.
    ///
    /// The test is conservative: a feature that is left out is farther away than `reach`, one that is kept may be, too.
    pub(super) fn near(&self, node: &Node, reach: f64, found: &mut Vec<u32>) {
        let (sin, cos) = math::sin_cos(node[HEADING]);
        let middle = Point::new(node[X] + cos * self.vehicle.middle(), node[Y] + sin * self.vehicle.middle());
        let half = [self.vehicle.length() / 2.0 + reach, self.vehicle.width / 2.0 + reach];
        // The rectangle's bounding box.
        let size =
            Vector::new(half[0] * cos.abs() + half[1] * sin.abs(), half[0] * sin.abs() + half[1] * cos.abs());
        found.clear();
        for bucket in self.range(middle - size, middle + size) {
            found.extend(&self.buckets[bucket]);
        }
        found.sort_unstable();
        found.dedup();
        let local = |p: Point| {
            let d = p - middle;
            [d.x * cos + d.y * sin, d.y * cos - d.x * sin]
        };
        found.retain(|&i| match self.all[i as usize] {
            Feature::Corner(p) => {
                let p = local(p);
                p[0].abs() <= half[0] && p[1].abs() <= half[1]
            }
            Feature::Edge { a, along, length, .. } => {
                let (p, q) = (local(a), local(a + along * length));
                // Apart by an axis of the rectangle or by the edge's own normal.
                let beside = |k: usize| p[k].min(q[k]) > half[k] || p[k].max(q[k]) < -half[k];
                let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
                let off = (p[0] * dy - p[1] * dx).abs();
                !(beside(0) || beside(1) || off > half[0] * dy.abs() + half[1] * dx.abs())
            }
        });
    }

    /// Tells every signed distance of the car at `node` to a feature that is less than `reach`.
    ///
    /// `features` are indices from [`Features::near`] for this pose or one close to it. The same obstacle may be told
    /// several times, as corner and as edge; each violation counts on its own.
    pub(super) fn distances(
        &self,
        node: &Node,
        features: &[u32],
        reach: f64,
        each: &mut impl FnMut(Distance),
    ) {
        let (sin, cos) = math::sin_cos(node[HEADING]);
        let (front, back, side) =
            (self.vehicle.rear_to_front, -self.vehicle.rear_to_back, self.vehicle.width / 2.0);
        let at = Point::new(node[X], node[Y]);
        let arms = [(front, side), (back, side), (back, -side), (front, -side)]
            .map(|(x, y)| Vector::new(x * cos - y * sin, x * sin + y * cos));
        let middle = at + Vector::new(cos, sin) * self.vehicle.middle();
        for &i in features {
            match self.all[i as usize] {
                Feature::Corner(p) => {
                    let d = p - at;
                    let local = [d.x * cos + d.y * sin, d.y * cos - d.x * sin];
                    let distance = outside(local, [back, front], side, (sin, cos));
                    if distance.value < reach {
                        each(distance);
                    }
                }
                Feature::Edge { a, along, length, outline, is_wall } => {
                    let mut normal = Vector::new(-along.y, along.x);
                    if is_wall && normal.dot(&(middle - a)) < 0.0 {
                        normal = -normal;
                    }
                    for arm in arms {
                        let from = at + arm - a;
                        let (station, value) = (along.dot(&from), normal.dot(&from));
                        if value >= reach || value < -DEEPEST || station < 0.0 || station > length {
                            continue;
                        }
                        if value < 0.0 {
                            let is_there = if is_wall {
                                // The way from the body's middle to its corner may lead past the wall's end.
                                let (back, depth) = (middle - at - arm, normal.dot(&(middle - a)) - value);
                                (0.0..=length).contains(&(station - value / depth * along.dot(&back)))
                            } else {
                                self.is_nearest(outline, at + arm, -value)
                            };
                            if !is_there {
                                continue;
                            }
                        }
                        each(Distance {
                            value,
                            slopes: [normal.x, normal.y, normal.y * arm.x - normal.x * arm.y],
                        });
                    }
                }
            }
        }
    }

    /// True if a point behind an edge, at a depth, is blocked there and no nearer to another edge of that outline.
    fn is_nearest(&self, outline: u32, p: Point, depth: f64) -> bool {
        let ring = &self.outlines[outline as usize];
        let mut is_inside = false;
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            is_inside ^= crosses_ray(a, b, p);
            if (p - a - (b - a) * nearest_share(p, a, b)).norm_squared() < depth * depth * (1.0 - 1e-9) {
                return false;
            }
        }
        // The floor's outline blocks outside, the others inside.
        is_inside != (outline == 0)
    }
}

/// True if a segment and a square have a point in common.
fn touches(a: Point, b: Point, from: Point, side: f64) -> bool {
    let (d, c) = (b - a, from + Vector::new(side, side) / 2.0 - a);
    (d.perp(&c)).abs() <= side / 2.0 * (d.x.abs() + d.y.abs()) * (1.0 + 1e-9) + 1e-9
}

/// From a point in the car's frame to its rectangle, x from `ends[0]` to `ends[1]` and y within `side`.
///
/// In front and to the side at once, the nearest point is a corner of the rectangle; otherwise the larger of both
/// excesses counts, which inside is the least depth.
fn outside(p: [f64; 2], ends: [f64; 2], side: f64, (sin, cos): (f64, f64)) -> Distance {
    let (dx, dy) = ((p[0] - ends[1]).max(ends[0] - p[0]), p[1].abs() - side);
    let (sx, sy) =
        (if p[0] - ends[1] > ends[0] - p[0] { 1.0 } else { -1.0 }, if p[1] < 0.0 { -1.0 } else { 1.0 });
    let (value, nx, ny) = if dx > 0.0 && dy > 0.0 {
        let value = (dx * dx + dy * dy).sqrt();
        (value, sx * dx / value, sy * dy / value)
    } else if dx > dy {
        (dx, sx, 0.0)
    } else {
        (dy, 0.0, sy)
    };
    // The point moves in the car's frame against the car.
    Distance { value, slopes: [-(nx * cos - ny * sin), -(nx * sin + ny * cos), nx * p[1] - ny * p[0]] }
}

#[cfg(test)]
mod tests;
