//! Cost-map A* for roads: what a metre costs depends on the room around the car, the lane, the kerb and the speed.
//!
//! From a manuscript on road navigation whose distances are a ship's; see DESIGN.md for what is kept of it. Places are the
//! middle of the car. The road's kerbs are the map's boundary.

mod config;
mod domain;
mod ground;
mod prune;
mod smooth;

pub use config::{Base, Config, Costs, Curves, Pruning};
pub use ground::Ground;
pub(crate) use ground::{lane_at, legs, limit_at};
pub use prune::{corners, prune};
pub use smooth::{Smooth, Smoothing, dense, paper_spline, smooth};

use crate::geometry::{Point, math};
use crate::map::Cell;
use crate::scenario::{Lane, SpeedLimit};
use crate::search::{End, Limits, Trace, best_first};
use domain::{Eager, Fair, Road, surcharges};

/// How far a start or goal without room may be moved to one with room, metres.
const SNAP: f64 = 1.5;

/// What is asked.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a> {
    /// The road's rasters.
    pub ground: &'a Ground,
    /// Lanes to keep to; none means that no lane counts.
    pub lanes: &'a [Lane],
    /// Areas with a speed limit.
    pub limits: &'a [SpeedLimit],
    /// Half the car's width, metres.
    pub radius: f64,
    /// The car's middle at first.
    pub start: Point,
    /// The car's middle at last.
    pub goal: Point,
}

/// How planning ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// There is a path.
    Found,
    /// There is none.
    NoPath,
    /// The expansion budget was spent first.
    BudgetSpent,
    /// The start is no road, or has no room within 1.5 m.
    StartBlocked,
    /// The goal is no road, or has no room within 1.5 m.
    GoalBlocked,
}

/// What was found and what it took.
#[derive(Debug, Clone)]
pub struct Report {
    /// How it ended.
    pub status: Status,
    /// Neighbouring cells from start to goal.
    pub cells: Vec<Cell>,
    /// Those that pruning kept.
    pub pruned: Vec<Cell>,
    /// Cost of the cells.
    pub cost: f64,
    /// How far start and goal were moved to have room, metres.
    pub moved: [f64; 2],
    /// Expansions.
    pub expanded: u32,
    /// Distinct cells met.
    pub generated: u32,
    /// Insertions into the open list.
    pub pushes: u32,
    /// Largest size of the open list.
    pub open_peak: u32,
    /// Cells with room for the car.
    pub free: u32,
    /// Bytes of the arrays that planning holds, those of the road included.
    pub bytes: usize,
}

/// The memory of the planner, reused between queries.
#[derive(Debug, Default)]
pub struct Scratch(crate::search::Scratch<f64, ()>);

/// Per cell: what a metre there costs beyond its length (with the manuscript's costs, what the cell costs); infinity where
/// there is no room.
pub fn costs(query: &Query, config: &Config) -> Vec<f32> {
    let surcharge = surcharges(query, config);
    (0..query.ground.frame.len()).map(|index| surcharge(index) as f32).collect()
}

/// Plans a way over cells and prunes it; `trace` is told of every cell expanded.
pub fn plan(query: &Query, config: &Config, scratch: &mut Scratch, trace: &mut Option<Trace>) -> Report {
    let ground = query.ground;
    let free = ground.clearance.iter().filter(|&&d| f64::from(d) >= query.radius).count() as u32;
    let mut report = Report {
        status: Status::NoPath,
        cells: Vec::new(),
        pruned: Vec::new(),
        cost: 0.0,
        moved: [0.0; 2],
        expanded: 0,
        generated: 0,
        pushes: 0,
        open_peak: 0,
        free,
        bytes: 0,
    };
    let Some((start, away)) = snapped(query, query.start) else {
        return Report { status: Status::StartBlocked, ..report };
    };
    report.moved[0] = away;
    let Some((goal, away)) = snapped(query, query.goal) else {
        return Report { status: Status::GoalBlocked, ..report };
    };
    report.moved[1] = away;
    let road = Road::new(query, config, goal);
    let root = (road.node(start), ());
    let limits = Limits { max_expansions: config.max_expansions, first: false };
    let memory = &mut scratch.0;
    let (found, road) = if config.costs == Costs::Steps {
        let mut road = Fair(road);
        (best_first(&mut road, root, limits, memory, trace), road.0)
    } else {
        let mut road = Eager(road);
        (best_first(&mut road, root, limits, memory, trace), road.0)
    };
    report.status = match found.end {
        End::Found => Status::Found,
        End::BudgetSpent => Status::BudgetSpent,
        End::Exhausted => Status::NoPath,
    };
    report.expanded = found.expanded;
    report.generated = found.generated;
    report.pushes = found.pushes;
    report.open_peak = found.open_peak;
    report.bytes = size_of_val(&ground.clearance[..])
        + size_of_val(&ground.kerb[..])
        + road.bytes()
        + crate::search::Scratch::<f64, ()>::bytes(road.len());
    if let Some((last, cost, ())) = found.found {
        report.cells = memory.chain(last).into_iter().map(|(node, ())| road.cell(node)).collect();
        report.cost = cost;
        report.pruned = prune(ground, &report.cells, query.radius, config);
    }
    if let Some(trace) = trace {
        trace.expanded.iter_mut().for_each(|node| *node = ground.frame.index(road.cell(*node)) as u32);
    }
    report
}

/// The cell of a place, or the nearest one with room.
fn snapped(query: &Query, place: Point) -> Option<(Cell, f64)> {
    let ground = query.ground;
    let cell = ground.frame.cell_at(place)?;
    let room = |cell: Cell| ground.at(cell) >= query.radius;
    if ground.at(cell) <= 0.0 {
        return None;
    }
    if room(cell) {
        return Some((cell, 0.0));
    }
    let reach = (SNAP / ground.frame.resolution) as i32;
    let around = (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| cell.offset(x, y)));
    let away = |cell: Cell| {
        let shift = ground.frame.center(cell) - place;
        math::hypot(shift.x, shift.y)
    };
    let near = around.filter(|&c| room(c)).map(|c| (c, away(c))).filter(|c| c.1 <= SNAP);
    near.fold(
        None,
        |best: Option<(Cell, f64)>, next| if best.is_none_or(|b| next.1 < b.1) { Some(next) } else { best },
    )
}
