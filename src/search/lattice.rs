//! Best-first search where every node has the same few moves and costs are whole numbers: eight bytes a node.
//!
//! The order, the counters and the result are those of [`best_first`](super::best_first); nodes carry no label and
//! remember the move that led to them instead of their parent, so that a large map fits the caches. `both_ways`
//! searches from both ends.

use super::queue::Queue;
use super::{End, NodeId, Observer};

/// A graph whose nodes have numbered moves, at most 63, the same at each.
pub trait Lattice {
    /// Number of nodes.
    fn node_count(&self) -> usize;

    /// How many numbers below 0 or from [`Lattice::node_count`] on its moves may name in [`Sink::worth_around`].
    fn rim(&self) -> usize {
        0
    }

    /// Offers the legal moves out of the node to `sink`. `last` is the move that led to it, where there was one: what
    /// the node before has been offered at no higher cost need not be offered again.
    fn successors<S: Sink>(&self, node: NodeId, last: Option<u32>, sink: &mut S);

    /// Offers the legal moves into the node: its number, the node that it comes from and its cost *from there*. `last`
    /// is the move that leads out of the node.
    fn predecessors<S: Sink>(&self, node: NodeId, last: Option<u32>, sink: &mut S);

    /// The node that the move leads to.
    fn after(&self, node: NodeId, number: u32) -> NodeId;

    /// The node that the move comes from.
    fn before(&self, node: NodeId, number: u32) -> NodeId;

    /// A lower bound of the cost from the node to the goal.
    fn to_goal(&self, node: NodeId) -> i64;

    /// A lower bound of the cost from the start to the node.
    fn to_start(&self, node: NodeId) -> i64;
}

/// Where a [`Lattice`] offers its moves.
pub trait Sink {
    /// Whether a move of this cost would improve what is known of `target`.
    fn worth(&self, target: NodeId, cost: i64) -> bool;
    /// The same for steps to the eight nodes around one, where rows have `row` nodes: bit c for the c-th of E, NE, N, NW,
    /// W, SW, S, SE. Nodes that there are not give either answer.
    fn worth_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32;
    /// The same for steps to the east, north, west and south: bits 0, 2, 4 and 6.
    fn worth_beside(&self, node: NodeId, row: usize, straight: i64) -> u32;
    /// Takes a move for which [`Sink::worth`] has just said yes, with the estimate beyond `target`.
    fn take(&mut self, number: u32, target: NodeId, cost: i64, h: i64);
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
    /// Nodes that a bound excluded before they were processed.
    pub rejected: u32,
    /// Largest number of entries held at once.
    pub open_peak: u32,
    /// The expanded node with the smallest estimate to the goal.
    pub closest: NodeId,
}

/// The memory of these searches, reused between them: nothing is cleared, so a query costs what it touches.
#[derive(Debug, Default)]
pub struct Memory {
    pub(super) sides: [Side; 2],
}

/// One node: from the lowest bit, 6 bits of the move that led to it, 44 of its cost, 1 set while it is open, 13 of the
/// generation, which counts down. So whatever is closed, cheaper or blocked is a smaller number than a candidate, and
/// whatever is left from an earlier search a larger one: one comparison tells.
type Record = u64;

const OPEN: Record = 1 << 50;
const GENERATION: Record = 1 << 51;
const GENERATIONS: u64 = 1 << 13;
/// The move that leads to the root.
const ROOT: u32 = 63;
const UNKNOWN: i64 = (1 << 44) - 1;

#[derive(Debug, Default)]
pub(super) struct Side {
    records: Vec<Record>,
    /// Records before the first node's.
    rim: usize,
    /// The current generation in place, 0 before the first search.
    generation: Record,
    open: Queue,
    generated: u32,
}

const fn cost_of(record: Record) -> i64 {
    (record >> 6) as i64 & UNKNOWN
}

impl Side {
    /// Forgets everything and puts in the root; `origin` is the least f that is worth a bucket of its own.
    pub(super) fn begin<L: Lattice>(&mut self, lattice: &L, root: NodeId, (f, h): (i64, i64), origin: i64) {
        let records = lattice.node_count() + 2 * lattice.rim();
        if self.generation <= GENERATION || self.records.len() < records {
            self.records.clear();
            self.records.resize(records, Record::MAX);
            self.generation = (GENERATIONS - 1) * GENERATION;
        }
        self.rim = lattice.rim();
        self.generation -= GENERATION;
        self.open.reset(origin);
        *self.record_mut(root) = self.generation | OPEN | Record::from(ROOT);
        self.open.push(f, h, root);
        self.generated = 1;
    }

    fn record(&self, node: NodeId) -> Record {
        self.records[node as usize + self.rim]
    }

    fn record_mut(&mut self, node: NodeId) -> &mut Record {
        &mut self.records[node as usize + self.rim]
    }

    /// The node's cost, where this side has reached it.
    #[cfg(feature = "complete")]
    pub(super) fn known(&self, node: NodeId) -> Option<i64> {
        let record = self.record(node);
        let cost = cost_of(record);
        (record < self.generation + GENERATION && cost != UNKNOWN).then_some(cost)
    }

    /// The number of the move that led to the node, which this side must have reached; none at the root.
    pub(super) fn last(&self, node: NodeId) -> Option<u32> {
        let number = (self.record(node) & 63) as u32;
        (number != ROOT).then_some(number)
    }

    pub(super) fn is_closed(&self, node: NodeId) -> bool {
        self.record(node) < self.generation | OPEN
    }

    /// Takes the node out of the search, whether this side has reached it or not.
    pub(super) fn close(&mut self, node: NodeId) {
        let generation = self.generation;
        let record = self.record_mut(node);
        *record = if *record >= generation + GENERATION {
            generation | (UNKNOWN as Record) << 6
        } else {
            *record & !OPEN
        };
    }

    /// The next node that is still open, with its f and h.
    pub(super) fn pop(&mut self) -> Option<(NodeId, i64, i64)> {
        loop {
            let (f, h, node) = self.open.pop()?;
            if !self.is_closed(node) {
                return Some((node, f, h));
            }
        }
    }

    /// The nodes from `node` to the root of this side, `node` first.
    pub(super) fn chain(&self, node: NodeId, step: impl Fn(NodeId, u32) -> NodeId) -> Vec<NodeId> {
        let mut chain = vec![node];
        let mut at = node;
        loop {
            let Some(number) = self.last(at) else { return chain };
            at = step(at, number);
            chain.push(at);
        }
    }
}

/// What happens to a move that improves a node, and what else is to be noted.
pub(super) struct Relaxing<'a, O, N> {
    side: &'a mut Side,
    observer: &'a mut O,
    g: i64,
    /// What a record would be at no cost of a step, whatever the step.
    base: Record,
    from: NodeId,
    note: N,
}

impl<'a, O, N> Relaxing<'a, O, N> {
    pub(super) fn new(side: &'a mut Side, observer: &'a mut O, (from, g): (NodeId, i64), note: N) -> Self {
        let base = side.generation | OPEN | (g as Record) << 6 | 63;
        Self { side, observer, g, base, from, note }
    }
}

impl<O: Observer<i64, ()>, N: FnMut(NodeId, i64)> Sink for Relaxing<'_, O, N> {
    fn worth(&self, target: NodeId, cost: i64) -> bool {
        self.base + ((cost as Record) << 6) < self.side.record(target)
    }

    #[inline(always)]
    fn worth_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32 {
        let (straight, diagonal) =
            (self.base + ((straight as Record) << 6), self.base + ((diagonal as Record) << 6));
        let at = node as usize + self.side.rim;
        let three = |middle: usize| <&[Record; 3]>::try_from(&self.side.records[middle - 1..middle + 2]).unwrap();
        let (south, here, north) = (three(at - row), three(at), three(at + row));
        u32::from(straight < here[2])
            | u32::from(diagonal < north[2]) << 1
            | u32::from(straight < north[1]) << 2
            | u32::from(diagonal < north[0]) << 3
            | u32::from(straight < here[0]) << 4
            | u32::from(diagonal < south[0]) << 5
            | u32::from(straight < south[1]) << 6
            | u32::from(diagonal < south[2]) << 7
    }

    #[inline(always)]
    fn worth_beside(&self, node: NodeId, row: usize, straight: i64) -> u32 {
        let straight = self.base + ((straight as Record) << 6);
        let at = node as usize + self.side.rim;
        let records = &self.side.records;
        u32::from(straight < records[at + 1])
            | u32::from(straight < records[at + row]) << 2
            | u32::from(straight < records[at - 1]) << 4
            | u32::from(straight < records[at - row]) << 6
    }

    fn take(&mut self, number: u32, target: NodeId, cost: i64, h: i64) {
        let g = self.g + cost;
        let side = &mut *self.side;
        let generation = side.generation;
        let record = side.record_mut(target);
        let fresh = *record >= generation + GENERATION;
        *record = generation | OPEN | (g as Record) << 6 | Record::from(number);
        side.generated += u32::from(fresh);
        side.open.push(g + h, h, target);
        self.observer.relaxed(target, self.from, (), g);
        (self.note)(target, g);
    }
}

/// Searches the cheapest path from `start` to `goal`; with an inconsistent estimate, some path.
pub fn one_way<L: Lattice, O: Observer<i64, ()>>(
    lattice: &L,
    (start, goal): (NodeId, NodeId),
    max_expansions: u32,
    memory: &mut Memory,
    observer: &mut O,
) -> Found {
    let side = &mut memory.sides[0];
    let h = lattice.to_goal(start);
    side.begin(lattice, start, (h, h), h);
    let mut found = Found::nothing(start);
    let mut nearest = h;
    while let Some((node, _, h)) = side.pop() {
        if found.expanded >= max_expansions {
            found.end = End::BudgetSpent;
            break;
        }
        let g = cost_of(side.record(node));
        side.close(node);
        found.expanded += 1;
        observer.expanded(node, (), g);
        if h < nearest {
            (nearest, found.closest) = (h, node);
        }
        if node == goal {
            found.end = End::Found;
            found.cost = g;
            found.nodes = side.chain(goal, |at, number| lattice.before(at, number));
            found.nodes.reverse();
            break;
        }
        let last = side.last(node);
        lattice.successors(node, last, &mut Relaxing::new(side, observer, (node, g), |_, _| ()));
    }
    found.count(&memory.sides[..1]);
    found
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
            rejected: 0,
            open_peak: 0,
            closest: start,
        }
    }

    pub(super) fn count(&mut self, sides: &[Side]) {
        for side in sides {
            self.generated += side.generated;
            self.pushes += side.open.pushes();
            self.open_peak += side.open.peak();
        }
    }
}
