//! From a path to states in time: speeds, rows, and the last millimetres to the goal.

use super::path::{Link, Path, Run};
use super::round::Car;
use super::segment::{ANGLE, STEP};
use crate::geometry::{Pose, math};
use crate::referee::{MotionLimits, States};

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
/// More than this is no correction of a steering angle, radians.
const MOST_CORRECTED: f64 = 0.02;
/// The end is reached when it is this near, metres and radians.
const REACHED: f64 = 1e-6;

/// Rows while they are made: time, signed speed, steering angle.
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
        for _ in 0..CORRECTIONS {
            let poses = self.poses(start.heading, wheelbase);
            let end = poses[poses.len() - 1];
            let off = [goal.x - end.x, goal.y - end.y, goal.heading - end.heading];
            if off.iter().all(|v| v.abs() < REACHED) {
                break;
            }
            self.correct(&poses, off, wheelbase, max_angle)?;
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

    /// Drives the same way more slowly, from one standstill to the next, where a correction has made the wheel too fast.
    fn slow_down(&mut self, rate: f64) {
        let too_fast = |i: usize| {
            let turn = (self.angle[i] - self.angle[i - 1]).abs();
            turn / (self.t[i] - self.t[i - 1]) / rate
        };
        let most = (1..self.t.len()).map(too_fast).fold(0.0, f64::max);
        if !(STILL_KEPT..MOST_SLOWED).contains(&most) {
            return;
        }
        let mut slowed = Self::new(self.most, self.angle[0]);
        let mut first = 0;
        while first + 1 < self.t.len() {
            let last = (first + 1..self.t.len() - 1).find(|&i| self.speed[i] == 0.0);
            let last = last.unwrap_or(self.t.len() - 1);
            let factor = (first + 1..=last).map(too_fast).fold(1.0, f64::max);
            for i in first + 1..=last {
                let duration = (self.t[i] - self.t[i - 1]) * factor;
                let parts = (duration / ROW - 1e-9).ceil().max(1.0);
                for k in 1..=parts as u32 {
                    let share = f64::from(k) / parts;
                    let mixed = |column: &[f64]| column[i - 1] + (column[i] - column[i - 1]) * share;
                    slowed.push(duration / parts, mixed(&self.speed) / factor, mixed(&self.angle));
                }
            }
            first = last;
        }
        *self = slowed;
    }

    /// The least change of the steering angles, as a function of time, that moves the end by `off`.
    fn correct(&mut self, poses: &[Pose], off: [f64; 3], wheelbase: f64, max_angle: f64) -> Option<()> {
        let end = poses[poses.len() - 1];
        let n = self.t.len();
        // How the end's pose moves with the heading at a row, and that heading with the row's steering angle.
        let row = |i: usize| {
            let tan = math::tan(self.angle[i]);
            let lever = self.speed[i] * (1.0 + tan * tan) / wheelbase;
            [-lever * (end.y - poses[i].y), lever * (end.x - poses[i].x), lever]
        };
        let mut rows: Vec<nalgebra::Vector3<f64>> = (0..n).map(|i| row(i).into()).collect();
        let factors = |rows: &[nalgebra::Vector3<f64>]| {
            let mut normal = nalgebra::Matrix3::<f64>::zeros();
            for (t, row) in self.t.windows(3).zip(&rows[1..]) {
                normal += row * row.transpose() * ((t[2] - t[0]) / 2.0);
            }
            Some(normal.try_inverse()? * nalgebra::Vector3::from(off))
        };
        // Angles at the lock that would go beyond it stay where they are, and the others do more.
        let all = factors(&rows)?;
        for (angle, row) in self.angle.iter().zip(&mut rows) {
            if angle.abs() >= max_angle && all.dot(row) * angle.signum() > 0.0 {
                *row = nalgebra::Vector3::zeros();
            }
        }
        let factors = factors(&rows).unwrap_or(all);
        for (angle, row) in self.angle[1..n - 1].iter_mut().zip(&rows[1..]) {
            let by = factors.dot(row);
            if by.abs() > MOST_CORRECTED {
                return None;
            }
            *angle = (*angle + by).clamp(-max_angle, max_angle);
        }
        Some(())
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
