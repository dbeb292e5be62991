//! The way around obstacles for a point: a lower bound on the car's way, from one flood of the lattice.

use crate::geometry::Point;
use crate::map::{Cell, Frame};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::Obstacles;

/// An eight-connected way is at most 1 / cos(π/8) = 1 / 0.924 longer than a straight one; 0.98 is a little greedy.
const DETOUR: f64 = 0.98;
/// Costs of a straight and a diagonal step; 7/5 is just below √2.
const STRAIGHT: u32 = 5;
const DIAGONAL: u32 = 7;
const UNREACHED: u32 = u32::MAX;

/// Distances to one point over the lattice of the obstacles' distance field.
pub(super) struct Flood {
    frame: Frame,
    steps: Vec<u32>,
    scale: f64,
}

impl Flood {
    /// Floods from `target`. A cell is closed where even the largest disc around the rear axle inside the body cannot
    /// be, wherever in the cell it is.
    pub(super) fn new(obstacles: &Obstacles, vehicle: &Vehicle, target: Point) -> Self {
        let frame = *obstacles.frame();
        let inner = (vehicle.width / 2.0).min(vehicle.rear_to_back).min(vehicle.rear_to_front);
        let closed_below = (inner - 2.0 * core::f64::consts::SQRT_2 * frame.resolution) as f32;
        let open: Vec<bool> = obstacles.field().data.iter().map(|&d| d >= closed_below).collect();
        let steps = frame.cell_at(target).map_or_else(Vec::new, |cell| spread(&frame, &open, cell));
        Self { frame, steps, scale: frame.resolution * DETOUR / f64::from(STRAIGHT) }
    }

    /// A lower bound on the way from `point`, metres; infinite where there is no way.
    pub(super) fn distance(&self, point: Point) -> f64 {
        let cell = self.frame.cell_at(point);
        match cell.and_then(|c| self.steps.get(self.frame.index(c))) {
            None | Some(&UNREACHED) => f64::INFINITY,
            Some(&steps) => f64::from(steps) * self.scale,
        }
    }
}

/// Dijkstra with a ring of buckets: no step costs more than [`DIAGONAL`].
fn spread(frame: &Frame, open: &[bool], from: Cell) -> Vec<u32> {
    let mut steps = vec![UNREACHED; open.len()];
    let mut ring: [Vec<u32>; DIAGONAL as usize + 1] = Default::default();
    let source = frame.index(from);
    steps[source] = 0;
    ring[0].push(source as u32);
    let (mut now, mut waiting) = (0_u32, 1_usize);
    let width = frame.width as i32;
    while waiting > 0 {
        let slot = now as usize % ring.len();
        let batch = core::mem::take(&mut ring[slot]);
        waiting -= batch.len();
        for &at in &batch {
            if steps[at as usize] != now {
                continue;
            }
            let cell = frame.cell(at as usize);
            for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)] {
                let next = cell.offset(dx, dy);
                if !frame.contains(next) {
                    continue;
                }
                let index = (next.y * width + next.x) as usize;
                let cost = now + if dx != 0 && dy != 0 { DIAGONAL } else { STRAIGHT };
                if open[index] && cost < steps[index] {
                    steps[index] = cost;
                    ring[cost as usize % ring.len()].push(index as u32);
                    waiting += 1;
                }
            }
        }
        now += 1;
    }
    steps
}
