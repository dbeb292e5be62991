//! A* on the grid with 4, 8, 16, 24 or 48 neighbours.
//!
//! Ties go to the smaller estimate, then to the newest entry, which keeps four-neighbour searches from flooding the
//! whole rectangle. Without a weight and with an admissible heuristic the path is the cheapest one.

use serde::{Deserialize, Serialize};
use std::cell::Cell as Counter;

use super::heuristics::{DistanceWeight, Heuristic};
use super::moves::{Move, Neighbourhood, legal_steps};
use super::query::{GridReport, GridScratch, Query};
use super::settings::{Inflation, MAX_EXPANSIONS, MinRadius, Post, Shared, SmoothMode};
use crate::error::{Error, ErrorCode};
use crate::map::{Cell, Corner, line_of_sight};
use crate::search::{Domain, Finish, Limits, NodeId, Observer, Relax, Visit, best_first};

/// What multiplies the estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Weight {
    /// Nothing: the cheapest path.
    #[default]
    None,
    /// 1 + distance to the goal / distance from start to goal (Hu et al. 2024, eq 12): faster, not always cheapest.
    Distance,
}

/// Settings of grid A*.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct Config {
    /// How the cost still to pay is estimated.
    pub heuristic: Heuristic,
    /// What multiplies the estimate.
    pub weight: Weight,
    /// What a path may do at corners of blocked cells.
    pub corner: Corner,
    /// Room for the car.
    pub inflation: Inflation,
    /// Extra room, metres.
    pub margin: f64,
    /// What is done to the raw path.
    pub post: Post,
    /// How corners share the segment between them.
    pub smooth_mode: SmoothMode,
    /// Tightest arc of smoothing, cells.
    pub min_radius: MinRadius,
    /// Expansions after which the search gives up.
    pub max_expansions: u32,
}

impl Default for Config {
    fn default() -> Self {
        Self::new(Neighbourhood::Eight)
    }
}

impl Config {
    /// The defaults for a neighbourhood: the papers' baselines for four and eight.
    pub const fn new(neighbourhood: Neighbourhood) -> Self {
        Self {
            heuristic: match neighbourhood {
                Neighbourhood::Four => Heuristic::Manhattan,
                Neighbourhood::Eight => Heuristic::Euclid,
                _ => Heuristic::Gauge,
            },
            weight: Weight::None,
            corner: Corner::Strict,
            inflation: Inflation::None,
            margin: 0.0,
            post: Post::None,
            smooth_mode: SmoothMode::Dynamic,
            min_radius: MinRadius::Cells(1.0),
            max_expansions: MAX_EXPANSIONS,
        }
    }

    /// Checks every setting.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self, neighbourhood: Neighbourhood) -> Result<(), Error> {
        if !self.heuristic.is_admissible(neighbourhood) {
            let names = [Heuristic::Manhattan, Heuristic::Euclid, Heuristic::Octile, Heuristic::Gauge]
                .into_iter()
                .filter(|h| h.is_admissible(neighbourhood))
                .map(Heuristic::as_str);
            let rule = format!(
                "must be {} with {} neighbours, got {}",
                names.collect::<Vec<_>>().join(" or "),
                neighbourhood.moves().len(),
                self.heuristic.as_str()
            );
            return Err(Error::new(ErrorCode::Config, "heuristic", rule));
        }
        let Self { margin, min_radius, max_expansions, .. } = *self;
        Shared { margin, min_radius, max_expansions }.validate()
    }
}

struct Grid<'a> {
    query: Query<'a>,
    neighbourhood: Neighbourhood,
    moves: Vec<Move>,
    /// How many of the moves lead to one of the eight cells around.
    steps: usize,
    corner: Corner,
    heuristic: Heuristic,
    weight: Option<DistanceWeight>,
    los_calls: Counter<u32>,
}

impl Domain for Grid<'_> {
    type Cost = i64;
    type Label = Cell;
    type Tail = ();

    fn node_count(&self) -> usize {
        self.query.map.len()
    }

    fn successors<S: Relax<i64, Cell>>(&self, from: Visit<i64, Cell>, sink: &mut S) {
        let map = self.query.map;
        let free = map.free_around(from.label);
        let legal = legal_steps(free, self.corner);
        let stride = if self.neighbourhood == Neighbourhood::Four { 2 } else { 1 };
        let mut calls = 0;
        for (k, m) in self.moves[..self.steps].iter().enumerate() {
            let bit = 1 << (k * stride);
            if free & bit == 0 {
                continue;
            }
            let to = from.label.offset(m.dx, m.dy);
            let node = map.index(to);
            if sink.worth(node, m.cost) {
                calls += 1;
                if legal & bit != 0 {
                    sink.emit(node, m.cost, to);
                }
            }
        }
        for m in &self.moves[self.steps..] {
            let to = from.label.offset(m.dx, m.dy);
            if map.blocked(to) {
                continue;
            }
            let node = map.index(to);
            if sink.worth(node, m.cost) {
                calls += 1;
                if line_of_sight(map, from.label, to, self.corner) {
                    sink.emit(node, m.cost, to);
                }
            }
        }
        self.los_calls.set(self.los_calls.get() + calls);
    }

    fn heuristic(&self, _: NodeId, at: Cell) -> i64 {
        let (dx, dy) = (self.query.goal.x - at.x, self.query.goal.y - at.y);
        let h = self.heuristic.estimate(self.neighbourhood, dx, dy);
        self.weight.map_or(h, |weight| weight.apply(h, dx, dy))
    }

    fn finish(&mut self, at: Visit<i64, Cell>, _: i64) -> Option<Finish<i64, ()>> {
        (at.label == self.query.goal).then_some(Finish { cost: 0, tail: () })
    }
}

/// Searches a path over the cells of a map.
///
/// `config` must be valid for the neighbourhood ([`Config::validate`]); `observer` is `()` where nobody watches.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::grid_astar::{Config, plan};
/// use parkade::planners::moves::Neighbourhood;
/// use parkade::planners::query::{GridScratch, Query};
///
/// let map = Occupancy::parse("....\n.##.\n....");
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(3, 2) };
/// let eight = Neighbourhood::Eight;
/// let report = plan(query, eight, &Config::new(eight), &mut GridScratch::new(), &mut ());
/// assert_eq!(report.cost_micro, 5_000_000);
/// ```
pub fn plan<O: Observer<i64, Cell>>(
    query: Query,
    neighbourhood: Neighbourhood,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if let Some(report) = query.trivial() {
        return report;
    }
    let (dx, dy) = (query.goal.x - query.start.x, query.goal.y - query.start.y);
    let moves = neighbourhood.moves();
    let mut grid = Grid {
        query,
        neighbourhood,
        steps: moves.len().min(8),
        moves,
        corner: config.corner,
        heuristic: config.heuristic,
        weight: (config.weight == Weight::Distance).then(|| DistanceWeight::new(1000, dx, dy)),
        los_calls: Counter::new(0),
    };
    let root = (query.map.index(query.start), query.start);
    let limits = Limits { max_expansions: config.max_expansions, first: true };
    let search = best_first(&mut grid, root, limits, scratch, observer);
    GridReport::of(&query, &search, scratch, grid.los_calls.get())
}
