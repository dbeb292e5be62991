//! Moves between cells: the neighbourhoods, and the single steps that the corner rules allow.
//!
//! Neighbourhoods of 16, 24 and 48 moves add longer steps to the eight around a cell, and with them angles: knight's
//! moves 26.6°, the 7 × 7 square 18.4° and 33.7° as well. A longer step is legal only if every cell that its line
//! crosses is free. Costs are straight distances in millionths of a cell, whole numbers, so that paths of equal
//! length are equal exactly.
//!
//! Directions count from east, counter-clockwise: 0 east, 2 north, 4 west, 6 south. Even ones are straight, so masks
//! of bits tell them apart.

use crate::json;
use crate::map::Corner;
pub use crate::map::DIRECTIONS;
pub use crate::map::move_cost::{D, R2, R5, R10, R13, cost, euclid};

/// Which cells a planner may step to from a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Neighbourhood {
    /// East, north, west, south.
    Four,
    /// The eight cells around.
    Eight,
    /// The eight cells around and the eight knight's moves.
    Sixteen,
    /// The 5 × 5 square.
    TwentyFour,
    /// The 7 × 7 square.
    FortyEight,
}

json::words!(Neighbourhood:
    "four" = Four, "eight" = Eight, "sixteen" = Sixteen, "twenty-four" = TwentyFour, "forty-eight" = FortyEight);

/// A step to another cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Move {
    /// Columns to the east.
    pub dx: i32,
    /// Rows to the north.
    pub dy: i32,
    /// Micro-cells.
    pub cost: i64,
}

impl Neighbourhood {
    /// Every one, from few cells to many.
    pub const ALL: [Self; 5] = [Self::Four, Self::Eight, Self::Sixteen, Self::TwentyFour, Self::FortyEight];

    /// The moves in the order in which they are tried: counter-clockwise from the east, inner ring first.
    ///
    /// The order matters: among entries of equal f and h the newest comes first, so it decides which of several equally
    /// cheap paths is found.
    ///
    /// # Examples
    /// ```
    /// use parkade::planners::moves::{Neighbourhood, R5};
    ///
    /// let moves = Neighbourhood::Sixteen.moves();
    /// assert_eq!(moves.len(), 16);
    /// assert_eq!((moves[0].dx, moves[0].dy), (1, 0));
    /// // The other eight are knight's moves.
    /// assert!(moves[8..].iter().all(|m| m.cost == R5));
    /// ```
    pub fn moves(self) -> Vec<Move> {
        let rings = match self {
            Self::Four | Self::Eight => 1,
            Self::Sixteen | Self::TwentyFour => 2,
            Self::FortyEight => 3,
        };
        let mut moves = Vec::new();
        for (dx, dy) in (1..=rings).flat_map(ring) {
            let wanted = match self {
                Self::Four => dx == 0 || dy == 0,
                Self::Sixteen => dx * dx + dy * dy != 4 && dx * dx + dy * dy != 8,
                _ => true,
            };
            if wanted {
                moves.push(Move { dx, dy, cost: cost(dx, dy) });
            }
        }
        moves
    }
}

/// The cells at Chebyshev distance `r`, counter-clockwise from (r, 0).
fn ring(r: i32) -> Vec<(i32, i32)> {
    let mut cells = Vec::new();
    let (mut x, mut y) = (r, 0);
    for _ in 0..8 * r {
        cells.push((x, y));
        match () {
            () if x == r && y < r => y += 1,
            () if y == r && x > -r => x -= 1,
            () if x == -r && y > -r => y -= 1,
            () => x += 1,
        }
    }
    cells
}

/// Which of the eight single steps are legal where the cells of the mask `free` are free (bit c: direction c of
/// [`DIRECTIONS`], see [`crate::map::Occupancy::free_around`]).
pub const fn legal_steps(free: u8, corner: Corner) -> u8 {
    const DIAGONALS: u8 = 0b1010_1010;
    let (before, after) = (free.rotate_left(1), free.rotate_right(1));
    let sides = match corner {
        Corner::Strict => before & after,
        Corner::NoSqueeze => before | after,
        Corner::Free => 0xff,
    };
    free & (sides | !DIAGONALS)
}

/// [`legal_steps`] by corner rule and free cells around.
pub(super) static LEGAL: [[u8; 256]; 3] =
    [legal_by_free(Corner::Strict), legal_by_free(Corner::NoSqueeze), legal_by_free(Corner::Free)];

/// For each byte of free cells around a cell the legal steps, one bit each; made by the compiler.
const fn legal_by_free(corner: Corner) -> [u8; 256] {
    let mut table = [0; 256];
    let mut free = 0;
    while free < 256 {
        table[free] = legal_steps(free as u8, corner);
        free += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{Cell, Occupancy, line_of_sight};

    #[test]
    fn rings_turn_counter_clockwise() {
        assert_eq!(ring(1), DIRECTIONS);
        let two = ring(2);
        assert_eq!(
            (two.len(), two[0], two[2], two[6], two[10], two[15]),
            (16, (2, 0), (2, 2), (-2, 2), (-2, -2), (2, -1))
        );
        let sizes = [4, 8, 16, 24, 48];
        let all = [
            Neighbourhood::Four,
            Neighbourhood::Eight,
            Neighbourhood::Sixteen,
            Neighbourhood::TwentyFour,
            Neighbourhood::FortyEight,
        ];
        assert_eq!(all.map(|n| n.moves().len()), sizes);
    }

    #[test]
    fn legal_steps_agree_with_line_of_sight() {
        let centre = Cell::new(1, 1);
        for free in 0..=255_u8 {
            let mut map = Occupancy::new(3, 3);
            for (c, &(dx, dy)) in DIRECTIONS.iter().enumerate() {
                map.set(centre.offset(dx, dy), free >> c & 1 == 0);
            }
            assert_eq!(map.free_around(centre), free);
            for corner in [Corner::Strict, Corner::NoSqueeze, Corner::Free] {
                let legal = legal_steps(free, corner);
                for (c, &(dx, dy)) in DIRECTIONS.iter().enumerate() {
                    assert_eq!(
                        legal >> c & 1 == 1,
                        line_of_sight(&map, centre, centre.offset(dx, dy), corner)
                    );
                }
            }
        }
    }
}
