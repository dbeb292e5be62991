//! A lattice of cells whose moves cost their length times the weight of the cells that they cross.
//!
//! Weights are at least 1, so every estimate that never exceeds the plain cost stays one, and a consistent one
//! consistent.
//!
//! The cost of a straight move is Σ wᵢ·lᵢ over the cells that it crosses, where lᵢ is the length of its part in cell i.
//! It is the same in both directions and adds up: two moves along a line cost what one over both costs. Units are
//! micro-cells of weight 1.
//!
//! The wrapper asks the plain lattice for its moves and changes their costs on the way to the search. Only one rule of
//! the plain lattice fails under weights: a cell that the previous one has seen may now be cheaper by the present one,
//! so nothing is left out.

use super::moves::DIRECTIONS;
use super::query::Query;
use crate::map::{Cell, Occupancy, Weights};
use crate::search::NodeId;
use crate::search::lattice::{Deferral, Deferring, Edge, EdgeSink, Lattice, Reversible};
use crate::search::{Considered, Legality, Part};

/// `lattice` over a map's cells, its moves at other costs than their lengths.
pub(super) struct Weighted<'a, L> {
    pub(super) lattice: L,
    map: &'a Occupancy,
    weights: Option<&'a Weights>,
    goal: Cell,
}

/// Passes moves on at their costs by weight; at no cost where there are no weights (greedy search).
struct Weighing<'a, S> {
    sink: &'a mut S,
    map: &'a Occupancy,
    weights: Option<&'a Weights>,
    from: Cell,
}

impl<'a, L> Weighted<'a, L> {
    /// The query's map must have weights.
    pub(super) fn new(lattice: L, query: &Query<'a>) -> Self {
        let weights = query.map.weights().expect("only maps with weights are searched by them");
        Self { lattice, map: query.map, weights: Some(weights), goal: query.goal }
    }

    /// Moves that cost nothing: a search by the estimate alone, which keeps the first way it finds to each cell.
    pub(super) fn for_nothing(lattice: L, query: &Query<'a>) -> Self {
        Self { lattice, map: query.map, weights: None, goal: query.goal }
    }

    fn weighing<'s, S>(&self, node: NodeId, sink: &'s mut S) -> Weighing<'s, S>
    where
        'a: 's,
    {
        Weighing { sink, map: self.map, weights: self.weights, from: self.map.cell(node) }
    }
}

impl<S> Weighing<'_, S> {
    fn cost(&self, to: Cell) -> i64 {
        self.weights.map_or(0, |weights| weights.cost(self.from, to))
    }
}

impl<S: EdgeSink> Weighing<'_, S> {
    /// Those of the eight directions, every `stride`-th, that would improve what is known there.
    fn improves_in(&self, stride: usize) -> u32 {
        let improves = |c: usize| {
            let to = self.from.offset(DIRECTIONS[c].0, DIRECTIONS[c].1);
            self.map.contains(to) && self.sink.improves(self.map.index(to), self.cost(to))
        };
        (0..8).step_by(stride).fold(0, |bits, c| bits | u32::from(improves(c)) << c)
    }
}

impl<S: EdgeSink> EdgeSink for Weighing<'_, S> {
    fn improves(&self, target: NodeId, _: i64) -> bool {
        self.sink.improves(target, self.cost(self.map.cell(target)))
    }

    fn improves_around(&self, _: NodeId, _: usize, _: i64, _: i64) -> u32 {
        self.improves_in(1)
    }

    fn improves_beside(&self, _: NodeId, _: usize, _: i64) -> u32 {
        self.improves_in(2)
    }

    fn relax(&mut self, edge: Edge, target: NodeId, h: i64) {
        let cost = self.cost(self.map.cell(target));
        self.sink.relax(edge.at(cost), target, h);
    }
}

impl<L: Lattice> Lattice for Weighted<'_, L> {
    type Entry = L::Entry;

    const JUMPS: bool = L::JUMPS;

    fn node_count(&self) -> usize {
        self.lattice.node_count()
    }

    fn padding(&self) -> usize {
        self.lattice.padding()
    }

    /// With weights the previous cell's moves are not always cheaper, so all moves are emitted.
    fn successors<S: EdgeSink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        self.lattice.successors(node, None, &mut self.weighing(node, sink));
    }

    fn before(&self, node: NodeId, number: u32) -> NodeId {
        self.lattice.before(node, number)
    }

    /// Straight to the goal where nothing heavier is on the way: a way around may be cheaper otherwise.
    fn direct(&self, node: NodeId) -> Option<i64> {
        let weights = self.weights?;
        let straight = |&cost: &i64| weights.cost(self.map.cell(node), self.goal) == cost;
        self.lattice.direct(node).filter(straight)
    }

    fn to_goal(&self, node: NodeId) -> i64 {
        self.lattice.to_goal(node)
    }
}

impl<L: Reversible> Reversible for Weighted<'_, L> {
    fn predecessors<S: EdgeSink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        self.lattice.predecessors(node, None, &mut self.weighing(node, sink));
    }

    fn after(&self, node: NodeId, number: u32) -> NodeId {
        self.lattice.after(node, number)
    }

    fn to_start(&self, node: NodeId) -> i64 {
        self.lattice.to_start(node)
    }
}

impl<L: Deferring> Deferring for Weighted<'_, L> {
    fn deferred_successors<S: EdgeSink>(&self, node: NodeId, payload: u32, sink: &mut S) {
        self.lattice.deferred_successors(node, payload, &mut self.weighing(node, sink));
    }

    fn deferred_at_once<S: EdgeSink>(&self, node: NodeId, sink: &mut S) {
        self.lattice.deferred_at_once(node, &mut self.weighing(node, sink));
    }

    fn payload(&self) -> u32 {
        self.lattice.payload()
    }

    fn deferral(&self) -> Deferral {
        self.lattice.deferral()
    }
}

impl<L: Considered> Considered for Weighted<'_, L> {
    fn consider(
        &self,
        node: NodeId,
        _: Option<u32>,
        part: Part,
        tell: &mut dyn FnMut(NodeId, i64, Legality),
    ) {
        let from = self.map.cell(node);
        let cost = |to| self.weights.map_or(0, |weights| weights.cost(from, self.map.cell(to)));
        self.lattice.consider(node, None, part, &mut |to, _, legality| {
            let cost = if legality == Legality::Free { cost(to) } else { 0 };
            tell(to, cost, legality);
        });
    }
}
