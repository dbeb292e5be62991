//! What forms, menus and documents are told of a planner.

use serde::Serialize;
use serde_json::Value;

/// English and Chinese.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Text {
    /// English.
    pub en: &'static str,
    /// Simplified Chinese.
    pub zh: &'static str,
}

/// A setting, for a form.
#[derive(Debug, Clone, Serialize)]
pub struct Parameter {
    /// Its name in the config.
    pub name: &'static str,
    /// `number`, `integer`, `boolean` or `choice`.
    #[serde(rename = "type")]
    pub kind: &'static str,
    /// `m`, `rad`, `cells` or `1`.
    pub unit: &'static str,
    /// Smallest value of a form's slider; the rules that planners hold a setting to may be wider.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// Largest value of the slider.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
    /// A step that people can see the effect of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<f64>,
    /// The words to choose from.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub choices: &'static [&'static str],
    /// Its default.
    pub default: Value,
    /// True if people reach for it first.
    pub basic: bool,
    /// Its name for people.
    pub title: Text,
    /// Its effect, in one line.
    pub doc: Text,
}

/// A planner's search space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Family {
    /// Cells of a map.
    Grid,
    /// Poses of a car, which can drive the path.
    Hybrid,
    /// Cells of a cost map, then curves along roads.
    Road,
}

/// A planner, for a menu.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Info {
    /// Its id.
    pub id: &'static str,
    /// Its search space.
    pub family: Family,
    /// Its name for people.
    pub title: Text,
    /// Its source.
    pub paper: &'static str,
    /// True if a risk field leads it.
    pub has_risk_field: bool,
    /// True if it knows that cells can cost more than others.
    pub takes_costs: bool,
    /// Its settings.
    pub parameters: Vec<Parameter>,
}
