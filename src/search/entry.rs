//! Entries of the [open list](super::bucket_queue) of lattice searches.
//!
//! An entry holds f, h, the node and whether it stands for the node's deferred moves. The packed form takes 16
//! bytes, its order is that of its upper 96 bits, and f and h are from 0 to below 2⁴⁸. The wide form has no such
//! limit; lattices whose priorities may be negative need it. Nodes are below 2²⁸ in both.

use super::NodeId;

/// An entry of the open list: a node's f and h, and whether it stands for the node's deferred moves.
/// Entries of equal f and h are ordered by position in the open list, so no entry stores its age.
pub trait Entry: Copy {
    /// A bucket of the open list is 2 to this power wide.
    const WIDTH: u32;
    /// True if many entries share their f, so that a new one often precedes all others.
    const TIES: bool;

    /// The entry.
    fn new(f: i64, h: i64, node: u32) -> Self;
    /// The priority.
    fn f(self) -> i64;
    /// The estimate in it.
    fn h(self) -> i64;
    /// The mark that [`Entry::open`] or [`Entry::deferred`] made.
    fn mark(self) -> u32;
    /// True if it precedes an older entry. Recency is positional, so every operation is stable.
    fn before(self, older: Self) -> bool;
    /// True if [`Entry::rank`] alone decides which of the two comes first: f is equal and h nearly so.
    fn is_like(self, other: Self) -> bool;
    /// The lower 32 bits of h: the order among entries that are alike.
    fn rank(self) -> u32;

    /// The mark of an open node; nodes are below 2²⁸.
    fn open(node: NodeId) -> u32 {
        debug_assert!(node < 1 << PAYLOAD);
        node
    }
    /// The mark of a node's deferred moves, with a payload from 0 to 7.
    fn deferred(node: NodeId, payload: u32) -> u32 {
        debug_assert!(node < 1 << PAYLOAD && payload < 8);
        node | payload << PAYLOAD | DEFERRED
    }
    /// The node.
    fn node(self) -> NodeId {
        self.mark() & ((1 << PAYLOAD) - 1)
    }
    /// The payload stored with a node's deferred moves.
    fn payload(self) -> u32 {
        (self.mark() & !DEFERRED) >> PAYLOAD
    }
    /// True if the entry stands for the node's deferred moves.
    fn is_deferred(self) -> bool {
        self.mark() & DEFERRED != 0
    }
}

const DEFERRED: u32 = 1 << 31;
const PAYLOAD: u32 = 28;

/// An entry in 16 bytes; f and h must be from 0 to below 2⁴⁸.
///
/// ```text
/// 127              80 79               32 31 30     28 27          0
/// ┌──────────────────┬───────────────────┬──┬─────────┬─────────────┐
/// │ f (48 bits)      │ h (48 bits)       │df│ payload │ node        │
/// └──────────────────┴───────────────────┴──┴─────────┴─────────────┘
/// ```
///
/// `df` is set for deferred moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PackedEntry {
    high: u64,
    low: u64,
}

impl Entry for PackedEntry {
    const WIDTH: u32 = 12;
    const TIES: bool = true;

    fn new(f: i64, h: i64, node: u32) -> Self {
        debug_assert!((0..1 << 48).contains(&f) && (0..1 << 48).contains(&h));
        let (f, h) = (f as u64, h as u64);
        Self { high: f << 16 | h >> 32, low: h << 32 | u64::from(node) }
    }

    fn f(self) -> i64 {
        (self.high >> 16) as i64
    }

    fn h(self) -> i64 {
        ((self.high & 0xffff) << 32 | self.low >> 32) as i64
    }

    fn mark(self) -> u32 {
        self.low as u32
    }

    fn before(self, older: Self) -> bool {
        // As one number of 128 bits this would be shorter natively and slower in wasm.
        self.high < older.high || self.high == older.high && self.low >> 32 <= older.low >> 32
    }

    fn is_like(self, other: Self) -> bool {
        self.high == other.high
    }

    fn rank(self) -> u32 {
        (self.low >> 32) as u32
    }
}

/// An entry of any costs, for searches whose f spreads widely.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WideEntry {
    f: i64,
    h: i64,
    node: u32,
}

impl Entry for WideEntry {
    const WIDTH: u32 = 18;
    const TIES: bool = false;

    fn new(f: i64, h: i64, node: u32) -> Self {
        Self { f, h, node }
    }

    fn f(self) -> i64 {
        self.f
    }

    fn h(self) -> i64 {
        self.h
    }

    fn mark(self) -> u32 {
        self.node
    }

    fn before(self, older: Self) -> bool {
        self.f < older.f || self.f == older.f && self.h <= older.h
    }

    fn is_like(self, other: Self) -> bool {
        self.f == other.f && self.h >> 32 == other.h >> 32
    }

    fn rank(self) -> u32 {
        self.h as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_hold_what_they_are_given() {
        for (f, h) in [(0, 0), (3, 1 << 40), ((1 << 48) - 1, (1 << 48) - 1), (1 << 47, 1 << 32)] {
            let entry = PackedEntry::new(f, h, u32::MAX);
            assert_eq!((entry.f(), entry.h(), entry.mark()), (f, h, u32::MAX));
        }
    }

    #[test]
    fn smaller_f_then_smaller_h_then_the_newer_comes_first() {
        ordered::<PackedEntry>();
        ordered::<WideEntry>();
    }

    fn ordered<E: Entry>() {
        const FAR: i64 = 1 << 33;
        let entry = |f, h| E::new(f, h, 1);
        for (first, second) in
            [((1, FAR), (2, 0)), ((1, 1), (1, 2)), ((1, 9), (1, FAR)), ((0, FAR), (0, FAR + 1))]
        {
            let (first, second) = (entry(first.0, first.1), entry(second.0, second.1));
            assert!(first.before(second) && !second.before(first));
        }
        assert!(entry(3, FAR).before(entry(3, FAR)));
        assert!(entry(5, FAR).is_like(entry(5, FAR + 7)) && entry(5, FAR + 7).rank() == 7);
        assert!(!entry(5, FAR).is_like(entry(6, FAR)) && !entry(5, FAR).is_like(entry(5, 7)));
    }

    #[test]
    fn a_mark_tells_node_note_and_whether_moves_are_held_back() {
        for (mark, told) in [
            (PackedEntry::open(77), (77, 0, false)),
            (PackedEntry::deferred(77, 5), (77, 5, true)),
            (PackedEntry::deferred((1 << 28) - 1, 0), ((1 << 28) - 1, 0, true)),
        ] {
            let entry = PackedEntry::new(0, 0, mark);
            assert_eq!((entry.node(), entry.payload(), entry.is_deferred()), told);
        }
    }
}
