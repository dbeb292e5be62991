//! What the planner answers to a scene, and what that takes.

use std::fmt;

use parkade::geometry::arcs;
use parkade::planners::hybrid::{Config, Query, Scratch, Status, plan};

use crate::clock;
use crate::tight_scenes::Scene;

/// How planning ended.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ending {
    Solved,
    /// Proven: the car can hardly move at one of its ends.
    BoxedIn,
    /// Proven: the body does not fit through.
    TooNarrow,
    /// Proven: all that a lattice can reach was searched.
    Searched,
    BudgetSpent,
    /// Neither a path nor a reason: a fault.
    Failed,
}

pub(crate) struct Answer {
    pub(crate) ending: Ending,
    pub(crate) changes: u32,
    /// What the path costs by the settings, metres.
    pub(crate) cost: f64,
    /// Kept free around the car, metres.
    pub(crate) margin: f64,
    pub(crate) milliseconds: f64,
    pub(crate) expanded: u32,
    /// Poses tested for collision: the work, as nearly all of it goes there.
    pub(crate) checks: u32,
}

impl Answer {
    pub(crate) fn of(scene: &Scene, config: &Config) -> Self {
        let Scene { vehicle, obstacles, start, goal, .. } = scene;
        let query = Query { obstacles, vehicle, start: *start, goal: *goal };
        let begin = clock::now();
        let report = plan(&query, config, &mut Scratch::default(), false, &mut None);
        let milliseconds = clock::now() - begin;
        let ending = match report.status {
            Status::Found | Status::Suboptimal => Ending::Solved,
            Status::BoxedIn { .. } => Ending::BoxedIn,
            Status::TooNarrow(_) | Status::NoRoom | Status::Unreachable => Ending::TooNarrow,
            Status::NoPath => Ending::Searched,
            Status::BudgetExhausted(_) => Ending::BudgetSpent,
            _ => Ending::Failed,
        };
        let changes = arcs::direction_changes(&report.arcs);
        let (cost, margin) = (report.cost, report.margin);
        let (expanded, checks) = (report.stats.expanded, report.collision_checks);
        Self { ending, changes, cost, margin, milliseconds, expanded, checks }
    }

    pub(crate) fn is_solved(&self) -> bool {
        self.ending == Ending::Solved
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { changes, cost, margin, expanded, milliseconds, .. } = self;
        match self.ending {
            Ending::Solved => {
                write!(f, "{changes} gear changes with {:.1} cm, cost {cost:.2} m", margin * 100.0)?;
            }
            Ending::BoxedIn => write!(f, "boxed in")?,
            Ending::TooNarrow => write!(f, "too narrow")?,
            Ending::Searched => write!(f, "no way, searched to the end")?,
            Ending::BudgetSpent => write!(f, "budget spent")?,
            Ending::Failed => write!(f, "failed")?,
        }
        write!(f, ", {expanded} expansions, {milliseconds:.0} ms")
    }
}
