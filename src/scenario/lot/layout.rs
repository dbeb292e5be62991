//! The figures by which a lot is drawn.

use crate::vehicle::Vehicle;

/// The car at the entrance.
pub(super) const CAR: Vehicle = Vehicle::SEDAN;

/// How a lot is drawn: metres and radians.
/// Every field has a range that [`Lot::draw`] checks.
///
/// ```
/// use parkade::scenario::lot::Lot;
///
/// let fields = serde_json::json!({ "seed": 3, "rows": 2, "bays": 10, "occupancy": 0.5 });
/// let lot = Lot::from_json(&fields).unwrap();
/// let drawn = lot.draw().unwrap();
/// assert_eq!(drawn.scene.slots.len(), 20);
/// assert_eq!(drawn.scene.slots.iter().filter(|slot| slot.occupied).count(), 10);
/// assert_eq!(drawn, lot.draw().unwrap());
/// ```
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
    /// Width of the rectangle that a bay holds.
    pub bay_width: f64,
    /// Its length; the lines beside an angled bay are longer.
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
