//! The arcs of a search tree, kept for drawing.

use core::cell::RefCell;

use super::analytic_expansion::Recorder;
use super::question::Search;
use super::report::Report;
use super::state::State;
use crate::IS_COMPLETE;
use crate::geometry::Pose;
use crate::search::{ExpansionCallback, Expansions};
use crate::search::{NodeId, Observer, Progress};

/// Arcs of the search tree that are kept for drawing.
const MAX_TREE_ARCS: usize = 20_000;
/// Numbers of an arc: x, y, heading, curvature, signed length.
const ARC: usize = 5;
/// Arcs that a callback is given at a time: often enough for a drawing, and few calls.
const TOLD_ARCS: usize = 64;

/// Keeps the arcs that led to expanded states.
pub(super) struct Tree<'a> {
    arcs: Vec<f64>,
    dropped: u64,
    origin: Pose,
    mirrored: bool,
    /// Those of the numbers that `tell` knows.
    told: usize,
    tell: Option<ExpansionCallback<'a>>,
}

impl<'a> Tree<'a> {
    /// For a search whose tree is to be kept; its expansions are told to `progress`.
    pub(super) fn new(search: &Search, progress: Option<&Progress<'a>>) -> Self {
        Self {
            arcs: Vec::new(),
            dropped: 0,
            origin: search.origin(),
            mirrored: search.mirrored,
            told: 0,
            tell: progress.and_then(|progress| progress.expansions),
        }
    }
}

impl Tree<'_> {
    /// Tells what is not told yet.
    fn flush(&mut self) {
        if IS_COMPLETE && let Some(tell) = self.tell.filter(|_| self.told < self.arcs.len()) {
            tell(Expansions { is_first: self.told == 0, nodes: &[], numbers: &self.arcs[self.told..] });
            self.told = self.arcs.len();
        }
    }
}

impl Observer<f64, State> for Tree<'_> {
    fn side(&mut self, side: usize) {
        self.mirrored = side == 1;
    }

    fn expanded(&mut self, _: NodeId, at: State, _: f64) {
        if at.length == 0.0 {
            return;
        }
        if self.arcs.len() >= MAX_TREE_ARCS * ARC {
            self.dropped += 1;
            return;
        }
        let (curvature, length) = (at.motion.curvature, at.length);
        let (from, length) =
            if self.mirrored { (at.pose, -length) } else { (at.pose.advance(curvature, -length), length) };
        let (x, y) = (from.x + self.origin.x, from.y + self.origin.y);
        self.arcs.extend([x, y, from.heading, curvature, length]);
        if IS_COMPLETE && self.arcs.len() - self.told == TOLD_ARCS * ARC {
            self.flush();
        }
    }
}

impl Report {
    /// Keeps what was written down for drawing.
    pub(super) fn keep(&mut self, tree: Option<Tree>, recorder: Option<&RefCell<Recorder>>) {
        if let (Some(mut tree), Some(recorder)) = (tree, recorder) {
            tree.flush();
            (self.tree, self.tree_dropped) = (tree.arcs, tree.dropped);
            self.failed_expansions = core::mem::take(&mut recorder.borrow_mut().failed);
        }
    }
}
