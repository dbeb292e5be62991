//! One side of a [`lattice`](super::lattice) search: what it knows of each node, and its open list.

use std::marker::PhantomData;

use super::lattice::{Lattice, Sink};
use super::queue::{Entry, Queue};
use super::{NodeId, Observer};

/// The memory of these searches, reused between them: nothing is cleared, so a query costs what it touches.
#[derive(Debug)]
pub struct Memory<E> {
    pub(super) sides: [Side<E>; 2],
}

impl<E> Default for Memory<E> {
    fn default() -> Self {
        Self { sides: [Side::default(), Side::default()] }
    }
}

/// One node: from the lowest bit, 8 bits of the move that led to it, 44 of its cost, 1 set while it is open, 11 of the
/// generation, which counts down. So whatever is closed, cheaper or blocked is a smaller number than a candidate, and
/// whatever is left from an earlier search a larger one: one comparison tells.
type Record = u64;

const MOVE: u32 = 8;
const OPEN: Record = 1 << 52;
const GENERATION: Record = 1 << 53;
const GENERATIONS: u64 = 1 << 11;
/// The move that leads to the root.
const ROOT: u32 = 255;
const UNKNOWN: i64 = (1 << 44) - 1;

#[derive(Debug)]
pub(super) struct Side<E> {
    records: Vec<Record>,
    /// Where the way to a node came from, where moves do not tell.
    parents: Vec<NodeId>,
    /// Records before the first node's.
    rim: usize,
    /// The current generation in place, 0 before the first search.
    generation: Record,
    pub(super) open: Queue<E>,
    pub(super) generated: u32,
}

impl<E> Default for Side<E> {
    fn default() -> Self {
        let (records, parents, open) = (Vec::new(), Vec::new(), Queue::default());
        Self { records, parents, rim: 0, generation: 0, open, generated: 0 }
    }
}

const fn cost_of(record: Record) -> i64 {
    (record >> MOVE) as i64 & UNKNOWN
}

impl<E: Entry> Side<E> {
    /// Forgets everything and puts in the root; `origin` is the least f that is worth a bucket of its own.
    pub(super) fn begin<L: Lattice>(&mut self, lattice: &L, root: NodeId, (f, h): (i64, i64), origin: i64) {
        let records = lattice.node_count() + 2 * lattice.rim();
        if self.generation <= GENERATION || self.records.len() < records {
            self.records.clear();
            self.records.resize(records, Record::MAX);
            self.generation = (GENERATIONS - 1) * GENERATION;
        }
        if L::JUMPS && self.parents.len() < lattice.node_count() {
            self.parents.resize(lattice.node_count(), 0);
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
        let number = (self.record(node) & Record::from(ROOT)) as u32;
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
            generation | (UNKNOWN as Record) << MOVE
        } else {
            *record & !OPEN
        };
    }

    /// The cost of a node that this side has reached.
    pub(super) fn cost(&self, node: NodeId) -> i64 {
        cost_of(self.record(node))
    }

    /// Whether this side has reached the node or taken it out.
    pub(super) fn is_known(&self, node: NodeId) -> bool {
        self.record(node) < self.generation + GENERATION
    }

    /// The next entry of a node that is still open, or, with `held`, of held-back moves.
    pub(super) fn pop(&mut self, held: bool) -> Option<E> {
        loop {
            let entry = self.open.pop()?;
            if held && entry.is_held() || !self.is_closed(entry.node()) {
                return Some(entry);
            }
        }
    }

    /// The nodes from `node` to the root of this side, `node` first.
    pub(super) fn chain<L: Lattice>(
        &self,
        _: &L,
        node: NodeId,
        step: impl Fn(NodeId, u32) -> NodeId,
    ) -> Vec<NodeId> {
        let mut chain = vec![node];
        let mut at = node;
        loop {
            let Some(number) = self.last(at) else { return chain };
            at = if L::JUMPS { self.parents[at as usize] } else { step(at, number) };
            chain.push(at);
        }
    }
}

/// What happens to a move that improves a node, and what else is to be noted.
pub(super) struct Relaxing<'a, L: Lattice, O, N> {
    lattice: PhantomData<L>,
    side: &'a mut Side<L::Entry>,
    observer: &'a mut O,
    g: i64,
    /// What a record would be at no cost of a step, whatever the step.
    base: Record,
    from: NodeId,
    note: N,
}

impl<'a, L: Lattice, O, N> Relaxing<'a, L, O, N> {
    pub(super) fn new(
        _: &L,
        side: &'a mut Side<L::Entry>,
        observer: &'a mut O,
        (from, g): (NodeId, i64),
        note: N,
    ) -> Self {
        let base = side.generation | OPEN | (g as Record) << MOVE | Record::from(ROOT);
        Self { lattice: PhantomData, side, observer, g, base, from, note }
    }
}

impl<L: Lattice, O: Observer<i64, ()>, N: FnMut(NodeId, i64)> Sink for Relaxing<'_, L, O, N> {
    fn worth(&self, target: NodeId, cost: i64) -> bool {
        self.base + ((cost as Record) << MOVE) < self.side.record(target)
    }

    #[inline]
    fn worth_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32 {
        let (straight, diagonal) =
            (self.base + ((straight as Record) << MOVE), self.base + ((diagonal as Record) << MOVE));
        let at = node as usize + self.side.rim;
        let three =
            |middle: usize| <&[Record; 3]>::try_from(&self.side.records[middle - 1..middle + 2]).unwrap();
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

    #[inline]
    fn worth_beside(&self, node: NodeId, row: usize, straight: i64) -> u32 {
        let straight = self.base + ((straight as Record) << MOVE);
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
        *record = generation | OPEN | (g as Record) << MOVE | Record::from(number);
        side.generated += u32::from(fresh);
        if L::JUMPS {
            side.parents[target as usize] = self.from;
        }
        side.open.push(g + h, h, L::Entry::open(target));
        self.observer.relaxed(target, self.from, (), g);
        (self.note)(target, g);
    }
}
