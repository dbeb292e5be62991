//! Lengths, turns and clearances of grid paths, in cells.
//!
//! Cell centres have integer coordinates; x grows to the east, y to the north. A cell's side is 1, so lengths become
//! metres by the map's resolution.

use crate::geometry::math;
use crate::map::{Cell, Occupancy};

/// Clearances beyond this many cells count as this many.
pub const MAX_CLEARANCE: f64 = 5.0;
/// Farthest that two samples of a clearance are apart, cells.
const STEP: f64 = 0.25;

/// The corners of a path.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Turns {
    /// Corners, after cells in a straight row are merged.
    pub count: u32,
    /// Sum of the absolute changes of heading, degrees.
    pub angle_deg: f64,
}

/// How near a path comes to blocked cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clearance {
    /// The smallest, cells.
    pub min: f64,
    /// The mean over samples a quarter of a cell apart, cells.
    pub mean: f64,
}

/// Length of a path over cell centres, cells.
pub fn length(path: &[Cell]) -> f64 {
    path.windows(2).map(|pair| distance(point(pair[0]), point(pair[1]))).sum()
}

/// The corners of a path over cell centres.
///
/// Exact integers decide what a corner is; only the angle is rounded. A reversal counts as a corner of 180°.
///
/// # Examples
/// ```
/// use parkade::map::Cell;
/// use parkade::metrics::grid::{length, turns};
///
/// let path = [Cell::new(0, 0), Cell::new(2, 0), Cell::new(3, 1)];
/// assert_eq!((turns(&path).count, turns(&path).angle_deg), (1, 45.0));
/// assert!((length(&path) - 2.0 - 2.0_f64.sqrt()).abs() < 1e-12);
/// ```
pub fn turns(path: &[Cell]) -> Turns {
    let mut turns = Turns::default();
    for triple in path.windows(3) {
        let (ux, uy) = (i64::from(triple[1].x - triple[0].x), i64::from(triple[1].y - triple[0].y));
        let (vx, vy) = (i64::from(triple[2].x - triple[1].x), i64::from(triple[2].y - triple[1].y));
        let (cross, dot) = (ux * vy - uy * vx, ux * vx + uy * vy);
        if cross != 0 || dot < 0 {
            turns.count += 1;
            turns.angle_deg += math::atan2(cross.abs() as f64, dot as f64).to_degrees();
        }
    }
    turns
}

/// The clearance along a polyline in cell coordinates (centres at integers): distance from the centre of each sample's
/// cell to the nearest blocked cell's centre, at most [`MAX_CLEARANCE`]. The border does not count.
///
/// A line without points has the largest clearance there is.
pub fn clearance(map: &Occupancy, line: &[[f64; 2]]) -> Clearance {
    let (mut min, mut sum, mut samples) = (MAX_CLEARANCE, 0.0, 0_u32);
    // Samples are close together: most are in the cell of the one before.
    let mut last = None;
    let mut sample = |[x, y]: [f64; 2]| {
        let cell = Cell::new((x + 0.5).floor() as i32, (y + 0.5).floor() as i32);
        let near = match last {
            Some((same, near)) if same == cell => near,
            _ => nearest(map, cell),
        };
        last = Some((cell, near));
        min = near.min(min);
        sum += near;
        samples += 1;
    };
    for pair in line.windows(2) {
        let parts = (distance(pair[0], pair[1]) / STEP).ceil() as u32;
        for k in 0..parts {
            let t = f64::from(k) / f64::from(parts);
            sample([pair[0][0] + t * (pair[1][0] - pair[0][0]), pair[0][1] + t * (pair[1][1] - pair[0][1])]);
        }
    }
    line.last().copied().map(&mut sample);
    Clearance { min, mean: if samples == 0 { min } else { sum / f64::from(samples) } }
}

/// A path's cell centres as a polyline.
pub fn polyline(path: &[Cell]) -> Vec<[f64; 2]> {
    path.iter().map(|&c| point(c)).collect()
}

/// Distance from a cell's centre to the nearest obstacle's, at most [`MAX_CLEARANCE`].
fn nearest(map: &Occupancy, cell: Cell) -> f64 {
    let reach = MAX_CLEARANCE as i32;
    let mut squared = reach * reach;
    for (i, j) in (-reach..=reach).flat_map(|j| (-reach..=reach).map(move |i| (i, j))) {
        if i * i + j * j < squared && map.is_obstacle(cell.offset(i, j)) {
            squared = i * i + j * j;
        }
    }
    f64::from(squared).sqrt()
}

fn point(cell: Cell) -> [f64; 2] {
    [f64::from(cell.x), f64::from(cell.y)]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn collinear_cells_make_no_turn() {
        let path = [(0, 0), (1, 0), (3, 0), (4, 1), (4, 2), (4, 1)].map(|(x, y)| Cell::new(x, y));
        let turns = turns(&path);
        assert_eq!(turns.count, 3);
        assert!((turns.angle_deg - (45.0 + 45.0 + 180.0)).abs() < 1e-9);
        assert!((length(&path) - (5.0 + 2_f64.sqrt())).abs() < 1e-12);
    }

    #[test]
    fn clearance_is_from_centre_to_centre_and_saturates() {
        let map = Occupancy::parse("..........\n..........\n#.........");
        let path = polyline(&[Cell::new(0, 2), Cell::new(9, 2)]);
        let clearance = clearance(&map, &path);
        assert_eq!(clearance.min, 2.0);
        // Samples at 0, 1/4, …, 9 fall into cells 0 (2 of them), 1 to 8 (4 each) and 9 (3).
        let cells: f64 = (1..9).map(|x| f64::from(4 + x * x).sqrt().min(5.0)).sum();
        assert!((clearance.mean - (2.0 * 2.0 + 4.0 * cells + 3.0 * 5.0) / 37.0).abs() < 1e-12);
    }

    #[test]
    fn no_obstacle_no_path() {
        assert_eq!(clearance(&Occupancy::new(3, 3), &[]), Clearance { min: 5.0, mean: 5.0 });
        assert_eq!(turns(&[]), Turns::default());
    }
}
