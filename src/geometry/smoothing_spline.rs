//! Smoothing splines whose knots the data choose, as FITPACK's `parcur` and with it `scipy.interpolate.splprep` fit
//! them: P. Dierckx, Curve and Surface Fitting with Splines, Oxford 1993, chapters 4, 5 and 9.
//!
//! Knots are added, always at a point in the interval with the largest sum of squared residuals, until a least-squares
//! spline is as close as asked. Then the jumps of the third derivative at these knots are made as small as the bound
//! on that sum allows. Cubic curves in the plane, all weights 1.
//!
//! One of the papers smooths its paths by `splprep`, so its figures can only be reproduced with the same knots; for
//! curves that a car is to follow, [`bspline`](super::bspline) has a measure of distance in metres instead. A pass over
//! m points with n knots takes O(m + n); knots are added in few passes, because their number grows by the ratio of what
//! is missing to what the last ones gained, at most doubling.

use super::bspline::{Knots, Spline};
use super::{Point, Vector};

/// Share of the bound by which the sum of squares may differ from it.
const TOLERANCE: f64 = 0.001;
/// Steps of the search for the penalty.
const MOST_STEPS: u32 = 20;
/// Factor between penalties until the bound lies between two, and the share by which a guess stays off a known one.
const FACTOR: f64 = 0.04;
const SHARE: f64 = 0.1;

/// Rows of an upper triangle with five diagonals.
type Band = Vec<[f64; 5]>;

/// The spline through at least four distinct consecutive points whose sum of squared distances from them is
/// `smoothing`, square metres, or less where a single cubic is closer. The parameter is the share of the way along the
/// points. `None` for fewer points, consecutive equal ones or a bound that is not positive.
///
/// # Examples
/// ```
/// use parkade::geometry::{Point, smoothing_spline::smoothing_spline};
///
/// let points = [(0.0, 0.0), (1.0, 2.0), (3.0, 2.5), (4.0, 0.5), (6.0, 0.0)].map(|(x, y)| Point::new(x, y));
/// let close = smoothing_spline(&points, 1e-6).unwrap();
/// assert!((close.at(0.0).point - points[0]).norm() < 1e-3);
/// ```
pub fn smoothing_spline(points: &[Point], smoothing: f64) -> Option<Spline> {
    let mut at = vec![0.0];
    for pair in points.windows(2) {
        at.push(at[at.len() - 1] + (pair[1] - pair[0]).norm());
    }
    let length = at[at.len() - 1];
    for u in &mut at {
        *u /= length;
    }
    let is_sound = points.len() >= 4 && at.windows(2).all(|w| w[0] < w[1]) && smoothing > 0.0;
    is_sound.then(|| Fit { points, at, bound: smoothing, knots: Vec::new() }.spline())
}

/// Points, their parameters and the knots so far.
struct Fit<'a> {
    points: &'a [Point],
    at: Vec<f64>,
    bound: f64,
    /// Inner knots.
    knots: Vec<f64>,
}

/// Least squares over some knots.
struct Solved {
    band: Band,
    right: Vec<Vector>,
    controls: Vec<Vector>,
    /// Sum of squared residuals.
    sum: f64,
}

/// An interval between knots.
#[derive(Clone, Copy)]
struct Interval {
    /// Sum of squared residuals in it.
    sum: f64,
    /// Points strictly inside.
    inside: usize,
}

impl Fit<'_> {
    /// Dierckx's two stages. Knots are added until the least-squares spline is close enough: as many at a time as the
    /// last gain promises, at least half as many as before and at most twice. Then the jumps at the knots are smoothed
    /// up to the bound.
    fn spline(mut self) -> Spline {
        let count = self.points.len();
        let mut intervals = vec![Interval { sum: 0.0, inside: count - 2 }];
        let mut solved = self.least_squares();
        let whole = solved.sum;
        let (mut before, mut added) = (0.0, 0);
        while solved.sum - self.bound >= TOLERANCE * self.bound && self.knots.len() + 4 < count {
            added = if self.knots.is_empty() {
                1
            } else {
                let (more, gain) = (solved.sum - self.bound, before - solved.sum);
                let wanted = if gain > TOLERANCE * self.bound {
                    (added as f64 * more / gain) as usize
                } else {
                    2 * added
                };
                wanted.max(added / 2).max(1).min(2 * added)
            };
            before = solved.sum;
            self.residuals(&solved.controls, &mut intervals);
            for _ in 0..added {
                if !self.add_knot(&mut intervals) {
                    break;
                }
                if self.knots.len() + 4 == count {
                    // As many as there are points: where an interpolating spline has them.
                    self.knots = self.at[2..count - 2].to_vec();
                    break;
                }
            }
            solved = self.least_squares();
        }
        let is_done = (solved.sum - self.bound).abs() < TOLERANCE * self.bound || self.knots.is_empty();
        let controls = if is_done { solved.controls } else { self.smoothed(&solved, whole) };
        Spline { controls: controls.into_iter().map(Point::from).collect(), knots: self.all_knots() }
    }

    fn all_knots(&self) -> Knots {
        Knots::Listed([&[0.0; 4], &self.knots[..], &[1.0; 4]].concat())
    }

    /// Per point: the first control point that counts, and the values of the functions there.
    fn rows(&self) -> Vec<(usize, [f64; 4])> {
        let (knots, count) = (self.all_knots(), self.knots.len() + 4);
        self.at.iter().map(|&u| knots.bases(count, u)).collect()
    }

    /// The least-squares spline over the present knots: one Givens rotation per point and basis function, so no normal
    /// equations are formed, whose condition would be the square. O(points + knots).
    fn least_squares(&self) -> Solved {
        let count = self.knots.len() + 4;
        let (mut band, mut right) = (vec![[0.0; 5]; count], vec![Vector::zeros(); count]);
        let mut sum = 0.0;
        for (point, (first, values)) in self.points.iter().zip(self.rows()) {
            let [a, b, c, d] = values;
            sum += rotate(&mut band, &mut right, first, [a, b, c, d, 0.0], point.coords).norm_squared();
        }
        let controls = substitute(&band, &right);
        Solved { band, right, controls, sum }
    }

    /// Squared residuals of the intervals: a point on a knot counts half to either side.
    fn residuals(&self, controls: &[Vector], intervals: &mut [Interval]) {
        let (mut sum, mut interval) = (0.0, 0);
        for (point, (first, values)) in self.points.iter().zip(self.rows()) {
            let term = (near(controls, first, values) - point.coords).norm_squared();
            sum += term;
            if first > interval {
                intervals[interval].sum = sum - term / 2.0;
                (sum, interval) = (term / 2.0, first);
            }
        }
        intervals[interval].sum = sum;
    }

    /// Puts a knot at the middle point of the interval with the largest residual; false where none can be divided.
    fn add_knot(&mut self, intervals: &mut Vec<Interval>) -> bool {
        let (mut worst, mut begin) = (None::<(usize, usize)>, 0);
        for (i, interval) in intervals.iter().enumerate() {
            let most = worst.map_or(0.0, |(worst, _)| intervals[worst].sum);
            if interval.inside > 0 && interval.sum > most {
                worst = Some((i, begin));
            }
            begin += interval.inside + 1;
        }
        let Some((i, begin)) = worst else { return false };
        let Interval { sum, inside } = intervals[i];
        let half = inside / 2;
        let part = |inside: usize, all: usize| Interval { sum: sum * inside as f64 / all as f64, inside };
        intervals[i] = part(half, inside);
        intervals.insert(i + 1, part(inside - half - 1, inside));
        self.knots.insert(i, self.at[begin + half + 1]);
        true
    }

    /// The control points with the smallest jumps whose sum of squares is the bound; `whole` is that of one cubic.
    fn smoothed(&self, solved: &Solved, whole: f64) -> Vec<Vector> {
        let (jumps, rows) = (self.jumps(), self.rows());
        let count = solved.controls.len();
        let mut p = count as f64 / solved.band.iter().fold(0.0, |sum, row| sum + row[0]);
        // Bounds on p, and by how much the sums there miss: too large at the low one. The high one is infinite at
        // first.
        let (mut low, mut high) = ((0.0, whole - self.bound), (-1.0, solved.sum - self.bound));
        let (mut is_low_known, mut is_high_known) = (false, false);
        let mut controls = Vec::new();
        for _ in 0..MOST_STEPS {
            let (mut band, mut right) = (solved.band.clone(), solved.right.clone());
            for (i, row) in jumps.iter().enumerate() {
                rotate(&mut band, &mut right, i, row.map(|jump| jump / p), Vector::zeros());
            }
            controls = substitute(&band, &right);
            let terms = self.points.iter().zip(&rows);
            let sum = terms.fold(0.0, |sum, (point, &(first, values))| {
                sum + (near(&controls, first, values) - point.coords).norm_squared()
            });
            let here = (p, sum - self.bound);
            if here.1.abs() < TOLERANCE * self.bound {
                break;
            }
            if !is_high_known {
                if here.1 - high.1 <= TOLERANCE * self.bound {
                    high = here;
                    p *= FACTOR;
                    if p <= low.0 {
                        p = low.0 * (1.0 - SHARE) + here.0 * SHARE;
                    }
                    continue;
                }
                is_high_known = here.1 < 0.0;
            }
            if !is_low_known {
                if low.1 - here.1 <= TOLERANCE * self.bound {
                    low = here;
                    p /= FACTOR;
                    if high.0 >= 0.0 && p >= high.0 {
                        p = here.0 * SHARE + high.0 * (1.0 - SHARE);
                    }
                    continue;
                }
                is_low_known = here.1 > 0.0;
            }
            if here.1 >= low.1 || here.1 <= high.1 {
                break;
            }
            p = between(low, here, high);
            *if here.1 < 0.0 { &mut high } else { &mut low } = here;
        }
        controls
    }

    /// Per inner knot: the jump of the third derivative there as a sum over five control points.
    fn jumps(&self) -> Band {
        let Knots::Listed(knots) = self.all_knots() else { return Vec::new() };
        let scale = (self.knots.len() + 1) as f64;
        let jump = |i: usize| {
            let here = knots[i + 4];
            let away = |j: usize| here - knots[j];
            // The knots around, without the one itself.
            let around = [i, i + 1, i + 2, i + 3, i + 5, i + 6, i + 7, i + 8];
            let mut row = [0.0; 5];
            for (j, value) in row.iter_mut().enumerate() {
                let product =
                    (1..4).fold(away(around[j]), |product, k| product * away(around[j + k]) * scale);
                *value = (knots[i + j + 4] - knots[i + j]) / product;
            }
            row
        };
        (0..self.knots.len()).map(jump).collect()
    }
}

fn near(controls: &[Vector], first: usize, values: [f64; 4]) -> Vector {
    controls[first..].iter().zip(values).fold(Vector::zeros(), |sum, (control, value)| sum + control * value)
}

/// Rotates a row into a triangle from its diagonal element `at` on; what is left of the right-hand side is the
/// residual (Givens). Rotations keep lengths, so least squares lose no digits to squared condition numbers as they do
/// by normal equations.
fn rotate(band: &mut Band, right: &mut [Vector], at: usize, mut row: [f64; 5], mut value: Vector) -> Vector {
    for (own, right) in band[at..].iter_mut().zip(&mut right[at..]) {
        let pivot = row[0];
        if pivot != 0.0 {
            let (large, small) =
                if pivot.abs() >= own[0] { (pivot.abs(), own[0]) } else { (own[0], pivot.abs()) };
            let norm = large * (1.0 + (small / large) * (small / large)).sqrt();
            let (cos, sin) = (own[0] / norm, pivot / norm);
            own[0] = norm;
            (value, *right) = (value * cos - *right * sin, *right * cos + value * sin);
            for (own, row) in own[1..].iter_mut().zip(&mut row[1..]) {
                (*row, *own) = (*row * cos - *own * sin, *own * cos + *row * sin);
            }
        }
        row = [row[1], row[2], row[3], row[4], 0.0];
        if row == [0.0; 5] {
            break;
        }
    }
    value
}

/// Solves an upper triangle.
fn substitute(band: &Band, right: &[Vector]) -> Vec<Vector> {
    let mut controls = right.to_vec();
    for i in (0..controls.len()).rev() {
        let mut rest = controls[i];
        for (value, known) in band[i][1..].iter().zip(&controls[i + 1..]) {
            rest -= known * *value;
        }
        controls[i] = rest / band[i][0];
    }
    controls
}

/// The zero of the rational function (u p + v) / (p + w) through three places; the high one is infinite below zero.
fn between((p1, f1): (f64, f64), (p2, f2): (f64, f64), (p3, f3): (f64, f64)) -> f64 {
    if p3 <= 0.0 {
        return (p1 * (f1 - f3) * f2 - p2 * (f2 - f3) * f1) / ((f1 - f2) * f3);
    }
    let (h1, h2, h3) = (f1 * (f2 - f3), f2 * (f3 - f1), f3 * (f1 - f2));
    -(p1 * p2 * h3 + p2 * p3 * h1 + p3 * p1 * h2) / (p1 * h1 + p2 * h2 + p3 * h3)
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;

    fn points(value: &Value) -> Vec<Point> {
        let number = |v: &Value| v.as_f64().unwrap();
        value.as_array().unwrap().iter().map(|p| Point::new(number(&p[0]), number(&p[1]))).collect()
    }

    #[test]
    fn knots_and_curves_are_scipys() {
        let text = include_str!("../../tests/data/smoothing-splines.json");
        let cases: Vec<Value> = serde_json::from_str(text).unwrap();
        for case in &cases {
            let data = points(&case["points"]);
            let spline = smoothing_spline(&data, case["smoothing"].as_f64().unwrap()).unwrap();
            let label = format!("{} {}", case["name"], case["smoothing"]);
            let Knots::Listed(knots) = &spline.knots else { panic!("uniform") };
            let inner = &knots[4..knots.len() - 4];
            let expected: Vec<f64> =
                case["knots"].as_array().unwrap().iter().map(|k| k.as_f64().unwrap()).collect();
            assert_eq!(inner.len(), expected.len(), "{label}");
            assert!(inner.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-14), "{label}: {inner:?}");
            for (u, expected) in [0.0, 0.1, 0.37, 0.5, 0.81, 1.0].into_iter().zip(points(&case["at"])) {
                let off = (spline.at(u).point - expected).norm();
                assert!(off < 1e-8, "{label} at {u}: {off:e} m off");
            }
        }
        assert_eq!(cases.len(), 19);
    }

    #[test]
    fn derivatives_are_those_of_the_curve() {
        let data: Vec<Point> = (0..30).map(|i| Point::new(f64::from(i), f64::from(i * i % 7))).collect();
        let spline = smoothing_spline(&data, 20.0).unwrap();
        for k in 1..40 {
            let (u, step) = (f64::from(k) / 40.0, 1e-6);
            let [before, here, after] = [u - step, u, u + step].map(|u| spline.at(u));
            let first = (after.point - before.point) / (2.0 * step);
            let second = (after.first - before.first) / (2.0 * step);
            assert!((first - here.first).norm() < 1e-5 * here.first.norm(), "{u}");
            assert!((second - here.second).norm() < 1e-2 * (1.0 + here.second.norm()), "{u}");
        }
    }

    #[test]
    fn the_bound_is_used_up_where_one_cubic_is_not_close_enough() {
        let data: Vec<Point> =
            (0..25).map(|i| Point::new(3.0 * f64::from(i), f64::from(i * 37 % 11))).collect();
        let at: Vec<f64> = {
            let way = |i: usize| (0..i).fold(0.0, |sum, i| sum + (data[i + 1] - data[i]).norm());
            (0..25).map(|i| way(i) / way(24)).collect()
        };
        for bound in [0.01, 1.0, 25.0, 100.0] {
            let spline = smoothing_spline(&data, bound).unwrap();
            let sum = data.iter().zip(&at).map(|(p, &u)| (spline.at(u).point - p).norm_squared());
            let sum: f64 = sum.sum();
            assert!((sum - bound).abs() <= 1.001 * TOLERANCE * bound, "{bound}: {sum}");
        }
        let far = smoothing_spline(&data, 1e6).unwrap();
        assert_eq!(far.controls.len(), 4);
    }

    #[test]
    fn impossible_data_have_no_spline() {
        let [a, b, c, d] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (3.0, 1.0)].map(|(x, y)| Point::new(x, y));
        assert!(smoothing_spline(&[a, b, c], 1.0).is_none() && smoothing_spline(&[], 1.0).is_none());
        assert!(smoothing_spline(&[a, b, b, d], 1.0).is_none());
        assert!(smoothing_spline(&[a, b, c, d], 0.0).is_none());
        assert!(smoothing_spline(&[a, b, c, d], 1.0).is_some());
    }
}
