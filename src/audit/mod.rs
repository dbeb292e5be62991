//! Which bays of a lot can be reached, by which vehicle, and in how many moves.
//!
//! An audit asks one question for each bay, vehicle, entrance and entry: can the vehicle drive in, and out again? Each
//! answer is that of hybrid A* between two poses and depends on nothing else, so parts of the job give exactly the
//! rows of the whole, in any order and on any number of workers. What the questions have in common is prepared once:
//! the obstacles, and the way around them to each entrance.
//!
//! The number of questions is bays × vehicles × entrances × entries, with one search each and one more for the way out.
//! Their order (bay, vehicle, entrance, entry) is part of the contract: rows of parts, joined by bay, are the rows of
//! the whole, byte for byte. No time and no thread takes part, and budgets count expansions.
//!
//! A bay is *reachable* only where the planner found a path **and** the independent validator
//! ([`crate::metrics::check()`]) accepts it. An unreachable bay may be proven (`no-path`, with the reason and the
//! place) or not (`budget-spent`). All lengths are metres, poses are those of the rear axle in the world frame.

mod affected;
mod options;
mod row;
pub mod standards;

use std::ops::ControlFlow;

use serde_json::{Map, Value};

pub use affected::{Known, affected};
pub use options::{AuditVehicle, Entrance, Options, WhatIf};
pub use row::{Row, Way};

use crate::error::Error;
use crate::geometry::Pose;
use crate::plan::{self, Ends, Planner, Site};
use crate::scenario::{Entry, Scenario, Slot};
use crate::vehicle::Vehicle;

/// The planner of ways in, from the bay: to leave a bay is easier than to find it.
const IN: &str = "hybrid";
/// The planner of ways out, from the bay as well.
const OUT: &str = "hybrid-forward";

/// Audits the bays of a scene: the rows bay by bay, and for each bay by vehicle, entrance and entry.
///
/// `each` is given every row as soon as it is known; where it breaks, the audit ends with the rows so far.
///
/// Memory holds one planner pair for each vehicle, and one more while an occupied bay is asked as if it were free. Who
/// asks in parts keeps an [`Auditor`].
///
/// # Errors
/// A wrong scene or option, named by field, value and rule.
///
/// # Examples
/// ```
/// use parkade::audit::{Options, audit};
/// use parkade::scenario::catalog;
///
/// let scene = catalog::scenario("perpendicular").unwrap();
/// let options = Options::of(&scene, &serde_json::json!({ "vehicles": ["sedan"] })).unwrap();
/// let rows = audit(&scene, &options, &mut |_| std::ops::ControlFlow::Continue(())).unwrap();
/// assert!(rows.iter().all(|row| row.way.reachable && row.way.moves >= 1));
/// ```
pub fn audit(
    scene: &Scenario,
    options: &Options,
    each: &mut dyn FnMut(&Row) -> ControlFlow<()>,
) -> Result<Vec<Row>, Error> {
    Auditor::new(scene, options)?.rows(options, each)
}

/// Audits parts of one job: what their questions have in common is prepared once.
///
/// # Examples
/// ```
/// use std::ops::ControlFlow;
/// use parkade::audit::{Auditor, Options, audit};
///
/// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
/// let whole = Options::of(&scene, &serde_json::json!({ "whatIf": "each-free" })).unwrap();
/// let mut auditor = Auditor::new(&scene, &whole).unwrap();
/// let mut rows = Vec::new();
/// for bays in whole.bays.chunks(2) {
///     let part = Options { bays: bays.to_vec(), ..whole.clone() };
///     assert!(auditor.serves(&scene, &part));
///     rows.extend(auditor.rows(&part, &mut |_| ControlFlow::Continue(())).unwrap());
/// }
/// assert_eq!(rows, audit(&scene, &whole, &mut |_| ControlFlow::Continue(())).unwrap());
/// ```
pub struct Auditor {
    /// The scene and the settings as a text.
    key: String,
    vehicles: Vec<AuditVehicle>,
    /// One for each vehicle.
    askers: Vec<Asker>,
}

impl Auditor {
    /// Prepares a scene for the vehicles and settings of some options.
    ///
    /// # Errors
    /// A wrong scene or setting, named by field, value and rule.
    pub fn new(scene: &Scenario, options: &Options) -> Result<Self, Error> {
        let mut askers = Vec::new();
        for vehicle in &options.vehicles {
            askers.push(Asker::new(scene, vehicle, &options.settings)?);
        }
        Ok(Self { key: key(scene, options), vehicles: options.vehicles.clone(), askers })
    }

    /// True if this was prepared for the same scene, vehicles and settings.
    pub fn serves(&self, scene: &Scenario, options: &Options) -> bool {
        self.vehicles == options.vehicles && self.key == key(scene, options)
    }

    /// The rows of the bays, entrances and entries in `options`, in the order of [`audit`].
    ///
    /// # Errors
    /// None for options that this [serves](Auditor::serves).
    pub fn rows(
        &mut self,
        options: &Options,
        each: &mut dyn FnMut(&Row) -> ControlFlow<()>,
    ) -> Result<Vec<Row>, Error> {
        let mut rows = Vec::new();
        for &bay in &options.bays {
            for (vehicle, shared) in self.vehicles.iter().zip(&mut self.askers) {
                let is_occupied = shared.way_in.scenario().slots[bay].occupied;
                if is_occupied && options.what_if == WhatIf::AsIs {
                    continue;
                }
                let mut own = None;
                if is_occupied {
                    own = Some(shared.with_free(bay)?);
                }
                let asker = own.as_mut().unwrap_or(shared);
                for entrance in &options.entrances {
                    for &entry in &options.entries {
                        let row = asker.row(bay, (vehicle, entrance, entry), options.out);
                        let flow = each(&row);
                        rows.push(row);
                        if flow.is_break() {
                            return Ok(rows);
                        }
                    }
                }
            }
        }
        Ok(rows)
    }
}

/// What an auditor depends on besides the vehicles.
fn key(scene: &Scenario, options: &Options) -> String {
    serde_json::json!([scene, options.settings]).to_string()
}

/// The name of a bay: its id, or its number from 1.
pub fn bay_name(slot: &Slot, index: usize) -> String {
    slot.id.clone().unwrap_or_else(|| format!("#{}", index + 1))
}

/// One vehicle among the obstacles of a scene.
///
/// Its planners share the obstacles of the scene and, from question to question, the ways around them.
struct Asker {
    site: Site,
    settings: Map<String, Value>,
    way_in: Planner,
    way_out: Planner,
    /// How far a vehicle's rear axle is ahead of that of the scene's car when their tails stand in one place, metres.
    ahead: f64,
}

impl Asker {
    /// Prepares a site for one vehicle. Entrances are poses of the scene's own car; a vehicle with a longer tail starts
    /// farther ahead by the difference, so that all tails stand in the same place.
    fn new(scene: &Scenario, vehicle: &AuditVehicle, settings: &Map<String, Value>) -> Result<Self, Error> {
        let own = scene.vehicle.resolve().map_err(|e| e.within("vehicle"))?;
        let mut scene = scene.clone();
        scene.vehicle = crate::scenario::VehicleSpec::Custom(vehicle.vehicle);
        // Ends are named in every question; a set of goals would be resolved for nothing.
        scene.goal = crate::scenario::Goal::Pose(scene.start);
        let mut settings = settings.clone();
        for (name, value) in scene.planners.remove(IN).unwrap_or_default() {
            settings.entry(name).or_insert(value);
        }
        Self::on(Site::new(&scene)?, settings, vehicle.vehicle.rear_to_back - own.rear_to_back)
    }

    /// The same where the car in an occupied slot is gone.
    fn with_free(&self, slot: usize) -> Result<Self, Error> {
        Self::on(self.site.with_free_slot(slot)?, self.settings.clone(), self.ahead)
    }

    #[inline(never)]
    fn on(site: Site, settings: Map<String, Value>, ahead: f64) -> Result<Self, Error> {
        let way_in = site.planner(IN, &settings)?;
        let mut outward = settings.clone();
        outward.remove("searchFrom");
        let way_out = site.planner(OUT, &outward)?;
        Ok(Self { site, settings, way_in, way_out, ahead })
    }

    /// The answer to one question. The start is the entrance's pose moved by `ahead`, the goal the bay's pose for this
    /// vehicle and entry.
    fn row(
        &mut self,
        bay: usize,
        (vehicle, entrance, entry): (&AuditVehicle, &Entrance, Entry),
        out: bool,
    ) -> Row {
        let slot = self.way_in.scenario().slots[bay].clone();
        let start = along(entrance.pose, self.ahead);
        let goal = slot.pose(entry, &vehicle.vehicle);
        let way = ask(&mut self.way_in, start, goal);
        let exit =
            entrance.exit.map_or_else(|| turned(start, &vehicle.vehicle), |exit| along(exit, self.ahead));
        let out = out.then(|| ask(&mut self.way_out, goal, exit));
        Row {
            bay: bay_name(&slot, bay),
            index: bay,
            vehicle: vehicle.id.clone(),
            entrance: entrance.id.clone(),
            entry,
            overhang: slot.overhang(&vehicle.vehicle),
            way,
            out,
        }
    }
}

/// The plan between two poses, which start and goal of the scene do not influence. A question that the planner refuses
/// is a way out of reach with the error as its reason; it does not end the audit.
fn ask(planner: &mut Planner, start: Pose, goal: Pose) -> Way {
    let ends = Ends { start: Some(start), goal: Some(goal) };
    match planner.plan_between(ends, plan::Options::default()) {
        Ok(plan) => Way::of(planner, &plan),
        Err(error) => Way::refused(error.to_string()),
    }
}

/// The pose moved forward by `ahead` metres, heading unchanged.
fn along(pose: Pose, ahead: f64) -> Pose {
    let at = pose.point() + pose.direction() * ahead;
    Pose::new(at.x, at.y, pose.heading)
}

/// The same rectangle of floor with the nose at the other end.
fn turned(pose: Pose, vehicle: &Vehicle) -> Pose {
    let at = pose.point() + pose.direction() * (2.0 * vehicle.middle());
    Pose::new(at.x, at.y, crate::geometry::math::wrap(pose.heading + crate::geometry::math::PI))
}
