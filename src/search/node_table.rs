//! Per-node state, reused between searches by generation stamps.
//!
//! A search of a large map touches few of its nodes. Clearing the table before each search would cost more than the
//! search itself. Instead each slot remembers the *ticket* of its latest entry in the open list, tickets only grow,
//! and a slot with a ticket from before the search began counts as never reached.
//!
//! One slot holds the node's cost g, its label, its parent and the ticket: 16 bytes without a label. A node that is
//! improved while it is open gets a new ticket. Its older entry in the open list then has a ticket that the slot no
//! longer knows, and is skipped when it is taken. Nothing has to be searched and moved in the open list.
//!
//! ```text
//! ticket < since                 stale: not reached in this search
//! ticket ≥ since, last bit 0     open: the entry with this ticket is the valid one
//! ticket ≥ since, last bit 1     closed: expanded, g and parent are final
//! ```

use super::open_list::{self, EntryKind, OpenList, Order};
use super::{Cost, NodeId};

pub(super) const NO_PARENT: NodeId = NodeId::MAX;

/// What a search knows of a node: its best way from the root so far.
///
/// A slot goes from stale (its ticket is from an earlier search) to open to closed, and never back within a search.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slot<C, L> {
    pub(super) g: C,
    pub(super) label: L,
    pub(super) parent: NodeId,
    /// The ticket of the node's latest entry in the open list, which also tells the search; [`CLOSED`] once it was
    /// expanded.
    ticket: u32,
}

/// Tickets end in two bits of [`EntryKind`], of which nodes' have none.
const CLOSED: u32 = 1;

impl<C, L> Slot<C, L> {
    pub(super) const fn is_closed(&self) -> bool {
        self.ticket & CLOSED != 0
    }

    /// True if an entry of the open list is the node's latest, and that not yet expanded.
    pub(super) const fn is_current(&self, ticket: u32) -> bool {
        self.ticket == ticket
    }

    /// Marks the node as expanded. Its g, label and parent stay as they are for the rest of the search.
    pub(super) const fn close(&mut self) {
        self.ticket |= CLOSED;
    }
}

/// The memory of a search. One value serves any number of searches, of any size, one after another: nothing is
/// cleared in between, so a short query on a large map costs what it touches.
#[derive(Debug)]
pub struct Scratch<C, L> {
    slots: Vec<Slot<C, L>>,
    /// Entries with an earlier ticket belong to a former search.
    since: u32,
    pub(super) open: OpenList<C>,
}

impl<C: Cost, L: Copy + Default> Default for Scratch<C, L> {
    fn default() -> Self {
        Self { slots: Vec::new(), since: open_list::FIRST, open: OpenList::default() }
    }
}

impl<C: Cost, L: Copy + Default> Scratch<C, L> {
    /// Memory with nothing in it yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Forgets everything in O(1); the open list's buckets count from `origin`. Tickets are 32 bits and count on
    /// between searches, so the table is really cleared once in about 500 million insertions.
    pub(super) fn begin(&mut self, node_count: usize, origin: C) {
        if self.open.ticket() > u32::MAX / 2 {
            self.slots.clear();
            self.open = OpenList::default();
        }
        self.since = self.open.ticket();
        self.open.reset(origin);
        self.grow(node_count);
    }

    /// Makes room for this many nodes; new slots are stale.
    fn grow(&mut self, node_count: usize) {
        if self.slots.len() < node_count {
            let empty = Slot { g: C::MAX, label: L::default(), parent: NO_PARENT, ticket: 0 };
            self.slots.resize(node_count, empty);
        }
    }

    /// The node's state in this search, or `None` where it was not reached yet: a stale slot looks like no slot.
    pub(super) fn get(&self, node: NodeId) -> Option<&Slot<C, L>> {
        self.slots.get(node as usize).filter(|slot| slot.ticket >= self.since)
    }

    pub(super) fn slot_mut(&mut self, node: NodeId) -> &mut Slot<C, L> {
        &mut self.slots[node as usize]
    }

    /// Records a better way to `node` and puts it into the open list, with priority `(f, h)`: its earlier entries
    /// become stale. Tells whether it was reached for the first time.
    pub(super) fn enter(
        &mut self,
        order: Order,
        (f, h): (C, C),
        node: NodeId,
        (g, label, parent): (C, L, NodeId),
    ) -> bool {
        if node as usize >= self.slots.len() {
            self.grow((node as usize + 1).next_power_of_two());
        }
        let ticket = self.open.push(order, f, h, node, EntryKind::Fresh);
        let slot = &mut self.slots[node as usize];
        let fresh = slot.ticket < self.since;
        *slot = Slot { g, label, parent, ticket };
        fresh
    }

    /// Bytes that a search of this many nodes needs whose open list holds `open_peak` entries at most.
    pub const fn bytes(node_count: usize, open_peak: u32) -> usize {
        node_count * size_of::<Slot<C, L>>() + open_peak as usize * size_of::<open_list::Entry<C>>()
    }

    /// The best cost found for `node` in the last search.
    pub fn cost(&self, node: NodeId) -> Option<C> {
        self.get(node).map(|s| s.g)
    }

    /// The label of `node` in the last search.
    pub fn label(&self, node: NodeId) -> Option<L> {
        self.get(node).map(|s| s.label)
    }

    /// The nodes from the root to `node`, with their labels, along the last search's best way.
    /// A node that the search did not reach has an empty chain.
    pub fn chain(&self, node: NodeId) -> Vec<(NodeId, L)> {
        let mut chain = Vec::new();
        let mut at = node;
        while at != NO_PARENT {
            let Some(slot) = self.get(at) else { break };
            chain.push((at, slot.label));
            at = slot.parent;
        }
        chain.reverse();
        chain
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn enter(scratch: &mut Scratch<i64, char>, node: NodeId, g: i64) -> bool {
        scratch.enter(Order::Newest, (g, 0), node, (g, 'l', NO_PARENT))
    }

    #[test]
    fn tickets_start_anew_before_they_run_out() {
        let mut scratch = Scratch::new();
        let half = 1 << 31;
        scratch.open = OpenList::at(half - 8);
        scratch.begin(2, 0);
        assert!(enter(&mut scratch, 0, 5) && !enter(&mut scratch, 0, 4));
        assert_eq!((scratch.cost(0), scratch.open.ticket()), (Some(4), half));
        scratch.begin(2, 0);
        assert_eq!((scratch.cost(0), scratch.open.ticket()), (None, open_list::FIRST));
        assert!(enter(&mut scratch, 1, 3));
        // Tickets go on from one search to the next.
        scratch.begin(2, 0);
        assert_eq!((scratch.cost(1), scratch.open.ticket()), (None, 2 * open_list::FIRST));
    }

    #[test]
    fn nodes_beyond_the_count_are_taken() {
        let mut scratch = Scratch::new();
        scratch.begin(0, 0);
        for node in [0, 1, 6] {
            assert!(scratch.cost(node).is_none() && enter(&mut scratch, node, 7));
            assert_eq!((scratch.cost(node), scratch.label(node)), (Some(7), Some('l')));
        }
    }

    #[test]
    fn memory_is_told() {
        // A node has its cost, parent and ticket, an entry two costs, its node and its ticket.
        assert_eq!(Scratch::<i64, ()>::bytes(10, 3), 10 * 16 + 3 * 24);
    }
}
