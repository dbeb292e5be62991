//! Two trees, one from each end, joined by Reeds–Shepp curves.
//!
//! The parking paper's flowchart lets the trees meet where they share a cell; cells alone do not make a drivable join, so a
//! curve between the two real poses does. Each expanded state is also tried with a curve to the other root.

use core::cell::RefCell;
use core::cmp::Ordering;
use std::collections::BinaryHeap;

use super::config::Level;
use super::cost::{CostModel, Motion};
use super::domain::{self, Lattice, Setting, State};
use super::flood::Flood;
use super::keys::Keys;
use super::level::Search;
use super::shots::Watch;
use super::{Report, Status, Tree};
use crate::geometry::arcs::{self, Arc};
use crate::geometry::reeds_shepp;
use crate::search::{Budget, Domain, NodeId, Observer, Progress, Relax, Visit};

/// What is known of a state.
#[derive(Clone, Copy)]
struct Node {
    g: f64,
    state: State,
    parent: Option<NodeId>,
    closed: bool,
}

const UNREACHED: Node = Node {
    g: f64::INFINITY,
    state: State {
        pose: crate::geometry::Pose { x: 0.0, y: 0.0, heading: 0.0 },
        motion: Motion { gear: 0, curvature: 0.0 },
        length: 0.0,
    },
    parent: None,
    closed: false,
};

/// An entry of the open list: the least priority first, then the earliest.
struct Entry {
    f: f64,
    number: u32,
    node: NodeId,
    g: f64,
}

impl Ord for Entry {
    fn cmp(&self, other: &Self) -> Ordering {
        other.f.total_cmp(&self.f).then(other.number.cmp(&self.number))
    }
}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Entry {}

/// One tree.
struct Side<'a> {
    lattice: Lattice<'a>,
    mirrored: bool,
    nodes: Vec<Node>,
    open: BinaryHeap<Entry>,
    pushes: u32,
    generated: u32,
}

/// Where one tree's moves go.
struct Sink<'s> {
    nodes: &'s mut Vec<Node>,
    moves: Vec<(NodeId, f64, State)>,
    g: f64,
    bound: f64,
}

impl Relax<f64, State> for Sink<'_> {
    fn worth(&self, target: NodeId, cost: f64) -> bool {
        let g = self.g + cost;
        g < self.bound && self.nodes.get(target as usize).is_none_or(|n| !n.closed && g < n.g)
    }

    fn emit(&mut self, target: NodeId, cost: f64, label: State) {
        if self.worth(target, cost) {
            self.moves.push((target, self.g + cost, label));
        }
    }
}

impl Side<'_> {
    fn enter(&mut self, id: NodeId, g: f64, state: State, parent: Option<NodeId>, bound: f64) {
        let f = g + self.lattice.heuristic(id, state);
        if f >= bound {
            return;
        }
        if id as usize >= self.nodes.len() {
            self.nodes.resize(id as usize + 1, UNREACHED);
        }
        let node = &mut self.nodes[id as usize];
        if node.closed || node.g <= g {
            return;
        }
        self.generated += u32::from(node.g.is_infinite());
        *node = Node { g, state, parent, closed: false };
        self.open.push(Entry { f, number: self.pushes, node: id, g });
        self.pushes += 1;
    }

    /// The next state, closed.
    fn pop(&mut self) -> Option<(NodeId, Node)> {
        loop {
            let entry = self.open.pop()?;
            let node = &mut self.nodes[entry.node as usize];
            if !node.closed && node.g == entry.g {
                node.closed = true;
                return Some((entry.node, *node));
            }
        }
    }

    fn expand(&mut self, id: NodeId, at: Node, bound: f64) {
        let mut sink = Sink { nodes: &mut self.nodes, moves: Vec::new(), g: at.g, bound };
        self.lattice.successors(visit(id, at), &mut sink);
        for (target, g, state) in sink.moves {
            self.enter(target, g, state, Some(id), bound);
        }
    }

    /// The arcs from the root to a state, as this tree drives.
    fn arcs(&self, mut id: NodeId) -> Vec<Arc> {
        let mut arcs = Vec::new();
        while let Node { state, parent: Some(parent), .. } = self.nodes[id as usize] {
            arcs.push(Arc { curvature: state.motion.curvature, length: state.length });
            id = parent;
        }
        arcs.reverse();
        arcs
    }

    /// The reached states in the cell of a pose, whatever their gear.
    fn around(&self, state: State) -> impl Iterator<Item = (NodeId, Node)> + '_ {
        [-1, 0, 1].into_iter().filter_map(move |gear| {
            let id = self.lattice.node(state.pose, gear);
            self.nodes.get(id as usize).filter(|n| n.g.is_finite()).map(|n| (id, *n))
        })
    }
}

fn visit(id: NodeId, at: Node) -> Visit<f64, State> {
    Visit { node: id, label: at.state, g: at.g, parent: at.parent }
}

/// The cheapest path so far, as driven.
struct Best<'a> {
    search: &'a Search<'a>,
    costs: CostModel,
    cost: f64,
    arcs: Vec<Arc>,
}

impl Best<'_> {
    fn take(&mut self, arcs: Vec<Arc>) {
        let cost = self.costs.path(self.search.probe, self.search.start, &arcs);
        if cost < self.cost {
            (self.cost, self.arcs) = (cost, arcs);
        }
    }

    /// Joins a state of the tree from the start to one of the tree from the goal.
    fn bridge(&mut self, from: (&Side, NodeId, Node), to: (&Side, NodeId, Node)) {
        let (here, there) = (from.2.state.pose, to.2.state.pose);
        let radius = self.costs.radius;
        let left = self.cost - from.2.g - to.2.g;
        let words = reeds_shepp::list_below(here, there, radius, left);
        let mut words: Vec<_> = words.into_iter().map(|word| (word.length(radius), word)).collect();
        while let Some((_, word)) = domain::take_cheapest(&mut words) {
            if word.direction_changes() <= from.0.lattice.max_changes && from.0.lattice.word_free(here, &word)
            {
                let first = from.0.arcs(from.1).into_iter().chain(word.arcs(radius));
                self.take(arcs::merge(first.chain(arcs::reversed(&to.0.arcs(to.1)))));
                return;
            }
        }
    }
}

/// Searches one level from both ends.
pub(super) fn search(
    search: &Search,
    level: Level,
    report: &mut Report,
    (tree, watch): (&mut Option<Tree>, Option<&RefCell<Watch>>),
    progress: &mut Option<Progress>,
) -> Option<(Vec<Arc>, Status)> {
    let vehicle = search.query.vehicle;
    let driven = search.costs().searching(&level);
    let keys = [RefCell::new(Keys::default()), RefCell::new(Keys::default())];
    let floods = [search.goal, search.start]
        .map(|target| Flood::new(search.query.obstacles, vehicle, target, report.margin, None));
    let ends = [search.start, search.goal];
    let mut sides = [false, true].map(|mirrored| {
        let i = usize::from(mirrored);
        let costs = if mirrored { driven.mirrored() } else { driven };
        let setting =
            Setting { probe: search.probe, flood: &floods[i], keys: &keys[i], costs, mirrored, watch };
        let lattice = Lattice::new(setting, vehicle, search.config, level, ends[1 - i], report.margin);
        let mut side =
            Side { lattice, mirrored, nodes: Vec::new(), open: BinaryHeap::new(), pushes: 0, generated: 0 };
        let root = side.lattice.node(ends[i], 0);
        side.enter(root, 0.0, State { pose: ends[i], ..State::default() }, None, f64::INFINITY);
        side
    });
    let mut best = Best { search, costs: driven, cost: f64::INFINITY, arcs: Vec::new() };
    let (mut expanded, mut waiting) = (0, 0);
    let mut budget = Budget::new::<f64, State, _>(level.max_expansions, progress);
    let spent = loop {
        let [least_a, least_b] = [&sides[0], &sides[1]].map(|s| s.open.peek().map_or(f64::INFINITY, |e| e.f));
        let done = least_a.max(least_b) >= best.cost && best.cost.is_finite();
        if done || (search.config.first_shot && best.cost.is_finite()) {
            break false;
        }
        let [a, b] = [sides[0].open.len(), sides[1].open.len()];
        waiting = waiting.max(a + b);
        let smaller = usize::from(a == 0 || (b > 0 && b < a));
        if a == 0 && b == 0 {
            break false;
        }
        if budget.is_spent::<f64, State, _>(expanded, progress) {
            break true;
        }
        let [first, second] = &mut sides;
        let (own, other) = if smaller == 0 { (first, &*second) } else { (second, &*first) };
        let Some((id, at)) = own.pop() else { continue };
        expanded += 1;
        if let Some(tree) = tree {
            tree.mirrored = own.mirrored;
            tree.expanded(id, at.state, at.g);
        }
        if let Some(finish) = own.lattice.finish(visit(id, at), best.cost) {
            let mut arcs = own.arcs(id);
            arcs.extend(finish.tail.arcs(driven.radius));
            best.take(if own.mirrored { arcs::reversed(&arcs::merge(arcs)) } else { arcs::merge(arcs) });
        }
        for (there, met) in other.around(at.state) {
            let (own, other) = ((&*own, id, at), (other, there, met));
            if smaller == 0 { best.bridge(own, other) } else { best.bridge(other, own) }
        }
        own.expand(id, at, best.cost);
    };
    report.expanded += expanded;
    let kept =
        sides.iter().map(|s| s.nodes.len() * size_of::<Node>()).sum::<usize>() + waiting * size_of::<Entry>();
    let named: u64 = keys.iter().map(|keys| keys.borrow().bytes()).sum();
    report.bytes = report.bytes.max(kept as u64 + named + floods.iter().map(Flood::bytes).sum::<u64>());
    for side in &sides {
        report.generated += side.generated;
        report.pushes += side.pushes;
    }
    if best.cost.is_finite() {
        return Some((best.arcs, if spent { Status::Suboptimal } else { Status::Found }));
    }
    let apart = (search.goal.point() - search.start.point()).norm();
    report.status = if spent { Status::BudgetExhausted(apart) } else { Status::NoPath };
    None
}
