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
pub struct Error(Box<Refusal>);

/// What an [`Error`] says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The kind of input that was refused.
    pub code: ErrorCode,
    /// The field, as a path into the input: `obstacles[2].points[0]`; a line number for imports; empty for the whole.
    pub path: String,
    /// The rule that was broken, with `{}` in the place of each value: the key of a translation.
    pub template: &'static str,
    /// The figures of the rule, and the value that broke it.
    pub values: Vec<String>,
}

impl std::ops::Deref for Error {
    type Target = Refusal;

    fn deref(&self) -> &Refusal {
        &self.0
    }
}

/// A rule with its values; made by `message!`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message {
    template: &'static str,
    values: Vec<String>,
}

impl Message {
    /// Values as people read them, in the places of the template's `{}`.
    #[cold]
    #[inline(never)]
    pub fn new(template: &'static str, values: &[&dyn fmt::Display]) -> Self {
        Self { template, values: values.iter().map(ToString::to_string).collect() }
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_filled(f, self.template, &self.values)
    }
}

impl From<&'static str> for Message {
    fn from(template: &'static str) -> Self {
        Self { template, values: Vec::new() }
    }
}

/// A rule as `format!` would say it, with the template and its values kept apart; formats go to `format_args!`.
macro_rules! message {
    ($template:literal $(, $value:expr)* $(,)?) => {
        $crate::error::Message::new($template, &[$(&$value as &dyn ::core::fmt::Display),*])
    };
}

impl Error {
    /// An error about `path`.
    pub fn new(code: ErrorCode, path: impl Into<String>, message: impl Into<Message>) -> Self {
        let Message { template, values } = message.into();
        Self(Box::new(Refusal { code, path: path.into(), template, values }))
    }

    /// The rule with its values, without the field.
    pub fn message(&self) -> String {
        Message { template: self.template, values: self.values.clone() }.to_string()
    }

    /// The same error about another kind of input.
    #[must_use]
    pub fn with_code(mut self, code: ErrorCode) -> Self {
        self.0.code = code;
        self
    }

    /// The same error about another field.
    #[must_use]
    pub fn with_path(mut self, path: String) -> Self {
        self.0.path = path;
        self
    }

    /// The same error one level further out: `width` inside `map` becomes `map.width`.
    #[must_use]
    #[cold]
    #[inline(never)]
    pub fn within(mut self, outer: &str) -> Self {
        let path = &mut self.0.path;
        if !outer.is_empty() {
            *path = match path.as_str() {
                "" => outer.to_owned(),
                item if item.starts_with('[') => format!("{outer}{item}"),
                field => format!("{outer}.{field}"),
            };
        }
        self
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.path.is_empty() {
            write!(f, "{}: ", self.path)?;
        }
        write_filled(f, self.template, &self.values)
    }
}

/// A text that is shown as it is, and has no translation: the wheel's own.
impl From<String> for Message {
    fn from(text: String) -> Self {
        Self { template: "{}", values: vec![text] }
    }
}

/// Writes values into the places of a template.
fn write_filled(f: &mut fmt::Formatter<'_>, template: &str, values: &[String]) -> fmt::Result {
    let mut parts = template.split("{}");
    f.write_str(parts.next().unwrap_or_default())?;
    for (value, part) in values.iter().zip(parts) {
        f.write_str(value)?;
        f.write_str(part)?;
    }
    Ok(())
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
