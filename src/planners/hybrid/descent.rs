//! Changing the lengths of a path's arcs until it costs no less any more.
//!
//! The shortcut keeps the poses through which a lattice led, and replaces what lies between. What is left are paths of
//! few arcs whose gear changes stand where the lattice put them. This moves them: curvatures and gears stay, lengths
//! change, and an arc may vanish.
//!
//! A direction says by how much each arc of a stretch grows (`path`). The directions are the edges of what is allowed,
//! as in the simplex method: all groups of four within eight neighbours, of which one grows and three follow. Where no
//! edge leads on, some random ones are tried, which slide along obstacles that stop every edge. Steps become ever
//! shorter.
//!
//! The slope of the cost does not tell that a gear change may be saved. So a second search makes one move of the path
//! shorter at any price (`super::squeeze`).

mod path;

use super::shortcut::Rules;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::{Pose, math};
use path::{STRETCH, volume};

pub(super) use path::{Column, Path, Stand, column, move_of};

/// The arc that changes most changes by so much at a time, metres.
const STEPS: [f64; 4] = [0.4, 0.2, 0.1, 0.05];
/// Rounds over all directions with each step, at most.
const MAX_ROUNDS: u32 = 4;
/// A direction that succeeds is tried so often in a row.
const REPEATS: u32 = 3;
/// Random directions for each stretch of arcs, all of which they change; the next one begins half a stretch on.
const RANDOM_DIRECTIONS: u32 = 40;
/// Attempts for one path, at most: a path of a thousand arcs would take seconds.
const MAX_ATTEMPTS: u32 = 100_000;

/// A path from `start` to the same end that costs no more and has no more gear changes, free by the rules if `arcs` is.
pub(super) fn descend(rules: Rules, start: Pose, arcs: Vec<Arc>) -> Vec<Arc> {
    let mut path = Path::new(rules, start, arcs::merge(arcs), None);
    path.improve(&STEPS, |_| false);
    path.arcs
}

impl Path<'_> {
    /// Changes lengths by ever shorter steps until none makes the path better, or it is good enough; tells whether that
    /// is so.
    pub(super) fn improve(&mut self, steps: &[f64], is_enough: impl Fn(&[Arc]) -> bool) -> bool {
        for &step in steps {
            self.round += 1;
            self.moved.fill(self.round);
            for _ in 0..MAX_ROUNDS {
                let is_better = self.along_edges(step) || self.along_random(step);
                if is_enough(&self.arcs) {
                    return true;
                }
                if !is_better {
                    break;
                }
                self.round += 1;
            }
        }
        false
    }

    /// Tries all groups of four arcs near each other; tells whether one got better.
    fn along_edges(&mut self, step: f64) -> bool {
        let mut is_better = false;
        let mut last = self.aim.start.max(3);
        while last < self.arcs.len().min(self.aim.end + STRETCH - 1) {
            for [first, second, third] in triples((last + 1).saturating_sub(STRETCH), last) {
                if ![first, second, third, last].iter().any(|arc| self.aim.contains(arc)) {
                    continue;
                }
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
                if first >= self.aim.end || first + STRETCH <= self.aim.start {
                    break;
                }
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
}

/// All ascending triples of numbers from `begin` on below `end`.
fn triples(begin: usize, end: usize) -> impl Iterator<Item = [usize; 3]> {
    let pairs = (begin..end).flat_map(move |i| (i + 1..end).map(move |j| [i, j]));
    pairs.flat_map(move |[i, j]| (j + 1..end).map(move |k| [i, j, k]))
}

#[cfg(test)]
pub(super) mod tests;
