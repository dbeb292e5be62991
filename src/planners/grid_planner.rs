//! What a search over cells has to offer to be a planner.

use super::parameters::Parameters;
use super::query::{GridReport, GridScratch, Query};
use super::risk_field::config::Config as RiskFieldConfig;
use super::settings::Common;
use crate::map::Bits;
use crate::search::Observers;
use crate::search::Recording;

/// A query, with what was prepared of its map.
#[derive(Clone, Copy)]
pub(crate) struct Prepared<'a> {
    pub(crate) query: Query<'a>,
    /// The map's jump bitmaps, if the planner [needs them](GridPlanner::needs_bits).
    pub(crate) bits: Option<&'a Bits>,
}

/// A search over cells with its settings, as a row of the registry makes it.
///
/// It is called once for a plan, so it may be a trait object; what runs once for an expansion is generic below it.
pub(crate) trait GridPlanner: Parameters + Send {
    /// The settings that all grid planners share.
    fn common(&self) -> Common;

    /// The search.
    fn run(&self, at: Prepared, scratch: &mut GridScratch, observers: &mut Observers) -> GridReport;

    /// The search once more with its events written down, at most `limit` of them. The small module cannot.
    fn record(&self, at: Prepared, limit: usize) -> Option<Recording>;

    /// The settings of the risk field that leads the search; `None` without one.
    fn risk_field(&self) -> Option<&RiskFieldConfig> {
        None
    }

    /// True if it searches jump bitmaps.
    fn needs_bits(&self) -> bool {
        false
    }
}

/// Makes settings a [`GridPlanner`], by the functions of their module that plan and record with them.
macro_rules! grid_planner {
    ($settings:ty: $plan:path, $record:path $(; $($more:item)*)?) => {
        impl $crate::planners::grid_planner::GridPlanner for $settings {
            fn common(&self) -> $crate::planners::settings::Common {
                self.common
            }

            fn run(
                &self,
                at: $crate::planners::grid_planner::Prepared,
                scratch: &mut $crate::planners::query::GridScratch,
                observers: &mut $crate::search::Observers,
            ) -> $crate::planners::query::GridReport {
                $plan(at.query, self, scratch, observers)
            }

            fn record(
                &self,
                at: $crate::planners::grid_planner::Prepared,
                limit: usize,
            ) -> Option<$crate::search::Recording> {
                $crate::IS_COMPLETE.then(|| $record(at.query, self, limit))
            }

            $($($more)*)?
        }
    };
}
pub(super) use grid_planner;
