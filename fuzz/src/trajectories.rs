//! Plans as trajectories, alone and among moving boxes.

use parkade::drive::{Encounter, Ending, Mover, Route, Rule, WaitOptions};
use parkade::geometry::{Point, Pose};
use parkade::metrics::Body;
use parkade::optimise::{Optimised, Options, Stage, optimise, stop_and_steer, stop_wait_go};
use parkade::plan::{Outcome as Answer, Plan, Planner};
use parkade::referee::{States, Submission, TimedRows, check, judge};
use parkade::scenario::resolve::Geometry;
use parkade::scenario::{MovingObstacle, Scenario};
use serde_json::{Map, Value};

use crate::Outcome;
use crate::random::Random;
use crate::random_scenes;

/// The referee's centimetre in x and in y, metres.
const ATTAINED: f64 = 0.0142;
/// An end that is reached exactly is no farther off than this, metres in x and in y and radians.
const NEAR: f64 = 0.001;
/// Seconds between two looks at a drive among boxes.
const LOOK: f64 = 0.005;

/// The trajectory of a random scene's path against the same path driven with stops, by the referee.
pub(crate) fn optimised(seed: u64) -> Outcome {
    let (scene, settings) = random_scenes::scene(seed);
    let Some((geometry, route, clearance)) = planned(&scene, &settings)? else { return Ok("no-path") };
    let r = &mut Random::new(seed);
    let options = Options { margin: *r.pick(&[0.0, 0.05, 0.05, 0.1]), ..Options::default() };
    let made = optimise(&geometry, &route, clearance, &options).map_err(|e| e.to_string())?;
    let word = held(&geometry, &route, &made, &options)?;
    let boxes = moving(r, &made.states);
    let movers: Vec<Mover> = boxes.iter().map(Mover::new).collect();
    for rule in [Rule::Predictive, Rule::Reactive] {
        let options = WaitOptions { rule, max_time: 60.0, ..WaitOptions::default() };
        let met =
            stop_wait_go(&geometry.vehicle, &made.states, &movers, &options).map_err(|e| e.to_string())?;
        encountered(&geometry, &movers, &met).map_err(|wrong| format!("{rule:?} {boxes:?}: {wrong}"))?;
    }
    Ok(word)
}

/// The hash of the trajectory that is made of a plan and, if boxes move in the scene, of its drive among them; or the
/// error's words.
pub(crate) fn hashes(scene: &Scenario, plan: &Plan) -> Vec<String> {
    let path: Vec<f64> = plan.path.iter().flat_map(|p| [p.x, p.y, p.heading]).collect();
    let columns = (&path[..], Some(&plan.directions[..]), Some(&plan.curvatures[..]));
    let made = parkade::plan::optimise(scene, columns, &Options::default());
    let (made, geometry) = match (made, scene.geometry()) {
        (Ok(made), Ok(geometry)) => (made, geometry),
        (Err(error), _) | (_, Err(error)) => return vec![error.to_string()],
    };
    let mut hashes = vec![made.states.hash()];
    let movers: Vec<Mover> = scene.moving.iter().map(Mover::new).collect();
    if !movers.is_empty() {
        let met = stop_wait_go(&geometry.vehicle, &made.states, &movers, &WaitOptions::default());
        hashes.push(met.map_or_else(|error| error.to_string(), |met| met.rows.hash()));
    }
    hashes
}

type Planned = (Geometry, Route, f64);

fn planned(scene: &Scenario, settings: &Map<String, Value>) -> Result<Option<Planned>, String> {
    let mut planner = Planner::new("hybrid", scene, settings).map_err(|e| e.to_string())?;
    let plan = planner.plan(parkade::plan::Options::default());
    if plan.outcome != Answer::Found || plan.path.len() < 2 {
        return Ok(None);
    }
    let geometry = planner.geometry().clone();
    let route = Route::new(&geometry.vehicle, &plan.path, &plan.directions, Some(&plan.curvatures));
    Ok(Some((geometry, route.map_err(|e| e.to_string())?, plan.metrics.min_clearance)))
}

/// What became of a path: the stage of its trajectory, or that it touches something as a trajectory and with stops
/// alike.
fn held(
    geometry: &Geometry,
    route: &Route,
    made: &Optimised,
    options: &Options,
) -> Result<&'static str, String> {
    let judged = judge(geometry, &timed(&made.states), &options.limits).map_err(|e| e.to_string())?;
    let plain = stop_and_steer(&geometry.vehicle, route, &options.limits);
    let plain = check(geometry, &Body::new(geometry), &plain, &options.limits);
    let stage = made.stage.as_str();
    // Without a margin a path is planned free at places. Between them it may touch something, or come so near that
    // nothing certifies it as free.
    if !plain.contacts.are_none() && !made.check.contacts.are_none() && made.stage == Stage::StopAndSteer {
        return Ok("touches-as-planned");
    }
    if !made.check.passes() || !judged.attained || !judged.keeps_limits || judged.contacts.touching_frames > 0
    {
        return Err(format!("{stage}: refused: {:?}, as a file {judged:?}", made.check));
    }
    let (x, y, turn) = made.check.end_error;
    let is_near = x <= NEAR && y <= NEAR && turn <= NEAR;
    let (figures, with_stops) = (&made.check.figures, &plain.figures);
    let is_worse = figures.duration > with_stops.duration + 1e-9
        || figures.gear_changes > with_stops.gear_changes
        || figures.tpcap_cost() > with_stops.tpcap_cost() + 1e-9;
    if is_worse {
        return Err(format!("{stage}: worse than with stops: {figures:?}, {with_stops:?}"));
    }
    // The referee's centimetre is kept; counted, as an optimised path ends closer but for rare ones.
    Ok(if is_near { stage } else { "within-a-centimetre" })
}

fn timed(states: &States) -> Submission {
    Submission::Timed(TimedRows {
        t: states.t.clone(),
        poses: states.poses.clone(),
        speed: Some(states.speed.clone()),
        steering: Some(states.steering.clone()),
    })
}

/// Up to three boxes that cross the trajectory, drive along it, or end beside it.
fn moving(r: &mut Random, states: &States) -> Vec<MovingObstacle> {
    let count = r.below(4);
    let boxes = (0..count).map(|_| {
        let at = states.poses[r.below(states.poses.len())];
        let way = Pose::new(at.x, at.y, r.between(-4.0, 4.0));
        let (before, after) = (r.between(3.0, 25.0), r.between(0.0, 25.0));
        let point = |along: f64| {
            let p = way.to_world(Point::new(along, 0.0));
            [p.x, p.y]
        };
        MovingObstacle {
            id: None,
            points: vec![point(-before), point(after)],
            size: [r.between(0.3, 5.0), r.between(0.3, 2.5)],
            speed: r.between(0.3, 6.0),
            start: r.between(0.0, 8.0),
        }
    });
    boxes.collect()
}

/// An encounter's words are true, and its rows are a drive.
fn encountered(geometry: &Geometry, movers: &[Mover], met: &Encounter) -> Result<(), String> {
    let rows = &met.rows;
    let mut driven = 0.0;
    for i in 1..rows.t.len() {
        let dt = rows.t[i] - rows.t[i - 1];
        driven += f64::midpoint(rows.speed[i].abs(), rows.speed[i - 1].abs()) * dt;
        if dt <= 0.0 || dt > 0.0501 || (driven - rows.station[i]).abs() > 1e-6 {
            return Err(format!("row {i}: {dt} s, {driven} m driven, at {} m", rows.station[i]));
        }
    }
    let arrives = [Ending::Arrived, Ending::Hit, Ending::Unavoidable].contains(&met.ending);
    let end = rows.poses[rows.t.len() - 1];
    if arrives && (end.point() - geometry.goal.point()).norm() > ATTAINED {
        return Err(format!("{:?} at {end:?}", met.ending));
    }
    if met.ending == Ending::Arrived && met.contact.is_some() {
        return Err("arrives with a contact".to_owned());
    }
    let touched = touch(geometry, movers, met);
    match (touched, &met.contact) {
        // The look is finer than the check, which may miss a graze.
        (Some((t, depth)), None) if depth > 0.03 => {
            Err(format!("touched at {t} s, {depth} m deep, and not told"))
        }
        (Some((t, depth)), Some(told)) if depth > 0.03 && told.t > t + 1e-9 => {
            Err(format!("touched at {t} s, told {} s", told.t))
        }
        _ => Ok(()),
    }
}

/// When body and boxes are first deeper than 3 cm in each other, or else where they are deepest: seconds and metres.
fn touch(geometry: &Geometry, movers: &[Mover], met: &Encounter) -> Option<(f64, f64)> {
    let rows = &met.rows;
    let (mut deepest, mut t) = (None::<(f64, f64)>, 0.0);
    while t <= met.duration {
        let i = rows.t.partition_point(|&at| at <= t).max(1) - 1;
        let j = (i + 1).min(rows.t.len() - 1);
        let share = if j > i { (t - rows.t[i]) / (rows.t[j] - rows.t[i]) } else { 0.0 };
        let mix = |a: f64, b: f64| a + (b - a) * share;
        let (a, b) = (rows.poses[i], rows.poses[j]);
        let pose = Pose::new(mix(a.x, b.x), mix(a.y, b.y), mix(a.heading, b.heading));
        let body = geometry.vehicle.outline(pose);
        for mover in movers {
            let depth = overlap(&body, &mover.outline(t));
            if depth > deepest.map_or(0.0, |found| found.1) {
                deepest = Some((t, depth));
            }
            if depth > 0.03 {
                return deepest;
            }
        }
        t += LOOK;
    }
    deepest
}

/// How deep two rectangles are in each other, by their sides' directions, metres; 0 where they are apart.
fn overlap(a: &[Point; 4], b: &[Point; 4]) -> f64 {
    let axes = [a, b].into_iter().flat_map(|ring| [ring[1] - ring[0], ring[2] - ring[1]]);
    axes.fold(f64::INFINITY, |least, side| {
        let axis = side.normalize();
        let range = |ring: &[Point; 4]| {
            let along = ring.iter().map(|p| p.coords.dot(&axis));
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
        };
        let ((a0, a1), (b0, b1)) = (range(a), range(b));
        least.min(a1.min(b1) - a0.max(b0))
    })
    .max(0.0)
}
