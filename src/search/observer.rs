//! Watching a search: `()` watches nothing at no cost.
//!
//! The search calls its observer at each expansion and each improvement. The observer is a type parameter, so the
//! calls to `()` vanish when they are compiled, and a search without a watcher is as fast as one without the calls.

use std::num::NonZeroU32;
use std::ops::ControlFlow;

use super::NodeId;
use crate::IS_COMPLETE;

/// Told of every event of a search.
pub trait Observer<C, L> {
    /// Names the tree of the events that follow. Only a bidirectional search over a [`Domain`](super::Domain) calls it.
    fn side(&mut self, side: usize) {
        let _ = side;
    }
    /// A node was taken from the open list and expanded.
    fn expanded(&mut self, node: NodeId, label: L, g: C) {
        let _ = (node, label, g);
    }
    /// A better way to `node` was found from `parent`.
    fn relaxed(&mut self, node: NodeId, parent: NodeId, label: L, g: C) {
        let _ = (node, parent, label, g);
    }
    /// Returns the expansion count at which to call again, or sooner; a value ≤ `expanded` stops the search as if its
    /// budget were spent.
    fn due(&mut self, expanded: u32) -> u32 {
        let _ = expanded;
        u32::MAX
    }
}

impl<C, L> Observer<C, L> for () {}

/// Watches, or not, by a decision made at run time; one branch an event.
impl<C, L, O: Observer<C, L>> Observer<C, L> for Option<O> {
    fn side(&mut self, side: usize) {
        if let Some(observer) = self {
            observer.side(side);
        }
    }

    fn expanded(&mut self, node: NodeId, label: L, g: C) {
        if let Some(observer) = self {
            observer.expanded(node, label, g);
        }
    }

    fn relaxed(&mut self, node: NodeId, parent: NodeId, label: L, g: C) {
        if let Some(observer) = self {
            observer.relaxed(node, parent, label, g);
        }
    }

    fn due(&mut self, expanded: u32) -> u32 {
        self.as_mut().map_or(u32::MAX, |observer| observer.due(expanded))
    }
}

impl<C, L, O: Observer<C, L>> Observer<C, L> for &mut O {
    fn side(&mut self, side: usize) {
        (**self).side(side);
    }

    fn expanded(&mut self, node: NodeId, label: L, g: C) {
        (**self).expanded(node, label, g);
    }

    fn relaxed(&mut self, node: NodeId, parent: NodeId, label: L, g: C) {
        (**self).relaxed(node, parent, label, g);
    }

    fn due(&mut self, expanded: u32) -> u32 {
        (**self).due(expanded)
    }
}

/// Both watch.
impl<C: Copy, L: Copy, A: Observer<C, L>, B: Observer<C, L>> Observer<C, L> for (A, B) {
    fn side(&mut self, side: usize) {
        self.0.side(side);
        self.1.side(side);
    }

    fn expanded(&mut self, node: NodeId, label: L, g: C) {
        self.0.expanded(node, label, g);
        self.1.expanded(node, label, g);
    }

    fn relaxed(&mut self, node: NodeId, parent: NodeId, label: L, g: C) {
        self.0.relaxed(node, parent, label, g);
        self.1.relaxed(node, parent, label, g);
    }

    // Apart from the searches' loops.
    #[cold]
    #[inline(never)]
    fn due(&mut self, expanded: u32) -> u32 {
        self.0.due(expanded).min(self.1.due(expanded))
    }
}

/// How plans are watched; of one type, so that each search is compiled once for all of them.
pub type Observers<'a> = (Option<Trace<'a>>, Option<Progress<'a>>);

/// Some of a search's expansions, in their order: nodes of a grid, or what a lattice makes of its states.
#[derive(Debug, Clone, Copy)]
pub struct Expansions<'a> {
    /// True if these are the first of their search.
    pub is_first: bool,
    /// Expanded nodes of a grid.
    pub nodes: &'a [NodeId],
    /// Numbers of expanded states, where a search has no grid.
    pub numbers: &'a [f64],
}

/// Receives expansions while a search runs.
pub type ExpansionCallback<'a> = &'a dyn Fn(Expansions<'_>);

/// Nodes that a callback is given at a time: often enough for a drawing, and few calls.
const NODES: usize = 1024;

/// Expanded nodes in order, up to a cap.
#[derive(Clone)]
pub struct Trace<'a> {
    /// The nodes, in order of expansion.
    pub expanded: Vec<NodeId>,
    /// Expansions beyond the cap, counted only.
    pub dropped: u64,
    cap: usize,
    /// Those of the nodes that `tell` knows.
    told: usize,
    tell: Option<ExpansionCallback<'a>>,
}

impl Trace<'_> {
    /// A trace that keeps the first `cap` expansions.
    pub fn new(cap: usize) -> Self {
        Self { expanded: Vec::new(), dropped: 0, cap, told: 0, tell: None }
    }
}

impl<'a> Trace<'a> {
    /// The same, told as it grows.
    #[must_use]
    pub fn telling(self, tell: Option<ExpansionCallback<'a>>) -> Self {
        Self { tell, ..self }
    }

    /// Tells what is not told yet.
    pub fn flush(&mut self) {
        if IS_COMPLETE && let Some(tell) = self.tell.filter(|_| self.told < self.expanded.len()) {
            tell(Expansions { is_first: self.told == 0, nodes: &self.expanded[self.told..], numbers: &[] });
            self.told = self.expanded.len();
        }
    }

    /// An empty trace of the same kind, for the search that comes next.
    #[must_use]
    pub fn restart(&mut self) -> Self {
        self.flush();
        Self { tell: self.tell, ..Self::new(self.cap) }
    }

    /// This one and what came after it, as one trace.
    #[must_use]
    pub fn followed_by(mut self, mut after: Self) -> Self {
        after.flush();
        let kept = after.expanded.len().min(self.cap.saturating_sub(self.expanded.len()));
        self.dropped += after.dropped + (after.expanded.len() - kept) as u64;
        self.expanded.extend_from_slice(&after.expanded[..kept]);
        self.told = self.expanded.len();
        self
    }
}

impl<C, L> Observer<C, L> for Trace<'_> {
    fn expanded(&mut self, node: NodeId, _: L, _: C) {
        if self.expanded.len() < self.cap {
            self.expanded.push(node);
            if IS_COMPLETE && self.expanded.len() - self.told == NODES {
                self.flush();
            }
        } else {
            self.dropped += 1;
        }
    }
}

/// Receives the number of expanded nodes and returns whether the search goes on.
pub type ProgressCallback<'a> = &'a mut dyn FnMut(u32) -> ControlFlow<()>;

/// Tells how many nodes a plan's searches have expanded: at each multiple of some number, and when they have ended.
///
/// ```
/// use std::num::NonZeroU32;
/// use std::ops::ControlFlow;
///
/// use parkade::search::{Observer, Progress};
///
/// let mut told = Vec::new();
/// let mut tell = |expanded| {
///     told.push(expanded);
///     if expanded < 2000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
/// };
/// let mut progress = Progress::new(NonZeroU32::new(1000).unwrap(), &mut tell);
/// assert_eq!(Observer::<i64, ()>::due(&mut progress, 0), 1000);
/// assert_eq!(Observer::<i64, ()>::due(&mut progress, 1000), 2000);
/// // The callback ends the search: the next count at which it is asked is 0.
/// assert_eq!(Observer::<i64, ()>::due(&mut progress, 2000), 0);
/// assert!(progress.is_stopped());
/// assert_eq!(told, [1000, 2000]);
/// ```
pub struct Progress<'a> {
    every: NonZeroU32,
    /// When it tells next.
    next: u32,
    /// Expansions of earlier plans that are told as one with this.
    base: u32,
    /// Expansions of the plan's searches before this one.
    before: u32,
    stopped: bool,
    tell: ProgressCallback<'a>,
    /// Receives expansions, where the search tells those itself.
    pub expansions: Option<ExpansionCallback<'a>>,
}

impl<'a> Progress<'a> {
    /// Tells after every so many expansions.
    pub fn new(every: NonZeroU32, tell: ProgressCallback<'a>) -> Self {
        Self { every, next: every.get(), base: 0, before: 0, stopped: false, tell, expansions: None }
    }

    /// The same, with a callback that is given the expansions.
    #[must_use]
    pub fn telling(self, expansions: Option<ExpansionCallback<'a>>) -> Self {
        Self { expansions, ..self }
    }

    /// A search follows others that have expanded as many nodes.
    pub fn follow(&mut self, before: u32) {
        self.before = self.base.saturating_add(before);
    }

    /// A plan follows others, told as one with it, whose searches have expanded as many nodes.
    pub fn continue_after(&mut self, expanded: u32) {
        (self.base, self.before) = (expanded, expanded);
    }

    /// Expansions of the earlier plans that are told as one with this.
    pub fn earlier(&self) -> u32 {
        self.base
    }

    /// The searches have ended; what follows checks and measures their path.
    pub fn finish(&mut self, expanded: u32) {
        if !self.stopped {
            self.stopped = (self.tell)(expanded).is_break();
        }
    }

    /// True if the observer ended the search.
    pub fn is_stopped(&self) -> bool {
        self.stopped
    }
}

impl<C, L> Observer<C, L> for Progress<'_> {
    fn due(&mut self, expanded: u32) -> u32 {
        let expanded = self.before.saturating_add(expanded);
        if expanded >= self.next && !self.stopped {
            self.next = self.next.saturating_add(self.every.get());
            self.stopped = (self.tell)(expanded).is_break();
        }
        if self.stopped { 0 } else { self.next - self.before }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All that it is told.
    #[derive(Default)]
    struct Told(Vec<(NodeId, Option<NodeId>)>);

    impl Observer<i64, ()> for Told {
        fn expanded(&mut self, node: NodeId, (): (), _: i64) {
            self.0.push((node, None));
        }
        fn relaxed(&mut self, node: NodeId, parent: NodeId, (): (), _: i64) {
            self.0.push((node, Some(parent)));
        }
    }

    #[test]
    fn an_observer_that_is_there_is_told() {
        let mut watch = Some(Told::default());
        watch.expanded(5, (), 0);
        watch.relaxed(6, 5, (), 1);
        assert_eq!(watch.unwrap().0, [(5, None), (6, Some(5))]);
    }

    #[test]
    fn a_trace_keeps_the_first_and_counts_the_rest() {
        let mut trace = Trace::new(2);
        for node in [5, 3, 8] {
            Observer::<i64, ()>::expanded(&mut trace, node, (), 0);
        }
        assert_eq!((trace.expanded, trace.dropped), (vec![5, 3], 1));
    }

    fn due(observer: &mut impl Observer<i64, ()>, expanded: u32) -> u32 {
        observer.due(expanded)
    }

    const TEN: NonZeroU32 = NonZeroU32::new(10).unwrap();

    #[test]
    fn progress_is_told_every_so_often_over_all_searches() {
        let mut told = Vec::new();
        let mut tell = |expanded| {
            told.push(expanded);
            if expanded < 30 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let mut progress = Progress::new(TEN, &mut tell);
        assert_eq!([0, 9, 10, 17].map(|expanded| due(&mut progress, expanded)), [10, 10, 20, 20]);
        progress.follow(17);
        assert_eq!([0, 3, 9].map(|expanded| due(&mut progress, expanded)), [3, 13, 13]);
        assert!(!progress.is_stopped());
        assert_eq!([13, 13, 23].map(|expanded| due(&mut progress, expanded)), [0; 3]);
        assert!(progress.is_stopped());
        progress.finish(40);
        assert_eq!(told, [10, 20, 30], "and not again");
    }

    #[test]
    fn progress_is_told_of_the_end() {
        let mut told = Vec::new();
        let mut tell = |expanded| {
            told.push(expanded);
            ControlFlow::Continue(())
        };
        let mut progress = Progress::new(TEN, &mut tell);
        assert_eq!([10, 17].map(|expanded| due(&mut progress, expanded)), [20, 20]);
        progress.finish(17);
        assert_eq!(told, [10, 17]);
    }

    #[test]
    fn both_watch_and_the_sooner_is_told() {
        let (mut one, mut tell) = (Told::default(), |_| ControlFlow::Continue(()));
        let mut progress = Some(Progress::new(TEN, &mut tell));
        let mut both = ((&mut one, Told::default()), progress.as_mut());
        both.expanded(5, (), 0);
        both.relaxed(6, 5, (), 1);
        assert_eq!([0, 10].map(|expanded| due(&mut both, expanded)), [10, 20]);
        let (_, other) = both.0;
        let all = [(5, None), (6, Some(5))];
        assert_eq!((&one.0[..], &other.0[..]), (&all[..], &all[..]));
        assert_eq!(due(&mut (None::<Told>, Told::default()), 10), u32::MAX);
    }
}
