//! What driving costs.

use super::Config;
use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::geometry::reeds_shepp::Word;
use crate::vehicle::collision::Probe;

/// Places are looked at this often along an arc, metres.
const CLEARANCE_STEP: f64 = 0.5;

/// The cost model of one plan.
#[derive(Debug, Clone, Copy)]
pub(super) struct CostModel {
    pub(super) radius: f64,
    forward: f64,
    reverse: f64,
    change: f64,
    steer: f64,
    steer_change: f64,
    obstacle: f64,
    obstacle_distance: f64,
}

/// How the car came to a pose: gear (0 at the root) and curvature.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Motion {
    pub(super) gear: i8,
    pub(super) curvature: f64,
}

impl Motion {
    pub(super) fn after(arc: &Arc) -> Self {
        Self { gear: if arc.length < 0.0 { -1 } else { 1 }, curvature: arc.curvature }
    }
}

impl CostModel {
    /// Costs of arcs as driven from start to goal.
    pub(super) fn driven(config: &Config, radius: f64) -> Self {
        let config = config.with_profile();
        Self {
            radius,
            forward: 1.0,
            reverse: config.reverse_cost,
            change: config.direction_change_cost,
            steer: config.steer_cost,
            steer_change: config.steer_change_cost,
            obstacle: config.obstacle_cost,
            obstacle_distance: config.obstacle_distance,
        }
    }

    /// Costs of the same arcs in a tree that grows from the goal, where every gear is the other one.
    pub(super) fn mirrored(self) -> Self {
        Self { forward: self.reverse, reverse: self.forward, ..self }
    }

    /// Cost of `arc` after `before`, obstacles aside.
    pub(super) fn arc(&self, before: Motion, arc: &Arc) -> f64 {
        let length = arc.length.abs();
        let reverse = arc.length < 0.0;
        let weight = if reverse { self.reverse } else { self.forward };
        let changed = (before.gear > 0 && reverse) || (before.gear < 0 && !reverse);
        length * (weight + self.steer * arc.curvature.abs() * self.radius)
            + if changed { self.change } else { 0.0 }
            + self.steer_change * (arc.curvature - before.curvature).abs() * self.radius
    }

    /// Cost of a word after `before`, obstacles aside.
    pub(super) fn word(&self, mut before: Motion, word: &Word) -> f64 {
        word.arcs(self.radius).fold(0.0, |cost, arc| {
            let cost = cost + self.arc(before, &arc);
            before = Motion::after(&arc);
            cost
        })
    }

    /// What a word from `from` costs for where it leads.
    pub(super) fn word_places(&self, probe: &Probe, from: Pose, word: &Word) -> f64 {
        if !self.minds_places(probe) {
            return 0.0;
        }
        let mut pose = from;
        word.arcs(self.radius).fold(0.0, |cost, arc| {
            let cost = cost + self.places(probe, pose, &arc);
            pose = pose.advance(arc.curvature, arc.length);
            cost
        })
    }

    fn minds_places(&self, probe: &Probe) -> bool {
        self.obstacle != 0.0 || probe.paint().is_some()
    }

    /// What `arc` from `from` costs for where it leads: near obstacles, and with the middle of the rear axle over cells
    /// whose weight is above 1.
    pub(super) fn places(&self, probe: &Probe, from: Pose, arc: &Arc) -> f64 {
        if !self.minds_places(probe) {
            return 0.0;
        }
        let steps = (arc.length.abs() / CLEARANCE_STEP).ceil().max(1.0);
        let part = arc.length / steps;
        let (mut near, mut painted) = (0.0, 0.0);
        let mut last = from;
        for k in 1..=steps as u32 {
            let pose = from.advance(arc.curvature, part * f64::from(k));
            if self.obstacle != 0.0 {
                let room = probe.clearance(pose, self.obstacle_distance) / self.obstacle_distance;
                near += (1.0 - room).max(0.0) * (1.0 - room).max(0.0);
            }
            if let Some(paint) = probe.paint() {
                let chord = (pose.point() - last.point()).norm();
                painted += (paint.along(last.point(), pose.point()) - chord).max(0.0);
            }
            last = pose;
        }
        let gear = if arc.length < 0.0 { self.reverse } else { self.forward };
        self.obstacle * near * part.abs() + gear * painted
    }

    /// Cost of a whole path from `start`, coming in with `before`.
    pub(super) fn path(&self, probe: &Probe, start: Pose, mut before: Motion, arcs: &[Arc]) -> f64 {
        let mut pose = start;
        let mut cost = 0.0;
        for arc in arcs {
            cost += self.arc(before, arc) + self.places(probe, pose, arc);
            before = Motion::after(arc);
            pose = pose.advance(arc.curvature, arc.length);
        }
        cost
    }
}
