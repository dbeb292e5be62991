//! The shortest path, the quickest, and a cheaper one.
//!
//! The ordinary answer is found on a coarse lattice, or by greedy searches of finer ones. Here the estimate has no
//! extra weight, so that a search ends with the cheapest path of its lattice; and the finer the lattice, the cheaper
//! that is. What cannot be cheaper than the first path is left out.

use super::{Goes, Run};
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::lattices::Level;
use crate::planners::hybrid::profile::Profile;
use crate::planners::hybrid::question::Search;

/// Expansions of the searches for a shorter or a quicker path: of the coarsest lattice, …
const COARSE_EXPANSIONS: u32 = 10_000;
/// … of the one with half its steps, …
const HALF_STEPS_EXPANSIONS: u32 = 20_000;
/// … and of the level with fine ones.
const FINE_EXPANSIONS: u32 = 40_000;
const FINE_LEVEL: u32 = 2;
/// A path of a lattice winds, and may cost so many times what is left of it after the shortcut.
const WINDING: f64 = 1.2;

impl Run<'_, '_> {
    /// Paths that cost less by these prices of a gear change and of turning the wheel, and nothing else: on the
    /// coarsest lattice, with half its steps and with fine ones.
    pub(super) fn cheaper(&mut self, change: f64, steer_change: f64) -> Goes {
        let config = Config {
            profile: Profile::Shortest,
            reverse_cost: 1.0,
            direction_change_cost: change,
            steer_cost: 0.0,
            steer_change_cost: steer_change,
            obstacle_cost: 0.0,
            ..*self.search.config
        };
        let coarsest = config.level(0);
        self.optimal((coarsest, 0, COARSE_EXPANSIONS), &config)?;
        self.optimal((coarsest.halved(), 0, HALF_STEPS_EXPANSIONS), &config)?;
        self.by_fine_steps(config)
    }

    /// A path that costs less by these settings, with fine steps.
    pub(super) fn by_fine_steps(&mut self, config: Config) -> Goes {
        if config.levels() <= FINE_LEVEL {
            return Goes::Continue(());
        }
        let level = config.level(FINE_LEVEL).cheaply_tried(&config.level(0));
        self.optimal((level, FINE_LEVEL, FINE_EXPANSIONS), &config)
    }

    /// The cheapest path of a lattice, short of what the first costs, with room for the shortcut.
    fn optimal(&mut self, (level, number, most): (Level, u32, u32), config: &Config) -> Goes {
        let search = Search { config, ..self.search }.arrived(&self.first.arcs);
        let level = Level { extra_change: 0.0, weight: config.heuristic_weight.unwrap_or(1.0), ..level };
        let costs = search.costs().searching(&level);
        let bound = WINDING * costs.path(search.checker, search.start, &self.first.arcs);
        self.attempt(config, (Level { bound, ..level }, number, most), self.kept, false)?;
        Goes::Continue(())
    }
}
