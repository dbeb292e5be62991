//! Data computed once per round: the samples of the body with their obstacles, and the speeds of the runs.
//!
//! Within a round these are constants, so that the cost is one smooth function of the path and a step can be judged by
//! it. Between rounds they are renewed, because the path has moved. The time of a run from rest to rest over the length
//! s is
//!
//! ```text
//! T(s) = √(2s·(1/a + 1/b))                 where the largest speed is not reached
//! T(s) = s/v + v/2·(1/a + 1/b)             where it is
//! ```
//!
//! and only its slope dT/ds enters: shortening a short run saves more time per metre than shortening a long one. That
//! is what makes needless runs vanish.

use super::features::Features;
use super::path::{Link, Path};
use super::segment::{Node, STEP};
use crate::referee::MotionLimits;
use crate::vehicle::Vehicle;

/// Features that are nearer than this are looked up, metres.
const NEAR: f64 = 0.9;
/// Between two nodes the body is looked at where something is nearer than this and two steps.
const BESIDE: f64 = 0.1;
/// A corner of the body moves at most so much farther than the rear axle.
const SWING: f64 = 1.4;
/// No run costs more time a metre than one of this length, metres.
const SHORTEST: f64 = 0.05;

/// The car and what it can do.
///
/// Radians, and radians per second; the limits are the caller's.
pub(super) struct Car<'a> {
    pub(super) vehicle: &'a Vehicle,
    pub(super) limits: &'a MotionLimits,
    /// Largest steering angle and rate in the plan, not more than the car's.
    pub(super) max_angle: f64,
    pub(super) max_rate: f64,
}

/// The task of the path stage.
pub(super) struct Task<'a> {
    pub(super) car: Car<'a>,
    pub(super) features: &'a Features,
    /// Kept from obstacles, metres.
    pub(super) margin: f64,
    /// True if no run may vanish, or become shorter than half of what it was.
    pub(super) keeps_runs: bool,
}

/// A place where the body is held against obstacles: a share of the way from a node to the next.
///
/// The features are those near the node; the sample is at most a step away.
pub(super) struct Sample {
    pub(super) node: usize,
    pub(super) share: f64,
    pub(super) features: Vec<u32>,
}

impl Sample {
    /// The car there: the way between two nodes is so short that it is straight.
    pub(super) fn car(&self, path: &Path) -> Node {
        let (from, to) = (&path.nodes[self.node], &path.nodes[self.node + 1]);
        let mut car = *from;
        for i in 0..3 {
            car[i] += self.share * (to[i] - from[i]);
        }
        car
    }
}

/// Data computed once per round.
pub(super) struct Round {
    pub(super) samples: Vec<Sample>,
    /// Largest speed on each link if only the run's length mattered, m/s.
    pub(super) speeds: Vec<f64>,
    /// Extra time per extra metre of each run, s/m.
    pub(super) time_slopes: Vec<f64>,
    /// Steps from the nodes, at least a centimetre.
    pub(super) steps: Vec<f64>,
}

impl Round {
    /// Takes one look-up of features per node. Speeds are those of a run from rest to rest without a wheel: the upper
    /// bound that the wheel's time is compared with.
    pub(super) fn new(task: &Task, path: &Path) -> Self {
        let n = path.nodes.len();
        let samples = samples(task, path);
        let (mut speeds, mut time_slopes) = (vec![0.0; n], vec![0.0; n]);
        let limits = task.car.limits;
        for run in path.runs() {
            let length = path.length_of(run);
            let slope = time_slope(limits, length);
            let mut s = 0.0;
            for k in run.first..run.last {
                let to = s + path.nodes[k][STEP];
                let up = 2.0 * limits.acceleration * to.max(1e-3);
                let down = 2.0 * limits.deceleration * (length - s).max(1e-3);
                s = to;
                speeds[k] = up.min(down).sqrt().min(limits.speed);
                time_slopes[k] = slope;
            }
        }
        Self {
            samples,
            speeds,
            time_slopes,
            steps: path.nodes.iter().map(|node| node[STEP].max(0.01)).collect(),
        }
    }
}

/// Extra time per extra metre of a run from rest to rest, s/m.
///
/// Bounded by that of a run of [`SHORTEST`] metres, since the slope of a root is infinite at 0.
fn time_slope(limits: &MotionLimits, length: f64) -> f64 {
    let inverse = 1.0 / limits.acceleration + 1.0 / limits.deceleration;
    let is_long = length >= limits.speed * limits.speed / 2.0 * inverse;
    if is_long { 1.0 / limits.speed } else { (inverse / 2.0 / length.max(SHORTEST)).sqrt() }
}

/// Samples of the body for the distances to obstacles: at nodes and, near obstacles, between them so densely that no
/// corner slips through.
///
/// A corner moves by up to 1.4 times the step; samples are so close that it moves by no more than the margin (2 to 6
/// cm) between two.
fn samples(task: &Task, path: &Path) -> Vec<Sample> {
    let (mut samples, mut near) = (Vec::new(), Vec::new());
    // Start and goal are where they are.
    for k in 1..path.nodes.len() - 1 {
        let node = &path.nodes[k];
        task.features.near(node, NEAR, &mut near);
        if near.is_empty() || path.links[k] == Link::Turn {
            continue;
        }
        let mut least = NEAR;
        task.features.distances(node, &near, NEAR, &mut |d| least = least.min(d.value));
        let is_near = least < task.margin + 2.0 * node[STEP] + BESIDE;
        let parts =
            if is_near { (node[STEP] * SWING / task.margin.clamp(0.02, 0.06)).ceil().max(1.0) } else { 1.0 };
        for part in 0..parts as u32 {
            let share = f64::from(part) / parts;
            if k > 1 || share > 0.0 {
                samples.push(Sample { node: k, share, features: near.clone() });
            }
        }
    }
    samples
}
