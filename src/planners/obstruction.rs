//! Where it fails when there is no path, for drawing.

use crate::geometry::{Point, Pose};

/// What keeps the car from its goal, and where; in world coordinates. An owner k > 0 is shape k - 1 of the scene's
/// geometry, 0 its border.
#[derive(Debug, Clone, PartialEq)]
pub enum Obstruction {
    /// The body overlaps something where it starts or shall arrive.
    Contact {
        /// Where it starts, else where it arrives.
        at_start: bool,
        /// What it overlaps.
        owner: u32,
    },
    /// The narrowest place of the widest way.
    Gap(Gap),
    /// No way joins start and goal.
    Enclosed {
        /// Whether the region is the start's, else the goal's: the smaller of the two.
        at_start: bool,
        /// Where a disc as wide as the car can be, by its centre.
        region: Region,
    },
    /// The car can hardly move.
    BoxedIn {
        /// Where it starts, else where it arrives.
        at_start: bool,
        /// How far it gets straight and at full lock, ahead and back, and what stops it there.
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
    /// Where that is, metres.
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
