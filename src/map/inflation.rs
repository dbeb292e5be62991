//! Safety space: cells that the car's width takes away.
//!
//! A grid planner moves a point. A disc of radius r fits where that point keeps the distance r from every obstacle,
//! so all cells that are closer are blocked before the search (*necessary* safety space, Hu et al. 2024, 2.2).
//! Distances come from one exact distance transform: O(cells) for the whole map. Other free cells that a car had
//! better not enter are *redundant* space; they are closed by the planner's settings and stay free for the
//! collision check.

use super::{Cell, Layer, Occupancy, distance};

/// State of a cell after inflation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Safety {
    /// Free.
    Free = 0,
    /// Blocked by an obstacle.
    Obstacle = 1,
    /// Too near to an obstacle for the car's middle.
    Necessary = 2,
    /// Closed although free: a dead end or too narrow.
    Redundant = 3,
}

/// The map with necessary space blocked: every cell whose centre is closer than `radius` cells to the square of a
/// blocked cell. A radius of at most half a cell changes nothing.
pub fn necessary(map: &Occupancy, radius: f64) -> Occupancy {
    let mut inflated = map.clone();
    let distances = distance::to_squares(map);
    let limit = 4.0 * (radius * radius);
    for (index, &d) in distances.data.iter().enumerate() {
        if (d as f64) < limit {
            inflated.set(map.cell(index as u32), true);
        }
    }
    inflated
}

/// Each cell's [`Safety`] as a number, from the map and its inflated form.
pub fn layer(map: &Occupancy, inflated: &Occupancy) -> Layer<u8> {
    let mut layer = map.layer();
    for (index, value) in layer.data.iter_mut().enumerate() {
        let cell: Cell = map.cell(index as u32);
        if *value == 0 && inflated.blocked(cell) {
            *value = Safety::Necessary as u8;
        }
    }
    layer
}

/// Each cell's [`Safety`] as a number, from the map, its inflated form and the form with redundant cells closed, too.
pub fn layers(map: &Occupancy, inflated: &Occupancy, closed: &Occupancy) -> Layer<u8> {
    let mut layer = layer(map, inflated);
    for (index, value) in layer.data.iter_mut().enumerate() {
        if *value == 0 && closed.blocked(map.cell(index as u32)) {
            *value = Safety::Redundant as u8;
        }
    }
    layer
}

/// Brings the inflated form, and its bits, up to date after `changed` was blocked or freed in `map`.
pub fn update(
    map: &Occupancy,
    inflated: &mut Occupancy,
    radius: f64,
    changed: Cell,
    mut bits: Option<&mut super::Bits>,
) {
    let limit = 4.0 * (radius * radius);
    let reach = (radius + 0.5).ceil() as i32;
    // Four times the squared distance from a cell's centre to another cell's square.
    let near = |dx: i32, dy: i32| {
        let side = |d: i32| f64::from((2 * d.abs() - 1).max(0));
        side(dx) * side(dx) + side(dy) * side(dy) < limit
    };
    let around = || (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (dx, dy)));
    let blocked = map.blocked(changed);
    for (dx, dy) in around().filter(|&(dx, dy)| (dx, dy) == (0, 0) || near(dx, dy)) {
        let cell = changed.offset(dx, dy);
        if !map.contains(cell) {
            continue;
        }
        let value = blocked
            || map.blocked(cell)
            || around().any(|(x, y)| near(x, y) && map.is_obstacle(cell.offset(x, y)));
        inflated.set(cell, value);
        if let Some(bits) = &mut bits {
            bits.follow(inflated, cell);
        }
    }
}
