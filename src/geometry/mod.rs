//! The plane in metres and radians; knows nothing of maps.
//!
//! x points east, y north. A [`Pose`] is a position with a heading, counted counter-clockwise from east; for a car
//! it is the middle of the rear axle. Curvature κ is in 1/m, positive to the left in either gear; an arc's length
//! is negative in reverse.
//!
//! * [`arcs`]: paths of circular arcs and straight lines, the form in which car planners return them.
//! * [`reeds_shepp`]: the shortest such paths without obstacles.
//! * [`math`]: sine, arctangent and the like from `libm`, because those of the standard library differ between
//!   platforms in the last bit, which would change plans.

pub mod arcs;
pub mod bspline;
pub mod math;
pub(crate) mod polygon;
mod pose;
pub mod reeds_shepp;
pub mod smoothing_spline;

pub use pose::Pose;

/// A point, metres.
pub type Point = nalgebra::Point2<f64>;
/// A displacement, metres. Where its length is asked for often, `norm_squared().sqrt()` tells it: `norm` takes the root
/// from `libm`, which has no instruction for that in WebAssembly.
pub type Vector = nalgebra::Vector2<f64>;
