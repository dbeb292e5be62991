//! The road as a graph of cells.
//!
//! Nodes are the cells with room for the car, numbered without gaps. A step of length ℓ between neighbours with
//! surcharges a and b costs ℓ · (1 + (a + b) / 2), and the surcharge of a cell is (costs `metre`)
//!
//! ```text
//! base(clearance)                              room beside the body
//! + laneWeight · min((off / half width)², 1.5) offset from the lane's middle
//! + kerbWeight · (1 − near)²                   near: 0 at the kerb, 1 a metre away, less in narrow lanes
//! + speedWeight · (10 / v − 1)                 v: speed limit, or what a bend allows, m/s
//! + a price below the margin                   up to twice a metre without any room beside the body
//! ```
//!
//! Painted weights multiply all of it. No metre costs less than its length, so the octile distance is a consistent
//! estimate.
//!
//! A cell's own surcharge counts half for each of its two steps, the one in and the one out. The cost of a step is
//! therefore the same in both directions.
//!
//! With the costs `steps` every metre costs 1. Lengths are then rounded to 2⁻³², so that sums are exact and equally
//! long ways stay equal; without this, rounding would choose among them. With `paper` a cell costs its surcharge
//! once, however long the step, which is the manuscript's formula.
//!
//! Memory: per cell of the map a bit and its counts, per cell with room a surcharge of four bytes and, on painted
//! floors, a weight of one.

use std::sync::Arc;

use super::rank_bitmap::RankBitmap;
use super::{Config, Costs, RoadRasters};
use crate::geometry::Point;
use crate::map::{Cell, Frame, Weights};
use crate::scenario::{Lane, LaneLeg, SpeedLimit};
use crate::search::{Domain, Fate, Finish, NodeId, Order, Relax, Told, Visit};

/// Speed at which no place is slow, m/s.
const FREE_SPEED: f64 = 10.0;
/// Comfortable lateral acceleration, m/s².
const LATERAL: f64 = 2.0;
/// The lane term counts no more than this.
const LANE_MOST: f64 = 1.5;
/// Raster distances this share of a cell smaller than what is asked may be due to the cells alone.
pub(super) const LEEWAY: f64 = 0.25;
/// Factor on the dearest metre with the whole margin: the cost of a metre without any margin, if no path keeps it.
const SHORT: f64 = 2.0;
/// Plain A* measures in this part of a metre.
const STEPS: f64 = 4_294_967_296.0;

/// West, east, south, north, south-west, south-east, north-west, north-east.
const AROUND: [(i32, i32); 8] = [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)];

/// Room beside the body that shall be kept, and what less of it costs.
#[derive(Debug, Clone, Copy)]
struct Margin {
    radius: f64,
    /// Metres.
    asked: f64,
    /// Per metre, or per cell with the manuscript's costs, where none of it is left.
    price: f64,
}

impl Margin {
    /// The extra cost at a place with this clearance of the car's middle: none with the whole margin, `price` without
    /// any.
    fn surcharge(self, clearance: f64) -> f64 {
        let room = clearance - self.radius;
        if room >= self.asked { 0.0 } else { self.price * (1.0 - room / self.asked) }
    }
}

/// Inputs of the cell costs besides clearance.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Traffic {
    /// Lanes to keep to; none means that no lane counts.
    pub lanes: Vec<Lane>,
    /// Areas with a speed limit.
    pub limits: Vec<SpeedLimit>,
}

/// The cells with room for the car, numbered row by row, and what a metre costs there.
#[derive(Debug, Clone)]
pub struct CostMap {
    frame: Frame,
    costs: Costs,
    numbers: RankBitmap,
    /// Half the car's width, metres, and what shall be free beside it.
    keeps: Margin,
    /// Per number: what a metre costs beyond its length; with the manuscript's costs, what the cell costs. What a place
    /// costs for having less than the margin comes on top of it.
    surcharges: Vec<f32>,
    /// Per number: how many times all that counts, where that is not once everywhere.
    weights: Vec<u8>,
}

impl CostMap {
    /// Of a road for cars that need `radius` metres to either side. `kerb` has the distance of every cell to what is no
    /// road.
    pub fn new(ground: &RoadRasters, kerb: &[f32], traffic: &Traffic, radius: f64, config: &Config) -> Self {
        let frame = ground.frame;
        let numbers = RankBitmap::new(ground.clearance.iter().map(|&d| f64::from(d) >= radius));
        let legs = LaneLeg::all(&traffic.lanes);
        let base = |clearance: f64, enough: Option<f64>| config.base_cost(clearance, radius, enough);
        let keeps = Margin {
            radius,
            asked: (config.kept() - frame.resolution * LEEWAY).max(0.0),
            price: SHORT * (1.0 + base(radius, None)),
        };
        let surcharge = |index: usize| {
            let clearance = f64::from(ground.clearance[index]);
            let soft = match config.costs {
                Costs::Steps => 0.0,
                Costs::Paper => base(clearance, None),
                Costs::Metre => {
                    let point = frame.center(frame.cell(index));
                    let lane = LaneLeg::nearest(&legs, point);
                    let (off, bend) =
                        lane.map_or((0.0, 0.0), |(leg, away)| (away / leg.half_width, leg.curvature));
                    // The room on the lattice in the middle of a lane as wide as this one.
                    let less = radius + frame.resolution * LEEWAY + ground.thickened;
                    let enough = lane.map(|(leg, _)| leg.half_width - less);
                    let last = enough.unwrap_or(1.0).clamp(0.1, 1.0);
                    let near = ((f64::from(kerb[index]) - radius) / last).clamp(0.0, 1.0);
                    let limit = SpeedLimit::lowest_at(&traffic.limits, point)
                        .min((LATERAL / bend.abs()).sqrt())
                        .min(FREE_SPEED);
                    base(clearance, enough)
                        + config.lane_weight * (off * off).min(LANE_MOST)
                        + config.kerb_weight * (1.0 - near) * (1.0 - near)
                        + config.speed_weight * (FREE_SPEED / limit - 1.0)
                }
            };
            soft + keeps.surcharge(clearance)
        };
        let mut surcharges = Vec::with_capacity(numbers.len());
        surcharges.extend((0..frame.len()).filter(|&i| numbers.has(i)).map(|i| surcharge(i) as f32));
        let weighed = |weights: &Arc<Weights>| {
            (0..frame.len()).filter(|&i| numbers.has(i)).map(|i| weights.at(frame.cell(i))).collect()
        };
        let weights = ground.weights.as_ref().map(weighed).unwrap_or_default();
        Self { frame, costs: config.costs, numbers, keeps, surcharges, weights }
    }

    /// Per cell of the map: what a metre there costs beyond its length (with the manuscript's costs, what the cell
    /// costs), whatever the margin; infinity where there is no room.
    /// Row by row from the south, as the rasters are.
    pub fn layer(&self, ground: &RoadRasters) -> Vec<f32> {
        let own = u8::from(self.costs != Costs::Paper);
        let cost = |index| {
            self.numbers.of(index).map_or(f32::INFINITY, |n| {
                let (surcharge, weight) = (self.soft(n, ground, index) as f32, self.weight(n));
                f32::from(weight) * surcharge + f32::from((weight - 1) * own)
            })
        };
        (0..self.frame.len()).map(cost).collect()
    }

    /// True if a cell has less than the margin.
    pub(super) fn is_short(&self, ground: &RoadRasters, cell: Cell) -> bool {
        ground.at(cell) < self.keeps.radius + self.keeps.asked
    }

    /// Cost of a node, regardless of the margin.
    fn soft(&self, node: NodeId, ground: &RoadRasters, index: usize) -> f64 {
        f64::from(self.surcharges[node as usize]) - self.keeps.surcharge(f64::from(ground.clearance[index]))
    }

    /// Cost of a metre through a cell with all weights, and with the margin if `margin`; `None` if the car does not
    /// fit.
    pub(super) fn metre(&self, ground: &RoadRasters, cell: Cell, margin: bool) -> Option<f64> {
        let node = self.node(cell)?;
        let surcharge = if margin {
            f64::from(self.surcharges[node as usize])
        } else {
            self.soft(node, ground, self.frame.index(cell))
        };
        Some(self.priced(surcharge) * f64::from(self.weight(node)))
    }

    /// The same between the centres of cells, whatever the margin; `None` where no cell around has room.
    pub(super) fn soft_metre(&self, ground: &RoadRasters, point: Point) -> Option<f64> {
        let [x, y] = self.frame.lattice(point).map(|v| v - 0.5);
        let (x0, y0) = (x.floor(), y.floor());
        let (mut sum, mut share) = (0.0, 0.0);
        for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let cell = Cell::new(x0 as i32 + dx, y0 as i32 + dy);
            let Some(node) = self.node(cell) else { continue };
            let part = (1.0 - (x - x0 - f64::from(dx)).abs()) * (1.0 - (y - y0 - f64::from(dy)).abs());
            let soft = self.priced(self.soft(node, ground, self.frame.index(cell)));
            sum += part * soft * f64::from(self.weight(node));
            share += part;
        }
        (share > 0.0).then(|| sum / share)
    }

    /// The manuscript charges a cell, however long the step.
    fn priced(&self, surcharge: f64) -> f64 {
        1.0 + if self.costs == Costs::Paper { surcharge / self.frame.resolution } else { surcharge }
    }

    /// Number of cells with room.
    pub(super) fn len(&self) -> usize {
        self.surcharges.len()
    }

    /// Bytes held.
    pub(super) fn bytes(&self) -> usize {
        self.numbers.bytes() + size_of_val(&self.surcharges[..]) + size_of_val(&self.weights[..])
    }

    /// The painted weight of a node; 1 where nothing is painted.
    fn weight(&self, node: NodeId) -> u8 {
        self.weights.get(node as usize).copied().unwrap_or(1)
    }

    /// The cell of a node.
    pub(super) fn cell(&self, node: NodeId) -> Cell {
        self.frame.cell(self.numbers.place(node))
    }

    /// The cell's number, if it has room.
    pub(super) fn node(&self, cell: Cell) -> Option<NodeId> {
        let inside = self.frame.contains(cell);
        inside.then(|| self.numbers.of(self.frame.index(cell))).flatten()
    }
}

/// The cells with room as a graph, towards a goal.
#[derive(Clone, Copy)]
pub(super) struct Road<'a> {
    pub(super) map: &'a CostMap,
    pub(super) goal: (Cell, NodeId),
    /// The raster, where only cells with the margin count.
    pub(super) strict: Option<&'a RoadRasters>,
}

impl Road<'_> {
    /// The node of a cell that may be on the way.
    fn open(&self, cell: Cell) -> Option<NodeId> {
        self.map.node(cell).filter(|_| self.strict.is_none_or(|ground| !self.map.is_short(ground, cell)))
    }

    /// True if a diagonal step cuts a corner: it needs both cells beside it to have room.
    fn cuts(&self, from: Cell, (dx, dy): (i32, i32)) -> bool {
        let has_room = |cell: Cell| self.map.node(cell).is_some();
        dx != 0 && dy != 0 && !(has_room(from.offset(dx, 0)) && has_room(from.offset(0, dy)))
    }

    /// Tells the steps to the eight cells around a node: cell, node and cost.
    #[inline(always)]
    fn steps(&self, from: Cell, node: NodeId, mut tell: impl FnMut(Cell, NodeId, f64)) {
        let map = self.map;
        let surcharge = |node: NodeId| f64::from(map.surcharges[node as usize]);
        let (own, weight) = (surcharge(node), map.weight(node));
        for (dx, dy) in AROUND {
            let to = from.offset(dx, dy);
            let Some(target) = self.open(to) else { continue };
            if self.cuts(from, (dx, dy)) {
                continue;
            }
            let step = self.length((dx, dy));
            let other = surcharge(target);
            let cost = match map.costs {
                // Sums of these are exact, so that equally long ways are equally good.
                Costs::Steps => (step * STEPS).round() / STEPS,
                Costs::Paper => step + other,
                Costs::Metre => step * (1.0 + f64::midpoint(own, other)),
            };
            tell(to, target, cost * f64::midpoint(f64::from(weight), f64::from(map.weight(target))));
        }
    }

    /// Of a step to a neighbouring cell, metres.
    fn length(&self, (dx, dy): (i32, i32)) -> f64 {
        self.map.frame.resolution * if dx != 0 && dy != 0 { core::f64::consts::SQRT_2 } else { 1.0 }
    }

    /// The octile distance in metres with the costs `metre`, the straight one with the others.
    fn estimate(&self, cell: Cell) -> f64 {
        let (map, (goal, _)) = (self.map, self.goal);
        let (dx, dy) = (f64::from((cell.x - goal.x).abs()), f64::from((cell.y - goal.y).abs()));
        map.frame.resolution
            * if map.costs == Costs::Metre {
                dx.max(dy) + (core::f64::consts::SQRT_2 - 1.0) * dx.min(dy)
            } else {
                (dx * dx + dy * dy).sqrt()
            }
    }

    /// Of equal cells the one met first where every metre costs the same, else the one met last.
    fn ties(&self) -> Order {
        if self.map.costs == Costs::Steps { Order::Oldest } else { Order::Newest }
    }
}

impl Domain for Road<'_> {
    type Cost = f64;
    type Label = ();
    type Tail = ();

    fn node_count(&self) -> usize {
        self.map.len()
    }

    fn order(&self) -> Order {
        self.ties()
    }

    fn successors<S: Relax<f64, ()>>(&self, from: Visit<f64, ()>, sink: &mut S) {
        self.steps(self.map.cell(from.node), from.node, |_, target, cost| sink.emit(target, cost, ()));
    }

    fn heuristic(&self, node: NodeId, (): ()) -> f64 {
        self.estimate(self.map.cell(node))
    }

    fn finish(&mut self, at: Visit<f64, ()>, _: f64) -> Option<Finish<f64, ()>> {
        (at.node == self.goal.1).then_some(Finish { cost: 0.0, tail: () })
    }
}

/// The same graph over the places of all cells of the map, those without room among them. A search of it is the same
/// search, and can be told of the cells that are left out.
pub(super) struct Places<'a>(pub(super) Road<'a>);

impl Places<'_> {
    /// Row by row, as the rasters are.
    pub(super) fn place(&self, cell: Cell) -> NodeId {
        self.0.map.frame.index(cell) as NodeId
    }

    fn cell(&self, place: NodeId) -> Cell {
        self.0.map.frame.cell(place as usize)
    }
}

impl Domain for Places<'_> {
    type Cost = f64;
    type Label = NodeId;
    type Tail = ();

    fn node_count(&self) -> usize {
        self.0.map.frame.len()
    }

    fn order(&self) -> Order {
        self.0.ties()
    }

    fn successors<S: Relax<f64, NodeId>>(&self, from: Visit<f64, NodeId>, sink: &mut S) {
        let cell = self.cell(from.node);
        let Some(node) = self.0.map.node(cell) else { return };
        self.0.steps(cell, node, |to, _, cost| sink.emit(self.place(to), cost, self.place(to)));
    }

    fn heuristic(&self, place: NodeId, _: NodeId) -> f64 {
        self.0.estimate(self.cell(place))
    }

    fn finish(&mut self, at: Visit<f64, NodeId>, _: f64) -> Option<Finish<f64, ()>> {
        (at.node == self.place(self.0.goal.0)).then_some(Finish { cost: 0.0, tail: () })
    }
}

impl Told for Places<'_> {
    fn consider(&self, from: Visit<f64, NodeId>, tell: &mut dyn FnMut(NodeId, f64, NodeId, Option<Fate>)) {
        let cell = self.cell(from.node);
        for step in AROUND {
            let to = cell.offset(step.0, step.1);
            if self.0.map.frame.contains(to) {
                let is_blocked = self.0.open(to).is_none();
                let illegal = (is_blocked || self.0.cuts(cell, step)).then_some(if is_blocked {
                    Fate::Blocked
                } else {
                    Fate::Corner
                });
                tell(self.place(to), self.0.length(step), self.place(to), illegal);
            }
        }
    }
}
