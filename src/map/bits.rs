//! A map as bits, 64 cells a word, by rows and by columns: scanning a row looks at up to 64 cells at once.

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
    bits: Vec<Word>,
}

/// 64 cells of a line.
#[derive(Debug, Clone, Copy)]
struct Word {
    blocked: u64,
    /// Where one who comes from lower numbers stops: blocked cells, and those beside which a wall ends.
    rising: u64,
    /// The same for one who comes from higher numbers.
    falling: u64,
}

impl Lines {
    fn new(lines: u32, length: u32) -> Self {
        let words = (length as usize).div_ceil(64) + 3;
        let wall = Word { blocked: u64::MAX, rising: u64::MAX, falling: u64::MAX };
        Self { words, bits: vec![wall; words * (lines as usize + 2)] }
    }

    /// Blocks or frees a cell; stops are behind then.
    fn set(&mut self, line: i32, at: i32, blocked: bool) {
        let bit = at as usize + PAD;
        let word = &mut self.bits[(line + 1) as usize * self.words + bit / 64].blocked;
        *word = if blocked { *word | 1 << (bit % 64) } else { *word & !(1 << (bit % 64)) };
    }

    /// Brings the stops of all words up to date.
    fn settle(&mut self) {
        for index in self.words + 1..self.bits.len() - self.words - 1 {
            self.settle_word(index);
        }
    }

    /// Brings the stops around a cell up to date.
    fn settle_around(&mut self, line: i32, at: i32) {
        let (lines, bit) = ((self.bits.len() / self.words) as i32 - 2, at as usize + PAD);
        for line in (line - 1).max(0)..=(line + 1).min(lines - 1) {
            // The first word is all wall, as it was made.
            for word in ((bit - 1) / 64).max(1)..=(bit + 1) / 64 {
                self.settle_word((line + 1) as usize * self.words + word);
            }
        }
    }

    fn settle_word(&mut self, index: usize) {
        let here = self.bits[index].blocked;
        let (mut rising, mut falling) = (here, here);
        for beside in [index - self.words, index + self.words] {
            let [before, wall, after] = [beside - 1, beside, beside + 1].map(|k| self.bits[k].blocked);
            rising |= !wall & (wall << 1 | before >> 63);
            falling |= !wall & (wall >> 1 | after << 63);
        }
        self.bits[index] = Word { blocked: here, rising, falling };
    }

    /// Goes along a line from the free cell `at` until a forced turn or a wall.
    #[inline]
    fn scan(&self, line: i32, at: i32, forward: bool) -> Stop {
        let start = (line + 1) as usize * self.words;
        let line = &self.bits[start..start + self.words];
        let end = if forward { rise(line, at) } else { fall(line, at) };
        let wall = line[end / 64].blocked >> (end % 64) & 1 == 1;
        Stop { at: end as i32 - PAD as i32, wall }
    }
}

/// The bit of the first stop after a cell.
#[inline]
fn rise(line: &[Word], at: i32) -> usize {
    let from = at as usize + PAD + 1;
    let first = line[from / 64].rising >> (from % 64);
    if first != 0 {
        return from + first.trailing_zeros() as usize;
    }
    let mut word = from / 64 + 1;
    while line[word].rising == 0 {
        word += 1;
    }
    64 * word + line[word].rising.trailing_zeros() as usize
}

/// The bit of the first stop before a cell.
#[inline]
fn fall(line: &[Word], at: i32) -> usize {
    let from = at as usize + PAD - 1;
    let first = line[from / 64].falling << (63 - from % 64);
    if first != 0 {
        return from - first.leading_zeros() as usize;
    }
    let mut word = from / 64 - 1;
    while line[word].falling == 0 {
        word -= 1;
    }
    64 * word + 63 - line[word].falling.leading_zeros() as usize
}

/// Where one who goes straight stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Stop {
    /// The column or row.
    pub(crate) at: i32,
    /// Whether the cell is blocked; else it has a forced turn.
    pub(crate) wall: bool,
}

impl Bits {
    /// The bits of a map.
    pub fn new(map: &Occupancy) -> Self {
        let (width, height) = (map.width(), map.height());
        let mut bits = Self { rows: Lines::new(height, width), columns: Lines::new(width, height) };
        for y in 0..height {
            for (x, _) in map.row(y).iter().enumerate().filter(|&(_, &blocked)| blocked == 0) {
                bits.rows.set(y as i32, x as i32, false);
                bits.columns.set(x as i32, y as i32, false);
            }
        }
        bits.rows.settle();
        bits.columns.settle();
        bits
    }

    /// Blocks or frees a cell, which must be on the map.
    pub fn set(&mut self, cell: Cell, blocked: bool) {
        self.rows.set(cell.y, cell.x, blocked);
        self.rows.settle_around(cell.y, cell.x);
        self.columns.set(cell.x, cell.y, blocked);
        self.columns.settle_around(cell.x, cell.y);
    }

    /// Goes straight, east or west, from a free cell.
    #[inline]
    pub(crate) fn along_row(&self, from: Cell, east: bool) -> Stop {
        self.rows.scan(from.y, from.x, east)
    }

    /// Goes straight, north or south, from a free cell.
    #[inline]
    pub(crate) fn along_column(&self, from: Cell, north: bool) -> Stop {
        self.columns.scan(from.x, from.y, north)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same, a cell at a time.
    fn plain(map: &Occupancy, from: Cell, (dx, dy): (i32, i32)) -> (Cell, bool) {
        let mut at = from;
        loop {
            let next = at.offset(dx, dy);
            let forced = [1, -1].iter().any(|&s| {
                !map.blocked(next.offset(dy * s, dx * s)) && map.blocked(at.offset(dy * s, dx * s))
            });
            if map.blocked(next) || forced {
                return (next, map.blocked(next));
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
            let mut bits = Bits::new(&map);
            for _ in 0..random(100) {
                let cell = map.cell(random(map.len() as u32));
                map.set(cell, random(2) == 0);
                bits.set(cell, map.blocked(cell));
            }
            for _ in 0..500 {
                let from = map.cell(random(map.len() as u32));
                if map.blocked(from) {
                    continue;
                }
                for step in [1, -1] {
                    let row = bits.along_row(from, step > 0);
                    assert_eq!((Cell::new(row.at, from.y), row.wall), plain(&map, from, (step, 0)));
                    let column = bits.along_column(from, step > 0);
                    assert_eq!((Cell::new(from.x, column.at), column.wall), plain(&map, from, (0, step)));
                }
            }
        }
    }
}
