//! The plane in metres and radians; knows nothing of maps.

pub mod arcs;
#[cfg(feature = "complete")]
pub mod bspline;
pub mod math;
mod pose;
pub mod reeds_shepp;
#[cfg(feature = "complete")]
pub mod smoothing_spline;

pub use pose::Pose;

/// A point, metres.
pub type Point = nalgebra::Point2<f64>;
/// A displacement, metres.
pub type Vector = nalgebra::Vector2<f64>;
