//! The members of the portfolio: who they are, what they search, and in which order they are asked.
//!
//! The order is that of a driver's wishes: first a comfortable margin with coarse steps, then smaller margins, then
//! finer steps, at last the searches that creep or rock out of the tightest slots. One member stands out of that
//! order. The coarsest search with the least margin goes early, because it reaches more than any other of its level:
//! where it ends without a path, it rules out many others at once (`outdoes`).

use crate::planners::hybrid::config::{Config, FIRST_SHUFFLING_LEVEL, Level};
#[cfg(feature = "complete")]
use crate::planners::hybrid::config::{Heuristic, REFINEMENTS};

/// With less than this a car creeps, metres.
pub(in crate::planners::hybrid) const COMFORTABLE_MARGIN: f64 = 0.03;
/// Expansions of the first slice.
pub(super) const FIRST_SLICE: u32 = 8192;
/// With more gear changes than this, finer steps may find a path with fewer.
pub(super) const MANY_CHANGES: u32 = 4;

/// Up to this level a search with the least margin is worth its while before finer ones with more are.
const LAST_CHEAP_LEVEL: u32 = 3;
/// The level that rocks with the least margin and, where that finds a path, with more, and the finer one.
#[cfg(feature = "complete")]
const ROCKING_LEVEL: u32 = 2;
#[cfg(feature = "complete")]
const FINE_ROCKING_LEVEL: u32 = 3;
/// The level that is refined.
#[cfg(feature = "complete")]
const FINEST_PLAIN_LEVEL: u32 = FIRST_SHUFFLING_LEVEL - 1;
/// Weight of the estimate where a search is greedy, and its expansions.
#[cfg(feature = "complete")]
const GREEDY_WEIGHT: f64 = 4.0;
#[cfg(feature = "complete")]
const GREEDY_EXPANSIONS: u32 = 100_000;
/// Weight of the estimate where a coarse search of the poses guides, and its expansions.
#[cfg(feature = "complete")]
const GUIDED_WEIGHT: f64 = 4.0;
#[cfg(feature = "complete")]
const GUIDED_EXPANSIONS: u32 = 60_000;
/// Weight of the estimate in a search from the other end, and its expansions.
#[cfg(feature = "complete")]
const FAR_WEIGHT: f64 = 3.0;
#[cfg(feature = "complete")]
const FAR_EXPANSIONS: u32 = 60_000;
/// Expansions of each search that rocks from the hard end, …
#[cfg(feature = "complete")]
const ROCKING_EXPANSIONS: u32 = 100_000;
/// … and of the one from both ends.
#[cfg(feature = "complete")]
const BOTH_EXPANSIONS: u32 = 40_000;

/// Where a tree grows from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum From {
    /// The end that is hard to leave.
    Hard,
    /// The other end.
    #[cfg(feature = "complete")]
    Far,
    /// Two trees, one from each.
    #[cfg(feature = "complete")]
    Both,
}

/// A level with one of the margins, from one end or both.
/// `margin` is an index into the list of margins, which fall: a larger index is a smaller margin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Member {
    pub(super) level: u32,
    /// From the one asked for to the least.
    pub(super) margin: usize,
    pub(super) from: From,
    /// True if the car may rock: turn nearly on the spot.
    pub(super) is_rocking: bool,
    /// True if it follows the estimate more than its level does.
    #[cfg(feature = "complete")]
    pub(super) is_greedy: bool,
    /// True if a coarse search of the poses guides it.
    #[cfg(feature = "complete")]
    pub(super) is_guided: bool,
    /// How much finer its lattice is than the level's; 0 where it is not.
    #[cfg(feature = "complete")]
    pub(super) refinement: usize,
}

impl Member {
    /// What it searches.
    pub(super) fn level(self, config: &Config, is_least: bool) -> Level {
        let level = config.level(self.level);
        #[cfg(feature = "complete")]
        if self.is_rocking {
            return self.rocking_level(level, config);
        }
        #[cfg(feature = "complete")]
        if self.refinement > 0 {
            return level.refined(self.refinement, config);
        }
        #[cfg(feature = "complete")]
        if self.is_guided {
            let weight = config.heuristic_weight.unwrap_or(GUIDED_WEIGHT);
            let max_expansions = config.max_expansions.unwrap_or(GUIDED_EXPANSIONS);
            return Level { max_expansions, weight, ..level.with_cheap_changes(config) };
        }
        #[cfg(feature = "complete")]
        if self.from == From::Far {
            let weight = config.heuristic_weight.unwrap_or(FAR_WEIGHT);
            let max_expansions = config.max_expansions.unwrap_or(FAR_EXPANSIONS);
            return Level { max_expansions, weight, ..level.with_cheap_changes(config) };
        }
        #[cfg(feature = "complete")]
        if self.is_greedy {
            let weight = config.heuristic_weight.unwrap_or(GREEDY_WEIGHT);
            let max_expansions = config.max_expansions.unwrap_or(GREEDY_EXPANSIONS);
            return Level { max_expansions, weight, ..level };
        }
        if self.level == 1 && is_least {
            // What it saves on rocking is less than it costs on detours.
            return Level { extra_change: 0.0, ..level };
        }
        level
    }

    /// The level with shorter moves and rocks, and the budget of its kind.
    #[cfg(feature = "complete")]
    fn rocking_level(self, level: Level, config: &Config) -> Level {
        let most = if self.from == From::Both { BOTH_EXPANSIONS } else { ROCKING_EXPANSIONS };
        let max_expansions = config.max_expansions.map_or(most, |asked| most.min(asked));
        let level = Level { max_expansions, is_from_both: self.from == From::Both, ..level.rocking(config) };
        if self.level == FINE_ROCKING_LEVEL { level.fine_rocking(config) } else { level }
    }

    /// True if it is for a car that can hardly move.
    pub(super) fn is_last_resort(self) -> bool {
        #[cfg(feature = "complete")]
        if self.refinement > 0 {
            return true;
        }
        self.level >= FIRST_SHUFFLING_LEVEL
    }

    /// True if a search that this one has ended without a way leaves no hope for `other`: coarser ones reach no more,
    /// nor do any with more margin, nor do those that do not rock where this one does.
    pub(super) fn outdoes(self, other: Self) -> bool {
        // In another order other poses stand for the cells: a guided search proves nothing for those without a guide.
        #[cfg(feature = "complete")]
        if other.refinement > self.refinement || (self.is_guided && !other.is_guided) {
            return false;
        }
        other.from == self.from
            && other.margin <= self.margin
            && other.level <= self.level
            && (self.is_rocking || !other.is_rocking)
    }
}

/// From the hard end, without rocking.
fn plain(level: u32, margin: usize) -> Member {
    Member {
        level,
        margin,
        from: From::Hard,
        is_rocking: false,
        #[cfg(feature = "complete")]
        is_greedy: false,
        #[cfg(feature = "complete")]
        is_guided: false,
        #[cfg(feature = "complete")]
        refinement: 0,
    }
}

/// Whoever has not tried yet, what a driver likes best in front.
///
/// `levels` is the number of levels that the settings allow, `widest` the index of the largest margin with which a
/// disc reaches the other end. At most `levels` times `margins` entries, and some for cars that creep.
pub(super) fn members(levels: u32, widest: usize, margins: &[f64]) -> Vec<Member> {
    let least = margins.len() - 1;
    let mut members = Vec::new();
    #[cfg(feature = "complete")]
    let mut finer = refined(levels, widest, margins);
    for level in 1..levels {
        #[cfg(feature = "complete")]
        if level > FIRST_SHUFFLING_LEVEL {
            members.extend(finer.next());
        }
        members.extend((widest..=least).map(|margin| plain(level, margin)));
    }
    #[cfg(feature = "complete")]
    members.extend(finer);
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

/// The members that rock from the hard end with these margins.
#[cfg(feature = "complete")]
pub(super) fn rocking(margins: core::ops::Range<usize>) -> impl Iterator<Item = Member> {
    margins.map(|margin| Member { is_rocking: true, ..plain(ROCKING_LEVEL, margin) })
}

/// The members with ever finer lattices and the least margin with which a car need not creep. A car that gains
/// millimetres with each gear change never leaves the cell of a coarser one, which is then soon searched to its end.
#[cfg(feature = "complete")]
fn refined(levels: u32, widest: usize, margins: &[f64]) -> impl Iterator<Item = Member> {
    let comfortable = margins.iter().rposition(|&margin| margin >= COMFORTABLE_MARGIN);
    let margin = comfortable.filter(|&margin| margin >= widest && levels > FIRST_SHUFFLING_LEVEL);
    let refined = |margin| move |refinement| Member { refinement, ..plain(FINEST_PLAIN_LEVEL, margin) };
    margin.into_iter().flat_map(move |margin| (1..=REFINEMENTS).map(refined(margin)))
}

/// The members for open space, which the small module lacks. Unless another estimate is asked for, the first two search
/// from either end, guided by a coarse search of the poses: among clutter that finds most ways in a hundredth of the
/// work. The next goes from the other end without a guide. Where `is_unproven`, the coarsest search with the least
/// margin then goes on from where its budget ended, greedily. The others rock with the least margin: on two lattices
/// from the hard end, and from both ends.
#[cfg(feature = "complete")]
pub(super) fn in_open_space(config: &Config, least: usize, may_swap: bool, is_unproven: bool) -> Vec<Member> {
    let levels = config.levels();
    let guided = Member { is_guided: true, ..plain(1, least) };
    let far = Member { from: From::Far, ..plain(1, least) };
    let mut members = vec![guided, Member { is_guided: true, ..far }, far];
    if config.heuristic != Heuristic::Max {
        members.retain(|one| !one.is_guided);
    }
    if is_unproven {
        members.push(Member { is_greedy: true, ..plain(1, least) });
    }
    let coarse = Member { is_rocking: true, ..plain(ROCKING_LEVEL, least) };
    members.push(coarse);
    members.push(Member { level: FINE_ROCKING_LEVEL, ..coarse });
    members.push(Member { from: From::Both, ..coarse });
    members.retain(|one| one.level < levels && (may_swap || one.from == From::Hard));
    members
}

/// Sorts stably. The members are few; the library's sort takes kilobytes of the module.
pub(super) fn arrange(members: &mut [Member], key: &dyn Fn(&Member) -> [usize; 3]) {
    for end in 1..members.len() {
        let mut at = end;
        while at > 0 && key(&members[at - 1]) > key(&members[at]) {
            members.swap(at - 1, at);
            at -= 1;
        }
    }
}
