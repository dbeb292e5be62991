//! Whether a drive touches what moves.
//!
//! The test advances by safe steps: while everything is at least g metres apart, and the two can approach at no more
//! than w m/s, nothing can touch for g/w seconds. Here w is the boxes' largest speed plus that of the car's farthest
//! corner, |v|·(1 + r·κ), r metres from the rear axle at the largest curvature κ. A step is never shorter than
//! [`CHECK`]/w; within that an overlap may stay unseen.

use super::moving_obstacles::Mover;
use crate::geometry::{Point, Pose};
use crate::metrics::gap;
use crate::vehicle::Vehicle;

/// Between two moments of the check no corner of the car and no box near each other by more than this, metres, unless
/// they are farther apart.
const CHECK: f64 = 0.02;

/// The body overlaps a moving obstacle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// `moving[i]` of the scene.
    pub obstacle: usize,
    /// When, seconds.
    pub t: f64,
    /// Pose of the car at contact.
    pub pose: Pose,
    /// True if the car stands: it is run into.
    pub standing: bool,
}

/// Distance from a body to the nearest box, and which. Metres, 0 where they overlap; infinite and 0 without boxes.
pub(crate) fn nearest(movers: &[Mover], body: &[Point; 4], t: f64) -> (f64, usize) {
    let gaps = movers.iter().enumerate().map(|(i, m)| (gap(body, &m.outline(t)), i));
    gaps.fold((f64::INFINITY, 0), |best, next| if next.0 < best.0 { next } else { best })
}

/// The first overlap of a drive with a box. `moments` are times and the largest speed from each on; `pose` tells the
/// car's at a time from a moment on.
pub(crate) fn first_contact(
    vehicle: &Vehicle,
    movers: &[Mover],
    moments: &[(f64, f64)],
    pose: impl Fn(usize, f64) -> Pose,
) -> Option<Contact> {
    let fastest = movers.iter().map(Mover::speed).fold(0.0, f64::max);
    let reach = vehicle.reach();
    let corner = 1.0 + reach * vehicle.max_curvature();
    moments.iter().enumerate().find_map(|(i, &(from, speed))| {
        let to = moments.get(i + 1).map_or(from, |next| next.0);
        let nearing = fastest + speed * corner;
        let mut t = from;
        loop {
            let pose = pose(i, t);
            let (gap, obstacle) = nearest(movers, &vehicle.outline(pose), t);
            if gap <= 0.0 {
                return Some(Contact { obstacle, t, pose, standing: speed == 0.0 });
            }
            if t >= to {
                return None;
            }
            // Boxes turn at once where their lines do: whichever way they head, they are no nearer than this.
            let apart = movers.iter().map(|m| m.apart(pose.point(), t)).fold(f64::INFINITY, f64::min);
            t = to.min(t + (apart - reach).max(CHECK) / nearing);
        }
    })
}
