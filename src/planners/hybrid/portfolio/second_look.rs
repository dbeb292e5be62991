//! A second look where a path changes gear often: more searches in which a change is dear.
//!
//! Whoever answers first may rock where another drives on: in a tight slot coarse lattices soon end, and the first that
//! gets out takes two changes where a finer one takes one. So the path is held against the coarsest lattice with the
//! same margin and from the same end. A gear change costs several metres in it. What cannot be cheaper by that price
//! than the known path is left out, and so is what takes as many changes, but for those that the shortcut may save: a
//! search soon ends where there is nothing to gain.
//!
//! A path with a large margin gives it up, down to what is comfortable, where that saves enough gear changes
//! (`known_paths`). One with many changes is held against finer lattices: what one misses the next one finds. They
//! shorten the moves that something blocks: what a fixed step leaves of a slot's room falls and rises with the length
//! of the slot, and a longer one must not take more changes for that. Some of them are lent some margin, which makes
//! the slot longer; their path must regain it (`regain`). A path that keeps no more than is comfortable is held against
//! the same searches with its own margin.
//!
//! Before that moves are squeezed out of the known path (`squeeze`): with its margin, and then with no more than is
//! comfortable; and out of the next best path that was found. Then others are pressed out of both in the same way
//! (`press`), and later out of each better path that a search finds. That saves more changes than the searches do.
//!
//! Out of a path with many changes that the first level found, moves are only squeezed and pressed: that level has
//! already searched for one with fewer.

use super::floods::Floods;
use super::known_paths::changes_to_save;
use super::members::{COMFORTABLE_MARGIN, MANY_CHANGES};
use crate::geometry::arcs;
use crate::planners::hybrid::lattices::{Effort, FIRST_SHUFFLING_LEVEL, Level};
use crate::planners::hybrid::profile::{FEW_CHANGES, MANY_CHANGES_COST};
use crate::planners::hybrid::question::{Search, Work};
use crate::planners::hybrid::report::{Report, Status};

/// Weight of the estimate.
const WEIGHT: f64 = 2.0;
/// Expansions of the coarsest lattice, …
const COARSE_EXPANSIONS: u32 = 5000;
/// … of those between, …
const FINE_EXPANSIONS: u32 = 20_000;
/// … and of those that are lent some margin.
const LENT_EXPANSIONS: u32 = 12_000;
/// Where there are more gear changes than this, a search on a fine lattice with a comfortable margin is worth more: …
const VERY_MANY_CHANGES: u32 = 8;
/// … so many expansions for each of them.
const EXPANSIONS_PER_CHANGE: u32 = 5000;
/// The level that lattices beside it are told by.
const FINE_LEVEL: u32 = 2;
/// Lattices with larger cells are coarse, metres.
const COARSE: f64 = 0.06;
/// A path may cost so many times what is left of it after the shortcut.
const BEFORE_SHORTCUT: f64 = 1.6;

/// Squeezes moves out of the path in `work`, where it changes gear often, and out of `next_best`, another one that was
/// found; then presses others out of both.
pub(super) fn save_moves(search: Search, floods: &Floods, next_best: Option<&Report>, work: &mut Work) {
    let Some((_, less)) = margins(&search, floods, work.report) else { return };
    let less = floods.margin(less);
    for save in [Search::squeeze, Search::press] {
        let known = work.report.clone();
        save_in(&search, save, (&known, known.margin), work);
        if let Some(next_best) = next_best {
            save_in(&search, save, (next_best, less), work);
        }
        if work.report.margin > less {
            let known = work.report.clone();
            save_in(&search, save, (&known, less), work);
        }
    }
}

/// A way of saving moves.
type Save<'a> = fn(&Search<'a>, Level, f64, &Report) -> Option<Report>;

/// Saves moves in a path with a margin. What comes of that takes the place of the path in `work` if it costs less and
/// saves enough gear changes.
fn save_in<'a>(search: &Search<'a>, save: Save<'a>, (path, margin): (&Report, f64), work: &mut Work) {
    let known = &work.report;
    if changes(known).min(changes(path)) <= FEW_CHANGES {
        return;
    }
    let saved = if margin < known.margin { changes_to_save(known) } else { 1 };
    let limits = (changes(known).saturating_sub(saved), known.cost);
    if let Some(better) =
        save(search, search.config.level(1), margin, path).filter(|path| is_within(limits, path))
    {
        *work.report = work.report.with_path_of(better);
    }
}

/// Replaces the path in `work`, where it changes gear often, by one with fewer changes: by a cheaper one with the same
/// margin, or by one with less. `next_best` is another one that was found.
pub(super) fn look_again(search: Search, floods: &Floods, next_best: Option<&Report>, work: &mut Work) {
    let config = search.config;
    let Some((kept, less)) = margins(&search, floods, work.report) else { return };
    save_moves(search, floods, next_best, work);
    let plain = |level, number, few| Look { level, number, most: FINE_EXPANSIONS, few, is_lent: false };
    let coarsest = Look { most: COARSE_EXPANSIONS, ..plain(config.level(0), 0, FEW_CHANGES) };
    if less > kept {
        attempt((search, floods), coarsest, kept, 1, work);
    }
    let coarse = config.level(1).shortening();
    let beside = |number, few| plain(config.level(FINE_LEVEL).beside(number).shortening(), FINE_LEVEL, few);
    let up_to_contact = plain(config.level(FINE_LEVEL).up_to_contact(), FIRST_SHUFFLING_LEVEL, MANY_CHANGES);
    let lent = |look| Look { most: LENT_EXPANSIONS, is_lent: true, ..look };
    // Less margin saves gear changes where there are few, too.
    let few = if less > kept { FEW_CHANGES } else { MANY_CHANGES };
    let looks = [coarsest, plain(coarse, 1, few), lent(beside(1, FEW_CHANGES)), lent(up_to_contact)];
    for look in looks {
        let before = changes(work.report);
        if before > look.few {
            attempt((search, floods), look, less, changes_to_save(work.report), work);
        }
        if changes(work.report) < before {
            let known = work.report.clone();
            save_in(&search, Search::press, (&known, floods.margin(less)), work);
        }
    }
}

/// The places of two margins in the list: of what a path keeps, and of what it may keep. Nothing where it changes gear
/// seldom, or the settings ask for few levels.
fn margins(search: &Search, floods: &Floods, path: &Report) -> Option<(usize, usize)> {
    if changes(path) <= FEW_CHANGES || search.config.levels() <= FIRST_SHUFFLING_LEVEL {
        return None;
    }
    let at = |margin: f64| floods.margins.iter().position(|&one| one == margin);
    let kept = at(path.margin)?;
    Some((kept, at(COMFORTABLE_MARGIN).map_or(kept, |comfortable| comfortable.max(kept))))
}

/// One more search.
#[derive(Clone, Copy)]
struct Look {
    level: Level,
    number: u32,
    /// Expansions, at most.
    most: u32,
    /// Where there are no more gear changes than this, it is left out.
    few: u32,
    /// True if it may keep the next smaller margin, and its path is to regain the other.
    is_lent: bool,
}

/// True if a path has so many gear changes at most, and costs less than so much.
fn is_within((most_changes, limit): (u32, f64), path: &Report) -> bool {
    changes(path) <= most_changes && path.cost < limit
}

fn changes(report: &Report) -> u32 {
    arcs::direction_changes(&report.arcs)
}

/// Takes the path of one more search, if it costs less and saves so many gear changes.
fn attempt(
    (search, floods): (Search, &Floods),
    Look { level, number, most, is_lent, .. }: Look,
    margin: usize,
    saved: u32,
    work: &mut Work,
) {
    let config = search.config;
    let wanted = floods.margin(margin);
    let margin = (margin + usize::from(is_lent)).min(floods.count() - 1);
    let is_swapped = work.report.from_goal != search.mirrored;
    let flood = floods.get(margin, is_swapped);
    let search = if is_swapped { search.swapped(flood) } else { Search { flood, ..search } };
    let counters = work.report.counters();
    let known = core::mem::replace(work.report, counters);
    (work.report.margin, work.report.level) = (floods.margin(margin), number);
    let before = changes(&known);
    let is_comfortable = floods.margin(margin) >= COMFORTABLE_MARGIN;
    let is_worth_more = number > 0 && is_comfortable && before > VERY_MANY_CHANGES;
    let most = if is_worth_more { EXPANSIONS_PER_CHANGE * before } else { most };
    let effort = match before {
        _ if !is_lent => Effort::Descent,
        ..=VERY_MANY_CHANGES => Effort::Shortcut,
        _ => Effort::Descent,
    };
    let level = Level {
        max_expansions: level.max_expansions.min(most),
        weight: config.heuristic_weight.unwrap_or(WEIGHT),
        extra_change: MANY_CHANGES_COST,
        effort,
        ..level.cheaply_tried(&config.level(0))
    };
    // The shortcut may save some, the more so the coarser the steps and the longer the path.
    let more =
        if number == 0 { saved } else { u32::from(level.xy > COARSE) + before.saturating_sub(MANY_CHANGES) };
    let level = level.with_changes((before + more).saturating_sub(saved));
    let bound =
        BEFORE_SHORTCUT * search.costs().searching(&level).path(search.checker, search.start, &known.arcs);
    let limits = (before.saturating_sub(saved), known.cost);
    let is_better = search.level_below(limits, Level { bound, ..level }, work)
        && (work.report.margin >= wanted
            || search.regain(level, wanted, work.report) && is_within(limits, work.report));
    if is_better {
        work.report.status = Status::Suboptimal;
    }
    if !is_better {
        *work.report = work.report.with_path_of(known);
    }
}
