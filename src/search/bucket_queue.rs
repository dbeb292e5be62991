//! The open list of [`lattice`](super::lattice) searches: smaller f first, then smaller h, then the newest.
//!
//! Costs are whole numbers there, so that most entries share their f with many others. Entries lie unsorted in buckets
//! of f, as in [`OpenList`](super::open_list::OpenList), but near ones at once in a bucket of their own, which is
//! [sorted](super::bucket_sort) when its turn comes. Recency is positional, so every operation on a bucket is
//! stable.
//!
//! ```text
//! stack   the current bucket, in order
//! ring    2048 buckets: the rest of this span and the next one, unsorted; a bit map finds the next that holds entries
//! later   one list per span of 1024 buckets, spread into the ring when the ring reaches it
//! ```
//!
//! A bucket is 2^[`WIDTH`](Entry::WIDTH) micro-cells wide. A push is O(1); taking an entry is O(1) and its share of
//! sorting one bucket. With consistent estimates f never falls, so buckets are only left forwards; an inconsistent
//! estimate may push before the current bucket, which is then put back (`go_back`): rare, but exact.

use super::bucket_sort::Sorter;
use super::entry::Entry;

/// The open list of one side of a lattice search.
///
/// Memory: 2048 list heads of the ring, and the entries. Lists that become empty are kept with their room and used
/// again, so a search of a map that was searched before hardly allocates.
#[derive(Debug)]
pub(super) struct BucketQueue<E> {
    /// The entries of the current bucket in order, the first one last.
    stack: Vec<E>,
    /// Unsorted entries of the buckets after the current one, up to the end of the next span; bucket `n` is at
    /// `n % RING`. A list without entries has no room for one: what says that one fits says that the bucket is in use.
    ring: Box<[Vec<E>; RING]>,
    /// A bit for each list of the ring that holds something.
    filled: [u64; WORDS],
    /// Unsorted entries of later spans, the last one without an end.
    later: Vec<Vec<E>>,
    /// Empty lists with room, the last used one last.
    empty: Vec<Vec<E>>,
    sorter: Sorter<E>,
    /// The current bucket, counted from `origin`.
    current: usize,
    /// The buckets before this one have their place in the ring.
    reach: usize,
    /// The f from which buckets are counted.
    origin: i64,
    peak: u32,
    pushes: u32,
    pops: u32,
}

/// Buckets in a span: more than a step of eight neighbours adds to f.
const SPAN: usize = 1024;
const RING: usize = 2 * SPAN;
const WORDS: usize = RING / 64;
/// Number of spans.
const SPANS: usize = 1024;
/// How deep in the stack the place of an entry is looked for step by step.
const NEAR: usize = 6;

impl<E> Default for BucketQueue<E> {
    fn default() -> Self {
        Self {
            stack: Vec::new(),
            ring: empty_ring(),
            filled: [0; WORDS],
            later: Vec::new(),
            empty: Vec::new(),
            sorter: Sorter::default(),
            current: 0,
            reach: 0,
            origin: 0,
            peak: 0,
            pushes: 0,
            pops: 0,
        }
    }
}

fn empty_ring<E>() -> Box<[Vec<E>; RING]> {
    let lists: Box<[Vec<E>]> = std::iter::repeat_with(Vec::new).take(RING).collect();
    lists.try_into().unwrap_or_else(|_| unreachable!("as many as asked for"))
}

impl<E: Entry> BucketQueue<E> {
    /// Empties the list; buckets count from `origin`, best the root's f.
    pub(super) fn reset(&mut self, origin: i64) {
        self.stack.clear();
        while let Some(bucket) = self.next_filled() {
            let mut list = self.take(bucket);
            list.clear();
            self.empty.push(list);
        }
        self.later.iter_mut().for_each(Vec::clear);
        (self.current, self.reach, self.origin) = (0, RING, origin);
        (self.peak, self.pushes, self.pops) = (0, 0, 0);
    }

    /// Largest number of entries held at once.
    pub(super) fn peak(&self) -> u32 {
        self.peak.max(self.pushes - self.pops)
    }

    /// Number of insertions so far.
    pub(super) fn pushes(&self) -> u32 {
        self.pushes
    }

    /// Adds an entry.
    #[inline(always)]
    pub(super) fn push(&mut self, f: i64, h: i64, node: u32) {
        self.pushes += 1;
        let entry = E::new(f, h, node);
        // Most go where others are already or, with many ties, before all; these ways are kept short. The ring holds
        // nothing of the current bucket.
        let bucket = ((f - self.origin) >> E::WIDTH) as u64;
        let further = bucket.wrapping_sub(self.current as u64);
        if E::TIES && further == 0 {
            if self.stack.last().is_none_or(|&first| entry.before(first)) {
                return self.stack.push(entry);
            }
        } else if further < (self.reach - self.current) as u64 {
            let list = &mut self.ring[bucket as usize % RING];
            if list.len() < list.capacity() {
                return list.push(entry);
            }
        }
        self.place(entry);
    }

    /// Adds an entry for which the short ways of `push` do not suffice.
    #[inline(never)]
    fn place(&mut self, entry: E) {
        let bucket = self.bucket(entry.f());
        if bucket == self.current && self.stack.last().is_none_or(|&first| entry.before(first)) {
            self.stack.push(entry);
        } else {
            self.place_further(entry, bucket);
        }
    }

    #[inline(never)]
    fn place_further(&mut self, entry: E, bucket: usize) {
        if bucket > self.current {
            self.put(entry, bucket);
        } else {
            if bucket < self.current {
                self.go_back(bucket);
            }
            self.insert(entry);
        }
    }

    /// Makes an empty bucket before the current one the current one.
    fn go_back(&mut self, bucket: usize) {
        if !self.stack.is_empty() {
            let slot = self.current % RING;
            let room = self.empty.pop().unwrap_or_default();
            self.ring[slot] = std::mem::replace(&mut self.stack, room);
            self.filled[slot / 64] |= 1 << (slot % 64);
        }
        self.current = bucket;
        let (reach, last) = ((bucket / SPAN + 2).min(SPANS), self.reach / SPAN);
        for span in reach.max(last - RING / SPAN)..last {
            self.send(span);
        }
        self.reach = reach * SPAN;
    }

    /// Takes the entries of a span out of the ring.
    fn send(&mut self, span: usize) {
        if span >= self.later.len() {
            self.later.resize_with(span + 1, Vec::new);
        }
        let first = span * SPAN % RING / 64;
        for word in first..first + SPAN / 64 {
            while self.filled[word] != 0 {
                let mut list = self.take(64 * word + self.filled[word].trailing_zeros() as usize);
                self.later[span].append(&mut list);
                self.empty.push(list);
            }
        }
    }

    /// The bucket of a priority. What lies before the first bucket counts to it, and all that lies beyond the last
    /// span shares one bucket, which is divided anew from its own least f when its turn comes.
    fn bucket(&self, f: i64) -> usize {
        ((f - self.origin).max(0) >> E::WIDTH).min((SPANS * SPAN) as i64) as usize
    }

    /// Adds an entry to a bucket after the current one, and marks the bucket as filled.
    fn put(&mut self, entry: E, bucket: usize) {
        if bucket < self.reach {
            let list = &mut self.ring[bucket % RING];
            if list.is_empty() {
                self.filled[bucket % RING / 64] |= 1 << (bucket % 64);
                *list = self.empty.pop().unwrap_or_default();
            }
            list.push(entry);
        } else {
            self.put_later(entry, bucket);
        }
    }

    #[cold]
    fn put_later(&mut self, entry: E, bucket: usize) {
        let span = (bucket / SPAN).min(SPANS);
        if span >= self.later.len() {
            self.later.resize_with(span + 1, Vec::new);
        }
        self.later[span].push(entry);
    }

    /// Notes how many entries there are: to be called between pushes and the next pop.
    #[inline]
    pub(super) fn measure(&mut self) {
        self.peak = self.peak();
    }

    /// Takes the first entry of the order.
    #[inline]
    pub(super) fn pop(&mut self) -> Option<E> {
        if self.stack.is_empty() {
            self.advance();
        }
        let entry = self.stack.pop()?;
        self.pops += 1;
        Some(entry)
    }

    /// Puts an entry among those of the current bucket.
    fn insert(&mut self, entry: E) {
        let near = self.stack.iter().rev().take(NEAR).take_while(|&&other| !entry.before(other)).count();
        let place = if near < NEAR {
            self.stack.len() - near
        } else {
            self.stack.partition_point(|&other| entry.before(other))
        };
        self.stack.insert(place, entry);
    }

    /// The bucket of the first list of the ring that holds something.
    fn next_filled(&self) -> Option<usize> {
        let start = self.current / 64;
        let shift = self.current % 64;
        let first = self.filled[start % WORDS] >> shift;
        if first != 0 {
            return Some(self.current + first.trailing_zeros() as usize);
        }
        (start + 1..=start + WORDS).find_map(|word| {
            let bits = self.filled[word % WORDS];
            (bits != 0).then(|| word * 64 + bits.trailing_zeros() as usize)
        })
    }

    /// Makes the next bucket with entries the current one, if there is one.
    #[inline(never)]
    fn advance(&mut self) {
        loop {
            let span = self.current / SPAN;
            if let Some(bucket) = self.next_filled() {
                if bucket / SPAN > span {
                    self.current = bucket / SPAN * SPAN;
                    self.bring(span + 2);
                }
                self.current = bucket;
                break;
            }
            let Some(next) = self.later.iter().position(|list| !list.is_empty()) else { return };
            if next == SPANS {
                self.origin = self.later[next].iter().map(|entry| entry.f()).min().unwrap_or_default();
                self.current = 0;
            } else {
                self.current = next * SPAN - 1;
            }
            self.bring(next);
        }
        let next = self.take(self.current);
        self.empty.push(std::mem::replace(&mut self.stack, next));
        self.sorter.sort(&mut self.stack);
    }

    /// Takes a bucket's list out of the ring.
    fn take(&mut self, bucket: usize) -> Vec<E> {
        let slot = bucket % RING;
        self.filled[slot / 64] &= !(1 << (slot % 64));
        std::mem::take(&mut self.ring[slot])
    }

    /// Puts the entries of a span that has come near into the ring.
    fn bring(&mut self, span: usize) {
        self.reach = (self.current / SPAN + 2).min(SPANS) * SPAN;
        let Some(list) = self.later.get_mut(span) else { return };
        let mut entries = std::mem::take(list);
        for entry in entries.drain(..) {
            self.put(entry, self.bucket(entry.f()));
        }
        // What is still too far away has made a new list.
        if self.later[span].is_empty() {
            self.later[span] = entries;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::{PackedEntry, WideEntry};

    fn random(state: &mut u64, n: u64) -> u64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (*state >> 33) % n
    }

    #[test]
    fn equal_entries_come_out_newest_first() {
        let mut queue = BucketQueue::<PackedEntry>::default();
        queue.reset(0);
        for node in 0..100 {
            queue.push(1_000_000, i64::from(node % 3), node);
        }
        queue.measure();
        let order: Vec<_> = std::iter::from_fn(|| queue.pop()).map(|e| (e.h(), e.mark())).collect();
        let mut sorted = order.clone();
        sorted.sort_by_key(|&(h, node)| (h, std::cmp::Reverse(node)));
        assert_eq!(order, sorted);
        assert_eq!(queue.peak(), 100);
    }

    /// Pushes and pops mixed: priorities in and across buckets and spans, before the origin, beyond the last span; in
    /// every second round many entries share few values of f, in some of them nothing is before what was popped.
    #[test]
    fn the_order_is_exact_whatever_is_pushed() {
        exact::<PackedEntry>();
        exact::<WideEntry>();
    }

    fn exact<E: Entry>() {
        let mut state = 7;
        let mut queue = BucketQueue::<E>::default();
        for round in 0..60 {
            queue.reset(1_000_000);
            let mut held: Vec<(i64, i64, u32)> = Vec::new();
            let (steps, mut number, mut last) = ([3000, 300][round % 2], 0, 1_000_000);
            for step in 0..steps {
                if random(&mut state, 5) < if step < steps / 2 { 4 } else { 2 } {
                    let f = match (random(&mut state, 50), round % 4) {
                        (0, _) => (1 << 45) + random(&mut state, 4) as i64,
                        (1, 0) => 5,
                        // The same place in the ring, later.
                        (1..3, _) => last + (1 + random(&mut state, 3) as i64) * ((RING as i64) << E::WIDTH),
                        (_, 0) => random(&mut state, 40) as i64 * 100_003,
                        (_, 1) => random(&mut state, 40) as i64 * 10_000_019,
                        (_, 2) => last + random(&mut state, 5) as i64 * 1_414_214,
                        _ => last + random(&mut state, 3000) as i64,
                    };
                    let h = random(&mut state, [8, 1 << 34][round / 4 % 2]) as i64;
                    queue.push(f, h, number);
                    held.push((f, h, number));
                    number += 1;
                } else {
                    let first =
                        held.iter().enumerate().min_by_key(|(_, e)| (e.0, e.1, std::cmp::Reverse(e.2)));
                    let want = first.map(|(i, _)| i).map(|i| held.swap_remove(i));
                    let got = queue.pop().map(|e| (e.f(), e.h(), e.mark()));
                    assert_eq!(got, want, "round {round} step {step}");
                    last = got.map_or(last, |(f, ..)| f);
                }
            }
        }
    }
}
