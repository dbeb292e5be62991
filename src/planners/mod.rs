//! The planners. One file or folder each: its settings, its search domain and `plan`.

pub mod grid_astar;
pub mod heuristics;
pub mod hybrid;
pub mod moves;
mod parameters;
pub mod query;
pub mod registry;
pub mod risk_field;
pub mod settings;
