//! Leaving out cells that a path does not need.

use crate::map::{Cell, Corner, Occupancy, first_in_sight, line_of_sight};

/// Leaves out, in one pass, every cell that the last kept one need not pass to see the next (Hu et al. 2024, 5.1).
///
/// Start and goal stay; the path never gets longer.
pub fn prune(map: &Occupancy, path: &[Cell], corner: Corner) -> Vec<Cell> {
    let [first, .., last] = path else { return path.to_vec() };
    let mut kept = vec![*first];
    let mut anchor = *first;
    for pair in path[1..].windows(2) {
        let (b, c) = (pair[0], pair[1]);
        if !goes_straight(anchor, b, c) && !line_of_sight(map, anchor, c, corner) {
            kept.push(b);
            anchor = b;
        }
    }
    kept.push(*last);
    kept
}

fn goes_straight(a: Cell, b: Cell, c: Cell) -> bool {
    let (ux, uy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
    let (vx, vy) = (i64::from(c.x - b.x), i64::from(c.y - b.y));
    ux * vy == uy * vx && ux * vx + uy * vy > 0
}

/// The shortest way over the path's own cells, every cell of its long moves included.
///
/// Takes time quadratic in the length of the path. What hid a cell from another one mostly hides it from the next one
/// too: that cell is looked at first, and only where it is out of the way the whole line.
pub fn prune_dp(map: &Occupancy, path: &[Cell], corner: Corner) -> Vec<Cell> {
    let points = unit_steps(path);
    let mut best = vec![(f64::INFINITY, 0_usize); points.len()];
    let mut screens: Vec<Option<Cell>> = vec![None; points.len()];
    if let Some(first) = best.first_mut() {
        first.0 = 0.0;
    }
    for j in 1..points.len() {
        let mut latest = None;
        for i in 0..j {
            let length = best[i].0 + distance(points[i], points[j]);
            if length >= best[j].0 - 1e-12 {
                continue;
            }
            let hidden = |screen: Option<Cell>| screen.is_some_and(|c| passes(points[j], points[i], c));
            if hidden(screens[i]) {
                continue;
            }
            if hidden(latest) {
                screens[i] = latest;
                continue;
            }
            let screen = first_in_sight(map, points[j], points[i], corner);
            if screen.is_none() {
                best[j] = (length, i);
            } else {
                // A free cell stands for a corner that no other line passes.
                latest = screen.filter(|&c| map.blocked(c));
                screens[i] = latest;
            }
        }
    }
    let mut kept: Vec<Cell> = points.last().copied().into_iter().collect();
    let mut at = points.len().saturating_sub(1);
    while at > 0 {
        at = best[at].1;
        kept.push(points[at]);
    }
    kept.reverse();
    kept
}

/// Whether the segment between two cell centres passes through the inside of a third cell's square.
fn passes(from: Cell, to: Cell, cell: Cell) -> bool {
    let within = |v: i32, a: i32, b: i32| v >= a.min(b) && v <= a.max(b);
    if !within(cell.x, from.x, to.x) || !within(cell.y, from.y, to.y) {
        return false;
    }
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    // Twice the cell's centre's distance from the line, against the farthest one of its corners.
    let aside = 2 * (dx * (cell.y - from.y) - dy * (cell.x - from.x));
    aside.abs() < dx.abs() + dy.abs()
}

/// The path with every move that passes over cell centres cut there.
fn unit_steps(path: &[Cell]) -> Vec<Cell> {
    let mut points: Vec<Cell> = path.first().copied().into_iter().collect();
    for pair in path.windows(2) {
        let (dx, dy) = (pair[1].x - pair[0].x, pair[1].y - pair[0].y);
        let parts = gcd(dx.abs(), dy.abs()).max(1);
        points.extend((1..=parts).map(|k| pair[0].offset(dx / parts * k, dy / parts * k)));
    }
    points
}

const fn gcd(a: i32, b: i32) -> i32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn distance(a: Cell, b: Cell) -> f64 {
    let (dx, dy) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const STAIRS: [Cell; 5] =
        [Cell::new(0, 0), Cell::new(1, 0), Cell::new(1, 1), Cell::new(2, 1), Cell::new(2, 2)];

    #[test]
    fn stairs_become_a_line_where_nothing_is_in_the_way() {
        let map = Occupancy::new(3, 3);
        let ends = [STAIRS[0], STAIRS[4]];
        assert_eq!(prune(&map, &STAIRS, Corner::Strict), ends);
        assert_eq!(prune_dp(&map, &STAIRS, Corner::Strict), ends);
    }

    #[test]
    fn a_blocked_corner_keeps_its_cell() {
        let map = Occupancy::parse("...\n...\n#..\n...");
        let path = [Cell::new(0, 0), Cell::new(1, 0), Cell::new(1, 1), Cell::new(1, 2), Cell::new(0, 2)];
        let around = [Cell::new(0, 0), Cell::new(1, 0), Cell::new(1, 2), Cell::new(0, 2)];
        assert_eq!(prune(&map, &path, Corner::Strict), around);
        assert_eq!(prune_dp(&map, &path, Corner::Strict), around);
    }

    #[test]
    fn a_cell_that_is_passed_is_in_sight() {
        let (from, corner) = (Cell::new(4, 5), Corner::Strict);
        for (to, index) in (0..100).flat_map(|to| (0..100).map(move |i| (to, i))) {
            let mut map = Occupancy::new(10, 10);
            let (to, cell) = (map.cell(to), map.cell(index));
            map.set(cell, true);
            let seen = line_of_sight(&map, from, to, corner);
            assert!(!(passes(from, to, cell) && seen), "{to:?} {cell:?}");
            // Without corners to touch, the two are the same.
            let hidden = !line_of_sight(&map, from, to, Corner::Free);
            assert!(from == to || passes(from, to, cell) == hidden);
        }
    }

    /// As specified, with nothing clever in it.
    fn plain_dp(map: &Occupancy, path: &[Cell], corner: Corner) -> Vec<Cell> {
        let points = unit_steps(path);
        let mut best = vec![(f64::INFINITY, 0); points.len()];
        best[0].0 = 0.0;
        for j in 1..points.len() {
            for i in 0..j {
                let length = best[i].0 + distance(points[i], points[j]);
                if length < best[j].0 - 1e-12 && line_of_sight(map, points[i], points[j], corner) {
                    best[j] = (length, i);
                }
            }
        }
        let (mut at, mut kept) = (points.len() - 1, vec![points[points.len() - 1]]);
        while at > 0 {
            at = best[at].1;
            kept.push(points[at]);
        }
        kept.reverse();
        kept
    }

    #[test]
    fn the_quick_way_is_the_plain_one() {
        use crate::scenario::generate::{Family, SplitMix64, occupancy};
        let mut random = SplitMix64::new(5);
        for seed in 1..=12 {
            let map = occupancy(Family::RANDOM, 40, seed).unwrap();
            for corner in [Corner::Strict, Corner::NoSqueeze, Corner::Free] {
                // A walk that wanders, steps of the corner rule's own.
                let mut path = vec![Cell::new(0, 0)];
                while path.len() < 300 {
                    let at = path[path.len() - 1];
                    let to = at.offset(random.below(3) as i32 - 1, random.below(3) as i32 - 1);
                    if to != at && line_of_sight(&map, at, to, corner) {
                        path.push(to);
                    }
                }
                assert_eq!(prune_dp(&map, &path, corner), plain_dp(&map, &path, corner));
            }
        }
    }

    #[test]
    fn short_paths_stay() {
        let map = Occupancy::new(3, 3);
        for n in 0..=2 {
            assert_eq!(prune(&map, &STAIRS[..n], Corner::Strict), STAIRS[..n]);
            assert_eq!(prune_dp(&map, &STAIRS[..n], Corner::Strict), STAIRS[..n]);
        }
    }
}
