//! Everything that blocks, sorted into buckets, and how far each place is from it.
//!
//! Edges of walls, solids and the boundary are sorted once into buckets ([`EdgeBuckets`]), so that a pose is held
//! against the edges near it only. A distance field over coarser cells tells a lower bound of the room at any place in
//! constant time. Coordinates are local: the origin is the boundary's lower left corner.

use super::edge::{Edge, bounds, point_square};
use super::edge_buckets::EdgeBuckets;
use crate::geometry::polygon::contains;
use crate::geometry::{Point, Pose, Vector, math};
use crate::map::{Frame, Layer, Occupancy, WeightMap, distance, raster};

/// Cells of the distance field, at most.
const FIELD_CELLS: f64 = 300_000.0;
/// Side of a field cell on worlds that are small enough, metres.
const FIELD_CELL: f64 = 0.25;

/// A closed outline and what it belongs to.
#[derive(Debug, Clone)]
pub struct Solid {
    /// Corners, metres, in either direction.
    pub outline: Vec<Point>,
    /// A number that the caller chose.
    pub owner: u32,
}

/// Everything that blocks, in a frame whose origin is the boundary's lower left corner. It never changes after it was
/// made; [`Obstacles::painted`] makes another one of it.
///
/// Memory: the distance field takes four bytes for each of some 300 000 cells at most, the buckets twenty bytes for
/// each edge that they hold. Making one is linear in edges, buckets and cells.
#[derive(Debug)]
pub struct Obstacles {
    pub(super) origin: Point,
    pub(super) edges: Vec<Edge>,
    solids: Vec<Solid>,
    boundary: Solid,
    buckets: EdgeBuckets,
    frame: Frame,
    /// Cells of the frame per metre.
    per_metre: f64,
    /// From cell centres to blocked squares, metres.
    field: Layer<f32>,
    fingerprint: u64,
    /// Weights of the floor; `None` if all cells cost the same.
    paint: Option<WeightMap>,
    /// Other obstacles, of which these are a variant.
    pub(super) original: Option<Original>,
}

/// The obstacles of which others are a variant.
#[derive(Debug)]
pub struct Original {
    /// They have the same lattice.
    pub obstacles: std::sync::Arc<Obstacles>,
    /// The lower left and the upper right corner of a box around all edges that only one of the two has, local
    /// coordinates, metres. Without such edges the box is empty: its corners are infinite and the wrong way round.
    pub change: (Point, Point),
    /// True if the variant has no edge that the original lacks.
    pub is_freer: bool,
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
        let frame = lattice(size, FIELD_CELL, FIELD_CELLS);
        let field = field(&edges, &frame);
        let fingerprint = fingerprint(&edges);
        Self {
            origin: low,
            buckets: EdgeBuckets::new(&edges, size),
            edges,
            solids,
            boundary,
            per_metre: 1.0 / frame.resolution,
            frame,
            field,
            fingerprint,
            paint: None,
            original: None,
        }
    }

    /// The same world on a floor with these costs, placed in world coordinates.
    #[must_use]
    pub fn painted(self, paint: Option<WeightMap>) -> Self {
        let low = self.origin;
        let local = |paint: WeightMap| {
            let frame = Frame { origin: Point::from(paint.frame.origin - low), ..paint.frame };
            WeightMap { frame, ..paint }
        };
        Self { paint: paint.map(local), ..self }
    }

    /// Bytes of the distance field, the edges and their buckets.
    pub fn bytes(&self) -> u64 {
        let arrays = size_of_val(&self.field.data[..]) + size_of_val(&self.edges[..]);
        arrays as u64 + self.buckets.bytes()
    }

    /// Weights of the floor in the frame of all queries; `None` if all cells cost the same.
    pub fn paint(&self) -> Option<&WeightMap> {
        self.paint.as_ref()
    }

    /// Another lattice over the same world and its distance field, as [`Obstacles::field`]: cells of `cell` metres,
    /// larger where there would be more than `most` of them.
    pub fn lattice(&self, cell: f64, most: f64) -> (Frame, Layer<f32>) {
        let (low, high) = bounds(self.boundary.outline.iter().copied());
        let frame = lattice(high - low, cell, most);
        (frame, field(&self.edges, &frame))
    }

    /// The edges whose own box meets a box, until one satisfies `wanted`: its owner. Few of them come twice.
    #[inline(always)]
    pub(super) fn find(&self, low: Point, high: Point, wanted: impl FnMut(&Edge) -> bool) -> Option<u32> {
        self.buckets.find(&self.edges, low, high, wanted)
    }

    /// Distance from a local point to the nearest edge, metres, at most `limit`.
    /// Exact, by the edges themselves. A point inside a solid has a distance from its outline, too; see
    /// [`Obstacles::inside`].
    pub fn distance(&self, point: Point, limit: f64) -> f64 {
        let mut square = f64::INFINITY;
        let reach = Vector::new(limit, limit);
        self.find(point - reach, point + reach, |edge| {
            square = square.min(point_square(point, edge.a, edge.b));
            false
        });
        square.sqrt().min(limit)
    }

    /// A world pose in the frame of all queries.
    pub fn local(&self, pose: Pose) -> Pose {
        Pose::new(pose.x - self.origin.x, pose.y - self.origin.y, math::wrap(pose.heading))
    }

    /// The obstacle that contains a point, or the boundary if the point is outside it; local coordinates.
    /// Every solid is asked: O(corners). A path needs this at its ends only, because a body that starts outside a
    /// solid cannot enter without meeting an edge.
    pub fn inside(&self, point: Point) -> Option<u32> {
        if !contains(&self.boundary.outline, point) {
            return Some(self.boundary.owner);
        }
        self.solids.iter().find(|s| contains(&s.outline, point)).map(|s| s.owner)
    }

    /// The lattice of [`Obstacles::field`].
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The distance field: metres from each cell's centre to the nearest cell that an edge touches, as a square.
    pub fn field(&self) -> &Layer<f32> {
        &self.field
    }

    /// The field at a local point; off the field, 0.
    #[inline(always)]
    pub(super) fn field_at(&self, x: f64, y: f64) -> f64 {
        // Three divisions a pose would be a third of the time that it takes.
        let [x, y] = [(x - self.frame.origin.x) * self.per_metre, (y - self.frame.origin.y) * self.per_metre];
        let Frame { width, height, .. } = self.frame;
        if x >= 0.0 && y >= 0.0 && x < f64::from(width) && y < f64::from(height) {
            f64::from(self.field.data[(y as u32 * width + x as u32) as usize])
        } else {
            0.0
        }
    }

    /// The same for equal edges in the same order, another one for others: tells whether what was derived still holds.
    pub fn fingerprint(&self) -> u64 {
        self.fingerprint
    }
}

/// A hash of the edges' coordinates, to the last bit.
fn fingerprint(edges: &[Edge]) -> u64 {
    let numbers = edges.iter().flat_map(|e| [e.a.x, e.a.y, e.b.x, e.b.y]);
    numbers.fold(0xcbf2_9ce4_8422_2325, |hash: u64, number| {
        let mixed = (hash ^ number.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        mixed ^ mixed >> 32
    })
}

/// A frame over a floor of this size with a margin of one cell around it.
fn lattice(size: Vector, cell: f64, most: f64) -> Frame {
    let cell = cell.max((size.x * size.y / most).sqrt());
    Frame {
        origin: Point::new(-cell, -cell),
        width: (size.x / cell) as u32 + 3,
        height: (size.y / cell) as u32 + 3,
        resolution: cell,
    }
}

/// The distance from each cell's centre to the nearest cell that an edge touches.
fn field(edges: &[Edge], frame: &Frame) -> Layer<f32> {
    let mut map = Occupancy::new(frame.width, frame.height);
    for edge in edges {
        raster::wall(&mut map, frame, &[edge.a, edge.b]);
    }
    distance::clearance(&map, frame.resolution)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(in crate::vehicle::collision) fn hall(solids: &[Solid]) -> Obstacles {
        let outline =
            [(0.0, 0.0), (30.0, 0.0), (30.0, 20.0), (0.0, 20.0)].map(|(x, y)| Point::new(x, y)).to_vec();
        Obstacles::new(&[], solids, &Solid { outline, owner: 9 })
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
