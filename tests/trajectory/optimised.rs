//! Plans as trajectories: on the built-in parking scenes, against reference times, and on random scenes.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::drive::Route;
use parkade::geometry::math;
use parkade::metrics::Body;
use parkade::optimise::{Optimised, Options, Stage, optimise, slow_duration};
use parkade::plan::{Outcome, Planner};
use parkade::referee::{MotionLimits, States, Submission, TimedRows, judge, track};
use parkade::scenario::{Scenario, catalog};
use parkade::vehicle::Vehicle;
use serde_json::{Map, Value};

use crate::{random_scenes, tight_scenes};

struct Driven {
    made: Optimised,
    lateral: f64,
    slow: f64,
}

/// Plans, optimises, and holds what is promised of every trajectory; `None` where there is no path.
fn driven(scene: &Scenario, settings: &Map<String, Value>, options: &Options) -> Option<Driven> {
    let name = scene.name.clone().unwrap_or_default();
    let mut planner = Planner::new("hybrid", scene, settings).unwrap();
    let plan = planner.plan(parkade::plan::Options::default());
    if plan.outcome != Outcome::Found || plan.path.len() < 2 {
        return None;
    }
    let geometry = planner.geometry();
    let vehicle = geometry.vehicle;
    let route = Route::new(&vehicle, &plan.path, &plan.directions, Some(&plan.curvatures)).unwrap();
    let made = optimise(geometry, &route, plan.metrics.min_clearance, options).unwrap();
    assert!(made.check.passes(), "{name}: {:?}", made.check);
    let states = &made.states;
    assert!(states.t.windows(2).all(|t| t[0] < t[1] && t[1] - t[0] < 0.0501), "{name}");
    let last = states.t.len() - 1;
    let ends = [states.speed[0], states.speed[last], states.steering[0], states.steering[last]];
    assert!(ends.iter().all(|end| end.abs() < 1e-9), "{name}: {ends:?}");
    let (_, rates) = states.controls();
    assert!(rates.iter().all(|r| r.abs() <= 1.001 * options.limits.steering_rate_of(&vehicle)), "{name}");
    continuous(&name, &vehicle, states, &options.limits);
    let tracked = track(&vehicle, &Body::new(geometry), states);
    let slow = slow_duration(&vehicle, &route, &options.limits);
    assert!(slow.is_finite(), "{name}");
    // The referee finds the same in the columns as if a stranger had handed them in.
    let rows = TimedRows {
        t: states.t.clone(),
        poses: states.poses.clone(),
        speed: Some(states.speed.clone()),
        steering: Some(states.steering.clone()),
    };
    let judged = judge(geometry, &Submission::Timed(rows), &options.limits).unwrap();
    assert!(
        judged.attained && judged.keeps_limits && judged.figures == made.check.figures,
        "{name}: {judged:?}"
    );
    Some(Driven { made, lateral: tracked.max_lateral, slow })
}

/// Where the car drives, the curvature changes no faster than the wheel turns, across rows too, and the rows' poses are
/// those of the curvatures between them.
fn continuous(name: &str, vehicle: &Vehicle, states: &States, limits: &MotionLimits) {
    let rate = 1.001 * limits.steering_rate_of(vehicle);
    let most = rate * (1.0 + math::tan(vehicle.max_steer).powi(2)) / vehicle.wheelbase;
    let (mut last, mut row) = (None::<(f64, f64)>, 0);
    parkade::referee::replay(vehicle, states, |frame| {
        let curvature = math::tan(frame.steering) / vehicle.wheelbase;
        if let Some((t, before)) = last {
            assert!((curvature - before).abs() <= most * (frame.t - t) + 1e-9, "{name} at {t} s");
        }
        if frame.t == states.t[row] {
            let own = math::tan(states.steering[row]) / vehicle.wheelbase;
            assert!((curvature - own).abs() < 1e-9, "{name}, row {row}");
            let own_pose = states.poses[row];
            let off = (frame.pose.point() - own_pose.point()).norm();
            // Far from the origin each step is rounded.
            let far = own_pose.x.abs().max(own_pose.y.abs());
            assert!(off < 1e-6 + 1e-12 * far, "{name}, row {row}: {off} m");
            row += 1;
        }
        last = Some((frame.t, curvature));
    });
    assert_eq!(row, states.t.len(), "{name}: every row is a frame");
}

fn built_in() -> impl Iterator<Item = &'static str> {
    let groups = ["parking", "tight", "paper"];
    catalog::scenes().filter(move |s| groups.contains(&s.group)).map(|s| s.id)
}

#[test]
fn built_in_scenes_are_driven_to_the_centimetre_and_much_faster_than_slow() {
    let (mut count, mut optimised, mut saved) = (0, 0, Vec::new());
    for id in built_in() {
        let scene = catalog::scenario(id).unwrap();
        let Some(driven) = driven(&scene, &Map::new(), &Options::default()) else {
            assert_eq!(id, "narrow-gap");
            continue;
        };
        assert!(driven.lateral < 0.01, "{id}: {}", driven.lateral);
        assert!(driven.made.states.duration() < driven.slow, "{id}");
        count += 1;
        optimised += usize::from(driven.made.stage == Stage::Optimised);
        saved.push(1.0 - driven.made.states.duration() / driven.slow);
    }
    saved.sort_by(f64::total_cmp);
    assert!(count >= 18 && optimised * 100 >= 95 * count, "{optimised} of {count}");
    assert!(saved[saved.len() / 2] >= 0.35, "{saved:?}");
}

#[test]
fn durations_are_near_those_of_an_interior_point_solver() {
    // Direct multiple shooting with 0.6 rad/s and a margin of 0.03 m, checked at its nodes only.
    let references = [
        ("P0", 11.70),
        ("reverse-in", 14.03),
        ("L0", 14.35),
        ("L2", 12.39),
        ("P2", 14.59),
        ("perp-tail-3.2", 15.93),
    ];
    let limits = MotionLimits { steering_rate: 0.6, ..MotionLimits::default() };
    for (id, reference) in references {
        let scene = catalog::scenario(id).unwrap();
        let options = Options { limits: limits.clone(), margin: 0.03 };
        let made = driven(&scene, &Map::new(), &options).unwrap().made;
        let duration = made.states.duration();
        assert!(made.stage == Stage::Optimised && duration < 1.05 * reference, "{id}: {duration} s");
    }
}

#[test]
fn random_scenes_pass_and_most_are_optimised() {
    let (mut count, mut optimised) = (0, 0);
    for seed in 1000..1060 {
        let (scene, settings) = random_scenes::scene(seed);
        let Some(driven) = driven(&scene, &settings, &Options::default()) else { continue };
        count += 1;
        optimised += usize::from(driven.made.stage == Stage::Optimised);
        assert!(driven.lateral < 0.01, "seed {seed}: {}", driven.lateral);
        assert!(driven.made.states.duration() <= driven.slow, "seed {seed}");
    }
    assert!(count > 40 && optimised * 100 >= 95 * count, "{optimised} of {count}");
}

#[test]
fn a_path_that_slow_drives_as_fast_is_no_slower() {
    let (scene, settings) = random_scenes::scene(20126);
    let driven = driven(&scene, &settings, &Options::default()).unwrap();
    let duration = driven.made.states.duration();
    assert!(duration <= driven.slow && duration > 0.95 * driven.slow, "{duration} s, slow {} s", driven.slow);
}

#[test]
fn limits_of_which_only_some_are_given_are_kept_and_no_slower_than_slow() {
    let usual = MotionLimits::default();
    let all = [
        MotionLimits { speed: 0.6, ..usual.clone() },
        MotionLimits { speed: 5.0, ..usual.clone() },
        MotionLimits { acceleration: 0.3, ..usual.clone() },
        MotionLimits { deceleration: 3.0, ..usual.clone() },
        MotionLimits { steering_rate: 0.15, ..usual.clone() },
        MotionLimits { lateral_acceleration: Some(0.4), ..usual },
    ];
    for (limits, seed) in all.iter().zip(3000..) {
        let options = Options { limits: limits.clone(), ..Options::default() };
        let (scene, settings) = random_scenes::scene(seed);
        for (scene, settings) in [(scene, settings), (catalog::scenario("L2").unwrap(), Map::new())] {
            let Some(driven) = driven(&scene, &settings, &options) else { continue };
            let duration = driven.made.states.duration();
            assert!(duration <= driven.slow, "seed {seed}, {limits:?}: {duration} s, slow {} s", driven.slow);
        }
    }
}

#[test]
fn tight_scenes_are_driven_to_the_centimetre() {
    let mut count = 0;
    for (kind, draw) in tight_scenes::KINDS {
        for (seed, car) in [(4001, Vehicle::PAPER), (4002, Vehicle::SEDAN)] {
            let scene = draw(&car, seed).scenario();
            let Some(driven) = driven(&scene, &Map::new(), &Options::default()) else { continue };
            count += 1;
            assert!(driven.lateral < 0.01, "{kind} {seed}: {}", driven.lateral);
            let duration = driven.made.states.duration();
            assert!(duration <= driven.slow, "{kind} {seed}: {duration} s in place of {}", driven.slow);
        }
    }
    assert!(count >= 6, "{count} have a path");
}

#[test]
fn pulses_of_the_acceleration_are_rare() {
    for id in ["reverse-in", "L2", "perpendicular", "P2"] {
        let made = driven(&catalog::scenario(id).unwrap(), &Map::new(), &Options::default()).unwrap().made;
        let states = &made.states;
        let pieces = pieces(states);
        let pulses = pieces.windows(3).filter(|three| {
            let [before, pulse, after] = [three[0], three[1], three[2]];
            let is_apart = |other: (f64, f64)| (pulse.0 - other.0).abs() > 0.3;
            pulse.1 < 0.03 && is_apart(before) && is_apart(after) && (before.0 - after.0).abs() < 0.3
        });
        assert!(pulses.count() <= 4, "{id}: {pieces:?}");
    }
}

/// Accelerations and how many seconds each lasts.
fn pieces(states: &States) -> Vec<(f64, f64)> {
    let mut pieces: Vec<(f64, f64)> = Vec::new();
    for i in 1..states.t.len() {
        let lasts = states.t[i] - states.t[i - 1];
        let by = (states.speed[i].abs() - states.speed[i - 1].abs()) / lasts;
        match pieces.last_mut() {
            Some(last) if (last.0 - by).abs() < 0.02 => last.1 += lasts,
            _ => pieces.push((by, lasts)),
        }
    }
    pieces
}

#[test]
fn every_byte_is_the_same_everywhere() {
    let stored: Map<String, Value> =
        serde_json::from_str(include_str!("../data/trajectory-hashes.json")).unwrap();
    assert_eq!(stored.len(), built_in().count() - 1);
    for (id, hash) in stored {
        let made = driven(&catalog::scenario(&id).unwrap(), &Map::new(), &Options::default()).unwrap().made;
        assert_eq!(hash.as_str(), Some(made.states.hash().as_str()), "{id}");
    }
}

#[test]
fn options_out_of_range_are_named() {
    let scene = catalog::scenario("P0").unwrap();
    let wrong = |options: &Options| {
        parkade::plan::optimise(&scene, (&[0.0, 0.0, 0.0], None, None), options).unwrap_err().to_string()
    };
    let margin = Options { margin: -1.0, ..Options::default() };
    assert_eq!(wrong(&margin), "margin: must be between 0 and 10, got -1");
    let limits = MotionLimits { acceleration: 0.0, ..MotionLimits::default() };
    assert_eq!(
        wrong(&Options { limits, ..Options::default() }),
        "acceleration: must be between 0.01 and 100, got 0"
    );
    assert_eq!(wrong(&Options::default()), "plan.path: must pass its check, got \"collides\"");
}
