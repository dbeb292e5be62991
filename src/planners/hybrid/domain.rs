//! The search space: poses on a lattice of position, heading and gear, joined by arcs.
//!
//! A node is a lattice cell; its label is the real-valued pose that reached the cell at the least cost. The cell's
//! key packs x and y in steps of `Level::xy`, the heading in steps of `Level::yaw`, and the gear; `StateIndex`
//! gives each key met a dense number. Moves are arcs of length `Level::step` ahead and back, at 2·`steer_samples` +
//! 1 steering angles that are spread evenly from lock to lock; some levels also take shorter ones, up to an obstacle.
//!
//! ```text
//! 63        43 42        22 21      3  2    1   0
//! ┌───────────┬────────────┬─────────┬─────┬──────┐
//! │ ⌊x/xy⌋    │ ⌊y/xy⌋     │ ⌊θ/yaw⌋ │clear│ gear │   the key of a state
//! └───────────┴────────────┴─────────┴─────┴──────┘
//! ```
//!
//! Invariants:
//!
//! * A node's pose never changes once it is expanded, and poses are not snapped to the lattice: a path is a chain of
//!   exact arcs, and its end is exact to rounding.
//! * Gear is part of the state, because a gear change has a price. The curvature of the last arc is not, though the
//!   wheel's movement has a price too: that would multiply the states by the steering angles.
//! * One pose stands for a whole cell, so the search is not complete: a cell's second pose might have got through.
//!
//! Poses are local to the obstacles. A tree that grows from the goal is *mirrored*: it drives the path backwards,
//! so every gear is the other one.

mod connections;
mod lengths;
mod rock;

use core::cell::{Cell, RefCell, RefMut};

use super::analytic_expansion::{Recorder, take_cheapest};
use super::config::{Config, Heuristic};
use super::cost::CostModel;
use super::lattices::{Lengths, Level};
use super::obstacle_heuristic::ObstacleHeuristic;
use super::pose_heuristic::PoseHeuristic;
use super::state::State;
use super::state_index::StateIndex;
use crate::IS_COMPLETE;
use crate::geometry::arcs::Arc;
use crate::geometry::reeds_shepp::{self, Word};
use crate::geometry::{Pose, math};
use crate::search::{Domain, Finish, NodeId, Order, Relax, Visit};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::{CollisionChecker, Reach, Sampling};

/// While shuffling, where the body has this much room around it, metres, …
const SHUFFLE_CLEARANCE: f64 = 0.1;
/// … states are told apart no finer than this: metres and radians.
const SHUFFLE_BINS: (f64, f64) = (0.5, math::PI / 36.0);
/// A key that no lattice cell has.
const NO_CELL: u64 = u64::MAX;

/// A move from a state, before anything but its cost is known.
#[derive(Debug, Clone, Copy)]
pub(super) struct Move {
    /// Of the cell where it ends.
    key: u64,
    pub(super) node: NodeId,
    /// Places aside.
    pub(super) cost: f64,
    arc: Arc,
    pub(super) to: State,
}

/// One search, from `root` to `target`, in local coordinates.
pub(super) struct StateLattice<'a> {
    pub(super) checker: &'a CollisionChecker<'a>,
    pub(super) flood: &'a ObstacleHeuristic,
    pub(super) keys: &'a RefCell<StateIndex>,
    pub(super) costs: CostModel,
    /// Of the places along connections.
    tail_costs: CostModel,
    pub(super) level: Level,
    pub(super) heuristic: Heuristic,
    pub(super) target: Pose,
    pub(super) margin: f64,
    pub(super) max_changes: u32,
    /// Costs from poses to the target, where the search is guided by them.
    poses: Option<&'a PoseHeuristic>,
    /// The poses that a search with many roots begins from, all at no cost; none where it begins from one.
    roots: &'a [Pose],
    pub(super) mirrored: bool,
    recorder: Option<&'a RefCell<Recorder>>,
    pub(super) primitives: Vec<Arc>,
    words: Vec<(f64, Word)>,
    /// Moves from the state at hand.
    moves: RefCell<Vec<Move>>,
    /// States that were asked for a connection so far.
    asked: u32,
    sampling: Sampling,
    /// How far the body can go from the pose that was asked about last, and back from the target.
    reach: [RefCell<Reach>; 2],
    /// Words tried so far, and the checks that they took.
    tried: Cell<(u32, u32)>,
}

/// Parts of a lattice.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub(super) checker: &'a CollisionChecker<'a>,
    pub(super) flood: &'a ObstacleHeuristic,
    pub(super) keys: &'a RefCell<StateIndex>,
    pub(super) costs: CostModel,
    /// True if the tree grows from the goal; `costs` are then, too.
    pub(super) mirrored: bool,
    pub(super) recorder: Option<&'a RefCell<Recorder>>,
    pub(super) poses: Option<&'a PoseHeuristic>,
    pub(super) roots: &'a [Pose],
}

impl<'a> StateLattice<'a> {
    /// The lattice of one level. Keys of the search before are forgotten, because their bins depend on the level;
    /// primitives are listed once, with steering angles δ from lock to lock and curvatures tan(δ)/wheelbase, gear ahead
    /// first.
    pub(super) fn new(
        setting: Setting<'a>,
        vehicle: &Vehicle,
        config: &Config,
        level: Level,
        target: Pose,
        margin: f64,
    ) -> Self {
        setting.keys.borrow_mut().clear();
        let n = level.steer_samples as i32;
        let steers = (-n..=n).map(|k| vehicle.max_steer * f64::from(k) / f64::from(n));
        let curvatures: Vec<f64> = steers.map(|delta| math::tan(delta) / vehicle.wheelbase).collect();
        let gears = [level.step, -level.step];
        let primitives = gears
            .into_iter()
            .flat_map(|length| curvatures.iter().map(move |&curvature| Arc { curvature, length }))
            .collect();
        let sampling = Sampling::new(level.spacing, margin, setting.costs.radius);
        Self {
            checker: setting.checker,
            flood: setting.flood,
            keys: setting.keys,
            costs: setting.costs,
            tail_costs: setting.costs.with_far_reverse(level.far_reverse.max(level.tail_far_reverse)),
            level,
            heuristic: config.heuristic,
            target,
            margin,
            max_changes: config.max_direction_changes,
            poses: setting.poses,
            roots: setting.roots,
            mirrored: setting.mirrored,
            recorder: setting.recorder,
            primitives,
            words: Vec::new(),
            moves: RefCell::default(),
            asked: 0,
            sampling,
            reach: [(), ()].map(|()| RefCell::new(Reach::new(target, sampling))),
            tried: Cell::new((0, 0)),
        }
    }

    /// The node that a search from `pose` begins at; with many roots none of them, but one before all of them.
    pub(super) fn root(&self, pose: Pose) -> (NodeId, State) {
        let state = |pose| State { pose, ..State::default() };
        if IS_COMPLETE && !self.roots.is_empty() {
            let node = self.keys.borrow_mut().id(NO_CELL);
            // No path from any of them is cheaper than the least estimate.
            let estimates: Vec<f64> =
                self.roots.iter().map(|&pose| self.heuristic(node, state(pose))).collect();
            return (node, state(self.roots[math::argmin(&estimates)]));
        }
        (self.node(pose, 0), state(pose))
    }

    pub(super) fn is_before_roots(&self, at: &Visit<f64, State>) -> bool {
        IS_COMPLETE && at.parent.is_none() && !self.roots.is_empty()
    }

    /// The number of a state's lattice cell.
    pub(super) fn node(&self, pose: Pose, gear: i8) -> NodeId {
        self.keys.borrow_mut().id(self.key(pose, gear))
    }

    /// The key of a pose's cell, as drawn at the head of this file. Where the body has room while shuffling, bins are
    /// coarser, and a bit of the key says so: the same place has then another key than with finer bins.
    #[inline]
    fn key(&self, pose: Pose, gear: i8) -> u64 {
        let clear_by = self.level.shuffles() && self.checker.clear_by(pose, SHUFFLE_CLEARANCE);
        let (xy, yaw) = if clear_by { SHUFFLE_BINS } else { (self.level.xy, self.level.yaw) };
        // The offset keeps what lies left of or below the origin positive.
        let cell = |v: f64| (v / xy + f64::from(1 << 20)) as u64 & 0x1f_ffff;
        let bins = (math::TAU / yaw).ceil() as u64;
        let yaw = ((pose.heading + math::PI) / yaw) as u64 % bins;
        let key = (cell(pose.x) << 43) | (cell(pose.y) << 22) | (yaw << 3) | (gear + 1) as u64;
        key | u64::from(clear_by) << 2
    }

    fn free(&self, from: Pose, arc: &Arc) -> bool {
        self.checker.arc_free(from, arc, self.level.spacing, self.margin)
    }

    /// How far the body can go from `from`.
    fn ahead<'r>(&self, reach: &'r RefCell<Reach>, from: Pose) -> RefMut<'r, Reach> {
        let mut reach = reach.borrow_mut();
        if reach.from() != from {
            *reach = Reach::new(from, self.sampling);
        }
        reach
    }

    /// True if a primitive is straight or at full lock.
    fn is_tightest(&self, primitive: &Arc) -> bool {
        primitive.curvature == 0.0 || self.level.steer_samples == 1
    }

    fn is_primitive_free(&self, from: Pose, arc: &Arc) -> bool {
        if self.is_tightest(arc) {
            self.ahead(&self.reach[0], from).is_free(self.checker, arc)
        } else {
            self.free(from, arc)
        }
    }

    /// The moves from a state that stay below the bound, whether or not they are free.
    ///
    /// All are made before the first of their cells is looked up: the look-ups then wait for memory together.
    #[inline(never)]
    pub(super) fn list_moves(&self, from: Visit<f64, State>, moves: &mut Vec<Move>) {
        let State { pose, motion, length: driven } = from.label;
        let turned = self.ahead(&self.reach[0], pose).turned();
        moves.clear();
        let is_farthest = IS_COMPLETE && self.level.shuffles() && driven.abs() < self.level.step;
        for primitive in &self.primitives {
            if motion.then(primitive).changes > self.level.most_changes {
                continue;
            }
            // While shuffling, an arc ends where something is in the way, or half as far, and its other end goes on.
            if is_farthest && primitive.curvature == motion.curvature && primitive.length * driven > 0.0 {
                continue;
            }
            for length in self.lengths(pose, primitive).into_iter().filter(|&length| length != 0.0) {
                let arc = Arc { length, ..*primitive };
                let cost = self.costs.arc(motion, &arc);
                if from.g + cost >= self.level.bound {
                    continue;
                }
                let (end, motion) = (pose.advance_turned(turned, arc.curvature, length), motion.then(&arc));
                let to = State { pose: end, motion, length };
                let key = self.key(end, motion.gear);
                moves.push(Move { key, node: 0, cost, arc, to });
            }
        }
        let mut keys = self.keys.borrow_mut();
        for one in moves {
            one.node = keys.id(one.key);
        }
    }
}

impl Domain for StateLattice<'_> {
    type Cost = f64;
    type Label = State;
    type Tail = Word;

    fn node_count(&self) -> usize {
        0
    }

    fn order(&self) -> Order {
        Order::Oldest
    }

    fn successors<S: Relax<f64, State>>(&self, from: Visit<f64, State>, sink: &mut S) {
        if self.is_before_roots(&from) {
            for &pose in self.roots {
                sink.emit(self.node(pose, 0), 0.0, State { pose, ..State::default() });
            }
            return;
        }
        let pose = from.label.pose;
        let mut moves = self.moves.borrow_mut();
        self.list_moves(from, &mut moves);
        for &Move { node, cost, arc, to, .. } in &*moves {
            if !sink.improves(node, cost) {
                continue;
            }
            if self.level.shuffles() || self.is_primitive_free(pose, &arc) {
                sink.emit(node, cost + self.costs.places(self.checker, pose, &arc), to);
            } else if IS_COMPLETE && self.level.lengths == Lengths::Shortened {
                self.shorten(from, &arc, sink);
            }
        }
        if IS_COMPLETE && self.level.rock > 0.0 {
            self.rock(from, sink);
        }
    }

    fn heuristic(&self, _: NodeId, label: State) -> f64 {
        let at = label.pose;
        let h = match self.heuristic {
            Heuristic::Euclid => (self.target.point() - at.point()).norm_squared().sqrt(),
            Heuristic::ReedsShepp => reeds_shepp::distance(at, self.target, self.costs.radius),
            Heuristic::Max => {
                let around = self.flood.distance(at);
                if around.is_finite() && self.level.far_reverse > 0.0 {
                    // A way with little of it turns round; what that costs leads the search there.
                    let curve = reeds_shepp::distance(at, self.target, self.costs.radius);
                    around + curve - (self.target.point() - at.point()).norm_squared().sqrt()
                } else if around.is_finite() {
                    around.max(reeds_shepp::distance_or(at, self.target, self.costs.radius, around))
                } else {
                    around
                }
            }
        };
        let h = match self.poses {
            Some(poses) if IS_COMPLETE && h.is_finite() => poses.cost(at, label.motion.gear, h),
            _ => h,
        };
        h * self.level.weight
    }

    fn finish(&mut self, at: Visit<f64, State>, bound: f64) -> Option<Finish<f64, Word>> {
        if self.is_before_roots(&at) {
            return None;
        }
        let State { pose, motion, .. } = at.label;
        self.asked += 1;
        if !(self.asked - 1).is_multiple_of(self.connect_every(pose)) {
            if let Some(recorder) = self.recorder {
                recorder.borrow_mut().skip();
            }
            return None;
        }
        let bound = bound.min(self.level.bound);
        let mut found = core::mem::take(&mut self.words);
        found.clear();
        reeds_shepp::words_below(pose, self.target, self.costs.radius, bound - at.g, |word| {
            if word.direction_changes() > self.max_changes || !self.has_changes_left(motion, &word) {
                return;
            }
            let cost = self.costs.word(motion, &word);
            if at.g + cost < bound {
                found.push((cost, word));
            }
        });
        let (mut missed, mut best) = (None, None::<Finish<f64, Word>>);
        while let Some((cost, word)) = take_cheapest(&mut found) {
            if best.as_ref().is_some_and(|best| cost >= best.cost) {
                break;
            }
            if !self.word_free(pose, &word) {
                missed.get_or_insert(word);
                continue;
            }
            let cost = cost + self.tail_costs.word_places(self.checker, pose, &word);
            if at.g + cost < bound && best.as_ref().is_none_or(|best| cost < best.cost) {
                best = Some(Finish { cost, tail: word });
            }
        }
        self.words = found;
        if let Some(recorder) = self.recorder {
            let rules = (self.costs.radius, self.level.spacing, self.margin);
            recorder.borrow_mut().note(&self.checker.clone(), pose, missed.as_ref(), rules, self.mirrored);
        }
        best
    }
}

#[cfg(test)]
mod tests;
