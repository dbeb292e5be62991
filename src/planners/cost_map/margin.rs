//! Proof that no path keeps a margin.
//!
//! Wherever the car passes, the middle of its body is at least the margin and half the width away from everything.
//! Cells in which no such place exists are closed, by an upper bound of the clearance of any place in a cell; if a
//! flood over the others does not join start and goal, no path keeps the margin. The converse does not hold: places
//! beside each other may need directions between which the car cannot turn.
//!
//! Cells are too coarse where a gap is about as wide as the car. Near obstacles a cell is therefore cut into 8 × 8
//! parts, one bit of a word each. A square of parts is closed where the room at its centre and half its diagonal are
//! together less than the room asked for, as no place has more room than another by more than their distance;
//! otherwise it is quartered. The flood spreads over words of bits, with shifts in the place of single steps.
//!
//! A single part is open only if the whole body keeps the margin there in some direction, which takes many measures.
//! So the flood first goes where the body is sure to fit, and looks at single parts when it has nowhere else to go: at
//! those that it touches nearest to the goal first, and thoroughly only when no quick look helps. Where the goal can be
//! reached few are looked at; which ones makes no difference to the answer.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::RoadRasters;
use crate::geometry::{Point, Vector};
use crate::map::Cell;

/// Parts of a cell in a row; their bits in a word are numbered row by row.
const PARTS: i32 = 8;
const ALL: u64 = u64::MAX;
/// Squares of fewer parts in a row are looked at part by part, when they are touched.
const COARSE: i32 = 4;
/// With so much more room than asked the body is not looked at, metres.
const AMPLE: f64 = 0.25;

/// Exact measures. A place is the middle of the body.
pub trait Exact {
    /// How far a place is from everything, metres.
    fn room(&self, place: Point) -> f64;
    /// True only if the body keeps the margin in one direction anywhere within a distance of a place.
    fn fits_around(&self, place: Point, reach: f64) -> bool;
    /// True only if the body keeps the margin somewhere in the square around a place with half this side; a quick look
    /// that may miss it.
    fn fits_easily(&self, place: Point, half: f64) -> bool;
    /// False only if the body keeps the margin nowhere in that square.
    fn may_fit(&self, place: Point, half: f64) -> bool;
}

/// True if every path of the car's middle from start to goal comes nearer to something than `room` metres, places
/// within `ends` metres of start and goal left out. `exact` measures a place.
///
/// Where the body keeps a margin, its middle keeps that margin and half the width. An eighth of a cell may hold such a
/// place unless its centre has less room by more than half its diagonal, for no place has more room than another by
/// more than what lies between them. What a flood over these parts, diagonals included, does not reach, no line through
/// places with that room does. It proves nothing where it reaches the goal.
pub fn is_excluded(
    ground: &RoadRasters,
    [start, goal]: [Point; 2],
    room: f64,
    ends: f64,
    exact: &dyn Exact,
) -> bool {
    let frame = &ground.frame;
    let [Some(first), Some(last)] = [start, goal].map(|end| frame.cell_at(end)) else { return false };
    let near = ends + frame.resolution;
    let parts = |cell: Cell| {
        let low = frame.center(cell) - Vector::repeat(frame.resolution / 2.0);
        Parts { low, side: frame.resolution / f64::from(PARTS), room, exact }
    };
    let known = |cell: Cell| {
        let (center, rough) = (frame.center(cell), ground.at(cell));
        let [open, unsure] = if rough >= room + AMPLE + frame.resolution
            || [start, goal].iter().any(|end| (center - end).norm() <= near)
        {
            [ALL, 0]
        } else if rough + ground.unsure < room {
            [0, 0]
        } else {
            parts(cell).holding([0, 0], PARTS)
        };
        Known { open, unsure, reached: 0 }
    };
    let mut met: BTreeMap<(i32, i32), Known> = BTreeMap::new();
    met.insert((first.x, first.y), Known { open: ALL, unsure: 0, reached: 0 });
    let mut open = vec![(first, ALL)];
    let mut touched = BinaryHeap::new();
    loop {
        while let Some((cell, entered)) = open.pop() {
            let entry = met.entry((cell.x, cell.y)).or_insert_with(|| known(cell));
            let reached = grown(entry.reached | entered & entry.open, entry.open);
            let asked = (entered | beside(reached)) & entry.unsure;
            entry.unsure &= !asked;
            let away = (cell.x - last.x).abs().max((cell.y - last.y).abs());
            for part in (0..PARTS * PARTS).filter(|part| asked >> part & 1 == 1) {
                let parts = parts(cell);
                let clearance = exact.room(parts.middle(part));
                if clearance + parts.reach(1) >= room {
                    let spare = (clearance * 1e6) as i64;
                    touched.push((Look::Quick, Reverse(away), spare, (cell.x, cell.y), part));
                }
            }
            if reached == entry.reached {
                continue;
            }
            entry.reached = reached;
            if cell == last {
                return false;
            }
            let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy)));
            for (dx, dy) in around.filter(|to| *to != (0, 0)) {
                let (next, entered) = (cell.offset(dx, dy), spilled(reached, dx, dy));
                if entered != 0 && frame.contains(next) {
                    open.push((next, entered));
                }
            }
        }
        let Some((look, away, spare, at, part)) = touched.pop() else { return true };
        let cell = Cell::new(at.0, at.1);
        let (middle, half) = (parts(cell).middle(part), frame.resolution / f64::from(2 * PARTS));
        if look == Look::Quick && !exact.fits_easily(middle, half) {
            touched.push((Look::Thorough, away, spare, at, part));
        } else if look == Look::Quick || exact.may_fit(middle, half) {
            met.entry(at).and_modify(|known| known.open |= 1 << part);
            open.push((cell, 1 << part));
        }
    }
}

/// How a part is looked at: all of them quickly before any thoroughly.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Look {
    Thorough,
    Quick,
}

/// What is known of a cell, a bit for each part.
struct Known {
    /// Parts that may hold a place with the room.
    open: u64,
    /// Parts that may, if a body fits, and that nothing has touched yet.
    unsure: u64,
    /// Open parts that the flood has reached.
    reached: u64,
}

/// A cell's parts.
struct Parts<'a> {
    /// The cell's lower left corner, world metres.
    low: Point,
    /// Side of a part, metres.
    side: f64,
    /// Distance that the middle of the body needs from everything, metres.
    room: f64,
    exact: &'a dyn Exact,
}

impl Parts<'_> {
    /// The middle of a part.
    fn middle(&self, part: i32) -> Point {
        let (x, y) = (part % PARTS, part / PARTS);
        self.low + Vector::new(f64::from(2 * x + 1), f64::from(2 * y + 1)) * (self.side / 2.0)
    }

    /// How far a place in a square of so many parts may be from its middle, metres.
    fn reach(&self, size: i32) -> f64 {
        f64::from(size) * self.side * core::f64::consts::FRAC_1_SQRT_2
    }

    /// Those of a square of `size` parts that are sure to hold a place with the room, and those that may.
    fn holding(&self, [x, y]: [i32; 2], size: i32) -> [u64; 2] {
        let middle =
            self.low + Vector::new(f64::from(2 * x + size), f64::from(2 * y + size)) * (self.side / 2.0);
        let (clearance, reach) = (self.exact.room(middle), self.reach(size));
        let row = ((1_u64 << size) - 1) << x;
        let all = (y..y + size).fold(0, |all, y| all | row << (PARTS * y));
        if clearance + reach < self.room {
            [0, 0]
        } else if clearance - reach >= self.room + AMPLE || self.exact.fits_around(middle, reach) {
            [all, 0]
        } else if size == COARSE {
            [0, all]
        } else {
            let half = size / 2;
            [[0, 0], [half, 0], [0, half], [half, half]].iter().fold([0, 0], |all, by| {
                let quarter = self.holding([x + by[0], y + by[1]], half);
                [all[0] | quarter[0], all[1] | quarter[1]]
            })
        }
    }
}

/// Bits of the first and of the last column.
const FIRST: u64 = 0x0101_0101_0101_0101;
const LAST: u64 = FIRST << 7;

/// The bits and those beside them in their rows.
fn widened(bits: u64) -> u64 {
    bits | (bits & !LAST) << 1 | (bits & !FIRST) >> 1
}

/// The bits and those beside them.
fn beside(bits: u64) -> u64 {
    let rows = widened(bits);
    rows | rows << 8 | rows >> 8
}

/// What can be reached from some bits over the `free` ones.
fn grown(mut bits: u64, free: u64) -> u64 {
    loop {
        let next = bits | beside(bits) & free;
        if next == bits {
            return bits;
        }
        bits = next;
    }
}

/// The bits of the cell (dx, dy) beside this one that bits of this one touch.
fn spilled(bits: u64, dx: i32, dy: i32) -> u64 {
    let column = match dx {
        0 => bits,
        1 => (bits & LAST) >> 7,
        _ => (bits & FIRST) << 7,
    };
    match dy {
        0 => column | column << 8 | column >> 8,
        1 if dx == 0 => widened(column) >> 56,
        1 => column >> 56,
        _ if dx == 0 => widened(column) << 56,
        _ => column << 56,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::generate::SplitMix64;

    #[test]
    fn bits_touch_as_squares_do() {
        let mut random = SplitMix64::new(4);
        let touches = |a: (i32, i32), b: (i32, i32)| (a.0 - b.0).abs() <= 1 && (a.1 - b.1).abs() <= 1;
        let places = |bits: u64| (0..64).filter(move |i| bits >> i & 1 == 1).map(|i| (i % 8, i / 8));
        for _ in 0..500 {
            let bits = random.next() & random.next() & random.next();
            for (dx, dy) in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))) {
                let beside = |i: i32| (i % 8 + 8 * dx, i / 8 + 8 * dy);
                let expected = (0..64).filter(|&i| places(bits).any(|place| touches(place, beside(i))));
                let expected = expected.fold(0_u64, |all, i| all | 1 << i);
                if (dx, dy) == (0, 0) {
                    assert_eq!(grown(bits, expected) & expected, expected);
                } else {
                    assert_eq!(spilled(bits, dx, dy), expected, "{bits:x} {dx} {dy}");
                }
            }
        }
        assert_eq!(grown(1, !0x0200), ALL & !0x0200);
        // Diagonal steps count, a whole row that is closed does not let through.
        assert_eq!(grown(1, 0x55AA_55AA_55AA_55AA), 0x55AA_55AA_55AA_55AB);
        assert_eq!(grown(1, !0xFF00), 0xFF);
    }
}
