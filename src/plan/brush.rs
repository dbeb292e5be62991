//! The cells under a planner's brush, apart from those that other obstacles block.

use super::world::{World, brushed, shapes};
use crate::map::{Occupancy, raster};
use crate::scenario::Scenario;

/// Cells covered by the brush, kept apart from the other obstacles.
///
/// Both maps have the frame of the planner's own.
pub(super) struct Brush {
    /// Cells that other obstacles block.
    pub(super) others: Occupancy,
    /// Cells under the brush.
    pub(super) covered: Occupancy,
    /// True if the scene and its exact geometry are behind.
    pub(super) stale: bool,
}

impl Brush {
    pub(super) fn new(scenario: &Scenario, world: &World) -> Self {
        let mut covered = Occupancy::new(world.frame.width, world.frame.height);
        for runs in brushed(scenario) {
            raster::runs(&mut covered, runs);
        }
        Self { others: shapes(scenario, &world.geometry, &world.frame), covered, stale: false }
    }
}
