//! From a grid path to a better one: pruning and rounding of corners. Coordinates are cells, centres at integers.

mod piece;
mod prune;
mod smooth;

pub use piece::Piece;
pub use prune::{prune, prune_dp};
pub use smooth::{Smoothed, smooth};
