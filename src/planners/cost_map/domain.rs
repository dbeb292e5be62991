//! The road as a graph of cells.

use super::ground::{lane_at, legs, limit_at};
use super::{Base, Config, Costs, Query};
use crate::geometry::math;
use crate::map::{Cell, Frame};
use crate::search::{Domain, Finish, NodeId, Order, Relax, Visit};

/// Speed at which no place is slow, m/s.
const PACE: f64 = 10.0;
/// Comfortable lateral acceleration, m/s².
const LATERAL: f64 = 2.0;
/// The lane term counts no more than this.
const LANE_MOST: f64 = 1.5;
/// Cells without room for the car.
const CLOSED: f64 = f64::INFINITY;
/// The number of a cell without room.
const NOWHERE: u32 = u32::MAX;

/// West, east, south, north, south-west, south-east, north-west, north-east.
const AROUND: [(i32, i32); 8] = [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)];

/// What a metre of every cell costs beyond its length; with the manuscript's costs, the cell. [`CLOSED`] where there is no
/// room.
pub(super) fn surcharges<'a>(query: &'a Query<'a>, config: &'a Config) -> impl Fn(usize) -> f64 + 'a {
    let frame = &query.ground.frame;
    let legs = legs(query.lanes);
    let paper = config.costs == Costs::Paper;
    let base = move |d: f64| match (config.base, paper) {
        (Base::Inverse, false) => config.factor / (d + config.epsilon),
        (Base::Exponential, false) => config.amplitude * math::exp(-config.decay * d),
        (Base::Inverse, true) => config.paper_factor / (d + config.paper_epsilon),
        (Base::Exponential, true) => config.paper_amplitude * math::exp(-config.paper_decay * d),
    };
    move |index| {
        let clearance = f64::from(query.ground.clearance[index]);
        if clearance < query.radius {
            return CLOSED;
        }
        match config.costs {
            Costs::Steps => 0.0,
            Costs::Paper => base(clearance),
            Costs::Metre => {
                let point = frame.center(frame.cell(index));
                let near = (f64::from(query.ground.kerb[index]) - query.radius).clamp(0.0, 1.0);
                let (off, bend) =
                    lane_at(&legs, point).map_or((0.0, 0.0), |(off, half, bend)| (off / half, bend));
                let pace = limit_at(query.limits, point).min((LATERAL / bend.abs()).sqrt()).min(PACE);
                base(clearance - query.radius)
                    + config.lane_weight * (off * off).min(LANE_MOST)
                    + config.kerb_weight * (1.0 - near) * (1.0 - near)
                    + config.speed_weight * (PACE / pace - 1.0)
            }
        }
    }
}

/// The cells with room, numbered row by row.
pub(super) struct Road<'a> {
    frame: &'a Frame,
    goal: Cell,
    costs: Costs,
    /// Per cell of the map: its number, [`NOWHERE`] without room.
    numbers: Vec<u32>,
    /// Per number: the cell and what a metre of it costs beyond its length.
    cells: Vec<(u32, f64)>,
}

impl<'a> Road<'a> {
    pub(super) fn new(query: &Query<'a>, config: &Config, goal: Cell) -> Self {
        let frame = &query.ground.frame;
        let surcharge = surcharges(query, config);
        let mut cells = Vec::new();
        let number = |index: usize| {
            let extra = surcharge(index);
            if extra == CLOSED {
                return NOWHERE;
            }
            cells.push((index as u32, extra));
            cells.len() as u32 - 1
        };
        let numbers = (0..frame.len()).map(number).collect();
        Self { frame, goal, costs: config.costs, numbers, cells }
    }

    /// Number of cells with room.
    pub(super) fn len(&self) -> usize {
        self.cells.len()
    }

    /// Bytes held.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.numbers[..]) + size_of_val(&self.cells[..])
    }

    pub(super) fn node(&self, cell: Cell) -> NodeId {
        self.numbers[self.frame.index(cell)]
    }

    pub(super) fn cell(&self, node: NodeId) -> Cell {
        self.frame.cell(self.cells[node as usize].0 as usize)
    }

    fn open(&self, cell: Cell) -> Option<NodeId> {
        let inside = self.frame.contains(cell);
        inside.then(|| self.node(cell)).filter(|&node| node != NOWHERE)
    }

    fn moves<S: Relax<f64, ()>>(&self, node: NodeId, sink: &mut S) {
        let from = self.cell(node);
        let own = self.cells[node as usize].1;
        for (dx, dy) in AROUND {
            let Some(target) = self.open(from.offset(dx, dy)) else { continue };
            let diagonal = dx != 0 && dy != 0;
            if diagonal
                && (self.open(from.offset(dx, 0)).is_none() || self.open(from.offset(0, dy)).is_none())
            {
                continue;
            }
            let step = self.frame.resolution * if diagonal { core::f64::consts::SQRT_2 } else { 1.0 };
            let other = self.cells[target as usize].1;
            let cost = match self.costs {
                Costs::Steps => step,
                Costs::Paper => step + other,
                Costs::Metre => step * (1.0 + f64::midpoint(own, other)),
            };
            sink.emit(target, cost, ());
        }
    }

    fn estimate(&self, node: NodeId) -> f64 {
        let cell = self.cell(node);
        let (dx, dy) = (f64::from((cell.x - self.goal.x).abs()), f64::from((cell.y - self.goal.y).abs()));
        self.frame.resolution
            * if self.costs == Costs::Metre {
                dx.max(dy) + (core::f64::consts::SQRT_2 - 1.0) * dx.min(dy)
            } else {
                (dx * dx + dy * dy).sqrt()
            }
    }
}

/// Of equal cells the one met last.
pub(super) struct Eager<'a>(pub(super) Road<'a>);
/// Of equal cells the one met first.
pub(super) struct Fair<'a>(pub(super) Road<'a>);

macro_rules! domain {
    ($name:ident, $order:expr) => {
        impl Domain for $name<'_> {
            type Cost = f64;
            type Label = ();
            type Tail = ();

            const ORDER: Order = $order;

            fn node_count(&self) -> usize {
                self.0.len()
            }

            fn successors<S: Relax<f64, ()>>(&self, from: Visit<f64, ()>, sink: &mut S) {
                self.0.moves(from.node, sink);
            }

            fn heuristic(&self, node: NodeId, (): ()) -> f64 {
                self.0.estimate(node)
            }

            fn finish(&mut self, at: Visit<f64, ()>, _: f64) -> Option<Finish<f64, ()>> {
                (at.node == self.0.node(self.0.goal)).then_some(Finish { cost: 0.0, tail: () })
            }
        }
    };
}

domain!(Eager, Order::Newest);
domain!(Fair, Order::Oldest);
