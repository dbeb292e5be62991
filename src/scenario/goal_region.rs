//! A goal's region: the car arrives when its whole body is inside.
//!
//! The set of poses inside a region has three dimensions; planners want a list. For a heading, the positions that
//! keep the body between the region's outermost corners are a rectangle along that heading (`Span`). It is sampled at
//! equal distances, and the polygon itself decides about each sample. Headings are those asked for, or the directions
//! of the longest edges and sixteen around the circle.
//!
//! The distance of the samples follows from the area of all spans, so that a region of any size gives some 2000 poses
//! at most, never closer than 0.25 m. A path that ends anywhere inside has arrived: the region decides, not the
//! sample.

use serde::Serialize;
use serde_json::Value;

use super::checks::{bad, outline, touch};
use super::places;
use crate::error::Error;
use crate::geometry::math::{self, PI};
use crate::geometry::polygon::contains;
use crate::geometry::{Point, Pose, Vector};
use crate::json::{Fields, list, number};
use crate::vehicle::Vehicle;

/// A region's heading is met up to this much to either side, radians.
pub const HEADING_TOLERANCE: f64 = PI / 12.0;
/// Where the region asks for no heading, these are tried: multiples of a turn's part, …
const HEADINGS: u32 = 16;
/// … and those along the longest edges.
const EDGES: usize = 4;
/// Poses of a sample: more come nearer to the cheapest arrival, and each costs a test for contact. Half as far apart,
/// in a lot's aisle, shortens ways by decimetres.
const POSES: f64 = 2000.0;
/// Poses of a sample are not nearer to each other than this, metres.
const SPACING: f64 = 0.25;
/// A body that sticks out of the region by less is inside, metres and radians.
const ROUNDING: f64 = 1e-6;

/// A simple polygon, and how the car shall point in it.
/// Coordinates are the world's, and the outline may run in either direction.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GoalRegion {
    /// Corners, metres.
    pub region: Vec<[f64; 2]>,
    /// Heading to within [`HEADING_TOLERANCE`], radians; any heading if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heading: Option<f64>,
}

impl GoalRegion {
    /// Reads `region` and `heading`; ranges are checked by [`GoalRegion::validate`].
    pub(super) fn read(value: &Value) -> Result<Self, Error> {
        let f = Fields::of(value, &["region", "heading"])?;
        Ok(Self { region: f.need("region", list(places::point))?, heading: f.maybe("heading", number)? })
    }

    /// A simple outline with some area, and a finite heading.
    pub(super) fn validate(&self) -> Result<(), Error> {
        outline("region", &self.region)?;
        match self.heading {
            Some(heading) if !heading.is_finite() => {
                bad("heading", message!("must be a finite number, got {}", heading))
            }
            _ => Ok(()),
        }
    }

    /// True if the car stands inside, and points where it shall.
    pub(super) fn holds(&self, vehicle: &Vehicle, pose: Pose) -> bool {
        let points = |heading| math::turn(heading, pose.heading).abs() <= HEADING_TOLERANCE + ROUNDING;
        self.heading.is_none_or(points) && encloses(&self.local(), vehicle, self.to_local(pose))
    }

    /// Emits poses in which the car stands inside, evenly spread.
    pub(super) fn sample(&self, vehicle: &Vehicle, mut emit: impl FnMut(Pose)) {
        let corners = self.local();
        let mut spans = Vec::new();
        for heading in self.headings(&corners) {
            spans.extend(Span::new(&corners, vehicle, heading));
        }
        // Lines and points have places, too.
        let area: f64 = spans.iter().map(|span| (span.length + SPACING) * (span.width + SPACING)).sum();
        let spacing = SPACING.max((area / POSES).sqrt());
        let [x, y] = self.region[0];
        for span in &spans {
            span.poses(spacing, |pose| {
                if encloses(&corners, vehicle, pose) {
                    emit(Pose::new(pose.x + x, pose.y + y, pose.heading));
                }
            });
        }
    }

    /// The corners from the first one, so that digits are kept far from the origin.
    fn local(&self) -> Vec<Point> {
        let [x, y] = self.region[0];
        self.region.iter().map(|corner| Point::new(corner[0] - x, corner[1] - y)).collect()
    }

    /// A pose as seen from the first corner.
    fn to_local(&self, pose: Pose) -> Pose {
        let [x, y] = self.region[0];
        Pose::new(pose.x - x, pose.y - y, pose.heading)
    }

    /// The headings to sample: five within the tolerance of the one asked for, else those of long edges and all
    /// around.
    fn headings(&self, corners: &[Point]) -> Vec<f64> {
        if let Some(heading) = self.heading {
            return [0.0, -1.0, 1.0, -0.5, 0.5].map(|part| heading + part * HEADING_TOLERANCE).to_vec();
        }
        let mut headings: Vec<f64> = Vec::new();
        let mut add = |heading: f64| {
            if headings.iter().all(|&known| math::turn(known, heading).abs() > 1e-3) {
                headings.push(math::wrap(heading));
            }
        };
        let edge = |i: usize| corners[(i + 1) % corners.len()] - corners[i];
        let mut shortness: Vec<f64> = (0..corners.len()).map(|i| -edge(i).norm()).collect();
        for _ in 0..EDGES.min(corners.len()) {
            let longest = math::argmin(&shortness);
            shortness[longest] = 0.0;
            let heading = math::atan2(edge(longest).y, edge(longest).x);
            add(heading);
            add(heading + PI);
        }
        (0..HEADINGS).for_each(|k| add(math::TAU * f64::from(k) / f64::from(HEADINGS)));
        headings
    }
}

/// Positions of the rear axle that keep the body between the region's outermost corners, along the car's heading.
struct Span {
    heading: f64,
    /// The car's direction.
    ahead: Vector,
    /// The place farthest back and to the right: ahead, and to the left.
    low: [f64; 2],
    length: f64,
    width: f64,
}

impl Span {
    /// The rectangle for one heading; `None` where the body is longer or wider than the region.
    fn new(corners: &[Point], vehicle: &Vehicle, heading: f64) -> Option<Self> {
        let ahead = Pose::new(0.0, 0.0, heading).direction();
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for at in corners.iter().map(|corner| corner.coords) {
            for (k, along) in [at.dot(&ahead), ahead.perp(&at)].into_iter().enumerate() {
                (low[k], high[k]) = (low[k].min(along), high[k].max(along));
            }
        }
        let (length, width) = (high[0] - low[0] - vehicle.length(), high[1] - low[1] - vehicle.width);
        let low = [low[0] + vehicle.rear_to_back, low[1] + vehicle.width / 2.0];
        let fits = length >= -ROUNDING && width >= -ROUNDING;
        fits.then(|| Self { heading, ahead, low, length: length.max(0.0), width: width.max(0.0) })
    }

    /// Emits the poses of a grid over the rectangle, its edges included; one line or one place where it is that thin.
    fn poses(&self, spacing: f64, mut emit: impl FnMut(Pose)) {
        let [along, across] = [self.length, self.width].map(|span| (span / spacing).ceil());
        let part = |span: f64, k: f64, count: f64| if count == 0.0 { span / 2.0 } else { span * k / count };
        let (x, y, mut i) = (self.ahead.x, self.ahead.y, 0.0);
        while i <= along {
            let mut k = 0.0;
            while k <= across {
                let ahead = self.low[0] + part(self.length, i, along);
                let left = self.low[1] + part(self.width, k, across);
                emit(Pose::new(x * ahead - y * left, y * ahead + x * left, self.heading));
                k += 1.0;
            }
            i += 1.0;
        }
    }
}

/// True if the polygon holds the whole body, up to rounding.
fn encloses(corners: &[Point], vehicle: &Vehicle, pose: Pose) -> bool {
    let body = Vehicle {
        width: vehicle.width - 2.0 * ROUNDING,
        rear_to_front: vehicle.rear_to_front - ROUNDING,
        rear_to_back: vehicle.rear_to_back - ROUNDING,
        ..*vehicle
    };
    let body = body.outline(pose);
    let edge = |points: &[Point], i: usize| (points[i], points[(i + 1) % points.len()]);
    let crossed = |(a, b)| (0..4).map(|k| edge(&body, k)).any(|(c, d)| touch(a, b, c, d));
    contains(corners, body[0]) && !(0..corners.len()).any(|i| crossed(edge(corners, i)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAR: Vehicle = Vehicle::SEDAN;

    fn region(corners: &[[f64; 2]], heading: Option<f64>) -> GoalRegion {
        GoalRegion { region: corners.to_vec(), heading }
    }

    fn sample(region: &GoalRegion) -> Vec<Pose> {
        let mut poses = Vec::new();
        region.sample(&CAR, |pose| poses.push(pose));
        poses
    }

    /// A rectangle as long and as wide as the car and a little more, turned, far away.
    fn box_around(more: f64, angle: f64) -> GoalRegion {
        let frame = Pose::new(5e5, -3e5, angle);
        let (a, b) = (f64::midpoint(CAR.length(), more), f64::midpoint(CAR.width, more));
        let corner = |(x, y)| frame.to_world(Point::new(x, y));
        region(&[(a, b), (-a, b), (-a, -b), (a, -b)].map(corner).map(|p| [p.x, p.y]), None)
    }

    #[test]
    fn a_box_that_just_holds_the_car_is_sampled_and_a_smaller_one_is_not() {
        for angle in [0.0, 0.3, 1.234, -2.0] {
            let tight = box_around(1e-4, angle);
            let poses = sample(&tight);
            assert!(poses.len() >= 2, "the nose may point both ways");
            assert!(poses.iter().all(|&pose| tight.holds(&CAR, pose)));
            assert!(sample(&box_around(-1e-4, angle)).is_empty());
        }
    }

    #[test]
    fn a_body_that_reaches_over_a_dent_is_outside() {
        let dented = region(
            &[[0.0, 0.0], [20.0, 0.0], [20.0, 6.0], [11.0, 6.0], [10.0, 1.0], [9.0, 6.0], [0.0, 6.0]],
            None,
        );
        assert!(dented.holds(&CAR, Pose::new(2.0, 3.0, 0.0)));
        // Its four corners are inside.
        assert!(!dented.holds(&CAR, Pose::new(9.0, 3.0, 0.0)));
        assert!(!dented.holds(&CAR, Pose::new(30.0, 3.0, 0.0)));
        let poses = sample(&dented);
        assert!(poses.len() > 100 && poses.iter().all(|&pose| dented.holds(&CAR, pose)));
    }

    #[test]
    fn a_heading_is_met_within_its_tolerance() {
        let hall = region(&[[0.0, 0.0], [30.0, 0.0], [30.0, 30.0], [0.0, 30.0]], Some(3.0));
        let at = |heading| hall.holds(&CAR, Pose::new(15.0, 15.0, heading));
        assert!(at(3.0) && at(3.0 + HEADING_TOLERANCE) && at(3.0 - HEADING_TOLERANCE - math::TAU));
        assert!(!at(3.0 + HEADING_TOLERANCE + 1e-3) && !at(0.0));
        assert!(sample(&hall).iter().all(|pose| at(pose.heading)));
    }

    #[test]
    fn a_sample_is_bounded_and_reaches_the_borders() {
        let lot = region(&[[0.0, 0.0], [400.0, 0.0], [400.0, 300.0], [0.0, 300.0]], None);
        let poses = sample(&lot);
        assert!((1000..6000).contains(&poses.len()), "{}", poses.len());
        let least = poses.iter().map(|pose| pose.x).fold(f64::INFINITY, f64::min);
        assert!((least - CAR.rear_to_back.min(CAR.width / 2.0)).abs() < 1e-6);
    }
}
