//! What a path is worth, and whether this car can drive it.

#[cfg(feature = "complete")]
mod any_angle;
mod body;
pub mod check;
pub mod grid;
#[cfg(feature = "complete")]
mod narrowest;
#[cfg(feature = "complete")]
pub mod risk;
#[cfg(feature = "complete")]
pub mod road;
#[cfg(feature = "complete")]
mod signed;

#[cfg(feature = "complete")]
pub use any_angle::any_angle_length;
#[cfg(feature = "complete")]
pub(crate) use body::gap;
pub use body::{Body, FAR};
pub use check::{Check, Verdict, check};
#[cfg(feature = "complete")]
pub use narrowest::Narrowest;
