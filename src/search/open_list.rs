//! The open list: an exact total order at nearly the price of a bucket queue.
//!
//! Entries are sorted into buckets of f, coarsely at first, finely once their coarse bucket is due; only the entries of
//! the current fine bucket are in order. Whatever falls into or before it is put among them, so the order is exact for
//! every heuristic, consistent or not. They are a sorted stack, onto which an entry goes that comes before nearly all
//! others, as that of the next cell on a straight way does, and a heap for the rest.
//!
//! Entries are never decreased. A node that is improved gets a second entry, and the older one is recognised by its
//! ticket when it is taken ([`Scratch`](super::Scratch)). So a push is O(1) but for entries of the current bucket,
//! which cost O(log k) for the k entries there; every entry is moved at most twice, into a coarse and into a fine
//! bucket.
//!
//! ```text
//! origin                      current
//!   │ coarse 0 │ coarse 1 … │ 16 fine buckets │ coarse … │ the last one has no end
//!                             └ stack and heap: the only ones in order
//! ```

use super::{Cost, NodeId};

/// How entries of equal priority are ordered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Smaller f, then smaller h (deeper), then the most recent push.
    Newest,
    /// Smaller f, then the earliest push.
    Oldest,
}

/// The kind of an open-list entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum EntryKind {
    /// A node to expand.
    Fresh,
    /// A completed path.
    Goal,
}

/// One entry: the node, its priority, and a ticket that tells whether it is the node's latest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Entry<C> {
    pub(super) f: C,
    pub(super) h: C,
    pub(super) node: NodeId,
    /// Number of the push, counted on from search to search, then two bits of [`EntryKind`]: a later push has a larger
    /// ticket.
    pub(super) ticket: u32,
}

impl<C: Cost> Entry<C> {
    pub(super) fn kind(&self) -> EntryKind {
        match self.ticket & 3 {
            0 => EntryKind::Fresh,
            _ => EntryKind::Goal,
        }
    }

    /// The total order of entries: f first. `Newest` then takes the smaller h and the later push, which dives towards
    /// the goal; `Oldest` the earlier push, which goes round by round. Tickets differ, so no two entries are equal.
    fn before(&self, other: &Self, order: Order) -> bool {
        if self.f != other.f {
            return self.f < other.f;
        }
        match order {
            Order::Newest if self.h != other.h => self.h < other.h,
            Order::Newest => self.ticket > other.ticket,
            Order::Oldest => self.ticket < other.ticket,
        }
    }
}

/// Entries in buckets of f; the current bucket alone is in order.
///
/// Invariants: every entry of `stack` and `heap` lies in the current bucket or before it, every entry of `fine` after
/// it in the same coarse bucket, every entry of `later` in a later coarse bucket. The first entry of the order is
/// therefore the top of the stack or of the heap.
#[derive(Debug)]
pub(super) struct OpenList<C> {
    /// Entries up to the current bucket, as a 4-ary heap: the four children of an entry are neighbours in memory.
    heap: Vec<Entry<C>>,
    /// Entries of the current bucket in order, the first one last.
    stack: Vec<Entry<C>>,
    /// Room for sorting.
    spare: Vec<Entry<C>>,
    /// The entries of the fine buckets of the current coarse one, unsorted.
    fine: [Vec<Entry<C>>; FINE],
    /// The entries of later coarse buckets, unsorted.
    later: Vec<Vec<Entry<C>>>,
    /// The current fine bucket.
    current: usize,
    /// The highest coarse bucket in use.
    highest: usize,
    /// The f from which buckets are counted.
    origin: C,
    len: usize,
    peak: usize,
    /// Of the next entry.
    ticket: u32,
    /// The first one since the last reset.
    first: u32,
}

/// Tickets begin here, so that 0 is none.
pub(super) const FIRST: u32 = TICKET;
/// From one ticket to the next: below are the bits of [`EntryKind`].
const TICKET: u32 = 4;
const ARITY: usize = 4;
/// How deep into the stack an entry may be put.
const DEPTH: usize = 6;
/// Fine buckets in a coarse one.
const FINE: usize = 16;
/// Fine buckets beyond this one share it.
const LAST_BUCKET: usize = FINE * (1 << 16) - 1;
/// Runs of this many entries are sorted by insertion, and then merged.
const RUN: usize = 12;

impl<C: Cost> Default for OpenList<C> {
    fn default() -> Self {
        Self {
            heap: Vec::new(),
            stack: Vec::new(),
            spare: Vec::new(),
            fine: std::array::from_fn(|_| Vec::new()),
            later: Vec::new(),
            current: 0,
            highest: 0,
            origin: C::default(),
            len: 0,
            peak: 0,
            ticket: FIRST,
            first: FIRST,
        }
    }
}

impl<C: Cost> OpenList<C> {
    /// Empties the list; buckets count from `origin`, best the root's f.
    pub(super) fn reset(&mut self, origin: C) {
        self.heap.clear();
        self.stack.clear();
        self.fine.iter_mut().for_each(Vec::clear);
        let used = self.later.len().min(self.highest + 1);
        self.later[..used].iter_mut().skip(self.current / FINE).for_each(Vec::clear);
        (self.current, self.highest, self.len, self.peak) = (0, 0, 0, 0);
        self.first = self.ticket;
        self.origin = origin;
    }

    /// Largest number of entries held at once.
    pub(super) fn peak(&self) -> usize {
        self.peak
    }

    /// Number of insertions so far.
    pub(super) fn pushes(&self) -> u32 {
        (self.ticket - self.first) / TICKET
    }

    /// An empty list whose next entry has this ticket.
    #[cfg(test)]
    pub(super) fn at(ticket: u32) -> Self {
        Self { ticket, first: ticket, ..Self::default() }
    }

    /// The ticket of the next entry: larger than all before.
    pub(super) fn ticket(&self) -> u32 {
        self.ticket
    }

    /// Adds an entry and returns its ticket.
    pub(super) fn push(&mut self, order: Order, f: C, h: C, node: NodeId, kind: EntryKind) -> u32 {
        let ticket = self.ticket | kind as u32;
        let entry = Entry { f, h, node, ticket };
        self.ticket += TICKET;
        self.len += 1;
        self.peak = self.peak.max(self.len);
        let bucket = self.bucket(f);
        let coarse = bucket / FINE;
        if bucket <= self.current {
            self.insert(entry, order);
        } else if coarse == self.current / FINE {
            self.fine[bucket % FINE].push(entry);
        } else {
            if coarse >= self.later.len() {
                self.later.resize_with(coarse + 1, Vec::new);
            }
            self.later[coarse].push(entry);
            self.highest = self.highest.max(coarse);
        }
        ticket
    }

    /// The number of the fine bucket of a priority, counted from the origin.
    fn bucket(&self, f: C) -> usize {
        (f - self.origin).bucket().min(LAST_BUCKET)
    }

    /// Takes the first entry of the order.
    pub(super) fn pop(&mut self, order: Order) -> Option<Entry<C>> {
        if self.len == 0 {
            return None;
        }
        self.len -= 1;
        if self.stack.is_empty() && self.heap.is_empty() {
            self.advance(order);
        }
        if let Some(&first) = self.stack.last()
            && self.heap.first().is_none_or(|other| first.before(other, order))
        {
            self.stack.pop();
            return Some(first);
        }
        let last = self.heap.pop()?;
        let Some(&top) = self.heap.first() else { return Some(last) };
        self.sift_down(0, last, order);
        Some(top)
    }

    /// Number of entries held.
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// The f of the first entry of the order.
    pub(super) fn least(&mut self, order: Order) -> Option<C> {
        if self.len == 0 {
            return None;
        }
        if self.stack.is_empty() && self.heap.is_empty() {
            self.advance(order);
        }
        let firsts = self.stack.last().into_iter().chain(self.heap.first());
        firsts.map(|entry| entry.f).reduce(|a, b| if b < a { b } else { a })
    }

    /// Puts an entry among those of the current bucket.
    #[inline(never)]
    fn insert(&mut self, entry: Entry<C>, order: Order) {
        let near =
            self.stack.iter().rev().take(DEPTH).take_while(|other| other.before(&entry, order)).count();
        if near < DEPTH {
            self.stack.insert(self.stack.len() - near, entry);
        } else {
            self.heap.push(entry);
            self.sift_up(order);
        }
    }

    /// Makes the next fine bucket with entries the current one.
    #[inline(never)]
    fn advance(&mut self, order: Order) {
        loop {
            self.current += 1;
            if self.current.is_multiple_of(FINE) {
                let mut coarse = self.current / FINE;
                while self.later[coarse].is_empty() {
                    coarse += 1;
                }
                self.current = coarse * FINE;
                let mut entries = std::mem::take(&mut self.later[coarse]);
                for entry in entries.drain(..) {
                    let bucket = self.bucket(entry.f);
                    self.fine[bucket % FINE].push(entry);
                }
                self.later[coarse] = entries;
            }
            if !self.fine[self.current % FINE].is_empty() {
                break;
            }
        }
        std::mem::swap(&mut self.stack, &mut self.fine[self.current % FINE]);
        sort(&mut self.stack, &mut self.spare, order);
    }

    /// Moves the last entry of the heap up to its place: O(log n).
    fn sift_up(&mut self, order: Order) {
        let mut hole = self.heap.len() - 1;
        let entry = self.heap[hole];
        while hole > 0 {
            let parent = (hole - 1) / ARITY;
            if !entry.before(&self.heap[parent], order) {
                break;
            }
            self.heap[hole] = self.heap[parent];
            hole = parent;
        }
        self.heap[hole] = entry;
    }

    /// Puts `entry` into the hole or below it.
    fn sift_down(&mut self, mut hole: usize, entry: Entry<C>, order: Order) {
        let heap = self.heap.as_mut_slice();
        loop {
            let first = hole * ARITY + 1;
            if first >= heap.len() {
                break;
            }
            let mut best = first;
            for child in first + 1..(first + ARITY).min(heap.len()) {
                if heap[child].before(&heap[best], order) {
                    best = child;
                }
            }
            if !heap[best].before(&entry, order) {
                break;
            }
            heap[hole] = heap[best];
            hole = best;
        }
        heap[hole] = entry;
    }
}

/// Sorts entries so that the first one of the order comes last. (The standard library's sort is 8 kB of wasm.)
#[inline(never)]
fn sort<C: Cost>(entries: &mut Vec<Entry<C>>, spare: &mut Vec<Entry<C>>, order: Order) {
    for run in entries.chunks_mut(RUN) {
        for sorted in 1..run.len() {
            let entry = run[sorted];
            let mut hole = sorted;
            while hole > 0 && run[hole - 1].before(&entry, order) {
                run[hole] = run[hole - 1];
                hole -= 1;
            }
            run[hole] = entry;
        }
    }
    let mut length = RUN;
    while length < entries.len() {
        spare.clear();
        for pair in entries.chunks(2 * length) {
            let (mut a, mut b) = pair.split_at(length.min(pair.len()));
            while let ([first, rest @ ..], [second, others @ ..]) = (a, b) {
                if first.before(second, order) {
                    spare.push(*second);
                    b = others;
                } else {
                    spare.push(*first);
                    a = rest;
                }
            }
            spare.extend_from_slice(a);
            spare.extend_from_slice(b);
        }
        std::mem::swap(entries, spare);
        length *= 2;
    }
}

#[cfg(test)]
mod tests;
