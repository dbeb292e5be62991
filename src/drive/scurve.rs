//! Speeds with limited jerk: changes of speed in three phases of constant jerk, steady speed between them.
//!
//! The fastest such drive up to one peak is tried; where it is too fast for a stretch, the slowest of these is driven at
//! its limit, and the ways before and after it are planned in the same manner.

use super::motion::{Limits, Phase};

/// Bisections of a speed.
const STEPS: u32 = 48;
/// Faster than a limit by less than this is rounding, m/s.
const ROUNDING: f64 = 1e-9;

/// A change of speed, without acceleration at its ends.
struct Ramp {
    from: f64,
    /// Seconds and jerk of its phases.
    parts: [(f64, f64); 3],
    /// Metres.
    length: f64,
}

impl Ramp {
    fn new(from: f64, to: f64, limits: &Limits, jerk: f64) -> Self {
        let change = (to - from).abs();
        let (most, jerk) =
            if to >= from { (limits.acceleration, jerk) } else { (limits.deceleration, -jerk) };
        let (edge, flat) = if change >= most * most / jerk.abs() {
            (most / jerk.abs(), change / most - most / jerk.abs())
        } else {
            ((change / jerk.abs()).sqrt(), 0.0)
        };
        // The speed is point-symmetric about the middle.
        let length = (from + to) * (2.0 * edge + flat) / 2.0;
        Self { from, parts: [(edge, jerk), (flat, 0.0), (edge, -jerk)], length }
    }

    fn phases(&self, station: f64) -> impl Iterator<Item = Phase> {
        let mut next = Phase { station, speed: self.from, ..Phase::default() };
        self.parts.into_iter().map(move |(duration, jerk)| {
            let phase = Phase { duration, jerk, ..next };
            let (station, speed, acceleration) = phase.after(duration);
            next = Phase { station, speed, acceleration, ..Phase::default() };
            phase
        })
    }

    /// The speed after so many metres of it.
    fn speed(&self, way: f64) -> f64 {
        let phases: Vec<Phase> = self.phases(0.0).collect();
        let phase = phases.iter().rev().find(|p| p.station <= way).unwrap_or(&phases[0]);
        let after = largest(0.0, phase.duration, |t| phase.after(t).0 <= way);
        phase.after(after).1
    }
}

/// The largest value between the two that is good, when smaller ones are.
fn largest(low: f64, high: f64, good: impl Fn(f64) -> bool) -> f64 {
    if good(high) {
        return high;
    }
    let (mut low, mut high) = (low, high);
    for _ in 0..STEPS {
        let middle = f64::midpoint(low, high);
        if good(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// A station and the speed there.
type Place = (f64, f64);

/// What is still to be driven.
enum Task {
    /// At the limits, without acceleration at the ends.
    Between(Place, Place),
    /// At one speed.
    Steady(Place, f64),
}

/// The phases of a run through zones of one limit each (where it ends, the limit), from one place and speed to another;
/// `None` where a zone or the end comes too soon to slow down or speed up for it.
pub(super) fn phases(
    limits: &Limits,
    jerk: f64,
    zones: &[(f64, f64)],
    [from, to]: [Place; 2],
) -> Option<Vec<Phase>> {
    let ramp = |from: f64, to: f64| Ramp::new(from, to, limits, jerk);
    let mut tasks = vec![Task::Between(from, to)];
    let mut phases = Vec::new();
    while let Some(task) = tasks.pop() {
        let (a, b) = match task {
            Task::Between(a, b) => (a, b),
            Task::Steady((station, speed), end) => {
                let duration = (end - station) / speed;
                phases.push(Phase { duration, station, speed, ..Phase::default() });
                continue;
            }
        };
        let fits = |peak: f64| ramp(a.1, peak).length + ramp(peak, b.1).length <= b.0 - a.0;
        let ends = a.1.max(b.1);
        let peak = largest(ends, limits.speed.max(ends), fits);
        let (up, down) = (ramp(a.1, peak), ramp(peak, b.1));
        let (top, fall) = (a.0 + up.length, b.0 - down.length);
        let fastest = |from: f64, to: f64| {
            if to < top {
                up.speed(to - a.0)
            } else if from > fall {
                down.speed(from - fall)
            } else {
                peak
            }
        };
        let first = zones.partition_point(|zone| zone.0 <= a.0);
        let mut start = a.0;
        let mut slowest: Option<(f64, f64, f64)> = None;
        for &(end, limit) in zones[first..].iter().take_while({
            let mut before = a.0;
            move |zone| std::mem::replace(&mut before, zone.0) < b.0
        }) {
            let end = end.min(b.0);
            if slowest.is_none_or(|s| limit < s.2) && fastest(start, end) > limit + ROUNDING {
                slowest = Some((start, end, limit));
            }
            start = end;
        }
        let steady = slowest.and_then(|(start, end, limit)| {
            let reach = |speed: f64| {
                (start.max(a.0 + ramp(a.1, speed).length), end.min(b.0 - ramp(speed, b.1).length))
            };
            let speed = largest(ends.min(limit), limit, |speed| reach(speed).0 <= reach(speed).1);
            let (from, to) = reach(speed);
            // Too fast for the zone at its beginning or end, whatever one does.
            let late = from > start + 1e-6 && a.1 > limit || to < end - 1e-6 && b.1 > limit;
            (from <= to && !late).then_some((from, to, speed))
        });
        if let Some((from, to, speed)) = steady {
            tasks.push(Task::Between((to, speed), b));
            tasks.push(Task::Steady((from, speed), to));
            tasks.push(Task::Between(a, (from, speed)));
            continue;
        }
        if !fits(ends) && ramp(a.1, b.1).length > b.0 - a.0 + 1e-6
            || slowest.is_some_and(|s| ends > s.2 + ROUNDING)
        {
            return None;
        }
        // Where a slow zone is too short to settle in it, one goes from the one speed straight to the other.
        let peak = if slowest.is_some() { ends } else { peak };
        let (up, down) = (ramp(a.1, peak), ramp(peak, b.1));
        phases.extend(up.phases(a.0));
        let cruise = b.0 - a.0 - up.length - down.length;
        if cruise > 0.0 && peak > 0.0 {
            let steady =
                Phase { duration: cruise / peak, station: a.0 + up.length, speed: peak, ..Phase::default() };
            phases.push(steady);
        }
        phases.extend(down.phases(b.0 - down.length));
    }
    phases.retain(|phase| phase.duration > 1e-9);
    Some(phases)
}
