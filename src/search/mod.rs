//! Best-first search over any [`Domain`]; knows nodes and costs, nothing else.
//!
//! A best-first search keeps an *open list* of nodes that it has reached and not yet expanded. It takes the one
//! with the smallest priority
//!
//! ```text
//! f(n) = g(n) + h(n)
//! ```
//!
//! where g is the cost of the best known path from the root and h estimates the cost that remains. Expanding a node
//! emits its moves, and a move that improves its target enters the open list. With h = 0 this is Dijkstra's search,
//! with an estimate that never exceeds the true cost it is A\*.
//!
//! There are two cores, which agree in order, counters and result:
//!
//! * [`best_first()`] works on any [`Domain`]: costs of any ordered type, a label per node (a pose in hybrid A\*),
//!   and completions beyond the last node.
//! * [`lattice`] is for graphs whose nodes all have the same numbered moves and integer costs. It keeps a node in
//!   eight bytes, which grids need.
//!
//! Invariants that both rely on:
//!
//! * A node is expanded once and never reopened (moves that a lattice defers are a second part of it), so a path is
//!   the cheapest only where h is consistent: h(a) ≤ cost(a, b) + h(b) for every move.
//! * The open list is a total order ([`Order`]): f, then on grids h, then the age of the entry. The same input
//!   therefore gives the same expansions on every machine.
//! * Memory belongs to the caller ([`Scratch`], [`PackedScratch`]) and is not cleared between searches. Generation
//!   numbers tell old entries from new ones, so a query costs what it touches, not the size of the map.
//! * An [`Observer`] is a type parameter. `()` compiles to nothing; [`Trace`] keeps the order of expansions for
//!   drawing.
//! * A budget counts expansions, never time.

mod best_first;
#[cfg(feature = "complete")]
mod bidirectional;
#[cfg(feature = "complete")]
mod bidirectional_best_first;
mod bucket_queue;
mod bucket_sort;
mod budget;
mod entry;
mod frontier;
pub mod lattice;
mod node_table;
mod observer;
mod one_way;
mod open_list;
#[cfg(feature = "complete")]
mod recorded;
#[cfg(feature = "complete")]
mod recorded_both;
#[cfg(feature = "complete")]
mod recorded_domain;
#[cfg(feature = "complete")]
mod recording;
#[cfg(test)]
#[cfg(feature = "complete")]
mod reference;
#[cfg(test)]
#[cfg(feature = "complete")]
mod tests;
mod tree;

pub use best_first::{Limits, Report, best_first};
#[cfg(feature = "complete")]
pub use bidirectional::{Stop, bidirectional};
#[cfg(feature = "complete")]
pub use bidirectional_best_first::{Join, Summary, Trees, bidirectional_best_first};
pub(crate) use budget::Budget;
pub use entry::{Entry, PackedEntry, WideEntry};
pub use frontier::PackedScratch;
pub use node_table::Scratch;
#[cfg(feature = "complete")]
pub use observer::{ExpansionCallback, Expansions};
pub use observer::{Observer, Progress, ProgressCallback, Trace, Watch};
pub use one_way::{Found, one_way, one_way_deferring};
pub use open_list::Order;
#[cfg(feature = "complete")]
pub use recorded::{Considered, Legality, Part, record_deferring, record_one_way};
#[cfg(feature = "complete")]
pub use recorded_both::record_bidirectional;
#[cfg(feature = "complete")]
pub use recorded_domain::{
    Ground, Labelled, Told, Watched, record_best_first, record_bidirectional_best_first,
};
#[cfg(feature = "complete")]
pub use recording::{BACKWARD, Fate, PAST, Recording, StepKind};
pub use tree::Tree;

/// Index of a node. Indices are dense: the search's memory grows with the largest.
pub type NodeId = u32;

/// A totally ordered path cost, never NaN: `i64` micro-cells on grids, `f64` metres in hybrid A*.
pub trait Cost:
    Copy + PartialOrd + Default + std::ops::Add<Output = Self> + std::ops::Sub<Output = Self> + std::fmt::Debug
{
    /// Larger than every cost of a path.
    const MAX: Self;

    /// A coarse measure of a cost that grows with it, for sorting the open list in advance; 0 below zero.
    fn bucket(self) -> usize;
}

impl Cost for i64 {
    const MAX: Self = Self::MAX;

    fn bucket(self) -> usize {
        usize::try_from(self.max(0) >> 12).unwrap_or(usize::MAX)
    }
}

impl Cost for f64 {
    const MAX: Self = Self::INFINITY;

    fn bucket(self) -> usize {
        (self * 256.0) as usize
    }
}

/// A completion of the path at a node: its cost and its form ([`Domain::Tail`]).
#[derive(Debug, Clone, Copy)]
pub struct Finish<C, T> {
    /// Cost from the node to the target along the tail; zero at the target itself.
    pub cost: C,
    /// The form of the completion.
    pub tail: T,
}

/// The node being expanded, with its label, cost and parent.
#[derive(Debug, Clone, Copy)]
pub struct Visit<C, L> {
    /// The node.
    pub node: NodeId,
    /// Its label, as emitted with its best cost.
    pub label: L,
    /// Its cost from the root.
    pub g: C,
    /// The node it was reached from; `None` at the root.
    pub parent: Option<NodeId>,
}

/// A graph to search, defined by its moves.
///
/// Nodes are numbers. A domain of known size gives every node its number beforehand; hybrid A\* numbers states in the
/// order in which it meets them. What else a node needs is its label, which the search keeps with the node's best
/// cost.
///
/// ```
/// use parkade::search::{Domain, End, Finish, Limits, NodeId, Relax, Scratch, Visit, best_first};
///
/// /// For each junction the roads out of it: target and metres. The goal is junction 3.
/// struct Roads([&'static [(NodeId, f64)]; 4]);
///
/// impl Domain for Roads {
///     type Cost = f64;
///     type Label = ();
///     type Tail = ();
///
///     fn node_count(&self) -> usize {
///         self.0.len()
///     }
///
///     fn successors<S: Relax<f64, ()>>(&self, from: Visit<f64, ()>, sink: &mut S) {
///         for &(target, metres) in self.0[from.node as usize] {
///             sink.emit(target, metres, ());
///         }
///     }
///
///     fn heuristic(&self, _: NodeId, (): ()) -> f64 {
///         0.0
///     }
///
///     fn finish(&mut self, at: Visit<f64, ()>, _: f64) -> Option<Finish<f64, ()>> {
///         (at.node == 3).then_some(Finish { cost: 0.0, tail: () })
///     }
/// }
///
/// let mut roads = Roads([&[(1, 90.0), (2, 30.0)], &[(3, 10.0)], &[(1, 40.0), (3, 80.0)], &[]]);
/// let limits = Limits { max_expansions: 100, first: false };
/// let mut scratch = Scratch::new();
/// let report = best_first(&mut roads, (0, ()), limits, &mut scratch, &mut ());
/// assert_eq!(report.end, End::Found);
/// let junctions: Vec<NodeId> = scratch.chain(3).into_iter().map(|(node, ())| node).collect();
/// assert_eq!(junctions, [0, 2, 1, 3]);
/// ```
pub trait Domain {
    /// The cost of a path.
    type Cost: Cost;
    /// Kept per node with its best cost: `()` on grids, a pose in hybrid A*.
    type Label: Copy + Default;
    /// The completion of a path beyond its last node: `()`, or an analytic expansion.
    type Tail;

    /// Number of nodes known beforehand; a domain that names nodes as it meets them may emit larger ids.
    fn node_count(&self) -> usize;

    /// How equal priorities are ordered; the same throughout a search.
    #[inline(always)]
    fn order(&self) -> Order {
        Order::Newest
    }

    /// Emits every move out of the node: target, cost of the move, label at the target.
    ///
    /// `improves(target, cost)` tells beforehand whether the move would improve the target, so that expensive validity
    /// checks can be skipped; emitting without asking is allowed.
    fn successors<S: Relax<Self::Cost, Self::Label>>(
        &self,
        from: Visit<Self::Cost, Self::Label>,
        sink: &mut S,
    );

    /// Estimate of the cost from the node to the target; [`Cost::MAX`] where the target cannot be reached.
    fn heuristic(&self, node: NodeId, label: Self::Label) -> Self::Cost;

    /// A way to complete the path from this node for less than `bound` in all, if there is one.
    fn finish(
        &mut self,
        at: Visit<Self::Cost, Self::Label>,
        bound: Self::Cost,
    ) -> Option<Finish<Self::Cost, Self::Tail>>;
}

/// Receives the moves that a [`Domain`] emits.
pub trait Relax<C, L> {
    /// True if a move of this cost to `target` would improve on what is known.
    fn improves(&self, target: NodeId, cost: C) -> bool;
    /// True if `target` has been expanded: no move improves it any more.
    fn is_closed(&self, target: NodeId) -> bool {
        let _ = target;
        false
    }
    /// Takes a valid move that leads to `target` from the node's parent, past the node itself. Searches over a
    /// [`Domain`] do.
    fn emit_past(&mut self, target: NodeId, cost: C, label: L) {
        let _ = (target, cost, label);
    }
    /// Takes a valid move.
    fn emit(&mut self, target: NodeId, cost: C, label: L);
}

/// How a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The cheapest completion was reached.
    Found,
    /// Nothing is left to expand.
    Exhausted,
    /// The expansion budget is spent; a completion may be known all the same.
    BudgetSpent,
}
