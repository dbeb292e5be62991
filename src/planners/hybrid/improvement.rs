//! A path made cheaper without another search: curves between its knots, and other lengths of its arcs.
//!
//! The shortcut replaces stretches of what a lattice led through; the descent moves what lies between. Each opens ways
//! for the other, so where the descent has gained much, both are tried once more. A path with fewer than two gear
//! changes is left to the shortcut: there is little to move, and so both modules plan every built-in scene alike.

use super::descent;
use super::profile::FEW_CHANGES;
use super::shortcut::{self, KNOT_SPACINGS, Rules};
use crate::IS_COMPLETE;
use crate::geometry::Pose;
use crate::geometry::arcs::{self, Arc};

/// A path that the descent makes no cheaper than by this factor is left at that.
const SETTLED: f64 = 0.99;

/// A path of arcs from `start`, made cheaper. Gear changes never increase.
///
/// Start and end pose stay as they are to rounding, and the cost never rises. `path` must be free by the same rules;
/// what is not replaced is not checked again. Without the descent a path stays as far from obstacles as its curves
/// lead. The small module has none.
pub(super) fn improved(rules: Rules, start: Pose, path: Vec<Arc>, descends: bool) -> Vec<Arc> {
    let path = shortcut::shortcut(rules, start, path, &KNOT_SPACINGS);
    if !IS_COMPLETE || !descends || arcs::direction_changes(&path) < FEW_CHANGES {
        return path;
    }
    let cost = |path: &[Arc]| rules.costs.path(rules.checker, start, path);
    let before = cost(&path);
    let path = descent::descend(rules, start, path);
    if cost(&path) > SETTLED * before {
        return path;
    }
    let path = shortcut::shortcut(rules, start, path, &KNOT_SPACINGS[..1]);
    descent::descend(rules, start, path)
}
