//! The artificial potential field of the risk-field planner: the goal attracts, the nearest obstacle repels.
//!
//! With ρ the distance to an obstacle's cell in cells, d the vector to the goal and n the unit vector away from the
//! obstacle, the force at a cell is (Hu et al. 2024)
//!
//! ```text
//! F = k1 · d                                  attraction, linear
//!   + k2 · (1/ρ − 1/ρ0) · 1/ρ² · n            repulsion, where ρ ≤ ρ0
//! ```
//!
//! and both parts are slopes of the potentials ½·k1·d² and ½·k2·(1/ρ − 1/ρ0)². The conic form of the attraction has
//! the constant length k1. The paper leaves open what repels where several cells are equally near; [`ObstacleSet`]
//! names the readings.
//!
//! The field is evaluated on demand, at the cells that a search expands. With the default reading and a reach ρ0 of
//! at most three cells the forces of all offsets are tabulated once, so that a cell costs a look-up by the bits of
//! the blocked cells around it.

use super::occupancy::DIRECTIONS;
use super::{Cell, Layer, Occupancy};
use crate::geometry::math;
use crate::json;

/// How the goal's pull depends on its distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Attraction {
    /// Proportional to the distance (the paper).
    #[default]
    Linear,
    /// The same at every distance.
    Conic,
}

json::words!(Attraction: "linear" = Linear, "conic" = Conic);

/// Which blocked cells within reach repel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ObstacleSet {
    /// The nearest; the mean of their forces where several are equally near.
    #[default]
    NearestMean,
    /// The nearest; of several equally near the first, row by row from the south-west.
    NearestFirst,
    /// All of them.
    Sum,
}

json::words!(ObstacleSet: "nearest-mean" = NearestMean, "nearest-first" = NearestFirst, "sum" = Sum);

/// Strength and reach of the field. Lengths in cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldSettings {
    /// Gain of the attraction.
    pub k1: f64,
    /// Reach of the repulsion, cells.
    pub rho0: f64,
    /// Gain of the repulsion.
    pub k2: f64,
    /// How the pull depends on the distance.
    pub attraction: Attraction,
    /// Which blocked cells repel.
    pub obstacle_set: ObstacleSet,
}

/// The field of one map and goal, evaluated cell by cell on demand.
#[derive(Debug, Clone)]
pub struct PotentialField<'a> {
    map: &'a Occupancy,
    goal: Cell,
    settings: FieldSettings,
    sources: Vec<Source>,
    /// The bits of [`Occupancy::window`] at each distance, nearest first; empty unless only the nearest cells repel and
    /// all of them lie in the window.
    rings: Vec<u64>,
    /// The forces by those bits.
    forces: Vec<(f64, f64)>,
    /// The push of the cells around that are blocked, by [`Occupancy::free_around`].
    near: Vec<(f64, f64)>,
}

/// How far [`Occupancy::window`] reaches.
const SIGHT: i32 = 3;

/// The bits of the cells to the east, north, west and south.
const STRAIGHT: u8 = 0b0101_0101;

/// The force of a blocked cell at one offset.
#[derive(Debug, Clone, Copy)]
struct Source {
    offset: (i32, i32),
    squared: i32,
    force: (f64, f64),
}

impl<'a> PotentialField<'a> {
    /// The field on `map` towards `goal`. Cells outside the map do not repel.
    pub fn new(map: &'a Occupancy, goal: Cell, settings: FieldSettings) -> Self {
        let mut sources = sources(&settings);
        if settings.obstacle_set != ObstacleSet::Sum {
            sources = math::sorted_by(&sources, |s| f64::from(s.squared));
        }
        let (mut rings, mut forces, mut near) = (Vec::new(), Vec::new(), Vec::new());
        if settings.obstacle_set == ObstacleSet::NearestMean && settings.rho0 <= f64::from(SIGHT) {
            forces = vec![(0.0, 0.0); 64];
            let mut around = [(0.0, 0.0); 8];
            let mut last = 0;
            for source in &sources {
                let bit = 8 * (source.offset.1 + SIGHT) + source.offset.0 + SIGHT;
                match rings.last_mut() {
                    Some(ring) if source.squared == last => *ring |= 1 << bit,
                    _ => rings.push(1_u64 << bit),
                }
                last = source.squared;
                forces[bit as usize] = source.force;
                if let Some(c) = DIRECTIONS.iter().position(|&offset| offset == source.offset) {
                    around[c] = source.force;
                }
            }
            // Diagonal cells out of the field's reach push with nothing, and then so does all that is farther.
            let push = |free: u8| match (!free & STRAIGHT, !free) {
                (0, 0) => (0.0, 0.0),
                (0, diagonal) => mean(diagonal.into(), &around),
                (straight, _) => mean(straight.into(), &around),
            };
            near = (0..=u8::MAX).map(push).collect();
        }
        Self { map, goal, settings, sources, rings, forces, near }
    }

    /// The force at a cell, east and north. Zero at the goal away from obstacles.
    pub fn force(&self, at: Cell) -> (f64, f64) {
        let (pull, push) = (self.attraction(at), self.repulsion(at));
        (pull.0 + push.0, pull.1 + push.1)
    }

    /// The force at the middle cell of each whole square of `every` cells (at least 1), (0, 0) in blocked ones.
    pub fn layer(&self, every: u32) -> Layer<[f32; 2]> {
        let mut layer = Layer::filled(self.map.width() / every, self.map.height() / every, [0.0; 2]);
        let (width, middle) = (layer.width, every / 2);
        for (index, value) in (0..).zip(&mut layer.data) {
            let at = [index % width, index / width].map(|i| (i * every + middle) as i32);
            let cell = Cell::new(at[0], at[1]);
            if !self.map.blocked(cell) {
                let (x, y) = self.force(cell);
                *value = [x as f32, y as f32];
            }
        }
        layer
    }

    /// The goal's pull at a cell, east and north.
    pub fn attraction(&self, at: Cell) -> (f64, f64) {
        let k1 = self.settings.k1;
        let (x, y) = (f64::from(self.goal.x - at.x), f64::from(self.goal.y - at.y));
        if self.settings.attraction == Attraction::Linear {
            return (k1 * x, k1 * y);
        }
        let distance = (x * x + y * y).sqrt();
        if distance == 0.0 { (0.0, 0.0) } else { (k1 * (x / distance), k1 * (y / distance)) }
    }

    /// The potentials at a cell, of the goal (Hu et al. 2024, eq 4) and of the obstacles (eq 6):
    /// [`PotentialField::attraction`] and [`PotentialField::repulsion`] are their slopes, downwards. Blocked cells have
    /// the potential of a cell beside them, 1 away.
    pub fn potentials(&self, at: Cell) -> (f64, f64) {
        let FieldSettings { k1, k2, rho0, .. } = self.settings;
        let (x, y) = (f64::from(self.goal.x - at.x), f64::from(self.goal.y - at.y));
        let squared = x * x + y * y;
        let pull = if self.settings.attraction == Attraction::Linear {
            0.5 * k1 * squared
        } else {
            k1 * squared.sqrt()
        };
        let near = |source: &Source| {
            let term = 1.0 / f64::from(source.squared).sqrt() - 1.0 / rho0;
            0.5 * k2 * term * term
        };
        let met = |source: &&Source| self.map.is_obstacle(at.offset(source.offset.0, source.offset.1));
        let push = if self.map.blocked(at) {
            0.5 * k2 * (1.0 - 1.0 / rho0) * (1.0 - 1.0 / rho0)
        } else if self.settings.obstacle_set == ObstacleSet::Sum {
            self.sources.iter().filter(met).map(near).sum()
        } else {
            // Nearest first; those equally near have the same potential.
            self.sources.iter().find(met).map_or(0.0, near)
        };
        (pull, push)
    }

    /// The sum of both potentials at every cell.
    pub fn potential_layer(&self) -> Layer<f32> {
        let mut layer = Layer::filled(self.map.width(), self.map.height(), 0.0);
        for (index, value) in (0..).zip(&mut layer.data) {
            let (pull, push) = self.potentials(self.map.cell(index));
            *value = (pull + push) as f32;
        }
        layer
    }

    /// The obstacles' push at a cell, east and north.
    pub fn repulsion(&self, at: Cell) -> (f64, f64) {
        let (width, height) = (self.map.width() as i32, self.map.height() as i32);
        // What is outside is blocked there, but does not repel.
        let inner = |x: i32, size: i32| x >= SIGHT && x + SIGHT < size;
        if !self.rings.is_empty() && inner(at.x, width) && inner(at.y, height) {
            let free = self.map.free_around(at);
            return if free != u8::MAX {
                self.near[usize::from(free)]
            } else if self.map.is_clear(at) {
                (0.0, 0.0)
            } else {
                self.nearest(self.map.window(at))
            };
        }
        let (mut x, mut y, mut count, mut nearest) = (0.0, 0.0, 0_u32, i32::MAX);
        for source in &self.sources {
            if source.squared > nearest {
                break;
            }
            if !self.map.is_obstacle(at.offset(source.offset.0, source.offset.1)) {
                continue;
            }
            match self.settings.obstacle_set {
                ObstacleSet::NearestFirst => return source.force,
                ObstacleSet::NearestMean => nearest = source.squared,
                ObstacleSet::Sum => {}
            }
            x += source.force.0;
            y += source.force.1;
            count += 1;
        }
        if self.settings.obstacle_set == ObstacleSet::NearestMean && count > 1 {
            (x / f64::from(count), y / f64::from(count))
        } else {
            (x, y)
        }
    }
}

impl PotentialField<'_> {
    /// The mean force of the nearest cells of a window; in the order of its bits, which is that of `sources`.
    fn nearest(&self, window: u64) -> (f64, f64) {
        // From the farthest to the nearest, all of them: at which one to stop is hard for a processor to guess.
        let nearer = |hit, ring: &u64| if window & ring != 0 { window & ring } else { hit };
        let hit = self.rings.iter().rev().fold(0, nearer);
        if hit == 0 { (0.0, 0.0) } else { mean(hit, &self.forces) }
    }
}

/// The mean of the forces at the bits set, of which there is one at least.
fn mean(mut bits: u64, forces: &[(f64, f64)]) -> (f64, f64) {
    let count = f64::from(bits.count_ones());
    let (mut x, mut y) = (0.0, 0.0);
    while bits != 0 {
        let force = forces[bits.trailing_zeros() as usize];
        x += force.0;
        y += force.1;
        bits &= bits - 1;
    }
    // Most often there is one.
    if count == 1.0 { (x, y) } else { (x / count, y / count) }
}

/// All offsets within reach, row by row from the south-west: the order in which forces are added.
fn sources(settings: &FieldSettings) -> Vec<Source> {
    let FieldSettings { rho0, k2, .. } = *settings;
    let reach = rho0.ceil() as i32;
    let mut sources = Vec::new();
    for j in -reach..=reach {
        for i in -reach..=reach {
            let squared = i * i + j * j;
            let rho = f64::from(squared).sqrt();
            if squared == 0 || rho > rho0 {
                continue;
            }
            let magnitude = k2 * (1.0 / rho - 1.0 / rho0) / (rho * rho);
            let force = (-f64::from(i) / rho * magnitude, -f64::from(j) / rho * magnitude);
            sources.push(Source { offset: (i, j), squared, force });
        }
    }
    sources
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(drawing: &str, obstacle_set: ObstacleSet, at: Cell) -> (f64, f64) {
        let map = Occupancy::parse(drawing);
        let settings =
            FieldSettings { k1: 0.0, rho0: 2.0, k2: 8.0, attraction: Attraction::Conic, obstacle_set };
        PotentialField::new(&map, at, settings).force(at)
    }

    #[test]
    fn the_nearest_obstacle_repels() {
        // k2 (1/1 - 1/2) / 1 = 4 away from the wall; the cell two to the west is at the end of its reach.
        let at = Cell::new(2, 1);
        assert_eq!(force(".....\n#..#.\n.....", ObstacleSet::NearestMean, at), (-4.0, 0.0));
        assert_eq!(force(".....\n.#.#.\n.....", ObstacleSet::NearestMean, at), (0.0, 0.0));
        assert_eq!(force(".....\n.#.#.\n.....", ObstacleSet::NearestFirst, at), (4.0, 0.0));
        assert_eq!(force("..#..\n.#...\n.....", ObstacleSet::NearestMean, at), (2.0, -2.0));
        assert_eq!(force("..#..\n.#...\n.....", ObstacleSet::Sum, at), (4.0, -4.0));
    }

    /// Equations 5 and 7 are the slopes of 4 and 6: exact differences of the goal's, a sum of small steps of the
    /// obstacles'.
    #[test]
    fn forces_are_the_slopes_of_the_potentials() {
        let map = Occupancy::parse("..........\n..........\n#.........\n..........");
        let (k1, rho0, k2) = (1.5, 4.0, 8.0);
        for attraction in [Attraction::Linear, Attraction::Conic] {
            let settings = FieldSettings { k1, rho0, k2, attraction, obstacle_set: ObstacleSet::NearestMean };
            let field = PotentialField::new(&map, Cell::new(9, 3), settings);
            let at = |x: i32| Cell::new(x, 1);
            if attraction == Attraction::Linear {
                for x in 1..9 {
                    let slope = (field.potentials(at(x + 1)).0 - field.potentials(at(x - 1)).0) / 2.0;
                    assert!((slope + field.attraction(at(x)).0).abs() < 1e-12, "{x}");
                }
            } else {
                assert!((field.potentials(Cell::new(5, 0)).0 - 5.0 * k1).abs() < 1e-12);
            }
            // The work against the push from the end of its reach to x cells before the wall, where it is felt as it is
            // here.
            for x in 1..4 {
                let steps = 10_000;
                let width = (rho0 - f64::from(x)) / f64::from(steps);
                let push = |rho: f64| k2 * (1.0 / rho - 1.0 / rho0) / (rho * rho);
                let work: f64 =
                    (0..steps).map(|k| push(f64::from(x) + (f64::from(k) + 0.5) * width) * width).sum();
                assert!((field.potentials(at(x)).1 - work).abs() < 1e-6, "{x}: {work}");
                assert!((field.repulsion(at(x)).0 - push(f64::from(x))).abs() < 1e-12, "{x}");
            }
            assert_eq!(field.potentials(at(4)).1, 0.0);
            let layer = field.potential_layer();
            assert!(
                (f64::from(layer.data[13]) - field.potentials(at(3)).0 - field.potentials(at(3)).1).abs()
                    < 1e-3
            );
        }
    }

    /// In the middle of a map obstacles are found by its bits, near its border one by one: the same to the last bit.
    #[test]
    fn forces_do_not_depend_on_where_the_map_ends() {
        let mut state = 5_u32;
        let mut random = move |n: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % n
        };
        for round in 0..300 {
            let (mut small, mut large) = (Occupancy::new(7, 7), Occupancy::new(13, 13));
            for _ in 0..round % 8 {
                let cell = Cell::new(random(7) as i32, random(7) as i32);
                if cell != Cell::new(3, 3) {
                    small.set(cell, true);
                    large.set(cell.offset(3, 3), true);
                }
            }
            let rho0 = [1.5, 2.0, 3.0][round % 3];
            let obstacle_set = ObstacleSet::NearestMean;
            let settings =
                FieldSettings { k1: 1.0, rho0, k2: 3.7, attraction: Attraction::Linear, obstacle_set };
            let at = |map, x| {
                PotentialField::new(map, Cell::new(9 + x, 5 + x), settings).force(Cell::new(3 + x, 3 + x))
            };
            let mut slow = PotentialField::new(&small, Cell::new(9, 5), settings);
            slow.rings.clear();
            assert_eq!(at(&large, 3), slow.force(Cell::new(3, 3)));
            assert_eq!(at(&small, 0), slow.force(Cell::new(3, 3)));
        }
    }

    #[test]
    fn the_border_does_not_repel() {
        assert_eq!(force("...", ObstacleSet::Sum, Cell::new(1, 0)), (0.0, 0.0));
    }
}
