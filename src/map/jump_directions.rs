//! In which directions a jump from a cell leads anywhere: most of them end at a wall, and a look at this byte instead
//! of along the line says so.

use super::{Cell, Occupancy};

/// A byte per cell: bit c for the c-th of E, NE, N, NW, W, SW, S, SE.
///
/// A straight jump leads somewhere where a turn is forced before a wall, a diagonal one where its first step is legal
/// with strict corners.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Ways {
    /// Columns, and one without ways on either side.
    stride: usize,
    ways: Vec<u8>,
}

impl Ways {
    pub(super) fn bytes(&self) -> usize {
        self.ways.len()
    }
}

/// By the free cells around a cell: the ways that it has whatever lies beyond, and those that it has where the next
/// cell has them.
static LOCAL: [(u8, u8); 256] = {
    let mut table = [(0, 0); 256];
    let mut free = 0;
    while free < 256 {
        table[free] = local(free as u8);
        free += 1;
    }
    table
};

const STRAIGHT: u8 = 0b0101_0101;

const fn local(free: u8) -> (u8, u8) {
    // Each at the bit of the direction that one looks in.
    let (left, right) = (free.rotate_right(2), free.rotate_left(2));
    let (left_ahead, right_ahead) = (free.rotate_right(1), free.rotate_left(1));
    let forced = left_ahead & !left | right_ahead & !right;
    (free & (STRAIGHT & forced | !STRAIGHT & left_ahead & right_ahead), free & STRAIGHT & !forced)
}

impl Ways {
    /// The directions of all cells. A straight direction may be passed on by the cell ahead, so cells are looked at in
    /// two sweeps, from either end of the map: each direction has its next cell before it in one of them.
    pub(super) fn new(map: &Occupancy) -> Self {
        let (width, height) = (map.width() as usize, map.height() as usize);
        let stride = width + 2;
        let mut ways = Self { stride, ways: vec![0; stride * (height + 2)] };
        for index in (0..map.len() as u32).rev() {
            ways.look(map, map.cell(index), !0);
        }
        for index in 0..map.len() as u32 {
            ways.look(map, map.cell(index), !0);
        }
        ways
    }

    /// The ways of a cell on the map.
    #[inline]
    pub(super) fn at(&self, cell: Cell) -> u8 {
        self.ways[self.slot(cell)]
    }

    /// Brings all up to date after a cell of the map was blocked or freed.
    pub(super) fn follow(&mut self, map: &Occupancy, changed: Cell) {
        for (direction, (dx, dy)) in [(1, 0), (0, 1), (-1, 0), (0, -1)].into_iter().enumerate() {
            for side in -1..=1 {
                let mut at = changed.offset(dx + dy * side, dy + dx * side);
                // The first three may have ways of their own, further ones only those of the next.
                let mut near = 3;
                while near > 0 || map.contains(at) {
                    let new = map.contains(at) && self.look(map, at, 1 << (2 * direction));
                    if !new && near <= 0 {
                        break;
                    }
                    at = at.offset(-dx, -dy);
                    near -= 1;
                }
            }
        }
        for (dx, dy) in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))) {
            let cell = changed.offset(dx, dy);
            if map.contains(cell) {
                self.look(map, cell, !STRAIGHT);
            }
        }
    }

    /// Brings these ways of a cell up to date, where its neighbours' are; tells whether they have changed.
    fn look(&mut self, map: &Occupancy, cell: Cell, directions: u8) -> bool {
        let slot = self.slot(cell);
        let (own, passed) = LOCAL[usize::from(map.free_around(cell))];
        let beyond = self.ways[slot + 1] & 1
            | self.ways[slot + self.stride] & 1 << 2
            | self.ways[slot - 1] & 1 << 4
            | self.ways[slot - self.stride] & 1 << 6;
        let new = (own | passed & beyond) & directions | self.ways[slot] & !directions;
        std::mem::replace(&mut self.ways[slot], new) != new
    }

    fn slot(&self, cell: Cell) -> usize {
        (cell.y + 1) as usize * self.stride + (cell.x + 1) as usize
    }
}
