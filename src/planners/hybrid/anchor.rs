//! The path before, led to other ends: while an end is dragged, of two ways that are about as good the one that is shown stays.

use super::cost::{CostModel, Motion};
use super::domain::take_cheapest;
use super::{Config, Query, Report, Status, shortcut};
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp::{self, Word};
use crate::geometry::{Pose, math};
use crate::vehicle::collision::Probe;

/// Knots of the path are this far apart, metres.
const KNOT: f64 = 0.5;
/// Knots at either end among which a new end may join.
const JOINTS: usize = 16;
/// Spacing of collision checks, metres.
const SPACING: f64 = 0.1;
/// Ends closer than this are the same, metres and radians.
const SAME: f64 = 1e-9;

/// A path and where it begins, in the obstacles' coordinates.
#[derive(Debug, Clone)]
pub struct Last {
    start: Pose,
    arcs: Vec<Arc>,
}

impl Last {
    /// What to remember of an answer.
    pub fn of(query: &Query, report: &Report) -> Self {
        Self { start: query.obstacles.local(query.start), arcs: report.arcs.clone() }
    }
}

/// The last path between the ends of this question with the margin of its answer `report`; `None` where it cannot be led there.
/// Its counters are those of `report`.
pub fn anchored(query: &Query, config: &Config, last: &Last, report: &Report) -> Option<Report> {
    let probe = Probe::new(query.obstacles, query.vehicle);
    let [start, goal] = [query.start, query.goal].map(|pose| query.obstacles.local(pose));
    let costs = CostModel::driven(config, query.vehicle.min_turning_radius(), [start, goal]);
    let joining = Joining { probe: &probe, costs: &costs, margin: report.margin };
    let knots = split(&last.arcs);
    let back: Vec<Arc> = arcs::reversed(&knots);
    let (head, from) = joining.lead(start, last.start, &knots)?;
    let (tail, to) = joining.lead(goal, arcs::end(last.start, &last.arcs), &back)?;
    let kept = knots.get(from..knots.len() - to)?;
    let path = head.into_iter().chain(kept.iter().copied()).chain(arcs::reversed(&tail));
    let rules = shortcut::Rules { probe: &probe, costs: &costs, spacing: SPACING, margin: report.margin };
    let path = shortcut::shortcut(rules, start, arcs::merge(path));
    let cost = costs.path(&probe, start, &path);
    Some(Report { arcs: path, cost, status: Status::Suboptimal, ..report.clone() })
}

fn split(path: &[Arc]) -> Vec<Arc> {
    let parts = |arc: &Arc| {
        let count = (arc.length.abs() / KNOT).ceil().max(1.0);
        core::iter::repeat_n(Arc { length: arc.length / count, ..*arc }, count as usize)
    };
    path.iter().flat_map(parts).collect()
}

struct Joining<'a> {
    probe: &'a Probe<'a>,
    costs: &'a CostModel,
    margin: f64,
}

impl Joining<'_> {
    /// The cheapest curve from a new end to one of the first knots of a path from `old`, and how many knots it replaces.
    fn lead(&self, new: Pose, old: Pose, knots: &[Arc]) -> Option<(Vec<Arc>, usize)> {
        let apart = (new.point() - old.point()).norm() + math::turn(new.heading, old.heading).abs();
        if apart < SAME {
            return Some((Vec::new(), 0));
        }
        let (mut pose, mut spent, mut before) = (old, 0.0, Motion::default());
        let mut best: Option<(f64, Word, usize)> = None;
        for replaced in 0..=knots.len().min(JOINTS) {
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
                let free = self.probe.arc_free(pose, &arc, SPACING, self.margin);
                pose = pose.advance(arc.curvature, arc.length);
                free
            })
        })
    }
}
