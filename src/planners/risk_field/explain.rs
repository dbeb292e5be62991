//! Explains the planner's step at one cell in the terms of the paper's tables 1 and 2.
//!
//! The explanation asks the same field, tables and estimate as the search, so it says what the planner would do; it
//! knows nothing of what a search has already reached. Whether a candidate would improve anything is therefore not
//! part of it.

use serde::Serialize;

use super::config::{Config, permille};
use super::directions::{is_oblique, primaries, region};
use super::domain::RiskGrid;
use crate::map::{Cell, line_of_sight};
use crate::planners::heuristics::DistanceWeight;
use crate::planners::moves::DIRECTIONS;
use crate::planners::query::Query;

const NAMES: [&str; 8] = ["E", "NE", "N", "NW", "W", "SW", "S", "SE"];

/// The planner's step at one cell. Forces are unitless, east and north.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Explanation {
    /// Column and row of the cell.
    pub cell: [i32; 2],
    /// `oblique` (table 1) where the way to the goal is mostly diagonal, else `straight` (table 2).
    pub mode: &'static str,
    /// The goal's pull.
    pub attraction: [f64; 2],
    /// The obstacles' push.
    pub repulsion: [f64; 2],
    /// Their sum, F.
    pub force: [f64; 2],
    /// The goal's potential (eq 4) and the obstacles' (eq 6).
    pub potentials: [f64; 2],
    /// Its slope k = Fy / Fx; `None` where Fx is 0.
    pub slope: Option<f64>,
    /// `1` to `8` of table 1, or `A` to `D` of table 2.
    pub region: &'static str,
    /// The region's central direction, counted counter-clockwise from the east: 0 to 7.
    pub center: usize,
    /// The cells that are looked at first, in the planner's order, then those that are held back.
    pub candidates: Vec<Candidate>,
    /// The estimate of the way to the goal, millionths of a cell.
    pub estimate: i64,
    /// The estimate times the distance weight: what the search adds to the way behind.
    pub weighted: i64,
}

/// A cell that may come next.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Candidate {
    /// Its column and row.
    pub cell: [i32; 2],
    /// Direction: `E`, `NE`, ….
    pub direction: &'static str,
    /// `primary`, `extension` or `held-back`.
    pub role: &'static str,
    /// True if it is free and the way to it is.
    pub free: bool,
}

/// Explains a free cell; `None` where the cell is blocked or off the map. No search is needed for it, and the
/// counters of the planner do not change.
///
/// # Examples
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::query::Query;
/// use parkade::planners::risk_field::{Config, explain};
///
/// let map = Occupancy::new(9, 9);
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(8, 8) };
/// let step = explain(query, &Config::PAPER, Cell::new(2, 2)).unwrap();
/// // Nothing repels on an empty map: the force points along the diagonal.
/// assert_eq!((step.mode, step.candidates[0].direction), ("oblique", "NE"));
/// ```
pub fn explain(query: Query, config: &Config, at: Cell) -> Option<Explanation> {
    if query.map.blocked(at) {
        return None;
    }
    let (dx, dy) = (query.goal.x - at.x, query.goal.y - at.y);
    let field = config.field(&query);
    let (attraction, repulsion) = (field.attraction(at), field.repulsion(at));
    let force = field.force(at);
    let oblique = is_oblique(dx, dy);
    let center = region(force, oblique);
    let tables =
        if oblique { ["1", "2", "3", "4", "5", "6", "7", "8"] } else { ["A", "", "B", "", "C", "", "D", ""] };
    let picked = primaries(center);
    let mut candidates = Vec::new();
    let mut add = |c: usize, step: i32, role| {
        let to = at.offset(step * DIRECTIONS[c].0, step * DIRECTIONS[c].1);
        let free = line_of_sight(query.map, at, to, config.common.corner);
        candidates.push(Candidate { cell: [to.x, to.y], direction: NAMES[c], role, free });
    };
    for c in picked {
        add(c, 1, "primary");
    }
    let leads_away = |c: usize| DIRECTIONS[c].0 * dx < 0 || DIRECTIONS[c].1 * dy < 0;
    let stretched = picked
        .into_iter()
        .enumerate()
        .filter(|&(i, c)| if oblique { c % 2 == 1 && !(config.goal_side && leads_away(c)) } else { i == 0 });
    for (_, c) in stretched {
        for step in 2..=config.ext_len as i32 + 1 {
            add(c, step, "extension");
        }
    }
    for c in (0..8).filter(|c| !picked.contains(c)) {
        add(c, 1, "held-back");
    }
    let (sx, sy) = (query.goal.x - query.start.x, query.goal.y - query.start.y);
    let estimate = |permille| {
        let weight = DistanceWeight::new(permille, sx, sy);
        RiskGrid::new(query, config, weight, config.deferral()).ahead(at)
    };
    Some(Explanation {
        cell: [at.x, at.y],
        mode: if oblique { "oblique" } else { "straight" },
        attraction: attraction.into(),
        repulsion: repulsion.into(),
        force: force.into(),
        potentials: field.potentials(at).into(),
        slope: (force.0 != 0.0).then(|| force.1 / force.0),
        region: tables[center],
        center,
        candidates,
        estimate: estimate(0),
        weighted: estimate(permille(config.wbar)),
    })
}
