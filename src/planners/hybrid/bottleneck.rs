//! The gap to name when the body fits through nowhere: the narrowest place of the widest way.
//!
//! It is found by a widest-path search over the cells of a distance field. The search is like Dijkstra's, but the value
//! of a way is its least clearance instead of the sum of its steps, and the largest value is taken first. The cell with
//! the least clearance on the widest way is the gap: every other way has a narrower one.
//!
//! Let c(n) be the clearance of cell n. The width of a way is twice the least c along it, and the search maximises
//! it:
//!
//! ```text
//! w(n) = max over neighbours m of  min(w(m), c(n))
//! ```
//!
//! Cells are taken in order of falling w from an array of buckets, 2 cm each, so a flood costs O(cells). Two rasters
//! are used: the coarse one of the scene shows quickly where a closed wall leaves no way at all, and a raster of 5 cm
//! then finds the gap and measures it exactly.

use crate::geometry::{Point, Pose};
use crate::map::{Cell, Frame, Layer};
use crate::planners::Gap;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::Obstacles;

/// Side of a lattice cell on worlds that are small enough, metres.
const CELL_SIDE: f64 = 0.05;
/// Cells of the lattice, at most.
const MAX_CELLS: f64 = 1_500_000.0;
/// Anything narrower is a wall, not a gap, metres.
const MIN_GAP: f64 = 0.2;
/// Slots per metre of clearance when the widest way is looked for.
const BUCKETS_PER_METRE: f64 = 50.0;

/// The narrowest place of the widest way from start to goal, local, if it is narrower than the car.
/// The way is one of the body's middle. `None` where the gap is at least as wide as the body, narrower than 20 cm, or
/// where no way of any width exists: then a wall is in the way, not a gap.
pub(super) fn too_narrow(obstacles: &Obstacles, vehicle: &Vehicle, start: Pose, goal: Pose) -> Option<Gap> {
    let middle = Point::new((vehicle.rear_to_front - vehicle.rear_to_back) / 2.0, 0.0);
    let narrowest = |frame: &Frame, clearance: &Layer<f32>| {
        let from = frame.cell_at(start.to_world(middle))?;
        let to = frame.cell_at(goal.to_world(middle))?;
        bottleneck(frame, clearance, from, to)
    };
    // A closed wall shows on the coarse field at once.
    let (frame, clearance) = (obstacles.frame(), obstacles.field());
    if narrowest(frame, clearance).is_none_or(|at| clearance.data[frame.index(at)] == 0.0) {
        return None;
    }
    let (frame, clearance) = obstacles.lattice(CELL_SIDE, MAX_CELLS);
    let at = frame.center(narrowest(&frame, &clearance)?);
    let width = 2.0 * obstacles.distance(at, vehicle.width);
    (MIN_GAP..vehicle.width).contains(&width).then_some(Gap { width, at })
}

const NEIGHBOURS: [(i32, i32); 8] = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)];

fn neighbours(frame: &Frame, at: usize) -> impl Iterator<Item = usize> + '_ {
    let cell = frame.cell(at);
    NEIGHBOURS
        .iter()
        .map(move |&(dx, dy)| cell.offset(dx, dy))
        .filter(|&c| frame.contains(c))
        .map(|c| frame.index(c))
}

/// The narrowest cell of the widest way.
/// `None` where no way joins the two cells. O(cells); each cell enters the buckets once.
fn bottleneck(frame: &Frame, clearance: &Layer<f32>, from: Cell, to: Cell) -> Option<Cell> {
    let (from, to) = (frame.index(from), frame.index(to));
    let slot = |v: f32| (f64::from(v) * BUCKETS_PER_METRE) as usize;
    let widest = clearance.data.iter().copied().fold(0.0, f32::max);
    let mut slots = vec![Vec::new(); slot(widest) + 1];
    // For each reached cell, the narrowest cell on its way.
    let mut narrowest = vec![u32::MAX; frame.len()];
    narrowest[from] = from as u32;
    slots[slot(clearance.data[from])].push(from);
    let mut level = slot(clearance.data[from]);
    loop {
        let Some(at) = slots[level].pop() else {
            level = level.checked_sub(1)?;
            continue;
        };
        let before = narrowest[at];
        if at == to {
            return Some(frame.cell(before as usize));
        }
        for next in neighbours(frame, at) {
            if narrowest[next] == u32::MAX {
                let tighter = clearance.data[next] < clearance.data[before as usize];
                narrowest[next] = if tighter { next as u32 } else { before };
                let reach = slot(clearance.data[narrowest[next] as usize]);
                slots[reach.min(level)].push(next);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::collision::Solid;

    fn gap(width: f64) -> Option<Gap> {
        let rectangle = |x0: f64, y0: f64, x1: f64, y1: f64, owner| Solid {
            outline: [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Point::new(x, y)).to_vec(),
            owner,
        };
        let walls = [
            rectangle(14.0, 0.0, 15.0, 10.0 - width / 2.0, 1),
            rectangle(14.0, 10.0 + width / 2.0, 15.0, 20.0, 2),
        ];
        let hall = Obstacles::new(&[], &walls, &rectangle(0.0, 0.0, 30.0, 20.0, 0));
        too_narrow(&hall, &Vehicle::PAPER, Pose::new(3.0, 10.0, 0.0), Pose::new(22.0, 10.0, 0.0))
    }

    #[test]
    fn ten_centimetres_too_little_are_found_and_enough_is_not() {
        let found = gap(2.5).unwrap();
        assert!((found.width - 2.5).abs() < 0.08, "{found:?}");
        assert!((found.at.x - 14.5).abs() < 0.6 && (found.at.y - 10.0).abs() < 0.1, "{found:?}");
        assert_eq!(gap(2.75), None);
        assert_eq!(gap(4.0), None);
    }
}
