//! Which of hybrid A*'s paths is the answer, and which are worth showing beside it.
//!
//! A search minimises one cost: length with prices for reversing, gear changes and steering. People want other things
//! of a path: few changes, a wide berth, little time. Those are figures of the whole path, not sums over edges, so no
//! single search minimises them. Instead the planner makes several candidates, and this module keeps the *Pareto
//! front*: a path leaves it only when another is as good in length, gear changes, clearance and time at once.
//!
//! Two figures count as equal within 1 % (lengths, times) and 5 cm (clearances). Without these tolerances the front
//! would fill with paths that look the same. The preferred path is never dropped from the front, and the answer is the
//! best of all that were offered, in an order that does not depend on time.

use std::ops::ControlFlow;

use super::outcome::{Plan, Stats};
use crate::drive::{Limits, Motion, Route};
use crate::optimise::{self, optimise};
use crate::planners::hybrid::Prefer;
use crate::scenario::SpeedLimit;
use crate::scenario::resolve::Geometry;

/// Given a plan; breaks to end the search.
pub type Improved<'a> = &'a mut dyn FnMut(&Plan) -> std::ops::ControlFlow<()>;

/// Lengths and times are the same within this share …
const SAME: f64 = 0.01;
/// … and clearances within this, metres.
const SAME_CLEARANCE: f64 = 0.05;

/// A request to choose among paths.
///
/// `stickiness` is a share of the cost, from 0: the hysteresis that keeps a path from jumping to and fro while somebody
/// drags the goal.
pub(super) struct Wish<'a> {
    pub(super) prefer: Option<Prefer>,
    pub(super) alternatives: bool,
    pub(super) improved: Option<Improved<'a>>,
    pub(super) stickiness: f64,
}

impl Wish<'_> {
    /// True if the first path suffices. During a drag the preference only decides which path stays.
    pub(super) fn is_none(&self) -> bool {
        (self.prefer.is_none() || self.stickiness > 0.0) && !self.alternatives && self.improved.is_none()
    }

    /// True if the time of a path matters to the choice. It takes an optimisation for each path, so it is avoided
    /// otherwise.
    fn needs_time(&self) -> bool {
        self.prefer == Some(Prefer::Fastest) || self.alternatives
    }

    /// True if a path that stays is about as good as another by what is preferred; their times are estimates, in
    /// seconds.
    pub(super) fn keeps(&self, plans: [&Plan; 2], times: [f64; 2]) -> bool {
        let [mut old, mut new] = plans.map(Figures::of);
        [old.time, new.time] = times;
        let about = 1.0 + self.stickiness;
        match self.prefer {
            None => true,
            Some(Prefer::Shortest) => old.length <= new.length * about,
            Some(Prefer::FewestChanges) => (old.changes, old.length) <= (new.changes, new.length * about),
            Some(Prefer::Widest) => old.clearance >= new.clearance - SAME_CLEARANCE,
            Some(Prefer::Fastest) => old.time <= new.time * about,
        }
    }

    /// The only preference to search for, if no alternatives are asked for.
    pub(super) fn searched(&self) -> Option<Prefer> {
        self.prefer.filter(|_| !self.alternatives)
    }
}

/// A plan's path and the speed limits on it. `None` where no car can drive the path: it has corners or turns that are
/// too tight.
fn route(plan: &Plan, geometry: &Geometry, limits: &[SpeedLimit]) -> Option<Route> {
    let route = Route::new(&geometry.vehicle, &plan.path, &plan.directions, Some(&plan.curvatures)).ok()?;
    Some(route.with_speed_limits(limits))
}

/// About how long a path takes to drive as it is, seconds; infinite where it cannot be told. An optimisation is too
/// slow for each moment of a drag.
pub(super) fn estimated_time(plan: &Plan, geometry: &Geometry, limits: &[SpeedLimit]) -> f64 {
    let motion = route(plan, geometry, limits)
        .and_then(|route| Motion::new(&geometry.vehicle, &route, &Limits::default()).ok());
    motion.map_or(f64::INFINITY, |motion| motion.duration())
}

/// Tells how long the trajectory takes that [`optimise`] makes of a path of hybrid A*'s; nothing where it makes none.
///
/// The trajectory runs between the path's own ends, which may be another goal's than the scene's.
fn tell_time(plan: &mut Plan, geometry: &Geometry, limits: &[SpeedLimit]) {
    let (Some(&start), Some(&goal)) = (plan.path.first(), plan.path.last()) else { return };
    let geometry = Geometry { start, goal, ..geometry.clone() };
    let made = route(plan, &geometry, limits).and_then(|route| {
        optimise(&geometry, &route, plan.metrics.min_clearance, &optimise::Options::default()).ok()
    });
    if let Some(figures) = &mut plan.metrics.hybrid {
        figures.drive_time = made.map(|made| made.states.duration());
    }
}

/// The paths so far.
///
/// Invariant: `plans` is empty or `best` is an index in it.
pub(super) struct Choosing<'w> {
    wish: Wish<'w>,
    geometry: Geometry,
    limits: Vec<SpeedLimit>,
    /// All that are worth keeping; `best` is one of them.
    plans: Vec<Plan>,
    best: usize,
    /// Margin that the first one was planned with, metres.
    margin: f64,
}

impl<'w> Choosing<'w> {
    pub(super) fn new(wish: Wish<'w>, geometry: Geometry, limits: Vec<SpeedLimit>) -> Self {
        Self { wish, geometry, limits, plans: Vec::new(), best: 0, margin: 0.0 }
    }

    /// Takes another path; tells whether to look for more.
    ///
    /// The first path is the best so far by definition. A later one that is not better and is covered by one that is
    /// kept leaves without a trace; one that stays drops those that it covers.
    pub(super) fn offer(&mut self, mut plan: Plan) -> ControlFlow<()> {
        if self.wish.needs_time() {
            tell_time(&mut plan, &self.geometry, &self.limits);
        }
        let is_first = self.plans.is_empty();
        if is_first {
            self.margin = margin(&plan);
        }
        let is_best = is_first || self.is_better(&plan);
        if !is_best && self.plans.iter().any(|kept| covers(kept, &plan)) {
            return ControlFlow::Continue(());
        }
        let best = if is_best { self.plans.len() } else { self.best };
        let mut index = 0;
        let mut moved = 0;
        self.plans.retain(|kept| {
            let is_kept = (!is_best && index == best) || !covers(&plan, kept);
            moved += usize::from(!is_kept && index < best);
            index += 1;
            is_kept
        });
        self.best = best - moved;
        self.plans.push(plan);
        match &mut self.wish.improved {
            Some(improved) if is_best => improved(&self.plans[self.best]),
            _ => ControlFlow::Continue(()),
        }
    }

    /// True if a path is better than the best so far by what is preferred or, where nothing is, costs less and keeps as
    /// much margin as the first.
    fn is_better(&self, plan: &Plan) -> bool {
        let (new, old) = (Figures::of(plan), Figures::of(&self.plans[self.best]));
        match self.wish.prefer {
            None => margin(plan) >= self.margin && new.cost < old.cost,
            Some(Prefer::Shortest) => new.length < old.length,
            Some(Prefer::FewestChanges) => (new.changes, new.length) < (old.changes, old.length),
            Some(Prefer::Widest) => new.clearance > old.clearance,
            Some(Prefer::Fastest) => new.time < old.time,
        }
    }

    /// The answer, after as much work.
    ///
    /// Counters are those of all searches together; the level is that of the search which found the path.
    ///
    /// Panics if nothing was offered.
    pub(super) fn conclude(mut self, stats: &Stats) -> Plan {
        let level = self.plans[self.best].stats.level;
        let mut best = self.plans[self.best].clone();
        best.stats = Stats { level, ..stats.clone() };
        if !self.wish.needs_time() {
            tell_time(&mut best, &self.geometry, &self.limits);
        }
        if self.wish.alternatives {
            self.plans.sort_by(|a, b| a.metrics.length.total_cmp(&b.metrics.length));
            best.alternatives = self.plans;
        }
        best
    }
}

/// The figures by which paths are compared.
///
/// Metres, seconds and the planner's cost. A time that is not known counts as the largest number, so a path with a
/// known time is always faster.
struct Figures {
    length: f64,
    changes: u32,
    clearance: f64,
    time: f64,
    cost: f64,
}

impl Figures {
    /// The figures by which paths are compared; what a plan lacks counts as the worst.
    fn of(plan: &Plan) -> Self {
        let hybrid = plan.metrics.hybrid.as_ref();
        Self {
            length: plan.metrics.length,
            changes: plan.metrics.direction_changes,
            clearance: plan.metrics.min_clearance,
            time: hybrid.and_then(|figures| figures.drive_time).unwrap_or(f64::MAX),
            cost: hybrid.map_or(f64::MAX, |figures| figures.cost),
        }
    }
}

/// True if one path is as good as another in everything, but for differences that nobody would notice.
///
/// Not transitive because of the tolerances, which is why the order of the offers is fixed.
fn covers(one: &Plan, other: &Plan) -> bool {
    let (one, other) = (Figures::of(one), Figures::of(other));
    one.changes <= other.changes
        && one.length <= other.length * (1.0 + SAME)
        && one.time <= other.time * (1.0 + SAME)
        && one.clearance >= other.clearance - SAME_CLEARANCE
}

/// The margin that a plan was searched with, metres; 0 for other planners.
fn margin(plan: &Plan) -> f64 {
    plan.metrics.hybrid.as_ref().map_or(0.0, |figures| figures.margin)
}
