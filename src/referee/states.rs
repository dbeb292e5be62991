//! A trajectory as columns.
//!
//! Columns instead of rows of records: the JS API hands each out as one typed array, and figures read one or two of
//! them only. All columns have the same length, which is an invariant of whoever fills them; [`States::push`] keeps it.

use crate::geometry::{Pose, math};

/// Columns of equal length, one item per moment. Speed and steering angle are linear in time between two moments, so
/// that the controls (acceleration and steering rate) are constant there.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct States {
    /// Seconds, strictly increasing from 0.
    pub t: Vec<f64>,
    /// Middle of the rear axle; headings are unwrapped: they do not jump by 2π.
    pub poses: Vec<Pose>,
    /// m/s, negative in reverse.
    pub speed: Vec<f64>,
    /// Angle of the middle front wheel, radians, positive to the left.
    pub steering: Vec<f64>,
}

impl States {
    /// Adds a moment.
    pub fn push(&mut self, t: f64, pose: Pose, speed: f64, steering: f64) {
        self.t.push(t);
        self.poses.push(pose);
        self.speed.push(speed);
        self.steering.push(steering);
    }

    /// The last moment, seconds.
    pub fn duration(&self) -> f64 {
        self.t.last().copied().unwrap_or(0.0)
    }

    /// Acceleration (m/s²) and steering rate (rad/s) from each moment to the next; 0 from the last.
    ///
    /// # Examples
    /// ```
    /// use parkade::geometry::Pose;
    /// use parkade::referee::States;
    ///
    /// let mut states = States::default();
    /// states.push(0.0, Pose::new(0.0, 0.0, 0.0), 0.0, 0.0);
    /// states.push(2.0, Pose::new(1.0, 0.0, 0.0), 1.0, 0.0);
    /// assert_eq!(states.controls().0, [0.5, 0.0]);
    /// assert_eq!((states.duration(), states.stations()), (2.0, vec![0.0, 1.0]));
    /// ```
    pub fn controls(&self) -> (Vec<f64>, Vec<f64>) {
        let slopes = |column: &[f64]| {
            let steps = self.t.windows(2).zip(column.windows(2));
            steps.map(|(t, c)| (c[1] - c[0]) / (t[1] - t[0])).chain([0.0]).take(column.len()).collect()
        };
        (slopes(&self.speed), slopes(&self.steering))
    }

    /// Distance driven up to each moment, metres.
    pub fn stations(&self) -> Vec<f64> {
        let mut stations = vec![0.0];
        for (t, v) in self.t.windows(2).zip(self.speed.windows(2)) {
            // Gears change at rest: between two rows the speed has one sign.
            let driven = (t[1] - t[0]) * (v[0].abs() + v[1].abs()) / 2.0;
            stations.push(stations[stations.len() - 1] + driven);
        }
        stations
    }

    /// Time at standstill, seconds.
    pub fn dwell(&self) -> f64 {
        let steps = self.t.windows(2).zip(self.speed.windows(2));
        steps.fold(0.0, |sum, (t, v)| if v[0] == 0.0 && v[1] == 0.0 { sum + t[1] - t[0] } else { sum })
    }

    /// FNV-1a-64 over all columns, as 16 hex digits: equal on every platform.
    pub fn hash(&self) -> String {
        let poses = self.poses.iter().flat_map(|p| [p.x, p.y, p.heading]);
        crate::drive::hash(poses.chain([&self.t, &self.speed, &self.steering].into_iter().flatten().copied()))
    }
}

/// The same poses with headings that do not jump.
pub(super) fn unwrapped(poses: &[Pose]) -> Vec<Pose> {
    let mut heading = poses.first().map_or(0.0, |p| p.heading);
    let turned = poses.iter().map(|p| {
        heading += math::turn(heading, p.heading);
        Pose { heading, ..*p }
    });
    turned.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn controls_are_slopes_and_headings_unwrap() {
        let mut states = States::default();
        states.push(0.0, Pose::new(0.0, 0.0, 3.0), 0.0, 0.0);
        states.push(0.5, Pose::new(0.0, 0.0, -3.0), 1.0, -0.1);
        states.push(1.0, Pose::new(0.0, 0.0, -3.0), 1.0, 0.0);
        let (acceleration, rate) = states.controls();
        assert_eq!((acceleration, rate), (vec![2.0, 0.0, 0.0], vec![-0.2, 0.2, 0.0]));
        assert_eq!(states.duration(), 1.0);
        let turned = unwrapped(&states.poses);
        assert!((turned[1].heading - (math::TAU - 3.0)).abs() < 1e-12);
        assert_eq!(States::default().controls(), (vec![], vec![]));
    }
}
