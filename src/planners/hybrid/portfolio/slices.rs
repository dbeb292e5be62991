//! One slice of a member: what it searches, and how that ended.

use super::members::{From, Member, Style};
use super::turns::{Turn, Turns};
use crate::IS_COMPLETE;
use crate::planners::hybrid::lattices::Level;
use crate::planners::hybrid::pose_heuristic::{MAX_STATES, PoseHeuristic};
use crate::planners::hybrid::question::{Search, Work};
use crate::planners::hybrid::report::Status;

impl<'a> Turns<'a> {
    /// One slice of a member; the answer is in `work.report`.
    pub(super) fn search(&self, member: Member, slice: u32, work: &mut Work) -> Turn {
        let search = self.question(member);
        (work.report.margin, work.report.level) = (self.floods.margin(member.margin), member.level);
        work.report.status = Status::NoPath;
        if search.flood.distance(search.root).is_infinite() {
            return Turn::Exhausted;
        }
        let level = member.level(search.config, self.is_least(member));
        let most = if IS_COMPLETE { self.known.most_changes(work.report.margin) } else { None };
        let level = most.map_or(level, |most| level.with_changes(most));
        let is_guided = IS_COMPLETE && member.style == Style::Guided;
        let search = if is_guided { self.guided(search, member) } else { search };
        let is_last = slice >= level.max_expansions;
        if search.level(Level { max_expansions: slice.min(level.max_expansions), ..level }, work) {
            return Turn::Found;
        }
        match work.report.status {
            Status::NoPath => Turn::Exhausted,
            Status::BudgetExhausted(_) if !is_last => Turn::Spent,
            _ => Turn::Lost,
        }
    }

    /// The question as a member searches it.
    fn question(&self, member: Member) -> Search<'a> {
        let is_swapped = self.is_swapped(member);
        let flood = self.floods.get(member.margin, is_swapped);
        if is_swapped { self.search.swapped(flood) } else { Search { flood, ..self.search } }
    }

    /// True if a member's tree grows from the target of the question.
    pub(super) fn is_swapped(&self, member: Member) -> bool {
        self.is_swapped != (member.from == From::Far)
    }

    /// The same search, guided by the costs from poses to its target. These are made with the least margin, once for
    /// each end: a little more margin hardly changes where the car must turn.
    fn guided<'b>(&'b self, search: Search<'b>, member: Member) -> Search<'b> {
        let poses = &self.poses[usize::from(self.is_swapped(member))];
        Search { poses: Some(poses.get_or_init(|| self.pose_heuristic(member, MAX_STATES))), ..search }
    }

    /// The costs from poses to the target of a guided member, from so many states.
    pub(super) fn pose_heuristic(&self, member: Member, most: usize) -> PoseHeuristic {
        let search = self.question(member);
        let to_root = self.floods.get(self.least(), !self.is_swapped(member));
        let level = member.level(search.config, self.is_least(member));
        let prices = (self.floods.least(), search.costs().searching(&level).change());
        let car = (search.checker, search.query.vehicle);
        PoseHeuristic::new(car, to_root, [search.root, search.target], prices, most)
    }
}
