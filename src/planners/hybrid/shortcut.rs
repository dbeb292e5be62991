//! Replacing stretches of a path by shorter Reeds–Shepp curves.

use super::cost::{CostModel, Motion};
use super::domain::take_cheapest;
use crate::geometry::Pose;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp::{self, Word};
use crate::vehicle::collision::Probe;

/// Arcs are split at most this far apart, metres.
const KNOT: f64 = 1.0;
/// A replacement must save at least this much.
const GAIN: f64 = 1e-3;
/// Collision checks after which shortcutting ends: work, not time, so that the result is the same everywhere.
const WORK: u32 = 400_000;
const PASSES: u32 = 6;

/// A path of arcs from `start`, made cheaper where a curve between two of its knots is free. Gear changes never
/// increase.
pub(super) fn shortcut(
    probe: &Probe,
    costs: &CostModel,
    start: Pose,
    path: Vec<Arc>,
    spacing: f64,
    margin: f64,
) -> Vec<Arc> {
    let limit = probe.checks().saturating_add(WORK);
    let mut path = path;
    for _ in 0..PASSES {
        let before = path.len();
        let cost = costs.path(probe, start, Motion::default(), &path);
        path = pass(probe, costs, start, &path, spacing, margin, limit);
        let gain = cost - costs.path(probe, start, Motion::default(), &path);
        if (gain < GAIN && path.len() == before) || probe.checks() >= limit {
            break;
        }
    }
    path
}

fn split(path: &[Arc]) -> Vec<Arc> {
    path.iter()
        .flat_map(|arc| {
            let parts = (arc.length.abs() / KNOT).ceil().max(1.0);
            let part = Arc { length: arc.length / parts, ..*arc };
            core::iter::repeat_n(part, parts as usize)
        })
        .collect()
}

fn pass(
    probe: &Probe,
    costs: &CostModel,
    start: Pose,
    path: &[Arc],
    spacing: f64,
    margin: f64,
    limit: u32,
) -> Vec<Arc> {
    let mut knots = split(path);
    let mut i = 0;
    let mut from = start;
    while i < knots.len() {
        let before = if i == 0 { Motion::default() } else { Motion::after(&knots[i - 1]) };
        let poses: Vec<Pose> = ends(from, &knots[i..]);
        for j in (i + 2..=knots.len()).rev() {
            if probe.checks() >= limit {
                return arcs::merge(knots);
            }
            let to = poses[j - i - 1];
            let old = stretch_cost(probe, costs, from, before, &knots[i..], j - i);
            let replacement =
                Candidate { probe, costs, from, to, before, next: knots.get(j), spacing, margin };
            let changes = changes(before, knots[i..j].iter().copied(), knots.get(j));
            if let Some(better) = replacement.best(old - GAIN, changes) {
                knots.splice(i..j, better);
                break;
            }
        }
        from = from.advance(knots[i].curvature, knots[i].length);
        i += 1;
    }
    arcs::merge(knots)
}

fn ends(from: Pose, arcs: &[Arc]) -> Vec<Pose> {
    let mut pose = from;
    arcs.iter()
        .map(|arc| {
            pose = pose.advance(arc.curvature, arc.length);
            pose
        })
        .collect()
}

/// Cost of the first `count` arcs, and of joining the one after them.
fn stretch_cost(
    probe: &Probe,
    costs: &CostModel,
    from: Pose,
    before: Motion,
    knots: &[Arc],
    count: usize,
) -> f64 {
    let cost = costs.path(probe, from, before, &knots[..count]);
    cost + knots.get(count).map_or(0.0, |next| costs.arc(Motion::after(&knots[count - 1]), next))
}

fn changes(before: Motion, arcs: impl IntoIterator<Item = Arc>, next: Option<&Arc>) -> u32 {
    let gears = arcs.into_iter().chain(next.copied()).map(|a| Motion::after(&a).gear);
    let mut gear = before.gear;
    gears.fold(0, |count, g| {
        let changed = gear != 0 && g != gear;
        gear = g;
        count + u32::from(changed)
    })
}

struct Candidate<'a> {
    probe: &'a Probe<'a>,
    costs: &'a CostModel,
    from: Pose,
    to: Pose,
    before: Motion,
    next: Option<&'a Arc>,
    spacing: f64,
    margin: f64,
}

impl Candidate<'_> {
    /// The cheapest free curve below `bound` with at most `max_changes` gear changes.
    fn best(&self, bound: f64, max_changes: u32) -> Option<Vec<Arc>> {
        let radius = self.costs.radius;
        let join = |last: &Arc| self.next.map_or(0.0, |next| self.costs.arc(Motion::after(last), next));
        let next_length = self.next.map_or(0.0, |n| n.length.abs());
        let mut found: Vec<(f64, Word)> = Vec::new();
        reeds_shepp::words(self.from, self.to, radius, |word| {
            if word.length(radius) + next_length >= bound {
                return;
            }
            let Some(last) = word.arcs(radius).last() else { return };
            let mut before = self.before;
            let mut cost = join(&last);
            for arc in word.arcs(radius) {
                cost += self.costs.arc(before, &arc);
                before = Motion::after(&arc);
            }
            if cost < bound && changes(self.before, word.arcs(radius), self.next) <= max_changes {
                found.push((cost, word));
            }
        });
        core::iter::from_fn(|| take_cheapest(&mut found))
            .map(|(cost, word)| (cost, word.arcs(radius).collect::<Vec<Arc>>()))
            .find(|(cost, arcs)| self.free(arcs) && cost + self.nearness(arcs) < bound)
            .map(|found| found.1)
    }

    fn free(&self, arcs: &[Arc]) -> bool {
        let mut pose = self.from;
        arcs.iter().all(|arc| {
            let free = self.probe.arc_free(pose, arc, self.spacing, self.margin);
            pose = pose.advance(arc.curvature, arc.length);
            free
        })
    }

    fn nearness(&self, arcs: &[Arc]) -> f64 {
        let mut pose = self.from;
        arcs.iter()
            .map(|arc| {
                let near = self.costs.nearness(self.probe, pose, arc);
                pose = pose.advance(arc.curvature, arc.length);
                near
            })
            .sum()
    }
}
