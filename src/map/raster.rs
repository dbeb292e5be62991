//! Geometry (metres) to cells: filled outlines, thin walls, brushed runs, the outside of a boundary.
//!
//! A filled outline blocks every cell whose open square it overlaps; contact alone does not block. A wall without
//! thickness blocks every cell whose closed square it touches. Coordinates within a billionth of a cell of an edge
//! count as on it, so an outline drawn along cell edges does not leak into the next row by rounding.

use super::{Cell, Frame, Occupancy};
use crate::geometry::{Point, math};

const SNAP: f64 = 1e-9;

/// Blocks every cell that a simple polygon overlaps.
pub fn fill(map: &mut Occupancy, frame: &Frame, outline: &[Point]) {
    let corners = lattice(frame, outline);
    for edge in edges(&corners) {
        cells_of(map, edge, false, |map, cell| map.set(cell, true));
    }
    for_each_row_inside(map, &corners, |map, y, from, to| {
        (from..to).for_each(|x| map.set(Cell::new(x, y), true));
    });
}

/// Blocks every cell that is not wholly inside a simple polygon.
pub fn fill_outside(map: &mut Occupancy, frame: &Frame, outline: &[Point]) {
    let corners = lattice(frame, outline);
    let mut inside = Occupancy::new(map.width(), map.height());
    for_each_row_inside(&mut inside, &corners, |inside, y, from, to| {
        (from..to).for_each(|x| inside.set(Cell::new(x, y), true));
    });
    for edge in edges(&corners) {
        cells_of(&mut inside, edge, false, |inside, cell| inside.set(cell, false));
    }
    for index in 0..map.len() as u32 {
        let cell = map.cell(index);
        if !inside.blocked(cell) {
            map.set(cell, true);
        }
    }
}

/// Blocks every cell that a polyline without thickness touches.
pub fn wall(map: &mut Occupancy, frame: &Frame, line: &[Point]) {
    let corners = lattice(frame, line);
    for pair in corners.windows(2) {
        cells_of(map, [pair[0], pair[1]], true, |map, cell| map.set(cell, true));
    }
}

/// Blocks runs of cells: x of the first, y, number of cells eastward.
pub fn runs(map: &mut Occupancy, runs: &[[u32; 3]]) {
    for &[x, y, count] in runs {
        let end = x.saturating_add(count).min(map.width());
        for x in x..end {
            map.set(Cell::new(x as i32, y as i32), true);
        }
    }
}

/// The blocked cells of a map as runs: the inverse of [`runs`].
pub fn to_runs(map: &Occupancy) -> Vec<[u32; 3]> {
    let mut runs: Vec<[u32; 3]> = Vec::new();
    for y in 0..map.height() {
        for (x, _) in map.row(y).iter().enumerate().filter(|&(_, &b)| b != 0) {
            let x = x as u32;
            match runs.last_mut() {
                Some(run) if run[1] == y && run[0] + run[2] == x => run[2] += 1,
                _ => runs.push([x, y, 1]),
            }
        }
    }
    runs
}

/// Corners in lattice coordinates, snapped to cell edges.
fn lattice(frame: &Frame, points: &[Point]) -> Vec<[f64; 2]> {
    let snap = |v: f64| if (v - v.round()).abs() < SNAP { v.round() } else { v };
    points.iter().map(|&p| frame.lattice(p).map(snap)).collect()
}

fn edges(corners: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| [a, b])
}

/// Visits the cells whose open (or closed) square the segment meets.
fn cells_of(
    map: &mut Occupancy,
    [a, b]: [[f64; 2]; 2],
    closed: bool,
    mut visit: impl FnMut(&mut Occupancy, Cell),
) {
    let padding = if closed { SNAP } else { -SNAP };
    let (low, high) = (a[1].min(b[1]), a[1].max(b[1]));
    for y in first_cell(low, map.height())..=last_cell(high, map.height()) {
        // The segment's extent within the row, widened by the padding and clipped to the segment.
        let (bottom, top) = (f64::from(y) - padding, f64::from(y + 1) + padding);
        if high <= bottom || low >= top {
            continue;
        }
        let (mut west, mut east) = (a[0].min(b[0]), a[0].max(b[0]));
        if high - low > SNAP {
            let at = |level: f64| {
                let t = ((level - a[1]) / (b[1] - a[1])).clamp(0.0, 1.0);
                a[0] + t * (b[0] - a[0])
            };
            let (p, q) = (at(bottom), at(top));
            (west, east) = (p.min(q), p.max(q));
        }
        for x in first_cell(west, map.width())..=last_cell(east, map.width()) {
            let (left, right) = (f64::from(x) - padding, f64::from(x + 1) + padding);
            if east > left && west < right {
                visit(map, Cell::new(x, y));
            }
        }
    }
}

/// The lowest row (or column) that could touch a coordinate.
fn first_cell(v: f64, count: u32) -> i32 {
    (v.floor() - 1.0).clamp(0.0, f64::from(count)) as i32
}

/// The highest row (or column) that could touch a coordinate.
fn last_cell(v: f64, count: u32) -> i32 {
    (v.floor() + 1.0).clamp(-1.0, f64::from(count) - 1.0) as i32
}

/// Visits, per row, the runs of cells whose centres are inside the outline (even-odd).
fn for_each_row_inside(
    map: &mut Occupancy,
    corners: &[[f64; 2]],
    mut visit: impl FnMut(&mut Occupancy, i32, i32, i32),
) {
    let width = f64::from(map.width());
    let column = |v: f64| (v - 0.5).ceil().clamp(0.0, width) as i32;
    let low = corners.iter().fold(f64::INFINITY, |low, c| low.min(c[1]));
    let high = corners.iter().fold(f64::NEG_INFINITY, |high, c| high.max(c[1]));
    let mut crossings = Vec::new();
    for y in first_cell(low, map.height())..=last_cell(high, map.height()) {
        let level = f64::from(y) + 0.5;
        crossings.clear();
        for [a, b] in edges(corners) {
            if (a[1] <= level) != (b[1] <= level) {
                crossings.push(a[0] + (level - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
            }
        }
        for pair in math::sorted_by(&crossings, |&x| x).chunks_exact(2) {
            visit(map, y, column(pair[0]), column(pair[1]));
        }
    }
}
