//! A search over a car's poses written down: the events, and the arc of every move.

use super::cost::Motion;
use super::domain::{State, StateLattice};
use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::search::{Fate, Labelled, NodeId, Recording, Told, Visit};

/// The events of a search over poses; a node is a cell of position, heading and gear.
#[derive(Debug, Clone, Default)]
pub struct PoseRecording {
    /// The events; costs are metres under the planner's settings.
    pub recording: Recording,
    /// The root's pose.
    pub root: Pose,
    /// True if the tree grows from the goal.
    pub from_goal: bool,
    /// Per move the pose that it leads to, or stops at where something is in its way: x, y, heading, ….
    pub poses: Vec<f64>,
    /// Per move its arc as the tree grows, up to there: curvature, signed length, ….
    pub arcs: Vec<f64>,
    /// Per move whose obstacle is in its way; [`PoseRecording::NOBODY`] where none is.
    pub owners: Vec<u32>,
}

impl PoseRecording {
    /// Stands where nothing is in a move's way.
    pub const NOBODY: u32 = u32::MAX;

    pub(super) fn new(lattice: &StateLattice, root: Pose, origin: Pose, search: Labelled<State>) -> Self {
        // The probe counts, so it must not be the search's own.
        let probe = lattice.probe.clone();
        let world = |pose: Pose| Pose::new(pose.x + origin.x, pose.y + origin.y, pose.heading);
        let from_goal = lattice.mirrored;
        let mut out = Self { root: world(root), from_goal, ..Self::default() };
        for (label, fate) in search.labels.iter().zip(&search.recording.fates) {
            let State { mut pose, motion, mut length } = *label;
            let mut owner = Self::NOBODY;
            if *fate == Fate::Blocked as u8 {
                let from = pose.advance(motion.curvature, -length);
                let arc = Arc { curvature: motion.curvature, length };
                let far = probe.free_length(from, &arc, lattice.level.spacing, lattice.margin);
                let beyond = (far + lattice.level.spacing).min(length.abs()).copysign(length);
                let hit = probe.hit(from.advance(motion.curvature, beyond), lattice.margin);
                owner = hit.unwrap_or(Self::NOBODY);
                length = far.copysign(length);
                pose = from.advance(motion.curvature, length);
            }
            let Pose { x, y, heading } = world(pose);
            out.poses.extend([x, y, heading]);
            out.arcs.extend([motion.curvature, length]);
            out.owners.push(owner);
        }
        out.recording = search.recording;
        out
    }
}

impl Told for StateLattice<'_> {
    fn consider(&self, from: Visit<f64, State>, tell: &mut dyn FnMut(NodeId, f64, State, Option<Fate>)) {
        // While shuffling a move ends where something is in the way.
        if self.is_before_roots(&from) || self.level.shuffle {
            return;
        }
        let State { pose, motion, .. } = from.label;
        for arc in &self.primitives {
            let (end, after) = (pose.advance(arc.curvature, arc.length), Motion::after(arc));
            let cost = self.costs.arc(motion, arc);
            if from.g + cost < self.level.bound {
                let label = State { pose: end, motion: after, length: arc.length };
                tell(self.node(end, after.gear), cost, label, Some(Fate::Blocked));
            }
        }
    }
}
