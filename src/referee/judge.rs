//! The verdict on a trajectory, by code that shares nothing with the planners.
//!
//! A submission passes five questions, and the verdict keeps the answer to each:
//!
//! 1. Does it begin at the start and end at rest at the goal, within 1 cm in x and in y and 1° (`attained`)?
//! 2. Is it what a car does? A replay of the controls must stay within 1 cm and 0.5° (`model_error`, in `attained`).
//! 3. Does the body touch anything, asked every millisecond and at every row (`Contacts::touching_frames`)?
//! 4. Can it touch anything in between? A stretch where nothing proves that it cannot counts as uncertified.
//! 5. Are the limits kept, to 0.1 % (`keeps_limits`)?
//!
//! Speeds and steering angles that are left out follow from the poses. A path without times is driven first.

use serde_json::{Value, json};

use super::replay::FRAME;
use super::submission::MAX_DURATION;
use super::{Contacts, Figures, MotionLimits, States, Submission, TimedRows, derive, replay, scan};
use crate::drive::{Motion, Route, follow};
use crate::error::{Error, ErrorCode};
use crate::geometry::{Pose, math};
use crate::metrics::Body;
use crate::scenario::Scenario;
use crate::scenario::resolve::Geometry;
use crate::vehicle::Vehicle;

/// How near to the goal a car must end, and to the start it must begin: metres in x and in y, and radians.
const NEAR: (f64, f64) = (0.01, math::PI / 180.0);
/// How far the poses may be from what the car does with the speeds and steering angles: metres, radians, …
const SAME: (f64, f64) = (0.01, math::PI / 360.0);
/// … looked at each so many frames.
const LOOK: usize = 10;
/// The car stands when it is no faster, m/s.
const STANDING: f64 = 0.01;

/// The referee's verdict and figures.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// True if the trajectory begins at the start, ends at rest within 1 cm and 1° of the goal, and is what the car
    /// does with its speeds and steering angles.
    pub attained: bool,
    /// True if all limits are kept, to 0.1 %.
    pub keeps_limits: bool,
    /// Duration, effort, gear changes and the largest of what the limits bound.
    pub figures: Figures,
    /// Contacts of the body.
    pub contacts: Contacts,
    /// How far the first pose is from the start: metres, radians.
    pub start_error: (f64, f64),
    /// How far the last pose is from the goal: metres in x and in y, radians. Infinite where the scene's set of goals
    /// is empty.
    pub end_error: (f64, f64, f64),
    /// The speed at the end, m/s.
    pub end_speed: f64,
    /// How far the given poses are from the replayed ones at most: metres, radians. Large values mean that no car
    /// drives these poses at these speeds.
    pub model_error: (f64, f64),
}

impl Judgement {
    /// True if nothing is wrong: attained, no touching frame, everything between the frames certified, limits kept.
    pub fn passes(&self) -> bool {
        self.attained && self.keeps_limits && self.contacts.are_none()
    }

    /// The verdict as plain data, with the names of the JS API.
    pub fn to_json(&self, scene: &Scenario) -> Value {
        let (figures, contacts) = (&self.figures, &self.contacts);
        let first = contacts.first.map(|(t, owner, pose)| {
            json!({ "t": t, "obstacle": scene.name_of(owner), "index": owner.index(), "pose": pose })
        });
        json!({
            "passes": self.passes(),
            "attained": self.attained,
            "keepsLimits": self.keeps_limits,
            "frames": contacts.frames,
            "touchingFrames": contacts.touching_frames,
            "uncertified": contacts.uncertified,
            "firstContact": first,
            "minClearance": contacts.min_clearance,
            "duration": figures.duration,
            "length": figures.length,
            "effort": figures.effort,
            "steeringEffort": figures.steering,
            "gearChanges": figures.gear_changes,
            "smoothness": figures.smoothness(),
            "tpcapCost": figures.tpcap_cost(),
            "maxSpeed": figures.max_speed,
            "maxAcceleration": figures.max_acceleration,
            "maxDeceleration": figures.max_deceleration,
            "maxSteering": figures.max_steering,
            "maxSteeringRate": figures.max_steering_rate,
            "maxLateralAcceleration": figures.max_lateral_acceleration,
            "startError": { "distance": self.start_error.0, "heading": self.start_error.1 },
            "endError": { "x": self.end_error.0, "y": self.end_error.1, "heading": self.end_error.2 },
            "endSpeed": self.end_speed,
            "modelError": { "distance": self.model_error.0, "heading": self.model_error.1 },
        })
    }
}

/// Checks states of our own: the controls are replayed from the first state, and the body is moved as the replay moves
/// it.
pub fn check(geometry: &Geometry, body: &Body, states: &States, limits: &MotionLimits) -> Judgement {
    let (mut moments, mut row, mut error) = (Vec::new(), 0, (0.0_f64, 0.0_f64));
    replay(&geometry.vehicle, states, |frame| {
        moments.push((frame.t, frame.pose));
        if frame.t == states.t[row] {
            error = larger(error, states.poses[row], frame.pose);
            row += 1;
        }
    });
    verdict(geometry, body, states, limits, &moments, error)
}

/// Judges a trajectory or a path. Poses with times are taken as they are, interpolated linearly; speeds and steering
/// angles that are absent come from them. A path is timed run by run with trapezoids and driven by the closed-loop
/// follower, whose drive is judged.
///
/// # Errors
/// As [`Submission::validate`], [`MotionLimits::validate`] and, for paths, [`Route::new`].
///
/// # Examples
/// ```
/// use parkade::referee::{MotionLimits, judge, read};
///
/// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
/// let geometry = scene.geometry().unwrap();
/// let submission = read("t,x,y,theta\n0,4,3,0\n2.5,7.125,3,0\n6.5,14,3,0\n").unwrap();
/// let judgement = judge(&geometry, &submission, &MotionLimits::default()).unwrap();
/// assert_eq!((judgement.figures.duration, judgement.attained), (6.5, false));
/// ```
pub fn judge(
    geometry: &Geometry,
    submission: &Submission,
    limits: &MotionLimits,
) -> Result<Judgement, Error> {
    limits.validate()?;
    submission.validate()?;
    let (vehicle, body) = (&geometry.vehicle, Body::new(geometry));
    let rows = match submission {
        Submission::Timed(rows) => rows.clone(),
        Submission::Path { poses, gears } => driven(vehicle, limits, poses, gears.as_deref())?,
    };
    let states = derive::states(vehicle, limits, &rows);
    let moments = interpolated(&states);
    let mut replayed = Vec::new();
    replay(vehicle, &states, |frame| replayed.push((frame.t, frame.pose)));
    let mut error = (0.0, 0.0);
    for pair in replayed.iter().zip(&moments).step_by(LOOK).chain(replayed.last().zip(moments.last())) {
        error = larger(error, pair.0.1, pair.1.1);
    }
    Ok(verdict(geometry, &body, &states, limits, &moments, error))
}

/// The larger of an error so far and that between two poses: metres, radians.
fn larger((distance, turn): (f64, f64), a: Pose, b: Pose) -> (f64, f64) {
    (distance.max(math::hypot(a.x - b.x, a.y - b.y)), turn.max((a.heading - b.heading).abs()))
}

/// Poses at the same moments as those of [`replay()`].
fn interpolated(states: &States) -> Vec<(f64, Pose)> {
    let mut moments = vec![(states.t[0], states.poses[0])];
    let mut tick = 1.0;
    for (t, poses) in states.t.windows(2).zip(states.poses.windows(2)) {
        let (from, to) = (poses[0], poses[1]);
        let mut add = |at: f64| {
            let share = (at - t[0]) / (t[1] - t[0]);
            let mix = |a: f64, b: f64| a + (b - a) * share;
            let pose = Pose::new(mix(from.x, to.x), mix(from.y, to.y), mix(from.heading, to.heading));
            moments.push((at, pose));
        };
        while tick * FRAME <= t[1] - 1e-9 {
            add(tick * FRAME);
            tick += 1.0;
        }
        if tick * FRAME < t[1] + 1e-9 {
            tick += 1.0;
        }
        add(t[1]);
    }
    moments
}

/// Holds the moments, every millisecond and every row, against start, goal, obstacles and limits.
fn verdict(
    geometry: &Geometry,
    body: &Body,
    states: &States,
    limits: &MotionLimits,
    moments: &[(f64, Pose)],
    model_error: (f64, f64),
) -> Judgement {
    let vehicle = &geometry.vehicle;
    let figures = Figures::new(vehicle, states);
    let (first, last) = (moments[0].1, moments[moments.len() - 1].1);
    let apart =
        |a: Pose, b: Pose| ((a.x - b.x).abs(), (a.y - b.y).abs(), math::turn(a.heading, b.heading).abs());
    let start = apart(first, geometry.start);
    let goal =
        geometry.goal_for(last).map_or((f64::INFINITY, f64::INFINITY, f64::INFINITY), |g| apart(last, g));
    let is_near = |(x, y, turn): (f64, f64, f64)| x <= NEAR.0 && y <= NEAR.0 && turn <= NEAR.1;
    let end_speed = states.speed[states.speed.len() - 1];
    let is_driven = model_error.0 <= SAME.0 && model_error.1 <= SAME.1;
    Judgement {
        attained: is_near(start) && is_near(goal) && end_speed.abs() <= STANDING && is_driven,
        keeps_limits: figures.keep(vehicle, limits),
        figures,
        contacts: scan(vehicle, body, moments),
        start_error: (math::hypot(start.0, start.1), start.2),
        end_error: goal,
        end_speed,
        model_error,
    }
}

/// The trajectory of the closed-loop follower on a path. Gears that are absent follow from the side on which the next
/// pose lies.
fn driven(
    vehicle: &Vehicle,
    limits: &MotionLimits,
    poses: &[Pose],
    gears: Option<&[i8]>,
) -> Result<TimedRows, Error> {
    let derived: Vec<i8>;
    let gears = if let Some(gears) = gears {
        gears
    } else {
        let signs = poses.windows(2).map(|p| {
            let turned = Pose { heading: p[0].heading + math::turn(p[0].heading, p[1].heading), ..p[1] };
            if derive::arc(p[0], turned) < 0.0 { -1 } else { 1 }
        });
        let mut all: Vec<i8> = signs.collect();
        all.push(all[all.len() - 1]);
        derived = all;
        &derived
    };
    let vehicle = Vehicle { max_steer_rate: limits.steering_rate_of(vehicle), ..*vehicle };
    let route = Route::new(&vehicle, poses, gears, None)?;
    let motion = Motion::trapezoids(&route, limits.speed, limits.acceleration, limits.deceleration)?;
    if motion.duration() > MAX_DURATION {
        let message = message!(
            "must be driven within {} s, takes {} s",
            MAX_DURATION,
            format_args!("{:.0}", motion.duration())
        );
        return Err(Error::new(ErrorCode::Input, "path", message));
    }
    let drive = follow(&vehicle, &route, &motion);
    Ok(TimedRows { t: drive.t, poses: drive.poses, speed: Some(drive.speed), steering: Some(drive.steering) })
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use super::*;
    use crate::scenario::resolve::{Form, Owner, Shape};

    /// A floor of 40 m by 40 m whose middle is the origin, and blocks on it.
    fn scene(start: Pose, goal: Pose, blocks: &[[f64; 4]]) -> Geometry {
        use crate::geometry::Point;
        let ring = |[left, low, right, high]: [f64; 4]| {
            [(left, low), (right, low), (right, high), (left, high)].map(|(x, y)| Point::new(x, y)).to_vec()
        };
        let shape = |&block| Shape { owner: Owner::Obstacle(0), form: Form::Polygon(ring(block)) };
        Geometry {
            start,
            goal,
            goals: None,
            vehicle: Vehicle { max_steer_rate: 0.5, ..Vehicle::PAPER },
            boundary: ring([-20.0, -20.0, 20.0, 20.0]),
            shapes: blocks.iter().map(shape).collect(),
            parked: Vec::new(),
        }
    }

    fn judged(geometry: &Geometry, csv: &str) -> Judgement {
        judge(geometry, &super::super::read(csv).unwrap(), &MotionLimits::default()).unwrap()
    }

    const STRAIGHT: &str =
        "t,x,y,theta,v,phi\n0,0,0,0,0,0\n2.5,3.125,0,0,2.5,0\n4,6.875,0,0,2.5,0\n6.5,10,0,0,0,0\n";

    #[test]
    fn ten_straight_metres_take_six_and_a_half_seconds() {
        let start = Pose::default();
        let geometry = scene(start, Pose::new(10.0, 0.0, 0.0), &[]);
        // Rows so far apart that linear poses are no accelerated motion; finer ones, without v and phi; and the path
        // alone.
        let mut fine = "t,x,y,theta\n".to_owned();
        for k in 0..=65 {
            let t = f64::from(k) / 10.0;
            let x = if t < 2.5 {
                t * t / 2.0
            } else if t < 4.0 {
                3.125 + 2.5 * (t - 2.5)
            } else {
                10.0 - (6.5 - t) * (6.5 - t) / 2.0
            };
            writeln!(fine, "{t},{x},0,0").unwrap();
        }
        for csv in [STRAIGHT, &fine, "x,y,theta\n0,0,0\n10,0,0\n"] {
            let got = judged(&geometry, csv);
            let figures = got.figures;
            assert!((figures.duration - 6.5).abs() < 1e-6, "{figures:?}");
            assert!((figures.effort - 5.0).abs() < 1e-6 && figures.steering < 1e-6, "{figures:?}");
            assert!((figures.length - 10.0).abs() < 1e-6 && figures.gear_changes == 0);
            assert!((figures.smoothness() - 50.0).abs() < 1e-5);
            assert!((figures.tpcap_cost() - 700.0).abs() < 1e-5);
            assert!(got.keeps_limits && got.contacts.are_none());
            assert!(got.contacts.frames >= 6501);
            assert_eq!(got.attained, csv != STRAIGHT, "{:?}", got.model_error);
        }
    }

    #[test]
    fn a_circle_costs_its_angle_squared_and_is_attained() {
        let (angle, speed): (f64, f64) = (0.4, 1.0);
        let curvature = math::tan(angle) / Vehicle::PAPER.wheelbase;
        let pose = |t: f64| Pose::default().advance(curvature, speed * t);
        let mut csv = "t,x,y,theta\n".to_owned();
        for k in 0..=400 {
            let t = f64::from(k) / 50.0;
            let p = pose(t);
            writeln!(csv, "{t},{},{},{}", p.x, p.y, p.heading).unwrap();
        }
        let geometry = scene(Pose::default(), pose(8.0), &[]);
        let got = judged(&geometry, &csv);
        assert!((got.figures.steering - angle * angle * 8.0).abs() < 1e-6, "{:?}", got.figures);
        assert!(got.figures.effort < 1e-6 && (got.figures.max_speed - 1.0).abs() < 1e-6);
        assert!(got.model_error.0 < 1e-3 && got.end_error.2 < 1e-9);
        // It does not stand at the end.
        assert!(!got.attained && (got.end_speed - 1.0).abs() < 1e-6);
    }

    #[test]
    fn a_metre_each_way_and_back_is_three_runs_of_two_seconds() {
        let goal = Pose::new(1.0, 0.0, 0.0);
        let geometry = scene(Pose::default(), goal, &[]);
        for csv in [
            "x,y,theta\n0,0,0\n1,0,0\n0,0,0\n1,0,0\n",
            "x,y,theta,gear\n0,0,0,1\n1,0,0,-1\n0,0,0,1\n1,0,0,1\n",
        ] {
            let got = judged(&geometry, csv);
            assert!((got.figures.duration - 6.0).abs() < 1e-6, "{:?}", got.figures);
            assert_eq!(got.figures.gear_changes, 2);
            assert!((got.figures.effort - 6.0).abs() < 1e-6 && (got.figures.length - 3.0).abs() < 1e-6);
            assert!(got.passes(), "{got:?}");
        }
    }

    #[test]
    fn a_post_in_the_way_is_touched_for_as_long_as_the_body_is_over_it() {
        // At 1 m/s the nose (4.5 m ahead) meets a plate of 1 mm after half a second; the tail leaves it 5.501 s later.
        let geometry = scene(Pose::default(), Pose::new(9.0, 0.0, 0.0), &[[5.0, -0.1, 5.001, 0.1]]);
        let got = judged(&geometry, "t,x,y,theta,v,phi\n0,0,0,0,1,0\n9,9,0,0,1,0\n");
        assert!((i64::from(got.contacts.touching_frames) - 5501).abs() <= 1, "{:?}", got.contacts);
        let (t, owner, _) = got.contacts.first.unwrap();
        assert!((t - 0.5).abs() < 2e-3 && owner == Owner::Obstacle(0));
        assert_eq!(got.contacts.min_clearance, 0.0);
    }

    #[test]
    fn what_lies_between_two_frames_is_certified_or_not() {
        // A spike that the corner of a fast turning body passes between two milliseconds by less than it moves.
        let geometry = scene(Pose::default(), Pose::new(9.0, 0.0, 0.0), &[[4.6, -1.0, 4.7, 1.3]]);
        let beside = judged(&geometry, "t,x,y,theta,v,phi\n0,0,2.61,0,1,0\n9,9,2.61,0,1,0\n");
        assert_eq!((beside.contacts.touching_frames, beside.contacts.uncertified), (0, 0));
        assert!((beside.contacts.min_clearance - 0.01).abs() < 1e-9);
        let graze = judged(&geometry, "t,x,y,theta,v,phi\n0,0,2.6,0,1,0\n9,9,2.6,0,1,0\n");
        assert!(
            graze.contacts.touching_frames == 0 && graze.contacts.uncertified > 100,
            "{:?}",
            graze.contacts
        );
    }

    #[test]
    fn poses_that_no_car_drives_are_not_attained() {
        let geometry = scene(Pose::default(), Pose::new(0.0, 2.0, 0.0), &[]);
        let sideways = judged(&geometry, "t,x,y,theta,v,phi\n0,0,0,0,0,0\n4,0,2,0,0,0\n");
        assert!(sideways.end_error == (0.0, 0.0, 0.0) && sideways.contacts.touching_frames == 0);
        assert!(sideways.model_error.0 > 1.9 && !sideways.attained);
        let elsewhere = judged(&geometry, "t,x,y,theta\n0,0,0,0\n1,0,0,0\n");
        assert!(!elsewhere.attained && elsewhere.end_error.1 == 2.0 && elsewhere.start_error == (0.0, 0.0));
    }

    #[test]
    fn limits_are_kept_to_a_thousandth() {
        let geometry = scene(Pose::default(), Pose::new(10.0, 0.0, 0.0), &[]);
        let kept = |v: f64, phi: f64| {
            judged(&geometry, &format!("t,x,y,theta,v,phi\n0,0,0,0,0,0\n2,1,0,0,{v},{phi}\n9,2,0,0,0,0\n"))
                .keeps_limits
        };
        assert!(kept(2.001, 0.6) && !kept(2.003, 0.0));
        assert!(kept(-2.001, -0.6005) && !kept(0.0, 0.601));
        let turned = "t,x,y,theta,v,phi\n0,0,0,0,0,0\n1,0,0,0,0,0.502\n";
        assert!(!judged(&geometry, turned).keeps_limits);
    }
}
