//! One of several goals, whichever is the cheapest to reach.
//!
//! The tree grows from the goals, so one search may begin at all of them: a node before them leads to each at no cost,
//! and the first connection to the start comes from the goal of the cheapest path. It searches the coarse level, which
//! answers nearly always; where it does not, each goal is planned for on its own until one has a path.
//!
//! A marked lot has dozens of free bays, and a driver takes whichever is convenient. Planning for each of them costs
//! dozens of searches. A super-source costs one: with an artificial root that leads to every goal at no cost, the
//! search expands the goals in the order of their estimates, and goals whose estimate exceeds the cost of the best
//! path are never expanded.
//!
//! Goals differ in the room that they have, and one margin must serve a whole search. Those with room for the margin
//! are searched from first; the others follow, with the least room among them, only if they may be cheaper by 3 %.
//!
//! The root's label is the goal with the least estimate, and its children are the goals, each at the cost 0. Their f
//! is the estimate of the way from the start to that goal, so the most promising goal is expanded first.
//!
//! The weight of 1.03 keeps many goals apart: without it, every goal whose estimate is a little below the best path
//! has to be searched from until it is proven dearer.

use super::config::Config;
use super::lattices::Level;
use super::level::{MARGIN_TOLERANCE, VERIFY_SPACING};
use super::obstacle_heuristic::ObstacleHeuristic;
use super::question::{MIN_MARGIN, Query, Scratch, Search, TIGHT_CLEARANCE, Work, nearest};
use super::report::{Report, Status};
use super::{compared, plan};
use crate::geometry::{Pose, arcs, math, reeds_shepp};
use crate::search::Progress;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::{CollisionChecker, Obstacles};

/// Expansions after which no further goal is planned for on its own: four goals that nobody can reach may take as many.
const MAX_SINGLE_GOAL_EXPANSIONS: u32 = 600_000;

/// A goal with less room than another is taken where its path costs less than this share of the other's.
const ROOM_TRADE: f64 = 0.97;
/// Weight of the estimate in a search from many goals, which may cost as much more than the cheapest path: else each
/// goal that seems a little nearer than the one taken is searched from until it is proven dearer.
const WEIGHT: f64 = 1.03;

/// Plans a path to the cheapest of some goals, one at least; tells which. The query's own goal is ignored.
///
/// Goals at which the body overlaps something are left out. All searches count together.
///
/// # Panics
/// Without goals.
///
/// # Examples
/// ```
/// use parkade::geometry::{Point, Pose};
/// use parkade::planners::hybrid::{Config, Query, Scratch, Status, plan_any};
/// use parkade::vehicle::Vehicle;
/// use parkade::vehicle::collision::{Obstacles, Solid};
///
/// let corners = [(0.0, 0.0), (40.0, 0.0), (40.0, 30.0), (0.0, 30.0)];
/// let floor = Solid { outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(), owner: 0 };
/// let obstacles = Obstacles::new(&[], &[], &floor);
/// let goals = [(35.0, 25.0), (12.0, 6.0), (39.0, 5.0)].map(|(x, y)| Pose::new(x, y, 0.0));
/// let start = Pose::new(5.0, 5.0, 0.0);
/// let query = Query { obstacles: &obstacles, vehicle: &Vehicle::SEDAN, start, goal: start };
/// let (goal, report) = plan_any(&query, &goals, &Config::default(), &mut Scratch::default(), false, &mut None);
/// assert_eq!((goal, report.status), (1, Status::Found));
/// ```
pub fn plan_any(
    query: &Query,
    goals: &[Pose],
    config: &Config,
    scratch: &mut Scratch,
    trace: bool,
    progress: &mut Option<Progress>,
) -> (usize, Report) {
    let checker = CollisionChecker::new(query.obstacles, query.vehicle);
    let local = |pose| query.obstacles.local(pose);
    let mut free: Vec<usize> = Vec::new();
    if goals.len() > 1 {
        free = with_room(query.obstacles, query.vehicle, goals, 0.0);
    }
    let here = goals.iter().position(|&goal| is_same(goal, query.start));
    if here.is_some() || free.len() < 2 || !is_free(&checker, query.obstacles, query.start, 0.0) {
        let only = here.or(free.first().copied()).unwrap_or(0);
        return (only, plan(&Query { goal: goals[only], ..*query }, config, scratch, trace, progress));
    }
    let poses: Vec<Pose> = free.iter().map(|&at| local(goals[at])).collect();
    let worlds = free.iter().map(|&at| goals[at]).collect();
    let many =
        Many { query, config, trace, checker: &checker, start: local(query.start), goals: &poses, worlds };
    let (at, report) = many.plan(scratch, progress);
    (free[at], report)
}

/// The one of some goals to which a path leads; in world coordinates.
/// The nearest to the path's end, where a radian counts as a metre. O(goals + arcs).
pub fn goal_of(query: &Query, goals: &[Pose], report: &Report) -> Pose {
    let locals: Vec<Pose> = goals.iter().map(|&goal| query.obstacles.local(goal)).collect();
    goals[nearest(&locals, arcs::end(query.obstacles.local(query.start), &report.arcs))]
}

/// Of some poses those at which the body keeps `margin`, metres.
/// Indices into `poses`, which are in world coordinates. A pose inside a solid obstacle has no room.
pub fn with_room(obstacles: &Obstacles, vehicle: &Vehicle, poses: &[Pose], margin: f64) -> Vec<usize> {
    let checker = CollisionChecker::new(obstacles, vehicle);
    let has_room = |&at: &usize| is_free(&checker, obstacles, poses[at], margin);
    (0..poses.len()).filter(has_room).collect()
}

/// True if a body at a pose in world coordinates keeps `margin` and does not stand inside an obstacle.
fn is_free(checker: &CollisionChecker, obstacles: &Obstacles, pose: Pose, margin: f64) -> bool {
    let pose = obstacles.local(pose);
    obstacles.inside(pose.point()).is_none() && checker.hit(pose, margin).is_none()
}

/// True if two poses differ by less than a micrometre and a microradian.
fn is_same(a: Pose, b: Pose) -> bool {
    (a.point() - b.point()).norm() <= 1e-6 && math::turn(a.heading, b.heading).abs() <= 1e-6
}

/// A question with two goals or more, at each of which the car has room.
/// `goals` are local, `worlds` the same poses in world coordinates and in the same order.
struct Many<'a> {
    query: &'a Query<'a>,
    config: &'a Config,
    trace: bool,
    checker: &'a CollisionChecker<'a>,
    /// In local coordinates, as the goals.
    start: Pose,
    goals: &'a [Pose],
    worlds: Vec<Pose>,
}

impl Many<'_> {
    /// Searches the goals with room, then those with less, then each on its own; tells which goal was taken.
    fn plan(&self, scratch: &mut Scratch, progress: &mut Option<Progress>) -> (usize, Report) {
        let clearances: Vec<f64> = self.goals.iter().map(|&goal| self.clearance(goal)).collect();
        let roomiest = clearances.iter().copied().fold(0.0, f64::max);
        let tightest = clearances.iter().copied().fold(f64::INFINITY, f64::min);
        let margin = self.margin(roomiest);
        // With the least margin it leads to all of them.
        let flood = self.flood(self.margin(tightest), scratch);
        let has_room = |&at: &usize| clearances[at] >= margin;
        let (clear_by, mut tight): (Vec<usize>, Vec<usize>) = (0..self.goals.len()).partition(has_room);
        let mut sum = Report { margin, ..Report::empty(self.bound()) };
        self.at_once(&clear_by, &clearances, &flood, (&mut sum, scratch, progress));
        let mut best = self.kept(&mut sum);
        // Goals with less room only where they may be nearer than what was found with more.
        let worth = best.as_ref().map_or(f64::INFINITY, |(_, best)| best.cost * ROOM_TRADE);
        tight.retain(|&at| self.estimate(at, &flood) < worth);
        if !tight.is_empty() {
            let least = tight.iter().map(|&at| clearances[at]).fold(f64::INFINITY, f64::min);
            sum.margin = self.margin(least);
            self.at_once(&tight, &clearances, &flood, (&mut sum, scratch, progress));
            if let Some((at, mut found)) = self.kept(&mut sum) {
                let own = self.margin(clearances[at]);
                if self.keeps(&found, own) {
                    found.margin = own;
                }
                if own > found.margin {
                    let again = self.alone(at, &sum, scratch, progress);
                    sum = Report { collision_checks: again.collision_checks, ..again.counters() };
                    if !again.arcs.is_empty() && again.margin > found.margin {
                        found = again;
                    }
                }
                if best.as_ref().is_none_or(|(_, best)| found.cost < best.cost * ROOM_TRADE) {
                    best = Some((at, found));
                }
            }
        }
        sum.stats.bytes += flood.bytes();
        let Some((at, found)) = best else { return self.one_by_one(sum, scratch, progress) };
        sum.stats.bytes += self.query.obstacles.bytes();
        let found = Report { stats: sum.stats, collision_checks: sum.collision_checks, ..found };
        let query = Query { goal: self.worlds[at], ..*self.query };
        (at, compared(&query, self.config, found, scratch, self.trace, progress))
    }

    /// The path in a report, with the goal that it leads to; the report then has counters only.
    fn kept(&self, report: &mut Report) -> Option<(usize, Report)> {
        let counters = Report { collision_checks: self.checker.checks(), ..report.counters() };
        let found = core::mem::replace(report, counters);
        (!found.arcs.is_empty()).then(|| (nearest(self.goals, arcs::end(self.start, &found.arcs)), found))
    }

    /// True if a path has so much room all the way, although less was asked of it.
    fn keeps(&self, found: &Report, margin: f64) -> bool {
        let mut pose = self.start;
        found.arcs.iter().all(|arc| {
            let is_kept = self.checker.keeps_clearance(pose, arc, VERIFY_SPACING, (margin, MARGIN_TOLERANCE));
            pose = pose.advance(arc.curvature, arc.length);
            is_kept
        })
    }

    /// Distance from the body at a pose to the nearest obstacle, metres, up to what is of interest here.
    fn clearance(&self, pose: Pose) -> f64 {
        self.checker.clearance(pose, self.config.margin.max(TIGHT_CLEARANCE))
    }

    /// The margin to a goal with this much room.
    fn margin(&self, clearance: f64) -> f64 {
        self.config.margin.max(MIN_MARGIN).min(clearance).min(self.clearance(self.start))
    }

    /// The ways around obstacles to the start, for a car with this margin.
    fn flood(&self, margin: f64, scratch: &Scratch) -> ObstacleHeuristic {
        let Query { obstacles, vehicle, .. } = *self.query;
        ObstacleHeuristic::new(obstacles, vehicle, self.start, margin, Some(&scratch.floods))
    }

    /// Metres of the way to a goal at least, as far as is known; infinite where there is none.
    fn estimate(&self, at: usize, flood: &ObstacleHeuristic) -> f64 {
        let radius = self.query.vehicle.min_turning_radius();
        let around = flood.distance(self.goals[at]);
        around.max(reeds_shepp::distance(self.start, self.goals[at], radius))
    }

    /// Lower bound of the path length to any goal, metres.
    fn bound(&self) -> f64 {
        let radius = self.query.vehicle.min_turning_radius();
        let curves = self.goals.iter().map(|&goal| reeds_shepp::distance(self.start, goal, radius));
        curves.fold(f64::INFINITY, f64::min)
    }

    /// One search of the first level from some of the goals with the report's margin.
    fn at_once(
        &self,
        some: &[usize],
        clearances: &[f64],
        flood: &ObstacleHeuristic,
        (report, scratch, progress): (&mut Report, &mut Scratch, &mut Option<Progress>),
    ) {
        let near: Vec<usize> =
            some.iter().copied().filter(|&at| flood.distance(self.goals[at]).is_finite()).collect();
        if !near.is_empty() {
            let goals: Vec<Pose> = near.iter().map(|&at| self.goals[at]).collect();
            let first = goals[0];
            let least = some.iter().map(|&at| clearances[at]).fold(f64::INFINITY, f64::min);
            let search = Search {
                query: self.query,
                config: self.config,
                checker: self.checker,
                flood,
                root: first,
                target: self.start,
                mirrored: true,
                start: self.start,
                goal: first,
                tight: least.min(self.clearance(self.start)) < TIGHT_CLEARANCE,
                trace: self.trace,
                poses: None,
                goals: &goals,
            };
            let level = self.config.level(0);
            search.first(
                &|| None,
                Level { weight: WEIGHT, ..level },
                &mut Work { report: &mut *report, scratch, progress },
            );
        }
    }

    /// The ways around obstacles to the goals.
    fn distances(&self, flood: &ObstacleHeuristic) -> Vec<f64> {
        self.goals.iter().map(|&goal| flood.distance(goal)).collect()
    }

    /// Goal after goal until there is a path, those with the shortest way around obstacles first. Goals that no disc of
    /// the car's width reaches are left out.
    fn one_by_one(
        &self,
        mut sum: Report,
        scratch: &mut Scratch,
        progress: &mut Option<Progress>,
    ) -> (usize, Report) {
        let flood = self.flood(MIN_MARGIN.min(sum.margin), scratch);
        let mut distances = self.distances(&flood);
        let (mut answer, mut is_proven) = (None, true);
        loop {
            let at = math::argmin(&distances);
            if answer.is_some() && distances[at].is_infinite() {
                break;
            }
            if answer.is_some()
                && (sum.stats.expanded >= MAX_SINGLE_GOAL_EXPANSIONS
                    || progress.as_ref().is_some_and(Progress::is_stopped))
            {
                is_proven = false;
                break;
            }
            distances[at] = f64::INFINITY;
            let report = self.alone(at, &sum, scratch, progress);
            if !report.arcs.is_empty() {
                return (at, report);
            }
            is_proven &= !matches!(report.status, Status::BudgetExhausted(_));
            sum = Report { collision_checks: report.collision_checks, ..report.counters() };
            answer.get_or_insert((at, report));
        }
        let (at, nearest) = answer.unwrap_or((0, Report::empty(0.0)));
        let status = match nearest.status {
            Status::BudgetExhausted(_) => nearest.status,
            status if is_proven => status,
            _ => Status::BudgetExhausted(nearest.rs_bound),
        };
        (at, Report { status, stats: sum.stats, collision_checks: sum.collision_checks, ..nearest })
    }

    /// The ordinary plan for one goal; its counters go on from those of `before`.
    fn alone(
        &self,
        at: usize,
        before: &Report,
        scratch: &mut Scratch,
        progress: &mut Option<Progress>,
    ) -> Report {
        if let Some(progress) = progress {
            progress.continue_after(before.stats.expanded);
        }
        let query = Query { goal: self.worlds[at], ..*self.query };
        let mut report = plan(&query, self.config, scratch, self.trace, progress);
        report.stats.add(before.stats);
        report.collision_checks = report.collision_checks.saturating_add(before.collision_checks);
        report
    }
}
