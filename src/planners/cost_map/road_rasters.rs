//! Rasters of a road: cells count by their centres.
//!
//! A cell is road if its centre is. Its clearance is the exact distance from its centre to the nearest blocked one,
//! less half a cell; distances to kerbs and lanes' middles are in metres. Places are the middle of the car, not its
//! rear axle.
//!
//! Obstacles count by centres, too, unless they are thinner than a cell: a wall without thickness holds no centre, so
//! it blocks every cell that it touches. That is the conservative choice; it costs lanes beside drawn kerbs up to
//! half a metre.
//!
//! The distances come from an exact Euclidean transform of the cells, O(cells), so no direction is preferred.

use std::sync::Arc;

use crate::geometry::{Point, math};
use crate::map::{Cell, Frame, Occupancy, Weights, distance, raster};
use crate::scenario::resolve::{Form, Geometry};

/// Centres this near to an outline are on it, metres.
const EDGE: f64 = 1e-9;

/// A road on a lattice.
/// Rows run from the south, as in the frame.
#[derive(Debug, Clone)]
pub struct RoadRasters {
    /// The lattice.
    pub frame: Frame,
    /// Per cell: metres from its centre to the border of the nearest cell that is no road or holds an obstacle; 0 in
    /// one.
    pub clearance: Vec<f32>,
    /// No place of a cell is farther from everything than the cell's clearance and this, metres.
    pub unsure: f64,
    /// By how much walls without thickness are thicker on the lattice, metres; 0 where there are none.
    pub thickened: f64,
    /// Weights of the cells; `None` if all cost the same.
    pub weights: Option<Arc<Weights>>,
}

impl RoadRasters {
    /// Of a scene's geometry. Where the map ends a road goes on if it is `open`; otherwise there is a wall.
    pub fn new(frame: Frame, geometry: &Geometry, open: bool) -> Self {
        let mut road = surface(&frame, geometry);
        // A cell's corner from its centre, and that centre from the border of the nearest cell that counts.
        let corner = frame.resolution * core::f64::consts::FRAC_1_SQRT_2;
        let (sure, mut is_thin) = (corner + frame.resolution / 2.0, false);
        for shape in &geometry.shapes {
            match &shape.form {
                Form::Polygon(outline) => {
                    fill(&frame, outline, |cell| road.set(cell, true));
                    // Centres can miss what is thinner than a cell.
                    if width(outline) < frame.resolution - EDGE {
                        let around: Vec<Point> = outline.iter().chain(outline.first()).copied().collect();
                        raster::wall(&mut road, &frame, &around);
                        is_thin = true;
                    }
                }
                Form::Segment(a, b) => {
                    raster::wall(&mut road, &frame, &[*a, *b]);
                    is_thin = true;
                }
            }
        }
        // What is thin touches its cells, but need not hold their centres.
        let unsure = if is_thin { sure + corner } else { sure };
        let thickened = if is_thin { frame.resolution } else { 0.0 };
        Self { frame, clearance: distances(&road, &frame, open), unsure, thickened, weights: None }
    }

    /// The clearance at a cell, metres; 0 off the map.
    pub fn at(&self, cell: Cell) -> f64 {
        if self.frame.contains(cell) { f64::from(self.clearance[self.frame.index(cell)]) } else { 0.0 }
    }
}

/// Per cell: metres to the border of the nearest cell that is no road, whatever stands on the road.
pub fn kerb_distances(frame: &Frame, geometry: &Geometry, open: bool) -> Vec<f32> {
    distances(&surface(frame, geometry), frame, open)
}

/// Blocked is what is no road.
fn surface(frame: &Frame, geometry: &Geometry) -> Occupancy {
    let mut road = Occupancy::blocked_everywhere(frame.width, frame.height);
    fill(frame, &geometry.boundary, |cell| road.set(cell, false));
    road
}

/// Calls `each` with every cell whose centre is inside a simple polygon or on its outline; some more than once.
fn fill(frame: &Frame, outline: &[Point], mut each: impl FnMut(Cell)) {
    for y in 0..frame.height {
        let center = frame.center(Cell::new(0, y as i32)).y;
        // A hair above and a hair below, so that edges along the row count.
        for level in [center - EDGE, center + EDGE] {
            let edges = outline.iter().zip(outline.iter().cycle().skip(1));
            let crossings: Vec<f64> = edges
                .filter(|(a, b)| (a.y > level) != (b.y > level))
                .map(|(a, b)| a.x + (level - a.y) / (b.y - a.y) * (b.x - a.x))
                .collect();
            for pair in math::sorted_by(&crossings, |x| *x).chunks_exact(2) {
                let column = |x: f64| (x - frame.origin.x) / frame.resolution - 0.5;
                let last = f64::from(frame.width);
                let from = column(pair[0] - EDGE).ceil().clamp(0.0, last);
                let to = (column(pair[1] + EDGE).floor() + 1.0).clamp(0.0, last);
                (from as i32..to as i32).for_each(|x| each(Cell::new(x, y as i32)));
            }
        }
    }
}

/// How thin a polygon is, metres: across the edge on which it lies flattest.
fn width(outline: &[Point]) -> f64 {
    let across = |(i, a): (usize, &Point)| {
        let edge = outline[(i + 1) % outline.len()] - a;
        outline.iter().fold(0.0, |most: f64, p| most.max((edge.perp(&(p - a)) / edge.norm()).abs()))
    };
    outline.iter().enumerate().map(across).fold(f64::INFINITY, f64::min)
}

/// From the exact distances between centres, half a cell less.
fn distances(map: &Occupancy, frame: &Frame, open: bool) -> Vec<f32> {
    let (w, h) = (f64::from(frame.width), f64::from(frame.height));
    let far = (w * w + h * h).sqrt() * frame.resolution;
    let metres = |d: i64| if d >= distance::NONE { far } else { (d as f64).sqrt() / 2.0 * frame.resolution };
    let mut clearance =
        distance::to_centers(map, |d| (metres(d) - frame.resolution / 2.0).max(0.0) as f32).data;
    if !open {
        for (index, d) in clearance.iter_mut().enumerate() {
            let cell = frame.cell(index);
            let (x, y) = (f64::from(cell.x) + 0.5, f64::from(cell.y) + 0.5);
            *d = d.min((x.min(y).min(w - x).min(h - y) * frame.resolution) as f32);
        }
    }
    clearance
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_count_by_their_centres() {
        let frame = Frame { origin: Point::new(0.0, 0.0), width: 6, height: 4, resolution: 0.5 };
        let outline = [(0.3, 0.2), (2.2, 0.2), (2.2, 1.3), (0.3, 1.3)].map(|(x, y)| Point::new(x, y));
        let mut cells = Vec::new();
        fill(&frame, &outline, |cell| cells.push((cell.x, cell.y)));
        cells.sort_unstable_by_key(|c| (c.1, c.0));
        cells.dedup();
        assert_eq!(cells, [(1, 0), (2, 0), (3, 0), (1, 1), (2, 1), (3, 1), (1, 2), (2, 2), (3, 2)]);
        let aligned = [(0.25, 0.25), (1.25, 0.25), (1.25, 0.75), (0.25, 0.75)].map(|(x, y)| Point::new(x, y));
        let mut cells = 0;
        let mut seen = [false; 24];
        fill(&frame, &aligned, |cell| {
            let index = frame.index(cell);
            cells += u32::from(!std::mem::replace(&mut seen[index], true));
        });
        assert_eq!(cells, 6, "edges through centres count");
    }
}
