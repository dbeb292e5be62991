//! Exact collision of the body with line obstacles, behind two cheap filters.
//!
//! A solid is its outline: a car that starts outside it cannot enter without meeting an edge, so containment is asked
//! only once, of the first and last pose ([`Obstacles::inside`]). Most poses are settled by discs that cover the body,
//! looked up in a distance field; the rest by separating axes against the edges nearby.

mod checker;
#[cfg(feature = "complete")]
mod corridor;
mod obstacles;
mod reach;
#[cfg(test)]
mod tests;

pub use checker::CollisionChecker;
#[cfg(feature = "complete")]
pub use corridor::Corridor;
pub use obstacles::{Edge, Obstacles, Solid};
pub use reach::{Reach, Sampling};
