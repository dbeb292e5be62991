//! Driving a path in time: speeds and steering, a closed-loop check, and waiting for what moves.
//!
//! A [`Route`] is a path as legs of constant curvature, parted into runs at gear changes. [`Motion`] gives it speeds;
//! [`Trajectory`] samples that. [`track()`] lets a simulated car follow it, [`stop_wait_go`] lets it wait for moving
//! obstacles.

mod contact;
mod jerk_limited;
mod limits;
mod moving_obstacles;
mod path_segments;
mod phase;
mod speed_profile;
mod stop_wait_go;
mod time_to_collision;
mod track;
mod trajectory;

pub use contact::Contact;
pub(crate) use contact::{first_contact, nearest};
pub use limits::{Limits, Profile, Steps};
pub use moving_obstacles::Mover;
pub use path_segments::Route;
pub use speed_profile::Motion;
pub use stop_wait_go::{Encounter, Ending, Rule, Scope, Wait, WaitOptions, stop_wait_go};
pub(crate) use stop_wait_go::{SAMPLE, SHORTEST, SPARE};
pub(crate) use time_to_collision::times_to_collision;
pub(crate) use track::follow;
pub use track::{Controller, Tracking, track};
pub(crate) use trajectory::hash;
pub use trajectory::{Rows, Trajectory, trajectory};
