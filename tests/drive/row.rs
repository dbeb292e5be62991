//! The parking paper's rows, planned once, and boxes that cross them.

use std::cell::OnceCell;

use parkade::drive::{Encounter, Limits, Mover, Route, Trajectory, WaitOptions, stop_wait_go, trajectory};
use parkade::geometry::Pose;
use parkade::plan::{Options, Planner};
use parkade::scenario::catalog;
use parkade::scenario::resolve::Geometry;
use parkade::vehicle::Vehicle;
use serde_json::Map;

use crate::outlines::overlap;

pub(crate) const CAR: Vehicle = Vehicle::PAPER;
pub(crate) const ROWS: [&str; 10] = ["P0", "P1", "P2", "P3", "P4", "L0", "L1", "L2", "L3", "L4"];

pub(crate) struct Row {
    pub(crate) id: &'static str,
    pub(crate) route: Route,
    pub(crate) geometry: Geometry,
    pub(crate) goal: Pose,
}

thread_local! {
    static PLANNED: OnceCell<Vec<Row>> = const { OnceCell::new() };
}

/// Hybrid A*'s path in a scene.
pub(crate) fn row(id: &'static str) -> Row {
    let scene = catalog::scenario(id).unwrap();
    let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
    let plan = planner.plan(Options::default());
    let geometry = planner.geometry().clone();
    let route = Route::new(&CAR, &plan.path, &plan.directions, Some(&plan.curvatures)).unwrap();
    assert!((route.length() - plan.metrics.length).abs() < 1e-6, "{id}");
    Row { id, route, goal: geometry.goal, geometry }
}

pub(crate) fn rows(each: impl Fn(&Row)) {
    PLANNED.with(|rows| rows.get_or_init(|| ROWS.map(row).into()).iter().for_each(each));
}

pub(crate) fn drive(row: &Row, limits: &Limits) -> Trajectory {
    trajectory(&CAR, &row.route, limits).unwrap()
}

pub(crate) fn crossing(id: &'static str) -> (Row, Vec<Mover>) {
    let movers = catalog::scenario(id).unwrap().moving.iter().map(Mover::new).collect();
    (row(id), movers)
}

pub(crate) fn meet(row: &Row, movers: &[Mover], options: &WaitOptions) -> Encounter {
    let met = stop_wait_go(&CAR, &row.route, movers, options).unwrap();
    let n = met.rows.t.len();
    assert!(met.clearances.len() == n && met.rows.t.windows(2).all(|t| t[0] < t[1]));
    // The body against the boxes, by separating axes over corners, at every row.
    for k in 0..n {
        let touched = movers.iter().any(|m| {
            overlap(
                &CAR.outline(met.rows.poses[k]).map(|p| [p.x, p.y]),
                &m.outline(met.rows.t[k]).map(|p| [p.x, p.y]),
            )
        });
        assert_eq!(touched, met.clearances[k] == 0.0, "{} at {}", row.id, met.rows.t[k]);
        assert!(!touched || met.contact.is_some_and(|c| c.t <= met.rows.t[k]), "{}", row.id);
    }
    met
}
