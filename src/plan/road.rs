//! Cost-map A* in a scene: the car's middle follows chords or a curve, the rest of the car is towed.

use serde_json::{Map, Value};

use super::outcome::{Outcome, Plan, PlanTrace, Stats};
use super::tow::tow;
use super::world::World;
use super::{Driven, NEAR, STEP, measured};
use crate::error::Error;
use crate::geometry::bspline::{Place, Spline};
use crate::geometry::{Point, Pose, Vector};
use crate::metrics::road::{self, RoadMetrics};
use crate::planners::cost_map::{
    Config, CostMap, Curves, Ground, Query, Report, Scratch, Smoothing, Status, Traffic, corners, dense,
    kerb_distances, paper_spline, plan, smooth,
};
use crate::scenario::Scenario;
use crate::search::Watch;

/// A path of more poses than this is sampled less often.
const MAX_POSES: f64 = 50_000.0;
/// The body is tested at places of a curve this far apart, metres.
const STATION: f64 = 0.25;
/// What is longer than this is smoothed at its own scale, metres.
const LARGEST_CAR: f64 = 10.0;
/// How much more a curve may cost by weights than its chords.
const DEARER: f64 = 1.05;
/// Nearer to the ends of a curve only its raster clearance counts, metres.
const ENDS: f64 = 5.0;

/// Cost-map A*, its rasters and its memory.
pub(super) struct Engine {
    config: Config,
    ground: Ground,
    traffic: Traffic,
    costs: CostMap,
    scratch: Scratch,
}

/// What the car's middle follows.
struct Line {
    /// Its chords' ends.
    chords: Vec<Point>,
    curve: Option<Spline>,
    fell_back: bool,
}

impl Engine {
    pub(super) fn new(
        scenario: &Scenario,
        world: &World,
        config: &Map<String, Value>,
    ) -> Result<Self, Error> {
        let config = Config::default().with(config)?;
        config.validate()?;
        let ground = ground(scenario, world);
        let traffic = traffic(scenario, world);
        let costs = costs(scenario, world, &ground, &traffic, &config);
        Ok(Self { config, ground, traffic, costs, scratch: Scratch::default() })
    }

    /// The obstacles have changed.
    pub(super) fn change(&mut self, scenario: &Scenario, world: &World) {
        self.ground = ground(scenario, world);
        self.traffic = traffic(scenario, world);
        self.costs = costs(scenario, world, &self.ground, &self.traffic, &self.config);
    }

    /// Other ends can have other lanes.
    fn turn(&mut self, scenario: &Scenario, world: &World) {
        let traffic = traffic(scenario, world);
        if traffic != self.traffic {
            self.costs = costs(scenario, world, &self.ground, &traffic, &self.config);
            self.traffic = traffic;
        }
    }

    /// Per cell, what a metre costs beyond its length.
    pub(super) fn costs(&self) -> Vec<f32> {
        self.costs.layer()
    }

    pub(super) fn plan(&mut self, scenario: &Scenario, world: &World, mut watch: Watch) -> Plan {
        let mut scratch = std::mem::take(&mut self.scratch);
        self.turn(scenario, world);
        let query = self.query(world);
        let report = plan(&query, &self.config, &mut scratch, &mut watch);
        if let Some(progress) = &mut watch.1 {
            progress.finish(report.expanded);
        }
        let found = report.status == Status::Found;
        let line = self.line(world, &report);
        let driven = if found { drive(world, &line) } else { Driven::default() };
        let mut plan =
            measured(world, outcome(world, &query, report.status), driven, NEAR.max(world.frame.resolution));
        if line.curve.is_none() && line.chords.len() > 2 {
            plan.metrics.max_curvature = None;
        }
        plan.metrics.weighted_length = world.paint().map(|paint| {
            let middle = |pose: &Pose| pose.advance(0.0, world.geometry.vehicle.middle()).point();
            plan.path.windows(2).fold(0.0, |sum, w| sum + paint.along(middle(&w[0]), middle(&w[1])))
        });
        plan.detail = line.fell_back.then_some("smoothing-fell-back");
        plan.reason = reason(&query, &report);
        plan.raw_path = report.cells.iter().map(|&c| world.frame.center(c)).collect();
        plan.stats = stats(&report);
        if found {
            let figures = road::figures(&world.geometry, &world.body, &self.traffic.lanes, &plan.path);
            plan.metrics.road = Some(RoadMetrics {
                cost: report.cost,
                turns_raw: corners(&report.cells).len() as u32,
                turns_pruned: corners(&report.pruned).len() as u32,
                start_moved: report.moved[0],
                goal_moved: report.moved[1],
                bytes: report.bytes as u64,
                figures,
            });
        }
        self.scratch = scratch;
        plan.trace = watch.0.map(|t| PlanTrace::Cells { cells: t.expanded, dropped: t.dropped });
        plan
    }

    fn query(&self, world: &World) -> Query<'_> {
        let [start, goal] = middles(world);
        let radius = radius(world, &self.config);
        Query { ground: &self.ground, costs: &self.costs, radius, start, goal }
    }

    fn line(&self, world: &World, report: &Report) -> Line {
        let chords: Vec<Point> = report.pruned.iter().map(|&c| world.frame.center(c)).collect();
        let (curve, fell_back) = match self.config.smoothing {
            _ if chords.len() < 2 => (None, false),
            Curves::None => (None, false),
            Curves::Paper => (paper_spline(&chords), false),
            Curves::Spline => {
                let limit = world.geometry.vehicle.max_curvature();
                let lever = world.geometry.vehicle.middle();
                let ends = [world.geometry.start, world.geometry.goal];
                let how = Smoothing {
                    sigma: self.config.residual,
                    places: self.config.smooth_points,
                    // Of the middle, where the rear axle's is at its limit.
                    max_curvature: limit / (1.0 + lever * lever * limit * limit).sqrt(),
                    radius: radius(world, &self.config),
                    margin: self.config.margin,
                    ways: ends.map(|end| self.config.headings.then(|| end.direction())),
                    scale: (world.geometry.vehicle.length() / LARGEST_CAR).max(1.0),
                };
                let accept = |spline: &Spline| clear(world, spline) && is_cheap(world, &chords, spline);
                let smooth = smooth(&self.ground, &chords, &how, accept);
                (smooth.spline, smooth.fell_back)
            }
        };
        Line { chords, curve, fell_back }
    }
}

fn traffic(scenario: &Scenario, world: &World) -> Traffic {
    let [start, goal] = middles(world);
    Traffic { lanes: scenario.lanes_between(start, goal), limits: scenario.all_speed_limits() }
}

/// What the car needs to either side, metres.
fn radius(world: &World, config: &Config) -> f64 {
    world.geometry.vehicle.width / 2.0 + config.margin
}

/// Where the map ends a road goes on, a lot has a wall.
fn is_open(scenario: &Scenario) -> bool {
    !scenario.lanes.is_empty()
}

fn costs(scenario: &Scenario, world: &World, ground: &Ground, traffic: &Traffic, config: &Config) -> CostMap {
    let kerb = kerb_distances(&world.frame, &world.geometry, is_open(scenario));
    CostMap::new(ground, &kerb, traffic, radius(world, config), config)
}

/// Where the car's middle starts and shall go.
fn middles(world: &World) -> [Point; 2] {
    let lever = world.geometry.vehicle.middle();
    [world.geometry.start, world.geometry.goal].map(|pose| pose.advance(0.0, lever).point())
}

fn ground(scenario: &Scenario, world: &World) -> Ground {
    let ground = Ground::new(world.frame, &world.geometry, is_open(scenario));
    Ground { weights: world.occupancy.weights().cloned(), ..ground }
}

/// Places of a curve about `step` apart, and the direction there.
fn along(spline: &Spline, step: f64) -> Vec<(Point, Vector)> {
    let rough: Vec<Point> = (0..=200).map(|k| spline.at(f64::from(k) / 200.0).point).collect();
    let length = rough.windows(2).fold(0.0, |sum, w| sum + (w[1] - w[0]).norm());
    // Parameters are not quite lengths.
    let count = (length * 1.25 / step).ceil().max(2.0) as u32;
    let place = |k: u32| {
        let Place { point, first, .. } = spline.at(f64::from(k) / f64::from(count));
        (point, first)
    };
    (0..=count).map(place).collect()
}

/// Whether the curve costs hardly more than the chords, where cells have weights: it strays from them by decimetres.
fn is_cheap(world: &World, chords: &[Point], spline: &Spline) -> bool {
    let Some(paint) = world.paint() else { return true };
    let cost = |points: &[Point]| points.windows(2).fold(0.0, |sum, w| sum + paint.along(w[0], w[1]));
    let places: Vec<Point> = along(spline, STATION).into_iter().map(|place| place.0).collect();
    cost(&places) <= DEARER * cost(chords)
}

/// Whether the towed car touches nothing but at the ends.
fn clear(world: &World, spline: &Spline) -> bool {
    let towed = tow(&world.geometry, &along(spline, STATION));
    let middle = |pose: &Pose| pose.advance(0.0, world.geometry.vehicle.middle()).point();
    let mut stations = vec![0.0];
    for pair in towed.poses.windows(2) {
        stations.push(stations[stations.len() - 1] + (middle(&pair[1]) - middle(&pair[0])).norm());
    }
    let inner = ENDS..=stations[stations.len() - 1] - ENDS;
    let inside = |(pose, station): (&Pose, &f64)| !inner.contains(station) || world.body.hit(*pose).is_none();
    towed.poses.iter().zip(&stations).all(inside)
}

fn drive(world: &World, line: &Line) -> Driven {
    if let [only] = line.chords[..] {
        let heading = world.geometry.start.heading;
        let pose = Pose::new(only.x, only.y, heading).advance(0.0, -world.geometry.vehicle.middle());
        return Driven { poses: vec![pose], directions: vec![1], curvatures: vec![0.0] };
    }
    let length = line.chords.windows(2).fold(0.0, |sum, w| sum + (w[1] - w[0]).norm());
    let step = STEP.max(length * 1.25 / MAX_POSES);
    if let Some(curve) = &line.curve {
        return tow(&world.geometry, &along(curve, step));
    }
    let points = dense(&line.chords, step);
    let way = |i: usize| points[(i + 1).min(points.len() - 1)] - points[i.min(points.len() - 2)];
    let places: Vec<(Point, Vector)> = (0..points.len()).map(|i| (points[i], way(i))).collect();
    tow(&world.geometry, &places)
}

fn outcome(world: &World, query: &Query, status: Status) -> Outcome {
    let outside = |point: Point| world.frame.cell_at(point).is_none();
    match status {
        Status::Found => Outcome::Found,
        Status::NoPath => Outcome::NoPath,
        Status::BudgetSpent => Outcome::BudgetSpent,
        Status::StartBlocked if outside(query.start) => Outcome::StartOutside,
        Status::StartBlocked => Outcome::StartBlocked,
        Status::GoalBlocked if outside(query.goal) => Outcome::GoalOutside,
        Status::GoalBlocked => Outcome::GoalBlocked,
    }
}

fn reason(query: &Query, report: &Report) -> Option<String> {
    let room = |end: &str, at: Point| {
        format!(
            "The car's middle at the {end}, ({:.2}, {:.2}), has no road or obstacles nearer than {:.2} m, and so has everything within 1.5 m.",
            at.x, at.y, query.radius
        )
    };
    Some(match report.status {
        Status::Found => return None,
        Status::StartBlocked => room("start", query.start),
        Status::GoalBlocked => room("goal", query.goal),
        Status::BudgetSpent => format!("Stopped after {} expansions.", report.expanded),
        Status::NoPath => format!(
            "No way through: all {} cells that can be reached with {:.2} m of room to each side were searched.",
            report.generated, query.radius
        ),
    })
}

fn stats(report: &Report) -> Stats {
    Stats {
        expanded: report.expanded,
        generated: report.generated,
        pushes: report.pushes,
        open_peak: report.open_peak,
        memory_bytes: report.bytes as u64,
        ..Stats::default()
    }
}
