//! The planners' parameters: a parameter is declared once, with its field, default, range, unit and words for people.
//!
//! `parameters!` makes of such a table the settings' struct, its defaults, the reading and writing of JSON, and the
//! list that the registry hands out. From that list follow the checks of ranges, the types of the npm package
//! (`settings.d.ts`), the page's inspector and the tables of the documentation. To add a parameter is to add one
//! entry:
//!
//! ```text
//! /// Extra metres accepted to avoid one gear change.          for readers of the crate
//! direction_change_cost: f64 = 1.0,                            field and default
//!     spec("directionChangeCost", Form::Number(0.0, 10.0, 0.5), "m", true,   JSON name, slider, unit, shown at once
//!          ["Gear-change cost", "换挡代价"], ["…", "…"])        title and effect, in English and Chinese
//!         .within(0.0, 1000.0);                                values that are accepted, where the slider is narrower
//! ```
//!
//! A setting that several planners share is a struct of its own, laid in by `shared`; a planner may leave one of its
//! fields out by name.

use serde_json::{Map, Value};

use super::info::{Parameter, Text};
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::json::{self, Setting};

/// A parameter's facts besides its type and default.
#[derive(Clone, Copy)]
pub(crate) struct ParameterSpec {
    pub(super) name: &'static str,
    form: Form,
    unit: &'static str,
    basic: bool,
    /// English and Chinese.
    title: [&'static str; 2],
    doc: [&'static str; 2],
    /// The values that planners take.
    range: Option<(f64, f64)>,
    is_complete_only: bool,
}

/// How people enter it; numbers by sliders from the first figure to the second, in steps of the third.
#[derive(Clone, Copy)]
pub(super) enum Form {
    Number(f64, f64, f64),
    Integer(f64, f64),
    Flag,
    Choice(&'static [&'static str]),
    /// A number or one of these words.
    NumberOr(f64, f64, f64, &'static [&'static str]),
}

/// A parameter without a range.
pub(super) const fn spec(
    name: &'static str,
    form: Form,
    unit: &'static str,
    basic: bool,
    title: [&'static str; 2],
    doc: [&'static str; 2],
) -> ParameterSpec {
    ParameterSpec { name, form, unit, basic, title, doc, range: None, is_complete_only: false }
}

impl ParameterSpec {
    /// The same with the values that planners take; a slider's range may be narrower.
    pub(super) const fn within(self, min: f64, max: f64) -> Self {
        Self { range: Some((min, max)), ..self }
    }

    /// The same for the complete module; the small one takes 1, and has no words for it.
    pub(super) const fn complete_only(self) -> Self {
        let (title, doc) = if IS_COMPLETE { (self.title, self.doc) } else { ([""; 2], [""; 2]) };
        Self { is_complete_only: true, title, doc, ..self }
    }

    /// True if this module has it.
    pub(super) fn is_listed(&self) -> bool {
        IS_COMPLETE || !self.is_complete_only
    }

    /// For a form.
    pub(super) fn with_default(&self, defaults: &Map<String, Value>) -> Parameter {
        let (kind, slider, choices): (_, _, &'static [&'static str]) = match self.form {
            Form::Number(min, max, step) => ("number", Some((min, max, step)), &[]),
            Form::Integer(min, max) => ("integer", Some((min, max, 1.0)), &[]),
            Form::Flag => ("boolean", None, &[]),
            Form::Choice(words) => ("choice", None, words),
            Form::NumberOr(min, max, step, words) => ("number", Some((min, max, step)), words),
        };
        Parameter {
            name: self.name,
            kind,
            unit: self.unit,
            min: slider.map(|s| s.0),
            max: slider.map(|s| s.1),
            step: slider.map(|s| s.2),
            choices,
            default: defaults[self.name].clone(),
            basic: self.basic,
            title: Text { en: self.title[0], zh: self.title[1] },
            doc: Text { en: self.doc[0], zh: self.doc[1] },
        }
    }

    /// Names the parameter, its range and the value where the value is outside, or one that this module does not have.
    fn check(&self, value: &dyn Setting) -> Result<(), Error> {
        let (Some((min, max)), Some(number)) = (self.range, value.number()) else { return Ok(()) };
        let bad = |rule| {
            Err(Error::new(ErrorCode::Config, self.name, message!("must be {}, got {}", rule, number)))
        };
        if !(min..=max).contains(&number) {
            return bad(format!("between {min} and {max}"));
        }
        if !self.is_listed() && number > 1.0 {
            return bad("1 without the complete module".to_owned());
        }
        Ok(())
    }
}

/// Which cells a step of a grid search may lead to.
pub(super) const NEIGHBOURS: ParameterSpec = spec(
    "neighbours",
    Form::Choice(&["four", "eight", "sixteen", "twenty-four", "forty-eight"]),
    "1",
    true,
    ["Neighbours", "邻域"],
    ["Cells reachable in one step.", "一步可达的栅格。"],
);
/// Expansions after which a search gives up.
pub(super) const EXPANSIONS: ParameterSpec = spec(
    "maxExpansions",
    Form::Integer(1.0, 1e8),
    "1",
    false,
    ["Expansion budget", "扩展上限"],
    ["Stops after this many.", "超过此数即放弃。"],
)
.within(1.0, 1e8);

/// A parameter and its value in a struct of settings.
pub(crate) type Field<'a> = (&'static ParameterSpec, &'a mut dyn Setting);

/// Settings that were declared by [`parameters!`].
pub(crate) trait Parameters {
    /// The parameters in the order of a form, with their values.
    fn fields(&mut self) -> Vec<Field<'_>>;

    /// Checks the rules that are not ranges of single parameters.
    fn check_rules(&self) -> Result<(), Error> {
        Ok(())
    }
}

/// A struct's own parameters, then the shared ones but for one of them. Compiled once, for settings of every type.
#[inline(never)]
pub(super) fn joined<'a>(
    specs: &'static [ParameterSpec],
    own: Vec<&'a mut dyn Setting>,
    (shared, left_out): (Vec<Field<'a>>, &str),
) -> Vec<Field<'a>> {
    let shared = shared.into_iter().filter(|field| field.0.name != left_out);
    specs.iter().zip(own).chain(shared).collect()
}

/// Lays JSON fields over settings.
pub(super) fn overlay(fields: Vec<Field>, values: &Map<String, Value>) -> Result<(), Error> {
    json::overlay(&mut named(fields), values)
}

/// Settings as JSON fields.
pub(super) fn written(fields: Vec<Field>) -> Map<String, Value> {
    json::written(&named(fields))
}

fn named(fields: Vec<Field<'_>>) -> Vec<(&'static str, &mut dyn Setting)> {
    fields.into_iter().map(|(spec, value)| (spec.name, value)).collect()
}

/// Checks every setting against its range.
pub(super) fn check(fields: Vec<Field>) -> Result<(), Error> {
    fields.into_iter().try_for_each(|(spec, value)| spec.check(value))
}

/// Declares a struct of settings: each field with its type, default and [`ParameterSpec`]; and, `shared`, a field whose
/// own parameters count as the struct's.
macro_rules! parameters {
    (@shared $self:ident) => { (Vec::new(), "") };
    (@shared $self:ident $shared:ident $($left_out:literal)?) => { ($self.$shared.fields(), concat!($($left_out)?)) };
    (
        $(#[$meta:meta])*
        pub struct $type:ident {
            $($(#[$doc:meta])* $field:ident: $kind:ty = $default:expr, $spec:expr;)*
        }
        $(
            $(#[$shared_doc:meta])*
            shared $shared:ident: $Shared:ty = $shared_default:expr $(, without $left_out:literal)?;
        )?
    ) => {
        use $crate::planners::parameters::Parameters as _;

        $(#[$meta])*
        pub struct $type {
            $($(#[$doc])* pub $field: $kind,)*
            $($(#[$shared_doc])* pub $shared: $Shared,)?
        }

        impl $type {
            /// Every setting at its default.
            pub const DEFAULT: Self = Self { $($field: $default,)* $($shared: $shared_default,)? };

            /// These settings with JSON fields laid over them. Ranges are checked by `validate`.
            ///
            /// # Errors
            /// [`ErrorCode::Config`](crate::error::ErrorCode::Config) with the field and the rule.
            pub fn with(
                mut self,
                fields: &serde_json::Map<String, serde_json::Value>,
            ) -> Result<Self, $crate::error::Error> {
                $crate::planners::parameters::overlay(self.fields(), fields)?;
                Ok(self)
            }

            /// These settings as JSON fields.
            pub fn to_json(&self) -> serde_json::Map<String, serde_json::Value> {
                $crate::planners::parameters::written(self.clone().fields())
            }

            /// Checks every setting against its range.
            ///
            /// # Errors
            /// [`ErrorCode::Config`](crate::error::ErrorCode::Config) with the field and the rule.
            pub fn validate(&self) -> Result<(), $crate::error::Error> {
                $crate::planners::parameters::check(self.clone().fields())
            }
        }

        impl $crate::planners::parameters::Parameters for $type {
            #[inline(never)]
            fn fields(&mut self) -> Vec<$crate::planners::parameters::Field<'_>> {
                const SPECS: &[$crate::planners::parameters::ParameterSpec] = &[$($spec),*];
                $crate::planners::parameters::joined(
                    SPECS,
                    vec![$(&mut self.$field),*],
                    parameters!(@shared self $($shared $($left_out)?)?))
            }
        }

        impl Default for $type {
            fn default() -> Self {
                Self::DEFAULT
            }
        }
    };
}
pub(super) use parameters;
