//! Obstacles that differ from others at one place, such as a parked car that is gone.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::Obstacles;
use super::obstacles::{Edge, bounds};
use crate::geometry::Point;

/// The obstacles of which others are a variant.
#[derive(Debug)]
pub struct Original {
    /// They have the same lattice.
    pub obstacles: Arc<Obstacles>,
    /// The lower left and the upper right corner of a box around all edges that only one of the two has, local
    /// coordinates, metres. Without such edges the box is empty: its corners are infinite and the wrong way round.
    pub change: (Point, Point),
    /// True if the variant has no edge that the original lacks.
    pub is_freer: bool,
}

impl Obstacles {
    /// The same obstacles, which are known from now on as a variant of others. Nothing changes where the two differ in
    /// origin or lattice.
    #[must_use]
    pub fn variant_of(mut self, original: &Arc<Self>) -> Self {
        if self.origin == original.origin && self.frame() == original.frame() {
            let (own, others) = (keys(&self.edges), keys(&original.edges));
            let is_added = |edge: &&Edge| !others.contains(&key(edge));
            let is_removed = |edge: &&Edge| !own.contains(&key(edge));
            let is_freer = !self.edges.iter().any(|edge| is_added(&edge));
            let added = self.edges.iter().filter(is_added);
            let removed = original.edges.iter().filter(is_removed);
            let change = bounds(added.chain(removed).flat_map(|edge| [edge.a, edge.b]));
            self.original = Some(Original { obstacles: Arc::clone(original), change, is_freer });
        }
        self
    }

    /// The obstacles of which these are a variant.
    pub fn original(&self) -> Option<&Original> {
        self.original.as_ref()
    }
}

fn key(edge: &Edge) -> [u64; 4] {
    [edge.a.x, edge.a.y, edge.b.x, edge.b.y].map(f64::to_bits)
}

fn keys(edges: &[Edge]) -> BTreeSet<[u64; 4]> {
    edges.iter().map(key).collect()
}
