//! Moves between cells and their exact integer costs.
//!
//! Costs are in micro-cells (a millionth of a cell), so that ties are real ties on every machine. A move costs the
//! *ceiling* of its length and a Euclidean estimate is the *floor*: every heuristic stays exactly consistent.

use crate::json;
use crate::map::Corner;
pub use crate::map::DIRECTIONS;

/// Micro-cells per cell: the cost of a straight step.
pub const D: i64 = 1_000_000;
/// The cost of a diagonal step, √2.
pub const R2: i64 = 1_414_214;
/// The cost of a knight's move, √5.
pub const R5: i64 = 2_236_068;
/// The cost of a (3, 1) move, √10.
pub const R10: i64 = 3_162_278;
/// The cost of a (3, 2) move, √13.
pub const R13: i64 = 3_605_552;

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

/// The cost of a straight move: the number of primitive steps times the rounded-up length of one. Micro-cells.
pub fn cost(dx: i32, dy: i32) -> i64 {
    let (a, b) = (dx.unsigned_abs(), dy.unsigned_abs());
    let k = gcd(a, b);
    if k == 0 {
        return 0;
    }
    let (p, q) = (i64::from(a / k), i64::from(b / k));
    let floor = micro_sqrt(p * p + q * q);
    let exact = p == 0 || q == 0 || is_square(p * p + q * q);
    i64::from(k) * (floor + i64::from(!exact))
}

/// The Euclidean distance, rounded down. Micro-cells.
pub fn euclid(dx: i32, dy: i32) -> i64 {
    let (dx, dy) = (i64::from(dx), i64::from(dy));
    micro_sqrt(dx * dx + dy * dy)
}

/// ⌊10⁶ √n⌋, exact for n below 10⁹.
fn micro_sqrt(n: i64) -> i64 {
    // n · 10¹² may exceed 64 bits, but the distance to the square of the nearest whole number does not, so wrapping
    // arithmetic gives it exactly.
    let near = nearest((n as f64).sqrt() * 1e6);
    let rest = n.wrapping_mul(1_000_000_000_000).wrapping_sub(near.wrapping_mul(near));
    near - i64::from(rest < 0)
}

/// The whole number nearest to one from 0 to below 2⁵¹, sooner than a conversion, which asks for the range.
#[inline]
fn nearest(number: f64) -> i64 {
    const BEYOND: f64 = (1_u64 << 52) as f64;
    (number + BEYOND).to_bits() as i64 - BEYOND.to_bits() as i64
}

fn is_square(n: i64) -> bool {
    let root = (n as f64).sqrt() as i64;
    (root - 1..=root + 1).any(|r| r * r == n)
}

const fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
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
    fn costs_are_the_stated_constants() {
        assert_eq!([cost(1, 0), cost(1, 1), cost(2, 1), cost(3, 1), cost(-2, 3)], [D, R2, R5, R10, R13]);
        assert_eq!([cost(-4, 4), cost(0, -3), cost(0, 0), cost(3, 4)], [4 * R2, 3 * D, 0, 5 * D]);
    }

    #[test]
    fn square_roots_are_exact() {
        let squares = (4000..31_000).step_by(97).flat_map(|root| root * root - 1..=root * root + 1);
        for n in (0..4000).chain(33_000_000..33_002_000).chain(squares).chain(999_990_000..1_000_000_000) {
            let (root, square) = (i128::from(micro_sqrt(n)), i128::from(n) * 1_000_000_000_000);
            assert!(root * root <= square && (root + 1) * (root + 1) > square, "{n}");
        }
    }

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
