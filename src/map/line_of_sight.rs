//! Line of sight between cell centres: one predicate for moves, pruning and any-angle checks.
//!
//! The line is walked cell by cell with whole numbers (as Bresenham's, but with every cell that it touches, not the
//! nearest ones alone), so the answer is exact and the same from either end. It costs O(cells on the line). A line
//! through a corner where four cells meet is the only case left open; [`Corner`] decides it, for a single diagonal step
//! and for a long chord alike. One rule for all is what keeps a pruned path as legal as the cells that it replaces.

use super::{Cell, Occupancy};
use crate::json;

/// The rule for a line that passes exactly through a corner of cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Corner {
    /// Both side cells must be free: the path touches no blocked closed square.
    #[default]
    Strict,
    /// At least one side cell must be free.
    NoSqueeze,
    /// Side cells do not matter.
    Free,
}

json::words!(Corner: "strict" = Strict, "no-squeeze" = NoSqueeze, "free" = Free);

/// True if the straight line between two cell centres crosses free cells only. Symmetric in its ends.
///
/// # Examples
/// ```
/// use parkade::map::{Cell, Corner, Occupancy, line_of_sight};
///
/// let mut map = Occupancy::new(4, 3);
/// map.set(Cell::new(1, 0), true);
/// let (from, to) = (Cell::new(0, 0), Cell::new(1, 1));
/// assert!(!line_of_sight(&map, from, to, Corner::Strict));
/// assert!(line_of_sight(&map, from, to, Corner::NoSqueeze));
/// ```
pub fn line_of_sight(map: &Occupancy, from: Cell, to: Cell, corner: Corner) -> bool {
    first_in_sight(map, from, to, corner).is_none()
}

/// The first cell that ends the straight line between two cell centres: a blocked one, or a free one of which a corner
/// may not be passed.
#[inline]
pub fn first_in_sight(map: &Occupancy, from: Cell, to: Cell, corner: Corner) -> Option<Cell> {
    let (dx, dy) = ((to.x - from.x).abs(), (to.y - from.y).abs());
    let (sx, sy) = (if to.x > from.x { 1 } else { -1 }, if to.y > from.y { 1 } else { -1 });
    let mut at = from;
    if map.blocked(at) {
        return Some(at);
    }
    let (mut i, mut j) = (0, 0);
    while i < dx || j < dy {
        let side = (2 * i + 1) * dy - (2 * j + 1) * dx;
        let (across, along) = (i32::from(side <= 0), i32::from(side >= 0));
        if side == 0 {
            let (a, b) = (map.blocked(at.offset(sx, 0)), map.blocked(at.offset(0, sy)));
            let shut = match corner {
                Corner::Strict => a || b,
                Corner::NoSqueeze => a && b,
                Corner::Free => false,
            };
            if shut {
                return Some(at);
            }
        }
        at = at.offset(sx * across, sy * along);
        (i, j) = (i + across, j + along);
        if map.blocked(at) {
            return Some(at);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cells of a 4 × 3 map that must be free for a line from (0, 0), besides its ends.
    fn needed(to: Cell) -> Vec<(i32, i32)> {
        let mut cells = Vec::new();
        for index in 0..12 {
            let mut map = Occupancy::new(4, 3);
            let cell = map.cell(index);
            map.set(cell, true);
            if cell != Cell::new(0, 0)
                && cell != to
                && !line_of_sight(&map, Cell::new(0, 0), to, Corner::Strict)
            {
                assert!(!line_of_sight(&map, to, Cell::new(0, 0), Corner::Strict));
                cells.push((cell.x, cell.y));
            }
        }
        cells
    }

    #[test]
    fn the_cells_of_short_lines() {
        assert_eq!(needed(Cell::new(1, 1)), [(1, 0), (0, 1)]);
        assert_eq!(needed(Cell::new(2, 1)), [(1, 0), (1, 1)]);
        assert_eq!(needed(Cell::new(3, 1)), [(1, 0), (2, 0), (1, 1), (2, 1)]);
        assert_eq!(needed(Cell::new(3, 2)), [(1, 0), (1, 1), (2, 1), (2, 2)]);
    }

    #[test]
    fn corner_rules() {
        let sees = |drawing: &str, corner| {
            line_of_sight(&Occupancy::parse(drawing), Cell::new(0, 0), Cell::new(1, 1), corner)
        };
        assert!(!sees("..\n.#", Corner::Strict) && sees("..\n.#", Corner::NoSqueeze));
        assert!(!sees("#.\n.#", Corner::NoSqueeze) && sees("#.\n.#", Corner::Free));
    }
}
