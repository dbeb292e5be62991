//! Searches along a line of nodes, down to the last counter.

use super::lattice::{Found, Hold, Lattice, Leg, Sink, one_way};
use super::{End, Memory, NodeId, Stop, Wide, both_ways};

/// Nodes 0 to 9 with steps of cost 1 up (number 0) and down (number 1). With `HOLDS`, steps down are held back.
struct Line<const JUMPS: bool, const HOLDS: bool> {
    ends: (NodeId, NodeId),
    hold: Hold,
    /// A node from which the goal is reached for this cost.
    shot: Option<(NodeId, i64)>,
}

const NODES: u32 = 10;
const NOTE: u32 = 5;

impl<const JUMPS: bool, const HOLDS: bool> Line<JUMPS, HOLDS> {
    const fn new(start: NodeId, goal: NodeId) -> Self {
        Self { ends: (start, goal), hold: Hold::UntilStuck, shot: None }
    }

    fn offer<S: Sink>(to: NodeId, number: u32, h: i64, sink: &mut S) {
        if to < NODES && sink.worth(to, 1) {
            sink.take(Leg::new(number, 1), to, h);
        }
    }

    fn one_way(&self, expansions: u32) -> Found {
        one_way(self, self.ends, expansions, &mut Memory::default(), &mut ())
    }
}

impl<const JUMPS: bool, const HOLDS: bool> Lattice for Line<JUMPS, HOLDS> {
    type Entry = Wide;
    const JUMPS: bool = JUMPS;
    const HOLDS_BACK: bool = HOLDS;

    fn node_count(&self) -> usize {
        NODES as usize
    }
    fn rim(&self) -> usize {
        3
    }
    fn successors<S: Sink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        Self::offer(node + 1, 0, self.to_goal(node + 1), sink);
        if !HOLDS {
            self.held_back_at_once(node, sink);
        }
    }
    fn predecessors<S: Sink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        Self::offer(node.wrapping_sub(1), 0, self.to_start(node.wrapping_sub(1)), sink);
        Self::offer(node + 1, 1, self.to_start(node + 1), sink);
    }
    fn held_back<S: Sink>(&self, node: NodeId, note: u32, sink: &mut S) {
        assert_eq!(note, NOTE);
        self.held_back_at_once(node, sink);
    }
    fn held_back_at_once<S: Sink>(&self, node: NodeId, sink: &mut S) {
        let down = node.wrapping_sub(1);
        Self::offer(down, 1, self.to_goal(down), sink);
    }
    fn note(&self) -> u32 {
        NOTE
    }
    fn hold(&self) -> Hold {
        self.hold
    }
    fn shot(&self, node: NodeId) -> Option<i64> {
        self.shot.filter(|shot| shot.0 == node).map(|shot| shot.1)
    }
    fn after(&self, node: NodeId, number: u32) -> NodeId {
        assert!(!JUMPS, "where moves do not tell, parents do");
        [node + 1, node.wrapping_sub(1)][number as usize]
    }
    fn before(&self, node: NodeId, number: u32) -> NodeId {
        self.after(node, 1 - number)
    }
    fn to_goal(&self, node: NodeId) -> i64 {
        i64::from(node.abs_diff(self.ends.1))
    }
    fn to_start(&self, node: NodeId) -> i64 {
        i64::from(node.abs_diff(self.ends.0))
    }
}

/// Records of all nodes and of three more on either side, eight bytes for each side that searches.
const RECORDS: u64 = 16 * 8;
const ENTRY: u64 = size_of::<Wide>() as u64;

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
    for stop in [Stop::First, Stop::Best, Stop::Optimal] {
        let found = both_ways(&line, line.ends, stop, 2, &mut Memory::default(), &mut ());
        assert_eq!((found.end, found.expanded, found.nodes.len()), (End::BudgetSpent, 2, 0));
    }
}

#[test]
fn a_shot_completes_the_path() {
    let line = Line::<false, false> { shot: Some((3, 7)), ..Line::new(2, 5) };
    let found = line.one_way(100);
    assert_eq!((found.end, found.cost, &found.nodes[..]), (End::Found, 8, &[2, 3, 5][..]));
    // The goal was not reached before, and counts.
    assert_eq!((found.expanded, found.generated, found.pushes), (2, 4, 3));
}

#[test]
fn moves_that_are_held_back_wait() {
    let found = |hold, start, goal| Line::<false, true> { hold, ..Line::new(start, goal) }.one_way(100);
    // Up to the end, where the way is stuck, and no step down from there improves anything.
    let counts = |found: &Found| (found.end, found.expanded, found.generated, found.pushes, found.deferred);
    assert_eq!(counts(&found(Hold::Forever, 7, 5)), (End::Exhausted, 3, 3, 3, 0));
    assert_eq!(counts(&found(Hold::UntilStuck, 7, 5)), (End::Exhausted, 3, 3, 3, 1));
    assert_eq!(counts(&found(Hold::UntilStuck, 9, 5)), (End::Found, 5, 5, 5, 4));
    // Put back by 1, the step down from 7 comes before the second step up; 6 has a step up that improves nothing.
    let late = found(Hold::Penalty(1), 7, 5);
    assert_eq!((late.nodes, late.cost), (vec![7, 6, 5], 2));
    assert_eq!((late.expanded, late.generated, late.pushes, late.deferred), (4, 4, 5, 2));
    // Put back by 4, it comes before the node 9 by its smaller h.
    let tie = found(Hold::Penalty(4), 7, 5);
    assert_eq!((tie.cost, tie.expanded, tie.generated, tie.pushes, tie.deferred), (2, 5, 5, 7, 2));
    // Put back by 5, it comes after that one, which is stuck.
    let later = found(Hold::Penalty(5), 7, 5);
    assert_eq!((later.cost, later.expanded, later.generated, later.pushes, later.deferred), (2, 6, 5, 7, 3));
}

#[test]
fn two_sides_count_what_they_do() {
    let line = Line::<false, false>::new(2, 7);
    let found = |stop| both_ways(&line, line.ends, stop, 100, &mut Memory::default(), &mut ());
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
    // 4 and 6 have met at 5 by then, and nothing is cheaper.
    let want = Found { expanded: 5, generated: 9, pushes: 9, rejected: 1, ..want };
    assert_eq!(found(Stop::Optimal), want);
}

#[test]
fn a_memory_serves_more_searches_than_it_has_generations() {
    let mut memory = Memory::default();
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
    let (leg, other) = (Leg::new(200, 5).at(1 << 40), Leg::new(200, 1 << 40));
    assert_eq!((leg.cost, leg.code), (other.cost, other.code));
}
