//! Settings that the grid planners share.

use serde_json::Value;

use crate::error::{Error, ErrorCode};
use crate::json::{self, Setting, bad};
use crate::map::Corner;

/// Expansions after which a grid search gives up, unless told otherwise.
pub const MAX_EXPANSIONS: u32 = 20_000_000;

/// How much room the car needs beside the path, as far as the map knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Inflation {
    /// None: the car is a point.
    #[default]
    None,
    /// Half its width: enough while it drives straight.
    Width,
    /// Half its diagonal: enough in every heading.
    HalfDiagonal,
}

json::words!(Inflation: "none" = None, "width" = Width, "half-diagonal" = HalfDiagonal);

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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
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

json::words!(Post: "none" = None, "prune" = Prune, "prune-dp" = PruneDp, "smooth" = Smooth);

/// How corners share the segment between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SmoothMode {
    /// Each corner may use what the one before it left, and half of the segment ahead; arcs shrink until they are free.
    #[default]
    Dynamic,
    /// Each corner tries the whole segment once.
    Paper,
}

json::words!(SmoothMode: "dynamic" = Dynamic, "paper" = Paper);

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

impl Setting for MinRadius {
    fn read(&mut self, value: &Value) -> Result<(), Error> {
        *self = match (value.as_f64(), value.as_str()) {
            (Some(radius), _) => Self::Cells(radius),
            (_, Some("vehicle")) => Self::Vehicle,
            _ => return bad("", format!("must be a number of cells or \"vehicle\", got {value}")),
        };
        Ok(())
    }

    fn write(&self) -> Value {
        match *self {
            Self::Cells(radius) => radius.into(),
            Self::Vehicle => "vehicle".into(),
        }
    }
}

/// What every grid planner's settings say of the map and of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Common {
    /// What a path may do at corners of blocked cells.
    pub corner: Corner,
    /// Room for the car.
    pub inflation: Inflation,
    /// Extra room, metres.
    pub margin: f64,
    /// Passages through which no square of this many cells fits are closed; 1 closes none.
    pub min_passage: u32,
    /// Pockets into which no square of this many cells fits are closed; 1 closes none.
    pub trap_mouth: u32,
    /// What is done to the raw path.
    pub post: Post,
    /// How corners share the segment between them.
    pub smooth_mode: SmoothMode,
    /// Tightest arc of smoothing, cells.
    pub min_radius: MinRadius,
    /// Expansions after which the search gives up.
    pub max_expansions: u32,
}

impl Common {
    /// No safety space, no processing of the path.
    pub const PLAIN: Self = Self {
        corner: Corner::Strict,
        inflation: Inflation::None,
        margin: 0.0,
        min_passage: 1,
        trap_mouth: 1,
        post: Post::None,
        smooth_mode: SmoothMode::Dynamic,
        min_radius: MinRadius::Cells(1.0),
        max_expansions: MAX_EXPANSIONS,
    };

    /// Checks every setting.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        within("margin", self.margin, 0.0, 10.0)?;
        for (name, cells) in [("minPassage", self.min_passage), ("trapMouth", self.trap_mouth)] {
            within(name, f64::from(cells), 1.0, 64.0)?;
            #[cfg(not(feature = "complete"))]
            if cells > 1 {
                let rule = format!("must be 1 without the complete module, got {cells}");
                return Err(Error::new(ErrorCode::Config, name, rule));
            }
        }
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
