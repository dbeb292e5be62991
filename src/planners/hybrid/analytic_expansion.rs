//! Connections to the target: the cheapest is tried first, and those that hit something are kept for drawing.
//!
//! A search asks many curves at each pose whether they are free, and throws the answers away. For people the cheapest
//! that failed tells most: where the way would be if that obstacle were not there.
//!
//! An expansion's connections are Reeds–Shepp words from its pose to the target. The search takes the cheapest free
//! one, or none; the recorder keeps the cheapest of those that failed, cut off at the first contact. It asks a
//! collision checker of its own, because the plan's counter of checks must be the same with and without a trace.
//!
//! Columns instead of a list of structures, because the whole goes to JavaScript as typed arrays: connection k has
//! the arcs from `first[k]` to `first[k + 1]`, five numbers each.

use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::geometry::reeds_shepp::Word;
use crate::vehicle::collision::CollisionChecker;

/// Connections that are kept.
const MAX_RECORDED: usize = 4000;

/// The cheapest of some connections, the first of equal ones. It is taken: its cost is infinite from then on.
pub(super) fn take_cheapest(words: &mut [(f64, Word)]) -> Option<(f64, Word)> {
    let cheaper = |best: (usize, f64), (i, word): (usize, &(f64, Word))| {
        if word.0 < best.1 { (i, word.0) } else { best }
    };
    let (index, cost) = words.iter().enumerate().fold((0, f64::INFINITY), cheaper);
    let word = words.get_mut(index).filter(|_| cost < f64::INFINITY)?;
    Some(core::mem::replace(word, (f64::INFINITY, word.1)))
}

/// Failed connections, at most one an expansion: the cheapest that was tried.
/// World coordinates, metres and radians, in the direction in which the car would drive.
#[derive(Debug, Clone, Default)]
pub struct FailedExpansions {
    /// Index of each expansion's first arc in `arcs`.
    pub first: Vec<u32>,
    /// Their arcs up to where they hit, as driven: x, y, heading, curvature, signed length, ….
    pub arcs: Vec<f64>,
    /// The body where it hits: x, y, heading per connection.
    pub hits: Vec<f64>,
    /// Whose obstacle is hit.
    pub owners: Vec<u32>,
    /// The expansion that tried it, counted from 0.
    pub expansions: Vec<u32>,
    /// Connections beyond the cap.
    pub dropped: u64,
}

/// Watches the connections of one search.
pub(super) struct Recorder {
    pub(super) failed: FailedExpansions,
    /// World position of the local origin.
    origin: Pose,
    expansions: u32,
}

impl Recorder {
    pub(super) fn new(origin: Pose) -> Self {
        Self { failed: FailedExpansions::default(), origin, expansions: 0 }
    }

    /// A search has expanded a pose without a try.
    pub(super) fn skip(&mut self) {
        self.expansions += 1;
    }

    /// A search has expanded `pose`; `missed` is the cheapest connection that it tried in vain. `mirrored` where the
    /// tree grows from the goal. The checker counts, so it must not be the search's own.
    pub(super) fn note(
        &mut self,
        checker: &CollisionChecker,
        pose: Pose,
        missed: Option<&Word>,
        (radius, spacing, margin): (f64, f64, f64),
        mirrored: bool,
    ) {
        let expansion = self.expansions;
        self.expansions += 1;
        let Some(word) = missed else { return };
        if self.failed.owners.len() >= MAX_RECORDED {
            self.failed.dropped += 1;
            return;
        }
        let begin = self.failed.arcs.len();
        let mut from = pose;
        for arc in word.arcs(radius) {
            let far = checker.free_length(from, &arc, spacing, margin);
            let length = far.copysign(arc.length);
            let end = from.advance(arc.curvature, length);
            if far > 0.0 {
                self.keep(if mirrored { end } else { from }, &Arc { length, ..arc }, mirrored);
            }
            if far < arc.length.abs() {
                let beyond = (far + spacing / 16.0).min(arc.length.abs()).copysign(arc.length);
                let beyond = from.advance(arc.curvature, beyond);
                let Some(owner) = checker.hit(beyond, margin) else { break };
                self.failed.first.push((begin / 5) as u32);
                self.failed.owners.push(owner);
                self.failed.expansions.push(expansion);
                self.failed.hits.extend([beyond.x + self.origin.x, beyond.y + self.origin.y, beyond.heading]);
                return;
            }
            from = end;
        }
        // What the search saw between two checks is not there at these.
        self.failed.arcs.truncate(begin);
    }

    /// Adds an arc as the car drives it; in a tree that grows from the goal that is the other direction.
    fn keep(&mut self, from: Pose, arc: &Arc, mirrored: bool) {
        let length = if mirrored { -arc.length } else { arc.length };
        let (x, y) = (from.x + self.origin.x, from.y + self.origin.y);
        self.failed.arcs.extend([x, y, from.heading, arc.curvature, length]);
    }
}
