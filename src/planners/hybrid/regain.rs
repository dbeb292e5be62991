//! Regaining a margin: a path that keeps less room than it should is moved away from obstacles until it keeps enough.
//!
//! With less margin a slot has more room, and a search finds a way with few gear changes there more often. That way
//! may do with less than it was given: so its margin is lent, and paid back here. Curvatures and gears stay, lengths
//! change, and the end stays where it is.
//!
//! A round asks at which places of the path the body is near an obstacle (`Contact`). Such a distance d changes with
//! the length of every arc before that place; to first order by g·Δ for changes Δ of the lengths. With the wanted
//! distance w, what each arc changes is the minimum of
//!
//! ```text
//! Σ max(0, w − d − g·Δ)² + λ|Δ|²,   where the end stays: C·Δ = 0
//! ```
//!
//! It is found by solving for the contacts that are too near, and again where others are then. A step is taken as far
//! as what the first order tells holds (a trust region), and Newton's method closes what the end misses.
//!
//! Arcs that are to vanish (`super::press`) add what is left of them, squared.
//!
//! A move of one arc can hardly give way. So each move first gets short arcs at its ends that turn the other way.
//! Those that are still short in the end are left out again.

mod near;

use core::ops::Range;

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::descent::{Column, Stand, column};
use super::lattices::{Effort, Level};
use super::level::MARGIN_TOLERANCE;
use super::question::Search;
use super::report::Report;
use super::shortcut::Rules;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::{Pose, math};
use near::{FAR, Near, Way};

/// Rounds for a margin.
const PACE: Pace = Pace { grace: 4, most: 18 };
/// Solutions in one round, at most.
const MAX_SOLUTIONS: u32 = 16;
/// No arc changes more in one round, metres.
pub(super) const LONGEST_STEP: f64 = 0.15;
/// Where steps must be shorter, nothing is gained any more, metres.
const SHORTEST_STEP: f64 = 0.001;
/// No arc becomes shorter than this, metres: it keeps its gear and may grow again.
const SHORT: f64 = 1e-10;
/// Arcs that are no longer than this in the end are left out, metres.
const NEGLIGIBLE: f64 = 0.001;
/// Weight of the changes, λ.
const DAMPING: f64 = 1e-3;
/// Weight of what is left of the arcs that are to vanish.
const PRESSURE: f64 = 0.02;
/// More than the margin that is aimed at, metres, …
const RESERVE: f64 = 0.0005;
/// … and less than it that is enough.
const LACK: f64 = 0.8 * MARGIN_TOLERANCE;
const MAX_NEWTON_STEPS: u32 = 8;
/// A path is closed if its end misses by less, metres and radians.
const CLOSED: f64 = 1e-9;

impl Search<'_> {
    /// Gives a path the margin that it should keep, with the checks of a level; tells whether it then keeps it.
    #[inline(never)]
    pub(super) fn regain(&self, level: Level, margin: f64, report: &mut Report) -> bool {
        let (this, costs) = (self.arrived(&report.arcs), self.costs());
        let rules = Rules { checker: self.checker, costs: &costs, spacing: level.spacing, margin };
        let Some(wide) = regain(rules, self.start, &report.arcs) else { return false };
        if !this.verified(&wide, margin) {
            return false;
        }
        let cheaper = this.straightened(&wide, Level { effort: Effort::Descent, ..level }, margin);
        let arcs = if this.verified(&cheaper, margin) { cheaper } else { wide };
        let cost = costs.path(self.checker, self.start, &arcs);
        (report.arcs, report.cost, report.margin) = (arcs, cost, margin);
        true
    }
}

/// A path from `start` to the same end that keeps the margin of the rules; nothing where this one cannot be moved so
/// far. It must overlap nothing.
fn regain(rules: Rules, start: Pose, arcs: &[Arc]) -> Option<Vec<Arc>> {
    Course { rules, start, goal: arcs::end(start, arcs), pressed: 0..0 }.regain(arcs.to_vec())
}

/// The arcs but for those that are short.
pub(super) fn without_short(arcs: Vec<Arc>) -> Vec<Arc> {
    arcs::merge(arcs.into_iter().filter(|arc| arc.length.abs() > NEGLIGIBLE))
}

/// The arcs with short ones at both ends of each move: on the other lock or, beside straight ones, on both.
pub(super) fn yielding(arcs: &[Arc], radius: f64) -> Vec<Arc> {
    let beside = |arc: &Arc| {
        let bends =
            if arc.curvature == 0.0 { vec![1.0 / radius, -1.0 / radius] } else { vec![-arc.curvature] };
        let length = SHORT.copysign(arc.length);
        bends.into_iter().map(|curvature| Arc { curvature, length }).collect::<Vec<_>>()
    };
    let moves = arcs.chunk_by(|one, next| one.length * next.length > 0.0);
    moves.flat_map(|arcs| [&beside(&arcs[0]), arcs, &beside(&arcs[arcs.len() - 1])].concat()).collect()
}

/// The poses before each arc and at the end.
fn stands(start: Pose, arcs: &[Arc]) -> Vec<Stand> {
    let ends = arcs.iter().scan(start, |at, arc| {
        *at = at.advance(arc.curvature, arc.length);
        Some(*at)
    });
    core::iter::once(start).chain(ends).map(Stand::at).collect()
}

/// How the end moves as each arc grows.
fn columns(arcs: &[Arc], stands: &[Stand]) -> Vec<Column> {
    let end = stands[arcs.len()].pose;
    arcs.iter().zip(&stands[1..]).map(|(arc, &at)| column(end, at, arc.curvature)).collect()
}

/// An arc with another length, but of the same gear.
fn lengthened(arc: &Arc, by: f64) -> Arc {
    let sign = 1.0_f64.copysign(arc.length);
    Arc { length: sign * f64::max(sign * (arc.length + by), SHORT), ..*arc }
}

/// How fast something must fall: after `grace` rounds evenly, to nothing after `most`. What falls more slowly hardly
/// ever gets there.
pub(super) struct Pace {
    pub(super) grace: u32,
    pub(super) most: u32,
}

impl Pace {
    /// The share that may be left after so many rounds.
    pub(super) fn share(&self, rounds: u32) -> f64 {
        f64::from(self.most.saturating_sub(rounds)) / f64::from(self.most - self.grace)
    }
}

/// What a path's contacts tell.
pub(super) struct Round {
    /// The least distance along the path, metres.
    least: f64,
    /// How much is missing: the sum over all arcs of what the nearest place lacks, squared.
    pub(super) missing: f64,
    /// By how much each arc should change, metres.
    changes: Vec<f64>,
}

/// What stays the same while a path changes.
pub(super) struct Course<'a> {
    pub(super) rules: Rules<'a>,
    pub(super) start: Pose,
    pub(super) goal: Pose,
    /// The arcs that are to vanish.
    pub(super) pressed: Range<usize>,
}

impl Course<'_> {
    /// A path moved away from obstacles until it keeps the margin, without arcs that are short then.
    pub(super) fn regain(&self, arcs: Vec<Arc>) -> Option<Vec<Arc>> {
        let wide = self.widen(yielding(&arcs::merge(arcs), self.rules.costs.radius))?;
        self.widen(without_short(wide))
    }

    /// A path moved away from obstacles until it keeps the margin.
    #[inline(never)]
    fn widen(&self, arcs: Vec<Arc>) -> Option<Vec<Arc>> {
        let mut path = self.close(arcs)?;
        let mut round = self.round(&path)?;
        let mut step = LONGEST_STEP;
        let whole = round.missing.sqrt();
        for rounds in 0..PACE.most {
            if self.is_wide(&round) {
                return Some(path);
            }
            if round.missing.sqrt() > PACE.share(rounds) * whole {
                break;
            }
            let is_better = |_: &[Arc], one: &Round, _: &[Arc], before: &Round| {
                one.missing < before.missing || self.is_wide(one)
            };
            self.advance((&mut path, &mut round), &mut step, is_better)?;
        }
        None
    }

    /// Takes a step, at most so long, if it is better; makes the next one longer then, or else shorter. Nothing where
    /// it would be too short.
    pub(super) fn advance(
        &self,
        (path, round): (&mut Vec<Arc>, &mut Round),
        step: &mut f64,
        is_better: impl Fn(&[Arc], &Round, &[Arc], &Round) -> bool,
    ) -> Option<()> {
        let most = round.changes.iter().fold(0.0, |most: f64, change| most.max(change.abs()));
        let share = (*step / most).min(1.0);
        let next = path.iter().zip(&round.changes).map(|(arc, change)| lengthened(arc, share * change));
        let next = self.close(next.collect()).and_then(|next| Some((self.round(&next)?, next)));
        match next {
            Some((one, next)) if is_better(&next, &one, path, round) => {
                (*round, *path, *step) = (one, next, (2.0 * *step).min(LONGEST_STEP));
                Some(())
            }
            _ => {
                *step = step.min(most) / 4.0;
                (*step >= SHORTEST_STEP).then_some(())
            }
        }
    }

    fn is_wide(&self, round: &Round) -> bool {
        round.least >= self.rules.margin - LACK
    }

    /// The arcs with lengths that lead to the goal, by the least changes; long arcs change most.
    #[inline(never)]
    pub(super) fn close(&self, mut arcs: Vec<Arc>) -> Option<Vec<Arc>> {
        for _ in 0..MAX_NEWTON_STEPS {
            let stands = stands(self.start, &arcs);
            let miss = self.miss(stands[arcs.len()].pose);
            if miss.iter().all(|miss| miss.abs() < CLOSED) {
                return Some(arcs);
            }
            let columns = columns(&arcs, &stands);
            let weight = |arc: &Arc| arc.length.abs().min(1.0);
            let mut normal = Matrix3::zeros();
            for (arc, column) in arcs.iter().zip(&columns) {
                let column = Vector3::from(*column);
                normal += weight(arc) * column * column.transpose();
            }
            let parts = normal.lu().solve(&Vector3::from(miss))?;
            for (arc, column) in arcs.iter_mut().zip(&columns) {
                *arc = lengthened(arc, weight(arc) * parts.dot(&Vector3::from(*column)));
            }
        }
        None
    }

    /// What an end misses of the goal.
    fn miss(&self, end: Pose) -> Column {
        let goal = self.goal;
        [goal.x - end.x, goal.y - end.y, math::turn(end.heading, goal.heading)]
    }

    /// What the contacts of a path tell; nothing where it overlaps something.
    #[inline(never)]
    pub(super) fn round(&self, arcs: &[Arc]) -> Option<Round> {
        let stands = stands(self.start, arcs);
        let (mut least, mut missing) = (FAR, 0.0);
        let mut near = Vec::new();
        let mut found = Vec::new();
        let way = Way { checker: self.rules.checker, margin: self.rules.margin, arcs, stands: &stands };
        for number in 0..arcs.len() {
            let nearest = way.contacts(number, (&mut near, &mut found))?;
            let lack = (self.wanted() - nearest).max(0.0);
            (least, missing) = (f64::min(least, nearest), missing + lack * lack);
        }
        let changes = self.changes(arcs, &stands, &near).unwrap_or_else(|| vec![0.0; arcs.len()]);
        Some(Round { least, missing, changes })
    }

    /// The distance that is aimed at.
    fn wanted(&self) -> f64 {
        self.rules.margin + RESERVE
    }

    /// By how much each arc should change for the contacts that are too near.
    fn changes(&self, arcs: &[Arc], stands: &[Stand], near: &[Near]) -> Option<Vec<f64>> {
        let count = arcs.len();
        let wanted = self.wanted();
        let mut matrix = DMatrix::zeros(count + 3, count + 3);
        let mut right = DVector::zeros(count + 3);
        for (n, column) in columns(arcs, stands).into_iter().enumerate() {
            matrix[(n, n)] = DAMPING;
            for (part, value) in column.into_iter().enumerate() {
                (matrix[(n, count + part)], matrix[(count + part, n)]) = (value, value);
            }
        }
        for (part, miss) in self.miss(stands[count].pose).into_iter().enumerate() {
            right[count + part] = miss;
        }
        let to_short = |n: usize| SHORT.copysign(arcs[n].length) - arcs[n].length;
        for n in self.pressed.clone() {
            matrix[(n, n)] += PRESSURE;
            right[n] = PRESSURE * to_short(n);
        }
        let mut is_too_near = vec![false; near.len()];
        // Arcs that cannot become any shorter.
        let mut is_short = vec![false; count];
        let mut changes = DVector::zeros(count + 3);
        for solutions in 0..MAX_SOLUTIONS {
            let mut is_settled = solutions > 0;
            for (Near { slopes, distance }, is_near) in near.iter().zip(&mut is_too_near) {
                let lack = wanted - distance;
                let is_now = slopes.dot(&changes.rows(0, slopes.len())) < lack;
                if *is_near != is_now {
                    (*is_near, is_settled) = (is_now, false);
                    let sign = if is_now { 1.0 } else { -1.0 };
                    let mut part = matrix.view_mut((0, 0), (slopes.len(), slopes.len()));
                    part.ger(sign, slopes, slopes, 1.0);
                    right.rows_mut(0, slopes.len()).axpy(sign * lack, slopes, 1.0);
                }
            }
            for (n, arc) in arcs.iter().enumerate() {
                let left = (arc.length + changes[n]) * 1.0_f64.copysign(arc.length);
                if !is_short[n] && left < SHORT / 2.0 {
                    (is_short[n], is_settled) = (true, false);
                }
            }
            if is_settled {
                break;
            }
            let (mut matrix, mut right) = (matrix.clone(), right.clone());
            for n in (0..count).filter(|&n| is_short[n]) {
                matrix.row_mut(n).fill(0.0);
                matrix[(n, n)] = 1.0;
                right[n] = to_short(n);
            }
            changes = matrix.lu().solve(&right)?;
        }
        Some(changes.as_slice()[..count].to_vec())
    }
}

#[cfg(test)]
mod tests;
