//! Lots with names, like those that people ask about.
//!
//! Values are rounded figures of what is commonly built: aisles of 6 m beside bays at right angles, narrower ones
//! beside angled bays. They are no standard; where a rule of some country must hold, its widths are given as fields.

use serde_json::Value;

use super::layout::Lot;
use crate::error::Error;
use crate::geometry::math;
use crate::json::bad;

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

/// What a preset does not say: twelve bays of 2.50 m by 5 m on either side of an aisle of 6 m.
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

pub(super) const SIXTY_DEGREES: f64 = math::PI / 3.0;

/// Lots like those that people ask about.
///
/// ```
/// use parkade::scenario::lot::PRESETS;
///
/// let station = PRESETS.iter().find(|preset| preset.id == "station").unwrap();
/// let drawn = station.lot.draw().unwrap();
/// assert_eq!((drawn.scene.slots.len(), drawn.entrances.len()), (120, 2));
/// ```
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
        Lot { rows: 2, bays: 16, columns: 3, ramp: 4.0, seed: 7, ..PLAIN },
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

/// An entry of the table.
const fn preset(id: &'static str, title: [&'static str; 2], lot: Lot) -> Preset {
    Preset { id, title, lot }
}

/// The lot of a preset's id, or an error that lists the ids.
pub(super) fn named(value: &Value) -> Result<Lot, Error> {
    let found = PRESETS.iter().find(|preset| value.as_str() == Some(preset.id));
    found.map(|preset| preset.lot).map_or_else(
        || {
            let ids: Vec<&str> = PRESETS.iter().map(|preset| preset.id).collect();
            bad("", message!("must be {}, got {}", ids.join(" or "), value))
        },
        Ok,
    )
}
