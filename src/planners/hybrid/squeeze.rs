//! Saving gear changes of a path: one move after another is made shorter, whatever the others cost, until one vanishes.
//!
//! In a tight slot a move less is hardly ever the next edge along which the cost falls: the others become longer first,
//! up to the obstacles. Once a move has vanished, its neighbours are one, and the path costs two gear changes less. It
//! need not be the move that was squeezed.

use super::descent::{Path, descend};
use super::shortcut::Rules;
use crate::geometry::Pose;
use crate::geometry::arcs::{self, Arc};

/// The arc that changes most changes by so much at a time, metres.
const STEPS: [f64; 2] = [0.2, 0.05];

/// The first path from `start` to the same end that has fewer gear changes and costs less, free by the rules if `arcs`
/// is; nothing where no move can be squeezed out. At most `most` moves are tried, from which they are taken.
pub(super) fn squeeze(rules: Rules, start: Pose, arcs: &[Arc], most: &mut u32) -> Option<Vec<Arc>> {
    let cost = |path: &[Arc]| rules.costs.path(rules.checker, start, path);
    let (known, changes) = (cost(arcs), arcs::direction_changes(arcs));
    let is_fewer = |path: &[Arc]| arcs::direction_changes(path) < changes;
    (0..=changes as usize).find_map(|number| {
        *most = most.checked_sub(1)?;
        let mut path = Path::new(rules, start, arcs::merge(arcs.to_vec()), Some(number));
        let better = path.improve(&STEPS, is_fewer).then(|| descend(rules, start, path.arcs))?;
        (is_fewer(&better) && cost(&better) < known).then_some(better)
    })
}

#[cfg(test)]
mod tests;
