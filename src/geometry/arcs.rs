//! Paths of circular arcs and straight lines, driven forward and in reverse.
//!
//! A car with a fixed steering angle δ and wheelbase L drives a circle of curvature κ = tan δ / L about the middle
//! of its rear axle. So a list of arcs, a start pose and nothing else describe a path that a car can drive, apart
//! from the moments at which the wheel turns. Poses along an arc are integrated exactly, not in steps.

use super::{Pose, math};

/// An arc of constant curvature, or a straight line.
///
/// The sign of the length is the gear, the sign of the curvature the side on which the centre lies. Turning the
/// wheel left and reversing therefore has a positive curvature and a negative length, and the heading falls.
///
/// # Examples
/// ```
/// use parkade::geometry::{Pose, arcs::{self, Arc}};
///
/// // A quarter circle of radius 5 m to the left, then 2 m back.
/// let path = [Arc { curvature: 0.2, length: 2.5 * std::f64::consts::PI }, Arc { curvature: 0.0, length: -2.0 }];
/// let end = arcs::end(Pose::default(), &path);
/// assert!((end.x - 5.0).abs() < 1e-9 && (end.y - 3.0).abs() < 1e-9);
/// assert_eq!(arcs::direction_changes(&path), 1);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// 1/m, positive to the left of the car in either gear.
    pub curvature: f64,
    /// Metres, negative in reverse.
    pub length: f64,
}

/// A pose along a path and how the car goes on from there.
///
/// At a gear change there is one waypoint; it tells of the arc ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waypoint {
    /// The pose.
    pub pose: Pose,
    /// Of the arc ahead, 1/m.
    pub curvature: f64,
    /// Of the arc ahead, ±1.
    pub gear: i8,
    /// Distance driven so far, metres.
    pub station: f64,
}

/// Length of the arc over a chord on which the heading turns by `turn` radians; metres, as the chord.
pub(crate) fn length_over(chord: f64, turn: f64) -> f64 {
    let half = turn / 2.0;
    if half.abs() < 1e-6 { chord } else { chord * half / math::sin(half) }
}

/// Curvatures closer than this are one curvature, 1/m.
const SAME_CURVATURE: f64 = 1e-9;
/// Shorter arcs are none, metres.
const SHORTEST: f64 = 1e-9;

/// Joins neighbouring arcs of one curvature and gear and drops those without length.
///
/// The path stays the same curve. A search finds a circle as many pieces, one per expansion; joined they are one arc.
pub fn merge(arcs: impl IntoIterator<Item = Arc>) -> Vec<Arc> {
    let mut merged: Vec<Arc> = Vec::new();
    for arc in arcs.into_iter().filter(|a| a.length.abs() >= SHORTEST) {
        match merged.last_mut() {
            Some(last)
                if (last.curvature - arc.curvature).abs() < SAME_CURVATURE
                    && last.length.signum() == arc.length.signum() =>
            {
                last.length += arc.length;
            }
            _ => merged.push(arc),
        }
    }
    merged
}

/// Distance driven in both gears, metres.
pub fn length(arcs: &[Arc]) -> f64 {
    // Not `sum`, which starts from −0.
    arcs.iter().fold(0.0, |sum, a| sum + a.length.abs())
}

/// Gear changes (cusps): sign changes of the length between consecutive arcs. Arcs without length should be
/// [merged](merge) away before, as they count as forward.
pub fn direction_changes(arcs: &[Arc]) -> u32 {
    arcs.windows(2).filter(|w| (w[0].length < 0.0) != (w[1].length < 0.0)).count() as u32
}

/// The pose at the end.
pub fn end(start: Pose, arcs: &[Arc]) -> Pose {
    arcs.iter().fold(start, |pose, arc| pose.advance(arc.curvature, arc.length))
}

/// The same curve driven from its end back to its start: the order is reversed and so is every gear.
///
/// A search that grows from the goal finds its path in this form.
pub fn reversed(arcs: &[Arc]) -> Vec<Arc> {
    arcs.iter().rev().map(|a| Arc { curvature: a.curvature, length: -a.length }).collect()
}

/// Poses at most `step` metres apart, the ends of all arcs included; the last is exactly `end`.
///
/// Each arc is divided evenly, and each pose is integrated from the beginning of its arc, so errors do not add up along
/// an arc. `end` is given because the sum of rounding errors over a path would otherwise leave the goal by some
/// nanometres.
pub fn sample(start: Pose, arcs: &[Arc], end: Pose, step: f64) -> Vec<Waypoint> {
    let mut points = Vec::new();
    let (mut pose, mut station) = (start, 0.0);
    let mut last = (0.0, 1);
    for arc in arcs {
        let steps = (arc.length.abs() / step).ceil().max(1.0) as u32;
        let gear = if arc.length < 0.0 { -1 } else { 1 };
        last = (arc.curvature, gear);
        for k in 0..steps {
            let along = arc.length * f64::from(k) / f64::from(steps);
            let pose = pose.advance(arc.curvature, along);
            points.push(Waypoint { pose, curvature: arc.curvature, gear, station: station + along.abs() });
        }
        pose = pose.advance(arc.curvature, arc.length);
        station += arc.length.abs();
    }
    points.push(Waypoint { pose: end, curvature: last.0, gear: last.1, station });
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    const PATH: [Arc; 3] = [
        Arc { curvature: 0.2, length: 3.0 },
        Arc { curvature: 0.0, length: -2.0 },
        Arc { curvature: -0.1, length: -1.05 },
    ];

    #[test]
    fn driving_back_returns_to_the_start() {
        let start = Pose::new(1.0, 2.0, 0.3);
        let back = end(end(start, &PATH), &reversed(&PATH));
        assert!(
            (back.point() - start.point()).norm() < 1e-12 && (back.heading - start.heading).abs() < 1e-12
        );
        assert_eq!(direction_changes(&PATH), 1);
        assert!((length(&PATH) - 6.05).abs() < 1e-12);
    }

    #[test]
    fn equal_neighbours_merge_and_empty_arcs_vanish() {
        let arc = |curvature, length| Arc { curvature, length };
        let merged = merge([arc(0.1, 1.0), arc(0.3, 0.0), arc(0.1, 2.0), arc(0.1, -1.0)]);
        assert_eq!(merged, [arc(0.1, 3.0), arc(0.1, -1.0)]);
    }

    #[test]
    fn samples_are_close_and_end_exactly() {
        let start = Pose::new(0.0, 0.0, 0.0);
        let goal = end(start, &PATH);
        let points = sample(start, &PATH, goal, 0.1);
        assert!(points.windows(2).all(|w| (w[1].pose.point() - w[0].pose.point()).norm() <= 0.1 + 1e-12));
        assert_eq!(points[points.len() - 1].pose, goal);
        assert_eq!((points[0].gear, points[31].gear), (1, -1));
    }

    #[test]
    fn the_least_difference_and_the_least_length_count() {
        let arc = |curvature, length| Arc { curvature, length };
        assert_eq!(merge([arc(0.0, 1.0), arc(SAME_CURVATURE, 1.0)]).len(), 2);
        assert_eq!(merge([arc(0.0, 1.0), arc(0.9 * SAME_CURVATURE, 1.0)]).len(), 1);
        assert_eq!(merge([arc(0.1, SHORTEST), arc(0.2, -0.9 * SHORTEST)]), [arc(0.1, SHORTEST)]);
    }

    #[test]
    fn samples_tell_station_curvature_and_gear() {
        let start = Pose::new(1.0, 2.0, 0.3);
        let points = sample(start, &PATH, end(start, &PATH), 1.0);
        let told: Vec<_> = points.iter().map(|p| (p.station, p.curvature, p.gear)).collect();
        let forward = [(0.0, 0.2, 1), (1.0, 0.2, 1), (2.0, 0.2, 1)];
        let back = [(3.0, 0.0, -1), (4.0, 0.0, -1), (5.0, -0.1, -1), (5.525, -0.1, -1), (6.05, -0.1, -1)];
        assert_eq!(told, [&forward[..], &back].concat());
        for (point, driven) in [(1, &[Arc { length: 1.0, ..PATH[0] }][..]), (3, &PATH[..1]), (5, &PATH[..2])]
        {
            let pose = end(start, driven);
            assert!((points[point].pose.point() - pose.point()).norm() < 1e-12);
            assert!((points[point].pose.heading - pose.heading).abs() < 1e-12);
        }
    }

    #[test]
    fn standing_is_no_reverse() {
        let start = Pose::new(1.0, 2.0, 0.3);
        let points = sample(start, &[Arc { curvature: 0.1, length: 0.0 }], start, 1.0);
        assert_eq!(
            points.iter().map(|p| (p.pose, p.gear, p.station)).collect::<Vec<_>>(),
            [(start, 1, 0.0); 2]
        );
        let changes =
            |lengths: [f64; 3]| direction_changes(&lengths.map(|length| Arc { curvature: 0.1, length }));
        assert_eq!((changes([1.0, 0.0, 2.0]), changes([-1.0, 0.0, -2.0])), (0, 2));
    }
}
