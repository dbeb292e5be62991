//! A search over a car's poses written down: the events, and the arc of every move.
//!
//! Two recorders meet here. The search core writes down nodes, costs and what became of each move, and knows nothing
//! of cars. This part adds the geometry that belongs to a move: the pose at its end, its arc, and the obstacle that
//! blocks it.
//!
//! Columns instead of structures, because all of it goes to JavaScript as typed arrays. A move costs 44 bytes beside
//! the [`Recording::MOVE_BYTES`] of its event: three numbers of a pose, two of an arc and one owner.

use super::domain::{Move, StateLattice};
use super::state::State;
use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::search::{BACKWARD, Fate, Labelled, NodeId, Recording, Told, Visit};
use crate::vehicle::collision::CollisionChecker;

/// The events of a search over poses; a node is a cell of position, heading and gear.
///
/// Poses are in world coordinates, lengths in metres, angles in radians. Arcs run as the tree grows: from the goal,
/// where [`PoseRecording::from_goal`] is true, which is against the direction in which the car will drive.
#[derive(Debug, Clone, Default)]
pub struct PoseRecording {
    /// The events; costs are metres under the planner's settings.
    pub recording: Recording,
    /// Per side the root's pose; of two sides the first grows from the start.
    pub roots: Vec<Pose>,
    /// True if the only tree, or the first, grows from the goal.
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

    /// `sides` are the lattices, each with its root; poses are told from `origin`.
    pub(super) fn new(
        sides: &[(&StateLattice, Pose)],
        origin: Pose,
        Labelled { recording, labels }: Labelled<State>,
    ) -> Self {
        let world = |pose: Pose| Pose::new(pose.x + origin.x, pose.y + origin.y, pose.heading);
        let mut out = Self {
            roots: sides.iter().map(|side| world(side.1)).collect(),
            from_goal: sides[0].0.mirrored,
            ..Self::default()
        };
        // The checker counts, so it must not be the search's own.
        let checker = sides[0].0.checker.clone();
        for (step, moves) in recording.first.windows(2).enumerate() {
            let lattice = sides[usize::from(recording.kinds[step] >= BACKWARD)].0;
            let moves = moves[0] as usize..moves[1] as usize;
            for (&label, &fate) in labels[moves.clone()].iter().zip(&recording.fates[moves]) {
                out.offer(lattice, &checker, label, fate == Fate::Blocked as u8, world);
            }
        }
        out.recording = recording;
        out
    }

    /// Writes a move's arc down, up to where something is in its way.
    fn offer(
        &mut self,
        lattice: &StateLattice,
        checker: &CollisionChecker,
        State { mut pose, motion, mut length }: State,
        is_blocked: bool,
        world: impl Fn(Pose) -> Pose,
    ) {
        let mut owner = Self::NOBODY;
        if is_blocked {
            let from = pose.advance(motion.curvature, -length);
            let arc = Arc { curvature: motion.curvature, length };
            let far = checker.free_length(from, &arc, lattice.level.spacing, lattice.margin);
            let beyond = (far + lattice.level.spacing).min(length.abs()).copysign(length);
            let hit = checker.hit(from.advance(motion.curvature, beyond), lattice.margin);
            owner = hit.unwrap_or(Self::NOBODY);
            length = far.copysign(length);
            pose = from.advance(motion.curvature, length);
        }
        let Pose { x, y, heading } = world(pose);
        self.poses.extend([x, y, heading]);
        self.arcs.extend([motion.curvature, length]);
        self.owners.push(owner);
    }
}

impl Told for StateLattice<'_> {
    fn consider(&self, from: Visit<f64, State>, tell: &mut dyn FnMut(NodeId, f64, State, Option<Fate>)) {
        // While shuffling a move ends where something is in the way.
        if self.is_before_roots(&from) || self.level.shuffles() {
            return;
        }
        let mut moves = Vec::new();
        self.list_moves(from, &mut moves);
        for Move { node, cost, to, .. } in moves {
            tell(node, cost, to, Some(Fate::Blocked));
        }
    }
}
