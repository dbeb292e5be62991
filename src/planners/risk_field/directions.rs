//! Which of the eight directions a force picks (tables 1 and 2 of Hu et al. 2024).
//!
//! The plane of forces is cut into regions by the slope |y| / |x|. In *oblique* mode, where diagonal steps make up
//! most of the way to the goal, there are eight regions, which split at the slopes 1/3 and 3. In *straight* mode
//! there are four, which split at 1. The region's central direction and its two neighbours are the three that the
//! search expands.

use crate::planners::moves::{D, R2};

/// True if a goal `dx` columns and `dy` rows away is reached mostly by diagonal steps: at least as much diagonal as
/// straight length.
pub(super) fn is_oblique(dx: i32, dy: i32) -> bool {
    let (x, y) = (i64::from(dx.abs()), i64::from(dy.abs()));
    let (far, near) = (x.max(y), x.min(y));
    R2 * near >= D * (far - near)
}

/// The central direction of the force's region, an index into [`crate::planners::moves::DIRECTIONS`].
///
/// Regions are told apart by products, so a force without an eastward part needs no special case. The slopes ±1/3 and
/// ±3, which the paper's table leaves open, belong to the diagonal regions.
pub(super) fn region((x, y): (f64, f64), oblique: bool) -> usize {
    let (ax, ay) = (x.abs(), y.abs());
    // Searches ask at every cell, and processors guess badly: the region in the first quadrant is counted, then turned
    // over.
    let steep = [1.0, 3.0][usize::from(oblique)];
    let first = usize::from(steep * ay > ax)
        + usize::from(ay > steep * ax)
        + (usize::from(steep * ay == ax) & usize::from(oblique));
    let north = if x >= 0.0 { first } else { 4 - first };
    if y >= 0.0 { north } else { (8 - north) % 8 }
}

/// The three directions of a region: the central one, its left and its right neighbour.
pub(super) const fn primaries(center: usize) -> [usize; 3] {
    [center, (center + 1) % 8, (center + 7) % 8]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn oblique_regions_split_at_one_third_and_three() {
        let cases = [
            ((0.0, 0.0), 1),
            ((4.0, 1.0), 0),
            ((3.0, 1.0), 1),
            ((1.0, 3.0), 1),
            ((1.0, 4.0), 2),
            ((0.0, 1.0), 2),
            ((-1.0, 3.0), 3),
            ((-4.0, -1.0), 4),
            ((-3.0, -1.0), 5),
            ((-1.0, -4.0), 6),
            ((3.0, -1.0), 7),
        ];
        for (force, direction) in cases {
            assert_eq!(region(force, true), direction, "{force:?}");
        }
    }

    #[test]
    fn straight_regions_split_at_the_diagonals() {
        let cases = [((1.0, 1.0), 0), ((1.0, 2.0), 2), ((-2.0, 2.0), 4), ((1.0, -2.0), 6), ((0.0, 0.0), 0)];
        for (force, direction) in cases {
            assert_eq!(region(force, false), direction, "{force:?}");
        }
    }

    #[test]
    fn modes_switch_where_the_parts_are_equal() {
        assert!(is_oblique(5, 5) && is_oblique(-12, 5) && !is_oblique(13, -5) && !is_oblique(3, 0));
        assert_eq!(primaries(0), [0, 1, 7]);
        assert_eq!(primaries(7), [7, 0, 6]);
    }
}
