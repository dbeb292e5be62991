//! Replacing stretches of a path by shorter Reeds–Shepp curves.
//!
//! A lattice has few steering angles and one step length, so its paths wind a little. The path is cut into knots; for
//! each pair of them, the farthest apart first, the cheapest free curve replaces what lies between if it costs less by
//! the same cost model and adds no gear change. Each replacement lowers the cost, so passes end; n knots give O(n²)
//! pairs, which is why pairs and collision checks have limits.
//!
//! Rounds go on until nothing is replaced any more, six at most for each spacing. A pair that a round has tried in vain
//! is not tried again while both its knots stay where they are.
//!
//! The result is deterministic: limits count work, not time.
//!
//! The lattice prefers paths that follow its own arcs; the shortcut knows only the car. For knots i < j with the
//! costs c of the way driven between them, a word of length ℓ is looked at only if ℓ < c, because no metre costs less
//! than 1. Straight distance rules out most pairs before any curve is computed, and the reach of the body, measured
//! once per knot and kept, rules out most curves before a collision check.

use super::analytic_expansion::take_cheapest;
use super::cost::{CostModel, Motion};
use crate::geometry::Pose;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp::{self, Word};
use crate::vehicle::collision::{CollisionChecker, Reach, Sampling};

/// Arcs are split at most this far apart, metres: first coarsely, which does most of it, then finely.
pub(super) const KNOT_SPACINGS: [f64; 2] = [1.0, 0.5];
/// A replacement must save at least this much.
pub(super) const MIN_GAIN: f64 = 1e-3;
/// Collision checks after which shortcutting ends: work, not time, so that the result is the same everywhere.
const MAX_CHECKS: u32 = 400_000;
const MAX_PASSES: u32 = 6;
/// Knots nearer to each other than this are the same, metres.
const SAME_PLACE: f64 = 1e-7;
/// Pairs of knots that a round looks at, at most: on a long way hardly any curve is free over more than a short
/// stretch.
const MAX_PAIRS: usize = 6000;

/// How a replacement is tested.
#[derive(Clone, Copy)]
pub(super) struct Rules<'a> {
    pub(super) checker: &'a CollisionChecker<'a>,
    pub(super) costs: &'a CostModel,
    /// Spacing of collision checks, metres.
    pub(super) spacing: f64,
    pub(super) margin: f64,
}

/// A path of arcs from `start`, made cheaper where a curve between two of its knots is free. Gear changes never
/// increase.
///
/// Start and end pose stay as they are to rounding, and the cost never rises. `path` must be free by the same rules;
/// what is not replaced is not checked again. Arcs are split by each of `spacings` in turn.
pub(super) fn shortcut(rules: Rules, start: Pose, mut path: Vec<Arc>, spacings: &[f64]) -> Vec<Arc> {
    let limit = rules.checker.checks().saturating_add(MAX_CHECKS);
    let mut settled = Vec::new();
    for &knot in spacings {
        for _ in 0..MAX_PASSES {
            let mut pass = Pass::new(rules, start, split(&path, knot), settled);
            let mut known = pass.places.clone();
            let improved = pass.run(limit);
            // A knot that was replaced may come back where it was, with another path on either side.
            known.retain(|old| is_among(old.pose, &pass.places));
            settled = known;
            path = arcs::merge(pass.knots);
            if !improved || rules.checker.checks() >= limit {
                break;
            }
        }
    }
    path
}

/// The path with each arc cut into equal parts of at most `knot` metres.
pub(super) fn split(path: &[Arc], knot: f64) -> Vec<Arc> {
    let mut knots = Vec::new();
    for arc in path {
        let parts = (arc.length.abs() / knot).ceil().max(1.0);
        for _ in 0..parts as usize {
            knots.push(Arc { length: arc.length / parts, ..*arc });
        }
    }
    knots
}

/// Where a knot begins.
#[derive(Clone, Copy)]
struct Place {
    pose: Pose,
    /// Cost up to there.
    spent: f64,
    /// Gear changes up to there.
    changed: u32,
    /// True in the round in which it is new.
    is_fresh: bool,
}

/// One round over all pairs of knots. Invariant: there is one place more than `knots`; a replacement renews what
/// follows it.
struct Pass<'a> {
    rules: Rules<'a>,
    /// Knots that a replaced stretch has, at most.
    reach: usize,
    knots: Vec<Arc>,
    /// Before each knot's arc, and at the end.
    places: Vec<Place>,
    /// Those between which all pairs were tried in vain.
    settled: Vec<Place>,
    sampling: Sampling,
    /// How far the body can go ahead from the knot at hand, and back from each of the others.
    ahead: Reach,
    back: Vec<Option<Reach>>,
}

impl<'a> Pass<'a> {
    /// A pass over a path's knots. Pairs are limited by [`MAX_PAIRS`], so a path of many knots is looked at less far
    /// ahead.
    fn new(rules: Rules<'a>, start: Pose, knots: Vec<Arc>, settled: Vec<Place>) -> Self {
        let reach = MAX_PAIRS / knots.len().max(1);
        let sampling = Sampling::new(rules.spacing, rules.margin, rules.costs.radius);
        let first = Place { pose: start, spent: 0.0, changed: 0, is_fresh: settled.is_empty() };
        let (places, back, ahead) = (vec![first], Vec::new(), Reach::new(start, sampling));
        let mut pass = Self { rules, reach, knots, places, settled, sampling, ahead, back };
        pass.measure(0);
        pass
    }

    /// Poses, costs and gear changes beyond knot `from`.
    fn measure(&mut self, from: usize) {
        self.places.truncate(from + 1);
        self.back.truncate(from + 1);
        self.back.resize(self.knots.len() + 1, None);
        for k in from..self.knots.len() {
            let (arc, Place { pose, spent, changed, .. }) = (self.knots[k], self.places[k]);
            let cost = self.rules.costs.arc(self.before(k), &arc)
                + self.rules.costs.places(self.rules.checker, pose, &arc);
            let pose = pose.advance(arc.curvature, arc.length);
            self.places.push(Place {
                pose,
                spent: spent + cost,
                changed: changed + u32::from(self.before(k).then(&arc).changes),
                is_fresh: !is_among(pose, &self.settled),
            });
        }
    }

    /// How the car arrives at knot `k`; at the start it has neither gear nor curvature.
    fn before(&self, k: usize) -> Motion {
        if k == 0 { Motion::default() } else { Motion::after(&self.knots[k - 1]) }
    }

    /// Cost of driving into knot `k`'s arc, if there is one, after `last`.
    fn join(&self, k: usize, last: &Arc) -> f64 {
        self.knots.get(k).map_or(0.0, |next| self.rules.costs.arc(Motion::after(last), next))
    }

    /// Tries every pair once, the farthest first; tells whether something was replaced.
    fn run(&mut self, limit: u32) -> bool {
        let mut improved = false;
        let mut i = 0;
        while i < self.knots.len() {
            self.ahead = Reach::new(self.places[i].pose, self.sampling);
            for j in (i + 2..=self.knots.len().min(i + self.reach)).rev() {
                if self.rules.checker.checks() >= limit {
                    return improved;
                }
                if !self.places[i].is_fresh && !self.places[j].is_fresh {
                    continue;
                }
                if let Some(word) = self.better(i, j) {
                    self.knots.splice(i..j, word.arcs(self.rules.costs.radius));
                    self.measure(i);
                    improved = true;
                    break;
                }
            }
            i += 1;
        }
        improved
    }

    /// The cheapest free curve from knot `i` to knot `j` that costs less than the stretch and has no more gear changes.
    fn better(&mut self, i: usize, j: usize) -> Option<Word> {
        let Rules { checker, costs, .. } = self.rules;
        let [begin, end] = [self.places[i], self.places[j]];
        let (from, to) = (begin.pose, end.pose);
        let old = end.spent - begin.spent + self.join(j, &self.knots[j - 1]) - MIN_GAIN;
        let longest = old - self.knots.get(j).map_or(0.0, |next| next.length.abs());
        if (to.point() - from.point()).norm_squared().sqrt() >= longest {
            return None;
        }
        let before = self.before(i);
        let next = self.knots.get(j);
        let allowed = self.places[self.knots.len().min(j + 1)].changed - begin.changed;
        let mut found: Vec<(f64, Word)> = Vec::new();
        // Most stretches are driven in one gear.
        let list = if allowed == 0 { reeds_shepp::list_in_one_gear } else { reeds_shepp::list_below };
        for word in list(from, to, costs.radius, longest) {
            let Some(last) = word.arcs(costs.radius).last() else { continue };
            let cost = costs.word(before, &word) + self.join(j, &last);
            if cost >= old {
                continue;
            }
            let arcs = word.arcs(costs.radius).chain(next.copied());
            if u32::from(arcs.fold(before, |motion, arc| motion.then(&arc)).changes) <= allowed {
                found.push((cost, word));
            }
        }
        core::iter::from_fn(|| take_cheapest(&mut found))
            .find(|(cost, word)| self.free(j, word) && cost + costs.word_places(checker, from, word) < old)
            .map(|found| found.1)
    }

    /// True if a word from the knot at hand to knot `to` can be driven.
    fn free(&mut self, to: usize, word: &Word) -> bool {
        let Rules { checker, costs, .. } = self.rules;
        let back = self.back[to].get_or_insert_with(|| Reach::new(self.places[to].pose, self.sampling));
        self.ahead.is_word_free(back, checker, word, costs.radius)
    }
}

/// True if one of some knots begins at a pose.
#[inline(never)]
fn is_among(pose: Pose, places: &[Place]) -> bool {
    let is_near =
        |one: &Place| (one.pose.x - pose.x).abs() < SAME_PLACE && (one.pose.y - pose.y).abs() < SAME_PLACE;
    places.iter().any(is_near)
}
