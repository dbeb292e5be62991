//! Judges whether a car can follow a trajectory: an independent replay and collision check, and the figures of public
//! benchmarks.
//!
//! The protocol is that of the benchmark `CommonParking` (2026): a rear-axle bicycle with limits of speed,
//! acceleration, steering angle and steering rate; the whole rectangle against the polygons at each millisecond;
//! attained where the car ends within 1 cm and 1°. [`replay()`] integrates the controls of a [`States`], [`scan()`]
//! certifies what lies between two milliseconds, and [`judge()`] does both for a [`Submission`], which may come from
//! anybody.
//!
//! # Units and frames
//!
//! Metres, radians, seconds and their quotients, in the world frame of the scene. A pose is that of the middle of the
//! rear axle. Speed v is negative in reverse; the steering angle φ is that of the middle front wheel, positive to the
//! left. The model is the kinematic bicycle with the wheelbase L:
//!
//! ```text
//! ẋ = v·cos θ    ẏ = v·sin θ    θ̇ = v·tan φ / L    v̇ = a    φ̇ = ω
//! ```
//!
//! # What a verdict means
//!
//! An error says that a submission cannot be judged (a wrong shape, a value out of range). A submission that can be
//! judged always has a [`Judgement`], however bad it is. The verdict is one-sided: whatever the certificate cannot
//! exclude counts against the trajectory, so a pass is a proof up to 1 µm of overlap, and a refusal may be a very close
//! call.

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
