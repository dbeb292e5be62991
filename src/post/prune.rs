//! Leaving out cells that a path does not need.
//!
//! [`prune`] walks along the path once. From the last cell kept it skips every cell whose successor it still sees;
//! it is greedy, and may therefore miss the shortest way. [`prune_dp`] looks at all pairs of cells: `best(j) = min
//! over i < j that see j of best(i) + |ij|`. It takes quadratic time at worst.
//!
//! Sight means that every cell which the segment between two centres passes is free, with the same rule for corners
//! ([`Corner`]) as the planner's moves; so a pruned path is valid wherever the raw one was.

use crate::map::{Cell, Corner, Occupancy, first_in_sight, line_of_sight};

/// Leaves out, in one pass, every cell that the last kept one need not pass to see the next (Hu et al. 2024, 5.1).
///
/// Start and goal stay; the path never gets longer, nor dearer where cells have weights.
///
/// Takes one line-of-sight test per cell, each linear in the distance to the last kept cell. Paths of fewer than two
/// cells are answered as they are.
pub fn prune(map: &Occupancy, path: &[Cell], corner: Corner) -> Vec<Cell> {
    let [first, .., last] = path else { return path.to_vec() };
    let mut kept = vec![*first];
    let mut anchor = *first;
    let step = |a, b| map.weights().map_or(0, |weights| weights.cost(a, b));
    // What the path costs from the anchor on.
    let mut spent = step(anchor, path[1]);
    for pair in path[1..].windows(2) {
        let (b, c) = (pair[0], pair[1]);
        let on = step(b, c);
        let direct = || line_of_sight(map, anchor, c, corner) && step(anchor, c) <= spent + on;
        if goes_straight(anchor, b, c) || direct() {
            spent += on;
        } else {
            kept.push(b);
            (anchor, spent) = (b, on);
        }
    }
    kept.push(*last);
    kept
}

/// True if the way from a to b and the way from b to c have the same direction, in exact integers.
fn goes_straight(a: Cell, b: Cell, c: Cell) -> bool {
    let (ux, uy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
    let (vx, vy) = (i64::from(c.x - b.x), i64::from(c.y - b.y));
    ux * vy == uy * vx && ux * vx + uy * vy > 0
}

/// The shortest way over the path's own cells, every cell of its long moves included; the cheapest where cells have
/// weights.
///
/// Takes time quadratic in the length of the path at worst. What hid a cell from another one mostly hides it from the
/// next one too: that is looked at first, and only where it is out of the way the whole line.
///
/// The result costs no more than that of [`prune`], except for rounding: a new predecessor has to save 1e-12 cells.
/// Ties keep the earliest predecessor, so equal input gives equal cells.
///
/// With weights the cost of a segment is its length times the mean weight of the cells it passes.
///
/// # Examples
/// ```
/// use parkade::map::{Cell, Corner, Occupancy};
/// use parkade::post::prune_dp;
///
/// let map = Occupancy::new(9, 9);
/// let detour = [Cell::new(0, 0), Cell::new(4, 4), Cell::new(8, 0)];
/// assert_eq!(prune_dp(&map, &detour, Corner::Strict), [detour[0], detour[2]]);
/// ```
pub fn prune_dp(map: &Occupancy, path: &[Cell], corner: Corner) -> Vec<Cell> {
    let points = unit_steps(path);
    let mut best = vec![(f64::INFINITY, 0_usize); points.len()];
    let mut screens: Vec<Option<Screen>> = vec![None; points.len()];
    if let Some(first) = best.first_mut() {
        first.0 = 0.0;
    }
    let ends = straight_ends(&points);
    let mean = |a, b| {
        map.weights().map_or(1.0, |weights| {
            let (above, below) = weights.mean(a, b);
            above as f64 / below as f64
        })
    };
    for j in 1..points.len() {
        let (mut latest, mut i) = (None, 0);
        while i < j {
            let at = i;
            i += 1;
            let length = best[at].0 + distance(points[at], points[j]) * mean(points[at], points[j]);
            if length >= best[j].0 - 1e-12 {
                continue;
            }
            let hides = |i: usize, screen: Screen| screen.hides(points[j], points[i]);
            let known = [screens[at], latest].into_iter().flatten().find(|&screen| hides(at, screen));
            if let Some(screen) = known {
                screens[at] = known;
                // A screen that hides both ends of a straight way hides all of it.
                let mut end = ends[at].min(j - 1);
                while end > at && !hides(end, screen) {
                    end = usize::midpoint(at, end);
                }
                i = end + 1;
                continue;
            }
            let screen = first_in_sight(map, points[j], points[at], corner);
            if screen.is_none() {
                best[j] = (length, at);
            } else {
                // A free cell stands for a corner that no other line passes.
                latest = screen.filter(|&c| map.blocked(c)).map(|c| Screen::around(map, c));
                screens[at] = latest;
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

/// Per point, the last one straight ahead.
fn straight_ends(points: &[Cell]) -> Vec<usize> {
    let mut ends: Vec<usize> = (0..points.len()).collect();
    for i in (0..points.len().saturating_sub(1)).rev() {
        let goes_on = points.get(i + 2).is_some_and(|&c| goes_straight(points[i], points[i + 1], c));
        ends[i] = if goes_on { ends[i + 1] } else { i + 1 };
    }
    ends
}

/// How far a screen reaches from its first cell, cells.
const REACH: i32 = 32;

/// Blocked cells in a row or column.
///
/// `low` and `high` are its first and last cell. A screen that hides one pair of cells is tried on the next pairs
/// before any line is walked: a test of four products instead of a walk over the cells.
#[derive(Debug, Clone, Copy)]
struct Screen {
    low: Cell,
    high: Cell,
}

impl Screen {
    /// The longer of the blocked row and the blocked column that a blocked cell is in.
    fn around(map: &Occupancy, cell: Cell) -> Self {
        let along = |dx: i32, dy: i32| {
            let far = |sign: i32| {
                let steps =
                    (1..=REACH).take_while(|k| map.blocked(cell.offset(sign * k * dx, sign * k * dy)));
                steps.count() as i32 * sign
            };
            let (back, ahead) = (far(-1), far(1));
            Self { low: cell.offset(back * dx, back * dy), high: cell.offset(ahead * dx, ahead * dy) }
        };
        let (row, column) = (along(1, 0), along(0, 1));
        if row.high.x - row.low.x >= column.high.y - column.low.y { row } else { column }
    }

    /// True if the segment between two cell centres passes through the inside of one of the squares.
    fn hides(self, from: Cell, to: Cell) -> bool {
        let clip = |low: i32, high: i32, a: i32, b: i32| (low.max(a.min(b)), high.min(a.max(b)));
        let (left, right) = clip(self.low.x, self.high.x, from.x, to.x);
        let (bottom, top) = clip(self.low.y, self.high.y, from.y, to.y);
        if left > right || bottom > top {
            return false;
        }
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        // Twice the middle's distance from the line, against the farthest corner's.
        let aside = dx * (bottom + top - 2 * from.y) - dy * (left + right - 2 * from.x);
        aside.abs() < dx.abs() * (top - bottom + 1) + dy.abs() * (right - left + 1)
    }
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

/// Greatest common divisor of two numbers that are not negative.
const fn gcd(a: i32, b: i32) -> i32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Between cell centres, cells.
fn distance(a: Cell, b: Cell) -> f64 {
    let (dx, dy) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::math;

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
            let passes = Screen { low: cell, high: cell }.hides(from, to);
            assert!(!(passes && seen), "{to:?} {cell:?}");
            // Without corners to touch, the two are the same.
            let hidden = !line_of_sight(&map, from, to, Corner::Free);
            assert!(from == to || passes == hidden);
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

    /// A corridor with blocks to both sides in turn, and straight ways between them.
    #[test]
    fn straight_ways_behind_blocks_are_left_out_rightly() {
        let mut map = Occupancy::new(300, 14);
        let mut path = vec![Cell::new(0, 7)];
        let mut walk = |to: Cell| {
            while let Some(&at) = path.last().filter(|&&at| at != to) {
                path.push(at.offset((to.x - at.x).signum(), (to.y - at.y).signum()));
            }
        };
        for k in 0..9 {
            let (x, low) = (20 + 30 * k, k % 2 == 0);
            let rows = if low { 0..8 } else { 6..14 };
            let block = rows.flat_map(|y| (x..x + 6).map(move |x| Cell::new(x, y)));
            block.for_each(|cell| map.set(cell, true));
            let y = if low { 9 } else { 4 };
            walk(Cell::new(x - 2, y));
            walk(Cell::new(x + 8, y));
        }
        for corner in [Corner::Strict, Corner::NoSqueeze, Corner::Free] {
            assert_eq!(prune_dp(&map, &path, corner), plain_dp(&map, &path, corner));
        }
    }

    #[test]
    fn long_moves_are_cut_at_the_centres_they_pass() {
        let cells = |row: &[(i32, i32)]| row.iter().map(|&(x, y)| Cell::new(x, y)).collect::<Vec<_>>();
        let path = cells(&[(1, 1), (5, 3), (5, 0), (2, 3), (2, 3), (5, 5)]);
        let ways = [(1, 1), (3, 2), (5, 3), (5, 2), (5, 1), (5, 0), (4, 1), (3, 2), (2, 3), (2, 3), (5, 5)];
        assert_eq!(unit_steps(&path), cells(&ways));
        assert_eq!(distance(Cell::new(1, 2), Cell::new(4, -2)), 5.0);
        assert_eq!(straight_ends(&cells(&ways)), [2, 2, 5, 5, 5, 8, 8, 8, 9, 10, 10]);
    }

    #[test]
    fn straight_on_is_one_direction() {
        let moves = || (-3..=3).flat_map(|x| (-3..=3).map(move |y| (x, y)));
        for ((ux, uy), (vx, vy)) in moves().flat_map(|u| moves().map(move |v| (u, v))) {
            let a = Cell::new(5, -7);
            let b = a.offset(ux, uy);
            let still = (ux, uy) == (0, 0) || (vx, vy) == (0, 0);
            let heading = |x: i32, y: i32| math::atan2(f64::from(y), f64::from(x));
            let straight = !still && heading(ux, uy) == heading(vx, vy);
            assert_eq!(goes_straight(a, b, b.offset(vx, vy)), straight, "{ux} {uy} {vx} {vy}");
        }
    }

    #[test]
    fn a_screen_is_the_longer_row_or_column() {
        let map = Occupancy::parse("......\n.####.\n..#...\n..#...\n......");
        let around = |x, y| {
            let Screen { low, high } = Screen::around(&map, Cell::new(x, y));
            [(low.x, low.y), (high.x, high.y)]
        };
        assert_eq!(around(2, 3), [(1, 3), (4, 3)]);
        assert_eq!(around(4, 3), [(1, 3), (4, 3)]);
        assert_eq!(around(2, 2), [(2, 1), (2, 3)]);
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
