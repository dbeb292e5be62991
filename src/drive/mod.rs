//! Driving a path in time: speeds and steering, a closed-loop check, and waiting for what moves.
//!
//! A [`Route`] is a path as legs of constant curvature, parted into runs at gear changes. [`Motion`] gives it speeds;
//! [`Trajectory`] samples that. [`track()`] lets a simulated car follow it, [`stop_wait_go`] lets it wait for moving
//! obstacles.

mod motion;
mod moving;
mod route;
mod scurve;
mod track;
mod trajectory;
mod wait;

pub use motion::{Limits, Motion, Profile, Steps};
pub use moving::Mover;
pub use route::Route;
pub(crate) use track::follow;
pub use track::{Controller, Tracking, track};
pub(crate) use trajectory::hash;
pub use trajectory::{Rows, Trajectory, trajectory};
pub use wait::{Contact, Encounter, Ending, Rule, Scope, Wait, WaitOptions, stop_wait_go};
