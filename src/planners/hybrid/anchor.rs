//! The path before, led to other ends: while something is dragged, of two ways that are about as good the one that is
//! shown stays.
//!
//! First the old path itself is joined to the new ends, and led around what has come in its way. Where that fails, a
//! search that keeps to the corridor around it bends it. That is made only where the new answer lies elsewhere.
//!
//! A planner that answers each question anew jumps: when the goal moves by a centimetre, another homotopy class may
//! become cheaper by a millimetre, and the whole path changes before the user's eyes. The old path has to be given a
//! chance.
//!
//! The distance between two paths is the larger of the two one-sided distances (Hausdorff): no place of either is
//! farther than that from the other. Paths within a metre of each other count as one and the same way.
//!
//! The steps, of which each is tried only where the one before fails:
//!
//! 1. join the old path to the new ends and go around what is in its way, all of it with the whole margin;
//! 2. the same with 71 % of the margin on pieces of the old path;
//! 3. both of them again within the corridor around the old path;
//! 4. search within the corridor, on the coarsest level and then on the next.
//!
//! The last two are left out where the new answer runs along the old path anyway. A candidate counts only if it is
//! near the old path, as good as the new answer to within the share asked for, and passes the caller's own check.

use super::analytic_expansion::take_cheapest;
use super::config::{Config, SearchFrom};
use super::cost::{CostModel, Motion};
use super::improvement;
use super::lattices::{Effort, Level};
use super::obstacle_heuristic::ObstacleHeuristic;
use super::question::{Query, Scratch, Search, TIGHT_CLEARANCE, Work};
use super::report::{Report, Status};
use super::shortcut;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp::{self, Word};
use crate::geometry::{Point, Pose, math};
use crate::vehicle::collision::{CollisionChecker, Corridor};

/// Knots of the path are this far apart, metres.
const KNOT_SPACING: f64 = 0.5;
/// Knots at either end among which a new end may join.
const JOINT_KNOTS: usize = 16;
/// Spacing of collision checks, metres.
const CHECK_SPACING: f64 = 0.1;
/// Ends closer than this are the same, metres and radians.
const SAME_POSE: f64 = 1e-9;
/// A path no place of which is farther than this from another's, metres, …
const SAME_PATH_DISTANCE: f64 = 0.98;
/// … or than so many times as far as an end has moved, is the same to the eye.
const SAME_PATH_SHIFT: f64 = 1.2;
/// The corridor around a path is narrower by this, half a cell's diagonal, metres.
const CORRIDOR_INSET: f64 = 0.14;
/// Knots before and behind an obstacle between which a path is led around it.
const DETOUR_KNOTS: usize = 12;
/// Paths are compared this often along them, metres, …
const COMPARE_SPACING: f64 = 0.25;
/// … long ones at so many places.
const MAX_COMPARISONS: f64 = 500.0;
/// Arcs with less curvature are as long as their chords, 1/m.
const STRAIGHT_CURVATURE: f64 = 1e-6;
/// Shares of the margin that pieces of the old path must keep when they are looked at again. The checks grow the
/// body to a rectangle, whose corners stick out: one that stands on a piece's first check may have passed unseen
/// between two. Of what keeps less the clearance decides.
const KEPT_MARGINS: [f64; 2] = [1.0, core::f64::consts::FRAC_1_SQRT_2];
/// Expansions of the search around the old path, on the coarsest level and on the next.
const CORRIDOR_EXPANSIONS: [u32; 2] = [1500, 4000];

/// A path and where it begins, in the obstacles' coordinates.
/// It holds no cost and no margin: those follow from the next question.
#[derive(Debug, Clone)]
pub struct Last {
    start: Pose,
    arcs: Vec<Arc>,
}

impl Last {
    /// The memory of an answer.
    pub fn of(query: &Query, report: &Report) -> Self {
        Self { start: query.obstacles.local(query.start), arcs: report.arcs.clone() }
    }

    /// A path that begins at `start`, in the obstacles' coordinates: its poses in any, their gears and curvatures.
    pub fn along(start: Pose, poses: &[Pose], gears: &[i8], curvatures: &[f64]) -> Self {
        let arcs = poses.windows(2).zip(gears).zip(curvatures).map(|((ends, &gear), &curvature)| {
            let chord = f64::from(gear) * (ends[1].point() - ends[0].point()).norm();
            let turned = math::turn(ends[0].heading, ends[1].heading);
            let length = if curvature.abs() < STRAIGHT_CURVATURE { chord } else { turned / curvature };
            Arc { curvature, length }
        });
        Self { start, arcs: arcs::merge(arcs) }
    }

    /// Places along the path, close enough to compare it with another.
    fn points(&self) -> Vec<Point> {
        points(self.start, &self.arcs)
    }
}

fn poses(start: Pose, path: &[Arc]) -> impl Iterator<Item = Pose> {
    let step = COMPARE_SPACING.max(arcs::length(path) / MAX_COMPARISONS);
    arcs::sample(start, path, arcs::end(start, path), step).into_iter().map(|at| at.pose)
}

fn points(start: Pose, path: &[Arc]) -> Vec<Point> {
    poses(start, path).map(Pose::point).collect()
}

/// The last path between the ends of this question with the margin of its answer `report`, where it stays: its cost or
/// its length is within `share` of the answer's, and `is_sound` is content with it. Its counters are those of `report`.
/// Without `cuts` it is not made shorter, which would lead it nearer to obstacles.
///
/// Ends are in the query's world coordinates. The search around the old path, where it is made, takes at most
/// `CORRIDOR_EXPANSIONS`.
pub fn stay(
    query: &Query,
    config: &Config,
    last: &Last,
    (report, share, cuts): (&Report, f64, bool),
    scratch: &mut Scratch,
    is_sound: &mut dyn FnMut(&Report) -> bool,
) -> Option<Report> {
    let checker = CollisionChecker::new(query.obstacles, query.vehicle);
    let [start, goal] = [query.start, query.goal].map(|pose| query.obstacles.local(pose));
    let costs = CostModel::driven(config, query.vehicle.min_turning_radius(), [start, goal]);
    let end = arcs::end(last.start, &last.arcs);
    let moved = (start.point() - last.start.point()).norm().max((goal.point() - end.point()).norm());
    let reach = SAME_PATH_DISTANCE.max(SAME_PATH_SHIFT * moved);
    let path = last.points();
    let old = Old { query, config, last, report, share, cuts, ends: [start, goal], costs, path };
    let mut is_kept =
        |path: &Report| old.strays(&path.arcs) <= reach && old.is_as_good(path) && is_sound(path);
    let mut anchored =
        |checker| KEPT_MARGINS.iter().find_map(|&kept| old.anchored(checker, kept).filter(&mut is_kept));
    let free = anchored(&checker);
    if free.is_some() || old.strays(&report.arcs) <= reach {
        return free;
    }
    let corridor = Corridor::around(&old.path, reach - CORRIDOR_INSET);
    let narrow = checker.within(&corridor);
    anchored(&narrow).or_else(|| old.bent(&narrow, reach - CORRIDOR_INSET, scratch).filter(is_kept))
}

/// The path in pieces of at most [`KNOT_SPACING`]; their ends are the knots.
fn split(path: &[Arc]) -> Vec<Arc> {
    let parts = |arc: &Arc| {
        let count = (arc.length.abs() / KNOT_SPACING).ceil().max(1.0);
        core::iter::repeat_n(Arc { length: arc.length / count, ..*arc }, count as usize)
    };
    path.iter().flat_map(parts).collect()
}

/// The last path and a new question.
struct Old<'a> {
    query: &'a Query<'a>,
    config: &'a Config,
    last: &'a Last,
    report: &'a Report,
    share: f64,
    cuts: bool,
    /// The new start and goal, in local coordinates.
    ends: [Pose; 2],
    costs: CostModel,
    /// Places along the last path.
    path: Vec<Point>,
}

impl Old<'_> {
    /// How far a path strays from the last one, or that one from it, metres.
    fn strays(&self, path: &[Arc]) -> f64 {
        let other = points(self.ends[0], path);
        let far = |from: &[Point], to: &[Point]| {
            let nearest = |p: &Point| to.iter().map(|q| (p - q).norm_squared()).fold(f64::INFINITY, f64::min);
            from.iter().map(nearest).fold(0.0, f64::max)
        };
        far(&self.path, &other).max(far(&other, &self.path)).sqrt()
    }

    /// True if a path costs little more than the answer, or that is about as long as it or as the last path.
    fn is_as_good(&self, path: &Report) -> bool {
        let [new, old, last] =
            [&self.report.arcs, &path.arcs, &self.last.arcs].map(|path| arcs::length(path));
        let is_like = |length: f64| (new - length).abs() <= length * self.share;
        path.cost <= self.report.cost * (1.0 + self.share) || is_like(old) || is_like(last)
    }

    /// A report of this path, with the counters of the plan that it competes with.
    fn answer(&self, path: Vec<Arc>, checker: &CollisionChecker) -> Report {
        let cost = self.costs.path(checker, self.ends[0], &path);
        Report { arcs: path, cost, status: Status::Suboptimal, ..self.report.clone() }
    }

    /// The old path with other ends; `None` where it cannot be led there. Its pieces stay where they have this share of
    /// the margin.
    fn anchored(&self, checker: &CollisionChecker, kept: f64) -> Option<Report> {
        let [start, goal] = self.ends;
        let margin = self.report.margin;
        let joining = Joining { checker, costs: &self.costs, margin, kept: kept * margin };
        let knots = split(&self.last.arcs);
        let back: Vec<Arc> = arcs::reversed(&knots);
        let (head, from) = joining.lead(start, self.last.start, &knots)?;
        let (tail, to) = joining.lead(goal, arcs::end(self.last.start, &self.last.arcs), &back)?;
        let kept = knots.get(from..knots.len() - to)?;
        let path: Vec<Arc> =
            head.into_iter().chain(kept.iter().copied()).chain(arcs::reversed(&tail)).collect();
        let path = joining.mended(start, split(&path))?;
        let rules = shortcut::Rules { checker, costs: &self.costs, spacing: CHECK_SPACING, margin };
        let path = arcs::merge(path);
        let path = if self.cuts { improvement::improved(rules, start, path, Effort::Descent) } else { path };
        Some(self.answer(path, checker))
    }

    /// The cheapest path within `reach` of the old one that a short search finds.
    fn bent(&self, checker: &CollisionChecker, reach: f64, scratch: &mut Scratch) -> Option<Report> {
        let Query { obstacles, vehicle, .. } = *self.query;
        let [start, goal] = self.ends;
        let mirrored = self.report.from_goal;
        let [root, target] = if mirrored { [goal, start] } else { [start, goal] };
        let flood = ObstacleHeuristic::new(obstacles, vehicle, target, self.report.margin, None);
        let discs: Vec<Point> =
            poses(self.last.start, &self.last.arcs).map(|pose| flood.disc(pose)).collect();
        let flood = flood.within(&Corridor::around(&discs, reach));
        let config = &Config { search_from: SearchFrom::Goal, ..*self.config };
        let room = checker.clearance(start, TIGHT_CLEARANCE).min(checker.clearance(goal, TIGHT_CLEARANCE));
        let search = Search {
            query: self.query,
            config,
            checker,
            flood: &flood,
            root,
            target,
            mirrored,
            start,
            goal,
            tight: room < TIGHT_CLEARANCE,
            trace: false,
            poses: None,
            goals: &[],
        };
        (0..config.levels()).zip(CORRIDOR_EXPANSIONS).find_map(|(number, most)| {
            let mut report =
                Report { margin: self.report.margin, level: self.report.level, ..self.report.counters() };
            let level = config.level(number);
            let level = Level { max_expansions: most.min(level.max_expansions), ..level };
            let mut work = Work { report: &mut report, scratch, progress: &mut None };
            search.level(level, &mut work).then(|| self.answer(report.arcs, checker))
        })
    }
}

/// The rules by which pieces of the old path are joined with new curves.
struct Joining<'a> {
    checker: &'a CollisionChecker<'a>,
    costs: &'a CostModel,
    /// Of new curves, metres, …
    margin: f64,
    /// … and of what stays of the old path.
    kept: f64,
}

impl Joining<'_> {
    /// The cheapest curve from a new end to one of the first knots of a path from `old`, and how many knots it
    /// replaces.
    fn lead(&self, new: Pose, old: Pose, knots: &[Arc]) -> Option<(Vec<Arc>, usize)> {
        let apart = (new.point() - old.point()).norm() + math::turn(new.heading, old.heading).abs();
        if apart < SAME_POSE {
            return Some((Vec::new(), 0));
        }
        let (mut pose, mut spent, mut before) = (old, 0.0, Motion::default());
        let mut best: Option<(f64, Word, usize)> = None;
        for replaced in 0..=knots.len().min(JOINT_KNOTS) {
            let bound = best.as_ref().map_or(f64::INFINITY, |best| best.0 + spent);
            if let Some((cost, word)) = self.curve(new, pose, bound) {
                best = Some((cost - spent, word, replaced));
            }
            let Some(arc) = knots.get(replaced) else { break };
            spent += self.costs.arc(before, arc);
            before = Motion::after(arc);
            pose = pose.advance(arc.curvature, arc.length);
        }
        best.map(|(_, word, replaced)| (word.arcs(self.costs.radius).collect(), replaced))
    }

    /// A path from `start` led around what is in its way, each time by the curve that is dearer by least.
    fn mended(&self, start: Pose, mut knots: Vec<Arc>) -> Option<Vec<Arc>> {
        let mut from = 0;
        loop {
            let mut poses = vec![start];
            poses.extend(knots.iter().scan(start, |pose, arc| {
                *pose = pose.advance(arc.curvature, arc.length);
                Some(*pose)
            }));
            let is_free = |at: usize| self.checker.arc_free(poses[at], &knots[at], CHECK_SPACING, self.kept);
            let Some(first) = (from..knots.len()).find(|&at| !is_free(at)) else { return Some(knots) };
            let behind = (first + 1..knots.len()).find(|&at| is_free(at)).unwrap_or(knots.len());
            let mut best: Option<(f64, Word, usize, usize)> = None;
            for i in (first.saturating_sub(DETOUR_KNOTS)..=first).rev() {
                for j in behind..=knots.len().min(behind + DETOUR_KNOTS) {
                    let saved = self.stretch(&knots[i..j]);
                    let bound = best.as_ref().map_or(f64::INFINITY, |best| best.0 + saved);
                    if let Some((cost, word)) = self.curve(poses[i], poses[j], bound) {
                        best = Some((cost - saved, word, i, j));
                    }
                }
            }
            let (_, word, i, j) = best?;
            let around = split(&word.arcs(self.costs.radius).collect::<Vec<_>>());
            from = i + around.len();
            knots.splice(i..j, around);
        }
    }

    /// Cost of some knots in a row, obstacles aside.
    fn stretch(&self, knots: &[Arc]) -> f64 {
        let mut before = Motion::default();
        knots.iter().fold(0.0, |cost, arc| {
            let cost = cost + self.costs.arc(before, arc);
            before = Motion::after(arc);
            cost
        })
    }

    /// The cheapest free curve below `bound`.
    fn curve(&self, from: Pose, to: Pose, bound: f64) -> Option<(f64, Word)> {
        let mut found = Vec::new();
        for word in reeds_shepp::list_below(from, to, self.costs.radius, bound) {
            let cost = self.costs.word(Motion::default(), &word);
            if cost < bound {
                found.push((cost, word));
            }
        }
        core::iter::from_fn(|| take_cheapest(&mut found)).find(|(_, word)| {
            let mut pose = from;
            word.arcs(self.costs.radius).all(|arc| {
                let free = self.checker.arc_free(pose, &arc, CHECK_SPACING, self.margin);
                pose = pose.advance(arc.curvature, arc.length);
                free
            })
        })
    }
}
