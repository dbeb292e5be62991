//! The way around obstacles for a disc, from one flood of the lattice: an estimate of the car's way.
//!
//! The body contains a disc as wide as itself. Wherever the car can drive, that disc can move; so the disc's
//! shortest way to the target is nearly a lower bound of the car's. One flood from the target over the cells of the
//! obstacles' distance field gives it for every place; a node of the search then reads it from a table.
//!
//! It is a little greedy, not a strict bound: cells count with eight neighbours, and places with hardly any room
//! count twice.
//!
//! In formulas, for a flood distance d (5 per straight step, 7 per diagonal one, twice that into narrow cells), cells
//! of side r, and the disc's centre a ahead of the rear axle:
//!
//! ```text
//! h = 0.98 · r · d/5 / √(1 + (κ·a)²)          κ: the largest curvature of the car
//! ```
//!
//! The root is there because the axle is what drives: when it moves by ds on the tightest arc, a point that lies a
//! ahead moves by ds·√(1 + (κa)²) at most. Dividing by it turns the way of the disc into a bound for the way of the
//! axle.
//!
//! A cell is closed only if no place in it has room for the disc. Its centre decides in most cases; near an obstacle
//! the cell is quartered, twice at most, and each quarter asked. So no drivable gap is cut off by the raster, and a
//! flood that does not reach the other end proves that there is no path.
//!
//! A flood takes O(cells). Both the costs of the cells and the flood are kept for the next question ([`FloodMemory`]),
//! and used again if obstacles, radius and source are the same.

use std::sync::Arc;

use super::flood_memory::FloodMemory;
use crate::geometry::{Point, Pose, Vector};
use crate::map::{Cell, Frame};
use crate::planners::Region;
use crate::vehicle::Vehicle;
#[cfg(feature = "complete")]
use crate::vehicle::collision::Corridor;
use crate::vehicle::collision::Obstacles;

/// An eight-connected way is at most 1 / cos(π/8) = 1 / 0.924 longer than a straight one; 0.98 is a little greedy.
const DETOUR: f64 = 0.98;
/// Costs of a straight and a diagonal step; 7/5 is just below √2.
const STRAIGHT: u32 = 5;
const DIAGONAL: u32 = 7;
const UNREACHED: u32 = u32::MAX;
/// Poses that touch something are free; so is their disc, metres.
const TOLERANCE: f64 = 1e-4;
/// Places where the disc has less room than this on either side are narrow, metres: a car meets them hardly ever, …
const NARROW_CLEARANCE: f64 = 0.05;
/// … so a way through them counts this often.
const NARROW_FACTOR: u32 = 2;

/// Closed cells are told apart from narrow open ones by quartering them this often.
const QUARTERINGS: u32 = 2;

/// Distances to one pose over the lattice of the obstacles' distance field.
///
/// The body holds a disc as wide as itself. Where no place in a cell has room for that disc, the car cannot go; and the
/// disc's way is hardly longer than the rear axle's.
#[derive(Debug)]
pub(super) struct ObstacleHeuristic {
    flood: Flood,
    scale: f64,
    /// Centre of the disc, metres ahead of the rear axle.
    ahead: f64,
}

/// Steps from each cell to one of them; a copy shares both tables.
#[derive(Debug, Clone)]
pub(super) struct Flood {
    pub(super) ground: Arc<Ground>,
    pub(super) source: Option<Cell>,
    pub(super) steps: Arc<Vec<u32>>,
}

/// Cost of entering each cell, for one disc among obstacles.
#[derive(Debug, Clone)]
pub(super) struct Ground {
    fingerprint: u64,
    radius: f64,
    frame: Frame,
    /// 0 where the disc cannot go; so are the outermost cells, which lie off the floor.
    costs: Vec<u8>,
}

impl ObstacleHeuristic {
    /// Bytes held.
    pub(super) fn bytes(&self) -> u64 {
        (size_of_val(&self.flood.steps[..]) + self.flood.ground.costs.len()) as u64
    }

    /// Floods from `target`, for a body grown by `margin`. What `memory` has of it is taken over.
    #[inline(never)]
    pub(super) fn new(
        obstacles: &Obstacles,
        vehicle: &Vehicle,
        target: Pose,
        margin: f64,
        memory: Option<&FloodMemory>,
    ) -> Self {
        let radius = (vehicle.width / 2.0).min(vehicle.length() / 2.0);
        // In a car as wide as it is long the two bounds are the same but for rounding, which may swap them.
        let ahead = (radius - vehicle.rear_to_back).max(0.0).min(vehicle.rear_to_front - radius);
        let swing = vehicle.max_curvature() * ahead;
        let stretch = (1.0 + swing * swing).sqrt();
        let scale = obstacles.frame().resolution * DETOUR / f64::from(STRAIGHT) / stretch;
        let source = obstacles.frame().cell_at(target.to_world(Point::new(ahead, 0.0)));
        let room = Room { obstacles, radius: radius + margin - TOLERANCE };
        let flood = memory
            .map_or_else(|| Flood::new(room.ground().into(), source), |known| known.flood(&room, source));
        Self { flood, scale, ahead }
    }

    /// The same flood where the disc's centre keeps within a corridor.
    #[cfg(feature = "complete")]
    pub(super) fn within(mut self, corridor: &Corridor) -> Self {
        let mut ground = Ground::clone(&self.flood.ground);
        let frame = ground.frame;
        for (i, cost) in ground.costs.iter_mut().enumerate() {
            *cost *= u8::from(corridor.holds(frame.center(frame.cell(i))));
        }
        self.flood = Flood::new(ground.into(), self.flood.source);
        self
    }

    /// The middle of the disc at a pose.
    #[cfg(feature = "complete")]
    pub(super) fn disc(&self, at: Pose) -> Point {
        at.to_world(Point::new(self.ahead, 0.0))
    }

    /// Costs of the cells, and steps from them.
    #[cfg(all(test, feature = "complete"))]
    pub(super) fn tables(&self) -> (&[u8], &[u32]) {
        (&self.flood.ground.costs, &self.flood.steps)
    }

    /// The cell that holds the disc's centre at a pose; `None` off the raster.
    fn cell(&self, at: Pose) -> Option<Cell> {
        self.flood.ground.frame.cell_at(at.to_world(Point::new(self.ahead, 0.0)))
    }

    /// Squares of the lattice that the flood reached.
    pub(super) fn reached(&self) -> usize {
        self.flood.steps.iter().filter(|&&s| s != UNREACHED).count()
    }

    /// The region that the flood reached.
    pub(super) fn region(&self) -> Region {
        let Flood { ground, steps, .. } = &self.flood;
        let frame = &ground.frame;
        let mut runs: Vec<(Point, u32)> = Vec::new();
        let half = Vector::new(0.5, 0.5) * frame.resolution;
        let reached = |i: usize| steps[i] != UNREACHED;
        for i in (0..steps.len()).filter(|&i| reached(i)) {
            let cell = frame.cell(i);
            match runs.last_mut() {
                Some(run) if cell.x > 0 && reached(i - 1) => run.1 += 1,
                _ => runs.push((frame.center(cell) - half, 1)),
            }
        }
        Region { cell: frame.resolution, runs }
    }

    /// The way from a pose, metres: less than the car needs, but for narrow places; infinite where there is no way.
    pub(super) fn distance(&self, at: Pose) -> f64 {
        match self.cell(at).and_then(|c| self.flood.steps.get(self.flood.ground.frame.index(c))) {
            None | Some(&UNREACHED) => f64::INFINITY,
            Some(&steps) => f64::from(steps) * self.scale,
        }
    }
}

impl Flood {
    /// The flood over this ground; empty where the source is off the raster.
    #[inline(never)]
    pub(super) fn new(ground: Arc<Ground>, source: Option<Cell>) -> Self {
        let steps = source.map_or_else(Vec::new, |cell| spread(&ground, cell));
        Self { ground, source, steps: steps.into() }
    }

    /// The flood from the same source where cells have become cheaper, or were opened: `ground` may cost nothing more
    /// than this one's. Only what is nearer than before is gone through.
    #[cfg(feature = "complete")]
    pub(super) fn onto(&self, ground: Arc<Ground>) -> Self {
        let mut steps = Vec::clone(&self.steps);
        let mut nearer = Vec::new();
        let around = neighbours(ground.frame.width as usize);
        let changed = |&at: &usize| ground.costs[at] != self.ground.costs[at];
        for at in (0..steps.len()).filter(changed) {
            let cost = u32::from(ground.costs[at]);
            let reached = |&(by, length): &(usize, u32)| {
                steps[at.wrapping_sub(by)].checked_add(cost * length).unwrap_or(UNREACHED)
            };
            let least = around.iter().map(reached).min().unwrap_or(UNREACHED);
            if least < steps[at] {
                steps[at] = least;
                nearer.push(at);
            }
        }
        while !nearer.is_empty() {
            for at in core::mem::take(&mut nearer) {
                for (by, length) in around {
                    let index = at.wrapping_add(by);
                    let Some(&cost) = ground.costs.get(index) else { continue };
                    let reached = steps[at] + u32::from(cost) * length;
                    if cost > 0 && reached < steps[index] {
                        steps[index] = reached;
                        nearer.push(index);
                    }
                }
            }
        }
        Self { ground, source: self.source, steps: steps.into() }
    }
}

impl Ground {
    /// True if the costs of the cells hold for these obstacles and this radius, to the last bit.
    pub(super) fn serves(&self, room: &Room) -> bool {
        self.fingerprint == room.obstacles.fingerprint() && self.radius.to_bits() == room.radius.to_bits()
    }
}

/// The cells in which a disc fits.
pub(super) struct Room<'a> {
    pub(super) obstacles: &'a Obstacles,
    pub(super) radius: f64,
}

impl Room<'_> {
    /// The cost of every cell: 0 closed, 1 open, [`NARROW_FACTOR`] narrow.
    pub(super) fn ground(&self) -> Ground {
        let frame = *self.obstacles.frame();
        let mut costs = vec![0; frame.width as usize * frame.height as usize];
        self.fill(&mut costs, [0, 0], [frame.width, frame.height]);
        Ground { fingerprint: self.obstacles.fingerprint(), radius: self.radius, frame, costs }
    }

    /// The costs of the cells where those of `known` are not for the same obstacles: in a box, metres.
    #[cfg(feature = "complete")]
    pub(super) fn ground_from(&self, known: &Ground, (low, high): (Point, Point)) -> Ground {
        let frame = known.frame;
        // Farther away neither the disc nor the field's squares tell the difference.
        let reach = self.radius + NARROW_CLEARANCE + 3.0 * frame.resolution;
        let column = |v: f64| ((v - frame.origin.x) / frame.resolution) as u32;
        let row = |v: f64| ((v - frame.origin.y) / frame.resolution) as u32;
        let from = [column(low.x - reach), row(low.y - reach)];
        let to = [column(high.x + reach), row(high.y + reach)].map(|last| last.saturating_add(1));
        let mut costs = known.costs.clone();
        self.fill(&mut costs, from, to);
        Ground { fingerprint: self.obstacles.fingerprint(), costs, ..*known }
    }

    /// Writes the costs of the cells from `from` to before `to`; outermost cells keep theirs, which is 0.
    #[inline(never)]
    fn fill(&self, costs: &mut [u8], from: [u32; 2], to: [u32; 2]) {
        let frame = self.obstacles.frame();
        let half_diagonal = frame.resolution * core::f64::consts::FRAC_1_SQRT_2;
        // The field is too small by up to the diagonal of the blocked square.
        let easy = (self.radius + NARROW_CLEARANCE) as f32;
        let closed = (self.radius - 3.0 * half_diagonal) as f32;
        let field = &self.obstacles.field().data;
        for y in from[1].max(1)..to[1].min(frame.height - 1) {
            for x in from[0].max(1)..to[0].min(frame.width - 1) {
                let cell = Cell::new(x as i32, y as i32);
                let at = frame.index(cell);
                costs[at] = match field[at] {
                    d if d >= easy => 1,
                    d if d > closed => self.cost(frame.center(cell), half_diagonal),
                    _ => 0,
                };
            }
        }
    }

    /// Cost of a cell whose centre may be near an obstacle.
    fn cost(&self, center: Point, half_diagonal: f64) -> u8 {
        let distance = self.obstacles.distance(center, self.radius + NARROW_CLEARANCE);
        match () {
            () if distance >= self.radius + NARROW_CLEARANCE => 1,
            () if distance >= self.radius || self.fits(center, distance, half_diagonal, QUARTERINGS) => {
                NARROW_FACTOR as u8
            }
            () => 0,
        }
    }

    /// True if the disc, which has no room in the middle of a square, `distance` away from something, may have it
    /// elsewhere in there.
    fn fits(&self, center: Point, distance: f64, half_diagonal: f64, quarterings: u32) -> bool {
        if distance < self.radius - half_diagonal {
            return false;
        }
        let quarter = half_diagonal * core::f64::consts::FRAC_1_SQRT_2 / 2.0;
        quarterings == 0
            || [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].iter().any(|&(dx, dy)| {
                let center = center + Vector::new(dx * quarter, dy * quarter);
                let distance = self.obstacles.distance(center, self.radius);
                distance >= self.radius || self.fits(center, distance, half_diagonal / 2.0, quarterings - 1)
            })
    }
}

/// How far the eight neighbours of a cell are in the arrays, and how long the steps to them.
fn neighbours(width: usize) -> [(usize, u32); 8] {
    let straight = [1, width, width.wrapping_neg(), 1_usize.wrapping_neg()];
    let corners = [width + 1, width - 1, 1_usize.wrapping_sub(width), 0_usize.wrapping_sub(width + 1)];
    core::array::from_fn(|i| if i < 4 { (straight[i], STRAIGHT) } else { (corners[i - 4], DIAGONAL) })
}

/// Dijkstra with a ring of buckets: no step costs more than a narrow diagonal one.
fn spread(ground: &Ground, from: Cell) -> Vec<u32> {
    const RING: usize = (DIAGONAL * NARROW_FACTOR) as usize + 1;
    let width = ground.frame.width as usize;
    let mut steps = vec![UNREACHED; ground.costs.len()];
    let mut ring: [Vec<u32>; RING] = Default::default();
    let source = ground.frame.index(from);
    steps[source] = 0;
    ring[0].push(source as u32);
    let (mut now, mut waiting) = (0_u32, 1_usize);
    let around = neighbours(width);
    while waiting > 0 {
        let slot = now as usize % RING;
        let mut batch = core::mem::take(&mut ring[slot]);
        waiting -= batch.len();
        for &at in &batch {
            if steps[at as usize] != now {
                continue;
            }
            for (by, length) in around {
                let index = (at as usize).wrapping_add(by);
                let Some(&cost) = ground.costs.get(index) else { continue };
                let reached = now + u32::from(cost) * length;
                if cost > 0 && reached < steps[index] {
                    steps[index] = reached;
                    ring[reached as usize % RING].push(index as u32);
                    waiting += 1;
                }
            }
        }
        batch.clear();
        ring[slot] = batch;
        now += 1;
    }
    steps
}
