//! The controls of a trajectory, integrated by the classical Runge–Kutta method in steps of at most a millisecond.
//!
//! Controls are constant between two rows, so v and φ are linear there and only the pose has to be integrated. The
//! method's error in a step of h = 1 ms is of the order h⁵, so beside the verdict's centimetre the replay counts as
//! exact.

use super::States;
use crate::geometry::{Pose, math};
use crate::vehicle::Vehicle;

/// Frames stand this far apart, seconds.
pub(super) const FRAME: f64 = 0.001;
/// A frame nearer than this to a row is that row, seconds.
const SAME_TIME: f64 = 1e-9;

/// A moment of a replay.
///
/// Speed and steering angle at a row are that row's own values, not sums of increments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Seconds.
    pub t: f64,
    /// Middle of the rear axle; the heading is unwrapped.
    pub pose: Pose,
    /// m/s, negative in reverse.
    pub speed: f64,
    /// Radians.
    pub steering: f64,
}

/// Drives the controls of `states` from its first state and tells each millisecond, each row and the end. Steps end at
/// rows, where the controls change. Positions and headings of later rows play no part.
///
/// Times count in whole milliseconds from 0, so equal trajectories give equal frames on every platform. A trajectory of
/// T seconds with n rows gives at most 1000·T + n frames. `states` without poses gives none.
pub fn replay(vehicle: &Vehicle, states: &States, mut each: impl FnMut(Frame)) {
    let Some(&start) = states.poses.first() else { return };
    let mut now = Frame { t: states.t[0], pose: start, speed: states.speed[0], steering: states.steering[0] };
    each(now);
    let mut tick = 1.0;
    for row in 1..states.t.len() {
        let (from, end) = (now, states.t[row]);
        let rates = [
            (states.speed[row] - from.speed) / (end - from.t),
            (states.steering[row] - from.steering) / (end - from.t),
        ];
        while now.t < end {
            let next = tick * FRAME;
            let is_row = next > end - SAME_TIME;
            if next < end + SAME_TIME {
                tick += 1.0;
            }
            let t = if is_row { end } else { next };
            now = step(vehicle, now, rates, t);
            if is_row {
                // What is linear in time is what the row says.
                (now.speed, now.steering) = (states.speed[row], states.steering[row]);
            }
            each(now);
        }
    }
}

/// One Runge–Kutta step of ẋ = v cos θ, ẏ = v sin θ, θ̇ = v tan φ / L, v̇ = a, φ̇ = ω.
fn step(vehicle: &Vehicle, from: Frame, [a, w]: [f64; 2], t: f64) -> Frame {
    let h = t - from.t;
    let rate = |share: f64, heading: f64| {
        let (v, steering) = (from.speed + a * h * share, from.steering + w * h * share);
        let (sin, cos) = math::sin_cos(heading);
        [v * cos, v * sin, v * math::tan(steering) / vehicle.wheelbase]
    };
    let k1 = rate(0.0, from.pose.heading);
    let k2 = rate(0.5, from.pose.heading + k1[2] * h / 2.0);
    let k3 = rate(0.5, from.pose.heading + k2[2] * h / 2.0);
    let k4 = rate(1.0, from.pose.heading + k3[2] * h);
    let mean = |i: usize| (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]) / 6.0;
    let Pose { x, y, heading } = from.pose;
    Frame {
        t,
        pose: Pose::new(x + h * mean(0), y + h * mean(1), heading + h * mean(2)),
        speed: from.speed + a * h,
        steering: from.steering + w * h,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_driven_to_the_nanometre_and_frames_stand_on_milliseconds() {
        let car = Vehicle::PAPER;
        let (curvature, speed) = (car.max_curvature(), 1.5);
        let mut states = States::default();
        for t in [0.0, 0.3337, 2.0] {
            states.push(t, Pose::default(), speed, car.max_steer);
        }
        let mut frames = Vec::new();
        replay(&car, &states, |frame| frames.push(frame));
        // 2 000 milliseconds, the start and the row between two of them.
        assert_eq!(frames.len(), 2002);
        let (last, wanted) = (frames[2001], Pose::default().advance(curvature, 3.0));
        assert_eq!(last.t, 2.0);
        assert!((last.pose.point() - wanted.point()).norm() < 1e-9);
        assert!((last.pose.heading - 3.0 * curvature).abs() < 1e-12);
    }

    #[test]
    fn a_speed_that_grows_moves_the_car_by_its_integral() {
        let mut states = States::default();
        states.push(0.0, Pose::default(), 0.0, 0.0);
        states.push(2.0, Pose::default(), -2.0, 0.0);
        let mut end = None;
        replay(&Vehicle::SEDAN, &states, |frame| end = Some(frame));
        assert!((end.unwrap().pose.x + 2.0).abs() < 1e-12);
    }
}
