//! An answer held against what other settings find, by the measure that is asked for.
//!
//! Prices other than the usual ones lead the search elsewhere: it may spend its budget near obstacles that are dear, or
//! end with a path that costs more, by these very prices, than the one of a planner that knows nothing of them. Less
//! margin leads the lattices elsewhere, too. So the answer to such settings is held against that of the usual prices
//! and that of the usual margin. The usual answer itself has no rival: it is what most people wait for. A search for
//! better paths holds every answer against more settings (`choices`).
//!
//! A rival has rivals of its own, so all settings choose among the same paths, and none loses to the others.

use super::config::Config;
use super::cost::CostModel;
use super::portfolio::{COMFORTABLE_MARGIN, MANY_CHANGES};
use super::profile::{FEW_CHANGES, Profile};
use super::question::{MIN_MARGIN, Query};
use super::report::{Report, Status};
use crate::IS_COMPLETE;
use crate::geometry::arcs;
use crate::vehicle::collision::CollisionChecker;

/// A path that costs no more than this many times the shortest curve without obstacles has no rivals.
const SETTLED: f64 = 1.01;

impl Config {
    /// The same with the prices of other settings, by which paths are compared.
    fn with_prices_of(self, other: &Self) -> Self {
        Self {
            profile: Profile::Practical,
            reverse_cost: other.reverse_cost,
            direction_change_cost: other.direction_change_cost,
            steer_cost: other.steer_cost,
            steer_change_cost: other.steer_change_cost,
            obstacle_cost: other.obstacle_cost,
            ..self
        }
    }

    /// The settings whose answers this one's is held against.
    fn rivals(&self, report: &Report) -> Vec<Self> {
        // A single search was asked for, or the first connection.
        if !self.ladder || self.first_shot || is_settled(report) {
            return Vec::new();
        }
        let usual = Self::default();
        let is_winding = arcs::direction_changes(&report.arcs) > FEW_CHANGES;
        let is_coarse = report.level == 0 && report.margin >= self.margin;
        let is_short = self.profile == Profile::Shortest && (is_winding || !is_coarse);
        // The same searches would spend their budget again.
        let is_spent = matches!(report.status, Status::BudgetExhausted(_));
        let mut rivals = Vec::new();
        if (is_short && !is_spent) || usual.with_prices_of(&self.with_profile()) != usual {
            rivals.push(self.with_prices_of(&usual));
        }
        if self.margin < usual.margin && !is_spent {
            rivals.push(Self { margin: usual.margin, ..*self });
        }
        rivals
    }
}

/// True if no path with as much margin costs much less.
fn is_settled(report: &Report) -> bool {
    report.level == 0 && !report.arcs.is_empty() && report.cost <= SETTLED * report.rs_bound
}

/// The cheapest of an answer and its rivals. Its counters are those of all searches. `search` plans with other settings
/// after so many expansions; nothing where the caller has ended the plan.
pub(super) fn compare(
    query: &Query,
    config: &Config,
    mut report: Report,
    search: &mut dyn FnMut(&Config, u32) -> Option<Report>,
) -> Report {
    // That a lattice holds no path by these prices is no proof for the same lattice by others.
    let is_open = !report.are_apart
        && matches!(
            report.status,
            Status::BudgetExhausted(_) | Status::VerificationFailed | Status::NoPath | Status::BoxedIn { .. }
        );
    if report.stats.expanded == 0 || (report.arcs.is_empty() && !is_open) {
        return report;
    }
    let asked = config.margin.max(MIN_MARGIN);
    for rival in config.rivals(&report) {
        let Some(mut other) = search(&rival, report.stats.expanded) else { break };
        other.margin = other.margin.min(asked);
        other.cost = cost(query, config, &other);
        let is_better = !other.arcs.is_empty()
            && (report.arcs.is_empty()
                || other.margin > report.margin
                || (other.margin == report.margin && other.cost < report.cost)
                || (IS_COMPLETE && gives_up_margin(&other, &report)));
        let checks = report.collision_checks.saturating_add(other.collision_checks);
        let mut sum = report.counters();
        sum.stats.add(other.stats);
        let status = if is_better { Status::Suboptimal } else { report.status };
        let best = if is_better { other } else { report };
        report = Report { status, collision_checks: checks, ..sum.with_path_of(best) };
    }
    report
}

/// True if a cheaper path gives up margin, down to what is comfortable, where there are many gear changes, and takes
/// no more of them: the usual answer may do so.
fn gives_up_margin(other: &Report, report: &Report) -> bool {
    let [fewer, many] = [other, report].map(|one| arcs::direction_changes(&one.arcs));
    other.margin >= COMFORTABLE_MARGIN && fewer <= many && many > MANY_CHANGES && other.cost < report.cost
}

/// What a path costs under the settings asked for.
fn cost(query: &Query, config: &Config, report: &Report) -> f64 {
    let [start, goal] = [query.start, query.goal].map(|pose| query.obstacles.local(pose));
    let checker = CollisionChecker::new(query.obstacles, query.vehicle);
    CostModel::driven(config, query.vehicle.min_turning_radius(), [start, goal]).path(
        &checker,
        start,
        &report.arcs,
    )
}
