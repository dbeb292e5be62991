//! The world on a lattice of square cells.

pub mod distance;
mod frame;
pub mod inflation;
#[cfg(feature = "complete")]
mod jump_bitmaps;
#[cfg(feature = "complete")]
mod jump_directions;
mod layer;
mod line_of_sight;
mod occupancy;
pub mod raster;
#[cfg(feature = "complete")]
mod redundant;
pub mod risk;
mod weights;

pub use frame::{Cell, Frame};
#[cfg(feature = "complete")]
pub use jump_bitmaps::Bits;
pub use layer::Layer;
pub use line_of_sight::{Corner, first_in_sight, line_of_sight};
pub use occupancy::{DIRECTIONS, Occupancy};
#[cfg(feature = "complete")]
pub use redundant::{Redundant, RedundantSettings, redundant};
pub use weights::{WeightMap, Weights};
