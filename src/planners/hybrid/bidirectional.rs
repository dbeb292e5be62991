//! Two trees, one from each end, joined by Reeds–Shepp curves.
//!
//! The parking paper's flowchart lets the trees meet where they share a cell; cells alone do not make a drivable join,
//! so a curve between the two real poses does. Each expanded state is also tried with a curve to the other root.
//!
//! The tree from the goal is mirrored: it drives backwards in time, so its arcs are reversed when both are joined. Both
//! trees charge the costs of driving forwards in time. The search ends when the least f of either tree is no less than
//! the cost of the best path, as that tree then has nothing cheaper to offer.
//!
//! A join of two poses in one cell needs a curve that begins and ends in that cell, with a turning radius of several
//! metres. Such a curve often makes a loop or a gear change; it is one candidate among others, and the shortcut that
//! follows takes out what is not needed. Per expansion there are at most three cells to look into, one per gear, and
//! one list of words for each.
//!
//! The costs of the two trees add up, because both charge arcs as driven forwards in time. A gear change at the joint
//! is charged when the whole path is priced, not while it is searched for.
//!
//! ```text
//! start ──tree──▶ a ⌒ curve ⌒ b ◀──tree── goal          cost: g(a) + curve + g(b)
//! ```
//!
//! With C the cost of the best path and F₁, F₂ the least f of the open lists, the search goes on while F₁ < C and F₂
//! < C. One of the two at C is enough, as each tree is also tried with a curve to the other root and would find every
//! path by itself.

use core::borrow::Borrow;
use core::cell::RefCell;

use super::analytic_expansion::{Recorder, take_cheapest};
use super::cost::CostModel;
use super::domain::{Setting, StateLattice};
use super::lattices::Level;
use super::obstacle_heuristic::ObstacleHeuristic;
use super::question::{Search, Work};
use super::recording::PoseRecording;
use super::report::Status;
use super::state::{self, State};
use super::tree::Tree;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp::{self, Word};
use crate::search::{
    self, Domain, End, Finish, Join, Limits, SearchStats, Trees, bidirectional_best_first,
    record_bidirectional_best_first,
};

type Visit = search::Visit<f64, State>;

/// The cheapest path so far, as driven.
/// `arcs` lead from start to goal; the second half has been reversed already.
struct Cheapest<'a> {
    search: &'a Search<'a>,
    costs: CostModel,
    cost: f64,
    arcs: Vec<Arc>,
}

impl<'l, D> Join<D> for Cheapest<'_>
where
    D: Domain<Cost = f64, Label = State, Tail = Word> + Borrow<StateLattice<'l>>,
{
    fn best(&self) -> f64 {
        self.cost
    }

    /// The path from a node of one tree by a curve to the other root.
    fn complete(&mut self, trees: Trees<D>, side: usize, at: Visit, finish: Finish<f64, Word>) {
        let arcs = state::path(&trees[side].chain(at.node), &finish.tail, self.costs.radius);
        self.keep(if side == 0 { arcs } else { arcs::reversed(&arcs) });
    }

    /// Tries the states of the other tree in the cell of this pose, whatever their gear.
    fn join(&mut self, trees: Trees<D>, side: usize, at: Visit) {
        let other = &trees[1 - side];
        let lattice: &StateLattice = (*other.domain).borrow();
        for gear in [-1, 0, 1] {
            if let Some(there) = other.reached(lattice.node(at.label.pose, gear)) {
                self.expand_between(trees, if side == 0 { [at, there] } else { [there, at] });
            }
        }
    }
}

impl Cheapest<'_> {
    /// Takes a whole path if it costs less than the best one so far.
    fn keep(&mut self, arcs: Vec<Arc>) {
        let cost = self.costs.path(self.search.checker, self.search.start, &arcs);
        if cost < self.cost {
            (self.cost, self.arcs) = (cost, arcs);
        }
    }

    /// Joins a state of the tree from the start to one of the tree from the goal.
    fn expand_between<'l, D>(&mut self, trees: Trees<D>, [from, to]: [Visit; 2])
    where
        D: Domain<Cost = f64, Label = State, Tail = Word> + Borrow<StateLattice<'l>>,
    {
        let (here, there) = (from.label.pose, to.label.pose);
        let (lattice, radius): (&StateLattice, _) = ((*trees[0].domain).borrow(), self.costs.radius);
        let words = reeds_shepp::list_below(here, there, radius, self.cost - from.g - to.g);
        let mut words: Vec<_> = words.into_iter().map(|word| (word.length(radius), word)).collect();
        while let Some((_, word)) = take_cheapest(&mut words) {
            if word.direction_changes() <= lattice.max_changes && lattice.word_free(here, &word) {
                let first = state::path(&trees[0].chain(from.node), &word, radius);
                let back = state::tree_arcs(&trees[1].chain(to.node)).collect::<Vec<_>>();
                self.keep(arcs::merge(first.into_iter().chain(arcs::reversed(&back))));
                return;
            }
        }
    }
}

/// Searches one level from both ends.
/// Returns the path from start to goal and whether it is proven the cheapest of its lattice, or `None`; the report's
/// status then says why. Counters are added to those of the report.
pub(super) fn search(
    search: &Search,
    level: Level,
    work: &mut Work,
    tree: &mut Option<Tree>,
    recorder: Option<&RefCell<Recorder>>,
) -> Option<(Vec<Arc>, Status)> {
    let Work { report, scratch, progress } = work;
    let other = scratch.other.get_or_insert_default();
    let Search { query, config, checker, .. } = *search;
    let back = ObstacleHeuristic::new(
        query.obstacles,
        query.vehicle,
        search.root,
        report.margin,
        Some(&other.floods),
    );
    let floods = if search.mirrored { [&back, search.flood] } else { [search.flood, &back] };
    let driven = search.costs().searching(&level);
    let ends = [search.start, search.goal];
    let lattice = |side: usize, keys| {
        let mirrored = side == 1;
        let costs = if mirrored { driven.mirrored() } else { driven };
        let setting = Setting {
            checker,
            flood: floods[side],
            keys,
            costs,
            mirrored,
            recorder,
            poses: None,
            roots: &[],
        };
        StateLattice::new(setting, query.vehicle, config, level, ends[1 - side], report.margin)
    };
    let (mut first, mut second) = (lattice(0, &scratch.keys), lattice(1, &other.keys));
    let roots = ends.map(|pose| State { pose, ..State::default() });
    let nodes = [first.node(ends[0], 0), second.node(ends[1], 0)];
    let limits = Limits { max_expansions: level.max_expansions, first: config.first_shot };
    let mut cheapest = Cheapest { search, costs: driven, cost: f64::INFINITY, arcs: Vec::new() };
    let mut observer = (tree.as_mut(), progress.as_mut());
    let [a, b] = [(nodes[0], roots[0]), (nodes[1], roots[1])];
    let found = if let Some(limit) = scratch.recorded_steps {
        let sides = [(&mut first, a, &mut scratch.search), (&mut second, b, &mut other.search)];
        let (found, recorded) =
            record_bidirectional_best_first(sides, limits, &mut cheapest, &mut observer, limit);
        let sides = [(&first, ends[0]), (&second, ends[1])];
        report.recorded = Some(PoseRecording::new(&sides, search.origin(), recorded).into());
        found
    } else {
        let mut trees = [
            search::Tree::new(&mut first, a, &mut scratch.search),
            search::Tree::new(&mut second, b, &mut other.search),
        ];
        bidirectional_best_first(&mut trees, limits, &mut cheapest, &mut observer)
    };
    let SearchStats { generated, open_peak, .. } = found.stats;
    let nodes = search::Scratch::<f64, State>::bytes(generated as usize, open_peak);
    let keys = scratch.keys.borrow().bytes() + other.keys.borrow().bytes();
    report.stats.add(SearchStats { bytes: nodes as u64 + keys + back.bytes(), ..found.stats });
    let is_spent = found.end == End::BudgetSpent;
    if cheapest.cost.is_finite() {
        return Some((cheapest.arcs, if is_spent { Status::Suboptimal } else { Status::Found }));
    }
    let apart = (search.goal.point() - search.start.point()).norm();
    report.status = if is_spent { Status::BudgetExhausted(apart) } else { Status::NoPath };
    None
}
