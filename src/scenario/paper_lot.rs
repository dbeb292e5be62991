//! The parking paper's lot, and the rows of its tables.
//!
//! The paper draws one lot for all rows: an aisle above y = 5 m, and below it a bay whose width and depth decide how
//! tight it is. Rows `P0` to `P4` park at right angles, rows `L0` to `L4` along the aisle. Poses are those of the
//! tables: the rear axle's middle, metres and radians.
//!
//! The lot is a boundary without obstacles, so the edge of the bay is exact and not a row of cells.

use std::collections::BTreeMap;

use super::{MapFrame, Scenario, VehicleSpec};
use crate::geometry::Pose;
use crate::geometry::math::{FRAC_PI_2, PI};

/// Start and goal of each row of the parking paper.
pub(super) const PAPER_ROWS: [(&str, [f64; 3], [f64; 3]); 10] = [
    ("P0", [22.0, 8.19, PI], [2.5, 5.0, -FRAC_PI_2]),
    ("P1", [24.0, 8.4, PI], [2.5, 5.0, -FRAC_PI_2]),
    ("P2", [-20.0, 14.5, PI], [-7.0, 5.0, -FRAC_PI_2]),
    ("P3", [16.0, 18.0, PI], [-2.0, 5.0, -FRAC_PI_2]),
    ("P4", [-16.0, 7.5, PI], [7.0, 5.0, -FRAC_PI_2]),
    ("L0", [20.0, 19.06, PI], [-3.0, 2.0, PI]),
    ("L1", [18.0, 15.7, PI], [-3.0, 2.0, PI]),
    ("L2", [16.0, 14.7, PI], [2.0, 2.0, PI]),
    ("L3", [19.0, 15.5, PI], [-4.0, 3.0, PI]),
    ("L4", [-8.0, 14.2, PI], [7.0, 3.0, PI]),
];

/// The scene of a row of the tables; `None` for other ids.
pub(super) fn paper_row(id: &str) -> Option<Scenario> {
    let &(_, start, goal) = PAPER_ROWS.iter().find(|row| row.0 == id)?;
    Some(lot(-10.0, 10.0, 5.0, start, goal))
}

/// The parking paper's lot: 50 m × 25 m above y = 5, with a bay `x0..x1` of some depth below it.
pub(super) fn lot(x0: f64, x1: f64, depth: f64, start: [f64; 3], goal: [f64; 3]) -> Scenario {
    let floor = 5.0 - depth;
    let low = floor.min(0.0);
    let boundary = [
        [-25.0, 5.0],
        [x0, 5.0],
        [x0, floor],
        [x1, floor],
        [x1, 5.0],
        [25.0, 5.0],
        [25.0, 30.0],
        [-25.0, 30.0],
    ];
    let map = MapFrame {
        origin: [-25.0, low],
        width: 200,
        height: ((30.0 - low) * 4.0) as u32,
        resolution: 0.25,
        boundary: Some(boundary.to_vec()),
    };
    let pose = |[x, y, heading]: [f64; 3]| Pose::new(x, y, heading);
    // The improved planner keeps the paper's necessary safety space, and arcs that this car can drive.
    let risk = serde_json::json!({ "inflation": "width", "minRadius": "vehicle" });
    let mut planners = BTreeMap::new();
    planners.insert("risk-field".to_owned(), risk.as_object().cloned().unwrap_or_default());
    Scenario { planners, ..Scenario::new(map, VehicleSpec::default(), pose(start), pose(goal)) }
}

/// A bay of this width in which the car shall stand with its tail to the wall.
pub(super) fn tail_in(width: f64) -> Scenario {
    lot(0.0, width, 6.0, [16.0, 9.0, PI], [width / 2.0, 0.4, FRAC_PI_2])
}

/// The same bay, entered nose first; the rear axle then stands near the mouth.
pub(super) fn nose_in(width: f64) -> Scenario {
    lot(0.0, width, 6.0, [16.0, 9.0, PI], [width / 2.0, 3.9, -FRAC_PI_2])
}
