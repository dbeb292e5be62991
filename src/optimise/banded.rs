//! Symmetric positive definite systems whose unknowns touch only near ones.
//!
//! One Gauss–Newton step solves H·δ = −g, where H sums w·a·aᵀ over all terms with the slopes a. Every term of the path
//! stage couples a node with itself and the next one only. So entry (i, j) of H is zero for |i − j| ≥ 10: H has a band.
//! Cholesky's factorisation creates nothing outside the band, so a system of n unknowns takes n·10² operations and n·10
//! numbers, instead of n³ and n². For 200 nodes that is a factor of ten thousand.
//!
//! # Layout
//!
//! Row i holds the entries (i, i) to (i, i + 9), the diagonal first: the lower half is the mirror image and is not
//! kept. Unknown `k * BLOCK + u` is component u of node k, in the order of [`segment`](super::segment). Memory is kept
//! from one step to the next.

/// Unknowns of one node.
pub(super) const BLOCK: usize = 5;
/// Entries of a row from the diagonal on: a node's unknowns touch those of the next node.
const WIDTH: usize = 2 * BLOCK;

/// The upper band of a matrix and a right-hand side.
///
/// `rows` stays as it was assembled, `factor` is the last factorisation: so a step can be repeated with more damping
/// without assembling again.
#[derive(Debug, Default)]
pub(super) struct Banded {
    rows: Vec<[f64; WIDTH]>,
    right: Vec<f64>,
    factor: Vec<[f64; WIDTH]>,
}

impl Banded {
    /// Empties it for so many nodes.
    pub(super) fn clear(&mut self, nodes: usize) {
        self.rows.clear();
        self.rows.resize(nodes * BLOCK, [0.0; WIDTH]);
        self.right.clear();
        self.right.resize(nodes * BLOCK, 0.0);
    }

    /// Takes over another one's matrix and right-hand side.
    pub(super) fn copy(&mut self, other: &Self) {
        self.rows.clone_from(&other.rows);
        self.right.clone_from(&other.right);
    }

    /// Adds the term w/2·(residual + Σ slope·δ)² by its Gauss–Newton normal equations. Unknowns ascend and lie in two
    /// neighbouring nodes.
    pub(super) fn square(&mut self, slopes: &[(usize, f64)], residual: f64, weight: f64) {
        for (k, &(i, a)) in slopes.iter().enumerate() {
            self.right[i] -= weight * a * residual;
            for &(j, b) in &slopes[k..] {
                self.rows[i][j - i] += weight * a * b;
            }
        }
    }

    /// Adds the term slope·δ. Its share of the gradient is constant and it adds nothing to the matrix.
    pub(super) fn slope(&mut self, unknown: usize, slope: f64) {
        self.right[unknown] -= slope;
    }

    /// Keeps an unknown at 0.
    ///
    /// Row and column become those of the identity, which keeps the matrix symmetric and the band as it is. Terms must
    /// not be added to it afterwards.
    pub(super) fn fix(&mut self, unknown: usize) {
        self.rows[unknown] = [0.0; WIDTH];
        self.rows[unknown][0] = 1.0;
        self.right[unknown] = 0.0;
        for back in 1..WIDTH.min(unknown + 1) {
            self.rows[unknown - back][back] = 0.0;
        }
    }

    /// The solution with `damping[unknown % BLOCK]` added to the diagonal, by Cholesky's factorisation; `None` where
    /// that meets a pivot that is not positive.
    ///
    /// Without a square root: H = L·D·Lᵀ with ones on the diagonal of L, where row i of `factor` is row i of D·Lᵀ. Then
    /// two sweeps: forwards L·y = right side, backwards D·Lᵀ·x = y. A pivot that is not positive means that the matrix
    /// is singular within rounding; more damping helps.
    pub(super) fn solve(&mut self, damping: [f64; BLOCK]) -> Option<Vec<f64>> {
        let n = self.rows.len();
        self.factor.clone_from(&self.rows);
        for i in 0..n {
            self.factor[i][0] += damping[i % BLOCK];
            let pivot = self.factor[i][0];
            if pivot.is_nan() || pivot <= 0.0 {
                return None;
            }
            let row = self.factor[i];
            for k in 1..WIDTH.min(n - i) {
                let share = row[k] / pivot;
                if share != 0.0 {
                    let target = &mut self.factor[i + k];
                    for j in k..WIDTH {
                        target[j - k] -= share * row[j];
                    }
                }
            }
        }
        let mut x = self.right.clone();
        for i in 0..n {
            let share = x[i] / self.factor[i][0];
            for k in 1..WIDTH.min(n - i) {
                x[i + k] -= self.factor[i][k] * share;
            }
        }
        for i in (0..n).rev() {
            let row = &self.factor[i];
            let rest = (1..WIDTH.min(n - i)).fold(0.0, |sum, k| sum + row[k] * x[i + k]);
            x[i] = (x[i] - rest) / row[0];
        }
        Some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_solves_and_fixed_unknowns_stay() {
        let mut system = Banded::default();
        let nodes = 7;
        system.clear(nodes);
        let mut seed = 1_u64;
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
        };
        let mut dense = vec![vec![0.0; nodes * BLOCK]; nodes * BLOCK];
        let mut right = vec![0.0; nodes * BLOCK];
        for node in 0..nodes - 1 {
            for _ in 0..12 {
                let slopes: Vec<(usize, f64)> = (0..2 * BLOCK).map(|k| (node * BLOCK + k, draw())).collect();
                let residual = draw();
                system.square(&slopes, residual, 2.0);
                for &(i, a) in &slopes {
                    right[i] -= 2.0 * a * residual;
                    for &(j, b) in &slopes {
                        dense[i][j] += 2.0 * a * b;
                    }
                }
            }
        }
        system.slope(3, 0.7);
        right[3] -= 0.7;
        system.fix(0);
        system.fix(17);
        let x = system.solve([0.25; BLOCK]).unwrap();
        assert_eq!((x[0], x[17]), (0.0, 0.0));
        for i in (0..nodes * BLOCK).filter(|i| ![0, 17].contains(i)) {
            let sum = (0..nodes * BLOCK).fold(0.25 * x[i], |sum, j| sum + dense[i][j] * x[j]);
            assert!((sum - right[i]).abs() < 1e-9, "{i}");
        }
        system.clear(2);
        assert!(system.solve([0.0; BLOCK]).is_none());
    }
}
