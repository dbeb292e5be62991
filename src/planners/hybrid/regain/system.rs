//! Systems of linear equations with few unknowns.

use crate::geometry::math;

/// A smaller pivot is none.
const SINGULAR: f64 = 1e-12;

/// A system of linear equations: a row for each, and what it equals in the last column.
pub(super) struct System {
    size: usize,
    cells: Vec<f64>,
}

impl System {
    pub(super) fn new(size: usize) -> Self {
        Self { size, cells: vec![0.0; size * (size + 1)] }
    }

    pub(super) fn at(&mut self, row: usize, column: usize) -> &mut f64 {
        &mut self.cells[row * (self.size + 1) + column]
    }

    /// Gives one unknown a value.
    pub(super) fn fix(&mut self, unknown: usize, value: f64) {
        let width = self.size + 1;
        self.cells[unknown * width..][..width].fill(0.0);
        *self.at(unknown, unknown) = 1.0;
        *self.at(unknown, self.size) = value;
    }

    /// The unknowns, by elimination with the largest pivots; nothing where equations depend on each other.
    pub(super) fn solve(mut self) -> Option<Vec<f64>> {
        let (size, width) = (self.size, self.size + 1);
        for step in 0..size {
            let candidates: Vec<f64> =
                (step..size).map(|row| -self.cells[row * width + step].abs()).collect();
            let pivot = step + math::argmin(&candidates);
            if self.cells[pivot * width + step].abs() < SINGULAR {
                return None;
            }
            for column in step..width {
                self.cells.swap(step * width + column, pivot * width + column);
            }
            let (done, rest) = self.cells.split_at_mut((step + 1) * width);
            let top = &done[step * width..];
            for row in rest.chunks_exact_mut(width) {
                let factor = row[step] / top[step];
                if factor != 0.0 {
                    for column in step..width {
                        row[column] -= factor * top[column];
                    }
                }
            }
        }
        let mut unknowns = vec![0.0; size];
        for row in (0..size).rev() {
            let known = (row + 1..size).fold(0.0, |sum, n| sum + self.cells[row * width + n] * unknowns[n]);
            unknowns[row] = (self.cells[row * width + size] - known) / self.cells[row * width + row];
        }
        Some(unknowns)
    }
}
