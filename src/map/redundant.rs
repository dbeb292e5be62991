//! Redundant safety space: free cells that a car had better not enter (Hu et al. 2024, 2.2).
//!
//! Passages too narrow for a block of cells, and pockets with a single mouth, are closed; what start and goal need is
//! given back. It is a soft measure: such cells are free for collision and clearance.
//!
//! Three steps, each linear in the cells but the last:
//!
//! 1. a cell that no free square of `min_passage` cells covers is narrow (a morphological opening);
//! 2. of the rest, a connected part that no square of `trap_mouth` cells covers, and that touches the open part in
//!    one place at most, is a pocket;
//! 3. where start and goal are now apart, the cheapest way that opens the fewest closed cells is found, and the parts
//!    that it crosses are given back. O(n·log n).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::{Cell, Occupancy};
use crate::geometry::math;

const SIDES: [(i32, i32); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

/// Sizes that count as too narrow, in cells; 1 switches a measure off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RedundantSettings {
    /// Side of the square that must fit through a passage.
    pub min_passage: u32,
    /// Side of the square that must fit into a place for it not to be a pocket.
    pub trap_mouth: u32,
}

impl Default for RedundantSettings {
    fn default() -> Self {
        Self { min_passage: 2, trap_mouth: 5 }
    }
}

/// The result of closing narrow passages and pockets.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Redundant {
    /// The map with redundant cells blocked.
    pub map: Occupancy,
    /// Cells closed because they are too narrow.
    pub narrow: u32,
    /// Cells closed because they are in a pocket.
    pub pocket: u32,
    /// Closed cells that were given back to connect start and goal.
    pub restored: u32,
}

/// Closes narrow passages and pockets of `map` (necessary space already blocked). Cells around start and goal stay
/// open, and start and goal stay connected if they were.
pub fn redundant(map: &Occupancy, start: Cell, goal: Cell, settings: RedundantSettings) -> Redundant {
    let protected = |cell: Cell| {
        [start, goal].iter().any(|end| (cell.x - end.x).abs() <= 1 && (cell.y - end.y).abs() <= 1)
    };
    let mut closed = map.clone();
    let passable = opened(map, settings.min_passage);
    let mut narrow = 0;
    for cell in cells(map).filter(|&c| !map.blocked(c) && passable.blocked(c) && !protected(c)) {
        closed.set(cell, true);
        narrow += 1;
    }
    let core = opened(&closed, settings.trap_mouth);
    let mut pocket = 0;
    for component in components(map, |c| !closed.blocked(c) && core.blocked(c)) {
        if !component.iter().any(|&c| protected(c)) && mouths(&component, &core) <= 1 {
            pocket += component.len() as u32;
            for c in component {
                closed.set(c, true);
            }
        }
    }
    let mut restored = 0;
    if map.connected(start, goal) && !closed.connected(start, goal) {
        let way = cheapest_way(map, &closed, start, goal);
        for component in components(map, |c| closed.blocked(c) && !map.blocked(c)) {
            if component.iter().any(|c| way.contains(c)) {
                restored += component.len() as u32;
                for c in component {
                    closed.set(c, false);
                }
            }
        }
    }
    Redundant { map: closed, narrow, pocket, restored }
}

fn cells(map: &Occupancy) -> impl Iterator<Item = Cell> {
    (0..map.len() as u32).map(|index| map.cell(index))
}

/// The map in which only those cells are free that a free `side` × `side` square within the map contains.
fn opened(map: &Occupancy, side: u32) -> Occupancy {
    let side = side as i32;
    let (width, height) = (map.width() as i32, map.height() as i32);
    let blocked = Counts::new(map, |c| map.blocked(c));
    let fits = |c: Cell| {
        c.x + side <= width && c.y + side <= height && blocked.within(c, c.offset(side - 1, side - 1)) == 0
    };
    let squares = Counts::new(map, fits);
    let mut opened = Occupancy::new(map.width(), map.height());
    for cell in cells(map) {
        opened.set(cell, squares.within(cell.offset(1 - side, 1 - side), cell) == 0);
    }
    opened
}

/// How many cells of any rectangle have a property.
struct Counts {
    stride: usize,
    sums: Vec<u32>,
}

impl Counts {
    /// Sums over all rectangles from the map's corner (Crow 1984), so that any rectangle takes four look-ups.
    fn new(map: &Occupancy, property: impl Fn(Cell) -> bool) -> Self {
        let stride = map.width() as usize + 1;
        let mut sums = vec![0; stride * (map.height() as usize + 1)];
        for cell in cells(map) {
            let at = (cell.y as usize + 1) * stride + cell.x as usize + 1;
            sums[at] = sums[at - 1] + sums[at - stride] + u32::from(property(cell)) - sums[at - stride - 1];
        }
        Self { stride, sums }
    }

    /// Both corners count; `low` may be outside to the south or west.
    fn within(&self, low: Cell, high: Cell) -> u32 {
        let (x0, y0) = (low.x.max(0) as usize, low.y.max(0) as usize);
        let (x1, y1) = (high.x as usize + 1, high.y as usize + 1);
        let sum = |x: usize, y: usize| self.sums[y * self.stride + x];
        sum(x1, y1) + sum(x0, y0) - sum(x0, y1) - sum(x1, y0)
    }
}

/// The groups of edge-sharing cells with a property.
fn components(map: &Occupancy, property: impl Fn(Cell) -> bool) -> Vec<Vec<Cell>> {
    let mut seen = vec![false; map.len()];
    let mut fresh = |c: Cell| {
        map.contains(c) && property(c) && !std::mem::replace(&mut seen[map.index(c) as usize], true)
    };
    let mut components = Vec::new();
    for first in cells(map) {
        if !fresh(first) {
            continue;
        }
        let mut component = vec![first];
        let mut next = 0;
        while let Some(&at) = component.get(next) {
            next += 1;
            component.extend(SIDES.iter().map(|&(dx, dy)| at.offset(dx, dy)).filter(|&c| fresh(c)));
        }
        components.push(component);
    }
    components
}

/// How many separate places of the core a component borders on; core cells that share a corner belong together.
fn mouths(component: &[Cell], core: &Occupancy) -> usize {
    let beside = component.iter().flat_map(|c| SIDES.map(|(dx, dy)| c.offset(dx, dy)));
    let mut left: Vec<Cell> = beside.filter(|&c| !core.blocked(c)).collect();
    left = math::sorted_by(&left, |c| f64::from(c.x) * 65536.0 + f64::from(c.y));
    left.dedup();
    let mut clusters = 0;
    while let Some(first) = left.pop() {
        clusters += 1;
        let mut stack = vec![first];
        while let Some(at) = stack.pop() {
            for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
                if let Ok(found) = left.binary_search(&at.offset(dx, dy)) {
                    stack.push(left.remove(found));
                }
            }
        }
    }
    clusters
}

/// The cells of the way over the open map that enters the fewest closed cells, then takes the fewest steps.
fn cheapest_way(open: &Occupancy, closed: &Occupancy, start: Cell, goal: Cell) -> Vec<Cell> {
    let mut best = vec![(u32::MAX, u32::MAX); open.len()];
    let mut parent = vec![start; open.len()];
    let mut queue = BinaryHeap::from([Reverse((0, 0, open.index(start)))]);
    best[open.index(start) as usize] = (0, 0);
    while let Some(Reverse((entered, steps, index))) = queue.pop() {
        let at = open.cell(index);
        if at == goal {
            break;
        }
        if best[index as usize] < (entered, steps) {
            continue;
        }
        for (dx, dy) in SIDES {
            let to = at.offset(dx, dy);
            if open.blocked(to) {
                continue;
            }
            let key = (entered + u32::from(closed.blocked(to)), steps + 1);
            let target = open.index(to) as usize;
            if key < best[target] {
                best[target] = key;
                parent[target] = at;
                queue.push(Reverse((key.0, key.1, target as u32)));
            }
        }
    }
    let mut way = vec![goal];
    let mut at = goal;
    while at != start {
        at = parent[open.index(at) as usize];
        way.push(at);
    }
    way
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_narrow_side_street_closes_and_a_needed_one_is_given_back() {
        let map = Occupancy::parse("....#....\n....#....\n.........\n....#....\n....#....");
        let ends = (Cell::new(0, 0), Cell::new(8, 4));
        let settings = RedundantSettings { min_passage: 2, trap_mouth: 1 };
        let kept = redundant(&map, ends.0, ends.1, settings);
        assert_eq!((kept.narrow, kept.pocket, kept.restored), (1, 0, 1));
        assert_eq!(kept.map, map);
        let closed = redundant(&map, ends.0, Cell::new(0, 4), settings);
        assert_eq!((closed.narrow, closed.restored), (1, 0));
        assert!(closed.map.blocked(Cell::new(4, 2)));
    }

    #[test]
    fn a_pocket_closes_unless_the_goal_is_in_it() {
        let map = Occupancy::parse(
            ".........\n..#####..\n..#...#..\n..#...#..\n.........\n.........\n.........\n.........",
        );
        let settings = RedundantSettings { min_passage: 1, trap_mouth: 4 };
        let closed = redundant(&map, Cell::new(0, 0), Cell::new(8, 0), settings);
        assert!(closed.map.blocked(Cell::new(4, 5)) && !closed.map.blocked(Cell::new(4, 2)));
        let kept = redundant(&map, Cell::new(0, 0), Cell::new(4, 5), settings);
        assert!(!kept.map.blocked(Cell::new(3, 4)));
    }
}
