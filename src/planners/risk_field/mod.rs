//! Risk-field A*: eight directions, of which a potential field picks three per cell (Hu et al. 2024).
//!
//! The force on a cell (the goal attracts, the nearest obstacle repels) names a region; the region names three of the
//! eight directions, and diagonal ones also offer a double step. A weighted estimate that favours the longer of the
//! diagonal and the straight part drives the search on. The three-direction rule alone loses the way on 2 to 22 % of
//! ordinary maps, so the other five directions are held back, not dropped ([`Fallback`]).
//! The path is not the cheapest one: the paper trades that for speed.

mod directions;
mod domain;
#[cfg(feature = "complete")]
mod explain;

use super::grid_astar;
use super::heuristics::{DistanceWeight, Heuristic as GridHeuristic};
use super::moves::Neighbourhood;
use super::query::{Detail, GridReport, GridScratch, Query, Status};
use super::settings::{Common, Post, within};
use super::weighted::Weighted;
use crate::error::{Error, ErrorCode};
use crate::json;
use crate::map::Corner;
use crate::map::risk::{Attraction, FieldSettings, ObstacleSet, PotentialField};
use crate::search::lattice::{Hold, one_way};
use crate::search::{Observer, Watch};

#[cfg(feature = "complete")]
pub use explain::{Candidate, Explanation, explain};

/// The estimate before the distance weight.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Heuristic {
    /// The paper's equations 10 and 11 as meant: w1 times the longer part plus w2 times the shorter.
    #[default]
    Corrected,
    /// The equations as printed, which scale the diagonal part twice and jump where the parts are equal.
    Printed,
    /// Unweighted: straight and diagonal steps over an empty map.
    Octile,
}

json::words!(Heuristic: "corrected" = Corrected, "printed" = Printed, "octile" = Octile);

/// What becomes of the five directions that the field does not pick.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fallback {
    /// Tried when the three improve nothing, else later, at a penalty: complete.
    #[default]
    Penalty,
    /// Tried when the three improve nothing, else only when nothing else is left: complete.
    Lexicographic,
    /// Tried only when the three improve nothing: may lose the way.
    StuckOnly,
    /// Never tried, the paper to the letter: loses the way on some maps.
    None,
}

json::words!(Fallback: "penalty" = Penalty, "lexicographic" = Lexicographic, "stuck-only" = StuckOnly, "none" = None);

/// Settings of risk-field A*.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Config {
    /// Weight of the longer part of the estimate. Thousandths count.
    pub w1: f64,
    /// Weight of the shorter part of the estimate. Thousandths count.
    pub w2: f64,
    /// Strength of the distance weight 1 + wbar · d(n)/d(s); 1 is the paper. Thousandths count.
    pub wbar: f64,
    /// The estimate before the distance weight.
    pub heuristic: Heuristic,
    /// Gain of the goal's attraction.
    pub k1: f64,
    /// Reach of the obstacles' repulsion, cells.
    pub rho0: f64,
    /// Gain of the repulsion; `null`: half of k1 times the distance from start to goal in cells.
    pub k2: Option<f64>,
    /// How the pull depends on the distance.
    pub attraction: Attraction,
    /// Which obstacles repel.
    pub obstacle_set: ObstacleSet,
    /// Longest extension beyond a step, in steps; 1 is the paper's double step.
    pub ext_len: u32,
    /// Whether diagonal extensions that lead away from the goal are left out.
    pub goal_side: bool,
    /// What becomes of the directions that the field does not pick.
    pub fallback: Fallback,
    /// How far `fallback: "penalty"` puts them back, cells.
    pub penalty: f64,
    /// Whether the search ends as soon as the goal is in sight.
    pub goal_shot: bool,
    /// What every grid planner has.
    pub common: Common,
}

json::settings! {
    Config:
    "w1" = w1,
    "w2" = w2,
    "wbar" = wbar,
    "heuristic" = heuristic,
    "k1" = k1,
    "rho0" = rho0,
    "k2" = k2,
    "attraction" = attraction,
    "obstacleSet" = obstacle_set,
    "extLen" = ext_len,
    "goalSide" = goal_side,
    "fallback" = fallback,
    "penalty" = penalty,
    "goalShot" = goal_shot,
    "corner" = common.corner,
    "inflation" = common.inflation,
    "margin" = common.margin,
    "minPassage" = common.min_passage,
    "trapMouth" = common.trap_mouth,
    "post" = common.post,
    "smoothMode" = common.smooth_mode,
    "minRadius" = common.min_radius,
    "maxExpansions" = common.max_expansions,
}

impl Default for Config {
    fn default() -> Self {
        Self::PAPER
    }
}

impl Config {
    /// The paper's planner, with this crate's answers where the paper is silent.
    pub const PAPER: Self = Self {
        w1: 2.0,
        w2: 1.0,
        wbar: 1.0,
        heuristic: Heuristic::Corrected,
        k1: 1.0,
        rho0: 3.0,
        k2: None,
        attraction: Attraction::Linear,
        obstacle_set: ObstacleSet::NearestMean,
        ext_len: 1,
        goal_side: false,
        fallback: Fallback::Penalty,
        penalty: 4.0,
        goal_shot: false,
        common: Common { post: Post::Smooth, ..Common::PLAIN },
    };

    /// Settings that give shorter paths from fewer cells than the paper's.
    pub const PLUS: Self = Self {
        heuristic: Heuristic::Octile,
        wbar: 0.5,
        attraction: Attraction::Conic,
        k2: Some(1.0),
        goal_side: true,
        ext_len: 3,
        goal_shot: true,
        common: Common { post: Post::PruneDp, ..Common::PLAIN },
        ..Self::PAPER
    };

    /// Checks every setting.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        within("w1", self.w1, 0.0, 10.0)?;
        within("w2", self.w2, 0.0, 10.0)?;
        within("wbar", self.wbar, 0.0, 10.0)?;
        within("k1", self.k1, 0.0, 1e6)?;
        within("rho0", self.rho0, 1.0, 20.0)?;
        within("k2", self.k2.unwrap_or(0.0), 0.0, 1e6)?;
        within("penalty", self.penalty, 0.0, 10_000.0)?;
        if self.ext_len > 16 {
            let rule = format!("must be between 0 and 16, got {}", self.ext_len);
            return Err(Error::new(ErrorCode::Config, "extLen", rule));
        }
        self.common.validate()
    }

    /// The potential field of a query.
    pub fn field<'a>(&self, query: &Query<'a>) -> PotentialField<'a> {
        let (dx, dy) = (f64::from(query.goal.x - query.start.x), f64::from(query.goal.y - query.start.y));
        let settings = FieldSettings {
            k1: self.k1,
            rho0: self.rho0,
            k2: self.k2.unwrap_or(0.5 * self.k1 * (dx * dx + dy * dy).sqrt()),
            attraction: self.attraction,
            obstacle_set: self.obstacle_set,
        };
        PotentialField::new(query.map, query.goal, settings)
    }

    fn hold(&self) -> Hold {
        match self.fallback {
            Fallback::Penalty => Hold::Penalty((self.penalty * 1e6).round() as i64),
            // Beyond every real priority, yet far from overflow.
            Fallback::Lexicographic => Hold::Penalty(1 << 61),
            Fallback::StuckOnly => Hold::UntilStuck,
            Fallback::None => Hold::Forever,
        }
    }
}

/// Searches a path over the cells of a map.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::query::{GridScratch, Query};
/// use parkade::planners::risk_field::{Config, plan};
///
/// let map = Occupancy::new(9, 9);
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(8, 8) };
/// let report = plan(query, &Config::PAPER, &mut GridScratch::new(), &mut ());
/// assert_eq!(report.cells.first(), Some(&query.start));
/// assert_eq!(report.cost_micro, 8 * 1_414_214);
/// ```
pub fn plan<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if let Some(report) = query.trivial() {
        return report;
    }
    let (dx, dy) = (query.goal.x - query.start.x, query.goal.y - query.start.y);
    let weight = DistanceWeight::new(permille(config.wbar), dx, dy);
    let grid = domain::RiskGrid::new(query, config, weight, config.hold());
    let most = config.common.max_expansions;
    let mut report = if query.map.weights().is_some() {
        let grid = Weighted::new(grid, &query);
        let found = one_way(&grid, query.ends(), most, &mut scratch.risk, observer);
        GridReport::along(&query, &found, grid.lattice.los_calls())
    } else {
        let found = one_way(&grid, query.ends(), most, &mut scratch.risk, observer);
        GridReport::along(&query, &found, grid.los_calls())
    };
    let incomplete = matches!(config.fallback, Fallback::StuckOnly | Fallback::None);
    if report.status == Status::NoPath && incomplete && is_reachable(query, config.common.corner, scratch) {
        report.detail = Some(Detail::Stranded);
    }
    report
}

/// Whether ordinary steps lead from start to goal.
fn is_reachable(query: Query, corner: Corner, scratch: &mut GridScratch) -> bool {
    let eight = Neighbourhood::Eight;
    let common = Common { corner, ..Common::PLAIN };
    let config =
        grid_astar::Config { heuristic: GridHeuristic::Octile, common, ..grid_astar::Config::new(eight) };
    // Silent, but of the type that plans are watched with: a second copy of the search saves nothing.
    grid_astar::plan(query, eight, &config, scratch, &mut Watch::default()).status == Status::Found
}

fn permille(weight: f64) -> i64 {
    (weight * 1000.0).round() as i64
}
