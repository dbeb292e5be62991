//! Figures of a path on a road: clearance beside the body, bends, lane keeping.
//!
//! All is measured along the line of the body's middle, resampled every metre, the car pointing along it; a path's own
//! headings play no part, so paths with corners are measured like curves.

use serde::Serialize;

use super::Body;
use crate::geometry::{Point, Pose, math};
use crate::scenario::resolve::Geometry;
use crate::scenario::{Lane, LaneLeg};

/// Stations are about this far apart, metres.
const STEP: f64 = 1.0;
/// Nearer to the ends the body is not measured, since the road ends there, metres.
pub(super) const ENDS: f64 = 5.0;
/// The manuscript claims distances of 0.8 to this, metres: a capped mean counts no more.
const MOST: f64 = 1.2;

/// Metrics of a road planner's path.
#[derive(Debug, Clone, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct RoadMetrics {
    /// Cost of the cells under the planner's settings.
    pub cost: f64,
    /// Turning points of the cells, ends included.
    pub turns_raw: u32,
    /// Turning points of the chords, ends included.
    pub turns_pruned: u32,
    /// How far the start was moved to have room, metres.
    pub start_moved: f64,
    /// How far the goal was moved to have room, metres.
    pub goal_moved: f64,
    /// Room that was asked for around the car, metres; 0 for plain A* and the manuscript's curves.
    pub margin: f64,
    /// Clearance that the path keeps, without 5 m at each end, metres. It is less than `margin` if no path that keeps
    /// the whole margin was found.
    pub margin_kept: f64,
    /// True if it is proven that no path on the map keeps the whole margin; false where that is not known or not the
    /// case.
    pub margin_excluded: bool,
    /// Bytes of the arrays that planning holds.
    pub bytes: u64,
    /// Of the path.
    #[serde(flatten)]
    pub figures: Figures,
}

/// Figures of any path on a road.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Figures {
    /// Length of the middle's line, metres.
    pub middle_length: f64,
    /// Least distance of the body to anything, 5 m at the ends left out, metres; below zero where it overlaps.
    pub body_clearance_min: f64,
    /// The mean.
    pub body_clearance_mean: f64,
    /// The mean, each place counted as 1.2 m at most, so that wide places do not make up for narrow ones.
    pub body_clearance_mean_capped: f64,
    /// Least distance of the middle to anything, half the width taken off, metres.
    pub side_clearance_min: f64,
    /// The mean.
    pub side_clearance_mean: f64,
    /// Sum of the curvature's changes from metre to metre, 1/m.
    pub curvature_variation: f64,
    /// Largest curvature over a metre, 1/m.
    pub middle_curvature: f64,
    /// Largest distance from the nearest lane's middle, metres; `None` without lanes.
    pub lane_deviation_max: Option<f64>,
    /// The mean.
    pub lane_deviation_mean: Option<f64>,
    /// Share of the way on which the middle is to the left of all lanes, 0 to 1: where there is a lane against, in
    /// that.
    pub lane_left_share: Option<f64>,
}

/// Measures a path of rear-axle poses.
pub fn figures(geometry: &Geometry, body: &Body, lanes: &[Lane], path: &[Pose]) -> Figures {
    let line = Line::new(geometry, path);
    let mut figures = Figures { middle_length: line.length, ..Figures::default() };
    (figures.curvature_variation, figures.middle_curvature) = line.bends();
    let side = geometry.vehicle.width / 2.0;
    let far = f64::INFINITY;
    let sides = line.points.iter().map(|&p| body.point_clearance(p, far) - side);
    (figures.side_clearance_min, figures.side_clearance_mean) = least_and_mean(sides);
    let rooms: Vec<f64> = line.inner().map(|i| body.signed_clearance(line.pose(i, 0.0), far)).collect();
    (figures.body_clearance_min, figures.body_clearance_mean) = least_and_mean(rooms.iter().copied());
    figures.body_clearance_mean_capped = least_and_mean(rooms.iter().map(|r| r.min(MOST))).1;
    let legs = LaneLeg::all(lanes);
    if !legs.is_empty() {
        let nearest = || line.points.iter().filter_map(|&p| Some((p, LaneLeg::nearest(&legs, p)?)));
        let away: Vec<f64> = nearest().map(|(_, (_, away))| away).collect();
        figures.lane_deviation_max = Some(away.iter().fold(0.0, |most: f64, d| most.max(*d)));
        figures.lane_deviation_mean = Some(least_and_mean(away.into_iter()).1);
        let left = nearest().map(|(p, (leg, _))| f64::from(u8::from(leg.left(p) > leg.half_width)));
        figures.lane_left_share = Some(least_and_mean(left).1);
    }
    figures
}

/// Of nothing: zero, so that there is always a number. The pair of the least and the mean value.
fn least_and_mean(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (least, sum, count) =
        values.fold((f64::INFINITY, 0.0, 0_u32), |(least, sum, n), v| (v.min(least), sum + v, n + 1));
    if count == 0 { (0.0, 0.0) } else { (least, sum / f64::from(count)) }
}

/// The middle's line, resampled.
pub(super) struct Line {
    pub(super) points: Vec<Point>,
    /// Between two points, metres.
    pub(super) step: f64,
    lever: f64,
    length: f64,
}

impl Line {
    /// The line of the car's middle along a path of the rear axle, sampled at equal steps of about [`STEP`] metres.
    pub(super) fn new(geometry: &Geometry, path: &[Pose]) -> Self {
        let lever = geometry.vehicle.middle();
        let middles: Vec<Point> = path.iter().map(|pose| pose.advance(0.0, lever).point()).collect();
        let mut stations = vec![0.0];
        for pair in middles.windows(2) {
            stations.push(stations[stations.len() - 1] + (pair[1] - pair[0]).norm());
        }
        let length = stations[stations.len() - 1];
        let count = (length / STEP).round().max(1.0) as usize;
        let step = length / count as f64;
        let mut points = Vec::with_capacity(count + 1);
        let mut at = 0;
        if length > 0.0 {
            for k in 0..count {
                let station = step * k as f64;
                while at + 2 < stations.len() && stations[at + 1] < station {
                    at += 1;
                }
                let span = stations[at + 1] - stations[at];
                let share = if span > 0.0 { (station - stations[at]) / span } else { 0.0 };
                points.push(middles[at] + (middles[at + 1] - middles[at]) * share);
            }
        }
        points.extend(middles.last());
        Self { points, step, lever, length }
    }

    /// The points of which the body is measured.
    pub(super) fn inner(&self) -> impl Iterator<Item = usize> + use<> {
        let (step, length) = (self.step, self.length);
        (0..self.points.len()).filter(move |&i| (ENDS..=length - ENDS).contains(&(step * i as f64)))
    }

    /// The car's rear axle with its middle `left` metres to the left of a point.
    pub(super) fn pose(&self, i: usize, left: f64) -> Pose {
        self.beside(i, -self.lever, left)
    }

    /// The place `left` metres to the left of a point.
    pub(super) fn middle(&self, i: usize, left: f64) -> Point {
        self.beside(i, 0.0, left).point()
    }

    fn beside(&self, i: usize, ahead: f64, left: f64) -> Pose {
        let last = self.points.len() - 1;
        let (before, after) = (self.points[i.saturating_sub(1)], self.points[(i + 1).min(last)]);
        let heading = math::atan2(after.y - before.y, after.x - before.x);
        let at = self.points[i];
        let place = Pose::new(at.x, at.y, heading).to_world(Point::new(ahead, left));
        Pose::new(place.x, place.y, heading)
    }

    /// Sum of the curvature's changes, and its largest.
    fn bends(&self) -> (f64, f64) {
        let headings: Vec<f64> =
            self.points.windows(2).map(|w| math::atan2(w[1].y - w[0].y, w[1].x - w[0].x)).collect();
        let curvatures: Vec<f64> = headings.windows(2).map(|w| math::turn(w[0], w[1]) / self.step).collect();
        let changes = curvatures.windows(2).fold(0.0, |sum, w| sum + (w[1] - w[0]).abs());
        (changes, curvatures.iter().fold(0.0, |most: f64, k| most.max(k.abs())))
    }
}
