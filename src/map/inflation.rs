//! Safety space: cells that the car's width takes away.

use super::{Cell, Layer, Occupancy, distance};

/// What a cell is after inflation.
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
