//! Points and poses from JSON, for all that a scene is made of.
//!
//! These readers are shared by obstacles, slots, lanes, moving boxes, goals and options of an import. They accept any
//! number; bounds are checked by whoever uses the place.

use serde_json::Value;

use crate::error::Error;
use crate::geometry::Pose;
use crate::json::{Fields, exactly, number};

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
