//! A path made cheaper without another search: curves between its knots, other lengths of its arcs, longer moves.
//!
//! The shortcut replaces stretches of what a lattice led through; the descent moves what lies between; longer moves
//! leave some out. Each opens ways for the others, so they follow in rounds until one gains little. A path with fewer
//! than two gear changes is left to the shortcut: there is little to move, and so both modules plan every built-in
//! scene alike.

use super::lattices::Effort;
use super::profile::FEW_CHANGES;
use super::shortcut::{self, KNOT_SPACINGS, Rules};
use super::{descent, longer_moves};
use crate::IS_COMPLETE;
use crate::geometry::Pose;
use crate::geometry::arcs::{self, Arc};

/// A path that a round makes no cheaper than by this factor is left at that, …
const SETTLED: f64 = 0.99;
/// … and any after so many rounds.
const MAX_ROUNDS: u32 = 4;

/// A path of arcs from `start`, made cheaper. Gear changes never increase.
///
/// Start and end pose stay as they are to rounding, and the cost never rises. `path` must be free by the same rules;
/// what is not replaced is not checked again. The small module has the shortcut only.
pub(super) fn improved(rules: Rules, start: Pose, path: Vec<Arc>, effort: Effort) -> Vec<Arc> {
    let mut path = shortcut::shortcut(rules, start, path, &KNOT_SPACINGS);
    if !IS_COMPLETE || effort == Effort::Shortcut || arcs::direction_changes(&path) < FEW_CHANGES {
        return path;
    }
    let cost = |path: &[Arc]| rules.costs.path(rules.checker, start, path);
    let mut before = cost(&path);
    for _ in 0..MAX_ROUNDS {
        path = longer_moves::lengthen(rules, start, descent::descend(rules, start, path));
        let after = cost(&path);
        if after > SETTLED * before {
            break;
        }
        path = shortcut::shortcut(rules, start, path, &KNOT_SPACINGS[..1]);
        before = after;
    }
    path
}
