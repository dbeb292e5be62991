//! The only place where cells become metres and metres cells.
//!
//! The centre of cell (x, y) lies at `origin + (x + ½, y + ½) · resolution`, in metres; the cell is the square
//! around it. A single home for this conversion prevents overlays that are half a cell off.

use crate::geometry::Point;

/// A cell: column `x` counted from the west, row `y` from the south, both from 0.
///
/// Negative and too large numbers are legal values; they lie outside every map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Cell {
    /// Column, to the east.
    pub x: i32,
    /// Row, to the north.
    pub y: i32,
}

impl Cell {
    /// The cell in column `x` and row `y`.
    pub const fn new(x: i32, y: i32) -> Self {
        Self { x, y }
    }

    /// The cell `dx` columns to the east and `dy` rows to the north.
    #[must_use]
    pub const fn offset(self, dx: i32, dy: i32) -> Self {
        Self { x: self.x + dx, y: self.y + dy }
    }
}

/// The lattice's place in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Lower left corner of cell (0, 0), metres.
    pub origin: Point,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Side of a cell, metres.
    pub resolution: f64,
}

impl Frame {
    /// Number of cells.
    pub fn len(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// True if there is no cell.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The cell's row-major number from the south-western corner; the cell must be inside.
    pub fn index(&self, cell: Cell) -> usize {
        cell.y as usize * self.width as usize + cell.x as usize
    }

    /// The cell of a row-major number.
    pub fn cell(&self, index: usize) -> Cell {
        let width = self.width as usize;
        Cell::new((index % width) as i32, (index / width) as i32)
    }

    /// True if the cell is on the map.
    pub fn contains(&self, cell: Cell) -> bool {
        (cell.x as u32) < self.width && (cell.y as u32) < self.height
    }

    /// The cell that a point (metres) lies in; a point on a common edge belongs to the eastern, northern cell.
    pub fn cell_at(&self, point: Point) -> Option<Cell> {
        let [x, y] = self.lattice(point);
        let inside = x >= 0.0 && y >= 0.0 && x < f64::from(self.width) && y < f64::from(self.height);
        inside.then(|| Cell::new(x as i32, y as i32))
    }

    /// The middle of a cell, metres.
    pub fn center(&self, cell: Cell) -> Point {
        self.world([f64::from(cell.x), f64::from(cell.y)])
    }

    /// The point (metres) at planner coordinates: cell units, cell centres at integers.
    pub fn world(&self, [x, y]: [f64; 2]) -> Point {
        Point::new(self.origin.x + (x + 0.5) * self.resolution, self.origin.y + (y + 0.5) * self.resolution)
    }

    /// A point (metres) in lattice coordinates: cell units from the lower left corner, cell edges at integers.
    pub fn lattice(&self, point: Point) -> [f64; 2] {
        [(point.x - self.origin.x) / self.resolution, (point.y - self.origin.y) / self.resolution]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn centres_and_cells_are_inverse() {
        let frame = Frame { origin: Point::new(-0.15, 2.0), width: 7, height: 5, resolution: 0.3 };
        for index in 0..frame.len() {
            let cell = frame.cell(index);
            assert_eq!(frame.index(cell), index);
            assert_eq!(frame.cell_at(frame.center(cell)), Some(cell));
        }
        assert_eq!(frame.cell_at(Point::new(-0.16, 2.1)), None);
        assert_eq!(frame.cell_at(Point::new(f64::NAN, 2.1)), None);
        assert_eq!(frame.center(Cell::new(0, 0)), Point::new(0.0, 2.15));
        assert!(!frame.contains(Cell::new(-1, 0)) && !frame.contains(Cell::new(0, 5)));
    }
}
