//! Searches along a line of nodes, down to the last counter.

use super::lattice::{Deferral, Deferring, Edge, EdgeSink, Lattice, Reversible};
use super::{
    End, Found, NodeId, PackedScratch, SearchStats, Stop, WideEntry, bidirectional, one_way,
    one_way_deferring,
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
        // 2, 3 and 1, 4, 5.
        stats: SearchStats { expanded: 4, generated: 5, pushes: 5, open_peak: 2, bytes: RECORDS + 2 * ENTRY },
        deferred: 0,
        rejected: None,
        closest: 5,
    };
    assert_eq!(found, want);
    let jumps = Line::<true, false>::new(2, 5).one_way(100);
    let stats = SearchStats { bytes: want.stats.bytes + u64::from(NODES) * 4, ..want.stats };
    assert_eq!(jumps, Found { stats, ..want });
}

#[test]
fn a_budget_ends_a_search_where_it_is() {
    for (budget, end, closest) in [(3, End::BudgetSpent, 4), (4, End::Found, 5)] {
        let found = Line::<false, false>::new(2, 5).one_way(budget);
        assert_eq!((found.end, found.stats.expanded, found.closest), (end, budget, closest));
    }
    let line = Line::<false, false>::new(2, 5);
    for stop in [Stop::First, Stop::Best, Stop::Optimal, Stop::Naive] {
        let found = bidirectional(&line, line.ends, stop, 2, &mut PackedScratch::default(), &mut ());
        assert_eq!((found.end, found.stats.expanded, found.nodes.len()), (End::BudgetSpent, 2, 0));
    }
}

#[test]
fn a_shot_completes_the_path() {
    let line = Line::<false, false> { direct: Some((3, 7)), ..Line::new(2, 5) };
    let found = line.one_way(100);
    assert_eq!((found.end, found.cost, &found.nodes[..]), (End::Found, 8, &[2, 3, 5][..]));
    // The goal was not reached before, and counts.
    assert_eq!((found.stats.expanded, found.stats.generated, found.stats.pushes), (2, 4, 3));
}

#[test]
fn moves_that_are_held_back_wait() {
    let found =
        |deferral, start, goal| Line::<false, true> { deferral, ..Line::new(start, goal) }.one_way(100);
    // Up to the end, where the way is stuck, and no step down from there improves anything.
    let counts = |found: &Found| {
        (found.end, found.stats.expanded, found.stats.generated, found.stats.pushes, found.deferred)
    };
    assert_eq!(counts(&found(Deferral::Never, 7, 5)), (End::Exhausted, 3, 3, 3, 0));
    assert_eq!(counts(&found(Deferral::IfStuck, 7, 5)), (End::Exhausted, 3, 3, 3, 1));
    assert_eq!(counts(&found(Deferral::IfStuck, 9, 5)), (End::Found, 5, 5, 5, 4));
    // Put back by 1, the step down from 7 comes before the second step up; 6 has a step up that improves nothing.
    let late = found(Deferral::Penalty(1), 7, 5);
    assert_eq!((late.nodes, late.cost), (vec![7, 6, 5], 2));
    assert_eq!((late.stats.expanded, late.stats.generated, late.stats.pushes, late.deferred), (4, 4, 5, 2));
    // Put back by 4, it comes before the node 9 by its smaller h.
    let tie = found(Deferral::Penalty(4), 7, 5);
    assert_eq!(
        (tie.cost, tie.stats.expanded, tie.stats.generated, tie.stats.pushes, tie.deferred),
        (2, 5, 5, 7, 2)
    );
    // Put back by 5, it comes after that one, which is stuck.
    let later = found(Deferral::Penalty(5), 7, 5);
    assert_eq!(
        (later.cost, later.stats.expanded, later.stats.generated, later.stats.pushes, later.deferred),
        (2, 6, 5, 7, 3)
    );
}

#[test]
fn two_sides_count_what_they_do() {
    let line = Line::<false, false>::new(2, 7);
    let found = |stop| bidirectional(&line, line.ends, stop, 100, &mut PackedScratch::default(), &mut ());
    let want = Found {
        end: End::Found,
        cost: 5,
        nodes: vec![2, 3, 4, 5, 6, 7],
        // Expanded are 2, 3, 4 and 7, 6, 5; then 5, where they meet. From either end, that and the five that one comes
        // to from three.
        stats: SearchStats {
            expanded: 7,
            generated: 10,
            pushes: 10,
            open_peak: 4,
            bytes: 2 * RECORDS + 4 * ENTRY,
        },
        deferred: 0,
        rejected: None,
        closest: 4,
    };
    assert_eq!(found(Stop::First), want);
    assert_eq!(found(Stop::Best), want);
    // On a line they cannot pass each other.
    assert_eq!(found(Stop::Naive), want);
    // 4 and 6 have met at 5 by then, and nothing is cheaper.
    let stats = SearchStats { expanded: 5, generated: 9, pushes: 9, ..want.stats };
    let want = Found { stats, rejected: Some(1), ..want };
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
            found.stats.generated,
            Line::<false, false>::new(line.ends.0, line.ends.1).one_way(100).stats.generated
        );
    }
}

#[test]
fn a_leg_at_another_cost_is_the_same_move() {
    let (edge, other) = (Edge::new(200, 5).at(1 << 40), Edge::new(200, 1 << 40));
    assert_eq!((edge.cost, edge.code), (other.cost, other.code));
}
