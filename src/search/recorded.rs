//! The lattice searches once more, slowly and with every event written down.
//!
//! They ask the same [`Lattice`] and order the open list by the same rule, with a heap and a map for memory; tests hold
//! them to the planners' own order and counters. Nothing in the fast searches knows of this.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BinaryHeap};

use super::NodeId;
use super::lattice::{Deferral, Deferring, Edge, EdgeSink, Lattice, ROOT, Reversible};
use super::recording::{Fate, MICRO, Recording, StepKind};

/// Whether a move that is considered can be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Legality {
    /// It can.
    Free,
    /// Its target is blocked.
    Blocked,
    /// Its target is free, the way to it is not.
    Corner,
}

/// Which of a node's moves are asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Those tried when the node is expanded.
    Forward,
    /// The same of the side that searches from the goal.
    Backward,
    /// Those that are deferred.
    Deferred,
}

/// A lattice that can name its moves whether legal or not.
pub trait Considered: Lattice {
    /// Tells of each move within the map: target, cost in micro-cells, legality. `last` is the move that reached the
    /// node, `None` at the root.
    fn consider(
        &self,
        node: NodeId,
        last: Option<u32>,
        part: Part,
        tell: &mut dyn FnMut(NodeId, i64, Legality),
    );
}

/// A lattice as the recorder asks it: behind a pointer, so that the searches are compiled once.
pub(super) trait Asked {
    fn successors(&self, node: NodeId, last: Option<u32>, sink: &mut RecordingSink);
    fn consider(
        &self,
        node: NodeId,
        last: Option<u32>,
        part: Part,
        tell: &mut dyn FnMut(NodeId, i64, Legality),
    );
    fn direct(&self, node: NodeId) -> Option<i64>;
    fn to_goal(&self, node: NodeId) -> i64;
}

/// The same of a [`Reversible`] lattice.
pub(super) trait AskedBothWays: Asked {
    fn predecessors(&self, node: NodeId, last: Option<u32>, sink: &mut RecordingSink);
    fn to_start(&self, node: NodeId) -> i64;
}

/// The deferred moves of a [`Deferring`] lattice.
trait AskedLater {
    fn deferred(&self, node: NodeId, payload: Option<u32>, sink: &mut RecordingSink);
    fn deferral(&self) -> Deferral;
    fn payload(&self) -> u32;
}

impl<L: Considered> Asked for L {
    fn successors(&self, node: NodeId, last: Option<u32>, sink: &mut RecordingSink) {
        Lattice::successors(self, node, last, sink);
    }

    fn consider(
        &self,
        node: NodeId,
        last: Option<u32>,
        part: Part,
        tell: &mut dyn FnMut(NodeId, i64, Legality),
    ) {
        Considered::consider(self, node, last, part, tell);
    }

    fn direct(&self, node: NodeId) -> Option<i64> {
        Lattice::direct(self, node)
    }

    fn to_goal(&self, node: NodeId) -> i64 {
        Lattice::to_goal(self, node)
    }
}

impl<L: Considered + Reversible> AskedBothWays for L {
    fn predecessors(&self, node: NodeId, last: Option<u32>, sink: &mut RecordingSink) {
        Reversible::predecessors(self, node, last, sink);
    }

    fn to_start(&self, node: NodeId) -> i64 {
        Reversible::to_start(self, node)
    }
}

impl<L: Deferring> AskedLater for L {
    fn deferred(&self, node: NodeId, payload: Option<u32>, sink: &mut RecordingSink) {
        match payload {
            Some(payload) => self.deferred_successors(node, payload, sink),
            None => self.deferred_at_once(node, sink),
        }
    }

    fn deferral(&self) -> Deferral {
        Deferring::deferral(self)
    }

    fn payload(&self) -> u32 {
        Deferring::payload(self)
    }
}

/// An open-list entry; the greatest is taken first: least f, then least h, then the newest.
pub(super) struct Waiting {
    pub(super) f: i64,
    pub(super) h: i64,
    number: u32,
    pub(super) node: NodeId,
    payload: Option<u32>,
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        (other.f, other.h, self.number).cmp(&(self.f, self.h, other.number))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

/// What a side knows of a node.
#[derive(Clone, Copy)]
pub(super) struct Known {
    pub(super) g: i64,
    /// The move that reached it; `None` at the root.
    pub(super) number: Option<u32>,
    pub(super) is_closed: bool,
}

#[derive(Default)]
pub(super) struct RecordedSide {
    pub(super) known: BTreeMap<NodeId, Known>,
    open: BinaryHeap<Waiting>,
    pushes: u32,
    generated: u32,
    peak: usize,
}

impl RecordedSide {
    pub(super) fn root(root: NodeId, h: i64) -> Self {
        let mut side = Self::default();
        side.known.insert(root, Known { g: 0, number: None, is_closed: false });
        side.generated = 1;
        side.push(h, h, root, None);
        side
    }

    fn push(&mut self, f: i64, h: i64, node: NodeId, payload: Option<u32>) {
        self.open.push(Waiting { f, h, number: self.pushes, node, payload });
        self.pushes += 1;
    }

    /// The next entry whose node is still open, or which stands for deferred moves.
    pub(super) fn pop(&mut self) -> Option<Waiting> {
        self.peak = self.peak.max(self.open.len());
        loop {
            let entry = self.open.pop()?;
            if entry.payload.is_some() || self.known.get(&entry.node).is_some_and(|known| !known.is_closed) {
                return Some(entry);
            }
        }
    }

    /// What would become of a free move to a node at this cost.
    fn fate(&self, target: NodeId, g: i64) -> Fate {
        match self.known.get(&target) {
            None => Fate::Kept,
            Some(known) if known.is_closed => Fate::Closed,
            Some(known) if g < known.g => Fate::Improved,
            Some(_) => Fate::Dearer,
        }
    }

    fn improves(&self, target: NodeId, g: i64) -> bool {
        matches!(self.fate(target, g), Fate::Kept | Fate::Improved)
    }
}

/// Takes the moves of one node and writes them down.
pub(super) struct RecordingSink<'a> {
    pub(super) side: &'a mut RecordedSide,
    pub(super) other: Option<&'a RecordedSide>,
    pub(super) best: Option<&'a mut (i64, NodeId)>,
    pub(super) recording: &'a mut Recording,
    pub(super) g: i64,
}

impl RecordingSink<'_> {
    fn improves_at(&self, node: i64, cost: i64) -> bool {
        u32::try_from(node).is_ok_and(|node| self.side.improves(node, self.g + cost))
    }
}

impl EdgeSink for RecordingSink<'_> {
    fn improves(&self, target: NodeId, cost: i64) -> bool {
        self.side.improves(target, self.g + cost)
    }

    fn improves_around(&self, node: NodeId, row: usize, straight: i64, diagonal: i64) -> u32 {
        let (node, row) = (i64::from(node), row as i64);
        let offsets = [1, row + 1, row, row - 1, -1, -row - 1, -row, 1 - row];
        let costs = [straight, diagonal];
        let improves = |c: usize| self.improves_at(node + offsets[c], costs[c % 2]);
        (0..8).fold(0, |bits, c| bits | u32::from(improves(c)) << c)
    }

    fn improves_beside(&self, node: NodeId, row: usize, straight: i64) -> u32 {
        self.improves_around(node, row, straight, straight) & 0b0101_0101
    }

    fn relax(&mut self, edge: Edge, target: NodeId, h: i64) {
        let g = self.g + edge.cost;
        let fate = self.side.fate(target, g);
        self.side.generated += u32::from(fate == Fate::Kept);
        let number = Some((edge.code & u64::from(ROOT)) as u32);
        self.side.known.insert(target, Known { g, number, is_closed: false });
        self.side.push(g + h, h, target, None);
        self.recording.offer(target, fate as u8, g as f64, h as f64);
        if let (Some(best), Some(there)) =
            (self.best.as_deref_mut(), self.other.and_then(|other| other.known.get(&target)))
            && g + there.g < best.0
        {
            *best = (g + there.g, target);
        }
    }
}

/// Writes down the moves of a node that were not taken.
pub(super) fn refuse(
    lattice: &dyn Asked,
    (node, known, part): (NodeId, Known, Part),
    side: &RecordedSide,
    recording: &mut Recording,
    hold: bool,
) {
    let taken = recording.first.last().map_or(0, |&first| first as usize)..recording.targets.len();
    let mut others = Vec::new();
    lattice.consider(node, known.number, part, &mut |target, cost, legality| {
        if recording.targets[taken.clone()].contains(&target) {
            return;
        }
        let fate = match (legality, side.fate(target, known.g + cost)) {
            (Legality::Blocked, _) => Fate::Blocked,
            (Legality::Corner, _) => Fate::Corner,
            (Legality::Free, Fate::Kept | Fate::Improved) if hold => Fate::HeldBack,
            (Legality::Free, Fate::Kept | Fate::Improved) => Fate::LeftOut,
            (Legality::Free, fate) => fate,
        };
        others.push((target, fate, known.g + cost));
    });
    for (target, fate, g) in others {
        recording.offer(target, fate as u8, g as f64, 0.0);
    }
}

/// [`one_way`](super::one_way::one_way), of which at most `limit` steps are written down.
pub fn record_one_way<L: Considered>(
    lattice: &L,
    ends: (NodeId, NodeId),
    max_expansions: u32,
    limit: usize,
) -> Recording {
    one_way(lattice, None, ends, max_expansions, limit)
}

/// [`one_way_deferring`](super::one_way::one_way_deferring), of which at most `limit` steps are written down.
pub fn record_deferring<L: Considered + Deferring>(
    lattice: &L,
    ends: (NodeId, NodeId),
    max_expansions: u32,
    limit: usize,
) -> Recording {
    one_way(lattice, Some(lattice), ends, max_expansions, limit)
}

/// The search from one end: entries are taken by f, h and recency from a heap, and each opens a step whose moves follow
/// it. Moves that a node defers come at once or with a second entry, as its [`Deferral`] says. O(E·log E) for E
/// entries.
fn one_way(
    lattice: &dyn Asked,
    later: Option<&dyn AskedLater>,
    (start, goal): (NodeId, NodeId),
    max_expansions: u32,
    limit: usize,
) -> Recording {
    let mut side = RecordedSide::root(start, lattice.to_goal(start));
    let mut out = Recording::default();
    if let Some(Deferral::Penalty(penalty)) = later.map(AskedLater::deferral) {
        out.penalty = penalty as f64;
    }
    while let Some(entry) = side.pop() {
        if out.stats.expanded >= max_expansions {
            break;
        }
        if out.nodes.len() == limit {
            out.is_cut = true;
            break;
        }
        let (node, h) = (entry.node, entry.h);
        let known = side.known[&node];
        let g = known.g;
        out.stats.expanded += 1;
        let numbers = [g, h, entry.f].map(|value| value as f64);
        if let Some(payload) = entry.payload {
            out.step(StepKind::Deferred, 0, node, numbers);
            let sink =
                &mut RecordingSink { side: &mut side, other: None, best: None, recording: &mut out, g };
            if let Some(later) = later {
                later.deferred(node, Some(payload), sink);
            }
            refuse(lattice, (node, known, Part::Deferred), &side, &mut out, false);
            continue;
        }
        side.known.insert(node, Known { is_closed: true, ..known });
        let rest = if node == goal { Some(0) } else { lattice.direct(node) };
        if let Some(rest) = rest {
            out.step(StepKind::Goal, 0, node, numbers);
            if node != goal {
                side.generated += u32::from(!side.known.contains_key(&goal));
                out.offer(goal, Fate::Kept as u8, (g + rest) as f64, 0.0);
            }
            break;
        }
        out.step(StepKind::Expand, 0, node, numbers);
        let pushes = side.pushes;
        let sink = &mut RecordingSink { side: &mut side, other: None, best: None, recording: &mut out, g };
        lattice.successors(node, known.number, sink);
        let has_improved = side.pushes > pushes;
        refuse(lattice, (node, known, Part::Forward), &side, &mut out, false);
        if let Some(later) = later {
            defer((lattice, later), (node, known, h), has_improved, &mut side, &mut out);
        }
    }
    count(out, &[side])
}

/// Tries the deferred moves of a node at once, or has it wait for them.
fn defer(
    (lattice, later): (&dyn Asked, &dyn AskedLater),
    (node, known, h): (NodeId, Known, i64),
    has_improved: bool,
    side: &mut RecordedSide,
    out: &mut Recording,
) {
    let (g, deferral) = (known.g, later.deferral());
    let at_once = !has_improved && deferral != Deferral::Never;
    if at_once {
        later.deferred(node, None, &mut RecordingSink { side, other: None, best: None, recording: out, g });
    }
    refuse(lattice, (node, known, Part::Deferred), side, out, !at_once);
    if let (Deferral::Penalty(penalty), true) = (deferral, has_improved) {
        side.push(g + h + penalty, h, node, Some(later.payload()));
        out.offer(node, Fate::Requeued as u8, g as f64, h as f64);
    }
}

/// Adds the sides' counters to the recording; the open lists' largest sizes are summed.
pub(super) fn count(mut out: Recording, sides: &[RecordedSide]) -> Recording {
    for side in sides {
        out.stats.generated += side.generated;
        out.stats.pushes += side.pushes;
        out.stats.open_peak += side.peak.max(side.open.len()) as u32;
    }
    out.unit = MICRO;
    out.finish()
}
