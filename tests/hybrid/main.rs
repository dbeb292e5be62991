//! Hybrid A* against the parking paper's rows, tight slots, bad questions and random lots; every path is driven again
//! by a checker that shares nothing with the planner.

#[cfg(feature = "complete")]
mod choices;
#[cfg(all(feature = "complete", not(target_arch = "wasm32")))]
mod drags;
#[cfg(all(feature = "complete", not(target_arch = "wasm32")))]
#[path = "../freedom/mod.rs"]
#[expect(dead_code, reason = "some pairs are only measured")]
mod freedom;
mod limits;
mod lot;
#[cfg(feature = "complete")]
mod paper;
mod properties;
mod questions;
mod reverse;
mod rows;
mod tight;
#[cfg(not(target_arch = "wasm32"))]
#[path = "../tight_scenes/mod.rs"]
#[expect(dead_code, reason = "scenes are planned as they are drawn")]
mod tight_scenes;
mod why;
