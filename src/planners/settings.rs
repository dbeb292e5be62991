//! Settings that the grid planners share.

use serde::de::{self, Deserializer, Visitor};
use serde::ser::Serializer;
use serde::{Deserialize, Serialize};
use std::fmt;

use crate::error::{Error, ErrorCode};

/// Expansions after which a grid search gives up, unless told otherwise.
pub const MAX_EXPANSIONS: u32 = 20_000_000;

/// How much room the car needs beside the path, as far as the map knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Inflation {
    /// None: the car is a point.
    #[default]
    None,
    /// Half its width: enough while it drives straight.
    Width,
    /// Half its diagonal: enough in every heading.
    HalfDiagonal,
}

impl Inflation {
    /// The radius in metres for a car of this length and width (metres), and extra `margin`; `None` for no inflation.
    pub fn radius(self, length: f64, width: f64, margin: f64) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Width => Some(width / 2.0 + margin),
            Self::HalfDiagonal => Some((length * length + width * width).sqrt() / 2.0 + margin),
        }
    }
}

/// What is done to the raw path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Post {
    /// Nothing.
    #[default]
    None,
    /// Skip cells that are not needed, in one pass (the paper).
    Prune,
    /// The shortest way over the path's own cells.
    PruneDp,
    /// Prune, then round the corners with tangent arcs.
    Smooth,
}

/// How corners share the segment between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SmoothMode {
    /// Each corner may use what the one before it left, and half of the segment ahead; arcs shrink until they are free.
    #[default]
    Dynamic,
    /// Each corner tries the whole segment once.
    Paper,
}

/// The tightest arc that smoothing may put in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MinRadius {
    /// A radius in cells.
    Cells(f64),
    /// The car's own minimum turning radius.
    Vehicle,
}

impl MinRadius {
    /// The radius in cells, for a car that turns in `vehicle` metres on cells of `resolution` metres.
    pub fn in_cells(self, vehicle: f64, resolution: f64) -> f64 {
        match self {
            Self::Cells(radius) => radius,
            Self::Vehicle => vehicle / resolution,
        }
    }
}

impl Serialize for MinRadius {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match *self {
            Self::Cells(radius) => serializer.serialize_f64(radius),
            Self::Vehicle => serializer.serialize_str("vehicle"),
        }
    }
}

impl<'de> Deserialize<'de> for MinRadius {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Words;
        impl Visitor<'_> for Words {
            type Value = MinRadius;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a number of cells or \"vehicle\"")
            }
            fn visit_f64<E: de::Error>(self, v: f64) -> Result<MinRadius, E> {
                Ok(MinRadius::Cells(v))
            }
            fn visit_u64<E: de::Error>(self, v: u64) -> Result<MinRadius, E> {
                Ok(MinRadius::Cells(v as f64))
            }
            fn visit_i64<E: de::Error>(self, v: i64) -> Result<MinRadius, E> {
                Ok(MinRadius::Cells(v as f64))
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<MinRadius, E> {
                if v == "vehicle" {
                    Ok(MinRadius::Vehicle)
                } else {
                    Err(E::invalid_value(de::Unexpected::Str(v), &self))
                }
            }
        }
        deserializer.deserialize_any(Words)
    }
}

/// The part of a grid planner's settings that every one of them has, for the checks they share.
pub(super) struct Shared {
    pub(super) margin: f64,
    pub(super) min_radius: MinRadius,
    pub(super) max_expansions: u32,
}

impl Shared {
    pub(super) fn validate(&self) -> Result<(), Error> {
        within("margin", self.margin, 0.0, 10.0)?;
        if let MinRadius::Cells(radius) = self.min_radius {
            within("minRadius", radius, 0.0, 1000.0)?;
        }
        if self.max_expansions == 0 || self.max_expansions > 100_000_000 {
            let rule = format!("must be between 1 and 100000000, got {}", self.max_expansions);
            return Err(Error::new(ErrorCode::Config, "maxExpansions", rule));
        }
        Ok(())
    }
}

/// Checks that a setting is a number in a closed range.
///
/// # Errors
/// [`ErrorCode::Config`] with the field's name and the rule.
pub(super) fn within(path: &str, value: f64, min: f64, max: f64) -> Result<(), Error> {
    if value >= min && value <= max {
        return Ok(());
    }
    Err(Error::new(ErrorCode::Config, path, format!("must be between {min} and {max}, got {value}")))
}
