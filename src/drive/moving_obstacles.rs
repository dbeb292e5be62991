//! Boxes that follow lines.
//!
//! A box rests at its line's first point until `start`, drives along the line at constant speed and rests at its last
//! point for ever. It heads along the segment it is on and turns on the spot at corners. Since it moves straight
//! between corners, the area it sweeps during an interval is one rectangle per segment: the box, longer at the front by
//! the way driven. Intersecting those is exact in time and needs no sampling.

use crate::geometry::{Point, Pose, Vector, math};
use crate::scenario::MovingObstacle;

/// Overlaps shallower than this are contact, which is free, metres.
const CONTACT: f64 = 1e-6;

/// A moving obstacle in time.
///
/// Positions are those of the box's middle, world frame, metres.
#[derive(Debug, Clone)]
pub struct Mover {
    points: Vec<Point>,
    /// Distance to each point along the line.
    stations: Vec<f64>,
    half: Vector,
    speed: f64,
    start: f64,
}

impl Mover {
    /// Of a validated scene.
    pub fn new(moving: &MovingObstacle) -> Self {
        let points: Vec<Point> = moving.points.iter().map(|p| Point::new(p[0], p[1])).collect();
        let mut stations = vec![0.0];
        for pair in points.windows(2) {
            stations.push(stations[stations.len() - 1] + (pair[1] - pair[0]).norm());
        }
        let half = Vector::new(moving.size[0], moving.size[1]) / 2.0;
        Self { points, stations, half, speed: moving.speed, start: moving.start }
    }

    /// The middle of the box and where it heads at a time, seconds.
    pub fn pose(&self, t: f64) -> Pose {
        let station = self.station(t);
        let (segment, heading) = self.segment(station);
        let along = Vector::new(math::cos(heading), math::sin(heading)) * (station - self.stations[segment]);
        let at = self.points[segment] + along;
        Pose::new(at.x, at.y, heading)
    }

    /// When it has arrived, seconds.
    pub fn end(&self) -> f64 {
        self.start + self.stations[self.stations.len() - 1] / self.speed
    }

    /// True if it is under way at a time, seconds.
    pub(crate) fn moves(&self, t: f64) -> bool {
        (self.start..self.end()).contains(&t)
    }

    /// m/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Its velocity at a time, m/s.
    pub(crate) fn velocity(&self, t: f64) -> Vector {
        if self.moves(t) { self.pose(t).direction() * self.speed } else { Vector::zeros() }
    }

    /// At least so far is the box from a point, whichever way it heads, metres; negative within its half diagonal.
    pub(super) fn apart(&self, from: Point, t: f64) -> f64 {
        (self.pose(t).point() - from).norm() - self.half.norm()
    }

    /// The corners of the box at a time.
    pub fn outline(&self, t: f64) -> [Point; 4] {
        self.stretched(self.pose(t), 0.0, 0.0)
    }

    /// How far along the line the box is at a time, metres.
    fn station(&self, t: f64) -> f64 {
        ((t - self.start) * self.speed).clamp(0.0, self.stations[self.stations.len() - 1])
    }

    /// The segment on which a station lies, and its direction, radians.
    fn segment(&self, station: f64) -> (usize, f64) {
        let after = self.stations.partition_point(|s| *s <= station);
        let segment = after.clamp(1, self.points.len() - 1) - 1;
        let along = self.points[segment + 1] - self.points[segment];
        (segment, math::atan2(along.y, along.x))
    }

    /// The box grown by `margin` on all sides, and by `ahead` to the front.
    fn stretched(&self, pose: Pose, margin: f64, ahead: f64) -> [Point; 4] {
        let (front, side) = (self.half.x + margin, self.half.y + margin);
        [(front + ahead, side), (-front, side), (-front, -side), (front + ahead, -side)]
            .map(|(x, y)| pose.to_world(Point::new(x, y)))
    }

    /// True if the box, grown by `margin`, meets a rectangle at any time from `from` to `to`, corners of the line cut
    /// as the box cuts them: it turns on the spot. `to` may be infinite: then the answer holds for all later times.
    /// Linear in the segments passed.
    pub(crate) fn meets(&self, body: &[Point; 4], margin: f64, from: f64, to: f64) -> bool {
        let (mut station, end) = (self.station(from), self.station(to));
        loop {
            let (segment, heading) = self.segment(station);
            let until = self.stations[segment + 1].min(end);
            let at = self.points[segment]
                + Vector::new(math::cos(heading), math::sin(heading)) * (station - self.stations[segment]);
            let box_ = self.stretched(Pose::new(at.x, at.y, heading), margin, (until - station).max(0.0));
            if overlap(body, &box_) {
                return true;
            }
            if until >= end || segment + 2 >= self.points.len() {
                return false;
            }
            station = until;
        }
    }
}

/// True if two rectangles overlap, by their separating axes. Two convex outlines are apart exactly if their projections
/// on the normal of one of their edges are; a rectangle has two.
fn overlap(a: &[Point; 4], b: &[Point; 4]) -> bool {
    [a, b].into_iter().all(|ring| {
        (0..2).all(|k| {
            let axis = (ring[k + 1] - ring[k]).normalize();
            let range = |ring: &[Point; 4]| {
                let along = ring.iter().map(|p| p.coords.dot(&axis));
                along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
            };
            let ((a0, a1), (b0, b1)) = (range(a), range(b));
            a1.min(b1) - a0.max(b0) > CONTACT
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mover() -> Mover {
        Mover::new(&MovingObstacle {
            id: None,
            points: vec![[0.0, 0.0], [10.0, 0.0], [10.0, 5.0]],
            size: [4.0, 1.0],
            speed: 2.0,
            start: 1.0,
        })
    }

    fn square(x: f64, y: f64) -> [Point; 4] {
        [(0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5), (0.5, -0.5)].map(|(a, b)| Point::new(x + a, y + b))
    }

    #[test]
    fn it_stands_drives_turns_and_stands() {
        let mover = mover();
        assert_eq!(mover.pose(0.0), Pose::new(0.0, 0.0, 0.0));
        assert_eq!(mover.pose(3.0), Pose::new(4.0, 0.0, 0.0));
        let late = mover.pose(7.5);
        assert!((late.point() - Point::new(10.0, 3.0)).norm() < 1e-12 && late.heading == math::FRAC_PI_2);
        assert_eq!(mover.end(), 8.5);
        assert!((mover.pose(100.0).point() - Point::new(10.0, 5.0)).norm() < 1e-12);
    }

    #[test]
    fn its_sweep_is_met_between_two_moments() {
        let mover = mover();
        assert!(!mover.meets(&square(6.0, 0.0), 0.0, 0.0, 2.5));
        assert!(mover.meets(&square(6.0, 0.0), 0.0, 0.0, 3.0));
        assert!(mover.meets(&square(6.0, 0.0), 0.0, 0.0, 100.0), "passed between");
        assert!(!mover.meets(&square(6.0, 0.0), 0.0, 6.0, 100.0), "gone");
        assert!(
            mover.meets(&square(10.0, 7.4), 0.0, 0.0, 100.0)
                && !mover.meets(&square(10.0, 7.6), 0.0, 0.0, 9e9)
        );
        assert!(mover.meets(&square(10.0, 7.6), 0.2, 0.0, 100.0));
        assert!(
            mover.meets(&square(11.2, 2.0), 0.3, 7.0, 7.1) && !mover.meets(&square(11.2, 2.0), 0.1, 7.0, 7.1)
        );
    }
}
