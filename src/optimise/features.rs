//! Corners and edges of obstacles, and the body's signed distances to them with derivatives.
//!
//! A corner of the body is held against edges, a corner of an obstacle against the body's rectangle; between convex
//! outlines that come near each other, one of the two is the nearest. Distances below zero are depths.

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
#[derive(Debug, Clone, Copy)]
enum Feature {
    /// A corner that sticks out.
    Corner(Point),
    /// An edge whose free side is on the left of the way from its first end to its second; of a wall without thickness
    /// both sides are free. With the number of its outline.
    Edge { a: Point, along: Vector, length: f64, outline: u32, is_wall: bool },
}

/// A signed distance and its slopes by x, y and heading.
#[derive(Debug, Clone, Copy)]
pub(super) struct Distance {
    pub(super) value: f64,
    pub(super) slopes: [f64; 3],
}

/// Obstacles sorted into buckets.
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

fn doubled_area(outline: &[Point]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).fold(0.0, |sum, (a, b)| sum + a.x * b.y - b.x * a.y)
}

impl Features {
    /// The obstacles of a scene, relative to `origin`.
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

    fn range(&self, low: Point, high: Point) -> impl Iterator<Item = usize> + use<> {
        let clamp = |v: f64, n: usize| (v / self.side).floor().clamp(0.0, (n - 1) as f64) as usize;
        let (x0, x1) = (clamp(low.x - self.low.x, self.columns), clamp(high.x - self.low.x, self.columns));
        let (y0, y1) = (clamp(low.y - self.low.y, self.rows), clamp(high.y - self.low.y, self.rows));
        let columns = self.columns;
        (y0..=y1).flat_map(move |y| (x0..=x1).map(move |x| y * columns + x))
    }

    /// The features that a car at `node` may come nearer to than `reach` metres, each once.
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
mod tests {
    use super::*;
    use crate::geometry::Pose;
    use crate::scenario::resolve::{Owner, Shape};

    fn scene(shapes: Vec<Form>) -> Features {
        let boundary = [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)].map(|(x, y)| Point::new(x, y));
        let shapes = shapes.into_iter().map(|form| Shape { owner: Owner::Obstacle(0), form }).collect();
        Features::new(
            &Geometry {
                start: Pose::default(),
                goal: Pose::default(),
                goals: None,
                vehicle: Vehicle::PAPER,
                boundary: boundary.to_vec(),
                shapes,
                parked: Vec::new(),
            },
            Point::origin(),
        )
    }

    fn least(features: &Features, node: &Node) -> Option<Distance> {
        let (mut near, mut least) = (Vec::new(), None::<Distance>);
        features.near(node, 1.0, &mut near);
        features.distances(node, &near, 1.0, &mut |d| {
            if least.is_none_or(|l| d.value < l.value) {
                least = Some(d);
            }
        });
        least
    }

    #[test]
    fn a_wall_beside_which_a_car_turns_is_not_in_it() {
        // The middle is left of the wall's line, beyond its end; a corner is right of the line, beside the wall.
        let features = scene(vec![Form::Segment(Point::new(10.0, 4.0), Point::new(10.0, 9.0))]);
        let car = Vehicle::PAPER;
        let end = Pose::new(10.0, 9.0, -0.87);
        let beside = end.to_world(Point::new(-0.3 * car.length(), car.width / 2.0 + 0.15));
        let rear = Pose::new(beside.x, beside.y, end.heading).advance(0.0, -car.middle());
        let turned = least(&features, &[rear.x, rear.y, rear.heading, 0.0, 0.0]);
        let through = least(&features, &[10.5 - car.rear_to_front, 6.0, 0.0, 0.0, 0.0]);
        assert!(turned.is_none_or(|d| d.value > 0.0), "{turned:?}");
        assert!(through.is_some_and(|d| d.value < -0.4), "{through:?}");
    }

    #[test]
    fn distances_are_those_of_the_checker_and_slopes_are_differences() {
        let blocks = [[3.0, 3.0, 6.0, 5.0], [9.0, 2.0, 9.4, 9.0], [12.0, 12.0, 16.0, 16.0]];
        let forms = blocks.map(|[l, b, r, t]| {
            Form::Polygon([(l, b), (r, b), (r, t), (l, t)].map(|(x, y)| Point::new(x, y)).to_vec())
        });
        let wall = Form::Segment(Point::new(2.0, 14.0), Point::new(7.0, 18.0));
        let features = scene([forms.to_vec(), vec![wall]].concat());
        let body = {
            let shapes =
                [forms.to_vec(), vec![Form::Segment(Point::new(2.0, 14.0), Point::new(7.0, 18.0))]].concat();
            crate::metrics::Body::new(&Geometry {
                start: Pose::default(),
                goal: Pose::default(),
                goals: None,
                vehicle: Vehicle::PAPER,
                boundary: [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)]
                    .map(|(x, y)| Point::new(x, y))
                    .to_vec(),
                shapes: shapes.into_iter().map(|form| Shape { owner: Owner::Obstacle(0), form }).collect(),
                parked: Vec::new(),
            })
        };
        let mut seed = 5_u64;
        let mut draw = |most: f64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            most * (seed >> 33) as f64 / f64::from(1_u32 << 31)
        };
        let (mut near, mut apart) = (0, 0);
        for _ in 0..4000 {
            let node = [draw(20.0), draw(20.0), draw(6.0), 0.0, 0.2];
            let pose = Pose::new(node[0], node[1], node[2]);
            if body.hit(pose).is_some() {
                continue;
            }
            let clearance = body.clearance(pose);
            let Some(found) = least(&features, &node) else {
                assert!(clearance >= 1.0 - 1e-9);
                apart += 1;
                continue;
            };
            assert!((found.value - clearance).abs() < 1e-9, "{node:?}: {} {clearance}", found.value);
            near += 1;
            for k in 0..3 {
                let moved = |by: f64| {
                    let mut other = node;
                    other[k] += by;
                    least(&features, &other).map_or(1.0, |d| d.value)
                };
                let slope = (moved(1e-6) - moved(-1e-6)) / 2e-6;
                // Where two features are equally near there is no slope.
                let one_side = (moved(2e-6) - found.value) / 2e-6;
                if (slope - one_side).abs() < 1e-4 && found.value < 0.99 {
                    assert!(
                        (slope - found.slopes[k]).abs() < 1e-3,
                        "{node:?} {k}: {slope} {:?}",
                        found.slopes
                    );
                }
            }
        }
        assert!(near > 400 && apart > 100, "{near} near, {apart} apart");
    }

    #[test]
    fn a_shallow_overlap_is_a_depth_to_the_nearest_side() {
        let block = Form::Polygon(
            [(9.0, 2.0), (9.4, 2.0), (9.4, 9.0), (9.0, 9.0)].map(|(x, y)| Point::new(x, y)).to_vec(),
        );
        let features = scene(vec![block]);
        // The nose is 5 cm inside the block.
        let found = least(&features, &[4.55, 5.0, 0.0, 0.0, 0.2]).unwrap();
        assert!((found.value + 0.05).abs() < 1e-9 && (found.slopes[0] + 1.0).abs() < 1e-9, "{found:?}");
        // The tail is 2 cm beyond the floor.
        let found = least(&features, &[0.98, 15.0, 0.0, 0.0, 0.2]).unwrap();
        assert!((found.value + 0.02).abs() < 1e-9 && (found.slopes[0] - 1.0).abs() < 1e-9, "{found:?}");
    }
}
