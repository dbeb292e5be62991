//! Hybrid A* against the parking paper's rows, tight slots, bad questions and random lots; every path is driven again
//! by a checker that shares nothing with the planner.

mod choices;
#[cfg(not(target_arch = "wasm32"))]
mod drags;
mod limits;
mod lot;
mod paper;
mod properties;
mod questions;
mod reverse;
mod rows;
#[cfg(not(target_arch = "wasm32"))]
mod scouts;
mod tight;
mod why;
