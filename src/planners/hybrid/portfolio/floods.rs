//! The rasters of the obstacle heuristic, shared by all members of the portfolio with the same margin and end.
//!
//! Making such a raster, a flood, goes through every cell of the map; ten members would make ten or twenty. A flood
//! depends on two things only: the margin, and the end from which it spreads. So each pair has one, made when it is
//! first asked for. A plan that succeeds on the first level usually makes a single flood.
//!
//! `ends[0]` is the target of the tree that is asked for; a swapped search uses `ends[1]`.

use core::cell::OnceCell;

use crate::geometry::Pose;
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::flood_memory::FloodMemory;
use crate::planners::hybrid::lattices::FIRST_SHUFFLING_LEVEL;
use crate::planners::hybrid::obstacle_heuristic::ObstacleHeuristic;
use crate::planners::hybrid::question::{MIN_MARGIN, Query};

/// Margins tried where no way keeps the one asked for, metres.
const FALLBACK_MARGINS: [f64; 4] = [0.05, 0.03, 0.01, MIN_MARGIN];

/// The estimates' rasters from both ends for each margin, made when they are needed first.
pub(in crate::planners::hybrid) struct Floods<'a> {
    query: &'a Query<'a>,
    /// Towards which the tree grows, and from where.
    ends: [Pose; 2],
    pub(super) margins: Vec<f64>,
    made: Vec<[OnceCell<ObstacleHeuristic>; 2]>,
}

impl<'a> Floods<'a> {
    /// For the margin asked for and, where the settings allow it, less. The first flood is that of `memory`.
    pub(in crate::planners::hybrid) fn new(
        query: &'a Query<'a>,
        config: &Config,
        ends: [Pose; 2],
        asked: f64,
        memory: &FloodMemory,
    ) -> Self {
        let mut margins = vec![asked];
        if config.levels() > FIRST_SHUFFLING_LEVEL {
            margins.extend(FALLBACK_MARGINS.into_iter().filter(|&margin| margin < asked));
        }
        let floods = Self::with(query, ends, margins);
        floods.get_from(0, false, Some(memory));
        floods
    }

    /// For these margins.
    pub(in crate::planners::hybrid) fn with(
        query: &'a Query<'a>,
        ends: [Pose; 2],
        margins: Vec<f64>,
    ) -> Self {
        let mut made = Vec::new();
        made.resize_with(margins.len(), Default::default);
        Self { query, ends, margins, made }
    }

    /// The flood for a margin's index, towards the first end or, if swapped, the second; made at the first call.
    pub(in crate::planners::hybrid) fn get(&self, margin: usize, is_swapped: bool) -> &ObstacleHeuristic {
        self.get_from(margin, is_swapped, None)
    }

    /// Towards the first end, or the second, with one of the margins.
    #[inline(never)]
    fn get_from(&self, margin: usize, is_swapped: bool, memory: Option<&FloodMemory>) -> &ObstacleHeuristic {
        let (Query { obstacles, vehicle, .. }, end) = (self.query, usize::from(is_swapped));
        self.made[margin][end].get_or_init(|| {
            ObstacleHeuristic::new(obstacles, vehicle, self.ends[end], self.margins[margin], memory)
        })
    }

    /// The largest margin with which a disc of the car's width gets from end to end.
    pub(in crate::planners::hybrid) fn widest(&self) -> Option<(usize, &ObstacleHeuristic)> {
        let reaches = |&at: &usize| self.get(at, false).distance(self.ends[1]).is_finite();
        (0..self.margins.len()).find(reaches).map(|at| (at, self.get(at, false)))
    }

    /// The margin at an index, metres; indices grow as margins fall.
    pub(in crate::planners::hybrid) fn margin(&self, at: usize) -> f64 {
        self.margins[at]
    }

    /// How many margins there are.
    pub(in crate::planners::hybrid) fn count(&self) -> usize {
        self.margins.len()
    }

    /// The least margin.
    pub(in crate::planners::hybrid) fn least(&self) -> f64 {
        self.margins[self.margins.len() - 1]
    }

    /// Bytes of the rasters made so far.
    pub(in crate::planners::hybrid) fn bytes(&self) -> u64 {
        self.made.iter().flatten().filter_map(OnceCell::get).map(ObstacleHeuristic::bytes).sum()
    }
}
