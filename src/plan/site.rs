//! Planners of hybrid A* that share what is prepared of their scene.
//!
//! Plans are those of planners made alone, to the last counter: only what is computed twice otherwise is shared.

use serde_json::{Map, Value};

use super::hybrid::{Ground, HybridEngine};
use super::world::World;
use super::{Planner, settings};
use crate::error::Error;
use crate::planners::registry::{PlannerId, Settings};
use crate::scenario::Scenario;

/// A scene that is prepared once for several planners of hybrid A*.
pub(crate) struct Site {
    scenario: Scenario,
    world: World,
    ground: Ground,
}

impl Site {
    /// # Errors
    /// Of a wrong scene, or one that is too large for a car to drive in.
    pub(crate) fn new(scenario: &Scenario) -> Result<Self, Error> {
        let world = World::new(scenario)?;
        let ground = Ground::new(&world)?;
        Ok(Self { scenario: scenario.clone(), world, ground })
    }

    /// The same site where the car in one of the slots is gone.
    ///
    /// # Errors
    /// Of a wrong scene.
    pub(crate) fn with_free_slot(&self, slot: usize) -> Result<Self, Error> {
        let mut scenario = self.scenario.clone();
        scenario.slots[slot].occupied = false;
        let world = World::new(&scenario)?;
        let ground = self.ground.variant(&world)?;
        Ok(Self { scenario, world, ground })
    }

    /// The planner `id`, as [`Planner::new`] makes it.
    ///
    /// # Errors
    /// Of a wrong setting.
    pub(crate) fn planner(&self, id: &str, config: &Map<String, Value>) -> Result<Planner, Error> {
        let kind = PlannerId::of(id)?;
        let Settings::Hybrid(config) = settings(kind, &self.scenario, config)? else {
            return Planner::new(id, &self.scenario, config);
        };
        let engine = Box::new(HybridEngine::on(self.ground.clone(), kind, config));
        Ok(Planner::of_parts(kind, self.scenario.clone(), self.world.clone(), engine))
    }
}
