//! The fallback that always works: the plan's own arcs, standing still wherever the curvature steps.

use super::roll_out::{Cell, Rows};
use crate::drive::Route;
use crate::geometry::math;
use crate::referee::{MotionLimits, States};
use crate::vehicle::Vehicle;

/// Shorter stretches are none, metres.
const NOTHING: f64 = 1e-12;

/// Drives the arcs of a route, each from rest to rest, and turns the wheel between them.
pub fn stop_and_steer(vehicle: &Vehicle, route: &Route, limits: &MotionLimits) -> States {
    let rate = limits.steering_rate_of(vehicle);
    let mut rows = Rows::new(f64::INFINITY);
    for arc in route.arcs() {
        let angle = math::atan(vehicle.wheelbase * arc.curvature);
        rows.turn(angle, rate);
        let lateral =
            limits.lateral_acceleration.map_or(f64::INFINITY, |most| (most / arc.curvature.abs()).sqrt());
        let length = arc.length.abs();
        let inverse = 1.0 / limits.acceleration + 1.0 / limits.deceleration;
        let peak = limits.speed.min(lateral).min((2.0 * length / inverse).sqrt());
        let ramps = [limits.acceleration, limits.deceleration].map(|rate| peak * peak / 2.0 / rate);
        let parts = [ramps[0], length - ramps[0] - ramps[1], ramps[1]];
        let cells: Vec<Cell> = parts
            .into_iter()
            .filter(|&length| length > NOTHING)
            .map(|length| Cell { length, speed: peak, begins: true })
            .collect();
        rows.drive(limits, &cells, arc.length.signum(), |_| angle);
    }
    rows.turn(0.0, rate);
    rows.plain(route.pose(0.0), vehicle.wheelbase)
}
