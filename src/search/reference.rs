//! The searches as one writes them down, with open lists that are looked through: what the fast ones do is the same,
//! down to the last counter.
//!
//! The packed searches owe their speed to things that can go wrong silently: 64-bit records, buckets, generation
//! stamps, eight comparisons at once. Here is none of that. The graph is a torus of 144 nodes whose moves cost
//! differently in each direction, so that a search from the goal that charges the wrong one is noticed; costs are
//! drawn so that ties are either frequent or rare, and some edges are missing.
//!
//! Compared are the end, the cost, the nodes of the path and all counters, for one side and for every stopping rule
//! of both.

use std::cmp::Reverse;
use std::marker::PhantomData;

use super::bidirectional::{Stop, bidirectional};
use super::entry::{Entry, PackedEntry, WideEntry};
use super::lattice::{Edge, EdgeSink, Lattice, Reversible};
use super::{End, NodeId, PackedScratch};
use super::{Found, one_way};

const SIDE: u32 = 12;
const NODES: usize = (SIDE * SIDE) as usize;
/// Farther than any path.
const FAR: i64 = 1 << 40;

/// A torus of nodes with four moves whose costs depend on where they begin: against the direction of a move, its
/// cost is another one. A cost of 0 is no move.
struct Directed<E> {
    costs: Vec<[i64; 4]>,
    to_goal: Vec<i64>,
    to_start: Vec<i64>,
    /// A node from which the goal is reached for this cost.
    direct: Option<(NodeId, i64)>,
    entry: PhantomData<E>,
}

impl<E> Directed<E> {
    fn neighbour(node: NodeId, number: u32) -> NodeId {
        let (x, y) = (node % SIDE, node / SIDE);
        let (dx, dy) = [(1, 0), (0, 1), (SIDE - 1, 0), (0, SIDE - 1)][number as usize];
        (x + dx) % SIDE + (y + dy) % SIDE * SIDE
    }

    /// Moves in the direction of a search, forward or backward: number, where it leads, cost.
    fn moves(&self, turn: usize, node: NodeId) -> impl Iterator<Item = (u32, NodeId, i64)> {
        let moves = (0..4).map(move |number| {
            let to = Self::neighbour(node, if turn == 0 { number } else { (number + 2) % 4 });
            (number, to, self.costs[[node, to][turn] as usize][number as usize])
        });
        moves.filter(|way| way.2 > 0)
    }

    fn estimate(&self, turn: usize, node: NodeId) -> i64 {
        [&self.to_goal, &self.to_start][turn][node as usize]
    }

    /// The cost of the cheapest way from each node to the root of a side.
    fn distances(&self, turn: usize, root: NodeId) -> Vec<i64> {
        let mut least = vec![FAR; NODES];
        least[root as usize] = 0;
        for _ in 0..NODES {
            for node in 0..NODES as u32 {
                for (_, to, cost) in self.moves(turn, node) {
                    least[to as usize] = least[to as usize].min((least[node as usize] + cost).min(FAR));
                }
            }
        }
        least
    }

    fn rest(&self, node: NodeId) -> Option<i64> {
        self.direct.filter(|direct| direct.0 == node).map(|direct| direct.1)
    }

    /// Neighbours are worth it together as they are one by one.
    fn compare_worth(&self, node: NodeId, sink: &impl EdgeSink) {
        if [node % SIDE, node / SIDE].iter().any(|at| !(1..SIDE - 1).contains(at)) {
            return;
        }
        let (row, [straight, diagonal, ..]) = (SIDE as usize, self.costs[node as usize]);
        let around = [1, 13, 12, 11, -1, -13, -12, -11].map(|step| node.wrapping_add_signed(step));
        let bits = (0..8).fold(0, |bits, c| {
            let cost = if c % 2 == 0 { straight } else { diagonal };
            bits | u32::from(sink.improves(around[c], cost)) << c
        });
        assert_eq!(sink.improves_around(node, row, straight, diagonal), bits);
        assert_eq!(sink.improves_beside(node, row, straight), bits & 0b0101_0101);
    }

    fn offer(&self, turn: usize, node: NodeId, sink: &mut impl EdgeSink) {
        self.compare_worth(node, sink);
        for (number, to, cost) in self.moves(turn, node) {
            if sink.improves(to, cost) {
                sink.relax(Edge::new(number, cost), to, self.estimate(turn, to));
            }
        }
    }
}

impl<E: Entry> Lattice for Directed<E> {
    type Entry = E;

    fn node_count(&self) -> usize {
        NODES
    }
    fn successors<S: EdgeSink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        self.offer(0, node, sink);
    }
    fn before(&self, node: NodeId, number: u32) -> NodeId {
        Self::neighbour(node, (number + 2) % 4)
    }
    fn direct(&self, node: NodeId) -> Option<i64> {
        self.rest(node)
    }
    fn to_goal(&self, node: NodeId) -> i64 {
        self.estimate(0, node)
    }
}

impl<E: Entry> Reversible for Directed<E> {
    fn predecessors<S: EdgeSink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        self.offer(1, node, sink);
    }
    fn after(&self, node: NodeId, number: u32) -> NodeId {
        Self::neighbour(node, number)
    }
    fn to_start(&self, node: NodeId) -> i64 {
        self.estimate(1, node)
    }
}

/// A side of a plain search: f, h and number of what is open, and what is known of each node.
struct Plain {
    open: Vec<(i64, i64, u32, NodeId)>,
    known: Vec<Option<(i64, NodeId)>>,
    closed: Vec<bool>,
    generated: u32,
    pushes: u32,
    peak: usize,
}

impl Plain {
    fn new(root: NodeId, h: i64) -> Self {
        let (known, closed) = (vec![None; NODES], vec![false; NODES]);
        let mut side = Self { open: Vec::new(), known, closed, generated: 0, pushes: 0, peak: 0 };
        side.reach(root, root, 0, h);
        side
    }

    fn g(&self, node: NodeId) -> Option<i64> {
        self.known[node as usize].map(|known| known.0)
    }

    /// Takes a way to a node if it is a better one.
    fn reach(&mut self, from: NodeId, node: NodeId, g: i64, h: i64) -> bool {
        let known = self.g(node);
        let better = !self.closed[node as usize] && known.is_none_or(|known| g < known);
        if better {
            self.generated += u32::from(known.is_none());
            self.known[node as usize] = Some((g, from));
            self.open.push((g + h, h, self.pushes, node));
            self.pushes += 1;
            self.peak = self.peak.max(self.open.len());
        }
        better
    }

    /// The first open node by f, then h, then the newest: f, h, node.
    fn pop(&mut self) -> Option<(i64, i64, NodeId)> {
        loop {
            let order = |&(f, h, number, _): &(i64, i64, u32, NodeId)| (f, h, Reverse(number));
            let (first, _) = self.open.iter().enumerate().min_by_key(|(_, entry)| order(entry))?;
            let (f, h, _, node) = self.open.swap_remove(first);
            if !self.closed[node as usize] {
                return Some((f, h, node));
            }
        }
    }

    /// The way from a node back to the root.
    fn chain(&self, mut node: NodeId) -> Vec<NodeId> {
        let mut chain = vec![node];
        while let Some((_, from)) = self.known[node as usize].filter(|known| known.1 != node) {
            chain.push(from);
            node = from;
        }
        chain
    }
}

fn count<E>(found: &mut Found, sides: &[Plain]) {
    found.stats.generated = sides.iter().map(|side| side.generated).sum();
    found.stats.pushes = sides.iter().map(|side| side.pushes).sum();
    found.stats.open_peak = sides.iter().map(|side| side.peak as u32).sum();
    found.stats.bytes = (sides.len() * NODES * 8 + found.stats.open_peak as usize * size_of::<E>()) as u64;
}

/// A search from one end whose open list is a vector that is looked through for its best entry: O(n²), and hard to get
/// wrong.
fn plain_one_way<E>(graph: &Directed<E>, (start, goal): (NodeId, NodeId)) -> Found {
    let mut found = Found::nothing(start);
    let mut nearest = graph.estimate(0, start);
    let mut side = Plain::new(start, nearest);
    while let Some((_, h, node)) = side.pop() {
        side.closed[node as usize] = true;
        found.stats.expanded += 1;
        if h < nearest {
            (nearest, found.closest) = (h, node);
        }
        let g = side.g(node).unwrap();
        let rest = if node == goal { Some(0) } else { graph.rest(node) };
        if let Some(rest) = rest {
            (found.end, found.cost, found.nodes) = (End::Found, g + rest, side.chain(node));
            found.nodes.reverse();
            if node != goal {
                found.nodes.push(goal);
                side.generated += u32::from(side.g(goal).is_none());
            }
            break;
        }
        for (_, to, cost) in graph.moves(0, node) {
            side.reach(node, to, g + cost, graph.estimate(0, to));
        }
    }
    count::<E>(&mut found, &[side]);
    found
}

/// With [`Stop::Optimal`] the algorithm of Pijls and Post (2009).
fn plain_both_ways<E>(graph: &Directed<E>, (start, goal): (NodeId, NodeId), stop: Stop) -> Found {
    let rejected = (stop == Stop::Optimal).then_some(0);
    let mut found = Found { rejected, ..Found::nothing(start) };
    let far = graph.estimate(0, start);
    let mut sides = [Plain::new(start, far), Plain::new(goal, far)];
    let (mut best, mut nearest, mut last) = ((i64::MAX, start), far, [far; 2]);
    let mut current = [start, goal];
    for turn in [0, 1].into_iter().cycle() {
        let Some((f, h, node)) = sides[turn].pop() else { break };
        let g = sides[turn].g(node).unwrap();
        sides[turn].closed[node as usize] = true;
        if stop == Stop::Optimal {
            last[turn] = f;
            sides[1 - turn].closed[node as usize] = true;
            let back = graph.estimate(1 - turn, node);
            if best.0 < i64::MAX && (f >= best.0 || g + last[1 - turn] - back >= best.0) {
                *found.rejected.get_or_insert_default() += 1;
                if f >= best.0 {
                    break;
                }
                continue;
            }
        }
        current[turn] = node;
        let meets = match stop {
            Stop::Optimal => false,
            Stop::Naive => current[0] == current[1],
            Stop::First | Stop::Best => sides[1 - turn].closed[node as usize],
        };
        if meets {
            found.stats.expanded += 1;
            if stop != Stop::Best {
                best = (g + sides[1 - turn].g(node).unwrap(), node);
            }
            break;
        }
        found.stats.expanded += 1;
        if turn == 0 && h < nearest {
            (nearest, found.closest) = (h, node);
        }
        for (_, to, cost) in graph.moves(turn, node) {
            if sides[turn].reach(node, to, g + cost, graph.estimate(turn, to))
                && (stop == Stop::Best || stop == Stop::Optimal)
                && let Some(there) = sides[1 - turn].g(to)
                && g + cost + there < best.0
            {
                best = (g + cost + there, to);
            }
        }
    }
    if best.0 < i64::MAX {
        (found.end, found.cost, found.nodes) = (End::Found, best.0, sides[0].chain(best.1));
        found.nodes.reverse();
        found.nodes.extend(&sides[1].chain(best.1)[1..]);
    }
    count::<E>(&mut found, &sides);
    found
}

#[test]
fn searches_do_what_plain_ones_do() {
    compare::<PackedEntry>();
    compare::<WideEntry>();
}

/// Random graphs, one with many ties, one with few, one with missing edges: the packed searches must answer, count and
/// break ties as the plain ones do. Random numbers are a linear congruence, so that a failure comes back.
fn compare<E: Entry>() {
    let mut state = 5_u64;
    let mut random = move |n: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 33) % n
    };
    let (mut memory, mut rejected, mut dearer, mut tails, mut closed, mut missed) =
        (PackedScratch::default(), 0, 0, 0, 0, 0);
    for round in 0..150 {
        // Many ties, or hardly any.
        let (kinds, unit) = [(3, 1), (9, 700), (1_000_000, 1)][round % 3];
        let holes = round % 5 == 4;
        let node =
            |_| [0; 4].map(|_| if holes && random(3) > 0 { 0 } else { 1 + random(kinds) as i64 } * unit);
        let costs = (0..NODES).map(node).collect();
        let ends = (random(NODES as u64) as u32, random(NODES as u64) as u32);
        if ends.0 == ends.1 {
            continue;
        }
        let (to_goal, to_start) = (Vec::new(), Vec::new());
        let mut graph = Directed::<E> { costs, to_goal, to_start, direct: None, entry: PhantomData };
        let exact = [graph.distances(1, ends.1), graph.distances(0, ends.0)];
        // From no estimate to one that is exact.
        let share = [0, 1, 3, 4][round / 3 % 4];
        let estimate = |distances: &Vec<i64>| distances.iter().map(|d| d * share / 4).collect();
        (graph.to_goal, graph.to_start) = (estimate(&exact[0]), estimate(&exact[1]));
        let cheapest = exact[0][ends.0 as usize];
        let one = one_way(&graph, ends, 1000, &mut memory, &mut ());
        assert_eq!(one, plain_one_way(&graph, ends), "round {round}");
        assert_eq!(
            (one.end, one.cost),
            if cheapest < FAR { (End::Found, cheapest) } else { (End::Exhausted, 0) }
        );
        for stop in [Stop::First, Stop::Best, Stop::Optimal, Stop::Naive] {
            let both = bidirectional(&graph, ends, stop, 1000, &mut memory, &mut ());
            assert_eq!(both, plain_both_ways(&graph, ends, stop), "round {round} {stop:?}");
            if cheapest == FAR {
                closed += 1;
                continue;
            }
            if stop == Stop::Naive && both.end == End::Exhausted {
                missed += 1;
                continue;
            }
            assert_eq!((both.nodes.first(), both.nodes.last()), (Some(&ends.0), Some(&ends.1)));
            // The cheapest of the moves that join two nodes is the one that a cheapest path takes.
            let step = |pair: &[NodeId]| {
                let moves = graph.moves(0, pair[0]).filter(|way| way.1 == pair[1]);
                moves.map(|way| way.2).min().unwrap()
            };
            assert_eq!(both.nodes.windows(2).map(step).sum::<i64>(), both.cost);
            assert!(both.cost >= cheapest && (stop != Stop::Optimal || both.cost == cheapest));
            dearer += u32::from(both.cost > cheapest);
            rejected += both.rejected.unwrap_or_default();
        }
        // Estimates that are no lower bounds: an entry may come before all that were popped.
        let mut wrong = |_: &i64| random(4 * kinds) as i64 * unit;
        graph.to_goal = exact[0].iter().map(&mut wrong).collect();
        graph.direct = Some((random(NODES as u64) as u32, 1));
        let one = one_way(&graph, ends, 1000, &mut memory, &mut ());
        assert_eq!(one, plain_one_way(&graph, ends), "round {round}");
        tails += u32::from(one.nodes.len() > 1 && graph.rest(one.nodes[one.nodes.len() - 2]).is_some());
    }
    assert!(rejected > 100 && dearer > 0, "{rejected} {dearer}");
    assert!(tails > 10 && closed > 10 && missed > 0, "{tails} {closed} {missed}");
}
