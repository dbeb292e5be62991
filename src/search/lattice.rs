//! Best-first search where every node has the same few moves and costs are whole numbers: eight bytes a node.
//!
//! The order, the counters and the result are those of [`best_first`](super::best_first); nodes carry no label and
//! remember the move that led to them instead of their parent, so that a large map fits the caches. `bidirectional`
//! searches from both ends.
//!
//! A lattice may hold back part of a node's moves ([`Lattice::HOLDS_BACK`]) until [`Lattice::hold`] lets them go.

use super::entry::Entry;
use super::frontier::{Frontier, MOVE, PackedScratch, Record, Relaxing, cost_of, move_of};
use super::{Budget, End, NodeId, Observer};

/// A graph whose nodes have numbered moves, at most 255, the same at each.
pub trait Lattice {
    /// What the open list keeps: [`PackedEntry`](super::PackedEntry), or [`WideEntry`](super::WideEntry) where priorities may be below zero or
    /// beyond 2⁴⁸.
    type Entry: Entry;

    /// Whether a move's number does not tell where it begins, so that parents must be kept.
    const JUMPS: bool = false;
    /// Whether [`Lattice::held_back`] has anything to add.
    const HOLDS_BACK: bool = false;

    /// Number of nodes.
    fn node_count(&self) -> usize;

    /// How many numbers below 0 or from [`Lattice::node_count`] on its moves may name in [`EdgeSink::worth_around`].
    fn rim(&self) -> usize {
        0
    }

    /// Offers the legal moves out of the node to `sink`. `last` is the move that led to it, where there was one: what
    /// the node before has been offered at no higher cost need not be offered again.
    fn successors<S: EdgeSink>(&self, node: NodeId, last: Option<u32>, sink: &mut S);

    /// Offers the legal moves into the node: its number, the node that it comes from and its cost *from there*. `last`
    /// is the move that leads out of the node.
    fn predecessors<S: EdgeSink>(&self, node: NodeId, last: Option<u32>, sink: &mut S);

    /// The node that the move leads to.
    fn after(&self, node: NodeId, number: u32) -> NodeId;

    /// The node that the move comes from.
    fn before(&self, node: NodeId, number: u32) -> NodeId;

    /// Offers the moves that [`Lattice::successors`] held back, with the node's [`Lattice::note`].
    fn held_back<S: EdgeSink>(&self, node: NodeId, note: u32, sink: &mut S) {
        let _ = (node, note, sink);
    }

    /// Offers them right after [`Lattice::successors`] of the same node, which improved nothing.
    fn held_back_at_once<S: EdgeSink>(&self, node: NodeId, sink: &mut S) {
        let _ = (node, sink);
    }

    /// What [`Lattice::held_back`] shall be told of the node whose successors were offered last, from 0 to 7.
    fn note(&self) -> u32 {
        0
    }

    /// When the moves that [`Lattice::successors`] held back are tried.
    fn hold(&self) -> Hold {
        Hold::UntilStuck
    }

    /// The cost of what completes the path from a node other than the goal, if anything does.
    fn shot(&self, node: NodeId) -> Option<i64> {
        let _ = node;
        None
    }

    /// A lower bound of the cost from the node to the goal.
    fn to_goal(&self, node: NodeId) -> i64;

    /// A lower bound of the cost from the start to the node.
    fn to_start(&self, node: NodeId) -> i64;
}

/// When a node's held-back moves are tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hold {
    /// Never.
    Forever,
    /// At once where the node's other moves improved nothing, else never.
    UntilStuck,
    /// At once where the node's other moves improved nothing, else when the node is popped a second time: its
    /// priority is put back by this much.
    Penalty(i64),
}

/// A move as a search keeps it.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// What it costs.
    pub(super) cost: i64,
    /// The cost and, in the lowest bits, the number.
    pub(super) code: u64,
}

impl Edge {
    /// The move of a number, at most 254, and a cost.
    #[inline]
    pub const fn new(number: u32, cost: i64) -> Self {
        Self { cost, code: (cost as u64) << MOVE | number as u64 }
    }

    /// The same move at another cost.
    #[must_use]
    pub const fn at(self, cost: i64) -> Self {
        Self::new((self.code & ((1 << MOVE) - 1)) as u32, cost)
    }
}

/// Where a [`Lattice`] offers its moves.
pub trait EdgeSink {
    /// Whether a move of this cost would improve what is known of `target`.
    fn worth(&self, target: NodeId, cost: i64) -> bool;
    /// The same for steps to the eight nodes around one, where rows have `row` nodes: bit c for the c-th of E, NE, N, NW,
    /// W, SW, S, SE. Nodes that there are not give either answer.
    fn worth_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32;
    /// The same for steps to the east, north, west and south: bits 0, 2, 4 and 6.
    fn worth_beside(&self, node: NodeId, row: usize, straight: i64) -> u32;
    /// Takes a move for which [`EdgeSink::worth`] has just said yes, with the estimate beyond `target`.
    fn take(&mut self, leg: Edge, target: NodeId, h: i64);
}

/// What a search found and what it did.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// How it ended.
    pub end: End,
    /// Cost of the path; 0 where there is none.
    pub cost: i64,
    /// The path's nodes from start to goal; empty where there is none.
    pub nodes: Vec<NodeId>,
    /// Nodes taken from the open lists and processed, the last one included.
    pub expanded: u32,
    /// Nodes that entered an open list, once per list.
    pub generated: u32,
    /// All insertions.
    pub pushes: u32,
    /// Nodes whose held-back moves were tried.
    pub deferred: u32,
    /// Nodes that a bound excluded before they were processed.
    pub rejected: u32,
    /// Largest number of entries held at once.
    pub open_peak: u32,
    /// The expanded node with the smallest estimate to the goal.
    pub closest: NodeId,
    /// Bytes of the nodes' records and of the open lists at their largest.
    pub bytes: u64,
}

/// Searches the cheapest path from `start` to `goal`; with an inconsistent estimate, some path.
pub fn one_way<L: Lattice, O: Observer<i64, ()>>(
    lattice: &L,
    (start, goal): (NodeId, NodeId),
    max_expansions: u32,
    memory: &mut PackedScratch<L::Entry>,
    observer: &mut O,
) -> Found {
    let h = lattice.to_goal(start);
    memory.begin::<L, 1>(lattice);
    // Estimates that are no lower bounds let f fall.
    memory.root::<1>(0, start, (h, h), if L::HOLDS_BACK { 0 } else { h });
    let mut found = Found::nothing(start);
    let mut nearest = h;
    let mut budget = Budget::new(max_expansions, observer);
    while let Some((entry, record)) = memory.pop::<1>(0, L::HOLDS_BACK) {
        if budget.is_spent(found.expanded, observer) {
            found.end = End::BudgetSpent;
            break;
        }
        let (node, h, g) = (entry.node(), entry.h(), cost_of(record));
        found.expanded += 1;
        observer.expanded(node, (), g);
        if L::HOLDS_BACK && entry.is_held() {
            found.deferred += 1;
            lattice.held_back(node, entry.note(), &mut only(lattice, memory, observer, (node, record)));
            continue;
        }
        memory.close::<1>(0, node, record);
        if h < nearest {
            (nearest, found.closest) = (h, node);
        }
        let rest = if node == goal { Some(0) } else { lattice.shot(node) };
        if let Some(rest) = rest {
            found.end = End::Found;
            found.cost = g + rest;
            found.nodes = memory.chain::<L, 1>(lattice, 0, node, |at, number| lattice.before(at, number));
            found.nodes.reverse();
            if node != goal {
                found.nodes.push(goal);
                found.generated += u32::from(!memory.is_known(goal));
            }
            break;
        }
        let pushes = memory.sides[0].open.pushes();
        lattice.successors(node, move_of(record), &mut only(lattice, memory, observer, (node, record)));
        if L::HOLDS_BACK {
            let open = &mut memory.sides[0].open;
            match (lattice.hold(), open.pushes() > pushes) {
                (Hold::Forever, _) | (Hold::UntilStuck, true) => {}
                (_, false) => {
                    found.deferred += 1;
                    lattice.held_back_at_once(node, &mut only(lattice, memory, observer, (node, record)));
                }
                (Hold::Penalty(penalty), true) => {
                    open.push(g + h + penalty, h, L::Entry::held(node, lattice.note()));
                }
            }
        }
    }
    found.count(lattice, &memory.sides[..1]);
    found
}

/// Relaxing in a search of one side.
fn only<'a, L: Lattice, O>(
    lattice: &L,
    memory: &'a mut PackedScratch<L::Entry>,
    observer: &'a mut O,
    at: (NodeId, Record),
) -> Relaxing<'a, L, O, 1, 0> {
    Relaxing::new(lattice, memory, observer, at, None)
}

impl Found {
    pub(super) fn nothing(start: NodeId) -> Self {
        Self {
            end: End::Exhausted,
            cost: 0,
            nodes: Vec::new(),
            expanded: 0,
            generated: 0,
            pushes: 0,
            deferred: 0,
            rejected: 0,
            open_peak: 0,
            closest: start,
            bytes: 0,
        }
    }

    pub(super) fn count<L: Lattice>(&mut self, lattice: &L, sides: &[Frontier<L::Entry>]) {
        for side in sides {
            self.generated += side.generated;
            self.pushes += side.open.pushes();
            self.open_peak += side.open.peak();
        }
        let nodes = lattice.node_count();
        let records = (nodes + 2 * lattice.rim()) * sides.len() * size_of::<Record>();
        let parents = if L::JUMPS { nodes * size_of::<NodeId>() } else { 0 };
        self.bytes = (records + parents + self.open_peak as usize * size_of::<L::Entry>()) as u64;
    }
}
