//! What a report of hybrid A* says, in the words and figures of a plan.

use super::outcome::Member;
use super::outcome::{HybridMetrics, Stats};
use crate::geometry::arcs;
use crate::planners::hybrid::{Report, Status};
use crate::scenario::Scenario;
use crate::scenario::resolve::Geometry;

/// Speed of the parking paper's driving times, m/s.
const PAPER_SPEED: f64 = 2.0;

/// The sentence for people where there is no path: what is in the way, by its name, or how far the search came. The
/// page says the same in its own words from outcome, detail and obstruction; this text is for programs and the command.
pub(super) fn reason(scenario: &Scenario, geometry: &Geometry, report: &Report) -> Option<String> {
    let name = |owner| scenario.name_of(geometry.owner(owner));
    let near =
        report.closest.map_or_else(String::new, |p| format!(" The search came to ({:.2}, {:.2}).", p.x, p.y));
    Some(match report.status {
        Status::Found | Status::Suboptimal => return None,
        Status::StartInCollision(owner) => {
            format!("The car overlaps {} at the start. Move one of them.", name(owner))
        }
        Status::GoalInCollision(owner) => {
            format!("The car overlaps {} at the goal. Move one of them.", name(owner))
        }
        Status::Unreachable => {
            "No way through: some gap on every way is narrower than the car with its margin.".to_owned()
        }
        Status::TooNarrow(gap) => {
            format!(
                "No way through. The gap is about {:.1} m, the car needs {:.2} m.",
                gap.width, geometry.vehicle.width
            )
        }
        Status::NoRoom => format!(
            "No way through: the body would not fit even if it could move sideways and turn on the spot.{near}"
        ),
        Status::NoPath => format!("No way through for this car at these settings.{near}"),
        Status::BoxedIn { at_start, travel } => {
            let end = if at_start { "start" } else { "goal" };
            format!("The car is boxed in at the {end}: it can move {travel:.2} m in all.")
        }
        Status::BudgetExhausted(left) => {
            format!(
                "Stopped after {} expansions, {left:.1} m short of the goal.{near}",
                report.stats.expanded
            )
        }
        Status::VerificationFailed => "Every path found touches something between two checks.".to_owned(),
    })
}

/// How finely a search looked, in words.
pub(super) fn resolution(member: &Member) -> String {
    let small = |metres: f64| {
        if metres < 0.01 { format!("{:.0} mm", metres * 1000.0) } else { format!("{:.0} cm", metres * 100.0) }
    };
    let (cell, margin) = (small(member.xy_resolution), small(member.margin));
    let degrees = (member.heading_resolution.to_degrees() * 10.0).round() / 10.0;
    format!("at {cell} and {degrees}° with {margin} of margin")
}

pub(super) fn stats(report: &Report) -> Stats {
    Stats {
        expansions: Some(report.stats.expanded),
        collision_checks: Some(report.collision_checks),
        level: Some(report.level),
        ..Stats::of(report.stats)
    }
}

/// The figures that only hybrid A* has; those of every path are measured on the sampled poses.
pub(super) fn metrics(report: &Report) -> HybridMetrics {
    let length = arcs::length(&report.arcs);
    let steps: f64 = report.arcs.iter().map(|a| (a.length.abs() / 0.1).round()).sum();
    let gap = if report.rs_bound > 0.0 { (length / report.rs_bound - 1.0) * 100.0 } else { 0.0 };
    HybridMetrics {
        cost: report.cost,
        margin: report.margin,
        rs_bound: report.rs_bound,
        gap_percent: gap,
        paper_length: 0.1 * steps,
        paper_nodes: steps as u32 + 1,
        paper_time: 0.1 * steps / PAPER_SPEED,
        drive_time: None,
    }
}
