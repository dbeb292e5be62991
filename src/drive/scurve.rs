//! A run with limited jerk: seven phases of constant jerk.

use super::motion::{Limits, Phase};

/// Speeds up from rest to `speed` (or, `down`, slows from it to rest): time and distance.
fn ramp(speed: f64, acceleration: f64, jerk: f64) -> ([f64; 2], f64) {
    let full = acceleration * acceleration / jerk;
    let (edge, flat) = if speed >= full {
        (acceleration / jerk, speed / acceleration - acceleration / jerk)
    } else {
        ((speed / jerk).sqrt(), 0.0)
    };
    // The speed is point-symmetric about the middle of the ramp.
    ([edge, flat], speed * (2.0 * edge + flat) / 2.0)
}

/// The phases of a run of `length` metres from rest to rest at no more than `top` m/s, from `at` (time, station) on.
pub(super) fn phases(limits: &Limits, jerk: f64, top: f64, length: f64, at: (f64, f64)) -> Vec<Phase> {
    let distance =
        |speed| ramp(speed, limits.acceleration, jerk).1 + ramp(speed, limits.deceleration, jerk).1;
    let mut peak = top;
    if distance(top) > length {
        let mut low = 0.0;
        for _ in 0..40 {
            let middle = f64::midpoint(low, peak);
            if distance(middle) > length {
                peak = middle;
            } else {
                low = middle;
            }
        }
        peak = low;
    }
    let ([up, rise], _) = ramp(peak, limits.acceleration, jerk);
    let ([down, fall], _) = ramp(peak, limits.deceleration, jerk);
    let cruise = (length - distance(peak)).max(0.0) / peak;
    let parts =
        [(up, jerk), (rise, 0.0), (up, -jerk), (cruise, 0.0), (down, -jerk), (fall, 0.0), (down, jerk)];
    let mut phase = Phase { time: at.0, station: at.1, ..Phase::default() };
    let mut phases = Vec::new();
    for (duration, jerk) in parts.into_iter().filter(|p| p.0 > 0.0) {
        phase = Phase { duration, jerk, ..phase };
        phases.push(phase);
        let (station, speed, acceleration) = phase.after(duration);
        phase = Phase { time: phase.time + duration, station, speed, acceleration, ..phase };
    }
    phases
}
