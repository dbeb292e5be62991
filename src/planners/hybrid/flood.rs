//! The flood: distances over the lattice of the obstacles' distance field for a disc.
//!
//! A cell is closed only if no place in it has room for the disc. Its centre decides in most cases; near an obstacle
//! the cell is quartered, twice at most, and each quarter asked. So no drivable gap is cut off by the raster, and a
//! flood that does not reach the other end proves that there is no path.
//!
//! Steps count 5 straight and 7 diagonally, twice that into narrow cells. A flood takes O(cells). Where obstacles
//! differ from known ones at one place, costs are looked at again around that place only; where that has opened
//! cells, only what is nearer than before is flooded again.

use std::sync::Arc;

use crate::geometry::{Point, Vector};
use crate::map::{Cell, Frame};
use crate::vehicle::collision::Obstacles;

/// Costs of a straight and a diagonal step; 7/5 is just below √2.
pub(super) const STRAIGHT: u32 = 5;
const DIAGONAL: u32 = 7;
pub(super) const UNREACHED: u32 = u32::MAX;
/// Places where the disc has less room than this on either side are narrow, metres: a car can rarely use them, …
const NARROW_CLEARANCE: f64 = 0.05;
/// … so a way through them counts this often.
const NARROW_FACTOR: u32 = 2;
/// Closed cells are told apart from narrow open ones by quartering them this often.
const QUARTERINGS: u32 = 2;

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
    pub(super) frame: Frame,
    /// 0 where the disc cannot go; so are the outermost cells, which lie off the floor.
    pub(super) costs: Vec<u8>,
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
                // Most neighbours are as near already as a step into an open cell would bring them.
                let Some(known) = steps.get_mut(index).filter(|known| now + length < **known) else {
                    continue;
                };
                let cost = u32::from(ground.costs[index]);
                let reached = now + cost * length;
                if cost > 0 && reached < *known {
                    *known = reached;
                    let ahead = slot + (cost * length) as usize;
                    ring[if ahead < RING { ahead } else { ahead - RING }].push(index as u32);
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
