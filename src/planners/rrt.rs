//! RRT: a tree that grows towards random cells until it reaches the goal (`LaValle` 1998).
//!
//! The tree knows no cost, so its path is not the shortest and differs with the seed. It cannot prove that there is no
//! path: where it finds none, its budget is spent. Legs are straight lines between cells; the path's cells are where it
//! turns.
//!
//! An expansion draws a free cell, finds the tree's cell nearest to it and adds a leg of at most `step` cells from
//! there towards it, if that is free. Random cells lie more often near large unexplored regions, which is what pulls
//! the tree outward. The nearest cell is found by looking at the whole tree, so n expansions take O(n²).

use super::Outcome;
use super::grid_planner::grid_planner;
use super::moves::{D, cost, euclid};
use super::parameters::{Form, parameters, spec};
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use crate::map::{Cell, line_of_sight};
use crate::scenario::generate::SplitMix64;
use crate::search::{Budget, Fate, Observer, Recording, SearchStats, StepKind};

/// Each expansion looks at the whole tree, so the default is far below that of the other searches.
const SHARED: Common = Common { max_expansions: 20_000, ..Common::PLAIN };
/// Cells drawn until one is free: on a road most cells of the map are beside it.
const DRAWS: usize = 64;

parameters! {
    /// Settings of RRT. An expansion is one random cell and the leg towards it.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
        /// The seed of the random cells.
        seed: u32 = 1,
            spec("seed", Form::Integer(1.0, 100.0), "1", true,
                 ["Seed", "随机种子"],
                 ["The same seed gives the same path.", "同一种子得到同一路径。"]).within(0.0, 4_294_967_295.0);
        /// Longest leg, cells.
        step: f64 = 5.0,
            spec("step", Form::Number(1.0, 30.0, 0.5), "cells", true,
                 ["Step", "步长"], ["Longest leg of the tree.", "树的最长一步。"]).within(1.0, 1000.0);
        /// Share of expansions that aim at the goal.
        goal_bias: f64 = 0.1,
            spec("goalBias", Form::Number(0.0, 1.0, 0.05), "1", true,
                 ["Goal bias", "目标偏置"],
                 ["Share of the expansions that aim at the goal.", "直接朝目标扩展的比例。"]).within(0.0, 1.0);
    }
    /// The settings that all grid planners share.
    shared common: Common = SHARED;
}

grid_planner!(Config: plan, record);

/// The cells of the tree, each with its parent's place in the list and its cost from the start, micro-cells.
struct Tree {
    cells: Vec<Cell>,
    parents: Vec<u32>,
    costs: Vec<i64>,
    /// One entry a cell of the map, true if the tree has it.
    is_in: Vec<bool>,
}

impl Tree {
    fn add(&mut self, query: &Query, cell: Cell, parent: usize) {
        let from = self.cells[parent];
        self.is_in[query.map.index(cell) as usize] = true;
        self.cells.push(cell);
        self.parents.push(parent as u32);
        self.costs.push(self.costs[parent] + cost(cell.x - from.x, cell.y - from.y));
    }

    /// The place of the cell nearest to another one, the oldest of several.
    fn nearest(&self, to: Cell) -> usize {
        let squared = |at: &Cell| {
            let (dx, dy) = (i64::from(to.x - at.x), i64::from(to.y - at.y));
            dx * dx + dy * dy
        };
        let mut nearest = (i64::MAX, 0);
        for (place, cell) in self.cells.iter().enumerate() {
            let distance = squared(cell);
            if distance < nearest.0 {
                nearest = (distance, place);
            }
        }
        nearest.1
    }

    /// The cells from the start to the last one.
    fn path(&self) -> Vec<Cell> {
        let mut place = self.cells.len() - 1;
        let mut path = vec![self.cells[place]];
        while place > 0 {
            place = self.parents[place] as usize;
            path.push(self.cells[place]);
        }
        path.reverse();
        path
    }
}

/// Grows a tree of straight legs over the cells of a map until it reaches the goal.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches, and is told the cell that
/// each expansion starts at. Weights of cells are ignored.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::query::{GridScratch, Query};
/// use parkade::planners::Outcome;
/// use parkade::planners::rrt::{Config, plan};
///
/// let map = Occupancy::parse("....\n.##.\n....");
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(3, 2) };
/// let report = plan(query, &Config::default(), &mut GridScratch::new(), &mut ());
/// assert_eq!((report.outcome, report.cells.last()), (Outcome::Found, Some(&query.goal)));
/// ```
pub fn plan<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    _: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    query.trivial().unwrap_or_else(|| grow(query, config, observer, &mut |_, _| {}))
}

/// The same tree with its events written down, at most `limit` of them.
pub fn record(query: Query, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    let mut out = Recording::default();
    let index = |cell: Cell| query.map.index(cell);
    let report = grow(query, config, &mut (), &mut |tree, Draw { towards, place, to, fate }| {
        let (from, g) = (tree.cells[place], tree.costs[place]);
        let h = cost(towards.x - from.x, towards.y - from.y);
        let moves =
            [(index(towards), Fate::Drawn, 0), (index(to), fate, g + cost(to.x - from.x, to.y - from.y))];
        out.add(limit, (StepKind::Drawn, index(from), [g, h]), &moves);
    });
    if report.outcome == Outcome::Found {
        out.add(limit, (StepKind::Goal, index(query.goal), [report.cost_micro, 0]), &[]);
    }
    out.counted(report.stats)
}

/// An expansion: the cell that was drawn, the place of the tree's nearest, the end of the leg and what became of it.
struct Draw {
    towards: Cell,
    place: usize,
    to: Cell,
    fate: Fate,
}

/// Grows the tree draw by draw until the goal is in it or the budget is spent. Each draw takes the nearest cell of the
/// tree, O(n) for n cells, and goes a step towards the drawn one; `tell` is given the tree and the draw.
fn grow<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    observer: &mut O,
    tell: &mut dyn FnMut(&Tree, Draw),
) -> GridReport {
    let mut tree = Tree {
        cells: vec![query.start],
        parents: vec![0],
        costs: vec![0],
        is_in: vec![false; query.map.len()],
    };
    tree.is_in[query.map.index(query.start) as usize] = true;
    let mut random = SplitMix64::new(u64::from(config.seed));
    let mut budget = Budget::new(config.common.max_expansions, observer);
    let (mut expanded, mut los_calls) = (0, 0);
    let mut outcome = Outcome::BudgetSpent;
    while outcome != Outcome::Found && !budget.is_spent(expanded, observer) {
        let towards = sample(&query, config, &mut random);
        let place = tree.nearest(towards);
        let from = tree.cells[place];
        expanded += 1;
        observer.expanded(query.map.index(from), (), tree.costs[place]);
        let to = leg(from, towards, config.step);
        let fate = if query.map.blocked(to) {
            Fate::Blocked
        } else if tree.is_in[query.map.index(to) as usize] {
            Fate::Closed
        } else {
            los_calls += 1;
            let is_free = line_of_sight(query.map, from, to, config.common.corner);
            if is_free { Fate::Kept } else { Fate::Corner }
        };
        tell(&tree, Draw { towards, place, to, fate });
        if fate == Fate::Kept {
            tree.add(&query, to, place);
            if to == query.goal {
                outcome = Outcome::Found;
            }
        }
    }
    report(&query, &tree, outcome, [expanded, los_calls])
}

/// The goal with a probability of the bias, otherwise any free cell of the map.
fn sample(query: &Query, config: &Config, random: &mut SplitMix64) -> Cell {
    if random.chance(config.goal_bias) {
        return query.goal;
    }
    let mut draw = || {
        let [x, y] = [query.map.width(), query.map.height()].map(|n| random.below(n) as i32);
        Cell::new(x, y)
    };
    let first = draw();
    std::iter::once(first)
        .chain(std::iter::repeat_with(draw).take(DRAWS))
        .find(|&cell| !query.map.blocked(cell))
        .unwrap_or(first)
}

/// The end of a leg of at most `step` cells.
fn leg(from: Cell, towards: Cell, step: f64) -> Cell {
    let (dx, dy) = (towards.x - from.x, towards.y - from.y);
    let distance = euclid(dx, dy) as f64 / D as f64;
    if distance <= step {
        return towards;
    }
    let part = |d: i32| (f64::from(d) * step / distance).round() as i32;
    from.offset(part(dx), part(dy))
}

/// The tree's path with its cost, and the counters: every cell of the tree counts as generated, pushed and held,
/// because the tree never lets one go.
fn report(query: &Query, tree: &Tree, outcome: Outcome, [expanded, los_calls]: [u32; 2]) -> GridReport {
    let found = outcome == Outcome::Found;
    let size = tree.cells.len();
    let nodes = size as u32;
    let bytes = query.map.len() + size * (size_of::<Cell>() + size_of::<u32>() + size_of::<i64>());
    GridReport {
        cells: if found { tree.path() } else { Vec::new() },
        cost_micro: if found { tree.costs[size - 1] } else { 0 },
        stats: SearchStats {
            expanded,
            generated: nodes,
            pushes: nodes,
            open_peak: nodes,
            bytes: bytes as u64,
        },
        los_calls,
        ..GridReport::empty(outcome, tree.cells[tree.nearest(query.goal)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::Occupancy;

    fn around_a_wall(config: &Config) -> GridReport {
        let map = Occupancy::parse("......\n.####.\n.#..#.\n.#..#.\n....#.\n......");
        let query = Query { map: &map, start: Cell::new(2, 2), goal: Cell::new(5, 5) };
        plan(query, config, &mut GridScratch::new(), &mut ())
    }

    #[test]
    fn seeds_give_their_own_paths_again_and_again() {
        let of = |seed| around_a_wall(&Config { seed, step: 2.0, ..Config::DEFAULT });
        assert_eq!(of(3), of(3));
        let paths: Vec<_> = (1..20).map(|seed| of(seed).cells).collect();
        assert!(paths.iter().all(|path| !path.is_empty()));
        assert!(paths.iter().any(|path| path != &paths[0]), "a tree that does not depend on its seed");
    }

    #[test]
    fn legs_are_as_long_as_they_may_be() {
        assert_eq!(leg(Cell::new(0, 0), Cell::new(30, 40), 5.0), Cell::new(3, 4));
        assert_eq!(leg(Cell::new(9, 9), Cell::new(9, 5), 5.0), Cell::new(9, 5));
        for seed in 1..20 {
            let report = around_a_wall(&Config { seed, step: 2.0, ..Config::DEFAULT });
            let longest = report.cells.windows(2).map(|p| cost(p[1].x - p[0].x, p[1].y - p[0].y)).max();
            // Rounding to a cell adds less than its half diagonal.
            assert!(longest.unwrap() < 2_707_107, "{longest:?}");
        }
    }

    #[test]
    fn a_bias_of_one_goes_straight_or_nowhere() {
        let config = Config { goal_bias: 1.0, ..Config::DEFAULT };
        let map = Occupancy::new(20, 3);
        let query = Query { map: &map, start: Cell::new(0, 1), goal: Cell::new(17, 1) };
        let report = plan(query, &config, &mut GridScratch::new(), &mut ());
        assert_eq!((report.stats.expanded, report.cost_micro), (4, 17 * D));
        let stuck = around_a_wall(&config);
        assert_eq!((stuck.outcome, stuck.stats.expanded), (Outcome::BudgetSpent, 20_000));
    }
}
