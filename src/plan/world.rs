//! A scene as the planners need it: exact for the car, rasters for the grid.
//!
//! Hybrid planners and the check test the body against exact outlines; grid planners see cells. Both views are made
//! here, from one validated scene, so they cannot disagree about what is in it. A filled outline blocks each cell
//! that it overlaps, a thin wall each cell that it touches.

use crate::map::{Frame, Occupancy, WeightMap, Weights, raster};
use crate::metrics::Body;
use crate::scenario::resolve::{Form, Geometry, Owner};
use crate::scenario::{Obstacle, Scenario};
use crate::{Error, geometry::Point};

/// A validated scene, prepared for planning.
///
/// The frame maps cells to metres: cell (x, y) covers the square from origin + resolution·(x, y) to the next.
#[derive(Clone)]
pub(super) struct World {
    pub(super) geometry: Geometry,
    pub(super) body: Body,
    pub(super) frame: Frame,
    /// Cells that real obstacles overlap.
    pub(super) occupancy: Occupancy,
}

impl World {
    /// # Errors
    /// Of a wrong scene, named by field, value and rule.
    pub(super) fn new(scenario: &Scenario) -> Result<Self, Error> {
        let geometry = scenario.geometry()?;
        let map = &scenario.map;
        let [x, y] = map.origin;
        let frame = Frame {
            origin: Point::new(x, y),
            width: map.width,
            height: map.height,
            resolution: map.resolution,
        };
        let mut occupancy = shapes(scenario, &geometry, &frame);
        for runs in brushed(scenario) {
            raster::runs(&mut occupancy, runs);
        }
        if scenario.costs.iter().any(|area| area.weight > 1) {
            let mut weights = Weights::new(frame.width, frame.height);
            for area in &scenario.costs {
                weights.paint(&area.runs, area.weight);
            }
            occupancy = occupancy.weighing(weights);
        }
        Ok(Self { body: Body::new(&geometry), geometry, frame, occupancy })
    }
}

impl World {
    /// Weights of the floor; `None` if all cells cost the same.
    pub(super) fn paint(&self) -> Option<WeightMap> {
        self.occupancy.weights().map(|weights| WeightMap { frame: self.frame, weights: weights.clone() })
    }
}

/// The brush's runs.
pub(super) fn brushed(scenario: &Scenario) -> impl Iterator<Item = &[[u32; 3]]> {
    scenario.obstacles.iter().filter_map(|obstacle| match obstacle {
        Obstacle::Cells { runs, .. } => Some(&runs[..]),
        _ => None,
    })
}

/// The cells that everything but the brush blocks.
///
/// Outside the boundary all cells are blocked. Shapes may overlap; the map does not tell whose a cell is.
pub(super) fn shapes(scenario: &Scenario, geometry: &Geometry, frame: &Frame) -> Occupancy {
    let mut map = Occupancy::new(frame.width, frame.height);
    if scenario.map.boundary.is_some() {
        raster::fill_outside(&mut map, frame, &geometry.boundary);
    }
    let brushed = |owner| match owner {
        Owner::Obstacle(i) => matches!(scenario.obstacles[i], Obstacle::Cells { .. }),
        _ => false,
    };
    for shape in geometry.shapes.iter().filter(|s| !brushed(s.owner)) {
        match &shape.form {
            Form::Segment(a, b) => raster::wall(&mut map, frame, &[*a, *b]),
            Form::Polygon(outline) => raster::fill(&mut map, frame, outline),
        }
    }
    map
}
