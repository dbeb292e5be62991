//! The planners. One file or folder each: its settings, its search domain and `plan`.
//!
//! There are three families ([`registry::Family`]). *Grid* planners move a point over cells: [`grid_astar`],
//! [`risk_field`] and, with the feature `complete`, search from both ends, jump points, any angle and planners to
//! compare with. *Hybrid* planners search poses of a car, whose path can be driven ([`hybrid`]). The *road* planner
//! is `cost_map`, whose metres cost more near obstacles, kerbs and the edge of a lane.
//!
//! Planners know cells, poses and obstacles, but no scenes: [`plan`](crate::plan) prepares those, calls a planner,
//! and checks what it answers. A planner is registered by one row in [`registry`]; its settings are declared once,
//! by the macro in `parameters`, from which defaults, ranges, forms and types come.

pub mod any_angle;
pub mod bidirectional;
pub mod cost_map;
pub mod dijkstra_greedy;
pub mod genetic;
pub mod grid_astar;
mod grid_lattice;
pub(crate) mod grid_planner;
pub mod heuristics;
pub mod hybrid;
mod info;
pub mod jump_point;
pub mod moves;
mod obstruction;
mod outcome;
mod parameters;
pub mod query;
pub mod registry;
pub mod risk_field;
pub mod rrt;
pub mod settings;
mod weighted;

pub use obstruction::{Gap, Obstruction, Region};
pub use outcome::{Detail, Outcome};
