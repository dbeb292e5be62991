//! The place that blocks the way when there is no path, for drawing.

use crate::geometry::{Point, Pose};

/// The obstruction between the car and its goal, in world coordinates. Owner k > 0 is shape k - 1 of the scene's
/// geometry, owner 0 its border.
#[derive(Debug, Clone, PartialEq)]
pub enum Obstruction {
    /// The body overlaps an obstacle at the start or at the goal.
    Contact {
        /// True at the start, false at the goal.
        at_start: bool,
        /// The obstacle that the body overlaps.
        owner: u32,
    },
    /// The narrowest place of the widest way.
    Gap(Gap),
    /// No way joins start and goal.
    Enclosed {
        /// True if the region is the start's, else the goal's: the smaller of the two.
        at_start: bool,
        /// The cells that the centre of a disc as wide as the car can reach.
        region: Region,
    },
    /// The car can hardly move.
    BoxedIn {
        /// True at the start, false at the goal.
        at_start: bool,
        /// The ends of its motions straight and at full lock, ahead and back, each with the obstacle that stops it.
        stops: Vec<(Pose, u32)>,
    },
    /// Of what was searched, the place with the least estimate to go.
    Nearest {
        /// The rear axle's middle, or a cell's.
        at: Point,
        /// The car's, where the planner knows one.
        heading: Option<f64>,
    },
}

/// A place that is too narrow for the car.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// The widest way from start to goal is about this wide at its narrowest, metres.
    pub width: f64,
    /// Position of the gap, metres.
    pub at: Point,
}

/// Squares in rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Side of a square, metres.
    pub cell: f64,
    /// Lower left corner and number of squares of each run eastward.
    pub runs: Vec<(Point, u32)>,
}
