//! The independent validator: exact footprint against exact obstacles, motion against the car's limits.
//!
//! Four questions, the worst answer first ([`Verdict`]):
//!
//! 1. Does the body overlap an obstacle at a pose or between two? Between two poses the car is assumed to follow
//!    the arc through both. It is tested each 2 cm of way and each 0.02 rad of turn; where the room around the body
//!    is larger than what it moves, that certifies the motion without a test.
//! 2. Is a stretch tighter than the turning radius, or does the body slide: does it move in another direction than
//!    its heading by more than 0.02 rad?
//! 3. Does the path begin at the start, within 5° of its heading?
//! 4. Does it end at the goal, within 5° of its heading?
//!
//! Motion is summed over short steps until it exceeds rounding, so the verdict does not depend on how finely a path
//! is sampled.

use super::Narrowest;
use super::{Body, FAR};
use crate::IS_COMPLETE;
use crate::geometry::{Pose, math};
use crate::scenario::resolve::{Geometry, Owner};

/// Between two poses the body is tested at least this often, metres. A corner of an obstacle can be overlooked only
/// where it enters the body by less than about half of this.
const STEP: f64 = 0.02;
/// Curvature above the limit by this factor is still the limit.
const CURVATURE_SLACK: f64 = 1.001;
/// A motion is judged once it is longer than this, metres, or turns by more, radians, …
const LEAST_MOTION: f64 = 1e-6;
/// … and by this part of the distance from the world's origin more: poses are rounded there, and a shorter motion would
/// seem to turn tighter by more than the slack.
const LEAST_MOTION_AWAY: f64 = 4.0 * f64::EPSILON / (CURVATURE_SLACK - 1.0);
/// Largest heading error that counts as arriving as asked, or starting along the heading, radians (5°).
pub(crate) const HEADING_TOLERANCE: f64 = 0.0873;
/// A step whose direction differs from the heading by more than this slides, radians.
const SLIP_TOLERANCE: f64 = 0.02;

/// The answer in one word, the worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// There is no path.
    None,
    /// The body overlaps something.
    Collides,
    /// It turns tighter than the car can, slides, or starts in another direction than the car points.
    TooTight,
    /// It can be driven but ends in another pose than asked.
    ArrivesTurned,
    /// It can be driven and arrives as asked.
    Ok,
}

impl Verdict {
    /// The word of the JS API.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Collides => "collides",
            Self::TooTight => "too-tight",
            Self::ArrivesTurned => "arrives-turned",
            Self::Ok => "ok",
        }
    }
}

/// The validator's verdict and figures.
#[derive(Debug, Clone)]
pub struct Check {
    /// In one word.
    pub verdict: Verdict,
    /// Indices of poses at which, or on the way to which, the body overlaps something.
    pub hit_poses: Vec<u32>,
    /// The first obstacle that the body overlaps, and the pose there.
    pub first_hit: Option<(Owner, Pose)>,
    /// Corners and stretches that turn tighter than the car can, a wrong heading at the start included.
    pub tight_turns: u32,
    /// Steps in which the body moves sideways; a path that begins elsewhere than at the start counts as one.
    pub slips: u32,
    /// Tightest radius, metres; 0 at a corner, infinite on a straight path.
    pub tightest_radius: f64,
    /// Radians between the car's heading and the path's first heading.
    pub start_heading_error: f64,
    /// Radians between the path's last heading and the goal's.
    pub goal_heading_error: f64,
    /// Metres between the last pose and the goal.
    pub goal_distance: f64,
    /// Smallest distance from the body to an obstacle, metres.
    pub min_clearance: f64,
    /// Mean of the poses' clearances, metres.
    pub mean_clearance: f64,
    /// Per pose: distance from the body to the nearest obstacle, metres.
    pub clearances: Vec<f64>,
    /// The pose with the least clearance; `None` if the body overlaps an obstacle.
    pub narrowest: Option<Narrowest>,
}

impl Check {
    /// True if this car can drive the path.
    pub fn drivable(&self) -> bool {
        matches!(self.verdict, Verdict::Ok | Verdict::ArrivesTurned)
    }
}

/// Checks `path` against the scene. `directions[i]` is the gear (±1) from pose i to pose i + 1; `near` is how far from
/// the start a path may begin and from the goal it may end, metres.
///
/// The goal is the nearest of the scene's goals to the last pose, so a set of goals is checked like a single one. An
/// empty path gives [`Verdict::None`]. `geometry` and `body` must be of the same scene.
///
/// # Examples
/// ```
/// use parkade::geometry::Pose;
/// use parkade::metrics::{Body, Verdict, check};
///
/// let geometry = parkade::scenario::catalog::scenario("perpendicular").unwrap().geometry().unwrap();
/// let (body, start) = (Body::new(&geometry), geometry.start);
/// let turned = Pose { heading: start.heading + 0.1, ..start };
/// let found = check(&geometry, &body, &[start, turned], &[1, 1], 0.001);
/// assert_eq!((found.verdict, found.tightest_radius), (Verdict::TooTight, 0.0));
/// ```
pub fn check(geometry: &Geometry, body: &Body, path: &[Pose], directions: &[i8], near: f64) -> Check {
    let mut check = empty();
    let (Some(first), Some(last)) = (path.first(), path.last()) else { return check };
    check.start_heading_error = math::turn(geometry.start.heading, first.heading).abs();
    let goal = geometry.goal_for(*last);
    check.goal_heading_error = goal.map_or(0.0, |goal| math::turn(goal.heading, last.heading).abs());
    check.goal_distance = goal.map_or(f64::INFINITY, |goal| (last.point() - goal.point()).norm());
    check.tight_turns = u32::from(check.start_heading_error > HEADING_TOLERANCE);
    check.slips = u32::from((first.point() - geometry.start.point()).norm() > near);
    check_motion(&mut check, path, directions, geometry.vehicle.min_turning_radius());
    check_body(&mut check, body, path, directions);
    let arrives = check.goal_heading_error <= HEADING_TOLERANCE && check.goal_distance <= near;
    check.verdict = match () {
        () if !check.hit_poses.is_empty() => Verdict::Collides,
        () if check.tight_turns > 0 || check.slips > 0 => Verdict::TooTight,
        () if !arrives => Verdict::ArrivesTurned,
        () => Verdict::Ok,
    };
    check
}

/// The verdict on no path: nothing hit and nothing driven.
fn empty() -> Check {
    Check {
        verdict: Verdict::None,
        hit_poses: Vec::new(),
        first_hit: None,
        tight_turns: 0,
        slips: 0,
        tightest_radius: f64::INFINITY,
        start_heading_error: 0.0,
        goal_heading_error: 0.0,
        goal_distance: 0.0,
        min_clearance: 0.0,
        mean_clearance: 0.0,
        clearances: Vec::new(),
        narrowest: None,
    }
}

/// The circular arc from one pose to the next: curvature and signed length.
///
/// A step without a turn is a straight line; `direction` (±1) is the sign of the length.
fn arc_between(a: Pose, b: Pose, direction: i8) -> (f64, f64) {
    let chord = (b.point() - a.point()).norm_squared().sqrt();
    let turn = math::turn(a.heading, b.heading);
    let half = turn / 2.0;
    let length = if half.abs() < 1e-6 { chord } else { chord * half / math::sin(half) };
    let length = length * f64::from(direction);
    (if length == 0.0 { 0.0 } else { turn / length }, length)
}

/// The car's motion from pose to pose, summed until it exceeds rounding, so that the verdict does not depend on how
/// finely a path is sampled.
#[derive(Default)]
struct Motion {
    /// Metres of arc, and radians turned on it.
    length: f64,
    turn: f64,
    /// Metres in the gear's direction, and to the left.
    ahead: f64,
    aside: f64,
}

impl Motion {
    /// Adds a step: length along its arc, turn, and shift ahead and aside in the frame of its middle heading.
    fn add(&mut self, a: Pose, b: Pose, gear: i8) {
        let turn = math::turn(a.heading, b.heading);
        self.length += arc_between(a, b, 1).1;
        self.turn += turn;
        let (sin, cos) = math::sin_cos(a.heading + turn / 2.0);
        let shift = b.point() - a.point();
        self.ahead += (cos * shift.x + sin * shift.y) * f64::from(gear);
        self.aside += cos * shift.y - sin * shift.x;
    }

    /// The radius, once it is known: when the motion is longer than `least`, metres, or turns by more, radians.
    fn radius(&mut self, least: f64) -> Option<f64> {
        let turn = self.turn.abs();
        if self.length <= least && turn <= least {
            return None;
        }
        let radius = if turn < 1e-9 { f64::INFINITY } else { self.length / turn };
        (self.length, self.turn) = (0.0, 0.0);
        Some(radius)
    }

    /// True if the body slides, once that is known.
    fn slides(&mut self) -> Option<bool> {
        if self.ahead * self.ahead + self.aside * self.aside <= 1e-8 {
            return None;
        }
        let slides = math::atan2(self.aside, self.ahead).abs() > SLIP_TOLERANCE;
        (self.ahead, self.aside) = (0.0, 0.0);
        Some(slides)
    }
}

/// Fills in turns, slips and the tightest radius. Adjoining tight steps count as one tight turn.
fn check_motion(check: &mut Check, path: &[Pose], directions: &[i8], min_radius: f64) {
    let (mut motion, mut tight_before) = (Motion::default(), false);
    let away = path.first().map_or(0.0, |first| first.x.abs() + first.y.abs());
    let least = LEAST_MOTION + LEAST_MOTION_AWAY * away;
    for (i, pair) in path.windows(2).enumerate() {
        let gear = if directions.get(i).is_some_and(|&d| d < 0) { -1 } else { 1 };
        motion.add(pair[0], pair[1], gear);
        if let Some(radius) = motion.radius(least) {
            check.tightest_radius = check.tightest_radius.min(radius);
            let tight = radius * CURVATURE_SLACK < min_radius;
            check.tight_turns += u32::from(tight && !tight_before);
            tight_before = tight;
        }
        check.slips += u32::from(motion.slides() == Some(true));
    }
}

/// More than rounding adds to a distance, metres.
const ROUNDING: f64 = 1e-6;

/// Fills in hits and clearances. The clearance at one pose serves twice: as a figure, and as the room that certifies
/// the way to the next.
fn check_body(check: &mut Check, body: &Body, path: &[Pose], directions: &[i8]) {
    let (mut sum, mut room) = (0.0, 0.0);
    check.min_clearance = f64::INFINITY;
    for (i, &pose) in path.iter().enumerate() {
        let way = i.checked_sub(1).map(|p| (path[p], directions.get(p).copied().unwrap_or(1)));
        let moved = way.map_or(0.0, |(from, gear)| {
            let (_, length) = arc_between(from, pose, gear);
            body.sweep(length, math::turn(from.heading, pose.heading))
        });
        // A body that moves less than the room around it hits nothing.
        let hit = if room > moved + ROUNDING {
            None
        } else {
            way.and_then(|(from, gear)| hit_between(body, (from, room), pose, gear))
                .or_else(|| body.hit(pose).map(|owner| (owner, pose)))
        };
        if let Some(hit) = hit {
            check.hit_poses.push(i as u32);
            check.first_hit.get_or_insert(hit);
        }
        let guess = if room > 0.0 { room + moved + ROUNDING } else { body.buckets.side };
        let clearance = if hit.is_some() { 0.0 } else { body.room(pose, guess, FAR) };
        room = clearance;
        check.min_clearance = check.min_clearance.min(clearance);
        sum += clearance;
        check.clearances.push(clearance);
    }
    check.mean_clearance = sum / path.len() as f64;
    if IS_COMPLETE && check.hit_poses.is_empty() {
        check.narrowest = body.narrowest(path, &check.clearances);
    }
}

/// Steps of a single way between two poses: 20 km at the usual spacing, which grows beyond.
const MOST_STEPS: f64 = 1e6;
/// Room is measured once in so many steps at most: where there is little, that costs more than it saves.
const PAUSE: u32 = 4;

/// The first hit strictly between two poses; the body may move by `room` from the first one and hits nothing.
fn hit_between(body: &Body, (from, room): (Pose, f64), to: Pose, gear: i8) -> Option<(Owner, Pose)> {
    let (curvature, length) = arc_between(from, to, gear);
    let turn = math::turn(from.heading, to.heading);
    let steps = (length.abs() / STEP).max(turn.abs() / STEP).ceil().min(MOST_STEPS) as u32;
    let straight = (curvature == 0.0 && steps > 1).then(|| from.direction());
    let each = body.sweep(length, turn) / f64::from(steps);
    let (mut free, mut measure, mut k) = (room, PAUSE, 0);
    loop {
        // Until it has used up the room around it, the body hits nothing.
        k = (k + 1).max(((free - ROUNDING) / each) as u32);
        if k >= steps {
            return None;
        }
        let moved = f64::from(k) * each;
        let t = f64::from(k) / f64::from(steps);
        let pose = if length == 0.0 {
            Pose::new(from.x, from.y, from.heading + turn * t)
        } else if let Some(ahead) = straight {
            Pose::new(from.x + length * t * ahead.x, from.y + length * t * ahead.y, from.heading)
        } else {
            from.advance(curvature, length * t)
        };
        let hit = body.hit(pose);
        if hit.is_none() && k >= measure && steps - k > PAUSE {
            measure = k + PAUSE;
            free = moved + body.room(pose, body.buckets.side, FAR);
        }
        if let Some(owner) = hit {
            return Some((owner, pose));
        }
    }
}

#[cfg(test)]
mod tests;
