//! How much more than its length it costs to cross a cell.
//!
//! Weights are whole numbers from 1 to 10. Since none is below 1, an estimate that never exceeds the plain length
//! never exceeds the weighted cost either, and A\* stays optimal with it. A straight line pays, for each cell, its
//! length inside that cell times the cell's weight.

use std::sync::Arc;

use super::move_cost::{D, R2, cost};
use super::{Cell, Frame, Layer};
use crate::geometry::Point;

/// A weight from 1 to 10 for every cell: what crossing it costs, in times its length. Outside it is 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Weights(Layer<u8>);

impl Weights {
    /// The largest weight.
    pub const MOST: u32 = 10;

    /// A map where every length counts once.
    pub fn new(width: u32, height: u32) -> Self {
        Self(Layer::filled(width, height, 1))
    }

    /// Paints runs of cells that are on the map; where something heavier is painted, that stays.
    pub fn paint(&mut self, runs: &[[u32; 3]], weight: u32) {
        for cell in runs.iter().flat_map(|&[x, y, count]| (x..x + count).map(move |x| (x, y))) {
            let cell = Cell::new(cell.0 as i32, cell.1 as i32);
            self.0.set(cell, self.at(cell).max(weight as u8));
        }
    }

    /// The cell's weight.
    pub fn at(&self, cell: Cell) -> u8 {
        self.0.get(cell).unwrap_or(1)
    }

    /// The mean weight of the straight line between two cell centres as a fraction, above and below; the same from both
    /// ends.
    pub fn mean(&self, from: Cell, to: Cell) -> (i64, i64) {
        let (dx, dy) = (i64::from((to.x - from.x).abs()), i64::from((to.y - from.y).abs()));
        let (sx, sy) = ((to.x - from.x).signum(), (to.y - from.y).signum());
        // Borders are crossed at odd multiples of the one and of the other.
        let (across, along) = (dy.max(1), dx.max(1));
        let whole = 2 * across * along;
        let (mut i, mut j, mut last, mut sum) = (0, 0, 0, 0);
        let mut at = from;
        while i < dx || j < dy {
            let column = if i < dx { (2 * i + 1) * across } else { whole };
            let row = if j < dy { (2 * j + 1) * along } else { whole };
            let next = column.min(row);
            sum += (next - last) * i64::from(self.at(at));
            last = next;
            if column == next {
                (i, at) = (i + 1, at.offset(sx, 0));
            }
            if row == next {
                (j, at) = (j + 1, at.offset(0, sy));
            }
        }
        (sum + (whole - last) * i64::from(self.at(at)), whole)
    }

    /// The cost of a straight move between two cells, every part of it times the weight of its cell, rounded up.
    /// Micro-cells.
    pub(crate) fn cost(&self, from: Cell, to: Cell) -> i64 {
        let (dx, dy) = ((to.x - from.x).abs(), (to.y - from.y).abs());
        if dx.max(dy) == 1 {
            // Half of a single step lies in each of its cells.
            let half = if dx == dy { R2 / 2 } else { D / 2 };
            return half * i64::from(self.at(from) + self.at(to));
        }
        let (above, below) = self.mean(from, to);
        (cost(dx, dy) * above + below - 1) / below
    }

    /// The length of a straight line, every part of it times the weight there. Cells, with centres at whole numbers.
    pub fn along(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
        let mut cell = from.map(|v| (v + 0.5).floor());
        let mut borders = [0, 1].map(|k| {
            let border = cell[k] + if way[k] < 0.0 { -0.5 } else { 0.5 };
            if way[k] == 0.0 { f64::INFINITY } else { (border - from[k]) / way[k] }
        });
        let (mut last, mut sum) = (0.0, 0.0);
        loop {
            let k = usize::from(borders[1] < borders[0]);
            let next = borders[k].min(1.0);
            sum += (next - last) * f64::from(self.at(Cell::new(cell[0] as i32, cell[1] as i32)));
            if next >= 1.0 {
                return length * sum;
            }
            last = next;
            cell[k] += way[k].signum();
            borders[k] += 1.0 / way[k].abs();
        }
    }
}

/// Weights at their place in the world.
#[derive(Debug, Clone)]
pub struct WeightMap {
    /// The lattice.
    pub frame: Frame,
    /// Its cells' weights.
    pub weights: Arc<Weights>,
}

impl WeightMap {
    /// The length of a straight line, every part of it times the weight there, metres.
    pub fn along(&self, from: Point, to: Point) -> f64 {
        let [from, to] = [from, to].map(|point| self.frame.lattice(point).map(|v| v - 0.5));
        self.weights.along(from, to) * self.frame.resolution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn painted() -> Weights {
        let mut weights = Weights::new(4, 3);
        weights.paint(&[[1, 0, 2]], 5);
        weights.paint(&[[1, 1, 1]], 9);
        weights.paint(&[[1, 1, 3]], 3);
        weights
    }

    #[test]
    fn the_heavier_paint_stays() {
        let weights = painted();
        let row = |y| (-1..5).map(|x| weights.at(Cell::new(x, y))).collect::<Vec<_>>();
        assert_eq!(row(0), [1, 1, 5, 5, 1, 1]);
        assert_eq!(row(1), [1, 1, 9, 3, 3, 1]);
        assert_eq!(row(2), [1; 6]);
    }

    #[test]
    fn lines_count_each_cell_by_its_share() {
        let weights = painted();
        let mean = |x, y| {
            let (from, to) = (Cell::new(0, 0), Cell::new(x, y));
            assert_eq!(weights.mean(from, to), weights.mean(to, from));
            let (above, below) = weights.mean(from, to);
            above as f64 / below as f64
        };
        assert_eq!(mean(0, 0), 1.0);
        assert_eq!(mean(1, 0), 3.0);
        assert_eq!(mean(1, 1), 5.0);
        // A quarter of a knight's move lies in each of (0, 0), (1, 0), (1, 1) and (2, 1).
        assert_eq!(mean(2, 1), (1.0 + 5.0 + 9.0 + 3.0) / 4.0);
        // A sixth in (0, 0) and (3, 1), a third in (1, 0) and (2, 1).
        assert_eq!(mean(3, 1), (1.0 + 2.0 * 5.0 + 2.0 * 3.0 + 3.0) / 6.0);
    }

    #[test]
    fn both_ways_to_measure_agree() {
        let weights = painted();
        let cells = || (0..4).flat_map(|x| (0..3).map(move |y| Cell::new(x, y)));
        for (a, b) in cells().flat_map(|a| cells().map(move |b| (a, b))) {
            let [from, to] = [a, b].map(|c| [f64::from(c.x), f64::from(c.y)]);
            let length = ((to[0] - from[0]).powi(2) + (to[1] - from[1]).powi(2)).sqrt();
            let (above, below) = weights.mean(a, b);
            assert!(
                (weights.along(from, to) - length * above as f64 / below as f64).abs() < 1e-9,
                "{a:?} {b:?}"
            );
        }
        assert!((weights.along([1.2, 0.1], [1.2, 0.3]) - 1.0).abs() < 1e-12);
        // Along a border, and from one to the west.
        assert!((weights.along([0.5, 0.0], [-0.5, 0.0]) - 1.0).abs() < 1e-12);
    }
}
