//! The same numbers everywhere.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::drive::{Controller, Limits, Mover, Route, Rule, Steps, WaitOptions};
use parkade::geometry::Pose;
use parkade::scenario::catalog;
use serde_json::Value;

use super::following::follow;
use super::row::{CAR, ROWS, Row, drive, meet};

#[test]
fn every_byte_is_the_same_everywhere() {
    let vectors: Value = serde_json::from_str(include_str!("../data/drive-vectors.json")).unwrap();
    let stored = |id: &'static str| {
        let row = &vectors["rows"][id];
        let numbers = |name: &str| -> Vec<f64> {
            row[name].as_array().unwrap().iter().filter_map(Value::as_f64).collect()
        };
        let path: Vec<Pose> = numbers("path").chunks_exact(3).map(|p| Pose::new(p[0], p[1], p[2])).collect();
        let directions: Vec<i8> =
            numbers("directions").iter().map(|&d| if d < 0.0 { -1 } else { 1 }).collect();
        let route = Route::new(&CAR, &path, &directions, Some(&numbers("curvatures"))).unwrap();
        let geometry = catalog::scenario(id).unwrap().geometry().unwrap();
        Row { id, route, goal: geometry.goal, geometry }
    };
    for id in ROWS {
        let (row, wanted) = (stored(id), &vectors["rows"][id]);
        for (name, limits) in [
            ("limited", Limits::default()),
            ("jerk", Limits { jerk: Some(2.0), ..Limits::default() }),
            ("slow", Limits { steps: Steps::Slow, ..Limits::default() }),
            ("paper", Limits::paper()),
        ] {
            assert_eq!(wanted[name], drive(&row, &limits).rows.hash(), "{id} {name}");
        }
        assert_eq!(wanted["tracked"], follow(&row, &Limits::default(), Controller::Feedback).hash(), "{id}");
    }
    let row = stored("L0");
    for (id, wanted) in vectors["scenes"].as_object().unwrap() {
        let scene = catalog::scenario(id).unwrap();
        let movers: Vec<Mover> = scene.moving.iter().map(Mover::new).collect();
        for (name, rule) in [("predictive", Rule::Predictive), ("reactive", Rule::Reactive)] {
            let met = meet(&row, &movers, &WaitOptions { rule, ..WaitOptions::default() });
            let wanted = [&wanted[name]["ending"], &wanted[name]["hash"]];
            assert_eq!(wanted, [met.ending.as_str(), &met.rows.hash()], "{id} {name}");
        }
    }
}
