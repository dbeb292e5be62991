//! Best-first search from both ends over any [`Domain`]: two trees by the steps of [`best_first`](super::best_first()).
//!
//! The domain knows how nodes of two trees form a path ([`Join`]): on a graph one node belongs to both, for a car two
//! poses are joined by a curve.
//!
//! Balance comes from sizes, not from turns: the tree with fewer waiting nodes grows. A car in a narrow slot can do
//! little, so the tree from the slot stays small and is finished first, while the tree from open space would fill the
//! whole lot.
//!
//! Let C be the cost of the best path so far. When the least f of one tree is at least C, no node that still waits in
//! this tree leads to a cheaper path. Each tree alone would find every path to its target, so this one condition
//! suffices.

use super::{Budget, Cost, Domain, End, Finish, Limits, Observer, SearchStats, Tree, Visit};

/// Two trees: the first grows from the start, the second against the direction of the path from the goal.
pub type Trees<'t, 'a, D> = &'t [Tree<'a, D>; 2];

/// How two trees are joined, and the cheapest path that came of it.
///
/// A join owns the best path, because only it knows how the two halves are put together: whether the second half is
/// reversed, and what a curve between them costs. The search reads its cost alone.
pub trait Join<D: Domain> {
    /// The cost of the cheapest path so far; [`Cost::MAX`] without one.
    fn best(&self) -> D::Cost;

    /// Takes the path through the node `at` of one tree and along a completion of its own.
    fn complete(
        &mut self,
        trees: Trees<D>,
        side: usize,
        at: Visit<D::Cost, D::Label>,
        finish: Finish<D::Cost, D::Tail>,
    );

    /// Takes paths through the node `at` of one tree, which is expanded next, and nodes that the other has reached.
    fn join(&mut self, trees: Trees<D>, side: usize, at: Visit<D::Cost, D::Label>);
}

/// How a bidirectional search ended, and what it did in both trees together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Summary {
    /// How it ended.
    pub end: End,
    /// Its counters, without the bytes.
    pub stats: SearchStats,
}

/// Grows the tree with fewer waiting nodes until neither can lead to a cheaper path than the best one of `join`.
///
/// A tree whose least f is no less than a path's cost has nothing cheaper to offer, and by itself it would find every
/// path; so with consistent heuristics, and joins wherever both trees have reached one node, the path is the cheapest.
/// `limits.first` takes the first one instead.
pub fn bidirectional_best_first<D: Domain, J: Join<D>, O: Observer<D::Cost, D::Label>>(
    trees: &mut [Tree<D>; 2],
    limits: Limits,
    join: &mut J,
    observer: &mut O,
) -> Summary {
    let mut expanded = 0;
    let mut budget = Budget::new(limits.max_expansions, observer);
    let end = loop {
        let best = join.best();
        if best < D::Cost::MAX && (limits.first || trees.iter_mut().any(|tree| tree.least() >= best)) {
            break End::Found;
        }
        let Some(side) = next_side(trees) else { break End::Exhausted };
        let tree = &mut trees[side];
        let Some(entry) = tree.pop() else { continue };
        if budget.is_spent(expanded, observer) {
            break End::BudgetSpent;
        }
        observer.side(side);
        let at = tree.close(&entry, observer);
        expanded += 1;
        if let Some(finish) = tree.complete(at, best) {
            join.complete(trees, side, at, finish);
        }
        join.join(trees, side, at);
        trees[side].expand(at, join.best(), observer);
    };
    let [a, b] = [trees[0].stats(), trees[1].stats()];
    let mut stats = SearchStats { expanded, ..a };
    stats.add(b);
    Summary { end, stats: SearchStats { open_peak: a.open_peak + b.open_peak, ..stats } }
}

/// The tree with fewer waiting nodes, and the first of equal ones; `None` where none waits.
fn next_side<D: Domain>([a, b]: &[Tree<D>; 2]) -> Option<usize> {
    match [a, b].map(|tree| tree.scratch.open.len()) {
        [0, 0] => None,
        [a, b] => Some(usize::from(a == 0 || (b > 0 && b < a))),
    }
}

#[cfg(test)]
mod tests;
