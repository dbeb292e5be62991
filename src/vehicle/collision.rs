//! Exact collision of the body with line obstacles, behind two cheap filters.
//!
//! A solid is its outline: a car that starts outside it cannot enter without meeting an edge, so containment is asked
//! only once, of the first and last pose ([`Obstacles::inside`]). Most poses are settled by discs that cover the body,
//! looked up in a distance field; the rest by separating axes against the edges nearby.

use std::cell::Cell as Counter;

use super::Vehicle;
use crate::geometry::{Point, Pose, math};
use crate::map::{Frame, Layer, Occupancy, distance, raster};

/// Overlaps shallower than this are contact, which is free, metres.
const CONTACT: f64 = 1e-6;
/// Side of a broad-phase bucket, metres.
const BUCKET: f64 = 2.0;
/// Cells of the distance field, at most.
const FIELD_CELLS: f64 = 300_000.0;
/// Side of a field cell on worlds that are small enough, metres.
const FIELD_CELL: f64 = 0.25;

/// A straight edge and what it belongs to.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// One end, metres.
    pub a: Point,
    /// The other end, metres.
    pub b: Point,
    /// A number that the caller chose.
    pub owner: u32,
}

/// A closed outline and what it belongs to.
#[derive(Debug, Clone)]
pub struct Solid {
    /// Corners, metres, in either direction.
    pub outline: Vec<Point>,
    /// A number that the caller chose.
    pub owner: u32,
}

/// Everything that blocks, in a frame whose origin is the boundary's lower left corner.
#[derive(Debug)]
pub struct Obstacles {
    origin: Point,
    edges: Vec<Edge>,
    solids: Vec<Solid>,
    boundary: Solid,
    columns: usize,
    rows: usize,
    bucket: f64,
    /// `first[b]..first[b + 1]` are the places in `members` of bucket b's edges.
    first: Vec<u32>,
    members: Vec<u32>,
    frame: Frame,
    /// Distance between cell centres, metres.
    field: Layer<f32>,
}

impl Obstacles {
    /// Prepares walls, solids and the boundary, all in world coordinates.
    pub fn new(walls: &[Edge], solids: &[Solid], boundary: &Solid) -> Self {
        let (low, high) = bounds(boundary.outline.iter().copied());
        let local = |p: Point| Point::from(p - low);
        let shift =
            |s: &Solid| Solid { outline: s.outline.iter().map(|&p| local(p)).collect(), owner: s.owner };
        let boundary = shift(boundary);
        let solids: Vec<Solid> = solids.iter().map(shift).collect();
        let mut edges: Vec<Edge> =
            walls.iter().map(|e| Edge { a: local(e.a), b: local(e.b), owner: e.owner }).collect();
        for solid in solids.iter().chain([&boundary]) {
            let n = solid.outline.len();
            let edge =
                |i: usize| Edge { a: solid.outline[i], b: solid.outline[(i + 1) % n], owner: solid.owner };
            edges.extend((0..n).map(edge));
        }
        let size = high - low;
        let bucket = BUCKET.max(size.x.max(size.y) / 1024.0);
        let (columns, rows) = ((size.x / bucket) as usize + 1, (size.y / bucket) as usize + 1);
        let cell = FIELD_CELL.max((size.x * size.y / FIELD_CELLS).sqrt());
        let frame = Frame {
            origin: Point::new(-cell, -cell),
            width: (size.x / cell) as u32 + 3,
            height: (size.y / cell) as u32 + 3,
            resolution: cell,
        };
        let field = field(&edges, &frame);
        let mut obstacles = Self {
            origin: low,
            edges,
            solids,
            boundary,
            columns,
            rows,
            bucket,
            first: Vec::new(),
            members: Vec::new(),
            frame,
            field,
        };
        obstacles.fill_buckets();
        obstacles
    }

    fn fill_buckets(&mut self) {
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        for (i, edge) in self.edges.iter().enumerate() {
            let (low, high) = bounds([edge.a, edge.b]);
            self.buckets(low, high, |b| pairs.push((b as u32, i as u32)));
        }
        let pairs = math::sorted_by(&pairs, |pair| f64::from(pair.0));
        self.first = vec![0; self.columns * self.rows + 1];
        for &(bucket, _) in &pairs {
            self.first[bucket as usize + 1] += 1;
        }
        for b in 1..self.first.len() {
            self.first[b] += self.first[b - 1];
        }
        self.members = pairs.into_iter().map(|p| p.1).collect();
    }

    fn buckets(&self, low: Point, high: Point, mut each: impl FnMut(usize)) {
        let place = |v: f64, n: usize| (v / self.bucket).clamp(0.0, (n - 1) as f64) as usize;
        for y in place(low.y, self.rows)..=place(high.y, self.rows) {
            for x in place(low.x, self.columns)..=place(high.x, self.columns) {
                each(y * self.columns + x);
            }
        }
    }

    /// A world pose in the frame of all queries.
    pub fn local(&self, pose: Pose) -> Pose {
        Pose::new(pose.x - self.origin.x, pose.y - self.origin.y, math::wrap(pose.heading))
    }

    /// What a point is inside of, or outside of in the case of the boundary; local coordinates.
    pub fn inside(&self, point: Point) -> Option<u32> {
        if !contains(&self.boundary.outline, point) {
            return Some(self.boundary.owner);
        }
        self.solids.iter().find(|s| contains(&s.outline, point)).map(|s| s.owner)
    }

    /// The lattice of [`Obstacles::distance_at`].
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The distance field: metres between cell centres, to the nearest cell that an edge touches.
    pub fn field(&self) -> &Layer<f32> {
        &self.field
    }

    /// The field at a local point; off the field, 0.
    pub fn distance_at(&self, point: Point) -> f64 {
        self.frame.cell_at(point).and_then(|c| self.field.get(c)).map_or(0.0, f64::from)
    }
}

fn field(edges: &[Edge], frame: &Frame) -> Layer<f32> {
    let mut map = Occupancy::new(frame.width, frame.height);
    for edge in edges {
        raster::wall(&mut map, frame, &[edge.a, edge.b]);
    }
    let quarters = distance::to_centers(&map);
    let mut field = Layer::filled(frame.width, frame.height, 0.0_f32);
    for (metres, &q) in field.data.iter_mut().zip(&quarters.data) {
        *metres = ((q as f64).sqrt() / 2.0 * frame.resolution) as f32;
    }
    field
}

/// Collision queries of one car, counted.
#[derive(Debug)]
pub struct Probe<'a> {
    obstacles: &'a Obstacles,
    vehicle: Vehicle,
    discs: Vec<f64>,
    disc_radius: f64,
    slack: f64,
    checks: Counter<u32>,
}

impl<'a> Probe<'a> {
    /// Queries of `vehicle` among `obstacles`.
    pub fn new(obstacles: &'a Obstacles, vehicle: &Vehicle) -> Self {
        let length = vehicle.length();
        let count = (length / vehicle.width).ceil().clamp(1.0, 8.0);
        let part = length / count;
        let discs = (0..count as u32).map(|i| (f64::from(i) + 0.5) * part - vehicle.rear_to_back).collect();
        let disc_radius = (part * part / 4.0 + vehicle.width * vehicle.width / 4.0).sqrt();
        // Point and obstacle may each be half a diagonal away from their cells' centres.
        let slack = obstacles.frame.resolution * core::f64::consts::SQRT_2 + 1e-6;
        Self { obstacles, vehicle: *vehicle, discs, disc_radius, slack, checks: Counter::new(0) }
    }

    /// Poses asked about so far.
    pub fn checks(&self) -> u32 {
        self.checks.get()
    }

    /// What the body, grown by `margin` metres on every side, overlaps at a local pose.
    pub fn hit(&self, pose: Pose, margin: f64) -> Option<u32> {
        self.checks.set(self.checks.get() + 1);
        let (sin, cos) = math::sin_cos(pose.heading);
        let reach = self.disc_radius + margin + self.slack;
        let far = |&along: &f64| {
            self.obstacles.distance_at(Point::new(pose.x + along * cos, pose.y + along * sin)) > reach
        };
        if self.discs.iter().all(far) {
            return None;
        }
        self.exact(pose, sin, cos, margin - CONTACT)
    }

    fn exact(&self, pose: Pose, sin: f64, cos: f64, margin: f64) -> Option<u32> {
        let sides = self.sides(margin);
        let (low, high) = self.bounds(pose, sin, cos, margin);
        let o = self.obstacles;
        let mut found = None;
        o.buckets(low, high, |bucket| {
            if found.is_some() {
                return;
            }
            let members = &o.members[o.first[bucket] as usize..o.first[bucket + 1] as usize];
            found = members.iter().map(|&i| &o.edges[i as usize]).find(|edge| {
                let (ax, ay) = (edge.a.x - pose.x, edge.a.y - pose.y);
                let (bx, by) = (edge.b.x - pose.x, edge.b.y - pose.y);
                let a = Point::new(ax * cos + ay * sin, ay * cos - ax * sin);
                let b = Point::new(bx * cos + by * sin, by * cos - bx * sin);
                segment_meets_box(a, b, sides)
            });
        });
        found.map(|edge| edge.owner)
    }

    /// Distance from the body to the nearest edge at a local pose, metres, at most `limit`; 0 where it overlaps.
    pub fn clearance(&self, pose: Pose, limit: f64) -> f64 {
        if self.hit(pose, 0.0).is_some() {
            return 0.0;
        }
        let (sin, cos) = math::sin_cos(pose.heading);
        let [front, back, left, right] = self.sides(0.0);
        let corners =
            [(front, left), (back, left), (back, right), (front, right)].map(|(x, y)| Point::new(x, y));
        let (low, high) = self.bounds(pose, sin, cos, limit);
        let o = self.obstacles;
        let mut best = limit;
        o.buckets(low, high, |bucket| {
            for &i in &o.members[o.first[bucket] as usize..o.first[bucket + 1] as usize] {
                let edge = &o.edges[i as usize];
                let (a, b) = (pose.to_local(edge.a), pose.to_local(edge.b));
                for k in 0..4 {
                    best = best.min(segment_distance(a, b, corners[k], corners[(k + 1) % 4]));
                }
            }
        });
        best
    }

    /// Front, back, left and right of the grown body in its own frame.
    fn sides(&self, margin: f64) -> [f64; 4] {
        let v = &self.vehicle;
        let side = v.width / 2.0 + margin;
        [v.rear_to_front + margin, -v.rear_to_back - margin, side, -side]
    }

    fn bounds(&self, pose: Pose, sin: f64, cos: f64, margin: f64) -> (Point, Point) {
        let v = &self.vehicle;
        let (half, side) = (v.length() / 2.0 + margin, v.width / 2.0 + margin);
        let ahead = (v.rear_to_front - v.rear_to_back) / 2.0;
        let (x, y) = (pose.x + ahead * cos, pose.y + ahead * sin);
        let dx = half * cos.abs() + side * sin.abs();
        let dy = half * sin.abs() + side * cos.abs();
        (Point::new(x - dx, y - dy), Point::new(x + dx, y + dy))
    }
}

/// Separating axes of a segment and an upright box: the box's two, then the segment's normal.
fn segment_meets_box(a: Point, b: Point, [front, back, left, right]: [f64; 4]) -> bool {
    if a.x.max(b.x) < back || a.x.min(b.x) > front || a.y.max(b.y) < right || a.y.min(b.y) > left {
        return false;
    }
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let side = |x: f64, y: f64| dx * (y - a.y) - dy * (x - a.x);
    let corners = [side(front, left), side(back, left), side(back, right), side(front, right)];
    !(corners.iter().all(|&s| s > 0.0) || corners.iter().all(|&s| s < 0.0))
}

fn point_distance(p: Point, a: Point, b: Point) -> f64 {
    let ab = b - a;
    let square = ab.norm_squared();
    let t = if square > 0.0 { ((p - a).dot(&ab) / square).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + ab * t)).norm()
}

/// Distance of two segments that do not cross.
fn segment_distance(a: Point, b: Point, c: Point, d: Point) -> f64 {
    let one = point_distance(a, c, d).min(point_distance(b, c, d));
    one.min(point_distance(c, a, b)).min(point_distance(d, a, b))
}

fn bounds(points: impl IntoIterator<Item = Point>) -> (Point, Point) {
    let inf = f64::INFINITY;
    points.into_iter().fold((Point::new(inf, inf), Point::new(-inf, -inf)), |(low, high), p| {
        (Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y)))
    })
}

fn contains(outline: &[Point], p: Point) -> bool {
    let mut odd = false;
    for (i, &a) in outline.iter().enumerate() {
        let b = outline[(i + 1) % outline.len()];
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
            odd = !odd;
        }
    }
    odd
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hall(solids: &[Solid]) -> Obstacles {
        let outline =
            [(0.0, 0.0), (30.0, 0.0), (30.0, 20.0), (0.0, 20.0)].map(|(x, y)| Point::new(x, y)).to_vec();
        Obstacles::new(&[], solids, &Solid { outline, owner: 9 })
    }

    #[test]
    fn touching_a_wall_is_free_and_a_margin_is_kept() {
        let hall = hall(&[]);
        let probe = Probe::new(&hall, &Vehicle::PAPER);
        assert_eq!(probe.hit(Pose::new(1.0, 10.0, 0.0), 0.0), None);
        assert_eq!(probe.hit(Pose::new(0.9, 10.0, 0.0), 0.0), Some(9));
        assert_eq!(probe.hit(Pose::new(1.05, 10.0, 0.0), 0.1), Some(9));
        assert!((probe.clearance(Pose::new(1.25, 10.0, 0.0), 1.0) - 0.25).abs() < 1e-9);
        assert_eq!(probe.checks(), 4);
    }

    #[test]
    fn the_filters_never_change_the_answer() {
        let square =
            [(12.0, 8.0), (13.0, 8.5), (12.6, 9.4), (11.8, 9.0)].map(|(x, y)| Point::new(x, y)).to_vec();
        let hall = hall(&[Solid { outline: square, owner: 1 }]);
        let probe = Probe::new(&hall, &Vehicle::PAPER);
        let mut hits = 0;
        for k in 0..20_000_u32 {
            let t = f64::from(k);
            let pose = Pose::new((t * 0.618).fract() * 30.0, (t * 0.414).fract() * 20.0, t * 0.1);
            let (sin, cos) = math::sin_cos(pose.heading);
            let exact = probe.exact(pose, sin, cos, 0.1 - CONTACT);
            assert_eq!(probe.hit(pose, 0.1), exact, "{pose:?}");
            hits += u32::from(exact.is_some());
        }
        assert!(hits > 2000, "{hits}");
    }

    #[test]
    fn containment_is_asked_of_the_point() {
        let square =
            [(5.0, 5.0), (25.0, 5.0), (25.0, 15.0), (5.0, 15.0)].map(|(x, y)| Point::new(x, y)).to_vec();
        let hall = hall(&[Solid { outline: square, owner: 1 }]);
        assert_eq!(hall.inside(Point::new(10.0, 10.0)), Some(1));
        assert_eq!(hall.inside(Point::new(40.0, 10.0)), Some(9));
        assert_eq!(hall.inside(Point::new(2.0, 2.0)), None);
    }
}
