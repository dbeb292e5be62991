//! A map of cells, and how it becomes a scene.
//!
//! Files of other programs have cells but seldom a question, so one is made up: from the first to the last cell, row
//! by row, of the largest room. Rooms are preferred in which the car can stand in every direction; where there is
//! none, any free cells will do. Both poses look along the straight line from one to the other.

use super::file::stem;
use crate::error::{Error, ErrorCode};
use crate::geometry::{Point, Pose, math};
use crate::map::{Cell, Frame, Occupancy, distance, raster};
use crate::scenario::{MapFrame, Obstacle, Scenario, VehicleSpec};

/// A map of cells as a scene without slots.
/// The map's first row is the southern one, as in all frames of this crate.
pub(super) struct Raster {
    pub(super) map: Occupancy,
    pub(super) frame: MapFrame,
    pub(super) vehicle: VehicleSpec,
}

impl Raster {
    /// The scene that goes from one cell to another, or along the farthest way of the largest room when none are given.
    ///
    /// # Errors
    /// No free cell, or a scene that [`Scenario::validate`] refuses.
    pub(super) fn scene(self, ends: Option<[Cell; 2]>, file: &str) -> Result<Scenario, Error> {
        let frame = lattice(&self.frame);
        let car = self.vehicle.resolve()?;
        let room = || {
            let mut inside = self.map.clone();
            if let Some(outline) = &self.frame.boundary {
                let outline: Vec<Point> = outline.iter().map(|&[x, y]| Point::new(x, y)).collect();
                raster::fill_outside(&mut inside, &frame, &outline);
            }
            // Where the car can stand in every direction, if there is such a place.
            let reach = car.reach();
            let largest = largest_room(&inner(&inside, reach / frame.resolution));
            largest.filter(|[start, goal]| start != goal).or_else(|| largest_room(&inside))
        };
        let Some([start, goal]) = ends.or_else(room) else {
            return Err(Error::new(ErrorCode::Import, file, "must have a free cell"));
        };
        let [start, goal] = poses(&frame, start, goal);
        let scene = Scenario {
            name: Some(stem(file).to_owned()),
            obstacles: vec![Obstacle::Cells { id: None, runs: raster::to_runs(&self.map) }],
            ..Scenario::new(self.frame, self.vehicle, start, goal)
        };
        // A file may place its map beyond every scene.
        scene.validate().map_err(|e| e.within(file).with_code(ErrorCode::Import))?;
        Ok(scene)
    }
}

/// The map's frame as the rasters use it.
pub(super) fn lattice(map: &MapFrame) -> Frame {
    let [x, y] = map.origin;
    Frame { origin: Point::new(x, y), width: map.width, height: map.height, resolution: map.resolution }
}

/// The poses in the middle of two cells, both along the line from the first to the second.
/// The heading is that of the straight line, so that a question without headings is one that a car can start from.
pub(super) fn poses(frame: &Frame, start: Cell, goal: Cell) -> [Pose; 2] {
    let (dx, dy) = (f64::from(goal.x - start.x), f64::from(goal.y - start.y));
    let heading = math::atan2(dy, dx);
    [start, goal].map(|cell| {
        let at = frame.center(cell);
        Pose::new(at.x, at.y, heading)
    })
}

/// The map without the cells that lie less than `reach` cells from a blocked cell or the border.
/// What remains is where the middle of a disc of that radius may be.
fn inner(map: &Occupancy, reach: f64) -> Occupancy {
    let mut inner = map.clone();
    // From centre to centre; a cell's corner may be that much nearer.
    let apart = distance::to_centers(map, |d| (d as f64).sqrt() as f32 / 2.0);
    let (far, edge) = (reach + core::f64::consts::FRAC_1_SQRT_2, reach.ceil() as i32);
    for (index, &d) in apart.data.iter().enumerate() {
        let Cell { x, y } = map.cell(index as u32);
        let border = x.min(y).min(map.width() as i32 - 1 - x).min(map.height() as i32 - 1 - y);
        if border < edge || f64::from(d) < far {
            inner.set(Cell { x, y }, true);
        }
    }
    inner
}

/// The first and the last cell of the largest set of free cells that share edges, row by row.
/// `None` where every cell is blocked. A flood over the cells: O(cells).
fn largest_room(map: &Occupancy) -> Option<[Cell; 2]> {
    let mut seen = vec![false; map.len()];
    let mut largest = (0, None);
    let mut stack = Vec::new();
    for index in 0..map.len() as u32 {
        let first = map.cell(index);
        if map.blocked(first) || seen[index as usize] {
            continue;
        }
        let (mut size, mut last) = (0_u32, index);
        seen[index as usize] = true;
        stack.push(first);
        while let Some(cell) = stack.pop() {
            size += 1;
            last = last.max(map.index(cell));
            for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1)] {
                let next = cell.offset(dx, dy);
                if !map.blocked(next) && !std::mem::replace(&mut seen[map.index(next) as usize], true) {
                    stack.push(next);
                }
            }
        }
        if size > largest.0 {
            largest = (size, Some([first, map.cell(last)]));
        }
    }
    largest.1
}
