//! Watching a search: `()` watches nothing at no cost.

use super::NodeId;

/// Told of every event of a search.
pub trait Observer<C, L> {
    /// A node was taken from the open list and expanded.
    fn expanded(&mut self, node: NodeId, label: L, g: C) {
        let _ = (node, label, g);
    }
    /// A better way to `node` was found from `parent`.
    fn relaxed(&mut self, node: NodeId, parent: NodeId, label: L, g: C) {
        let _ = (node, parent, label, g);
    }
}

impl<C, L> Observer<C, L> for () {}

/// Watches, or not, by a decision made at run time; one branch an event.
impl<C, L, O: Observer<C, L>> Observer<C, L> for Option<O> {
    fn expanded(&mut self, node: NodeId, label: L, g: C) {
        if let Some(observer) = self {
            observer.expanded(node, label, g);
        }
    }

    fn relaxed(&mut self, node: NodeId, parent: NodeId, label: L, g: C) {
        if let Some(observer) = self {
            observer.relaxed(node, parent, label, g);
        }
    }
}

/// Expanded nodes in order, up to a cap.
#[derive(Debug, Clone)]
pub struct Trace {
    /// The nodes, in order of expansion.
    pub expanded: Vec<NodeId>,
    /// Expansions beyond the cap, counted only.
    pub dropped: u64,
    cap: usize,
}

impl Trace {
    /// A trace that keeps the first `cap` expansions.
    pub fn new(cap: usize) -> Self {
        Self { expanded: Vec::new(), dropped: 0, cap }
    }
}

impl<C, L> Observer<C, L> for Trace {
    fn expanded(&mut self, node: NodeId, _: L, _: C) {
        if self.expanded.len() < self.cap {
            self.expanded.push(node);
        } else {
            self.dropped += 1;
        }
    }
}
