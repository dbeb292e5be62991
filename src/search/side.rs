//! What a [`lattice`](super::lattice) search remembers: what it knows of each node, and its open lists.

use super::entry::Entry;
use super::lattice::{Lattice, Sink};
use super::queue::Queue;
use super::{NodeId, Observer};

/// One node: from the lowest bit, 8 bits of the move that led to it, 44 of its cost, 1 set while it is open, 11 of the
/// generation, which counts down. So whatever is closed, cheaper or blocked is a smaller number than a candidate, and
/// whatever is left from an earlier search a larger one: one comparison tells.
pub(super) type Record = u64;

const MOVE: u32 = 8;
const OPEN: Record = 1 << 52;
const GENERATION: Record = 1 << 53;
const GENERATIONS: u64 = 1 << 11;
/// The move that leads to the root.
const ROOT: u32 = 255;
const UNKNOWN: i64 = (1 << 44) - 1;

/// The memory of these searches, reused between them: nothing is cleared, so a query costs what it touches.
#[derive(Debug)]
pub struct Memory<E> {
    /// One per node or, where two sides search, two side by side: who looks at one needs the other.
    records: Vec<Record>,
    /// Where the way to a node came from, where moves do not tell.
    parents: Vec<NodeId>,
    /// Nodes before the first one.
    rim: usize,
    /// The current generation in place, 0 before the first search.
    generation: Record,
    pub(super) sides: [Side<E>; 2],
}

/// What each side has of its own.
#[derive(Debug)]
pub(super) struct Side<E> {
    pub(super) open: Queue<E>,
    pub(super) generated: u32,
}

impl<E> Default for Memory<E> {
    fn default() -> Self {
        let side = || Side { open: Queue::default(), generated: 0 };
        Self { records: Vec::new(), parents: Vec::new(), rim: 0, generation: 0, sides: [side(), side()] }
    }
}

pub(super) const fn cost_of(record: Record) -> i64 {
    (record >> MOVE) as i64 & UNKNOWN
}

/// The number of the move that led to a node that was reached; none at the root.
pub(super) fn move_of(record: Record) -> Option<u32> {
    let number = (record & Record::from(ROOT)) as u32;
    (number != ROOT).then_some(number)
}

/// `SIDES` is how many search: one or two.
impl<E: Entry> Memory<E> {
    /// Forgets everything.
    pub(super) fn begin<L: Lattice, const SIDES: usize>(&mut self, lattice: &L) {
        let records = (lattice.node_count() + 2 * lattice.rim()) * SIDES;
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
    }

    /// Puts in a side's root; `origin` is the least f that is worth a bucket of its own.
    pub(super) fn root<const SIDES: usize>(
        &mut self,
        turn: usize,
        root: NodeId,
        (f, h): (i64, i64),
        origin: i64,
    ) {
        let at = self.place::<SIDES>(turn, root);
        self.records[at] = self.generation | OPEN | Record::from(ROOT);
        let side = &mut self.sides[turn];
        side.open.reset(origin);
        side.open.push(f, h, root);
        side.generated = 1;
    }

    fn place<const SIDES: usize>(&self, turn: usize, node: NodeId) -> usize {
        (node as usize + self.rim) * SIDES + turn
    }

    fn record<const SIDES: usize>(&self, turn: usize, node: NodeId) -> Record {
        self.records[self.place::<SIDES>(turn, node)]
    }

    /// The node's cost, where this side has reached it.
    #[cfg(feature = "complete")]
    pub(super) fn known(&self, turn: usize, node: NodeId) -> Option<i64> {
        let record = self.record::<2>(turn, node);
        let cost = cost_of(record);
        (record < self.generation + GENERATION && cost != UNKNOWN).then_some(cost)
    }

    #[cfg(feature = "complete")]
    pub(super) fn is_closed(&self, turn: usize, node: NodeId) -> bool {
        self.record::<2>(turn, node) < self.generation | OPEN
    }

    /// Closes a node with its record, as it was popped.
    pub(super) fn close<const SIDES: usize>(&mut self, turn: usize, node: NodeId, record: Record) {
        let at = self.place::<SIDES>(turn, node);
        self.records[at] = record & !OPEN;
    }

    /// Closes a node of one of two sides with its record, as it was popped, and takes it out of the other side's search,
    /// whether that one has reached it or not.
    #[cfg(feature = "complete")]
    pub(super) fn settle(&mut self, turn: usize, node: NodeId, record: Record) {
        let at = self.place::<2>(0, node);
        let both = &mut self.records[at..at + 2];
        both[turn] = record & !OPEN;
        let other = &mut both[1 - turn];
        *other = if *other >= self.generation + GENERATION {
            self.generation | (UNKNOWN as Record) << MOVE
        } else {
            *other & !OPEN
        };
    }

    /// Whether the only side has reached the node.
    pub(super) fn is_known(&self, node: NodeId) -> bool {
        self.record::<1>(0, node) < self.generation + GENERATION
    }

    /// The next entry of a node that is still open, or, with `held`, of held-back moves; with the node's record.
    pub(super) fn pop<const SIDES: usize>(&mut self, turn: usize, held: bool) -> Option<(E, Record)> {
        loop {
            let entry = self.sides[turn].open.pop()?;
            let record = self.record::<SIDES>(turn, entry.node());
            if record >= self.generation | OPEN || held && entry.is_held() {
                return Some((entry, record));
            }
        }
    }

    /// The nodes from `node` to the root of a side, `node` first.
    pub(super) fn chain<L: Lattice, const SIDES: usize>(
        &self,
        _: &L,
        turn: usize,
        node: NodeId,
        step: impl Fn(NodeId, u32) -> NodeId,
    ) -> Vec<NodeId> {
        let mut chain = vec![node];
        let mut at = node;
        while let Some(number) = move_of(self.record::<SIDES>(turn, at)) {
            at = if L::JUMPS { self.parents[at as usize] } else { step(at, number) };
            chain.push(at);
        }
        chain
    }
}

/// What happens to a move that improves a node.
pub(super) struct Relaxing<'a, L: Lattice, O, const SIDES: usize> {
    records: &'a mut [Record],
    parents: &'a mut [NodeId],
    side: &'a mut Side<L::Entry>,
    observer: &'a mut O,
    /// Where this side's record of node 0 is.
    first: usize,
    g: i64,
    /// What a record would be at no cost of a step, whatever the step.
    base: Record,
    /// Nodes whose records are not below it have not been reached.
    fresh: Record,
    from: NodeId,
    /// The cheapest connection with the other side so far and the node that it leads through, where it is wanted.
    best: Option<&'a mut (i64, NodeId)>,
}

impl<'a, L: Lattice, O, const SIDES: usize> Relaxing<'a, L, O, SIDES> {
    pub(super) fn new(
        _: &L,
        (memory, turn): (&'a mut Memory<L::Entry>, usize),
        observer: &'a mut O,
        (from, g): (NodeId, i64),
        best: Option<&'a mut (i64, NodeId)>,
    ) -> Self {
        Self {
            base: memory.generation | OPEN | (g as Record) << MOVE | Record::from(ROOT),
            fresh: memory.generation + GENERATION,
            first: memory.place::<SIDES>(turn, 0),
            records: &mut memory.records,
            parents: &mut memory.parents,
            side: &mut memory.sides[turn],
            observer,
            g,
            from,
            best,
        }
    }

    fn place(&self, node: NodeId) -> usize {
        self.first + node as usize * SIDES
    }

    /// What the record of a node reached by a step of this cost must exceed to be worth it.
    fn limit(&self, cost: i64) -> Record {
        self.base + ((cost as Record) << MOVE)
    }
}

impl<L: Lattice, O: Observer<i64, ()>, const SIDES: usize> Sink for Relaxing<'_, L, O, SIDES> {
    fn worth(&self, target: NodeId, cost: i64) -> bool {
        self.limit(cost) < self.records[self.place(target)]
    }

    #[inline]
    fn worth_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32 {
        let (straight, diagonal) = (self.limit(straight), self.limit(diagonal));
        let (at, row) = (self.place(node), row * SIDES);
        let three = |middle: usize| {
            let line = &self.records[middle - SIDES..][..=2 * SIDES];
            [line[0], line[SIDES], line[2 * SIDES]]
        };
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
        let straight = self.limit(straight);
        let (at, row) = (self.place(node), row * SIDES);
        let records = &self.records;
        u32::from(straight < records[at + SIDES])
            | u32::from(straight < records[at + row]) << 2
            | u32::from(straight < records[at - SIDES]) << 4
            | u32::from(straight < records[at - row]) << 6
    }

    #[inline(always)]
    fn take(&mut self, number: u32, target: NodeId, cost: i64, h: i64) {
        let g = self.g + cost;
        let at = self.place(target);
        let record = self.limit(cost) - Record::from(ROOT - number);
        let fresh = std::mem::replace(&mut self.records[at], record) >= self.fresh;
        if L::JUMPS {
            self.parents[target as usize] = self.from;
        }
        self.side.generated += u32::from(fresh);
        self.side.open.push(g + h, h, L::Entry::open(target));
        self.observer.relaxed(target, self.from, (), g);
        if SIDES == 2
            && let Some(best) = &mut self.best
        {
            let other = self.records[at ^ 1];
            let there = g + cost_of(other);
            if other < self.fresh && there < best.0 && cost_of(other) != UNKNOWN {
                **best = (there, target);
            }
        }
    }
}
