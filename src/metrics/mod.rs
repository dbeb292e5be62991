//! Figures of a path, and the independent check whether the car can drive it.

#[cfg(feature = "complete")]
mod any_angle;
pub mod check;
mod footprint_distance;
pub mod grid;
#[cfg(feature = "complete")]
mod narrowest;
#[cfg(feature = "complete")]
pub mod risk;
#[cfg(feature = "complete")]
pub mod road;
#[cfg(feature = "complete")]
mod signed_distance;

#[cfg(feature = "complete")]
pub use any_angle::any_angle_length;
pub use check::{Check, Verdict, check};
#[cfg(feature = "complete")]
pub(crate) use footprint_distance::gap;
pub use footprint_distance::{Body, FAR};
#[cfg(feature = "complete")]
pub use narrowest::Narrowest;
