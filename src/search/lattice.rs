//! Graphs whose nodes all have the same few numbered moves, with integer costs.
//!
//! A node carries no label, and the number of the move that reached it stands for its parent.
//!
//! Two traits add what only some lattices can do: [`Reversible`] lattices are searched from both ends, [`Deferring`]
//! ones keep some of a node's moves for later.
//!
//! A search from the start tries the moves *out of* a node ([`Lattice::successors`]). Costs are micro-cells, 10⁻⁶ of
//! a cell, in whole numbers: sums are exact, so that equal costs are real ties and the order of expansions is the
//! same on every machine. One rule of rounding keeps estimates consistent: the cost of a move is rounded up, the
//! estimate down.
//!
//! The lattice decides what is legal, and the sink what is worthwhile. The cheap question comes first: a lattice asks
//! [`EdgeSink::improves`], which reads one number of the search's memory, before it looks at the map.
//!
//! ```
//! use parkade::search::lattice::{Edge, EdgeSink, Lattice};
//! use parkade::search::{End, NodeId, PackedEntry, PackedScratch, one_way};
//!
//! /// A corridor of ten cells with the goal in cell 7. Move 0 leads to the next cell, move 1 to the previous one.
//! struct Corridor;
//!
//! const CELL: i64 = 1_000_000;
//!
//! impl Lattice for Corridor {
//!     type Entry = PackedEntry;
//!
//!     fn node_count(&self) -> usize {
//!         10
//!     }
//!
//!     fn successors<S: EdgeSink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
//!         for (number, target) in [(0, node + 1), (1, node.wrapping_sub(1))] {
//!             if target < 10 && sink.improves(target, CELL) {
//!                 sink.relax(Edge::new(number, CELL), target, self.to_goal(target));
//!             }
//!         }
//!     }
//!
//!     fn before(&self, node: NodeId, number: u32) -> NodeId {
//!         if number == 0 { node - 1 } else { node + 1 }
//!     }
//!
//!     fn to_goal(&self, node: NodeId) -> i64 {
//!         i64::from(node.abs_diff(7)) * CELL
//!     }
//! }
//!
//! let found = one_way(&Corridor, (2, 7), 100, &mut PackedScratch::default(), &mut ());
//! assert_eq!((found.end, found.cost), (End::Found, 5 * CELL));
//! assert_eq!(found.nodes, [2, 3, 4, 5, 6, 7]);
//! ```

use super::NodeId;
use super::entry::Entry;

/// Bits of a move's number in a record.
pub(super) const MOVE: u32 = 8;
/// The number that stands for "no move" in the root's record.
pub(super) const ROOT: u32 = 255;
/// The largest cost that a record holds.
pub(super) const COST: i64 = (1 << 44) - 1;

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
