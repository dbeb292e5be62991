//! Plans, and what becomes of them.

use std::path::Path;

use parkade::drive::Route;
use parkade::import::tpcap;
use parkade::metrics::Body;
use parkade::optimise::{Optimised, Options, optimise};
use parkade::plan::{Plan, Planner};
use parkade::referee::track;
use parkade::scenario::resolve::Geometry;
use parkade::scenario::{Scenario, catalog};
use serde_json::{Map, Value};

use crate::clock;

type Settings = Map<String, Value>;

/// A plan, what was made of it, and the milliseconds that both took.
pub(crate) struct Made {
    pub(crate) geometry: Geometry,
    pub(crate) plan: Plan,
    pub(crate) route: Option<Route>,
    pub(crate) driven: Option<Optimised>,
    pub(crate) millis: (f64, f64),
}

pub(crate) fn built_in() -> Vec<(String, Scenario)> {
    let parking = catalog::scenes().filter(|s| ["parking", "tight", "paper"].contains(&s.group));
    parking.map(|s| (s.id.to_owned(), catalog::scenario(s.id).expect("a scene of the catalog"))).collect()
}

fn public() -> Vec<(String, Scenario)> {
    let folder = std::env::var("PARKADE_DATA").unwrap_or_else(|_| "../shared/data".to_owned());
    let read = |number: u32| {
        let name = format!("Case{number}");
        let text = std::fs::read_to_string(Path::new(&folder).join(format!("tpcap/{name}.csv"))).ok()?;
        let scene = tpcap::scene(&name, &text).unwrap_or_else(|error| panic!("{name}: {error}"));
        Some((name, scene))
    };
    (1..=20).filter_map(read).collect()
}

/// The built-in scenes and the cases at hand.
pub(crate) fn scenes() -> Vec<(String, Scenario)> {
    built_in().into_iter().chain(public()).collect()
}

pub(crate) fn make(planner: &str, scene: &Scenario, settings: &Settings) -> Made {
    made_with(planner, scene, settings, &Options::default())
}

pub(crate) fn made_with(planner: &str, scene: &Scenario, settings: &Settings, options: &Options) -> Made {
    let mut planner = Planner::new(planner, scene, settings).expect("valid settings");
    let begin = clock::now();
    let plan = planner.plan(parkade::plan::Options::default());
    let planned = clock::now();
    let geometry = planner.geometry().clone();
    let is_drivable = plan.path.len() > 1 && plan.check.drivable();
    let route = |plan: &Plan| {
        Route::new(&geometry.vehicle, &plan.path, &plan.directions, Some(&plan.curvatures)).ok()
    };
    let route = is_drivable.then(|| route(&plan)).flatten();
    let driven = route.as_ref().map(|route| {
        let clearance = plan.metrics.min_clearance;
        optimise(&geometry, route, clearance, options).expect("valid options")
    });
    Made { geometry, plan, route, driven, millis: (planned - begin, clock::now() - planned) }
}

pub(crate) fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// How far a simulated car strays from a trajectory at most, metres.
pub(crate) fn strays(geometry: &Geometry, driven: &Optimised) -> f64 {
    track(&geometry.vehicle, &Body::new(geometry), &driven.states).max_lateral
}

/// How often a car brakes and speeds up again without a stop: by more than a centimetre a second.
pub(crate) fn dips(driven: &Optimised) -> u32 {
    let (mut count, mut low, mut high) = (0, 0.0, 0.0);
    for speed in driven.states.speed.iter().map(|speed| speed.abs()) {
        if speed == 0.0 {
            (low, high) = (0.0, 0.0);
        } else if low < high - 0.01 && speed > low + 0.01 {
            count += 1;
            (low, high) = (speed, speed);
        } else if speed > high {
            (low, high) = (speed, speed);
        } else if speed < low {
            low = speed;
        }
    }
    count
}
