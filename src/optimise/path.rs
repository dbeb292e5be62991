//! The path that is optimised: nodes, links between them, runs.
//!
//! Positions are metres relative to the start's place, headings are not wrapped: a car that turns twice around ends at
//! 4π more. A node's five numbers are in the order of [`segment`](super::segment).
//!
//! A gear change is two nodes at one place with a [`Link::Turn`] between them, so the wheel's angle may differ before
//! and after. The first guess replaces the jumps of the curvature by means over half a metre to either side, since a
//! Gauss–Newton step needs angles that the wheel can nearly follow. Runs that the time does not justify shrink in the
//! optimisation, and below 12 cm they are taken out, with the two gear changes at their ends.

use super::segment::{ANGLE, Node, STEP};
use crate::drive::Route;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::{Pose, math};
use crate::vehicle::Vehicle;

/// Distance of nodes in the first guess, metres, …
const SPACING: f64 = 0.2;
/// … least nodes of a run, and most of a path.
const FEWEST: f64 = 8.0;
const MOST: f64 = 400.0;
/// The first guess's curvature is a mean over so much to either side, metres.
const WINDOW: f64 = 0.5;

/// How one node leads to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Link {
    /// The car stands while the wheel turns.
    Turn,
    /// The car drives in a gear, ±1.
    Drive(f64),
}

/// Nodes from start to goal; `links[k]` leads from node k to node k + 1. A standstill, where the wheel may turn, comes
/// before, between and after the runs.
///
/// Invariants: one link fewer than nodes; a node before a turn has step 0. In a whole path the first and the last link
/// are turns.
#[derive(Debug, Clone)]
pub(super) struct Path {
    pub(super) nodes: Vec<Node>,
    pub(super) links: Vec<Link>,
}

/// A stretch in one gear: its first and its last node.
///
/// Indices of nodes; all links between them drive in this gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run {
    pub(super) first: usize,
    pub(super) last: usize,
    pub(super) gear: f64,
}

impl Path {
    /// Samples a route, relative to its start. The goal's heading is the one that the route turns to, not wrapped.
    ///
    /// The spacing grows with the length, so that a long route has a few hundred nodes as well.
    pub(super) fn new(vehicle: &Vehicle, route: &Route) -> Self {
        let spacing = SPACING.max(route.length() / (0.6 * MOST));
        let mut path = Self { nodes: Vec::new(), links: Vec::new() };
        let mut pose = Pose { x: 0.0, y: 0.0, ..route.pose(0.0) };
        let all = route.arcs();
        let mut first = 0;
        while first < all.len() {
            let gear = all[first].length.signum();
            let end = (first..all.len()).find(|&i| all[i].length.signum() != gear).unwrap_or(all.len());
            path.run(vehicle, &mut pose, &all[first..end], spacing);
            first = end;
        }
        let mut last = *path.nodes.last().unwrap_or(&[pose.x, pose.y, pose.heading, 0.0, 0.0]);
        if path.nodes.is_empty() {
            path.nodes.push(last);
        }
        path.links.push(Link::Turn);
        last[ANGLE] = 0.0;
        path.nodes.push(last);
        path
    }

    /// Adds a standstill and the nodes of a run.
    fn run(&mut self, vehicle: &Vehicle, pose: &mut Pose, run: &[Arc], spacing: f64) {
        let (length, gear) = (arcs::length(run), run[0].length.signum());
        if self.nodes.is_empty() {
            self.nodes.push([pose.x, pose.y, pose.heading, 0.0, 0.0]);
        }
        self.links.push(Link::Turn);
        let steps = (length / spacing).ceil().max(FEWEST);
        let step = length / steps;
        for k in 0..=steps as u32 {
            let s = (f64::from(k) * step).min(length);
            let here = along(*pose, run, s);
            let curvature = mean_curvature(run, s, WINDOW.min(length / 4.0));
            let angle = math::atan(vehicle.wheelbase * curvature);
            let last = f64::from(k) >= steps;
            self.nodes.push([here.x, here.y, here.heading, angle, if last { 0.0 } else { step }]);
            if !last {
                self.links.push(Link::Drive(gear));
            }
        }
        *pose = along(*pose, run, length);
    }

    /// The stretches in one gear.
    pub(super) fn runs(&self) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        let mut is_new = true;
        for (k, link) in self.links.iter().enumerate() {
            match *link {
                Link::Turn => is_new = true,
                Link::Drive(gear) if is_new => {
                    runs.push(Run { first: k, last: k + 1, gear });
                    is_new = false;
                }
                Link::Drive(_) => {
                    if let Some(run) = runs.last_mut() {
                        run.last = k + 1;
                    }
                }
            }
        }
        runs
    }

    /// Metres of a run.
    pub(super) fn length_of(&self, run: Run) -> f64 {
        self.nodes[run.first..run.last].iter().fold(0.0, |sum, node| sum + node[STEP])
    }

    /// Leaves out the shortest run that is shorter than `least` metres; the runs on both sides of it, which are in the
    /// same gear, become one. The only run stays.
    ///
    /// One run at a time: its neighbours become one longer run, which changes what is short. True if a run was left
    /// out.
    pub(super) fn drop_short(&mut self, least: f64) -> bool {
        let runs = self.runs();
        let lengths: Vec<f64> = runs.iter().map(|&run| self.length_of(run)).collect();
        let shortest = math::argmin(&lengths);
        if runs.len() < 2 || lengths[shortest] >= least {
            return false;
        }
        let Run { first, last, .. } = runs[shortest];
        let is_inner = shortest > 0 && shortest + 1 < runs.len();
        // The node before a run and the node after it stand still with it; of an inner run the neighbours' ends are
        // joined.
        if is_inner {
            let (before, after) = (self.nodes[first - 1], self.nodes[last + 1]);
            let mut joined = after;
            for k in 0..=ANGLE {
                joined[k] = f64::midpoint(before[k], after[k]);
            }
            self.nodes.splice(first - 1..=last + 1, [joined]);
            self.links.drain(first - 1..=last);
        } else if shortest == 0 {
            self.nodes.drain(first..=last);
            self.links.drain(first..=last);
        } else {
            self.nodes.drain(first..=last);
            self.links.drain(first - 1..last);
        }
        true
    }
}

/// The pose after `s` metres of a run; the heading is not wrapped.
fn along(start: Pose, run: &[Arc], s: f64) -> Pose {
    let (mut pose, mut left) = (start, s);
    for arc in run {
        let length = arc.length.abs().min(left);
        let signed = length * arc.length.signum();
        let heading = pose.heading + arc.curvature * signed;
        pose = Pose { heading, ..pose.advance(arc.curvature, signed) };
        left -= length;
        if left <= 0.0 {
            break;
        }
    }
    pose
}

/// The mean curvature of a run within `window` metres of a place, weighted by length; at the ends over the part that
/// there is.
fn mean_curvature(run: &[Arc], s: f64, window: f64) -> f64 {
    let (mut from, mut turned, mut length) = (0.0, 0.0, 0.0);
    for arc in run {
        let to = from + arc.length.abs();
        let part = (to.min(s + window) - from.max(s - window)).max(0.0);
        turned += arc.curvature * part;
        length += part;
        from = to;
    }
    if length > 0.0 { turned / length } else { run[0].curvature }
}
