//! A map as bits, 64 cells a word, by rows and by columns: scanning a row looks at 63 cells at once.

use super::{Cell, Occupancy};

/// Blocked bits before the first cell of a line.
const PAD: usize = 64;

/// Which cells are blocked, as bits. Everything outside counts as blocked.
#[derive(Debug, Clone)]
pub struct Bits {
    rows: Lines,
    columns: Lines,
}

/// Parallel lines of cells.
#[derive(Debug, Clone)]
struct Lines {
    /// Words of one line.
    words: usize,
    bits: Vec<u64>,
}

impl Lines {
    fn new(lines: u32, length: u32) -> Self {
        let words = (length as usize).div_ceil(64) + 3;
        Self { words, bits: vec![u64::MAX; words * (lines as usize + 2)] }
    }

    fn set(&mut self, line: i32, at: i32, blocked: bool) {
        let bit = at as usize + PAD;
        let word = &mut self.bits[(line + 1) as usize * self.words + bit / 64];
        *word = if blocked { *word | 1 << (bit % 64) } else { *word & !(1 << (bit % 64)) };
    }

    fn line(&self, line: i32) -> &[u64] {
        let start = (line + 1) as usize * self.words;
        &self.bits[start..start + self.words]
    }

    /// Goes along a line from the free cell `at` until the goal, a forced turn or a wall.
    fn scan(&self, line: i32, at: i32, forward: bool, goal: Option<i32>) -> Scan {
        let lines = [line, line + 1, line - 1].map(|l| self.line(l));
        let mut from = at;
        loop {
            let start = (if forward { from } else { from - 63 } + PAD as i32) as usize;
            let [here, above, below] = lines.map(|l| window(l, start));
            let end = if forward {
                let stops = here | (!above & above << 1) | (!below & below << 1);
                let first = (stops & !1).trailing_zeros() as i32;
                (first < 64).then(|| (from + first, here >> first & 1 == 1))
            } else {
                let stops = here | (!above & above >> 1) | (!below & below >> 1);
                let first = (stops & !(1 << 63)).leading_zeros() as i32;
                (first < 64).then(|| (from - first, here << first >> 63 == 1))
            };
            let Some((end, wall)) = end else {
                from += if forward { 63 } else { -63 };
                continue;
            };
            let passes = |goal: &i32| {
                let (before, after) =
                    if forward { (*goal > at, *goal < end) } else { (*goal < at, *goal > end) };
                before && (after || (*goal == end && !wall))
            };
            let cells = end.abs_diff(at);
            return match goal.filter(passes) {
                Some(goal) => Scan { jump: Some(goal), cells },
                None => Scan { jump: (!wall).then_some(end), cells },
            };
        }
    }
}

/// 64 cells of a line, from the one at `bit` − [`PAD`] on.
fn window(line: &[u64], bit: usize) -> u64 {
    let (low, high, shift) = (line[bit / 64], line[bit / 64 + 1], bit % 64);
    // Two shifts, because one by 64 is none.
    low >> shift | high << 1 << (63 - shift)
}

/// The end of a straight jump.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Scan {
    /// The column (or row) of the goal or of the first cell with a forced turn, if there is one before a wall.
    pub(crate) jump: Option<i32>,
    /// Cells looked at.
    pub(crate) cells: u32,
}

impl Bits {
    /// The bits of a map.
    pub fn new(map: &Occupancy) -> Self {
        let (width, height) = (map.width(), map.height());
        let mut bits = Self { rows: Lines::new(height, width), columns: Lines::new(width, height) };
        for y in 0..height {
            for (x, _) in map.row(y).iter().enumerate().filter(|&(_, &blocked)| blocked == 0) {
                bits.set(Cell::new(x as i32, y as i32), false);
            }
        }
        bits
    }

    /// Blocks or frees a cell, which must be on the map.
    pub fn set(&mut self, cell: Cell, blocked: bool) {
        self.rows.set(cell.y, cell.x, blocked);
        self.columns.set(cell.x, cell.y, blocked);
    }

    /// Goes straight, east or west by `step`, from a free cell.
    pub(crate) fn along_row(&self, from: Cell, step: i32, goal: Cell) -> Scan {
        self.rows.scan(from.y, from.x, step > 0, (goal.y == from.y).then_some(goal.x))
    }

    /// Goes straight, north or south by `step`, from a free cell.
    pub(crate) fn along_column(&self, from: Cell, step: i32, goal: Cell) -> Scan {
        self.columns.scan(from.x, from.y, step > 0, (goal.x == from.x).then_some(goal.y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same, a cell at a time.
    fn plain(map: &Occupancy, from: Cell, (dx, dy): (i32, i32), goal: Cell) -> Option<Cell> {
        let mut at = from;
        loop {
            let next = at.offset(dx, dy);
            if map.blocked(next) {
                return None;
            }
            let forced = [1, -1].iter().any(|&s| {
                !map.blocked(next.offset(dy * s, dx * s)) && map.blocked(at.offset(dy * s, dx * s))
            });
            if next == goal || forced {
                return Some(next);
            }
            at = next;
        }
    }

    #[test]
    fn scans_stop_where_single_steps_would() {
        let mut state = 11_u32;
        let mut random = move |n: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % n
        };
        for round in 0..40 {
            let mut map = Occupancy::new(1 + random(300), 1 + random(200));
            for _ in 0..map.len() as u32 * (round % 5) / 40 {
                map.set(map.cell(random(map.len() as u32)), true);
            }
            let bits = Bits::new(&map);
            for _ in 0..500 {
                let (from, goal) = (map.cell(random(map.len() as u32)), map.cell(random(map.len() as u32)));
                if map.blocked(from) {
                    continue;
                }
                for goal in [goal, Cell::new(from.x, goal.y), Cell::new(goal.x, from.y)] {
                    for step in [1, -1] {
                        let row = bits.along_row(from, step, goal).jump.map(|x| Cell::new(x, from.y));
                        assert_eq!(row, plain(&map, from, (step, 0), goal));
                        let column = bits.along_column(from, step, goal).jump.map(|y| Cell::new(from.x, y));
                        assert_eq!(column, plain(&map, from, (0, step), goal));
                    }
                }
            }
        }
    }
}
