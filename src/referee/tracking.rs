//! A simulated car follows a trajectory in closed loop, at its own speeds.
//!
//! The judge asks whether the trajectory itself is sound; this asks how it fares on a car that starts from it and
//! corrects. Lateral error e is positive to the left of the trajectory, heading error ψ where the car points farther to
//! the left. With the signed speed v the correction of the curvature is
//!
//! ```text
//! κ = tan(φ_ahead)/L − (1.6 · sign(v) · ψ + 0.64 · e)
//! ```
//!
//! The gains in distance place both poles of the linearised error e″ = −1.6·e′ − 0.64·e at −0.8 per metre: critically
//! damped, so an error decays without oscillation within some metres, whatever the speed.

use super::{States, replay};
use crate::drive::Tracking;
use crate::geometry::{Pose, math};
use crate::metrics::Body;
use crate::vehicle::Vehicle;

/// Frames of a replay per step: 5 ms.
const STEP: usize = 5;
/// Steps per kept row.
const KEPT: usize = 10;
/// Curvature per heading error, 1/m, and per lateral error, 1/m².
const GAINS: (f64, f64) = (1.6, 0.64);

/// Lets a car follow `states`: the steering angle of the trajectory one step ahead, corrected by feedback on heading
/// and lateral error, through a wheel of limited angle and rate.
///
/// Takes the time of one replay. Every tenth step (50 ms) and the last become rows; `max_lateral` and `max_heading`
/// count every step.
pub fn track(vehicle: &Vehicle, body: &Body, states: &States) -> Tracking {
    let mut frames = Vec::new();
    replay(vehicle, states, |frame| frames.push(frame));
    let last = frames[frames.len() - 1];
    let mut moments: Vec<_> = frames.into_iter().step_by(STEP).collect();
    if moments[moments.len() - 1].t < last.t {
        moments.push(last);
    }
    let (mut pose, mut angle) = (moments[0].pose, moments[0].steering);
    let mut log = Tracking::default();
    for (i, now) in moments.iter().enumerate() {
        let lateral = now.pose.to_local(pose.point()).y;
        let heading = math::turn(now.pose.heading, pose.heading);
        log.max_lateral = log.max_lateral.max(lateral.abs());
        log.max_heading = log.max_heading.max(heading.abs());
        if i % KEPT == 0 || i + 1 == moments.len() {
            log.t.push(now.t);
            log.poses.push(pose);
            log.lateral.push(lateral);
            log.steering.push(angle);
        }
        let Some(next) = moments.get(i + 1) else { break };
        let speed = f64::midpoint(now.speed, next.speed);
        let correction = GAINS.0 * heading * speed.signum() + GAINS.1 * lateral;
        let wanted = math::atan(math::tan(next.steering) - vehicle.wheelbase * correction);
        let most = vehicle.max_steer_rate * (next.t - now.t);
        let before = angle;
        angle += (wanted.clamp(-vehicle.max_steer, vehicle.max_steer) - angle).clamp(-most, most);
        let curvature = math::tan(f64::midpoint(before, angle)) / vehicle.wheelbase;
        pose = pose.advance(curvature, speed * (next.t - now.t));
        if log.hit.is_none() && speed != 0.0 {
            log.hit = body.hit(pose).map(|owner| (owner, pose));
        }
    }
    ends(&mut log, pose, last.pose);
    log
}

/// Errors at the end: metres and radians to the trajectory's last pose.
fn ends(log: &mut Tracking, pose: Pose, goal: Pose) {
    log.end_distance = (pose.point() - goal.point()).norm();
    log.end_heading = math::turn(goal.heading, pose.heading).abs();
}
