//! From a grid path to a better one: pruning and rounding of corners. Coordinates are cells, centres at integers.
//!
//! A grid search turns only in multiples of its moves' angles, so its path has more corners than the way needs. Two
//! steps follow it (Hu et al. 2024, section 5): [`prune()`] leaves out cells that a straight line can skip, and
//! [`smooth()`] replaces the remaining corners by tangent arcs. [`prune_dp`] finds the shortest way over all cells
//! of the path instead, by dynamic programming.
//!
//! Neither step makes a path longer, nor dearer where cells have weights. Pruning uses the planners' own
//! line-of-sight rule; an arc that would enter a blocked cell is made smaller or left out.

mod piece;
mod prune;
mod smooth;

pub use piece::Piece;
pub use prune::{prune, prune_dp};
pub use smooth::{SmoothMode, Smoothed, smooth};
