//! Searches along a line of nodes, down to the last counter; a bidirectional one on random graphs, against Dijkstra's.

use super::lattice::{
    Deferral, Deferring, Edge, EdgeSink, Found, Lattice, Reversible, one_way, one_way_deferring,
};
use super::{
    Domain, End, Finish, Join, Limits, NodeId, Observer, PackedScratch, Relax, Scratch, Stop, Summary, Tree,
    Trees, Visit, WideEntry, bidirectional, bidirectional_best_first,
};

/// Nodes 0 to 9 with steps of cost 1 up (number 0) and down (number 1). With `HOLDS`, steps down are held back.
struct Line<const JUMPS: bool, const HOLDS: bool> {
    ends: (NodeId, NodeId),
    deferral: Deferral,
    /// A node from which the goal is reached for this cost.
    direct: Option<(NodeId, i64)>,
}

const NODES: u32 = 10;
const PAYLOAD: u32 = 5;

impl<const JUMPS: bool, const HOLDS: bool> Line<JUMPS, HOLDS> {
    const fn new(start: NodeId, goal: NodeId) -> Self {
        Self { ends: (start, goal), deferral: Deferral::IfStuck, direct: None }
    }

    fn offer<S: EdgeSink>(to: NodeId, number: u32, h: i64, sink: &mut S) {
        if to < NODES && sink.improves(to, 1) {
            sink.relax(Edge::new(number, 1), to, h);
        }
    }

    fn down<S: EdgeSink>(&self, node: NodeId, sink: &mut S) {
        let down = node.wrapping_sub(1);
        Self::offer(down, 1, self.to_goal(down), sink);
    }

    fn one_way(&self, expansions: u32) -> Found {
        let search = if HOLDS { one_way_deferring } else { one_way };
        search(self, self.ends, expansions, &mut PackedScratch::default(), &mut ())
    }
}

impl<const JUMPS: bool, const HOLDS: bool> Lattice for Line<JUMPS, HOLDS> {
    type Entry = WideEntry;
    const JUMPS: bool = JUMPS;

    fn node_count(&self) -> usize {
        NODES as usize
    }
    fn padding(&self) -> usize {
        3
    }
    fn successors<S: EdgeSink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        Self::offer(node + 1, 0, self.to_goal(node + 1), sink);
        if !HOLDS {
            self.down(node, sink);
        }
    }
    fn direct(&self, node: NodeId) -> Option<i64> {
        self.direct.filter(|direct| direct.0 == node).map(|direct| direct.1)
    }
    fn before(&self, node: NodeId, number: u32) -> NodeId {
        assert!(!JUMPS, "where moves do not tell, parents do");
        [node.wrapping_sub(1), node + 1][number as usize]
    }
    fn to_goal(&self, node: NodeId) -> i64 {
        i64::from(node.abs_diff(self.ends.1))
    }
}

impl<const JUMPS: bool, const HOLDS: bool> Deferring for Line<JUMPS, HOLDS> {
    fn deferred_successors<S: EdgeSink>(&self, node: NodeId, payload: u32, sink: &mut S) {
        assert_eq!(payload, PAYLOAD);
        self.down(node, sink);
    }
    fn deferred_at_once<S: EdgeSink>(&self, node: NodeId, sink: &mut S) {
        self.down(node, sink);
    }
    fn payload(&self) -> u32 {
        PAYLOAD
    }
    fn deferral(&self) -> Deferral {
        self.deferral
    }
}

impl<const JUMPS: bool, const HOLDS: bool> Reversible for Line<JUMPS, HOLDS> {
    fn predecessors<S: EdgeSink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        Self::offer(node.wrapping_sub(1), 0, self.to_start(node.wrapping_sub(1)), sink);
        Self::offer(node + 1, 1, self.to_start(node + 1), sink);
    }
    fn after(&self, node: NodeId, number: u32) -> NodeId {
        self.before(node, 1 - number)
    }
    fn to_start(&self, node: NodeId) -> i64 {
        i64::from(node.abs_diff(self.ends.0))
    }
}

/// Records of all nodes and of three more on either side, eight bytes for each side that searches.
const RECORDS: u64 = 16 * 8;
const ENTRY: u64 = size_of::<WideEntry>() as u64;

#[test]
fn one_side_counts_what_it_does() {
    let found = Line::<false, false>::new(2, 5).one_way(100);
    let want = Found {
        end: End::Found,
        cost: 3,
        nodes: vec![2, 3, 4, 5],
        expanded: 4,
        // 2, 3 and 1, 4, 5.
        generated: 5,
        pushes: 5,
        deferred: 0,
        rejected: 0,
        open_peak: 2,
        closest: 5,
        bytes: RECORDS + 2 * ENTRY,
    };
    assert_eq!(found, want);
    let jumps = Line::<true, false>::new(2, 5).one_way(100);
    assert_eq!(jumps, Found { bytes: want.bytes + u64::from(NODES) * 4, ..want });
}

#[test]
fn a_budget_ends_a_search_where_it_is() {
    for (budget, end, closest) in [(3, End::BudgetSpent, 4), (4, End::Found, 5)] {
        let found = Line::<false, false>::new(2, 5).one_way(budget);
        assert_eq!((found.end, found.expanded, found.closest), (end, budget, closest));
    }
    let line = Line::<false, false>::new(2, 5);
    for stop in [Stop::First, Stop::Best, Stop::Optimal, Stop::Naive] {
        let found = bidirectional(&line, line.ends, stop, 2, &mut PackedScratch::default(), &mut ());
        assert_eq!((found.end, found.expanded, found.nodes.len()), (End::BudgetSpent, 2, 0));
    }
}

#[test]
fn a_shot_completes_the_path() {
    let line = Line::<false, false> { direct: Some((3, 7)), ..Line::new(2, 5) };
    let found = line.one_way(100);
    assert_eq!((found.end, found.cost, &found.nodes[..]), (End::Found, 8, &[2, 3, 5][..]));
    // The goal was not reached before, and counts.
    assert_eq!((found.expanded, found.generated, found.pushes), (2, 4, 3));
}

#[test]
fn moves_that_are_held_back_wait() {
    let found =
        |deferral, start, goal| Line::<false, true> { deferral, ..Line::new(start, goal) }.one_way(100);
    // Up to the end, where the way is stuck, and no step down from there improves anything.
    let counts = |found: &Found| (found.end, found.expanded, found.generated, found.pushes, found.deferred);
    assert_eq!(counts(&found(Deferral::Never, 7, 5)), (End::Exhausted, 3, 3, 3, 0));
    assert_eq!(counts(&found(Deferral::IfStuck, 7, 5)), (End::Exhausted, 3, 3, 3, 1));
    assert_eq!(counts(&found(Deferral::IfStuck, 9, 5)), (End::Found, 5, 5, 5, 4));
    // Put back by 1, the step down from 7 comes before the second step up; 6 has a step up that improves nothing.
    let late = found(Deferral::Penalty(1), 7, 5);
    assert_eq!((late.nodes, late.cost), (vec![7, 6, 5], 2));
    assert_eq!((late.expanded, late.generated, late.pushes, late.deferred), (4, 4, 5, 2));
    // Put back by 4, it comes before the node 9 by its smaller h.
    let tie = found(Deferral::Penalty(4), 7, 5);
    assert_eq!((tie.cost, tie.expanded, tie.generated, tie.pushes, tie.deferred), (2, 5, 5, 7, 2));
    // Put back by 5, it comes after that one, which is stuck.
    let later = found(Deferral::Penalty(5), 7, 5);
    assert_eq!((later.cost, later.expanded, later.generated, later.pushes, later.deferred), (2, 6, 5, 7, 3));
}

#[test]
fn two_sides_count_what_they_do() {
    let line = Line::<false, false>::new(2, 7);
    let found = |stop| bidirectional(&line, line.ends, stop, 100, &mut PackedScratch::default(), &mut ());
    let want = Found {
        end: End::Found,
        cost: 5,
        nodes: vec![2, 3, 4, 5, 6, 7],
        // 2, 3, 4 and 7, 6, 5; then 5, where they meet.
        expanded: 7,
        // From either end, that and the five that one comes to from three.
        generated: 10,
        pushes: 10,
        deferred: 0,
        rejected: 0,
        open_peak: 4,
        closest: 4,
        bytes: 2 * RECORDS + 4 * ENTRY,
    };
    assert_eq!(found(Stop::First), want);
    assert_eq!(found(Stop::Best), want);
    // On a line they cannot pass each other.
    assert_eq!(found(Stop::Naive), want);
    // 4 and 6 have met at 5 by then, and nothing is cheaper.
    let want = Found { expanded: 5, generated: 9, pushes: 9, rejected: 1, ..want };
    assert_eq!(found(Stop::Optimal), want);
}

#[test]
fn a_memory_serves_more_searches_than_it_has_generations() {
    let mut memory = PackedScratch::default();
    for k in 0..5000 {
        let line = Line::<false, false>::new(k % NODES, k * 7 % NODES);
        let found = one_way(&line, line.ends, 100, &mut memory, &mut ());
        assert_eq!((found.end, found.cost), (End::Found, i64::from(line.ends.0.abs_diff(line.ends.1))));
        assert_eq!(
            found.generated,
            Line::<false, false>::new(line.ends.0, line.ends.1).one_way(100).generated
        );
    }
}

#[test]
fn a_leg_at_another_cost_is_the_same_move() {
    let (edge, other) = (Edge::new(200, 5).at(1 << 40), Edge::new(200, 1 << 40));
    assert_eq!((edge.cost, edge.code), (other.cost, other.code));
}

/// A directed graph as one of two trees sees it.
struct Graph {
    /// From each node: where to, and the cost.
    edges: Vec<Vec<(NodeId, i64)>>,
    /// Less than the cost to the other root, and consistent.
    estimates: Vec<i64>,
    /// True if a path ends where the tree reaches the other root, or only where the trees meet.
    completes: bool,
    target: NodeId,
}

impl Domain for Graph {
    type Cost = i64;
    type Label = ();
    type Tail = ();

    fn node_count(&self) -> usize {
        self.edges.len()
    }
    fn successors<S: Relax<i64, ()>>(&self, from: Visit<i64, ()>, sink: &mut S) {
        for &(to, cost) in &self.edges[from.node as usize] {
            sink.emit(to, cost, ());
        }
    }
    fn heuristic(&self, node: NodeId, (): ()) -> i64 {
        self.estimates[node as usize]
    }
    fn finish(&mut self, at: Visit<i64, ()>, _: i64) -> Option<Finish<i64, ()>> {
        (self.completes && at.node == self.target).then_some(Finish { cost: 0, tail: () })
    }
}

/// Joins two trees at the nodes that both have reached.
struct Meeting {
    best: i64,
    nodes: Vec<NodeId>,
}

impl Meeting {
    fn new() -> Self {
        Self { best: i64::MAX, nodes: Vec::new() }
    }

    fn keep(&mut self, cost: i64, nodes: impl Iterator<Item = NodeId>) {
        if cost < self.best {
            (self.best, self.nodes) = (cost, nodes.collect());
        }
    }
}

impl Join<Graph> for Meeting {
    fn best(&self) -> i64 {
        self.best
    }
    fn complete(&mut self, trees: Trees<Graph>, side: usize, at: Visit<i64, ()>, finish: Finish<i64, ()>) {
        let chain = trees[side].chain(at.node);
        let nodes = chain.iter().map(|&(node, ())| node);
        let cost = at.g + finish.cost;
        if side == 0 { self.keep(cost, nodes) } else { self.keep(cost, nodes.rev()) }
    }
    fn join(&mut self, trees: Trees<Graph>, side: usize, at: Visit<i64, ()>) {
        if let Some(met) = trees[1 - side].reached(at.node) {
            let [there, back] = [0, 1].map(|tree: usize| trees[tree].chain(at.node));
            let nodes = there.iter().chain(back.iter().rev().skip(1));
            self.keep(at.g + met.g, nodes.map(|&(node, ())| node));
        }
    }
}

/// The costs from a node to all others, as Dijkstra's search finds them.
fn distances(edges: &[Vec<(NodeId, i64)>], root: NodeId) -> Vec<i64> {
    let mut least = vec![i64::MAX; edges.len()];
    least[root as usize] = 0;
    let mut open: Vec<NodeId> = (0..edges.len() as NodeId).collect();
    while let Some(at) = (0..open.len()).min_by_key(|&at| least[open[at] as usize]) {
        let node = open.swap_remove(at) as usize;
        let g = least[node];
        for &(to, cost) in &edges[node] {
            least[to as usize] = least[to as usize].min(g.saturating_add(cost));
        }
    }
    least
}

/// Edges there and back between nodes by seed, of costs that depend on the direction.
fn random_edges(seed: u64) -> [Vec<Vec<(NodeId, i64)>>; 2] {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + 1;
    let mut random = |n: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 33) % n
    };
    let count = 2 + random(40);
    let mut edges = [0, 1].map(|_| vec![Vec::new(); count as usize]);
    for _ in 0..count * (1 + random(4)) {
        let (from, to, cost) = (random(count), random(count), 1 + random(9) as i64);
        edges[0][from as usize].push((to as NodeId, cost));
        edges[1][to as usize].push((from as NodeId, cost));
    }
    edges
}

/// Searches from the first node to the last one. The estimates are so many quarters of the costs.
fn meet(seed: u64, quarters: i64, completes: bool, limits: Limits) -> (Summary, Meeting, i64) {
    let edges = random_edges(seed);
    let ends = [0, edges[0].len() as NodeId - 1];
    let costs = [distances(&edges[1], ends[1]), distances(&edges[0], ends[0])];
    let best = costs[0][ends[0] as usize];
    let graph = |side: usize| Graph {
        edges: edges[side].clone(),
        estimates: costs[side].iter().map(|&c| if c < i64::MAX { c * quarters / 4 } else { c }).collect(),
        completes,
        target: ends[1 - side],
    };
    let (mut first, mut second) = (graph(0), graph(1));
    let (mut memory, mut other) = (Scratch::new(), Scratch::new());
    let mut trees = [
        Tree::new(&mut first, (ends[0], ()), &mut memory),
        Tree::new(&mut second, (ends[1], ()), &mut other),
    ];
    let mut meeting = Meeting::new();
    let summary = bidirectional_best_first(&mut trees, limits, &mut meeting, &mut ());
    let cost = |pair: &[NodeId]| {
        let between = edges[0][pair[0] as usize].iter().filter(|edge| edge.0 == pair[1]);
        between.map(|edge| edge.1).min().expect("an edge of the graph")
    };
    if let [first, .., last] | [first @ last] = meeting.nodes[..] {
        assert_eq!([first, last], ends);
        assert_eq!(meeting.nodes.windows(2).map(cost).sum::<i64>(), meeting.best, "seed {seed}");
    }
    (summary, meeting, best)
}

const ALL: Limits = Limits { max_expansions: 1000, first: false };

#[test]
fn two_trees_meet_on_the_cheapest_path() {
    let (mut joined, mut none) = (0, 0);
    for (seed, quarters) in (0..400).flat_map(|seed| [0, 2, 3, 4].map(|quarters| (seed, quarters))) {
        for completes in [false, true] {
            let (summary, meeting, best) = meet(seed, quarters, completes, ALL);
            let end = if best < i64::MAX { End::Found } else { End::Exhausted };
            assert_eq!((meeting.best, summary.end), (best, end), "seed {seed}, {quarters}, {completes}");
            assert!(summary.expanded <= summary.generated && summary.generated <= summary.pushes);
            joined += u32::from(best < i64::MAX);
            none += u32::from(best == i64::MAX);
        }
    }
    assert!(joined > 1000 && none > 100, "{joined} {none}");
}

#[test]
fn two_trees_stop_at_their_budget_or_the_first_path() {
    let mut dearer = 0;
    for seed in 0..200 {
        let (all, _, best) = meet(seed, 0, true, ALL);
        let (first, meeting, _) = meet(seed, 0, true, Limits { first: true, ..ALL });
        assert_eq!((first.end, meeting.best < i64::MAX), (all.end, best < i64::MAX), "seed {seed}");
        assert!(first.expanded <= all.expanded && meeting.best >= best, "seed {seed}");
        dearer += u32::from(meeting.best > best);
        for most in [0, 1, all.expanded - 1].into_iter().filter(|&most| most < all.expanded) {
            let (cut, ..) = meet(seed, 0, true, Limits { max_expansions: most, first: false });
            assert_eq!((cut.end, cut.expanded), (End::BudgetSpent, most), "seed {seed}");
        }
    }
    assert!(dearer > 10, "{dearer}");
}

/// All that is expanded, and in which tree.
#[derive(Default)]
struct Told {
    side: usize,
    expanded: Vec<(usize, NodeId)>,
}

impl Observer<i64, ()> for Told {
    fn side(&mut self, side: usize) {
        self.side = side;
    }
    fn expanded(&mut self, node: NodeId, (): (), _: i64) {
        self.expanded.push((self.side, node));
    }
}

#[test]
fn the_tree_with_fewer_waiting_nodes_grows_and_its_observer_knows_which() {
    // From 0 to 3 by 1 or 2.
    let edges = [[vec![1, 2], vec![3], vec![3], vec![]], [vec![], vec![0], vec![0], vec![1, 2]]];
    let graph = |side: usize| Graph {
        edges: edges[side].iter().map(|to| to.iter().map(|&to| (to, 1)).collect()).collect(),
        estimates: vec![0; 4],
        completes: false,
        target: 3,
    };
    let (mut first, mut second) = (graph(0), graph(1));
    let (mut memory, mut other) = (Scratch::new(), Scratch::new());
    let mut trees =
        [Tree::new(&mut first, (0, ()), &mut memory), Tree::new(&mut second, (3, ()), &mut other)];
    let (mut told, mut meeting) = (Told::default(), Meeting::new());
    let mut observers = ((), Some(&mut told));
    let summary = bidirectional_best_first(&mut trees, ALL, &mut meeting, &mut observers);
    assert_eq!((meeting.best, meeting.nodes), (2, vec![0, 2, 3]));
    assert_eq!(told.expanded, [(0, 0), (1, 3), (0, 2), (0, 1)]);
    let want = Summary { end: End::Found, expanded: 4, generated: 6, pushes: 6, open_peak: 4 };
    assert_eq!(summary, want);
}
