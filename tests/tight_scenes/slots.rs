//! Slots at a kerb, and in a row beside an aisle.

use std::iter;

use parkade::geometry::{Pose, math};
use parkade::vehicle::Vehicle;

use super::{Random, Range, Scene, box_of, first_clear, obstacles, parked, reach, rear_axle};

/// Of the street or aisle, metres.
const LENGTH: f64 = 34.0;

/// A kerb slot `slack` longer than the car in a row of parked cars, on a street this wide beside the row; the
/// neighbours stand up to 15 cm off and are tilted by up to 0.03 rad.
pub(crate) fn kerb(car: &Vehicle, seed: u64, slack: Range, street: Range) -> Scene {
    let mut r = Random::new(seed);
    let (slack, street) = (r.between(slack), r.between(street));
    let (lane, middle) = (car.width + 0.3, LENGTH / 2.0);
    let mut beside = |side: f64| {
        let (out, tilt) = (r.around(0.15), r.around(0.03));
        // Its nearest corner is where the slot ends.
        let first = car.length() / 2.0 + slack / 2.0 + reach(car.length(), car.width, tilt);
        row(first, out, tilt, car.length() + 0.8)
            .map(|(away, out, tilt)| Pose::new(middle + side * away, lane / 2.0 + out, tilt))
            .map(|middle| parked(car, middle))
            .collect::<Vec<_>>()
    };
    let solids = [beside(-1.0), beside(1.0)].concat();
    let outlines = (solids, box_of((0.0, 0.0), (LENGTH, lane + street)));
    let obstacles = obstacles(&outlines);
    let goal = rear_axle(car, Pose::new(middle, lane / 2.0 + r.around(0.05), 0.0));
    let start = first_clear(&obstacles, car, || {
        Pose::new(r.between((3.0, 24.0)), lane + r.between((0.2, 0.8)) * street, r.around(0.1))
    });
    Scene {
        name: format!("kerb +{slack:.2} m, street {street:.2} m"),
        vehicle: *car,
        obstacles,
        outlines,
        start,
        goal,
    }
}

/// A bay `slack` wider than the car in a row of parked cars, on an aisle this wide; head in or reverse in.
pub(crate) fn bay(car: &Vehicle, seed: u64, slack: Range, aisle: Range) -> Scene {
    bay_at("bay", car, seed, (math::FRAC_PI_2, math::FRAC_PI_2), slack, aisle)
}

/// As [`bay`], at 45° to 75° to the aisle.
pub(crate) fn angled(car: &Vehicle, seed: u64, slack: Range, aisle: Range) -> Scene {
    bay_at("angled", car, seed, (math::PI / 4.0, math::PI / 2.4), slack, aisle)
}

fn bay_at(kind: &str, car: &Vehicle, seed: u64, angle: Range, slack: Range, aisle: Range) -> Scene {
    let mut r = Random::new(seed);
    let (angle, slack, aisle) = (r.between(angle), r.between(slack), r.between(aisle));
    let (sin, cos) = math::sin_cos(angle);
    let depth = car.length() * sin + car.width * cos + 0.3;
    let middle = Pose::new(LENGTH / 2.0, depth / 2.0, angle);
    let mut beside = |side: f64| {
        let (out, tilt) = (r.around(0.15), r.around(0.02));
        // Its nearest corner is on the slot's edge.
        let first = car.width / 2.0 + slack / 2.0 + reach(car.width, car.length(), tilt);
        row(first, out, tilt, car.width + 0.6)
            .map(|(away, out, tilt)| {
                Pose::new(middle.x + side * away / sin + out * cos, middle.y + out * sin, angle + tilt)
            })
            .map(|middle| parked(car, middle))
            .collect::<Vec<_>>()
    };
    let solids = [beside(-1.0), beside(1.0)].concat();
    let outlines = (solids, box_of((0.0, 0.0), (LENGTH, depth + aisle)));
    let obstacles = obstacles(&outlines);
    let mut either_way = || if r.chance(0.5) { 0.0 } else { math::PI };
    let (into, along) = (either_way(), either_way());
    let goal = rear_axle(car, Pose { heading: math::wrap(angle + into), ..middle });
    let start = first_clear(&obstacles, car, || {
        let across = depth + r.between((0.25, 0.75)) * aisle;
        Pose::new(r.between((4.0, 30.0)), across, math::wrap(along + r.around(0.1)))
    });
    let name = format!("{kind} {:.0}°, +{slack:.2} m, aisle {aisle:.2} m", angle.to_degrees());
    Scene { name, vehicle: *car, obstacles, outlines, start, goal }
}

/// The cars on one side of a slot, to the end of the street: how far their middles are from its own, how far they stand
/// out and how they are tilted. The first is as given, the others follow as straight as they should.
fn row(first: f64, out: f64, tilt: f64, pitch: f64) -> impl Iterator<Item = (f64, f64, f64)> {
    let others = (1..).map(move |at| (first + f64::from(at) * pitch, 0.0, 0.0));
    iter::once((first, out, tilt)).chain(others).take_while(|(away, ..)| *away < LENGTH / 2.0)
}
