//! A graph to search, defined by its moves.
//!
//! A domain answers four questions and keeps no account of the search: which moves leave a node, how far the target
//! is at least, whether a path may be completed from here, and in which order equal entries are taken. Costs must not
//! be negative, and the estimate must be consistent, h(a) ≤ cost(a, b) + h(b), for the first path taken to be the
//! cheapest; nodes are not reopened.

use super::cost::{Cost, NodeId};
use super::open_list::Order;

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
