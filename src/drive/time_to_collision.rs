//! Time to collision: how soon car and moving boxes would touch if both kept their velocity.
//!
//! The usual measure of traffic safety (Hayward 1972). Both outlines move in straight lines, so the moment of touch is
//! exact: along each separating axis the projections meet during an interval of time, and the outlines touch when all
//! intervals overlap.
//!
//! With the relative speed w along an axis, the projections [a₀, a₁] and [b₀, b₁] overlap from (a₁ − b₀)/w to (a₀ −
//! b₁)/w or the other way around. The intersection of the four axes' intervals is the time of overlap; its beginning,
//! not before now, is the answer.

use super::moving_obstacles::Mover;
use super::trajectory::Rows;
use crate::geometry::{Point, Vector};
use crate::vehicle::Vehicle;

/// Velocities below this do not bring anything nearer, m/s.
const STILL: f64 = 1e-9;

/// Per row of a drive: seconds until the car would touch a moving box if both kept their velocity; 0 while they
/// overlap, infinite where they never would.
pub(crate) fn times_to_collision(vehicle: &Vehicle, movers: &[Mover], rows: &Rows) -> Vec<f64> {
    let at = |row: usize| {
        let (t, pose) = (rows.t[row], rows.poses[row]);
        let body = vehicle.outline(pose);
        let velocity = pose.direction() * rows.speed[row];
        let soonest = |mover: &Mover| touch(&body, &mover.outline(t), mover.velocity(t) - velocity);
        movers.iter().map(soonest).fold(f64::INFINITY, f64::min)
    };
    (0..rows.t.len()).map(at).collect()
}

/// Seconds until rectangle `b`, moving at `velocity` relative to `a`, touches it; infinite if it never does.
fn touch(a: &[Point; 4], b: &[Point; 4], velocity: Vector) -> f64 {
    let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
    for axis in [a, b].into_iter().flat_map(|ring| [0, 1].map(|k| (ring[k + 1] - ring[k]).normalize())) {
        let range = |ring: &[Point; 4]| {
            let along = ring.iter().map(|p| p.coords.dot(&axis));
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
        };
        let ((a0, a1), (b0, b1), speed) = (range(a), range(b), velocity.dot(&axis));
        if speed.abs() < STILL {
            if b0 > a1 || b1 < a0 {
                return f64::INFINITY;
            }
            continue;
        }
        let (first, last) = ((a1 - b0) / speed, (a0 - b1) / speed);
        enter = enter.max(first.min(last));
        leave = leave.min(first.max(last));
    }
    if enter <= leave { enter } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Pose;
    use crate::scenario::MovingObstacle;
    use crate::scenario::generate::SplitMix64;

    fn rectangle(x: f64, y: f64, heading: f64) -> [Point; 4] {
        let pose = Pose::new(x, y, heading);
        [(2.0, 1.0), (-2.0, 1.0), (-2.0, -1.0), (2.0, -1.0)].map(|(a, b)| pose.to_world(Point::new(a, b)))
    }

    #[test]
    fn rectangles_meet_when_their_nearest_sides_do() {
        let a = rectangle(0.0, 0.0, 0.0);
        let towards = Vector::new(-2.0, 0.0);
        // 6 m between the sides at 2 m/s.
        assert_eq!(touch(&a, &rectangle(10.0, 0.0, 0.0), towards), 3.0);
        assert_eq!(touch(&a, &rectangle(10.0, 1.9, 0.0), towards), 3.0);
        assert_eq!(touch(&a, &rectangle(10.0, 2.1, 0.0), towards), f64::INFINITY);
        assert_eq!(touch(&a, &rectangle(10.0, 0.0, 0.0), -towards), f64::INFINITY);
        assert_eq!(touch(&a, &rectangle(10.0, 0.0, 0.0), Vector::zeros()), f64::INFINITY);
        assert_eq!(touch(&a, &rectangle(1.0, 0.0, 0.3), towards), 0.0);
    }

    /// Stepping through time with another overlap test comes to the same moment.
    #[test]
    fn the_moment_is_that_of_a_slow_simulation() {
        let mut random = SplitMix64::new(7);
        let mut unit = || (random.next() >> 11) as f64 / (1_u64 << 53) as f64;
        let mut met = 0;
        for _ in 0..200 {
            let a = rectangle(0.0, 0.0, unit() * 6.3);
            let b = rectangle(unit() * 16.0 - 8.0, unit() * 16.0 - 8.0, unit() * 6.3);
            let velocity = Vector::new(unit() * 6.0 - 3.0, unit() * 6.0 - 3.0);
            let apart = |t: f64| crate::metrics::gap(&a, &b.map(|p| p + velocity * t));
            let first = (0..=4000).map(|k| f64::from(k) * 0.005).find(|&t| apart(t) <= 1e-9);
            let exact = touch(&a, &b, velocity);
            match first {
                Some(t) => {
                    met += 1;
                    assert!(exact <= t + 1e-6 && exact > t - 0.0051, "{exact} {t}");
                }
                // Grazes between two steps are no contact of the simulation.
                None => assert!(exact > 20.0 || apart(exact) < 1e-6, "{exact}"),
            }
        }
        assert!((50..150).contains(&met), "{met}");
    }

    #[test]
    fn a_reversing_car_nears_what_is_behind_it() {
        let vehicle = Vehicle::profile("sedan").unwrap();
        let wall = MovingObstacle {
            id: None,
            points: vec![[-20.0, 0.0], [-10.0, 0.0]],
            size: [2.0, 2.0],
            speed: 1.0,
            start: 0.0,
        };
        let mut rows = Rows {
            t: vec![0.0],
            station: vec![0.0],
            poses: vec![Pose::new(0.0, 0.0, 0.0)],
            speed: vec![-1.0],
            acceleration: vec![0.0],
            steering: vec![0.0],
        };
        let behind = vehicle.outline(rows.poses[0]).iter().fold(f64::INFINITY, |least, p| least.min(p.x));
        let movers = [Mover::new(&wall)];
        assert!(
            (times_to_collision(&vehicle, &movers, &rows)[0] - f64::midpoint(behind, 19.0)).abs() < 1e-12
        );
        rows.speed = vec![1.0];
        assert_eq!(times_to_collision(&vehicle, &movers, &rows), [f64::INFINITY]);
    }
}
