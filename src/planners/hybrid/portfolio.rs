//! Which searches are tried, in what order, and how much work each gets.
//!
//! The members stand in one list, what a driver likes best in front. They take turns: whoever has spent a slice and may
//! still find a way leaves a quarter of it to the next in the list, and slices grow fourfold with each round (Levin's
//! universal search, 1973; Gomes and Selman, Algorithm portfolios, 2001). Nobody waits long behind a member that is
//! lost, and all together work a few times as much as the best one would alone. Work is counted in expansions, never in
//! time.

use core::cell::OnceCell;

use super::config::{FIRST_SHUFFLING_LEVEL, Level};
#[cfg(feature = "complete")]
use super::holonomic;
use super::level::{First, Search, Work};
use super::obstacle_heuristic::ObstacleHeuristic;
use super::{Config, MIN_MARGIN, Query, Report, SearchFrom, Status};
use crate::geometry::{Pose, arcs};
use crate::search::Progress;

/// Margins tried where no way keeps the one asked for, metres.
const FALLBACK_MARGINS: [f64; 4] = [0.05, 0.03, 0.01, MIN_MARGIN];
/// With less than this a car creeps, metres.
pub(super) const COMFORTABLE_MARGIN: f64 = 0.03;
/// Expansions of the first slice.
const FIRST_SLICE: u32 = 8192;
/// Expansions of all members together, where the settings say nothing.
const TOTAL_EXPANSIONS: u32 = 150_000;
/// Expansions for more margin once there is a path, besides as many as it took.
const MORE_MARGIN_EXPANSIONS: u32 = 100_000;
/// With more gear changes than this, finer steps may find a path with fewer.
const MANY_CHANGES: u32 = 4;
/// A member that has searched more than this many poses to the end, times its level, came out of any slot: there are
/// many gear changes, or no way.
const WIDE_SEARCH_POSES: u32 = 1000;
/// Levels of the searches in open space, …
#[cfg(feature = "complete")]
const OPEN_COARSE: u32 = 2;
#[cfg(feature = "complete")]
const OPEN_FINE: u32 = 3;
/// … expansions of each, from the hard end and from the other one, …
#[cfg(feature = "complete")]
const OPEN_HARD_EXPANSIONS: u32 = 80_000;
#[cfg(feature = "complete")]
const OPEN_OTHER_EXPANSIONS: u32 = 130_000;
/// … and of all members together where they are asked.
#[cfg(feature = "complete")]
const OPEN_TOTAL_EXPANSIONS: u32 = 300_000;
/// Up to this level a search with the least margin is worth its while before finer ones with more are.
const LAST_CHEAP_LEVEL: u32 = 3;

/// The estimates' rasters from both ends for each margin, made when they are needed first.
pub(super) struct Floods<'a> {
    query: &'a Query<'a>,
    /// Towards which the tree grows, and from where.
    ends: [Pose; 2],
    margins: Vec<f64>,
    made: Vec<[OnceCell<ObstacleHeuristic>; 2]>,
}

impl<'a> Floods<'a> {
    /// For the margin asked for and, where the settings allow it, less. `memory` is used again.
    pub(super) fn new(
        query: &'a Query<'a>,
        config: &Config,
        ends: [Pose; 2],
        asked: f64,
        memory: Option<ObstacleHeuristic>,
    ) -> Self {
        let mut margins = vec![asked];
        if config.levels() > FIRST_SHUFFLING_LEVEL {
            margins.extend(FALLBACK_MARGINS.into_iter().filter(|&margin| margin < asked));
        }
        let floods = Self::with(query, ends, margins);
        floods.get_from(0, false, memory);
        floods
    }

    /// For these margins.
    pub(super) fn with(query: &'a Query<'a>, ends: [Pose; 2], margins: Vec<f64>) -> Self {
        let mut made = Vec::new();
        made.resize_with(margins.len(), Default::default);
        Self { query, ends, margins, made }
    }

    pub(super) fn get(&self, margin: usize, is_swapped: bool) -> &ObstacleHeuristic {
        self.get_from(margin, is_swapped, None)
    }

    /// Towards the first end, or the second, with one of the margins.
    #[inline(never)]
    fn get_from(
        &self,
        margin: usize,
        is_swapped: bool,
        memory: Option<ObstacleHeuristic>,
    ) -> &ObstacleHeuristic {
        let (Query { obstacles, vehicle, .. }, end) = (self.query, usize::from(is_swapped));
        self.made[margin][end].get_or_init(|| {
            ObstacleHeuristic::new(obstacles, vehicle, self.ends[end], self.margins[margin], memory)
        })
    }

    /// The largest margin with which a disc of the car's width gets from end to end.
    pub(super) fn widest(&self) -> Option<(usize, &ObstacleHeuristic)> {
        let reaches = |&at: &usize| self.get(at, false).distance(self.ends[1]).is_finite();
        (0..self.margins.len()).find(reaches).map(|at| (at, self.get(at, false)))
    }

    pub(super) fn margin(&self, at: usize) -> f64 {
        self.margins[at]
    }

    /// The least margin.
    pub(super) fn least(&self) -> f64 {
        self.margins[self.margins.len() - 1]
    }

    pub(super) fn bytes(&self) -> u64 {
        self.made.iter().flatten().filter_map(OnceCell::get).map(ObstacleHeuristic::bytes).sum()
    }

    /// The first one's memory.
    pub(super) fn into_memory(mut self) -> Option<ObstacleHeuristic> {
        self.made[0][0].take()
    }
}

/// A level with one of the margins, from one end.
#[derive(Clone, Copy, PartialEq)]
struct Member {
    level: u32,
    /// From the one asked for to the least.
    margin: usize,
    /// True if the tree grows from the end that is not the hard one.
    from_other: bool,
}

/// How a turn ended.
enum Turn {
    Found,
    /// All that it can reach was searched.
    Exhausted,
    /// It may find a way with more work.
    Spent,
    /// It will not, and has proven nothing.
    Lost,
}

/// Finds a path with the largest margin that some member keeps, or why there is none. `widest` is the largest margin to
/// try.
pub(super) fn plan(search: Search, floods: &Floods, widest: usize, work: &mut Work) {
    let levels = search.config.levels();
    let may_swap = search.config.search_from == SearchFrom::Goal && levels > 1;
    let other = || may_swap.then(|| search.swapped(floods.get(widest, true)));
    let first = search.first(&other, search.config.level(0), work);
    if first == First::Found || levels == 1 {
        return;
    }
    let members = members(levels, widest, &floods.margins);
    let is_swapped = first == First::Cramped;
    let mut run = Run {
        search,
        floods,
        is_swapped,
        #[cfg(feature = "complete")]
        may_swap,
        members,
        effort: TOTAL_EXPANSIONS,
        best: None,
        is_way_out: false,
        doubt: None,
        #[cfg(feature = "complete")]
        hope: Hope::Unasked,
        proof: None,
    };
    run.rounds(work);
    run.conclude(work.report);
}

/// Whoever has not tried yet, what a driver likes best in front.
fn members(levels: u32, widest: usize, margins: &[f64]) -> Vec<Member> {
    let least = margins.len() - 1;
    let all = (1..levels)
        .flat_map(|level| (widest..=least).map(move |margin| Member { level, margin, from_other: false }));
    let mut members: Vec<Member> = all.collect();
    // Sorted by level and margin before.
    arrange(&mut members, &|&Member { level, margin, .. }| {
        let is_comfortable = margins[margin] >= COMFORTABLE_MARGIN || margin == widest;
        match level {
            // Searched to the end with the least margin, the coarsest proves soonest that there is hardly a way.
            1 if margin == widest => [0; 3],
            1 if margin == least => [1, 0, 0],
            1..=LAST_CHEAP_LEVEL if is_comfortable => [2, margin, 0],
            1..=LAST_CHEAP_LEVEL if margin == least => [3, 0, 0],
            _ if is_comfortable => [4, 0, 0],
            _ => [5, 0, 0],
        }
    });
    members
}

/// Sorts stably. The members are few; the library's sort takes kilobytes of the module.
fn arrange(members: &mut [Member], key: &dyn Fn(&Member) -> [usize; 3]) {
    for end in 1..members.len() {
        let mut at = end;
        while at > 0 && key(&members[at - 1]) > key(&members[at]) {
            members.swap(at - 1, at);
            at -= 1;
        }
    }
}

/// True if the body could get to the other end if it moved in any direction.
#[cfg(feature = "complete")]
enum Hope {
    Unasked,
    Some,
    /// It could not; the pose nearest to the other end that it may reach.
    None(Pose),
}

struct Run<'a> {
    search: Search<'a>,
    floods: &'a Floods<'a>,
    /// True if the trees grow from the other end.
    is_swapped: bool,
    /// True if they may grow from either end.
    #[cfg(feature = "complete")]
    may_swap: bool,
    members: Vec<Member>,
    /// Expansions of all members together.
    effort: u32,
    /// The path with the largest margin so far.
    best: Option<Report>,
    /// True if a search with the least margin came out of any slot, and found no way.
    is_way_out: bool,
    /// How a member ended that has proven nothing.
    doubt: Option<Status>,
    /// True if the body could get there if it moved in any direction.
    #[cfg(feature = "complete")]
    hope: Hope,
    /// Margin and level of the search that came to its end with the least margin, the first of them, and where that
    /// ended.
    proof: Option<(f64, u32, Option<Pose>)>,
}

impl Run<'_> {
    fn rounds(&mut self, work: &mut Work) {
        if self.search.config.max_expansions.is_some() {
            self.effort = u32::MAX;
        }
        for round in 0_u32.. {
            // Everybody before this one has spent a slice in this round.
            let mut at = 0;
            while let Some(&member) = self.members.get(at).filter(|_| at <= round as usize) {
                let before = work.report.expanded;
                if before >= self.effort || work.progress.as_ref().is_some_and(Progress::is_stopped) {
                    return;
                }
                let growth = 1_u32.checked_shl(2 * (round - at as u32)).unwrap_or(u32::MAX);
                let slice = if self.is_way_out { u32::MAX } else { FIRST_SLICE.saturating_mul(growth) };
                let turn = self.turn(member, slice.min(self.effort - before), work);
                let expanded = work.report.expanded - before;
                at = match turn {
                    Turn::Spent if self.may_ask_proof(member) => {
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
                };
                #[cfg(feature = "complete")]
                if self.is_way_out && matches!(self.hope, Hope::Unasked) {
                    if self.is_hopeless(work) {
                        return;
                    }
                    self.effort = OPEN_TOTAL_EXPANSIONS;
                }
            }
            if self.members.is_empty() {
                return;
            }
        }
    }

    /// True if the body could not get there either if it moved in any direction; else more work is worth its while.
    #[cfg(feature = "complete")]
    fn is_hopeless(&mut self, work: &Work) -> bool {
        let least = self.floods.margins.len() - 1;
        let flood = self.floods.get(least, self.is_swapped);
        let search = if self.is_swapped { self.search.swapped(flood) } else { self.search };
        let car = (search.probe, search.query.vehicle);
        let keys = &mut work.scratch.keys.borrow_mut();
        let ends = [search.root, search.target];
        let nearest = holonomic::proven_apart(car, flood, ends, self.floods.least(), keys);
        self.hope = nearest.map_or(Hope::Some, Hope::None);
        nearest.is_some()
    }

    /// True if the proof is to be sought before a search with more margin goes on: it may find a way sooner, too.
    fn may_ask_proof(&self, member: Member) -> bool {
        let is_proof = |one: Member| one.level == 1 && self.is_least(one);
        member.level == 1 && !is_proof(member) && self.members[0] == member && {
            self.members.get(1).is_some_and(|&next| is_proof(next))
        }
    }

    fn is_least(&self, member: Member) -> bool {
        member.margin + 1 == self.floods.margins.len()
    }

    /// A member has searched all that it can reach. Coarser ones would reach no more, nor would any with more margin.
    /// Where that came out of any slot, only finer ones with the least margin are asked now, from either end, which
    /// prove more as well. Tells who is next.
    fn exhausted(&mut self, at: usize, expanded: u32, report: &Report) -> usize {
        let member = self.members[at];
        let is_proof = self.is_least(member);
        if is_proof && !member.from_other {
            self.proof = Some((report.margin, report.level, report.closest));
        }
        let next = self.drop(at, |one| {
            one.from_other == member.from_other && one.margin <= member.margin && one.level <= member.level
        });
        if !is_proof || self.is_way_out || self.best.is_some() || expanded <= WIDE_SEARCH_POSES * member.level
        {
            return next;
        }
        self.is_way_out = true;
        #[cfg(feature = "complete")]
        self.ask_open_space(member);
        #[cfg(not(feature = "complete"))]
        self.members.clear();
        0
    }

    /// The members for open space, which the small module lacks: from the hard end with the least margin, finer with
    /// the least that is no creeping, and from the other end.
    #[cfg(feature = "complete")]
    fn ask_open_space(&mut self, proof: Member) {
        let creeping = self.floods.margins.iter().position(|&margin| margin < COMFORTABLE_MARGIN);
        let finer = Member { margin: creeping.unwrap_or(proof.margin), level: OPEN_FINE, ..proof };
        let other = Member { level: OPEN_COARSE, from_other: true, ..finer };
        let tries =
            [Member { level: OPEN_COARSE, ..proof }, finer, other, Member { level: OPEN_FINE, ..other }];
        let levels = self.search.config.levels();
        let is_new = |one: &Member| one.level < levels && (one.level > proof.level || one.from_other);
        self.members =
            tries.into_iter().filter(is_new).filter(|one| self.may_swap || !one.from_other).collect();
    }

    /// A member has found a path. Only those go on that may keep more margin, a little more first, or, where there are
    /// many gear changes, save some.
    fn found(&mut self, at: usize, report: &mut Report) -> usize {
        let member = self.members[at];
        let is_comfortable = report.margin >= COMFORTABLE_MARGIN;
        let is_restless = arcs::direction_changes(&report.arcs) > MANY_CHANGES;
        let more = if is_comfortable { FIRST_SLICE } else { MORE_MARGIN_EXPANSIONS };
        self.effort = self.effort.min(report.expanded.saturating_add(report.expanded.max(more)));
        self.is_way_out = false;
        self.offer(report);
        self.drop(at, |one| {
            let is_better = one.margin < member.margin
                || (is_restless && one.margin == member.margin && one.level > member.level);
            !is_better || (is_comfortable && one.level >= FIRST_SHUFFLING_LEVEL)
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

    /// Keeps a path that has more margin than the best so far or, with the same, costs less.
    fn offer(&mut self, report: &mut Report) {
        let counters = report.counters();
        let path = core::mem::replace(report, counters);
        if self.best.as_ref().is_none_or(|best| path.margin > best.margin || path.cost < best.cost) {
            self.best = Some(path);
        }
    }

    fn turn(&self, member: Member, slice: u32, work: &mut Work) -> Turn {
        let is_swapped = self.is_swapped != member.from_other;
        let flood = self.floods.get(member.margin, is_swapped);
        let search = if is_swapped { self.search.swapped(flood) } else { Search { flood, ..self.search } };
        (work.report.margin, work.report.level) = (self.floods.margin(member.margin), member.level);
        work.report.status = Status::NoPath;
        if flood.distance(search.root).is_infinite() {
            return Turn::Exhausted;
        }
        let mut level = search.config.level(member.level);
        if self.is_way_out || (member.level == 1 && self.is_least(member)) {
            // In open space what it saves on rocking is less than it costs on detours.
            level.extra_change = 0.0;
        }
        #[cfg(feature = "complete")]
        if self.is_way_out {
            level = level.in_open_space(if member.from_other {
                OPEN_OTHER_EXPANSIONS
            } else {
                OPEN_HARD_EXPANSIONS
            });
        }
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

    /// Says what came of it; the counters are those of all members.
    fn conclude(self, report: &mut Report) {
        #[cfg(feature = "complete")]
        if let Hope::None(nearest) = self.hope {
            (report.status, report.margin) = (Status::NoRoom, self.floods.least());
            report.closest = Some(self.search.world(nearest));
            return;
        }
        if let Some(best) = self.best {
            let Report { expanded, generated, pushes, open_peak, bytes, .. } = *report;
            *report = Report { expanded, generated, pushes, open_peak, bytes, ..best };
        } else if let Some(proof) = self.proof {
            report.status = Status::NoPath;
            (report.margin, report.level, report.closest) = proof;
        } else if report.status == Status::NoPath {
            report.status = self.doubt.unwrap_or(Status::BudgetExhausted(report.rs_bound));
        }
    }
}
