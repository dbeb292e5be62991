//! Lanes that meet, clutter, and garages.

use parkade::geometry::{Point, Pose, math};
use parkade::vehicle::Vehicle;

use super::{Random, Range, Scene, box_of, first_clear, obstacles, parked, rear_axle, turned_box};

/// Two lanes of these widths that meet in a right angle: that in which the car starts, and that in which it ends.
pub(crate) fn corner(car: &Vehicle, seed: u64, first: Range, second: Range) -> Scene {
    let mut r = Random::new(seed);
    let (first, second) = (r.between(first), r.between(second));
    let side = 16.0;
    let floor =
        [(0.0, 0.0), (side, 0.0), (side, side), (side - second, side), (side - second, first), (0.0, first)];
    let outlines = (Vec::new(), floor.map(|(x, y)| Point::new(x, y)).to_vec());
    let obstacles = obstacles(&outlines);
    // Off the middle and turned, the car keeps a third of its room.
    let mut off = |width: f64| {
        let most = (width - car.width) / 6.0;
        (r.around(most), r.around((most / car.rear_to_front).min(0.05)))
    };
    let ((y, start_turn), (x, goal_turn)) = (off(first), off(second));
    let start = Pose::new(2.0, first / 2.0 + y, start_turn);
    let goal = Pose::new(side - second / 2.0 + x, side - 5.5, math::FRAC_PI_2 + goal_turn);
    Scene {
        name: format!("corner {first:.2} m, {second:.2} m"),
        vehicle: *car,
        obstacles,
        outlines,
        start,
        goal,
    }
}

/// Boxes and poles at random, between random poses at least 8 m apart.
pub(crate) fn cluttered(car: &Vehicle, seed: u64) -> Scene {
    let mut r = Random::new(seed);
    let (wide, high, count) = (26.0, 20.0, 10 + r.below(15));
    let mut thing = || {
        let size = if r.chance(0.3) { (0.2, 0.5) } else { (0.8, 4.5) };
        let middle = Pose::new(r.between((0.0, wide)), r.between((0.0, high)), r.around(math::PI));
        let length = r.between(size);
        turned_box(middle, length, length * r.between((0.3, 1.0)))
    };
    let solids = (0..count).map(|_| thing()).collect();
    let outlines = (solids, box_of((-1.0, -1.0), (wide + 1.0, high + 1.0)));
    let obstacles = obstacles(&outlines);
    let mut anywhere = || Pose::new(r.between((0.0, wide)), r.between((0.0, high)), r.around(math::PI));
    let start = first_clear(&obstacles, car, &mut anywhere);
    let goal = first_clear(&obstacles, car, || {
        std::iter::repeat_with(&mut anywhere)
            .find(|pose| (pose.point() - start.point()).norm() >= 8.0)
            .expect("endless")
    });
    Scene { name: format!("cluttered with {count}"), vehicle: *car, obstacles, outlines, start, goal }
}

/// Rows of bays on two aisles that lanes at both sides join: a pillar after every second or third bay, nine of ten bays
/// taken.
pub(crate) fn garage(car: &Vehicle, seed: u64) -> Scene {
    let mut r = Random::new(seed);
    let (slack, aisle, lane) = (r.between((0.3, 0.7)), r.between((4.5, 6.5)), r.between((4.0, 6.0)));
    let (pitch, depth) = (car.width + slack, car.length() + 0.3);
    let (bays, pillar, inset) = (2 + r.below(2), r.between((0.3, 0.5)), r.between((0.1, 0.9)));
    let module = bays as f64 * pitch + pillar;
    let modules = 12 / bays;
    // Below each row, and whether its bays open upwards.
    let rows = [
        (0.0, true),
        (depth + aisle, false),
        (2.0 * depth + aisle, true),
        (3.0 * depth + 2.0 * aisle, false),
    ];
    let mut places = Vec::new();
    let mut solids = Vec::new();
    for (low, is_upwards) in rows {
        for at in 0..=modules {
            let left = lane + at as f64 * module;
            let front = if is_upwards { low + depth - inset - pillar } else { low + inset };
            solids.push(box_of((left, front), (left + pillar, front + pillar)));
            let bays = if at == modules { 0 } else { bays };
            let middles = (0..bays).map(|bay| left + pillar + (bay as f64 + 0.5) * pitch);
            places.extend(middles.map(|x| Pose::new(x, low + depth / 2.0, math::FRAC_PI_2)));
        }
    }
    let chosen = r.below(places.len());
    for (at, place) in places.iter().enumerate() {
        if at != chosen && r.chance(0.9) {
            let (x, y) = (place.x + r.around(0.05), place.y + r.around(0.15));
            solids.push(parked(car, Pose::new(x, y, place.heading + r.around(0.02))));
        }
    }
    let (right, top) = (2.0 * lane + modules as f64 * module + pillar, rows[3].0 + depth);
    let outlines = (solids, box_of((0.0, 0.0), (right, top)));
    let obstacles = obstacles(&outlines);
    let way = if r.chance(0.5) { math::FRAC_PI_2 } else { -math::FRAC_PI_2 };
    let goal = rear_axle(car, Pose { heading: way, ..places[chosen] });
    let aisles = [depth, 3.0 * depth + aisle];
    let start = first_clear(&obstacles, car, || {
        let across = aisles[r.below(2)] + r.between((0.25, 0.75)) * aisle;
        let way = if r.chance(0.5) { 0.0 } else { math::PI };
        Pose::new(r.between((2.0, right - 2.0)), across, math::wrap(way + r.around(0.1)))
    });
    let name = format!("garage +{slack:.2} m, aisle {aisle:.2} m, pillars after {bays} bays");
    Scene { name, vehicle: *car, obstacles, outlines, start, goal }
}
