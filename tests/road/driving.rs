//! Speeds, following, and a ship.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::drive::{Controller, Limits, Route, track, trajectory};
use parkade::geometry::Pose;
use parkade::metrics::{Body, Verdict};
use parkade::plan::{Options, Outcome, Planner};
use parkade::scenario::{Scenario, catalog};
use serde_json::json;

use super::{IDS, planned};

#[test]
fn speeds_keep_to_limits_and_a_car_can_follow() {
    for id in IDS {
        let scene = catalog::scenario(id).unwrap();
        let geometry = scene.geometry().unwrap();
        let plan = planned(id, &json!({}));
        let route =
            Route::new(&geometry.vehicle, &plan.path, &plan.directions, Some(&plan.curvatures)).unwrap();
        let free = trajectory(&geometry.vehicle, &route, &Limits::road()).unwrap();
        let route = route.with_speed_limits(&scene.speed_limits);
        let driven = trajectory(&geometry.vehicle, &route, &Limits::road()).unwrap();
        println!("{id}: {:.1} s, without limits {:.1} s", driven.duration, free.duration);
        assert!(driven.max_lateral_acceleration <= 2.0 + 1e-6, "{id}: {}", driven.max_lateral_acceleration);
        let rows = &driven.rows;
        let ends = (rows.speed[0], rows.speed[rows.speed.len() - 1]);
        assert!(ends.0 == 0.0 && ends.1.abs() < 1e-6, "{id}: {ends:?}");
        for i in 0..rows.t.len() {
            assert!(
                (-2.0 - 1e-9..=1.5 + 1e-9).contains(&rows.acceleration[i]) && rows.speed[i] <= 10.0 + 1e-9
            );
            // The crosswalks, a sample in.
            let Pose { x, y, .. } = rows.poses[i];
            let on = |across: f64, along: f64| across.abs() < 7.5 && (along + 17.0).abs() < 1.2;
            if id == "road-crossing" && (on(x, y) || on(y, x)) {
                assert!(rows.speed[i] <= 5.56 + 1e-9, "{:?}: {}", rows.poses[i], rows.speed[i]);
            }
        }
        assert!(driven.duration > driven.length / 10.0 && driven.duration >= free.duration - 1e-9);
        for i in 1..rows.t.len() {
            let jerk = (rows.acceleration[i] - rows.acceleration[i - 1]) / (rows.t[i] - rows.t[i - 1]);
            assert!(jerk.abs() <= 2.0 + 1e-4, "{id}: {jerk} at {}", rows.t[i]);
        }
        // What the jerk's limit costs.
        let hasty = trajectory(&geometry.vehicle, &route, &Limits { jerk: None, ..Limits::road() }).unwrap();
        println!("{id}: {:.1} s without a limit of jerk", hasty.duration);
        assert!(driven.duration >= hasty.duration && driven.duration <= 1.1 * hasty.duration, "{id}");
        let body = Body::new(&geometry);
        for controller in [Controller::Stanley, Controller::Feedback] {
            let got = track(&geometry.vehicle, &body, &route, &Limits::road(), controller).unwrap();
            println!("{id}: {controller:?} followed within {:.3} m", got.max_lateral);
            assert!(got.max_lateral <= 0.25 && got.hit.is_none(), "{id} {controller:?}: {}", got.max_lateral);
        }
    }
}

#[test]
fn a_drive_begins_and_ends_as_fast_as_asked() {
    let scene = catalog::scenario("road-crossing").unwrap();
    let vehicle = scene.geometry().unwrap().vehicle;
    let plan = planned("road-crossing", &json!({}));
    let route = Route::new(&vehicle, &plan.path, &plan.directions, Some(&plan.curvatures)).unwrap();
    let route = route.with_speed_limits(&scene.speed_limits);
    for jerk in [None, Some(2.0)] {
        let with = |start_speed, goal_speed| {
            trajectory(&vehicle, &route, &Limits { jerk, start_speed, goal_speed, ..Limits::road() })
        };
        let driven = with(8.0, 5.0).unwrap();
        let speeds = &driven.rows.speed;
        assert!((speeds[0] - 8.0).abs() < 1e-9 && (speeds[speeds.len() - 1] - 5.0).abs() < 1e-6);
        assert!(driven.duration < with(0.0, 0.0).unwrap().duration);
        assert_eq!(with(11.0, 0.0).unwrap_err().path, "startSpeed");
        assert_eq!(with(0.0, 11.0).unwrap_err().path, "goalSpeed");
        assert_eq!(with(-1.0, 0.0).unwrap_err().path, "startSpeed");
    }
}

#[test]
fn a_ship_keeps_its_distance_in_a_channel() {
    // The manuscript's appendix B: cells of 5 m, 17 m of safety from the ship's middle.
    let block = |x: f64, y: f64| json!({ "type": "rectangle", "center": [x, y], "size": [60.0, 40.0] });
    let scene = Scenario::from_json(&json!({
        "version": 1,
        "map": { "origin": [0.0, 0.0], "width": 400, "height": 60, "resolution": 5.0,
            "boundary": [[0, 20], [2000, 20], [2000, 280], [0, 280]] },
        "lanes": [{ "start": { "x": 0, "y": 150, "heading": 0 }, "pieces": [{ "length": 2000 }], "width": 200 }],
        "obstacles": [block(600.0, 130.0), block(1300.0, 170.0)],
        "vehicle": "ship",
        "start": { "x": 102.5, "y": 152.5, "heading": 0 },
        "goal": { "x": 1800.0, "y": 152.5, "heading": 0 },
    }))
    .unwrap();
    for (margin, least) in [(0.0, 0.0), (9.0, 9.0)] {
        let settings = json!({ "margin": margin, "residual": 0.5 });
        let mut planner = Planner::new("cost-map", &scene, settings.as_object().unwrap()).unwrap();
        let plan = planner.plan(Options::default());
        assert_eq!(
            (plan.outcome, plan.check.verdict),
            (Outcome::Found, Verdict::Ok),
            "{:?} {:?}",
            plan.reason,
            plan.detail
        );
        let figures = plan.metrics.road.unwrap().figures;
        assert!(figures.side_clearance_min >= least, "{figures:?}");
        assert!(figures.middle_curvature <= 1.0 / 144.0, "{figures:?}");
    }
}
