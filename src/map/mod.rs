//! The world on a lattice of square cells.

pub mod distance;
mod frame;
pub mod inflation;
mod layer;
mod los;
mod occupancy;
pub mod raster;
mod redundant;
pub mod risk;

pub use frame::{Cell, Frame};
pub use layer::Layer;
pub use los::{Corner, line_of_sight};
pub use occupancy::Occupancy;
pub use redundant::{Redundant, RedundantSettings, redundant};
