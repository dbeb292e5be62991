//! Section 4 of the road manuscript: its tables beside plain A*, our cost map, and its own method taken literally.
//!
//! The manuscript publishes no geometry; the scenes are ours, built to what it says of them. Its distances are a
//! ship's, so every scene also comes ten times as large with the ship of its appendix B.

use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::error::{Error, ErrorCode};
use crate::metrics::random_drives::{self, Risk};
use crate::metrics::road::RoadMetrics;
use crate::plan::{Detail, Options, Planner, collision_risk};
use crate::scenario::Scenario;
use crate::scenario::catalog;

/// Memory that planning may take, bytes per cell of the map.
const MOST_BYTES: f64 = 16.0;
/// The tightest circle of the manuscript's car, 1/m.
const MOST_CURVATURE: f64 = 1.0 / 5.5;

/// A scene and what is printed of it, each for plain and improved A*.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Row {
    /// `S1`, …, and `S1-ship`, ….
    pub id: &'static str,
    /// The scene.
    pub scene: &'static str,
    /// True if it is ten times as large, for the ship.
    pub ship: bool,
    /// Printed values.
    pub printed: Printed,
}

/// Printed values of plain and improved A*.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Printed {
    /// Metres.
    pub length: [f64; 2],
    /// Turning points.
    pub turns: [f64; 2],
    /// Metres.
    pub safety: [f64; 2],
    /// Seconds.
    pub time: [f64; 2],
    /// MB.
    pub memory: [f64; 2],
    /// Of 1000.
    pub collisions: [f64; 2],
}

const S1: Printed = Printed {
    length: [1000.0, 1000.0],
    turns: [2.0, 2.0],
    safety: [60.0, 60.0],
    time: [0.012, 0.045],
    memory: [2.1, 8.5],
    collisions: [0.0, 0.0],
};
const S2: Printed = Printed {
    length: [850.2, 865.4],
    turns: [8.0, 3.0],
    safety: [8.5, 17.2],
    time: [0.018, 0.052],
    memory: [2.3, 9.2],
    collisions: [23.0, 0.0],
};
const S3: Printed = Printed {
    length: [720.8, 745.6],
    turns: [15.0, 6.0],
    safety: [6.2, 16.8],
    time: [0.025, 0.068],
    memory: [2.8, 10.1],
    collisions: [45.0, 2.0],
};
const S4: Printed = Printed {
    length: [680.5, 712.3],
    turns: [22.0, 9.0],
    safety: [5.1, 16.5],
    time: [0.032, 0.085],
    memory: [3.2, 11.8],
    collisions: [67.0, 3.0],
};

/// The manuscript's scenes, for its car and for its ship.
pub const ROWS: [Row; 8] = [
    Row { id: "S1", scene: "road-straight", ship: false, printed: S1 },
    Row { id: "S2", scene: "road-curve", ship: false, printed: S2 },
    Row { id: "S3", scene: "road-crossing", ship: false, printed: S3 },
    Row { id: "S4", scene: "road-narrow", ship: false, printed: S4 },
    Row { id: "S1-ship", scene: "road-straight-ship", ship: true, printed: S1 },
    Row { id: "S2-ship", scene: "road-curve-ship", ship: true, printed: S2 },
    Row { id: "S3-ship", scene: "road-crossing-ship", ship: true, printed: S3 },
    Row { id: "S4-ship", scene: "road-narrow-ship", ship: true, printed: S4 },
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

impl Row {
    /// The scene.
    ///
    /// # Errors
    /// None for rows of [`ROWS`].
    pub fn scenario(&self) -> Result<Scenario, Error> {
        catalog::scenario(self.scene)
    }

    /// Names of what is compared and its settings of the planner `cost-map`; plain A* comes first.
    pub fn lines(&self) -> Vec<(&'static str, Map<String, Value>)> {
        let lines = if self.ship {
            vec![
                ("plain", json!({ "costs": "steps", "pruning": "none", "smoothing": "none" })),
                // The scene has the ship's costs and margin.
                ("paper", json!({})),
                ("paper-exponential", json!({ "base": "exponential" })),
                ("literal", json!({ "costs": "paper", "pruning": "los", "smoothing": "paper" })),
            ]
        } else {
            vec![
                ("plain", json!({ "costs": "steps", "pruning": "none", "smoothing": "none" })),
                ("inverse", json!({})),
                ("exponential", json!({ "base": "exponential" })),
                ("literal", json!({ "costs": "paper", "pruning": "los", "smoothing": "paper" })),
            ]
        };
        let object = |value: Value| if let Value::Object(fields) = value { fields } else { Map::new() };
        lines.into_iter().map(|(id, settings)| (id, object(settings))).collect()
    }
}

/// Measurements of a row.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Table {
    /// The row.
    pub row: Row,
    /// Cells of the map.
    pub cells: u32,
    /// Plain A* first.
    pub lines: Vec<Line>,
    /// Promises of the second line; ships have none.
    pub promises: Vec<Promise>,
}

/// Figures of one planner on a scene.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Line {
    /// `plain`, `inverse`, ….
    pub id: &'static str,
    /// The independent checker's.
    pub verdict: &'static str,
    /// True if the chords stayed, because no curve was good enough.
    pub fell_back: bool,
    /// Of the path.
    pub metrics: RoadMetrics,
    /// Of a thousand drives.
    pub risk: Risk,
    /// Of planning from the scene on, checks included: the fastest of the rounds.
    pub milliseconds: f64,
}

/// A bound on a figure and what was found.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Promise {
    /// `length`, `turns`, `curvatureVariation`, `clearanceMean`, `clearanceLeast`, `hits`, `curvature`,
    /// `laneDeviation`, `laneLeft` or `bytesPerCell`.
    pub figure: &'static str,
    /// True if the figure must not be less than the bound, rather than not more.
    pub at_least: bool,
    /// The bound of the promise.
    pub bound: f64,
    /// The cost map's.
    pub found: f64,
    /// Plain A*'s.
    pub plain: f64,
    /// True if it keeps to it.
    pub kept: bool,
}

/// Measures a row; `clock` tells milliseconds, 0 throughout where nobody measures.
///
/// # Errors
/// [`ErrorCode::Input`] for no rounds at all.
///
/// # Examples
/// ```
/// use parkade::papers::road::{measure, row};
///
/// let table = measure(row("S1").unwrap(), 1, &mut || 0.0).unwrap();
/// assert!(table.promises.iter().any(|p| p.figure == "clearanceLeast" && p.kept));
/// ```
pub fn measure(row: &Row, rounds: u32, clock: &mut dyn FnMut() -> f64) -> Result<Table, Error> {
    if !(1..=1000).contains(&rounds) {
        return Err(Error::new(ErrorCode::Input, "rounds", message!("must be 1 to 1000, got {}", rounds)));
    }
    let scene = row.scenario()?;
    let lines = row
        .lines()
        .into_iter()
        .map(|(id, settings)| line(&scene, id, &settings, rounds, clock))
        .collect::<Result<Vec<Line>, Error>>()?;
    let cells = scene.map.width * scene.map.height;
    let promises = if row.ship { Vec::new() } else { promises(row.id, cells, &lines[0], &lines[1]) };
    Ok(Table { row: *row, cells, lines, promises })
}

/// Plans a scene in one way and measures it. The time is that of the fastest of `rounds`; plans do not differ.
fn line(
    scene: &Scenario,
    id: &'static str,
    settings: &Map<String, Value>,
    rounds: u32,
    clock: &mut dyn FnMut() -> f64,
) -> Result<Line, Error> {
    let mut milliseconds = f64::INFINITY;
    let mut round = || {
        let before = clock();
        let plan = Planner::new("cost-map", scene, settings)?.plan(Options::default());
        milliseconds = milliseconds.min(clock() - before);
        Ok::<_, Error>(plan)
    };
    let mut plan = round()?;
    for _ in 1..rounds {
        plan = round()?;
    }
    let path: Vec<f64> = plan.path.iter().flat_map(|p| [p.x, p.y, p.heading]).collect();
    let risk = collision_risk(scene, &path, &random_drives::Options::default())?;
    let metrics = plan.metrics.road.unwrap_or_default();
    let fell_back = plan.detail == Some(Detail::SmoothingFellBack);
    Ok(Line { id, verdict: plan.check.verdict.as_str(), fell_back, metrics, risk, milliseconds })
}

/// What the improved line is held to on a scene: no longer than the plain one, fewer turning points, a quarter of its
/// curvature variation, a twentieth of its hits, and the room and memory that are stated here. The straight lane has
/// nothing to turn for, so its bounds are its own.
fn promises(scene: &str, cells: u32, plain: &Line, ours: &Line) -> Vec<Promise> {
    let promise = |figure, of: &dyn Fn(&Line) -> f64, at_least: bool, bound: f64| {
        let (found, plain) = (of(ours), of(plain));
        let kept = if at_least { found >= bound } else { found <= bound + 1e-6 };
        Promise { figure, at_least, bound, found, plain, kept }
    };
    let length = |line: &Line| line.metrics.figures.middle_length;
    let turns = |line: &Line| f64::from(line.metrics.turns_pruned);
    let variation = |line: &Line| line.metrics.figures.curvature_variation;
    let mean = |line: &Line| line.metrics.figures.body_clearance_mean_capped;
    let least = |line: &Line| line.metrics.figures.body_clearance_min;
    let hits = |line: &Line| f64::from(line.risk.hits);
    let curvature = |line: &Line| line.metrics.figures.middle_curvature;
    let lane = |line: &Line| line.metrics.figures.lane_deviation_mean.unwrap_or(0.0);
    let left = |line: &Line| line.metrics.figures.lane_left_share.unwrap_or(0.0);
    let bytes = |line: &Line| line.metrics.bytes as f64 / f64::from(cells);
    let (most_turns, clearances) = match scene {
        "S1" => (2.0, [0.79, 0.79]),
        "S4" => (11.0, [0.8, 0.5]),
        _ => (0.45 * turns(plain), [0.8, 0.5]),
    };
    vec![
        promise("length", &length, false, length(plain)),
        promise("turns", &turns, false, most_turns),
        promise("curvatureVariation", &variation, false, 0.25 * variation(plain)),
        promise("curvature", &curvature, false, MOST_CURVATURE),
        promise("clearanceMean", &mean, true, clearances[0]),
        promise("clearanceLeast", &least, true, clearances[1]),
        promise("hits", &hits, false, 0.05 * hits(plain)),
        promise("laneDeviation", &lane, false, lane(plain)),
        promise("laneLeft", &left, false, left(plain)),
        promise("bytesPerCell", &bytes, false, MOST_BYTES),
    ]
}
