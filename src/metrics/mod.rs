//! Figures of a path, and the independent check whether the car can drive it.
//!
//! The check shares no collision code with the planners: it measures the distance from body to outlines by code of
//! its own. So a bug in a planner's collision test shows as a path that the check refuses. Figures come in
//! families: lengths and turns of grid paths ([`grid`]) in cells, everything else in metres.
//!
//! Three levels of trust: [`check()`] decides whether a path is drivable and is the only judge of paths; [`Body`]
//! answers distance queries about one pose; the figures describe and never decide. Everything is computed from the
//! resolved scene and the path alone, so figures of paths by different planners are comparable.

mod any_angle;
pub mod check;
mod footprint_distance;
pub mod grid;
mod narrowest;
mod outlines;
pub mod random_drives;
pub mod road;
mod signed_distance;

pub use any_angle::any_angle_length;
pub use check::{Check, Verdict, check};
pub use footprint_distance::{Body, FAR};
pub use narrowest::Narrowest;
pub(crate) use outlines::gap;
