//! Exact integer costs of straight moves between cells.
//!
//! Costs are in micro-cells (a millionth of a cell), so that ties are real ties on every machine. A move costs the
//! *ceiling* of its length and a Euclidean estimate is the *floor*: every heuristic stays exactly consistent.
//!
//! Consistency asks h(a) ≤ cost(a, b) + h(b). In exact numbers the triangle inequality gives it for Euclid. Rounding
//! costs up and estimates down keeps it: ⌊x⌋ ≤ ⌈y⌉ + ⌊z⌋ wherever x ≤ y + z. Rounding both to the nearest would break
//! it by a millionth here and there, and a closed cell would not always have its lowest cost.

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

/// The cost of a straight move: the number of primitive steps times the rounded-up length of one. Micro-cells.
///
/// A move of (4, 2) is two steps of (2, 1), so long moves cost what their parts cost, and a pruned path costs no more
/// than the cells that it replaces.
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

#[cfg(test)]
mod tests {
    use super::*;

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
}
