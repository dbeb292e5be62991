//! Cost-map A* on the road scenes.
#![cfg(feature = "complete")]

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::drive::{Controller, Limits, Route, track, trajectory};
use parkade::geometry::bspline::Spline;
use parkade::geometry::{Point, Pose, math};
use parkade::map::{Cell, Frame};
use parkade::metrics::{Body, Verdict, risk};
use parkade::plan::{
    Ends, LayerData, Options, Outcome, Plan, PlanTrace, Planner, collision_risk, road_figures,
};
use parkade::planners::cost_map::{
    Base, Config, Costs, Ground, Pruning, Query, Report, Scratch, Smooth, Smoothing, Status, corners, plan,
    smooth,
};
use parkade::planners::registry::planners;
use parkade::scenario::{Scenario, catalog};
use serde_json::{Map, json};

const IDS: [&str; 4] = ["road-straight", "road-curve", "road-crossing", "road-narrow"];

struct Scene {
    scenario: Scenario,
    ground: Ground,
    start: Point,
    goal: Point,
}

impl Scene {
    fn new(id: &str) -> Self {
        Self::of(catalog::scenario(id).unwrap())
    }

    fn of(scenario: Scenario) -> Self {
        let geometry = scenario.geometry().unwrap();
        let map = &scenario.map;
        let [x, y] = map.origin;
        let frame = Frame {
            origin: Point::new(x, y),
            width: map.width,
            height: map.height,
            resolution: map.resolution,
        };
        let car = geometry.vehicle;
        let middle = |pose: Pose| pose.advance(0.0, (car.rear_to_front - car.rear_to_back) / 2.0).point();
        let (start, goal) = (middle(geometry.start), middle(geometry.goal));
        Self { ground: Ground::new(frame, &geometry, true), scenario, start, goal }
    }

    fn plan(&self, config: &Config) -> Report {
        config.validate().unwrap();
        let query = Query {
            ground: &self.ground,
            lanes: &self.scenario.lanes,
            limits: &self.scenario.speed_limits,
            radius: 0.95,
            start: self.start,
            goal: self.goal,
        };
        plan(&query, config, &mut Scratch::default(), &mut None)
    }
}

fn length(cells: &[Cell]) -> f64 {
    let leg = |a: Cell, b: Cell| {
        let (dx, dy) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
        (dx * dx + dy * dy).sqrt()
    };
    cells.windows(2).map(|w| leg(w[0], w[1])).sum::<f64>() / 2.0
}

/// Neighbouring cells with room, no corner cut, from start to goal.
fn sound(scene: &Scene, report: &Report) {
    let ground = &scene.ground;
    assert_eq!(report.status, Status::Found);
    let room = |cell: Cell| ground.at(cell) >= 0.95;
    for pair in report.cells.windows(2) {
        let (dx, dy) = (pair[1].x - pair[0].x, pair[1].y - pair[0].y);
        assert!(dx.abs().max(dy.abs()) == 1 && room(pair[1]));
        assert!(room(pair[0].offset(dx, 0)) && room(pair[0].offset(0, dy)));
    }
    for line in [&report.cells, &report.pruned] {
        assert_eq!(line.first().copied(), ground.frame.cell_at(scene.start));
        assert_eq!(line.last().copied(), ground.frame.cell_at(scene.goal));
    }
}

#[test]
fn plain_paths_are_as_long_as_measured() {
    // Length and turning points; the latter depend on the order of equal cells, and on how far the map goes on.
    let measured = [(1000.0, 2), (816.7, 315), (720.8, 29), (506.6, 21)];
    for (id, (metres, turns)) in IDS.into_iter().zip(measured) {
        let scene = Scene::new(id);
        let report = scene.plan(&Config::plain());
        sound(&scene, &report);
        assert!((length(&report.cells) - metres).abs() <= 0.3, "{id}: {}", length(&report.cells));
        let got = corners(&report.cells).len() as i32;
        assert!((got - turns).abs() <= turns / 14 + 1, "{id}: {got}");
        assert!((report.cost - length(&report.cells)).abs() < 1e-6);
    }
}

#[test]
fn pruning_leaves_the_promised_turning_points() {
    for (id, most) in IDS.into_iter().zip([2, 13, 10, 10]) {
        let scene = Scene::new(id);
        let plain = scene.plan(&Config::plain());
        for base in [Base::Inverse, Base::Exponential] {
            let report = scene.plan(&Config { base, ..Config::default() });
            sound(&scene, &report);
            let (turns, before) = (corners(&report.pruned).len(), corners(&plain.cells).len());
            assert!(turns <= most, "{id} {base:?}: {turns}");
            // −55 % on the curve and at the crossing; on the narrow road ten is the least.
            let share = turns as f64 / before as f64;
            assert!(share <= 0.48 || id == "road-straight", "{id}: {turns} of {before}");
            assert!(length(&report.pruned) <= length(&plain.cells) + 1e-9, "{id}");
        }
    }
}

#[test]
fn chords_keep_their_distance() {
    for id in IDS {
        let scene = Scene::new(id);
        for (pruning, least) in [(Pruning::Auto, 0.95), (Pruning::Los, 0.1)] {
            let report = scene.plan(&Config { pruning, ..Config::default() });
            for pair in report.pruned.windows(2) {
                let steps = 4 * (pair[1].x - pair[0].x).abs().max((pair[1].y - pair[0].y).abs());
                for k in 0..=steps {
                    let share = f64::from(k) / f64::from(steps.max(1));
                    let at = |a: i32, b: i32| (f64::from(a) + f64::from(b - a) * share).round() as i32;
                    let cell = Cell::new(at(pair[0].x, pair[1].x), at(pair[0].y, pair[1].y));
                    // A sampled line may leave Bresenham's by one cell.
                    assert!(scene.ground.at(cell) >= least - 0.5, "{id}: {cell:?}");
                }
            }
        }
        let (auto, los) = (
            scene.plan(&Config::default()),
            scene.plan(&Config { pruning: Pruning::Los, ..Config::default() }),
        );
        assert!(corners(&los.pruned).len() <= corners(&auto.pruned).len(), "{id}");
        let none = scene.plan(&Config { pruning: Pruning::None, ..Config::default() });
        assert_eq!(none.pruned, none.cells);
    }
}

#[test]
fn the_manuscripts_factor_cancels() {
    for id in IDS {
        let scene = Scene::new(id);
        let lengths = [500.0, 3000.0, 5000.0, 8000.0].map(|factor| {
            let report = scene.plan(&Config { paper_factor: factor, ..Config::paper() });
            // The estimate tells nothing: nearly all cells with room are expanded, run-outs aside.
            assert!(f64::from(report.expanded) >= 0.98 * f64::from(report.free), "{id}");
            length(&report.cells)
        });
        assert!(lengths.iter().all(|l| (l - lengths[0]).abs() <= 0.01), "{id}: {lengths:?}");
    }
}

#[test]
fn clearance_is_to_the_border_of_what_is_no_road() {
    let scene = Scene::new("road-narrow");
    let at = |x: f64, y: f64| scene.ground.at(scene.ground.frame.cell_at(Point::new(x, y)).unwrap());
    let kerb = |x: f64, y: f64| {
        let ground = &scene.ground;
        f64::from(ground.kerb[ground.frame.index(ground.frame.cell_at(Point::new(x, y)).unwrap())])
    };
    assert_eq!((at(10.25, 3.25), at(10.25, 0.25), at(10.25, -0.25)), (3.25, 0.25, 0.0));
    // Beside the first obstacle, 3 m high: the gap's middle; inside it; its kerb.
    assert_eq!((at(45.25, 4.75), at(45.25, 2.75), kerb(45.25, 2.75)), (1.75, 0.0, 2.75));
    // A road goes on where the map ends.
    assert_eq!(at(-4.75, 3.25), 3.25);
}

#[test]
fn starts_without_room_are_moved_and_said() {
    let mut scene = Scene::new("road-narrow");
    scene.start = Point::new(10.25, 0.25);
    let report = scene.plan(&Config::default());
    assert_eq!((report.status, report.moved), (Status::Found, [1.0, 0.0]));
    scene.start = Point::new(10.25, -0.75);
    assert_eq!(scene.plan(&Config::default()).status, Status::StartBlocked);
    scene.start = Point::new(10.25, 3.25);
    scene.goal = Point::new(45.25, 1.0);
    assert_eq!(scene.plan(&Config::default()).status, Status::GoalBlocked);
    scene.goal = Point::new(900.0, 3.25);
    assert_eq!(scene.plan(&Config::default()).status, Status::GoalBlocked);
    scene.goal = scene.start;
    let still = scene.plan(&Config::default());
    assert_eq!((still.status, still.cells.len(), still.pruned.len(), still.cost), (Status::Found, 1, 1, 0.0));
    let short = Config { max_expansions: 3, ..Config::default() };
    scene.goal = Point::new(100.0, 3.25);
    assert_eq!(scene.plan(&short).status, Status::BudgetSpent);
}

#[test]
fn a_closed_road_has_no_path() {
    let mut scenario = catalog::scenario("road-straight").unwrap();
    let barrier = json!({ "type": "rectangle", "center": [500.0, 1.75], "size": [1.0, 2.0] });
    let mut value = json!(scenario);
    value["obstacles"] = json!([barrier]);
    scenario = Scenario::from_json(&value).unwrap();
    let scene = Scene::of(scenario);
    assert_eq!(scene.plan(&Config::default()).status, Status::NoPath);
}

#[test]
fn the_search_is_the_same_everywhere() {
    let expected = [6027, 15975, 25220, 8397];
    for (id, expanded) in IDS.into_iter().zip(expected) {
        let scene = Scene::new(id);
        let report = scene.plan(&Config::default());
        let again = scene.plan(&Config::default());
        assert_eq!((report.expanded, &report.cells), (expanded, &again.cells), "{id}");
    }
}

#[test]
fn lanes_kerbs_and_limits_are_felt() {
    let scene = Scene::new("road-crossing");
    let cost = |change: &dyn Fn(&mut Config)| {
        let mut config =
            Config { lane_weight: 0.0, kerb_weight: 0.0, speed_weight: 0.0, ..Config::default() };
        change(&mut config);
        scene.plan(&config).cost
    };
    let bare = cost(&|_| {});
    assert!(cost(&|c| c.lane_weight = 1.0) > bare + 1.0);
    assert!(cost(&|c| c.kerb_weight = 1.0) > bare);
    // Two crossings of 3 m at 5.56 instead of 10 m/s, and a bend of 14.25 m.
    assert!(cost(&|c| c.speed_weight = 1.0) > bare + 2.0 * 3.0 * 0.79);
}

#[test]
fn wrong_settings_are_named() {
    let with = |fields: serde_json::Value| {
        Config::default().with(fields.as_object().unwrap()).and_then(|c| c.validate())
    };
    for (fields, path) in [
        (json!({ "factor": 5000 }), "factor"),
        (json!({ "epsilon": 0 }), "epsilon"),
        (json!({ "amplitude": 0 }), "amplitude"),
        (json!({ "decay": 9 }), "decay"),
        (json!({ "paperFactor": 5 }), "paperFactor"),
        (json!({ "paperEpsilon": 0 }), "paperEpsilon"),
        (json!({ "paperAmplitude": 1 }), "paperAmplitude"),
        (json!({ "paperDecay": 1 }), "paperDecay"),
        (json!({ "smoothing": "round" }), "smoothing"),
        (json!({ "residual": 0 }), "residual"),
        (json!({ "smoothPoints": 49 }), "smoothPoints"),
        (json!({ "laneWeight": 4 }), "laneWeight"),
        (json!({ "kerbWeight": -1 }), "kerbWeight"),
        (json!({ "speedWeight": "x" }), "speedWeight"),
        (json!({ "margin": -1 }), "margin"),
        (json!({ "pruneShare": 0.1 }), "pruneShare"),
        (json!({ "pruneCap": 2 }), "pruneCap"),
        (json!({ "costs": "none" }), "costs"),
        (json!({ "maxExpansions": 0 }), "maxExpansions"),
    ] {
        assert_eq!(with(fields).unwrap_err().path, path);
    }
    assert!(with(json!({ "costs": "paper" })).is_ok());
    assert_eq!(Config::plain().costs, Costs::Steps);
}

/// The car's rear axle at points of its middle.
fn poses(points: &[Point]) -> Vec<Pose> {
    let heading = |i: usize| {
        let (a, b) = (points[i.saturating_sub(1)], points[(i + 1).min(points.len() - 1)]);
        math::atan2(b.y - a.y, b.x - a.x)
    };
    let pose = |(i, p): (usize, &Point)| Pose::new(p.x, p.y, heading(i)).advance(0.0, -1.4);
    points.iter().enumerate().map(pose).collect()
}

const SMOOTHING: Smoothing = Smoothing { sigma: 0.12, places: 100, max_curvature: 1.0 / 5.5, radius: 0.95 };

impl Scene {
    fn curve(&self, report: &Report, how: &Smoothing) -> (Smooth, Body) {
        let body = Body::new(&self.scenario.geometry().unwrap());
        let line: Vec<Point> = report.pruned.iter().map(|&c| self.ground.frame.center(c)).collect();
        let free = |spline: &Spline| {
            let points: Vec<Point> = (0..=4000).map(|k| spline.at(f64::from(k) / 4000.0).point).collect();
            poses(&points).iter().all(|&p| body.hit(p).is_none())
        };
        (smooth(&self.ground, &line, how, free), body)
    }
}

#[test]
fn curves_keep_their_distance_and_bend_little() {
    // Length, mean (of at most 1.2 m) and least distance of the body, largest curvature and sum of its changes.
    let measured = [
        (1000.0, 0.80, 0.80, 0.0, 0.0),
        (796.4, 1.16, 0.62, 0.182, 0.28),
        (715.2, 1.13, 0.68, 0.129, 0.52),
        (500.6, 1.07, 0.55, 0.182, 0.19),
    ];
    for (id, (metres, mean, least, bend, changes)) in IDS.into_iter().zip(measured) {
        let scene = Scene::new(id);
        let report = scene.plan(&Config::default());
        let (curve, body) = scene.curve(&report, &SMOOTHING);
        assert!(!curve.fell_back, "{id}");
        let length: f64 = curve.points.windows(2).map(|w| (w[1] - w[0]).norm()).sum();
        assert!((length - metres).abs() <= 0.3, "{id}: {length}");
        let rooms: Vec<f64> = poses(&curve.points).iter().map(|&p| body.clearance(p)).collect();
        // Without 5 m at the ends.
        let inner = &rooms[10..rooms.len() - 10];
        let got_mean = inner.iter().map(|r| r.min(1.2)).sum::<f64>() / inner.len() as f64;
        let got_least = inner.iter().fold(f64::INFINITY, |a: f64, &b| a.min(b));
        assert!(got_mean >= mean - 0.02 && got_mean >= 0.79, "{id}: {got_mean}");
        assert!(got_least >= least - 0.02 && got_least >= 0.5, "{id}: {got_least}");
        let got_bend = curve.curvatures.iter().fold(0.0_f64, |m, k| m.max(k.abs()));
        assert!(got_bend <= bend + 0.01 && got_bend <= SMOOTHING.max_curvature, "{id}: {got_bend}");
        let got_changes: f64 = curve.curvatures.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
        assert!(got_changes <= changes + 0.08, "{id}: {got_changes}");
        println!(
            "{id}: {length:.1} m, body {got_mean:.2} / {got_least:.2} m, {got_bend:.3} 1/m, {got_changes:.2}"
        );
        let ends = [curve.points[0], curve.points[curve.points.len() - 1]];
        assert!((ends[0] - scene.start).norm() < 0.36 && (ends[1] - scene.goal).norm() < 0.36, "{id}");
    }
}

#[test]
fn where_no_curve_is_good_the_chords_stay() {
    let scene = Scene::new("road-narrow");
    let report = scene.plan(&Config::default());
    let (straight, _) = scene.curve(&report, &Smoothing { max_curvature: 1e-6, ..SMOOTHING });
    assert!(straight.fell_back && straight.curvatures.is_empty());
    let corners = report.pruned.iter().map(|&c| scene.ground.frame.center(c));
    for corner in corners {
        assert!(straight.points.iter().any(|p| (p - corner).norm() < 1e-9));
    }
}

fn planned(id: &str, settings: &serde_json::Value) -> Plan {
    let scene = catalog::scenario(id).unwrap();
    Planner::new("cost-map", &scene, settings.as_object().unwrap()).unwrap().plan(Options::default())
}

/// Plain A*: the shortest cells, as they are.
fn plain() -> serde_json::Value {
    json!({ "costs": "steps", "pruning": "none", "smoothing": "none" })
}

#[test]
fn plans_keep_what_the_table_promises() {
    // Turning points, least and mean distance of the body, curvature's changes over those of plain A*.
    let promised = [(2, 0.79, 0.79), (136, 0.5, 0.8), (13, 0.5, 0.8), (11, 0.5, 0.8)];
    for (id, (turns, least, mean)) in IDS.into_iter().zip(promised) {
        let before = planned(id, &plain());
        let old = before.metrics.road.unwrap();
        for base in ["inverse", "exponential"] {
            let after = planned(id, &json!({ "base": base }));
            let new = after.metrics.road.unwrap();
            assert_eq!(
                (after.outcome, after.detail, after.check.verdict),
                (Outcome::Found, None, Verdict::Ok)
            );
            assert!(new.turns_pruned <= turns, "{id}: {} turning points", new.turns_pruned);
            let (old, new) = (old.figures, new.figures);
            assert!(new.middle_length <= old.middle_length + 1e-6, "{id}: {new:?}");
            assert!(new.body_clearance_min >= least && new.body_clearance_mean >= mean, "{id}: {new:?}");
            assert!(new.curvature_variation <= 0.25 * old.curvature_variation + 1e-9, "{id}: {new:?}");
            assert!(new.middle_curvature <= 1.0 / 5.5, "{id}: {new:?}");
            assert!(after.metrics.max_curvature.unwrap() <= 1.0 / 5.5, "{id}");
            assert!(new.lane_deviation_mean.unwrap() <= 1.6, "{id}: {new:?}");
        }
    }
}

#[test]
fn plain_cells_and_the_manuscripts_curves_fail_as_measured() {
    for (id, overlap) in [("road-curve", -0.3), ("road-crossing", -0.4), ("road-narrow", 0.0)] {
        let cells = planned(id, &plain());
        assert_eq!(cells.check.verdict, Verdict::Collides, "{id}");
        assert!(cells.metrics.road.unwrap().figures.body_clearance_min < overlap, "{id}");
        assert_eq!(cells.metrics.max_curvature, None);
    }
    // A metre of deviation leaves the road, cuts the corner, drives straight through.
    let paper = json!({ "costs": "paper", "pruning": "los", "smoothing": "paper" });
    for (id, depth) in [("road-curve", -8.0), ("road-crossing", -4.0), ("road-narrow", -0.7)] {
        let curve = planned(id, &paper);
        assert_eq!(curve.check.verdict, Verdict::Collides, "{id}");
        assert!(curve.metrics.road.unwrap().figures.body_clearance_min < depth, "{id}");
    }
    // Two points are padded to four.
    assert_eq!(planned("road-straight", &paper).check.verdict, Verdict::Ok);
}

#[test]
fn memory_is_told() {
    for (id, most) in IDS.into_iter().zip([24.0, 16.0, 16.0, 33.0]) {
        let map = catalog::scenario(id).unwrap().map;
        let bytes = planned(id, &json!({})).metrics.road.unwrap().bytes as f64;
        let share = bytes / f64::from(map.width * map.height);
        assert!(share <= most, "{id}: {share:.1} bytes a cell");
    }
}

#[test]
fn the_cost_map_can_be_drawn() {
    let scene = catalog::scenario("road-narrow").unwrap();
    let planner = Planner::new("cost-map", &scene, &Map::new()).unwrap();
    let layer = planner.layer("cost").unwrap();
    let LayerData::Floats(costs) = layer.data else { panic!("bytes") };
    let at = |x: f64, y: f64| {
        let [x0, y0] = scene.map.origin;
        let (column, row) = (((x - x0) / 0.5) as u32, ((y - y0) / 0.5) as u32);
        costs[(row * layer.width + column) as usize]
    };
    assert_eq!((at(10.25, 0.25), at(45.25, 2.75)), (f32::INFINITY, f32::INFINITY));
    // 2.3 m beside the body in the road's middle: 0.8/(2.3 + 0.2).
    assert!((at(10.25, 3.25) - 0.32).abs() < 1e-6, "{}", at(10.25, 3.25));
    assert!(at(10.25, 1.25) > 1.0);
    let error = Planner::new("eight", &scene, &Map::new()).unwrap().layer("cost").unwrap_err();
    assert_eq!(error.message, "eight has no cost map; cost-map has");
}

#[test]
fn any_scene_is_answered_and_every_setting_is_checked() {
    for info in catalog::scenes().filter(|s| s.group != "road") {
        let scene = catalog::scenario(info.id).unwrap();
        let mut planner = Planner::new("cost-map", &scene, &Map::new()).unwrap();
        let plan = planner.plan(Options { trace: true });
        assert_eq!(plan.outcome == Outcome::Found, !plan.path.is_empty(), "{}", info.id);
        assert_eq!(plan.outcome == Outcome::Found, plan.reason.is_none(), "{}", info.id);
        let Some(PlanTrace::Cells { cells, .. }) = &plan.trace else { panic!("no trace") };
        assert_eq!(cells.len(), plan.stats.expanded as usize);
        assert!(cells.iter().all(|&c| c < scene.map.width * scene.map.height));
        // Without lanes the map's edge is a wall.
        let beside = plan.metrics.road.map_or(0.0, |road| road.figures.side_clearance_min);
        assert!(beside > -0.5, "{}: {beside}", info.id);
    }
    let scene = catalog::scenario("road-narrow").unwrap();
    let settings = json!({ "laneWeight": 9 });
    let error = Planner::new("cost-map", &scene, settings.as_object().unwrap()).err().unwrap();
    assert_eq!(error.to_string(), "laneWeight: must be between 0 and 3, got 9");
    let settings = json!({ "lane": 1 });
    let error = Planner::new("cost-map", &scene, settings.as_object().unwrap()).err().unwrap();
    assert_eq!(error.path, "lane");
}

#[test]
fn ends_and_edits_are_answered_in_words() {
    let scene = catalog::scenario("road-narrow").unwrap();
    let mut planner = Planner::new("cost-map", &scene, &Map::new()).unwrap();
    let mut between = |start: Pose| {
        let ends = Ends { start: Some(start), goal: None };
        planner.plan_between(ends, Options::default()).unwrap()
    };
    assert_eq!(between(Pose::new(-50.0, 3.0, 0.0)).outcome, Outcome::StartOutside);
    let blocked = between(Pose::new(10.0, -0.6, 0.0));
    assert_eq!(blocked.outcome, Outcome::StartBlocked);
    assert!(blocked.reason.unwrap().starts_with("The car's middle at the start, (11.40, -0.60), has no"));
    let moved = between(Pose::new(10.0, 0.25, 0.0)).metrics.road.unwrap();
    assert!(moved.start_moved > 0.7 && moved.start_moved < 1.5, "{}", moved.start_moved);
    let still = between(scene.geometry().unwrap().goal);
    assert_eq!((still.outcome, still.path.len(), still.metrics.length), (Outcome::Found, 1, 0.0));
    // A brush across the road closes it.
    planner.brush(&(0..17).map(|row| [400, row, 2]).collect::<Vec<_>>(), true).unwrap();
    assert_eq!(planner.plan(Options::default()).outcome, Outcome::NoPath);
    planner.brush(&(0..17).map(|row| [400, row, 2]).collect::<Vec<_>>(), false).unwrap();
    assert_eq!(planner.plan(Options::default()).hash(), planned("road-narrow", &json!({})).hash());
}

#[test]
fn other_planners_drive_on_roads() {
    for id in ["road-narrow", "road-crossing"] {
        let scene = catalog::scenario(id).unwrap();
        for info in planners().iter().filter(|p| p.family == "grid") {
            let plan = Planner::new(info.id, &scene, &Map::new()).unwrap().plan(Options::default());
            assert_eq!(plan.outcome, Outcome::Found, "{} on {id}: {:?}", info.id, plan.reason);
        }
    }
    let scene = catalog::scenario("road-narrow").unwrap();
    let plan = Planner::new("hybrid", &scene, &Map::new()).unwrap().plan(Options::default());
    assert_eq!((plan.outcome, plan.check.verdict), (Outcome::Found, Verdict::Ok), "{:?}", plan.reason);
}

#[test]
fn curves_forgive_what_cells_do_not() {
    // Of 1000: plain cells, within 15 % for another generator and other ties; curves at most a twentieth of that.
    for (id, cells, most) in [
        ("road-straight", 0, 0),
        ("road-curve", 1000, 10),
        ("road-crossing", 1000, 10),
        ("road-narrow", 863, 10),
    ] {
        let scene = catalog::scenario(id).unwrap();
        let risk = |settings: &serde_json::Value, options: &risk::Options| {
            let plan = planned(id, settings);
            let path: Vec<f64> = plan.path.iter().flat_map(|p| [p.x, p.y, p.heading]).collect();
            collision_risk(&scene, &path, options).unwrap()
        };
        let all = risk::Options::default();
        let (before, after) = (risk(&plain(), &all), risk(&json!({}), &all));
        println!("{id}: {before:?} {after:?}");
        assert!(before.hits.abs_diff(cells) <= cells * 3 / 20, "{id}: {before:?}");
        assert!(before.disc_hits <= before.hits && after.disc_hits <= after.hits);
        assert!(after.hits <= most, "{id}: {after:?}");
        let slices = [(0, 300), (300, 700)].map(|(from, trials)| {
            let slice = risk(&plain(), &risk::Options { trials, from, ..all.clone() });
            (slice.hits, slice.disc_hits)
        });
        let sum = (slices[0].0 + slices[1].0, slices[0].1 + slices[1].1);
        assert_eq!(sum, (before.hits, before.disc_hits), "{id}");
    }
    let scene = catalog::scenario("road-narrow").unwrap();
    assert_eq!(collision_risk(&scene, &[], &risk::Options::default()).unwrap_err().path, "path");
    assert_eq!(road_figures(&scene, &[0.0, f64::NAN, 0.0]).unwrap_err().path, "path[1]");
}

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
        let body = Body::new(&geometry);
        // Stanley has nothing ahead in view and comes late into the crossing's bend.
        let late = if id == "road-crossing" { 0.30 } else { 0.25 };
        for (controller, most) in [(Controller::Stanley, late), (Controller::Feedback, 0.25)] {
            let got = track(&geometry.vehicle, &body, &route, &Limits::road(), controller).unwrap();
            println!("{id}: {controller:?} followed within {:.3} m", got.max_lateral);
            assert!(got.max_lateral <= most && got.hit.is_none(), "{id} {controller:?}: {}", got.max_lateral);
        }
    }
}

#[test]
fn a_ship_keeps_its_distance_in_a_channel() {
    // The manuscript's appendix B: cells of 5 m, 17 m of safety from the ship's middle.
    let block = |x: f64, y: f64| json!({ "type": "rectangle", "center": [x, y], "size": [60.0, 40.0] });
    let scene = Scenario::from_json(&json!({
        "version": 1,
        "map": { "origin": [0.0, 0.0], "width": 400, "height": 60, "resolution": 5.0, "boundary": [[0, 20], [2000, 20], [2000, 280], [0, 280]] },
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

#[test]
fn plans_have_the_same_hash_everywhere() {
    let hashes = IDS.map(|id| planned(id, &json!({})).hash());
    assert_eq!(hashes, ["1e68c3d1f5c948a6", "1e896ca1cf21572d", "5cc29e19a9ae5e6e", "6a517c09afd6faaf"]);
}
