//! The planners by id: titles, papers, parameters with units.
//!
//! A planner is one row here. What other layers ask of a planner (its family, whether it drives a car, has a risk
//! field or takes weighted cells) is a field of its [`Info`]. Titles and effects are in English and Chinese, for
//! forms and documentation.

use serde::Serialize;
use serde_json::{Map, Value};

use super::moves::Neighbourhood;
use super::parameters::{Parameters, written};
#[cfg(feature = "complete")]
use super::{any_angle, bidirectional, cost_map, dijkstra_greedy, genetic, jump_point, rrt};
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

/// A planner as the composer dispatches it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlannerId {
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
    /// Dijkstra's search.
    #[cfg(feature = "complete")]
    Dijkstra,
    /// Greedy best-first search.
    #[cfg(feature = "complete")]
    Greedy,
    /// A tree that grows towards random cells.
    #[cfg(feature = "complete")]
    Rrt,
    /// A genetic algorithm over paths of straight legs.
    #[cfg(feature = "complete")]
    Genetic,
}

/// The facts of each planner, in the order of menus.
const ROWS: &[Row] = &[
    row(PlannerId::Four, "four", Family::Grid, ["4-neighbour", "四邻域"], "Hart, Nilsson, Raphael 1968"),
    row(PlannerId::Eight, "eight", Family::Grid, ["8-neighbour", "八邻域"], "Hart, Nilsson, Raphael 1968"),
    #[cfg(feature = "complete")]
    row(PlannerId::Sixteen, "sixteen", Family::Grid, ["16-neighbour", "十六邻域"], "Yuan 2020"),
    #[cfg(feature = "complete")]
    row(PlannerId::TwentyFour, "twenty-four", Family::Grid, ["24-neighbour", "二十四邻域"], "Yuan 2020"),
    #[cfg(feature = "complete")]
    row(PlannerId::FortyEight, "forty-eight", Family::Grid, ["48-neighbour", "四十八邻域"], "Yuan 2020"),
    #[cfg(feature = "complete")]
    row(
        PlannerId::Bidirectional,
        "sixteen-bidirectional",
        Family::Grid,
        ["From both ends", "双向搜索"],
        "Yuan 2020; Pijls, Post 2009",
    ),
    #[cfg(feature = "complete")]
    row(
        PlannerId::JumpPoint,
        "jump-point",
        Family::Grid,
        ["Jump points", "跳点搜索"],
        "Harabor, Grastien 2011",
    ),
    #[cfg(feature = "complete")]
    row(
        PlannerId::AnyAngle,
        "any-angle",
        Family::Grid,
        ["Any angle", "任意角（Theta*）"],
        "Nash, Daniel, Koenig, Felner 2007",
    ),
    row(
        PlannerId::RiskField,
        "risk-field",
        Family::Grid,
        ["Risk field", "改进A*（风险场）"],
        "Hu et al. 2024",
    ),
    #[cfg(feature = "complete")]
    row(
        PlannerId::RiskFieldPlus,
        "risk-field-plus",
        Family::Grid,
        ["Risk field plus", "改进A*+（风险场）"],
        "Hu et al. 2024, beyond",
    ),
    row(
        PlannerId::Hybrid,
        "hybrid",
        Family::Hybrid,
        ["Hybrid A*", "混合A*"],
        "Reverse-search hybrid A* for parking, 2025",
    ),
    row(
        PlannerId::HybridForward,
        "hybrid-forward",
        Family::Hybrid,
        ["Hybrid A*, forward", "混合A*（从起点搜索）"],
        "Dolgov et al. 2010",
    ),
    #[cfg(feature = "complete")]
    row(
        PlannerId::HybridBidirectional,
        "hybrid-bidirectional",
        Family::Hybrid,
        ["Hybrid A*, both ends", "混合A*（双向搜索）"],
        "Reverse-search hybrid A* for parking, 2025",
    ),
    #[cfg(feature = "complete")]
    row(
        PlannerId::HybridClassic,
        "hybrid-classic",
        Family::Hybrid,
        ["Hybrid A*, classic", "混合A*（经典）"],
        "Dolgov et al. 2010",
    ),
    #[cfg(feature = "complete")]
    row(
        PlannerId::CostMap,
        "cost-map",
        Family::Road,
        ["Cost map", "代价地图A*"],
        "A* path planning for intelligent-vehicle road navigation, manuscript",
    ),
    #[cfg(feature = "complete")]
    row(PlannerId::Dijkstra, "dijkstra", Family::Grid, ["Dijkstra", "Dijkstra"], "Dijkstra 1959"),
    #[cfg(feature = "complete")]
    row(
        PlannerId::Greedy,
        "greedy",
        Family::Grid,
        ["Greedy best-first", "贪婪最佳优先"],
        "Doran, Michie 1966",
    ),
    #[cfg(feature = "complete")]
    row(PlannerId::Rrt, "rrt", Family::Grid, ["RRT", "RRT（快速扩展随机树）"], "LaValle 1998"),
    #[cfg(feature = "complete")]
    row(PlannerId::Genetic, "genetic", Family::Grid, ["Genetic", "遗传算法"], "Holland 1975"),
];

struct Row {
    kind: PlannerId,
    id: &'static str,
    family: Family,
    /// English and Chinese.
    title: [&'static str; 2],
    paper: &'static str,
}

const fn row(
    kind: PlannerId,
    id: &'static str,
    family: Family,
    title: [&'static str; 2],
    paper: &'static str,
) -> Row {
    Row { kind, id, family, title, paper }
}

impl PlannerId {
    /// The planner of this id.
    ///
    /// # Errors
    /// [`ErrorCode::UnknownPlanner`], with the ids that exist.
    pub fn of(id: &str) -> Result<Self, Error> {
        ROWS.iter().find(|row| row.id == id).map(|row| row.kind).ok_or_else(|| {
            let known: Vec<_> = ROWS.iter().map(|row| row.id).collect();
            let message = format!("no planner \"{id}\"; there are {}", known.join(", "));
            Error::new(ErrorCode::UnknownPlanner, "", message)
        })
    }

    fn row(self) -> &'static Row {
        // Every planner has a row: a test counts them.
        ROWS.iter().find(|row| row.kind == self).unwrap_or(&ROWS[0])
    }

    /// Its id.
    pub fn id(self) -> &'static str {
        self.row().id
    }

    /// Its search space.
    pub fn family(self) -> Family {
        self.row().family
    }

    /// True if a risk field leads it.
    pub fn has_risk_field(self) -> bool {
        #[cfg(feature = "complete")]
        return matches!(self, Self::RiskField | Self::RiskFieldPlus);
        #[cfg(not(feature = "complete"))]
        matches!(self, Self::RiskField)
    }

    /// True if it knows that cells can cost more than others.
    pub fn takes_costs(self) -> bool {
        #[cfg(feature = "complete")]
        return !matches!(self, Self::JumpPoint | Self::AnyAngle | Self::Greedy | Self::Rrt | Self::Genetic);
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

    /// Its settings at their defaults.
    fn defaults(self) -> Box<dyn Parameters> {
        match self {
            #[cfg(feature = "complete")]
            Self::Bidirectional => Box::new(bidirectional::Config::DEFAULT),
            #[cfg(feature = "complete")]
            Self::JumpPoint => Box::new(jump_point::Config::DEFAULT),
            #[cfg(feature = "complete")]
            Self::AnyAngle => Box::new(any_angle::Config::DEFAULT),
            Self::RiskField => Box::new(risk_field::Config::PAPER),
            #[cfg(feature = "complete")]
            Self::RiskFieldPlus => Box::new(risk_field::Config::PLUS),
            Self::Hybrid => Box::new(hybrid::Config::DEFAULT),
            Self::HybridForward => Box::new(hybrid::Config::forward()),
            #[cfg(feature = "complete")]
            Self::HybridBidirectional => Box::new(hybrid::Config::bidirectional()),
            #[cfg(feature = "complete")]
            Self::HybridClassic => Box::new(hybrid::Config::classic()),
            #[cfg(feature = "complete")]
            Self::CostMap => Box::new(cost_map::Config::DEFAULT),
            #[cfg(feature = "complete")]
            Self::Dijkstra | Self::Greedy => Box::new(dijkstra_greedy::Config::DEFAULT),
            #[cfg(feature = "complete")]
            Self::Rrt => Box::new(rrt::Config::DEFAULT),
            #[cfg(feature = "complete")]
            Self::Genetic => Box::new(genetic::Config::DEFAULT),
            _ => Box::new(grid_astar::Config::new(self.neighbourhood().unwrap_or(Neighbourhood::Eight))),
        }
    }

    /// Its parameters for a form.
    fn parameters(self) -> Vec<Parameter> {
        let mut settings = self.defaults();
        let values = written(settings.fields());
        let own = self.neighbourhood().map(grid_astar::Config::heuristic_spec);
        let specs = settings
            .fields()
            .into_iter()
            .map(|(spec, _)| own.filter(|own| own.name == spec.name).unwrap_or(spec));
        specs.filter(|spec| spec.is_listed()).map(|spec| spec.with_default(&values)).collect()
    }
}

/// A planner's settings, all at their defaults.
///
/// # Errors
/// [`ErrorCode::UnknownPlanner`].
pub fn default_config(id: &str) -> Result<Map<String, Value>, Error> {
    Ok(written(PlannerId::of(id)?.defaults().fields()))
}

/// All planners.
pub fn planners() -> Vec<Info> {
    ROWS.iter().map(info).collect()
}

fn info(&Row { kind, id, family, title: [en, zh], paper }: &Row) -> Info {
    Info {
        id,
        family,
        title: Text { en, zh },
        paper,
        has_risk_field: kind.has_risk_field(),
        takes_costs: kind.takes_costs(),
        parameters: kind.parameters(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planners::parameters::{check, overlay};

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
    fn planners_take_whatever_a_form_offers() {
        for &Row { kind, id, .. } in ROWS {
            for Parameter { name, kind: form, choices, min, max, default, .. } in kind.parameters() {
                let ends = [min, max].into_iter().flatten();
                let ends =
                    ends.map(|end| if form == "integer" { (end as u64).into() } else { Value::from(end) });
                for value in ends.chain(choices.iter().map(|&word| word.into())).chain([default]) {
                    let fields = Map::from_iter([(name.to_owned(), value.clone())]);
                    let mut settings = kind.defaults();
                    overlay(settings.fields(), &fields).unwrap_or_else(|e| panic!("{id}: {e}"));
                    check(settings.fields()).unwrap_or_else(|e| panic!("{id}: {e}"));
                    assert_eq!(written(settings.fields())[name], value, "{id}: {name}");
                }
            }
        }
    }

    #[test]
    fn every_planner_has_one_row() {
        for (i, row) in ROWS.iter().enumerate() {
            assert_eq!((row.kind.id(), PlannerId::of(row.id).unwrap()), (row.id, row.kind));
            assert_eq!(row.kind.neighbourhood().is_some(), i < 5, "{}", row.id);
        }
        // The last one of the enum.
        assert_eq!(ROWS.len(), PlannerId::Genetic as usize + 1);
    }

    #[test]
    fn an_unknown_planner_is_named() {
        let error = PlannerId::of("prm").unwrap_err();
        assert!(error.message.starts_with("no planner \"prm\"; there are four, eight"), "{error}");
    }
}
