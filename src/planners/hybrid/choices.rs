//! Paths to choose between, beside the ordinary answer: with fewer gear changes, shorter, quicker, with more room.
//!
//! The ordinary answer is the cheapest by one sum of several costs. Somebody who looks at it often asks for an
//! extreme instead, and an extreme is found by a search of its own:
//!
//! * *Fewest gear changes*: a change costs more than any way, so the search goes through all poses that can be
//!   reached with no change, then with one, and so on.
//! * *Shortest*: length is the only cost. Fine steps by the ordinary costs often find as short a path that is easier to
//!   drive, which also betters the ordinary answer.
//! * *Fastest*: length plus the distances that the car could have driven while it changes gear and turns the wheel.
//! * *Widest*: the margin is the largest with which there is a path, found by trying shares of the room at the ends
//!   and halving the gap between the last that fails and the first that succeeds.
//!
//! Where nothing is preferred, a cheaper path by the ordinary costs is worth as much: what other settings find is
//! compared by these costs (`elsewhere`).
//!
//! Each search has its own limit of expansions. It is as deterministic as the ordinary plan, and no result is proven
//! the best of its kind.

mod cheapest;
mod elsewhere;
mod fewest;

use core::ops::ControlFlow;

use super::config::{Config, SearchFrom};
use super::lattices::{Effort, FIRST_SHUFFLING_LEVEL, Level};
use super::portfolio::{COMFORTABLE_MARGIN, Floods};
use super::profile::FEW_CHANGES;
use super::question::{Query, Scratch, Search, Work};
use super::report::{Report, Status};
use super::widest::{self, GAP_PARTS, MARGIN_SHARES};
use crate::geometry::{Pose, arcs};
use crate::json;
use crate::search::Progress;
use crate::vehicle::collision::CollisionChecker;
use fewest::{CREEPING_PASSES, FEWER_CHANGES_MARGINS, creeping_levels, layered};

/// The preference by which a path is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Prefer {
    /// The shortest.
    Shortest,
    /// The one with the fewest gear changes, and of those the shortest.
    FewestChanges,
    /// The one that stays farthest from every obstacle.
    Widest,
    /// The one that takes the least time to drive.
    Fastest,
}

json::words!(Prefer: "shortest" = Shortest, "fewest-changes" = FewestChanges, "widest" = Widest, "fastest" = Fastest);

/// More room than this is room enough, metres.
const ENOUGH_CLEARANCE: f64 = 1.0;
/// Expansions of each level's search with one margin.
const WIDER_EXPANSIONS: [u32; 2] = [3000, 8000];
/// Expansions of each search for fewer gear changes in layers.
const LAYER_EXPANSIONS: u32 = 5000;
/// The finest level on which fewer are looked for by a price.
const FINEST_PRICED_LEVEL: u32 = 3;
/// Extra cost of a gear change there, metres, …
const EXTRA_CHANGE_COST: f64 = 5.0;
/// … and expansions of each such search.
const PRICED_EXPANSIONS: u32 = 20_000;
/// Weight of the estimate on the lattice with half the steps.
const FINE_LAYERS_WEIGHT: f64 = 2.0;
/// A car that creeps into a slot keeps this much, metres: with it all lattices are searched from both ends.
const CREEPING_MARGIN: f64 = 0.01;
/// The levels that are searched with and without room for the shortcut from the start, too.
const SWAPPED_TWICE: [u32; 2] = [1, 2];
/// Expansions of each such search.
const CREEPING_EXPANSIONS: u32 = 60_000;
/// Time of a gear change, expressed in metres at full speed.
const CHANGE_TIME: f64 = 6.0;
/// Time to turn the wheel from straight to full lock, expressed in metres at full speed.
const STEER_TIME: f64 = 0.3;

/// Searches for paths that are better than `first` by `prefer`, or in any way where nothing is preferred; with several
/// `goals` to any of them. Each is given to `offer`, which answers whether to go on. The counters in each, and in the
/// empty report returned, count everything so far, `first` included.
///
/// Poses are in world coordinates, `first` is the ordinary answer to the same question, and the paths offered have
/// their status at [`Status::Suboptimal`]. A caller that wants the best by `prefer` compares them itself: several may
/// be offered, and one that is offered later is not always better.
pub fn choices(
    query: &Query,
    (config, goals): (&Config, &[Pose]),
    (first, prefer): (&Report, Option<Prefer>),
    (scratch, progress): (&mut Scratch, &mut Option<Progress>),
    offer: &mut dyn FnMut(Report) -> ControlFlow<()>,
) -> Report {
    let checker = CollisionChecker::new(query.obstacles, query.vehicle);
    let [start, goal] = [query.start, query.goal].map(|pose| query.obstacles.local(pose));
    let locals: Vec<Pose> = goals.iter().map(|&pose| query.obstacles.local(pose)).collect();
    let is_inside = |goal: &Pose| query.obstacles.inside(goal.point()).is_none();
    let free = |goal: &Pose| is_inside(goal) && checker.hit(*goal, 0.0).is_none();
    let goals: Vec<Pose> = locals.into_iter().filter(free).collect();
    let goals = if goals.len() > 1 { &goals[..] } else { &[] };
    let widest = if goals.is_empty() { 0.0 } else { widest::clearance(&checker, start, &first.arcs) };
    let mut margins = if goals.is_empty() {
        let room = checker.clearance(start, ENOUGH_CLEARANCE).min(checker.clearance(goal, ENOUGH_CLEARANCE));
        MARGIN_SHARES.map(|share| share * room).to_vec()
    } else {
        widest::margins(&checker, start, goals, widest)
    };
    margins.retain(|&margin| margin > first.margin);
    let parts = if goals.is_empty() { 1 } else { GAP_PARTS };
    let kept = margins.len();
    margins.push(first.margin);
    margins.extend(FEWER_CHANGES_MARGINS.into_iter().filter(|&margin| margin < first.margin));
    let mirrored = !goals.is_empty() || first.from_goal || config.search_from == SearchFrom::Both;
    let [root, target] = if mirrored { [goal, start] } else { [start, goal] };
    let floods = Floods::with(query, [target, root], margins);
    let config = &Config { search_from: SearchFrom::Goal, ..*config };
    let flood = floods.get(kept, false);
    let (tight, trace) = (false, false);
    let search = Search {
        query,
        config,
        checker: &checker,
        flood,
        root,
        target,
        mirrored,
        start,
        goal,
        tight,
        trace,
        poses: None,
        goals,
    };
    let mut report = first.counters();
    let work = Work { report: &mut report, scratch, progress };
    let changes = arcs::direction_changes(&first.arcs);
    let mut run = Run { search, floods: &floods, kept, parts, widest, changes, first, work, offer };
    let _ = run.all(prefer);
    report.collision_checks += checker.checks();
    report
}

/// Whether the search goes on (true), and the arcs found.
/// The caller ends the run by its answer to an offer, or by ending the progress.
type Goes<T = ()> = ControlFlow<(), T>;

/// The searches for paths beside the first.
/// Each search goes through `attempt`, which offers what it finds and adds what it cost.
struct Run<'a, 'p> {
    search: Search<'a>,
    floods: &'a Floods<'a>,
    /// Which margin the first path keeps; those before it are larger.
    kept: usize,
    /// Every how many of those are tried before the ones between.
    parts: usize,
    /// Clearance of the widest path so far to one of several goals, metres.
    widest: f64,
    /// Gear changes of the path with the fewest so far.
    changes: u32,
    first: &'a Report,
    work: Work<'a, 'p>,
    offer: &'a mut dyn FnMut(Report) -> Goes,
}

impl Run<'_, '_> {
    /// Runs the searches for what is preferred, those whose results help the later ones first.
    fn all(&mut self, prefer: Option<Prefer>) -> Goes {
        let wants = |one| prefer.is_none_or(|prefer| prefer == one);
        if prefer.is_none() {
            self.elsewhere()?;
        }
        if wants(Prefer::FewestChanges) {
            self.fewer_changes()?;
        }
        if wants(Prefer::Shortest) {
            self.cheaper(0.0, 0.0)?;
            self.by_fine_steps(*self.search.config)?;
        }
        if wants(Prefer::Fastest) {
            self.cheaper(CHANGE_TIME, STEER_TIME)?;
        }
        if wants(Prefer::Widest) {
            self.wider()?;
        }
        Goes::Continue(())
    }

    /// The fewest gear changes, and of those paths the shortest, with the margin kept and, where less saves some, with
    /// less. In layers on the coarsest lattice, from both ends; on finer ones, which would spend all they have on the
    /// first layers, by a price that is worth a detour. From the other end fine steps only spend their
    /// budget: it is the one with room.
    fn fewer_changes(&mut self) -> Goes {
        for margin in self.kept..self.floods.count() {
            self.layers(margin, false)?;
            if self.work.report.status != Status::NoPath {
                self.layers(margin, true)?;
            }
            self.fine_layers(margin)?;
            for number in 1..=FINEST_PRICED_LEVEL {
                self.fewer_by_price(number, margin)?;
            }
            if self.creeps(margin) && self.floods.margin(margin) == CREEPING_MARGIN {
                self.creep(margin)?;
            }
        }
        Goes::Continue(())
    }

    /// True if a path with one of the margins keeps less than the first and less than is comfortable. A car creeps for
    /// fewer changes, not for a shorter way with as many.
    fn creeps(&self, margin: usize) -> bool {
        margin > self.kept && self.floods.margin(margin) < COMFORTABLE_MARGIN
    }

    /// A path with fewer gear changes, with hardly any margin: each lattice finds it in some slots. What takes too many
    /// is left out, so that a search soon ends where there is nothing to gain; a second one leaves room for what the
    /// shortcut saves, and in a third one a change is dearer. From the start they find other ways than from the slot,
    /// and take long.
    fn creep(&mut self, margin: usize) -> Goes {
        let config = *self.search.config;
        if config.levels() < FIRST_SHUFFLING_LEVEL {
            return Goes::Continue(());
        }
        // From the start a search leads to one goal.
        let ends = if self.search.goals.is_empty() { &[false, true][..] } else { &[false] };
        for &is_swapped in ends {
            for (level, number) in creeping_levels(&config) {
                let is_once = is_swapped && !SWAPPED_TWICE.contains(&number);
                let passes = if is_swapped { 2 - usize::from(is_once) } else { CREEPING_PASSES.len() };
                for &(more, extra_change) in &CREEPING_PASSES[..passes] {
                    if self.changes < 2 || (is_swapped && self.changes <= FEW_CHANGES) {
                        return Goes::Continue(());
                    }
                    let level = Level { extra_change, ..level.with_changes(self.changes - 1 + more) };
                    self.attempt(&config, (level, number, CREEPING_EXPANSIONS), margin, is_swapped)?;
                }
            }
        }
        Goes::Continue(())
    }

    /// All that can be reached without a gear change, then with one, and so on, short of as many as are known: layers
    /// of one search of the coarsest lattice, in which a change is dearer than any way.
    fn layers(&mut self, margin: usize, is_swapped: bool) -> Goes {
        let config = *self.search.config;
        // From the start a search leads to one goal.
        if self.changes == 0 || (is_swapped && !self.search.goals.is_empty()) {
            return Goes::Continue(());
        }
        let known = arcs::length(&self.first.arcs);
        let level = layered(config.level(0), &config, (known, self.changes));
        self.attempt(&config, (level, 0, LAYER_EXPANSIONS), margin, is_swapped)?;
        if !is_swapped && self.changes > 0 {
            // The order of the search decides which pose stands for a cell. Without an estimate it goes through each
            // layer as an exhaustive search does, and misses nothing that this one finds.
            let all = Level { weight: 0.0, ..layered(config.level(0), &config, (known, self.changes)) };
            self.attempt(&config, (all, 0, LAYER_EXPANSIONS), margin, false)?;
        }
        Goes::Continue(())
    }

    /// The same on a lattice with half the cells and steps, greedily: where few changes are left, the last one to save
    /// may need a place to turn round that coarse steps pass by.
    fn fine_layers(&mut self, margin: usize) -> Goes {
        if !(1..=FEW_CHANGES).contains(&self.changes) {
            return Goes::Continue(());
        }
        let config = *self.search.config;
        let known = (arcs::length(&self.first.arcs), self.changes);
        let level = layered(config.level(0).halved(), &config, known).with_changes(self.changes - 1);
        let level = level.within((FINE_LAYERS_WEIGHT, PRICED_EXPANSIONS), &config);
        self.attempt(&config, (level, 0, PRICED_EXPANSIONS), margin, false)?;
        Goes::Continue(())
    }

    /// A path with fewer gear changes on a fine lattice, where a change costs 5 m more than usual.
    fn fewer_by_price(&mut self, number: u32, margin: usize) -> Goes {
        let config = *self.search.config;
        if number >= config.levels() || self.changes < 2 {
            return Goes::Continue(());
        }
        let level = config.level(number);
        let level = if self.creeps(margin) { level.trying_all() } else { level };
        let level = Level { extra_change: EXTRA_CHANGE_COST, ..level };
        self.attempt(&config, (level, number, PRICED_EXPANSIONS), margin, false)?;
        Goes::Continue(())
    }

    /// A path with the largest margin that there is one with, and with that margin a path to each goal that has more
    /// room.
    fn wider(&mut self) -> Goes {
        let tried = (0..self.kept).step_by(self.parts);
        let (mut found, mut failed) = (self.kept, self.kept);
        for margin in tried {
            if self.with_margin(margin)? {
                (found, failed) = (margin, margin.saturating_sub(self.parts));
                break;
            }
        }
        while found > failed + 1 {
            let middle = usize::midpoint(found, failed);
            if self.with_margin(middle)? {
                found = middle;
            } else {
                failed = middle;
            }
        }
        self.wider_to_each(found)
    }

    /// A path with one of the margins to each goal that has more room than any path so far, those with the most room
    /// first.
    fn wider_to_each(&mut self, margin: usize) -> Goes {
        let goals = self.search.goals;
        for (room, at) in widest::by_room(self.search.checker, self.search.start, goals) {
            if room <= self.widest {
                break;
            }
            self.search.goals = &goals[at..=at];
            self.with_margin(margin)?;
        }
        self.search.goals = goals;
        Goes::Continue(())
    }

    /// A path with one of the margins; tells whether there is one.
    fn with_margin(&mut self, margin: usize) -> Goes<bool> {
        let config = *self.search.config;
        for (number, most) in (0..config.levels()).zip(WIDER_EXPANSIONS) {
            // The descent would give away what a path keeps beyond its margin.
            let level = Level { effort: Effort::Shortcut, ..config.level(number) };
            if self.attempt(&config, (level, number, most), margin, false)? {
                return Goes::Continue(true);
            }
        }
        Goes::Continue(false)
    }

    /// One search with at most so many expansions; tells whether there is a path, which is offered.
    fn attempt(
        &mut self,
        config: &Config,
        (level, number, most): (Level, u32, u32),
        margin: usize,
        is_swapped: bool,
    ) -> Goes<bool> {
        self.work.report.status = Status::NoPath;
        let flood = self.floods.get(margin, is_swapped);
        let search = Search { config, ..self.search };
        let search = if is_swapped { search.swapped(flood) } else { Search { flood, ..search } };
        let reaches = |pose: Pose| flood.distance(pose).is_finite();
        if !reaches(search.root) && !search.goals.iter().any(|&goal| reaches(goal)) {
            return Goes::Continue(false);
        }
        let level = Level { max_expansions: most.min(level.max_expansions), ..level };
        (self.work.report.margin, self.work.report.level) = (self.floods.margin(margin), number);
        let found = search.level(level, &mut self.work);
        if self.work.progress.as_ref().is_some_and(Progress::is_stopped) {
            return Goes::Break(());
        }
        if found {
            let counters = self.work.report.counters();
            let path = core::mem::replace(self.work.report, counters);
            self.work.report.status = Status::Suboptimal;
            if self.creeps(margin) && arcs::direction_changes(&path.arcs) >= self.changes {
                return Goes::Continue(true);
            }
            self.take(path)?;
        }
        Goes::Continue(found)
    }

    /// Offers a path at what it costs by the settings asked for.
    fn take(&mut self, path: Report) -> Goes {
        let Search { checker, start, .. } = self.search;
        self.changes = self.changes.min(arcs::direction_changes(&path.arcs));
        if !self.search.goals.is_empty() {
            self.widest = self.widest.max(widest::clearance(checker, start, &path.arcs));
        }
        let cost = self.search.arrived(&path.arcs).costs().path(checker, start, &path.arcs);
        (self.offer)(Report { cost, status: Status::Suboptimal, ..path })
    }
}

#[cfg(test)]
mod tests;
