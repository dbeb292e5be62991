//! Memory of a [`lattice`](super::lattice) search: a record per node, and an open list per side.
//!
//! A record packs cost, move and generation into one 64-bit number. Relaxing a move is then one comparison of two
//! numbers: what is closed or better is smaller than the candidate. Costs are below 2⁴⁴ micro-cells, which is 17
//! million cells of a path; move numbers are at most 254.
//!
//! No parent is stored: a node and the number of the move that reached it give the parent
//! ([`Lattice::before`]). Only jump points, whose moves have no fixed length, keep parents beside the records.
//! A map of 1000 × 1000 cells thus takes 8 MB, and its records are cleared once in about 2000 searches.

use super::bucket_queue::BucketQueue;
use super::entry::Entry;
use super::lattice::{COST, Edge, EdgeSink, Lattice, MOVE, ROOT};
use super::{NodeId, Observer};

/// One node's state in 64 bits.
///
/// ```text
/// 63         53 52 51                                    8 7        0
/// ┌────────────┬──┬───────────────────────────────────────┬──────────┐
/// │ generation │op│ cost g, micro-cells (44 bits)         │ move     │
/// └────────────┴──┴───────────────────────────────────────┴──────────┘
/// ```
///
/// `op` is set while the node is open. Move 255 marks the root. The generation counts down from search to search, so
/// records of former searches are larger than those of the present one: records order as
/// closed < better < candidate < stale, and one comparison decides.
///
/// Example: generation 2046, open, g = 1 414 214 (one diagonal step), move 1 (NE):
/// `2046 << 53 | 1 << 52 | 1_414_214 << 8 | 1`.
pub(super) type Record = u64;

const OPEN: Record = 1 << 52;
const GENERATION: Record = 1 << 53;
const GENERATIONS: u64 = 1 << 11;
/// Memory shared by successive searches. Nothing is cleared in between, so a query costs what it touches.
#[derive(Debug)]
pub struct PackedScratch<E> {
    /// One record per node or, in a two-sided search, two adjacent ones, because reading one needs the other.
    records: Vec<Record>,
    /// Each node's parent, for lattices whose moves do not determine it.
    parents: Vec<NodeId>,
    /// Padding before node 0, in nodes.
    padding: usize,
    /// The current generation in place, 0 before the first search.
    generation: Record,
    pub(super) sides: [Frontier<E>; 2],
}

/// One side of a search: its open list and counter.
#[derive(Debug)]
pub(super) struct Frontier<E> {
    pub(super) open: BucketQueue<E>,
    pub(super) generated: u32,
}

impl<E> Default for PackedScratch<E> {
    fn default() -> Self {
        let side = || Frontier { open: BucketQueue::default(), generated: 0 };
        Self { records: Vec::new(), parents: Vec::new(), padding: 0, generation: 0, sides: [side(), side()] }
    }
}

pub(super) const fn cost_of(record: Record) -> i64 {
    (record >> MOVE) as i64 & COST
}

/// The move that reached a node; `None` at the root.
pub(super) fn move_of(record: Record) -> Option<u32> {
    let number = (record & Record::from(ROOT)) as u32;
    (number != ROOT).then_some(number)
}

/// `SIDES` is the number of sides, one or two. A const generic avoids a branch per node.
impl<E: Entry> PackedScratch<E> {
    /// Starts a new generation, which makes all records stale.
    pub(super) fn begin<L: Lattice, const SIDES: usize>(&mut self, lattice: &L) {
        let records = (lattice.node_count() + 2 * lattice.padding()) * SIDES;
        if self.generation <= GENERATION || self.records.len() < records {
            self.records.clear();
            self.records.resize(records, Record::MAX);
            self.generation = (GENERATIONS - 1) * GENERATION;
        }
        if L::JUMPS && self.parents.len() < lattice.node_count() {
            self.parents.resize(lattice.node_count(), 0);
        }
        self.padding = lattice.padding();
        self.generation -= GENERATION;
    }

    /// Inserts a side's root; `origin` is the f of the first bucket.
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

    /// A node's records, one per side.
    /// They are adjacent: in a search from both ends, reading one brings the other into the cache.
    fn at<const SIDES: usize>(&mut self, node: NodeId) -> &mut [Record; SIDES] {
        &mut self.records.as_chunks_mut().0[node as usize + self.padding]
    }

    fn record<const SIDES: usize>(&self, turn: usize, node: NodeId) -> Record {
        self.records.as_chunks::<SIDES>().0[node as usize + self.padding][turn]
    }

    /// The node's cost if this side has reached it. Not valid for nodes that [`PackedScratch::close_for_both`] removed
    /// from this side's search.
    pub(super) fn known(&self, turn: usize, node: NodeId) -> Option<i64> {
        let record = self.record::<2>(turn, node);
        (record < self.generation + GENERATION).then_some(cost_of(record))
    }

    pub(super) fn is_closed(&self, turn: usize, node: NodeId) -> bool {
        self.record::<2>(turn, node) < self.generation | OPEN
    }

    /// Closes a node; `record` is its record as popped.
    pub(super) fn close<const SIDES: usize>(&mut self, turn: usize, node: NodeId, record: Record) {
        self.at::<SIDES>(node)[turn] = record & !OPEN;
    }

    /// Closes a node on one side and removes it from the other side's search, reached there or not; `record` is its
    /// record as popped.
    pub(super) fn close_for_both(&mut self, turn: usize, node: NodeId, record: Record) {
        let generation = self.generation;
        let both = self.at::<2>(node);
        both[turn] = record & !OPEN;
        let other = &mut both[1 - turn];
        *other = if *other >= generation + GENERATION { generation } else { *other & !OPEN };
    }

    /// True if a one-sided search has reached the node.
    pub(super) fn is_known(&self, node: NodeId) -> bool {
        self.record::<1>(0, node) < self.generation + GENERATION
    }

    /// Pops the next entry whose node is still open, or which stands for deferred moves if `with_deferred`; returns it
    /// with the node's record.
    #[inline]
    pub(super) fn pop<const SIDES: usize>(
        &mut self,
        turn: usize,
        with_deferred: bool,
    ) -> Option<(E, Record)> {
        self.sides[turn].open.measure();
        loop {
            let entry = self.sides[turn].open.pop()?;
            let record = self.record::<SIDES>(turn, entry.node());
            if record >= self.generation | OPEN || with_deferred && entry.is_deferred() {
                return Some((entry, record));
            }
        }
    }

    /// The nodes from `node` back to the side's root, `node` first.
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

/// The [`EdgeSink`] of side `TURN` in a search of `SIDES` sides.
pub(super) struct Relaxing<'a, L: Lattice, O, const SIDES: usize, const TURN: usize> {
    records: &'a mut [[Record; SIDES]],
    parents: &'a mut [NodeId],
    side: &'a mut Frontier<L::Entry>,
    observer: &'a mut O,
    /// Padding before node 0, in nodes.
    padding: usize,
    g: i64,
    /// The record of an open node of cost g, without a move.
    base: Record,
    /// Records from this value on are stale: their nodes have not been reached.
    fresh: Record,
    from: NodeId,
    /// The cheapest connection with the other side so far and its node, if the search asks for it.
    best: Option<&'a mut (i64, NodeId)>,
}

impl<'a, L: Lattice, O, const SIDES: usize, const TURN: usize> Relaxing<'a, L, O, SIDES, TURN> {
    /// The sink for the moves out of one node, given with its record.
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
            padding: memory.padding,
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
        node as usize + self.padding
    }

    /// The record that a step of this cost would write; larger records are improved.
    fn limit(&self, cost: i64) -> Record {
        self.base + Edge::new(ROOT, cost).code
    }
}

/// The candidate of a move is one number: the record that it would write, `base + code`. Where the target's record is
/// larger, the target is stale or reached at a higher cost, and the move improves it. A closed node's record lacks
/// the bit `op` and is therefore smaller than every candidate, so closed nodes need no test of their own.
impl<L: Lattice, O: Observer<i64, ()>, const SIDES: usize, const TURN: usize> EdgeSink
    for Relaxing<'_, L, O, SIDES, TURN>
{
    fn improves(&self, target: NodeId, cost: i64) -> bool {
        self.limit(cost) < self.records[self.place(target)][TURN]
    }

    /// The eight bits without a branch: a record is one number whose order is closed < better < candidate < stale, so
    /// that one comparison decides for each neighbour.
    #[inline]
    fn improves_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32 {
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
    fn improves_beside(&self, node: NodeId, row: usize, straight: i64) -> u32 {
        let straight = self.limit(straight);
        let (at, records) = (self.place(node), &self.records);
        u32::from(straight < records[at + 1][TURN])
            | u32::from(straight < records[at + row][TURN]) << 2
            | u32::from(straight < records[at - 1][TURN]) << 4
            | u32::from(straight < records[at - row][TURN]) << 6
    }

    #[inline(always)]
    fn relax(&mut self, edge: Edge, target: NodeId, h: i64) {
        let g = self.g + edge.cost;
        let known = &mut self.records[target as usize + self.padding];
        let fresh = std::mem::replace(&mut known[TURN], self.base + edge.code) >= self.fresh;
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
