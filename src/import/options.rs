//! Options of an import.
//!
//! Every option is checked when it is read, and one that the file decides itself is refused by name: an option
//! without effect would hide a mistake.

use serde_json::{Map, Value};

use crate::error::{Error, ErrorCode, Message};
use crate::scenario::{VehicleSpec, vehicle_spec};

/// Treatment of cells that are neither free nor occupied.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unknown {
    /// Blocked.
    #[default]
    Blocked,
    /// Free.
    Free,
}

/// Options of an import.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// Side of a cell, metres, of maps that do not say; default 1.
    pub resolution: Option<f64>,
    /// Which of the questions gives start and goal, from 0.
    pub query: usize,
    /// Treatment of unknown cells.
    pub unknown: Unknown,
    /// The car; default: a cart as wide as 0.8 cells for maps of cells, `paper` for maps in metres.
    pub vehicle: Option<VehicleSpec>,
}

impl Options {
    /// Reads options: `resolution`, `query`, `unknown` (`blocked` or `free`), `vehicle`.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] with the field and the rule it breaks.
    ///
    /// # Examples
    /// ```
    /// use parkade::import::{Options, Unknown};
    ///
    /// let fields = serde_json::json!({ "unknown": "free", "query": 3 });
    /// let options = Options::from_json(fields.as_object().unwrap()).unwrap();
    /// assert_eq!((options.unknown, options.query), (Unknown::Free, 3));
    ///
    /// let fields = serde_json::json!({ "resolution": 0 });
    /// let error = Options::from_json(fields.as_object().unwrap()).unwrap_err();
    /// assert_eq!(error.to_string(), "resolution: must be 0.001 to 1000 m, got 0");
    /// ```
    pub fn from_json(fields: &Map<String, Value>) -> Result<Self, Error> {
        let mut options = Self::default();
        for (name, value) in fields {
            let bad = |template| Error::new(ErrorCode::Input, name, Message::new(template, &[value]));
            match name.as_str() {
                "resolution" => {
                    let side = value.as_f64().filter(|v| (0.001..=1000.0).contains(v));
                    options.resolution = Some(side.ok_or_else(|| bad("must be 0.001 to 1000 m, got {}"))?);
                }
                "query" => {
                    let query = value.as_u64().and_then(|v| usize::try_from(v).ok());
                    options.query = query.ok_or_else(|| bad("must be a whole number from 0, got {}"))?;
                }
                "unknown" => {
                    options.unknown = match value.as_str() {
                        Some("blocked") => Unknown::Blocked,
                        Some("free") => Unknown::Free,
                        _ => return Err(bad("must be blocked or free, got {}")),
                    }
                }
                "vehicle" => {
                    let vehicle = vehicle_spec::vehicle(value).and_then(|v| v.resolve().map(|_| v));
                    options.vehicle = Some(vehicle.map_err(|e| e.within(name).with_code(ErrorCode::Input))?);
                }
                _ => {
                    let rule = "no option of importScene; there are resolution, query, unknown, vehicle";
                    return Err(Error::new(ErrorCode::Input, name, rule));
                }
            }
        }
        Ok(options)
    }

    /// Files without questions take no number of one.
    pub(super) fn refuse_question(&self) -> Result<(), Error> {
        match self.query {
            0 => Ok(()),
            n => {
                let rule = message!("must be 0 for maps without questions, got {}", n);
                Err(Error::new(ErrorCode::Input, "query", rule))
            }
        }
    }

    /// Files that say everything themselves take no options.
    pub(super) fn refuse_for_scenes(&self) -> Result<(), Error> {
        self.refuse_question()?;
        let refused =
            |name: &str| Error::new(ErrorCode::Input, name, "must be left out: the file says its own");
        match (self.resolution, &self.vehicle) {
            (Some(_), _) => Err(refused("resolution")),
            (_, Some(_)) => Err(refused("vehicle")),
            _ => Ok(()),
        }
    }
}
