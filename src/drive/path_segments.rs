//! A path as legs of constant curvature.
//!
//! Planners return poses or arcs; everything in `drive` asks by the distance driven, the *station*. A [`Route`]
//! stores the legs in order, each with its station, and groups them into runs without a gear change. At the end of
//! a run the car stands still.

use crate::error::{Error, ErrorCode, Message};
use crate::geometry::arcs::{self, Arc};
use crate::geometry::{Pose, math};
use crate::scenario::SpeedLimit;
use crate::vehicle::Vehicle;

/// Curvatures closer than this are one curvature, 1/m.
const SAME_CURVATURE: f64 = 1e-6;
/// Curvature above the car's limit by this factor is still the limit.
const CURVATURE_SLACK: f64 = 1.001;
/// Speed limits are looked up this often, metres.
const SCAN: f64 = 0.25;
/// Poses closer than this are one place, metres.
const SAME_PLACE: f64 = 1e-9;

/// A stretch of constant curvature in one gear.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    pub(super) from: Pose,
    /// Positive to the left of the car in either gear, 1/m.
    pub(super) curvature: f64,
    /// Driven, metres.
    pub(super) length: f64,
    /// ±1.
    pub(super) gear: f64,
    /// Distance driven before it, metres.
    pub(super) station: f64,
}

/// Legs without a gear change between them.
///
/// `from` and `to` are stations, metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    pub(super) first: usize,
    /// One past the last.
    pub(super) end: usize,
    pub(super) gear: f64,
    pub(super) from: f64,
    pub(super) to: f64,
}

/// A path that a car can drive, by the distance driven.
///
/// The legs join in position and heading. Memory and construction are linear in the legs, queries by station
/// logarithmic. Neighbouring steps of the same arc become one leg, so a path of straight lines and arcs has as many
/// legs as those, however finely it was sampled.
#[derive(Debug, Clone)]
pub struct Route {
    pub(super) legs: Vec<Leg>,
    pub(super) runs: Vec<Run>,
    /// Stretches with a speed limit: from, to, m/s.
    pub(super) slow: Vec<(f64, f64, f64)>,
    start: Pose,
    goal: Pose,
    length: f64,
}

fn refused<T>(path: String, message: Message) -> Result<T, Error> {
    Err(Error::new(ErrorCode::Input, path, message))
}

impl Route {
    /// The route of a path: `directions[i]` (±1) and, where known, `curvatures[i]` (1/m) of the way from pose i to
    /// pose i + 1.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] for a path without poses, with corners, or with turns tighter than the car's.
    ///
    /// # Examples
    /// ```
    /// use parkade::drive::Route;
    /// use parkade::geometry::Pose;
    /// use parkade::vehicle::Vehicle;
    ///
    /// let path = [Pose::new(0.0, 0.0, 0.0), Pose::new(4.0, 0.0, 0.0), Pose::new(1.0, 0.0, 0.0)];
    /// let route = Route::new(&Vehicle::SEDAN, &path, &[1, -1], None).unwrap();
    /// assert_eq!((route.length(), route.pose(5.0).x), (7.0, 3.0));
    /// let corner = [path[0], Pose::new(0.0, 0.0, 1.0)];
    /// assert!(Route::new(&Vehicle::SEDAN, &corner, &[1], None).unwrap_err().to_string().contains("corners"));
    /// ```
    pub fn new(
        vehicle: &Vehicle,
        path: &[Pose],
        directions: &[i8],
        curvatures: Option<&[f64]>,
    ) -> Result<Self, Error> {
        let (Some(&start), Some(&goal)) = (path.first(), path.last()) else {
            return refused(
                "path".to_owned(),
                "must have poses; a plan without a path cannot be driven".into(),
            );
        };
        let limit = vehicle.max_curvature() * CURVATURE_SLACK;
        let mut route =
            Self { legs: Vec::new(), runs: Vec::new(), slow: Vec::new(), start, goal, length: 0.0 };
        for (i, pair) in path.windows(2).enumerate() {
            let gear = if directions.get(i).is_some_and(|&d| d < 0) { -1.0 } else { 1.0 };
            let chord = (pair[1].point() - pair[0].point()).norm();
            let turn = math::turn(pair[0].heading, pair[1].heading);
            if chord < SAME_PLACE {
                if turn.abs() > 1e-6 {
                    let at = format!("({:.2}, {:.2})", pair[0].x, pair[0].y);
                    return refused(
                        format!("path[{}]", 3 * i),
                        message!("must have no corners, turns on the spot at {}", at),
                    );
                }
                continue;
            }
            let length = arcs::length_over(chord, turn);
            let curvature = match curvatures.and_then(|k| k.get(i)) {
                Some(k) if k.is_finite() => *k,
                _ => turn / length * gear,
            };
            if curvature.abs() > limit {
                let message = message!(
                    "must turn no tighter than {} 1/m, turns {}",
                    format_args!("{:.4}", vehicle.max_curvature()),
                    format_args!("{:.4}", curvature)
                );
                return refused(format!("path[{}]", 3 * i), message);
            }
            route.extend(pair[0], curvature, length, gear);
        }
        route.part();
        Ok(route)
    }

    /// The same route where areas limit the speed; the rear axle's middle counts, every quarter of a metre.
    #[must_use]
    pub fn with_speed_limits(mut self, areas: &[SpeedLimit]) -> Self {
        let steps = if areas.is_empty() { 0 } else { (self.length / SCAN).ceil() as u32 };
        for k in 0..steps {
            let (from, to) = (SCAN * f64::from(k), (SCAN * f64::from(k + 1)).min(self.length));
            let ends = [from, to].map(|station| SpeedLimit::lowest_at(areas, self.pose(station).point()));
            let speed = ends[0].min(ends[1]);
            match self.slow.last_mut() {
                Some(last) if last.1 == from && last.2 == speed => last.1 = to,
                _ if speed < f64::INFINITY => self.slow.push((from, to, speed)),
                _ => {}
            }
        }
        self
    }

    /// Appends a step, to the last leg where gear and curvature are the same.
    fn extend(&mut self, from: Pose, curvature: f64, length: f64, gear: f64) {
        match self.legs.last_mut() {
            Some(last) if last.gear == gear && (last.curvature - curvature).abs() < SAME_CURVATURE => {
                last.length += length;
            }
            _ => self.legs.push(Leg { from, curvature, length, gear, station: self.length }),
        }
        self.length += length;
    }

    /// Groups the legs into runs. The last run ends at the route's length, without rounding.
    fn part(&mut self) {
        for (i, leg) in self.legs.iter().enumerate() {
            let to = leg.station + leg.length;
            match self.runs.last_mut() {
                Some(run) if run.gear == leg.gear => (run.end, run.to) = (i + 1, to),
                _ => self.runs.push(Run { first: i, end: i + 1, gear: leg.gear, from: leg.station, to }),
            }
        }
        if let Some(last) = self.runs.last_mut() {
            last.to = self.length;
        }
    }

    /// The lowest of the speed limits that hold on it, m/s; infinite where there is none.
    pub(crate) fn lowest_limit(&self) -> f64 {
        self.slow.iter().fold(f64::INFINITY, |least, slow| least.min(slow.2))
    }

    /// The route's arcs.
    pub(crate) fn arcs(&self) -> Vec<Arc> {
        let arc = |leg: &Leg| Arc { curvature: leg.curvature, length: leg.gear * leg.length };
        self.legs.iter().map(arc).collect()
    }

    /// Distance driven, metres.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The pose after `station` metres.
    pub fn pose(&self, station: f64) -> Pose {
        if station >= self.length {
            return self.goal;
        }
        match self.leg(station) {
            Some(leg) => {
                leg.from.advance(leg.curvature, leg.gear * (station - leg.station).clamp(0.0, leg.length))
            }
            None => self.start,
        }
    }

    /// The leg that is driven from `station` on.
    pub(super) fn leg(&self, station: f64) -> Option<&Leg> {
        let after = self.legs.partition_point(|leg| leg.station <= station);
        self.legs.get(after.max(1) - 1)
    }

    /// The pose `station` metres along the whole route if it were no longer than `run`: within it, and straight on
    /// beyond its end.
    pub(super) fn pose_in(&self, run: &Run, station: f64) -> Pose {
        let leg = self.leg_in(run, station);
        let (beyond, within) = ((station - run.to).max(0.0), station.min(run.to) - leg.station);
        leg.from.advance(leg.curvature, leg.gear * within).advance(0.0, leg.gear * beyond)
    }

    /// The curvature at a station, the run's own at its end.
    pub(super) fn curvature_in(&self, run: &Run, station: f64) -> f64 {
        self.leg_in(run, station).curvature
    }

    /// The leg of a run that is driven from a station on; its first before it, its last beyond it.
    fn leg_in(&self, run: &Run, station: f64) -> &Leg {
        let legs = &self.legs[run.first..run.end];
        let after = legs.partition_point(|leg| leg.station <= station);
        &legs[after.max(1) - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::arcs;

    const CAR: Vehicle = Vehicle::PAPER;

    #[test]
    fn arcs_come_back_from_their_poses() {
        let path = [
            Arc { curvature: 0.18, length: 3.03 },
            Arc { curvature: 0.0, length: 2.0 },
            Arc { curvature: -0.1, length: -4.0 },
        ];
        let start = Pose::new(3.0, -1.0, 3.0);
        let goal = arcs::end(start, &path);
        let points = arcs::sample(start, &path, goal, 0.1);
        let poses: Vec<Pose> = points.iter().map(|p| p.pose).collect();
        let gears: Vec<i8> = points.iter().map(|p| p.gear).collect();
        let curvatures: Vec<f64> = points.iter().map(|p| p.curvature).collect();
        for known in [None, Some(&curvatures[..])] {
            let route = Route::new(&CAR, &poses, &gears, known).unwrap();
            assert_eq!((route.legs.len(), route.runs.len()), (3, 2));
            assert!((route.length() - 9.03).abs() < 1e-9);
            assert!((route.runs[1].from - 5.03).abs() < 1e-9);
            for point in &points {
                assert!((route.pose(point.station).point() - point.pose.point()).norm() < 1e-9);
            }
        }
    }

    #[test]
    fn what_no_car_drives_is_refused() {
        let corner = [Pose::default(), Pose::new(3.0, 0.0, 0.0), Pose::new(3.0, 0.0, 1.0)];
        let error = Route::new(&CAR, &corner, &[1; 3], None).unwrap_err();
        assert_eq!(error.to_string(), "path[3]: must have no corners, turns on the spot at (3.00, 0.00)");
        let tight = [Pose::default(), Pose::default().advance(0.3, 0.1)];
        assert!(
            Route::new(&CAR, &tight, &[1; 2], None)
                .unwrap_err()
                .message()
                .starts_with("must turn no tighter")
        );
        assert!(Route::new(&CAR, &[], &[], None).is_err());
        let still = Route::new(&CAR, &[Pose::default(); 1], &[1], None).unwrap();
        assert_eq!((still.length(), still.pose(0.0)), (0.0, Pose::default()));
    }
}
