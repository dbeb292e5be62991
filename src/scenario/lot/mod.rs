//! Parking lots by seed: rows of bays along aisles, columns, parked cars, entrances, a ramp.
//!
//! Aisles run from west to east, a row of bays on either side of each; rows back to back are parted by a kerb. Lanes
//! across the ends join the aisles. What the caller leaves open is drawn by the seed.
//!
//! A lot serves tests and audits: many bays, each of which opens to an aisle; whether a car of some size gets in is
//! what an audit finds out. The same fields and seed draw the same lot on every machine.
//!
//! ```text
//!  the next aisle
//!   │ │ │ │ │ │      row of bays, mouths to the north
//!   ├─┼─┼─┼─┼─┤      kerb between rows back to back
//!   │ │ │ │ │ │      row of bays, mouths to the south
//!  entrance →        first aisle
//!   │ │ │ │ │ │      row of bays, mouths to the north
//!   └─┴─┴─┴─┴─┘      the floor's southern edge
//! ```
//!
//! Bays are slots, told from the middle of their mouths ([`super::Slot`]); angled ones are parallelograms. The frame's
//! origin is the south-western corner of the floor, or of the ramp where there is one.

mod layout;
mod plan;
mod presets;

pub use layout::Lot;
pub use presets::{PRESETS, Preset};

use serde_json::Value;

use super::generate::SplitMix64;
use super::{Goal, Scenario, VehicleSpec};
use crate::error::{Error, ErrorCode};
use crate::geometry::{Pose, math};
use crate::json::{Fields, bad, count, number};
use plan::Plan;
use presets::{SIXTY_DEGREES, named};

/// A field as options spell it, its least and greatest value, and its place.
type Field<T> = (&'static str, [f64; 2], fn(&mut Lot) -> &mut T);

/// Whole numbers, with their ranges.
const COUNTS: [Field<u32>; 4] = [
    ("rows", [1.0, 40.0], |lot| &mut lot.rows),
    ("bays", [1.0, 100.0], |lot| &mut lot.bays),
    ("columns", [0.0, 100.0], |lot| &mut lot.columns),
    ("entrances", [1.0, 2.0], |lot| &mut lot.entrances),
];

/// Lengths in metres, an angle in radians and a share, with their ranges.
const NUMBERS: [Field<f64>; 6] = [
    ("angle", [0.5, math::FRAC_PI_2], |lot| &mut lot.angle),
    ("bayWidth", [1.5, 8.0], |lot| &mut lot.bay_width),
    ("bayLength", [2.5, 24.0], |lot| &mut lot.bay_length),
    ("aisle", [2.0, 20.0], |lot| &mut lot.aisle),
    ("occupancy", [0.0, 1.0], |lot| &mut lot.occupancy),
    ("ramp", [0.0, 10.0], |lot| &mut lot.ramp),
];

/// A lot and the poses in which cars come in.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnLot {
    /// The scene; its start is the first entrance, its goal the first free bay.
    pub scene: Scenario,
    /// Each entrance.
    pub entrances: Vec<Pose>,
}

impl Lot {
    /// Reads a lot: a `preset`'s values or, without one, values drawn by the `seed`, with the given fields in their
    /// place.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] with the field and the rule.
    pub fn from_json(value: &Value) -> Result<Self, Error> {
        let names = COUNTS.iter().map(|field| field.0).chain(NUMBERS.iter().map(|field| field.0));
        let known: Vec<&str> = ["preset", "seed"].into_iter().chain(names).collect();
        let f = Fields::of(value, &known)?;
        let seed = f.maybe("seed", whole)?;
        let mut lot = match f.maybe("preset", named)? {
            Some(lot) => lot,
            None => Self::drawn(seed.unwrap_or(1)),
        };
        lot.seed = seed.unwrap_or(lot.seed);
        for (name, _, field) in COUNTS {
            let field = field(&mut lot);
            *field = f.maybe(name, count)?.unwrap_or(*field);
        }
        for (name, _, field) in NUMBERS {
            let field = field(&mut lot);
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

    /// Each field within its range; the ramp, where there is one, no wider than the aisle.
    fn validate(&self) -> Result<(), Error> {
        let within = |name: &str, value: f64, [least, most]: [f64; 2]| {
            if (least..=most).contains(&value) {
                return Ok(());
            }
            let unit = if name == "angle" { " rad" } else { "" };
            bad(name, message!("must be {} to {}{}, got {}", least, most, unit, value))
        };
        let mut lot = *self;
        for (name, range, field) in COUNTS {
            within(name, f64::from(*field(&mut lot)), range)?;
        }
        for (name, range, field) in NUMBERS {
            within(name, *field(&mut lot), range)?;
        }
        if self.ramp != 0.0 {
            within("ramp", self.ramp, [2.0, self.aisle.min(10.0)])?;
        }
        Ok(())
    }

    /// Draws the lot.
    ///
    /// O(bays). The scene is valid, and its slots have ids.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] with the field and the rule.
    pub fn draw(&self) -> Result<DrawnLot, Error> {
        self.validate()?;
        let plan = Plan::new(self);
        let mut scene = Scenario {
            name: Some("lot".to_owned()),
            ..Scenario::new(
                plan.map(),
                VehicleSpec::Profile("sedan".to_owned()),
                plan.entrance(0),
                plan.entrance(0),
            )
        };
        for row in 0..self.rows {
            plan.fill(row, &mut scene);
        }
        self.park(&mut scene);
        if let Some(free) = scene.slots.iter().find(|slot| !slot.occupied) {
            let slot = free.id.clone().unwrap_or_default();
            scene.goal = Goal::Slot(super::SlotGoal { slot, entry: super::Entry::ReverseIn });
        }
        scene.validate().map_err(|e| e.with_code(ErrorCode::Input))?;
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

/// A seed: a whole number of up to 64 bits.
fn whole(value: &Value) -> Result<u64, Error> {
    let whole = value.as_u64();
    whole.map_or_else(|| bad("", message!("must be a whole number from 0, got {}", value)), Ok)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::layout::CAR;
    use super::plan::letters;
    use super::*;
    use crate::geometry::Point;
    use crate::geometry::polygon::contains;
    use crate::scenario::Entry;

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

    /// Cars that stand aslant had their corners in the aisle, which was 1.2 m narrower than asked for.
    #[test]
    fn parked_cars_leave_the_aisles_free() {
        for seed in 0..40 {
            let lot = Lot { occupancy: 1.0, ..Lot::drawn(seed) };
            for slot in lot.draw().unwrap().scene.slots {
                let inward = Pose::new(0.0, 0.0, slot.heading).direction();
                for corner in CAR.outline(slot.pose(Entry::ReverseIn, &CAR)) {
                    let depth = (corner - Point::new(slot.x, slot.y)).dot(&inward);
                    assert!(depth >= 0.0 && depth <= slot.length, "seed {seed}, {:?}: {depth} m", slot.id);
                }
            }
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
