//! The members for open space, which the small module lacks: who they are, and in which order they are asked.
//!
//! A search that has left every slot and found no way has met clutter, a narrow lane, or a place where the car must
//! creep round a corner. Two groups take turns then, each member with all of its budget at once.
//!
//! The first looks for what the flood of a disc hides. Guided searches find most ways among clutter in a hundredth of
//! the work. A search from the other end helps where only the hard end's surroundings are known. Those that rock turn
//! the car where it has hardly more room than its own length.
//!
//! The second is asked only where one of the first has spent its work in vain: there is room left to search, and ways
//! have been found there. Its members go on for long, from either end, and take gear changes lightly.

use super::members::{From, Member, Style, plain};
use super::{Run, Stage};
use crate::geometry::Pose;
use crate::planners::hybrid::config::{Config, Heuristic, Level};
use crate::planners::hybrid::holonomic;
use crate::planners::hybrid::pose_heuristic::PoseHeuristic;
use crate::planners::hybrid::question::{Search, Work};

/// Expansions of all members together where the first of those for open space are asked, …
const OPEN_TOTAL_EXPANSIONS: u32 = 360_000;
/// … and of the last alone.
const LAST_EXPANSIONS: u32 = 300_000;

/// The level that rocks with the least margin and, where that finds a path, with more, and the finer one.
const ROCKING_LEVEL: u32 = 2;
pub(super) const FINE_ROCKING_LEVEL: u32 = 3;
/// The level of those that go on for long.
const DOGGED_LEVEL: u32 = 2;

/// True if the body could get to the other end if it moved in any direction.
pub(super) enum Hope {
    Unasked,
    Some,
    /// It could not; the pose nearest to the other end that it may reach.
    None(Pose),
}

impl Run<'_> {
    /// Only the first members for open space from now on.
    pub(super) fn first_in_open_space(&mut self) {
        let is_unproven = self.proof.is_none();
        self.members = first(self.search.config, self.least(), self.may_swap, is_unproven);
        self.effort = OPEN_TOTAL_EXPANSIONS;
    }

    /// Turns to the members for open space, where they may find a way: to the first where all that may be spent was
    /// spent in vain, and to the last where one of the first has spent its work in vain.
    pub(super) fn next_stage(&mut self, work: &mut Work) -> bool {
        match self.stage {
            _ if self.best.is_some() => false,
            Stage::Levels if !self.members.is_empty() => {
                self.enter_open_space();
                !self.members.is_empty() && !self.is_hopeless(work)
            }
            Stage::OpenSpace { in_vain: true } => {
                self.stage = Stage::Last;
                self.members = last(self.search.config, self.least(), self.may_swap);
                self.effort = work.report.stats.expanded.saturating_add(LAST_EXPANSIONS);
                true
            }
            _ => false,
        }
    }

    /// True if the body could not get there either if it moved in any direction; else more work is worth its while.
    pub(super) fn is_hopeless(&mut self, work: &Work) -> bool {
        let flood = self.floods.get(self.least(), self.is_swapped);
        let search = if self.is_swapped { self.search.swapped(flood) } else { self.search };
        let car = (search.checker, search.query.vehicle);
        let keys = &mut work.scratch.keys.borrow_mut();
        let ends = [search.root, search.target];
        let nearest = holonomic::proven_apart(car, flood, ends, self.floods.least(), keys);
        self.hope = nearest.map_or(Hope::Some, Hope::None);
        nearest.is_some()
    }

    /// The same search, guided by the costs from poses to its target. These are made with the least margin, once for
    /// each end: a little more margin hardly changes where the car must turn.
    pub(super) fn guided<'a>(&'a self, search: Search<'a>, is_swapped: bool, level: &Level) -> Search<'a> {
        let poses = self.poses[usize::from(is_swapped)].get_or_init(|| {
            let car = (search.checker, search.query.vehicle);
            let to_root = self.floods.get(self.floods.count() - 1, !is_swapped);
            let prices = (self.floods.least(), search.costs().searching(level).change());
            PoseHeuristic::new(car, to_root, [search.root, search.target], prices)
        });
        Search { poses: Some(poses), ..search }
    }
}

/// The first group. Unless another estimate is asked for, the first two search from either end, guided by a coarse
/// search of the poses. The next goes from the other end without a guide. Where `is_unproven`, the coarsest search with
/// the least margin then goes on from where its budget ended, greedily. The others rock with the least margin, on two
/// lattices.
fn first(config: &Config, least: usize, may_swap: bool, is_unproven: bool) -> Vec<Member> {
    let coarsest = |from, style| Member { from, style, ..plain(1, least) };
    let mut members = Vec::new();
    if config.heuristic == Heuristic::Max {
        members.extend([coarsest(From::Hard, Style::Guided), coarsest(From::Far, Style::Guided)]);
    }
    members.push(coarsest(From::Far, Style::Plain));
    if is_unproven {
        members.push(coarsest(From::Hard, Style::Greedy));
    }
    members.extend([ROCKING_LEVEL, FINE_ROCKING_LEVEL].map(|level| rocking(level, least)));
    allowed(members, config, may_swap)
}

/// The second group: two that go on for long, and one that rocks from both ends.
fn last(config: &Config, least: usize, may_swap: bool) -> Vec<Member> {
    let dogged = |from| Member { from, style: Style::Dogged, ..plain(DOGGED_LEVEL, least) };
    let both = Member { from: From::Both, ..rocking(ROCKING_LEVEL, least) };
    allowed(vec![dogged(From::Hard), dogged(From::Far), both], config, may_swap)
}

/// The members that may improve the path of one of these: the same with more margin, or those that rock.
pub(super) fn with_more_margin(
    member: Member,
    margins: core::ops::Range<usize>,
) -> impl Iterator<Item = Member> {
    margins.map(move |margin| match member.style {
        Style::Guided | Style::Dogged => Member { margin, ..member },
        _ => rocking(ROCKING_LEVEL, margin),
    })
}

fn rocking(level: u32, margin: usize) -> Member {
    Member { style: Style::Rocking, ..plain(level, margin) }
}

/// Those that the settings allow.
fn allowed(mut members: Vec<Member>, config: &Config, may_swap: bool) -> Vec<Member> {
    members.retain(|one| one.level < config.levels() && (may_swap || one.from == From::Hard));
    members
}
