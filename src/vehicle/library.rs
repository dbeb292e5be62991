//! Vehicles of standards and of everyday traffic, with their sources.
//!
//! Design guides state a vehicle by its axles, overhangs and turning circles. The kinematic model needs one steering
//! angle instead, and the circles then follow from it: with the rear axle's radius R = wheelbase / tan δ, the width
//! w, the wheelbase L and the distance F from the rear axle to the front bumper,
//!
//! ```text
//! kerb to kerb:  √((R + w/2)² + L²)       the outer front wheel
//! wall to wall:  √((R + w/2)² + F²)       the outer front corner of the body
//! ```
//!
//! Where a source states a circle, a test holds the model's circle to it.

use std::sync::OnceLock;

use serde::Serialize;
use serde_json::Value;

use super::{DEFAULT_STEER_RATE, Vehicle};
use crate::error::Error;
use crate::geometry::math;
use crate::json::{Fields, list, number, owned};

/// A vehicle of the library.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct LibraryVehicle {
    /// Its name in options.
    pub id: String,
    /// Its name for people.
    pub title: Title,
    /// Distance between the axles, metres.
    pub wheelbase: f64,
    /// Front axle to front bumper, metres.
    pub front_overhang: f64,
    /// Rear axle to rear bumper, metres.
    pub rear_overhang: f64,
    /// Full width without mirrors, metres.
    pub width: f64,
    /// Full width with mirrors, metres, where the source states it.
    pub width_with_mirrors: Option<f64>,
    /// Largest steering angle of the middle front wheel, radians.
    pub max_steer: f64,
    /// Radius of the circle of the outer front wheel at full lock, metres, where the source states it.
    pub kerb_radius: Option<f64>,
    /// Radius of the circle of the outer front corner at full lock, metres, where the source states it.
    pub wall_radius: Option<f64>,
    /// Fields that the source leaves open and that were chosen here.
    pub assumed: Vec<String>,
    /// Where the figures are from.
    pub source: String,
}

/// A name in English and Chinese.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Title {
    /// English.
    pub en: String,
    /// Chinese.
    pub zh: String,
}

impl LibraryVehicle {
    /// Its dimensions without mirrors.
    /// It is valid by [`Vehicle::validate`], and its steering speed is [`DEFAULT_STEER_RATE`].
    ///
    /// ```
    /// use parkade::vehicle::library;
    ///
    /// for entry in library::all() {
    ///     let vehicle = entry.vehicle();
    ///     assert!(vehicle.validate().is_ok());
    ///     assert!(vehicle.kerb_radius() < vehicle.wall_radius());
    /// }
    /// ```
    pub fn vehicle(&self) -> Vehicle {
        Vehicle {
            wheelbase: self.wheelbase,
            width: self.width,
            rear_to_front: self.wheelbase + self.front_overhang,
            rear_to_back: self.rear_overhang,
            max_steer: self.max_steer,
            max_steer_rate: DEFAULT_STEER_RATE,
        }
    }
}

impl Vehicle {
    /// Radius of the circle of the outer front wheel at full lock, metres: kerb to kerb is twice as much. The wheel
    /// stands at the body's side.
    pub fn kerb_radius(&self) -> f64 {
        math::hypot(self.min_turning_radius() + self.width / 2.0, self.wheelbase)
    }

    /// Radius of the circle of the outer front corner at full lock, metres: wall to wall is twice as much.
    pub fn wall_radius(&self) -> f64 {
        math::hypot(self.min_turning_radius() + self.width / 2.0, self.rear_to_front)
    }
}

/// All vehicles of the library.
///
/// # Panics
/// Never: a test reads the data.
pub fn all() -> &'static [LibraryVehicle] {
    static ALL: OnceLock<Vec<LibraryVehicle>> = OnceLock::new();
    ALL.get_or_init(|| {
        let data = serde_json::from_str(include_str!("library.json")).unwrap_or_default();
        list(read)(&data).expect("the library's data is valid")
    })
}

const FIELDS: &[&str] = &[
    "id",
    "title",
    "wheelbase",
    "frontOverhang",
    "rearOverhang",
    "width",
    "widthWithMirrors",
    "maxSteer",
    "kerbRadius",
    "wallRadius",
    "assumed",
    "source",
];

/// Reads a vehicle of the table. Figures that its source does not state are left out there.
fn read(value: &Value) -> Result<LibraryVehicle, Error> {
    let f = Fields::of(value, FIELDS)?;
    let title = |value: &Value| {
        let f = Fields::of(value, &["en", "zh"])?;
        Ok(Title { en: f.need("en", owned)?, zh: f.need("zh", owned)? })
    };
    Ok(LibraryVehicle {
        id: f.need("id", owned)?,
        title: f.need("title", title)?,
        wheelbase: f.need("wheelbase", number)?,
        front_overhang: f.need("frontOverhang", number)?,
        rear_overhang: f.need("rearOverhang", number)?,
        width: f.need("width", number)?,
        width_with_mirrors: f.maybe("widthWithMirrors", number)?,
        max_steer: f.need("maxSteer", number)?,
        kerb_radius: f.maybe("kerbRadius", number)?,
        wall_radius: f.maybe("wallRadius", number)?,
        assumed: f.need("assumed", list(owned))?,
        source: f.need("source", owned)?,
    })
}

/// The vehicle with an id, if there is one.
/// Ids are compared letter by letter. O(entries).
pub fn find(id: &str) -> Option<&'static LibraryVehicle> {
    all().iter().find(|entry| entry.id == id)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sources round to centimetres, and measure the wheel's circle at the tyre or at the middle of its tread.
    const ROUNDING: f64 = 0.1;

    #[test]
    fn turning_circles_follow_from_wheelbase_and_lock() {
        for entry in all() {
            let vehicle = entry.vehicle();
            assert!(vehicle.validate().is_ok(), "{}", entry.id);
            let stated =
                [(entry.kerb_radius, vehicle.kerb_radius()), (entry.wall_radius, vehicle.wall_radius())];
            assert!(stated.iter().any(|circle| circle.0.is_some()), "{} has no stated circle", entry.id);
            for (stated, computed) in stated {
                let off = stated.map_or(0.0, |stated| (stated - computed).abs());
                assert!(off <= ROUNDING, "{}: stated {stated:?}, computed {computed:.3}", entry.id);
            }
        }
    }

    /// Outer front wheel and outer front corner turn about one centre, on the rear axle's line.
    #[test]
    fn the_circles_of_kerb_and_wall_agree_with_each_other() {
        for entry in all() {
            let vehicle = entry.vehicle();
            let beside = |radius: f64, ahead: f64| (radius * radius - ahead * ahead).sqrt();
            let of_kerb = |radius| beside(radius, vehicle.wheelbase);
            let of_wall = |radius| beside(radius, vehicle.rear_to_front);
            let off = of_kerb(vehicle.kerb_radius()) - of_wall(vehicle.wall_radius());
            assert!(off.abs() < 1e-9, "{}: {off}", entry.id);
            // What a source states of one circle gives the other's within the rounding of both.
            let stated = entry.kerb_radius.map(of_kerb).or(entry.wall_radius.map(of_wall));
            let inner = stated.map_or(0.0, |outer| outer - vehicle.width);
            assert!(inner > 0.0, "{}: no room inside the circle", entry.id);
            assert!((inner + vehicle.width / 2.0 - vehicle.min_turning_radius()).abs() < 0.2, "{}", entry.id);
        }
    }

    #[test]
    fn every_vehicle_has_an_id_of_its_own_and_a_source() {
        for (i, entry) in all().iter().enumerate() {
            assert!(all()[..i].iter().all(|other| other.id != entry.id), "{}", entry.id);
            assert!(Vehicle::profile(&entry.id).is_none(), "{}", entry.id);
            assert!(entry.source.len() > 10 && entry.title.en != entry.title.zh, "{}", entry.id);
            assert!(entry.width_with_mirrors.is_none_or(|width| width > entry.width), "{}", entry.id);
        }
    }
}
