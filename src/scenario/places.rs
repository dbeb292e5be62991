//! Points, poses and cars from JSON, for all that a scene is made of.
//!
//! These readers are shared by obstacles, slots, lanes, moving boxes, goals and options of an import. They accept any
//! number; bounds are checked by whoever uses the place.

use serde_json::Value;

use super::VehicleSpec;
use crate::error::Error;
use crate::geometry::Pose;
use crate::json::{Fields, exactly, number};
use crate::vehicle::{DEFAULT_STEER_RATE, Vehicle};

type Result<T> = core::result::Result<T, Error>;

/// Two numbers, x and y, metres.
pub(super) fn point(value: &Value) -> Result<[f64; 2]> {
    exactly(number)(value)
}

/// A pose of the rear axle's middle, all three fields required.
pub(crate) fn pose(value: &Value) -> Result<Pose> {
    let f = Fields::of(value, &["x", "y", "heading"])?;
    Ok(Pose::new(f.need("x", number)?, f.need("y", number)?, f.need("heading", number)?))
}

/// A car: a profile's name or dimensions, not yet checked.
pub(crate) fn vehicle(value: &Value) -> Result<VehicleSpec> {
    if let Value::String(name) = value {
        return Ok(VehicleSpec::Profile(name.clone()));
    }
    let known = ["wheelbase", "width", "rearToFront", "rearToBack", "maxSteer", "maxSteerRate"];
    let f = Fields::of(value, &known)?;
    Ok(VehicleSpec::Custom(Vehicle {
        wheelbase: f.need("wheelbase", number)?,
        width: f.need("width", number)?,
        rear_to_front: f.need("rearToFront", number)?,
        rear_to_back: f.need("rearToBack", number)?,
        max_steer: f.need("maxSteer", number)?,
        max_steer_rate: f.maybe("maxSteerRate", number)?.unwrap_or(DEFAULT_STEER_RATE),
    }))
}
