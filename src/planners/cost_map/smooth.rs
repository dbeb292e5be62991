//! From chords to a curve: a penalised spline, drawn closer to the chords where it comes too near to something.
//!
//! The first curve is as smooth as a root mean square distance σ from the chords allows. It is then measured with the
//! car: where the car would come nearer to something than on the chords, points there weigh more and σ falls; where it
//! would have to turn too tightly, points near the sharp place count less and σ grows. Both loops have a limit. If no
//! curve passes, the chords themselves are the answer, and the plan says so.
//!
//! The spline minimises
//!
//! ```text
//! Σ wⱼ·|C(uⱼ) − pⱼ|² + λ·Σ |Δ³Pᵢ|²
//! ```
//!
//! over cubic splines C with control points Pᵢ, for points pⱼ on the chords ([`Spline`]). λ is found by bisection so
//! that the root mean square distance is σ; so σ, a length that can be pictured, is the setting, and λ is not.

use std::ops::Range;

use super::RoadRasters;
use crate::geometry::bspline::{CurvePoint, Rows, Spline};
use crate::geometry::smoothing_spline::smoothing_spline;
use crate::geometry::{Point, Vector};
use crate::map::Cell;

/// Points of the chords are this far apart at most, metres.
const DATA: f64 = 1.0;
/// Control points are this far apart; closer where that does not do, metres.
const SPACINGS: [f64; 2] = [5.0, 2.5];
/// Rounds of drawing closer.
const ROUNDS: u32 = 8;
/// A firm point counts as much as so many others.
const FIRM: f64 = 10.0;
/// A curve with less clearance than this is none, metres.
const LEAST: f64 = 0.05;

/// How to smooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Smoothing {
    /// Root mean square distance from the chords that is used up, metres.
    pub sigma: f64,
    /// Places of the curve, at least; two a metre on long ways.
    pub places: u32,
    /// Largest curvature, 1/m.
    pub max_curvature: f64,
    /// Half the car's width, metres.
    pub radius: f64,
    /// Room beside the body of which the curve keeps as much as the line has, metres.
    pub margin: f64,
    /// How many times as large as a car; its points are that much farther apart.
    pub scale: f64,
    /// True if the line is smooth already, so that control points shall be close from the beginning.
    pub close: bool,
    /// Unit vectors in which the curve begins and ends, where that is asked.
    pub ways: [Option<Vector>; 2],
}

/// A curve, or the chords where none was good enough.
#[derive(Debug, Clone)]
pub struct Smooth {
    /// Points from start to goal.
    pub points: Vec<Point>,
    /// Signed curvature at each point, 1/m; empty for chords.
    pub curvatures: Vec<f64>,
    /// The curve itself.
    pub spline: Option<Spline>,
    /// Smallest clearance beside the body by the raster, metres.
    pub clearance: f64,
    /// True if these are the chords.
    pub fell_back: bool,
}

/// Smooths a polyline; `accept` has the last word on a curve. The line's `firm` points, none where it is shorter, are
/// passed more closely than the others.
/// Points are world metres. The result begins and ends where the line does; without a good curve it is the line
/// itself with [`Smooth::fell_back`] set, which is an answer and not an error.
pub fn smooth(
    ground: &RoadRasters,
    line: &[Point],
    firm: &[bool],
    how: &Smoothing,
    accept: impl Fn(&Spline) -> bool,
) -> Smooth {
    let fit = Fit::new(ground, line, how);
    let places = f64::from(fit.places);
    let is_straight = line.len() < 3 && how.ways == [None; 2];
    if is_straight || fit.length < SPACINGS[0] * how.scale {
        let points = dense(line, fit.length / places.max(1.0));
        return Smooth {
            curvatures: vec![0.0; points.len()],
            fell_back: line.len() > 2,
            ..fit.chords(points)
        };
    }
    let weights = firmness(line, firm, DATA * how.scale);
    let mut spacings = SPACINGS.into_iter().skip(usize::from(how.close));
    let curve = spacings.find_map(|spacing| fit.finished(fit.drawn_closer(spacing, &weights)?, &accept));
    let curve = curve.or_else(|| fit.turned_wider(weights, &accept));
    curve.unwrap_or_else(|| fit.chords(dense(line, fit.length / places)))
}

/// Points of the line to which splines are fitted.
struct Fit<'a> {
    ground: &'a RoadRasters,
    how: &'a Smoothing,
    points: Vec<Point>,
    /// Length of the line, metres.
    length: f64,
    /// Places at which a curve is measured.
    places: u32,
}

impl<'a> Fit<'a> {
    fn new(ground: &'a RoadRasters, line: &[Point], how: &'a Smoothing) -> Self {
        let points = dense(line, DATA * how.scale);
        let length = points.windows(2).fold(0.0, |sum, w| sum + (w[1] - w[0]).norm());
        let places = (f64::from(how.places)).max((length * 2.0 / how.scale).ceil()).max(1.0) as u32;
        Self { ground, how, points, length, places }
    }

    /// Clearance beside the body whose middle is at a point, metres.
    fn room(&self, p: Point) -> f64 {
        bilinear(self.ground, p) - self.how.radius
    }

    /// The least clearance at some points, metres.
    fn clearance(&self, points: &[Point]) -> f64 {
        points.iter().fold(f64::INFINITY, |least, &p| least.min(self.room(p)))
    }

    /// The answer without a curve.
    fn chords(&self, points: Vec<Point>) -> Smooth {
        let clearance = self.clearance(&points);
        Smooth { points, curvatures: Vec::new(), spline: None, clearance, fell_back: true }
    }

    /// The points' stations as shares of the length.
    fn stations(&self) -> Vec<f64> {
        let mut at = vec![0.0];
        for pair in self.points.windows(2) {
            at.push(at[at.len() - 1] + (pair[1] - pair[0]).norm() / self.length);
        }
        at
    }

    /// The spline's equations, with control points this far apart, metres.
    fn rows(&self, at: &[f64], spacing: f64) -> Rows {
        Rows::new(at, ((self.length / (spacing * self.how.scale)).ceil() as usize + 3).max(6))
    }

    fn spline(&self, rows: &Rows, weights: &[f64], sigma: f64) -> Spline {
        let slopes = self.how.ways.map(|way| way.map(|way| way * self.length));
        Spline::fit(&self.points, rows, weights, sigma, slopes)
    }

    /// Point i with so many of its neighbours on each side.
    fn around(&self, i: usize, by: usize) -> Range<usize> {
        i.saturating_sub(by)..(i + by + 1).min(self.points.len())
    }

    /// The curve, if it has room and its turns are wide enough.
    fn finished(&self, spline: Spline, accept: &impl Fn(&Spline) -> bool) -> Option<Smooth> {
        let share = |k: u32| f64::from(k) / f64::from(self.places);
        let curve: Vec<CurvePoint> = (0..=self.places).map(|k| spline.at(share(k))).collect();
        let points: Vec<Point> = curve.iter().map(|p| p.point).collect();
        let curvatures: Vec<f64> = curve.iter().map(CurvePoint::curvature).collect();
        let clearance = self.clearance(&points);
        let bends = curvatures.iter().all(|k| k.abs() <= self.how.max_curvature);
        let is_good = clearance >= LEAST && bends && accept(&spline);
        is_good.then_some(Smooth { points, curvatures, spline: Some(spline), clearance, fell_back: false })
    }

    /// Of some splines, each nearer to the points where the one before lacks room, that which lacks least.
    fn drawn_closer(&self, spacing: f64, weights: &[f64]) -> Option<Spline> {
        let target = |p: Point| (self.room(p).min(self.how.margin.max(0.8)) - 0.02).max(0.25);
        let targets: Vec<f64> = self.points.iter().map(|&p| target(p)).collect();
        let rows = self.rows(&self.stations(), spacing);
        let (mut weights, mut sigma) = (weights.to_vec(), self.how.sigma);
        let mut best: Option<(f64, Spline)> = None;
        for _ in 0..ROUNDS {
            let spline = self.spline(&rows, &weights, sigma);
            let rooms: Vec<f64> = spline.points(&rows).map(|p| self.room(p)).collect();
            let over = rooms.iter().zip(&targets).map(|(room, target)| room - target);
            let worst = over.fold(f64::INFINITY, f64::min);
            if best.as_ref().is_none_or(|b| worst > b.0) {
                best = Some((worst, spline));
            }
            if worst >= 0.0 {
                break;
            }
            for near in (0..rooms.len()).filter(|&i| rooms[i] < targets[i]) {
                for weight in &mut weights[self.around(near, 3)] {
                    *weight = (*weight * 4.0).min(1e4);
                }
            }
            sigma *= 0.7;
        }
        best.map(|(_, spline)| spline)
    }

    /// Chords can turn where no car does. The points near such corners count less, until the curve is wide enough.
    fn turned_wider(&self, mut weights: Vec<f64>, accept: &impl Fn(&Spline) -> bool) -> Option<Smooth> {
        let at = self.stations();
        let rows = self.rows(&at, SPACINGS[0]);
        let limit = self.how.max_curvature;
        let reach = (0.5 / (limit * DATA * self.how.scale)).ceil() as usize;
        let mut sigma = self.how.sigma;
        for _ in 0..2 * ROUNDS {
            let spline = self.spline(&rows, &weights, sigma);
            let met: Vec<CurvePoint> = at.iter().map(|&u| spline.at(u)).collect();
            let mut factors = vec![1.0; met.len()];
            for i in (0..met.len()).filter(|&i| met[i].curvature().abs() > 0.95 * limit) {
                factors[self.around(i, reach)].fill(0.25);
            }
            let is_tight = factors.contains(&0.25);
            for i in (0..met.len()).filter(|&i| self.room(met[i].point) < LEAST) {
                factors[self.around(i, 3)].fill(4.0);
            }
            if let Some(curve) = self.finished(spline, accept) {
                return Some(curve);
            }
            for (weight, factor) in weights.iter_mut().zip(factors) {
                *weight = (*weight * factor).clamp(1e-4, 1e4);
            }
            sigma *= if is_tight { 1.3 } else { 0.7 };
        }
        None
    }
}

/// The manuscript's smoothing, `splprep` with as many square metres as there are points: a root mean square distance of
/// a metre. Lines of fewer than four points, for which it fails, get more half-way. `None` for fewer than two.
pub fn paper_spline(line: &[Point]) -> Option<Spline> {
    let mut points = line.to_vec();
    while points.len() < 4 {
        let gap = |i: &usize| -((points[i + 1] - points[*i]).norm());
        let widest = (0..points.len().checked_sub(1)?).min_by(|a, b| gap(a).total_cmp(&gap(b)))?;
        points.insert(widest + 1, nalgebra::center(&points[widest], &points[widest + 1]));
    }
    smoothing_spline(&points, points.len() as f64)
}

/// The same line with points at most `step` metres apart, its own kept.
pub fn dense(line: &[Point], step: f64) -> Vec<Point> {
    let mut points = Vec::new();
    for pair in line.windows(2) {
        let way = pair[1] - pair[0];
        let parts = parts(way, step);
        points.extend((0..parts as u32).map(|k| pair[0] + way * (f64::from(k) / parts)));
    }
    points.extend(line.last());
    points
}

/// How many pieces at most `step` metres long a way is divided into.
fn parts(way: Vector, step: f64) -> f64 {
    (way.norm() / step - 1e-9).ceil().max(1.0)
}

/// The weight of each point of the dense line: large between firm points.
fn firmness(line: &[Point], firm: &[bool], step: f64) -> Vec<f64> {
    let is_firm = |i: usize| firm.get(i).copied().unwrap_or(false);
    let weight = |is_firm: bool| if is_firm { FIRM } else { 1.0 };
    let mut weights = Vec::new();
    for (i, pair) in line.windows(2).enumerate() {
        weights.push(weight(is_firm(i)));
        let between = weight(is_firm(i) && is_firm(i + 1));
        weights.extend((1..parts(pair[1] - pair[0], step) as u32).map(|_| between));
    }
    weights.push(weight(is_firm(line.len().saturating_sub(1))));
    weights
}

/// The clearance between cell centres, metres; at the map's edge that of the outermost centres.
pub(super) fn bilinear(ground: &RoadRasters, point: Point) -> f64 {
    let [x, y] = ground.frame.lattice(point).map(|v| v - 0.5);
    let (w, h) = (f64::from(ground.frame.width - 1), f64::from(ground.frame.height - 1));
    let (x, y) = (x.clamp(0.0, w), y.clamp(0.0, h));
    let (x0, y0) = (x.floor(), y.floor());
    let (fx, fy) = (x - x0, y - y0);
    let below = ground.frame.index(Cell::new(x0 as i32, y0 as i32));
    let above = if y0 < h { below + ground.frame.width as usize } else { below };
    let next = usize::from(x0 < w);
    let at = |index: usize| f64::from(ground.clearance[index]);
    (at(below) * (1.0 - fx) + at(below + next) * fx) * (1.0 - fy)
        + (at(above) * (1.0 - fx) + at(above + next) * fx) * fy
}
