//! A search written down event by event, for people who want to follow it.
//!
//! The fast searches keep only the order of their expansions. [`record_one_way`](super::record_one_way) and
//! [`record_bidirectional`](super::record_bidirectional) repeat a search over the same lattice at leisure and write
//! down every entry taken from the open list and every move considered there, with the reason for what became of
//! it.

use super::{NodeId, SearchStats};

/// What an entry taken from the open list led to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepKind {
    /// The node was closed and its moves were tried.
    Expand = 0,
    /// The node's deferred moves were tried.
    Deferred = 1,
    /// A bound excluded the node (NBA*).
    Rejected = 2,
    /// The node completes the path.
    Goal = 3,
    /// The node is where the two sides meet.
    Meet = 4,
    /// The node completes a path, and its moves were tried for a cheaper one.
    Joined = 5,
    /// A cell was drawn at random; this node of the tree is the nearest to it, and stays in the tree.
    Drawn = 6,
    /// A whole path was judged: its legs are the moves, from the node on, one after another; f is its fitness, the
    /// least the best.
    Candidate = 7,
}

/// What became of a move that was considered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// The target entered the open list for the first time.
    Kept = 0,
    /// The target was open at a higher cost.
    Improved = 1,
    /// The target was open at no higher cost.
    Dearer = 2,
    /// The target had been expanded.
    Closed = 3,
    /// The target is blocked.
    Blocked = 4,
    /// The target is free, but the way to it cuts a corner or crosses a blocked cell.
    Corner = 5,
    /// The move waits until the node's deferred moves are tried.
    HeldBack = 6,
    /// The node itself re-entered the open list for its deferred moves, its f raised by the penalty.
    Requeued = 7,
    /// The search's rule leaves the move out.
    LeftOut = 8,
    /// No move: the cell that was drawn, or the end of a candidate's free leg.
    Drawn = 9,
}

/// Micro-cells of a cell.
pub(super) const MICRO: f64 = 1e6;
/// Added to a [`Fate`]: the move leads from the node's parent, past the node itself.
pub const PAST: u8 = 16;
/// Added to a [`StepKind`]: the side that searches from the goal.
pub const BACKWARD: u8 = 16;

/// The events of a search in columns.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Recording {
    /// Per step its [`StepKind`], with [`BACKWARD`] where the side from the goal took it.
    pub kinds: Vec<u8>,
    /// Per step its node.
    pub nodes: Vec<NodeId>,
    /// Per step the node's cost from its side's root.
    pub g: Vec<f64>,
    /// Per step the estimate of the way ahead.
    pub h: Vec<f64>,
    /// Per step the priority by which it was taken.
    pub f: Vec<f64>,
    /// Per step the number of its first move in the columns below, and their total.
    pub first: Vec<u32>,
    /// Per move its target.
    pub targets: Vec<NodeId>,
    /// Per move the target's cost along it.
    pub target_g: Vec<f64>,
    /// Per move the estimate at its target; 0 where the move was not legal.
    pub target_h: Vec<f64>,
    /// Per move its [`Fate`], with [`PAST`] where it leads from the node's parent.
    pub fates: Vec<u8>,
    /// True if the oldest of the entries with the least f is taken ([`Order::Oldest`](super::Order::Oldest)), whatever
    /// its h.
    pub oldest_first: bool,
    /// Costs per cell or metre: a million where the search reckons in micro-cells, 1 where in `f64`.
    pub unit: f64,
    /// Steps beyond the limit are missing.
    pub is_cut: bool,
    /// The penalty by which f of [`Fate::Requeued`] exceeds g + h.
    pub penalty: f64,
    /// The planner's counters.
    pub stats: SearchStats,
}

impl Recording {
    /// Bytes that a step and a move take at most.
    pub const STEP_BYTES: usize = 33;
    /// Bytes that a move takes.
    pub const MOVE_BYTES: usize = 21;

    /// Adds a step of a planner without an open list, and what it did: target, fate and cost there. Costs are
    /// micro-cells.
    pub(crate) fn add(
        &mut self,
        limit: usize,
        (kind, node, [g, h]): (StepKind, NodeId, [i64; 2]),
        moves: &[(NodeId, Fate, i64)],
    ) {
        self.is_cut |= self.nodes.len() == limit;
        if !self.is_cut {
            self.step(kind, 0, node, [g as f64, h as f64, (g + h) as f64]);
            for &(target, fate, g) in moves {
                self.offer(target, fate as u8, g as f64, 0.0);
            }
        }
    }

    /// With the planner's counters.
    pub(crate) fn counted(self, stats: SearchStats) -> Self {
        Self { unit: MICRO, stats, ..self }.finish()
    }

    /// A search without steps: nothing had to be searched.
    pub fn empty() -> Self {
        Self { unit: MICRO, ..Self::default() }.finish()
    }

    pub(super) fn step(&mut self, kind: StepKind, side: usize, node: NodeId, [g, h, f]: [f64; 3]) {
        self.kinds.push(kind as u8 + if side == 1 { BACKWARD } else { 0 });
        self.nodes.push(node);
        self.g.push(g);
        self.h.push(h);
        self.f.push(f);
        self.first.push(self.targets.len() as u32);
    }

    pub(super) fn offer(&mut self, target: NodeId, fate: u8, g: f64, h: f64) {
        self.targets.push(target);
        self.target_g.push(g);
        self.target_h.push(h);
        self.fates.push(fate);
    }

    pub(super) fn finish(mut self) -> Self {
        self.first.push(self.targets.len() as u32);
        self
    }
}
