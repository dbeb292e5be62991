//! Tight manoeuvres by seed, for any car: slots in a row, right-angle corners, clutter and garages. Metres; x along the
//! street or aisle.

mod lots;
mod slots;

pub(crate) use lots::{cluttered, corner, garage};
pub(crate) use slots::{angled, bay, kerb};

use parkade::geometry::{Point, Pose, math};
use parkade::scenario::{Goal, MapFrame, Obstacle, Scenario, VehicleSpec, catalog};
use parkade::vehicle::Vehicle;
use parkade::vehicle::collision::{CollisionChecker, Obstacles, Solid};

/// Something to plan.
pub(crate) struct Scene {
    /// What it is, with its sizes.
    pub(crate) name: String,
    pub(crate) vehicle: Vehicle,
    pub(crate) obstacles: Obstacles,
    /// Outlines of all that stands there, and of the floor.
    pub(crate) outlines: (Vec<Vec<Point>>, Vec<Point>),
    pub(crate) start: Pose,
    pub(crate) goal: Pose,
}

impl Scene {
    /// The same as a scene with a map.
    pub(crate) fn scenario(&self) -> Scenario {
        let numbers = |outline: &[Point]| outline.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>();
        let (solids, floor) = &self.outlines;
        let least = |pick: fn(&Point) -> f64| floor.iter().map(pick).fold(f64::INFINITY, f64::min);
        let most = |pick: fn(&Point) -> f64| floor.iter().map(pick).fold(f64::NEG_INFINITY, f64::max);
        let (left, low) = (least(|p| p.x), least(|p| p.y));
        let map = MapFrame {
            origin: [left, low],
            width: ((most(|p| p.x) - left) / 0.25).ceil() as u32,
            height: ((most(|p| p.y) - low) / 0.25).ceil() as u32,
            resolution: 0.25,
            boundary: Some(numbers(floor)),
        };
        let solids = solids.iter().map(|solid| Obstacle::Polygon { id: None, points: numbers(solid) });
        let mut scenario = catalog::scenario("P0").expect("a scene of the catalog");
        scenario.name = Some(self.name.clone());
        (scenario.map, scenario.obstacles) = (map, solids.collect());
        (scenario.start, scenario.goal) = (self.start, Goal::Pose(self.goal));
        scenario.vehicle = VehicleSpec::Custom(self.vehicle);
        scenario.slots.clear();
        scenario.planners.clear();
        scenario
    }
}

/// Least and largest of a size that is drawn, metres.
pub(crate) type Range = (f64, f64);

/// A scene of some kind for a car, by seed.
pub(crate) type Make = fn(&Vehicle, u64) -> Scene;

/// Every kind, from sizes that hardly any car can use to comfortable ones.
pub(crate) const KINDS: [(&str, Make); 6] = [
    ("kerb", |car, seed| kerb(car, seed, (0.3, 2.5), (3.5, 6.5))),
    ("bay", |car, seed| bay(car, seed, (0.3, 1.2), (3.5, 7.0))),
    ("angled", |car, seed| angled(car, seed, (0.3, 1.2), (3.5, 6.5))),
    ("corner", |car, seed| {
        let width = (car.width + 0.4, car.width + 2.8);
        corner(car, seed, width, width)
    }),
    ("cluttered", cluttered),
    ("garage", garage),
];

/// A small generator whose numbers are the same everywhere.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x7e57_ab1e);
        random.between((0.0, 1.0));
        random
    }

    fn between(&mut self, (low, high): Range) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 33) as f64 / (1_u64 << 31) as f64
    }

    /// Between minus and plus `most`.
    fn around(&mut self, most: f64) -> f64 {
        self.between((-most, most))
    }

    /// True in this share of cases.
    fn chance(&mut self, share: f64) -> bool {
        self.between((0.0, 1.0)) < share
    }

    /// One of the numbers from 0 to `count` - 1.
    fn below(&mut self, count: usize) -> usize {
        (self.between((0.0, 1.0)) * count as f64) as usize
    }
}

/// What is kept around the car where it starts, metres: the default margin, so that the start does not limit it.
const CLEARANCE: f64 = 0.1;

fn obstacles((solids, floor): &(Vec<Vec<Point>>, Vec<Point>)) -> Obstacles {
    let solid = |(owner, outline): (u32, &Vec<Point>)| Solid { outline: outline.clone(), owner };
    let solids: Vec<Solid> = (1..).zip(solids).map(solid).collect();
    Obstacles::new(&[], &solids, &solid((0, floor)))
}

fn is_clear(obstacles: &Obstacles, car: &Vehicle, pose: Pose, margin: f64) -> bool {
    let local = obstacles.local(pose);
    obstacles.inside(local.point()).is_none()
        && CollisionChecker::new(obstacles, car).hit(local, margin).is_none()
}

/// The first of the drawn poses where the car has room.
fn first_clear(obstacles: &Obstacles, car: &Vehicle, draw: impl FnMut() -> Pose) -> Pose {
    std::iter::repeat_with(draw)
        .take(100_000)
        .find(|&pose| is_clear(obstacles, car, pose, CLEARANCE))
        .expect("room for the car at its start")
}

fn box_of((left, low): (f64, f64), (right, high): (f64, f64)) -> Vec<Point> {
    [(left, low), (right, low), (right, high), (left, high)].map(|(x, y)| Point::new(x, y)).to_vec()
}

/// A rectangle about its middle, `length` along its heading.
fn turned_box(middle: Pose, length: f64, width: f64) -> Vec<Point> {
    let (along, across) = (length / 2.0, width / 2.0);
    [(along, across), (-along, across), (-along, -across), (along, -across)]
        .map(|(ahead, left)| middle.to_world(Point::new(ahead, left)))
        .to_vec()
}

/// The outline of a parked car about its middle.
fn parked(car: &Vehicle, middle: Pose) -> Vec<Point> {
    turned_box(middle, car.length(), car.width)
}

/// The rear axle of a car about its middle.
fn rear_axle(car: &Vehicle, middle: Pose) -> Pose {
    middle.advance(0.0, -car.middle())
}

/// How far a box that is tilted out of its place reaches from its middle in the direction of its first side, metres.
fn reach(along: f64, across: f64, tilt: f64) -> f64 {
    let (sin, cos) = math::sin_cos(tilt.abs());
    along / 2.0 * cos + across / 2.0 * sin
}

#[test]
fn every_scene_leaves_its_car_room_at_start_and_goal() {
    for car in [Vehicle::SEDAN, Vehicle::PAPER] {
        for (kind, make) in KINDS {
            for seed in 1..=200 {
                let Scene { name, obstacles, start, goal, .. } = make(&car, seed);
                assert!(name.starts_with(kind));
                for (end, pose) in [("start", start), ("goal", goal)] {
                    assert!(is_clear(&obstacles, &car, pose, 0.02), "{name}, seed {seed}: {end}");
                }
            }
        }
    }
}
