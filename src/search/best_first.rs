//! A\* and its kin: one loop for every planner that searches a [`Domain`].
//!
//! The loop takes the first entry of the open list. An entry for a node is expanded: its moves are relaxed, and the
//! domain may offer a completion from there ([`Domain::finish`]). A completion enters the open list with its total
//! cost as priority. The search ends when a completion is taken or costs no more than the entry in hand, not when
//! one is found: no open node can then lead to a cheaper one, provided that the heuristic is consistent.
//! [`Limits::first`] takes the first completion instead.
//!
//! With E expansions, b moves a node and an open list of n entries a search takes O(E·b) relaxations and O(log n)
//! for each entry at worst; the buckets of the open list make most insertions constant.

use super::open_list::EntryKind;
use super::{Budget, Cost, Domain, End, NodeId, Observer, Scratch, SearchStats, Tree};

/// When to stop short of the cheapest completion.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Expansions after which the search gives up; the same on every machine, unlike a clock.
    pub max_expansions: u32,
    /// True to take the first completion found instead of the cheapest.
    pub first: bool,
}

/// The result of a search and its counters.
#[derive(Debug, Clone)]
pub struct Report<C, T> {
    /// How it ended.
    pub end: End,
    /// The best completion: last node, total cost, tail.
    pub found: Option<(NodeId, C, T)>,
    /// Its counters, without the bytes.
    pub stats: SearchStats,
    /// The smallest heuristic value of an expanded node, and that node: how close the search came.
    pub closest: (C, NodeId),
}

/// Searches from `root` for the cheapest completion of `domain`.
///
/// Nodes are expanded in the order of [`Domain::order`] and never reopened, so with a consistent heuristic the
/// completion is optimal. `scratch` is reused between calls; `observer` is `()` where nobody watches.
#[inline(always)]
pub fn best_first<D: Domain, O: Observer<D::Cost, D::Label>>(
    domain: &mut D,
    root: (NodeId, D::Label),
    limits: Limits,
    scratch: &mut Scratch<D::Cost, D::Label>,
    observer: &mut O,
) -> Report<D::Cost, D::Tail> {
    let mut tree = Tree::new(domain, root, scratch);
    let mut report =
        Report { end: End::Exhausted, found: None, stats: SearchStats::default(), closest: tree.closest };
    let mut best = D::Cost::MAX;
    let mut budget = Budget::new(limits.max_expansions, observer);
    while let Some(entry) = tree.pop() {
        if entry.kind() == EntryKind::Goal {
            report.end = End::Found;
            break;
        }
        if budget.is_spent(report.stats.expanded, observer) {
            report.end = End::BudgetSpent;
            break;
        }
        let at = tree.close(&entry, observer);
        report.stats.expanded += 1;
        if let Some(finish) = tree.complete(at, best) {
            best = at.g + finish.cost;
            report.found = Some((at.node, best, finish.tail));
            if limits.first || best <= entry.f {
                report.end = End::Found;
                break;
            }
            tree.scratch.open.push(tree.domain.order(), best, D::Cost::default(), at.node, EntryKind::Goal);
        }
        tree.expand(at, best, observer);
    }
    report.stats = SearchStats { expanded: report.stats.expanded, ..tree.stats() };
    report.closest = tree.closest;
    report
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use crate::search::{Finish, Relax, Visit};

    /// A line of nodes 0..n with unit steps to both sides.
    struct Line {
        n: u32,
        target: u32,
    }

    impl Domain for Line {
        type Cost = i64;
        type Label = ();
        type Tail = ();

        fn node_count(&self) -> usize {
            self.n as usize
        }

        fn successors<S: Relax<i64, ()>>(&self, from: Visit<i64, ()>, sink: &mut S) {
            if from.node + 1 < self.n {
                sink.emit(from.node + 1, 1, ());
            }
            if from.node > 0 {
                sink.emit(from.node - 1, 1, ());
            }
        }

        fn heuristic(&self, node: NodeId, (): ()) -> i64 {
            i64::from(node.abs_diff(self.target))
        }

        fn finish(&mut self, at: Visit<i64, ()>, _: i64) -> Option<Finish<i64, ()>> {
            (at.node == self.target).then_some(Finish { cost: 0, tail: () })
        }
    }

    const LIMITS: Limits = Limits { max_expansions: 100, first: false };

    #[test]
    fn finds_the_target_and_counts_it() {
        let mut scratch = Scratch::new();
        let report = best_first(&mut Line { n: 10, target: 7 }, (3, ()), LIMITS, &mut scratch, &mut ());
        assert_eq!((report.end, report.stats.expanded, report.stats.generated), (End::Found, 5, 6));
        assert_eq!((report.stats.pushes, report.stats.open_peak), (6, 2));
        assert_eq!(scratch.chain(7).iter().map(|n| n.0).collect::<Vec<_>>(), [3, 4, 5, 6, 7]);
    }

    #[test]
    fn start_is_target() {
        let report = best_first(&mut Line { n: 1, target: 0 }, (0, ()), LIMITS, &mut Scratch::new(), &mut ());
        assert_eq!((report.end, report.stats.expanded, report.stats.generated), (End::Found, 1, 1));
    }

    #[test]
    fn an_unreachable_target_exhausts_and_a_budget_stops() {
        let mut line = Line { n: 10, target: 20 };
        let report = best_first(&mut line, (0, ()), LIMITS, &mut Scratch::new(), &mut ());
        assert_eq!((report.end, report.stats.expanded, report.closest.1), (End::Exhausted, 10, 9));
        let limits = Limits { max_expansions: 4, ..LIMITS };
        let report = best_first(&mut line, (0, ()), limits, &mut Scratch::new(), &mut ());
        assert_eq!((report.end, report.stats.expanded), (End::BudgetSpent, 4));
    }

    #[test]
    fn scratch_serves_searches_of_different_sizes() {
        let mut scratch = Scratch::new();
        for (n, target) in [(10, 7), (100, 99), (5, 1)] {
            let report = best_first(&mut Line { n, target }, (0, ()), LIMITS, &mut scratch, &mut ());
            assert_eq!(report.found.map(|f| f.1), Some(i64::from(target)));
            assert_eq!(scratch.cost(target), Some(i64::from(target)));
        }
    }

    /// Directed edges with costs, and by node an estimate and a completion. From node 2, edges lead past it.
    struct Graph {
        edges: Vec<(NodeId, NodeId, i64)>,
        estimates: [i64; 5],
        completions: [Option<i64>; 5],
        asked: Cell<u32>,
    }

    impl Graph {
        fn new(edges: &[(NodeId, NodeId, i64)], completions: [Option<i64>; 5]) -> Self {
            Self { edges: edges.to_vec(), estimates: [0; 5], completions, asked: Cell::new(0) }
        }

        fn search(&mut self, root: NodeId, limits: Limits) -> (Report<i64, ()>, Vec<NodeId>) {
            let mut scratch = Scratch::new();
            let report = best_first(self, (root, ()), limits, &mut scratch, &mut ());
            let chain = scratch.chain(report.found.map_or(root, |found| found.0));
            (report, chain.iter().map(|at| at.0).collect())
        }
    }

    impl Domain for Graph {
        type Cost = i64;
        type Label = ();
        type Tail = ();

        fn node_count(&self) -> usize {
            5
        }

        fn successors<S: Relax<i64, ()>>(&self, from: Visit<i64, ()>, sink: &mut S) {
            assert!(sink.is_closed(from.node) && !sink.improves(from.node, -100));
            assert_eq!(from.parent.is_none(), from.g == 0);
            for &(_, to, cost) in self.edges.iter().filter(|edge| edge.0 == from.node) {
                self.asked.set(self.asked.get() + u32::from(sink.improves(to, cost)));
                if from.node == 2 {
                    sink.emit_past(to, cost, ());
                } else {
                    sink.emit(to, cost, ());
                }
                assert!(!sink.is_closed(to) || !sink.improves(to, cost));
            }
        }

        fn heuristic(&self, node: NodeId, (): ()) -> i64 {
            self.estimates[node as usize]
        }

        fn finish(&mut self, at: Visit<i64, ()>, _: i64) -> Option<Finish<i64, ()>> {
            self.completions[at.node as usize].map(|cost| Finish { cost, tail: () })
        }
    }

    const AT_3: [Option<i64>; 5] = [None, None, None, Some(0), None];

    #[test]
    fn a_better_way_replaces_a_worse_one() {
        let mut graph =
            Graph::new(&[(0, 1, 5), (0, 4, 1), (4, 1, 1), (1, 3, 1), (1, 0, 1), (4, 1, 1), (4, 1, 9)], AT_3);
        let (report, chain) = graph.search(0, LIMITS);
        assert_eq!((report.found.unwrap().1, chain), (3, vec![0, 4, 1, 3]));
        // The old entry of 1 is not expanded.
        assert_eq!((report.stats.expanded, report.stats.generated, report.stats.pushes), (4, 4, 5));
        // Back to 0 and at 9 to 1 are no better, nor is as dear a way.
        assert_eq!(graph.asked.get(), 4);
        assert_eq!(report.closest, (0, 0), "the first of the equally near");
        let (report, _) = Graph::new(&[(0, 1, 5), (0, 4, 1), (4, 1, 1)], [None; 5]).search(0, LIMITS);
        assert_eq!(
            (report.end, report.stats.expanded, report.stats.pushes),
            (End::Exhausted, 3, 4),
            "nor at the end"
        );
    }

    #[test]
    fn a_move_may_lead_past_the_node() {
        let edges = |past| [(4, 0, 1), (0, 1, 5), (0, 2, 1), (2, 1, past), (1, 3, 1)];
        let (report, chain) = Graph::new(&edges(3), AT_3).search(4, LIMITS);
        assert_eq!((report.found.unwrap().1, report.stats.pushes, chain), (5, 6, vec![4, 0, 1, 3]));
        // As dear as what is known, or closed.
        for past in [5, 6] {
            let (report, chain) = Graph::new(&edges(past), AT_3).search(4, LIMITS);
            assert_eq!((report.found.unwrap().1, report.stats.pushes, chain), (7, 5, vec![4, 0, 1, 3]));
        }
        let (report, _) = Graph::new(&[(4, 0, 1), (0, 2, 1), (2, 0, -5)], [None; 5]).search(4, LIMITS);
        assert_eq!((report.stats.expanded, report.stats.pushes), (3, 3));
    }

    #[test]
    fn the_cheapest_completion_is_found_or_the_first() {
        let edges = [(0, 1, 1), (0, 4, 2), (4, 3, 0)];
        // From 4, as dear a way as from 1, and later.
        let completions = [Some(10), Some(2), None, Some(1), Some(1)];
        let mut graph = Graph::new(&edges, completions);
        graph.estimates[3] = 1;
        let (report, chain) = graph.search(0, LIMITS);
        assert_eq!((report.end, report.found.unwrap().1, chain), (End::Found, 3, vec![0, 1]));
        // 3 would cost no less than what is known by then.
        assert_eq!((report.stats.expanded, report.stats.generated), (3, 3));
        let (report, chain) = Graph::new(&edges, completions).search(0, Limits { first: true, ..LIMITS });
        assert_eq!(
            (report.end, report.found.unwrap().1, report.stats.expanded, chain),
            (End::Found, 10, 1, vec![0])
        );
        let (report, _) = Graph::new(&edges, completions).search(0, Limits { max_expansions: 1, ..LIMITS });
        assert_eq!((report.end, report.found.unwrap().1), (End::BudgetSpent, 10));
    }

    #[test]
    fn what_cannot_reach_the_target_is_left_out() {
        let mut graph = Graph::new(&[(0, 1, 1), (0, 4, 1), (1, 3, 5), (4, 3, 1)], AT_3);
        graph.estimates[4] = i64::MAX;
        let (report, chain) = graph.search(0, LIMITS);
        assert_eq!((report.found.unwrap().1, report.stats.generated, chain), (6, 3, vec![0, 1, 3]));
    }
}
