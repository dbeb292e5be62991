//! Obstacles that differ from others at one place, such as a parked car that is gone.

use std::sync::Arc;

use super::Obstacles;
use super::edge::{Edge, bounds};
use super::obstacles::Original;

impl Obstacles {
    /// The same obstacles, which are known from now on as a variant of others. Nothing changes where the two differ in
    /// origin or lattice.
    ///
    /// All edges between the first and the last that differ, in the order of both, count as changed: one thing that is
    /// missing is found exactly.
    #[must_use]
    pub fn variant_of(mut self, original: &Arc<Self>) -> Self {
        if self.origin == original.origin && self.frame() == original.frame() {
            let (own, others) = (&self.edges[..], &original.edges[..]);
            let before = own.iter().zip(others).take_while(|(a, b)| is_same(a, b)).count();
            let (own, others) = (&own[before..], &others[before..]);
            let behind = own.iter().rev().zip(others.iter().rev()).take_while(|(a, b)| is_same(a, b)).count();
            let (own, others) = (&own[..own.len() - behind], &others[..others.len() - behind]);
            self.original = Some(Original {
                obstacles: Arc::clone(original),
                change: bounds(own.iter().chain(others).flat_map(|edge| [edge.a, edge.b])),
                is_freer: own.is_empty(),
            });
        }
        self
    }

    /// The obstacles of which these are a variant.
    pub fn original(&self) -> Option<&Original> {
        self.original.as_ref()
    }
}

/// True if two edges lie in the same place; whose they are does not matter.
fn is_same(one: &Edge, other: &Edge) -> bool {
    (one.a, one.b) == (other.a, other.b)
}
