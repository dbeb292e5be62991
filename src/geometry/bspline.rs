//! Cubic B-splines; those with uniform knots are fitted to points: as smooth as a given residual allows.
//!
//! A spline is C(u) = Σ Pᵢ·Bᵢ(u) with control points Pᵢ and cubic basis functions Bᵢ, of which four do not vanish at
//! any u. It is twice continuously differentiable, so its curvature is continuous: a car can follow it without turning
//! its wheel at a standstill.
//!
//! A fit makes
//!
//! ```text
//! Σ wⱼ·|C(uⱼ) − pⱼ|² + λ·Σ |Δ³Pᵢ|²
//! ```
//!
//! least over clamped uniform knots (penalised splines, Eilers and Marx 1996), where Δ³ is the third difference, which
//! vanishes on parabolas. The larger λ, the smoother the curve and the farther it is from the points. λ is bisected
//! on a logarithmic scale until the root mean square distance is as large as allowed. The matrix has seven diagonals,
//! so a fit of m points with n control points takes O(m + n) for each of at most 16 values of λ.

use super::{Point, Vector};

/// Steps of the bisection for λ, and the powers of ten between which it looks: fourteen halvings of eleven decades find
/// λ to a thousandth of a decade.
const STEPS: u32 = 14;
const POWERS: (f64, f64) = (-4.0, 7.0);

/// A cubic B-spline over u from 0 to 1. u is not the arc length: the speed |C′(u)| varies.
#[derive(Debug, Clone)]
pub struct Spline {
    pub(super) controls: Vec<Point>,
    pub(super) knots: Knots,
}

/// Where the polynomials of a cubic spline join.
#[derive(Debug, Clone)]
pub(super) enum Knots {
    /// Clamped, the inner ones evenly spaced.
    Uniform,
    /// As listed, four more than control points: 0 and 1 four times each, the inner ones between them.
    Listed(Vec<f64>),
}

impl Knots {
    /// Knot i of a spline with n control points.
    fn at(&self, n: usize, i: usize) -> f64 {
        match self {
            Self::Uniform => knot(n, i),
            Self::Listed(knots) => knots[i],
        }
    }

    /// The last knot, before the end, that is not beyond u.
    fn span(&self, n: usize, u: f64) -> usize {
        match self {
            Self::Uniform => ((u * (n - 3) as f64).floor().clamp(0.0, (n - 4) as f64)) as usize + 3,
            Self::Listed(knots) => knots[4..n].partition_point(|&knot| knot <= u) + 3,
        }
    }

    /// The cubic functions that do not vanish at u: which control point they begin with, and their values.
    pub(super) fn bases(&self, n: usize, u: f64) -> (usize, [f64; 4]) {
        let (first, [.., cubic]) = self.all_bases(n, u);
        (first, cubic)
    }

    /// The same with the functions of degree 1 and 2 on the way to them.
    fn all_bases(&self, n: usize, u: f64) -> (usize, [[f64; 4]; 3]) {
        let span = self.span(n, u);
        let around = [0, 1, 2, 3, 4, 5].map(|k| self.at(n, span + k - 2));
        let mut values = [1.0, 0.0, 0.0, 0.0];
        let by_degree = [1, 2, 3].map(|d| {
            let mut saved = 0.0;
            for (r, value) in values[..d].iter_mut().enumerate() {
                let (right, left) = (around[r + 3], around[r + 3 - d]);
                let share = *value / (right - left);
                *value = saved + (right - u) * share;
                saved = (u - left) * share;
            }
            values[d] = saved;
            values
        });
        (span - 3, by_degree)
    }
}

/// A place on a spline.
#[derive(Debug, Clone, Copy)]
pub struct CurvePoint {
    /// Position, metres.
    pub point: Point,
    /// Derivatives by u.
    pub first: Vector,
    /// Of the second order.
    pub second: Vector,
}

impl CurvePoint {
    /// Signed curvature, 1/m, positive to the left: κ = (x′y″ − y′x″)/|C′|³, which does not depend on the parameter.
    pub fn curvature(&self) -> f64 {
        let speed = self.first.norm();
        self.first.perp(&self.second) / (speed * speed * speed)
    }
}

impl Spline {
    /// The smoothest uniform spline whose root mean square distance from `points` is at most `sigma` metres, ends met
    /// exactly; the closest one where none is as close. `rows` are the points' own, `slopes` derivatives by u to have
    /// at the ends.
    pub fn fit(
        points: &[Point],
        rows: &Rows,
        weights: &[f64],
        sigma: f64,
        slopes: [Option<Vector>; 2],
    ) -> Self {
        let count = rows.count;
        let ends = [points[0].coords, points[points.len() - 1].coords];
        let third = 1.0 / (3.0 * (count - 3) as f64);
        let mut fixed = vec![(0, ends[0]), (count - 1, ends[1])];
        fixed.extend(slopes[0].map(|slope| (1, ends[0] + slope * third)));
        fixed.extend(slopes[1].map(|slope| (count - 2, ends[1] - slope * third)));
        let system = System::new(points, &rows.values, weights, count);
        let solve =
            |power: f64| Self { controls: system.solve(&fixed, power10(power)), knots: Knots::Uniform };
        let is_near = |spline: &Self| spline.distance(points, rows) <= sigma;
        let (mut low, mut high) = POWERS;
        let mut best = solve(high);
        if is_near(&best) {
            return best;
        }
        best = solve(low);
        for _ in 0..STEPS {
            let middle = f64::midpoint(low, high);
            let next = solve(middle);
            if is_near(&next) {
                (low, best) = (middle, next);
            } else {
                high = middle;
            }
        }
        best
    }

    /// The place at u, from 0 to 1. Derivatives are splines of a lower degree over the same knots, whose control points
    /// are divided differences of these.
    pub fn at(&self, u: f64) -> CurvePoint {
        let n = self.controls.len();
        let (first, [linear, quadratic, cubic]) = self.knots.all_bases(n, u);
        let knot = |i: usize| self.knots.at(n, i);
        let zeroth = [0, 1, 2, 3].map(|k| self.controls[first + k].coords);
        // Control point k of a derivative depends on two of the function's.
        let derived = |controls: &[Vector], degree: usize, k: usize| {
            let i = first + k + 4 - degree;
            (controls[k + 1] - controls[k]) * (degree as f64 / (knot(i + degree) - knot(i)))
        };
        let slopes = [0, 1, 2].map(|k| derived(&zeroth, 3, k));
        let bends = [0, 1].map(|k| derived(&slopes, 2, k));
        let sum = |controls: &[Vector], values: [f64; 4]| {
            controls.iter().zip(values).fold(Vector::zeros(), |sum, (c, v)| sum + c * v)
        };
        CurvePoint {
            point: Point::from(sum(&zeroth, cubic)),
            first: sum(&slopes, quadratic),
            second: sum(&bends, linear),
        }
    }

    /// Where each control point has the most to say.
    pub fn places(&self) -> Vec<CurvePoint> {
        let n = self.controls.len();
        let mean = |i: usize| (1..4).map(|k| self.knots.at(n, i + k)).sum::<f64>() / 3.0;
        (0..n).map(|i| self.at(mean(i).clamp(0.0, 1.0))).collect()
    }

    /// The same with its control points moved. It begins and ends as it did, in place and direction.
    #[must_use]
    pub fn moved(&self, by: impl Fn(usize) -> Vector) -> Self {
        let mut moved = self.clone();
        let last = moved.controls.len() - 2;
        for (i, control) in moved.controls.iter_mut().enumerate().take(last).skip(2) {
            *control += by(i);
        }
        moved
    }

    /// The places of rows.
    pub fn points<'a>(&'a self, rows: &'a Rows) -> impl Iterator<Item = Point> + 'a {
        rows.values.iter().map(|(first, values)| {
            let controls = self.controls[*first..].iter().zip(values);
            Point::from(controls.fold(Vector::zeros(), |sum, (c, v)| sum + c.coords * *v))
        })
    }

    fn distance(&self, points: &[Point], rows: &Rows) -> f64 {
        let sum = self.points(rows).zip(points).fold(0.0, |sum, (near, p)| sum + (near - p).norm_squared());
        (sum / points.len() as f64).sqrt()
    }
}

/// Parameters and the functions of a uniform spline there.
#[derive(Debug, Clone)]
pub struct Rows {
    count: usize,
    values: Vec<(usize, [f64; 4])>,
}

impl Rows {
    /// Of a spline with `count` (at least 4) control points at these u.
    pub fn new(at: &[f64], count: usize) -> Self {
        Self { count, values: at.iter().map(|&u| Knots::Uniform.bases(count, u)).collect() }
    }
}

/// 10 to a power.
fn power10(power: f64) -> f64 {
    super::math::exp(power * core::f64::consts::LN_10)
}

/// Knot i of a clamped uniform cubic spline with n control points.
fn knot(n: usize, i: usize) -> f64 {
    (i.clamp(3, n) - 3) as f64 / (n - 3) as f64
}

/// The banded normal equations of a fit, without the penalty. They are set up once and serve every λ.
struct System {
    /// Lower half of the matrix: `band[i][k]` couples i with i − k.
    band: Vec<[f64; 4]>,
    right: Vec<Vector>,
}

impl System {
    /// The normal equations of the points alone. Rows overlap in four control points, so the matrix is a band.
    fn new(points: &[Point], rows: &[(usize, [f64; 4])], weights: &[f64], n: usize) -> Self {
        let mut system = Self { band: vec![[0.0; 4]; n], right: vec![Vector::zeros(); n] };
        for ((point, (first, values)), &weight) in points.iter().zip(rows).zip(weights) {
            for (right, value) in system.right[*first..].iter_mut().zip(values) {
                *right += point.coords * (weight * value);
            }
            add(&mut system.band, *first, values, weight);
        }
        system
    }

    /// All control points, for one λ. Fixed ones are moved to the right-hand side, which keeps the matrix symmetric and
    /// banded; it is positive definite, so Cholesky's factorisation needs no pivots.
    fn solve(&self, fixed: &[(usize, Vector)], lambda: f64) -> Vec<Point> {
        let n = self.right.len();
        let (mut band, mut right) = (self.band.clone(), self.right.clone());
        for first in 0..n - 3 {
            add(&mut band, first, &[-1.0, 3.0, -3.0, 1.0], lambda);
        }
        for &(fixed, value) in fixed {
            let around = fixed.saturating_sub(3)..(fixed + 4).min(n);
            for (other, sum) in right.iter_mut().enumerate().take(around.end).skip(around.start) {
                let (high, low) = (fixed.max(other), fixed.min(other));
                let coupling = std::mem::take(&mut band[high][high - low]);
                *sum -= value * coupling;
            }
            band[fixed][0] = 1.0;
            right[fixed] = value;
        }
        // Cholesky in place, then both substitutions.
        for i in 0..n {
            for k in (0..=i.min(3)).rev() {
                let j = i - k;
                let mut sum = band[i][k];
                for m in i.saturating_sub(3)..j {
                    sum -= band[i][i - m] * band[j][j - m];
                }
                band[i][k] = if k == 0 { sum.max(1e-300).sqrt() } else { sum / band[j][0] };
            }
        }
        for i in 0..n {
            for m in i.saturating_sub(3)..i {
                let known = right[m];
                right[i] -= known * band[i][i - m];
            }
            right[i] /= band[i][0];
        }
        for i in (0..n).rev() {
            for m in i + 1..(i + 4).min(n) {
                let known = right[m];
                right[i] -= known * band[m][m - i];
            }
            right[i] /= band[i][0];
        }
        right.into_iter().map(Point::from).collect()
    }
}

fn add(band: &mut [[f64; 4]], first: usize, values: &[f64; 4], weight: f64) {
    for a in 0..4 {
        for b in 0..=a {
            band[first + a][a - b] += weight * values[a] * values[b];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::math;

    fn wave(sigma: f64) -> (Vec<Point>, Vec<f64>, Spline) {
        let at: Vec<f64> = (0..=100).map(|i| f64::from(i) / 100.0).collect();
        let points: Vec<Point> = at
            .iter()
            .map(|u| Point::new(100.0 * u, 2.0 * math::sin(9.0 * u) + 0.1 * math::sin(400.0 * u)))
            .collect();
        let spline = Spline::fit(&points, &Rows::new(&at, 30), &[1.0; 101], sigma, [None; 2]);
        (points, at, spline)
    }

    #[test]
    fn ends_are_met_and_the_residual_is_used_up() {
        for sigma in [0.1, 0.3, 1.0] {
            let (points, at, spline) = wave(sigma);
            assert!((spline.at(0.0).point - points[0]).norm() < 1e-9);
            assert!((spline.at(1.0).point - points[100]).norm() < 1e-9);
            let residual = spline.distance(&points, &Rows::new(&at, 30));
            assert!(residual <= sigma && residual > 0.95 * sigma, "{sigma}: {residual}");
        }
    }

    #[test]
    fn a_line_stays_a_line() {
        let at: Vec<f64> = (0..=20).map(|i| f64::from(i) / 20.0).collect();
        let points: Vec<Point> = at.iter().map(|u| Point::new(7.0 * u, 1.0 + u)).collect();
        let spline = Spline::fit(&points, &Rows::new(&at, 6), &[1.0; 21], 0.1, [None; 2]);
        for u in [0.0, 0.13, 0.5, 1.0] {
            let place = spline.at(u);
            assert!((place.point.y - 1.0 - place.point.x / 7.0).abs() < 1e-9, "{place:?}");
            assert!(place.curvature().abs() < 1e-6);
        }
    }

    #[test]
    fn derivatives_are_those_of_the_curve() {
        let (_, _, spline) = wave(0.1);
        let step = 1e-5;
        for k in 1..50 {
            let u = f64::from(k) / 50.0;
            let (before, here, after) = (spline.at(u - step), spline.at(u), spline.at(u + step));
            let first = (after.point - before.point) / (2.0 * step);
            let second = (after.first - before.first) / (2.0 * step);
            assert!((first - here.first).norm() < 1e-3 * here.first.norm(), "{u}: {first} {}", here.first);
            assert!((second - here.second).norm() < 0.02 * (1.0 + here.second.norm()), "{u}");
        }
    }

    #[test]
    fn the_second_derivative_does_not_jump() {
        let (_, _, spline) = wave(0.1);
        for i in 4..30 {
            let (u, near) = (knot(30, i), 1e-9);
            let (before, after) = (spline.at(u - near), spline.at(u + near));
            assert!((before.point - after.point).norm() < 1e-5, "{u}");
            assert!((before.first - after.first).norm() < 1e-4 * before.first.norm(), "{u}");
            assert!((before.second - after.second).norm() < 1e-4 * (1.0 + before.second.norm()), "{u}");
        }
    }

    #[test]
    fn slopes_at_the_ends_are_kept() {
        let (points, at, free) = wave(0.3);
        let slopes = [Vector::new(80.0, -40.0), Vector::new(60.0, 60.0)];
        let bent = Spline::fit(&points, &Rows::new(&at, 30), &[1.0; 101], 0.3, slopes.map(Some));
        for (u, slope) in [0.0, 1.0].into_iter().zip(slopes) {
            assert!((bent.at(u).first - slope).norm() < 1e-9, "{}", bent.at(u).first);
            assert!((free.at(u).first - slope).norm() > 10.0);
            assert!((bent.at(u).point - free.at(u).point).norm() < 1e-9);
        }
    }

    #[test]
    fn heavy_points_are_passed_closer() {
        let (points, at, _) = wave(1.0);
        let mut weights = [1.0; 101];
        weights[50] = 1e4;
        let heavy = Spline::fit(&points, &Rows::new(&at, 30), &weights, 1.0, [None; 2]);
        assert!((heavy.at(0.5).point - points[50]).norm() < 0.05);
    }

    /// Moved control points move their places, and neither the ends nor their directions.
    #[test]
    fn moved_control_points_keep_the_ends() {
        let (data, at, _) = wave(1.0);
        let spline = Spline::fit(&data, &Rows::new(&at, 12), &vec![1.0; data.len()], 0.05, [None; 2]);
        let moved = spline.moved(|_| Vector::new(0.0, 0.5));
        for end in [0.0, 1.0] {
            let [old, new] = [&spline, &moved].map(|spline| spline.at(end));
            assert!((old.point - new.point).norm() < 1e-12);
            assert!(old.first.normalize().perp(&new.first.normalize()).abs() < 1e-12);
        }
        let shift = moved.at(0.5).point - spline.at(0.5).point;
        assert!((shift - Vector::new(0.0, 0.5)).norm() < 1e-12, "{shift:?}");
        let places = spline.places();
        assert_eq!(places.len(), 12);
        assert!(places.windows(2).all(|pair| pair[1].point.x > pair[0].point.x));
    }
}
