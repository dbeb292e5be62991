//! Best-first search over a [`Lattice`] from its start.
//!
//! The order, the counters and the result equal those of [`best_first`](super::best_first). A node takes eight bytes,
//! so that a large map stays in the caches. [`bidirectional`](super::bidirectional()) runs the same search from both
//! ends.
//!
//! Per expansion the loop takes the first entry whose node is still open, closes the node, and asks the lattice for its
//! moves. It ends at the goal, or at a node from which the lattice knows a direct connection ([`Lattice::direct`]).
//! Because a node is never reopened, that is the cheapest path only if the estimate is consistent; with another
//! estimate it may be longer.
//!
//! A lattice that defers moves is searched by the same loop, with one rule more: [`Deferral`] says whether a node's
//! deferred moves are tried never, at once, or when the node is taken a second time. [`one_way`] compiles to a loop
//! without that rule.

use super::entry::Entry;
use super::frontier::{Frontier, PackedScratch, Record, Relaxing, cost_of, move_of};
use super::lattice::{Deferral, Deferring, EdgeSink, Lattice};
use super::{Budget, End, NodeId, Observer, SearchStats};

/// The path of a search and its counters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// How the search ended.
    pub end: End,
    /// Cost of the path in micro-cells; 0 without a path.
    pub cost: i64,
    /// Nodes from start to goal; empty without a path.
    pub nodes: Vec<NodeId>,
    /// Its counters.
    pub stats: SearchStats,
    /// Nodes whose deferred moves were tried.
    pub deferred: u32,
    /// Nodes that a bound excluded before they were processed; `None` where there are no bounds.
    pub rejected: Option<u32>,
    /// The expanded node with the smallest estimate to the goal.
    pub closest: NodeId,
}

/// Searches a path from the first node to the second: the cheapest one if the estimate is consistent.
/// `max_expansions` counts expanded nodes; a search that reaches it ends with [`End::BudgetSpent`] and without a
/// path. The memory is left as the search ended and serves the next search, of this map or another.
pub fn one_way<L: Lattice, O: Observer<i64, ()>>(
    lattice: &L,
    ends: (NodeId, NodeId),
    max_expansions: u32,
    memory: &mut PackedScratch<L::Entry>,
    observer: &mut O,
) -> Found {
    search::<L, NoneDeferred, O>(lattice, ends, max_expansions, memory, observer)
}

/// [`one_way`] over a lattice that defers moves.
pub fn one_way_deferring<L: Deferring, O: Observer<i64, ()>>(
    lattice: &L,
    ends: (NodeId, NodeId),
    max_expansions: u32,
    memory: &mut PackedScratch<L::Entry>,
    observer: &mut O,
) -> Found {
    search::<L, SomeDeferred, O>(lattice, ends, max_expansions, memory, observer)
}

/// The part of a one-sided search that concerns deferred moves.
trait DeferredMoves<L: Lattice> {
    /// True if there are any.
    const EXIST: bool;

    /// Emits those of a node: the ones whose entry carries the payload, or at once.
    fn emit<S: EdgeSink>(lattice: &L, node: NodeId, payload: Option<u32>, sink: &mut S);

    /// When those of the node that was expanded last are tried, and their payload.
    fn rule(lattice: &L) -> (Deferral, u32);
}

struct NoneDeferred;

impl<L: Lattice> DeferredMoves<L> for NoneDeferred {
    const EXIST: bool = false;

    fn emit<S: EdgeSink>(_: &L, _: NodeId, _: Option<u32>, _: &mut S) {}

    fn rule(_: &L) -> (Deferral, u32) {
        (Deferral::Never, 0)
    }
}

struct SomeDeferred;

impl<L: Deferring> DeferredMoves<L> for SomeDeferred {
    const EXIST: bool = true;

    #[inline]
    fn emit<S: EdgeSink>(lattice: &L, node: NodeId, payload: Option<u32>, sink: &mut S) {
        match payload {
            Some(payload) => lattice.deferred_successors(node, payload, sink),
            None => lattice.deferred_at_once(node, sink),
        }
    }

    #[inline]
    fn rule(lattice: &L) -> (Deferral, u32) {
        (lattice.deferral(), lattice.payload())
    }
}

/// The loop of both functions; `M` tells at compile time whether there are deferred moves.
fn search<L: Lattice, M: DeferredMoves<L>, O: Observer<i64, ()>>(
    lattice: &L,
    (start, goal): (NodeId, NodeId),
    max_expansions: u32,
    memory: &mut PackedScratch<L::Entry>,
    observer: &mut O,
) -> Found {
    let h = lattice.to_goal(start);
    memory.begin::<L, 1>(lattice);
    // Inadmissible estimates let f decrease below the root's.
    memory.root::<1>(0, start, (h, h), if M::EXIST { 0 } else { h });
    let mut found = Found::nothing(start);
    let mut nearest = h;
    let mut budget = Budget::new(max_expansions, observer);
    while let Some((entry, record)) = memory.pop::<1>(0, M::EXIST) {
        if budget.is_spent(found.stats.expanded, observer) {
            found.end = End::BudgetSpent;
            break;
        }
        let (node, h, g) = (entry.node(), entry.h(), cost_of(record));
        found.stats.expanded += 1;
        observer.expanded(node, (), g);
        if M::EXIST && entry.is_deferred() {
            found.deferred += 1;
            let sink = &mut only(lattice, memory, observer, (node, record));
            M::emit(lattice, node, Some(entry.payload()), sink);
            continue;
        }
        memory.close::<1>(0, node, record);
        if h < nearest {
            (nearest, found.closest) = (h, node);
        }
        let rest = if node == goal { Some(0) } else { lattice.direct(node) };
        if let Some(rest) = rest {
            found.end = End::Found;
            found.cost = g + rest;
            found.nodes = memory.chain::<L, 1>(lattice, 0, node, |at, number| lattice.before(at, number));
            found.nodes.reverse();
            if node != goal {
                found.nodes.push(goal);
                found.stats.generated += u32::from(!memory.is_known(goal));
            }
            break;
        }
        let pushes = memory.sides[0].open.pushes();
        lattice.successors(node, move_of(record), &mut only(lattice, memory, observer, (node, record)));
        let open = &mut memory.sides[0].open;
        match (M::rule(lattice), open.pushes() > pushes) {
            ((Deferral::Never, _), _) | ((Deferral::IfStuck, _), true) => {}
            (_, false) => {
                found.deferred += 1;
                M::emit(lattice, node, None, &mut only(lattice, memory, observer, (node, record)));
            }
            ((Deferral::Penalty(penalty), payload), true) => {
                open.push(g + h + penalty, h, L::Entry::deferred(node, payload));
            }
        }
    }
    found.count(lattice, &memory.sides[..1]);
    found
}

/// The sink of a one-sided search.
fn only<'a, L: Lattice, O>(
    lattice: &L,
    memory: &'a mut PackedScratch<L::Entry>,
    observer: &'a mut O,
    at: (NodeId, Record),
) -> Relaxing<'a, L, O, 1, 0> {
    Relaxing::new(lattice, memory, observer, at, None)
}

impl Found {
    /// The result of a search that has not begun: no path, and no node nearer to the goal than the start.
    pub(super) fn nothing(start: NodeId) -> Self {
        Self {
            end: End::Exhausted,
            cost: 0,
            nodes: Vec::new(),
            stats: SearchStats::default(),
            deferred: 0,
            rejected: None,
            closest: start,
        }
    }

    /// Adds the counters of the sides, and the bytes that records, parents and open lists need.
    pub(super) fn count<L: Lattice>(&mut self, lattice: &L, sides: &[Frontier<L::Entry>]) {
        let stats = &mut self.stats;
        for side in sides {
            stats.generated += side.generated;
            stats.pushes += side.open.pushes();
            stats.open_peak += side.open.peak();
        }
        let nodes = lattice.node_count();
        let records = (nodes + 2 * lattice.padding()) * sides.len() * size_of::<Record>();
        let parents = if L::JUMPS { nodes * size_of::<NodeId>() } else { 0 };
        stats.bytes = (records + parents + stats.open_peak as usize * size_of::<L::Entry>()) as u64;
    }
}
