//! The planners by id: titles, papers, parameters with units.

use serde::Serialize;
use serde_json::{Map, Value};

use super::moves::Neighbourhood;
use super::parameters::{GRID, GRID_HEURISTICS, HYBRID, RISK, Row};
use super::{grid_astar, hybrid, risk_field};
use crate::error::{Error, ErrorCode};

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
    /// Smallest value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// Largest value.
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
    /// Whether people reach for it first.
    pub basic: bool,
    /// Its name for people.
    pub title: Text,
    /// What it does, in one line.
    pub doc: Text,
}

/// A planner, for a menu.
#[derive(Debug, Clone, Serialize)]
pub struct Info {
    /// Its id.
    pub id: &'static str,
    /// `grid` or `hybrid`.
    pub family: &'static str,
    /// Its name for people.
    pub title: Text,
    /// Where it comes from.
    pub paper: &'static str,
    /// Its settings.
    pub parameters: Vec<Parameter>,
}

/// A planner as the composer dispatches it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// 4 neighbours.
    Four,
    /// 8 neighbours.
    Eight,
    /// Risk-field variable-neighbourhood A*.
    RiskField,
    /// Hybrid A* from the goal.
    Hybrid,
    /// Hybrid A* from the start.
    HybridForward,
}

const KINDS: [(Kind, &str); 5] = [
    (Kind::Four, "four"),
    (Kind::Eight, "eight"),
    (Kind::RiskField, "risk-field"),
    (Kind::Hybrid, "hybrid"),
    (Kind::HybridForward, "hybrid-forward"),
];

impl Kind {
    /// The planner of this id.
    ///
    /// # Errors
    /// [`ErrorCode::UnknownPlanner`], with the ids that exist.
    pub fn of(id: &str) -> Result<Self, Error> {
        KINDS.iter().find(|k| k.1 == id).map(|k| k.0).ok_or_else(|| {
            let known: Vec<_> = KINDS.iter().map(|k| k.1).collect();
            let message = format!("no planner \"{id}\"; there are {}", known.join(", "));
            Error::new(ErrorCode::UnknownPlanner, "", message)
        })
    }

    /// Its id.
    pub fn id(self) -> &'static str {
        KINDS.iter().find(|k| k.0 == self).map_or("", |k| k.1)
    }

    fn default_value(self) -> Value {
        let value = match self {
            Self::Four => serde_json::to_value(grid_astar::Config::new(Neighbourhood::Four)),
            Self::Eight => serde_json::to_value(grid_astar::Config::new(Neighbourhood::Eight)),
            Self::RiskField => serde_json::to_value(risk_field::Config::default()),
            Self::Hybrid => serde_json::to_value(hybrid::Config::default()),
            Self::HybridForward => serde_json::to_value(hybrid::Config::forward()),
        };
        value.unwrap_or_default()
    }
}

/// A planner's settings, all at their defaults.
///
/// # Errors
/// [`ErrorCode::UnknownPlanner`].
pub fn default_config(id: &str) -> Result<Map<String, Value>, Error> {
    Ok(Kind::of(id)?.default_value().as_object().cloned().unwrap_or_default())
}

/// All planners.
pub fn planners() -> Vec<Info> {
    KINDS.iter().map(|&(kind, id)| info(kind, id)).collect()
}

fn info(kind: Kind, id: &'static str) -> Info {
    let text = |en, zh| Text { en, zh };
    let (family, title, paper) = match kind {
        Kind::Four => ("grid", text("4-neighbour", "四邻域"), "Hart, Nilsson, Raphael 1968"),
        Kind::Eight => ("grid", text("8-neighbour", "八邻域"), "Hart, Nilsson, Raphael 1968"),
        Kind::RiskField => ("grid", text("Risk field", "改进A*（风险场）"), "Hu et al. 2024"),
        Kind::Hybrid => ("hybrid", text("Hybrid A*", "混合A*"), "Reverse-search hybrid A* for parking, 2025"),
        Kind::HybridForward => ("hybrid", text("Hybrid A*, forward", "混合A*（正向）"), "Dolgov et al. 2010"),
    };
    let defaults = kind.default_value();
    let rows: Vec<Row> = match kind {
        Kind::Four => [&GRID_HEURISTICS[..1], &GRID[..]].concat(),
        Kind::Eight => [&GRID_HEURISTICS[1..], &GRID[..]].concat(),
        Kind::RiskField => [&RISK[..], &GRID[1..]].concat(),
        Kind::Hybrid | Kind::HybridForward => HYBRID.to_vec(),
    };
    let parameters = rows.iter().map(|row| row.with_default(&defaults)).collect();
    Info { id, family, title, paper, parameters }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_setting_is_listed_once_with_its_default() {
        for info in planners() {
            let config = default_config(info.id).unwrap();
            let mut names: Vec<_> = info.parameters.iter().map(|p| p.name).collect();
            names.sort_unstable();
            let mut expected: Vec<_> = config.keys().map(String::as_str).collect();
            expected.sort_unstable();
            assert_eq!(names, expected, "{}", info.id);
        }
    }

    #[test]
    fn an_unknown_planner_is_named() {
        let error = Kind::of("rrt").unwrap_err();
        assert!(error.message.starts_with("no planner \"rrt\"; there are four, eight"), "{error}");
    }
}
