//! Paths to choose between, beside the ordinary answer: with fewer gear changes, shorter, quicker, with more room.

use core::ops::ControlFlow;

use super::config::{Config, Level, Profile, SearchFrom};
use super::level::{Search, Work};
use super::portfolio::{COMFORTABLE, Floods};
use super::{Query, Report, Scratch, Status};
use crate::geometry::arcs;
use crate::json;
use crate::search::Progress;
use crate::vehicle::collision::Probe;

/// What a path may be chosen by.
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
const ROOMY: f64 = 1.0;
/// Margins that are tried for more room, as shares of the room at the ends.
const SHARES: [f64; 5] = [0.95, 0.8, 0.65, 0.5, 0.35];
/// Expansions of each level's search with one margin.
const WIDER: [u32; 2] = [3000, 8000];
/// Expansions of each level's search for fewer gear changes, from each end.
const LAYERS: [u32; 3] = [5000, 20_000, 40_000];
/// Expansions of each level's search for a shorter or a quicker path.
const BETTER: [u32; 2] = [10_000, 20_000];
/// The price of a gear change where fewer are looked for: this many metres …
const PRICE: f64 = 100.0;
/// … and this many lengths of the first path. No way that is worth taking is as long.
const PRICE_LENGTHS: f64 = 3.0;
/// What a gear change costs in time, in metres at full speed.
const CHANGE_TIME: f64 = 6.0;
/// What turning the wheel from straight to full lock costs in time, in metres at full speed.
const STEER_TIME: f64 = 0.3;

/// Searches for paths that are better than `first` by `prefer`, or in any way where nothing is preferred. Each is given to
/// `offer`, which answers whether to go on. The counters in each, and in the empty report returned, count everything so far,
/// `first` included.
pub fn choices(
    query: &Query,
    config: &Config,
    (first, prefer): (&Report, Option<Prefer>),
    (scratch, progress): (&mut Scratch, &mut Option<Progress>),
    offer: &mut dyn FnMut(Report) -> ControlFlow<()>,
) -> Report {
    let probe = Probe::new(query.obstacles, query.vehicle);
    let [start, goal] = [query.start, query.goal].map(|pose| query.obstacles.local(pose));
    let room = probe.clearance(start, ROOMY).min(probe.clearance(goal, ROOMY));
    let mut margins: Vec<f64> = SHARES.map(|share| share * room).to_vec();
    margins.retain(|&margin| margin > first.margin);
    let kept = margins.len();
    margins.extend([first.margin, COMFORTABLE]);
    let mirrored = config.search_from != SearchFrom::Start;
    let [root, target] = if mirrored { [goal, start] } else { [start, goal] };
    let floods = Floods::with(query, [target, root], margins);
    let config = &Config { search_from: SearchFrom::Goal, ..*config };
    let flood = floods.get(kept, false);
    let (tight, trace) = (false, false);
    let search =
        Search { query, config, probe: &probe, flood, root, target, mirrored, start, goal, tight, trace };
    let mut report = first.counters();
    let work = Work { report: &mut report, scratch, progress };
    let changes = arcs::direction_changes(&first.arcs);
    let mut run = Run { search, floods: &floods, kept, changes, first, work, offer };
    let wants = |one| prefer.is_none_or(|prefer| prefer == one);
    let _ = run.all(&wants);
    report.collision_checks += probe.checks();
    report
}

/// Whether to go on, and what was found.
type Goes<T = ()> = ControlFlow<(), T>;

/// The searches for paths beside the first.
struct Run<'a, 'p> {
    search: Search<'a>,
    floods: &'a Floods<'a>,
    /// Which margin the first path keeps; those before it are larger.
    kept: usize,
    /// Gear changes of the path with the fewest so far.
    changes: u32,
    first: &'a Report,
    work: Work<'a, 'p>,
    offer: &'a mut dyn FnMut(Report) -> Goes,
}

impl Run<'_, '_> {
    fn all(&mut self, wants: &dyn Fn(Prefer) -> bool) -> Goes {
        if wants(Prefer::FewestChanges) {
            self.fewer_changes()?;
        }
        if wants(Prefer::Shortest) {
            self.cheaper(0.0, 0.0)?;
        }
        if wants(Prefer::Fastest) {
            self.cheaper(CHANGE_TIME, STEER_TIME)?;
        }
        if wants(Prefer::Widest) {
            self.wider()?;
        }
        Goes::Continue(())
    }

    /// The fewest gear changes, and of those paths the shortest: a change is dearer than any way, so that the search goes
    /// through all that can be reached without one first, then with one, and so on, and never comes to as many as are known.
    fn fewer_changes(&mut self) -> Goes {
        let config = *self.search.config;
        let price = PRICE + PRICE_LENGTHS * arcs::length(&self.first.arcs);
        let last = self.kept + usize::from(self.first.margin > COMFORTABLE);
        for (number, most) in (0..config.levels()).zip(LAYERS) {
            for (margin, is_swapped) in (self.kept..=last).flat_map(|at| [(at, false), (at, true)]) {
                // Fine steps do not find what needs room, a way with a change less where there are few.
                if self.changes < number.max(1) {
                    return Goes::Continue(());
                }
                if is_swapped && self.work.report.status == Status::NoPath {
                    continue;
                }
                let level = Level {
                    extra_change: price - config.with_profile().direction_change_cost,
                    bound: price * f64::from(self.changes),
                    ..config.level(number)
                };
                self.attempt(&config, (level, number, most), margin, is_swapped)?;
            }
        }
        Goes::Continue(())
    }

    /// Paths that cost less by these prices of a gear change and of turning the wheel, and nothing else.
    fn cheaper(&mut self, change: f64, steer_change: f64) -> Goes {
        let config = Config {
            profile: Profile::Shortest,
            reverse_cost: 1.0,
            direction_change_cost: change,
            steer_cost: 0.0,
            steer_change_cost: steer_change,
            obstacle_cost: 0.0,
            ..*self.search.config
        };
        for (number, most) in (0..config.levels()).zip(BETTER) {
            let level = Level { extra_change: 0.0, ..config.level(number) };
            self.attempt(&config, (level, number, most), self.kept, false)?;
        }
        Goes::Continue(())
    }

    /// A path with the largest margin that there is one with.
    fn wider(&mut self) -> Goes {
        let config = *self.search.config;
        for margin in 0..self.kept {
            for (number, most) in (0..config.levels()).zip(WIDER) {
                if self.attempt(&config, (config.level(number), number, most), margin, false)? {
                    return Goes::Continue(());
                }
            }
        }
        Goes::Continue(())
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
        if flood.distance(search.root).is_infinite() {
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
            let mut path = core::mem::replace(self.work.report, counters);
            self.changes = self.changes.min(arcs::direction_changes(&path.arcs));
            path.cost = self.search.costs().path(self.search.probe, self.search.start, &path.arcs);
            path.status = Status::Suboptimal;
            self.work.report.status = Status::Suboptimal;
            (self.offer)(path)?;
        }
        Goes::Continue(found)
    }
}
