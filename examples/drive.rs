//! Prints how long the parking paper's rows take to drive, how well a simulated car follows them, and where it waits
//! for moving obstacles; and, as JSON, `tests/data/drive-vectors.json`.
//!
//! ```sh
//! cargo run --release --example drive > tests/data/drive-vectors.json
//! ```

use parkade::Error;
use parkade::drive::{
    Controller, Limits, Mover, Profile, Route, Rule, Steps, WaitOptions, stop_wait_go, track, trajectory,
};
use parkade::geometry::Pose;
use parkade::metrics::Body;
use parkade::plan::{Options, Plan, Planner};
use parkade::scenario::catalog;
use parkade::scenario::resolve::Geometry;
use serde_json::{Map, Value, json};

fn main() -> Result<(), Error> {
    let (mut rows, mut scenes) = (Map::new(), Map::new());
    let mut crossed = None;
    for info in catalog::scenes().filter(|s| s.group == "paper" || s.group == "moving") {
        let scene = catalog::scenario(info.id)?;
        let mut planner = Planner::new("hybrid", &scene, &Map::new())?;
        let plan = planner.plan(Options::default());
        let geometry = planner.geometry();
        let movers: Vec<Mover> = scene.moving.iter().map(Mover::new).collect();
        let route = Route::new(&geometry.vehicle, &plan.path, &plan.directions, Some(&plan.curvatures))?;
        if let Some(stored) = crossed.as_ref().filter(|_| !movers.is_empty()) {
            wait(info.id, geometry, &route, &movers)?;
            scenes.insert(info.id.to_owned(), wait("", geometry, stored, &movers)?);
        } else {
            figures(info.id, geometry, &route)?;
            let (path, stored) = coarse(geometry, &plan)?;
            rows.insert(info.id.to_owned(), vector(path, geometry, &stored)?);
            crossed = crossed.or((info.id == "L0").then_some(stored));
        }
    }
    println!("{:#}", json!({ "rows": rows, "scenes": scenes }));
    Ok(())
}

/// Every tenth pose, gear changes kept, in numbers that every reader of JSON reads alike.
fn coarse(geometry: &Geometry, plan: &Plan) -> Result<(Map<String, Value>, Route), Error> {
    let round = |v: f64| (v * 1e6).round() / 1e6;
    let last = plan.path.len() - 1;
    let step = |i: usize| {
        i > 0
            && (plan.directions[i] != plan.directions[i - 1] || plan.curvatures[i] != plan.curvatures[i - 1])
    };
    let kept: Vec<usize> = (0..=last).filter(|&i| i % 10 == 0 || i == last || step(i)).collect();
    let poses: Vec<Pose> = kept
        .iter()
        .map(|&i| plan.path[i])
        .map(|p| Pose::new(round(p.x), round(p.y), round(p.heading)))
        .collect();
    let directions: Vec<i8> = kept.iter().map(|&i| plan.directions[i]).collect();
    let curvatures: Vec<f64> = kept.iter().map(|&i| round(plan.curvatures[i])).collect();
    let route = Route::new(&geometry.vehicle, &poses, &directions, Some(&curvatures))?;
    let path: Vec<f64> = poses.iter().flat_map(|p| [p.x, p.y, p.heading]).collect();
    let row = [("path", json!(path)), ("directions", json!(directions)), ("curvatures", json!(curvatures))];
    Ok((row.map(|(name, value)| (name.to_owned(), value)).into_iter().collect(), route))
}

fn kinds() -> [(&'static str, Limits); 4] {
    [
        ("limited", Limits::default()),
        ("jerk", Limits { jerk: Some(2.0), ..Limits::default() }),
        ("slow", Limits { steps: Steps::Slow, ..Limits::default() }),
        ("paper", Limits::paper()),
    ]
}

fn vector(mut row: Map<String, Value>, geometry: &Geometry, route: &Route) -> Result<Value, Error> {
    for (name, limits) in kinds() {
        row.insert(name.to_owned(), trajectory(&geometry.vehicle, route, &limits)?.rows.hash().into());
    }
    let (body, limits) = (Body::new(geometry), Limits::default());
    let tracked = track(&geometry.vehicle, &body, route, &limits, Controller::Feedback)?;
    row.insert("tracked".to_owned(), tracked.hash().into());
    Ok(row.into())
}

fn figures(id: &str, geometry: &Geometry, route: &Route) -> Result<(), Error> {
    let (car, body) = (&geometry.vehicle, Body::new(geometry));
    for (name, limits) in kinds() {
        let driven = trajectory(car, route, &limits)?;
        eprintln!(
            "{id} {name}: {:.2} s, of which {:.2} turning the wheel at standstill",
            driven.duration, driven.dwell
        );
    }
    for controller in [Controller::Feedback, Controller::PurePursuit, Controller::Stanley] {
        for speed in [2.0, 1.0, 0.5] {
            let limits = Limits { speed, profile: Profile::Constant, ..Limits::default() };
            let got = track(car, &body, route, &limits, controller)?;
            let verdict = if got.passes() { "" } else { ", FAILS" };
            eprintln!(
                "{id} {controller:?} at {speed} m/s: {:.3} m, {:.3} rad; at the end {:.3} m, {:.3} rad{verdict}",
                got.max_lateral, got.max_heading, got.end_distance, got.end_heading
            );
        }
    }
    Ok(())
}

/// How both rules do; printed where there is a name.
fn wait(id: &str, geometry: &Geometry, route: &Route, movers: &[Mover]) -> Result<Value, Error> {
    let mut rules = Map::new();
    for (name, rule) in [("predictive", Rule::Predictive), ("reactive", Rule::Reactive)] {
        let options = WaitOptions { rule, ..WaitOptions::default() };
        let met = stop_wait_go(&geometry.vehicle, route, movers, &options)?;
        let ending = met.ending.as_str();
        if !id.is_empty() {
            eprintln!(
                "{id} {name}: {ending} after {:.2} s instead of {:.2}",
                met.duration, met.free_duration
            );
            for wait in &met.waits {
                eprintln!(
                    "    waits at ({:.1}, {:.1}), {:.2} to {:.2} s",
                    wait.pose.x, wait.pose.y, wait.from, wait.to
                );
            }
            if let Some(contact) = &met.contact {
                eprintln!("    touched at {:.2} s, standing: {}", contact.t, contact.standing);
            }
        }
        rules.insert(name.to_owned(), json!({ "ending": ending, "hash": met.rows.hash() }));
    }
    Ok(rules.into())
}
