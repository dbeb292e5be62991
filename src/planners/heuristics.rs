//! Estimates of the cost between cells, in micro-cells.
//!
//! With dx and dy the columns and rows to the goal, M the larger and m the smaller of them:
//!
//! ```text
//! manhattan   dx + dy                admissible with 4 neighbours
//! octile      M + (√2 − 1)·m         with 4 and 8
//! euclid      √(dx² + dy²)           with all
//! gauge       the cheapest way over an empty map, by the planner's own moves
//! ```
//!
//! A heuristic that never overestimates with the planner's moves keeps A\* optimal. The gauge is the largest such
//! estimate that depends on dx and dy alone. A Euclidean estimate is rounded down and a move's cost up
//! ([`moves`](super::moves)), so that none becomes inconsistent by rounding.

use super::moves::{D, Neighbourhood, R2, R5, R10, R13, euclid};
use crate::json;

/// The estimate of the remaining cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Heuristic {
    /// Columns plus rows: exact for four neighbours, too much for more.
    Manhattan,
    /// The straight distance.
    Euclid,
    /// The shortest way with straight and diagonal steps: exact for eight neighbours, too much for more.
    Octile,
    /// The shortest way with the planner's own moves on an empty map: the best that never overestimates.
    Gauge,
    /// The larger of columns and rows: never too much, and never more than the straight distance.
    Chebyshev,
    /// Nothing, which makes A* Dijkstra's search.
    Zero,
}

json::words!(Heuristic:
    "manhattan" = Manhattan, "euclid" = Euclid, "octile" = Octile, "gauge" = Gauge; complete: "chebyshev" = Chebyshev);

impl Heuristic {
    /// True if it never overestimates with these moves.
    pub fn is_admissible(self, neighbourhood: Neighbourhood) -> bool {
        match self {
            Self::Manhattan => neighbourhood == Neighbourhood::Four,
            Self::Octile => matches!(neighbourhood, Neighbourhood::Four | Neighbourhood::Eight),
            Self::Euclid | Self::Gauge | Self::Chebyshev | Self::Zero => true,
        }
    }

    /// The name used in settings.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Manhattan => "manhattan",
            Self::Euclid => "euclid",
            Self::Octile => "octile",
            Self::Gauge => "gauge",
            Self::Chebyshev => "chebyshev",
            Self::Zero => "zero",
        }
    }

    /// The estimate over `dx` columns and `dy` rows.
    pub fn estimate(self, neighbourhood: Neighbourhood, dx: i32, dy: i32) -> i64 {
        match self {
            Self::Manhattan => D * (i64::from(dx.abs()) + i64::from(dy.abs())),
            Self::Euclid => euclid(dx, dy),
            Self::Octile => octile(dx, dy),
            Self::Gauge => gauge(neighbourhood, dx, dy),
            Self::Chebyshev => D * ordered(dx, dy).0,
            Self::Zero => 0,
        }
    }
}

/// An estimate chosen before a search, so that its loop has no choice to make.
pub(super) trait Estimate {
    /// The estimate over `dx` columns and `dy` rows.
    fn over(&self, dx: i32, dy: i32) -> i64;
}

/// [`Heuristic::Manhattan`].
pub(super) struct Manhattan;
/// [`Heuristic::Euclid`].
pub(super) struct Euclid;
/// [`Heuristic::Octile`], which is the gauge of eight neighbours.
pub(super) struct Octile;
/// The gauge of 16 and of 24 neighbours.
pub(super) struct Gauge16;
/// Any heuristic, weighted or not.
pub(super) struct Chosen {
    pub(super) heuristic: Heuristic,
    pub(super) neighbourhood: Neighbourhood,
    pub(super) weight: Option<DistanceWeight>,
}

impl Estimate for Manhattan {
    fn over(&self, dx: i32, dy: i32) -> i64 {
        D * (i64::from(dx.abs()) + i64::from(dy.abs()))
    }
}

impl Estimate for Euclid {
    fn over(&self, dx: i32, dy: i32) -> i64 {
        euclid(dx, dy)
    }
}

impl Estimate for Octile {
    fn over(&self, dx: i32, dy: i32) -> i64 {
        octile(dx, dy)
    }
}

impl Estimate for Gauge16 {
    fn over(&self, dx: i32, dy: i32) -> i64 {
        gauge(Neighbourhood::Sixteen, dx, dy)
    }
}

impl Estimate for Chosen {
    fn over(&self, dx: i32, dy: i32) -> i64 {
        let h = self.heuristic.estimate(self.neighbourhood, dx, dy);
        self.weight.map_or(h, |weight| weight.apply(h, dx, dy))
    }
}

/// The larger and the smaller of the two absolute differences.
fn ordered(dx: i32, dy: i32) -> (i64, i64) {
    let (x, y) = (i64::from(dx.abs()), i64::from(dy.abs()));
    (x.max(y), x.min(y))
}

/// Straight and diagonal steps over an empty map.
pub fn octile(dx: i32, dy: i32) -> i64 {
    // D (a - b) + R2 b, without the smaller of the two.
    let (x, y) = (i64::from(dx.abs()), i64::from(dy.abs()));
    (R2 - D) * (x + y) + (2 * D - R2) * x.max(y)
}

/// The exact cost over an empty map with the moves of a neighbourhood.
pub fn gauge(neighbourhood: Neighbourhood, dx: i32, dy: i32) -> i64 {
    let (a, b) = ordered(dx, dy);
    match neighbourhood {
        Neighbourhood::Four => D * (a + b),
        Neighbourhood::Eight => octile(dx, dy),
        Neighbourhood::Sixteen | Neighbourhood::TwentyFour if a >= 2 * b => D * (a - 2 * b) + R5 * b,
        Neighbourhood::Sixteen | Neighbourhood::TwentyFour => R5 * (a - b) + R2 * (2 * b - a),
        Neighbourhood::FortyEight if a >= 3 * b => D * (a - 3 * b) + R10 * b,
        Neighbourhood::FortyEight if a >= 2 * b => R10 * (a - 2 * b) + R5 * (3 * b - a),
        Neighbourhood::FortyEight if 2 * a >= 3 * b => R5 * (2 * a - 3 * b) + R13 * (2 * b - a),
        Neighbourhood::FortyEight => R13 * (a - b) + R2 * (3 * b - 2 * a),
    }
}

/// The dynamic weight of Hu et al. 2024, eq 12: h grows by the share of the straight way that is still ahead.
#[derive(Debug, Clone, Copy)]
pub struct DistanceWeight {
    /// Thousandths: 1000 is the paper, w = 1 + d(n)/d(s).
    permille: i64,
    start: i64,
    /// 1 / `start`.
    inverse: f64,
}

impl DistanceWeight {
    /// The weight for a query over `dx` columns and `dy` rows.
    pub fn new(permille: i64, dx: i32, dy: i32) -> Self {
        // No two cells are nearer than one cell.
        let start = euclid(dx, dy).max(D);
        Self { permille, start, inverse: 1.0 / start as f64 }
    }

    /// The weighted estimate `h` of a cell `dx` columns and `dy` rows from the goal; floor divisions, left to right.
    #[inline(always)]
    pub fn apply(&self, h: i64, dx: i32, dy: i32) -> i64 {
        let e = euclid(dx, dy);
        // Divisions are slow. The product may exceed 64 bits, but what is left of it beside a quotient that is a few
        // off does not, so wrapping arithmetic tells it.
        let mut share = (h as f64 * e as f64 * self.inverse) as i64;
        let mut rest = h.wrapping_mul(e).wrapping_sub(share.wrapping_mul(self.start));
        while rest < 0 {
            (share, rest) = (share - 1, rest + self.start);
        }
        while rest >= self.start {
            (share, rest) = (share + 1, rest - self.start);
        }
        h + if self.permille == 1000 { share } else { (self.permille * share).div_euclid(1000) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::Words;
    use crate::planners::moves::cost;

    /// |h(u) − h(v)| ≤ cost(u, v) for every move: what keeps closed cells closed.
    #[test]
    fn the_four_distances_are_the_papers() {
        use Heuristic::{Chebyshev, Euclid, Manhattan, Octile};
        use Neighbourhood::{Eight, Four, Sixteen};
        for (dx, dy) in [(-3, 4), (4, 3), (3, -4), (-4, -3)] {
            let over = [Manhattan, Euclid, Chebyshev, Octile].map(|h| h.estimate(Eight, dx, dy));
            // Equation 3: √2 for each of three diagonal steps, and one straight step.
            assert_eq!(over, [7 * D, 5 * D, 4 * D, 3 * R2 + D], "{dx} {dy}");
        }
        let fits = |h: Heuristic| [Four, Eight, Sixteen].map(|moves| h.is_admissible(moves));
        assert_eq!([Manhattan, Octile].map(fits), [[true, false, false], [true, true, false]]);
        assert_eq!([Euclid, Chebyshev].map(fits), [[true; 3]; 2]);
    }

    #[test]
    fn admissible_estimates_are_consistent() {
        use Neighbourhood::{Eight, FortyEight, Four, Sixteen, TwentyFour};
        for neighbourhood in [Four, Eight, Sixteen, TwentyFour, FortyEight] {
            let moves = neighbourhood.moves();
            for &(_, heuristic) in Heuristic::WORDS {
                if !heuristic.is_admissible(neighbourhood) {
                    continue;
                }
                for (x, y) in (-70..=70).flat_map(|x| (-70..=70).map(move |y| (x, y))) {
                    let h = heuristic.estimate(neighbourhood, x, y);
                    for m in &moves {
                        let step = heuristic.estimate(neighbourhood, x + m.dx, y + m.dy) - h;
                        assert!(step.abs() <= m.cost, "{neighbourhood:?} {heuristic:?} {x} {y} {m:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_gauge_is_exact_along_its_own_moves() {
        for m in Neighbourhood::FortyEight.moves() {
            assert_eq!(gauge(Neighbourhood::FortyEight, m.dx, m.dy), cost(m.dx, m.dy));
        }
        assert_eq!(gauge(Neighbourhood::Sixteen, 7, -3), 3 * R5 + D);
    }

    /// As by exact division, for every pair of a few numbers, those where the ways of reckoning meet among them.
    #[test]
    fn the_weight_is_rounded_down() {
        let ends = [(1, 0), (1, 1), (7, 3), (199, 199), (-500, 13), (4095, -4095)];
        for (start, cell) in ends.into_iter().flat_map(|start| ends.map(|cell| (start, cell))) {
            let (s, e) = (euclid(start.0, start.1), euclid(cell.0, cell.1));
            // Quotients that are whole, and just not.
            let whole = [s, 2 * s, 300 * s].into_iter().flat_map(|h| [h - 1, h, h + 1]);
            let sizes = [-3 * D, 0, 1, D, 999_999_937, (1 << 31) - 1, 1 << 31, 1 << 37];
            for h in whole.chain(sizes) {
                for permille in [1000, 500, 1] {
                    let weight = DistanceWeight::new(permille, start.0, start.1);
                    let share = (i128::from(h) * i128::from(e)).div_euclid(i128::from(s)) as i64;
                    let want = h + (permille * share).div_euclid(1000);
                    assert_eq!(weight.apply(h, cell.0, cell.1), want, "{start:?} {cell:?} {h}");
                }
            }
        }
    }

    #[test]
    fn the_weight_is_two_at_the_start_and_one_at_the_goal() {
        let weight = DistanceWeight::new(1000, 30, 40);
        assert_eq!(weight.apply(70 * D, 30, 40), 140 * D);
        assert_eq!(weight.apply(0, 0, 0), 0);
        let far = DistanceWeight::new(1000, 4000, 3000);
        assert_eq!(far.apply(2 * euclid(4000, 3000), 4000, 3000), 4 * euclid(4000, 3000));
    }
}
