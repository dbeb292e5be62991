//! Hybrid A* against the parking paper's rows, tight slots, bad questions and random lots; every path is driven again
//! by a checker that shares nothing with the planner.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use parkade::geometry::arcs::{self, Arc};
use parkade::geometry::{Point, Pose, math, reeds_shepp};
use parkade::planners::hybrid::{Config, Profile, Query, Report, Scratch, SearchFrom, Status, plan};
use parkade::vehicle::Vehicle;
use parkade::vehicle::collision::{Edge, Obstacles, Probe, Solid};

const CAR: Vehicle = Vehicle::PAPER;
const BORDER: u32 = 0;

/// A floor, what stands on it, and a question.
#[derive(Clone)]
struct Lot {
    floor: Vec<[f64; 2]>,
    solids: Vec<Vec<[f64; 2]>>,
    start: [f64; 3],
    goal: [f64; 3],
}

fn pose([x, y, heading]: [f64; 3]) -> Pose {
    Pose::new(x, y, heading)
}

impl Lot {
    /// The paper's lot: 50 m × 25 m above y = 5 with a bay `x0..x1` of this depth below it.
    fn paper(x0: f64, x1: f64, depth: f64, start: [f64; 3], goal: [f64; 3]) -> Self {
        let low = 5.0 - depth;
        let floor = vec![
            [-25.0, 5.0],
            [x0, 5.0],
            [x0, low],
            [x1, low],
            [x1, 5.0],
            [25.0, 5.0],
            [25.0, 30.0],
            [-25.0, 30.0],
        ];
        Self { floor, solids: Vec::new(), start, goal }
    }

    fn row(id: &str) -> Self {
        let (_, start, goal) = ROWS.into_iter().find(|row| row.0 == id).expect("a row of the paper");
        Self::paper(-10.0, 10.0, 5.0, start, goal)
    }

    fn with(mut self, solid: &[[f64; 2]]) -> Self {
        self.solids.push(solid.to_vec());
        self
    }

    fn obstacles(&self) -> Obstacles {
        let point = |p: &[f64; 2]| Point::new(p[0], p[1]);
        let solid = |points: &[[f64; 2]], owner| Solid { outline: points.iter().map(point).collect(), owner };
        let solids: Vec<Solid> = (1..).zip(&self.solids).map(|(owner, s)| solid(s, owner)).collect();
        Obstacles::new(&[], &solids, &solid(&self.floor, BORDER))
    }

    fn plan(&self, config: &Config) -> Report {
        config.validate().unwrap();
        let obstacles = self.obstacles();
        let query =
            Query { obstacles: &obstacles, vehicle: &CAR, start: pose(self.start), goal: pose(self.goal) };
        plan(&query, config, &mut Scratch::default(), false)
    }

    /// Plans and checks the path; its length and direction changes.
    fn solve(&self, name: &str, config: &Config) -> (f64, u32, Report) {
        let report = self.plan(config);
        assert_eq!(report.status, Status::Found, "{name}");
        self.check(name, &report.arcs);
        let length = arcs::length(&report.arcs);
        assert!(length >= report.rs_bound - 1e-6, "{name}: {length} below {}", report.rs_bound);
        (length, arcs::direction_changes(&report.arcs), report)
    }

    /// Drives `path` in steps of 2 cm: ends at the goal, turns within the limit, touches nothing.
    fn check(&self, name: &str, path: &[Arc]) {
        let mut at = self.start;
        assert_eq!(self.hit(at), None, "{name}: at the start");
        for arc in path {
            assert!(arc.curvature.abs() <= CAR.max_curvature() + 1e-9, "{name}: {arc:?}");
            let steps = (arc.length.abs() / 0.02).ceil();
            let from = at;
            for k in 1..=steps as u32 {
                at = drive(from, arc.curvature, arc.length * f64::from(k) / steps);
                assert_eq!(self.hit(at), None, "{name}: at {at:?} on {arc:?}");
            }
        }
        let [x, y, heading] = self.goal;
        assert!(math::hypot(at[0] - x, at[1] - y) < 1e-6, "{name} ends at {at:?}");
        assert!(math::wrap(at[2] - heading).abs() < 1e-6, "{name} ends at {at:?}");
        let back = arcs::end(pose(self.goal), &arcs::reversed(path));
        assert!((back.point() - pose(self.start).point()).norm() < 1e-6, "{name} does not lead back");
    }

    /// The least distance from the car to anything along a path, 1 m at most.
    fn clearance(&self, path: &[Arc]) -> f64 {
        let obstacles = self.obstacles();
        let probe = Probe::new(&obstacles, &CAR);
        let points = arcs::sample(pose(self.start), path, pose(self.goal), 0.02);
        points.iter().fold(1.0, |least, p| probe.clearance(obstacles.local(p.pose), least).min(least))
    }

    /// Whether the car overlaps a solid or an edge of the floor by more than a micrometre.
    fn hit(&self, at: [f64; 3]) -> Option<usize> {
        let body = body(at);
        let n = self.floor.len();
        let walls = (0..n).map(|i| vec![self.floor[i], self.floor[(i + 1) % n]]);
        let things: Vec<Vec<[f64; 2]>> = walls.chain(self.solids.iter().cloned()).collect();
        things.iter().position(|thing| overlap(&body, thing))
    }
}

/// Corners of the car.
fn body([x, y, heading]: [f64; 3]) -> [[f64; 2]; 4] {
    let (s, c) = (math::sin(heading), math::cos(heading));
    let side = CAR.width / 2.0;
    [
        (CAR.rear_to_front, side),
        (-CAR.rear_to_back, side),
        (-CAR.rear_to_back, -side),
        (CAR.rear_to_front, -side),
    ]
    .map(|(u, v)| [x + u * c - v * s, y + u * s + v * c])
}

/// Separating axes of two convex outlines; a segment is one of two corners.
fn overlap(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    let axes = |p: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let edge = |i: usize| [p[(i + 1) % p.len()][0] - p[i][0], p[(i + 1) % p.len()][1] - p[i][1]];
        (0..p.len()).map(edge).map(|[dx, dy]| [-dy / math::hypot(dx, dy), dx / math::hypot(dx, dy)]).collect()
    };
    let range = |p: &[[f64; 2]], [nx, ny]: [f64; 2]| {
        let along = p.iter().map(|q| q[0] * nx + q[1] * ny);
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
    };
    axes(a).into_iter().chain(axes(b)).all(|axis| {
        let ((a0, a1), (b0, b1)) = (range(a, axis), range(b, axis));
        a1.min(b1) - a0.max(b0) > 1e-6
    })
}

/// A pose after an arc, by the chord: another formula than the planner's.
fn drive([x, y, heading]: [f64; 3], curvature: f64, length: f64) -> [f64; 3] {
    let half = curvature * length / 2.0;
    let chord = if half.abs() < 1e-12 { length } else { length * math::sin(half) / half };
    [x + chord * math::cos(heading + half), y + chord * math::sin(heading + half), heading + 2.0 * half]
}

const ROWS: [(&str, [f64; 3], [f64; 3]); 10] = [
    ("P0", [22.0, 8.19, PI], [2.5, 5.0, -FRAC_PI_2]),
    ("P1", [24.0, 8.4, PI], [2.5, 5.0, -FRAC_PI_2]),
    ("P2", [-20.0, 14.5, PI], [-7.0, 5.0, -FRAC_PI_2]),
    ("P3", [16.0, 18.0, PI], [-2.0, 5.0, -FRAC_PI_2]),
    ("P4", [-16.0, 7.5, PI], [7.0, 5.0, -FRAC_PI_2]),
    ("L0", [20.0, 19.06, PI], [-3.0, 2.0, PI]),
    ("L1", [18.0, 15.7, PI], [-3.0, 2.0, PI]),
    ("L2", [16.0, 14.7, PI], [2.0, 2.0, PI]),
    ("L3", [19.0, 15.5, PI], [-4.0, 3.0, PI]),
    ("L4", [-8.0, 14.2, PI], [7.0, 3.0, PI]),
];

/// Reeds–Shepp bound, and what must be reached: metres, direction changes.
const MUST_REACH: [(&str, f64, f64, u32); 10] = [
    ("P0", 22.69, 22.80, 0),
    ("P1", 24.66, 24.75, 0),
    ("P2", 22.10, 22.20, 1),
    ("P3", 23.20, 23.25, 0),
    ("P4", 27.21, 27.30, 1),
    ("L0", 29.20, 30.10, 0),
    ("L1", 25.50, 26.30, 0),
    ("L2", 19.97, 24.80, 1),
    ("L3", 26.44, 26.50, 0),
    ("L4", 19.38, 19.45, 0),
];

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_papers_rows_are_reached() {
    for (id, bound, length, changes) in MUST_REACH {
        let (got, got_changes, report) = Lot::row(id).solve(id, &Config::default());
        println!("{id}: {got:.2} m, {got_changes} changes, {} expansions", report.expanded);
        assert!(got <= length && got_changes <= changes, "{id}: {got} m, {got_changes} changes");
        assert!((report.rs_bound - bound).abs() < 0.005, "{id}: bound {}", report.rs_bound);
        assert_eq!(report.margin, if id == "P1" { 0.0 } else { 0.1 }, "{id}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_papers_rows_are_reached_from_the_start_too() {
    let config = Config { search_from: SearchFrom::Start, ..Config::default() };
    for id in ["P0", "P3", "L3", "L4"] {
        Lot::row(id).solve(id, &config);
    }
}

#[cfg(feature = "complete")]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn two_trees_reach_the_papers_rows() {
    for (id, _, length, changes) in MUST_REACH {
        let (got, got_changes, report) = Lot::row(id).solve(id, &Config::both_ways());
        println!("{id}: {got:.2} m, {got_changes} changes, {} expansions", report.expanded);
        assert!(got <= length * 1.05 && got_changes <= changes, "{id}: {got} m, {got_changes} changes");
    }
    let boxed = Lot::paper(-8.0, -1.4, 3.0, [10.0, 8.0, PI], [-2.95, 3.5, PI]);
    let report = boxed.plan(&Config { finest_level: 2, ..Config::both_ways() });
    assert!(report.arcs.is_empty(), "{:?}", report.status);
}

#[cfg(feature = "complete")]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_classic_planner_is_as_poor_as_its_forerunner() {
    let rows = [("P0", 22.77, 0), ("P1", 24.72, 0), ("P3", 23.20, 0), ("L3", 26.44, 0), ("L4", 19.38, 0)];
    for (id, length, changes) in rows {
        let (got, got_changes, _) = Lot::row(id).solve(id, &Config::classic());
        assert!(
            (got - length).abs() < 0.01 && got_changes == changes,
            "{id}: {got} m, {got_changes} changes"
        );
    }
    for (id, length) in [("P2", 23.14), ("P4", 27.35), ("L0", 36.6), ("L1", 32.0), ("L2", 37.3)] {
        let (got, got_changes, _) = Lot::row(id).solve(id, &Config::classic());
        println!("{id}: {got:.2} m, {got_changes} changes; {length} m measured before");
        assert!(got >= length * 0.8 && got <= length * 1.35, "{id}: {got} m");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn comfort_keeps_away_from_walls() {
    let config = Config { profile: Profile::Comfort, ..Config::default() };
    for (id, length, clear) in [("P4", 27.8, 0.3), ("L2", 26.0, 0.18)] {
        let lot = Lot::row(id);
        let (got, changes, report) = lot.solve(id, &config);
        let clearance = lot.clearance(&report.arcs);
        println!("{id}: {got:.2} m, {changes} changes, {clearance:.2} m clear");
        assert!(
            got <= length && changes <= 1 && clearance >= clear,
            "{id}: {got} m, {changes}, {clearance} m"
        );
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_box_in_the_aisle_is_passed() {
    let lot = Lot::row("P0").with(&[[11.0, 8.5], [13.0, 8.5], [13.0, 10.5], [11.0, 10.5]]);
    let (length, changes, _) = lot.solve("box", &Config::default());
    assert!(length <= 23.9 && changes == 0, "{length} {changes}");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn tight_slots_are_entered() {
    let parallel = |x1: f64, x: f64| Lot::paper(-8.0, x1, 3.0, [10.0, 8.0, PI], [x, 3.5, PI]);
    let across =
        |w: f64, y: f64, heading: f64| Lot::paper(0.0, w, 6.0, [16.0, 9.0, PI], [w / 2.0, y, heading]);
    let (tail, nose) = ((0.4, FRAC_PI_2), (3.9, -FRAC_PI_2));
    let rows = [
        ("par-8.0", parallel(0.0, -2.25), 24.6, 4),
        ("par-7.2", parallel(-0.8, -2.65), 26.7, 10),
        ("perp-tail-3.6", across(3.6, tail.0, tail.1), 25.5, 1),
        ("perp-tail-3.2", across(3.2, tail.0, tail.1), 25.8, 1),
        ("perp-tail-3.0", across(3.0, tail.0, tail.1), 26.2, 1),
        ("perp-nose-3.6", across(3.6, nose.0, nose.1), 23.5, 1),
        ("perp-nose-3.2", across(3.2, nose.0, nose.1), 26.0, 1),
        ("perp-nose-3.0", across(3.0, nose.0, nose.1), 26.0, 1),
    ];
    let config = Config { heuristic_weight: Some(1.2), ..Config::default() };
    for (name, lot, length, changes) in rows {
        lot.solve(name, &Config::default());
        let (got, got_changes, report) = lot.solve(name, &config);
        println!("{name}: {got:.2} m, {got_changes} changes, {} expansions", report.expanded);
        assert!(got <= length * 1.05 && got_changes <= changes, "{name}: {got} m, {got_changes} changes");
    }
    let tightest = parallel(-1.4, -2.95);
    let coarse = tightest.plan(&Config { finest_level: 2, ..config });
    assert!(matches!(coarse.status, Status::BoxedIn { at_start: false, .. }), "{:?}", coarse.status);
    let report = tightest.plan(&Config::default());
    assert_eq!((report.status, report.level, report.margin), (Status::Suboptimal, 3, 0.1));
    assert!(arcs::length(&report.arcs) < 32.0 && arcs::direction_changes(&report.arcs) <= 20);
    tightest.check("par-6.6", &report.arcs);
    let nose = across(3.2, nose.0, nose.1).solve("perp-nose-3.2", &Config::default());
    assert!(nose.0 <= 27.3 && nose.1 == 1, "{} m, {} changes", nose.0, nose.1);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_margin_falls_where_it_alone_keeps_the_car_in() {
    // Seven tenths of a metre to move in between two cars.
    let mut lot = Lot::paper(-10.0, 10.0, 5.0, [10.0, 8.5, PI], [0.0, 2.0, PI]);
    lot.solids.push(vec![[1.35, 0.7], [6.0, 0.7], [6.0, 3.3], [1.35, 3.3]]);
    lot.solids.push(vec![[-9.0, 0.7], [-4.85, 0.7], [-4.85, 3.3], [-9.0, 3.3]]);
    let report = lot.plan(&Config::default());
    assert!(matches!(report.status, Status::Suboptimal), "{:?}", report.status);
    assert_eq!((report.margin, report.level), (0.002, 3));
    lot.check("between two cars", &report.arcs);
    let kept = lot.plan(&Config { finest_level: 2, ..Config::default() });
    assert_eq!((kept.status, kept.margin), (Status::BoxedIn { at_start: false, travel: 0.5 }, 0.1));
    // The other way round, the tree grows from the start, which is now the tight end.
    let out = Lot { start: lot.goal, goal: lot.start, ..lot };
    let report = out.plan(&Config::default());
    assert_eq!((report.status, report.margin), (Status::Suboptimal, 0.002));
    out.check("out between two cars", &report.arcs);
    let kept = out.plan(&Config { finest_level: 2, ..Config::default() });
    assert!(matches!(kept.status, Status::BoxedIn { at_start: true, .. }) && kept.expanded < 100);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn bad_questions_are_answered_with_the_reason() {
    let lot = Lot::row("P3");
    let ask = |lot: &Lot| lot.plan(&Config::default());
    let block =
        |x: f64, y: f64| [[x - 1.0, y - 1.0], [x + 1.0, y - 1.0], [x + 1.0, y + 1.0], [x - 1.0, y + 1.0]];
    assert_eq!(ask(&lot.clone().with(&block(14.0, 18.0))).status, Status::StartInCollision(1));
    assert_eq!(ask(&lot.clone().with(&block(-2.0, 3.0))).status, Status::GoalInCollision(1));
    let cliff = [[-30.0, 4.0], [30.0, 4.0], [30.0, 31.0], [-30.0, 31.0]];
    assert_eq!(ask(&lot.clone().with(&cliff)).status, Status::StartInCollision(1), "wholly inside a solid");
    let away = Lot { start: [100.0, 18.0, PI], ..lot.clone() };
    assert_eq!(ask(&away).status, Status::StartInCollision(BORDER), "wholly outside");
    let wall = [[-25.0, 11.0], [25.0, 11.0], [25.0, 11.2], [-25.0, 11.2]];
    let walled = ask(&lot.clone().with(&wall));
    assert_eq!((walled.status, walled.expanded), (Status::Unreachable, 0));
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        let report = ask(&Lot { start: [bad, 18.0, PI], ..lot.clone() });
        assert!(!matches!(report.status, Status::Found | Status::Suboptimal), "{bad}");
        let report = ask(&Lot { goal: [0.0, 18.0, bad], ..lot.clone() });
        assert!(bad == 1e300 || !matches!(report.status, Status::Found | Status::Suboptimal), "{bad}");
    }
    let stay = ask(&Lot { goal: lot.start, ..lot.clone() });
    assert_eq!((stay.status, stay.arcs.len(), stay.cost), (Status::Found, 0, 0.0));
    let turn = Lot { goal: [16.0, 18.0, 0.0], ..lot.clone() };
    turn.solve("about turn", &Config::default());
    let config = Config {
        motion_primitive_length: Some(0.2),
        xy_resolution: Some(0.1),
        heading_resolution: Some(0.026),
        max_expansions: Some(10),
        ladder: false,
        ..Config::default()
    };
    let spent = Lot::paper(-8.0, -0.8, 3.0, [10.0, 8.0, PI], [-2.65, 3.5, PI]).plan(&config);
    assert!(matches!(spent.status, Status::BudgetExhausted(left) if left > 1.0), "{:?}", spent.status);
    assert_eq!(spent.expanded, 10);
}

/// A number in [0, 1) and the next state.
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

/// A lot with boxes strewn over it.
fn strewn(seed: u64) -> Lot {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mut between = |low: f64, high: f64| low + (high - low) * random(&mut state);
    let mut lot = Lot::paper(-10.0, 10.0, 5.0, [0.0; 3], [0.0; 3]);
    for _ in 0..6 {
        let (x, y, turn) = (between(-24.0, 24.0), between(8.0, 29.0), between(0.0, PI));
        let (a, b) = (between(0.3, 2.5), between(0.3, 1.5));
        let (s, c) = (math::sin(turn), math::cos(turn));
        let corner = |u: f64, v: f64| [x + u * c - v * s, y + u * s + v * c];
        lot.solids.push(vec![corner(-a, -b), corner(a, -b), corner(a, b), corner(-a, b)]);
    }
    let mut free = || loop {
        let at = [between(-23.0, 23.0), between(3.0, 28.0), between(-PI, PI)];
        if lot.hit(at).is_none() && at[1] > 6.0 + 4.0 * f64::from(at[0].abs() > 9.0) {
            return at;
        }
    };
    (lot.start, lot.goal) = (free(), free());
    lot
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn random_lots_give_drivable_paths() {
    let mut found = 0;
    for seed in 0..40 {
        let lot = strewn(seed);
        let name = format!("seed {seed}");
        let config = Config { ladder: false, max_expansions: Some(3000), ..Config::default() };
        let report = lot.plan(&config);
        if !matches!(report.status, Status::Found | Status::Suboptimal) {
            continue;
        }
        found += 1;
        lot.check(&name, &report.arcs);
        let length = arcs::length(&report.arcs);
        assert!(length >= report.rs_bound - 1e-6, "{name}");
        let again = lot.plan(&config);
        assert_eq!((again.arcs, again.expanded), (report.arcs.clone(), report.expanded), "{name}");
        let mut turned = lot.clone();
        (turned.start[2], turned.goal[2]) = (lot.start[2] + TAU, lot.goal[2] - TAU);
        let turned = turned.plan(&config);
        assert!((arcs::length(&turned.arcs) - length).abs() < 1e-6, "{name}: turned by 2π");
    }
    assert!(found >= 30, "{found}");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn far_from_the_origin_the_answer_is_the_same() {
    for id in ["P2", "L1", "L2"] {
        let near = Lot::row(id);
        let (length, changes, _) = near.solve(id, &Config::default());
        let far = |p: &[f64; 2]| [p[0] + 1e9, p[1] - 1e9];
        let mut lot = Lot { floor: near.floor.iter().map(far).collect(), ..near.clone() };
        for at in [&mut lot.start, &mut lot.goal] {
            (at[0], at[1]) = (at[0] + 1e9, at[1] - 1e9);
        }
        let report = lot.plan(&Config::default());
        near.check(id, &report.arcs);
        assert!((arcs::length(&report.arcs) - length).abs() < 1e-5, "{id}");
        assert_eq!(arcs::direction_changes(&report.arcs), changes, "{id}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_mirror_image_is_as_long() {
    for id in ["P2", "L0", "L4"] {
        let lot = Lot::row(id);
        let flip = |[x, y, heading]: [f64; 3]| [-x, y, PI - heading];
        let mirror = Lot::paper(-10.0, 10.0, 5.0, flip(lot.start), flip(lot.goal));
        let (one, _, _) = lot.solve(id, &Config::default());
        let (other, _, _) = mirror.solve(id, &Config::default());
        assert!((one - other).abs() <= 0.02 * one, "{id}: {one} {other}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_hundred_thousand_words_arrive() {
    let mut state = 1_u64;
    let radius = CAR.min_turning_radius();
    for _ in 0..100_000 {
        let mut any = || {
            let [x, y, t] = [(); 3].map(|()| random(&mut state));
            Pose::new(x * 30.0 - 15.0, y * 30.0 - 15.0, t * TAU - PI)
        };
        let (from, to) = (any(), any());
        let mut least = f64::INFINITY;
        reeds_shepp::words(from, to, radius, |word| {
            least = least.min(word.length(radius));
            let end = word.arcs(radius).fold(from, |at, arc| at.advance(arc.curvature, arc.length));
            assert!((end.point() - to.point()).norm() < 1e-6, "{from:?} {to:?} {word:?}");
            assert!(math::turn(end.heading, to.heading).abs() < 1e-6, "{from:?} {to:?} {word:?}");
        });
        let distance = reeds_shepp::distance(from, to, radius);
        assert!((distance - least).abs() < 1e-9);
        assert!((reeds_shepp::distance(to, from, radius) - distance).abs() < 1e-6);
        assert!(distance >= (to.point() - from.point()).norm() - 1e-9);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn settings_are_checked() {
    let error = Config { margin: f64::NAN, ..Config::default() }.validate().unwrap_err();
    assert_eq!((error.path.as_str(), error.message.ends_with("got NaN")), ("margin", true));
    let with = |text: &str| Config::default().with(&serde_json::from_str(text).unwrap());
    let config = with(r#"{ "searchFrom": "start", "xyResolution": 0.4 }"#).unwrap();
    assert_eq!((config.search_from, config.xy_resolution), (SearchFrom::Start, Some(0.4)));
    let refused = |text: &str| with(text).unwrap_err().to_string();
    assert!(
        refused(r#"{ "stepLength": 1 }"#).starts_with("stepLength: no such setting; there are searchFrom")
    );
    assert_eq!(
        refused(r#"{ "steerSamples": "many" }"#),
        "steerSamples: must be a whole number from 0, got \"many\""
    );
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_wall_is_no_solid_but_stops_the_car() {
    let point = |x, y| Point::new(x, y);
    let outline = vec![point(0.0, 0.0), point(40.0, 0.0), point(40.0, 20.0), point(0.0, 20.0)];
    let floor = Solid { outline, owner: 0 };
    let wall = Edge { a: point(20.0, 0.0), b: point(20.0, 14.0), owner: 7 };
    let obstacles = Obstacles::new(&[wall], &[], &floor);
    let ask = |start: Pose| {
        let query = Query { obstacles: &obstacles, vehicle: &CAR, start, goal: Pose::new(34.0, 4.0, 0.0) };
        plan(&query, &Config::default(), &mut Scratch::default(), false)
    };
    assert_eq!(ask(Pose::new(18.0, 5.0, 0.0)).status, Status::StartInCollision(7));
    let around = ask(Pose::new(8.0, 4.0, FRAC_PI_2));
    assert_eq!(around.status, Status::Found);
    assert!(arcs::length(&around.arcs) > 36.0);
}

#[cfg(all(feature = "complete", not(target_arch = "wasm32")))]
#[test]
fn every_competition_case_is_solved() {
    use parkade::metrics::Verdict;
    use parkade::plan::{Options, Planner};
    let folder = std::env::var("PARKADE_DATA").unwrap_or_else(|_| "../shared/data".to_owned());
    let mut solved = 0;
    for number in 1..=20 {
        let Ok(text) = std::fs::read_to_string(format!("{folder}/tpcap/Case{number}.csv")) else { continue };
        let scene = parkade::import::tpcap::scene("case", &text).unwrap();
        let plan = Planner::new("hybrid", &scene, &serde_json::Map::new()).unwrap().plan(Options::default());
        assert_eq!(plan.check.verdict, Verdict::Ok, "case {number}: {:?}", plan.reason);
        let margin = plan.metrics.hybrid.as_ref().map_or(0.0, |m| m.margin);
        assert!(number == 7 || margin == 0.1, "case {number}: planned with {margin} m");
        solved += 1;
    }
    if solved == 0 {
        println!("skipped: no tpcap/Case*.csv in {folder}; they are in libai1943/TPCAP_benchmarks");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn an_obstacle_more_makes_no_path_shorter() {
    for seed in 0..25 {
        let full = strewn(seed);
        let mut fewer = full.clone();
        fewer.solids.pop();
        let config = Config { ladder: false, max_expansions: Some(3000), ..Config::default() };
        let cost = |lot: &Lot| Some(lot.plan(&config)).filter(|r| !r.arcs.is_empty()).map(|r| r.cost);
        if let (Some(more), Some(less)) = (cost(&full), cost(&fewer)) {
            assert!(more >= 0.98 * less, "seed {seed}: {more} with, {less} without");
        }
    }
}
