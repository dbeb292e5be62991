//! Tables 3 and 4 of Hu et al. 2024, on seeded maps of the same kinds and sizes, and the neighbourhoods of Yuan 2020.
//!
//! The papers' own maps are not published, so a row is a family of maps: every figure is a median, a 95th percentile
//! and a worst case. The printed column "expanded nodes" grows linearly with the side of the map, as the cells that
//! ever entered the open list do, so that is what it is held against. Lengths are those after pruning.
//!
//! Work comes in slices of seeds, so that a page can spread it over workers and show how far it is.

use serde::Serialize;

use super::Spread;
use crate::error::{Error, ErrorCode};
use crate::map::{Cell, Corner, Occupancy};
use crate::metrics::grid::{clearance, length, polyline, turns};
use crate::planners::Outcome;
use crate::planners::grid_astar::{self, Weight};
use crate::planners::heuristics::Heuristic;
use crate::planners::moves::Neighbourhood;
use crate::planners::query::{GridReport, GridScratch, Query};
use crate::planners::{bidirectional, dijkstra_greedy, risk_field};
use crate::post::SmoothMode;
use crate::post::{prune, prune_dp, smooth};
use crate::scenario::generate::{Family, occupancy};
use crate::search::{Observers, Stop};

/// Figures kept of each planner on each map, in this order.
pub const COLUMNS: [&str; 11] = [
    "generated",
    "expanded",
    "lengthRaw",
    "lengthPruned",
    "lengthDp",
    "lengthSmoothed",
    "turns",
    "turnAngleDeg",
    "clearanceMean",
    "clearanceMin",
    "milliseconds",
];

/// What the printed column "path length" may mean, of [`COLUMNS`]: the cells, what pruning leaves of them, the shortest
/// line over them, and the pruned path with rounded corners.
pub const READINGS: [&str; 4] = ["lengthRaw", "lengthPruned", "lengthDp", "lengthSmoothed"];

/// Planners that every map is given to, in this order.
pub const PLANNERS: [&str; 13] = [
    "four",
    "eight",
    "eight-octile",
    "eight-weighted",
    "sixteen",
    "twenty-four",
    "forty-eight",
    "sixteen-bidirectional",
    "sixteen-nba",
    "risk-field",
    "risk-field-plus",
    "dijkstra",
    "greedy",
];

/// Numbers per map.
pub const WIDTH: usize = COLUMNS.len() * PLANNERS.len();

/// Most seeds of one slice.
const MAX_SEEDS: u64 = 10_000;

/// A row of the paper's tables.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Row {
    /// `regular-30`, ….
    pub id: &'static str,
    /// The paper's table.
    pub table: u32,
    /// How the maps are drawn.
    #[serde(skip)]
    pub family: Family,
    /// Cells a side.
    pub size: u32,
    /// Printed nodes: four neighbours, eight neighbours, the improved planner.
    pub nodes: [f64; 3],
    /// Printed lengths of the same, cells.
    pub lengths: [f64; 3],
}

impl Row {
    const fn new(id: &'static str, family: Family, size: u32, nodes: [f64; 3], lengths: [f64; 3]) -> Self {
        let table = if matches!(family, Family::Regular) { 3 } else { 4 };
        Self { id, table, family, size, nodes, lengths }
    }

    /// No path between the printed end points is shorter, cells.
    pub fn straight(&self) -> f64 {
        f64::from(self.size - 1) * std::f64::consts::SQRT_2
    }
}

/// The rows of tables 3 and 4.
pub const ROWS: [Row; 6] = [
    Row::new("regular-30", Family::Regular, 30, [164.0, 177.0, 81.0], [49.9324, 43.2146, 42.2926]),
    Row::new("regular-60", Family::Regular, 60, [335.0, 355.0, 155.0], [101.8335, 89.2595, 88.7633]),
    Row::new("regular-100", Family::Regular, 100, [546.0, 599.0, 260.0], [156.4311, 135.8619, 134.8739]),
    Row::new("random-30", Family::RANDOM, 30, [174.0, 198.0, 83.0], [51.5183, 42.574, 42.574]),
    Row::new("random-60", Family::RANDOM, 60, [342.0, 391.0, 160.0], [99.1579, 87.7071, 86.6724]),
    Row::new("random-100", Family::RANDOM, 100, [688.0, 610.0, 248.0], [140.7975, 133.4048, 134.186]),
];

/// The row of this id.
///
/// # Errors
/// [`ErrorCode::Input`] with the ids that exist.
pub fn row(id: &str) -> Result<&'static Row, Error> {
    ROWS.iter().find(|row| row.id == id).ok_or_else(|| {
        let known: Vec<_> = ROWS.iter().map(|row| row.id).collect();
        Error::new(ErrorCode::Input, "row", message!("must be one of {}, got \"{}\"", known.join(", "), id))
    })
}

/// All figures of a row on the maps of seeds `from` to `to`, both included: per seed [`PLANNERS`] × [`COLUMNS`].
///
/// `clock` tells milliseconds; 0 throughout where nobody measures.
///
/// # Errors
/// [`ErrorCode::Input`] for seeds in the wrong order or too many.
///
/// # Examples
/// ```
/// use parkade::papers::grid::{WIDTH, measure, row, summary};
///
/// let row = row("regular-30").unwrap();
/// let figures = measure(row, 1, 3, &mut || 0.0).unwrap();
/// assert_eq!(figures.len(), 3 * WIDTH);
/// assert!(summary(row, &figures).unwrap().ratios[0].ours.median < 0.46);
/// ```
pub fn measure(row: &Row, from: u64, to: u64, clock: &mut dyn FnMut() -> f64) -> Result<Vec<f64>, Error> {
    if from > to || to - from >= MAX_SEEDS {
        let rule = message!("must be {} to {}, got {}", from, from.saturating_add(MAX_SEEDS - 1), to);
        return Err(Error::new(ErrorCode::Input, "to", rule));
    }
    let mut scratch = GridScratch::new();
    let mut figures = Vec::new();
    for seed in from..=to {
        let map = occupancy(row.family, row.size, seed)?;
        for planner in PLANNERS {
            let before = clock();
            let report = run(planner, &map, &mut scratch);
            let time = clock() - before;
            figures.extend(figures_of(&map, &report)?);
            figures.push(time);
        }
    }
    Ok(figures)
}

/// Runs a planner of the tables from corner to corner of a map. Names beyond the registry's are the variants that the
/// papers compare: another estimate, or the weight that grows with the distance.
fn run(planner: &str, map: &Occupancy, scratch: &mut GridScratch) -> GridReport {
    use Neighbourhood::{Eight, FortyEight, Four, Sixteen, TwentyFour};
    // As planners on scenes are called: a search for `()` would be the same code a second time.
    let mut silent = Observers::default();
    let end = map.width() as i32 - 1;
    let query = Query { map, start: Cell::new(0, 0), goal: Cell::new(end, end) };
    let mut around = |neighbourhood, change: fn(&mut grid_astar::Config)| {
        let mut config = grid_astar::Config::new(neighbourhood);
        change(&mut config);
        grid_astar::plan(query, neighbourhood, &config, scratch, &mut silent)
    };
    match planner {
        "four" => around(Four, |_| ()),
        "eight" => around(Eight, |_| ()),
        "eight-octile" => around(Eight, |config| config.heuristic = Heuristic::Octile),
        "eight-weighted" => around(Eight, |config| config.weight = Weight::Distance),
        "sixteen" => around(Sixteen, |_| ()),
        "twenty-four" => around(TwentyFour, |_| ()),
        "forty-eight" => around(FortyEight, |_| ()),
        "sixteen-bidirectional" => {
            bidirectional::plan(query, &bidirectional::Config::default(), scratch, &mut silent)
        }
        "sixteen-nba" => {
            let config = bidirectional::Config { stop: Stop::Optimal, ..bidirectional::Config::default() };
            bidirectional::plan(query, &config, scratch, &mut silent)
        }
        "dijkstra" => {
            dijkstra_greedy::dijkstra(query, &dijkstra_greedy::Config::DEFAULT, scratch, &mut silent)
        }
        "greedy" => dijkstra_greedy::greedy(query, &dijkstra_greedy::Config::DEFAULT, scratch, &mut silent),
        "risk-field" => risk_field::plan(query, &risk_field::Config::PAPER, scratch, &mut silent),
        _ => risk_field::plan(query, &risk_field::Config::PLUS, scratch, &mut silent),
    }
}

/// All columns but the time.
fn figures_of(map: &Occupancy, report: &GridReport) -> Result<[f64; COLUMNS.len() - 1], Error> {
    if report.outcome != Outcome::Found {
        // Generated maps are connected and every planner here is complete.
        return Err(Error::new(ErrorCode::Input, "row", "must have a path on every map"));
    }
    let raw = &report.cells;
    let pruned = prune(map, raw, Corner::Strict);
    let corners = turns(raw);
    let room = clearance(map, &polyline(raw));
    Ok([
        f64::from(report.stats.generated),
        f64::from(report.stats.expanded),
        length(raw),
        length(&pruned),
        length(&prune_dp(map, raw, Corner::Strict)),
        smooth(map, &pruned, 1.0, SmoothMode::Dynamic).length,
        f64::from(corners.count),
        corners.angle_deg,
        room.mean,
        room.min,
    ])
}

/// A row's printed values beside ours.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Table {
    /// The row.
    pub row: Row,
    /// No path between the printed end points is shorter, cells.
    pub straight: f64,
    /// Maps measured.
    pub maps: usize,
    /// A line per planner.
    pub lines: Vec<Line>,
    /// One planner's figures over another's, map by map.
    pub ratios: Vec<Ratio>,
}

/// A planner's line.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Line {
    /// The planner.
    pub planner: &'static str,
    /// Printed nodes.
    pub printed_nodes: Option<f64>,
    /// Printed length, cells.
    pub printed_length: Option<f64>,
    /// True if the printed length is below the straight line between the printed end points.
    pub impossible: bool,
    /// The one of [`READINGS`] whose median is nearest to the printed length; `None` where none is printed, or one that
    /// cannot be.
    pub closest: Option<&'static str>,
    /// Our figures, in the order of [`COLUMNS`].
    pub figures: Vec<Spread>,
}

impl Line {
    /// Our median over the printed length, by a reading.
    pub fn over_printed(&self, reading: &str) -> Option<f64> {
        let at = COLUMNS.iter().position(|c| *c == reading)?;
        self.printed_length.map(|printed| self.figures[at].median / printed)
    }

    fn with_closest(self) -> Self {
        let off =
            |reading: &&str| self.over_printed(reading).map_or(f64::INFINITY, |ratio| (ratio - 1.0).abs());
        let nearest = READINGS.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let closest = nearest.filter(|_| self.printed_length.is_some() && !self.impossible);
        Self { closest, ..self }
    }
}

/// One planner's figure over another's.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Ratio {
    /// The figure, one of [`COLUMNS`].
    pub figure: &'static str,
    /// The planner above.
    pub planner: &'static str,
    /// The planner below.
    pub over: &'static str,
    /// The figure below.
    pub over_figure: &'static str,
    /// The same of the printed values.
    pub printed: Option<f64>,
    /// Ours.
    pub ours: Spread,
}

/// Index of a planner's printed values in a [`Row`].
fn printed_at(planner: &str) -> Option<usize> {
    ["four", "eight", "risk-field"].iter().position(|p| *p == planner)
}

/// The summary of a row from the figures of any number of slices, one after another.
///
/// # Errors
/// [`ErrorCode::Input`] where the figures are none, not whole maps' or not numbers.
pub fn summary(row: &Row, figures: &[f64]) -> Result<Table, Error> {
    if figures.is_empty() || !figures.len().is_multiple_of(WIDTH) {
        let rule = message!("must have {} figures per map, got {}", WIDTH, figures.len());
        return Err(Error::new(ErrorCode::Input, "figures", rule));
    }
    if let Some(i) = figures.iter().position(|v| !v.is_finite()) {
        let rule = message!("must be a finite number, got {}", figures[i]);
        return Err(Error::new(ErrorCode::Input, format!("figures[{i}]"), rule));
    }
    let lines = PLANNERS
        .into_iter()
        .map(|planner| {
            let at = printed_at(planner);
            Line {
                planner,
                printed_nodes: at.map(|k| row.nodes[k]),
                printed_length: at.map(|k| row.lengths[k]),
                impossible: at.is_some_and(|k| row.lengths[k] < row.straight()),
                closest: None,
                figures: COLUMNS.iter().map(|c| Spread::of(&column(figures, planner, c))).collect(),
            }
            .with_closest()
        })
        .collect();
    let compared = [
        ("generated", "risk-field", "eight"),
        ("generated", "risk-field", "four"),
        ("generated", "risk-field", "eight-weighted"),
        ("generated", "risk-field-plus", "eight"),
        ("lengthPruned", "risk-field", "eight"),
        ("lengthPruned", "four", "eight"),
        ("lengthRaw", "sixteen", "eight-octile"),
        ("lengthRaw", "twenty-four", "sixteen"),
        ("lengthRaw", "forty-eight", "sixteen"),
        ("turnAngleDeg", "sixteen", "eight-octile"),
        ("turnAngleDeg", "forty-eight", "sixteen"),
        ("expanded", "sixteen-bidirectional", "sixteen"),
        ("expanded", "sixteen-nba", "sixteen"),
        ("lengthRaw", "sixteen-bidirectional", "sixteen"),
        ("lengthRaw", "sixteen-nba", "sixteen"),
        ("turnAngleDeg", "sixteen-bidirectional", "sixteen"),
        ("generated", "sixteen-bidirectional", "sixteen"),
        ("generated", "sixteen", "eight-octile"),
        ("generated", "twenty-four", "sixteen"),
        ("generated", "forty-eight", "sixteen"),
        ("milliseconds", "sixteen-bidirectional", "sixteen"),
        ("milliseconds", "sixteen", "eight-octile"),
        ("milliseconds", "twenty-four", "sixteen"),
        ("milliseconds", "forty-eight", "sixteen"),
        ("clearanceMean", "sixteen", "eight-octile"),
        ("clearanceMean", "twenty-four", "sixteen"),
        ("clearanceMean", "forty-eight", "sixteen"),
        ("generated", "eight", "dijkstra"),
        ("generated", "greedy", "dijkstra"),
        ("lengthRaw", "greedy", "dijkstra"),
    ];
    let alike = compared.into_iter().map(|(figure, planner, over)| [figure, planner, figure, over]);
    let ratios = alike.chain([["lengthDp", "risk-field-plus", "lengthPruned", "eight"]]);
    Ok(Table {
        row: *row,
        straight: row.straight(),
        maps: figures.len() / WIDTH,
        lines,
        ratios: ratios.map(|pair| ratio(row, figures, pair)).collect(),
    })
}

/// A figure's ratio to another one, map by map, as median, 95th percentile and worst, beside the ratio of the printed
/// values.
fn ratio(row: &Row, figures: &[f64], [figure, planner, over_figure, over]: [&'static str; 4]) -> Ratio {
    let (above, below) = (column(figures, planner, figure), column(figures, over, over_figure));
    // A straight path has no turns, and a clock that stands still no time: nothing to compare.
    let ours: Vec<f64> = above.iter().zip(&below).map(|(a, b)| if *b == 0.0 { 1.0 } else { a / b }).collect();
    let values = match figure {
        "generated" => Some(row.nodes),
        "lengthPruned" => Some(row.lengths),
        _ => None,
    };
    let printed = match (values, printed_at(planner), printed_at(over)) {
        (Some(values), Some(a), Some(b)) => Some(values[a] / values[b]),
        _ => None,
    };
    Ratio { figure, planner, over, over_figure, printed, ours: Spread::of(&ours) }
}

/// One figure of one planner, map by map.
fn column(figures: &[f64], planner: &str, name: &str) -> Vec<f64> {
    let planner = PLANNERS.iter().position(|p| *p == planner).unwrap_or(0);
    let column = COLUMNS.iter().position(|c| *c == name).unwrap_or(0);
    figures.chunks_exact(WIDTH).map(|map| map[planner * COLUMNS.len() + column]).collect()
}
