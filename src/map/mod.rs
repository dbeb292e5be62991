//! The world on a lattice of square cells.

#[cfg(feature = "complete")]
mod bits;
pub mod distance;
mod frame;
pub mod inflation;
mod layer;
mod los;
mod occupancy;
pub mod raster;
#[cfg(feature = "complete")]
mod redundant;
pub mod risk;
#[cfg(feature = "complete")]
mod ways;
mod weights;

#[cfg(feature = "complete")]
pub use bits::Bits;
pub use frame::{Cell, Frame};
pub use layer::Layer;
pub use los::{Corner, first_in_sight, line_of_sight};
pub use occupancy::{DIRECTIONS, Occupancy};
#[cfg(feature = "complete")]
pub use redundant::{Redundant, RedundantSettings, redundant};
pub use weights::{Paint, Weights};
