//! Scouts: short guided searches, sent ahead where the levels have spent some work in vain.
//!
//! Where a wide region lies before the car, the levels may go through it for long, while a coarse search of the poses
//! shows the way at once: most such ways are found in a few thousand expansions, or not by any search of the levels.
//! So two scouts go first, one from either end.
//!
//! They also tell where more work is vain. If the coarse search of the poses gets from neither end to the other, though
//! both lie in wide regions, there is hardly a way: hardly any other search has ever found one. An end in a slot says
//! less: a coarse search does not get out of every slot that a fine one leaves.

use super::members::{From, Member, Style, plain};
use super::turns::{SCOUTED_EXPANSIONS, Turn, Turns};
use crate::IS_COMPLETE;
use crate::planners::hybrid::config::Heuristic;
use crate::planners::hybrid::pose_heuristic::PoseHeuristic;
use crate::planners::hybrid::question::Work;
use crate::planners::hybrid::report::Report;

/// They go after so many expansions without a path, …
const SENT_AFTER: u32 = 25_000;
/// … with so many each.
const SCOUT_EXPANSIONS: u32 = 6000;
/// A region with more states of the coarse search is no slot.
const WIDE_REGION: usize = 15_000;

impl Turns<'_> {
    /// True if it is time for scouts: much was spent, and nothing was found or proven.
    pub(super) fn may_scout(&self, report: &Report) -> bool {
        IS_COMPLETE
            && !self.is_scouted
            && self.is_undecided()
            && self.search.config.heuristic == Heuristic::Max
            && report.stats.expanded >= SENT_AFTER
    }

    /// Sends the scouts. False if more work is vain: the ends are apart for a coarse search, or for the body even if it
    /// moved in any direction. Whoever asks for a budget gets it spent.
    pub(super) fn scout(&mut self, work: &mut Work) -> bool {
        self.is_scouted = true;
        let may_end = self.search.config.max_expansions.is_none();
        let guided = |from| Member { from, style: Style::Guided, ..plain(1, self.least()) };
        let [hard, far] = [guided(From::Hard), guided(From::Far)];
        for scout in [hard, far].into_iter().take(1 + usize::from(self.may_swap)) {
            if let Turn::Found = self.search(scout, SCOUT_EXPANSIONS, work) {
                self.found_by_scout(scout, work.report);
                return true;
            }
            if may_end && scout == hard && self.are_apart(hard, far) {
                work.report.are_apart = true;
                break;
            }
        }
        if may_end {
            self.effort = self.effort.min(SCOUTED_EXPANSIONS);
        }
        !self.is_hopeless(work) && !work.report.are_apart
    }

    /// True if the coarse search for one scout has ended in a wide region without its root, and the root lies in
    /// another wide one.
    fn are_apart(&self, hard: Member, far: Member) -> bool {
        let is_wide = |poses: &PoseHeuristic| poses.states() > WIDE_REGION;
        let own = self.poses[usize::from(self.is_swapped(hard))].get();
        own.is_some_and(|poses| poses.is_closed() && is_wide(poses))
            && is_wide(&self.pose_heuristic(far, WIDE_REGION + 1))
    }
}
