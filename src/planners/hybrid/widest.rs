//! The widest path to one of several goals: which margins are tried, and which goals have the most room.
//!
//! The width of a path is the least clearance of the body along it, metres. A path with margin m is also one with any
//! smaller margin, so the largest m is found with few searches: by a list of margins, and by halving the gap between
//! the smallest that fails and the largest that succeeds.
//!
//! With several goals, no path is wider than the room at the goal where it ends. Goals with less room than the best
//! path so far has are therefore not searched.

use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::vehicle::collision::CollisionChecker;

/// Margins that are tried for more room, as shares of the room at the ends.
pub(super) const MARGIN_SHARES: [f64; 5] = [0.95, 0.8, 0.65, 0.5, 0.35];
/// More room than this is room enough where a path may lead to one of several goals, metres. Some of them may lie in
/// the open.
const ENOUGH_CLEARANCE_AMONG_GOALS: f64 = 3.0;
/// Of margins for several goals, those closer than this share to a larger one are left out …
const MARGIN_STEP: f64 = 0.12;
/// … and the gap above the largest one with a path is halved until it is a quarter.
pub(super) const GAP_PARTS: usize = 4;
/// Spacing of the places at which a path's clearance is measured, metres.
const CLEARANCE_SPACING: f64 = 0.1;
/// The most goals that are searched from one by one.
const MAX_GOALS_ONE_BY_ONE: usize = 8;

/// Margins for the widest path to one of some goals, largest first: shares of the room at each, which counts up to the
/// room at the start. All are more than `least`. Between two of them are more, by which the gap is halved.
pub(super) fn margins(checker: &CollisionChecker, start: Pose, goals: &[Pose], least: f64) -> Vec<f64> {
    let at_start = checker.clearance(start, ENOUGH_CLEARANCE_AMONG_GOALS);
    let rooms = goals.iter().map(|&goal| checker.clearance(goal, ENOUGH_CLEARANCE_AMONG_GOALS).min(at_start));
    let mut shares: Vec<f64> = rooms.flat_map(|room| MARGIN_SHARES.map(|share| share * room)).collect();
    shares.retain(|&margin| margin > least);
    shares.sort_by(|a, b| b.total_cmp(a));
    let mut margins: Vec<f64> = Vec::new();
    for margin in shares {
        match margins.last() {
            Some(&above) if margin > above * (1.0 - MARGIN_STEP) => {}
            Some(&above) => {
                let part = (above - margin) / GAP_PARTS as f64;
                margins.extend((1..=GAP_PARTS).map(|k| above - part * k as f64));
            }
            None => margins.push(margin),
        }
    }
    margins
}

/// The least distance from the body to an obstacle along a path, metres; three at most.
/// Sampled every 10 cm; the distances themselves are exact.
pub(super) fn clearance(checker: &CollisionChecker, start: Pose, path: &[Arc]) -> f64 {
    let mut pose = start;
    let mut least = checker.clearance(start, ENOUGH_CLEARANCE_AMONG_GOALS);
    for arc in path {
        let steps = (arc.length.abs() / CLEARANCE_SPACING).ceil().max(1.0);
        for k in 1..=steps as u32 {
            let at = pose.advance(arc.curvature, arc.length * f64::from(k) / steps);
            least = least.min(checker.clearance(at, least));
        }
        pose = pose.advance(arc.curvature, arc.length);
    }
    least
}

/// The room at the goals that have the most, no more than at the start, largest first, each with the goal's number.
pub(super) fn by_room(checker: &CollisionChecker, start: Pose, goals: &[Pose]) -> Vec<(f64, usize)> {
    let at_start = checker.clearance(start, ENOUGH_CLEARANCE_AMONG_GOALS);
    let rooms = goals.iter().map(|&goal| checker.clearance(goal, ENOUGH_CLEARANCE_AMONG_GOALS).min(at_start));
    let mut rooms: Vec<(f64, usize)> = rooms.zip(0..).collect();
    rooms.sort_by(|a, b| b.0.total_cmp(&a.0));
    rooms.truncate(MAX_GOALS_ONE_BY_ONE);
    rooms
}
