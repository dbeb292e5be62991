//! The recorded search from both ends: the turns and stopping rules of [`bidirectional`](super::bidirectional()).
//!
//! Each side has an open list of its own, and both write into one recording in the order of their turns; a step's kind
//! tells the side ([`BACKWARD`](super::BACKWARD)).
//!
//! The recorder is written from the definition of the search, not from its code: a map of known nodes and a heap for
//! each side. Tests compare it with the fast search: order, costs, relaxed moves and counters. So a reader of a
//! recording sees what the planner did and not a second opinion.
//!
//! A step costs O(log n) for n known nodes, and every step is written down with all its moves. `limit` bounds the
//! memory: [`Recording::STEP_BYTES`] and [`Recording::MOVE_BYTES`] tell how much a step takes.

use super::NodeId;
use super::bidirectional::Stop;
use super::lattice::Reversible;
use super::recorded::{AskedBothWays, Considered, Known, Part, RecordedSide, RecordingSink, count, refuse};
use super::recording::{Recording, StepKind};

/// [`bidirectional`](super::bidirectional()), of which at most `limit` steps are written down.
/// A recording that reaches the limit is cut ([`Recording::is_cut`]), and its counters end there.
pub fn record_bidirectional<L: Considered + Reversible>(
    lattice: &L,
    ends: (NodeId, NodeId),
    stop: Stop,
    max_expansions: u32,
    limit: usize,
) -> Recording {
    both_ways(lattice, ends, stop, max_expansions, limit)
}

/// The search from both ends with its events: the sides take turns until the stopping rule ends it.
fn both_ways(
    lattice: &dyn AskedBothWays,
    (start, goal): (NodeId, NodeId),
    stop: Stop,
    max_expansions: u32,
    limit: usize,
) -> Recording {
    let far = lattice.to_goal(start);
    let mut search = TwoSides {
        lattice,
        stop,
        most: max_expansions,
        limit,
        sides: [start, goal].map(|root| RecordedSide::root(root, far)),
        best: (i64::MAX, start),
        last: [far; 2],
        current: [start, goal],
        out: Recording::default(),
    };
    while search.turn(0) && search.turn(1) {}
    count(search.out, &search.sides)
}

/// The state of the search: the fields of the fast one, with a [`RecordedSide`] in place of packed records.
struct TwoSides<'a> {
    lattice: &'a dyn AskedBothWays,
    stop: Stop,
    most: u32,
    limit: usize,
    sides: [RecordedSide; 2],
    /// The cheapest connection so far and its node.
    best: (i64, NodeId),
    /// Each side's last f.
    last: [i64; 2],
    /// The node that each side took up last.
    current: [NodeId; 2],
    out: Recording,
}

impl TwoSides<'_> {
    /// Takes up the side's next node. Tells whether to go on.
    fn turn(&mut self, turn: usize) -> bool {
        let Some(entry) = self.sides[turn].pop() else { return false };
        if self.out.stats.expanded >= self.most {
            return false;
        }
        if self.out.nodes.len() == self.limit {
            self.out.is_cut = true;
            return false;
        }
        let (node, h) = (entry.node, entry.h);
        let known = self.sides[turn].known[&node];
        let numbers = [known.g, h, entry.f].map(|value| value as f64);
        self.sides[turn].known.insert(node, Known { is_closed: true, ..known });
        self.current[turn] = node;
        if self.stop == Stop::Optimal {
            self.last[turn] = entry.f;
            let other = self.sides[1 - turn].known.entry(node).or_insert(Known {
                g: 0,
                number: None,
                is_closed: true,
            });
            other.is_closed = true;
            if self.is_excluded(turn, (node, known.g, h)) {
                self.out.step(StepKind::Rejected, turn, node, numbers);
                return entry.f < self.best.0;
            }
        } else if self.meets(turn, node) {
            self.out.stats.expanded += 1;
            self.out.step(StepKind::Meet, turn, node, numbers);
            return false;
        }
        self.expand(turn, (node, known), numbers);
        true
    }

    /// True if the sides meet in the node that one of them has just taken.
    fn meets(&self, turn: usize, node: NodeId) -> bool {
        match self.stop {
            Stop::Naive => self.current[1 - turn] == node,
            _ => self.sides[1 - turn].known.get(&node).is_some_and(|known| known.is_closed),
        }
    }

    /// True if no connection through the node is cheaper than the best one.
    fn is_excluded(&self, turn: usize, (node, g, h): (NodeId, i64, i64)) -> bool {
        let back = if turn == 0 { self.lattice.to_start(node) } else { self.lattice.to_goal(node) };
        self.best.0 < i64::MAX && (g + h >= self.best.0 || g + self.last[1 - turn] - back >= self.best.0)
    }

    /// Writes the node down with its moves: those that were relaxed, then those that were not and why.
    fn expand(&mut self, turn: usize, (node, known): (NodeId, Known), numbers: [f64; 3]) {
        self.out.stats.expanded += 1;
        self.out.step(StepKind::Expand, turn, node, numbers);
        let joins = matches!(self.stop, Stop::Best | Stop::Optimal);
        let [forward, backward] = &mut self.sides;
        let (side, other) = if turn == 0 { (forward, &*backward) } else { (backward, &*forward) };
        let best = joins.then_some(&mut self.best);
        let sink =
            &mut RecordingSink { side, other: Some(other), best, recording: &mut self.out, g: known.g };
        let part = if turn == 0 {
            self.lattice.successors(node, known.number, sink);
            Part::Forward
        } else {
            self.lattice.predecessors(node, known.number, sink);
            Part::Backward
        };
        refuse(self.lattice, (node, known, part), &self.sides[turn], &mut self.out, false);
    }
}
