//! Where everything of a lot stands.
//!
//! A bay holds a rectangle of width w and length ℓ. At the angle α to the aisle it takes w / sin α of the aisle's
//! length, the lines beside it are
//!
//! ```text
//! ℓ + w / tan α
//! ```
//!
//! long, and its row is as deep as they are times sin α: no corner of the rectangle is in the aisle. Everything else
//! follows from these: the rows stand at multiples of the depth, aisles and kerbs between them, and the floor is as
//! long as the longest row with a lane across either end. The kerb between two rows is an obstacle; columns stand on
//! the lines between bays, set back from the aisle.

use super::layout::{CAR, Lot};
use crate::geometry::{Pose, math};
use crate::scenario::{Lean, MapFrame, Obstacle, Scenario, Slot, SlotKind};

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

/// Where everything of a lot stands.
pub(super) struct Plan<'a> {
    lot: &'a Lot,
    /// Length of a bay's mouth along the aisle, of the lines beside it, and depth of a row.
    opening: f64,
    side: f64,
    depth: f64,
    /// Width of the lanes across the aisles' ends.
    cross: f64,
    /// The floor's size.
    width: f64,
    height: f64,
}

impl<'a> Plan<'a> {
    /// Lays a valid lot out; nothing is drawn yet.
    pub(super) fn new(lot: &'a Lot) -> Self {
        let (sin, cos) = math::sin_cos(lot.angle);
        let opening = lot.bay_width / sin;
        let side = lot.bay_length + lot.bay_width * cos / sin;
        let depth = side * sin;
        let cross = CROSS.max(lot.aisle);
        let columns = lot.bays.checked_div(lot.columns).unwrap_or(0);
        let skew = side * cos;
        let length = f64::from(lot.bays) * opening + f64::from(columns) * COLUMN + skew;
        let aisles = f64::from(lot.rows.div_ceil(2));
        let kerbs = f64::from(lot.rows.div_ceil(2) - 1) * KERB;
        let height = aisles * lot.aisle + f64::from(lot.rows) * depth + kerbs;
        Self { lot, opening, side, depth, cross, width: length + 2.0 * cross, height }
    }

    /// The lower edge of an aisle.
    fn aisle(&self, number: u32) -> f64 {
        // A single row lies north of its aisle.
        let south = if self.lot.rows == 1 { 0.0 } else { self.depth };
        south + f64::from(number) * (2.0 * self.depth + self.lot.aisle + KERB)
    }

    /// The floor: a rectangle, with the ramp's corner beside it where there is one.
    pub(super) fn map(&self) -> MapFrame {
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
    pub(super) fn entrance(&self, number: u32) -> Pose {
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
    pub(super) fn fill(&self, row: u32, scene: &mut Scenario) {
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
                length: self.side,
                angle: is_angled.then_some(lot.angle),
                lean: is_angled.then_some(if is_north { Lean::Right } else { Lean::Left }),
                occupied: false,
            });
            x += self.opening;
        }
        let back = mouth + inward * (self.depth + KERB / 2.0);
        if is_north && back < self.height {
            let end = x + self.side * math::sin_cos(lot.angle).1;
            scene.obstacles.push(Obstacle::Rectangle {
                id: Some(format!("kerb-{}", row.div_ceil(2))),
                center: [f64::midpoint(self.cross, end), back],
                size: [end - self.cross, KERB],
                heading: 0.0,
            });
        }
    }

    /// A column between two bays, at `x` along the aisle; `inward` is 1 for rows north of their aisle and −1 south of
    /// it.
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
pub(super) fn letters(mut number: u32) -> String {
    let mut name = String::new();
    loop {
        name.insert(0, char::from(b'A' + (number % 26) as u8));
        if number < 26 {
            return name;
        }
        number = number / 26 - 1;
    }
}
