//! The members' turns: who searches next, how much, and what follows from how a search ended.
//!
//! Slices and rounds are told where the portfolio is (`portfolio`); this is what happens between them.
//!
//! A turn ends in one of four ways:
//!
//! 1. *found*: members go on only if they may keep more margin or, where there are many gear changes, save some;
//! 2. *exhausted*: coarser members and those with more margin would reach no more and are dropped;
//! 3. *spent*: the member waits for its next, larger slice;
//! 4. *lost*: its work proves nothing, and it is dropped; the answer can no longer be a proof.
//!
//! Where the levels have found nothing for a while, scouts go ahead (`scouts`). Where nothing is found at all, members
//! for open space follow in two stages, unless a search over all motions of the body shows that it cannot get through.
//! The state is a stage, a list of members and a budget; `rounds` is the loop.

use core::cell::OnceCell;

use super::floods::Floods;
use super::known_paths::KnownPaths;
use super::members::{COMFORTABLE_MARGIN, FIRST_SLICE, From, MANY_CHANGES, Member, Style, arrange, members};
use super::open_space;
use crate::IS_COMPLETE;
use crate::geometry::Pose;
use crate::geometry::arcs;
use crate::planners::hybrid::config::SearchFrom;
use crate::planners::hybrid::holonomic;
use crate::planners::hybrid::pose_heuristic::PoseHeuristic;
use crate::planners::hybrid::question::{Search, Work};
use crate::planners::hybrid::report::{Report, Status};
use crate::search::Progress;

/// Expansions of all members together, where the settings say nothing, …
const TOTAL_EXPANSIONS: u32 = 150_000;
/// … where a search with the least margin has not come out of a slot: only the finest will, …
const SLOT_EXPANSIONS: u32 = 220_000;
/// … and where scouts came back in vain.
pub(super) const SCOUTED_EXPANSIONS: u32 = 100_000;
/// Expansions for more margin once there is a path, besides as many as it took.
const MORE_MARGIN_EXPANSIONS: u32 = 200_000;
/// The same where the path was guided: what finds one with more margin finds it soon.
const MORE_GUIDED_EXPANSIONS: u32 = 40_000;
/// A member that has searched more than this many poses to the end, times its level, came out of any slot: there are
/// many gear changes, or no way.
const WIDE_SEARCH_POSES: u32 = 1000;
/// Expansions of all members together where the first of those for open space are asked, …
const OPEN_TOTAL_EXPANSIONS: u32 = 360_000;
/// … and of the last alone.
const LAST_EXPANSIONS: u32 = 170_000;

/// Which members take turns.
#[derive(Clone, Copy, PartialEq)]
enum Stage {
    /// Those of the levels.
    Levels,
    /// The first for open space: a search with the least margin came out of any slot and found no way, or all that may
    /// be spent was spent.
    OpenSpace { in_vain: bool },
    /// The last for open space: one of the first has spent its work in vain.
    Last,
}

/// How a turn ended.
pub(super) enum Turn {
    Found,
    /// All that it can reach was searched.
    Exhausted,
    /// It may find a way with more work.
    Spent,
    /// It will not, and has proven nothing.
    Lost,
}

/// True if the body could get to the other end if it moved in any direction.
enum Hope {
    Unasked,
    Some,
    /// It could not; the pose nearest to the other end that it may reach.
    None(Pose),
}

/// The members that take turns, and what they have found.
pub(super) struct Turns<'a> {
    pub(super) search: Search<'a>,
    pub(super) floods: &'a Floods<'a>,
    /// True if the trees grow from the other end.
    pub(super) is_swapped: bool,
    /// True if they may grow from either end.
    pub(super) may_swap: bool,
    members: Vec<Member>,
    /// The largest margin to try.
    widest: usize,
    /// Expansions of all members together.
    pub(super) effort: u32,
    /// The paths found so far.
    pub(super) known: KnownPaths,
    /// Whose turns these are.
    stage: Stage,
    /// True if scouts have gone ahead.
    pub(super) is_scouted: bool,
    /// How a member ended that has proven nothing.
    doubt: Option<Status>,
    /// True if the body could get there if it moved in any direction.
    hope: Hope,
    /// The costs from poses to either end, made when they are needed first.
    pub(super) poses: [OnceCell<PoseHeuristic>; 2],
    /// What the last search from the hard end told that came to its end with the least margin.
    proof: Option<Report>,
}

impl<'a> Turns<'a> {
    /// Those of all levels and margins, from `widest` on, which is the largest with which a disc reaches the other end.
    pub(super) fn new(search: Search<'a>, floods: &'a Floods<'a>, widest: usize, is_swapped: bool) -> Self {
        let levels = search.config.levels();
        Self {
            search,
            floods,
            is_swapped,
            may_swap: search.config.search_from == SearchFrom::Goal,
            members: members(levels, widest, &floods.margins),
            widest,
            effort: TOTAL_EXPANSIONS,
            known: KnownPaths::default(),
            stage: Stage::Levels,
            is_scouted: false,
            doubt: None,
            hope: Hope::Unasked,
            poses: Default::default(),
            proof: None,
        }
    }

    /// Takes all turns; what came of them is in `work.report`.
    pub(super) fn take(&mut self, work: &mut Work) {
        self.rounds(work);
        if IS_COMPLETE {
            work.report.stats.bytes +=
                self.poses.iter().filter_map(OnceCell::get).map(PoseHeuristic::bytes).sum::<u64>();
        }
        self.conclude(work.report);
    }

    /// Lets members search in turn until one has found a path that no other may improve, all are dropped, or the work
    /// is spent.
    fn rounds(&mut self, work: &mut Work) {
        if self.search.config.max_expansions.is_some() {
            self.effort = u32::MAX;
        }
        for round in 1_u32.. {
            // Everybody before this one has spent a slice in this round.
            let mut at = 0;
            while at < self.members.len() && at <= round as usize {
                if work.progress.as_ref().is_some_and(Progress::is_stopped) {
                    return;
                }
                if work.report.stats.expanded >= self.effort {
                    if !self.next_stage(work) {
                        return;
                    }
                    at = 0;
                    continue;
                }
                if self.may_scout(work.report) {
                    if !self.scout(work) {
                        return;
                    }
                    at = 0;
                    continue;
                }
                at = self.turn(at, round, work);
                let is_unasked = matches!((self.stage, &self.hope), (Stage::OpenSpace { .. }, Hope::Unasked));
                if is_unasked && self.is_hopeless(work) {
                    return;
                }
            }
            if self.members.is_empty() && !self.next_stage(work) {
                return;
            }
        }
    }

    /// The turn of the member at a place of the list in one of the rounds; tells the place of the next one.
    fn turn(&mut self, at: usize, round: u32, work: &mut Work) -> usize {
        let (member, before) = (self.members[at], work.report.stats.expanded);
        // Where another may prove more at once, the first spends no more before that than any other.
        let is_proof_next = self.may_ask_proof(member);
        let rounds = if is_proof_next { 0 } else { round - at as u32 };
        let growth = 1_u32.checked_shl(2 * rounds).unwrap_or(u32::MAX);
        let slice = if self.stage == Stage::Levels { FIRST_SLICE.saturating_mul(growth) } else { u32::MAX };
        let turn = self.search(member, slice.min(self.effort - before), work);
        let expanded = work.report.stats.expanded - before;
        if let (Stage::OpenSpace { in_vain }, Turn::Spent | Turn::Lost) = (&mut self.stage, &turn) {
            *in_vain = true;
        }
        match turn {
            Turn::Spent if is_proof_next => {
                self.members.swap(0, 1);
                0
            }
            Turn::Spent => at + 1,
            Turn::Lost => {
                self.doubt = Some(work.report.status);
                self.drop(at, |_| false)
            }
            Turn::Exhausted => self.exhausted(at, expanded, work.report),
            Turn::Found => self.found(at, work.report),
        }
    }

    /// True while the levels have found and proven nothing.
    pub(super) fn is_undecided(&self) -> bool {
        self.stage == Stage::Levels && self.known.is_empty() && self.proof.is_none()
    }

    /// A scout has found a path. Only the same search with more margin goes on.
    pub(super) fn found_by_scout(&mut self, scout: Member, report: &mut Report) {
        (self.stage, self.members) = (Stage::OpenSpace { in_vain: false }, vec![scout]);
        self.found(0, report);
    }

    /// Turns to the members for open space, where they may find a way: to the first where all that may be spent was
    /// spent in vain, and to the last where one of the first has spent its work in vain.
    fn next_stage(&mut self, work: &mut Work) -> bool {
        match self.stage {
            _ if !IS_COMPLETE || !self.known.is_empty() => false,
            Stage::Levels if !self.members.is_empty() => {
                self.enter_open_space();
                !self.members.is_empty() && !self.is_hopeless(work)
            }
            Stage::OpenSpace { in_vain: true } => {
                self.stage = Stage::Last;
                self.members = open_space::last(self.search.config, self.least(), self.may_swap);
                self.effort = work.report.stats.expanded.saturating_add(LAST_EXPANSIONS);
                true
            }
            _ => false,
        }
    }

    /// True if the body could not get there either if it moved in any direction; else more work is worth its while.
    pub(super) fn is_hopeless(&mut self, work: &Work) -> bool {
        if !IS_COMPLETE || !matches!(self.hope, Hope::Unasked) {
            return false;
        }
        let flood = self.floods.get(self.least(), self.is_swapped);
        let search = if self.is_swapped { self.search.swapped(flood) } else { self.search };
        let car = (search.checker, search.query.vehicle);
        let keys = &mut work.scratch.keys.borrow_mut();
        let ends = [search.root, search.target];
        let nearest = holonomic::proven_apart(car, flood, ends, self.floods.least(), keys);
        self.hope = nearest.map_or(Hope::Some, Hope::None);
        nearest.is_some()
    }

    /// From now on only the first members for open space are asked, which the small module lacks.
    fn enter_open_space(&mut self) {
        self.stage = Stage::OpenSpace { in_vain: false };
        self.members.clear();
        if IS_COMPLETE {
            self.members = open_space::first(self.search.config, self.least(), self.may_swap);
            self.effort = OPEN_TOTAL_EXPANSIONS;
        }
    }

    /// The index of the least margin.
    pub(super) fn least(&self) -> usize {
        self.floods.margins.len() - 1
    }

    /// True if the proof is to be sought before a search with more margin goes on: it may find a way sooner, too.
    fn may_ask_proof(&self, member: Member) -> bool {
        let is_proof = |one: Member| one.level == 1 && self.is_least(one);
        member.level == 1 && !is_proof(member) && self.members[0] == member && {
            self.members.get(1).is_some_and(|&next| is_proof(next))
        }
    }

    /// True if a member has the least of the margins: what it cannot reach, no member of its level can.
    pub(super) fn is_least(&self, member: Member) -> bool {
        member.margin == self.least()
    }

    /// A member has searched all that it can reach. Coarser ones would reach no more, nor would any with more margin.
    /// Where that came out of any slot, only finer ones with the least margin are asked now, from either end, which
    /// prove more as well. Tells who is next.
    fn exhausted(&mut self, at: usize, expanded: u32, report: &Report) -> usize {
        let member = self.members[at];
        let is_proof = self.is_least(member);
        if is_proof && member.from == From::Hard {
            self.proof = Some(report.clone());
        }
        if is_proof && self.known.is_empty() {
            self.effort = self.effort.max(SLOT_EXPANSIONS);
        }
        let next = self.drop(at, |one| member.outdoes(one));
        if !is_proof
            || self.stage != Stage::Levels
            || !self.known.is_empty()
            || expanded <= WIDE_SEARCH_POSES * member.level
        {
            return next;
        }
        self.enter_open_space();
        self.members.retain(|&one| !member.outdoes(one));
        0
    }

    /// A member has found a path. Only those go on that may keep more margin, a little more first, or, where there are
    /// many gear changes, save some. None rocks where another drove out.
    fn found(&mut self, at: usize, report: &mut Report) -> usize {
        let member = self.members[at];
        let is_comfortable = report.margin >= COMFORTABLE_MARGIN;
        let is_restless = arcs::direction_changes(&report.arcs) > MANY_CHANGES;
        let more = match member.style {
            _ if is_comfortable => FIRST_SLICE,
            Style::Guided if IS_COMPLETE => MORE_GUIDED_EXPANSIONS,
            _ => MORE_MARGIN_EXPANSIONS,
        };
        self.effort = self.effort.min(report.stats.expanded.saturating_add(report.stats.expanded.max(more)));
        let need_not_rock = IS_COMPLETE && self.stage == Stage::Levels && member.style != Style::Rocking;
        if IS_COMPLETE && self.stage != Stage::Levels {
            self.members.extend(open_space::with_more_margin(member, self.widest..member.margin));
        }
        self.stage = Stage::Levels;
        let counters = report.counters();
        self.known.offer(core::mem::replace(report, counters));
        self.drop(at, |one| {
            let is_better = one.margin < member.margin
                || (is_restless && one.margin == member.margin && one.level > member.level);
            let is_vain =
                (is_comfortable && one.is_last_resort()) || (need_not_rock && one.style == Style::Rocking);
            !is_better || is_vain
        });
        let margins = &self.floods.margins;
        arrange(&mut self.members, &|one| {
            let is_close = margins[one.margin] < COMFORTABLE_MARGIN;
            [usize::from(is_close), usize::from(one.margin == member.margin), margins.len() - one.margin]
        });
        0
    }

    /// Takes the member that had its turn out of the list, and the others for which there is no hope; tells where the
    /// next one stands.
    fn drop(&mut self, at: usize, is_hopeless: impl Fn(Member) -> bool) -> usize {
        let (mut index, mut next) = (0, 0);
        self.members.retain(|&one| {
            let is_kept = index != at && !is_hopeless(one);
            next += usize::from(is_kept && index < at);
            index += 1;
            is_kept
        });
        next
    }

    /// Says what came of it; the counters are those of all members.
    fn conclude(&mut self, report: &mut Report) {
        if IS_COMPLETE && let Hope::None(nearest) = self.hope {
            (report.status, report.margin) = (Status::NoRoom, self.floods.least());
            report.closest = Some(self.search.world(nearest));
            return;
        }
        if let Some(known) = self.known.take_better().or_else(|| self.proof.take()) {
            *report = report.with_path_of(known);
        } else if report.status == Status::NoPath {
            report.status = self.doubt.unwrap_or(Status::BudgetExhausted(report.rs_bound));
        }
    }
}
