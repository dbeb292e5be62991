//! To whichever of several goals is the cheapest to reach.
//!
//! Hybrid A* takes all goals as sinks of one search: the tree that reaches any of them first by cost has the answer. A
//! grid planner has one goal in its estimate, so the goals are tried one after another, the nearest first. The straight
//! distance d to a goal bounds the cost of any path to it from below, because no move costs less than its length. So
//! once a path of cost c is found, goals with d − slack ≥ c cannot be cheaper and are skipped; `slack` covers the way
//! from the pose to the middle of its cell.
//!
//! The chosen goal is planned once more at the end, with trace and callbacks, so that the answer is the same plan as
//! for this goal alone; only the count of expansions is the sum.

use std::ops::ControlFlow;

use super::measured::{Driven, NEAR, measured};
use super::{Family, Improved, Options, Outcome, Plan, Planner, ProgressCallback};
use crate::geometry::{Pose, math};
use crate::scenario::{GoalPose, Goals};

/// Expansions of cells after which no further goal is tried. The cap keeps a scene with many unreachable goals from
/// searching the whole map once for each.
const EFFORT: u32 = 50_000_000;

impl Planner {
    /// Plans to the cheapest goal: in one search with hybrid A*, else to one goal after another.
    ///
    /// Without any goal the outcome is `goal-blocked`, with the scene's reason. Afterwards the planner's geometry has
    /// the goal that was reached.
    pub(super) fn plan_any(&mut self, start: Pose, goals: &Goals, mut options: Options) -> Plan {
        let poses: Vec<Pose> = goals.poses.iter().map(|goal| goal.pose).collect();
        if poses.is_empty() {
            self.world.geometry.start = start;
            let mut plan = measured(&self.world, Outcome::GoalBlocked, Driven::default(), NEAR);
            (plan.planner, plan.reason) = (self.kind.id(), Some(goals.empty_reason().to_owned()));
            return plan;
        }
        let mut plan = if self.engine.aim(&self.world, &poses, goals.is_sample()) {
            let ends = [start, poses[0]];
            match options.improved.take() {
                None => self.toward(ends, options),
                Some(improved) => {
                    let mut told =
                        |plan: &Plan| improved(&Plan { goal: at_end(goals, plan), ..plan.clone() });
                    let progress: Option<ProgressCallback> = match &mut options.progress {
                        Some(tell) => Some(&mut **tell),
                        None => None,
                    };
                    let Options { trace, record, expansions, prefer, alternatives, stickiness, .. } = options;
                    let improved: Option<Improved> = Some(&mut told);
                    let improved = Options {
                        trace,
                        record,
                        progress,
                        expansions,
                        prefer,
                        alternatives,
                        stickiness,
                        improved,
                    };
                    self.toward(ends, improved)
                }
            }
        } else {
            self.one_by_one(start, &poses, options)
        };
        let goal = self.world.geometry.goal;
        let nearest = goals.poses.iter().find(|one| one.pose == goal);
        match (plan.outcome, nearest) {
            (Outcome::Found, _) => {
                plan.goal = nearest.cloned();
                for one in &mut plan.alternatives {
                    one.goal = at_end(goals, one);
                }
            }
            (Outcome::StartBlocked | Outcome::StartOutside, _) => {}
            (_, Some(nearest)) if goals.poses.len() > 1 => {
                let own = plan.reason.unwrap_or_default();
                plan.reason = Some(format!("No path to any goal. {}: {own}", named(nearest)));
            }
            _ => {}
        }
        plan
    }

    /// Plans for each goal, and once more for the one with the cheapest path, else for that whose failure tells most.
    /// Goals that are nearer as the crow flies come first; those farther away than the best path is dear cannot be
    /// cheaper.
    ///
    /// Of goals in one cell a grid planner tries the first only: it cannot tell them apart.
    fn one_by_one(&mut self, start: Pose, goals: &[Pose], mut options: Options) -> Plan {
        let mut straight: Vec<f64> = goals.iter().map(|goal| (goal.point() - start.point()).norm()).collect();
        let frame = self.world.frame;
        // Costs are counted from middles of cells, on roads from the car's middle.
        let slack = 2.0 * frame.resolution + self.world.geometry.vehicle.length();
        let is_grid = self.kind.family() == Family::Grid;
        let (mut seen, mut best) = (Vec::new(), (f64::INFINITY, goals[0]));
        let (mut expanded, mut is_stopped) = (0_u32, false);
        while goals.len() > 1 && expanded < EFFORT && !is_stopped {
            let at = math::argmin(&straight);
            let distance = core::mem::replace(&mut straight[at], f64::INFINITY);
            if distance.is_infinite() || distance - slack >= best.0 {
                break;
            }
            let cell = frame.cell_at(goals[at].point());
            if is_grid && cell.is_some() && seen.contains(&cell) {
                continue;
            }
            seen.push(cell);
            let mut tell = |count| {
                let flow = told(&mut options.progress, expanded, count);
                is_stopped |= flow.is_break();
                flow
            };
            let own = Options { progress: Some(&mut tell), ..Options::default() };
            let plan = self.toward([start, goals[at]], own);
            expanded = expanded.saturating_add(plan.stats.expanded);
            let price = self.price(&plan);
            if price < best.0 || seen.len() == 1 {
                best = (price, goals[at]);
            }
        }
        let is_over = expanded >= EFFORT;
        let mut tell = |count| told(&mut options.progress, expanded, count);
        let Options { trace, record, expansions, .. } = options;
        let last = Options { trace, record, expansions, progress: Some(&mut tell), ..Options::default() };
        let mut plan = self.toward([start, best.1], last);
        plan.stats.expanded = plan.stats.expanded.saturating_add(expanded);
        if is_over && plan.outcome != Outcome::Found {
            plan.outcome = Outcome::BudgetSpent;
        }
        plan
    }

    /// Cost of a plan's path under its planner's settings, metres. Failures cost more than any path; the more a failure
    /// explains, the less it costs. So if all goals fail, the plan that is answered is a search that went through
    /// everything rather than a goal inside a wall.
    fn price(&self, plan: &Plan) -> f64 {
        let cells = plan.stats.cost_micro.map(|cost| cost as f64 * 1e-6 * self.world.frame.resolution);
        let road = plan.metrics.road.as_ref().map(|road| road.cost);
        match plan.outcome {
            Outcome::Found => cells.or(road).unwrap_or(plan.metrics.length),
            Outcome::StartBlocked | Outcome::StartOutside => f64::NEG_INFINITY,
            Outcome::BudgetSpent => 1e100,
            Outcome::NoPath => 1e101,
            Outcome::GoalBlocked | Outcome::GoalOutside => f64::INFINITY,
        }
    }
}

/// The goal at which a path ends.
///
/// Compares bits: the last pose of a path is the goal's own, not an integrated one.
fn at_end(goals: &Goals, plan: &Plan) -> Option<GoalPose> {
    let end = *plan.path.last()?;
    goals.poses.iter().find(|one| one.pose == end).cloned()
}

/// Tells of expansions that follow others.
///
/// The caller sees one count that never falls, whatever the number of searches.
fn told(tell: &mut Option<ProgressCallback>, before: u32, count: u32) -> ControlFlow<()> {
    match tell {
        Some(tell) => tell(before.saturating_add(count)),
        None => ControlFlow::Continue(()),
    }
}

/// A goal in a message.
fn named(goal: &GoalPose) -> String {
    match &goal.slot {
        Some(slot) => format!("At {slot}"),
        None => format!("At ({:.2}, {:.2})", goal.pose.x, goal.pose.y),
    }
}
