//! Best-first search over graphs whose nodes all have the same few numbered moves, with integer costs.
//!
//! The order, the counters and the result equal those of [`best_first`](super::best_first). A node takes eight bytes:
//! it carries no label and stores the number of the move that reached it instead of its parent, so that a large map
//! stays in the caches. `bidirectional` runs the same search from both ends.
//!
//! Two traits add what only some lattices can do: [`Reversible`] lattices are searched from both ends, [`Deferring`]
//! ones keep some of a node's moves for later.

use super::entry::Entry;
use super::frontier::{COST, Frontier, MOVE, PackedScratch, ROOT, Record, Relaxing, cost_of, move_of};
use super::{Budget, End, NodeId, Observer};

/// A graph whose nodes all have the same numbered moves, at most 255.
pub trait Lattice {
    /// The type of an open-list entry: [`PackedEntry`](super::PackedEntry), or [`WideEntry`](super::WideEntry) where
    /// priorities may be negative or reach 2⁴⁸.
    type Entry: Entry;

    /// True if a move's number does not determine its origin, so that the search stores parents.
    const JUMPS: bool = false;

    /// Number of nodes.
    fn node_count(&self) -> usize;

    /// Padding on each side of the node range that [`EdgeSink::improves_around`] may read, in nodes.
    fn padding(&self) -> usize {
        0
    }

    /// Emits the legal moves out of `node`. `last` is the move that reached the node, `None` at the root. Moves that
    /// the previous node already offered at no higher cost may be left out.
    fn successors<S: EdgeSink>(&self, node: NodeId, last: Option<u32>, sink: &mut S);

    /// The origin of move `number` into `node`. Not asked of a lattice that [`Lattice::JUMPS`].
    fn before(&self, node: NodeId, number: u32) -> NodeId;

    /// Cost of a direct connection from `node`, which is not the goal, to the goal; `None` where there is none.
    fn direct(&self, node: NodeId) -> Option<i64> {
        let _ = node;
        None
    }

    /// A lower bound of the cost from the node to the goal.
    fn to_goal(&self, node: NodeId) -> i64;
}

/// A lattice that can be searched from the goal as well.
pub trait Reversible: Lattice {
    /// Emits the legal moves into `node`: the move's number, its origin and its forward cost *from that origin*. `last`
    /// is the move that leaves the node.
    fn predecessors<S: EdgeSink>(&self, node: NodeId, last: Option<u32>, sink: &mut S);

    /// The target of move `number` from `node`.
    fn after(&self, node: NodeId, number: u32) -> NodeId;

    /// A lower bound of the cost from the start to the node.
    fn to_start(&self, node: NodeId) -> i64;
}

/// A lattice that tries some of a node's moves later than the others, or never.
pub trait Deferring: Lattice {
    /// Emits the moves that [`Lattice::successors`] deferred; `payload` is the node's [`Deferring::payload`].
    fn deferred_successors<S: EdgeSink>(&self, node: NodeId, payload: u32, sink: &mut S);

    /// Emits the deferred moves directly after [`Lattice::successors`] of the same node, which improved nothing.
    fn deferred_at_once<S: EdgeSink>(&self, node: NodeId, sink: &mut S);

    /// Three-bit payload (0 to 7) stored with the deferred entry of the node that was expanded last.
    fn payload(&self) -> u32;

    /// The rule that says when deferred moves are tried.
    fn deferral(&self) -> Deferral;
}

/// The rule that says when a node's deferred moves are tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Deferral {
    /// Never.
    Never,
    /// At once if the node's other moves improved nothing, otherwise never.
    IfStuck,
    /// At once if the node's other moves improved nothing; otherwise the node re-enters the open list with its f raised
    /// by this many micro-cells, and the moves are tried when it is popped again.
    Penalty(i64),
}

/// A move: its cost in micro-cells and its number.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// Micro-cells, at least 0 and below 2⁴⁴.
    pub(super) cost: i64,
    /// The cost above the lowest [`MOVE`] bits, which hold the number: the layout of a [`Record`].
    pub(super) code: u64,
}

impl Edge {
    /// A move with a number of at most 254 and a cost from 0 to below 2⁴⁴.
    #[inline]
    pub const fn new(number: u32, cost: i64) -> Self {
        debug_assert!(number <= ROOT && 0 <= cost && cost <= COST);
        Self { cost, code: (cost as u64) << MOVE | number as u64 }
    }

    /// Its cost, micro-cells.
    #[cfg(feature = "complete")]
    pub const fn cost(self) -> i64 {
        self.cost
    }

    /// The same move at another cost.
    #[must_use]
    pub const fn at(self, cost: i64) -> Self {
        Self::new((self.code & ((1 << MOVE) - 1)) as u32, cost)
    }
}

/// Receives the moves that a [`Lattice`] emits.
pub trait EdgeSink {
    /// True if a move of this cost improves the best known cost of `target`.
    fn improves(&self, target: NodeId, cost: i64) -> bool;
    /// The same for steps to the eight neighbours of `node` in rows of `row` nodes: bit c stands for the c-th of E, NE,
    /// N, NW, W, SW, S, SE. The bits of neighbours outside the map are arbitrary.
    fn improves_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32;
    /// The same for the four straight steps: bits 0, 2, 4 and 6 for E, N, W and S.
    fn improves_beside(&self, node: NodeId, row: usize, straight: i64) -> u32;
    /// Relaxes a move for which [`EdgeSink::improves`] has just returned true; `h` is the estimate at `target`.
    fn relax(&mut self, edge: Edge, target: NodeId, h: i64);
}

/// The path of a search and its counters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// How the search ended.
    pub end: End,
    /// Cost of the path in micro-cells; 0 without a path.
    pub cost: i64,
    /// Nodes from start to goal; empty without a path.
    pub nodes: Vec<NodeId>,
    /// Nodes popped and expanded, the goal included.
    pub expanded: u32,
    /// Nodes that entered an open list, once per list.
    pub generated: u32,
    /// Insertions into the open lists.
    pub pushes: u32,
    /// Nodes whose deferred moves were tried.
    pub deferred: u32,
    /// Nodes that a bound excluded before they were processed.
    pub rejected: u32,
    /// Largest number of open-list entries.
    pub open_peak: u32,
    /// The expanded node with the smallest estimate to the goal.
    pub closest: NodeId,
    /// Bytes of the node records plus the open lists at their peak.
    pub bytes: u64,
}

/// Searches a path from the first node to the second: the cheapest one if the estimate is consistent.
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
        if budget.is_spent(found.expanded, observer) {
            found.end = End::BudgetSpent;
            break;
        }
        let (node, h, g) = (entry.node(), entry.h(), cost_of(record));
        found.expanded += 1;
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
                found.generated += u32::from(!memory.is_known(goal));
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
        let records = (nodes + 2 * lattice.padding()) * sides.len() * size_of::<Record>();
        let parents = if L::JUMPS { nodes * size_of::<NodeId>() } else { 0 };
        self.bytes = (records + parents + self.open_peak as usize * size_of::<L::Entry>()) as u64;
    }
}
