//! Search from both ends at once, one node at a time in turns.
//!
//! The backward side follows *forward* costs against their direction ([`Reversible::predecessors`]), so costs may
//! depend on the direction of a move.
//!
//! The first meeting is not the cheapest path: two sides may touch on a dear way while a cheaper one is still open. The
//! rules ([`Stop`]) differ in what they do about that: take it, take the best connection seen so far, or search on
//! until no better one can exist. The last, NBA\* (Pijls and Post 2009), rejects a node if g and the bounds of both
//! sides show that no cheaper path leads through it; each node is expanded by one side only.
//!
//! NBA\* in formulas. Let side s take node n with cost gₛ(n), let F be the f of the node that the other side took
//! last, b(n) the estimate from n back to the root of side s, and M the cost of the best connection so far. A path
//! through n costs at least gₛ(n) + h(n); and because the other side has taken everything below F, also at least
//! gₛ(n) + F − b(n). Where one of the two bounds reaches M, no path through n is cheaper, and n is rejected without
//! an expansion. The search ends when a side's f reaches M.
//!
//! Both sides read and write one table of records, two adjacent ones per node. Each turn of a side costs what an
//! expansion of a one-sided search does, and one more look at the other side's record per relaxed move.

use super::entry::Entry;
use super::frontier::{PackedScratch, Record, Relaxing, cost_of, move_of};
use super::lattice::Reversible;
use super::one_way::Found;
use super::{Budget, End, NodeId, Observer};

/// When a search from both ends stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Stop {
    /// When one side takes up a node that the other has finished; the path leads through it. Not always the cheapest.
    #[default]
    First,
    /// Then, too; but the path leads through the best connection seen until then.
    Best,
    /// When no better connection can exist, which gives the cheapest path (Pijls and Post 2009).
    Optimal,
    /// When both sides have taken up the same node last; the path leads through it. Each side searches on through nodes
    /// that the other has finished, so the sides can miss each other and exhaust the map without a path.
    Naive,
}

/// Searches a path from `start` to `goal` from both ends. The estimates must be consistent.
/// With [`Stop::Optimal`] the path is the cheapest; with the other rules it may be longer, and with [`Stop::Naive`] a
/// search of connected ends may find none.
///
/// A search whose budget is spent returns no path, even where the sides have met: the connection known by then has no
/// meaning under any of the rules.
pub fn bidirectional<L: Reversible, O: Observer<i64, ()>>(
    lattice: &L,
    (start, goal): (NodeId, NodeId),
    stop: Stop,
    max_expansions: u32,
    memory: &mut PackedScratch<L::Entry>,
    observer: &mut O,
) -> Found {
    let far = lattice.to_goal(start);
    memory.begin::<L, 2>(lattice);
    for (turn, root) in [start, goal].into_iter().enumerate() {
        memory.root::<2>(turn, root, (far, far), far);
    }
    let mut search = Search {
        lattice,
        budget: Budget::new(max_expansions, observer),
        observer,
        stop,
        found: Found { rejected: (stop == Stop::Optimal).then_some(0), ..Found::nothing(start) },
        best: (i64::MAX, start),
        nearest: far,
        last: [far; 2],
        current: [start, goal],
    };
    while search.turn::<0>(memory) && search.turn::<1>(memory) {}
    let Search { mut found, best, .. } = search;
    if best.0 < i64::MAX && found.end != End::BudgetSpent {
        found.end = End::Found;
        found.cost = best.0;
        found.nodes = memory.chain::<L, 2>(lattice, 0, best.1, |at, number| lattice.before(at, number));
        found.nodes.reverse();
        let back = memory.chain::<L, 2>(lattice, 1, best.1, |at, number| lattice.after(at, number));
        found.nodes.extend(&back[1..]);
    }
    found.count(lattice, &memory.sides);
    found
}

struct Search<'a, L, O> {
    lattice: &'a L,
    observer: &'a mut O,
    stop: Stop,
    budget: Budget,
    found: Found,
    /// The cheapest connection so far, and the node that it leads through.
    best: (i64, NodeId),
    nearest: i64,
    /// Each side's last f.
    last: [i64; 2],
    /// The node that each side took up last.
    current: [NodeId; 2],
}

/// The side is a const generic, which avoids a branch per node.
impl<L: Reversible, O: Observer<i64, ()>> Search<'_, L, O> {
    /// Takes up the side's next node. Tells whether to go on.
    #[inline]
    fn turn<const TURN: usize>(&mut self, memory: &mut PackedScratch<L::Entry>) -> bool {
        let Some((entry, record)) = memory.pop::<2>(TURN, false) else { return false };
        if self.budget.is_spent(self.found.stats.expanded, self.observer) {
            self.found.end = End::BudgetSpent;
            return false;
        }
        let (node, h) = (entry.node(), entry.h());
        let goes_on = if self.stop == Stop::Optimal {
            self.bounded::<TURN>((node, entry.f(), h), record, memory)
        } else {
            self.meeting::<TURN>(node, record, memory)
        };
        if goes_on == Some(true) {
            self.expand::<TURN>((node, h), record, memory);
        }
        goes_on.is_some()
    }

    /// One turn until the sides meet. Tells whether to go on, and whether with an expansion.
    #[inline]
    fn meeting<const TURN: usize>(
        &mut self,
        node: NodeId,
        record: Record,
        memory: &mut PackedScratch<L::Entry>,
    ) -> Option<bool> {
        memory.close::<2>(TURN, node, record);
        self.current[TURN] = node;
        let meets = match self.stop {
            Stop::Naive => self.current[1 - TURN] == node,
            _ => memory.is_closed(1 - TURN, node),
        };
        if meets {
            let g = cost_of(record);
            self.found.stats.expanded += 1;
            self.observer.expanded(node, (), g);
            if self.stop != Stop::Best {
                self.best = (g + memory.known(1 - TURN, node).unwrap_or_default(), node);
            }
            return None;
        }
        Some(true)
    }

    /// One turn of NBA*. Tells whether to go on, and whether with an expansion.
    #[inline]
    fn bounded<const TURN: usize>(
        &mut self,
        (node, f, h): (NodeId, i64, i64),
        record: Record,
        memory: &mut PackedScratch<L::Entry>,
    ) -> Option<bool> {
        let g = cost_of(record);
        self.last[TURN] = f;
        memory.close_for_both(TURN, node, record);
        if self.best.0 < i64::MAX {
            let back = if TURN == 0 { self.lattice.to_start(node) } else { self.lattice.to_goal(node) };
            if g + h >= self.best.0 || g + self.last[1 - TURN] - back >= self.best.0 {
                *self.found.rejected.get_or_insert_default() += 1;
                return (f < self.best.0).then_some(false);
            }
        }
        Some(true)
    }

    /// Emits the node's moves on its side: along their direction from the start, against it from the goal.
    #[inline]
    fn expand<const TURN: usize>(
        &mut self,
        (node, h): (NodeId, i64),
        record: Record,
        memory: &mut PackedScratch<L::Entry>,
    ) {
        let (g, last) = (cost_of(record), move_of(record));
        self.found.stats.expanded += 1;
        self.observer.expanded(node, (), g);
        if TURN == 0 && h < self.nearest {
            (self.nearest, self.found.closest) = (h, node);
        }
        let best = matches!(self.stop, Stop::Best | Stop::Optimal).then_some(&mut self.best);
        let mut sink: Relaxing<L, O, 2, TURN> =
            Relaxing::new(self.lattice, memory, self.observer, (node, record), best);
        if TURN == 0 {
            self.lattice.successors(node, last, &mut sink);
        } else {
            self.lattice.predecessors(node, last, &mut sink);
        }
    }
}
