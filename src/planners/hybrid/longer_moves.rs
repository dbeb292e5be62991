//! Moves of a path driven as far as there is room, so that fewer do.
//!
//! A move is what lies between two gear changes. In a tight slot each turns the car as far as the room lets it. A
//! lattice leaves some of the room unused, as its steps have a length: ten times in a row that is a move too many.
//!
//! So from each move on, that one and those that follow are driven with the curvatures of the path, but until something
//! is in the way. Where one of them ends, the car has turned farther than the path had by then, and a Reeds–Shepp curve
//! may lead to a later part of the path and leave out moves between. The cheapest such path is taken. The same is tried
//! from the other end, where the slot may be.

use super::analytic_expansion::take_cheapest;
use super::cost::Motion;
use super::profile::FEW_CHANGES;
use super::shortcut::{self, MIN_GAIN, Rules};
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp::{self, Word};
use crate::geometry::{Pose, math};
use crate::vehicle::collision::{Reach, Sampling};

/// A move grows by this at most, metres.
const LONGER: f64 = 1.0;
/// Places that a curve may lead to are so far apart, metres.
const KNOT_SPACING: f64 = 0.5;
/// A curve leaves out so many gear changes of the path at least, though it may have some of its own. What leaves out
/// fewer is found by the shortcut.
const LEFT_OUT: u32 = 2;
/// Collision checks after which no more is tried, from each end.
const MAX_CHECKS: u32 = 30_000;
/// Curves of a search are checked so many times as far apart: moves that end at the margin may leave it between checks.
const FINER: f64 = 2.0;

/// A path from `start` to the same end that costs no more and has no more gear changes, free by the rules if `path` is.
/// One with few gear changes stays as it is.
pub(super) fn lengthen(rules: Rules, start: Pose, path: Vec<Arc>) -> Vec<Arc> {
    if arcs::direction_changes(&path) <= FEW_CHANGES {
        return path;
    }
    let rules = Rules { spacing: rules.spacing / FINER, ..rules };
    // Costs of places are sampled; those of a whole path tell.
    let cost = |path: &[Arc]| rules.costs.path(rules.checker, start, path);
    let cheaper = |path: Vec<Arc>, other: Option<Vec<Arc>>| match other {
        Some(other) if cost(&other) < cost(&path) => other,
        _ => path,
    };
    let ahead = from_start(rules, start, &path);
    let path = cheaper(path, ahead);
    let mirrored = rules.costs.mirrored();
    let reversed = Rules { costs: &mirrored, ..rules };
    let back = from_start(reversed, arcs::end(start, &path), &arcs::reversed(&path));
    cheaper(path, back.map(|arcs| arcs::reversed(&arcs)))
}

/// The cheapest path with longer moves near its start, if that costs less.
fn from_start(rules: Rules, start: Pose, path: &[Arc]) -> Option<Vec<Arc>> {
    let mut old = Old::new(rules, start, path);
    let limit = rules.checker.checks().saturating_add(MAX_CHECKS);
    let mut best = (old.cost + rules.costs.many_changes(old.changes(0)) - MIN_GAIN, None);
    let moves: Vec<&[Arc]> = path.chunk_by(|one, next| one.length * next.length > 0.0).collect();
    let replaced = moves.len().saturating_sub(LEFT_OUT as usize);
    let mut unchanged = Driven::at(start);
    for first in 0..replaced {
        let mut longer = unchanged.clone();
        for arcs in &moves[first..replaced] {
            if rules.checker.checks() >= limit || !longer.drive_far(rules, arcs) {
                break;
            }
            old.meet(rules, &longer, &mut best);
        }
        for &arc in moves[first] {
            unchanged.drive(rules, arc);
        }
    }
    best.1.map(arcs::merge)
}

/// What a path must cost less than, and the cheapest one that does.
type Best = (f64, Option<Vec<Arc>>);

/// What is driven so far.
#[derive(Clone)]
struct Driven {
    pose: Pose,
    arcs: Vec<Arc>,
    /// As far as it does not depend on the number of gear changes.
    cost: f64,
    changes: u32,
}

impl Driven {
    /// Nothing yet.
    fn at(pose: Pose) -> Self {
        Self { pose, arcs: Vec::new(), cost: 0.0, changes: 0 }
    }

    fn motion(&self) -> Motion {
        self.arcs.last().map_or_else(Motion::default, Motion::after)
    }

    #[inline(never)]
    fn drive(&mut self, rules: Rules, arc: Arc) {
        let before = self.motion();
        self.changes += u32::from(before.then(&arc).changes);
        self.cost += rules.costs.arc(before, &arc) + rules.costs.places(rules.checker, self.pose, &arc);
        self.pose = self.pose.advance(arc.curvature, arc.length);
        self.arcs.push(arc);
    }

    /// Drives a move, its last arc as far as there is room; false if something is in the way before.
    fn drive_far(&mut self, rules: Rules, arcs: &[Arc]) -> bool {
        let Rules { checker, spacing, margin, .. } = rules;
        let Some((&last, arcs)) = arcs.split_last() else { return false };
        for &arc in arcs {
            if !checker.arc_free(self.pose, &arc, spacing, margin) {
                return false;
            }
            self.drive(rules, arc);
        }
        let farthest = Arc { length: last.length + LONGER.copysign(last.length), ..last };
        let length = checker.free_length(self.pose, &farthest, spacing, margin);
        if length > 0.0 {
            self.drive(rules, Arc { length: length.copysign(last.length), ..last });
        }
        length > 0.0
    }
}

/// The old path, cut at the places that curves may lead to.
struct Old {
    arcs: Vec<Arc>,
    sampling: Sampling,
    /// Before each arc, and at the end: how far the body can go back from there.
    places: Vec<Reach>,
    /// Cost of the whole path, as far as it does not depend on the number of gear changes.
    cost: f64,
    /// The part of it from a place to the end that does not depend on how the car gets there.
    beyond: Vec<f64>,
    /// Gear changes up to there.
    changed: Vec<u32>,
}

impl Old {
    fn new(rules: Rules, start: Pose, path: &[Arc]) -> Self {
        let arcs = shortcut::split(path, KNOT_SPACING);
        let sampling = Sampling::new(rules.spacing, rules.margin, rules.costs.radius);
        let mut driven = Driven::at(start);
        let (mut places, mut beyond, mut changed) = (vec![Reach::new(start, sampling)], Vec::new(), vec![0]);
        for &arc in &arcs {
            let along = rules.costs.places(rules.checker, driven.pose, &arc);
            driven.drive(rules, arc);
            places.push(Reach::new(driven.pose, sampling));
            beyond.push(along - driven.cost);
            changed.push(driven.changes);
        }
        beyond.push(-driven.cost);
        for cost in &mut beyond {
            *cost += driven.cost;
        }
        Self { arcs, sampling, places, cost: driven.cost, beyond, changed }
    }

    /// Gear changes from a place to the end.
    fn changes(&self, place: usize) -> u32 {
        self.changed[self.arcs.len()] - self.changed[place]
    }

    /// Keeps the cheapest path that is driven so far and then leads by a curve to a later place.
    fn meet(&mut self, rules: Rules, driven: &Driven, best: &mut Best) {
        let mut ahead = Reach::new(driven.pose, self.sampling);
        for place in 0..self.places.len() {
            if self.changed[place] >= driven.changes + LEFT_OUT {
                self.meet_at(place, rules, driven, &mut ahead, best);
            }
        }
    }

    /// The same with a curve to one place. `ahead` is how far the body can go from where it was driven.
    fn meet_at(&mut self, place: usize, rules: Rules, driven: &Driven, ahead: &mut Reach, best: &mut Best) {
        let Rules { checker, costs, .. } = rules;
        let (from, to) = (driven.pose, self.places[place].from());
        // What the arc at the place costs depends on how the car gets there.
        let next = self.arcs.get(place);
        let spent = driven.cost + self.beyond[place];
        let changes = driven.changes + self.changes(place);
        let longest =
            best.0 - spent - costs.many_changes(changes) - next.map_or(0.0, |next| next.length.abs());
        let turn = math::turn(from.heading, to.heading).abs();
        if (to.point() - from.point()).norm_squared().sqrt().max(turn * costs.radius) >= longest {
            return;
        }
        let mut found: Vec<(f64, Word)> = Vec::new();
        for word in reeds_shepp::list_below(from, to, costs.radius, longest) {
            let mut motion = driven.motion();
            let mut cost = spent + costs.word(motion, &word);
            for arc in word.arcs(costs.radius) {
                motion = motion.then(&arc);
            }
            if let Some(next) = next {
                cost += costs.arc(motion, next);
                motion = motion.then(next);
            }
            let changes = changes + u32::from(motion.changes);
            cost += costs.many_changes(changes);
            if cost < best.0 && changes <= self.changes(0) {
                found.push((cost, word));
            }
        }
        while let Some((cost, word)) = take_cheapest(&mut found) {
            let cost = cost + costs.word_places(checker, from, &word);
            if cost < best.0 && ahead.is_word_free(&mut self.places[place], checker, &word, costs.radius) {
                let mut arcs = driven.arcs.clone();
                arcs.extend(word.arcs(costs.radius));
                arcs.extend_from_slice(&self.arcs[place..]);
                *best = (cost, Some(arcs));
                break;
            }
        }
    }
}

#[cfg(test)]
mod tests;
