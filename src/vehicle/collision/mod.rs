//! Exact collision of the body with line obstacles, behind two cheap filters.
//!
//! A solid is its outline: a car that starts outside it cannot enter without meeting an edge, so containment is asked
//! only once, of the first and last pose ([`Obstacles::inside`]). Most poses are settled by discs that cover the body,
//! looked up in a distance field; the rest by separating axes against the edges nearby.
//!
//! Frames: [`Obstacles`] moves everything to local coordinates, whose origin is the lower left corner of the
//! boundary. Numbers stay small there, so maps far from the world's origin lose no digits. [`Obstacles::new`],
//! [`Obstacles::painted`] and [`Obstacles::local`] alone take world coordinates.
//!
//! Costs: a disc look-up is O(1); the exact test takes the edges in the buckets around the body, usually none to a
//! dozen.
//!
//! ```
//! use parkade::geometry::{Point, Pose};
//! use parkade::vehicle::Vehicle;
//! use parkade::vehicle::collision::{CollisionChecker, Edge, Obstacles, Solid};
//!
//! let corners = [(0.0, 0.0), (20.0, 0.0), (20.0, 10.0), (0.0, 10.0)];
//! let floor = Solid { outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(), owner: 0 };
//! let wall = Edge { a: Point::new(10.0, 0.0), b: Point::new(10.0, 4.0), owner: 7 };
//! let obstacles = Obstacles::new(&[wall], &[], &floor);
//! let checker = CollisionChecker::new(&obstacles, &Vehicle::SEDAN);
//!
//! let before_the_wall = obstacles.local(Pose::new(5.0, 2.0, 0.0));
//! assert_eq!(checker.hit(before_the_wall, 0.0), None);
//! assert_eq!(checker.clearance(before_the_wall, 2.0), 1.05);
//! assert_eq!(checker.hit(obstacles.local(Pose::new(7.0, 2.0, 0.0)), 0.0), Some(7));
//! ```

mod along_arc;
mod checker;
mod contacts;
mod corridor;
mod edge;
mod edge_buckets;
mod obstacles;
mod reach;
#[cfg(test)]
mod tests;
mod variant;

pub use checker::CollisionChecker;
pub(crate) use contacts::Contact;
pub use corridor::Corridor;
pub use edge::Edge;
pub use obstacles::{Obstacles, Original, Solid};
pub use reach::{Reach, Sampling};
