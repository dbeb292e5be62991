//! Bitmaps for jump point search: the cells at which straight jumps stop, read 64 at a time, and the directions in
//! which jumps lead anywhere.
//!
//! A straight jump ends at the first cell that is blocked or stands beside the end of a wall. Along a row these cells
//! are bits, so the next stop is found by counting zeros: 64 cells for one instruction. Columns have bits of their
//! own, because a jump north would otherwise read a word for each cell; going back has others than going on, because
//! a wall ends for only one of the two. That is four bits a cell.
//!
//! An edit renews the bits of nine cells; directions along its row and column follow as far as they change.

use super::jump_directions::Ways;
use super::{Cell, Occupancy};

/// The stopping points of jumps over a map. Everything outside the map is a wall.
#[derive(Debug, Clone)]
pub struct Bits {
    /// Going east, north, west and south.
    lines: [Lines; 4],
    ways: Ways,
}

impl Bits {
    /// Bytes held.
    pub fn bytes(&self) -> usize {
        self.lines.iter().map(|lines| size_of_val(&lines.stops[..])).sum::<usize>() + self.ways.bytes()
    }
}

/// The rows or columns of a map in one direction.
#[derive(Debug, Clone)]
struct Lines {
    /// Cells of one line.
    length: u32,
    /// Words of one line.
    words: usize,
    /// Stops of jumps along each line: blocked cells, cells beside the end of a wall, and the place after the last
    /// cell.
    stops: Vec<u64>,
}

impl Lines {
    fn new(lines: u32, length: u32) -> Self {
        let words = length as usize / 64 + 1;
        Self { length, words, stops: vec![u64::MAX; words * lines as usize] }
    }

    fn set(&mut self, line: u32, at: u32, stops: bool) {
        let word = &mut self.stops[line as usize * self.words + at as usize / 64];
        let bit = 1 << (at % 64);
        *word = if stops { *word | bit } else { *word & !bit };
    }

    /// The number of steps along a line from a cell to the first stop.
    #[inline]
    fn scan(&self, line: u32, at: u32) -> u32 {
        let next = at + 1;
        let mut word = line as usize * self.words + next as usize / 64;
        let mut stops = self.stops[word] >> (next % 64);
        let mut steps = 1;
        if stops == 0 {
            steps += 64 - next % 64;
            word += 1;
            stops = self.stops[word];
            while stops == 0 {
                steps += 64;
                word += 1;
                stops = self.stops[word];
            }
        }
        steps + stops.trailing_zeros()
    }
}

impl Bits {
    /// The bits of a map.
    pub fn new(map: &Occupancy) -> Self {
        let (width, height) = (map.width(), map.height());
        let (rows, columns) = (Lines::new(height, width), Lines::new(width, height));
        let lines = [rows.clone(), columns.clone(), rows, columns];
        let mut bits = Self { lines, ways: Ways::new(map) };
        for index in 0..map.len() as u32 {
            bits.sync(map, map.cell(index));
        }
        bits
    }

    /// Brings all up to date after a cell of the map was blocked or freed.
    pub fn follow(&mut self, map: &Occupancy, changed: Cell) {
        for (dx, dy) in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))) {
            let cell = changed.offset(dx, dy);
            if map.contains(cell) {
                self.sync(map, cell);
            }
        }
        self.ways.follow(map, changed);
    }

    /// Brings the stops at a cell up to date.
    fn sync(&mut self, map: &Occupancy, cell: Cell) {
        let stops = if map.blocked(cell) { u8::MAX } else { ends(map.free_around(cell)) };
        for quarter in 0..4 {
            let (line, at) = self.place(cell, quarter);
            self.lines[quarter as usize].set(line, at, stops >> (2 * quarter) & 1 == 1);
        }
    }

    /// The line of a cell, and its place there, as seen in a direction: 0 east, 1 north, 2 west, 3 south.
    #[inline]
    fn place(&self, cell: Cell, quarter: u32) -> (u32, u32) {
        let (x, y) = (cell.x as u32, cell.y as u32);
        let (line, at) = if quarter.is_multiple_of(2) { (y, x) } else { (x, y) };
        let last = self.lines[quarter as usize % 4].length - 1;
        (line, if quarter < 2 { at } else { last - at })
    }

    /// The directions in which a jump from a cell leads anywhere, the goal aside: bit c for the c-th of E, NE, N, NW,
    /// W, SW, S, SE.
    #[inline]
    pub(crate) fn ways(&self, from: Cell) -> u8 {
        self.ways.at(from)
    }

    /// The number of steps straight from a cell to the first wall or forced turn: 0 east, 1 north, 2 west, 3 south.
    #[inline]
    pub(crate) fn straight(&self, from: Cell, quarter: u32) -> u32 {
        let (line, at) = self.place(from, quarter);
        self.lines[quarter as usize % 4].scan(line, at)
    }
}

/// Directions that have a forced neighbour here, given the free neighbours of a free cell.
const fn ends(free: u8) -> u8 {
    let (left, right) = (free.rotate_right(2), free.rotate_left(2));
    let (left_behind, right_behind) = (free.rotate_right(3), free.rotate_left(3));
    left & !left_behind | right & !right_behind
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIRECTIONS: [(i32, i32); 8] =
        [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];

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
                bits.follow(&map, cell);
            }
            for _ in 0..500 {
                let from = map.cell(random(map.len() as u32));
                if map.blocked(from) {
                    continue;
                }
                for (direction, &step) in DIRECTIONS.iter().enumerate() {
                    let leads = bits.ways(from) >> direction & 1 == 1;
                    let (dx, dy) = step;
                    let legal = !map.blocked(from.offset(dx, 0))
                        && !map.blocked(from.offset(0, dy))
                        && !map.blocked(from.offset(dx, dy));
                    let free = if dx * dy == 0 { !plain(&map, from, step).1 } else { legal };
                    assert_eq!(leads, free, "{from:?} {step:?}");
                }
                for (quarter, (dx, dy)) in [(1, 0), (0, 1), (-1, 0), (0, -1)].into_iter().enumerate() {
                    let steps = bits.straight(from, quarter as u32) as i32;
                    assert_eq!(from.offset(dx * steps, dy * steps), plain(&map, from, (dx, dy)).0);
                }
            }
        }
    }
}
