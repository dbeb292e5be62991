//! The way around obstacles for a disc: a lower bound on the car's way, from one flood of the lattice.

use crate::geometry::{Point, Pose, Vector};
use crate::map::{Cell, Frame};
use crate::planners::Region;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::Obstacles;

/// An eight-connected way is at most 1 / cos(π/8) = 1 / 0.924 longer than a straight one; 0.98 is a little greedy.
const DETOUR: f64 = 0.98;
/// Costs of a straight and a diagonal step; 7/5 is just below √2.
const STRAIGHT: u32 = 5;
const DIAGONAL: u32 = 7;
const UNREACHED: u32 = u32::MAX;
/// Poses that touch something are free; so is their disc, metres.
const TOLERANCE: f64 = 1e-4;

/// Closed cells are told apart from narrow open ones by quartering them this often.
const QUARTERINGS: u32 = 2;

/// Distances to one pose over the lattice of the obstacles' distance field.
///
/// The body holds a disc as wide as itself. Where no place in a cell has room for that disc, the car cannot go; and the
/// disc's way is hardly longer than the rear axle's.
pub(super) struct Flood {
    frame: Frame,
    steps: Vec<u32>,
    scale: f64,
    /// Centre of the disc, metres ahead of the rear axle.
    ahead: f64,
}

impl Flood {
    /// Floods from `target`, for a body grown by `margin`.
    pub(super) fn new(obstacles: &Obstacles, vehicle: &Vehicle, target: Pose, margin: f64) -> Self {
        let frame = *obstacles.frame();
        let radius = (vehicle.width / 2.0).min(vehicle.length() / 2.0);
        let ahead = 0.0_f64.clamp(radius - vehicle.rear_to_back, vehicle.rear_to_front - radius);
        let swing = vehicle.max_curvature() * ahead;
        let stretch = (1.0 + swing * swing).sqrt();
        let room = Room { obstacles, radius: radius + margin - TOLERANCE };
        let open = room.cells();
        let mut flood = Self {
            frame,
            steps: Vec::new(),
            scale: frame.resolution * DETOUR / f64::from(STRAIGHT) / stretch,
            ahead,
        };
        flood.steps = flood.cell(target).map_or_else(Vec::new, |cell| spread(&frame, &open, cell));
        flood
    }

    fn cell(&self, at: Pose) -> Option<Cell> {
        self.frame.cell_at(at.to_world(Point::new(self.ahead, 0.0)))
    }

    /// Squares of the lattice that the flood reached.
    pub(super) fn reached(&self) -> usize {
        self.steps.iter().filter(|&&s| s != UNREACHED).count()
    }

    /// Where the flood came.
    pub(super) fn region(&self) -> Region {
        let mut runs: Vec<(Point, u32)> = Vec::new();
        let half = Vector::new(0.5, 0.5) * self.frame.resolution;
        let reached = |i: usize| self.steps[i] != UNREACHED;
        for i in (0..self.steps.len()).filter(|&i| reached(i)) {
            let cell = self.frame.cell(i);
            match runs.last_mut() {
                Some(run) if cell.x > 0 && reached(i - 1) => run.1 += 1,
                _ => runs.push((self.frame.center(cell) - half, 1)),
            }
        }
        Region { cell: self.frame.resolution, runs }
    }

    /// A lower bound on the way from a pose, metres; infinite where there is no way.
    pub(super) fn distance(&self, at: Pose) -> f64 {
        match self.cell(at).and_then(|c| self.steps.get(self.frame.index(c))) {
            None | Some(&UNREACHED) => f64::INFINITY,
            Some(&steps) => f64::from(steps) * self.scale,
        }
    }
}

/// Where a disc has room.
struct Room<'a> {
    obstacles: &'a Obstacles,
    radius: f64,
}

impl Room<'_> {
    fn cells(&self) -> Vec<bool> {
        let frame = self.obstacles.frame();
        let half_diagonal = frame.resolution * core::f64::consts::FRAC_1_SQRT_2;
        // The field is too small by up to the diagonal of the blocked square.
        let (open, closed) = (self.radius as f32, (self.radius - 3.0 * half_diagonal) as f32);
        let field = self.obstacles.field().data.iter();
        field
            .enumerate()
            .map(|(i, &d)| {
                d >= open
                    || (d > closed && self.fits(frame.center(frame.cell(i)), half_diagonal, QUARTERINGS))
            })
            .collect()
    }

    /// Whether the disc may have room somewhere in the square around a point.
    fn fits(&self, center: Point, half_diagonal: f64, quarterings: u32) -> bool {
        let distance = self.obstacles.distance(center, self.radius);
        if distance >= self.radius {
            return true;
        }
        if distance < self.radius - half_diagonal {
            return false;
        }
        let quarter = half_diagonal * core::f64::consts::FRAC_1_SQRT_2 / 2.0;
        let corner = |dx: f64, dy: f64| center + Vector::new(dx * quarter, dy * quarter);
        quarterings == 0
            || [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)]
                .iter()
                .any(|&(dx, dy)| self.fits(corner(dx, dy), half_diagonal / 2.0, quarterings - 1))
    }
}

/// Dijkstra with a ring of buckets: no step costs more than [`DIAGONAL`].
fn spread(frame: &Frame, open: &[bool], from: Cell) -> Vec<u32> {
    let mut steps = vec![UNREACHED; open.len()];
    let mut ring: [Vec<u32>; DIAGONAL as usize + 1] = Default::default();
    let source = frame.index(from);
    steps[source] = 0;
    ring[0].push(source as u32);
    let (mut now, mut waiting) = (0_u32, 1_usize);
    let width = frame.width as i32;
    while waiting > 0 {
        let slot = now as usize % ring.len();
        let batch = core::mem::take(&mut ring[slot]);
        waiting -= batch.len();
        for &at in &batch {
            if steps[at as usize] != now {
                continue;
            }
            let cell = frame.cell(at as usize);
            for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)] {
                let next = cell.offset(dx, dy);
                if !frame.contains(next) {
                    continue;
                }
                let index = (next.y * width + next.x) as usize;
                let cost = now + if dx != 0 && dy != 0 { DIAGONAL } else { STRAIGHT };
                if open[index] && cost < steps[index] {
                    steps[index] = cost;
                    ring[cost as usize % ring.len()].push(index as u32);
                    waiting += 1;
                }
            }
        }
        now += 1;
    }
    steps
}
