//! The smallest bays and aisles of the standards, with the standard's own vehicle.
//!
//! Each case is a row of five bays on one side of an aisle with a wall beyond it, the neighbours of the middle bay
//! parked. The standard promises that its vehicle gets in; with a narrower aisle that shall cost moves, or fail.
//!
//! The frame: the aisle runs along +x between y = 0, the wall, and y = `aisle`, where the bays open; bays lean to the
//! right by 90° less their angle. An opening along the aisle is width / sin(angle). All sizes are metres.
//!
//! # Examples
//! ```
//! use parkade::audit::standards::CASES;
//!
//! let case = CASES.iter().find(|case| case.degrees == 45).unwrap();
//! assert!(case.ask(case.aisle).unwrap().reachable);
//! ```

use serde_json::json;

use super::{Options, Way, audit};
use crate::error::Error;
use crate::geometry::{Pose, math};
use crate::scenario::{Entry, Lean, MapFrame, Obstacle, Scenario, Slot, SlotKind, VehicleSpec};
use crate::vehicle::library;

/// Bays in a case; the middle one is asked for.
const BAYS: usize = 5;
/// Room before and behind the row, metres.
const ROOM: f64 = 12.0;
/// Side of a map cell, metres.
const CELL: f64 = 0.25;

/// A size that a standard gives.
///
/// Sizes are those between markings or walls; vehicles are measured without mirrors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    /// The standard, and the table in it.
    pub source: &'static str,
    /// The vehicle in the library.
    pub vehicle: &'static str,
    /// Degrees between aisle and bay.
    pub degrees: u32,
    /// The way in that the standard means.
    pub entry: Entry,
    /// Clear width and length of the bay, metres.
    pub bay: [f64; 2],
    /// Width of the aisle, metres.
    pub aisle: f64,
}

const EAR: &str = "FGSV, Empfehlungen für Anlagen des ruhenden Verkehrs (EAR 05)";
/// The law's text was read, which that of the others was not.
const GARVO: &str = "Garagenverordnung Saarland, § 4";
const JGJ: &str = "JGJ 100-2015, table 4.3.4";

const fn case(
    source: &'static str,
    vehicle: &'static str,
    degrees: u32,
    entry: Entry,
    bay: [f64; 2],
    aisle: f64,
) -> Case {
    Case { source, vehicle, degrees, entry, bay, aisle }
}

/// The standards' sizes.
pub const CASES: [Case; 12] = [
    case(EAR, "german-car", 90, Entry::HeadIn, [2.5, 5.0], 6.0),
    case(EAR, "german-car", 90, Entry::ReverseIn, [2.5, 5.0], 4.5),
    case(EAR, "german-car", 60, Entry::HeadIn, [2.5, 5.0], 4.0),
    case(EAR, "german-car", 45, Entry::HeadIn, [2.5, 5.0], 3.0),
    case(GARVO, "german-car", 90, Entry::HeadIn, [2.5, 5.0], 5.5),
    case(GARVO, "german-car", 90, Entry::HeadIn, [2.3, 5.0], 6.5),
    case(GARVO, "german-car", 60, Entry::HeadIn, [2.3, 5.0], 4.5),
    case(GARVO, "german-car", 45, Entry::HeadIn, [2.3, 5.0], 3.5),
    case(JGJ, "china-small-car", 90, Entry::HeadIn, [2.4, 5.3], 9.0),
    case(JGJ, "china-small-car", 90, Entry::ReverseIn, [2.4, 5.3], 5.5),
    case(JGJ, "china-small-car", 60, Entry::HeadIn, [2.4, 5.3], 4.5),
    case(JGJ, "china-small-car", 45, Entry::HeadIn, [2.4, 5.3], 3.8),
];

impl Case {
    /// The lot, with an aisle of so many metres.
    ///
    /// The start is at the low end of the aisle, in its middle, heading +x.
    ///
    /// # Errors
    /// None for the cases here.
    pub fn scene(&self, aisle: f64) -> Result<Scenario, Error> {
        let angle = math::PI * f64::from(self.degrees) / 180.0;
        let (sin, cos) = math::sin_cos(angle);
        let [width, length] = self.bay;
        let opening = width / sin;
        let (floor, depth) = (2.0 * ROOM + opening * BAYS as f64, length * sin + width * cos);
        let is_angled = self.degrees != 90;
        let slot = |k: usize| Slot {
            id: Some(format!("{}", k + 1)),
            kind: if is_angled { SlotKind::Angled } else { SlotKind::Perpendicular },
            x: ROOM + opening * (k as f64 + 0.5),
            y: aisle,
            heading: math::FRAC_PI_2,
            width,
            length,
            angle: is_angled.then_some(angle),
            lean: is_angled.then_some(Lean::Right),
            occupied: false,
        };
        let slots: Vec<Slot> = (0..BAYS).map(slot).collect();
        let vehicle = library::find(self.vehicle)
            .map_or(crate::vehicle::Vehicle::SEDAN, library::LibraryVehicle::vehicle);
        // The neighbours are cars of the standard as well, not the sedan that stands in occupied bays.
        let obstacles = slots
            .iter()
            .enumerate()
            .filter(|(k, _)| *k != BAYS / 2)
            .map(|(k, slot)| Obstacle::Car {
                id: Some(format!("car {}", k + 1)),
                pose: slot.pose(Entry::ReverseIn, &vehicle),
                vehicle: VehicleSpec::Custom(vehicle),
            })
            .collect();
        let height = aisle + depth;
        let start = Pose::new(vehicle.rear_to_back + 0.5, aisle / 2.0, 0.0);
        Ok(Scenario {
            obstacles,
            slots,
            ..Scenario::new(
                MapFrame {
                    origin: [0.0, 0.0],
                    width: (floor / CELL).ceil() as u32,
                    height: (height / CELL).ceil() as u32,
                    resolution: CELL,
                    boundary: Some(vec![[0.0, 0.0], [floor, 0.0], [floor, height], [0.0, height]]),
                },
                VehicleSpec::Custom(vehicle),
                start,
                start,
            )
        })
    }

    /// The way into the middle bay from an aisle of so many metres.
    ///
    /// # Errors
    /// None for the cases here.
    pub fn ask(&self, aisle: f64) -> Result<Way, Error> {
        let scene = self.scene(aisle)?;
        let entry = if self.entry == Entry::HeadIn { "head-in" } else { "reverse-in" };
        let asked = json!({ "bays": [BAYS / 2], "entries": [entry], "out": false });
        let options = Options::of(&scene, &asked)?;
        let mut rows = audit(&scene, &options, &mut |_| std::ops::ControlFlow::Continue(()))?;
        Ok(rows.remove(0).way)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A narrower aisle costs moves in half of the cases; in the others the standard gives more than its vehicle needs.
    #[test]
    fn the_standards_vehicles_reach_their_bays_and_narrower_aisles_cost_moves() {
        let mut costlier = 0;
        for case in CASES {
            let full = case.ask(case.aisle).unwrap();
            assert!(full.reachable, "{case:?}: {full:?}");
            let cut = case.ask(0.8 * case.aisle).unwrap();
            assert!(!cut.reachable || cut.moves >= full.moves, "{case:?}: {} and {}", full.moves, cut.moves);
            costlier += usize::from(!cut.reachable || cut.moves > full.moves);
        }
        assert!(2 * costlier >= CASES.len(), "only {costlier}");
    }
}
