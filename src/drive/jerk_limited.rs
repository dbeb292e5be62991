//! Speeds with limited jerk: changes of speed in three phases of constant jerk, steady speed between them.
//!
//! The fastest such drive up to one peak is tried; where it is too fast for a stretch, the slowest of these is driven
//! at its limit, and the ways before and after it are planned in the same manner.
//!
//! A change of speed by Δv takes three phases: the acceleration grows with the jerk j, stays at its limit a, and falls
//! again. If Δv < a²/j it never reaches its limit, and the middle phase vanishes:
//!
//! ```text
//! Δv ≥ a²/j:  T = Δv/a + a/j        Δv < a²/j:  T = 2·√(Δv/j)        s = (v₀ + v₁)/2 · T
//! ```
//!
//! The length s is the mean speed times the time, because the speed is point-symmetric about the ramp's middle. It
//! grows with the speed at the top, so the highest peak that fits between two places is found by bisection; 48 halvings
//! leave 2⁻⁴⁸ of the range.
//!
//! Parts are worked off from the start on, so the phases come out in order; each part looks at the zones between its
//! ends. The profile is not the fastest there is: between two slow zones acceleration returns to 0.

use super::limits::Limits;
use super::phase::Phase;

/// Bisections of a speed.
const STEPS: u32 = 48;
/// Faster than a limit by less than this is rounding, m/s.
const ROUNDING: f64 = 1e-9;

/// A change of speed, without acceleration at its ends.
///
/// Lengths are positive: a ramp down is driven forwards in time too.
struct Ramp {
    from: f64,
    /// Seconds and jerk of its phases.
    parts: [(f64, f64); 3],
    /// Metres.
    length: f64,
}

impl Ramp {
    /// The ramp from one speed to another, by the formulas at the head of this file: `edge` is the time of each outer
    /// phase, `flat` that of the middle one.
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

    /// The three phases from `station` on; some may last no time.
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
type Milestone = (f64, f64);

/// A part of the run that has no speed profile yet.
enum Task {
    /// At the limits, without acceleration at the ends.
    Between(Milestone, Milestone),
    /// At one speed.
    Steady(Milestone, f64),
}

/// The phases of a run through zones of one limit each (where it ends, the limit), from one place and speed to another;
/// `None` where a zone or the end comes too soon to slow down or speed up for it.
pub(super) fn phases(
    limits: &Limits,
    jerk: f64,
    zones: &[(f64, f64)],
    [from, to]: [Milestone; 2],
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
            // Cruise interval that remains after both ramps, clipped to the zone. A zone too short to reach its speed
            // in is driven through on the way to another speed.
            let room = |speed: f64| (a.0 + ramp(a.1, speed).length, b.0 - ramp(speed, b.1).length);
            let speed = largest(ends.min(limit), limit, |speed| room(speed).0 <= room(speed).1);
            let (first, last) = room(speed);
            let (from, to) = (start.min(last).max(first), end.min(last).max(first));
            // Too fast for the zone at its beginning or end, whatever one does.
            let late = from > start + 1e-6 && a.1 > limit || to < end - 1e-6 && b.1 > limit;
            // All of it on the way from one speed to the other is no step ahead.
            (first <= last && !late && to > a.0 && from < b.0).then_some((from, to, speed))
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
        if peak > 0.0 {
            let steady =
                Phase { duration: cruise / peak, station: a.0 + up.length, speed: peak, ..Phase::default() };
            phases.push(steady);
        }
        phases.extend(down.phases(b.0 - down.length));
    }
    phases.retain(|phase| phase.duration > 1e-9);
    Some(phases)
}

#[cfg(test)]
mod tests {
    use super::*;

    const JERK: f64 = 2.0;
    /// Metres a second.
    const TOP: f64 = 3.0;

    fn limits() -> Limits {
        Limits { speed: TOP, acceleration: 1.0, deceleration: 1.5, ..Limits::default() }
    }

    /// Seconds and metres of a change of speed, once it is large enough for the whole acceleration.
    fn change(from: f64, to: f64) -> (f64, f64) {
        let most = if to > from { 1.0 } else { 1.5 };
        let time = (to - from).abs() / most + most / JERK;
        (time, time * (from + to) / 2.0)
    }

    /// Drives through zones; the time it takes. What it drives joins and keeps to all limits.
    fn driven(zones: &[(f64, f64)], ends: [Milestone; 2]) -> Option<f64> {
        let limits = limits();
        let phases = phases(&limits, JERK, zones, ends)?;
        let (mut at, mut time) = ((ends[0].0, ends[0].1, 0.0), 0.0);
        let near = |a: (f64, f64, f64), b: (f64, f64, f64)| {
            (a.0 - b.0).abs() < 1e-6 && (a.1 - b.1).abs() < 1e-6 && (a.2 - b.2).abs() < 1e-5
        };
        for phase in &phases {
            assert!(near(at, (phase.station, phase.speed, phase.acceleration)), "{at:?} {phase:?}");
            assert!(phase.duration > 0.0 && [0.0, JERK].contains(&phase.jerk.abs()), "{phase:?}");
            for k in 0..=16 {
                let (station, speed, acceleration) = phase.after(phase.duration * f64::from(k) / 16.0);
                assert!((-1.5 - 1e-6..=1.0 + 1e-6).contains(&acceleration), "{phase:?}");
                let limit =
                    |station: f64| zones.iter().find(|zone| station <= zone.0).map_or(TOP, |zone| zone.1);
                let most = limit(station - 1e-5).max(limit(station + 1e-5)).min(TOP);
                assert!(speed <= most + 1e-6, "{speed} at {station}: {phase:?}");
            }
            at = phase.after(phase.duration);
            time += phase.duration;
        }
        assert!(near(at, (ends[1].0, ends[1].1, 0.0)), "{at:?} {ends:?}");
        Some(time)
    }

    fn takes(zones: &[(f64, f64)], ends: [Milestone; 2], wanted: f64) {
        let time = driven(zones, ends).unwrap();
        assert!((time - wanted).abs() < 1e-6, "{time} s, not {wanted} s");
    }

    #[test]
    fn a_long_way_is_driven_at_the_limit() {
        let (up, down) = (change(0.0, TOP), change(TOP, 0.0));
        let steady = (100.0 - up.1 - down.1) / TOP;
        takes(&[(105.0, 9.0)], [(5.0, 0.0), (105.0, 0.0)], up.0 + steady + down.0);
        // Where one has not come to that speed yet, or no longer goes at it, a lower limit costs nothing.
        takes(&[(5.1, 1.0), (105.0, 9.0)], [(5.0, 0.0), (105.0, 0.0)], up.0 + steady + down.0);
        takes(&[(104.9, 9.0), (105.0, 1.0)], [(5.0, 0.0), (105.0, 0.0)], up.0 + steady + down.0);
        // In two zones of one limit, and begun and ended in motion.
        takes(&[(40.0, 9.0), (105.0, 9.0)], [(5.0, 0.0), (105.0, 0.0)], up.0 + steady + down.0);
        let (up, down) = (change(1.0, TOP), change(TOP, 1.5));
        takes(&[(60.0, TOP)], [(0.0, 1.0), (60.0, 1.5)], up.0 + (60.0 - up.1 - down.1) / TOP + down.0);
        takes(&[(60.0, TOP)], [(0.0, TOP), (60.0, TOP)], 60.0 / TOP);
    }

    #[test]
    fn it_may_begin_anywhere() {
        let (up, down) = (change(0.0, TOP), change(TOP, 0.0));
        let time = up.0 + (100.0 - up.1 - down.1) / TOP + down.0;
        takes(&[(149.9, 9.0), (150.0, 1.0)], [(50.0, 0.0), (150.0, 0.0)], time);
        // What begins where it ends does not matter.
        takes(&[(60.0, TOP), (70.0, 0.5)], [(60.0 - up.1, 0.0), (60.0, TOP)], up.0);
        assert!(driven(&[(60.0, TOP)], [(51.0, 2.0), (51.0 + change(2.0, 0.0).1 - 0.01, 0.0)]).is_none());
    }

    #[test]
    fn a_short_way_lowers_the_peak() {
        // Neither acceleration is reached: up and down are alike, each of p √(p / j) metres and 2 √(p / j) seconds.
        for length in [0.001, 0.1, 0.3] {
            let peak = (length * length * JERK / 4.0).cbrt();
            takes(&[(length, TOP)], [(0.0, 0.0), (length, 0.0)], 4.0 * (peak / JERK).sqrt());
        }
        // Shorter than any speed could be found for.
        takes(&[(1.0, TOP)], [(0.0, 0.0), (1e-30, 0.0)], 0.0);
        // Just far enough to go from one speed to another.
        let (time, length) = change(0.0, 2.0);
        takes(&[(length, TOP)], [(0.0, 0.0), (length, 2.0)], time);
        let (time, length) = change(2.0, 0.0);
        takes(&[(7.0 + length, TOP)], [(7.0, 2.0), (7.0 + length, 0.0)], time);
    }

    #[test]
    fn slow_zones_are_driven_at_their_limit() {
        let ramps = [change(0.0, TOP), change(TOP, 1.0), change(1.0, TOP), change(TOP, 0.0)];
        let (time, way) = ramps.iter().fold((0.0, 0.0), |sum, ramp| (sum.0 + ramp.0, sum.1 + ramp.1));
        let zones = [(40.0, TOP), (45.0, 1.0), (90.0, TOP)];
        takes(&zones, [(0.0, 0.0), (90.0, 0.0)], time + 5.0 + (85.0 - way) / TOP);
        // The slower of two, and at either end.
        let ramps = [change(0.0, 1.0), change(1.0, 2.0), change(2.0, 0.0)];
        let ways = ramps.map(|ramp| ramp.1);
        let wanted = ramps.iter().map(|ramp| ramp.0).sum::<f64>() + 20.0 - ways[0];
        let wanted = wanted + (20.0 - ways[1] - ways[2]) / 2.0;
        takes(&[(20.0, 1.0), (40.0, 2.0)], [(0.0, 0.0), (40.0, 0.0)], wanted);
    }

    #[test]
    fn what_comes_too_soon_is_refused() {
        let (_, length) = change(2.0, 0.0);
        assert!(driven(&[(9.0, TOP)], [(0.0, 2.0), (length - 0.01, 0.0)]).is_none());
        assert!(driven(&[(9.0, TOP)], [(0.0, 0.0), (1.0, 2.0)]).is_none());
        for ends in [[(0.0, 2.0), (30.0, 0.0)], [(0.0, 2.0), (30.0, 2.0)]] {
            assert!(driven(&[(1.0, 0.5), (30.0, TOP)], ends).is_none());
            assert!(driven(&[(0.2, TOP), (1.0, 0.5), (30.0, TOP)], ends).is_none());
        }
        assert!(driven(&[(29.0, TOP), (30.0, 0.5)], [(0.0, 0.0), (30.0, 2.0)]).is_none());
        assert!(driven(&[(29.0, TOP), (30.0, 2.0)], [(0.0, 0.0), (30.0, 2.0)]).is_some());
    }

    #[test]
    fn a_slow_zone_is_come_to_slowly() {
        // One slows down just before it, and speeds up just after it.
        let (down, up) = (change(2.0, 0.5), change(0.5, 2.0));
        let zones = [(10.0 + down.1, TOP), (30.0, 0.5), (30.0 + up.1, TOP)];
        takes(&zones, [(10.0, 2.0), (30.0 + up.1, 2.0)], down.0 + (20.0 - down.1) / 0.5 + up.0);
        // Too late, though there is room enough in it.
        for ends in [[(10.01, 2.0), (30.0 + up.1, 2.0)], [(10.0, 2.0), (29.99 + up.1, 2.0)]] {
            assert!(driven(&zones, ends).is_none());
        }
        assert!(driven(&zones[1..], [(15.0, 2.0), (25.0, 0.0)]).is_none());
        assert!(driven(&zones[1..], [(15.0, 0.0), (25.0, 2.0)]).is_none());
    }

    #[test]
    fn one_stops_through_a_zone_too_short_to_brake_in() {
        // From its limit, to which one comes before it; the other way round one speeds up beyond it.
        let stop = (2.0 * (1.0_f64 / JERK).sqrt(), (1.0_f64 / JERK).sqrt());
        let [first, up, down] = [change(0.0, 1.0), change(1.0, TOP), change(TOP, 1.0)];
        let before = first.0 + 5.0 - first.1;
        let between = up.0 + (15.0 - 5.0 - stop.1 - up.1 - down.1) / TOP + down.0;
        takes(&[(5.0, 1.0), (14.5, TOP), (15.0, 1.0)], [(0.0, 0.0), (15.0, 0.0)], before + between + stop.0);
        takes(&[(14.5, TOP), (15.0, 1.0)], [(5.0, 1.0), (15.0, 0.0)], between + stop.0);
        let [first, up, down] = [change(0.0, 0.9), change(0.9, TOP), change(TOP, 0.0)];
        let wanted = first.0 + up.0 + (15.0 - first.1 - up.1 - down.1) / TOP + down.0;
        takes(&[(0.5, 0.9), (15.0, TOP)], [(0.0, 0.0), (15.0, 0.0)], wanted);
    }

    #[test]
    fn hairs_of_zones_end_it_too() {
        for width in [1e-7, 1e-10, 1e-13] {
            for (zones, ends) in [
                ([(5.0, TOP), (5.0 + width, 0.5), (10.0, TOP)], [(5.0, 1.0), (10.0, 1.0)]),
                ([(5.0 - width, TOP), (5.0, 0.5), (10.0, TOP)], [(0.0, 1.0), (5.0, 1.0)]),
                ([(5.0, 2.0), (5.0 + width, 0.5), (10.0, TOP)], [(0.0, 0.5), (5.0 + width, 1.0)]),
            ] {
                // Both outcomes are reported.
                let _ = phases(&limits(), JERK, &zones, ends);
            }
        }
        // Through a hair at its limit.
        let ramps = [change(0.0, 0.5), change(0.5, 0.0)];
        let zones = [(5.0, 0.5), (5.0 + 1e-10, 0.4), (10.0, 0.5)];
        let time = driven(&zones, [(0.0, 0.0), (10.0, 0.0)]).unwrap();
        assert!(time > 20.0 + ramps[0].0 + ramps[1].0 - 2.0 * (ramps[0].1 + ramps[1].1) - 1e-6, "{time}");
    }

    #[test]
    fn any_zones_are_kept_to() {
        let mut state = 11_u64;
        let mut random = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as f64 / f64::from(1_u32 << 31)
        };
        for round in 0..300 {
            let longest = [1.0, 4.0, 20.0][round % 3];
            let mut end = 0.0;
            let zones: Vec<_> = (0..=round % 7)
                .map(|_| {
                    end += 0.25 + longest * random();
                    (end, 0.2 + 4.0 * random())
                })
                .collect();
            let time = driven(&zones, [(0.0, 0.0), (end, 0.0)]).expect("from standstill to standstill");
            let least = zones
                .iter()
                .fold((0.0, 0.0), |(from, time), zone| (zone.0, time + (zone.0 - from) / zone.1.min(TOP)));
            assert!(time > least.1);
        }
    }
}
