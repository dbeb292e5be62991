//! The planners by id: titles, papers, parameters with units.
//!
//! A planner is one row here: what it is called, what it knows, and its settings at their defaults, which say how it
//! is run. Titles and effects are in English and Chinese, for forms and documentation.
//!
//! Everything else that lists planners reads these rows: [`planners`] for JavaScript, the page and the documentation,
//! [`default_config`] for forms, the tests that run every planner on every scene. Two ids may share a search and
//! differ in their defaults only, as `risk-field` and `risk-field-plus` do. The small module leaves out the rows that
//! `complete_row` makes; nothing else of it has to know.
//!
//! A row's order is that of menus; ids are part of share links and never change.

use serde_json::{Map, Value};

use super::grid_astar::GridAstar;
use super::grid_planner::GridPlanner;
pub use super::info::{Family, Info, Parameter, Text};
use super::moves::Neighbourhood;
use super::parameters::{Parameters, check, overlay, written};
use super::{
    any_angle, bidirectional, cost_map, dijkstra_greedy, genetic, hybrid, jump_point, risk_field, rrt,
};
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};

/// A planner of the registry.
#[derive(Clone, Copy)]
pub struct PlannerId(&'static Row);

/// The planners of this module.
static ROWS: [Row; rows().1] = {
    let (rows, count) = rows();
    let (mut kept, mut at) = ([rows[0]; _], 0);
    while at < count {
        kept[at] = rows[at];
        at += 1;
    }
    kept
};

/// Every planner, in the order of menus.
const ALL: [Row; 19] = [
    row("four", ["4-neighbour", "四邻域"], "Hart, Nilsson, Raphael 1968", || {
        grid(GridAstar::new(Neighbourhood::Four))
    }),
    row("eight", ["8-neighbour", "八邻域"], "Hart, Nilsson, Raphael 1968", || {
        grid(GridAstar::new(Neighbourhood::Eight))
    }),
    complete_row("sixteen", ["16-neighbour", "十六邻域"], "Yuan 2020", || {
        grid(GridAstar::new(Neighbourhood::Sixteen))
    }),
    complete_row("twenty-four", ["24-neighbour", "二十四邻域"], "Yuan 2020", || {
        grid(GridAstar::new(Neighbourhood::TwentyFour))
    }),
    complete_row("forty-eight", ["48-neighbour", "四十八邻域"], "Yuan 2020", || {
        grid(GridAstar::new(Neighbourhood::FortyEight))
    }),
    complete_row(
        "sixteen-bidirectional",
        ["From both ends", "双向搜索"],
        "Yuan 2020; Pijls, Post 2009",
        || grid(bidirectional::Config::DEFAULT),
    ),
    complete_row("jump-point", ["Jump points", "跳点搜索"], "Harabor, Grastien 2011", || {
        grid(jump_point::Config::DEFAULT)
    })
    .without_costs(),
    complete_row(
        "any-angle",
        ["Any angle", "任意角（Theta*）"],
        "Nash, Daniel, Koenig, Felner 2007",
        || grid(any_angle::Config::DEFAULT),
    )
    .without_costs(),
    row("risk-field", ["Risk field", "改进A*（风险场）"], "Hu et al. 2024", || {
        grid(risk_field::Config::PAPER)
    }),
    complete_row(
        "risk-field-plus",
        ["Risk field plus", "改进A*+（风险场）"],
        "Hu et al. 2024, beyond",
        || grid(risk_field::Config::PLUS),
    ),
    row("hybrid", ["Hybrid A*", "混合A*"], "Reverse-search hybrid A* for parking, 2025", || {
        Settings::Hybrid(hybrid::Config::DEFAULT)
    }),
    row(
        "hybrid-forward",
        ["Hybrid A*, forward", "混合A*（从起点搜索）"],
        "Dolgov et al. 2010",
        || Settings::Hybrid(hybrid::Config::forward()),
    ),
    complete_row(
        "hybrid-bidirectional",
        ["Hybrid A*, both ends", "混合A*（双向搜索）"],
        "Reverse-search hybrid A* for parking, 2025",
        || Settings::Hybrid(hybrid::Config::bidirectional()),
    ),
    complete_row(
        "hybrid-classic",
        ["Hybrid A*, classic", "混合A*（经典）"],
        "Dolgov et al. 2010",
        || Settings::Hybrid(hybrid::Config::classic()),
    ),
    complete_row(
        "cost-map",
        ["Cost map", "代价地图A*"],
        "A* path planning for intelligent-vehicle road navigation, manuscript",
        || Settings::Road(cost_map::Config::DEFAULT),
    ),
    complete_row("dijkstra", ["Dijkstra", "Dijkstra"], "Dijkstra 1959", || {
        grid(dijkstra_greedy::Search::DIJKSTRA)
    }),
    complete_row("greedy", ["Greedy best-first", "贪婪最佳优先"], "Doran, Michie 1966", || {
        grid(dijkstra_greedy::Search::GREEDY)
    })
    .without_costs(),
    complete_row("rrt", ["RRT", "RRT（快速扩展随机树）"], "LaValle 1998", || {
        grid(rrt::Config::DEFAULT)
    })
    .without_costs(),
    complete_row("genetic", ["Genetic", "遗传算法"], "Holland 1975", || grid(genetic::Config::DEFAULT))
        .without_costs(),
];

#[derive(Clone, Copy)]
struct Row {
    id: &'static str,
    /// English and Chinese.
    title: [&'static str; 2],
    paper: &'static str,
    /// Its settings at their defaults; their kind is its family.
    settings: fn() -> Settings,
    /// True if it knows that cells can cost more than others.
    takes_costs: bool,
    /// True if the small module lacks it.
    is_complete_only: bool,
}

/// The rows of this module in front, and how many they are. Only these are in its file.
const fn rows() -> ([Row; ALL.len()], usize) {
    let (mut rows, mut count, mut at) = (ALL, 0, 0);
    while at < ALL.len() {
        if IS_COMPLETE || !ALL[at].is_complete_only {
            rows[count] = ALL[at];
            count += 1;
        }
        at += 1;
    }
    (rows, count)
}

const fn row(
    id: &'static str,
    title: [&'static str; 2],
    paper: &'static str,
    settings: fn() -> Settings,
) -> Row {
    Row { id, title, paper, settings, takes_costs: true, is_complete_only: false }
}

/// A row that the small module lacks.
const fn complete_row(
    id: &'static str,
    title: [&'static str; 2],
    paper: &'static str,
    settings: fn() -> Settings,
) -> Row {
    Row { is_complete_only: true, ..row(id, title, paper, settings) }
}

impl Row {
    const fn without_costs(self) -> Self {
        Self { takes_costs: false, ..self }
    }
}

/// A planner's settings, by the family that runs it.
pub(crate) enum Settings {
    Grid(Box<dyn GridPlanner>),
    Hybrid(hybrid::Config),
    Road(cost_map::Config),
}

fn grid(planner: impl GridPlanner + 'static) -> Settings {
    Settings::Grid(Box::new(planner))
}

impl Settings {
    fn family(&self) -> Family {
        match self {
            Self::Grid(_) => Family::Grid,
            Self::Hybrid(_) => Family::Hybrid,
            Self::Road(_) => Family::Road,
        }
    }

    fn parameters(&mut self) -> &mut dyn Parameters {
        match self {
            Self::Grid(planner) => &mut **planner,
            Self::Hybrid(config) => config,
            Self::Road(config) if IS_COMPLETE => config,
            Self::Road(_) => unreachable!("no row of the small module has these settings"),
        }
    }
}

impl PlannerId {
    /// The planner of this id.
    ///
    /// # Errors
    /// [`ErrorCode::UnknownPlanner`], with the ids that exist.
    pub fn of(id: &str) -> Result<Self, Error> {
        ROWS.iter().find(|row| row.id == id).map(Self).ok_or_else(|| {
            let known: Vec<_> = ROWS.iter().map(|row| row.id).collect();
            let message = message!("no planner \"{}\"; there are {}", id, known.join(", "));
            Error::new(ErrorCode::UnknownPlanner, "", message)
        })
    }

    /// Its id.
    pub fn id(self) -> &'static str {
        self.0.id
    }

    /// Its search space.
    pub fn family(self) -> Family {
        (self.0.settings)().family()
    }

    /// True if a risk field leads it.
    pub fn has_risk_field(self) -> bool {
        matches!((self.0.settings)(), Settings::Grid(planner) if planner.risk_field().is_some())
    }

    /// True if it knows that cells can cost more than others.
    pub fn takes_costs(self) -> bool {
        self.0.takes_costs
    }

    /// Its settings, with JSON fields laid over the defaults.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub(crate) fn settings(self, fields: &Map<String, Value>) -> Result<Settings, Error> {
        let mut settings = (self.0.settings)();
        let parameters = settings.parameters();
        overlay(parameters.fields(), fields)?;
        parameters.check_rules()?;
        check(parameters.fields())?;
        Ok(settings)
    }

    /// Its parameters for a form.
    fn parameters(self) -> Vec<Parameter> {
        let mut settings = (self.0.settings)();
        let parameters = settings.parameters();
        let values = written(parameters.fields());
        let specs = parameters.fields().into_iter().map(|field| field.0);
        specs.filter(|spec| spec.is_listed()).map(|spec| spec.with_default(&values)).collect()
    }
}

/// A planner's settings, all at their defaults.
///
/// # Errors
/// [`ErrorCode::UnknownPlanner`].
pub fn default_config(id: &str) -> Result<Map<String, Value>, Error> {
    Ok(written((PlannerId::of(id)?.0.settings)().parameters().fields()))
}

/// All planners.
pub fn planners() -> Vec<Info> {
    ROWS.iter().map(|row| info(PlannerId(row))).collect()
}

/// What JavaScript is told of a row.
fn info(planner: PlannerId) -> Info {
    let PlannerId(&Row { id, title: [en, zh], paper, takes_costs, .. }) = planner;
    Info {
        id,
        family: planner.family(),
        title: Text { en, zh },
        paper,
        has_risk_field: planner.has_risk_field(),
        takes_costs,
        parameters: planner.parameters(),
    }
}

#[cfg(test)]
mod tests;
