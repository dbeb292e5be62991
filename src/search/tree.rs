//! A tree that grows from a root in the order of its open list.
//!
//! [`best_first`](super::best_first()) grows one, a bidirectional search two, by the same steps: take the first entry
//! that is not stale (`pop`), close its node, try to complete a path from there, emit its moves (`expand`). Who calls
//! them decides when to stop. A move that cannot lead to a path below the best one known is not put into the open list.

use super::node_table::{NO_PARENT, Slot};
use super::open_list::{Entry, EntryKind};
use super::{Cost, Domain, Finish, NodeId, Observer, Relax, Scratch, SearchStats, Visit};

/// A domain, and what a search has found in it so far.
#[derive(Debug)]
pub struct Tree<'a, D: Domain> {
    /// The graph that it grows in.
    pub domain: &'a mut D,
    pub(super) scratch: &'a mut Scratch<D::Cost, D::Label>,
    /// Distinct nodes that ever entered the open list, the root included.
    pub(super) generated: u32,
    /// The smallest heuristic value of an expanded node, and that node.
    pub(super) closest: (D::Cost, NodeId),
}

impl<'a, D: Domain> Tree<'a, D> {
    /// A tree of its root alone, which waits in the open list. `scratch` is used again.
    #[inline(always)]
    pub fn new(
        domain: &'a mut D,
        (root, label): (NodeId, D::Label),
        scratch: &'a mut Scratch<D::Cost, D::Label>,
    ) -> Self {
        let h = domain.heuristic(root, label);
        scratch.begin(domain.node_count(), h);
        scratch.enter(domain.order(), (h, h), root, (D::Cost::default(), label, NO_PARENT));
        Self { domain, scratch, generated: 1, closest: (h, root) }
    }

    /// Its counters, without expansions, which the caller counts, and bytes.
    pub(super) fn stats(&self) -> SearchStats {
        let open = &self.scratch.open;
        let (pushes, open_peak) = (open.pushes(), open.peak() as u32);
        SearchStats { generated: self.generated, pushes, open_peak, ..SearchStats::default() }
    }

    /// Takes the first entry of the open list that is not stale; its node is not expanded yet.
    #[inline(always)]
    pub(super) fn pop(&mut self) -> Option<Entry<D::Cost>> {
        while let Some(entry) = self.scratch.open.pop(self.domain.order()) {
            if entry.kind() == EntryKind::Goal || self.scratch.slot_mut(entry.node).is_current(entry.ticket) {
                return Some(entry);
            }
        }
        None
    }

    /// Closes the entry's node, which is expanded next.
    #[inline(always)]
    pub(super) fn close<O: Observer<D::Cost, D::Label>>(
        &mut self,
        entry: &Entry<D::Cost>,
        observer: &mut O,
    ) -> Visit<D::Cost, D::Label> {
        let slot = self.scratch.slot_mut(entry.node);
        slot.close();
        let at = visit(entry.node, slot);
        observer.expanded(at.node, at.label, at.g);
        if entry.h < self.closest.0 {
            self.closest = (entry.h, at.node);
        }
        at
    }

    /// A completion from the node, if one costs less than `best` in all.
    #[inline(always)]
    pub(super) fn complete(
        &mut self,
        at: Visit<D::Cost, D::Label>,
        best: D::Cost,
    ) -> Option<Finish<D::Cost, D::Tail>> {
        self.domain.finish(at, best).filter(|finish| at.g + finish.cost < best)
    }

    /// Puts the node's moves into the open list, except those that cannot lead to a path for less than `best`.
    #[inline(always)]
    pub(super) fn expand<O: Observer<D::Cost, D::Label>>(
        &mut self,
        at: Visit<D::Cost, D::Label>,
        best: D::Cost,
        observer: &mut O,
    ) {
        let Self { domain, scratch, .. } = self;
        let mut sink =
            TreeSink { domain: &**domain, scratch, observer, parent: at.node, g: at.g, best, generated: 0 };
        domain.successors(at, &mut sink);
        self.generated += sink.generated;
    }
}

impl<D: Domain> Tree<'_, D> {
    /// The least f of the open list, stale entries included; [`Cost::MAX`] where it is empty.
    pub(super) fn least(&mut self) -> D::Cost {
        self.scratch.open.least(self.domain.order()).unwrap_or(D::Cost::MAX)
    }

    /// A node as the tree has reached it so far, expanded or not.
    pub fn reached(&self, node: NodeId) -> Option<Visit<D::Cost, D::Label>> {
        self.scratch.get(node).map(|slot| visit(node, slot))
    }

    /// The nodes from the root to `node`, with their labels.
    pub fn chain(&self, node: NodeId) -> Vec<(NodeId, D::Label)> {
        self.scratch.chain(node)
    }
}

/// The state of a node in the form in which domains see it.
#[inline(always)]
fn visit<C: Copy, L: Copy>(node: NodeId, slot: &Slot<C, L>) -> Visit<C, L> {
    let parent = (slot.parent != NO_PARENT).then_some(slot.parent);
    Visit { node, label: slot.label, g: slot.g, parent }
}

/// Takes the moves of one node, `parent`, which the search has reached at cost `g`.
struct TreeSink<'a, D: Domain, O> {
    domain: &'a D,
    scratch: &'a mut Scratch<D::Cost, D::Label>,
    observer: &'a mut O,
    parent: NodeId,
    g: D::Cost,
    best: D::Cost,
    generated: u32,
}

impl<D: Domain, O: Observer<D::Cost, D::Label>> Relax<D::Cost, D::Label> for TreeSink<'_, D, O> {
    fn improves(&self, target: NodeId, cost: D::Cost) -> bool {
        let g = self.g + cost;
        g < self.best && self.scratch.get(target).is_none_or(|s| !s.is_closed() && g < s.g)
    }

    fn is_closed(&self, target: NodeId) -> bool {
        self.scratch.get(target).is_some_and(Slot::is_closed)
    }

    fn emit_past(&mut self, target: NodeId, cost: D::Cost, label: D::Label) {
        let parent = self.scratch.slot_mut(self.parent).parent;
        let g = self.scratch.slot_mut(parent).g + cost;
        if !self.is_closed(target) && self.scratch.get(target).is_none_or(|slot| g < slot.g) {
            self.link(parent, g, target, label);
        }
    }

    fn emit(&mut self, target: NodeId, cost: D::Cost, label: D::Label) {
        if self.improves(target, cost) {
            self.link(self.parent, self.g + cost, target, label);
        }
    }
}

/// A move whose target is estimated at infinity, or whose f is no less than the best path's cost, never enters the
/// open list. This keeps the list short once a first path is known: every later entry can still improve on it.
impl<D: Domain, O: Observer<D::Cost, D::Label>> TreeSink<'_, D, O> {
    /// Records `parent` as the way to `target` and puts the target into the open list.
    fn link(&mut self, parent: NodeId, g: D::Cost, target: NodeId, label: D::Label) {
        let h = self.domain.heuristic(target, label);
        if h >= D::Cost::MAX || g + h >= self.best {
            return;
        }
        self.generated +=
            u32::from(self.scratch.enter(self.domain.order(), (g + h, h), target, (g, label, parent)));
        self.observer.relaxed(target, parent, label, g);
    }
}
