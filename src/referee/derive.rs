//! Speeds and steering angles of poses in time, where they are not given.
//!
//! Poses and times are data, speeds and steering angles a reconstruction. Between two poses the car is taken to drive
//! the circular arc through both, whose length follows from the chord c and the turn Δθ: s = c·(Δθ/2)/sin(Δθ/2). Speed
//! is ds/dt and curvature dθ/ds, hence φ = atan(L·κ). Where the reconstruction is wrong, the replay strays from the
//! poses, and [`super::Judgement::model_error`] shows it.

use super::states::unwrapped;
use super::{MotionLimits, States, TimedRows};
use crate::geometry::{Pose, math};
use crate::vehicle::Vehicle;

/// Shorter motions tell no curvature, metres.
const SHORTEST: f64 = 1e-6;
/// A profile of speeds that ends this slow ends at rest, m/s.
const AT_REST: f64 = 1e-4;

/// Signed length of the arc between two poses: negative where the car moves against its heading.
///
/// The sign is that of the chord along the mean heading, so headings must be unwrapped.
pub(super) fn arc(from: Pose, to: Pose) -> f64 {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let half = (to.heading - from.heading) / 2.0;
    let (sin, cos) = math::sin_cos(from.heading + half);
    let sign = if dx * cos + dy * sin < 0.0 { -1.0 } else { 1.0 };
    let bent = if half.abs() < 1e-6 { 1.0 } else { half / math::sin(half) };
    sign * math::hypot(dx, dy) * bent
}

/// The states of rows: what is missing comes from the poses.
pub(super) fn states(vehicle: &Vehicle, limits: &MotionLimits, rows: &TimedRows) -> States {
    let poses = unwrapped(&rows.poses);
    let arcs: Vec<f64> = poses.windows(2).map(|p| arc(p[0], p[1])).collect();
    let turns: Vec<f64> = poses.windows(2).map(|p| p[1].heading - p[0].heading).collect();
    let speed = rows.speed.clone().unwrap_or_else(|| speeds(limits, &rows.t, &arcs));
    let steering = rows.steering.clone().unwrap_or_else(|| angles(vehicle, &arcs, &turns));
    States { t: rows.t.clone(), poses, speed, steering }
}

/// Speeds that are linear between rows and cover the arcs, from rest to rest, where they keep the limits of
/// acceleration; else central differences.
///
/// The exact solution is the recursion v₀ = 0, vᵢ₊₁ = 2·sᵢ/Δtᵢ − vᵢ. It is unstable under noise (an error alternates in
/// sign and stays), so it counts only where every acceleration keeps the limits and the car ends at rest.
fn speeds(limits: &MotionLimits, t: &[f64], arcs: &[f64]) -> Vec<f64> {
    let dt: Vec<f64> = t.windows(2).map(|t| t[1] - t[0]).collect();
    let mean: Vec<f64> = arcs.iter().zip(&dt).map(|(s, dt)| s / dt).collect();
    let mut exact = vec![0.0];
    for (i, mean) in mean.iter().enumerate() {
        exact.push(2.0 * mean - exact[i]);
    }
    let most = 1.001 * limits.acceleration.max(limits.deceleration);
    let is_sound = exact.windows(2).zip(&dt).all(|(v, dt)| (v[1] - v[0]).abs() <= most * dt + 1e-6);
    if is_sound && exact[arcs.len()].abs() <= AT_REST {
        return exact;
    }
    let n = mean.len();
    let mut speeds = vec![0.0; n + 1];
    for i in 1..n {
        let (before, after) = (mean[i - 1], mean[i]);
        // Gears change at rest.
        if before * after >= 0.0 {
            speeds[i] = (before * dt[i] + after * dt[i - 1]) / (dt[i - 1] + dt[i]);
        }
    }
    speeds[0] = if n > 1 { 2.0 * mean[0] - speeds[1] } else { mean[0] };
    speeds[n] = if n > 1 { 2.0 * mean[n - 1] - speeds[n - 1] } else { mean[0] };
    speeds
}

/// Steering angles at the rows: of the mean curvature of the two arcs that meet there. A standstill tells no curvature
/// and takes that of the motion before it. The mean is weighted by the other arc's length, which is the linear
/// interpolation between the middles of the arcs.
fn angles(vehicle: &Vehicle, arcs: &[f64], turns: &[f64]) -> Vec<f64> {
    let known = |i: usize| (arcs[i].abs() > SHORTEST).then(|| turns[i] / arcs[i]);
    let n = arcs.len();
    let first = (0..n).find_map(known).unwrap_or(0.0);
    let mut curvatures = Vec::with_capacity(n);
    let mut last = first;
    for i in 0..n {
        last = known(i).unwrap_or(last);
        curvatures.push(last);
    }
    let at = |i: usize| {
        let (before, after) = (i.saturating_sub(1).min(n - 1), i.min(n - 1));
        let (a, b) = (arcs[before].abs().max(SHORTEST), arcs[after].abs().max(SHORTEST));
        (curvatures[before] * b + curvatures[after] * a) / (a + b)
    };
    (0..=n).map(|i| math::atan(vehicle.wheelbase * at(i))).collect()
}
