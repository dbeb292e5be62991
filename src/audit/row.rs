//! The answers of an audit.
//!
//! A row is one question: a bay, a vehicle, an entrance and an entry (head first or in reverse). It says whether
//! the vehicle gets in and out again, in how many moves, and what stands in the way where it does not.

use serde::Serialize;

use crate::geometry::{Point, Pose};
use crate::metrics::Verdict;
use crate::plan::{Detail, Outcome, Plan, Planner};
use crate::planners::{Gap, Obstruction};
use crate::scenario::Entry;
use crate::scenario::resolve::Owner;

/// Poses of the swept body are this far apart, in poses of the path: half a metre.
const SWEPT_EVERY: usize = 5;

/// The answer for one bay, vehicle, entrance and entry.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Row {
    /// The bay's id, or `#` and its number from 1.
    pub bay: String,
    /// Its index in the scene's slots.
    pub index: usize,
    /// The vehicle's id.
    pub vehicle: String,
    /// The entrance's id.
    pub entrance: String,
    /// Which way the nose points in the bay.
    pub entry: Entry,
    /// How far the parked body sticks out of the bay, metres along its lines or across them; 0 where it fits.
    pub overhang: f64,
    /// The way in.
    #[serde(flatten)]
    pub way: Way,
    /// The way out, if asked for.
    pub out: Option<Way>,
}

/// A way in or out, or why there is none.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Way {
    /// True if there is a path that the independent validator accepts.
    pub reachable: bool,
    /// How planning ended: `budget-spent` where nothing is proven.
    pub outcome: &'static str,
    /// A finer word for the outcome.
    pub detail: Option<&'static str>,
    /// For people, where there is no path.
    pub reason: Option<String>,
    /// The place that blocks the way, or the obstacle's point nearest to the body on it; metres.
    pub place: Option<[f64; 2]>,
    /// The name of what stands there.
    pub blocker: Option<String>,
    /// Gear changes and one; 0 without a path. A move is a stretch without a gear change, so driving straight in is one
    /// move.
    pub moves: u32,
    /// Metres. Of the path; 0 without one.
    pub length: f64,
    /// Seconds, the wheel turned at standstill at gear changes; `None` without a path.
    pub drive_time: Option<f64>,
    /// Least distance from the body to anything along the way, metres.
    pub clearance: f64,
    /// The plan's hash.
    pub hash: String,
    /// Poses half a metre apart along the way, and its last.
    #[serde(skip)]
    pub swept: Vec<Pose>,
}

impl Row {
    /// The entry as the JS API spells it.
    pub const fn entry_word(&self) -> &'static str {
        match self.entry {
            Entry::HeadIn => "head-in",
            Entry::ReverseIn => "reverse-in",
        }
    }
}

impl Way {
    /// Takes the figures of a plan. A path that the validator refuses keeps its length and clearance, but is not
    /// reachable and has no moves.
    pub(super) fn of(planner: &Planner, plan: &Plan) -> Self {
        let reachable = plan.outcome == Outcome::Found && plan.check.verdict == Verdict::Ok;
        let (place, owner) = place(planner, plan);
        let time = reachable.then(|| planner.driving_time(plan)).filter(|time| time.is_finite());
        let ends = plan.path.last().filter(|_| plan.path.len() % SWEPT_EVERY != 1);
        Self {
            reachable,
            outcome: plan.outcome.as_str(),
            detail: plan.detail.map(Detail::as_str),
            reason: plan.reason.clone(),
            place: place.map(|p| [p.x, p.y]),
            blocker: owner.map(|number| planner.scenario().name_of(number)),
            moves: if reachable { plan.metrics.direction_changes + 1 } else { 0 },
            length: plan.metrics.length,
            drive_time: time,
            clearance: plan.metrics.min_clearance,
            hash: plan.hash(),
            swept: plan.path.iter().step_by(SWEPT_EVERY).chain(ends).copied().collect(),
        }
    }

    /// No plan could be asked for.
    pub(super) fn refused(reason: String) -> Self {
        Self {
            reachable: false,
            outcome: Outcome::NoPath.as_str(),
            detail: None,
            reason: Some(reason),
            place: None,
            blocker: None,
            moves: 0,
            length: 0.0,
            drive_time: None,
            clearance: 0.0,
            hash: String::new(),
            swept: Vec::new(),
        }
    }
}

/// What stands in the way, and where. A point of the world frame, metres, and the thing in the scene that owns it.
///
/// Without a path the obstruction decides: an end in contact, enclosed or boxed in gives the middle of the car there, a
/// gap that is too narrow its own place. With a path it is the narrowest place.
fn place(planner: &Planner, plan: &Plan) -> (Option<Point>, Option<Owner>) {
    let geometry = planner.geometry();
    let end = |at_start| if at_start { geometry.start } else { geometry.goal };
    let middle = |pose: Pose| pose.point() + pose.direction() * geometry.vehicle.middle();
    match &plan.obstruction {
        None => match plan.check.narrowest {
            Some(narrowest) => (Some(narrowest.obstacle), Some(narrowest.owner)),
            None => (None, None),
        },
        Some(Obstruction::Contact { at_start, owner }) => {
            (Some(middle(end(*at_start))), Some(geometry.owner(*owner)))
        }
        Some(Obstruction::Enclosed { at_start, .. }) => (Some(middle(end(*at_start))), None),
        Some(Obstruction::BoxedIn { at_start, stops }) => {
            (Some(middle(end(*at_start))), stops.first().map(|stop| geometry.owner(stop.1)))
        }
        Some(Obstruction::Gap(Gap { at, .. }) | Obstruction::Nearest { at, .. }) => (Some(*at), None),
    }
}
