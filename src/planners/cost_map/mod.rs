//! Cost-map A* for roads: what a metre costs depends on the room around the car, the lane, the kerb and the speed.
//!
//! From a manuscript on road navigation whose distances are a ship's; see DESIGN.md for what is kept of it. Places are
//! the middle of the car. The road's kerbs are the map's boundary.
//!
//! The steps: [`RoadRasters`] and [`CostMap`] are made of a scene; [`plan`] searches cells, first among those that
//! keep the margin and then, where that finds nothing, among all with room; [`corners`] and the pruning turn cells
//! into chords; the [`Lateral`] programme and [`smooth()`] turn chords into a curve. Only the curve is what a car
//! drives; it is measured with the towed car before it is accepted.
//!
//! All coordinates are world metres. Clearances are those of the body's middle from a blocked cell; half the car's
//! width (`radius`) is subtracted where the room beside the body is meant.

mod config;
mod domain;
mod lateral;
mod margin;
mod prune;
mod rank_bitmap;
mod road_rasters;
mod smooth;

pub use config::{Base, Config, Costs, Curves, Pruning};
pub use domain::{CostMap, Traffic};
pub use lateral::{Lateral, Row, Station};
pub use margin::{Exact, is_excluded};
pub use prune::corners;
pub use road_rasters::{RoadRasters, kerb_distances};
pub use smooth::{Smooth, Smoothing, dense, paper_spline, smooth};

use super::Outcome;
use crate::geometry::{Point, math};
use crate::map::Cell;
use crate::search::{Limits, NodeId, Observers, Recording, SearchStats, best_first, record_best_first};
use domain::{Places, Road};
use prune::Chords;

/// How far a start or goal without room may be moved to one with room, metres.
const SNAP: f64 = 1.5;

/// A query.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a> {
    /// The road's raster.
    pub ground: &'a RoadRasters,
    /// Costs on it.
    pub costs: &'a CostMap,
    /// Half the car's width, metres.
    pub radius: f64,
    /// The car's middle at first.
    pub start: Point,
    /// The car's middle at last.
    pub goal: Point,
    /// True if cells with less than the margin count from the beginning, not only where no way has it all.
    pub less: bool,
}

/// The result of a query and its counters.
#[derive(Debug, Clone)]
pub struct Report {
    /// How it ended; blocked where there is no road, or no room within 1.5 m.
    pub outcome: Outcome,
    /// Neighbouring cells from start to goal.
    pub cells: Vec<Cell>,
    /// Those that pruning kept.
    pub pruned: Vec<Cell>,
    /// Cost of the cells.
    pub cost: f64,
    /// How far start and goal were moved to have room, metres.
    pub moved: [f64; 2],
    /// The counters of all searches, but for the cells met by the last one alone; and bytes of the rasters, nodes and
    /// open list that the planner holds in the end.
    pub stats: SearchStats,
    /// Expansions of the last search, to which the cells belong.
    pub last: u32,
    /// True if all cells have the margin, by the raster.
    pub has_margin: bool,
    /// Cells with room for the car.
    pub free: u32,
}

/// The memory of the planner, reused between queries.
#[derive(Debug, Default)]
pub struct Scratch(crate::search::Scratch<f64, ()>);

/// Plans a way over cells and prunes it; `observers` is told of every cell expanded.
pub fn plan(query: &Query, config: &Config, scratch: &mut Scratch, observers: &mut Observers) -> Report {
    let ground = query.ground;
    let map = query.costs;
    let mut report = Report {
        outcome: Outcome::NoPath,
        cells: Vec::new(),
        pruned: Vec::new(),
        cost: 0.0,
        moved: [0.0; 2],
        stats: SearchStats::default(),
        last: 0,
        has_margin: false,
        free: map.len() as u32,
    };
    let Some((_, root, away)) = snapped(query, query.start) else {
        return Report { outcome: Outcome::StartBlocked, ..report };
    };
    report.moved[0] = away;
    let Some((goal, last, away)) = snapped(query, query.goal) else {
        return Report { outcome: Outcome::GoalBlocked, ..report };
    };
    report.moved[1] = away;
    let memory = &mut scratch.0;
    let ends = [map.cell(root), goal];
    // First where the margin is everywhere, which is less to search; then wherever the car fits.
    let is_last = query.less || config.kept() == 0.0 || ends.iter().any(|&end| map.is_short(ground, end));
    let mut found = None;
    for strict in [true, false].into_iter().skip(usize::from(is_last)) {
        let mut road = Road { map, goal: (goal, last), strict: strict.then_some(ground) };
        let limits = Limits { max_expansions: config.max_expansions - report.stats.expanded, first: false };
        let next = best_first(&mut road, (root, ()), limits, memory, observers);
        report.stats.add(next.stats);
        report.stats.generated = next.stats.generated;
        report.last = next.stats.expanded;
        report.outcome = next.end.into();
        found = next.found;
        report.has_margin = strict;
        if report.outcome != Outcome::NoPath || report.stats.expanded >= config.max_expansions {
            break;
        }
    }
    let nodes = crate::search::Scratch::<f64, ()>::bytes(map.len(), report.stats.open_peak);
    report.stats.bytes = (size_of_val(&ground.clearance[..]) + map.bytes() + nodes) as u64;
    if let Some((last, cost, ())) = found {
        report.cells = memory.chain(last).into_iter().map(|(node, ())| map.cell(node)).collect();
        report.cost = cost;
        report.pruned = Chords { ground, costs: map, radius: query.radius, config }.prune(&report.cells);
    }
    if let Some(trace) = &mut observers.0 {
        trace.expanded.iter_mut().for_each(|node| *node = ground.frame.index(map.cell(*node)) as u32);
    }
    report
}

/// The last search of a report with its events written down, at most `limit` of them. Its nodes are the places of cells
/// in the rasters.
pub fn record(query: &Query, report: &Report, limit: usize) -> Recording {
    let [start, goal] = [query.start, query.goal].map(|place| snapped(query, place));
    let (Some((start, ..)), Some((goal, last, _))) = (start, goal) else { return Recording::empty() };
    let strict = report.has_margin.then_some(query.ground);
    let mut places = Places(Road { map: query.costs, goal: (goal, last), strict });
    let root = places.place(start);
    let limits = Limits { max_expansions: report.last, first: false };
    let mut memory = crate::search::Scratch::new();
    record_best_first(&mut places, (root, root), limits, &mut memory, &mut (), limit).1.recording
}

/// The cell of a place, or the nearest one with room, and its number.
/// `None` on a blocked cell, or where no cell within [`SNAP`] has room. The distance is 0 where the place's own cell
/// has room.
fn snapped(query: &Query, place: Point) -> Option<(Cell, NodeId, f64)> {
    let ground = query.ground;
    let cell = ground.frame.cell_at(place)?;
    if ground.at(cell) <= 0.0 {
        return None;
    }
    let room = |cell: Cell| query.costs.node(cell).map(|node| (cell, node));
    if let Some((cell, node)) = room(cell) {
        return Some((cell, node, 0.0));
    }
    let reach = (SNAP / ground.frame.resolution) as i32;
    let around = (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| cell.offset(x, y)));
    let away = |cell: Cell| {
        let shift = ground.frame.center(cell) - place;
        math::hypot(shift.x, shift.y)
    };
    let near = around.filter_map(room).map(|(c, node)| (c, node, away(c))).filter(|c| c.2 <= SNAP);
    near.fold(
        None,
        |best: Option<(Cell, NodeId, f64)>, next| {
            if best.is_none_or(|b| next.2 < b.2) { Some(next) } else { best }
        },
    )
}
