//! What a path is worth, and whether this car can drive it.

mod body;
pub mod check;
pub mod grid;

pub use body::{Body, FAR};
pub use check::{Check, Verdict, check};
