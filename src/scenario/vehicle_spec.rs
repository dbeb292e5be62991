//! The car of a scene: a profile's name or dimensions.

use serde::Serialize;
use serde_json::Value;

use crate::error::Error;
use crate::json::{Fields, number};
use crate::vehicle::{DEFAULT_STEER_RATE, Vehicle};

/// The car: a named profile or its own dimensions.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum VehicleSpec {
    /// `paper` or `sedan`.
    Profile(String),
    /// Its own dimensions.
    Custom(Vehicle),
}

impl Default for VehicleSpec {
    fn default() -> Self {
        Self::Profile("paper".to_owned())
    }
}

/// A car: a profile's name or dimensions, not yet checked.
pub(crate) fn vehicle(value: &Value) -> Result<VehicleSpec, Error> {
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
