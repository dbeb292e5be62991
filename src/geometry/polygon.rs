//! Points, edges and outlines of simple polygons.

use super::Point;

/// True if the ray from `p` to the east crosses the edge from `a` to `b`.
pub(crate) fn crosses_ray(a: Point, b: Point, p: Point) -> bool {
    (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
}

/// True if a point is inside an outline, by the even–odd rule. Points on the outline may count either way.
pub(crate) fn contains<P: Copy + Into<Point>>(outline: &[P], p: Point) -> bool {
    let Some(&last) = outline.last() else { return false };
    let (mut odd, mut before) = (false, last.into());
    for &corner in outline {
        let corner = corner.into();
        odd ^= crosses_ray(before, corner, p);
        before = corner;
    }
    odd
}

/// The share of the segment from `a` to `b`, 0 to 1, at which it is nearest to `p`.
pub(crate) fn nearest_share(p: Point, a: Point, b: Point) -> f64 {
    let ab = b - a;
    let square = ab.norm_squared();
    if square > 0.0 { ((p - a).dot(&ab) / square).clamp(0.0, 1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dent_is_outside() {
        let outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]];
        for (x, y, inside) in [(1.0, 1.0, true), (2.0, 2.0, false), (3.5, 2.5, true), (5.0, 1.0, false)] {
            assert_eq!(contains(&outline, Point::new(x, y)), inside, "{x} {y}");
        }
        assert!(!contains::<[f64; 2]>(&[], Point::origin()));
    }

    #[test]
    fn the_nearest_point_of_a_segment_is_on_it() {
        let (a, b) = (Point::new(1.0, 1.0), Point::new(5.0, 1.0));
        for (x, share) in [(-3.0, 0.0), (2.0, 0.25), (9.0, 1.0)] {
            assert_eq!(nearest_share(Point::new(x, 7.0), a, b), share);
        }
        assert_eq!(nearest_share(b, a, a), 0.0);
    }
}
