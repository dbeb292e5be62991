//! Published tables, computed again: printed values beside ours, row by row.

mod claims;
pub mod grid;
pub mod incomplete;
mod naive_stop;
pub mod parking;
pub mod road;
mod sample;
pub mod traditional;
pub mod verdicts;
pub mod volumes;

pub use claims::{Claim, claims};
pub use naive_stop::NaiveStop;
pub use sample::Spread;
