//! Parking lots by seed: rows of bays along aisles, columns, parked cars, entrances, a ramp.
//!
//! Aisles run from west to east, a row of bays on either side of each; rows back to back are parted by a kerb. Lanes
//! across the ends join the aisles. What the caller leaves open is drawn by the seed.

use serde_json::Value;

use super::generate::SplitMix64;
use super::{Goal, Lean, MapFrame, Obstacle, Scenario, Slot, SlotKind, VehicleSpec};
use crate::error::{Error, ErrorCode};
use crate::geometry::{Pose, math};
use crate::json::{Fields, bad, count, number};
use crate::vehicle::Vehicle;

/// The car at the entrance.
const CAR: Vehicle = Vehicle::SEDAN;
/// Side of a map cell, metres.
const CELL: f64 = 0.25;
/// Thickness of kerbs between rows and of the wall beside a ramp, metres.
const KERB: f64 = 0.2;
/// Side of a column, metres, and how far it stands back from the aisle.
const COLUMN: f64 = 0.4;
const SET_BACK: f64 = 0.8;
/// Between the car at the entrance and the wall behind it, metres.
const BEHIND: f64 = 0.5;
/// Length of a ramp before its corner, metres.
const RAMP: f64 = 8.0;
/// Lanes across the ends of aisles are at least this wide, metres.
const CROSS: f64 = 6.0;

/// How a lot is drawn: metres and radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lot {
    /// Number that everything drawn follows from.
    pub seed: u64,
    /// Rows of bays; two share an aisle.
    pub rows: u32,
    /// Bays in each row.
    pub bays: u32,
    /// Angle between aisle and bay: π/6 to π/2.
    pub angle: f64,
    /// Clear width of a bay.
    pub bay_width: f64,
    /// Length of a bay.
    pub bay_length: f64,
    /// Width of the aisles.
    pub aisle: f64,
    /// Bays from one column to the next; 0 for none.
    pub columns: u32,
    /// Share of the bays that are occupied, 0 to 1.
    pub occupancy: f64,
    /// Entrances, 1 or 2.
    pub entrances: u32,
    /// Width of the ramp that joins the first aisle at a right angle; 0 for none.
    pub ramp: f64,
}

/// A lot and the poses in which cars come in.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnLot {
    /// The scene; its start is the first entrance, its goal the first free bay.
    pub scene: Scenario,
    /// Each entrance.
    pub entrances: Vec<Pose>,
}

/// A lot with a name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Preset {
    /// Its name in options.
    pub id: &'static str,
    /// English and Chinese.
    pub title: [&'static str; 2],
    /// How it is drawn.
    pub lot: Lot,
}

const PLAIN: Lot = Lot {
    seed: 1,
    rows: 2,
    bays: 12,
    angle: math::FRAC_PI_2,
    bay_width: 2.5,
    bay_length: 5.0,
    aisle: 6.0,
    columns: 0,
    occupancy: 0.5,
    entrances: 1,
    ramp: 0.0,
};

const SIXTY_DEGREES: f64 = math::PI / 3.0;

/// Lots like those that people ask about.
pub const PRESETS: [Preset; 10] = [
    preset(
        "corner-shop",
        ["Corner shop", "街角小店"],
        Lot { rows: 1, bays: 10, aisle: 6.5, occupancy: 0.4, ..PLAIN },
    ),
    preset("apartment", ["Apartment house", "公寓楼"], Lot { bays: 8, columns: 2, seed: 2, ..PLAIN }),
    preset(
        "supermarket",
        ["Supermarket", "超市"],
        Lot { rows: 4, bays: 15, bay_width: 2.7, aisle: 6.5, seed: 3, ..PLAIN },
    ),
    preset(
        "angled-60",
        ["One-way aisles, 60°", "单行通道，60°"],
        Lot { rows: 4, bays: 14, angle: SIXTY_DEGREES, aisle: 4.5, seed: 4, ..PLAIN },
    ),
    preset(
        "angled-45",
        ["One-way aisles, 45°", "单行通道，45°"],
        Lot { rows: 4, bays: 12, angle: math::FRAC_PI_4, aisle: 3.6, seed: 5, ..PLAIN },
    ),
    preset(
        "basement",
        ["Basement with columns", "带立柱的地下车库"],
        Lot { rows: 4, bays: 12, columns: 3, aisle: 5.8, occupancy: 0.7, seed: 6, ..PLAIN },
    ),
    preset(
        "ramp",
        ["Garage behind a ramp's corner", "坡道直角转弯后的车库"],
        Lot { rows: 2, bays: 16, columns: 3, ramp: 3.6, seed: 7, ..PLAIN },
    ),
    preset(
        "old-town",
        ["Old narrow garage", "狭窄的老车库"],
        Lot { bays: 14, bay_width: 2.3, aisle: 5.2, columns: 2, occupancy: 0.6, seed: 8, ..PLAIN },
    ),
    preset(
        "station",
        ["Railway station", "火车站"],
        Lot { rows: 6, bays: 20, occupancy: 0.8, entrances: 2, seed: 9, ..PLAIN },
    ),
    preset(
        "stadium",
        ["Stadium", "体育场"],
        Lot { rows: 8, bays: 30, bay_width: 2.4, occupancy: 0.6, entrances: 2, seed: 10, ..PLAIN },
    ),
];

const fn preset(id: &'static str, title: [&'static str; 2], lot: Lot) -> Preset {
    Preset { id, title, lot }
}

impl Lot {
    /// Reads a lot: a `preset`'s values or, without one, values drawn by the `seed`, with the given fields in their
    /// place.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] with the field and the rule.
    pub fn from_json(value: &Value) -> Result<Self, Error> {
        let known = [
            "preset",
            "seed",
            "rows",
            "bays",
            "angle",
            "bayWidth",
            "bayLength",
            "aisle",
            "columns",
            "occupancy",
            "entrances",
            "ramp",
        ];
        let f = Fields::of(value, &known)?;
        let seed = f.maybe("seed", whole)?;
        let mut lot = match f.maybe("preset", named)? {
            Some(lot) => lot,
            None => Self::drawn(seed.unwrap_or(1)),
        };
        lot.seed = seed.unwrap_or(lot.seed);
        for (name, field) in [
            ("rows", &mut lot.rows),
            ("bays", &mut lot.bays),
            ("columns", &mut lot.columns),
            ("entrances", &mut lot.entrances),
        ] {
            *field = f.maybe(name, count)?.unwrap_or(*field);
        }
        for (name, field) in [
            ("angle", &mut lot.angle),
            ("bayWidth", &mut lot.bay_width),
            ("bayLength", &mut lot.bay_length),
            ("aisle", &mut lot.aisle),
            ("occupancy", &mut lot.occupancy),
            ("ramp", &mut lot.ramp),
        ] {
            *field = f.maybe(name, number)?.unwrap_or(*field);
        }
        lot.validate()?;
        Ok(lot)
    }

    /// What a seed draws.
    fn drawn(seed: u64) -> Self {
        let mut random = SplitMix64::new(seed ^ 0x4C4F_5453);
        let mut between = |from: u32, to: u32| from + random.below(to - from + 1);
        let angle = [math::FRAC_PI_2, SIXTY_DEGREES, math::FRAC_PI_4][between(0, 2) as usize];
        // About what is built for a bay at this angle, and half a metre less or more.
        let usual = if angle > 1.5 {
            6.0
        } else if angle > 1.0 {
            4.5
        } else {
            3.6
        };
        Self {
            seed,
            rows: between(1, 6),
            bays: between(6, 20),
            angle,
            bay_width: f64::from(between(23, 28)) / 10.0,
            bay_length: f64::from(between(48, 54)) / 10.0,
            aisle: usual + f64::from(between(0, 10)) / 10.0 - 0.5,
            columns: [0, 0, 2, 3][between(0, 3) as usize],
            occupancy: f64::from(between(2, 9)) / 10.0,
            entrances: between(1, 2),
            ramp: 0.0,
        }
    }

    fn validate(&self) -> Result<(), Error> {
        let within = |name: &str, value: f64, [least, most]: [f64; 2]| {
            if (least..=most).contains(&value) {
                return Ok(());
            }
            bad(name, format!("must be {least} to {most}, got {value}"))
        };
        within("rows", self.rows.into(), [1.0, 40.0])?;
        within("bays", self.bays.into(), [1.0, 100.0])?;
        within("angle", self.angle, [0.5, math::FRAC_PI_2])?;
        within("bayWidth", self.bay_width, [1.5, 8.0])?;
        within("bayLength", self.bay_length, [2.5, 24.0])?;
        within("aisle", self.aisle, [2.0, 20.0])?;
        within("columns", self.columns.into(), [0.0, 100.0])?;
        within("occupancy", self.occupancy, [0.0, 1.0])?;
        within("entrances", self.entrances.into(), [1.0, 2.0])?;
        if self.ramp != 0.0 {
            within("ramp", self.ramp, [2.0, self.aisle.min(10.0)])?;
        }
        Ok(())
    }

    /// Draws the lot.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] with the field and the rule.
    pub fn draw(&self) -> Result<DrawnLot, Error> {
        self.validate()?;
        let plan = Plan::new(self);
        let mut scene = Scenario {
            version: 1,
            name: Some("lot".to_owned()),
            map: plan.map(),
            obstacles: Vec::new(),
            slots: Vec::new(),
            costs: Vec::new(),
            moving: Vec::new(),
            lanes: Vec::new(),
            speed_limits: Vec::new(),
            vehicle: VehicleSpec::Profile("sedan".to_owned()),
            start: plan.entrance(0),
            goal: Goal::Pose(plan.entrance(0)),
            planners: std::collections::BTreeMap::new(),
        };
        for row in 0..self.rows {
            plan.fill(row, &mut scene);
        }
        self.park(&mut scene);
        if let Some(free) = scene.slots.iter().find(|slot| !slot.occupied) {
            let slot = free.id.clone().unwrap_or_default();
            scene.goal = Goal::Slot(super::SlotGoal { slot, entry: super::Entry::ReverseIn });
        }
        scene.validate().map_err(|e| Error { code: ErrorCode::Input, ..e })?;
        Ok(DrawnLot { scene, entrances: (0..self.entrances).map(|k| plan.entrance(k)).collect() })
    }

    /// Occupies some bays: the first of a shuffled list.
    fn park(&self, scene: &mut Scenario) {
        let mut random = SplitMix64::new(self.seed);
        let mut order: Vec<usize> = (0..scene.slots.len()).collect();
        for last in (1..order.len()).rev() {
            order.swap(last, random.below(last as u32 + 1) as usize);
        }
        let occupied = (self.occupancy * order.len() as f64).round() as usize;
        for &at in &order[..occupied] {
            scene.slots[at].occupied = true;
        }
    }
}

fn whole(value: &Value) -> Result<u64, Error> {
    let whole = value.as_u64();
    whole.map_or_else(|| bad("", format!("must be a whole number from 0, got {value}")), Ok)
}

fn named(value: &Value) -> Result<Lot, Error> {
    let found = PRESETS.iter().find(|preset| value.as_str() == Some(preset.id));
    found.map(|preset| preset.lot).map_or_else(
        || {
            let ids: Vec<&str> = PRESETS.iter().map(|preset| preset.id).collect();
            bad("", format!("must be {}, got {value}", ids.join(" or ")))
        },
        Ok,
    )
}

/// Where everything of a lot stands.
struct Plan<'a> {
    lot: &'a Lot,
    /// Length of a bay's mouth along the aisle, and depth of a row.
    opening: f64,
    depth: f64,
    /// Width of the lanes across the aisles' ends.
    cross: f64,
    /// The floor's size.
    width: f64,
    height: f64,
}

impl<'a> Plan<'a> {
    fn new(lot: &'a Lot) -> Self {
        let (sin, cos) = math::sin_cos(lot.angle);
        let opening = lot.bay_width / sin;
        let depth = lot.bay_length * sin + lot.bay_width * cos;
        let cross = CROSS.max(lot.aisle);
        let columns = lot.bays.checked_div(lot.columns).unwrap_or(0);
        let skew = lot.bay_length * cos;
        let length = f64::from(lot.bays) * opening + f64::from(columns) * COLUMN + skew;
        let aisles = f64::from(lot.rows.div_ceil(2));
        let kerbs = f64::from(lot.rows.div_ceil(2) - 1) * KERB;
        let height = aisles * lot.aisle + f64::from(lot.rows) * depth + kerbs;
        Self { lot, opening, depth, cross, width: length + 2.0 * cross, height }
    }

    /// The lower edge of an aisle.
    fn aisle(&self, number: u32) -> f64 {
        // A single row lies north of its aisle.
        let south = if self.lot.rows == 1 { 0.0 } else { self.depth };
        south + f64::from(number) * (2.0 * self.depth + self.lot.aisle + KERB)
    }

    fn map(&self) -> MapFrame {
        let cells = |metres: f64| (metres / CELL).ceil() as u32;
        let (width, height) = (self.width, self.height);
        let plain = vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
        if self.lot.ramp == 0.0 {
            return MapFrame {
                origin: [0.0, 0.0],
                width: cells(width),
                height: cells(height),
                resolution: CELL,
                boundary: Some(plain),
            };
        }
        let low = self.aisle(0);
        let (left, right, bottom, top) = (-KERB - self.lot.ramp, -KERB, low - RAMP, low + self.lot.ramp);
        let ramp = [[0.0, top], [left, top], [left, bottom], [right, bottom], [right, low], [0.0, low]];
        let y = bottom.min(0.0);
        MapFrame {
            origin: [left, y],
            width: cells(width - left),
            height: cells(height - y),
            resolution: CELL,
            boundary: Some(plain.into_iter().chain(ramp).collect()),
        }
    }

    /// Where cars come in: by the first aisle or the ramp, by the last aisle.
    fn entrance(&self, number: u32) -> Pose {
        let behind = CAR.rear_to_back + BEHIND;
        if number == 0 && self.lot.ramp > 0.0 {
            let low = self.aisle(0);
            return Pose::new(-KERB - self.lot.ramp / 2.0, low - RAMP + behind, math::FRAC_PI_2);
        }
        let last = self.lot.rows.div_ceil(2) - 1;
        let (aisle, x, heading) =
            if number == 0 { (0, behind, 0.0) } else { (last, self.width - behind, math::PI) };
        Pose::new(x, self.aisle(aisle) + self.lot.aisle / 2.0, heading)
    }

    /// Adds a row of bays, its columns and the kerb behind it.
    fn fill(&self, row: u32, scene: &mut Scenario) {
        let lot = self.lot;
        let is_north = lot.rows == 1 || row % 2 == 1;
        let low = self.aisle(row / 2);
        let (mouth, inward) = if is_north { (low + lot.aisle, 1.0) } else { (low, -1.0) };
        let is_angled = lot.angle < math::FRAC_PI_2 - 1e-9;
        let mut x = self.cross;
        for bay in 0..lot.bays {
            if lot.columns > 0 && bay > 0 && bay % lot.columns == 0 {
                scene.obstacles.push(self.column(x, mouth, inward, scene.obstacles.len()));
                x += COLUMN;
            }
            scene.slots.push(Slot {
                id: Some(format!("{}{}", letters(row), bay + 1)),
                kind: if is_angled { SlotKind::Angled } else { SlotKind::Perpendicular },
                x: x + self.opening / 2.0,
                y: mouth,
                heading: inward * math::FRAC_PI_2,
                width: lot.bay_width,
                length: lot.bay_length,
                angle: is_angled.then_some(lot.angle),
                lean: is_angled.then_some(if is_north { Lean::Right } else { Lean::Left }),
                occupied: false,
            });
            x += self.opening;
        }
        let back = mouth + inward * (self.depth + KERB / 2.0);
        if is_north && back < self.height {
            let end = x + lot.bay_length * math::sin_cos(lot.angle).1;
            scene.obstacles.push(Obstacle::Rectangle {
                id: Some(format!("kerb-{}", row.div_ceil(2))),
                center: [f64::midpoint(self.cross, end), back],
                size: [end - self.cross, KERB],
                heading: 0.0,
            });
        }
    }

    fn column(&self, x: f64, mouth: f64, inward: f64, number: usize) -> Obstacle {
        let along = math::sin_cos(self.lot.angle).1 / math::sin_cos(self.lot.angle).0;
        let depth = SET_BACK + COLUMN / 2.0;
        Obstacle::Rectangle {
            id: Some(format!("column-{}", number + 1)),
            center: [x + COLUMN / 2.0 + depth * along, mouth + inward * depth],
            size: [COLUMN, COLUMN],
            heading: 0.0,
        }
    }
}

/// A, B, …, Z, AA, ….
fn letters(mut number: u32) -> String {
    let mut name = String::new();
    loop {
        name.insert(0, char::from(b'A' + (number % 26) as u8));
        if number < 26 {
            return name;
        }
        number = number / 26 - 1;
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::vehicle::collision::contains;

    #[test]
    fn every_preset_has_its_bays_and_entrances_on_the_floor() {
        let mut large = 0;
        for preset in &PRESETS {
            let drawn = preset.lot.draw().unwrap();
            let geometry = drawn.scene.geometry().unwrap();
            assert_eq!(
                drawn.scene.slots.len(),
                (preset.lot.rows * preset.lot.bays) as usize,
                "{}",
                preset.id
            );
            large += usize::from(drawn.scene.slots.len() >= 120);
            for slot in &drawn.scene.slots {
                let middle = nalgebra::center(&slot.outline()[0], &slot.outline()[2]);
                assert!(contains(&geometry.boundary, middle), "{} {:?}", preset.id, slot.id);
            }
            for entrance in &drawn.entrances {
                for corner in CAR.outline(*entrance) {
                    assert!(contains(&geometry.boundary, corner), "{}", preset.id);
                }
            }
        }
        assert!(large >= 2);
    }

    #[test]
    fn bays_of_a_row_do_not_overlap_and_lie_beside_their_aisle() {
        for seed in 0..40 {
            let lot = Lot::drawn(seed);
            let scene = lot.draw().unwrap().scene;
            for pair in scene.slots.windows(2).filter(|pair| pair[0].y == pair[1].y) {
                let apart = (pair[1].x - pair[0].x) * math::sin(lot.angle);
                assert!(apart >= lot.bay_width - 1e-9, "seed {seed}");
            }
            let occupied = scene.slots.iter().filter(|slot| slot.occupied).count();
            assert!((occupied as f64 - lot.occupancy * scene.slots.len() as f64).abs() <= 0.5, "seed {seed}");
        }
    }

    #[test]
    fn seeds_draw_different_lots_and_fields_take_their_place() {
        let drawn = |value: Value| Lot::from_json(&value).unwrap();
        assert_ne!(drawn(json!({ "seed": 1 })), drawn(json!({ "seed": 2 })));
        assert_eq!(drawn(json!({ "seed": 5, "rows": 3 })), Lot { rows: 3, ..Lot::drawn(5) });
        assert_eq!(drawn(json!({ "preset": "ramp", "aisle": 5.0 })), Lot { aisle: 5.0, ..PRESETS[6].lot });
        let refused = |value: Value| Lot::from_json(&value).unwrap_err().to_string();
        assert_eq!(refused(json!({ "rows": 0 })), "rows: must be 1 to 40, got 0");
        assert!(refused(json!({ "preset": "moon" })).starts_with("preset: must be corner-shop or"));
        assert_eq!(letters(0) + &letters(25) + &letters(26) + &letters(52), "AZAABA");
    }
}
