//! What a [`lattice`](super::lattice) search remembers: what it knows of each node, and its open lists.

use super::bucket_queue::BucketQueue;
use super::entry::Entry;
use super::lattice::{Edge, EdgeSink, Lattice};
use super::{NodeId, Observer};

/// One node: from the lowest bit, 8 bits of the move that led to it, 44 of its cost, 1 set while it is open, 11 of the
/// generation, which counts down. Records order as closed < better < candidate < stale, so
/// one comparison decides.
pub(super) type Record = u64;

pub(super) const MOVE: u32 = 8;
const OPEN: Record = 1 << 52;
const GENERATION: Record = 1 << 53;
const GENERATIONS: u64 = 1 << 11;
/// The move that leads to the root.
const ROOT: u32 = 255;
const COST: i64 = (1 << 44) - 1;

/// The memory of these searches, reused between them: nothing is cleared, so a query costs what it touches.
#[derive(Debug)]
pub struct PackedScratch<E> {
    /// One per node or, where two sides search, two side by side: who looks at one needs the other.
    records: Vec<Record>,
    /// Where the way to a node came from, where moves do not tell.
    parents: Vec<NodeId>,
    /// Nodes before the first one.
    rim: usize,
    /// The current generation in place, 0 before the first search.
    generation: Record,
    pub(super) sides: [Frontier<E>; 2],
}

/// What each side has of its own.
#[derive(Debug)]
pub(super) struct Frontier<E> {
    pub(super) open: BucketQueue<E>,
    pub(super) generated: u32,
}

impl<E> Default for PackedScratch<E> {
    fn default() -> Self {
        let side = || Frontier { open: BucketQueue::default(), generated: 0 };
        Self { records: Vec::new(), parents: Vec::new(), rim: 0, generation: 0, sides: [side(), side()] }
    }
}

pub(super) const fn cost_of(record: Record) -> i64 {
    (record >> MOVE) as i64 & COST
}

/// The number of the move that led to a node that was reached; none at the root.
pub(super) fn move_of(record: Record) -> Option<u32> {
    let number = (record & Record::from(ROOT)) as u32;
    (number != ROOT).then_some(number)
}

/// `SIDES` is how many search: one or two.
impl<E: Entry> PackedScratch<E> {
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
        self.at::<SIDES>(root)[turn] = self.generation | OPEN | Record::from(ROOT);
        let side = &mut self.sides[turn];
        side.open.reset(origin);
        side.open.push(f, h, root);
        side.generated = 1;
    }

    /// What is known of a node, by side.
    fn at<const SIDES: usize>(&mut self, node: NodeId) -> &mut [Record; SIDES] {
        &mut self.records.as_chunks_mut().0[node as usize + self.rim]
    }

    fn record<const SIDES: usize>(&self, turn: usize, node: NodeId) -> Record {
        self.records.as_chunks::<SIDES>().0[node as usize + self.rim][turn]
    }

    /// The node's cost, where this side has reached it; not for nodes that [`PackedScratch::settle`] took out of its search.
    #[cfg(feature = "complete")]
    pub(super) fn known(&self, turn: usize, node: NodeId) -> Option<i64> {
        let record = self.record::<2>(turn, node);
        (record < self.generation + GENERATION).then_some(cost_of(record))
    }

    #[cfg(feature = "complete")]
    pub(super) fn is_closed(&self, turn: usize, node: NodeId) -> bool {
        self.record::<2>(turn, node) < self.generation | OPEN
    }

    /// Closes a node with its record, as it was popped.
    pub(super) fn close<const SIDES: usize>(&mut self, turn: usize, node: NodeId, record: Record) {
        self.at::<SIDES>(node)[turn] = record & !OPEN;
    }

    /// Closes a node of one of two sides with its record, as it was popped, and takes it out of the other side's search,
    /// whether that one has reached it or not.
    #[cfg(feature = "complete")]
    pub(super) fn settle(&mut self, turn: usize, node: NodeId, record: Record) {
        let generation = self.generation;
        let both = self.at::<2>(node);
        both[turn] = record & !OPEN;
        let other = &mut both[1 - turn];
        *other = if *other >= generation + GENERATION { generation } else { *other & !OPEN };
    }

    /// Whether the only side has reached the node.
    pub(super) fn is_known(&self, node: NodeId) -> bool {
        self.record::<1>(0, node) < self.generation + GENERATION
    }

    /// The next entry of a node that is still open, or, with `held`, of held-back moves; with the node's record.
    #[inline]
    pub(super) fn pop<const SIDES: usize>(&mut self, turn: usize, held: bool) -> Option<(E, Record)> {
        self.sides[turn].open.measure();
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

/// What happens to a move that improves a node, in the search of one of one or two sides.
pub(super) struct Relaxing<'a, L: Lattice, O, const SIDES: usize, const TURN: usize> {
    records: &'a mut [[Record; SIDES]],
    parents: &'a mut [NodeId],
    side: &'a mut Frontier<L::Entry>,
    observer: &'a mut O,
    /// Nodes before the first one.
    rim: usize,
    g: i64,
    /// What the record of an open node of this cost is before a move is added.
    base: Record,
    /// Nodes whose records are not below it have not been reached.
    fresh: Record,
    from: NodeId,
    /// The cheapest connection with the other side so far and the node that it leads through, where it is wanted.
    best: Option<&'a mut (i64, NodeId)>,
}

impl<'a, L: Lattice, O, const SIDES: usize, const TURN: usize> Relaxing<'a, L, O, SIDES, TURN> {
    /// The moves out of a node, with its record.
    pub(super) fn new(
        _: &L,
        memory: &'a mut PackedScratch<L::Entry>,
        observer: &'a mut O,
        (from, record): (NodeId, Record),
        best: Option<&'a mut (i64, NodeId)>,
    ) -> Self {
        let g = cost_of(record);
        Self {
            base: record & !Record::from(ROOT) | OPEN,
            fresh: memory.generation + GENERATION,
            rim: memory.rim,
            records: memory.records.as_chunks_mut().0,
            parents: &mut memory.parents,
            side: &mut memory.sides[TURN],
            observer,
            g,
            from,
            best,
        }
    }

    fn place(&self, node: NodeId) -> usize {
        node as usize + self.rim
    }

    /// What the record of a node reached by a step of this cost must exceed to be worth it.
    fn limit(&self, cost: i64) -> Record {
        self.base + Edge::new(ROOT, cost).code
    }
}

impl<L: Lattice, O: Observer<i64, ()>, const SIDES: usize, const TURN: usize> EdgeSink
    for Relaxing<'_, L, O, SIDES, TURN>
{
    fn worth(&self, target: NodeId, cost: i64) -> bool {
        self.limit(cost) < self.records[self.place(target)][TURN]
    }

    #[inline]
    fn worth_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32 {
        let (straight, diagonal) = (self.limit(straight), self.limit(diagonal));
        let at = self.place(node);
        let three = |middle: usize| {
            let line = &self.records[middle - 1..][..3];
            [line[0][TURN], line[1][TURN], line[2][TURN]]
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
        let (at, records) = (self.place(node), &self.records);
        u32::from(straight < records[at + 1][TURN])
            | u32::from(straight < records[at + row][TURN]) << 2
            | u32::from(straight < records[at - 1][TURN]) << 4
            | u32::from(straight < records[at - row][TURN]) << 6
    }

    #[inline(always)]
    fn take(&mut self, leg: Edge, target: NodeId, h: i64) {
        let g = self.g + leg.cost;
        let known = &mut self.records[target as usize + self.rim];
        let fresh = std::mem::replace(&mut known[TURN], self.base + leg.code) >= self.fresh;
        if SIDES == 2
            && let Some(best) = &mut self.best
        {
            let other = known[SIDES - 1 - TURN];
            let there = g + cost_of(other);
            if other < self.fresh && there < best.0 {
                **best = (there, target);
            }
        }
        if L::JUMPS {
            self.parents[target as usize] = self.from;
        }
        self.side.generated += u32::from(fresh);
        self.side.open.push(g + h, h, L::Entry::open(target));
        self.observer.relaxed(target, self.from, (), g);
    }
}
