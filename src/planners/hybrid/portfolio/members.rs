//! The members of the portfolio: who they are, what they search, and in which order they are asked.
//!
//! The order is that of a driver's wishes: first a comfortable margin with coarse steps, then smaller margins, then
//! finer steps, at last the searches that creep or rock out of the tightest slots. One member stands out of that
//! order. The coarsest search with the least margin goes early, because it reaches more than any other of its level:
//! where it ends without a path, it rules out many others at once (`outdoes`). Before the finest steps a few searches
//! rock: where a car gets out only by turning nearly on the spot, fine steps go on for long.

use crate::IS_COMPLETE;
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::lattices::{CHEAP_CHANGE_COST, FIRST_SHUFFLING_LEVEL, Level, REFINEMENTS};

/// With less than this a car creeps, metres.
pub(in crate::planners::hybrid) const COMFORTABLE_MARGIN: f64 = 0.03;
/// Expansions of the first slice.
pub(super) const FIRST_SLICE: u32 = 8192;
/// With more gear changes than this, finer steps may find a path with fewer.
pub(in crate::planners::hybrid) const MANY_CHANGES: u32 = 4;

/// The coarser of the levels that rock.
pub(super) const ROCKING_LEVEL: u32 = 2;
/// Up to this level a search with the least margin is worth its while before finer ones with more are.
const LAST_CHEAP_LEVEL: u32 = 3;
/// The finer of the levels that rock.
pub(super) const FINE_ROCKING_LEVEL: u32 = 3;
/// The level that is refined.
const FINEST_PLAIN_LEVEL: u32 = FIRST_SHUFFLING_LEVEL - 1;
/// Weight of the estimate where a coarse search of the poses guides, and its expansions, …
const GUIDED: (f64, u32) = (4.0, 60_000);
/// … in a search from the other end, …
const FAR: (f64, u32) = (3.0, 60_000);
/// … and in those that are asked when others have spent their work in vain.
const DOGGED: (f64, u32) = (3.0, 130_000);
/// What a gear change costs in them, metres.
const DOGGED_CHANGE_COST: f64 = 0.5;
/// Expansions of each search that rocks from the hard end, …
const ROCKING_EXPANSIONS: u32 = 100_000;
/// … and of the one from both ends.
const BOTH_EXPANSIONS: u32 = 40_000;

/// Where a tree grows from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum From {
    /// The end that is hard to leave.
    Hard,
    /// The other end.
    Far,
    /// Two trees, one from each.
    Both,
}

/// How a member searches its level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Style {
    /// As the level says.
    Plain,
    /// Guided by a coarse search of the poses.
    Guided,
    /// The car may rock: turn nearly on the spot.
    Rocking,
    /// Goes on for long, and gear changes cost little.
    Dogged,
    /// On one of the lattices that are finer than the level's, from 1 on.
    Refined(usize),
}

/// A level with one of the margins, from one end or both.
/// `margin` is an index into the list of margins, which fall: a larger index is a smaller margin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Member {
    pub(super) level: u32,
    /// From the one asked for to the least.
    pub(super) margin: usize,
    pub(super) from: From,
    pub(super) style: Style,
}

impl Member {
    /// What it searches.
    pub(super) fn level(self, config: &Config, is_least: bool) -> Level {
        let level = config.level(self.level);
        if IS_COMPLETE && (self.from, self.style) != (From::Hard, Style::Plain) {
            return self.open_space_level(level, config);
        }
        // What it saves on rocking is less than it costs on detours.
        if self.level == 1 && is_least { Level { extra_change: 0.0, ..level } } else { level }
    }

    /// The level with the prices and the budget of a style, or of a search from the other end.
    fn open_space_level(self, level: Level, config: &Config) -> Level {
        match self.style {
            Style::Guided => level.with_change(CHEAP_CHANGE_COST, config).within(GUIDED, config),
            Style::Dogged => level.with_change(DOGGED_CHANGE_COST, config).within(DOGGED, config),
            Style::Rocking => self.rocking_level(level, config),
            Style::Refined(number) => level.refined(number, config),
            Style::Plain => level.with_change(CHEAP_CHANGE_COST, config).within(FAR, config),
        }
    }

    /// The level with shorter moves and rocks, and the budget of its kind.
    fn rocking_level(self, level: Level, config: &Config) -> Level {
        let most = if self.from == From::Both { BOTH_EXPANSIONS } else { ROCKING_EXPANSIONS };
        let max_expansions = config.max_expansions.map_or(most, |asked| most.min(asked));
        let level = Level { max_expansions, is_from_both: self.from == From::Both, ..level.rocking(config) };
        if self.level == FINE_ROCKING_LEVEL { level.fine_rocking(config) } else { level }
    }

    /// True if it is for a car that can hardly move.
    pub(super) fn is_last_resort(self) -> bool {
        self.level >= FIRST_SHUFFLING_LEVEL || (IS_COMPLETE && matches!(self.style, Style::Refined(_)))
    }

    /// True if a search that this one has ended without a way leaves no hope for `other`: coarser ones reach no more,
    /// nor do any with more margin, nor do those that do not rock where this one does.
    pub(super) fn outdoes(self, other: Self) -> bool {
        other.from == self.from
            && other.margin <= self.margin
            && other.level <= self.level
            && self.style.outdoes(other.style)
    }
}

impl Style {
    /// True if what a search in this style cannot reach, none in the other can.
    fn outdoes(self, other: Self) -> bool {
        match (self, other) {
            _ if !IS_COMPLETE => true,
            // In another order other poses stand for the cells: neither proves anything for those in a usual one.
            (Self::Guided, _) => other == Self::Guided,
            (Self::Dogged, _) | (_, Self::Dogged) => false,
            (_, Self::Refined(other)) => matches!(self, Self::Refined(this) if this >= other),
            (_, Self::Rocking) => self == Self::Rocking,
            _ => true,
        }
    }
}

/// From the hard end, in no special style.
pub(super) fn plain(level: u32, margin: usize) -> Member {
    Member { level, margin, from: From::Hard, style: Style::Plain }
}

/// From the hard end, for a car that may rock.
pub(super) fn rocking(level: u32, margin: usize) -> Member {
    Member { style: Style::Rocking, ..plain(level, margin) }
}

/// Whoever has not tried yet, what a driver likes best in front.
///
/// `levels` is the number of levels that the settings allow, `widest` the index of the largest margin with which a
/// disc reaches the other end. At most `levels` times `margins` entries, and some for cars that creep.
pub(super) fn members(levels: u32, widest: usize, margins: &[f64]) -> Vec<Member> {
    let least = margins.len() - 1;
    let mut members = Vec::new();
    let mut finer = refined(levels, widest, margins);
    for level in 1..levels {
        if level > FIRST_SHUFFLING_LEVEL {
            members.extend(finer.next());
        }
        members.extend((widest..=least).map(|margin| plain(level, margin)));
    }
    members.extend(finer);
    if IS_COMPLETE && levels > FIRST_SHUFFLING_LEVEL {
        let comfortable = (widest..=least).filter(|&margin| margins[margin] >= COMFORTABLE_MARGIN);
        members.extend(comfortable.map(|margin| rocking(ROCKING_LEVEL, margin)));
    }
    // Sorted by level and margin before.
    arrange(&mut members, &|&Member { level, margin, style, .. }| {
        let is_comfortable = margins[margin] >= COMFORTABLE_MARGIN || margin == widest;
        match level {
            _ if IS_COMPLETE && style == Style::Rocking => [4, 0, 0],
            // Searched to the end with the least margin, the coarsest proves soonest that there is hardly a way.
            1 if margin == widest => [0; 3],
            1 if margin == least => [1, 0, 0],
            1..=LAST_CHEAP_LEVEL if is_comfortable => [2, margin, 0],
            1..=LAST_CHEAP_LEVEL if margin == least => [3, 0, 0],
            _ if is_comfortable => [5, 0, 0],
            _ => [6, 0, 0],
        }
    });
    members
}

/// The members with ever finer lattices and the least margin with which a car need not creep. A car that gains
/// millimetres with each gear change never leaves the cell of a coarser one, which is then soon searched to its end.
fn refined(levels: u32, widest: usize, margins: &[f64]) -> impl Iterator<Item = Member> {
    let comfortable = margins.iter().rposition(|&margin| margin >= COMFORTABLE_MARGIN);
    let margin = comfortable.filter(|&margin| margin >= widest && levels > FIRST_SHUFFLING_LEVEL);
    let refined =
        |margin| move |number| Member { style: Style::Refined(number), ..plain(FINEST_PLAIN_LEVEL, margin) };
    let margin = margin.filter(|_| IS_COMPLETE);
    margin.into_iter().flat_map(move |margin| (1..=REFINEMENTS).map(refined(margin)))
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
