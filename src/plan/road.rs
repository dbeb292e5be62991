//! Cost-map A* in a scene: the car's middle follows chords or a curve, the rest of the car is towed.
//!
//! The search finds cells for the *middle of the car*, the point that should keep to the middle of its lane. The car
//! itself is steered at the front and follows its rear axle, so a line for the middle is turned into poses by towing
//! ([`tractrix`]). If the rear axle turns with the curvature κ, the middle, l metres ahead of it, is on a larger
//! circle: its squared radius is 1/κ² + l². That is how the car's limit becomes a limit of the curve.
//!
//! Two searches at most: the first among cells that have the margin; where no curve of that way can be driven, the
//! second among all cells with room for the car, where short room is dear. Counters add up, and the trace has both. A
//! plan that keeps less than the margin says so (`less-margin`) and, where it can be proven, that none keeps it.

use super::engine::{Ask, Engine, LayerData};
use super::measured::{Driven, NEAR, STEP, measured};
use super::outcome::{Detail, Outcome, Plan, PlanTrace, Recorded, Stats};
use super::road_curve::{Curve, ENDS, along};
use super::road_fit::Fit;
use super::tractrix::tractrix;
use super::world::World;
use crate::geometry::bspline::Spline;
use crate::geometry::{Point, Pose, Vector};
use crate::metrics::road::{self, RoadMetrics};
use crate::metrics::{FAR, Verdict};
use crate::planners::cost_map::{
    Config, CostMap, Curves, Query, Report, RoadRasters, Scratch, Smoothing, Traffic, corners, dense,
    is_excluded, kerb_distances, paper_spline, plan, record,
};
use crate::scenario::Scenario;
use crate::search::{SearchStats, Trace};

/// A path of more poses than this is sampled less often.
const MAX_POSES: f64 = 50_000.0;
/// Paths this much below the margin count as keeping it, metres. The check measures poses, the curve was made for
/// places between them.
const MARGIN_TOLERANCE: f64 = 2e-3;
/// Cars longer than this are smoothed at a scale of their own, metres.
const LARGEST_CAR: f64 = 10.0;

/// Cost-map A*, its rasters and its memory.
///
/// Rasters depend on the obstacles, the traffic on the ends as well, the costs on both.
pub(super) struct RoadEngine {
    config: Config,
    ground: RoadRasters,
    traffic: Traffic,
    costs: CostMap,
    scratch: Scratch,
}

/// The line that the middle of the car follows.
struct Line {
    /// Its chords' ends.
    chords: Vec<Point>,
    curve: Option<Spline>,
    fell_back: bool,
}

impl RoadEngine {
    /// Prepares the rasters: distances, lanes, kerbs and speed limits, each linear in the cells.
    pub(super) fn new(scenario: &Scenario, world: &World, config: Config) -> Self {
        let ground = ground(scenario, world);
        let traffic = traffic(scenario, world);
        let costs = costs(scenario, world, &ground, &traffic, &config);
        Self { config, ground, traffic, costs, scratch: Scratch::default() }
    }

    /// Other ends can have other lanes.
    fn turn(&mut self, scenario: &Scenario, world: &World) {
        let traffic = traffic(scenario, world);
        if traffic != self.traffic {
            self.costs = costs(scenario, world, &self.ground, &traffic, &self.config);
            self.traffic = traffic;
        }
    }

    /// The question to the search; with `less`, cells with less than the margin count, too.
    fn query(&self, world: &World, less: bool) -> Query<'_> {
        let [start, goal] = middles(world);
        let radius = radius(world);
        Query { ground: &self.ground, costs: &self.costs, radius, start, goal, less }
    }

    /// The line that the car follows and the checked plan of following it.
    fn driven(&self, world: &World, report: &Report) -> (Line, Plan) {
        let line = self.line(world, report);
        let driven = if report.outcome == Outcome::Found { drive(world, &line) } else { Driven::default() };
        let outcome = outcome(world, &self.query(world, false), report.outcome);
        let plan = measured(world, outcome, driven, NEAR.max(world.frame.resolution));
        (line, plan)
    }

    /// Chords with the curve that replaces them; no curve where the settings ask for none or there is nothing to
    /// smooth.
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
                    radius: radius(world),
                    margin: self.config.kept(),
                    close: false,
                    ways: ends.map(|end| self.config.headings.then(|| end.direction())),
                    scale: (world.geometry.vehicle.length() / LARGEST_CAR).max(1.0),
                };
                let curve = Curve { world, ground: &self.ground, costs: &self.costs, how };
                curve.along(&chords, corners(&report.cells).len() == 2)
            }
        };
        Line { chords, curve, fell_back }
    }
}

impl Engine for RoadEngine {
    /// Search, chords, curve, towing, check and figures. Of the last search at most `steps` steps are written down:
    /// the one whose way the car drives.
    fn plan(&mut self, scenario: &Scenario, world: &mut World, mut ask: Ask) -> Plan {
        let world = &*world;
        let mut observers = ask.observers();
        let mut scratch = std::mem::take(&mut self.scratch);
        self.turn(scenario, world);
        let mut report = plan(&self.query(world, false), &self.config, &mut scratch, &mut observers);
        let (mut line, mut plan) = self.driven(world, &report);
        let is_bad = line.fell_back || plan.check.verdict == Verdict::Collides;
        if report.has_margin && report.outcome == Outcome::Found && is_bad {
            // A way with the margin that no car can drive is none.
            let mut before = observers.0.take();
            observers.0 = before.as_mut().map(Trace::restart);
            let next = self::plan(&self.query(world, true), &self.config, &mut scratch, &mut observers);
            observers.0 = before.zip(observers.0.take()).map(|(before, after)| before.followed_by(after));
            let expanded = report.stats.expanded + next.stats.expanded;
            report = Report { stats: SearchStats { expanded, ..next.stats }, ..next };
            (line, plan) = self.driven(world, &report);
        }
        if let Some(progress) = &mut observers.1 {
            progress.finish(report.stats.expanded);
        }
        if let Some(trace) = &mut observers.0 {
            trace.flush();
        }
        let query = self.query(world, false);
        let found = report.outcome == Outcome::Found;
        if line.curve.is_none() && line.chords.len() > 2 {
            plan.metrics.max_curvature = None;
        }
        plan.metrics.weighted_length = world.paint().map(|paint| {
            let middle = |pose: &Pose| pose.advance(0.0, world.geometry.vehicle.middle()).point();
            plan.path.windows(2).fold(0.0, |sum, w| sum + paint.along(middle(&w[0]), middle(&w[1])))
        });
        plan.detail = line.fell_back.then_some(Detail::SmoothingFellBack);
        plan.reason = reason(&query, &report);
        plan.raw_path = report.cells.iter().map(|&c| world.frame.center(c)).collect();
        plan.stats = Stats::of(report.stats);
        if found {
            let margin = self.config.kept();
            let kept = kept(world, &plan, margin).min(margin);
            let is_short = kept < margin - MARGIN_TOLERANCE;
            if is_short {
                plan.detail = plan.detail.or(Some(Detail::LessMargin));
            }
            let needed = radius(world) + margin - MARGIN_TOLERANCE;
            let fit = Fit::new(world, margin - MARGIN_TOLERANCE);
            let figures = road::figures(&world.geometry, &world.body, &self.traffic.lanes, &plan.path);
            plan.metrics.road = Some(RoadMetrics {
                cost: report.cost,
                turns_raw: corners(&report.cells).len() as u32,
                turns_pruned: corners(&report.pruned).len() as u32,
                start_moved: report.moved[0],
                goal_moved: report.moved[1],
                margin,
                margin_kept: kept,
                margin_excluded: is_short && is_excluded(&self.ground, middles(world), needed, ENDS, &fit),
                bytes: report.stats.bytes,
                figures,
            });
        }
        self.scratch = scratch;
        plan.recorded = ask.record.map(|limit| {
            let recording = record(&self.query(world, false), &report, limit);
            let [width, height] = [world.frame.width, world.frame.height];
            Box::new(Recorded::Cells { width, height, recording })
        });
        plan.trace = observers.0.map(|t| PlanTrace::Cells { cells: t.expanded, dropped: t.dropped });
        plan
    }

    /// Of the costs, per cell what a metre costs beyond its length.
    fn layer(&self, _: &World, name: &str, _: u32) -> Option<LayerData> {
        (name == "cost").then(|| LayerData::Floats(self.costs.layer(&self.ground)))
    }

    fn obstacles_changed(&mut self, scenario: &Scenario, world: &World) {
        self.ground = ground(scenario, world);
        self.traffic = traffic(scenario, world);
        self.costs = costs(scenario, world, &self.ground, &self.traffic, &self.config);
    }
}

/// The least room around the car, metres, without 5 m at the ends, where it stands as it is asked to. At the ends the
/// poses are given and no planner can change the room there.
fn kept(world: &World, plan: &Plan, margin: f64) -> f64 {
    // The check's clearances go no farther.
    let exact: Vec<f64> = if margin < FAR {
        Vec::new()
    } else {
        plan.path.iter().map(|pose| world.body.signed_clearance(*pose, margin + 1.0)).collect()
    };
    let clearances = if exact.is_empty() { &plan.check.clearances } else { &exact };
    let mut station = 0.0;
    let mut stations = vec![station];
    for pair in plan.path.windows(2) {
        station += (pair[1].point() - pair[0].point()).norm();
        stations.push(station);
    }
    let inner = ENDS..=station - ENDS;
    let rooms = clearances.iter().zip(&stations);
    let least =
        rooms.filter(|room| inner.contains(room.1)).fold(f64::INFINITY, |least, room| least.min(*room.0));
    if least.is_finite() { least } else { plan.check.min_clearance }
}

/// Lanes in the direction of travel, and all speed limits.
fn traffic(scenario: &Scenario, world: &World) -> Traffic {
    let [start, goal] = middles(world);
    Traffic { lanes: scenario.lanes_between(start, goal), limits: scenario.all_speed_limits() }
}

/// Half the width that the car needs, metres.
fn radius(world: &World) -> f64 {
    world.geometry.vehicle.width / 2.0
}

/// True if the map's border is open, as on a road; a lot ends at a wall.
fn is_open(scenario: &Scenario) -> bool {
    !scenario.lanes.is_empty()
}

/// The cost per metre of each cell for one direction of travel.
fn costs(
    scenario: &Scenario,
    world: &World,
    ground: &RoadRasters,
    traffic: &Traffic,
    config: &Config,
) -> CostMap {
    let kerb = kerb_distances(&world.frame, &world.geometry, is_open(scenario));
    CostMap::new(ground, &kerb, traffic, radius(world), config)
}

/// Start and goal of the car's middle.
fn middles(world: &World) -> [Point; 2] {
    let lever = world.geometry.vehicle.middle();
    [world.geometry.start, world.geometry.goal].map(|pose| pose.advance(0.0, lever).point())
}

/// Distances to obstacles and kerbs, with the weights that the scene paints.
fn ground(scenario: &Scenario, world: &World) -> RoadRasters {
    let ground = RoadRasters::new(world.frame, &world.geometry, is_open(scenario));
    RoadRasters { weights: world.occupancy.weights().cloned(), ..ground }
}

/// The towed car's poses along the line, [`STEP`] apart or farther on very long roads.
fn drive(world: &World, line: &Line) -> Driven {
    if let [only] = line.chords[..] {
        let heading = world.geometry.start.heading;
        let pose = Pose::new(only.x, only.y, heading).advance(0.0, -world.geometry.vehicle.middle());
        return Driven { poses: vec![pose], directions: vec![1], curvatures: vec![0.0] };
    }
    let length = line.chords.windows(2).fold(0.0, |sum, w| sum + (w[1] - w[0]).norm());
    let step = STEP.max(length * 1.25 / MAX_POSES);
    if let Some(curve) = &line.curve {
        return tractrix(&world.geometry, &along(curve, step));
    }
    let points = dense(&line.chords, step);
    let way = |i: usize| points[(i + 1).min(points.len() - 1)] - points[i.min(points.len() - 2)];
    let places: Vec<(Point, Vector)> = (0..points.len()).map(|i| (points[i], way(i))).collect();
    tractrix(&world.geometry, &places)
}

/// A blocked end that lies outside the map is told as such.
fn outcome(world: &World, query: &Query, outcome: Outcome) -> Outcome {
    let outside = |point: Point| world.frame.cell_at(point).is_none();
    match outcome {
        Outcome::StartBlocked if outside(query.start) => Outcome::StartOutside,
        Outcome::GoalBlocked if outside(query.goal) => Outcome::GoalOutside,
        outcome => outcome,
    }
}

/// The outcome in a sentence with places and rooms in metres; `None` where there is a path. The search moves an end by
/// 1.5 m at most to find room, which is why the sentence names that distance.
fn reason(query: &Query, report: &Report) -> Option<String> {
    let room = |end: &str, at: Point| {
        format!(
            "The car's middle at the {end}, ({:.2}, {:.2}), has no road or obstacles nearer than {:.2} m, and so has \
             everything within 1.5 m.",
            at.x, at.y, query.radius
        )
    };
    Some(match report.outcome {
        Outcome::Found => return None,
        Outcome::StartBlocked | Outcome::StartOutside => room("start", query.start),
        Outcome::GoalBlocked | Outcome::GoalOutside => room("goal", query.goal),
        Outcome::BudgetSpent => format!("Stopped after {} expansions.", report.stats.expanded),
        Outcome::NoPath => format!(
            "No way through: all {} cells that can be reached with {:.2} m of room to each side were searched.",
            report.stats.generated, query.radius
        ),
    })
}
