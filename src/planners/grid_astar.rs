//! A* on the grid with 4, 8, 16, 24 or 48 neighbours.
//!
//! Ties go to the smaller estimate, then to the newest entry, which keeps four-neighbour searches from flooding the
//! whole rectangle. Without a weight and with an admissible heuristic the path is the cheapest one.

use super::grid_lattice::Grid;
use super::grid_planner::{GridPlanner, Prepared};
use super::heuristics::{Chosen, DistanceWeight, Estimate, Euclid, Gauge16, Heuristic, Manhattan, Octile};
use super::moves::Neighbourhood;
use super::parameters::{Field, Form, ParameterSpec, parameters, spec};
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use super::weighted::Weighted;
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::json::{self, Words};
use crate::search::{Observer, Observers, one_way};
use crate::search::{Recording, record_one_way};

/// The factor on the estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Weight {
    /// Nothing: the cheapest path.
    #[default]
    None,
    /// 1 + distance to the goal / distance from start to goal (Hu et al. 2024, eq 12): faster, not always cheapest.
    Distance,
}

json::words!(Weight: "none" = None, "distance" = Distance);

/// Names of the heuristics allowed with four neighbours, with eight, and with more.
const CHOICES: [&[&str]; 3] = if IS_COMPLETE {
    [
        &["manhattan", "euclid", "octile", "chebyshev"],
        &["euclid", "octile", "chebyshev"],
        &["euclid", "gauge", "chebyshev"],
    ]
} else {
    [&["manhattan", "euclid", "octile"], &["euclid", "octile"], &["euclid", "gauge"]]
};

/// The heuristic's declarations: of four neighbours, of eight, of more.
const HEURISTIC_SPECS: [ParameterSpec; 3] = [
    spec(
        "heuristic",
        Form::Choice(CHOICES[0]),
        "1",
        false,
        ["Heuristic", "启发函数"],
        ["The paper's baseline uses Manhattan.", "论文基线为曼哈顿距离。"],
    ),
    spec(
        "heuristic",
        Form::Choice(CHOICES[1]),
        "1",
        true,
        ["Heuristic", "启发函数"],
        ["Octile is exact on an empty map, so it expands less.", "空地图上八方距离精确，扩展更少。"],
    ),
    spec(
        "heuristic",
        Form::Choice(CHOICES[2]),
        "1",
        false,
        ["Heuristic", "启发函数"],
        ["The gauge is exact on an empty map for these moves.", "对这些移动，规范距离在空地图上精确。"],
    ),
];

parameters! {
    /// Settings of grid A*.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
        /// How the cost still to pay is estimated.
        heuristic: Heuristic = Heuristic::Euclid,
            HEURISTIC_SPECS[1];
        /// The factor on the estimate.
        weight: Weight = Weight::None,
            spec("weight", Form::Choice(&["none", "distance"]), "1", true,
                 ["Dynamic weight", "动态权重"],
                 ["Faster far from the goal, but not optimal.", "远离目标时加速，放弃最优性。"]);
    }
    /// The settings that all grid planners share.
    shared common: Common = Common::PLAIN;
}

impl Config {
    /// The defaults for a neighbourhood: the papers' baselines for four and eight.
    pub const fn new(neighbourhood: Neighbourhood) -> Self {
        let heuristic = match neighbourhood {
            Neighbourhood::Four => Heuristic::Manhattan,
            Neighbourhood::Eight => Heuristic::Euclid,
            _ => Heuristic::Gauge,
        };
        Self { heuristic, ..Self::DEFAULT }
    }

    /// Checks every setting for a neighbourhood.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate_for(&self, neighbourhood: Neighbourhood) -> Result<(), Error> {
        self.check_heuristic(neighbourhood)?;
        self.validate()
    }

    /// An estimate above the true cost would make the path longer than the cheapest one without a word, so it is
    /// refused.
    fn check_heuristic(&self, neighbourhood: Neighbourhood) -> Result<(), Error> {
        if !self.heuristic.is_admissible(neighbourhood) {
            let words = Heuristic::WORDS.iter();
            let names = words.filter(|word| word.1.is_admissible(neighbourhood)).map(|word| word.0);
            let rule = message!(
                "must be {} with {} neighbours, got {}",
                names.collect::<Vec<_>>().join(" or "),
                neighbourhood.moves().len(),
                self.heuristic.as_str()
            );
            return Err(Error::new(ErrorCode::Config, "heuristic", rule));
        }
        Ok(())
    }
}

/// Grid A* with a neighbourhood, which is no setting.
pub(super) struct GridAstar {
    neighbourhood: Neighbourhood,
    config: Config,
}

impl GridAstar {
    pub(super) const fn new(neighbourhood: Neighbourhood) -> Self {
        Self { neighbourhood, config: Config::new(neighbourhood) }
    }
}

impl super::parameters::Parameters for GridAstar {
    /// The settings with the heuristics that the neighbourhood allows.
    fn fields(&mut self) -> Vec<Field<'_>> {
        let own = match self.neighbourhood {
            Neighbourhood::Four => &HEURISTIC_SPECS[0],
            Neighbourhood::Eight => &HEURISTIC_SPECS[1],
            _ => &HEURISTIC_SPECS[2],
        };
        let mut fields = self.config.fields();
        for (spec, _) in fields.iter_mut().filter(|field| field.0.name == own.name) {
            *spec = own;
        }
        fields
    }

    fn check_rules(&self) -> Result<(), Error> {
        self.config.check_heuristic(self.neighbourhood)
    }
}

impl GridPlanner for GridAstar {
    fn common(&self) -> Common {
        self.config.common
    }

    fn run(&self, at: Prepared, scratch: &mut GridScratch, observers: &mut Observers) -> GridReport {
        plan(at.query, self.neighbourhood, &self.config, scratch, observers)
    }

    fn record(&self, at: Prepared, limit: usize) -> Option<Recording> {
        IS_COMPLETE.then(|| record(at.query, self.neighbourhood, &self.config, limit))
    }
}

/// Searches a path over the cells of a map.
///
/// `config` must be valid for the neighbourhood ([`Config::validate_for`]); `observer` is `()` where nobody watches.
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
pub fn plan<O: Observer<i64, ()>>(
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
    let weight = (config.weight == Weight::Distance).then(|| DistanceWeight::new(1000, dx, dy));
    let search = Search { query, neighbourhood, common: config.common, scratch, observer };
    if query.map.weights().is_some() {
        return search.by_weights(Chosen { heuristic: config.heuristic, neighbourhood, weight });
    }
    match (config.heuristic, neighbourhood, weight) {
        (Heuristic::Manhattan, _, None) => search.by(Manhattan),
        (Heuristic::Euclid, _, None) => search.by(Euclid),
        (Heuristic::Octile, _, None) => search.by(Octile),
        (Heuristic::Gauge, Neighbourhood::Sixteen | Neighbourhood::TwentyFour, None) => search.by(Gauge16),
        (heuristic, neighbourhood, weight) => search.by(Chosen { heuristic, neighbourhood, weight }),
    }
}

struct Search<'a, O> {
    query: Query<'a>,
    neighbourhood: Neighbourhood,
    common: Common,
    scratch: &'a mut GridScratch,
    observer: &'a mut O,
}

impl<O: Observer<i64, ()>> Search<'_, O> {
    fn by<E: Estimate>(self, estimate: E) -> GridReport {
        let Self { query, neighbourhood, common, scratch, observer } = self;
        let grid = Grid::new(&query, neighbourhood, common.corner, estimate);
        let found = one_way(&grid, query.ends(), common.max_expansions, &mut scratch.lattice, observer);
        GridReport::along(&query, &found, grid.los_calls())
    }

    /// The map has weights.
    fn by_weights(self, estimate: Chosen) -> GridReport {
        let Self { query, neighbourhood, common, scratch, observer } = self;
        let lattice = Grid::new(&query, neighbourhood, common.corner, estimate);
        let grid = Weighted::new(lattice, &query);
        let found = one_way(&grid, query.ends(), common.max_expansions, &mut scratch.lattice, observer);
        GridReport::along(&query, &found, grid.lattice.los_calls())
    }
}

/// The same search with its events written down, at most `limit` of them.
pub fn record(query: Query, neighbourhood: Neighbourhood, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    let (dx, dy) = (query.goal.x - query.start.x, query.goal.y - query.start.y);
    let weight = (config.weight == Weight::Distance).then(|| DistanceWeight::new(1000, dx, dy));
    let estimate = Chosen { heuristic: config.heuristic, neighbourhood, weight };
    record_grid(query, Grid::new(&query, neighbourhood, config.common.corner, estimate), config.common, limit)
}

/// A search over a grid, with the map's weights where it has some.
pub(super) fn record_grid(query: Query, grid: Grid<Chosen>, common: Common, limit: usize) -> Recording {
    let (ends, most) = (query.ends(), common.max_expansions);
    if query.map.weights().is_some() {
        return record_one_way(&Weighted::new(grid, &query), ends, most, limit);
    }
    record_one_way(&grid, ends, most, limit)
}
