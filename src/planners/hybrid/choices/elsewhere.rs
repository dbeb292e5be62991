//! What the same planner finds by other settings.
//!
//! Other prices, or more margin, lead the lattices elsewhere, and now and then upon a path that is cheaper by the
//! settings asked for: 5 % to 40 % cheaper in one scene of ten, most often with fewer gear changes. Which settings do
//! so differs from scene to scene, and nothing in the first answer tells where. So a plan that waits for better paths
//! asks them all.

use super::{Goes, Run};
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::profile::Profile;
use crate::planners::hybrid::question::Query;
use crate::planners::hybrid::report::Report;
use crate::planners::hybrid::search_alone;
use crate::search::Progress;

/// A margin that keeps a car out of narrow ways, metres.
const WIDE_MARGIN: f64 = 0.3;
/// A weight of nearness to obstacles that keeps it away from them.
const OBSTACLE_COST: f64 = 1.0;
/// A price of gear changes that is worth a detour, metres.
const CHANGE_COST: f64 = 5.0;
/// The same of a metre in reverse.
const REVERSE_COST: f64 = 2.0;

/// Settings that lead elsewhere than these.
fn others(config: Config) -> impl Iterator<Item = Config> {
    let others = [
        Config { profile: Profile::Comfort, ..config },
        Config { obstacle_cost: OBSTACLE_COST, ..config },
        Config { direction_change_cost: CHANGE_COST, ..config },
        Config { reverse_cost: REVERSE_COST, ..config },
        Config { profile: Profile::Shortest, ..config },
        Config { margin: config.margin.max(WIDE_MARGIN), ..config },
    ];
    others.into_iter().filter(move |other| other.with_profile() != config.with_profile())
}

impl Run<'_, '_> {
    /// The paths that other settings find, to the goal at which the first ends.
    pub(super) fn elsewhere(&mut self) -> Goes {
        let config = *self.search.config;
        if !config.ladder || config.first_shot {
            return Goes::Continue(());
        }
        let arrived = self.search.arrived(&self.first.arcs);
        let query = Query { goal: self.search.world(arrived.goal), ..*self.search.query };
        for other in others(config) {
            let before = self.work.report.stats.expanded;
            let earlier = self.work.progress.as_ref().map_or(0, Progress::earlier);
            if let Some(progress) = self.work.progress {
                progress.continue_after(earlier.saturating_add(before));
            }
            let path = search_alone(&query, &other, self.work.scratch, false, self.work.progress);
            if let Some(progress) = self.work.progress {
                progress.continue_after(earlier);
            }
            self.work.report.stats.add(path.stats);
            self.work.report.collision_checks += path.collision_checks;
            if self.work.progress.as_ref().is_some_and(Progress::is_stopped) {
                return Goes::Break(());
            }
            if path.arcs.is_empty() {
                continue;
            }
            let (stats, margin) = (self.work.report.stats, path.margin.min(config.margin));
            self.take(Report { margin, stats, ..path })?;
        }
        Goes::Continue(())
    }
}
