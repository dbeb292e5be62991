//! Random scenes and questions to hybrid A*, by seed: floors near and far from the origin, polygons in both directions,
//! walls without thickness, cars to park between, start and goal anywhere, headings beyond ±π.

use parkade::geometry::{Point, Pose, math};
use parkade::metrics::Verdict;
use parkade::plan::{Options, Outcome, Plan, Planner};
use parkade::planners::hybrid::obstacles as obstacles_of;
use parkade::scenario::{Goal, MapFrame, Obstacle, Scenario, VehicleSpec};
use parkade::vehicle::Vehicle;
use parkade::vehicle::collision::CollisionChecker;
use serde_json::{Map, Value, json};

struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.bits() as f64 / (1_u64 << 31) as f64
    }
}

/// The scene of a seed and the settings to plan it with.
pub(crate) fn scene(seed: u64) -> (Scenario, Map<String, Value>) {
    let mut r = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5ca1_ab1e);
    r.bits();
    let [x0, y0] = [[0.0, 0.0], [-17.3, 4.1], [1e9, -1e9], [3e6, 2e6]][r.below(4) as usize];
    let (width, height) = (r.between(18.0, 50.0), r.between(15.0, 35.0));
    let at = |x: f64, y: f64| [x0 + x, y0 + y];
    let mut obstacles = Vec::new();
    for _ in 0..r.below(10) {
        let [x, y] = at(r.between(0.0, width), r.between(0.0, height));
        obstacles.push(match r.below(4) {
            0 => Obstacle::Rectangle {
                id: None,
                center: [x, y],
                size: [r.between(0.2, 6.0), r.between(0.2, 3.0)],
                heading: r.between(-9.0, 9.0),
            },
            1 => Obstacle::Car {
                id: None,
                pose: Pose::new(x, y, r.between(-4.0, 4.0)),
                vehicle: VehicleSpec::Profile("sedan".to_owned()),
            },
            2 => Obstacle::Wall {
                id: None,
                points: vec![[x, y], [x + r.between(-8.0, 8.0), y + r.between(1.0, 8.0)]],
                thickness: [0.0, 0.2][r.below(2) as usize],
            },
            _ => star(&mut r, [x, y]),
        });
    }
    let heading = |r: &mut Random| r.between(-math::PI, math::PI) + math::TAU * (r.below(5) as f64 - 2.0);
    let pose = |r: &mut Random| {
        let [x, y] = at(r.between(1.0, width - 1.0), r.between(1.0, height - 1.0));
        Pose::new(x, y, heading(r))
    };
    let (start, goal) = (pose(&mut r), pose(&mut r));
    let car = [Vehicle::PAPER, Vehicle::SEDAN][r.below(2) as usize];
    if r.below(3) == 0 {
        let pair = [r.between(0.1, 2.0), r.between(0.1, 2.0)];
        obstacles.extend(between(goal, &car, pair));
    }
    let settings = json!({
        "margin": ([0.1, 0.1, 0.0, 0.3][r.below(4) as usize]),
        "searchFrom": (["goal", "goal", "start", "both"][r.below(4) as usize]),
        "profile": (["shortest", "shortest", "shortest", "classic", "comfort"][r.below(5) as usize]),
        "firstShot": r.below(5) == 0,
    });
    let mut scenario = Scenario {
        name: Some(format!("random_scenes {seed}")),
        obstacles,
        ..Scenario::new(
            MapFrame {
                origin: [x0, y0],
                width: (width / 0.25) as u32,
                height: (height / 0.25) as u32,
                resolution: 0.25,
                boundary: None,
            },
            VehicleSpec::Custom(car),
            start,
            goal,
        )
    };
    // Most poses shall be free, not all.
    for _ in 0..6 {
        let geometry = scenario.geometry().expect("a valid scene");
        let obstacles = obstacles_of(&geometry);
        let checker = CollisionChecker::new(&obstacles, &car);
        let blocked = |pose: Pose| {
            let pose = obstacles.local(pose);
            obstacles.inside(pose.point()).or_else(|| checker.hit(pose, 0.0)).is_some()
        };
        if blocked(geometry.start) {
            scenario.start = pose(&mut r);
        }
        if blocked(geometry.goal) {
            scenario.goal = Goal::Pose(pose(&mut r));
        }
    }
    (scenario, settings.as_object().cloned().unwrap_or_default())
}

/// A polygon with dents, in either direction.
fn star(r: &mut Random, [x, y]: [f64; 2]) -> Obstacle {
    let corners = 3 + r.below(8) as u32;
    let mut points: Vec<[f64; 2]> = (0..corners)
        .map(|k| {
            let (angle, radius) = (math::TAU * f64::from(k) / f64::from(corners), r.between(0.4, 3.0));
            [x + radius * math::cos(angle), y + radius * math::sin(angle)]
        })
        .collect();
    if r.below(2) == 0 {
        points.reverse();
    }
    Obstacle::Polygon { id: None, points }
}

/// A block ahead of a pose and one behind it.
fn between(pose: Pose, car: &Vehicle, [ahead, behind]: [f64; 2]) -> [Obstacle; 2] {
    [car.rear_to_front + ahead + 1.5, -car.rear_to_back - behind - 1.5].map(|along| {
        let middle = pose.to_world(Point::new(along, 0.0));
        Obstacle::Rectangle {
            id: None,
            center: [middle.x, middle.y],
            size: [3.0, car.width],
            heading: pose.heading,
        }
    })
}

/// Plans a seed's scene and holds the answer against what is promised.
pub(crate) fn plan(seed: u64) -> Plan {
    let (scene, settings) = scene(seed);
    let mut planner =
        Planner::new("hybrid", &scene, &settings).unwrap_or_else(|e| panic!("seed {seed}: {e}"));
    let plan = planner.plan(Options::default());
    if plan.outcome == Outcome::Found {
        let metrics = plan.metrics.hybrid.as_ref().expect("metrics of a car's path");
        assert!(
            plan.path.len() < 2 || plan.check.verdict == Verdict::Ok,
            "seed {seed}: {:?}",
            plan.check.verdict
        );
        assert!(plan.metrics.length >= metrics.rs_bound - 1e-5, "seed {seed}: below the bound");
        assert!(plan.metrics.min_clearance >= 0.0, "seed {seed}");
    } else {
        assert!(plan.path.is_empty(), "seed {seed}: a path without being found");
        assert!(plan.reason.as_ref().is_some_and(|r| r.len() > 10), "seed {seed}: no reason");
    }
    plan
}
