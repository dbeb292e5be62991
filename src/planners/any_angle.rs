//! Theta*: eight neighbours, but a cell may hang on its parent's parent when that sees it (Nash et al. 2007).
//!
//! Costs are straight distances in `f64` cells. Paths are short and turn rarely; they are not always the shortest.
//!
//! A line of sight is asked for each move, which is most of the work: O(length) each, under the same rule for corners
//! as single steps.

use std::cell::Cell as Counter;

use super::grid_planner::grid_planner;
use super::moves::{DIRECTIONS, cost, legal_steps};
use super::parameters::parameters;
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use crate::map::{Cell, line_of_sight};
use crate::search::{
    Domain, Fate, Finish, Limits, NodeId, Observer, Recording, Relax, Scratch, Told, Visit, best_first,
    record_best_first,
};

parameters! {
    /// Settings of any-angle search.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
    }
    /// The settings that all grid planners share.
    shared common: Common = Common::PLAIN;
}

grid_planner!(Config: plan, record);

struct AnyAngle<'a> {
    query: Query<'a>,
    config: Config,
    los_calls: Counter<u32>,
}

impl<'a> AnyAngle<'a> {
    /// With the search's root and limits.
    fn new(query: Query<'a>, config: &Config) -> (Self, (NodeId, Cell), Limits) {
        let domain = Self { query, config: *config, los_calls: Counter::new(0) };
        let limits = Limits { max_expansions: config.common.max_expansions, first: true };
        (domain, (query.map.index(query.start), query.start), limits)
    }
}

impl Domain for AnyAngle<'_> {
    type Cost = f64;
    type Label = Cell;
    type Tail = ();

    fn node_count(&self) -> usize {
        self.query.map.len()
    }

    fn successors<S: Relax<f64, Cell>>(&self, from: Visit<f64, Cell>, sink: &mut S) {
        let map = self.query.map;
        let free = map.free_around(from.label);
        let legal = legal_steps(free, self.config.common.corner);
        let parent = from.parent.map(|node| map.cell(node));
        let mut calls = 0;
        for (c, &(dx, dy)) in DIRECTIONS.iter().enumerate().filter(|(c, _)| legal >> c & 1 == 1) {
            let to = from.label.offset(dx, dy);
            let step = if c % 2 == 0 { 1.0 } else { std::f64::consts::SQRT_2 };
            let node = map.index(to);
            if sink.is_closed(node) {
                continue;
            }
            calls += u32::from(parent.is_some());
            match parent.filter(|&p| line_of_sight(map, p, to, self.config.common.corner)) {
                Some(parent) => sink.emit_past(node, distance(parent, to), to),
                None => sink.emit(node, step, to),
            }
        }
        self.los_calls.set(self.los_calls.get() + calls);
    }

    fn heuristic(&self, _: NodeId, at: Cell) -> f64 {
        distance(at, self.query.goal)
    }

    fn finish(&mut self, at: Visit<f64, Cell>, _: f64) -> Option<Finish<f64, ()>> {
        (at.label == self.query.goal).then_some(Finish { cost: 0.0, tail: () })
    }
}

impl Told for AnyAngle<'_> {
    fn consider(&self, from: Visit<f64, Cell>, tell: &mut dyn FnMut(NodeId, f64, Cell, Option<Fate>)) {
        let map = self.query.map;
        let legal = legal_steps(map.free_around(from.label), self.config.common.corner);
        for (c, &(dx, dy)) in DIRECTIONS.iter().enumerate() {
            let to = from.label.offset(dx, dy);
            if map.contains(to) {
                let step = if c % 2 == 0 { 1.0 } else { std::f64::consts::SQRT_2 };
                let illegal = if map.blocked(to) { Fate::Blocked } else { Fate::Corner };
                tell(map.index(to), step, to, (legal >> c & 1 == 0).then_some(illegal));
            }
        }
    }
}

fn distance(a: Cell, b: Cell) -> f64 {
    let (dx, dy) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
    (dx * dx + dy * dy).sqrt()
}

/// Searches a path over the cells of a map; its cells are where it turns. The report's cost is that of the straight
/// lines between them.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::any_angle::{Config, plan};
/// use parkade::planners::query::{GridScratch, Query};
///
/// let map = Occupancy::new(9, 4);
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(8, 3) };
/// let report = plan(query, &Config::default(), &mut GridScratch::new(), &mut ());
/// assert_eq!(report.cells, [query.start, query.goal]);
/// ```
pub fn plan<O: Observer<f64, Cell>>(
    query: Query,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if let Some(report) = query.trivial() {
        return report;
    }
    let (mut domain, root, limits) = AnyAngle::new(query, config);
    let search = best_first(&mut domain, root, limits, &mut scratch.lengths, observer);
    let mut report = GridReport::of(&query, &search, &scratch.lengths, domain.los_calls.get());
    report.cost_micro = report.cells.windows(2).map(|p| cost(p[1].x - p[0].x, p[1].y - p[0].y)).sum();
    report
}

/// The same search with its events written down, at most `limit` of them.
pub fn record(query: Query, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    let (mut domain, root, limits) = AnyAngle::new(query, config);
    record_best_first(&mut domain, root, limits, &mut Scratch::new(), &mut (), limit).1.recording
}
