//! Saving gear changes of a path: one move after another is made shorter, whatever the others cost, until one vanishes.
//!
//! In a tight slot a move less is hardly ever the next edge along which the cost falls: the others become longer first,
//! up to the obstacles. Once a move has vanished, its neighbours are one, and the path costs two gear changes less. It
//! need not be the move that was squeezed.

use super::descent::{Path, descend};
use super::lattices::Level;
use super::profile::FEW_CHANGES;
use super::question::Search;
use super::report::Report;
use super::shortcut::{self, KNOT_SPACINGS, Rules};
use crate::geometry::Pose;
use crate::geometry::arcs::{self, Arc};

/// Moves of a path that are squeezed, at most.
const MAX_SQUEEZED: u32 = 60;
/// The arc that changes most changes by so much at a time, metres.
const STEPS: [f64; 2] = [0.2, 0.05];

impl Search<'_> {
    /// The path of a report without the moves that can be squeezed out of it, one after another, with the checks of a
    /// level and a margin; nothing where none can.
    #[inline(never)]
    pub(super) fn squeeze(&self, level: Level, margin: f64, path: &Report) -> Option<Report> {
        if !self.config.shortcut {
            return None;
        }
        let (this, costs) = (self.arrived(&path.arcs), self.costs());
        let rules = Rules { checker: self.checker, costs: &costs, spacing: level.spacing, margin };
        let mut most = MAX_SQUEEZED;
        let mut arcs = squeeze(rules, self.start, &path.arcs, &mut most)?;
        loop {
            arcs = shortcut::shortcut(rules, self.start, arcs, &KNOT_SPACINGS[..1]);
            if arcs::direction_changes(&arcs) <= FEW_CHANGES {
                break;
            }
            let Some(better) = squeeze(rules, self.start, &arcs, &mut most) else { break };
            arcs = better;
        }
        let cost = costs.path(self.checker, self.start, &arcs);
        this.verified(&arcs, margin).then(|| Report { arcs, cost, margin, ..path.clone() })
    }
}

/// The first path from `start` to the same end that has fewer gear changes and costs less, free by the rules if `arcs`
/// is; nothing where no move can be squeezed out. At most `most` moves are tried, from which they are taken.
fn squeeze(rules: Rules, start: Pose, arcs: &[Arc], most: &mut u32) -> Option<Vec<Arc>> {
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
