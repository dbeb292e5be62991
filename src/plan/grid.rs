//! Grid planners in a scene: cells in, a checked path in metres out.

use serde_json::{Map, Value};

use super::drive;
use super::outcome::{GridMetrics, Outcome, Plan, PlanTrace, Stats};
use super::settings::settings;
use super::world::World;
use super::{NEAR, Options, STEP, TRACE, measured};
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::map::{Cell, Corner, Frame, Occupancy, inflation};
use crate::metrics::grid as cells;
use crate::planners::moves::Neighbourhood;
use crate::planners::query::{Detail, GridReport, GridScratch, Query, Status};
use crate::planners::registry::Kind;
use crate::planners::settings::{Inflation, MinRadius, Post, SmoothMode};
use crate::planners::{grid_astar, risk_field};
use crate::post::{Piece, Smoothed, prune, prune_dp, smooth};
use crate::search::Trace;

/// A path of more poses than this is sampled less often.
const MAX_POSES: f64 = 50_000.0;

enum Search {
    Neighbours(Neighbourhood, grid_astar::Config),
    RiskField(risk_field::Config),
}

/// What all grid planners' settings say of the path.
#[derive(Clone, Copy)]
struct PathSettings {
    corner: Corner,
    inflation: Inflation,
    margin: f64,
    post: Post,
    smooth_mode: SmoothMode,
    min_radius: MinRadius,
}

/// A grid planner and its memory.
pub(super) struct Engine {
    search: Search,
    settings: PathSettings,
    /// The map with the safety space blocked, where there is any.
    inflated: Option<Occupancy>,
    scratch: GridScratch,
}

impl Engine {
    pub(super) fn new(world: &World, kind: Kind, config: &Map<String, Value>) -> Result<Self, Error> {
        let search = if kind == Kind::RiskField {
            let config: risk_field::Config = settings(config)?;
            config.validate()?;
            Search::RiskField(config)
        } else {
            let around = if kind == Kind::Four { Neighbourhood::Four } else { Neighbourhood::Eight };
            let config: grid_astar::Config = settings(config)?;
            config.validate(around)?;
            Search::Neighbours(around, config)
        };
        let settings = search.path_settings();
        let vehicle = &world.geometry.vehicle;
        let inflated = settings
            .inflation
            .radius(vehicle.length(), vehicle.width, settings.margin)
            .map(|radius| inflation::necessary(&world.occupancy, radius / world.frame.resolution));
        Ok(Self { search, settings, inflated, scratch: GridScratch::new() })
    }

    pub(super) fn plan(&mut self, world: &World, options: Options) -> Plan {
        let map = self.inflated.as_ref().unwrap_or(&world.occupancy);
        let query = Query {
            map,
            start: cell_of(&world.frame, world.geometry.start),
            goal: cell_of(&world.frame, world.geometry.goal),
        };
        let mut trace = options.trace.then(|| Trace::new(TRACE));
        let report = self.search.run(query, &mut self.scratch, &mut trace);
        let finish = Finish { world, map, settings: self.settings, report: &report };
        let mut plan = finish.plan();
        plan.trace = trace.map(|t| PlanTrace::Cells { cells: t.expanded, dropped: t.dropped });
        plan
    }

    /// The risk field's force at every cell: east, north, ….
    pub(super) fn field(&self, world: &World) -> Vec<f32> {
        let Search::RiskField(config) = &self.search else { return Vec::new() };
        let map = self.inflated.as_ref().unwrap_or(&world.occupancy);
        let start = cell_of(&world.frame, world.geometry.start);
        let goal = cell_of(&world.frame, world.geometry.goal);
        config.field(&Query { map, start, goal }).layer().data.into_iter().flatten().collect()
    }
}

impl Search {
    fn run(&self, query: Query, scratch: &mut GridScratch, trace: &mut Option<Trace>) -> GridReport {
        match self {
            Self::Neighbours(around, config) => grid_astar::plan(query, *around, config, scratch, trace),
            Self::RiskField(config) => risk_field::plan(query, config, scratch, trace),
        }
    }

    fn path_settings(&self) -> PathSettings {
        match *self {
            Self::Neighbours(_, c) => PathSettings {
                corner: c.corner,
                inflation: c.inflation,
                margin: c.margin,
                post: c.post,
                smooth_mode: c.smooth_mode,
                min_radius: c.min_radius,
            },
            Self::RiskField(c) => PathSettings {
                corner: c.corner,
                inflation: c.inflation,
                margin: c.margin,
                post: c.post,
                smooth_mode: c.smooth_mode,
                min_radius: c.min_radius,
            },
        }
    }
}

/// The cell of a pose; one outside the map where it is outside.
fn cell_of(frame: &Frame, pose: Pose) -> Cell {
    frame.cell_at(pose.point()).unwrap_or(Cell::new(-1, -1))
}

struct Finish<'a> {
    world: &'a World,
    map: &'a Occupancy,
    settings: PathSettings,
    report: &'a GridReport,
}

impl Finish<'_> {
    fn plan(&self) -> Plan {
        let Self { world, report, .. } = self;
        let pruned = prune(self.map, &report.cells, self.settings.corner);
        let radius = world.geometry.vehicle.min_turning_radius();
        let min_radius = self.settings.min_radius.in_cells(radius, world.frame.resolution);
        let smoothed = smooth(self.map, &pruned, min_radius, self.settings.smooth_mode);
        let driven = self.driven(&pruned, &smoothed);
        let near = NEAR.max(world.frame.resolution);
        let mut plan = measured(world, outcome(report.status), driven, near);
        plan.detail = report.detail.map(Detail::as_str);
        plan.reason = self.reason();
        plan.raw_path = report.cells.iter().map(|&c| world.frame.center(c)).collect();
        plan.stats = stats(report);
        if report.status == Status::Found {
            plan.metrics.grid = Some(metrics(&report.cells, &pruned, &smoothed));
        }
        plan
    }

    fn driven(&self, pruned: &[Cell], smoothed: &Smoothed) -> super::Driven {
        let frame = &self.world.frame;
        let start = self.world.geometry.start.heading;
        if let [only] = self.report.cells[..] {
            let at: Point = frame.center(only);
            let poses = vec![Pose::new(at.x, at.y, start)];
            return super::Driven { poses, directions: vec![1], curvatures: vec![0.0] };
        }
        let line = |cells: &[Cell]| {
            Piece::lines(&cells.iter().map(|c| [f64::from(c.x), f64::from(c.y)]).collect::<Vec<_>>())
        };
        let pieces = match self.settings.post {
            Post::None => line(&self.report.cells),
            Post::Prune => line(pruned),
            Post::PruneDp => line(&prune_dp(self.map, &self.report.cells, self.settings.corner)),
            Post::Smooth => smoothed.pieces.clone(),
        };
        let length: f64 = pieces.iter().map(Piece::length).sum::<f64>() * frame.resolution;
        drive::follow(frame, &pieces, start, STEP.max(length / MAX_POSES))
    }

    fn reason(&self) -> Option<String> {
        let at = |pose: Pose| format!("({:.2}, {:.2})", pose.x, pose.y);
        let geometry = &self.world.geometry;
        let space =
            if self.settings.inflation == Inflation::None { "" } else { " or in the safety space around it" };
        Some(match self.report.status {
            Status::Found => return None,
            Status::StartOutside => format!("The start {} is off the map.", at(geometry.start)),
            Status::GoalOutside => format!("The goal {} is off the map.", at(geometry.goal)),
            Status::StartBlocked => format!("The start {} is inside an obstacle{space}.", at(geometry.start)),
            Status::GoalBlocked => format!("The goal {} is inside an obstacle{space}.", at(geometry.goal)),
            Status::BudgetSpent => format!("Stopped after {} expansions.", self.report.expanded),
            Status::NoPath => {
                let near = self.world.frame.center(self.report.closest);
                format!(
                    "No way through: all {} cells that can be reached were searched; the nearest to the goal is ({:.2}, {:.2}).",
                    self.report.generated, near.x, near.y
                )
            }
        })
    }
}

fn outcome(status: Status) -> Outcome {
    match status {
        Status::Found => Outcome::Found,
        Status::NoPath => Outcome::NoPath,
        Status::BudgetSpent => Outcome::BudgetSpent,
        Status::StartBlocked => Outcome::StartBlocked,
        Status::GoalBlocked => Outcome::GoalBlocked,
        Status::StartOutside => Outcome::StartOutside,
        Status::GoalOutside => Outcome::GoalOutside,
    }
}

fn stats(report: &GridReport) -> Stats {
    Stats {
        expanded: report.expanded,
        generated: report.generated,
        pushes: report.pushes,
        open_peak: report.open_peak,
        deferred: Some(report.deferred),
        los_calls: Some(report.los_calls),
        cost_micro: (report.status == Status::Found).then_some(report.cost_micro),
        ..Stats::default()
    }
}

fn metrics(raw: &[Cell], pruned: &[Cell], smoothed: &Smoothed) -> GridMetrics {
    let (turns, turns_pruned) = (cells::turns(raw), cells::turns(pruned));
    GridMetrics {
        length_raw: cells::length(raw),
        length_pruned: cells::length(pruned),
        length_smoothed: smoothed.length,
        turns: turns.count,
        turn_angle_deg: turns.angle_deg,
        turns_pruned: turns_pruned.count,
        turn_angle_deg_pruned: turns_pruned.angle_deg,
        sharp_corners: smoothed.sharp,
        arcs: smoothed.arcs,
        min_radius: smoothed.min_radius,
    }
}
