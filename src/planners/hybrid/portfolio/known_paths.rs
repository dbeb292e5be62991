//! The paths that members have found: the one with the largest margin, and the easiest with less.
//!
//! Margin costs gear changes: with 10 cm a car may rock ten times where 3 cm let it in with four. So a path with less
//! margin, though no less than is comfortable, is the better answer where it saves enough of them. A search for more
//! margin leaves out what would take too many to be that answer.

use super::members::{COMFORTABLE_MARGIN, MANY_CHANGES};
use crate::IS_COMPLETE;
use crate::geometry::arcs;
use crate::planners::hybrid::report::Report;

/// More margin than this is roomy, metres. Any other is given up for one gear change: more room is not to mean more
/// changes.
const ROOMY_MARGIN: f64 = 0.05;
/// A path must save so many gear changes, where there are few, to be worth a roomy margin.
const ROOMY_MARGIN_WORTH: u32 = 2;
/// The shortcut may save so many of a path with more margin.
const SAVED_BY_SHORTCUT: u32 = 2;

/// The paths found so far.
#[derive(Default)]
pub(super) struct KnownPaths {
    /// The one with the largest margin.
    widest: Option<Report>,
    /// One with less, but no less than is comfortable, and of those the one with the fewest gear changes. The small
    /// module keeps none.
    easiest: Option<Report>,
}

impl KnownPaths {
    /// True before anything was found.
    pub(super) fn is_empty(&self) -> bool {
        self.widest.is_none()
    }

    /// Keeps a path that has more margin than the widest or, with the same, costs less, and the easiest of the others.
    pub(super) fn offer(&mut self, path: Report) {
        let is_wider = |widest: &Report| path.margin > widest.margin || path.cost < widest.cost;
        let is_widest = self.widest.as_ref().is_none_or(is_wider);
        if !IS_COMPLETE {
            if is_widest {
                self.widest = Some(path);
            }
            return;
        }
        let other = if is_widest { self.widest.replace(path) } else { Some(path) };
        let comfortable = other.filter(|other| other.margin >= COMFORTABLE_MARGIN);
        if let Some(other) = comfortable
            && self.easiest.as_ref().is_none_or(|easiest| is_easier(&other, easiest))
        {
            self.easiest = Some(other);
        }
    }

    /// The most gear changes, before the shortcut, of a path with a margin that would be the answer in place of those
    /// with less; nothing where none with less is comfortable.
    pub(super) fn most_changes(&self, margin: f64) -> Option<u32> {
        let known = [&self.widest, &self.easiest].into_iter().flatten();
        let comfortable = known.filter(|known| (COMFORTABLE_MARGIN..margin).contains(&known.margin));
        let fewest = comfortable.map(changes).min()?;
        let few = fewest + worth(margin) - 1;
        Some(fewest.max(few.min(MANY_CHANGES)) + SAVED_BY_SHORTCUT)
    }

    /// The better answer.
    pub(super) fn take_better(&mut self) -> Option<Report> {
        if IS_COMPLETE
            && let (Some(widest), Some(easiest)) = (&self.widest, &self.easiest)
            && gives_up_margin(widest, easiest)
        {
            return self.easiest.take();
        }
        self.widest.take()
    }

    /// The better one of those that were not taken.
    pub(super) fn next_best(&self) -> Option<&Report> {
        self.widest.as_ref().or(self.easiest.as_ref())
    }
}

/// How many gear changes a path with the comfortable margin must save to be better than one with as much or more.
pub(super) fn changes_to_save(path: &Report) -> u32 {
    if changes(path) <= MANY_CHANGES { worth(path.margin) } else { 1 }
}

/// How many gear changes a path must save that gives up a margin, where there are few.
fn worth(margin: f64) -> u32 {
    if margin > ROOMY_MARGIN { ROOMY_MARGIN_WORTH } else { 1 }
}

/// True if a path with less margin is the better answer.
fn gives_up_margin(widest: &Report, easiest: &Report) -> bool {
    easiest.margin < widest.margin
        && changes(easiest) + changes_to_save(widest) <= changes(widest)
        && easiest.cost < widest.cost
}

/// True if a path has fewer gear changes than another or, with as many, more margin or a lower cost.
fn is_easier(path: &Report, other: &Report) -> bool {
    match changes(path).cmp(&changes(other)) {
        core::cmp::Ordering::Equal if path.margin == other.margin => path.cost < other.cost,
        core::cmp::Ordering::Equal => path.margin > other.margin,
        order => order.is_lt(),
    }
}

fn changes(path: &Report) -> u32 {
    arcs::direction_changes(&path.arcs)
}

#[cfg(test)]
mod tests;
