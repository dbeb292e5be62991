//! Grid planners in a scene: cells in, a checked path in metres out.
//!
//! A pose becomes the cell that holds the rear axle's middle; a heading plays no part in the search. The way back to
//! metres goes through these steps, each of which keeps what the one before has made:
//!
//! 1. the search answers cells from start to goal;
//! 2. pruning leaves out cells that a straight line can skip, greedily ([`prune`]) and by dynamic programming
//!    ([`prune_dp`]);
//! 3. tangent arcs round the corners ([`smooth`]);
//! 4. poses are sampled along the result that the setting `post` asks for;
//! 5. the independent check drives the car along them, with its real body.
//!
//! Steps 2 and 3 always run, since their lengths and corners are among the metrics. A grid path is not expected to pass
//! the check of a car: it has corners, and the search knew a point or a disc. The check says so, and the outcome stays
//! `found`.

use super::engine::{Ask, Engine, LayerData};
use super::measured::{Driven, NEAR, STEP, measured};
use super::outcome::Recorded;
use super::outcome::{GridMetrics, Outcome, Plan, PlanTrace, Stats};
use super::path_sampling;
use super::rasters::Rasters;
use super::stages::Stages;
use super::world::World;
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::geometry::{Point, Pose};
use crate::map::Cell;
use crate::map::risk::PotentialField;
use crate::metrics::any_angle_length;
use crate::metrics::grid as cells;
use crate::planners::Detail;
use crate::planners::Obstruction;
use crate::planners::grid_planner::GridPlanner;
use crate::planners::query::{GridReport, GridScratch};
use crate::planners::registry::PlannerId;
use crate::planners::risk_field;
use crate::planners::settings::{Common, Inflation, Post};
use crate::post::{Piece, Smoothed, prune, prune_dp, smooth};
use crate::scenario::Scenario;
use crate::search::Observers;

/// A path of more poses than this is sampled less often. It bounds time and memory of the check on maps of kilometres.
const MAX_POSES: f64 = 50_000.0;
/// Longest chord that stands for a piece of an arc where clearances are measured, cells.
const CHORD: f64 = 0.1;

/// A grid planner and its memory.
///
/// The scratch keeps node tables and queues between plans; its size follows the largest map so far.
pub(super) struct GridEngine {
    search: Box<dyn GridPlanner>,
    settings: Common,
    rasters: Rasters,
    scratch: GridScratch,
}

impl GridEngine {
    /// # Errors
    /// [`ErrorCode::Config`] where cells have weights and the planner takes them for equal.
    pub(super) fn new(world: &World, kind: PlannerId, search: Box<dyn GridPlanner>) -> Result<Self, Error> {
        let settings = search.common();
        if world.occupancy.weights().is_some() && !kind.takes_costs() {
            let rule = message!("must be empty for {}, for which all free cells cost the same", kind.id());
            return Err(Error::new(ErrorCode::Config, "costs", rule));
        }
        let rasters = Rasters::new(world, &settings);
        Ok(Self { search, settings, rasters, scratch: GridScratch::new() })
    }

    /// The search alone, between two cells. Rasters that depend on them are brought up to date before.
    ///
    /// Ends outside the map get a cell that no map has, which the planner answers with an outcome.
    fn search_cells(&mut self, world: &World, cells: [Cell; 2], observers: &mut Observers) -> GridReport {
        if IS_COMPLETE {
            self.rasters.prepare(world, cells);
            if self.search.needs_bits() {
                self.rasters.prepare_bits(world);
            }
        }
        self.search.run(self.rasters.query(world, cells), &mut self.scratch, observers)
    }

    /// The potential field between the ends of `world`, if one leads the search.
    fn field<'a>(&'a self, world: &'a World) -> Option<PotentialField<'a>> {
        Some(self.search.risk_field()?.field(&self.rasters.query(world, ends(world)).query))
    }
}

impl Engine for GridEngine {
    /// Search, then [`Finish`].
    fn plan(&mut self, _: &Scenario, world: &mut World, mut ask: Ask) -> Plan {
        let mut observers = ask.observers();
        let report = self.search_cells(world, ends(world), &mut observers);
        if let Some(trace) = &mut observers.0 {
            trace.flush();
        }
        if let Some(progress) = &mut observers.1 {
            progress.finish(report.stats.expanded);
        }
        let finish = Finish { world, rasters: &self.rasters, settings: self.settings, report: &report };
        let mut plan = finish.plan(observers.0.is_some());
        if IS_COMPLETE {
            self.count(&report, &mut plan.stats);
            plan.recorded = ask.record.and_then(|limit| self.record(world, limit)).map(Box::new);
        }
        plan.trace = observers.0.map(|t| PlanTrace::Cells { cells: t.expanded, dropped: t.dropped });
        plan
    }

    /// Of the risk field the force at the middle cells of squares of `every` cells: east, north, ….
    fn layer(&self, world: &World, name: &str, every: u32) -> Option<LayerData> {
        match name {
            "risk" => {
                let forces = self.field(world)?.layer(every).data;
                Some(LayerData::Floats(forces.into_iter().flatten().collect()))
            }
            "potential" if IS_COMPLETE => Some(LayerData::Floats(self.field(world)?.potential_layer().data)),
            "redundant" if IS_COMPLETE => Some(LayerData::Bytes(self.rasters.layer(world, ends(world)).data)),
            _ => None,
        }
    }

    fn cell_changed(&mut self, world: &World, cell: Cell) {
        if IS_COMPLETE {
            self.rasters.change(world, cell);
        }
    }

    fn search(&mut self, world: &World, ends: [Pose; 2]) -> Option<GridReport> {
        IS_COMPLETE.then(|| self.search_cells(world, cells_of(world, ends), &mut Observers::default()))
    }

    fn any_angle_length(&self, world: &World) -> Option<f64> {
        if !IS_COMPLETE {
            return None;
        }
        let [start, goal] = ends(world);
        let cells = any_angle_length(self.rasters.solid(world), start, goal)?;
        Some(cells * world.frame.resolution)
    }

    fn explain(&self, world: &World, at: Point) -> Option<risk_field::Explanation> {
        let config = self.search.risk_field().filter(|_| IS_COMPLETE)?;
        risk_field::explain(self.rasters.query(world, ends(world)).query, config, world.frame.cell_at(at)?)
    }
}

impl GridEngine {
    /// The last search, between the ends of `world`, with its events written down. Recording runs the search a second
    /// time, so that a plan without it pays nothing.
    fn record(&self, world: &World, limit: usize) -> Option<Recorded> {
        let at = self.rasters.query(world, ends(world));
        let (width, height) = (at.query.map.width(), at.query.map.height());
        let recording = self.search.record(at, limit)?;
        Some(Recorded::Cells { width, height, recording })
    }

    /// Counters that only some planners and settings have.
    fn count(&self, report: &GridReport, stats: &mut Stats) {
        (stats.cells_scanned, stats.rejected) = (report.cells_scanned, report.rejected);
        if let Some(redundant) = self.rasters.redundant() {
            stats.narrow = Some(redundant.narrow);
            stats.pocket = Some(redundant.pocket);
            stats.restored = Some(redundant.restored);
        }
    }
}

/// The cells of start and goal.
fn ends(world: &World) -> [Cell; 2] {
    cells_of(world, [world.geometry.start, world.geometry.goal])
}

/// The cells of two poses; (−1, −1), which is blocked in every map, for one outside the map.
fn cells_of(world: &World, poses: [Pose; 2]) -> [Cell; 2] {
    poses.map(|pose| world.frame.cell_at(pose.point()).unwrap_or(Cell::new(-1, -1)))
}

/// Everything after the search, from cells to a checked plan in metres.
struct Finish<'a> {
    world: &'a World,
    rasters: &'a Rasters,
    settings: Common,
    report: &'a GridReport,
}

impl Finish<'_> {
    /// The plan; with what each step makes of the path where it is `traced`.
    fn plan(&self, traced: bool) -> Plan {
        let Self { world, report, .. } = self;
        let (map, solid) = (self.rasters.map(world), self.rasters.solid(world));
        let pruned = prune(map, &report.cells, self.settings.corner);
        let radius = world.geometry.vehicle.min_turning_radius();
        let min_radius = self.settings.min_radius.in_cells(radius, world.frame.resolution);
        let smoothed = smooth(solid, &pruned, min_radius, self.settings.smooth_mode);
        let shortest = prune_dp(map, &report.cells, self.settings.corner);
        let pieces = self.pieces(&pruned, &shortest, &smoothed);
        let driven = self.driven(&pieces);
        let near = NEAR.max(world.frame.resolution);
        let mut plan = measured(world, report.outcome, driven, near);
        plan.detail = report.detail;
        plan.reason = self.reason();
        if report.outcome == Outcome::NoPath {
            let at = world.frame.center(report.closest);
            plan.obstruction = Some(Obstruction::Nearest { at, heading: None });
        }
        plan.raw_path = report.cells.iter().map(|&c| world.frame.center(c)).collect();
        plan.stats = stats(report);
        plan.stats.memory_bytes += self.rasters.bytes(world) as u64;
        if report.outcome == Outcome::Found {
            plan.metrics.grid = Some(self.metrics(&pruned, &shortest, &smoothed, &pieces));
            if IS_COMPLETE && traced {
                plan.stages = Some(Stages::new(&world.frame, &pruned, &shortest, &smoothed));
            }
        }
        plan
    }

    /// The path after the requested post-processing.
    fn pieces(&self, pruned: &[Cell], shortest: &[Cell], smoothed: &Smoothed) -> Vec<Piece> {
        let line = |path: &[Cell]| Piece::lines(&cells::polyline(path));
        match self.settings.post {
            Post::None => line(&self.report.cells),
            Post::Prune => line(pruned),
            Post::PruneDp => line(shortest),
            Post::Smooth => smoothed.pieces.clone(),
        }
    }

    /// The poses along the pieces, [`STEP`] apart, or farther on very long paths. A path of one cell is the car at its
    /// start heading.
    fn driven(&self, pieces: &[Piece]) -> Driven {
        let frame = &self.world.frame;
        let start = self.world.geometry.start.heading;
        if let [only] = self.report.cells[..] {
            let at: Point = frame.center(only);
            let poses = vec![Pose::new(at.x, at.y, start)];
            return Driven { poses, directions: vec![1], curvatures: vec![0.0] };
        }
        let length: f64 = pieces.iter().map(Piece::length).sum::<f64>() * frame.resolution;
        path_sampling::follow(frame, pieces, start, STEP.max(length / MAX_POSES))
    }

    /// Lengths and clearances in cells, measured before the sampling to poses.
    fn metrics(
        &self,
        pruned: &[Cell],
        shortest: &[Cell],
        smoothed: &Smoothed,
        pieces: &[Piece],
    ) -> GridMetrics {
        let raw = &self.report.cells;
        let (turns, turns_pruned) = (cells::turns(raw), cells::turns(pruned));
        let line = if pieces.is_empty() { cells::polyline(raw) } else { Piece::polyline(pieces, CHORD) };
        let clearance = cells::clearance(self.rasters.solid(self.world), &line);
        GridMetrics {
            length_raw: cells::length(raw),
            length_pruned: cells::length(pruned),
            length_dp: cells::length(shortest),
            length_smoothed: smoothed.length,
            turns: turns.count,
            turn_angle_deg: turns.angle_deg,
            turns_pruned: turns_pruned.count,
            turn_angle_deg_pruned: turns_pruned.angle_deg,
            min_clearance_cells: clearance.min,
            mean_clearance_cells: clearance.mean,
            sharp_corners: smoothed.sharp,
            arcs: smoothed.arcs,
            min_radius: smoothed.min_radius,
        }
    }

    /// The outcome in a sentence, with the place in metres; `None` where there is a path.
    fn reason(&self) -> Option<String> {
        let at = |pose: Pose| format!("({:.2}, {:.2})", pose.x, pose.y);
        let geometry = &self.world.geometry;
        let space =
            if self.settings.inflation == Inflation::None { "" } else { " or in the safety space around it" };
        Some(match self.report.outcome {
            Outcome::Found => return None,
            Outcome::StartOutside => format!("The start {} is off the map.", at(geometry.start)),
            Outcome::GoalOutside => format!("The goal {} is off the map.", at(geometry.goal)),
            Outcome::StartBlocked => {
                format!("The start {} is inside an obstacle{space}.", at(geometry.start))
            }
            Outcome::GoalBlocked => format!("The goal {} is inside an obstacle{space}.", at(geometry.goal)),
            Outcome::BudgetSpent => format!("Stopped after {} expansions.", self.report.stats.expanded),
            Outcome::NoPath if self.report.detail == Some(Detail::Incomplete) => {
                format!(
                    "There is a path, but this rule missed it: {} cells were searched.",
                    self.report.stats.expanded
                )
            }
            Outcome::NoPath => {
                let near = self.world.frame.center(self.report.closest);
                format!(
                    "No way through: all {} cells that can be reached were searched; the nearest to the goal is \
                     ({:.2}, {:.2}).",
                    self.report.stats.generated, near.x, near.y
                )
            }
        })
    }
}

/// The counters that all grid planners have. The cost is told only where there is a path.
fn stats(report: &GridReport) -> Stats {
    Stats {
        deferred: Some(report.deferred),
        los_calls: Some(report.los_calls),
        cost_micro: (report.outcome == Outcome::Found).then_some(report.cost_micro),
        ..Stats::of(report.stats)
    }
}
