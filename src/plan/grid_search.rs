//! One of the grid planners with its settings.

use serde_json::{Map, Value};

#[cfg(feature = "complete")]
use super::rasters::Rasters;
use crate::error::Error;
use crate::planners::moves::Neighbourhood;
use crate::planners::query::{GridReport, GridScratch, Query};
use crate::planners::registry::PlannerId;
use crate::planners::settings::Common;
#[cfg(feature = "complete")]
use crate::planners::{any_angle, bidirectional, dijkstra_greedy, genetic, jump_point, rrt};
use crate::planners::{grid_astar, risk_field};
#[cfg(feature = "complete")]
use crate::search::Recording;
use crate::search::Watch;

pub(super) enum Search {
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

impl Search {
    pub(super) fn new(kind: PlannerId, config: &Map<String, Value>) -> Result<Self, Error> {
        if let Some(around) = kind.neighbourhood() {
            let config = grid_astar::Config::new(around).with(config)?;
            config.validate_for(around)?;
            return Ok(Self::Neighbours(around, config));
        }
        Ok(match kind {
            #[cfg(feature = "complete")]
            PlannerId::Bidirectional => Self::Bidirectional(bidirectional::Config::default().with(config)?),
            #[cfg(feature = "complete")]
            PlannerId::JumpPoint => Self::JumpPoint(jump_point::Config::default().with(config)?),
            #[cfg(feature = "complete")]
            PlannerId::AnyAngle => Self::AnyAngle(any_angle::Config::default().with(config)?),
            #[cfg(feature = "complete")]
            PlannerId::Dijkstra => Self::Dijkstra(dijkstra_greedy::Config::default().with(config)?),
            #[cfg(feature = "complete")]
            PlannerId::Greedy => Self::Greedy(dijkstra_greedy::Config::default().with(config)?),
            #[cfg(feature = "complete")]
            PlannerId::Rrt => {
                let config = rrt::Config::default().with(config)?;
                config.validate()?;
                Self::Rrt(config)
            }
            #[cfg(feature = "complete")]
            PlannerId::Genetic => {
                let config = genetic::Config::default().with(config)?;
                config.validate()?;
                Self::Genetic(config)
            }
            kind => {
                let defaults = match kind {
                    #[cfg(feature = "complete")]
                    PlannerId::RiskFieldPlus => risk_field::Config::PLUS,
                    _ => risk_field::Config::default(),
                };
                let config = defaults.with(config)?;
                config.validate()?;
                Self::RiskField(config)
            }
        })
    }

    /// The settings that all grid planners share, not yet validated.
    pub(super) fn common(&self) -> Common {
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

    /// True if it searches [`Rasters::bits`].
    #[cfg(feature = "complete")]
    pub(super) fn needs_bits(&self) -> bool {
        matches!(self, Self::JumpPoint(_))
    }

    pub(super) fn run(
        &self,
        query: Query,
        #[cfg(feature = "complete")] rasters: &Rasters,
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
                let bits = rasters.bits().expect("prepared before the search");
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

    /// The search once more with its events written down, at most `limit` of them; `None` for planners without an open
    /// list of cells.
    #[cfg(feature = "complete")]
    pub(super) fn record(&self, query: Query, rasters: &Rasters, limit: usize) -> Option<Recording> {
        Some(match self {
            Self::Neighbours(around, config) => grid_astar::record(query, *around, config, limit),
            Self::RiskField(config) => risk_field::record(query, config, limit),
            Self::Bidirectional(config) => bidirectional::record(query, config, limit),
            Self::JumpPoint(config) => {
                let bits = rasters.bits().expect("prepared before the search");
                jump_point::record(query, bits, config, limit)
            }
            Self::Dijkstra(config) => dijkstra_greedy::record_dijkstra(query, config, limit),
            Self::Greedy(config) => dijkstra_greedy::record_greedy(query, config, limit),
            Self::AnyAngle(config) => any_angle::record(query, config, limit),
            Self::Rrt(_) | Self::Genetic(_) => return None,
        })
    }
}
