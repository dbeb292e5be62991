//! Tight manoeuvres by seed: kerb slots, bays, and right-angle corners for the sedan. Metres; x along the street or aisle.

use parkade::geometry::{Point, Pose, math};
use parkade::vehicle::Vehicle;
use parkade::vehicle::collision::{Obstacles, Solid};

/// A small generator whose numbers are the same everywhere.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x7e57_ab1e);
        random.between(0.0, 1.0);
        random
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 33) as f64 / (1_u64 << 31) as f64
    }
}

/// Something to plan.
pub(crate) struct Scene {
    /// What it is, with its sizes.
    pub(crate) name: String,
    pub(crate) obstacles: Obstacles,
    pub(crate) start: Pose,
    pub(crate) goal: Pose,
}

pub(crate) const CAR: Vehicle = Vehicle::SEDAN;

fn scene(name: String, solids: &[Vec<Point>], floor: Vec<Point>, [start, goal]: [Pose; 2]) -> Scene {
    let solids: Vec<Solid> =
        (1..).zip(solids).map(|(owner, outline)| Solid { outline: outline.clone(), owner }).collect();
    let obstacles = Obstacles::new(&[], &solids, &Solid { outline: floor, owner: 0 });
    Scene { name, obstacles, start, goal }
}

fn rectangle(left: f64, low: f64, right: f64, high: f64) -> Vec<Point> {
    [(left, low), (right, low), (right, high), (left, high)].map(|(x, y)| Point::new(x, y)).to_vec()
}

/// The outline of a parked car whose middle is here.
fn parked(x: f64, y: f64, heading: f64) -> Vec<Point> {
    let middle = Pose::new(x, y, heading);
    let (along, across) = (CAR.length() / 2.0, CAR.width / 2.0);
    [(along, across), (-along, across), (-along, -across), (along, -across)]
        .map(|(ahead, left)| middle.to_world(Point::new(ahead, left)))
        .to_vec()
}

/// The rear axle of a car whose middle is here.
fn centred(x: f64, y: f64, heading: f64) -> Pose {
    Pose::new(x, y, heading).advance(0.0, -CAR.middle())
}

/// A kerb slot `slack` longer than the car, on a street this wide beside the parked cars; these stand up to 15 cm off and
/// are tilted by up to 0.03 rad.
pub(crate) fn kerb(seed: u64, slack: (f64, f64), street: (f64, f64)) -> Scene {
    let mut r = Random::new(seed);
    let (slack, street) = (r.between(slack.0, slack.1), r.between(street.0, street.1));
    let (lane, from) = (2.2, 12.0);
    let to = from + CAR.length() + slack;
    let mut beside = |x: f64| {
        let (y, tilt) = (lane / 2.0 + r.between(-0.15, 0.15), r.between(-0.03, 0.03));
        // Its nearest corner stays where the slot ends.
        let reach = CAR.length() / 2.0 + CAR.width / 2.0 * math::sin(tilt.abs());
        parked(if x < from + 1.0 { x - reach } else { x + reach }, y, tilt)
    };
    let solids = [beside(from), beside(to)];
    let start =
        Pose::new(r.between(3.0, 22.0), lane + r.between(0.3 * street, 0.7 * street), r.between(-0.1, 0.1));
    let goal = centred(f64::midpoint(from, to), lane / 2.0 + r.between(-0.05, 0.05), 0.0);
    let name = format!("kerb +{slack:.2} m, street {street:.2} m");
    scene(name, &solids, rectangle(0.0, 0.0, 34.0, lane + street), [start, goal])
}

/// A bay `slack` wider than the car between parked cars, on an aisle this wide; head in or reverse in.
pub(crate) fn bay(seed: u64, slack: (f64, f64), aisle: (f64, f64)) -> Scene {
    let mut r = Random::new(seed);
    let (slack, aisle) = (r.between(slack.0, slack.1), r.between(aisle.0, aisle.1));
    let (depth, at) = (5.0, 14.0);
    let side = CAR.width + slack / 2.0 + 0.02;
    let mut beside =
        |x: f64| parked(x, depth / 2.0 + r.between(-0.15, 0.15), math::PI / 2.0 + r.between(-0.02, 0.02));
    let solids = [beside(at - side), beside(at + side)];
    let heading = if r.between(0.0, 1.0) < 0.5 { math::PI / 2.0 } else { -math::PI / 2.0 };
    let start =
        Pose::new(r.between(3.0, 24.0), depth + r.between(0.35 * aisle, 0.65 * aisle), r.between(-0.1, 0.1));
    let goal = centred(at, depth / 2.0, heading);
    let name = format!("bay +{slack:.2} m, aisle {aisle:.2} m");
    scene(name, &solids, rectangle(0.0, 0.0, 30.0, depth + aisle), [start, goal])
}

/// Two lanes of these widths that meet in a right angle.
pub(crate) fn corner(seed: u64, width: (f64, f64)) -> Scene {
    let mut r = Random::new(seed);
    let (one, two) = (r.between(width.0, width.1), r.between(width.0, width.1));
    let (along, up) = (16.0, 16.0);
    let floor = [(0.0, 0.0), (along, 0.0), (along, up), (along - two, up), (along - two, one), (0.0, one)];
    let start = Pose::new(2.0, one / 2.0, 0.0);
    let goal = Pose::new(along - two / 2.0, up - 5.0, math::PI / 2.0);
    let name = format!("corner {one:.2} m, {two:.2} m");
    scene(name, &[], floor.map(|(x, y)| Point::new(x, y)).to_vec(), [start, goal])
}
