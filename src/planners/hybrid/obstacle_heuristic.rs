//! The way around obstacles for a disc, from one flood of the lattice: an estimate of the car's way.
//!
//! The body contains a disc as wide as itself. Wherever the car can drive, that disc can move; so the disc's
//! shortest way to the target is nearly a lower bound of the car's. One flood from the target over the cells of the
//! obstacles' distance field gives it for every place; a node of the search then reads it from a table.
//!
//! It is a little greedy, not a strict bound: cells count with eight neighbours, and places with hardly any room
//! count twice.
//!
//! In formulas, for a flood distance d (5 per straight step, 7 per diagonal one, twice that into narrow cells), cells
//! of side r, and the disc's centre a ahead of the rear axle:
//!
//! ```text
//! h = 0.98 · r · d/5 / √(1 + (κ·a)²)          κ: the largest curvature of the car
//! ```
//!
//! The root is there because the axle is what drives: when it moves by ds on the tightest arc, a point that lies a
//! ahead moves by ds·√(1 + (κa)²) at most. Dividing by it turns the way of the disc into a bound for the way of the
//! axle.
//!
//! A flood takes O(cells). Both the costs of the cells and the flood are kept for the next question ([`FloodMemory`]),
//! and used again if obstacles, radius and source are the same.

use super::flood::{Flood, Room, STRAIGHT, UNREACHED};
use super::flood_memory::FloodMemory;
use crate::geometry::{Point, Pose, Vector};
use crate::map::Cell;
use crate::planners::Region;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::Corridor;
use crate::vehicle::collision::Obstacles;

/// An eight-connected way is at most 1 / cos(π/8) = 1 / 0.924 longer than a straight one; 0.98 is a little greedy.
const DETOUR: f64 = 0.98;
/// Poses that touch something are free; so is their disc, metres.
const TOLERANCE: f64 = 1e-4;

/// Distances to one pose over the lattice of the obstacles' distance field.
///
/// The body holds a disc as wide as itself. Where no place in a cell has room for that disc, the car cannot go; and the
/// disc's way is hardly longer than the rear axle's.
#[derive(Debug)]
pub(super) struct ObstacleHeuristic {
    flood: Flood,
    scale: f64,
    /// Centre of the disc, metres ahead of the rear axle.
    ahead: f64,
}

impl ObstacleHeuristic {
    /// Bytes held.
    pub(super) fn bytes(&self) -> u64 {
        (size_of_val(&self.flood.steps[..]) + self.flood.ground.costs.len()) as u64
    }

    /// Floods from `target`, for a body grown by `margin`. What `memory` has of it is taken over.
    #[inline(never)]
    pub(super) fn new(
        obstacles: &Obstacles,
        vehicle: &Vehicle,
        target: Pose,
        margin: f64,
        memory: Option<&FloodMemory>,
    ) -> Self {
        let radius = (vehicle.width / 2.0).min(vehicle.length() / 2.0);
        // In a car as wide as it is long the two bounds are the same but for rounding, which may swap them.
        let ahead = (radius - vehicle.rear_to_back).max(0.0).min(vehicle.rear_to_front - radius);
        let swing = vehicle.max_curvature() * ahead;
        let stretch = (1.0 + swing * swing).sqrt();
        let scale = obstacles.frame().resolution * DETOUR / f64::from(STRAIGHT) / stretch;
        let source = obstacles.frame().cell_at(target.to_world(Point::new(ahead, 0.0)));
        let room = Room { obstacles, radius: radius + margin - TOLERANCE };
        let flood = memory
            .map_or_else(|| Flood::new(room.ground().into(), source), |known| known.flood(&room, source));
        Self { flood, scale, ahead }
    }

    /// The same flood where the disc's centre keeps within a corridor.
    pub(super) fn within(mut self, corridor: &Corridor) -> Self {
        let mut ground = (*self.flood.ground).clone();
        let frame = ground.frame;
        for (i, cost) in ground.costs.iter_mut().enumerate() {
            *cost *= u8::from(corridor.holds(frame.center(frame.cell(i))));
        }
        self.flood = Flood::new(ground.into(), self.flood.source);
        self
    }

    /// The middle of the disc at a pose.
    pub(super) fn disc(&self, at: Pose) -> Point {
        if self.ahead == 0.0 { at.point() } else { at.to_world(Point::new(self.ahead, 0.0)) }
    }

    /// The cell that holds the disc's centre at a pose; `None` off the raster.
    fn cell(&self, at: Pose) -> Option<Cell> {
        self.flood.ground.frame.cell_at(self.disc(at))
    }

    /// Squares of the lattice that the flood reached.
    pub(super) fn reached(&self) -> usize {
        self.flood.steps.iter().filter(|&&s| s != UNREACHED).count()
    }

    /// The region that the flood reached.
    pub(super) fn region(&self) -> Region {
        let Flood { ground, steps, .. } = &self.flood;
        let frame = &ground.frame;
        let mut runs: Vec<(Point, u32)> = Vec::new();
        let half = Vector::new(0.5, 0.5) * frame.resolution;
        let reached = |i: usize| steps[i] != UNREACHED;
        for i in (0..steps.len()).filter(|&i| reached(i)) {
            let cell = frame.cell(i);
            match runs.last_mut() {
                Some(run) if cell.x > 0 && reached(i - 1) => run.1 += 1,
                _ => runs.push((frame.center(cell) - half, 1)),
            }
        }
        Region { cell: frame.resolution, runs }
    }

    /// The way from a pose, metres: less than the car needs, but for narrow places; infinite where there is no way.
    pub(super) fn distance(&self, at: Pose) -> f64 {
        match self.cell(at).and_then(|c| self.flood.steps.get(self.flood.ground.frame.index(c))) {
            None | Some(&UNREACHED) => f64::INFINITY,
            Some(&steps) => f64::from(steps) * self.scale,
        }
    }
}
