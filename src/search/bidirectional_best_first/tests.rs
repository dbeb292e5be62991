//! The search with two trees on random graphs, against Dijkstra's.

use super::super::{
    Domain, End, Finish, Join, Limits, NodeId, Observer, Relax, Scratch, SearchStats, Summary, Tree, Trees,
    Visit, bidirectional_best_first,
};

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
            assert!(
                summary.stats.expanded <= summary.stats.generated
                    && summary.stats.generated <= summary.stats.pushes
            );
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
        assert!(first.stats.expanded <= all.stats.expanded && meeting.best >= best, "seed {seed}");
        dearer += u32::from(meeting.best > best);
        for most in [0, 1, all.stats.expanded - 1].into_iter().filter(|&most| most < all.stats.expanded) {
            let (cut, ..) = meet(seed, 0, true, Limits { max_expansions: most, first: false });
            assert_eq!((cut.end, cut.stats.expanded), (End::BudgetSpent, most), "seed {seed}");
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
    let stats = SearchStats { expanded: 4, generated: 6, pushes: 6, open_peak: 4, bytes: 0 };
    assert_eq!(summary, Summary { end: End::Found, stats });
}
