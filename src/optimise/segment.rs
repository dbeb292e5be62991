//! A stretch of path whose steering angle is linear in the distance.
//!
//! Along the distance s of a segment of length h, in the gear g (±1) and with the wheelbase L:
//!
//! ```text
//! φ(s) = φ₀ + (φ₁ − φ₀)·s/h    θ′ = g·tan φ / L    x′ = g·cos θ    y′ = g·sin θ
//! ```
//!
//! There is no closed form. The curvature is replaced by the parabola through its values at both ends and in the
//! middle, whose integral gives the headings in the middle and at the end. Simpson's rule over the three headings gives
//! the position. For steps of 0.2 m the error is far below what the end's correction removes, and the derivatives are
//! as simple as the formula.

use crate::geometry::math;

/// Unknowns of a node, in this order.
pub(super) const X: usize = 0;
pub(super) const Y: usize = 1;
pub(super) const HEADING: usize = 2;
pub(super) const ANGLE: usize = 3;
pub(super) const STEP: usize = 4;

/// A node of the path: rear axle, unwrapped heading, steering angle, and the distance to the next node.
///
/// Metres relative to the path's origin, radians. The step is driven distance and not negative, in either gear.
pub(super) type Node = [f64; 5];

/// The end of a stretch: x, y, heading; and their derivatives by heading, steering angle and distance at its beginning
/// and by the steering angle at its end.
///
/// `slopes[i][j]`: component i (x, y, heading) by the start's heading, its angle, its step, and the end's angle. By the
/// start's own x and y they are those of the identity.
pub(super) struct End {
    pub(super) pose: [f64; 3],
    pub(super) slopes: [[f64; 4]; 3],
}

/// Drives from `node` over its distance in a gear (±1), the wheel turning evenly to `angle`: Simpson's rule over
/// headings that are themselves integrated by a quadratic through three curvatures.
///
/// The heading's slopes do not depend on the heading, so `slopes[2][0]` is 1.
pub(super) fn drive(node: &Node, angle: f64, gear: f64, wheelbase: f64) -> End {
    let (heading, h) = (node[HEADING], node[STEP]);
    let angles = [node[ANGLE], f64::midpoint(node[ANGLE], angle), angle];
    let tangents = angles.map(math::tan);
    let curvature = tangents.map(|t| gear * t / wheelbase);
    // Of the curvature by the angle.
    let bend = tangents.map(|t| gear * (1.0 + t * t) / wheelbase);
    // Headings in the middle and at the end, per metre, and by both angles.
    let half = (5.0 * curvature[0] + 8.0 * curvature[1] - curvature[2]) / 24.0;
    let half_by = [(5.0 * bend[0] + 4.0 * bend[1]) / 24.0, (4.0 * bend[1] - bend[2]) / 24.0];
    let full = (curvature[0] + 4.0 * curvature[1] + curvature[2]) / 6.0;
    let full_by = [(bend[0] + 2.0 * bend[1]) / 6.0, (2.0 * bend[1] + bend[2]) / 6.0];
    let [s0, s1, s2] = [0.0, h * half, h * full].map(|turn| math::sin_cos(heading + turn));
    let mean = |a: f64, b: f64, c: f64| (a + 4.0 * b + c) / 6.0;
    let (cos, sin) = (mean(s0.1, s1.1, s2.1), mean(s0.0, s1.0, s2.0));
    let (x, y) = (gear * h * cos, gear * h * sin);
    // A change of the headings in the middle and at the end.
    let turned = |middle: f64, end: f64| {
        let (m, e) = (4.0 * middle / 6.0, end / 6.0);
        (-gear * h * (m * s1.0 + e * s2.0), gear * h * (m * s1.1 + e * s2.1))
    };
    let by_first = turned(h * half_by[0], h * full_by[0]);
    let by_last = turned(h * half_by[1], h * full_by[1]);
    let by_step = turned(half, full);
    End {
        pose: [node[X] + x, node[Y] + y, heading + h * full],
        slopes: [
            [-y, by_first.0, gear * cos + by_step.0, by_last.0],
            [x, by_first.1, gear * sin + by_step.1, by_last.1],
            [1.0, h * full_by[0], full, h * full_by[1]],
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Pose;

    #[test]
    fn an_arc_is_an_arc_and_slopes_are_differences() {
        let node = [1.0, 2.0, 0.7, 0.4, 0.25];
        let arc = drive(&node, 0.4, -1.0, 3.7);
        let wanted = Pose::new(1.0, 2.0, 0.7).advance(math::tan(0.4) / 3.7, -0.25);
        assert!((arc.pose[0] - wanted.x).abs() < 1e-9 && (arc.pose[1] - wanted.y).abs() < 1e-9);
        assert!((arc.pose[2] - wanted.heading).abs() < 1e-12);
        let bent = drive(&node, -0.1, 1.0, 3.7);
        for (k, place) in [HEADING, ANGLE, STEP, 5].into_iter().enumerate() {
            let moved = |by: f64| {
                let mut other = node;
                if place < 5 {
                    other[place] += by;
                }
                drive(&other, if place == 5 { -0.1 + by } else { -0.1 }, 1.0, 3.7).pose
            };
            let (before, after) = (moved(-1e-5), moved(1e-5));
            for i in 0..3 {
                let slope = (after[i] - before[i]) / 2e-5;
                assert!((slope - bent.slopes[i][k]).abs() < 1e-8, "{i} by {k}");
            }
        }
    }
}
