//! Proof that no path keeps a margin.
//!
//! Wherever the car passes, the middle of its body is at least the margin and half the width away from everything. Cells in
//! which no such place exists are closed, by an upper bound of the clearance of any place in a cell; if a flood over the
//! others does not join start and goal, no path keeps the margin. The converse does not hold, because the body is longer
//! than the disc about its middle.

use super::RoadRasters;
use crate::geometry::Point;
use crate::map::Cell;

/// True if every path of the car's middle from start to goal comes nearer to something than `room` metres, places
/// within `ends` metres of start and goal left out.
///
/// Where the body keeps a margin, its middle keeps that margin and half the width. Every cell is entered that holds a
/// place with so much exact room, by [`RoadRasters::unsure`], and from each one all eight around it: what such a flood
/// does not reach, no line through places with that room does. It proves nothing where it reaches the goal.
pub fn is_excluded(ground: &RoadRasters, [start, goal]: [Point; 2], room: f64, ends: f64) -> bool {
    let frame = &ground.frame;
    let [Some(first), Some(last)] = [start, goal].map(|end| frame.cell_at(end)) else { return false };
    let near = ends + frame.resolution;
    let may_hold = |cell: Cell| {
        let center = frame.center(cell);
        ground.at(cell) + ground.unsure >= room
            || [start, goal].iter().any(|end| (center - end).norm() <= near)
    };
    let mut met = vec![false; frame.len()];
    met[frame.index(first)] = true;
    let mut open = vec![first];
    while let Some(cell) = open.pop() {
        if cell == last {
            return false;
        }
        for next in (-1..=1).flat_map(|y| (-1..=1).map(move |x| cell.offset(x, y))) {
            if frame.contains(next) && !met[frame.index(next)] && may_hold(next) {
                met[frame.index(next)] = true;
                open.push(next);
            }
        }
    }
    true
}
