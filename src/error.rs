//! The one error type: bad input, named by field, value and rule.
//!
//! An error has a code for programs, the path of the field (`vehicle.wheelbase`, `obstacles[3].points`) and a
//! sentence for people. A scene in which no path exists is not an error but an [`Outcome`](crate::plan::Outcome).

use std::fmt;

/// Which kind of input an [`Error`] is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorCode {
    /// A planner setting.
    Config,
    /// The scene: map, obstacles, slots, poses.
    Scenario,
    /// The vehicle's dimensions.
    Vehicle,
    /// An argument of a call, such as a path to check.
    Input,
    /// A file of another format.
    Import,
    /// No planner has this id.
    UnknownPlanner,
    /// No built-in scene has this id.
    UnknownScenario,
}

impl ErrorCode {
    /// The code as the JS API spells it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Config => "bad-config",
            Self::Scenario => "bad-scenario",
            Self::Vehicle => "bad-vehicle",
            Self::Input => "bad-input",
            Self::Import => "bad-import",
            Self::UnknownPlanner => "unknown-planner",
            Self::UnknownScenario => "unknown-scenario",
        }
    }
}

/// Bad input. A search that finds no path is no error: see [`crate::plan::Plan::outcome`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    /// The kind of input that was refused.
    pub code: ErrorCode,
    /// The field, as a path into the input: `obstacles[2].points[0]`; a line number for imports; empty for the whole.
    pub path: String,
    /// The rule that was broken and the value that broke it.
    pub message: String,
}

impl Error {
    /// An error about `path`.
    pub fn new(code: ErrorCode, path: impl Into<String>, message: impl Into<String>) -> Self {
        Self { code, path: path.into(), message: message.into() }
    }

    /// The same error one level further out: `width` inside `map` becomes `map.width`.
    #[must_use]
    #[cold]
    #[inline(never)]
    pub fn within(mut self, outer: &str) -> Self {
        self.path = match (outer.is_empty(), self.path.is_empty()) {
            (true, _) => self.path,
            (_, true) => outer.to_owned(),
            _ if self.path.starts_with('[') => format!("{outer}{}", self.path),
            _ => format!("{outer}.{}", self.path),
        };
        self
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() {
            write!(f, "{}", self.message)
        } else {
            write!(f, "{}: {}", self.path, self.message)
        }
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_nest() {
        let inner = Error::new(ErrorCode::Scenario, "width", "must be positive, got -1");
        assert_eq!(inner.within("map").to_string(), "map.width: must be positive, got -1");
        let item = Error::new(ErrorCode::Scenario, "[2]", "x").within("obstacles");
        assert_eq!(item.path, "obstacles[2]");
    }
}
