//! Published tables, computed again: printed values beside ours, row by row and seed by seed.

mod claims;
pub mod grid;
mod sample;

pub use claims::{Claim, claims};
pub use sample::Spread;
