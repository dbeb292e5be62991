//! Per-node state, reused between searches by generation stamps.

use super::open::{Kind, OpenList, Order};
use super::{Cost, NodeId};

pub(super) const NO_PARENT: NodeId = NodeId::MAX;

#[derive(Debug, Clone, Copy)]
pub(super) struct Slot<C, L> {
    pub(super) g: C,
    pub(super) label: L,
    pub(super) parent: NodeId,
    stamp: u32,
    /// The ticket of the node's latest entry in the open list; earlier entries are stale.
    pub(super) ticket: u32,
    /// 0 open, 1 expanded once, 2 fully expanded.
    pub(super) stage: u8,
}

/// The memory of a search. One value serves any number of searches, of any size, one after another: nothing is
/// cleared in between, so a short query on a large map costs what it touches.
#[derive(Debug)]
pub struct Scratch<C, L> {
    slots: Vec<Slot<C, L>>,
    stamp: u32,
    pub(super) open: OpenList<C>,
}

impl<C: Cost, L: Copy + Default> Default for Scratch<C, L> {
    fn default() -> Self {
        Self { slots: Vec::new(), stamp: 0, open: OpenList::default() }
    }
}

impl<C: Cost, L: Copy + Default> Scratch<C, L> {
    /// Memory with nothing in it yet.
    pub fn new() -> Self {
        Self::default()
    }

    pub(super) fn begin(&mut self, node_count: usize) {
        if self.stamp == u32::MAX {
            self.slots.clear();
            self.stamp = 0;
        }
        self.stamp += 1;
        self.grow(node_count);
    }

    fn grow(&mut self, node_count: usize) {
        if self.slots.len() < node_count {
            let empty =
                Slot { g: C::MAX, label: L::default(), parent: NO_PARENT, stamp: 0, ticket: 0, stage: 0 };
            self.slots.resize(node_count, empty);
        }
    }

    /// The node's state in this search, or `None` where it was not reached yet.
    pub(super) fn get(&self, node: NodeId) -> Option<&Slot<C, L>> {
        self.slots.get(node as usize).filter(|slot| slot.stamp == self.stamp)
    }

    pub(super) fn slot_mut(&mut self, node: NodeId) -> &mut Slot<C, L> {
        &mut self.slots[node as usize]
    }

    /// Records a better way to `node`; tells whether it was reached for the first time.
    pub(super) fn improve(&mut self, node: NodeId, g: C, label: L, parent: NodeId) -> bool {
        if node as usize >= self.slots.len() {
            self.grow((node as usize + 1).next_power_of_two());
        }
        let stamp = self.stamp;
        let slot = &mut self.slots[node as usize];
        let fresh = slot.stamp != stamp;
        *slot = Slot { g, label, parent, stamp, ticket: 0, stage: 0 };
        fresh
    }

    /// Puts a reached node into the open list, with priority `(f, h)`; its earlier entries become stale.
    pub(super) fn enter(&mut self, order: Order, (f, h): (C, C), node: NodeId, kind: Kind) {
        self.slots[node as usize].ticket = self.open.push(order, f, h, node, kind);
    }

    /// Bytes that a search of this many nodes needs, but for the open list's.
    #[cfg(feature = "complete")]
    pub const fn bytes(node_count: usize) -> usize {
        node_count * size_of::<Slot<C, L>>()
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
