//! The planners by id: titles, papers, parameters with units.

use serde::Serialize;
use serde_json::{Map, Value};

use super::moves::Neighbourhood;
#[cfg(feature = "complete")]
use super::parameters::{BIDIRECTIONAL, JUMP_POINT, ROAD};
use super::parameters::{GRID, GRID_HEURISTICS, HYBRID, RISK, Row};
#[cfg(feature = "complete")]
use super::{any_angle, bidirectional, cost_map, jump_point};
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
    /// `grid`, `hybrid` or `road`.
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
    /// 16 neighbours.
    #[cfg(feature = "complete")]
    Sixteen,
    /// 24 neighbours.
    #[cfg(feature = "complete")]
    TwentyFour,
    /// 48 neighbours.
    #[cfg(feature = "complete")]
    FortyEight,
    /// From both ends, 16 neighbours unless told otherwise.
    #[cfg(feature = "complete")]
    Bidirectional,
    /// Jump point search.
    #[cfg(feature = "complete")]
    JumpPoint,
    /// Theta*.
    #[cfg(feature = "complete")]
    AnyAngle,
    /// Risk-field variable-neighbourhood A*.
    RiskField,
    /// The same with settings for shorter paths from fewer cells.
    #[cfg(feature = "complete")]
    RiskFieldPlus,
    /// Hybrid A* from the goal.
    Hybrid,
    /// Hybrid A* from the start.
    HybridForward,
    /// Hybrid A* from both ends.
    #[cfg(feature = "complete")]
    HybridBidirectional,
    /// Hybrid A* as coarse and greedy as its forerunner.
    #[cfg(feature = "complete")]
    HybridClassic,
    /// Cost-map A* for roads.
    #[cfg(feature = "complete")]
    CostMap,
}

const KINDS: &[(Kind, &str)] = &[
    (Kind::Four, "four"),
    (Kind::Eight, "eight"),
    #[cfg(feature = "complete")]
    (Kind::Sixteen, "sixteen"),
    #[cfg(feature = "complete")]
    (Kind::TwentyFour, "twenty-four"),
    #[cfg(feature = "complete")]
    (Kind::FortyEight, "forty-eight"),
    #[cfg(feature = "complete")]
    (Kind::Bidirectional, "sixteen-bidirectional"),
    #[cfg(feature = "complete")]
    (Kind::JumpPoint, "jump-point"),
    #[cfg(feature = "complete")]
    (Kind::AnyAngle, "any-angle"),
    (Kind::RiskField, "risk-field"),
    #[cfg(feature = "complete")]
    (Kind::RiskFieldPlus, "risk-field-plus"),
    (Kind::Hybrid, "hybrid"),
    (Kind::HybridForward, "hybrid-forward"),
    #[cfg(feature = "complete")]
    (Kind::HybridBidirectional, "hybrid-bidirectional"),
    #[cfg(feature = "complete")]
    (Kind::HybridClassic, "hybrid-classic"),
    #[cfg(feature = "complete")]
    (Kind::CostMap, "cost-map"),
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

    /// Whether a risk field leads it.
    pub fn has_field(self) -> bool {
        self.id().starts_with("risk-field")
    }

    /// Whether it plans for a car instead of on cells.
    pub fn is_hybrid(self) -> bool {
        self.id().starts_with("hybrid")
    }

    /// Whether it knows that cells can cost more than others.
    pub fn weighs(self) -> bool {
        #[cfg(feature = "complete")]
        return !matches!(self, Self::JumpPoint | Self::AnyAngle);
        #[cfg(not(feature = "complete"))]
        true
    }

    /// The neighbourhood of plain grid A*.
    pub fn neighbourhood(self) -> Option<Neighbourhood> {
        Some(match self {
            Self::Four => Neighbourhood::Four,
            Self::Eight => Neighbourhood::Eight,
            #[cfg(feature = "complete")]
            Self::Sixteen => Neighbourhood::Sixteen,
            #[cfg(feature = "complete")]
            Self::TwentyFour => Neighbourhood::TwentyFour,
            #[cfg(feature = "complete")]
            Self::FortyEight => Neighbourhood::FortyEight,
            _ => return None,
        })
    }

    fn default_config(self) -> Map<String, Value> {
        if let Some(neighbourhood) = self.neighbourhood() {
            return grid_astar::Config::new(neighbourhood).to_json();
        }
        match self {
            #[cfg(feature = "complete")]
            Self::Bidirectional => bidirectional::Config::default().to_json(),
            #[cfg(feature = "complete")]
            Self::JumpPoint => jump_point::Config::default().to_json(),
            #[cfg(feature = "complete")]
            Self::AnyAngle => any_angle::Config::default().to_json(),
            Self::RiskField => risk_field::Config::default().to_json(),
            #[cfg(feature = "complete")]
            Self::RiskFieldPlus => risk_field::Config::PLUS.to_json(),
            Self::Hybrid => hybrid::Config::default().to_json(),
            Self::HybridForward => hybrid::Config::forward().to_json(),
            #[cfg(feature = "complete")]
            Self::HybridBidirectional => hybrid::Config::both_ways().to_json(),
            #[cfg(feature = "complete")]
            Self::HybridClassic => hybrid::Config::classic().to_json(),
            #[cfg(feature = "complete")]
            Self::CostMap => cost_map::Config::default().to_json(),
            _ => Map::new(),
        }
    }
}

/// A planner's settings, all at their defaults.
///
/// # Errors
/// [`ErrorCode::UnknownPlanner`].
pub fn default_config(id: &str) -> Result<Map<String, Value>, Error> {
    Ok(Kind::of(id)?.default_config())
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
        #[cfg(feature = "complete")]
        Kind::Sixteen => ("grid", text("16-neighbour", "十六邻域"), "Yuan 2020"),
        #[cfg(feature = "complete")]
        Kind::TwentyFour => ("grid", text("24-neighbour", "二十四邻域"), "Yuan 2020"),
        #[cfg(feature = "complete")]
        Kind::FortyEight => ("grid", text("48-neighbour", "四十八邻域"), "Yuan 2020"),
        #[cfg(feature = "complete")]
        Kind::Bidirectional => ("grid", text("From both ends", "双向搜索"), "Yuan 2020; Pijls, Post 2009"),
        #[cfg(feature = "complete")]
        Kind::JumpPoint => ("grid", text("Jump points", "跳点搜索"), "Harabor, Grastien 2011"),
        #[cfg(feature = "complete")]
        Kind::AnyAngle => {
            ("grid", text("Any angle", "任意角（Theta*）"), "Nash, Daniel, Koenig, Felner 2007")
        }
        Kind::RiskField => ("grid", text("Risk field", "改进A*（风险场）"), "Hu et al. 2024"),
        #[cfg(feature = "complete")]
        Kind::RiskFieldPlus => {
            ("grid", text("Risk field plus", "改进A*+（风险场）"), "Hu et al. 2024, beyond")
        }
        Kind::Hybrid => ("hybrid", text("Hybrid A*", "混合A*"), "Reverse-search hybrid A* for parking, 2025"),
        Kind::HybridForward => {
            ("hybrid", text("Hybrid A*, forward", "混合A*（仅前进）"), "Dolgov et al. 2010")
        }
        #[cfg(feature = "complete")]
        Kind::HybridBidirectional => (
            "hybrid",
            text("Hybrid A*, both ends", "混合A*（双向搜索）"),
            "Reverse-search hybrid A* for parking, 2025",
        ),
        #[cfg(feature = "complete")]
        Kind::HybridClassic => ("hybrid", text("Hybrid A*, classic", "混合A*（经典）"), "Dolgov et al. 2010"),
        #[cfg(feature = "complete")]
        Kind::CostMap => (
            "road",
            text("Cost map", "代价地图A*"),
            "A* path planning for intelligent-vehicle road navigation, manuscript",
        ),
    };
    let defaults = kind.default_config();
    let rows: Vec<Row> = match kind {
        Kind::Four => [&GRID_HEURISTICS[..1], GRID].concat(),
        Kind::Eight => [&GRID_HEURISTICS[1..2], GRID].concat(),
        #[cfg(feature = "complete")]
        Kind::Sixteen | Kind::TwentyFour | Kind::FortyEight => [&GRID_HEURISTICS[2..], GRID].concat(),
        #[cfg(feature = "complete")]
        Kind::Bidirectional => [&BIDIRECTIONAL[..], &GRID[1..]].concat(),
        // Jump points presuppose strict corners, the second row of all.
        #[cfg(feature = "complete")]
        Kind::JumpPoint => [&JUMP_POINT[..], &GRID[2..]].concat(),
        #[cfg(feature = "complete")]
        Kind::AnyAngle => GRID[1..].to_vec(),
        #[cfg(feature = "complete")]
        Kind::CostMap => ROAD.to_vec(),
        kind if kind.has_field() => [&RISK[..], &GRID[1..]].concat(),
        _ => HYBRID.to_vec(),
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
