//! From a scene and settings to a checked plan: the only place that joins all the rest.

mod drive;
mod grid;
mod hybrid;
mod outcome;
mod settings;
mod world;

pub use outcome::{GridMetrics, HybridMetrics, Metrics, Outcome, Plan, PlanTrace, Stats};

use serde_json::{Map, Value};

use crate::error::{Error, ErrorCode};
use crate::geometry::Pose;
use crate::map::{distance, inflation};
use crate::metrics::{Body, Check, check};
use crate::planners::registry::{Kind, default_config};
use crate::scenario::Scenario;
use crate::scenario::resolve::Geometry;
use world::World;

/// Poses of a path are this close together, metres.
const STEP: f64 = 0.1;
/// Events that a trace keeps.
const TRACE: usize = 1_000_000;
/// How far from the goal a car's path may end, metres.
const NEAR: f64 = 1e-3;

/// What is asked besides the path.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options {
    /// Whether to keep where the search went.
    pub trace: bool,
}

/// A raster for drawing, row-major from the south-western cell.
#[derive(Debug, Clone)]
pub struct Layer {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The values.
    pub data: LayerData,
}

/// The values of a [`Layer`].
#[derive(Debug, Clone)]
pub enum LayerData {
    /// One byte per cell.
    Bytes(Vec<u8>),
    /// One or two numbers per cell.
    Floats(Vec<f32>),
}

enum Engine {
    Grid(Box<grid::Engine>),
    Hybrid(Box<hybrid::Engine>),
}

/// A planner on one scene: settings checked once, map prepared once, memory reused between plans.
///
/// # Examples
/// ```
/// let scene = parkade::scenario::catalog::scenario("P3").unwrap();
/// let mut planner = parkade::plan::Planner::new("hybrid", &scene, &Default::default()).unwrap();
/// let plan = planner.plan(Default::default());
/// assert!(plan.metrics.length < 23.25);
/// ```
pub struct Planner {
    kind: Kind,
    scenario: Scenario,
    world: World,
    engine: Engine,
}

impl Planner {
    /// Prepares the planner `id` on a scene. `config` is laid over the scene's own settings for it, and those over the
    /// planner's defaults.
    ///
    /// # Errors
    /// What is wrong with the scene or the settings, by field, value and rule.
    pub fn new(id: &str, scenario: &Scenario, config: &Map<String, Value>) -> Result<Self, Error> {
        let kind = Kind::of(id)?;
        let mut settings = default_config(id)?;
        let own = scenario.planners.get(id);
        for (name, value) in own.into_iter().flatten().chain(config) {
            if settings.insert(name.clone(), value.clone()).is_none() {
                let known: Vec<_> = default_config(id)?.keys().cloned().collect();
                let message = format!("no setting of {id}; there are {}", known.join(", "));
                return Err(Error::new(ErrorCode::Config, name.clone(), message));
            }
        }
        for (name, other) in scenario.planners.iter().filter(|p| p.0 != id) {
            let known = default_config(name)
                .map_err(|e| Error { code: ErrorCode::Scenario, ..e.within("planners") })?;
            if let Some(stranger) = other.keys().find(|k| !known.contains_key(*k)) {
                let path = format!("planners.{name}.{stranger}");
                return Err(Error::new(ErrorCode::Scenario, path, format!("no setting of {name}")));
            }
        }
        let world = World::new(scenario)?;
        let engine = match kind {
            Kind::Hybrid | Kind::HybridForward => {
                Engine::Hybrid(Box::new(hybrid::Engine::new(&world, settings::settings(&settings)?)?))
            }
            _ => Engine::Grid(Box::new(grid::Engine::new(&world, kind, &settings)?)),
        };
        Ok(Self { kind, scenario: scenario.clone(), world, engine })
    }

    /// The scene.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The scene's geometry.
    pub fn geometry(&self) -> &Geometry {
        &self.world.geometry
    }

    /// Plans, and checks the answer.
    pub fn plan(&mut self, options: Options) -> Plan {
        let mut plan = match &mut self.engine {
            Engine::Grid(engine) => engine.plan(&self.world, options),
            Engine::Hybrid(engine) => engine.plan(&self.scenario, &self.world, options),
        };
        plan.planner = self.kind.id();
        plan
    }

    /// A raster: `occupancy`, `safety`, `clearance` or `risk`.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] for another name, and for `risk` of a planner without a field.
    pub fn layer(&self, name: &str) -> Result<Layer, Error> {
        let map = &self.world.occupancy;
        let data = match (name, &self.engine) {
            ("occupancy", _) => LayerData::Bytes(cells(&self.world)),
            ("safety", _) => {
                let radius = self.world.geometry.vehicle.width / 2.0 / self.world.frame.resolution;
                let inflated = inflation::necessary(map, radius);
                LayerData::Bytes(inflation::layer(map, &inflated).data)
            }
            ("clearance", _) => LayerData::Floats(distance::clearance(map, self.world.frame.resolution).data),
            ("risk", Engine::Grid(engine)) if self.kind == Kind::RiskField => {
                LayerData::Floats(engine.field(&self.world))
            }
            ("risk", _) => {
                let message = format!("{} has no risk field; risk-field has", self.kind.id());
                return Err(Error::new(ErrorCode::Input, "name", message));
            }
            _ => {
                let message = format!("must be occupancy, safety, clearance or risk, got \"{name}\"");
                return Err(Error::new(ErrorCode::Input, "name", message));
            }
        };
        Ok(Layer { width: map.width(), height: map.height(), data })
    }
}

fn cells(world: &World) -> Vec<u8> {
    let map = &world.occupancy;
    (0..map.len() as u32).map(|i| u8::from(map.blocked(map.cell(i)))).collect()
}

/// Poses of a path, whatever made it.
#[derive(Debug, Default)]
struct Driven {
    poses: Vec<Pose>,
    directions: Vec<i8>,
    curvatures: Vec<f64>,
}

/// The plan of a path, checked and measured.
fn measured(world: &World, outcome: Outcome, driven: Driven, near: f64) -> Plan {
    let Driven { poses, directions, curvatures } = driven;
    let check = check(&world.geometry, &world.body, &poses, &directions, near);
    let corner = check.tightest_radius == 0.0;
    let max_curvature = curvatures.iter().filter(|k| !k.is_nan()).fold(0.0_f64, |max, k| max.max(k.abs()));
    let metrics = Metrics {
        length: outcome::path_length(&poses),
        direction_changes: outcome::direction_changes(&directions),
        max_curvature: (!corner).then_some(max_curvature),
        curvature_limit: world.geometry.vehicle.max_curvature(),
        min_clearance: check.min_clearance,
        mean_clearance: check.mean_clearance,
        grid: None,
        hybrid: None,
    };
    Plan {
        planner: "",
        outcome,
        detail: None,
        reason: None,
        path: poses,
        directions,
        curvatures,
        raw_path: Vec::new(),
        stats: Stats::default(),
        metrics,
        check,
        trace: None,
    }
}

/// Re-checks any path against a scene: x, y, heading, … and the gear of the way on from each pose (forward where
/// absent).
///
/// # Errors
/// [`ErrorCode::Input`] when the numbers are not poses or the gears not ±1.
pub fn check_path(geometry: &Geometry, path: &[f64], directions: Option<&[i8]>) -> Result<Check, Error> {
    if !path.len().is_multiple_of(3) {
        let message = format!("must be x, y, heading for each pose, got {} numbers", path.len());
        return Err(Error::new(ErrorCode::Input, "path", message));
    }
    if let Some(i) = path.iter().position(|v| !v.is_finite()) {
        let message = format!("must be a finite number, got {}", path[i]);
        return Err(Error::new(ErrorCode::Input, format!("path[{i}]"), message));
    }
    let poses: Vec<Pose> = path.chunks_exact(3).map(|p| Pose::new(p[0], p[1], p[2])).collect();
    let forward = vec![1; poses.len()];
    let directions = directions.unwrap_or(&forward);
    if directions.len() != poses.len() {
        let message = format!("must be one per pose ({}), got {}", poses.len(), directions.len());
        return Err(Error::new(ErrorCode::Input, "directions", message));
    }
    if let Some(i) = directions.iter().position(|d| d.abs() != 1) {
        let message = format!("must be 1 or -1, got {}", directions[i]);
        return Err(Error::new(ErrorCode::Input, format!("directions[{i}]"), message));
    }
    Ok(check(geometry, &Body::new(geometry), &poses, directions, NEAR))
}
