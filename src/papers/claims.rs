//! The papers' claims, judged on our rows.

use serde::Serialize;

use super::NaiveStop;
use super::grid::{ROWS, Ratio, Table};

/// A claim and what we find.
#[derive(Debug, Clone, Serialize)]
pub struct Claim {
    /// `H1` to `H3` of Hu et al. 2024, `Y1` to `Y4` of Yuan 2020.
    pub id: &'static str,
    /// The paper's claim.
    pub text: &'static str,
    /// Our finding: the range of medians over the rows.
    pub found: String,
    /// `yes`, `no`, `partly`, or `unknown` where rows are missing.
    pub holds: &'static str,
}

/// The claims, judged on the rows there are.
pub fn claims(tables: &[Table]) -> Vec<Claim> {
    let medians = |figure, planner, over| Range::of(tables, figure, planner, over);
    let complete = tables.len() == ROWS.len();
    let judged = |id, text, found: String, holds| Claim {
        id,
        text,
        found,
        holds: if complete { holds } else { "unknown" },
    };
    let share = |over| medians("generated", "risk-field", over);
    let (eight, weighted, four) = (share("eight"), share("eight-weighted"), share("four"));
    let pruned = medians("lengthPruned", "risk-field", "eight");
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
    let longest = worst(tables, "lengthRaw", "sixteen-bidirectional");
    vec![
        judged(
            "H1",
            "The improved planner visits 0.41 to 0.46 of the nodes of eight neighbours.",
            format!(
                "generates {eight} of plain eight neighbours', {weighted} of theirs under the same weight"
            ),
            if eight.1 < 0.4577 && weighted.0 > 0.4065 { "partly" } else { "no" },
        ),
        judged(
            "H2",
            "The improved planner visits 0.36 to 0.49 of the nodes of four neighbours.",
            format!("generates {four}"),
            if four.1 < 0.4939 {
                "yes"
            } else if four.0 < 0.4939 {
                "partly"
            } else {
                "no"
            },
        ),
        judged(
            "H3",
            "Its path is at most 0.6 % longer than with eight neighbours.",
            format!("{pruned} after pruning"),
            if pruned.1 <= 1.0059 {
                "yes"
            } else if pruned.0 <= 1.0059 {
                "partly"
            } else {
                "no"
            },
        ),
        judged(
            "Y1",
            "Sixteen neighbours give shorter and smoother paths than eight, at clearly more time.",
            format!("length {short16}, turning {turn16}, generated {work16}, time {time16}"),
            share_of(&[short16.1 < 1.0 && turn16.1 < 1.0, work16.0 > 1.0]),
        ),
        judged(
            "Y2",
            "24 and 48 neighbours are no smoother, somewhat shorter, much slower.",
            format!(
                "24: length {short24}, generated {work24}, time {time24}; 48: length {short48}, turning {turn48}, \
                 generated {work48}, time {time48} of sixteen's"
            ),
            share_of(&[
                turn48.0 >= 1.0,
                short24.1 < 1.0 && short48.1 < 1.0,
                work24.0 > 1.0 && work48.0 > 1.0,
            ]),
        ),
        judged(
            "Y3",
            "Sixteen neighbours from both ends keep the quality of the path and need the least time.",
            format!(
                "length {} of sixteen's in the median, {:.3} at worst; turning {}, generated {work_both}, time {time_both}",
                both("lengthRaw"),
                longest,
                both("turnAngleDeg")
            ),
            share_of(&[longest <= 1.0, work_both.1 < 1.0]),
        ),
        judged(
            "Y4",
            "Plain search from both ends can fail or loop where no common best node is found.",
            format!(
                "stopping at the same best node, on {} maps that have a path: none found on {}, a longer one than the \
                 cheapest on {}, {:.2} of it at worst; no endless loop, because a closed cell stays closed",
                naive.maps, naive.none, naive.longer, naive.worst
            ),
            share_of(&[naive.none > 0]),
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

/// The worst of a planner's figures over sixteen neighbours', on any map.
fn worst(tables: &[Table], figure: &str, planner: &str) -> f64 {
    let same = |r: &&Ratio| r.figure == figure && r.planner == planner && r.over == "sixteen";
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

impl std::fmt::Display for Range {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        if self.0 > self.1 {
            f.write_str("not measured")
        } else {
            write!(f, "{:.3} to {:.3}", self.0, self.1)
        }
    }
}
