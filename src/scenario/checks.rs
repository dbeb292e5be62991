//! Rules for the numbers, points and outlines of a scene.

use crate::error::{Error, ErrorCode, Message};
use crate::geometry::{Point, Pose};

/// Largest coordinate, metres: beyond it neighbouring numbers are more than a tenth of a millimetre apart.
const MAX_COORDINATE: f64 = 1e11;
/// Most corners of one polygon or wall: the test for self-intersection is quadratic.
const MAX_CORNERS: usize = 2000;
/// Refuses a field.
pub(super) fn bad<T>(path: &str, message: Message) -> Result<T, Error> {
    Err(Error::new(ErrorCode::Scenario, path, message))
}

/// An error for NaN and infinities.
pub(super) fn finite(path: &str, value: f64) -> Result<(), Error> {
    if value.is_finite() { Ok(()) } else { bad(path, message!("must be a finite number, got {}", value)) }
}

/// A length, width or speed: above 0, at most 10⁶.
pub(super) fn positive(path: &str, value: f64) -> Result<(), Error> {
    if value > 0.0 && value <= 1e6 {
        Ok(())
    } else {
        bad(path, message!("must be positive, at most 1e6, got {}", value))
    }
}

/// Two coordinates within [`MAX_COORDINATE`].
pub(super) fn point(path: &str, [x, y]: [f64; 2]) -> Result<(), Error> {
    match [x, y].into_iter().find(|v| v.is_nan() || v.abs() > MAX_COORDINATE) {
        Some(v) => bad(
            path,
            message!("must be finite, within ±{} m, got {}", format_args!("{:e}", MAX_COORDINATE), v),
        ),
        None => Ok(()),
    }
}

/// A pose within the bounds of coordinates; any finite heading.
pub(crate) fn finite_pose(pose: Pose) -> Result<(), Error> {
    point("x", [pose.x, 0.0])?;
    point("y", [pose.y, 0.0])?;
    finite("heading", pose.heading)
}

/// A list of points within the bounds, `least` of them at least.
pub(super) fn corners(path: &str, points: &[[f64; 2]], least: usize) -> Result<(), Error> {
    if points.len() < least || points.len() > MAX_CORNERS {
        return bad(path, message!("must have {} to {} points, got {}", least, MAX_CORNERS, points.len()));
    }
    points.iter().enumerate().try_for_each(|(i, &p)| point(&format!("{path}[{i}]"), p))
}

/// A closed outline: at least three corners, no two edges that touch, some area.
/// O(corners²): two thousand corners are two million pairs. Either direction is allowed.
pub(super) fn outline(path: &str, points: &[[f64; 2]]) -> Result<(), Error> {
    corners(path, points, 3)?;
    let n = points.len();
    // Relative to the first corner, so that the tests below keep their digits far from the origin.
    let p: Vec<Point> = points.iter().map(|q| Point::new(q[0] - points[0][0], q[1] - points[0][1])).collect();
    for i in 0..n {
        if p[i] == p[(i + 1) % n] {
            return bad(&format!("{path}[{}]", (i + 1) % n), "must differ from the corner before it".into());
        }
        for j in i + 1..n {
            let adjacent = j == i + 1 || (i == 0 && j == n - 1);
            if !adjacent && touch(p[i], p[i + 1], p[j], p[(j + 1) % n]) {
                return bad(path, message!("must not cross itself: edges {} and {} meet", i, j));
            }
        }
    }
    let area: f64 = (0..n).map(|i| cross(p[i], p[(i + 1) % n], Point::origin())).sum();
    if area == 0.0 {
        return bad(path, "must enclose an area".into());
    }
    Ok(())
}

fn cross(a: Point, b: Point, origin: Point) -> f64 {
    (a - origin).perp(&(b - origin))
}

/// True if two closed segments share a point.
pub(super) fn touch(a: Point, b: Point, c: Point, d: Point) -> bool {
    let side = |p, q, r| {
        let s = cross(q, r, p);
        if s > 0.0 { 1 } else { -i32::from(s < 0.0) }
    };
    let within = |p: Point, q: Point, r: Point| {
        r.x >= p.x.min(q.x) && r.x <= p.x.max(q.x) && r.y >= p.y.min(q.y) && r.y <= p.y.max(q.y)
    };
    let (s1, s2, s3, s4) = (side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b));
    (s1 != s2 && s3 != s4)
        || (s1 == 0 && within(a, b, c))
        || (s2 == 0 && within(a, b, d))
        || (s3 == 0 && within(c, d, a))
        || (s4 == 0 && within(c, d, b))
}
