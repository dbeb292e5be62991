//! Vehicle path planners: grid A*, risk-field A*, hybrid A* — one scene, many answers.
//!
//! A [`scenario::Scenario`] is a floor, obstacles, parking slots, a car, a start and a goal. A [`plan::Planner`] is one
//! of the planners that [`planners::registry::planners`] lists, prepared on a scene. Its [`plan::Plan`] is a path in
//! metres and radians, what the search did, what the path is worth, and what an independent validator
//! ([`metrics::check()`]) says of it. No path is an outcome with a reason, not an [`Error`]; errors are for scenes and
//! settings that are wrong.
//!
//! ```
//! use parkade::plan::{Options, Outcome, Planner};
//! use parkade::scenario::catalog;
//!
//! # fn main() -> Result<(), parkade::Error> {
//! let scene = catalog::scenario("perpendicular")?;
//! let mut settings = serde_json::Map::new();
//! settings.insert("reverseCost".to_owned(), 1.5.into());
//! let mut planner = Planner::new("hybrid", &scene, &settings)?;
//! let plan = planner.plan(Options::default());
//! assert_eq!(plan.outcome, Outcome::Found);
//! assert!(plan.check.drivable() && plan.metrics.length < 23.0);
//! # Ok(())
//! # }
//! ```
//!
//! # Layers
//!
//! A module uses only modules before it in this list: [`error`] · `fnv` (the hash of results) · `json` (reading
//! settings and scenes) · [`geometry`] (poses, arcs, Reeds–Shepp curves) · [`map`] (cells, rasters, distance and
//! potential fields) · [`vehicle`] (dimensions, collision) · [`scenario`] (scenes, their JSON, built-in and generated
//! ones) · `import` (maps of other programs) · [`search`] (best-first search over any [`search::Domain`]) · [`post`]
//! (pruning, smoothing) · [`metrics`] (validator, figures) · `drive` (paths in time) · `referee` (verdicts on
//! trajectories) · [`planners`] · `optimise` (plans as trajectories) · [`plan`] (joins all of these) · `audit` (every
//! bay of a lot) · `papers` (the papers' tables) · `wasm` (JavaScript bindings, on wasm32 only).
//!
//! # Determinism
//!
//! Equal input gives equal bytes on every platform: transcendental functions come from `libm`, grid costs are integers,
//! the open list has a total order, and no clock, thread, hash order or random number takes part. Budgets count
//! expansions. [`plan::Plan::hash`] is there to compare.
//!
//! The cargo feature `complete`, on by default, holds what the page does not need for its first picture.

// First: the others use its macro.
#[macro_use]
pub mod error;

pub mod audit;
pub mod drive;
mod fnv;
pub mod geometry;
pub mod import;
mod json;
pub mod map;
pub mod metrics;
pub mod optimise;
pub mod papers;
pub mod plan;
pub mod planners;
pub mod post;
pub mod referee;
pub mod scenario;
pub mod search;
pub mod vehicle;
#[cfg(target_arch = "wasm32")]
mod wasm;

pub use error::Error;

/// True with the cargo feature `complete`. The small module's file lacks what only branches on it lead to.
pub(crate) const IS_COMPLETE: bool = cfg!(feature = "complete");

/// Runs the README's Rust lines.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
