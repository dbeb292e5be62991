//! A strip of floor along a path.
//!
//! A corridor restricts where a path may lead, not what the body may touch: only the middle of the rear axle is held
//! against it. It is a bitmap, so a question costs O(1) a point; building one costs O(points · (reach / cell)²).
//!
//! The cells are decided by their centres. A place in a cell that counts may therefore be half a cell's diagonal
//! farther from the points than the reach, and callers that need a bound take it off beforehand.

use crate::geometry::arcs::Arc;
use crate::geometry::{Point, Pose, Vector};
use crate::map::{Cell, Frame};

/// Side of a cell, metres, …
const CELL: f64 = 0.2;
/// … unless there would be more of them than this.
const CELLS: f64 = 1e6;
/// Arcs are looked at this often, metres.
const STEP: f64 = 0.5;

/// The positions allowed for the middle of the rear axle, in cells of 0.2 m.
/// Coordinates are those of the points that it was made around.
#[derive(Debug)]
pub struct Corridor {
    frame: Frame,
    held: Vec<bool>,
}

impl Corridor {
    /// Everything within `reach` metres of some points, one at least.
    ///
    /// # Panics
    /// Without points.
    pub fn around(points: &[Point], reach: f64) -> Self {
        let edge = Vector::new(reach, reach);
        let low = points.iter().fold(points[0], |low, p| Point::from(low.coords.inf(&p.coords))) - edge;
        let high = points.iter().fold(points[0], |high, p| Point::from(high.coords.sup(&p.coords))) + edge;
        let size = high - low;
        let resolution = CELL.max((size.x * size.y / CELLS).sqrt());
        let [width, height] = [size.x, size.y].map(|side| (side / resolution) as u32 + 1);
        let frame = Frame { origin: low, width, height, resolution };
        let mut held = vec![false; width as usize * height as usize];
        for point in points {
            let [west, south, east, north] = [
                (point.x - reach - low.x, width),
                (point.y - reach - low.y, height),
                (point.x + reach - low.x, width),
                (point.y + reach - low.y, height),
            ]
            .map(|(at, cells)| ((at / resolution).max(0.0) as u32).min(cells - 1) as i32);
            for (x, y) in (south..=north).flat_map(|y| (west..=east).map(move |x| (x, y))) {
                let cell = Cell::new(x, y);
                held[frame.index(cell)] |= (frame.center(cell) - point).norm() <= reach;
            }
        }
        Self { frame, held }
    }

    /// True if a point is in it.
    /// Places off the bitmap are not.
    pub fn holds(&self, point: Point) -> bool {
        self.frame.cell_at(point).is_some_and(|cell| self.held[self.frame.index(cell)])
    }

    /// True if an arc from a pose stays in it.
    pub(super) fn holds_arc(&self, from: Pose, arc: &Arc) -> bool {
        let steps = (arc.length.abs() / STEP).ceil().max(1.0);
        let at = |k: u32| from.advance(arc.curvature, arc.length * f64::from(k) / steps).point();
        (1..=steps as u32).rev().all(|k| self.holds(at(k)))
    }
}
