//! A search over a [`Domain`] written down while it runs: the domain is watched, not repeated.
//!
//! The search is [`best_first`](super::best_first()) or
//! [`bidirectional_best_first`](super::bidirectional_best_first()) itself. It asks a domain that passes every question
//! on and keeps the answers, so order, costs and counters are the planner's own; a search that nobody watches knows
//! nothing of this. Two trees write into one recording, each with nodes of its own.
//!
//! A step is opened by [`Domain::finish`], which the search asks once for every node that it takes, and filled by
//! [`Domain::successors`], which follows. Between the two the recorder knows the node's g and h; what becomes of each
//! move it works out from its own table of costs. The search itself is generic over its domain, so the planner's own
//! domain compiles to the planner's own loop, and the watched one to a second copy.

use std::borrow::Borrow;
use std::cell::RefCell;
use std::collections::BTreeMap;

use super::best_first::{Limits, Report, best_first};
use super::bidirectional_best_first::{Join, Summary, Trees, bidirectional_best_first};
use super::observer::Observer;
use super::recording::{BACKWARD, Fate, PAST, Recording, StepKind};
use super::{Domain, Finish, NodeId, Order, Relax, Scratch, SearchStats, Tree, Visit};

/// A domain that can name its moves whether they were taken or not.
/// A target may be told more than once; what the search emitted is recognised by its label.
pub trait Told: Domain<Cost = f64, Label: PartialEq> {
    /// Tells of all moves of a node, those that [`Domain::successors`] emits among them: target, cost of the move,
    /// label there, and why it is not made unless its cost is against it; `None` where nothing else is.
    fn consider(
        &self,
        from: Visit<f64, Self::Label>,
        tell: &mut dyn FnMut(NodeId, f64, Self::Label, Option<Fate>),
    );
}

/// A recording, and the label of each move's target.
#[derive(Debug, Clone, PartialEq)]
pub struct Labelled<L> {
    /// The events.
    pub recording: Recording,
    /// Per move the label with which it reaches its target.
    pub labels: Vec<L>,
}

/// What the search knows of a node.
#[derive(Debug, Clone, Copy)]
struct Known {
    g: f64,
    is_closed: bool,
}

/// The recording so far, and what is needed to judge the next move. It lies in a [`RefCell`], because a domain is
/// asked for its moves by shared reference.
#[derive(Debug)]
struct Notes<L> {
    out: Labelled<L>,
    /// Per side its nodes.
    known: [BTreeMap<NodeId, Known>; 2],
    /// Cost of the best path so far.
    best: f64,
    /// Moves of the node at hand whose cost the domain has asked about.
    asked: Vec<(NodeId, f64, Fate)>,
    limit: usize,
}

impl<L> Notes<L> {
    /// Notes of a search with one root a side, before its first step.
    fn new(roots: &[NodeId], order: Order, limit: usize) -> Self {
        let recording = Recording { oldest_first: order == Order::Oldest, ..Recording::default() };
        let out = Labelled { recording, labels: Vec::new() };
        let mut known = [BTreeMap::new(), BTreeMap::new()];
        for (known, &root) in known.iter_mut().zip(roots) {
            known.insert(root, Known { g: 0.0, is_closed: false });
        }
        Self { out, known, best: f64::INFINITY, asked: Vec::new(), limit }
    }

    /// What becomes of a legal move to `target` that reaches it at cost `g`, by the best costs known before it.
    fn fate(&self, side: usize, target: NodeId, g: f64) -> Fate {
        match self.known[side].get(&target) {
            Some(known) if known.is_closed => Fate::Closed,
            Some(known) if g >= known.g => Fate::Dearer,
            _ if g >= self.best => Fate::LeftOut,
            Some(_) => Fate::Improved,
            None => Fate::Kept,
        }
    }

    /// The node at hand is expanded; returns the number of its first move.
    fn begin_moves(&mut self) -> usize {
        self.asked.clear();
        if let (false, Some(kind)) = (self.out.recording.is_cut, self.out.recording.kinds.last_mut())
            && *kind == StepKind::Goal as u8
        {
            *kind = StepKind::Joined as u8;
        }
        self.out.labels.len()
    }

    /// Adds a move to the step at hand, unless the recording has reached its limit.
    fn offer(&mut self, target: NodeId, fate: u8, g: f64, h: f64, label: L) {
        if !self.out.recording.is_cut {
            self.out.recording.offer(target, fate, g, h);
            self.out.labels.push(label);
        }
    }
}

/// A domain that passes every question on.
#[derive(Debug)]
pub struct Watched<'a, D: Told> {
    domain: &'a mut D,
    notes: &'a RefCell<Notes<D::Label>>,
    side: usize,
}

impl<D: Told> Borrow<D> for Watched<'_, D> {
    fn borrow(&self) -> &D {
        self.domain
    }
}

impl<D: Told> Domain for Watched<'_, D> {
    type Cost = f64;
    type Label = D::Label;
    type Tail = D::Tail;

    fn node_count(&self) -> usize {
        self.domain.node_count()
    }

    fn order(&self) -> Order {
        self.domain.order()
    }

    fn successors<S: Relax<f64, D::Label>>(&self, from: Visit<f64, D::Label>, sink: &mut S) {
        let parent_g = from.parent.map_or(0.0, |parent| self.notes.borrow().known[self.side][&parent].g);
        let first = self.notes.borrow_mut().begin_moves();
        self.domain.successors(from, &mut Passing { watched: self, sink, from: [from.g, parent_g] });
        let Self { notes, side, .. } = *self;
        self.domain.consider(from, &mut |target, cost, label, reason| {
            let mut notes = notes.borrow_mut();
            if notes.out.recording.is_cut || notes.out.labels[first..].contains(&label) {
                return;
            }
            let g = from.g + cost;
            let asked = notes.asked.iter().find(|one| (one.0, one.1) == (target, cost)).map(|one| one.2);
            let is_dear = asked.filter(|fate| !matches!(fate, Fate::Kept | Fate::Improved));
            let fate = is_dear.or(reason).unwrap_or_else(|| match notes.fate(side, target, g) {
                Fate::Kept | Fate::Improved => Fate::LeftOut,
                fate => fate,
            });
            notes.offer(target, fate as u8, g, 0.0, label);
        });
    }

    fn heuristic(&self, node: NodeId, label: D::Label) -> f64 {
        self.domain.heuristic(node, label)
    }

    fn finish(&mut self, at: Visit<f64, D::Label>, bound: f64) -> Option<Finish<f64, D::Tail>> {
        let h = self.domain.heuristic(at.node, at.label);
        let found = self.domain.finish(at, bound).filter(|finish| at.g + finish.cost < bound);
        let mut notes = self.notes.borrow_mut();
        let notes = &mut *notes;
        notes.known[self.side].insert(at.node, Known { g: at.g, is_closed: true });
        let recording = &mut notes.out.recording;
        recording.is_cut |= recording.nodes.len() == notes.limit;
        if !recording.is_cut {
            let kind = if found.is_some() { StepKind::Goal } else { StepKind::Expand };
            recording.step(kind, self.side, at.node, [at.g, h, at.g + h]);
        }
        if let Some(finish) = &found {
            notes.best = at.g + finish.cost;
        }
        found
    }
}

/// Passes moves on to the search and writes them down.
struct Passing<'a, 'd, D: Told, S> {
    watched: &'a Watched<'d, D>,
    sink: &'a mut S,
    /// Costs of the node and of its parent.
    from: [f64; 2],
}

impl<D: Told, S: Relax<f64, D::Label>> Passing<'_, '_, D, S> {
    /// Writes one emitted move down before it is passed on.
    fn note(&mut self, target: NodeId, g: f64, past: u8, label: D::Label) {
        let h = self.watched.domain.heuristic(target, label);
        let side = self.watched.side;
        let mut notes = self.watched.notes.borrow_mut();
        let fate = match notes.fate(side, target, g) {
            Fate::Kept | Fate::Improved if h.is_infinite() || g + h >= notes.best => Fate::LeftOut,
            fate => fate,
        };
        if matches!(fate, Fate::Kept | Fate::Improved) {
            notes.known[side].insert(target, Known { g, is_closed: false });
        }
        notes.offer(target, fate as u8 | past, g, h, label);
    }
}

impl<D: Told, S: Relax<f64, D::Label>> Relax<f64, D::Label> for Passing<'_, '_, D, S> {
    fn improves(&self, target: NodeId, cost: f64) -> bool {
        let mut notes = self.watched.notes.borrow_mut();
        let fate = notes.fate(self.watched.side, target, self.from[0] + cost);
        notes.asked.push((target, cost, fate));
        self.sink.improves(target, cost)
    }

    fn is_closed(&self, target: NodeId) -> bool {
        self.sink.is_closed(target)
    }

    fn emit_past(&mut self, target: NodeId, cost: f64, label: D::Label) {
        self.note(target, self.from[1] + cost, PAST, label);
        self.sink.emit_past(target, cost, label);
    }

    fn emit(&mut self, target: NodeId, cost: f64, label: D::Label) {
        self.note(target, self.from[0] + cost, 0, label);
        self.sink.emit(target, cost, label);
    }
}

/// A join of two watched trees, which says where a path comes from.
struct Noted<'a, L, J> {
    join: &'a mut J,
    notes: &'a RefCell<Notes<L>>,
}

impl<L, J> Noted<'_, L, J> {
    /// The step at hand made the best path cheaper, or the completion that it was noted for did not.
    fn note<D: Domain<Cost = f64, Label = L>>(&mut self, before: f64, kind: StepKind)
    where
        J: Join<D>,
    {
        let mut notes = self.notes.borrow_mut();
        let is_cheaper = self.join.best() < before;
        notes.best = self.join.best();
        if let (false, Some(last)) = (notes.out.recording.is_cut, notes.out.recording.kinds.last_mut()) {
            let side = *last & BACKWARD;
            if is_cheaper {
                *last = side + kind as u8;
            } else if *last == side + StepKind::Goal as u8 {
                *last = side + StepKind::Expand as u8;
            }
        }
    }
}

impl<D: Domain<Cost = f64>, J: Join<D>> Join<D> for Noted<'_, D::Label, J> {
    fn best(&self) -> f64 {
        self.join.best()
    }

    fn complete(
        &mut self,
        trees: Trees<D>,
        side: usize,
        at: Visit<f64, D::Label>,
        finish: Finish<f64, D::Tail>,
    ) {
        let before = self.join.best();
        self.join.complete(trees, side, at, finish);
        self.note::<D>(before, StepKind::Joined);
    }

    fn join(&mut self, trees: Trees<D>, side: usize, at: Visit<f64, D::Label>) {
        let before = self.join.best();
        self.join.join(trees, side, at);
        self.note::<D>(before, StepKind::Meet);
    }
}

/// [`best_first`](super::best_first()), of which at most `limit` steps are written down.
pub fn record_best_first<D: Told, O: Observer<f64, D::Label>>(
    domain: &mut D,
    root: (NodeId, D::Label),
    limits: Limits,
    scratch: &mut Scratch<f64, D::Label>,
    observer: &mut O,
    limit: usize,
) -> (Report<f64, D::Tail>, Labelled<D::Label>) {
    let notes = RefCell::new(Notes::new(&[root.0], domain.order(), limit));
    let mut watched = Watched { domain, notes: &notes, side: 0 };
    let report = best_first(&mut watched, root, limits, scratch, observer);
    let stats = report.stats;
    (report, finished(notes, stats))
}

/// Domain, root and memory of one side of a search.
pub type Ground<'a, D> =
    (&'a mut D, (NodeId, <D as Domain>::Label), &'a mut Scratch<f64, <D as Domain>::Label>);

/// [`bidirectional_best_first`](super::bidirectional_best_first()), of which at most `limit` steps are written down.
pub fn record_bidirectional_best_first<'a, D, J, O>(
    [first, second]: [Ground<'a, D>; 2],
    limits: Limits,
    join: &mut J,
    observer: &mut O,
    limit: usize,
) -> (Summary, Labelled<D::Label>)
where
    D: Told,
    J: for<'w> Join<Watched<'w, D>>,
    O: Observer<f64, D::Label>,
{
    let notes = RefCell::new(Notes::new(&[first.1.0, second.1.0], first.0.order(), limit));
    let mut domains =
        [(0, first.0), (1, second.0)].map(|(side, domain)| Watched { domain, notes: &notes, side });
    let [a, b] = &mut domains;
    let mut trees = [Tree::new(a, first.1, first.2), Tree::new(b, second.1, second.2)];
    let mut noted = Noted { join, notes: &notes };
    let summary = bidirectional_best_first(&mut trees, limits, &mut noted, observer);
    (summary, finished(notes, summary.stats))
}

/// Closes the last step and adds the search's own counters.
fn finished<L>(notes: RefCell<Notes<L>>, stats: SearchStats) -> Labelled<L> {
    let Labelled { recording, labels } = notes.into_inner().out;
    let recording = Recording { unit: 1.0, stats, ..recording };
    Labelled { recording: recording.finish(), labels }
}
