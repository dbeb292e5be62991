//! A path whose arcs may change their lengths, while its end stays where it is.
//!
//! Three arcs of a stretch follow from the others: with the columns cₙ by which the end moves as arc n grows,
//! Σ cₙ·Δₙ = 0. The lengths change by a step in such a direction, or until an arc vanishes, and Newton's method closes
//! what the straight line misses. What is free and better is kept.
//!
//! Most attempts hit something, and most of them at the same few places. So the places where attempts failed are
//! checked first, the latest in front: most attempts end after one check.

use core::ops::Range;

use crate::geometry::arcs::{self, Arc};
use crate::geometry::{Pose, math};
use crate::planners::hybrid::cost::Motion;
use crate::planners::hybrid::shortcut::{MIN_GAIN, Rules};

/// Arcs that change together, at most.
pub(super) const STRETCH: usize = 8;
/// A direction by which less is saved for each metre of the largest change is left.
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

/// How the end of a path moves for each metre that one of its arcs grows: x, y, heading.
pub(in crate::planners::hybrid) type Column = [f64; 3];

/// A pose, with sine and cosine of its heading.
#[derive(Clone, Copy)]
pub(in crate::planners::hybrid) struct Stand {
    pub(in crate::planners::hybrid) pose: Pose,
    pub(in crate::planners::hybrid) turned: (f64, f64),
}

impl Stand {
    #[inline]
    pub(in crate::planners::hybrid) fn at(pose: Pose) -> Self {
        Self { pose, turned: math::sin_cos(pose.heading) }
    }

    #[inline]
    fn after(self, arc: &Arc, length: f64) -> Self {
        let (pose, turned) = self.pose.advance_turning(self.turned, arc.curvature, length);
        Self { pose, turned }
    }
}

/// The path at hand. Invariant: its end never moves.
pub(in crate::planners::hybrid) struct Path<'a> {
    rules: Rules<'a>,
    pub(in crate::planners::hybrid) arcs: Vec<Arc>,
    /// Before each arc, and at the end.
    pub(super) stands: Vec<Stand>,
    /// Costs of the places that each arc leads through.
    places: Vec<f64>,
    /// The round in which each arc was last moved.
    pub(super) moved: Vec<u32>,
    pub(super) round: u32,
    pub(super) attempts: u32,
    /// Where attempts failed: on which arc, and how far from its beginning, metres.
    hits: Vec<(usize, f64)>,
    /// State of the random numbers.
    pub(super) random: u32,
    /// The move that is to become shorter, by its number; none where the cost is to fall.
    squeezed: Option<usize>,
    /// The arcs of which some are to change: those of that move, or all.
    pub(super) aim: Range<usize>,
}

impl<'a> Path<'a> {
    /// One that is to become cheaper or, with the number of one of its moves, to have that one shorter.
    pub(in crate::planners::hybrid) fn new(
        rules: Rules<'a>,
        start: Pose,
        arcs: Vec<Arc>,
        squeezed: Option<usize>,
    ) -> Self {
        let mut path = Self {
            rules: Rules { spacing: rules.spacing / FINER, ..rules },
            arcs,
            stands: vec![Stand::at(start)],
            places: Vec::new(),
            moved: Vec::new(),
            round: 0,
            attempts: 0,
            hits: Vec::new(),
            random: 1,
            squeezed,
            aim: 0..0,
        };
        path.measure();
        path
    }

    /// Poses, costs of places and what is to change, anew.
    fn measure(&mut self) {
        self.stands.resize(self.arcs.len() + 1, self.stands[0]);
        follow(&mut self.stands, &self.arcs);
        self.places = self.places_of(&self.arcs, &self.stands);
        self.moved = vec![self.round; self.arcs.len()];
        self.hits.clear();
        self.aim = self.squeezed.map_or(0..self.arcs.len(), |number| move_of(&self.arcs, number));
    }

    /// Changes the lengths of the arcs from `first` on by a step in a direction, if that is free and better. Three of
    /// them close the path.
    pub(super) fn attempt(&mut self, first: usize, change: &mut [f64], three: [usize; 3], step: f64) -> bool {
        self.attempts += 1;
        let (count, end) = (change.len(), self.stands[first + change.len()]);
        let mut miss = [0.0; 3];
        for n in (0..count).filter(|n| change[*n] != 0.0 && !three.contains(n)) {
            let column = self.column(end, first + n);
            miss = core::array::from_fn(|x| miss[x] - column[x] * change[n]);
        }
        let Some(parts) = solve(three.map(|n| self.column(end, first + n)), miss) else { return false };
        for (n, part) in three.into_iter().zip(parts) {
            change[n] = part;
        }
        let most = change.iter().fold(0.0, |most: f64, change| most.max(change.abs()));
        let changing = change.iter().zip(first..).filter(|(change, _)| **change != 0.0);
        let slope = changing.fold(0.0, |slope, (change, n)| slope + change * self.price(n));
        let far = -slope.signum() * step / most;
        if self.shuns_obstacles() {
            return self.advance(first, change, three, far) || self.advance(first, change, three, -far);
        }
        slope.abs() >= MIN_SLOPE * most && self.advance(first, change, three, far)
    }

    /// What is saved for each metre by which an arc's signed length falls.
    fn price(&self, n: usize) -> f64 {
        let arc = self.arcs[n];
        let metre = Arc { length: 1.0_f64.copysign(arc.length), ..arc };
        let price = match self.squeezed {
            Some(_) => f64::from(u8::from(self.aim.contains(&n))),
            None => self.rules.costs.arc(Motion::after(&arc), &metre),
        };
        metre.length * price
    }

    /// True if a way with the same slope may be worth more or less for the obstacles beside it.
    fn shuns_obstacles(&self) -> bool {
        self.squeezed.is_none() && self.rules.costs.shuns_obstacles()
    }

    /// Changes the lengths of the arcs from `first` on `far` in a direction, or until one vanishes, if that is free and
    /// better.
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
            let columns = three.map(|n| column(last.pose, stands[n + 1], arcs[n].curvature));
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
        let saved = self.spent(first, &self.arcs[first..end]) - self.spent(first, next);
        if (saved <= MIN_GAIN && !self.shuns_obstacles()) || !self.is_free(first, next, stands) {
            return false;
        }
        let places = self.places_of(next, stands);
        let sum = |places: &[f64]| places.iter().fold(0.0, |sum, one| sum + one);
        let is_cheaper = saved + sum(&self.places[first..end]) - sum(&places) > MIN_GAIN;
        if self.squeezed.is_none() && !is_cheaper {
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
    pub(super) fn column(&self, end: Stand, arc: usize) -> Column {
        column(end.pose, self.stands[arc + 1], self.arcs[arc].curvature)
    }

    /// Costs of the places that some arcs lead through.
    fn places_of(&self, arcs: &[Arc], stands: &[Stand]) -> Vec<f64> {
        let Rules { checker, costs, .. } = self.rules;
        arcs.iter().zip(stands).map(|(arc, stand)| costs.places(checker, stand.pose, arc)).collect()
    }

    /// What is to become less of some arcs in place of those from `first` on, places aside.
    fn spent(&self, first: usize, arcs: &[Arc]) -> f64 {
        if self.squeezed.is_none() {
            return self.driving(first, arcs);
        }
        let aimed = arcs.iter().zip(first..).filter(|(_, n)| self.aim.contains(n));
        aimed.fold(0.0, |sum, (arc, _)| sum + arc.length.abs())
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

/// The arcs of a move, by its number: of those between two gear changes.
pub(in crate::planners::hybrid) fn move_of(arcs: &[Arc], number: usize) -> Range<usize> {
    let mut ends = arcs.chunk_by(|one, next| one.length * next.length > 0.0).scan(0, |end, arcs| {
        *end += arcs.len();
        Some(*end - arcs.len()..*end)
    });
    ends.nth(number).unwrap_or(0..0)
}

/// Renews where arcs begin and end, from the first on.
fn follow(stands: &mut [Stand], arcs: &[Arc]) {
    for (n, arc) in arcs.iter().enumerate() {
        stands[n + 1] = stands[n].after(arc, arc.length);
    }
}

/// How `later` moves as an arc before it grows that ends at `at`.
#[inline]
pub(in crate::planners::hybrid) fn column(later: Pose, at: Stand, curvature: f64) -> Column {
    let Stand { pose: at, turned: (sin, cos) } = at;
    [cos - curvature * (later.y - at.y), sin + curvature * (later.x - at.x), curvature]
}

/// Determinant of three columns.
pub(super) fn volume(a: Column, b: Column, c: Column) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + b[0] * (c[1] * a[2] - c[2] * a[1])
        + c[0] * (a[1] * b[2] - a[2] * b[1])
}

/// How much of each of three columns makes up `sum`; nothing where they depend on each other.
#[inline]
pub(super) fn solve([a, b, c]: [Column; 3], sum: Column) -> Option<[f64; 3]> {
    let whole = volume(a, b, c);
    let parts = [volume(sum, b, c), volume(a, sum, c), volume(a, b, sum)];
    (whole.abs() >= DEPENDENT).then(|| parts.map(|part| part / whole))
}
