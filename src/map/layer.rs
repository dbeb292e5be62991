//! One value per cell.
//!
//! Rows lie one after the other from the south-western cell, as in ROS maps and unlike pictures, which begin in the
//! north.

use super::Cell;

/// A value for every cell of a map.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layer<T> {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Row by row from the south-western cell, eastward.
    pub data: Vec<T>,
}

impl<T: Copy> Layer<T> {
    /// A layer that holds `value` everywhere.
    pub fn filled(width: u32, height: u32, value: T) -> Self {
        Self { width, height, data: vec![value; width as usize * height as usize] }
    }

    /// The value at a cell; `None` outside.
    pub fn get(&self, cell: Cell) -> Option<T> {
        let inside = (cell.x as u32) < self.width && (cell.y as u32) < self.height;
        inside.then(|| self.data[self.index(cell)])
    }

    /// Sets the value at a cell, which must be inside.
    pub fn set(&mut self, cell: Cell, value: T) {
        let index = self.index(cell);
        self.data[index] = value;
    }

    fn index(&self, cell: Cell) -> usize {
        cell.y as usize * self.width as usize + cell.x as usize
    }
}
