//! A submission to the referee: a trajectory with times, or a path.
//!
//! Both kinds are checked in full before any work: lengths of columns, finite values within ±1e10, times that increase
//! strictly from 0. The same rules serve the CSV reader, which turns row and column into a place in the text.

use crate::error::{Error, ErrorCode, Message};
use crate::geometry::Pose;

/// The longest trajectory that is judged, seconds, and the most rows: time and memory grow with them.
pub(crate) const MAX_DURATION: f64 = 3600.0;
const MAX_ROWS: usize = 1_000_000;
/// No coordinate is farther out, metres, and no heading, speed or angle is larger.
const FARTHEST: f64 = 1e10;

/// Poses with times, and what else is known.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TimedRows {
    /// Seconds, strictly increasing from 0.
    pub t: Vec<f64>,
    /// Middle of the rear axle.
    pub poses: Vec<Pose>,
    /// m/s, negative in reverse.
    pub speed: Option<Vec<f64>>,
    /// Radians, positive to the left.
    pub steering: Option<Vec<f64>>,
}

/// A trajectory or a path that somebody hands in.
///
/// For a path the referee chooses the speeds, so its duration and effort are those of the referee's own follower and
/// not comparable with a trajectory's.
#[derive(Debug, Clone, PartialEq)]
pub enum Submission {
    /// Poses with times.
    Timed(TimedRows),
    /// Poses alone. The referee gives them times.
    Path {
        /// Middle of the rear axle.
        poses: Vec<Pose>,
        /// ±1 for the way on from each pose; from the poses where absent.
        gears: Option<Vec<i8>>,
    },
}

fn refused<T>(path: &str, message: Message) -> Result<T, Error> {
    Err(Error::new(ErrorCode::Input, path, message))
}

/// The first broken rule: which row, which column, what rule.
pub(super) type Broken = (usize, &'static str, Message);

impl Submission {
    /// The first value that breaks a rule.
    pub(super) fn broken(&self) -> Option<Broken> {
        let poses = match self {
            Self::Timed(rows) => &rows.poses,
            Self::Path { poses, .. } => poses,
        };
        let within = |row: usize, name: &'static str, value: f64| {
            let is_fine = value.abs() <= FARTHEST;
            (!is_fine).then(|| (row, name, message!("must be between -1e10 and 1e10, got {}", value)))
        };
        let outside = poses.iter().enumerate().find_map(|(i, p)| {
            within(i, "x", p.x).or_else(|| within(i, "y", p.y)).or_else(|| within(i, "theta", p.heading))
        });
        let Self::Timed(rows) = self else { return outside };
        let column = |name: &'static str, column: &Option<Vec<f64>>| {
            column.iter().flatten().enumerate().find_map(|(i, &v)| within(i, name, v))
        };
        let times = || {
            rows.t.iter().enumerate().find_map(|(i, &t)| {
                let before = i.checked_sub(1).map(|k| rows.t[k]);
                match before {
                    None if t != 0.0 => Some((i, "t", message!("must be 0 in the first row, got {}", t))),
                    Some(before) if t.is_nan() || t <= before => Some((
                        i,
                        "t",
                        message!("must be greater than {} in the row before, got {}", before, t),
                    )),
                    _ if t > MAX_DURATION => {
                        Some((i, "t", message!("must be at most {}, got {}", MAX_DURATION, t)))
                    }
                    _ => None,
                }
            })
        };
        outside.or_else(times).or_else(|| column("v", &rows.speed)).or_else(|| column("phi", &rows.steering))
    }

    /// Checks lengths and values.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] with the column, the row and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        let (count, lengths) = match self {
            Self::Timed(rows) => {
                let n = |column: &Option<Vec<f64>>| column.as_ref().map_or(rows.poses.len(), Vec::len);
                (
                    rows.poses.len(),
                    vec![("t", rows.t.len()), ("v", n(&rows.speed)), ("phi", n(&rows.steering))],
                )
            }
            Self::Path { poses, gears } => {
                (poses.len(), vec![("gear", gears.as_ref().map_or(poses.len(), Vec::len))])
            }
        };
        if !(2..=MAX_ROWS).contains(&count) {
            return refused("", message!("must have 2 to {} rows, got {}", MAX_ROWS, count));
        }
        if let Some((name, length)) = lengths.into_iter().find(|(_, length)| *length != count) {
            return refused(name, message!("must be one per pose ({}), got {}", count, length));
        }
        if let Self::Path { gears: Some(gears), .. } = self
            && let Some(i) = gears.iter().position(|g| g.abs() != 1)
        {
            return refused(&format!("gear[{i}]"), message!("must be 1 or -1, got {}", gears[i]));
        }
        match self.broken() {
            Some((row, name, rule)) => refused(&format!("{name}[{row}]"), rule),
            None => Ok(()),
        }
    }
}
