//! From a path to states in time: speeds, rows, and the last millimetres to the goal.
//!
//! Speeds are found on cells of 2 cm by the passes v²(s + Δ) ≤ v²(s) + 2aΔ and back, below the limits of the wheel and
//! of lateral acceleration. The poses that follow differ from the path's by millimetres, since the path's integration
//! is another one. The correction is a least-norm problem: with J(t) the change of the end's pose per change of φ at
//! time t, the smallest ∫δφ² dt with ∫J·δφ dt = off is δφ = Jᵀ·(∫J·Jᵀ dt)⁻¹·off, a 3 × 3 system, repeated until the end
//! is there.

use super::path::{Link, Path, Run};
use super::round::Car;
use super::segment::{ANGLE, STEP};
use crate::geometry::{Pose, math};
use crate::referee::{MotionLimits, States};
use nalgebra::Vector3;

/// An end is off the goal when it is farther from it than this, metres and radians.
pub(super) const OFF: f64 = 5e-4;
/// Speeds are looked at this often, metres, …
const CELL: f64 = 0.02;
/// … and rows stand no farther apart, seconds.
const ROW: f64 = 0.05;
/// Shorter times and turns of the wheel are none, seconds and radians.
const NOTHING: f64 = 1e-9;
/// The referee allows a steering rate that is higher than the limit by a thousandth; so much of it is used here.
const STILL_KEPT: f64 = 1.0005;
/// No drive is slowed down by more than this.
const MOST_SLOWED: f64 = 1.5;
/// Corrections of the end.
const CORRECTIONS: usize = 10;
/// More than this is no correction of a steering angle, radians, or of a run's length, metres.
const MOST_CORRECTED: f64 = 0.02;
const MOST_STRETCHED: f64 = 0.1;
/// The end is reached when it is this near, metres and radians.
const REACHED: f64 = 1e-6;

/// Rows while they are made: time, signed speed, steering angle.
///
/// Columns of equal length; speed and angle are linear in time between rows.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// No drive may take longer, seconds; it is given up then.
    most: f64,
    t: Vec<f64>,
    speed: Vec<f64>,
    angle: Vec<f64>,
}

impl Rows {
    /// One row at standstill with the wheel at an angle.
    pub(super) fn new(most: f64, angle: f64) -> Self {
        Self { most, t: vec![0.0], speed: vec![0.0], angle: vec![angle] }
    }

    /// Adds a row `after` seconds.
    fn push(&mut self, after: f64, speed: f64, angle: f64) {
        let t = self.t.last().copied().unwrap_or(0.0);
        self.t.push(t + after);
        self.speed.push(speed + 0.0);
        self.angle.push(angle);
    }

    /// Turns the wheel at standstill.
    pub(super) fn turn(&mut self, to: f64, rate: f64) {
        let from = self.angle.last().copied().unwrap_or(0.0);
        let duration = (to - from).abs() / rate;
        if duration > NOTHING {
            let parts = (duration / ROW).ceil();
            for k in 1..=parts as u32 {
                let share = f64::from(k) / parts;
                self.push(duration / parts, 0.0, if share == 1.0 { to } else { from + (to - from) * share });
            }
        }
    }

    /// Drives the runs of a path.
    pub(super) fn along(&mut self, path: &Path, car: &Car) {
        for run in path.runs() {
            self.turn(path.nodes[run.first][ANGLE], car.max_rate);
            let cells = cells(path, run, car);
            let mut stations = vec![0.0];
            for node in &path.nodes[run.first..run.last] {
                stations.push(stations[stations.len() - 1] + node[STEP]);
            }
            self.drive(car.limits, &cells, run.gear, |s| {
                let k = stations.partition_point(|&at| at <= s).clamp(1, stations.len() - 1) - 1;
                let (from, to) = (path.nodes[run.first + k][ANGLE], path.nodes[run.first + k + 1][ANGLE]);
                let share =
                    ((s - stations[k]) / (stations[k + 1] - stations[k]).max(NOTHING)).clamp(0.0, 1.0);
                (from + (to - from) * share).clamp(-car.max_angle, car.max_angle)
            });
        }
    }

    /// Drives cells from rest to rest. `angles` tells the steering angle so many metres along.
    fn drive(&mut self, limits: &MotionLimits, cells: &[Cell], gear: f64, angle: impl Fn(f64) -> f64) {
        let speeds = speeds(limits, cells);
        let (mut s, mut i) = (0.0, 0);
        while i < cells.len() {
            // Cells of one acceleration are one piece, but for those where the wheel's rate changes.
            let rate = |i: usize| (speeds[i + 1] * speeds[i + 1] - speeds[i] * speeds[i]) / cells[i].length;
            let first = i;
            let mut length = cells[i].length;
            i += 1;
            while i < cells.len() && !cells[i].begins && (rate(i) - rate(first)).abs() < 1e-9 {
                length += cells[i].length;
                i += 1;
            }
            let (from, to) = (speeds[first], speeds[i]);
            let duration = 2.0 * length / (from + to);
            let end = self.t[self.t.len() - 1] + duration;
            if end.is_nan() || end > self.most {
                self.most = f64::NEG_INFINITY;
                return;
            }
            let parts = (duration / ROW).ceil().max(1.0);
            for k in 1..=parts as u32 {
                let share = f64::from(k) / parts;
                let speed = if share == 1.0 { to } else { from + (to - from) * share };
                let along = s + f64::midpoint(from, speed) * duration * share;
                self.push(duration / parts, gear * speed, angle(along));
            }
            s += length;
        }
    }

    /// The states from a start, the wheel's angles changed a little so that they end at the goal, which is given
    /// relative to the start's place; `None` where that is too far.
    pub(super) fn states(mut self, start: Pose, goal: Pose, car: &Car) -> Option<States> {
        let (wheelbase, max_angle) = (car.vehicle.wheelbase, car.vehicle.max_steer);
        if self.most < 0.0 {
            return None;
        }
        // Angles at the lock cannot bring every end to the goal: the runs' lengths change only where they do not
        // suffice.
        let mut stretches = false;
        for round in 0..2 * CORRECTIONS {
            let poses = self.poses(start.heading, wheelbase);
            let end = poses[poses.len() - 1];
            let off = [goal.x - end.x, goal.y - end.y, goal.heading - end.heading];
            let is_off = |least: f64| off.iter().any(|v| v.abs() >= least);
            if !is_off(if round < CORRECTIONS { REACHED } else { OFF }) {
                break;
            }
            stretches |= round == CORRECTIONS;
            if !stretches && self.correct(&poses, off, (wheelbase, max_angle), false).is_none() {
                stretches = true;
            }
            if stretches {
                self.correct(&poses, off, (wheelbase, max_angle), true)?;
            }
        }
        self.slow_down(car.limits.steering_rate_of(car.vehicle));
        Some(self.plain(start, wheelbase))
    }

    /// The states from a start, as they are.
    pub(super) fn plain(self, start: Pose, wheelbase: f64) -> States {
        let poses = self.poses(start.heading, wheelbase);
        let poses = poses.into_iter().map(|p| Pose { x: start.x + p.x, y: start.y + p.y, ..p }).collect();
        States { t: self.t, poses, speed: self.speed, steering: self.angle }
    }

    /// Poses at the rows relative to the start's place; speed and steering angle are linear between them.
    fn poses(&self, heading: f64, wheelbase: f64) -> Vec<Pose> {
        let mut pose = Pose::new(0.0, 0.0, heading);
        let mut poses = vec![pose];
        for i in 0..self.t.len() - 1 {
            let mixed = |column: &[f64]| [column[i], f64::midpoint(column[i], column[i + 1]), column[i + 1]];
            pose = moved(pose, self.t[i + 1] - self.t[i], mixed(&self.speed), mixed(&self.angle), wheelbase);
            poses.push(pose);
        }
        poses
    }

    /// Drives the same way more slowly, from one standstill to the next, where a correction has made the wheel too
    /// fast.
    fn slow_down(&mut self, rate: f64) {
        let too_fast = |i: usize| {
            let turn = (self.angle[i] - self.angle[i - 1]).abs();
            turn / (self.t[i] - self.t[i - 1]) / rate
        };
        let most = (1..self.t.len()).map(too_fast).fold(0.0, f64::max);
        if !(STILL_KEPT..MOST_SLOWED).contains(&most) {
            return;
        }
        let slowed = |(first, last): (usize, usize)| {
            let factor = (first + 1..=last).map(too_fast).fold(1.0, f64::max);
            (factor, factor)
        };
        let factors: Vec<(f64, f64)> = self.runs().into_iter().map(slowed).collect();
        self.rescale(&factors);
    }

    /// The first and the last rows between one standstill and the next.
    fn runs(&self) -> Vec<(usize, usize)> {
        let (mut runs, mut first, end) = (Vec::new(), 0, self.t.len() - 1);
        while first < end {
            let last = (first + 1..end).find(|&i| self.speed[i] == 0.0).unwrap_or(end);
            runs.push((first, last));
            first = last;
        }
        runs
    }

    /// Multiplies the times and divides the speeds from one standstill to the next.
    ///
    /// Path and angles stay; (longer, slower) above 1 lengthens the run, or slows it down.
    fn rescale(&mut self, factors: &[(f64, f64)]) {
        let mut rescaled = Self::new(self.most, self.angle[0]);
        for ((first, last), (longer, slower)) in self.runs().into_iter().zip(factors) {
            for i in first + 1..=last {
                let duration = (self.t[i] - self.t[i - 1]) * longer;
                let parts = (duration / ROW - 1e-9).ceil().max(1.0);
                for k in 1..=parts as u32 {
                    let share = f64::from(k) / parts;
                    let mixed = |column: &[f64]| column[i - 1] + (column[i] - column[i - 1]) * share;
                    rescaled.push(duration / parts, mixed(&self.speed) / slower, mixed(&self.angle));
                }
            }
        }
        *self = rescaled;
    }

    /// The least change of the steering angles, as a function of time, that moves the end by `off`; where it
    /// `stretches`, of the runs' lengths, too.
    ///
    /// `None` where the system is singular or the change is no longer small.
    fn correct(
        &mut self,
        poses: &[Pose],
        off: [f64; 3],
        (wheelbase, max_angle): (f64, f64),
        stretches: bool,
    ) -> Option<()> {
        let end = poses[poses.len() - 1];
        let n = self.t.len();
        // How the end's pose moves with the heading at a row, and that heading with the row's steering angle.
        let row = |i: usize| {
            let tan = math::tan(self.angle[i]);
            let lever = self.speed[i] * (1.0 + tan * tan) / wheelbase;
            [-lever * (end.y - poses[i].y), lever * (end.x - poses[i].x), lever]
        };
        let mut rows: Vec<Vector3<f64>> = (0..n).map(|i| row(i).into()).collect();
        let columns = if stretches { self.columns(poses, wheelbase) } else { Vec::new() };
        let factors = |rows: &[Vector3<f64>]| {
            let mut normal = nalgebra::Matrix3::<f64>::zeros();
            for (t, row) in self.t.windows(3).zip(&rows[1..]) {
                normal += row * row.transpose() * ((t[2] - t[0]) / 2.0);
            }
            for (_, column) in &columns {
                normal += column * column.transpose();
            }
            Some(normal.try_inverse()? * Vector3::from(off))
        };
        // Angles at the lock that would go beyond it stay where they are, and the others do more.
        let all = factors(&rows)?;
        for (angle, row) in self.angle.iter().zip(&mut rows) {
            if angle.abs() >= max_angle && all.dot(row) * angle.signum() > 0.0 {
                *row = Vector3::zeros();
            }
        }
        let factors = factors(&rows).unwrap_or(all);
        let turned: Vec<f64> = rows[1..n - 1].iter().map(|row| factors.dot(row)).collect();
        let stretched: Vec<(f64, f64)> =
            columns.iter().map(|(length, column)| (*length, factors.dot(column))).collect();
        let is_too_far = turned.iter().any(|by| by.abs() > MOST_CORRECTED)
            || stretched.iter().any(|(length, by)| by.abs() > MOST_STRETCHED.min(length / 2.0));
        if is_too_far {
            return None;
        }
        for (angle, by) in self.angle[1..].iter_mut().zip(turned) {
            *angle = (*angle + by).clamp(-max_angle, max_angle);
        }
        if stretches {
            // A longer run takes more time, a shorter one is driven more slowly: no limit is left.
            let factors = stretched.into_iter().map(|(length, by)| {
                let factor = 1.0 + by / length;
                if factor < 1.0 { (1.0, 1.0 / factor) } else { (factor, 1.0) }
            });
            self.rescale(&factors.collect::<Vec<_>>());
        }
        Some(())
    }

    /// The length of each run, and how the end's pose moves with it; a standstill has the least length there is.
    fn columns(&self, poses: &[Pose], wheelbase: f64) -> Vec<(f64, Vector3<f64>)> {
        let end = poses[poses.len() - 1];
        let rate = |i: usize| {
            let (speed, (sin, cos)) = (self.speed[i], math::sin_cos(poses[i].heading));
            let turn = speed * math::tan(self.angle[i]) / wheelbase;
            let (dx, dy) = (end.x - poses[i].x, end.y - poses[i].y);
            Vector3::new(speed * cos - turn * dy, speed * sin + turn * dx, turn)
        };
        let column = |(first, last): (usize, usize)| {
            let (mut length, mut sum) = (NOTHING, Vector3::zeros());
            for i in first..last {
                let half = (self.t[i + 1] - self.t[i]) / 2.0;
                length += half * (self.speed[i] + self.speed[i + 1]).abs();
                sum += (rate(i) + rate(i + 1)) * half;
            }
            (length, sum / length)
        };
        self.runs().into_iter().map(column).collect()
    }
}

/// The pose after `dt` seconds, of speeds and steering angles at the beginning, in the middle and at the end; the
/// heading is not wrapped.
pub(super) fn moved(from: Pose, dt: f64, speed: [f64; 3], angle: [f64; 3], wheelbase: f64) -> Pose {
    let turn = [0, 1, 2].map(|k| speed[k] * math::tan(angle[k]) / wheelbase);
    let half = dt * (5.0 * turn[0] + 8.0 * turn[1] - turn[2]) / 24.0;
    let full = dt * (turn[0] + 4.0 * turn[1] + turn[2]) / 6.0;
    let ways = [0.0, half, full].map(|turn| math::sin_cos(from.heading + turn));
    let mean = |a: f64, b: f64, c: f64| dt * (speed[0] * a + 4.0 * speed[1] * b + speed[2] * c) / 6.0;
    Pose::new(
        from.x + mean(ways[0].1, ways[1].1, ways[2].1),
        from.y + mean(ways[0].0, ways[1].0, ways[2].0),
        from.heading + full,
    )
}

/// A short stretch with a largest speed.
///
/// Metres; `top` is in m²/s².
#[derive(Debug, Clone, Copy)]
struct Cell {
    length: f64,
    /// Largest speed at its end, squared; in between the square is linear.
    top: f64,
    /// True if the wheel's rate changes where it begins.
    begins: bool,
}

/// The fastest speeds at the ends of cells from rest to rest, with constant acceleration in each.
fn speeds(limits: &MotionLimits, cells: &[Cell]) -> Vec<f64> {
    let n = cells.len();
    let mut square = vec![0.0; n + 1];
    for i in 0..n - 1 {
        square[i + 1] = (square[i] + 2.0 * limits.acceleration * cells[i].length).min(cells[i].top);
    }
    for i in (0..n).rev() {
        square[i] = square[i].min(square[i + 1] + 2.0 * limits.deceleration * cells[i].length);
    }
    square.into_iter().map(f64::sqrt).collect()
}

/// Divides the links of a run into cells with the largest speeds that limit, wheel and lateral acceleration allow.
fn cells(path: &Path, run: Run, car: &Car) -> Vec<Cell> {
    let lengths: Vec<f64> = path.nodes[run.first..run.last].iter().map(|n| n[STEP].max(NOTHING)).collect();
    let tops: Vec<f64> = (run.first..run.last)
        .zip(&lengths)
        .map(|(k, length)| {
            debug_assert!(path.links[k] == Link::Drive(run.gear));
            let (from, to) = (path.nodes[k][ANGLE], path.nodes[k + 1][ANGLE]);
            let speed = car.limits.speed.min(car.max_rate * length / (to - from).abs());
            let lateral = car.limits.lateral_acceleration.map_or(f64::INFINITY, |most| {
                most * car.vehicle.wheelbase / math::tan(from.abs().max(to.abs()))
            });
            (speed * speed).min(lateral)
        })
        .collect();
    let tops = between(&tops);
    let mut cells = Vec::new();
    for (length, top) in lengths.into_iter().zip(tops.windows(2)) {
        let parts = (length / CELL).ceil();
        for part in 1..=parts as u32 {
            let share = f64::from(part) / parts;
            let top = if share == 1.0 { top[1] } else { top[0] + (top[1] - top[0]) * share };
            cells.push(Cell { length: length / parts, top, begins: part == 1 });
        }
    }
    cells
}

/// Values at the ends of links, none above that of a link beside it.
fn between(links: &[f64]) -> Vec<f64> {
    let beside = |i: usize| links[i.saturating_sub(1)].min(links[i.min(links.len() - 1)]);
    (0..=links.len()).map(beside).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tops_between_links_are_nowhere_above_them() {
        let links = [4.0, 1.0, 3.0, 2.0];
        let ends = between(&links);
        assert_eq!(ends, [4.0, 1.0, 1.0, 2.0, 2.0]);
        assert!(links.iter().zip(ends.windows(2)).all(|(top, ends)| ends[0].max(ends[1]) <= *top));
    }
}
