//! From a grid path to a better one: pruning and rounding of corners. Coordinates are cells, centres at integers.
//!
//! A grid search turns only in multiples of its moves' angles, so its path has more corners than the way needs. Two
//! steps follow it (Hu et al. 2024, section 5): [`prune()`] leaves out cells that a straight line can skip, and
//! [`smooth()`] replaces the remaining corners by tangent arcs. [`prune_dp`] finds the shortest way over all cells
//! of the path instead, by dynamic programming.
//!
//! Neither step makes a path longer, nor dearer where cells have weights. Pruning uses the planners' own
//! line-of-sight rule; an arc that would enter a blocked cell is made smaller or left out.
//!
//! All functions are pure: they read the map, allocate their result and never fail. A path is a list of cells from
//! start to goal whose moves are free; the result begins and ends in the same cells. Pruning answers cells again, so
//! that it can be followed by [`smooth()`] or by nothing.
//!
//! # Examples
//! ```
//! use parkade::map::{Cell, Corner, Occupancy};
//! use parkade::post::{SmoothMode, prune, smooth};
//!
//! let map = Occupancy::parse(".....\n.###.\n.###.\n.###.\n.....");
//! let raw: Vec<Cell> = (0..5).map(|y| Cell::new(0, y)).chain((1..5).map(|x| Cell::new(x, 4))).collect();
//! let corners = prune(&map, &raw, Corner::Strict);
//! assert_eq!(corners, [raw[0], raw[4], raw[8]]);
//! let smoothed = smooth(&map, &corners, 0.5, SmoothMode::Dynamic);
//! assert!(smoothed.arcs == 1 && smoothed.length < 8.0);
//! ```

mod piece;
mod prune;
mod smooth;

pub use piece::Piece;
pub use prune::{prune, prune_dp};
pub use smooth::{SmoothMode, Smoothed, smooth};
