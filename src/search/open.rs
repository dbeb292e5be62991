//! The open list: a binary heap with an exact total order.

use super::{Cost, NodeId};

/// How entries of equal priority are ordered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Smaller f, then smaller h (deeper), then the most recent push.
    Newest,
    /// Smaller f, then the earliest push.
    Oldest,
}

/// What an open-list entry stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A node to expand.
    Fresh,
    /// A node whose held-back moves are due.
    HeldBack,
    /// A completed path.
    Goal,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Entry<C> {
    pub(super) f: C,
    pub(super) h: C,
    pub(super) g: C,
    pub(super) seq: u32,
    pub(super) node: NodeId,
    pub(super) kind: Kind,
}

impl<C: Cost> Entry<C> {
    fn before(&self, other: &Self, order: Order) -> bool {
        if self.f != other.f {
            return self.f < other.f;
        }
        match order {
            Order::Newest if self.h != other.h => self.h < other.h,
            Order::Newest => self.seq > other.seq,
            Order::Oldest => self.seq < other.seq,
        }
    }
}

/// A 4-ary heap: fewer levels, and the four children of a node are neighbours in memory.
#[derive(Debug, Default)]
pub(super) struct OpenList<C> {
    heap: Vec<Entry<C>>,
    next_seq: u32,
    peak: usize,
}

const ARITY: usize = 4;

impl<C: Cost> OpenList<C> {
    pub(super) fn clear(&mut self) {
        self.heap.clear();
        self.next_seq = 0;
        self.peak = 0;
    }

    /// Largest number of entries held at once.
    pub(super) fn peak(&self) -> usize {
        self.peak
    }

    /// Number of insertions so far.
    pub(super) fn pushes(&self) -> u32 {
        self.next_seq
    }

    pub(super) fn push(&mut self, order: Order, f: C, h: C, g: C, node: NodeId, kind: Kind) {
        let entry = Entry { f, h, g, seq: self.next_seq, node, kind };
        self.next_seq += 1;
        let mut hole = self.heap.len();
        self.heap.push(entry);
        self.peak = self.peak.max(self.heap.len());
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

    pub(super) fn pop(&mut self, order: Order) -> Option<Entry<C>> {
        let last = self.heap.pop()?;
        let Some(&top) = self.heap.first() else { return Some(last) };
        let (mut hole, len) = (0, self.heap.len());
        loop {
            let first = hole * ARITY + 1;
            if first >= len {
                break;
            }
            let mut best = first;
            for child in first + 1..(first + ARITY).min(len) {
                if self.heap[child].before(&self.heap[best], order) {
                    best = child;
                }
            }
            if !self.heap[best].before(&last, order) {
                break;
            }
            self.heap[hole] = self.heap[best];
            hole = best;
        }
        self.heap[hole] = last;
        Some(top)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drain(order: Order, entries: &[(i64, i64)]) -> Vec<u32> {
        let mut open = OpenList::default();
        for &(f, h) in entries {
            open.push(order, f, h, f - h, 0, Kind::Fresh);
        }
        std::iter::from_fn(|| open.pop(order)).map(|e| e.seq).collect()
    }

    #[test]
    fn ties_go_to_smaller_h_then_to_the_newest() {
        assert_eq!(drain(Order::Newest, &[(5, 3), (5, 1), (4, 4), (5, 1), (9, 0)]), [2, 3, 1, 0, 4]);
    }

    #[test]
    fn ties_go_to_the_oldest() {
        assert_eq!(drain(Order::Oldest, &[(5, 3), (5, 1), (4, 4), (5, 1), (9, 0)]), [2, 0, 1, 3, 4]);
    }

    #[test]
    fn a_long_shuffled_list_comes_out_sorted() {
        let mut state = 7_u64;
        let entries: Vec<(i64, i64)> = (0..2000)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                ((state >> 58) as i64, (state >> 40 & 7) as i64)
            })
            .collect();
        let mut expected: Vec<u32> = (0..2000).collect();
        expected.sort_by_key(|&i| (entries[i as usize], std::cmp::Reverse(i)));
        assert_eq!(drain(Order::Newest, &entries), expected);
    }
}
