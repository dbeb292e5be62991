//! A planner used more than once: other ends, edits with a brush, the search alone. Every answer is that of a planner
//! made anew.

use std::ops::ControlFlow;

use parkade::error::ErrorCode;
use parkade::geometry::{Point, Pose};
use parkade::plan::{Ends, LayerData, Options, Outcome, Planner};
use parkade::planners::registry::{self, Info, planners};
use parkade::scenario::generate::{Family, SplitMix64, generate};
use parkade::scenario::{Goal, Obstacle, Scenario, catalog};
use serde_json::{Map, Value, json};

fn settings(value: &Value) -> Map<String, Value> {
    value.as_object().cloned().unwrap()
}

fn bytes(planner: &Planner, name: &str) -> Vec<u8> {
    match planner.layer(name, 1).unwrap().data {
        LayerData::Bytes(bytes) => bytes,
        LayerData::Floats(_) => panic!("{name} has bytes"),
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn other_ends_give_the_plan_of_another_scene() {
    let scene = catalog::scenario("reverse-in").unwrap();
    let start = Pose { x: scene.start.x - 0.7, ..scene.start };
    let goal = Pose { y: scene.start.y + 0.2, x: scene.start.x - 3.0, ..scene.start };
    let moved = Scenario { start, goal: Goal::Pose(goal), ..scene.clone() };
    for info in planners() {
        let mut session = Planner::new(info.id, &scene, &Map::new()).unwrap();
        let own = session.plan(Options::default()).hash();
        let ends = Ends { start: Some(start), goal: Some(goal) };
        let there = session.plan_between(ends, Options::default()).unwrap();
        let anew = Planner::new(info.id, &moved, &Map::new()).unwrap().plan(Options::default());
        assert_eq!((there.outcome, there.hash()), (Outcome::Found, anew.hash()), "{}", info.id);
        assert_eq!(session.plan(Options::default()).hash(), own, "{}", info.id);
        let nowhere = Ends { start: None, goal: Some(Pose { heading: f64::NAN, ..goal }) };
        let error = session.plan_between(nowhere, Options::default()).unwrap_err();
        assert_eq!((error.code, error.path.as_str()), (ErrorCode::Input, "goal.heading"));
    }
}

fn floats(planner: &Planner, name: &str, every: u32) -> (u32, u32, Vec<f32>) {
    let layer = planner.layer(name, every).unwrap();
    match layer.data {
        LayerData::Floats(floats) => (layer.width, layer.height, floats),
        LayerData::Bytes(_) => panic!("{name} has floats"),
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn rasters_and_explanations_are_between_the_last_ends() {
    let scene = catalog::scenario("random-60").unwrap();
    let Goal::Pose(goal) = scene.goal.clone() else { panic!("a pose") };
    let (start, goal) = (Pose { x: goal.x - 3.0, ..goal }, scene.start);
    let moved = Scenario { start, goal: Goal::Pose(goal), ..scene.clone() };
    let closing = settings(&json!({ "minPassage": 2, "trapMouth": 5 }));
    let ends = Ends { start: Some(start), goal: Some(goal) };
    let mut session = Planner::new("risk-field", &scene, &closing).unwrap();
    let mut anew = Planner::new("risk-field", &moved, &closing).unwrap();
    let at = scene.start.point();
    let all = |planner: &Planner| {
        (
            floats(planner, "risk", 1),
            bytes(planner, "redundant"),
            planner.any_angle_length(),
            json!(planner.explain(at.x, at.y).unwrap()),
        )
    };
    session.plan(Options::default());
    let own = all(&session);
    session.plan_between(ends, Options::default()).unwrap();
    anew.plan(Options::default());
    assert!(all(&session) == all(&anew));
    assert!(all(&session).0 != own.0);
    session.plan(Options::default());
    assert!(all(&session) == own);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_sampled_field_has_the_values_of_the_whole() {
    let planner = Planner::new("risk-field", &catalog::scenario("random-60").unwrap(), &Map::new()).unwrap();
    let (width, height, whole) = floats(&planner, "risk", 1);
    for every in [2, 3, 7, 64, 1000] {
        let (columns, rows, some) = floats(&planner, "risk", every);
        assert_eq!((columns, rows), (width / every, height / every));
        let cells = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
        let middle = |i: u32| i * every + every / 2;
        let same: Vec<f32> = cells
            .map(|(x, y)| 2 * (middle(y) * width + middle(x)) as usize)
            .flat_map(|i| [whole[i], whole[i + 1]])
            .collect();
        assert_eq!(some, same, "every {every}");
    }
    let error = planner.layer("risk", 0).unwrap_err();
    assert_eq!((error.code, error.path.as_str()), (ErrorCode::Input, "every"));
    assert_eq!(planner.layer("clearance", 2).unwrap_err().path, "every");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_search_alone_finds_the_raw_path() {
    let scene = catalog::scenario("trap-60").unwrap();
    for info in planners() {
        let mut session = Planner::new(info.id, &scene, &Map::new()).unwrap();
        let (start, Goal::Pose(goal)) = (scene.start, scene.goal.clone()) else { panic!("a pose") };
        let route = session.search(start.point(), goal.point());
        if info.family != registry::Family::Grid {
            assert_eq!(route.unwrap_err().code, ErrorCode::Input);
            continue;
        }
        let shortest = session.any_angle_length().unwrap();
        let (route, plan) = (route.unwrap(), session.plan(Options::default()));
        assert!(plan.metrics.grid.as_ref().unwrap().length_dp * scene.map.resolution >= 0.998 * shortest);
        assert_eq!((route.outcome, route.path), (plan.outcome, plan.raw_path), "{}", info.id);
        assert_eq!(Some(route.cost_micro), plan.stats.cost_micro);
        assert_eq!((route.expanded, route.generated), (plan.stats.expanded, plan.stats.generated));
        let error = session.search(Point::new(0.0, f64::INFINITY), goal.point()).unwrap_err();
        assert_eq!(error.path, "start.y");
        let off = session.search(Point::new(-1e3, 0.0), goal.point()).unwrap();
        assert_eq!((off.outcome, off.path.len()), (Outcome::StartOutside, 0));
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_brushed_map_is_as_if_made_anew() {
    let mut random = SplitMix64::new(60);
    let wide = json!({ "inflation": "width", "margin": 0.35 });
    let closing = json!({ "minPassage": 2, "trapMouth": 5 });
    let kinds = [
        ("eight", json!({})),
        ("eight", wide.clone()),
        ("jump-point", json!({})),
        ("jump-point", wide),
        ("jump-point", closing),
        ("risk-field", json!({})),
        ("hybrid", json!({})),
    ];
    for (id, config) in kinds {
        // One scene with a brush, one without: walls and parked cars stay under the eraser.
        for scene in ["random-60", "perpendicular"] {
            let mut scene = catalog::scenario(scene).unwrap();
            let mut session = Planner::new(id, &scene, &settings(&config)).unwrap();
            let (width, height) = (scene.map.width, scene.map.height);
            for round in 0..6 {
                let (x, y) = (random.below(width - 3), random.below(height - 2));
                let runs = [[x, y, 3], [x, y + 1, 2]];
                let blocked = round % 3 != 2;
                session.brush(&runs, blocked).unwrap();
                edit(&mut scene, &runs, blocked);
            }
            let mut anew = Planner::new(id, &scene, &settings(&config)).unwrap();
            assert_eq!(bytes(&session, "occupancy"), bytes(&anew, "occupancy"), "{id}");
            if id == "jump-point" {
                let ends = [scene.start.point(), Point::new(scene.start.x + 9.0, scene.start.y)];
                let [one, two] = [&mut session, &mut anew].map(|p| p.search(ends[0], ends[1]).unwrap().path);
                assert_eq!(one, two);
                assert_eq!(bytes(&session, "redundant"), bytes(&anew, "redundant"));
            }
            let [one, two] = [&mut session, &mut anew].map(|planner| planner.plan(Options::default()));
            assert_eq!(one.hash(), two.hash(), "{id} {config}");
        }
    }
    let scene = catalog::scenario("random-60").unwrap();
    let mut session = Planner::new("eight", &scene, &Map::new()).unwrap();
    let error = session.brush(&[[0, 0, 1], [58, 0, 3]], true).unwrap_err();
    assert_eq!((error.code, error.path.as_str()), (ErrorCode::Input, "runs[1]"));
}

/// The same edit in the scene.
fn edit(scene: &mut Scenario, runs: &[[u32; 3]], blocked: bool) {
    use parkade::map::{Cell, Occupancy, raster};
    let mut covered = Occupancy::new(scene.map.width, scene.map.height);
    for obstacle in &scene.obstacles {
        if let Obstacle::Cells { runs, .. } = obstacle {
            raster::runs(&mut covered, runs);
        }
    }
    for &[x, y, count] in runs {
        (x..x + count).for_each(|x| covered.set(Cell::new(x as i32, y as i32), blocked));
    }
    scene.obstacles.retain(|o| !matches!(o, Obstacle::Cells { .. }));
    scene.obstacles.push(Obstacle::Cells { id: None, runs: raster::to_runs(&covered) });
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn redundant_space_is_closed_counted_and_drawn() {
    let scene = catalog::scenario("trap-60").unwrap();
    for id in
        ["four", "eight", "forty-eight", "sixteen-bidirectional", "jump-point", "any-angle", "risk-field"]
    {
        let config = settings(&json!({ "minPassage": 2, "trapMouth": 5, "post": "none" }));
        let mut session = Planner::new(id, &scene, &config).unwrap();
        let plan = session.plan(Options::default());
        let stats = &plan.stats;
        let closed = stats.narrow.unwrap() + stats.pocket.unwrap() - stats.restored.unwrap();
        let layer = bytes(&session, "redundant");
        assert_eq!(layer.iter().map(|&v| u32::from(v == 3)).sum::<u32>(), closed);
        assert!(closed > 0 && plan.outcome == Outcome::Found);
        // The path keeps out of closed cells.
        let index = |x: f64, y: f64| {
            let [x0, y0] = scene.map.origin;
            let cell = |v: f64, v0: f64| ((v - v0) / scene.map.resolution).floor() as usize;
            cell(y, y0) * scene.map.width as usize + cell(x, x0)
        };
        assert!(plan.raw_path.iter().all(|p| layer[index(p.x, p.y)] == 0), "{id}");
        // Switched off, nothing of it is said.
        let off = Planner::new(id, &scene, &Map::new()).unwrap().plan(Options::default());
        assert!(off.stats.narrow.is_none());
    }
    let config = settings(&json!({ "minPassage": 0 }));
    let error = Planner::new("eight", &scene, &config).err().unwrap();
    assert_eq!(error.to_string(), "minPassage: must be between 1 and 64, got 0");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_brush_reaches_the_corners_of_the_map() {
    let scene = catalog::scenario("random-60").unwrap();
    let last = [scene.map.width - 1, scene.map.height - 1];
    for info in planners() {
        let mut session = Planner::new(info.id, &scene, &Map::new()).unwrap();
        let before = session.plan(Options::default()).hash();
        for corner in [[0, 0, 1], [last[0], 0, 1], [0, last[1], 1], [last[0], last[1], 1]] {
            let was = bytes(&session, "occupancy")[(corner[1] * scene.map.width + corner[0]) as usize] != 0;
            session.brush(&[corner], !was).unwrap();
            session.plan(Options::default());
            session.brush(&[corner], was).unwrap();
        }
        assert_eq!(session.plan(Options::default()).hash(), before, "{}", info.id);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_map_too_large_for_a_car_is_refused_and_says_so() {
    let mut scene = catalog::scenario("perpendicular").unwrap();
    (scene.map.width, scene.map.height, scene.map.resolution) = (101, 101, 1000.0);
    let error = Planner::new("hybrid", &scene, &Map::new()).err().unwrap();
    assert_eq!((error.code, error.path.as_str()), (ErrorCode::Input, "map"));
    assert!(
        error.message().contains("at most 100000 m") && error.message().contains("got 101000 m"),
        "{error}"
    );
    (scene.map.width, scene.map.height) = (100, 100);
    assert!(Planner::new("hybrid", &scene, &Map::new()).is_ok());
}

/// A planner that takes long, and how often it tells: noise with a wall across it, where every cell that can be reached
/// is searched, or a tight slot.
fn slow(info: &Info) -> (Planner, u32) {
    let (scene, config, every) = if info.family == registry::Family::Hybrid {
        (catalog::scenario("par-8.0").unwrap(), settings(&json!({ "maxExpansions": 1500 })), 256)
    } else {
        let noise = Family::Random { density_permille: 330, block_min: 1, block_max: 1 };
        let mut scene = generate(noise, 480, 7).unwrap();
        edit(&mut scene, &(0..480).map(|y| [380, y, 1]).collect::<Vec<_>>(), true);
        // Those that know no end stop at a budget of their own.
        let own = match info.id {
            "rrt" | "genetic" => settings(&json!({ "maxExpansions": 40_000 })),
            _ => Map::new(),
        };
        (scene, own, 16_384)
    };
    (Planner::new(info.id, &scene, &config).unwrap(), every)
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn progress_is_told_at_fixed_counts_and_at_the_end_and_changes_nothing() {
    for info in planners() {
        let (mut planner, every) = slow(&info);
        let mut told = Vec::new();
        let mut tell = |expanded| {
            told.push(expanded);
            ControlFlow::Continue(())
        };
        let plan = planner.plan(Options { progress: Some(&mut tell), ..Options::default() });
        let expanded = plan.stats.expanded;
        assert_eq!(told.pop(), Some(expanded), "{}: the end", info.id);
        let times = told.len() as u32;
        assert!(told.into_iter().eq((1..=times).map(|k| k * every)), "{}", info.id);
        // None is told of the last node of all.
        assert!(
            times >= 2 && (times == expanded / every || times == (expanded - 1) / every),
            "{}: {times}",
            info.id
        );

        let mut left = 2;
        let mut stop = |_| {
            left -= 1;
            if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let stopped = planner.plan(Options { progress: Some(&mut stop), ..Options::default() });
        assert_eq!((stopped.stats.expanded, left), (2 * every, 0), "{}", info.id);
        // Hybrid A* may know a way before it is the best.
        let ended = if info.id == "hybrid" { Outcome::Found } else { Outcome::BudgetSpent };
        assert_eq!(stopped.outcome, ended, "{}", info.id);

        let silent = planner.plan(Options::default());
        assert_eq!((plan.hash(), expanded), (silent.hash(), silent.stats.expanded), "{}", info.id);
    }
}
