//! Hybrid A* in a scene: obstacles in, a checked path of arcs out.
//!
//! The engine prepares the exact obstacles once; floods around them are kept in the scratch memory from plan to plan.
//! A plan takes these steps:
//!
//! 1. the portfolio of searches answers a chain of arcs, or why there is none ([`Report`]);
//! 2. the arcs are sampled every 0.1 m at most, with gear and curvature;
//! 3. the independent check moves the real body along them. If it finds a hit the path is withdrawn, and the plan
//!    says `verification-failed`: the checker has the last word;
//! 4. outcome, reason, figures and the search tree are written into the plan.
//!
//! The complete module goes on from there, each part only where the question asks for it: the last path is kept while
//! a goal is dragged (`stay_with_last`), further paths are searched and the best by the asked measure is chosen
//! (`choose`), and of several goals the one that was reached becomes the world's.

use std::sync::Arc;

use super::choices::{self, Choosing, Wish};
use super::engine::{Ask, Engine};
use super::hybrid_answer::resolution;
use super::hybrid_answer::{metrics, reason, stats};
use super::measured::{Driven, NEAR, STEP, measured};
use super::outcome::{Member, Outcome, Recorded};
use super::outcome::{Plan, PlanTrace};
use super::path::MAX_LENGTH;
use super::world::World;
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::geometry::Pose;
use crate::geometry::arcs;
use crate::metrics::Verdict;
use crate::planners::hybrid::{self, FloodMemory, Last, Prefer, goal_of, plan, plan_any, stay, with_room};
use crate::planners::hybrid::{Config, Query, Report, Scratch, Status, obstacles};
use crate::planners::registry::PlannerId;
use crate::scenario::Scenario;
use crate::scenario::resolve::Geometry;
use crate::search::Progress;
use crate::vehicle::collision::Obstacles;

/// More than rounding takes from a clearance, metres.
const ROUNDING: f64 = 1e-6;
/// Hybrid A*, its obstacles and its memory.
pub(super) struct HybridEngine {
    kind: PlannerId,
    /// The path of the last plan that found one.
    last: Option<Last>,
    config: Config,
    obstacles: Arc<Obstacles>,
    scratch: Scratch,
    /// The goals of the next plan, if there are several.
    goals: Vec<Pose>,
}

impl HybridEngine {
    pub(super) fn new(world: &World, kind: PlannerId, config: Config) -> Result<Self, Error> {
        Ok(Self {
            kind,
            last: None,
            config,
            obstacles: Arc::new(obstacles_of(world)?),
            scratch: Scratch::default(),
            goals: Vec::new(),
        })
    }

    /// The planner of other settings on ground that is prepared already.
    pub(super) fn on(ground: Ground, kind: PlannerId, config: Config) -> Self {
        let Ground { obstacles, floods } = ground;
        Self { kind, last: None, config, obstacles, scratch: Scratch::sharing(floods), goals: Vec::new() }
    }

    /// Plans between the ends of `world`, or to the cheapest of several goals, which is its goal from then on.
    fn found(
        &mut self,
        scenario: &Scenario,
        world: &mut World,
        trace: bool,
        progress: &mut Option<Progress>,
    ) -> (Plan, Report) {
        let query = query(&self.obstacles, &world.geometry);
        let mut report = if IS_COMPLETE && !self.goals.is_empty() {
            let (at, report) =
                plan_any(&query, &self.goals, &self.config, &mut self.scratch, trace, progress);
            world.geometry.goal = self.goals[at];
            report
        } else {
            plan(&query, &self.config, &mut self.scratch, trace, progress)
        };
        let (world, geometry) = (&*world, &world.geometry);
        let query = self::query(&self.obstacles, geometry);
        if let Some(progress) = progress {
            progress.finish(report.stats.expanded);
        }
        let mut found = report.status.is_found();
        let driven = if found { drive(&query, &report) } else { Driven::default() };
        let mut plan = measured(world, report.status.outcome(), driven, NEAR);
        if found && plan.check.verdict == Verdict::Collides {
            (found, report.status) = (false, Status::VerificationFailed);
            plan = measured(world, report.status.outcome(), Driven::default(), NEAR);
        }
        plan.detail = report.status.detail();
        plan.reason = reason(scenario, geometry, &report);
        plan.stats = stats(&report);
        if found {
            fill(&query, &report, &mut plan);
        }
        plan.obstruction = report.obstruction.take();
        plan.trace = trace.then(|| PlanTrace::Arcs {
            arcs: core::mem::take(&mut report.tree),
            dropped: report.tree_dropped,
            failed_expansions: core::mem::take(&mut report.failed_expansions),
        });
        self.scratch.record(None);
        if IS_COMPLETE {
            let recorded = report.recorded.take().map(Arc::unwrap_or_clone);
            plan.recorded = recorded.map(|poses| Recorded::Poses(poses).into());
        }
        (plan, report)
    }

    /// Keeps to the last path, led to the new ends, where this one is not so much better.
    fn stay_with_last(
        &mut self,
        (scenario, world): (&Scenario, &World),
        plan: &mut Plan,
        first: Report,
        wish: &Wish,
    ) -> Report {
        let query = query(&self.obstacles, &world.geometry);
        let limits = scenario.all_speed_limits();
        let time = |plan: &Plan| match wish.prefer {
            Some(Prefer::Fastest) => choices::estimated_time(plan, &world.geometry, &limits),
            _ => 0.0,
        };
        let mut report = first;
        if let Some(last) = self.last.as_ref().filter(|_| wish.stickiness > 0.0) {
            let own_time = time(plan);
            let mut stayed = None;
            let mut is_kept = |kept: &Report| {
                let mut driven = measured(world, Outcome::Found, drive(&query, kept), NEAR);
                fill(&query, kept, &mut driven);
                // Among other obstacles than its own the last path may keep less.
                let margin = report.margin.min(plan.check.min_clearance);
                let is_sound = driven.check.drivable() && driven.check.min_clearance >= margin - ROUNDING;
                let keeps = |driven: &Plan| wish.keeps([driven, plan], [time(driven), own_time]);
                stayed = Some(driven).filter(|driven| is_sound && keeps(driven));
                stayed.is_some()
            };
            let share = if wish.prefer.is_some() { f64::INFINITY } else { wish.stickiness };
            let asked = (&report, share, wish.prefer != Some(Prefer::Widest));
            let kept = stay(&query, &self.config, last, asked, &mut self.scratch, &mut is_kept);
            if let (Some(kept), Some(mut stayed)) = (kept, stayed) {
                (stayed.detail, stayed.stats) = (kept.status.detail(), plan.stats.clone());
                (stayed.member, stayed.trace) = (plan.member, plan.trace.take());
                stayed.recorded = plan.recorded.take();
                *plan = stayed;
                report = kept;
            }
        }
        self.last = Some(Last::of(&query, &report));
        report
    }

    /// Which search answered; none where nothing was searched.
    fn member(report: &Report) -> Option<Member> {
        let (xy_resolution, heading_resolution) = report.resolution;
        (report.stats.expanded > 0).then_some(Member {
            level: report.level,
            from_goal: report.from_goal,
            xy_resolution,
            heading_resolution,
            margin: report.margin,
        })
    }

    /// Chooses among further paths and plans them. The goal of `world` becomes that of the chosen path.
    fn choose(
        &mut self,
        (scenario, world): (&Scenario, &mut World),
        (mut plan, first): (Plan, Report),
        wish: Wish,
        progress: &mut Option<Progress>,
    ) -> Plan {
        plan.member = Self::member(&first);
        if let (Some(member), Some(reason)) = (&plan.member, &mut plan.reason) {
            let how = resolution(member);
            *reason = match first.status {
                Status::NoPath => {
                    reason.replace("at these settings", &format!("{how}, with any number of gear changes"))
                }
                _ => reason.replacen(" expansions,", &format!(" expansions {how},"), 1),
            };
        }
        if plan.outcome != Outcome::Found {
            return plan;
        }
        let first = self.stay_with_last((scenario, world), &mut plan, first, &wish);
        if wish.is_none() {
            return plan;
        }
        let vehicle = world.geometry.vehicle;
        let Geometry { start, goal, .. } = world.geometry;
        let query = Query { obstacles: &self.obstacles, vehicle: &vehicle, start, goal };
        let prefer = wish.searched();
        let (trace, recorded) = (plan.trace.take(), plan.recorded.take());
        let (id, config) = (self.kind.id(), self.config);
        plan.planner = id;
        let mut choosing = Choosing::new(wish, world.geometry.clone(), scenario.all_speed_limits());
        let mut last = first.clone();
        if choosing.offer(plan).is_continue() {
            let goals = &self.goals;
            let mut offer = |report: Report| {
                let goal = if goals.is_empty() { query.goal } else { goal_of(&query, goals, &report) };
                let query = Query { goal, ..query };
                world.geometry.goal = goal;
                let mut plan = measured(world, Outcome::Found, drive(&query, &report), NEAR);
                if plan.check.verdict == Verdict::Collides {
                    return std::ops::ControlFlow::Continue(());
                }
                (plan.planner, plan.detail, plan.stats) = (id, report.status.detail(), stats(&report));
                fill(&query, &report, &mut plan);
                plan.member = Self::member(&report);
                choosing.offer(plan)
            };
            let memory = (&mut self.scratch, &mut *progress);
            last = hybrid::choices(&query, (&config, goals), (&first, prefer), memory, &mut offer);
        }
        if let Some(progress) = progress {
            progress.finish(last.stats.expanded);
        }
        let mut plan = choosing.conclude(&stats(&last));
        world.geometry.goal = plan.path.last().copied().unwrap_or(world.geometry.goal);
        (plan.trace, plan.recorded) = (trace, recorded);
        plan
    }
}

impl Engine for HybridEngine {
    fn plan(&mut self, scenario: &Scenario, world: &mut World, ask: Ask) -> Plan {
        let mut progress = ask.progress;
        self.scratch.record(ask.record);
        let found = self.found(scenario, world, ask.is_traced, &mut progress);
        if !IS_COMPLETE {
            return found.0;
        }
        let plan = self.choose((scenario, world), found, ask.wish, &mut progress);
        self.goals.clear();
        plan
    }

    fn obstacles_changed(&mut self, _: &Scenario, world: &World) {
        // The map is as large as before.
        if IS_COMPLETE && let Ok(obstacles) = obstacles_of(world) {
            self.obstacles = obstacles.into();
        }
    }

    fn aim(&mut self, world: &World, goals: &[Pose], is_sample: bool) -> bool {
        if !IS_COMPLETE {
            return false;
        }
        let with_margin = if is_sample {
            with_room(&self.obstacles, &world.geometry.vehicle, goals, self.config.margin)
        } else {
            Vec::new()
        };
        self.goals = if with_margin.is_empty() {
            goals.to_vec()
        } else {
            with_margin.iter().map(|&at| goals[at]).collect()
        };
        true
    }

    fn last(&mut self) -> Option<&mut Option<Last>> {
        Some(&mut self.last)
    }

    fn continue_along(&mut self, poses: &[Pose], gears: &[i8], curvatures: &[f64]) {
        if !IS_COMPLETE {
            return;
        }
        self.last = Some(Last::along(self.obstacles.local(poses[0]), poses, gears, curvatures));
    }
}

/// Everything that blocks in a world, and its costs.
///
/// # Errors
/// [`ErrorCode::Input`] where the map is too large for a car to drive in.
fn obstacles_of(world: &World) -> Result<Obstacles, Error> {
    let frame = &world.frame;
    let side = f64::from(frame.width.max(frame.height)) * frame.resolution;
    if side > MAX_LENGTH {
        let message = message!(
            "must be at most {} m wide and high where a car is to drive, got {} m",
            MAX_LENGTH,
            side
        );
        return Err(Error::new(ErrorCode::Input, "map", message));
    }
    Ok(obstacles(&world.geometry).painted(world.paint()))
}

/// What planners of one scene share: its obstacles, and the ways around them.
#[derive(Clone)]
pub(super) struct Ground {
    obstacles: Arc<Obstacles>,
    floods: FloodMemory,
}

impl Ground {
    /// # Errors
    /// As those of a planner on this world.
    pub(super) fn new(world: &World) -> Result<Self, Error> {
        Ok(Self { obstacles: obstacles_of(world)?.into(), floods: FloodMemory::shared() })
    }

    /// That of another scene, which differs at one place. Floods are derived from this one's.
    ///
    /// # Errors
    /// As those of a planner on this world.
    pub(super) fn variant(&self, world: &World) -> Result<Self, Error> {
        let obstacles = obstacles_of(world)?.variant_of(&self.obstacles);
        Ok(Self { obstacles: obstacles.into(), floods: self.floods.clone() })
    }
}

fn fill(query: &Query, report: &Report, plan: &mut Plan) {
    plan.raw_path = knots(query, report);
    plan.metrics.length = arcs::length(&report.arcs);
    plan.metrics.hybrid = Some(metrics(report));
}

fn query<'a>(obstacles: &'a Obstacles, geometry: &'a Geometry) -> Query<'a> {
    Query { obstacles, vehicle: &geometry.vehicle, start: geometry.start, goal: geometry.goal }
}

fn drive(query: &Query, report: &Report) -> Driven {
    let points = arcs::sample(query.start, &report.arcs, query.goal, STEP);
    Driven {
        poses: points.iter().map(|p| p.pose).collect(),
        directions: points.iter().map(|p| p.gear).collect(),
        curvatures: points.iter().map(|p| p.curvature).collect(),
    }
}

/// The ends of the arcs.
fn knots(query: &Query, report: &Report) -> Vec<crate::geometry::Point> {
    let mut pose = query.start;
    let mut points = vec![pose.point()];
    for arc in &report.arcs {
        pose = pose.advance(arc.curvature, arc.length);
        points.push(pose.point());
    }
    points
}
