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
//! have been found there. One of its members goes on for long and takes gear changes lightly, one rocks from both ends.

use super::members::{FINE_ROCKING_LEVEL, From, Member, ROCKING_LEVEL, Style, plain, rocking};
use crate::planners::hybrid::config::{Config, Heuristic};

/// The level of those that go on for long.
const DOGGED_LEVEL: u32 = 2;

/// The first group. Unless another estimate is asked for, the first two search from either end, guided by a coarse
/// search of the poses. The next goes from the other end without a guide. The others rock with the least margin, on two
/// lattices, and on the finer one from the other end, too.
pub(super) fn first(config: &Config, least: usize, may_swap: bool) -> Vec<Member> {
    let coarsest = |from, style| Member { from, style, ..plain(1, least) };
    let mut members = Vec::new();
    if config.heuristic == Heuristic::Max {
        members.extend([coarsest(From::Hard, Style::Guided), coarsest(From::Far, Style::Guided)]);
    }
    members.push(coarsest(From::Far, Style::Plain));
    members.extend([ROCKING_LEVEL, FINE_ROCKING_LEVEL].map(|level| rocking(level, least)));
    // In a narrow corner the pose that stands for a cell decides, and from the other end another does.
    members.push(Member { from: From::Far, ..rocking(FINE_ROCKING_LEVEL, least) });
    allowed(members, config, may_swap)
}

/// The second group: one that goes on for long, and one that rocks from both ends.
pub(super) fn last(config: &Config, least: usize, may_swap: bool) -> Vec<Member> {
    let dogged = Member { style: Style::Dogged, ..plain(DOGGED_LEVEL, least) };
    let both = Member { from: From::Both, ..rocking(ROCKING_LEVEL, least) };
    allowed(vec![dogged, both], config, may_swap)
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

/// Those that the settings allow.
fn allowed(mut members: Vec<Member>, config: &Config, may_swap: bool) -> Vec<Member> {
    members.retain(|one| one.level < config.levels() && (may_swap || one.from == From::Hard));
    members
}
