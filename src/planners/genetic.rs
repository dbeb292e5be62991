//! A genetic algorithm over paths of straight legs (manuscript on roads, section 4.4.2).
//!
//! A candidate is a list of cells between start and goal. Candidates that cross fewer blocked cells are fitter, and
//! shorter ones among equal ones. The algorithm cannot prove that there is no path: where no candidate is free, its
//! budget is spent.
//!
//! A generation keeps its two fittest candidates, a tenth is drawn anew, and the rest are children of parents that each
//! won a tournament of three. A child takes the head of one parent and the tail of another; some children are changed
//! at random, and half of these changes repair a leg that is not free.

use super::Outcome;
use super::grid_planner::grid_planner;
use super::moves::{D, cost};
use super::parameters::{Form, parameters, spec};
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use crate::geometry::math::sorted_by;
use crate::map::{Cell, line_of_sight};
use crate::scenario::generate::SplitMix64;
use crate::search::{Budget, Fate, Observer, Recording, SearchStats, StepKind};

/// An expansion is a candidate and its fitness, which looks at every cell along its path.
const SHARED: Common = Common { max_expansions: 20_000, ..Common::PLAIN };
/// Most cells between start and goal.
const GENES: usize = 48;
/// Cells drawn until one is free.
const DRAWS: usize = 16;
/// Candidates of which the fittest becomes a parent.
const TOURNAMENT: u32 = 3;
/// Fittest candidates that live on unchanged.
const ELITE: usize = 2;
/// Share of a generation that has no parents, so that it does not become all alike.
const IMMIGRANTS: f64 = 0.1;
/// Share of the changes that repair a leg.
const REPAIRS: f64 = 0.5;
/// Cost of a blocked cell on the way, and of a leg that is not free: more than a detour around it costs.
const BLOCKED: i64 = 20 * D;

parameters! {
    /// Settings of the genetic algorithm. An expansion is one candidate.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
        /// The seed of all choices.
        seed: u32 = 1,
            spec("seed", Form::Integer(1.0, 100.0), "1", true,
                 ["Seed", "随机种子"],
                 ["The same seed gives the same path.", "同一种子得到同一路径。"]).within(0.0, 4_294_967_295.0);
        /// Candidates of a generation.
        population: u32 = 50,
            spec("population", Form::Integer(10.0, 200.0), "1", true,
                 ["Population", "种群规模"], ["Candidates of a generation.", "每一代的候选数。"]).within(4.0, 10_000.0);
        /// Probability that a child is changed.
        mutation: f64 = 0.6,
            spec("mutation", Form::Number(0.0, 1.0, 0.05), "1", true,
                 ["Mutation", "变异率"], ["Probability that a child is changed.", "子代变异的概率。"]).within(0.0, 1.0);
    }
    /// The settings that all grid planners share.
    shared common: Common = SHARED;
}

grid_planner!(Config: plan, record);

#[derive(Debug, Clone)]
struct Candidate {
    genes: Vec<Cell>,
    /// Micro-cells; less is fitter.
    fitness: i64,
    is_free: bool,
}

struct Evolution<'a> {
    query: Query<'a>,
    config: Config,
    random: SplitMix64,
    los_calls: u32,
}

/// Breeds paths over the cells of a map until the budget is spent, and returns the shortest free one.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches, and is told a cell in the
/// middle of each candidate. Weights of cells are ignored.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::genetic::{Config, plan};
/// use parkade::planners::query::{GridScratch, Query};
/// use parkade::planners::Outcome;
///
/// let map = Occupancy::parse("....\n.##.\n....");
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(3, 2) };
/// let report = plan(query, &Config::default(), &mut GridScratch::new(), &mut ());
/// assert_eq!((report.outcome, report.cost_micro), (Outcome::Found, 5_000_000));
/// ```
pub fn plan<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    _: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    query.trivial().unwrap_or_else(|| evolve(query, config, observer, &mut |_, _| {}))
}

/// The same candidates written down, at most `limit` of them.
pub fn record(query: Query, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    let mut out = Recording::default();
    let index = |cell: Cell| query.map.index(cell);
    let report = evolve(query, config, &mut (), &mut |evolution, candidate| {
        let mut far = 0;
        let legs = legs(&query, &candidate.genes);
        let legs = legs.windows(2).map(|leg| {
            far += cost(leg[1].x - leg[0].x, leg[1].y - leg[0].y);
            let fate = if evolution.is_free(leg[0], leg[1]) { Fate::Drawn } else { Fate::Blocked };
            (index(leg[1]), fate, far)
        });
        let legs: Vec<_> = legs.collect();
        out.add(limit, (StepKind::Candidate, index(query.start), [candidate.fitness, 0]), &legs);
    });
    out.counted(report.stats)
}

/// Breeds candidates until the budget is spent. A candidate is a list of turning points; a full population is sorted by
/// fitness, and its best are the first of the next. `tell` is given each candidate that is judged. The seed decides
/// everything that is drawn.
fn evolve<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    observer: &mut O,
    tell: &mut dyn FnMut(&Evolution, &Candidate),
) -> GridReport {
    let random = SplitMix64::new(u64::from(config.seed));
    let mut evolution = Evolution { query, config: *config, random, los_calls: 0 };
    let mut budget = Budget::new(config.common.max_expansions, observer);
    let mut expanded = 0;
    let mut people: Vec<Candidate> = Vec::new();
    let mut next: Vec<Candidate> = Vec::new();
    while !budget.is_spent(expanded, observer) {
        let is_new = people.is_empty() || evolution.random.chance(IMMIGRANTS);
        let genes = if is_new { evolution.ancestor() } else { evolution.child(&people) };
        expanded += 1;
        let middle = genes.get(genes.len() / 2).copied().unwrap_or(query.start);
        let candidate = evolution.judged(genes);
        observer.expanded(query.map.index(middle), (), candidate.fitness);
        tell(&evolution, &candidate);
        next.push(candidate);
        if next.len() == config.population as usize {
            people = fittest_first(&next);
            next.clear();
            next.extend_from_slice(&people[..ELITE]);
        }
    }
    let best = people.iter().chain(&next).min_by_key(|candidate| candidate.fitness);
    evolution.report(best, expanded)
}

impl Evolution<'_> {
    /// A candidate without parents: the straight line, its cells moved aside.
    fn ancestor(&mut self) -> Vec<Cell> {
        let (start, goal) = (self.query.start, self.query.goal);
        let count = self.random.below(GENES as u32 / 2 + 1) as i32;
        let reach = self.size();
        let part = |a: i32, b: i32, k: i32| a + (b - a) * k / (count + 1);
        (1..=count)
            .map(|k| Cell::new(part(start.x, goal.x, k), part(start.y, goal.y, k)))
            .map(|cell| self.near(cell, reach))
            .collect()
    }

    /// The head of one parent and the tail of another, perhaps changed.
    fn child(&mut self, people: &[Candidate]) -> Vec<Cell> {
        let [a, b] = [(); 2].map(|()| self.parent(people));
        let mut genes = people[a].genes.clone();
        genes.truncate(self.random.below(genes.len() as u32 + 1) as usize);
        let tail = &people[b].genes;
        genes.extend_from_slice(&tail[self.random.below(tail.len() as u32 + 1) as usize..]);
        genes.truncate(GENES);
        if self.random.chance(self.config.mutation) {
            self.mutate(&mut genes);
        }
        genes
    }

    /// The fittest of a few: those of a generation are sorted.
    fn parent(&mut self, people: &[Candidate]) -> usize {
        let drawn = (0..TOURNAMENT).map(|_| self.random.below(people.len() as u32));
        drawn.min().unwrap_or(0) as usize
    }

    /// Repairs a leg, or moves, adds or removes a cell.
    fn mutate(&mut self, genes: &mut Vec<Cell>) {
        if self.random.chance(REPAIRS) && self.repair(genes) {
            return;
        }
        let at = self.random.below(genes.len() as u32 + 1) as usize;
        // Far at times and near at others: ways around obstacles, and then the shortest of them.
        let reach = ((2 * self.size()) >> self.random.below(5)).max(1);
        match self.random.below(4) {
            0 if genes.len() < GENES => {
                let before = if at == 0 { self.query.start } else { genes[at - 1] };
                let cell = self.near(before, reach);
                genes.insert(at, cell);
            }
            1 if at < genes.len() => {
                genes.remove(at);
            }
            _ if at < genes.len() => genes[at] = self.near(genes[at], reach),
            _ => {}
        }
    }

    /// Leads a leg that is not free over a cell beside its middle; false if all are free.
    fn repair(&mut self, genes: &mut Vec<Cell>) -> bool {
        let cells: Vec<Cell> =
            [self.query.start].into_iter().chain(genes.iter().copied()).chain([self.query.goal]).collect();
        let blocked: Vec<usize> =
            (0..cells.len() - 1).filter(|&i| !self.is_free(cells[i], cells[i + 1])).collect();
        if blocked.is_empty() || genes.len() >= GENES {
            return false;
        }
        let at = blocked[self.random.below(blocked.len() as u32) as usize];
        let (a, b) = (cells[at], cells[at + 1]);
        let middle = Cell::new(i32::midpoint(a.x, b.x), i32::midpoint(a.y, b.y));
        let reach = (b.x - a.x).abs().max((b.y - a.y).abs()) >> self.random.below(3);
        let cell = self.near(middle, reach.max(1));
        genes.insert(at, cell);
        true
    }

    /// A cell of the map at most `reach` columns and rows away, a free one if one is drawn soon.
    fn near(&mut self, cell: Cell, reach: i32) -> Cell {
        let map = self.query.map;
        let mut draw = || {
            let mut moved = |at: i32, size: u32| {
                (at + self.random.below(2 * reach as u32 + 1) as i32 - reach).clamp(0, size as i32 - 1)
            };
            Cell::new(moved(cell.x, map.width()), moved(cell.y, map.height()))
        };
        let first = draw();
        std::iter::once(first)
            .chain(std::iter::repeat_with(draw).take(DRAWS))
            .find(|&cell| !map.blocked(cell))
            .unwrap_or(first)
    }

    /// Half of the larger side of the map, cells.
    fn size(&self) -> i32 {
        (self.query.map.width().max(self.query.map.height()) / 2).max(1) as i32
    }

    /// A candidate's fitness, less is better: the cost of its legs, and for each blocked leg a price that grows with
    /// the blocked cells, so that nearly free candidates are bred on.
    fn judged(&mut self, genes: Vec<Cell>) -> Candidate {
        let (mut fitness, mut is_free) = (0, true);
        for leg in legs(&self.query, &genes).windows(2) {
            fitness += cost(leg[1].x - leg[0].x, leg[1].y - leg[0].y);
            self.los_calls += 1;
            if !self.is_free(leg[0], leg[1]) {
                is_free = false;
                fitness += BLOCKED * (1 + self.blocked_between(leg[0], leg[1]));
            }
        }
        Candidate { genes, fitness, is_free }
    }

    /// True if the straight line between two cells is.
    fn is_free(&self, from: Cell, to: Cell) -> bool {
        line_of_sight(self.query.map, from, to, self.config.common.corner)
    }

    /// The blocked cells on a line, one a column or row.
    fn blocked_between(&self, from: Cell, to: Cell) -> i64 {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let steps = dx.abs().max(dy.abs()).max(1);
        let at = |k: i32| from.offset((dx * k).div_euclid(steps), (dy * k).div_euclid(steps));
        (0..=steps).filter(|&k| self.query.map.blocked(at(k))).count() as i64
    }

    /// The best candidate's turning points as the path; no path where even the best one has a blocked leg. The search
    /// never proves that there is none, so it ends with a spent budget then.
    fn report(&self, best: Option<&Candidate>, expanded: u32) -> GridReport {
        let found = best.filter(|candidate| candidate.is_free);
        let outcome = if found.is_some() { Outcome::Found } else { Outcome::BudgetSpent };
        let candidate = size_of::<Candidate>() + GENES * size_of::<Cell>();
        GridReport {
            cells: found.map_or_else(Vec::new, |candidate| legs(&self.query, &candidate.genes)),
            cost_micro: found.map_or(0, |candidate| candidate.fitness),
            stats: SearchStats {
                expanded,
                generated: expanded,
                pushes: expanded,
                open_peak: self.config.population,
                bytes: 2 * u64::from(self.config.population) * candidate as u64,
            },
            los_calls: self.los_calls,
            ..GridReport::empty(outcome, self.query.start)
        }
    }
}

/// Equal ones keep their order.
fn fittest_first(people: &[Candidate]) -> Vec<Candidate> {
    let places: Vec<usize> = (0..people.len()).collect();
    let sorted = sorted_by(&places, |&place| people[place].fitness as f64);
    sorted.into_iter().map(|place| people[place].clone()).collect()
}

/// Start, genes and goal, without standing still.
fn legs(query: &Query, genes: &[Cell]) -> Vec<Cell> {
    let mut cells = vec![query.start];
    cells.extend_from_slice(genes);
    cells.push(query.goal);
    cells.dedup();
    cells
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
        let of = |seed, expansions| {
            let common = Common { max_expansions: expansions, ..Common::PLAIN };
            around_a_wall(&Config { seed, common, ..Config::DEFAULT })
        };
        assert_eq!(of(3, 2000), of(3, 2000));
        assert!((1..20).all(|seed| of(seed, 20_000).outcome == Outcome::Found));
        assert!((1..20).any(|seed| of(seed, 60) != of(1, 60)), "a choice that does not depend on the seed");
    }

    #[test]
    fn more_generations_are_no_longer() {
        let of = |expansions| {
            let common = Common { max_expansions: expansions, ..Common::PLAIN };
            around_a_wall(&Config { common, ..Config::DEFAULT })
        };
        let lengths: Vec<_> = [200, 2000, 20_000]
            .map(of)
            .iter()
            .filter(|r| r.outcome == Outcome::Found)
            .map(|r| r.cost_micro)
            .collect();
        assert!(lengths.len() >= 2 && lengths.is_sorted_by(|a, b| a >= b), "{lengths:?}");
    }

    #[test]
    fn nothing_is_found_where_nothing_is_free() {
        let map = Occupancy::parse("..#..\n..#..\n..#..");
        let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(4, 2) };
        let report = plan(query, &Config::default(), &mut GridScratch::new(), &mut ());
        assert_eq!((report.outcome, report.stats.expanded), (Outcome::BudgetSpent, 20_000));
        assert!(report.cells.is_empty());
    }
}
