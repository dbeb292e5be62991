//! Driving a path in time: speeds and steering, a closed-loop check, and waiting for what moves.
//!
//! A [`Route`] is a path as legs of constant curvature, parted into runs at gear changes. [`Motion`] gives it speeds;
//! [`Trajectory`] samples that. [`track()`] lets a simulated car follow it, [`stop_wait_go`] lets it wait for moving
//! obstacles.
//!
//! # Units, frames and signs
//!
//! Metres, seconds and radians in the world frame of the scene. Poses are those of the middle of the rear axle. The
//! *station* is the distance driven since the start, in either gear, so it never decreases. Speeds of a plan are
//! without sign; in the columns that are answered, speed and acceleration are negative in reverse. Curvature κ is
//! positive where the car turns to its left, and φ = atan(L·κ).
//!
//! # What is exact
//!
//! A path has a curvature that jumps, and a wheel has not. So a [`Trajectory`] is a drive along the path whose wheel
//! lags at the jumps; [`track()`] measures how far a car would stray because of that. A drive that a car can follow
//! exactly is the business of [`crate::optimise`].
//!
//! # Examples
//! ```
//! use parkade::drive::{Limits, Motion, Route};
//! use parkade::geometry::Pose;
//! use parkade::vehicle::Vehicle;
//!
//! // 8 m straight ahead at no more than 2 m/s, up with 1 m/s² and down with 1.5 m/s².
//! let path = [Pose::new(0.0, 0.0, 0.0), Pose::new(8.0, 0.0, 0.0)];
//! let route = Route::new(&Vehicle::SEDAN, &path, &[1], None).unwrap();
//! let motion = Motion::new(&Vehicle::SEDAN, &route, &Limits::default()).unwrap();
//! let (up, down) = (2.0 / 1.0, 2.0 / 1.5);
//! assert!((motion.duration() - (up + down + (8.0 - up - down) / 2.0)).abs() < 1e-9);
//! ```

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
