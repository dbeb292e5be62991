//! Judges whether a car can follow a trajectory: an independent replay and collision check, and the figures of public
//! benchmarks.
//!
//! The protocol is that of the benchmark `CommonParking` (2026): a rear-axle bicycle with limits of speed,
//! acceleration, steering angle and steering rate; the whole rectangle against the polygons at each millisecond;
//! attained where the car ends within 1 cm and 1°. [`replay()`] integrates the controls of a [`States`], [`scan()`]
//! certifies what lies between two milliseconds, and [`judge()`] does both for a [`Submission`], which may come from
//! anybody.

mod csv;
mod derive;
mod figures;
mod judge;
mod limits;
mod replay;
mod scan;
mod states;
mod submission;
mod tracking;

pub use csv::read;
pub use figures::Figures;
pub use judge::{Judgement, check, judge};
pub use limits::MotionLimits;
pub use replay::{Frame, replay};
pub use scan::{Contacts, scan};
pub use states::States;
pub(crate) use submission::MAX_DURATION;
pub use submission::{Submission, TimedRows};
pub use tracking::track;
