//! From a scene and settings to a checked plan: the only place that joins all the rest.
//!
//! A [`Planner`] is made once for a scene and settings, and asked any number of times. Making it validates both and
//! prepares the map; a plan then runs, in this order, the search, post-processing, sampling of poses, the
//! independent check and the figures. Start and goal can be moved and cells brushed between plans without preparing
//! the map again.
//!
//! The result is always a [`Plan`]. Its [`Outcome`] says whether there is a path; errors are for wrong input only.
//! Lengths are in metres, headings in radians counter-clockwise from east, poses are the middle of the rear axle.

mod brush;
mod choices;
mod edits;
mod engine;
mod goals;
mod grid;
mod hybrid;
mod hybrid_answer;
mod layers;
mod measured;
#[cfg(not(target_arch = "wasm32"))]
mod options;
mod outcome;
mod path;
mod path_sampling;
mod queries;
mod rasters;
mod road;
mod road_curve;
mod road_fit;
#[cfg(not(target_arch = "wasm32"))]
mod serialize;
mod site;
mod stages;
mod tractrix;
mod world;

pub use choices::Improved;
pub use engine::LayerData;
pub use layers::Layer;
pub use outcome::{Detail, GridMetrics, HybridMetrics, Metrics, Outcome, Plan, PlanTrace, Stats};
pub use outcome::{Member, Recorded};
pub use path::check_path;
pub use path::{collision_risk, drive_envelope, optimise, path_poses, road_figures, route};
pub(crate) use site::Site;
pub use stages::{Stages, TangentArc};

pub use crate::planners::hybrid::Prefer;
pub use crate::search::ProgressCallback;
pub use queries::{Ends, Found};

use std::num::NonZeroU32;

use serde_json::{Map, Value};

use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::geometry::Pose;
use crate::planners::registry::{Family, PlannerId, Settings, default_config};
use crate::scenario::Goals;
use crate::scenario::Scenario;
use crate::scenario::resolve::Geometry;
use crate::search::Progress;
pub use crate::search::{ExpansionCallback, Expansions};
use crate::{geometry::Point, planners::risk_field::Explanation};
use engine::{Ask, Engine};
use world::World;

/// Steps of a search that are recorded with all they did, where no other number is asked for.
pub const RECORDED_STEPS: usize = 100_000;
/// Expansions of cells from one [`Options::progress`] to the next.
const CELLS: NonZeroU32 = NonZeroU32::new(1 << 14).unwrap();
/// The same of a car's poses, which take longer.
const POSES: NonZeroU32 = NonZeroU32::new(1 << 8).unwrap();
/// Options of a plan besides the path itself.
#[derive(Default)]
pub struct Options<'a> {
    /// True to keep the search trace.
    pub trace: bool,
    /// Steps of the search to keep with all they did ([`Plan::recorded`]).
    pub record: Option<usize>,
    /// Told of the expansions so far each 16 384 cells, or 256 poses of a car, and never of more than
    /// [`Stats::expanded`]. The plan is the same with and without; where it breaks, the search ends as if its budget
    /// were spent.
    pub progress: Option<ProgressCallback<'a>>,
    /// Given the expansions of each search that is traced, a few at a time while it runs; only beside `progress`.
    /// Numbers are arcs as in [`PlanTrace::Arcs`].
    pub expansions: Option<ExpansionCallback<'a>>,
    /// The preference by which hybrid A* chooses its path; `None` for the default cost.
    pub prefer: Option<Prefer>,
    /// True if alternatives to hybrid A*'s path are searched as well: [`Plan::alternatives`].
    pub alternatives: bool,
    /// How much cheaper another path of hybrid A*'s must be than this planner's last one, led to the new ends, to take
    /// its place: a share of its cost. With 0 the last plan does not matter.
    pub stickiness: f64,
    /// Given hybrid A*'s first plan, and each one that is better. Where it breaks, the last one is the answer.
    pub improved: Option<Improved<'a>>,
}

impl Options<'_> {
    /// The first of the options that ask for a choice.
    fn choice(&self) -> Option<&'static str> {
        let asked = [
            (self.prefer.is_some(), "prefer"),
            (self.alternatives, "alternatives"),
            (self.improved.is_some(), "onImproved"),
            (self.stickiness > 0.0, "stickiness"),
        ];
        asked.into_iter().find(|choice| choice.0).map(|choice| choice.1)
    }
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
    kind: PlannerId,
    scenario: Scenario,
    /// Its `geometry` has the ends of the last plan.
    world: World,
    /// The scene's start and goal.
    own_ends: [Pose; 2],
    /// The scene's goals, where it has a set of them.
    own_goals: Option<Goals>,
    engine: Box<dyn Engine>,
    brush: Option<brush::Brush>,
}

impl Planner {
    /// Prepares the planner `id` on a scene. `config` is laid over the scene's own settings for it, and those over the
    /// planner's defaults.
    ///
    /// # Errors
    /// A wrong scene or setting, named by field, value and rule.
    pub fn new(id: &str, scenario: &Scenario, config: &Map<String, Value>) -> Result<Self, Error> {
        Self::owning(id, scenario.clone(), config)
    }

    /// The same with a scene that is given away.
    pub(crate) fn owning(id: &str, scenario: Scenario, config: &Map<String, Value>) -> Result<Self, Error> {
        let kind = PlannerId::of(id)?;
        let settings = settings(kind, &scenario, config)?;
        let world = World::new(&scenario)?;
        let engine = engine(kind, settings, &scenario, &world)?;
        Ok(Self::of_parts(kind, scenario, world, engine))
    }

    /// A planner of a world that is prepared. The scene's own ends are kept apart, because a plan may ask between
    /// others.
    fn of_parts(kind: PlannerId, scenario: Scenario, mut world: World, engine: Box<dyn Engine>) -> Self {
        Self {
            kind,
            scenario,
            own_ends: [world.geometry.start, world.geometry.goal],
            own_goals: world.geometry.goals.take(),
            world,
            engine,
            brush: None,
        }
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
    ///
    /// Plans depend on the scene and the settings alone: any number of calls give the same bytes. The exception is
    /// `stickiness` above 0, with which the last plan counts, too.
    pub fn plan(&mut self, options: Options) -> Plan {
        self.between(self.own_ends[0], None, options)
    }

    /// To the scene's own goal, or to the cheapest of them, where none is given.
    fn between(&mut self, start: Pose, goal: Option<Pose>, options: Options) -> Plan {
        if IS_COMPLETE {
            self.sync();
        }
        if IS_COMPLETE && let Some(goals) = self.own_goals.take_if(|_| goal.is_none()) {
            let plan = self.plan_any(start, &goals, options);
            self.own_goals = Some(goals);
            return plan;
        }
        self.toward([start, goal.unwrap_or(self.own_ends[1])], options)
    }

    /// Searches between two poses, which become the ends of the world until the next plan.
    fn toward(&mut self, ends: [Pose; 2], options: Options) -> Plan {
        [self.world.geometry.start, self.world.geometry.goal] = ends;
        let every = if self.kind.family() == Family::Hybrid { POSES } else { CELLS };
        let progress = options.progress.map(|tell| Progress::new(every, tell).telling(options.expansions));
        let wish = choices::Wish {
            prefer: options.prefer,
            alternatives: options.alternatives,
            improved: options.improved,
            stickiness: options.stickiness,
        };
        let ask = Ask {
            is_traced: options.trace,
            progress,
            record: options.record,
            expansions: options.expansions,
            wish,
        };
        let mut plan = self.engine.plan(&self.scenario, &mut self.world, ask);
        plan.planner = self.kind.id();
        plan
    }

    /// About how long this planner's path takes to drive as it is, seconds; infinite where it cannot be told. It uses
    /// default limits without a limit of jerk; [`optimise`] gives the time of a trajectory that a car can follow.
    pub fn driving_time(&self, plan: &Plan) -> f64 {
        choices::estimated_time(plan, &self.world.geometry, &self.scenario.all_speed_limits())
    }

    /// Explains the risk field at the cell of a point (metres): force, region and candidates in the paper's terms.
    /// `None` off the map and in blocked cells.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] for a planner without a risk field, and for coordinates that are not finite.
    ///
    /// # Examples
    /// ```
    /// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
    /// let planner = |id| parkade::plan::Planner::new(id, &scene, &Default::default()).unwrap();
    /// assert!(planner("risk-field").explain(scene.start.x, scene.start.y).unwrap().is_some());
    /// assert!(planner("eight").explain(0.0, 0.0).is_err());
    /// ```
    pub fn explain(&self, x: f64, y: f64) -> Result<Option<Explanation>, Error> {
        for (name, value) in [("x", x), ("y", y)] {
            if !value.is_finite() {
                return Err(Error::new(
                    ErrorCode::Input,
                    name,
                    message!("must be a finite number, got {}", value),
                ));
            }
        }
        if !self.kind.has_risk_field() {
            let message = message!("{} has no risk field; risk-field has", self.kind.id());
            return Err(Error::new(ErrorCode::Input, "planner", message));
        }
        Ok(self.engine.explain(&self.world, Point::new(x, y)))
    }
}

/// A planner's settings: its defaults, below the scene's, below `config`.
///
/// # Errors
/// A wrong setting of this planner, or one in the scene that its planner does not have.
fn settings(kind: PlannerId, scenario: &Scenario, config: &Map<String, Value>) -> Result<Settings, Error> {
    let mut settings = scenario.planners.get(kind.id()).cloned().unwrap_or_default();
    settings.extend(config.clone());
    for (name, other) in scenario.planners.iter().filter(|p| p.0 != kind.id()) {
        let known = default_config(name).map_err(|e| e.within("planners").with_code(ErrorCode::Scenario))?;
        if let Some(stranger) = other.keys().find(|k| !known.contains_key(*k)) {
            let path = format!("planners.{name}.{stranger}");
            return Err(Error::new(ErrorCode::Scenario, path, message!("no setting of {}", name)));
        }
    }
    kind.settings(&settings)
}

/// The engine of a planner's family on a scene.
///
/// # Errors
/// [`ErrorCode::Config`] or [`ErrorCode::Input`] where the family refuses the scene.
fn engine(
    planner: PlannerId,
    settings: Settings,
    scenario: &Scenario,
    world: &World,
) -> Result<Box<dyn Engine>, Error> {
    Ok(match settings {
        Settings::Grid(search) => Box::new(grid::GridEngine::new(world, planner, search)?),
        Settings::Hybrid(config) => Box::new(hybrid::HybridEngine::new(world, planner, config)?),
        Settings::Road(config) if IS_COMPLETE => Box::new(road::RoadEngine::new(scenario, world, config)),
        Settings::Road(_) => unreachable!("no planner of the small module has these settings"),
    })
}
