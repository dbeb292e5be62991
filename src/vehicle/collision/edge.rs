//! Straight edges, and distances to them.

use crate::geometry::Point;
use crate::geometry::polygon::nearest_share;

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

/// Distance from a point to a segment, metres.
pub(super) fn point_distance(p: Point, a: Point, b: Point) -> f64 {
    point_square(p, a, b).sqrt()
}

/// Distance from a point to a segment, squared.
#[inline(never)]
pub(super) fn point_square(p: Point, a: Point, b: Point) -> f64 {
    (p - (a + (b - a) * nearest_share(p, a, b))).norm_squared()
}

/// The lower left and the upper right corner of the box around some points.
pub(super) fn bounds(points: impl IntoIterator<Item = Point>) -> (Point, Point) {
    let inf = f64::INFINITY;
    points.into_iter().fold((Point::new(inf, inf), Point::new(-inf, -inf)), |(low, high), p| {
        (Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y)))
    })
}
