//! Segments and outlines of the checker: which meet, and how far apart they are.
//!
//! Two outlines meet when edges cross or one holds a corner of the other; that is exact for concave polygons too.

use crate::geometry::Point;

/// The corners of the box around some points: the least and the greatest coordinates.
pub(super) fn bounds<'a>(points: impl IntoIterator<Item = &'a Point>) -> (Point, Point) {
    let start = (Point::new(f64::INFINITY, f64::INFINITY), Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY));
    points.into_iter().fold(start, |(low, high), p| {
        (Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y)))
    })
}

/// Positive where a point is to the left of the line from a to b: twice the area of the triangle.
fn side(a: Point, b: Point, p: Point) -> f64 {
    (b - a).perp(&(p - a))
}

/// True if two segments cross or touch.
pub(super) fn cross(a: Point, b: Point, c: Point, d: Point) -> bool {
    let (c_side, d_side) = (side(a, b, c), side(a, b, d));
    let (a_side, b_side) = (side(c, d, a), side(c, d, b));
    c_side * d_side <= 0.0 && a_side * b_side <= 0.0 && {
        let ((l1, h1), (l2, h2)) = (bounds([&a, &b]), bounds([&c, &d]));
        l1.x <= h2.x && l2.x <= h1.x && l1.y <= h2.y && l2.y <= h1.y
    }
}

/// True if an edge is passed on the way from a point to the far east.
pub(super) fn passes(a: Point, b: Point, p: Point) -> bool {
    (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
}

/// True if a point is inside a simple polygon (even–odd rule).
pub(super) fn inside(outline: &[Point], p: Point) -> bool {
    (0..outline.len()).fold(false, |odd, i| odd ^ passes(outline[i], outline[(i + 1) % outline.len()], p))
}

/// The square of a point's distance from a segment.
pub(super) fn squared_to_segment(p: Point, a: Point, b: Point) -> f64 {
    let ab = b - a;
    let length2 = ab.norm_squared();
    let t = if length2 > 0.0 { ((p - a).dot(&ab) / length2).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + ab * t)).norm_squared()
}

/// The square of the distance between two segments that do not cross.
pub(super) fn squared_apart(a: Point, b: Point, c: Point, d: Point) -> f64 {
    let one = squared_to_segment(a, c, d).min(squared_to_segment(b, c, d));
    one.min(squared_to_segment(c, a, b)).min(squared_to_segment(d, a, b))
}

/// Distance between two closed outlines, metres; 0 where they overlap.
pub(crate) fn gap(a: &[Point], b: &[Point]) -> f64 {
    if inside(a, b[0]) || inside(b, a[0]) {
        return 0.0;
    }
    let edges =
        |ring: &[Point]| ring.iter().copied().zip(ring.iter().copied().cycle().skip(1)).collect::<Vec<_>>();
    let others = edges(b);
    edges(a).into_iter().fold(f64::INFINITY, |best, (p, q)| {
        others.iter().fold(best, |best, &(r, s)| {
            best.min(if cross(p, q, r, s) { 0.0 } else { squared_apart(p, q, r, s).sqrt() })
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outlines_are_apart_by_their_nearest_sides() {
        let square = |x: f64, y: f64, r: f64| {
            [(-r, -r), (r, -r), (r, r), (-r, r)].map(|(a, b)| Point::new(x + a, y + b))
        };
        assert!((gap(&square(0.0, 0.0, 1.0), &square(4.0, 0.5, 1.0)) - 2.0).abs() < 1e-12);
        assert_eq!(gap(&square(0.0, 0.0, 1.0), &square(1.5, 1.5, 1.0)), 0.0);
        assert_eq!(gap(&square(0.0, 0.0, 3.0), &square(0.2, 0.1, 1.0)), 0.0);
        assert!((gap(&square(0.0, 0.0, 1.0), &square(5.0, 6.0, 1.0)) - 5.0).abs() < 1e-12);
    }
}
