//! Which cells are blocked.

use super::{Cell, Layer};

/// Free and blocked cells. Everything outside counts as blocked.
///
/// Stored as bytes with a rim of blocked cells, so that the eight neighbours of a cell need no range checks of
/// their own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Occupancy {
    width: u32,
    height: u32,
    stride: usize,
    rimmed: Vec<u8>,
}

impl Occupancy {
    /// A map of free cells.
    pub fn new(width: u32, height: u32) -> Self {
        let stride = width as usize + 2;
        let mut rimmed = vec![1; stride * (height as usize + 2)];
        for row in rimmed.chunks_mut(stride).skip(1).take(height as usize) {
            row[1..=width as usize].fill(0);
        }
        Self { width, height, stride, rimmed }
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

    /// Columns.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Whether there is no cell.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether the cell is on the map.
    pub fn contains(&self, cell: Cell) -> bool {
        (cell.x as u32) < self.width && (cell.y as u32) < self.height
    }

    /// The cell's row-major number; the cell must be inside.
    pub fn index(&self, cell: Cell) -> u32 {
        cell.y as u32 * self.width + cell.x as u32
    }

    /// The cell of a row-major number.
    pub fn cell(&self, index: u32) -> Cell {
        Cell::new((index % self.width) as i32, (index / self.width) as i32)
    }

    /// Whether the cell is blocked or outside.
    pub fn blocked(&self, cell: Cell) -> bool {
        !self.contains(cell) || self.rimmed[self.slot(cell)] != 0
    }

    /// Whether the cell is inside and blocked.
    pub fn is_obstacle(&self, cell: Cell) -> bool {
        self.contains(cell) && self.rimmed[self.slot(cell)] != 0
    }

    /// Blocks or frees a cell; cells outside stay as they are.
    pub fn set(&mut self, cell: Cell, blocked: bool) {
        if self.contains(cell) {
            let slot = self.slot(cell);
            self.rimmed[slot] = u8::from(blocked);
        }
    }

    /// The free cells around an inside cell: bit c stands for the c-th of E, NE, N, NW, W, SW, S, SE.
    pub fn free_around(&self, cell: Cell) -> u8 {
        let slot = self.slot(cell);
        let row = |start: usize| {
            let r = &self.rimmed[start..start + 3];
            [r[0], r[1], r[2]]
        };
        let [sw, s, se] = row(slot - self.stride - 1);
        let [w, _, e] = row(slot - 1);
        let [nw, n, ne] = row(slot + self.stride - 1);
        !(e | ne << 1 | n << 2 | nw << 3 | w << 4 | sw << 5 | s << 6 | se << 7)
    }

    /// One row, west to east: 0 free, 1 blocked.
    pub fn row(&self, y: u32) -> &[u8] {
        let start = (y as usize + 1) * self.stride + 1;
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
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for y in 0..self.height {
            for &byte in self.row(y) {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
            }
        }
        hash
    }

    /// Whether a path of edge-sharing free cells joins the two cells, which is what a path that touches no corner of
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
        (cell.y as usize + 1) * self.stride + cell.x as usize + 1
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
    fn free_around_names_the_eight_neighbours() {
        let mut map = Occupancy::new(3, 3);
        assert_eq!(map.free_around(Cell::new(1, 1)), 0xff);
        assert_eq!(map.free_around(Cell::new(0, 0)), 0b0000_0111);
        map.set(Cell::new(2, 0), true);
        assert_eq!(map.free_around(Cell::new(1, 1)), 0b0111_1111);
    }

    #[test]
    fn diagonal_contact_does_not_connect() {
        let map = Occupancy::parse("#.\n.#\n");
        assert!(!map.connected(Cell::new(0, 0), Cell::new(1, 1)));
        assert!(map.connected(Cell::new(0, 0), Cell::new(0, 0)));
    }
}
