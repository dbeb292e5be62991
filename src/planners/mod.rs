//! The planners. One file or folder each: its settings, its search domain and `plan`.

#[cfg(feature = "complete")]
pub mod any_angle;
#[cfg(feature = "complete")]
pub mod bidirectional;
#[cfg(feature = "complete")]
pub mod cost_map;
#[cfg(feature = "complete")]
pub mod dijkstra_greedy;
#[cfg(feature = "complete")]
pub mod genetic;
pub mod grid_astar;
mod grid_lattice;
pub mod heuristics;
pub mod hybrid;
#[cfg(feature = "complete")]
pub mod jump_point;
pub mod moves;
mod obstruction;
mod parameters;
pub mod query;
pub mod registry;
pub mod risk_field;
#[cfg(feature = "complete")]
pub mod rrt;
pub mod settings;
mod weighted;

pub use obstruction::{Gap, Obstruction, Region};
pub(crate) use weighted::weighted_cost;
