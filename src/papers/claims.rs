//! The papers' claims, judged on our rows.
//!
//! A claim is a sentence of a paper that figures can decide, say "the improved A* generates 54 % fewer nodes". Its
//! verdict is `yes`, `partly` or `no` by a rule that is written down here, and `unknown` while a row that it needs is
//! missing. A claim over several rows holds in part if some of them keep it.
//!
//! Figures are given by name, without sentences: the page and the documentation make those, in English and Chinese.
//! Counted work decides, never a clock; times are told beside it.

use std::collections::BTreeMap;

use serde::Serialize;

use super::NaiveStop;
use super::grid::{ROWS, Ratio, Table};

/// A claim and what we find. Its sentences are the reader's, by its id.
#[derive(Debug, Clone, Serialize)]
pub struct Claim {
    /// `H1` to `H3` of Hu et al. 2024, `Y1` to `Y6` of Yuan 2020, `K1` to `K5` of the parking paper, `R1` to `R5` of
    /// the road manuscript.
    pub id: &'static str,
    /// What we find, by name: ratios, percentages, metres or counts.
    pub figures: BTreeMap<&'static str, Figure>,
    /// `yes`, `no`, `partly`, or `unknown` where rows are missing.
    pub holds: &'static str,
}

impl Claim {
    pub(super) fn new<const N: usize>(
        id: &'static str,
        figures: [(&'static str, Figure); N],
        holds: &'static str,
    ) -> Self {
        Self { id, figures: figures.into(), holds }
    }
}

/// A row of a Markdown table.
impl std::fmt::Display for Claim {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let figures: Vec<_> = self.figures.iter().map(|(name, figure)| format!("{name} {figure}")).collect();
        write!(f, "| {} | {} | {} |", self.id, figures.join(", "), self.holds)
    }
}

/// A figure that a claim is judged by.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Figure {
    /// One number.
    Number(f64),
    /// The smallest and the largest of several rows' numbers; `None` where no row is measured.
    Range(Option<(f64, f64)>),
}

impl From<f64> for Figure {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<(f64, f64)> for Figure {
    fn from((low, high): (f64, f64)) -> Self {
        Self::Range((low <= high).then_some((low, high)))
    }
}

impl std::fmt::Display for Figure {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number:.3}"),
            Self::Range(Some((low, high))) => write!(f, "{low:.3} to {high:.3}"),
            Self::Range(None) => f.write_str("not measured"),
        }
    }
}

/// The claims of the grid papers, judged on the rows there are.
pub fn claims(tables: &[Table]) -> Vec<Claim> {
    let complete = tables.len() == ROWS.len();
    let mut all: Vec<_> = risk_field_claims(tables)
        .into_iter()
        .chain(sixteen_claims(tables))
        .chain(clearance_and_greedy_claims(tables))
        .collect();
    for claim in &mut all {
        claim.holds = if complete { claim.holds } else { "unknown" };
    }
    all
}

/// The claims of Hu et al. 2024.
fn risk_field_claims(tables: &[Table]) -> [Claim; 3] {
    let over = |figure, planner| Range::of(tables, figure, "risk-field", planner);
    let (eight, weighted) = (over("generated", "eight"), over("generated", "eight-weighted"));
    let (four, pruned) = (over("generated", "four"), over("lengthPruned", "eight"));
    let at_most = |Range(low, high): Range, bound: f64| {
        if high <= bound {
            "yes"
        } else if low <= bound {
            "partly"
        } else {
            "no"
        }
    };
    [
        Claim::new(
            "H1",
            [("generated", eight.into()), ("weighted", weighted.into())],
            if eight.1 < 0.4577 && weighted.0 > 0.4065 { "partly" } else { "no" },
        ),
        Claim::new("H2", [("generated", four.into())], at_most(four, 0.4939)),
        Claim::new("H3", [("length", pruned.into())], at_most(pruned, 1.0059)),
    ]
}

/// The claims of Yuan 2020.
fn sixteen_claims(tables: &[Table]) -> [Claim; 4] {
    let medians = |figure, planner, over| Range::of(tables, figure, planner, over);
    let (short16, turn16) =
        (medians("lengthRaw", "sixteen", "eight-octile"), medians("turnAngleDeg", "sixteen", "eight-octile"));
    // Milliseconds depend on the machine and its load: they are told, and counted work decides.
    let told = |planner, over| (medians("generated", planner, over), medians("milliseconds", planner, over));
    let ((work16, time16), (work24, time24), (work48, time48)) =
        (told("sixteen", "eight-octile"), told("twenty-four", "sixteen"), told("forty-eight", "sixteen"));
    let (work_both, time_both) = told("sixteen-bidirectional", "sixteen");
    let (short24, short48) =
        (medians("lengthRaw", "twenty-four", "sixteen"), medians("lengthRaw", "forty-eight", "sixteen"));
    let both = |figure| medians(figure, "sixteen-bidirectional", "sixteen");
    let turn48 = medians("turnAngleDeg", "forty-eight", "sixteen");
    // The same maps for any rows: the verdict does not depend on how many are measured.
    let naive = NaiveStop::measured();
    let longest = worst(tables, "sixteen-bidirectional", "sixteen");
    [
        Claim::new(
            "Y1",
            [
                ("length", short16.into()),
                ("turning", turn16.into()),
                ("generated", work16.into()),
                ("time", time16.into()),
            ],
            share_of(&[short16.1 < 1.0 && turn16.1 < 1.0, work16.0 > 1.0]),
        ),
        Claim::new(
            "Y2",
            [
                ("length24", short24.into()),
                ("generated24", work24.into()),
                ("time24", time24.into()),
                ("length48", short48.into()),
                ("turning48", turn48.into()),
                ("generated48", work48.into()),
                ("time48", time48.into()),
            ],
            share_of(&[
                turn48.0 >= 1.0,
                short24.1 < 1.0 && short48.1 < 1.0,
                work24.0 > 1.0 && work48.0 > 1.0,
            ]),
        ),
        Claim::new(
            "Y3",
            [
                ("length", both("lengthRaw").into()),
                ("longest", longest.into()),
                ("turning", both("turnAngleDeg").into()),
                ("generated", work_both.into()),
                ("time", time_both.into()),
            ],
            share_of(&[longest <= 1.0, work_both.1 < 1.0]),
        ),
        Claim::new(
            "Y4",
            [
                ("maps", f64::from(naive.maps).into()),
                ("none", f64::from(naive.none).into()),
                ("longer", f64::from(naive.longer).into()),
                ("worst", naive.worst.into()),
            ],
            share_of(&[naive.none > 0]),
        ),
    ]
}

/// Claims of Yuan 2020 of how near paths are to obstacles, and of best-first search.
fn clearance_and_greedy_claims(tables: &[Table]) -> [Claim; 2] {
    let room = |planner, over| Range::of(tables, "clearanceMean", planner, over);
    let (room16, room24, room48) =
        (room("sixteen", "eight-octile"), room("twenty-four", "sixteen"), room("forty-eight", "sixteen"));
    let of_greedy = |figure| Range::of(tables, figure, "greedy", "dijkstra");
    let (work, length) = (of_greedy("generated"), of_greedy("lengthRaw"));
    let longest = worst(tables, "greedy", "dijkstra");
    [
        Claim::new(
            "Y5",
            [("clearance16", room16.into()), ("clearance24", room24.into()), ("clearance48", room48.into())],
            if room24.1 < 1.0 && room48.1 < 1.0 {
                "yes"
            } else if room24.0 < 1.0 || room48.0 < 1.0 {
                "partly"
            } else {
                "no"
            },
        ),
        Claim::new(
            "Y6",
            [("generated", work.into()), ("length", length.into()), ("longest", longest.into())],
            share_of(&[work.1 < 1.0, longest > 1.0]),
        ),
    ]
}

/// How much of a claim of several parts holds.
pub(super) fn share_of(hold: &[bool]) -> &'static str {
    match hold.iter().filter(|part| **part).count() {
        0 => "no",
        count if count == hold.len() => "yes",
        _ => "partly",
    }
}

/// The worst of a planner's lengths over another's, on any map.
fn worst(tables: &[Table], planner: &str, over: &str) -> f64 {
    let same = |r: &&Ratio| r.figure == "lengthRaw" && r.planner == planner && r.over == over;
    tables.iter().filter_map(|t| t.ratios.iter().find(same)).fold(0.0, |worst, r| worst.max(r.ours.worst))
}

/// The smallest and the largest median over the rows.
#[derive(Clone, Copy)]
struct Range(f64, f64);

impl Range {
    fn of(tables: &[Table], figure: &str, planner: &str, over: &str) -> Self {
        let same = |r: &&Ratio| r.figure == figure && r.planner == planner && r.over == over;
        let medians = tables.iter().filter_map(|t| t.ratios.iter().find(same)).map(|r| r.ours.median);
        medians
            .fold(Self(f64::INFINITY, f64::NEG_INFINITY), |Self(low, high), m| Self(low.min(m), high.max(m)))
    }
}

impl From<Range> for Figure {
    fn from(Range(low, high): Range) -> Self {
        (low, high).into()
    }
}
