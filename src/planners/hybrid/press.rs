//! Saving gear changes of a path: a move is pressed out of it, while all others give way.
//!
//! In a tight slot one move less means that the others use the room in another way, each a little longer and by other
//! curves. Which ones and how, follows from what is near: as where a path regains its margin (`super::regain`), but
//! with arcs that are to vanish. Meanwhile the path may keep less margin than it should. Once the move is gone, its
//! neighbours are one, and the path regains its margin or is of no use.

use super::descent::move_of;
use super::lattices::{Effort, Level};
use super::profile::FEW_CHANGES;
use super::question::{MIN_MARGIN, Search};
use super::regain::{Course, LONGEST_STEP, Pace, Round, without_short, yielding};
use super::report::Report;
use super::shortcut::Rules;
use crate::geometry::Pose;
use crate::geometry::arcs::{self, Arc};

/// Of a path with n gear changes so many times 1/n moves are tried, as each costs more where there are more.
const MAX_WORK: usize = 100;
/// So many arcs change on either side of a move.
const NEAR: usize = 10;
/// A longer move is not tried: hardly any of these goes, metres.
const LONGEST: f64 = 4.0;
/// Rounds for one move.
const PACE: Pace = Pace { grace: 8, most: 24 };
/// A move with no more than this left is gone, metres.
const GONE: f64 = 0.005;
/// What is missing of the margin counts so many times as much as what is left of the move.
const MARGIN_WORTH: f64 = 500.0;
/// A round gains at least this, metres of the move.
const MIN_GAIN: f64 = 5e-4;

impl Search<'_> {
    /// The path of a report without the moves that can be pressed out of it, one after another, with the checks of a
    /// level and a margin; nothing where none can.
    #[inline(never)]
    pub(super) fn press(&self, level: Level, margin: f64, path: &Report) -> Option<Report> {
        if !self.config.shortcut {
            return None;
        }
        let (this, costs) = (self.arrived(&path.arcs), self.costs());
        let rules = Rules { checker: self.checker, costs: &costs, spacing: level.spacing, margin };
        let pressed = |arcs: &[Arc]| {
            let most = MAX_WORK / arcs::direction_changes(arcs).max(1) as usize;
            let press =
                |number| press(rules, self.start, arcs, number).filter(|arcs| this.verified(arcs, margin));
            numbers(arcs).into_iter().take(most).find_map(press)
        };
        let mut arcs = pressed(&path.arcs)?;
        while arcs::direction_changes(&arcs) > FEW_CHANGES
            && let Some(better) = pressed(&arcs)
        {
            arcs = better;
        }
        let cheaper = this.straightened(&arcs, Level { effort: Effort::Descent, ..level }, margin);
        let arcs = if this.verified(&cheaper, margin) { cheaper } else { arcs };
        let cost = costs.path(self.checker, self.start, &arcs);
        Some(Report { arcs, cost, margin, ..path.clone() })
    }
}

/// The numbers of the moves that may be pressed out, the shortest first.
fn numbers(arcs: &[Arc]) -> Vec<usize> {
    let moves = arcs.chunk_by(|one, next| one.length * next.length > 0.0).map(arcs::length);
    let mut moves: Vec<_> = moves.enumerate().filter(|(_, length)| *length <= LONGEST).collect();
    moves.sort_by(|(_, one), (_, next)| one.total_cmp(next));
    moves.into_iter().map(|(number, _)| number).collect()
}

/// A path from `start` to the same end without one of the moves, told by its number, that keeps the margin of the
/// rules; nothing where the others cannot give way. Only arcs near that move change.
fn press(rules: Rules, start: Pose, arcs: &[Arc], number: usize) -> Option<Vec<Arc>> {
    let arcs = arcs::merge(arcs.to_vec());
    let pressed = move_of(&arcs, number);
    if pressed.is_empty() {
        return None;
    }
    let near = pressed.start.saturating_sub(NEAR)..(pressed.end + NEAR).min(arcs.len());
    let (before, after) = (&arcs[..near.start], &arcs[near.end..]);
    let moves_before = arcs::direction_changes(&arcs[..=near.start]) as usize;
    let pressed = press_among(rules, arcs::end(start, before), &arcs[near.clone()], number - moves_before)?;
    Some(arcs::merge([before, &pressed, after].concat()))
}

/// The same for arcs all of which may change.
fn press_among(rules: Rules, start: Pose, arcs: &[Arc], number: usize) -> Option<Vec<Arc>> {
    let goal = arcs::end(start, arcs);
    let arcs = yielding(arcs, rules.costs.radius);
    let pressed = move_of(&arcs, number);
    let least = Rules { margin: rules.margin.min(MIN_MARGIN), ..rules };
    let course = Course { rules: least, start, goal, pressed: pressed.clone() };
    let left = |path: &[Arc]| arcs::length(&path[pressed.clone()]);
    let worth = |path: &[Arc], round: &Round| left(path) + MARGIN_WORTH * round.missing.sqrt();
    let is_better = |next: &[Arc], one: &Round, path: &[Arc], round: &Round| {
        worth(next, one) < worth(path, round) - MIN_GAIN
    };
    let mut path = course.close(arcs)?;
    let mut round = course.round(&path)?;
    let mut step = LONGEST_STEP;
    let whole = worth(&path, &round);
    let mut rounds = 0;
    while left(&path) > GONE {
        rounds += 1;
        if worth(&path, &round) > PACE.share(rounds) * whole {
            return None;
        }
        course.advance((&mut path, &mut round), &mut step, is_better)?;
    }
    path.drain(pressed.clone());
    let course = Course { rules, start, goal, pressed: 0..0 };
    course.regain(course.close(without_short(path))?)
}

#[cfg(test)]
mod tests;
