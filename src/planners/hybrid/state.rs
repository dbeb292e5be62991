//! What a node of the search keeps, and the arcs between nodes.

use super::cost::Motion;
use crate::IS_COMPLETE;
use crate::geometry::Pose;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp::Word;
use crate::search::NodeId;

/// A node's real-valued state: its pose and the arc that led there.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct State {
    pub(super) pose: Pose,
    pub(super) motion: Motion,
    /// Signed length of the arc that led here.
    pub(super) length: f64,
}

/// The arcs of a finished search, from its root to its target.
pub(super) fn path(chain: &[(NodeId, State)], tail: &Word, radius: f64) -> Vec<Arc> {
    arcs::merge(tree_arcs(chain).chain(tail.arcs(radius)))
}

/// The arcs between the nodes of a chain, one each.
pub(super) fn tree_arcs(chain: &[(NodeId, State)]) -> impl Iterator<Item = Arc> {
    chain[1..].iter().flat_map(|(_, s)| {
        let arc = Arc { curvature: s.motion.curvature, length: s.length };
        let is_rock = IS_COMPLETE && s.motion.is_rock;
        rock_arcs(arc).into_iter().skip(if is_rock { 0 } else { 2 })
    })
}

/// The three arcs of a rock whose first and last arc this is.
pub(super) fn rock_arcs(arc: Arc) -> [Arc; 3] {
    [arc, Arc { curvature: -arc.curvature, length: -2.0 * arc.length }, arc]
}
