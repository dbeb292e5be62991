//! Cost model of driving.
//!
//! An arc of length s (metres) and curvature κ, for a car of turning radius R, costs
//!
//! ```text
//! |s| · (w + steerCost · |κ|·R)          w = reverseCost in reverse, else 1
//! + directionChangeCost                  if the gear changes
//! + steerChangeCost · |Δκ|·R             where the curvature changes
//! + obstacleCost · ∫ (1 − c/D)² ds       where the clearance c is below D = obstacleDistance
//! + the profile's price · ds             in reverse, more than 10 m from both ends
//! + the profile's price                  for each gear change after the second
//! + w · (weight − 1) ds                  over cells with a weight
//! ```
//!
//! The first three terms depend on the arc and the one before it; the others are sampled along it, at most half a
//! metre apart. No weight is negative and w is at least 1, so that the length bounds the cost from below.
//!
//! What each term is for: the weight of reverse driving and the price of a gear change are what drivers mind; the
//! weights of the wheel make steady curves cheaper than winding ones of equal length; the obstacle term prefers the
//! middle of a passage and falls to nothing, with its slope, at D. κ·R is 1 at full lock, so the weights of the wheel
//! need no knowledge of the car.
//!
//! A gear change and a movement of the wheel belong to the joint of two arcs. That is why a state knows the arc by
//! which it was reached, and why the cost of a path can be summed arc by arc.

use super::config::Config;
use super::lattices::Level;
use super::profile::FEW_CHANGES;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp::Word;
use crate::geometry::{Point, Pose};
use crate::vehicle::collision::CollisionChecker;

/// Places are looked at this often along an arc, metres.
const CLEARANCE_STEP: f64 = 0.5;
/// Reverse driving within this distance of start or goal belongs to the manoeuvre there, metres.
const MANOEUVRE: f64 = 10.0;

/// The cost model of one plan.
/// All prices are in metres, or in metres per metre: a path's cost is the length of a straight way ahead that is
/// worth as much.
#[derive(Debug, Clone, Copy)]
pub(super) struct CostModel {
    pub(super) radius: f64,
    /// True if the tree grows from the goal, where every gear is the other one.
    mirrored: bool,
    reverse: f64,
    /// Extra weight of a metre in reverse away from both ends.
    far_reverse: f64,
    /// Extra cost of each gear change of a path after the second; a search does not count them.
    many_changes: f64,
    /// Start and goal.
    ends: [Point; 2],
    change: f64,
    steer: f64,
    steer_change: f64,
    obstacle: f64,
    obstacle_distance: f64,
}

/// How the car came to a pose: gear (0 at the root) and curvature.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Motion {
    pub(super) gear: i8,
    /// True if the arc ends a rock: the same arc, twice as far back on the other lock, and the arc again.
    pub(super) is_rock: bool,
    /// Gear changes since the root, as far as they are counted.
    pub(super) changes: u8,
    pub(super) curvature: f64,
}

impl Motion {
    /// How the car moves at the end of an arc.
    #[inline]
    pub(super) fn after(arc: &Arc) -> Self {
        let gear = if arc.length < 0.0 { -1 } else { 1 };
        Self { gear, is_rock: false, changes: 0, curvature: arc.curvature }
    }

    /// The same as after `arc`, with the gear changes counted.
    #[inline]
    pub(super) fn then(self, arc: &Arc) -> Self {
        let next = Self::after(arc);
        let changed = u8::from(self.gear * next.gear < 0);
        Self { changes: self.changes.saturating_add(changed), ..next }
    }
}

impl CostModel {
    /// Costs of arcs as driven from start to goal.
    pub(super) fn driven(config: &Config, radius: f64, ends: [Pose; 2]) -> Self {
        let config = config.with_profile();
        Self {
            radius,
            mirrored: false,
            reverse: config.reverse_cost,
            far_reverse: config.profile.far_reverse(),
            many_changes: config.profile.many_changes(),
            ends: ends.map(Pose::point),
            change: config.direction_change_cost,
            steer: config.steer_cost,
            steer_change: config.steer_change_cost,
            obstacle: config.obstacle_cost,
            obstacle_distance: config.obstacle_distance,
        }
    }

    /// Costs of the same arcs in a tree that grows from the goal.
    pub(super) fn mirrored(self) -> Self {
        Self { mirrored: true, ..self }
    }

    /// The same with another extra weight of a metre in reverse away from both ends.
    pub(super) fn with_far_reverse(self, far_reverse: f64) -> Self {
        Self { far_reverse, ..self }
    }

    /// What a level searches by: it may shun gear changes and long ways in reverse more than the path will be charged
    /// for.
    pub(super) fn searching(self, level: &Level) -> Self {
        let change = self.change + level.extra_change;
        Self { far_reverse: level.far_reverse, many_changes: 0.0, change, ..self }
    }

    /// Price of a gear change, metres.
    pub(super) fn change(&self) -> f64 {
        self.change
    }

    /// What so many gear changes of a path cost beside their price.
    pub(super) fn many_changes(&self, changes: u32) -> f64 {
        self.many_changes * f64::from(changes.saturating_sub(FEW_CHANGES))
    }

    /// True if places near obstacles cost more.
    pub(super) fn shuns_obstacles(&self) -> bool {
        self.obstacle != 0.0
    }

    /// True if the car drives this arc of the tree in reverse.
    fn in_reverse(&self, arc: &Arc) -> bool {
        (arc.length < 0.0) != self.mirrored
    }

    /// Cost of `arc` after `before`, obstacles aside.
    #[inline]
    pub(super) fn arc(&self, before: Motion, arc: &Arc) -> f64 {
        let backwards = arc.length < 0.0;
        let weight = if self.in_reverse(arc) { self.reverse } else { 1.0 };
        let changed = (before.gear > 0 && backwards) || (before.gear < 0 && !backwards);
        arc.length.abs() * (weight + self.steer * arc.curvature.abs() * self.radius)
            + if changed { self.change } else { 0.0 }
            + self.steer_change * (arc.curvature - before.curvature).abs() * self.radius
    }

    /// Cost of a word after `before`, obstacles aside.
    /// The words of an analytic expansion are compared by this, before any collision check.
    pub(super) fn word(&self, mut before: Motion, word: &Word) -> f64 {
        word.arcs(self.radius).fold(0.0, |cost, arc| {
            let cost = cost + self.arc(before, &arc);
            before = Motion::after(&arc);
            cost
        })
    }

    /// Cost of the places that a word from `from` leads through.
    pub(super) fn word_places(&self, checker: &CollisionChecker, from: Pose, word: &Word) -> f64 {
        if self.is_plain(checker, self.far_reverse, from, word.length(self.radius)) {
            return 0.0;
        }
        let mut pose = from;
        word.arcs(self.radius).fold(0.0, |cost, arc| {
            let cost = cost + self.places(checker, pose, &arc);
            pose = pose.advance(arc.curvature, arc.length);
            cost
        })
    }

    /// Cost of the places that `arc` from `from` leads through: near obstacles, in reverse away from both ends, and
    /// with the middle of the rear axle over cells whose weight is above 1.
    pub(super) fn places(&self, checker: &CollisionChecker, from: Pose, arc: &Arc) -> f64 {
        let reverse = self.in_reverse(arc);
        let far_reverse = if reverse { self.far_reverse } else { 0.0 };
        if self.is_plain(checker, far_reverse, from, arc.length.abs()) {
            return 0.0;
        }
        let steps = (arc.length.abs() / CLEARANCE_STEP).ceil().max(1.0);
        let part = arc.length / steps;
        let (mut near, mut painted, mut far) = (0.0, 0.0, 0.0);
        let mut last = from;
        for k in 1..=steps as u32 {
            let pose = from.advance(arc.curvature, part * f64::from(k));
            if self.obstacle != 0.0 {
                let room = checker.clearance(pose, self.obstacle_distance) / self.obstacle_distance;
                near += (1.0 - room).max(0.0) * (1.0 - room).max(0.0);
            }
            if far_reverse != 0.0 && !self.is_near_an_end(pose.point(), 0.0) {
                far += 1.0;
            }
            if let Some(paint) = checker.paint() {
                let chord = (pose.point() - last.point()).norm_squared().sqrt();
                painted += (paint.along(last.point(), pose.point()) - chord).max(0.0);
            }
            last = pose;
        }
        let weight = if reverse { self.reverse } else { 1.0 };
        (self.obstacle * near + far_reverse * far) * part.abs() + weight * painted
    }

    /// True if no place costs anything that is no farther than this from a pose, metres.
    fn is_plain(&self, checker: &CollisionChecker, far_reverse: f64, from: Pose, around: f64) -> bool {
        self.obstacle == 0.0
            && checker.paint().is_none()
            && (far_reverse == 0.0 || self.is_near_an_end(from.point(), around))
    }

    /// True if what is no farther than this from a place, metres, belongs to the manoeuvre at one of the ends.
    fn is_near_an_end(&self, place: Point, around: f64) -> bool {
        self.ends.iter().any(|&end| (place - end).norm_squared().sqrt() + around <= MANOEUVRE)
    }

    /// Cost of a whole path from `start`.
    /// What a report's cost is: every term, sampled afresh along the path as driven.
    pub(super) fn path(&self, checker: &CollisionChecker, start: Pose, arcs: &[Arc]) -> f64 {
        let (mut pose, mut before) = (start, Motion::default());
        let mut cost = self.many_changes(arcs::direction_changes(arcs));
        for arc in arcs {
            cost += self.arc(before, arc) + self.places(checker, pose, arc);
            before = Motion::after(arc);
            pose = pose.advance(arc.curvature, arc.length);
        }
        cost
    }
}
