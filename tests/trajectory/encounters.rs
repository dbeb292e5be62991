//! Trajectories among moving boxes.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::drive::{Encounter, Ending, Mover, Route, Rule, Scope, WaitOptions};
use parkade::geometry::Pose;
use parkade::optimise::{Options, optimise, stop_wait_go};
use parkade::plan::Planner;
use parkade::referee::{MotionLimits, States, Submission, TimedRows, judge};
use parkade::scenario::resolve::Geometry;
use parkade::scenario::{MovingObstacle, catalog};

use crate::outlines::overlap;

const CONFLICTS: [&str; 4] = ["fig16-conflict", "fig16-oncoming", "fig16-fast", "fig16-low"];

struct Made {
    geometry: Geometry,
    states: States,
    movers: Vec<Mover>,
}

fn made(id: &str) -> Made {
    let scene = catalog::scenario(id).unwrap();
    let mut planner = Planner::new("hybrid", &scene, &serde_json::Map::new()).unwrap();
    let plan = planner.plan(parkade::plan::Options::default());
    let geometry = planner.geometry().clone();
    let route = Route::new(&geometry.vehicle, &plan.path, &plan.directions, Some(&plan.curvatures)).unwrap();
    let made = optimise(&geometry, &route, plan.metrics.min_clearance, &Options::default()).unwrap();
    let movers = scene.moving.iter().map(Mover::new).collect();
    Made { geometry, states: made.states, movers }
}

/// Drives, and holds what is promised of every encounter.
fn meet(made: &Made, movers: &[Mover], options: &WaitOptions) -> Encounter {
    let met = stop_wait_go(&made.geometry.vehicle, &made.states, movers, options).unwrap();
    let rows = &met.rows;
    let n = rows.t.len();
    assert!(rows.t.windows(2).all(|t| t[0] < t[1] && t[1] - t[0] < 0.0501));
    assert_eq!((met.clearances.len(), met.duration), (n, rows.t[n - 1]));
    // The seconds of the drive are those of its speeds.
    let mut driven = 0.0;
    for i in 1..n {
        driven += f64::midpoint(rows.speed[i].abs(), rows.speed[i - 1].abs()) * (rows.t[i] - rows.t[i - 1]);
        assert!((driven - rows.station[i]).abs() < 1e-6, "at {} s", rows.t[i]);
    }
    for k in 0..n {
        let body = made.geometry.vehicle.outline(rows.poses[k]).map(|p| [p.x, p.y]);
        let touched = movers.iter().any(|m| overlap(&body, &m.outline(rows.t[k]).map(|p| [p.x, p.y])));
        assert_eq!(touched, met.clearances[k] == 0.0, "at {} s", rows.t[k]);
        assert!(!touched || met.contact.is_some_and(|c| c.t <= rows.t[k]), "at {} s", rows.t[k]);
    }
    // The referee allows it as it allows the trajectory: the same path within the same limits.
    let columns = TimedRows {
        t: rows.t.clone(),
        poses: rows.poses.clone(),
        speed: Some(rows.speed.clone()),
        steering: Some(rows.steering.clone()),
    };
    let judged = judge(&made.geometry, &Submission::Timed(columns), &MotionLimits::default()).unwrap();
    assert!(judged.keeps_limits && judged.contacts.touching_frames == 0, "{judged:?}");
    assert!(judged.model_error.0 < 0.01, "{judged:?}");
    if matches!(met.ending, Ending::Arrived | Ending::Hit | Ending::Unavoidable) {
        assert!(judged.attained, "{judged:?}");
    }
    met
}

#[test]
fn without_boxes_it_is_the_trajectory() {
    let made = made("reverse-in");
    for rule in [Rule::Predictive, Rule::Reactive] {
        let met = meet(&made, &[], &WaitOptions { rule, ..WaitOptions::default() });
        assert_eq!((met.ending, met.waits.len(), met.contact), (Ending::Arrived, 0, None));
        assert!((met.duration - made.states.duration()).abs() < 1e-6);
        assert_eq!(met.rows.t.len(), made.states.t.len());
        let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-6;
        assert!(met.rows.speed.iter().zip(&made.states.speed).all(near));
    }
}

#[test]
fn a_conflict_is_waited_for_where_it_is_safe() {
    for id in CONFLICTS {
        let made = made(id);
        let met = meet(&made, &made.movers, &WaitOptions::default());
        assert_eq!((met.ending, met.contact), (Ending::Arrived, None), "{id}");
        assert_eq!(met.waits.len(), 1, "{id}: {:?}", met.waits);
        assert!(met.clearances.iter().all(|&c| c > 0.25), "{id}");
        assert!(met.duration > met.free_duration, "{id}");
        println!("{id}: {:?} {} {}", met.waits, met.duration, met.free_duration);
    }
}

#[test]
fn a_car_that_reacts_needs_a_stopping_distance_and_contact_is_told() {
    let mut touched = 0;
    for id in CONFLICTS {
        let made = made(id);
        for scope in [Scope::Remaining, Scope::Window] {
            let options = WaitOptions { rule: Rule::Reactive, scope, ..WaitOptions::default() };
            let met = meet(&made, &made.movers, &options);
            println!("{id} {scope:?}: {:?} {:?} {:?}", met.ending, met.waits, met.contact);
            assert_eq!(met.ending == Ending::Hit, met.contact.is_some(), "{id}");
            touched += u32::from(met.contact.is_some());
            // It does not stop again at once.
            assert!(met.waits.iter().all(|wait| wait.to - wait.from > 0.1), "{id}: {:?}", met.waits);
            for wait in &met.waits {
                // It comes to rest no sooner than a car can: speeds before the stop are those of a steady deceleration.
                let before = met.rows.t.iter().position(|&t| t >= wait.from - 0.5).unwrap();
                assert!(met.rows.speed[before] <= 1.001 * 0.55, "{id}");
            }
        }
    }
    assert!(touched > 0);
}

#[test]
fn what_parks_on_the_path_blocks_it_and_what_never_ends_runs_out_of_time() {
    let made = made("P0");
    let at = made.states.poses[made.states.t.len() * 2 / 3];
    let parks = |speed: f64| {
        let moving = MovingObstacle {
            id: None,
            points: vec![[at.x, at.y + 30.0], [at.x, at.y]],
            size: [2.0, 2.0],
            speed,
            start: 0.0,
        };
        vec![Mover::new(&moving)]
    };
    for rule in [Rule::Predictive, Rule::Reactive] {
        let options = WaitOptions { rule, ..WaitOptions::default() };
        let met = meet(&made, &parks(4.0), &options);
        assert_eq!(met.ending, Ending::Blocked, "{rule:?}: {:?}", met.contact);
        assert_eq!(met.rows.speed[met.rows.t.len() - 1], 0.0);
        let short = meet(&made, &parks(4.0), &WaitOptions { max_time: 3.0, ..options });
        assert_eq!(short.ending, Ending::OutOfTime);
        assert!(short.duration <= 3.0);
    }
}

#[test]
fn a_steady_speed_can_be_interrupted_too() {
    let made = made("P0");
    let mut states = States::default();
    for row in 0..=200 {
        let t = 0.05 * f64::from(row);
        states.push(t, Pose::new(t, 0.0, 0.0), 1.0, 0.0);
    }
    let cross = MovingObstacle {
        id: None,
        points: vec![[8.0, 12.0], [8.0, -30.0]],
        size: [2.0, 2.0],
        speed: 2.0,
        start: 0.0,
    };
    for rule in [Rule::Predictive, Rule::Reactive] {
        let options = WaitOptions { rule, max_time: 60.0, ..WaitOptions::default() };
        let car = &made.geometry.vehicle;
        let met = stop_wait_go(car, &states, &[Mover::new(&cross)], &options).unwrap();
        assert!(met.rows.t.len() < 2000 && met.duration <= 60.0, "{rule:?}: {:?}", met.ending);
    }
}
