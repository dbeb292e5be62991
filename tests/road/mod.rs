//! Roads: the search and its chords, curves, plans, drives and drawn roads.

mod curves;
mod driving;
mod lanes;
mod plans;
mod random_roads;
mod road_obstacle;
mod search;

use parkade::geometry::{Point, Pose};
use parkade::map::{Cell, Frame};
use parkade::plan::{Options, Plan, Planner};
use parkade::planners::Outcome;
use parkade::planners::cost_map::{
    Config, CostMap, Query, Report, RoadRasters, Scratch, Traffic, kerb_distances, plan,
};
use parkade::scenario::{Scenario, catalog};
use parkade::search::Observers;
use serde_json::json;

pub(crate) const IDS: [&str; 4] = ["road-straight", "road-curve", "road-crossing", "road-narrow"];

pub(crate) struct Scene {
    pub(crate) scenario: Scenario,
    pub(crate) ground: RoadRasters,
    pub(crate) kerb: Vec<f32>,
    pub(crate) start: Point,
    pub(crate) goal: Point,
}

impl Scene {
    pub(crate) fn new(id: &str) -> Self {
        Self::of(catalog::scenario(id).unwrap())
    }

    pub(crate) fn of(scenario: Scenario) -> Self {
        let geometry = scenario.geometry().unwrap();
        let map = &scenario.map;
        let [x, y] = map.origin;
        let frame = Frame {
            origin: Point::new(x, y),
            width: map.width,
            height: map.height,
            resolution: map.resolution,
        };
        let car = geometry.vehicle;
        let middle = |pose: Pose| pose.advance(0.0, (car.rear_to_front - car.rear_to_back) / 2.0).point();
        let (start, goal) = (middle(geometry.start), middle(geometry.goal));
        let kerb = kerb_distances(&frame, &geometry, true);
        Self { ground: RoadRasters::new(frame, &geometry, true), kerb, scenario, start, goal }
    }

    pub(crate) fn plan(&self, config: &Config) -> Report {
        config.validate().unwrap();
        let traffic =
            Traffic { lanes: self.scenario.lanes.clone(), limits: self.scenario.speed_limits.clone() };
        let costs = CostMap::new(&self.ground, &self.kerb, &traffic, 0.95, config);
        let query = Query {
            ground: &self.ground,
            costs: &costs,
            radius: 0.95,
            start: self.start,
            goal: self.goal,
            less: false,
        };
        plan(&query, config, &mut Scratch::default(), &mut Observers::default())
    }
}

pub(crate) fn length(cells: &[Cell]) -> f64 {
    let leg = |a: Cell, b: Cell| {
        let (dx, dy) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
        (dx * dx + dy * dy).sqrt()
    };
    cells.windows(2).map(|w| leg(w[0], w[1])).sum::<f64>() / 2.0
}

/// Neighbouring cells with room, no corner cut, from start to goal.
pub(crate) fn sound(scene: &Scene, report: &Report) {
    let ground = &scene.ground;
    assert_eq!(report.outcome, Outcome::Found);
    let room = |cell: Cell| ground.at(cell) >= 0.95;
    for pair in report.cells.windows(2) {
        let (dx, dy) = (pair[1].x - pair[0].x, pair[1].y - pair[0].y);
        assert!(dx.abs().max(dy.abs()) == 1 && room(pair[1]));
        assert!(room(pair[0].offset(dx, 0)) && room(pair[0].offset(0, dy)));
    }
    for line in [&report.cells, &report.pruned] {
        assert_eq!(line.first().copied(), ground.frame.cell_at(scene.start));
        assert_eq!(line.last().copied(), ground.frame.cell_at(scene.goal));
    }
}

pub(crate) fn planned(id: &str, settings: &serde_json::Value) -> Plan {
    let scene = catalog::scenario(id).unwrap();
    Planner::new("cost-map", &scene, settings.as_object().unwrap()).unwrap().plan(Options::default())
}

/// Plain A*: the shortest cells, as they are.
pub(crate) fn plain() -> serde_json::Value {
    json!({ "costs": "steps", "pruning": "none", "smoothing": "none" })
}
