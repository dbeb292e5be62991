//! The world on a lattice of square cells.
//!
//! Grid planners, distance fields and drawings work on cells; the car, obstacles and paths are in metres. [`Frame`]
//! is the only place where one becomes the other. The cell (0, 0) is the south-western one, x counts columns to the
//! east and y rows to the north. Arrays are row-major from that cell: `index = y · width + x`.
//!
//! * [`Occupancy`]: which cells are blocked, and the weights of the others. Everything outside the map is blocked.
//! * [`Layer`]: one value of any type for each cell.
//! * [`raster`]: shapes in metres to blocked cells.
//! * [`distance`]: exact Euclidean distance transforms.
//! * [`inflation`]: cells that the car's width takes away, so that a planner may treat the car as a point.
//! * [`risk`]: the artificial potential field of the risk-field planner.
//! * [`move_cost`]: what a straight move between two cells costs, in whole micro-cells.
//! * [`line_of_sight()`]: the one rule by which moves, pruning and any-angle search decide that two cells see each
//!   other.

pub mod distance;
mod frame;
pub mod inflation;
mod jump_bitmaps;
mod jump_directions;
mod layer;
mod line_of_sight;
pub mod move_cost;
mod occupancy;
pub mod raster;
mod redundant;
pub mod risk;
mod weights;

pub use frame::{Cell, Frame};
pub use jump_bitmaps::Bits;
pub use layer::Layer;
pub use line_of_sight::{Corner, first_in_sight, line_of_sight};
pub use occupancy::{DIRECTIONS, Occupancy};
pub use redundant::{Redundant, RedundantSettings, redundant};
pub use weights::{WeightMap, Weights};
