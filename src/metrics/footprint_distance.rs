//! Distance from the car's body to everything that blocks, from outlines alone.
//!
//! The checker's own code path: the planners' separating axes, discs and rasters are not used here. Two outlines meet
//! when edges cross or one holds a corner of the other; that is exact for concave polygons too.
//!
//! Coordinates are relative to the boundary's first corner, so that scenes far from the origin lose no digits. Edges
//! are hashed into square buckets; a query looks at those that the body's box touches, then at larger surroundings
//! until the nearest edge found is nearer than anything not yet looked at.

use std::cell::Cell;

use super::outlines::{bounds, cross, inside, passes, squared_apart};
use crate::geometry::{Point, Pose, math};
use crate::scenario::resolve::{Form, Geometry, Owner};
use crate::vehicle::Vehicle;

/// Distances beyond this are reported as this, metres.
pub const FAR: f64 = 10.0;

/// Overlaps shallower than this count as contact, which is free, metres.
const CONTACT: f64 = 1e-6;

/// A segment of an outline with its bounding box. The boundary's edges come first in [`Body::edges`].
#[derive(Clone)]
pub(super) struct Edge {
    pub(super) a: Point,
    pub(super) b: Point,
    low: Point,
    high: Point,
    pub(super) owner: Owner,
}

impl Edge {
    fn new(a: Point, b: Point, owner: Owner) -> Self {
        let (low, high) = bounds([&a, &b]);
        Self { a, b, low, high, owner }
    }

    /// A lower bound on the distance to anything inside a box, squared.
    pub(super) fn apart_from(&self, low: Point, high: Point) -> f64 {
        let dx = (self.low.x - high.x).max(low.x - self.high.x).max(0.0);
        let dy = (self.low.y - high.y).max(low.y - self.high.y).max(0.0);
        dx * dx + dy * dy
    }
}

/// A polygon with an inside; a body that lies wholly in it meets no edge.
#[derive(Clone)]
pub(super) struct Solid {
    outline: Vec<Point>,
    owner: Owner,
    low: Point,
    high: Point,
}

impl Solid {
    /// True if the point is inside.
    pub(super) fn holds(&self, p: Point) -> bool {
        let (low, high) = (self.low, self.high);
        let near = p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
        near && inside(&self.outline, p)
    }
}

/// The exact obstacles of a scene, ready for body queries.
///
/// The name is that of the car's body, about which all queries are. Building takes time linear in the edges plus the
/// buckets they touch; a query costs about as much as there are edges near the body.
///
/// # Examples
/// ```
/// use parkade::metrics::Body;
///
/// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
/// let geometry = scene.geometry().unwrap();
/// let body = Body::new(&geometry);
/// assert!(body.hit(geometry.start).is_none() && body.clearance(geometry.start) > 0.1);
/// ```
#[derive(Clone)]
pub struct Body {
    vehicle: Vehicle,
    pub(super) origin: Point,
    pub(super) edges: Vec<Edge>,
    pub(super) solids: Vec<Solid>,
    pub(super) buckets: Buckets,
    /// The boundary's edges by the buckets' rows.
    bands: Vec<Vec<u32>>,
    /// The last heading with its sine and cosine: paths go straight a lot.
    turn: Cell<(f64, (f64, f64))>,
}

/// Edges by the square of the plane that their bounding box touches.
///
/// Row by row from `low`; what lies outside is in the nearest outermost bucket.
#[derive(Clone)]
pub(super) struct Buckets {
    pub(super) side: f64,
    low: Point,
    columns: usize,
    rows: usize,
    pub(super) edges: Vec<Vec<u32>>,
    pub(super) solids: Vec<Vec<u32>>,
}

impl Buckets {
    fn new(low: Point, high: Point, count: usize) -> Self {
        let (w, h) = ((high.x - low.x).max(1.0), (high.y - low.y).max(1.0));
        let side = ((w * h / (count + 1) as f64).sqrt() * 2.0).clamp(w.max(h) / 512.0, w.max(h)).max(0.5);
        let (columns, rows) = ((w / side) as usize + 1, (h / side) as usize + 1);
        let empty = || vec![Vec::new(); columns * rows];
        Self { side, low, columns, rows, edges: empty(), solids: empty() }
    }

    fn row(&self, y: f64) -> usize {
        ((y - self.low.y) / self.side).clamp(0.0, (self.rows - 1) as f64) as usize
    }

    /// The buckets that a box touches.
    pub(super) fn range(&self, low: Point, high: Point) -> impl Iterator<Item = usize> + use<> {
        let clamp = |v: f64, n: usize| (v / self.side).clamp(0.0, (n - 1) as f64) as usize;
        let (x0, x1) = (clamp(low.x - self.low.x, self.columns), clamp(high.x - self.low.x, self.columns));
        let (y0, y1) = (clamp(low.y - self.low.y, self.rows), clamp(high.y - self.low.y, self.rows));
        let columns = self.columns;
        (y0..=y1).flat_map(move |y| (x0..=x1).map(move |x| y * columns + x))
    }
}

impl Body {
    /// The obstacles of a scene around its car.
    pub fn new(geometry: &Geometry) -> Self {
        let origin = geometry.boundary[0];
        let local = |p: &Point| Point::from(p - origin);
        let boundary: Vec<Point> = geometry.boundary.iter().map(local).collect();
        let mut edges = Vec::new();
        let mut ring = |outline: &[Point], owner| {
            for (i, &a) in outline.iter().enumerate() {
                edges.push(Edge::new(a, outline[(i + 1) % outline.len()], owner));
            }
        };
        ring(&boundary, Owner::Border);
        let mut solids = Vec::new();
        let mut segments = Vec::new();
        for shape in &geometry.shapes {
            match &shape.form {
                Form::Segment(a, b) => segments.push(Edge::new(local(a), local(b), shape.owner)),
                Form::Polygon(points) => {
                    let outline: Vec<Point> = points.iter().map(local).collect();
                    ring(&outline, shape.owner);
                    let (low, high) = bounds(&outline);
                    solids.push(Solid { outline, owner: shape.owner, low, high });
                }
            }
        }
        edges.append(&mut segments);
        let (low, high) = bounds(&boundary);
        let mut buckets = Buckets::new(low, high, edges.len());
        for (i, edge) in edges.iter().enumerate() {
            buckets.range(edge.low, edge.high).for_each(|b| buckets.edges[b].push(i as u32));
        }
        for (i, solid) in solids.iter().enumerate() {
            buckets.range(solid.low, solid.high).for_each(|b| buckets.solids[b].push(i as u32));
        }
        let mut bands = vec![Vec::new(); buckets.rows];
        for (i, edge) in edges[..boundary.len()].iter().enumerate() {
            bands[buckets.row(edge.low.y)..=buckets.row(edge.high.y)]
                .iter_mut()
                .for_each(|b| b.push(i as u32));
        }
        Self {
            vehicle: geometry.vehicle,
            origin,
            edges,
            solids,
            buckets,
            bands,
            turn: Cell::new((0.0, (0.0, 1.0))),
        }
    }

    /// True if a point, relative to the local origin, is within the boundary.
    pub(super) fn on_floor(&self, p: Point) -> bool {
        self.bands[self.buckets.row(p.y)].iter().fold(false, |odd, &i| {
            let edge = &self.edges[i as usize];
            odd ^ passes(edge.a, edge.b, p)
        })
    }

    /// The obstacle that the body overlaps at `pose`, if any; touching counts as free.
    ///
    /// Where several are overlapped it is the first found, in an order that depends on the scene alone.
    pub fn hit(&self, pose: Pose) -> Option<Owner> {
        let body = self.outline(pose, CONTACT);
        let (low, high) = bounds(&body);
        for bucket in self.buckets.range(low, high) {
            for &i in &self.buckets.edges[bucket] {
                let edge = &self.edges[i as usize];
                if edge.apart_from(low, high) > 0.0 {
                    continue;
                }
                let ring = (0..4).any(|k| cross(body[k], body[(k + 1) % 4], edge.a, edge.b));
                if ring || inside(&body, edge.a) {
                    return Some(edge.owner);
                }
            }
            for &i in &self.buckets.solids[bucket] {
                let solid = &self.solids[i as usize];
                if solid.holds(body[0]) {
                    return Some(solid.owner);
                }
            }
        }
        (!self.on_floor(body[0])).then_some(Owner::Border)
    }

    /// Distance from the body to the nearest obstacle, metres, at most [`FAR`]; 0 where it overlaps.
    pub fn clearance(&self, pose: Pose) -> f64 {
        self.clearance_within(pose, FAR)
    }

    /// The same, at most `most` metres: the less, the sooner it is known.
    pub(crate) fn clearance_within(&self, pose: Pose, most: f64) -> f64 {
        if self.hit(pose).is_some() { 0.0 } else { self.room(pose, self.buckets.side, most) }
    }

    /// Distance to the nearest obstacle where nothing is hit, metres, at most `most`; faster the nearer above it
    /// `guess` is.
    pub(super) fn room(&self, pose: Pose, guess: f64, most: f64) -> f64 {
        let body = self.outline(pose, 0.0);
        let (low, high) = bounds(&body);
        let mut reach = guess.min(most);
        loop {
            let margin = nalgebra::Vector2::new(reach, reach);
            let mut best = most;
            for bucket in self.buckets.range(low - margin, high + margin) {
                for &i in &self.buckets.edges[bucket] {
                    let edge = &self.edges[i as usize];
                    // What is beyond reach is no answer yet.
                    let least = best.min(reach);
                    if edge.apart_from(low, high) >= least * least {
                        continue;
                    }
                    let squared = (0..4).fold(f64::INFINITY, |least, k| {
                        least.min(squared_apart(body[k], body[(k + 1) % 4], edge.a, edge.b))
                    });
                    best = best.min(squared.sqrt());
                }
            }
            if best <= reach || reach >= most {
                return best;
            }
            reach = (reach * 2.0).min(most);
        }
    }

    /// How far a point of the body moves at most on an arc of a length with a turn, metres. The lever is an upper bound
    /// of the farthest corner's distance from the rear axle.
    pub(super) fn sweep(&self, length: f64, turn: f64) -> f64 {
        let v = &self.vehicle;
        let lever = v.rear_to_front.max(v.rear_to_back) + v.width / 2.0;
        length.abs() + turn.abs() * lever
    }

    /// The body's corners relative to the local origin, pulled in by `inset` metres on every side.
    pub(super) fn outline(&self, pose: Pose, inset: f64) -> [Point; 4] {
        let v = &self.vehicle;
        let small = Vehicle {
            width: v.width - 2.0 * inset,
            rear_to_front: v.rear_to_front - inset,
            rear_to_back: v.rear_to_back - inset,
            ..*v
        };
        let at = pose.point() - self.origin;
        let (mut heading, mut turn) = self.turn.get();
        if heading != pose.heading {
            (heading, turn) = (pose.heading, math::sin_cos(pose.heading));
            self.turn.set((heading, turn));
        }
        small.outline_turned(Pose::new(at.x, at.y, heading), turn)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::resolve::Shape;

    fn scene(shapes: Vec<Shape>) -> Body {
        let boundary = [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)].map(|(x, y)| Point::new(x, y));
        let pose = Pose::new(5.0, 5.0, 0.0);
        Body::new(&Geometry {
            start: pose,
            goal: pose,
            goals: None,
            vehicle: Vehicle::PAPER,
            boundary: boundary.to_vec(),
            shapes,
            parked: Vec::new(),
        })
    }

    #[test]
    fn touching_the_border_is_free_and_crossing_it_is_not() {
        let body = scene(Vec::new());
        assert_eq!(body.hit(Pose::new(1.0, 5.0, 0.0)), None);
        assert_eq!(body.hit(Pose::new(0.99, 5.0, 0.0)), Some(Owner::Border));
        assert_eq!(body.hit(Pose::new(-50.0, 5.0, 0.0)), Some(Owner::Border));
        assert!((body.clearance(Pose::new(3.0, 10.0, 0.0)) - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_post_inside_the_body_and_a_body_inside_a_block_are_hits() {
        let square = |x: f64, y: f64, r: f64| {
            Form::Polygon(
                [(-r, -r), (r, -r), (r, r), (-r, r)].map(|(a, b)| Point::new(x + a, y + b)).to_vec(),
            )
        };
        let owner = Owner::Obstacle(0);
        let post = scene(vec![Shape { owner, form: square(7.0, 5.0, 0.1) }]);
        assert_eq!(post.hit(Pose::new(5.0, 5.0, 0.0)), Some(owner));
        assert!((post.clearance(Pose::new(5.0, 8.0, 0.0)) - 1.6).abs() < 1e-12);
        let block = scene(vec![Shape { owner, form: square(10.0, 10.0, 9.0) }]);
        assert_eq!(block.hit(Pose::new(9.0, 10.0, 0.3)), Some(owner));
    }

    #[test]
    fn a_line_across_the_body_is_a_hit() {
        let form = Form::Segment(Point::new(7.0, 0.0), Point::new(7.0, 20.0));
        let wall = scene(vec![Shape { owner: Owner::Obstacle(3), form }]);
        assert_eq!(wall.hit(Pose::new(5.0, 5.0, 0.0)), Some(Owner::Obstacle(3)));
        assert!((wall.clearance(Pose::new(2.0, 5.0, 0.0)) - 0.5).abs() < 1e-12);
    }
}
