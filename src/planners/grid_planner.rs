//! One of the grid planners with its settings.

use super::moves::Neighbourhood;
use super::parameters::{Field, Parameters as _};
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
#[cfg(feature = "complete")]
use super::{any_angle, bidirectional, dijkstra_greedy, genetic, jump_point, rrt};
use super::{grid_astar, risk_field};
use crate::error::Error;
#[cfg(feature = "complete")]
use crate::map::Bits;
#[cfg(feature = "complete")]
use crate::search::Recording;
use crate::search::Watch;

/// A grid planner with its settings.
pub(crate) enum GridPlanner {
    Neighbours(Neighbourhood, grid_astar::Config),
    RiskField(risk_field::Config),
    #[cfg(feature = "complete")]
    Bidirectional(bidirectional::Config),
    #[cfg(feature = "complete")]
    JumpPoint(jump_point::Config),
    #[cfg(feature = "complete")]
    AnyAngle(any_angle::Config),
    #[cfg(feature = "complete")]
    Dijkstra(dijkstra_greedy::Config),
    #[cfg(feature = "complete")]
    Greedy(dijkstra_greedy::Config),
    #[cfg(feature = "complete")]
    Rrt(rrt::Config),
    #[cfg(feature = "complete")]
    Genetic(genetic::Config),
}

impl GridPlanner {
    /// Grid A* with a neighbourhood.
    pub(super) fn around(neighbourhood: Neighbourhood) -> Self {
        Self::Neighbours(neighbourhood, grid_astar::Config::new(neighbourhood))
    }

    pub(super) fn fields(&mut self) -> Vec<Field<'_>> {
        match self {
            Self::Neighbours(_, config) => config.fields(),
            Self::RiskField(config) => config.fields(),
            #[cfg(feature = "complete")]
            Self::Bidirectional(config) => config.fields(),
            #[cfg(feature = "complete")]
            Self::JumpPoint(config) => config.fields(),
            #[cfg(feature = "complete")]
            Self::AnyAngle(config) => config.fields(),
            #[cfg(feature = "complete")]
            Self::Dijkstra(config) | Self::Greedy(config) => config.fields(),
            #[cfg(feature = "complete")]
            Self::Rrt(config) => config.fields(),
            #[cfg(feature = "complete")]
            Self::Genetic(config) => config.fields(),
        }
    }

    pub(super) fn validate(&self) -> Result<(), Error> {
        match self {
            Self::Neighbours(around, config) => config.validate_for(*around)?,
            Self::RiskField(config) => config.validate()?,
            #[cfg(feature = "complete")]
            Self::Rrt(config) => config.validate()?,
            #[cfg(feature = "complete")]
            Self::Genetic(config) => config.validate()?,
            #[cfg(feature = "complete")]
            _ => {}
        }
        self.common().validate()
    }

    /// The settings that all grid planners share.
    pub(crate) fn common(&self) -> Common {
        match self {
            Self::Neighbours(_, config) => config.common,
            Self::RiskField(config) => config.common,
            #[cfg(feature = "complete")]
            Self::Bidirectional(config) => config.common,
            #[cfg(feature = "complete")]
            Self::JumpPoint(config) => config.common,
            #[cfg(feature = "complete")]
            Self::AnyAngle(config) => config.common,
            #[cfg(feature = "complete")]
            Self::Dijkstra(config) | Self::Greedy(config) => config.common,
            #[cfg(feature = "complete")]
            Self::Rrt(config) => config.common,
            #[cfg(feature = "complete")]
            Self::Genetic(config) => config.common,
        }
    }

    /// True if it searches a map's bits.
    #[cfg(feature = "complete")]
    pub(crate) fn needs_bits(&self) -> bool {
        matches!(self, Self::JumpPoint(_))
    }

    pub(crate) fn run(
        &self,
        query: Query,
        #[cfg(feature = "complete")] bits: Option<&Bits>,
        scratch: &mut GridScratch,
        watch: &mut Watch,
    ) -> GridReport {
        match self {
            Self::Neighbours(around, config) => grid_astar::plan(query, *around, config, scratch, watch),
            Self::RiskField(config) => risk_field::plan(query, config, scratch, watch),
            #[cfg(feature = "complete")]
            Self::Bidirectional(config) => bidirectional::plan(query, config, scratch, watch),
            #[cfg(feature = "complete")]
            Self::JumpPoint(config) => {
                let bits = bits.expect("prepared before the search");
                jump_point::plan(query, bits, config, scratch, watch)
            }
            #[cfg(feature = "complete")]
            Self::AnyAngle(config) => any_angle::plan(query, config, scratch, watch),
            #[cfg(feature = "complete")]
            Self::Dijkstra(config) => dijkstra_greedy::dijkstra(query, config, scratch, watch),
            #[cfg(feature = "complete")]
            Self::Greedy(config) => dijkstra_greedy::greedy(query, config, scratch, watch),
            #[cfg(feature = "complete")]
            Self::Rrt(config) => rrt::plan(query, config, scratch, watch),
            #[cfg(feature = "complete")]
            Self::Genetic(config) => genetic::plan(query, config, scratch, watch),
        }
    }

    /// The search once more with its events written down, at most `limit` of them.
    #[cfg(feature = "complete")]
    pub(crate) fn record(&self, query: Query, bits: Option<&Bits>, limit: usize) -> Recording {
        match self {
            Self::Neighbours(around, config) => grid_astar::record(query, *around, config, limit),
            Self::RiskField(config) => risk_field::record(query, config, limit),
            Self::Bidirectional(config) => bidirectional::record(query, config, limit),
            Self::JumpPoint(config) => {
                let bits = bits.expect("prepared before the search");
                jump_point::record(query, bits, config, limit)
            }
            Self::Dijkstra(config) => dijkstra_greedy::record_dijkstra(query, config, limit),
            Self::Greedy(config) => dijkstra_greedy::record_greedy(query, config, limit),
            Self::AnyAngle(config) => any_angle::record(query, config, limit),
            Self::Rrt(config) => rrt::record(query, config, limit),
            Self::Genetic(config) => genetic::record(query, config, limit),
        }
    }
}
