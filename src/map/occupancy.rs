//! Which cells are blocked, and what it costs to cross the others.
//!
//! Searches ask "which of the eight cells around are free?" far more often than anything else, so the map keeps the
//! answer as a byte per cell. An edit of one cell updates the nine bytes around it; nothing has to be prepared before a
//! search, and a brush stroke costs what it touches. A border of blocked cells saves the test of each neighbour against
//! the border.

use std::sync::Arc;

use super::{Cell, Layer, Weights};
use crate::fnv::Fnv;

/// Blocked cells around the map, so that the cells around a cell need no range checks of their own.
const RIM: usize = 3;

/// Free and blocked cells. Everything outside counts as blocked.
///
/// Each cell is a byte, and a second one says which of the eight cells around it are free: searches ask for nothing
/// more often. Both are kept up to date by every change, so there is nothing to prepare before a search.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Occupancy {
    width: u32,
    height: u32,
    stride: usize,
    /// 2⁴⁰ / width, rounded up; 0 where that is not exact enough.
    reciprocal: u64,
    /// 0 free, 1 blocked.
    rimmed: Vec<u8>,
    /// Per cell in the order of their numbers, a bit for each free neighbour: searches know numbers.
    around: Vec<u8>,
    /// Weights of the cells; `None` if all cost the same.
    weights: Option<Arc<Weights>>,
}

/// The eight directions E, NE, N, NW, W, SW, S, SE, in the order of [`Occupancy::free_around`]'s bits.
pub const DIRECTIONS: [(i32, i32); 8] =
    [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];

impl Occupancy {
    /// A map of free cells.
    pub fn new(width: u32, height: u32) -> Self {
        let (w, h) = (width as usize, height as usize);
        let stride = w + 2 * RIM;
        // Eight cells of a row can be read at once, even at the end of the last.
        let size = stride * (h + 2 * RIM) + 8;
        let (mut rimmed, mut around) = (vec![1; size], vec![0; w * h]);
        for y in 0..h {
            let start = (y + RIM) * stride + RIM;
            rimmed[start..start + w].fill(0);
            let south = if y == 0 { 0b0001_1111 } else { 0xff };
            let north = if y + 1 == h { 0b1111_0001 } else { 0xff };
            let row = &mut around[y * w..][..w];
            row.fill(south & north);
            if let Some(first) = row.first_mut() {
                *first &= 0b1100_0111;
            }
            if let Some(last) = row.last_mut() {
                *last &= 0b0111_1100;
            }
        }
        let [wide, high] = [width, height].map(u64::from);
        let exact = wide > 0 && (wide * wide).saturating_mul(high) <= 1 << 40;
        let reciprocal = if exact { (1_u64 << 40).div_ceil(u64::from(width)) } else { 0 };
        Self { width, height, stride, reciprocal, rimmed, around, weights: None }
    }

    /// A map of blocked cells.
    pub fn blocked_everywhere(width: u32, height: u32) -> Self {
        let mut map = Self::new(width, height);
        map.rimmed.fill(1);
        map.around.fill(0);
        map
    }

    /// A map drawn with characters: the first line is the northern row, `.` and blanks are free, the rest blocked.
    pub fn parse(drawing: &str) -> Self {
        let lines: Vec<&[u8]> = drawing.lines().map(str::as_bytes).filter(|l| !l.is_empty()).collect();
        let width = lines.iter().map(|l| l.len()).max().unwrap_or(0);
        let mut map = Self::new(width as u32, lines.len() as u32);
        for (y, line) in lines.iter().rev().enumerate() {
            for (x, &c) in line.iter().enumerate() {
                map.set(Cell::new(x as i32, y as i32), c != b'.' && c != b' ');
            }
        }
        map
    }

    /// The same map with these costs of its cells.
    #[must_use]
    pub fn weighing(self, weights: Weights) -> Self {
        Self { weights: Some(Arc::new(weights)), ..self }
    }

    /// Weights of the cells; `None` if all cost the same.
    pub fn weights(&self) -> Option<&Arc<Weights>> {
        self.weights.as_ref()
    }

    /// Columns.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Bytes held, weights included.
    pub fn bytes(&self) -> usize {
        let weights = if self.weights.is_some() { self.len() } else { 0 };
        self.rimmed.len() + self.around.len() + weights
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// True if there is no cell.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// True if the cell is on the map.
    pub fn contains(&self, cell: Cell) -> bool {
        (cell.x as u32) < self.width && (cell.y as u32) < self.height
    }

    /// The cell's row-major number; the cell must be inside.
    pub fn index(&self, cell: Cell) -> u32 {
        cell.y as u32 * self.width + cell.x as u32
    }

    /// The cell of a row-major number.
    pub fn cell(&self, index: u32) -> Cell {
        // A division takes longer than all the rest of a search's step.
        let y = match self.reciprocal {
            0 => index / self.width,
            reciprocal => ((u64::from(index) * reciprocal) >> 40) as u32,
        };
        Cell::new((index - y * self.width) as i32, y as i32)
    }

    /// True if the cell is blocked or outside.
    pub fn blocked(&self, cell: Cell) -> bool {
        !self.contains(cell) || self.rimmed[self.slot(cell)] != 0
    }

    /// True if the cell is inside and blocked.
    pub fn is_obstacle(&self, cell: Cell) -> bool {
        self.contains(cell) && self.rimmed[self.slot(cell)] != 0
    }

    /// Blocks or frees a cell; cells outside stay as they are.
    pub fn set(&mut self, cell: Cell, blocked: bool) {
        if !self.contains(cell) {
            return;
        }
        let slot = self.slot(cell);
        let value = u8::from(blocked);
        if std::mem::replace(&mut self.rimmed[slot], value) == value {
            return;
        }
        for (direction, (dx, dy)) in DIRECTIONS.into_iter().enumerate() {
            let neighbour = cell.offset(dx, dy);
            if self.contains(neighbour) {
                let index = self.index(neighbour) as usize;
                self.around[index] ^= 1 << ((direction + 4) % 8);
            }
        }
    }

    /// The free cells around an inside cell: bit c stands for the c-th of E, NE, N, NW, W, SW, S, SE.
    pub fn free_around(&self, cell: Cell) -> u8 {
        self.free_around_index(self.index(cell))
    }

    /// [`Occupancy::free_around`] of the cell of a row-major number.
    #[inline]
    pub(crate) fn free_around_index(&self, index: u32) -> u8 {
        self.around[index as usize]
    }

    /// The blocked cells of the 7 × 7 square around an inside cell: bit `8 · (dy + 3) + dx + 3`.
    pub(crate) fn window(&self, cell: Cell) -> u64 {
        /// Gathers the lowest bits of eight bytes.
        const GATHER: u64 = 0x0102_0408_1020_4080;
        let mut start = self.slot(cell) - RIM * self.stride - RIM;
        let mut window = 0;
        for row in 0..7 {
            let mut bytes = [0; 8];
            bytes.copy_from_slice(&self.rimmed[start..start + 8]);
            window |= (u64::from_le_bytes(bytes).wrapping_mul(GATHER) >> 56) << (8 * row);
            start += self.stride;
        }
        window
    }

    /// True if the 7 × 7 square around a cell is free, where all of it is on the map: the same as an empty
    /// [`Occupancy::window`], sooner.
    pub(crate) fn is_clear(&self, cell: Cell) -> bool {
        const FIVE: u64 = (1 << 40) - 1;
        let row = |dy| {
            let west = self.index(cell.offset(-2, dy)) as usize;
            let mut bytes = [0; 8];
            bytes.copy_from_slice(&self.around[west..west + 8]);
            u64::from_le_bytes(bytes)
        };
        row(-2) & row(0) & row(2) & FIVE == FIVE
    }

    /// One row, west to east: 0 free, 1 blocked.
    pub fn row(&self, y: u32) -> &[u8] {
        let start = (y as usize + RIM) * self.stride + RIM;
        &self.rimmed[start..start + self.width as usize]
    }

    /// Number of blocked cells.
    pub fn blocked_cells(&self) -> usize {
        (0..self.height).map(|y| self.row(y).iter().filter(|&&b| b != 0).count()).sum()
    }

    /// 0 free, 1 blocked, per cell.
    pub fn layer(&self) -> Layer<u8> {
        let data = (0..self.height).flat_map(|y| self.row(y).iter().copied()).collect();
        Layer { width: self.width, height: self.height, data }
    }

    /// FNV-1a-64 over one byte per cell (0 free, 1 blocked), row by row: names a map in tests.
    pub fn fnv1a64(&self) -> u64 {
        let mut hash = Fnv::new();
        (0..self.height).for_each(|y| hash.add(self.row(y)));
        hash.value()
    }

    /// True if a path of edge-sharing free cells joins the two cells, which is what a path that touches no corner of
    /// a blocked cell needs.
    pub fn connected(&self, from: Cell, to: Cell) -> bool {
        if self.blocked(from) || self.blocked(to) {
            return false;
        }
        let mut seen = vec![false; self.len()];
        let mut stack = vec![from];
        seen[self.index(from) as usize] = true;
        while let Some(cell) = stack.pop() {
            if cell == to {
                return true;
            }
            for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1)] {
                let next = cell.offset(dx, dy);
                if !self.blocked(next) && !std::mem::replace(&mut seen[self.index(next) as usize], true) {
                    stack.push(next);
                }
            }
        }
        false
    }

    fn slot(&self, cell: Cell) -> usize {
        (cell.y as usize + RIM) * self.stride + cell.x as usize + RIM
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_line_of_a_drawing_is_the_north() {
        let map = Occupancy::parse("#..\n...\n");
        assert_eq!((map.width(), map.height(), map.blocked_cells()), (3, 2, 1));
        assert!(map.blocked(Cell::new(0, 1)) && !map.blocked(Cell::new(0, 0)));
        assert!(map.blocked(Cell::new(-1, 0)) && !map.is_obstacle(Cell::new(-1, 0)));
    }

    #[test]
    fn numbers_name_their_cells_however_wide_a_map_is() {
        for (width, height) in [(1, 9), (3, 70_000), (4096, 4096), (65_000, 3), (600_000, 7), (2_000_000, 2)]
        {
            let map = Occupancy::new(width, height);
            for index in (0..width * height).step_by(997).chain([width - 1, width * height - 1]) {
                let cell = Cell::new((index % width) as i32, (index / width) as i32);
                assert_eq!((map.cell(index), map.index(cell)), (cell, index), "{width} x {height}");
            }
        }
    }

    #[test]
    fn free_around_names_the_eight_neighbours() {
        let mut map = Occupancy::new(3, 3);
        assert_eq!(map.free_around(Cell::new(1, 1)), 0xff);
        assert_eq!(map.free_around(Cell::new(0, 0)), 0b0000_0111);
        map.set(Cell::new(2, 0), true);
        assert_eq!(map.free_around(Cell::new(1, 1)), 0b0111_1111);
    }

    #[test]
    fn neighbours_and_windows_follow_every_change() {
        let mut map = Occupancy::new(9, 8);
        let mut state = 7_u32;
        for round in 0..300 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let cell = map.cell((state >> 8) % map.len() as u32);
            map.set(cell, round % 3 == 0 && round < 200);
            let window = map.window(cell);
            for (dx, dy) in (-3..=3).flat_map(|dy| (-3..=3).map(move |dx| (dx, dy))) {
                let seen = window >> (8 * (dy + 3) + dx + 3) & 1 == 1;
                assert_eq!(seen, map.blocked(cell.offset(dx, dy)), "{cell:?} {dx} {dy}");
            }
            if (3..6).contains(&cell.x) && (3..map.height() as i32 - 3).contains(&cell.y) {
                assert_eq!(map.is_clear(cell), window == 0, "{cell:?}");
            }
            for (c, (dx, dy)) in DIRECTIONS.into_iter().enumerate() {
                assert_eq!(map.free_around(cell) >> c & 1 == 0, map.blocked(cell.offset(dx, dy)));
            }
        }
    }

    #[test]
    fn diagonal_contact_does_not_connect() {
        let map = Occupancy::parse("#.\n.#\n");
        assert!(!map.connected(Cell::new(0, 0), Cell::new(1, 1)));
        assert!(map.connected(Cell::new(0, 0), Cell::new(0, 0)));
    }
}
