//! Seeded families of grid maps, the same bits in every language: blocks at random, a lattice of blocks, U-shaped
//! traps.
//!
//! The start is the south-western cell, the goal the north-eastern one. A map in which they are not connected is drawn
//! again from the continuing random stream.
//!
//! A map is a function of family, size and seed: the generator is [`SplitMix64`], every draw is an integer, and no
//! map depends on the order of a hash table or on the machine. A square of two cells at either corner stays free in
//! all families, so that the car can turn out of it.

use super::{MAX_CELLS, MapFrame, Obstacle, Scenario, VehicleSpec};
use crate::error::{Error, ErrorCode};
use crate::geometry::{Pose, math};
use crate::json::{self, Fields};
use crate::map::{Cell, Occupancy, raster};
use crate::vehicle::Vehicle;

/// Maps drawn before a generator gives up on connecting start and goal.
const MAX_DRAWS: u32 = 1000;
/// Blocks tried per random map.
const MAX_TRIES: u32 = 100_000;

/// A car that fits between cells of one metre: 1.5 m × 0.8 m.
pub const CART: Vehicle = Vehicle {
    wheelbase: 1.0,
    width: 0.8,
    rear_to_front: 1.2,
    rear_to_back: 0.3,
    max_steer: 0.6,
    max_steer_rate: 0.6,
};

/// How a map is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Rectangles anywhere.
    Random {
        /// Share of blocked cells, thousandths.
        density_permille: u32,
        /// Shortest side of a rectangle, cells.
        block_min: u32,
        /// Longest side of a rectangle, cells.
        block_max: u32,
    },
    /// A lattice of equal rectangles, its rows shifted against each other.
    Regular,
    /// U-shaped walls of one cell.
    Trap,
}

impl Family {
    /// Random blocks as in the tables: 15 %, of one to three cells a side.
    pub const RANDOM: Self = Self::Random { density_permille: 150, block_min: 1, block_max: 3 };

    /// A number of the family, so that two families with the same seed draw from different streams.
    fn tag(self) -> u64 {
        match self {
            Self::Random { .. } => 0x5241_4E44,
            Self::Regular => 0x5245_4755,
            Self::Trap => 0x5452_4150,
        }
    }

    /// A size that holds the family's shapes, and densities and sides within their ranges.
    fn validate(self, size: u32) -> Result<(), Error> {
        let within = |path: &str, value: u32, min: u32, max: u32| {
            let rule = || message!("must be between {} and {}, got {}", min, max, value);
            if (min..=max).contains(&value) {
                Ok(())
            } else {
                Err(Error::new(ErrorCode::Input, path, rule()))
            }
        };
        within("size", size, if self == Self::Trap { 10 } else { 5 }, MAX_CELLS)?;
        if let Self::Random { density_permille, block_min, block_max } = self {
            within("densityPermille", density_permille, 0, 900)?;
            within("blockMax", block_max, 1, size)?;
            within("blockMin", block_min, 1, block_max)?;
        }
        Ok(())
    }
}

/// Draws a square map of `size` cells a side.
///
/// Row 0 is the southern one, and cells (0, 0) and (size − 1, size − 1) are free and connected by steps between free
/// cells. Drawing costs O(size²) a try.
///
/// # Errors
/// [`ErrorCode::Input`] when a parameter is out of range, or when a thousand maps did not connect start and goal.
pub fn occupancy(family: Family, size: u32, seed: u64) -> Result<Occupancy, Error> {
    family.validate(size)?;
    let mut random =
        SplitMix64::new(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ u64::from(size) << 32 ^ family.tag());
    let goal = Cell::new(size as i32 - 1, size as i32 - 1);
    for _ in 0..MAX_DRAWS {
        let map = match family {
            Family::Random { density_permille, block_min, block_max } => {
                draw_random(&mut random, size, density_permille, (block_min, block_max))
            }
            Family::Regular => draw_regular(&mut random, size, seed == 0),
            Family::Trap => draw_traps(&mut random, size),
        };
        if map.connected(Cell::new(0, 0), goal) {
            return Ok(map);
        }
    }
    Err(Error::new(ErrorCode::Input, "seed", message!("must give a map with a way through, got {}", seed)))
}

/// Draws a scene: one metre per cell, the centre of cell (0, 0) at the origin, and a [`CART`] to drive.
///
/// # Errors
/// As [`occupancy`].
///
/// # Examples
/// ```
/// use parkade::scenario::generate::{Family, generate};
///
/// let scene = generate(Family::RANDOM, 40, 7).unwrap();
/// assert_eq!((scene.map.width, scene.map.resolution), (40, 1.0));
/// // The same seed draws the same scene.
/// assert_eq!(scene, generate(Family::RANDOM, 40, 7).unwrap());
/// ```
pub fn generate(family: Family, size: u32, seed: u64) -> Result<Scenario, Error> {
    let map = occupancy(family, size, seed)?;
    let end = f64::from(size - 1);
    // A quarter of a cell inwards, still in the corner cells: room to turn out of the corner.
    let start = Pose::new(0.25, 0.25, math::PI / 4.0);
    let goal = Pose::new(end - 0.25, end - 0.25, -3.0 * math::PI / 4.0);
    let frame = MapFrame { origin: [-0.5, -0.5], width: size, height: size, resolution: 1.0, boundary: None };
    Ok(Scenario {
        obstacles: vec![Obstacle::Cells { id: None, runs: raster::to_runs(&map) }],
        ..Scenario::new(frame, VehicleSpec::Custom(CART), start, goal)
    })
}

/// Draws the scene that JSON fields ask for: `family` (`random`, `regular` or `trap`), `size`, `seed`, and for `random`
/// `densityPermille`, `blockMin` and `blockMax`, which default to [`Family::RANDOM`]'s.
///
/// # Errors
/// [`ErrorCode::Input`] with the field and the rule it breaks.
///
/// # Examples
/// ```
/// let scene = parkade::scenario::generate::from_json(&serde_json::json!({ "family": "trap", "size": 30, "seed": 2 }));
/// assert_eq!(scene.unwrap().map.width, 30);
/// ```
pub fn from_json(value: &serde_json::Value) -> Result<Scenario, Error> {
    const RECTANGLES: [&str; 3] = ["densityPermille", "blockMin", "blockMax"];
    let f = Fields::of(value, &["family", "size", "seed", RECTANGLES[0], RECTANGLES[1], RECTANGLES[2]])?;
    let whole = |value: &serde_json::Value| {
        let seed = value.as_u64();
        seed.map_or_else(|| json::bad("", message!("must be a whole number from 0, got {}", value)), Ok)
    };
    let families =
        json::word(&[("random", Family::RANDOM), ("regular", Family::Regular), ("trap", Family::Trap)]);
    let family = match f.need("family", families)? {
        Family::Random { density_permille, block_min, block_max } => Family::Random {
            density_permille: f.maybe(RECTANGLES[0], json::count)?.unwrap_or(density_permille),
            block_min: f.maybe(RECTANGLES[1], json::count)?.unwrap_or(block_min),
            block_max: f.maybe(RECTANGLES[2], json::count)?.unwrap_or(block_max),
        },
        other => {
            let given = RECTANGLES.iter().find(|name| value.get(name).is_some_and(|v| !v.is_null()));
            if let Some(name) = given {
                return json::bad(name, "must be left out: only random maps have it".into());
            }
            other
        }
    };
    generate(family, f.need("size", json::count)?, f.need("seed", whole)?)
}

/// Sebastiano Vigna's `SplitMix64`.
/// 64 bits of state and of output, a period of 2⁶⁴, every seed as good as another. It is quick and passes the usual
/// tests of randomness; it is no generator for secrets.
#[derive(Debug, Clone)]
pub struct SplitMix64(u64);

impl SplitMix64 {
    /// The generator in this state.
    pub const fn new(state: u64) -> Self {
        Self(state)
    }

    /// The next 64 bits.
    pub const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = self.0;
        let z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    /// True with this probability, in millionths.
    pub fn chance(&mut self, probability: f64) -> bool {
        f64::from(self.below(1_000_000)) < probability * 1e6
    }

    /// A number below `n`.
    /// By multiplication instead of division; for small n, as here, no number is noticeably preferred.
    pub const fn below(&mut self, n: u32) -> u32 {
        (((self.next() >> 32) * n as u64) >> 32) as u32
    }
}

/// True if a rectangle reaches into the corners around start and goal, which stay free.
fn in_keep_out(size: u32, x: u32, y: u32, width: u32, height: u32) -> bool {
    x <= 1 && y <= 1 || x + width + 1 >= size && y + height + 1 >= size
}

/// Blocks a cell; tells whether it was free.
fn block(map: &mut Occupancy, x: u32, y: u32) -> bool {
    let cell = Cell::new(x as i32, y as i32);
    let fresh = !map.blocked(cell);
    map.set(cell, true);
    fresh
}

/// Rectangles at random places until so many thousandths of the cells are blocked, overlaps counted once.
fn draw_random(random: &mut SplitMix64, size: u32, permille: u32, (min, max): (u32, u32)) -> Occupancy {
    let mut map = Occupancy::new(size, size);
    let target = u64::from(size) * u64::from(size) * u64::from(permille) / 1000;
    let mut blocked = 0;
    for _ in 0..MAX_TRIES {
        if blocked >= target {
            break;
        }
        let width = min + random.below(max - min + 1);
        let height = min + random.below(max - min + 1);
        let x = random.below(size - width + 1);
        let y = random.below(size - height + 1);
        if in_keep_out(size, x, y, width, height) {
            continue;
        }
        for (x, y) in (y..y + height).flat_map(|y| (x..x + width).map(move |x| (x, y))) {
            blocked += u64::from(block(&mut map, x, y));
        }
    }
    map
}

/// Rectangles in rows, each shifted by none, one or two thirds of a period against the row before; `first` is the
/// fixed pattern of seed 0.
fn draw_regular(random: &mut SplitMix64, size: u32, first: bool) -> Occupancy {
    let (width, height, gap_x, gap_y, shift, offset_x, offset_y) = if first {
        (4, 3, 3, 3, 0, 2, 2)
    } else {
        let (width, height) = (2 + random.below(4), 2 + random.below(4));
        let (gap_x, gap_y) = (3 + random.below(4), 3 + random.below(4));
        let shift = random.below(3) * (width + gap_x) / 3;
        let offset_x = random.below(width + gap_x);
        (width, height, gap_x, gap_y, shift, offset_x, random.below(height + gap_y))
    };
    let (period_x, period_y) = (width + gap_x, height + gap_y);
    let mut map = Occupancy::new(size, size);
    for (x, y) in (0..size).flat_map(|y| (0..size).map(move |x| (x, y))) {
        let row = (y + period_y - offset_y) / period_y;
        let blocked = (y + period_y - offset_y) % period_y < height
            && (x + period_x - offset_x + row * shift) % period_x < width;
        if blocked && !in_keep_out(size, x, y, 1, 1) {
            block(&mut map, x, y);
        }
    }
    map
}

/// Boxes of walls with one open side, one for each 150 cells.
fn draw_traps(random: &mut SplitMix64, size: u32) -> Occupancy {
    let mut map = Occupancy::new(size, size);
    for _ in 0..(size * size / 150).max(1) {
        let (width, height) = (5 + random.below(5), 5 + random.below(5));
        let open = random.below(4);
        let x = random.below(size - width + 1);
        let y = random.below(size - height + 1);
        if in_keep_out(size, x, y, width, height) {
            continue;
        }
        let (east, north) = (x + width - 1, y + height - 1);
        for (side, walls) in [
            (0, (east, east, y, north)),
            (1, (x, east, north, north)),
            (2, (x, x, y, north)),
            (3, (x, east, y, y)),
        ] {
            if side == open {
                continue;
            }
            for (x, y) in (walls.2..=walls.3).flat_map(|y| (walls.0..=walls.1).map(move |x| (x, y))) {
                block(&mut map, x, y);
            }
        }
    }
    map
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stream_is_splitmix64() {
        let mut random = SplitMix64::new(1);
        let first = [random.next(), random.next(), random.next()];
        assert_eq!(first, [0x910a_2dec_8902_5cc1, 0xbeeb_8da1_658e_ec67, 0xf893_a2ee_fb32_555e]);
    }

    #[test]
    fn a_scene_is_valid_and_its_runs_are_its_map() {
        let scene = generate(Family::Trap, 30, 3).unwrap();
        scene.validate().unwrap();
        let Obstacle::Cells { runs, .. } = &scene.obstacles[0] else { panic!("cells") };
        let mut map = Occupancy::new(30, 30);
        raster::runs(&mut map, runs);
        assert_eq!(map, occupancy(Family::Trap, 30, 3).unwrap());
    }

    #[test]
    fn bad_fields_are_named() {
        use serde_json::json;
        let refused = |value| from_json(&value).unwrap_err().to_string();
        for (got, expected) in [
            (refused(json!([])), "must be an object, got []"),
            (refused(json!({ "family": "maze" })), "family: must be random or regular or trap, got \"maze\""),
            (refused(json!({ "family": "trap", "seed": 1 })), "size: missing field"),
            (refused(json!({ "family": "trap", "size": 30 })), "seed: missing field"),
            (
                refused(json!({ "family": "trap", "size": 9, "seed": 1 })),
                "size: must be between 10 and 4096, got 9",
            ),
            (
                refused(json!({ "family": "trap", "size": 30, "seed": -1 })),
                "seed: must be a whole number from 0",
            ),
            (
                refused(json!({ "family": "trap", "size": 30, "seed": 1, "blockMin": 1 })),
                "blockMin: must be left out",
            ),
            (
                refused(json!({ "family": "random", "size": 30, "seed": 1, "block": 1 })),
                "block: unknown field",
            ),
            (
                refused(json!({ "family": "random", "size": 30, "seed": 1, "densityPermille": 901 })),
                "densityPermille: must be between 0 and 900, got 901",
            ),
            (
                refused(json!({ "family": "random", "size": 30, "seed": 1, "blockMin": 4 })),
                "blockMin: must be between 1 and 3, got 4",
            ),
        ] {
            assert!(got.starts_with(expected), "{got}\nis not\n{expected}");
        }
    }

    #[test]
    fn bad_parameters_are_named() {
        let path = |family, size| occupancy(family, size, 1).unwrap_err().path.clone();
        assert_eq!(path(Family::Trap, 4), "size");
        let family = Family::Random { density_permille: 150, block_min: 3, block_max: 2 };
        assert_eq!(path(family, 30), "blockMin");
    }
}
