//! What an audit is asked.
//!
//! Options name the vehicles, the entrances and the entries; their product with the bays is the list of questions,
//! whose order does not depend on how it is divided among workers.
//!
//! Absent fields have defaults: the scene's car, its start as the only entrance, both entries, all bays, ways out
//! asked, occupied bays left out. A field that is present must be valid in full; nothing is clamped or skipped.

use serde_json::{Map, Value};

use crate::error::{Error, ErrorCode};
use crate::geometry::Pose;
use crate::json::{Fields, bad, flag, list, object, owned, word};
use crate::scenario::{Entry, Scenario, VehicleSpec, checks, places, vehicle_spec};
use crate::vehicle::{Vehicle, library};

/// The name of the scene's own car where it has none.
const OWN: &str = "scene";
/// Most vehicles, entrances, and bays in one list.
const MAX_ITEMS: usize = 10_000;

/// A vehicle and its name in the rows.
#[derive(Debug, Clone, PartialEq)]
pub struct AuditVehicle {
    /// The id in the library, a profile's name, or one that the caller chose.
    pub id: String,
    /// Its dimensions.
    pub vehicle: Vehicle,
}

/// Where vehicles come from, and where they leave.
#[derive(Debug, Clone, PartialEq)]
pub struct Entrance {
    /// Its name in the rows.
    pub id: String,
    /// Pose of the scene's car. Other vehicles stand with their tail in the same place.
    pub pose: Pose,
    /// Pose in which they leave; where absent, the entrance's with the nose at the other end.
    pub exit: Option<Pose>,
}

/// How occupied bays are asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WhatIf {
    /// They are left out.
    AsIs,
    /// Each as if it were free, and the others as they are.
    EachFree,
}

/// The questions of an audit.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Each vehicle, in the order of the rows.
    pub vehicles: Vec<AuditVehicle>,
    /// Each way to stand in a bay.
    pub entries: Vec<Entry>,
    /// How occupied bays are asked.
    pub what_if: WhatIf,
    /// Each entrance.
    pub entrances: Vec<Entrance>,
    /// Indices of the bays, ascending.
    pub bays: Vec<usize>,
    /// True if ways out are asked as well.
    pub out: bool,
    /// Settings of hybrid A*, laid over the scene's.
    pub settings: Map<String, Value>,
}

impl Options {
    /// Reads options for a scene: `vehicles`, `entries`, `whatIf`, `entrances`, `bays`, `out`, `settings`.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] with the field and the rule; [`ErrorCode::Vehicle`] for impossible dimensions.
    ///
    /// # Examples
    /// ```
    /// use parkade::audit::{Options, WhatIf};
    ///
    /// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
    /// let options = Options::of(&scene, &serde_json::json!({ "bays": [0], "whatIf": "each-free" })).unwrap();
    /// assert_eq!((options.what_if, options.vehicles.len(), options.entries.len()), (WhatIf::EachFree, 1, 2));
    /// let error = Options::of(&scene, &serde_json::json!({ "bays": [999] })).unwrap_err();
    /// assert!(error.to_string().contains("bays"));
    /// ```
    pub fn of(scene: &Scenario, value: &Value) -> Result<Self, Error> {
        scene.validate()?;
        let f =
            Fields::of(value, &["vehicles", "entries", "whatIf", "entrances", "bays", "out", "settings"])?;
        let vehicles = f.maybe("vehicles", list(vehicle))?;
        let vehicles = match vehicles {
            Some(vehicles) => vehicles,
            None => vec![own(scene)?],
        };
        distinct("vehicles", vehicles.iter().map(|one| &one.id))?;
        let entrances = f
            .maybe("entrances", list(entrance))?
            .unwrap_or_else(|| vec![Entrance { id: "start".to_owned(), pose: scene.start, exit: None }]);
        distinct("entrances", entrances.iter().map(|one| &one.id))?;
        let words = word(&[("head-in", Entry::HeadIn), ("reverse-in", Entry::ReverseIn)]);
        let mut entries =
            f.maybe("entries", list(words))?.unwrap_or_else(|| vec![Entry::HeadIn, Entry::ReverseIn]);
        entries.dedup();
        if entries.is_empty() || entries.len() > 2 {
            return bad(
                "entries",
                message!("must have one or both of head-in and reverse-in, got {}", entries.len()),
            );
        }
        let what_if = f.maybe("whatIf", word(&[("as-is", WhatIf::AsIs), ("each-free", WhatIf::EachFree)]))?;
        let bays = f.maybe("bays", |value| bays(scene, value))?;
        Ok(Self {
            vehicles,
            entries,
            what_if: what_if.unwrap_or(WhatIf::AsIs),
            entrances,
            bays: bays.unwrap_or_else(|| (0..scene.slots.len()).collect()),
            out: f.maybe("out", flag)?.unwrap_or(true),
            settings: f.maybe("settings", object)?.cloned().unwrap_or_default(),
        })
    }
}

/// A profile, a vehicle of the library, or `{ id, vehicle }`.
fn vehicle(value: &Value) -> Result<AuditVehicle, Error> {
    if let Value::String(id) = value {
        return named(id);
    }
    let f = Fields::of(value, &["id", "vehicle"])?;
    let id = f.need("id", owned)?;
    let spec = f.need("vehicle", vehicle_spec::vehicle)?;
    let vehicle = match spec {
        VehicleSpec::Profile(name) => named(&name).map_err(|e| e.within("vehicle"))?.vehicle,
        VehicleSpec::Custom(vehicle) => {
            vehicle.validate().map_err(|e| e.within("vehicle"))?;
            vehicle
        }
    };
    Ok(AuditVehicle { id, vehicle })
}

/// A profile or a vehicle of the library by its id. The error lists all ids that are known.
fn named(id: &str) -> Result<AuditVehicle, Error> {
    let found = Vehicle::profile(id).or_else(|| library::find(id).map(library::LibraryVehicle::vehicle));
    if let Some(vehicle) = found {
        return Ok(AuditVehicle { id: id.to_owned(), vehicle });
    }
    let known: Vec<&str> = library::all().iter().map(|entry| &entry.id[..]).collect();
    let known = known.join(", ");
    let message = message!("must be paper, sedan, ship, {} or { id, vehicle }, got \"{}\"", known, id);
    Err(Error::new(ErrorCode::Vehicle, "", message))
}

fn own(scene: &Scenario) -> Result<AuditVehicle, Error> {
    let id = match &scene.vehicle {
        VehicleSpec::Profile(name) => name.clone(),
        VehicleSpec::Custom(_) => OWN.to_owned(),
    };
    Ok(AuditVehicle { id, vehicle: scene.vehicle.resolve().map_err(|e| e.within("vehicle"))? })
}

/// `{ id, pose, exit? }` with finite poses in metres and radians.
fn entrance(value: &Value) -> Result<Entrance, Error> {
    let f = Fields::of(value, &["id", "pose", "exit"])?;
    let pose = |value: &Value| {
        let pose = places::pose(value)?;
        checks::finite_pose(pose).map(|()| pose).map_err(|e| e.with_code(ErrorCode::Input))
    };
    Ok(Entrance { id: f.need("id", owned)?, pose: f.need("pose", pose)?, exit: f.maybe("exit", pose)? })
}

/// Bays by id or index. The result ascends and has no index twice.
fn bays(scene: &Scenario, value: &Value) -> Result<Vec<usize>, Error> {
    let one = |value: &Value| {
        let found = match value {
            Value::String(id) => scene.slots.iter().position(|slot| slot.id.as_ref() == Some(id)),
            _ => value.as_u64().map(|at| at as usize).filter(|&at| at < scene.slots.len()),
        };
        let rule =
            || message!("must be the id or index of one of {} slots, got {}", scene.slots.len(), value);
        found.map_or_else(|| bad("", rule()), Ok)
    };
    let mut all = list(one)(value)?;
    all.sort_unstable();
    all.dedup();
    Ok(all)
}

/// Refuses an empty list, one that is too long, and ids that occur twice: rows are told apart by them.
fn distinct<'a>(field: &str, ids: impl ExactSizeIterator<Item = &'a String>) -> Result<(), Error> {
    let count = ids.len();
    if count == 0 || count > MAX_ITEMS {
        return bad(field, message!("must have 1 to {} items, got {}", MAX_ITEMS, count));
    }
    let mut seen = std::collections::BTreeSet::new();
    for id in ids {
        if !seen.insert(id) {
            return bad(field, message!("must have different ids, got \"{}\" twice", id));
        }
    }
    Ok(())
}
