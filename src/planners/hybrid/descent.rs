//! Changing the lengths of a path's arcs until it costs no less any more.
//!
//! The shortcut keeps the poses through which a lattice led, and replaces what lies between. What is left are paths of
//! few arcs whose gear changes stand where the lattice put them. This moves them: curvatures and gears stay, lengths
//! change, and an arc may vanish.
//!
//! A direction says by how much each arc of a stretch grows. Three of them follow from the others, as the end must stay
//! where it is: with the columns cₙ by which the end moves as arc n grows, Σ cₙ·Δₙ = 0. The lengths change by a step
//! that way, or until an arc vanishes, and Newton's method closes what the straight line misses. What costs less and is
//! free is kept. Steps become ever shorter.
//!
//! The directions are the edges of what is allowed, as in the simplex method: all groups of four within eight
//! neighbours, of which one grows and three follow. Where no edge leads on, some random ones are tried, which slide
//! along obstacles that stop every edge.
//!
//! Most attempts hit something, and most of them at the same few places. So the places where attempts failed are
//! checked first, the latest in front: most attempts end after one check.

use super::cost::Motion;
use super::shortcut::{MIN_GAIN, Rules};
use crate::geometry::arcs::{self, Arc};
use crate::geometry::{Pose, math};

/// The arc that changes most changes by so much at a time, metres.
const STEPS: [f64; 4] = [0.4, 0.2, 0.1, 0.05];
/// Rounds over all directions with each step, at most.
const MAX_ROUNDS: u32 = 4;
/// A direction that succeeds is tried so often in a row.
const REPEATS: u32 = 3;
/// Arcs that change together, at most; random directions change all of so many.
const STRETCH: usize = 8;
/// Random directions for each such stretch; the next one begins half a stretch on.
const RANDOM_DIRECTIONS: u32 = 40;
/// Attempts for one path, at most: a path of a thousand arcs would take seconds.
const MAX_ATTEMPTS: u32 = 100_000;
/// A direction by which the cost falls by less for each metre of the largest change is left.
const MIN_SLOPE: f64 = 0.02;
/// Columns that span less than this depend on each other.
const DEPENDENT: f64 = 1e-6;
/// A path is closed if its end misses by less, metres and radians.
const CLOSED: f64 = 1e-9;
/// By less than this it misses where a check tells whether it hits something.
const ROUGHLY_CLOSED: f64 = 1e-3;
const MAX_NEWTON_STEPS: u32 = 6;
/// Places where attempts failed, at most.
const MAX_HITS: usize = 32;
/// Curves of a search are checked so many times as far apart: arcs that touch the margin may leave it between checks.
const FINER: f64 = 2.0;

/// A path from `start` to the same end that costs no more and has no more gear changes, free by the rules if `arcs` is.
pub(super) fn descend(rules: Rules, start: Pose, arcs: Vec<Arc>) -> Vec<Arc> {
    let mut path = Path::new(rules, start, arcs::merge(arcs));
    for step in STEPS {
        path.round += 1;
        path.moved.fill(path.round);
        for _ in 0..MAX_ROUNDS {
            if !path.along_edges(step) && !path.along_random(step) {
                break;
            }
            path.round += 1;
        }
    }
    path.arcs
}

/// How the end of a path moves for each metre that one of its arcs grows: x, y, heading.
type Column = [f64; 3];

/// A pose, with sine and cosine of its heading.
#[derive(Clone, Copy)]
struct Stand {
    pose: Pose,
    turned: (f64, f64),
}

impl Stand {
    #[inline]
    fn after(self, arc: &Arc, length: f64) -> Self {
        let (pose, turned) = self.pose.advance_turning(self.turned, arc.curvature, length);
        Self { pose, turned }
    }
}

/// The path at hand. Invariant: its end never moves.
struct Path<'a> {
    rules: Rules<'a>,
    arcs: Vec<Arc>,
    /// Before each arc, and at the end.
    stands: Vec<Stand>,
    /// Costs of the places that each arc leads through.
    places: Vec<f64>,
    /// The round in which each arc was last moved.
    moved: Vec<u32>,
    round: u32,
    attempts: u32,
    /// Where attempts failed: on which arc, and how far from its beginning, metres.
    hits: Vec<(usize, f64)>,
    /// State of the random numbers.
    random: u32,
}

impl<'a> Path<'a> {
    fn new(rules: Rules<'a>, start: Pose, arcs: Vec<Arc>) -> Self {
        let rules = Rules { spacing: rules.spacing / FINER, ..rules };
        let stands = vec![Stand { pose: start, turned: math::sin_cos(start.heading) }];
        let (places, moved, hits) = (Vec::new(), Vec::new(), Vec::new());
        let mut path = Self { rules, arcs, stands, places, moved, round: 0, attempts: 0, hits, random: 1 };
        path.measure();
        path
    }

    /// Poses and costs of places, anew.
    fn measure(&mut self) {
        self.stands.resize(self.arcs.len() + 1, self.stands[0]);
        follow(&mut self.stands, &self.arcs);
        self.places = self.places_of(&self.arcs, &self.stands);
        self.moved = vec![self.round; self.arcs.len()];
        self.hits.clear();
    }

    /// Tries all groups of four arcs near each other; tells whether one got better.
    fn along_edges(&mut self, step: f64) -> bool {
        let mut is_better = false;
        let mut last = 3;
        while last < self.arcs.len() {
            for [first, second, third] in triples((last + 1).saturating_sub(STRETCH), last) {
                let mut repeats = 0;
                while repeats < REPEATS && last < self.arcs.len() && self.is_unsettled(first, last) {
                    let four = [first, second, third, last];
                    let [a, b, c, d] = four.map(|n| self.column(self.stands[last + 1], n));
                    let minors = [volume(b, c, d), volume(a, c, d), volume(a, b, d), volume(a, b, c)];
                    let out = math::argmin(&minors.map(|minor| -minor.abs()));
                    let mut change = [0.0; STRETCH];
                    let change = &mut change[..=last - first];
                    change[four[out] - first] = 1.0;
                    let three = core::array::from_fn(|n| four[n + usize::from(n >= out)] - first);
                    if !self.attempt(first, change, three, step) {
                        break;
                    }
                    (is_better, repeats) = (true, repeats + 1);
                }
            }
            last += 1;
        }
        is_better
    }

    /// Tries some random directions for each stretch; tells whether one got better.
    fn along_random(&mut self, step: f64) -> bool {
        let mut is_better = false;
        let mut first = 0;
        // Four arcs have no directions but the edge.
        while first + 5 <= self.arcs.len() {
            let mut three = None;
            for _ in 0..RANDOM_DIRECTIONS {
                let count = STRETCH.min(self.arcs.len().saturating_sub(first));
                if count < 5 {
                    break;
                }
                let mut change = [(); STRETCH].map(|()| self.random());
                let closing = *three.get_or_insert_with(|| self.widest_three(first, count));
                if self.attempts < MAX_ATTEMPTS && self.attempt(first, &mut change[..count], closing, step) {
                    (is_better, three) = (true, None);
                }
            }
            first += STRETCH / 2;
        }
        is_better
    }

    /// The three of some arcs whose columns span most: they close the path best.
    fn widest_three(&self, first: usize, count: usize) -> [usize; 3] {
        let end = self.stands[first + count];
        let columns: Vec<Column> = (first..first + count).map(|n| self.column(end, n)).collect();
        let span = |[i, j, k]: [usize; 3]| volume(columns[i], columns[j], columns[k]).abs();
        triples(0, count).fold([0, 1, 2], |best, three| if span(three) > span(best) { three } else { best })
    }

    /// True if one of some arcs was moved in this round or the one before, and attempts are left.
    fn is_unsettled(&self, first: usize, last: usize) -> bool {
        self.attempts < MAX_ATTEMPTS && self.moved[first..=last].iter().any(|&round| round + 1 >= self.round)
    }

    /// A number from -1 to 1.
    fn random(&mut self) -> f64 {
        self.random = self.random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(self.random >> 8) / f64::from(1 << 23) - 1.0
    }

    /// Changes the lengths of the arcs from `first` on by a step in a direction, if that is free and costs less. Three
    /// of them close the path.
    fn attempt(&mut self, first: usize, change: &mut [f64], three: [usize; 3], step: f64) -> bool {
        self.attempts += 1;
        let (count, end) = (change.len(), self.stands[first + change.len()]);
        let mut miss = [0.0; 3];
        for n in (0..count).filter(|n| !three.contains(n)) {
            let column = self.column(end, first + n);
            miss = core::array::from_fn(|x| miss[x] - column[x] * change[n]);
        }
        let Some(parts) = solve(three.map(|n| self.column(end, first + n)), miss) else { return false };
        for (n, part) in three.into_iter().zip(parts) {
            change[n] = part;
        }
        let most = change.iter().fold(0.0, |most: f64, change| most.max(change.abs()));
        let slope = change.iter().zip(&self.arcs[first..]).fold(0.0, |sum, (change, &arc)| {
            let metre = Arc { length: 1.0_f64.copysign(arc.length), ..arc };
            sum + change * metre.length * self.rules.costs.arc(Motion::after(&arc), &metre)
        });
        let far = -slope.signum() * step / most;
        if self.rules.costs.shuns_obstacles() {
            return self.advance(first, change, three, far) || self.advance(first, change, three, -far);
        }
        slope.abs() >= MIN_SLOPE * most && self.advance(first, change, three, far)
    }

    /// Changes the lengths of the arcs from `first` on `far` in a direction, or until one vanishes, if that is free and
    /// costs less.
    fn advance(&mut self, first: usize, change: &[f64], mut three: [usize; 3], mut far: f64) -> bool {
        let count = change.len();
        let mut vanishes = None;
        for (n, change) in change.iter().enumerate() {
            let length = self.arcs[first + n].length;
            if length * change * far < 0.0 && length.abs() < (far * change).abs() {
                (far, vanishes) = (-length / change, Some(n));
            }
        }
        let mut next = [Arc { curvature: 0.0, length: 0.0 }; STRETCH];
        let next = &mut next[..count];
        for (n, next) in next.iter_mut().enumerate() {
            let arc = self.arcs[first + n];
            *next = Arc { length: arc.length + far * change[n], ..arc };
        }
        if let Some(gone) = vanishes {
            next[gone].length = 0.0;
            // What vanishes closes nothing.
            let others = (0..count).filter(|n| !three.contains(n));
            let other = others.max_by(|&i, &j| change[i].abs().total_cmp(&change[j].abs())).unwrap_or(gone);
            three = three.map(|n| if n == gone { other } else { n });
        }
        let mut stands = [self.stands[first]; STRETCH + 1];
        let stands = &mut stands[..=count];
        if !self.close(first, next, stands, three) {
            return false;
        }
        let keeps_gears = three.iter().all(|&n| next[n].length * self.arcs[first + n].length > 0.0);
        keeps_gears && self.take(first, next, stands, vanishes.is_some())
    }

    /// Changes the lengths of three arcs so that some in place of those from `first` on lead to the same end, and
    /// renews where they begin and end. Tells whether they do, and do not hit something where others did.
    fn close(&mut self, first: usize, arcs: &mut [Arc], stands: &mut [Stand], three: [usize; 3]) -> bool {
        let to = self.stands[first + arcs.len()].pose;
        let mut is_checked = false;
        for _ in 0..MAX_NEWTON_STEPS {
            follow(stands, arcs);
            let last = stands[arcs.len()];
            let from = last.pose;
            let miss = [to.x - from.x, to.y - from.y, math::turn(from.heading, to.heading)];
            let is_within = |limit: f64| miss.iter().all(|miss| miss.abs() < limit);
            if !is_checked && is_within(ROUGHLY_CLOSED) {
                is_checked = true;
                if self.is_hit(first, arcs, stands) {
                    return false;
                }
            }
            if is_within(CLOSED) {
                return true;
            }
            let columns = three.map(|n| column(last, stands[n + 1], &arcs[n]));
            let Some(parts) = solve(columns, miss) else { return false };
            for (n, part) in three.into_iter().zip(parts) {
                arcs[n].length += part;
            }
        }
        false
    }

    /// Puts some arcs in place of those from `first` on, if they are free and cost less.
    fn take(&mut self, first: usize, next: &[Arc], stands: &[Stand], is_shorter: bool) -> bool {
        let end = first + next.len();
        let saved = self.driving(first, &self.arcs[first..end]) - self.driving(first, next);
        let shuns_obstacles = self.rules.costs.shuns_obstacles();
        if (saved <= MIN_GAIN && !shuns_obstacles) || !self.is_free(first, next, stands) {
            return false;
        }
        let places = self.places_of(next, stands);
        let sum = |places: &[f64]| places.iter().fold(0.0, |sum, one| sum + one);
        if saved + sum(&self.places[first..end]) - sum(&places) <= MIN_GAIN {
            return false;
        }
        self.arcs[first..end].copy_from_slice(next);
        if is_shorter {
            self.arcs = arcs::merge(core::mem::take(&mut self.arcs));
            self.measure();
        } else {
            self.stands[first..=end].copy_from_slice(stands);
            self.places[first..end].copy_from_slice(&places);
            self.moved[first..end].fill(self.round);
        }
        true
    }

    /// How `end` moves as an arc grows.
    #[inline]
    fn column(&self, end: Stand, arc: usize) -> Column {
        column(end, self.stands[arc + 1], &self.arcs[arc])
    }

    /// Costs of the places that some arcs lead through.
    fn places_of(&self, arcs: &[Arc], stands: &[Stand]) -> Vec<f64> {
        let Rules { checker, costs, .. } = self.rules;
        arcs.iter().zip(stands).map(|(arc, stand)| costs.places(checker, stand.pose, arc)).collect()
    }

    /// Cost of driving some arcs in place of those from `first` on, and of driving into what follows; places aside.
    fn driving(&self, first: usize, arcs: &[Arc]) -> f64 {
        let mut before = first.checked_sub(1).map_or_else(Motion::default, |n| Motion::after(&self.arcs[n]));
        let next = self.arcs.get(first + arcs.len());
        arcs.iter().filter(|arc| arc.length != 0.0).chain(next).fold(0.0, |cost, arc| {
            let cost = cost + self.rules.costs.arc(before, arc);
            before = Motion::after(arc);
            cost
        })
    }

    /// True if some arcs in place of those from `first` on hit something where others did.
    fn is_hit(&mut self, first: usize, arcs: &[Arc], stands: &[Stand]) -> bool {
        let Rules { checker, margin, .. } = self.rules;
        let hit = self.hits.iter().position(|&(n, along)| {
            let Some(arc) = n.checked_sub(first).and_then(|n| arcs.get(n)) else { return false };
            along.abs() <= arc.length.abs() && {
                let Stand { pose, turned } = stands[n - first].after(arc, along);
                !checker.fits(pose.point(), turned, margin)
            }
        });
        if let Some(at) = hit {
            self.hits[..=at].rotate_right(1);
        }
        hit.is_some()
    }

    /// True if some arcs in place of those from `first` on are free.
    fn is_free(&mut self, first: usize, arcs: &[Arc], stands: &[Stand]) -> bool {
        let Rules { checker, spacing, margin, .. } = self.rules;
        let hit_on = |n: usize| {
            let is_there = arcs[n].length != 0.0;
            let along =
                is_there.then(|| checker.hit_along(stands[n].pose, &arcs[n], spacing, margin)).flatten();
            along.map(|along| (first + n, along))
        };
        let Some(hit) = (0..arcs.len()).rev().find_map(hit_on) else { return true };
        self.hits.truncate(MAX_HITS - 1);
        self.hits.insert(0, hit);
        false
    }
}

/// Renews where arcs begin and end, from the first on.
fn follow(stands: &mut [Stand], arcs: &[Arc]) {
    for (n, arc) in arcs.iter().enumerate() {
        stands[n + 1] = stands[n].after(arc, arc.length);
    }
}

/// How `end` moves as an arc grows that ends at `at`.
#[inline]
fn column(Stand { pose: end, .. }: Stand, at: Stand, arc: &Arc) -> Column {
    let Stand { pose: at, turned: (sin, cos) } = at;
    [cos - arc.curvature * (end.y - at.y), sin + arc.curvature * (end.x - at.x), arc.curvature]
}

/// Determinant of three columns.
fn volume(a: Column, b: Column, c: Column) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + b[0] * (c[1] * a[2] - c[2] * a[1])
        + c[0] * (a[1] * b[2] - a[2] * b[1])
}

/// How much of each of three columns makes up `sum`; nothing where they depend on each other.
#[inline]
fn solve([a, b, c]: [Column; 3], sum: Column) -> Option<[f64; 3]> {
    let whole = volume(a, b, c);
    let parts = [volume(sum, b, c), volume(a, sum, c), volume(a, b, sum)];
    (whole.abs() >= DEPENDENT).then(|| parts.map(|part| part / whole))
}

/// All ascending triples of numbers from `begin` on below `end`.
fn triples(begin: usize, end: usize) -> impl Iterator<Item = [usize; 3]> {
    let pairs = (begin..end).flat_map(move |i| (i + 1..end).map(move |j| [i, j]));
    pairs.flat_map(move |[i, j]| (j + 1..end).map(move |k| [i, j, k]))
}

#[cfg(test)]
mod tests;
