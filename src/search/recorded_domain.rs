//! A search over a [`Domain`] written down while it runs: the domain is watched, not repeated.
//!
//! The search is [`best_first`](super::best_first()) itself. It asks a domain that passes every question on and keeps the
//! answers, so order, costs and counters are the planner's own; a search that nobody watches knows nothing of this.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::best_first::{Limits, Report, best_first};
use super::observer::Observer;
use super::recording::{Fate, PAST, Recording, StepKind};
use super::{Domain, Finish, NodeId, Order, Relax, Scratch, Visit};

/// A domain that can name its moves whether they were taken or not.
pub trait Told: Domain<Cost = f64, Label: PartialEq> {
    /// Tells of all moves of a node, those that [`Domain::successors`] emits among them: target, cost of the move, label
    /// there, and why it is not made unless its cost is against it; `None` where nothing else is.
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
#[derive(Clone, Copy)]
struct Known {
    g: f64,
    is_closed: bool,
}

struct Notes<L> {
    out: Labelled<L>,
    known: BTreeMap<NodeId, Known>,
    /// Cost of the best completion so far.
    best: f64,
    /// Moves of the node at hand whose cost the domain has asked about.
    asked: Vec<(NodeId, f64, Fate)>,
    limit: usize,
}

impl<L> Notes<L> {
    fn fate(&self, target: NodeId, g: f64) -> Fate {
        match self.known.get(&target) {
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

    fn offer(&mut self, target: NodeId, fate: u8, g: f64, h: f64, label: L) {
        if !self.out.recording.is_cut {
            self.out.recording.offer(target, fate, g, h);
            self.out.labels.push(label);
        }
    }
}

struct Watched<'a, D: Told> {
    domain: &'a mut D,
    notes: RefCell<Notes<D::Label>>,
}

impl<D: Told> Domain for Watched<'_, D> {
    type Cost = f64;
    type Label = D::Label;
    type Tail = D::Tail;

    const ORDER: Order = D::ORDER;

    fn node_count(&self) -> usize {
        self.domain.node_count()
    }

    fn successors<S: Relax<f64, D::Label>>(&self, from: Visit<f64, D::Label>, sink: &mut S) {
        let parent_g = from.parent.map_or(0.0, |parent| self.notes.borrow().known[&parent].g);
        let first = self.notes.borrow_mut().begin_moves();
        self.domain.successors(from, &mut Passing { watched: self, sink, from: [from.g, parent_g] });
        let notes = &self.notes;
        self.domain.consider(from, &mut |target, cost, label, reason| {
            let mut notes = notes.borrow_mut();
            if notes.out.recording.is_cut || notes.out.labels[first..].contains(&label) {
                return;
            }
            let g = from.g + cost;
            let asked = notes.asked.iter().find(|one| (one.0, one.1) == (target, cost)).map(|one| one.2);
            let is_dear = asked.filter(|fate| !matches!(fate, Fate::Kept | Fate::Improved));
            let fate = is_dear.or(reason).unwrap_or_else(|| match notes.fate(target, g) {
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
        let notes = self.notes.get_mut();
        notes.known.insert(at.node, Known { g: at.g, is_closed: true });
        let recording = &mut notes.out.recording;
        recording.is_cut |= recording.nodes.len() == notes.limit;
        if !recording.is_cut {
            let kind = if found.is_some() { StepKind::Goal } else { StepKind::Expand };
            recording.step(kind, 0, at.node, [at.g, h, at.g + h]);
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
    fn note(&mut self, target: NodeId, g: f64, past: u8, label: D::Label) {
        let h = self.watched.domain.heuristic(target, label);
        let mut notes = self.watched.notes.borrow_mut();
        let fate = match notes.fate(target, g) {
            Fate::Kept | Fate::Improved if h.is_infinite() || g + h >= notes.best => Fate::LeftOut,
            fate => fate,
        };
        if matches!(fate, Fate::Kept | Fate::Improved) {
            notes.known.insert(target, Known { g, is_closed: false });
        }
        notes.offer(target, fate as u8 | past, g, h, label);
    }
}

impl<D: Told, S: Relax<f64, D::Label>> Relax<f64, D::Label> for Passing<'_, '_, D, S> {
    fn improves(&self, target: NodeId, cost: f64) -> bool {
        let mut notes = self.watched.notes.borrow_mut();
        let fate = notes.fate(target, self.from[0] + cost);
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

/// [`best_first`](super::best_first()), of which at most `limit` steps are written down.
pub fn record_best_first<D: Told, O: Observer<f64, D::Label>>(
    domain: &mut D,
    root: (NodeId, D::Label),
    limits: Limits,
    scratch: &mut Scratch<f64, D::Label>,
    observer: &mut O,
    limit: usize,
) -> (Report<f64, D::Tail>, Labelled<D::Label>) {
    let out = Labelled { recording: Recording::default(), labels: Vec::new() };
    let known = BTreeMap::from([(root.0, Known { g: 0.0, is_closed: false })]);
    let notes = RefCell::new(Notes { out, known, best: f64::INFINITY, asked: Vec::new(), limit });
    let mut watched = Watched { domain, notes };
    let report = best_first(&mut watched, root, limits, scratch, observer);
    let Labelled { mut recording, labels } = watched.notes.into_inner().out;
    recording.unit = 1.0;
    (recording.expanded, recording.generated) = (report.expanded, report.generated);
    (recording.pushes, recording.open_peak) = (report.pushes, report.open_peak);
    (report, Labelled { recording: recording.finish(), labels })
}
