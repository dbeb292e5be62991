//! Chords instead of cells, where they keep their distance and are worth what they cost.
//!
//! A path of cells turns by 45° where a straight line would do. Cells near corners become candidates, and the cheapest
//! chain of chords between them is found by dynamic programming: a chord costs what the map charges along it, a corner
//! costs as much as ten cells. A chord keeps at least 0.8 of the room that its cells have, and half the car's width.
//!
//! In formulas, for candidates c₀ … cₙ in the order of the path, with the cost w of a chord and the price p of a
//! corner:
//!
//! ```text
//! best(b) = min over a < b of  best(a) + w(a, b) + p
//! ```
//!
//! That is O(n²) chords, each as long as its cells, so n is limited to 400 and a row of 40 failures from one
//! candidate ends its turn. Chords follow Bresenham's cells; each of them must have the room that is asked for.

use super::{Config, CostMap, Curves, Pruning, RoadRasters};
use crate::map::{Cell, Weights};

/// Around each corner of the cells this many to either side may become corners of the chords.
const AROUND: usize = 4;
/// The best chords are looked for among at most this many cells.
const MOST: usize = 400;
/// After so many cells in a row that a chord from one cell cannot reach, no more are tried.
const MISSES: usize = 40;
/// A corner counts as much as the way over so many cells.
const CORNER: f64 = 10.0;

/// A road, what it costs, and how chords over it are chosen.
pub(super) struct Chords<'a> {
    pub(super) ground: &'a RoadRasters,
    pub(super) costs: &'a CostMap,
    pub(super) radius: f64,
    pub(super) config: &'a Config,
}

impl Chords<'_> {
    /// The cells that stay. Those of which the chords between them cost the least, a corner as much as ten cells; with
    /// `los` from each one the last that can be seen before the first that cannot.
    pub(super) fn prune(&self, cells: &[Cell]) -> Vec<Cell> {
        match self.config.pruning {
            Pruning::None => cells.to_vec(),
            _ if cells.len() < 3 => cells.to_vec(),
            Pruning::Los => self.greedy(cells),
            Pruning::Auto => self.cheapest(cells),
        }
    }

    /// The clearance that a chord over cells of this clearance has to keep.
    fn needed(&self, least: f64) -> f64 {
        let Config { pruning, prune_share, prune_cap, .. } = *self.config;
        match pruning {
            Pruning::Auto => {
                let margin = self.config.kept();
                // A margin beyond what is enough room for chords is theirs, too, as far as the cells have it.
                let own = if margin > prune_cap { least.min(self.radius + margin) } else { 0.0 };
                (prune_share * least).clamp(self.radius, self.radius + prune_cap).max(own)
            }
            _ => f64::MIN_POSITIVE,
        }
    }

    /// From each kept cell the farthest one in sight, as the manuscript prunes. O(cells²) at worst.
    fn greedy(&self, cells: &[Cell]) -> Vec<Cell> {
        let spent = spent(self.ground, cells);
        let mut kept = vec![cells[0]];
        let mut from = 0;
        while from + 1 < cells.len() {
            let mut to = from + 1;
            while to + 1 < cells.len()
                && self.chord(cells[from], cells[to + 1], f64::MIN_POSITIVE).is_some()
                && is_cheap(self.ground, cells, &spent, (from, to + 1))
            {
                to += 1;
            }
            kept.push(cells[to]);
            from = to;
        }
        kept
    }

    /// The cheapest chain of chords over the candidates.
    fn cheapest(&self, cells: &[Cell]) -> Vec<Cell> {
        let places = places(cells);
        let spent = spent(self.ground, cells);
        let sums = self.sums(cells);
        let corner = CORNER * sums[cells.len() - 1] / (cells.len() - 1) as f64;
        // Per place: the cost of the way there, the place before.
        let mut best = vec![(f64::INFINITY, 0); places.len()];
        best[0] = (0.0, 0);
        for a in 0..places.len() - 1 {
            let (before, from) = (best[a].0, places[a]);
            let (mut least, mut misses) = (f64::INFINITY, 0);
            for b in a + 1..places.len() {
                let to = places[b];
                least = (places[b - 1]..=to).fold(least, |least, i| least.min(self.ground.at(cells[i])));
                // The cells themselves are a way where they are straight.
                let is_next = b == a + 1 && is_straight(&cells[from..=to]);
                let along = || sums[to] - sums[from];
                let chord = || self.chord(cells[from], cells[to], self.needed(least));
                let cost = if is_next { Some(along()) } else { chord() };
                let Some(cost) = cost.filter(|_| is_cheap(self.ground, cells, &spent, (from, to))) else {
                    misses += 1;
                    if misses > MISSES {
                        break;
                    }
                    continue;
                };
                misses = 0;
                if before + cost + corner < best[b].0 {
                    best[b] = (before + cost + corner, a);
                }
            }
        }
        let mut kept = vec![cells[places[places.len() - 1]]];
        let mut at = places.len() - 1;
        while at > 0 {
            at = best[at].1;
            kept.push(cells[places[at]]);
        }
        kept.reverse();
        kept
    }

    /// Cost of a metre in a cell. The margin is left to the curve.
    fn metre(&self, cell: Cell) -> f64 {
        let is_final = self.config.smoothing == Curves::None;
        self.costs.metre(self.ground, cell, is_final).unwrap_or(1.0)
    }

    /// Per cell, what the way to it costs.
    fn sums(&self, cells: &[Cell]) -> Vec<f64> {
        let mut sums = vec![0.0];
        for pair in cells.windows(2) {
            let step = away(pair[0], pair[1]) * self.ground.frame.resolution;
            sums.push(sums[sums.len() - 1] + step * f64::midpoint(self.metre(pair[0]), self.metre(pair[1])));
        }
        sums
    }

    /// Cost of a chord; `None` unless every cell of Bresenham's line has this clearance.
    fn chord(&self, a: Cell, b: Cell, needed: f64) -> Option<f64> {
        let (dx, dy) = ((b.x - a.x).abs(), -(b.y - a.y).abs());
        let (sx, sy) = ((b.x - a.x).signum(), (b.y - a.y).signum());
        let (mut at, mut error) = (a, dx + dy);
        let mut sum = 0.0;
        loop {
            if self.ground.at(at) < needed {
                return None;
            }
            let share = if at == a || at == b { 0.5 } else { 1.0 };
            sum += share * self.metre(at);
            if at == b {
                let steps = f64::from(dx.max(-dy)).max(1.0);
                return Some(sum * away(a, b) * self.ground.frame.resolution / steps);
            }
            let twice = 2 * error;
            if twice >= dy {
                error += dy;
                at.x += sx;
            }
            if twice <= dx {
                error += dx;
                at.y += sy;
            }
        }
    }
}

/// Between two cells, in cells.
fn away(a: Cell, b: Cell) -> f64 {
    let (dx, dy) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
    (dx * dx + dy * dy).sqrt()
}

/// True if all steps between the cells are the same.
fn is_straight(cells: &[Cell]) -> bool {
    let step = |w: &[Cell]| (w[1].x - w[0].x, w[1].y - w[0].y);
    cells.windows(2).all(|w| step(w) == step(cells))
}

/// The cells among which chords are looked for: those near corners of the cells, or every so many of them.
fn places(cells: &[Cell]) -> Vec<usize> {
    let step = |i: usize| (cells[i].x - cells[i - 1].x, cells[i].y - cells[i - 1].y);
    let end = cells.len() - 1;
    let mut near = vec![false; cells.len()];
    for i in (1..end).filter(|&i| step(i) != step(i + 1)) {
        near[i.saturating_sub(AROUND)..=(i + AROUND).min(end)].fill(true);
    }
    (near[0], near[end]) = (true, true);
    let places: Vec<usize> = (0..=end).filter(|&i| near[i]).collect();
    let every = places.len().div_ceil(MOST);
    let last = places.len() - 1;
    (0..=last).filter(|i| i % every == 0 || *i == last).map(|i| places[i]).collect()
}

/// Per cell what the way to it costs by weights; empty where all cells cost the same.
fn spent(ground: &RoadRasters, cells: &[Cell]) -> Vec<i64> {
    let Some(weights) = &ground.weights else { return Vec::new() };
    let mut spent = vec![0];
    spent.extend(cells.windows(2).scan(0, |sum, pair| {
        *sum += weights.cost(pair[0], pair[1]);
        Some(*sum)
    }));
    spent
}

/// True if a chord between two of the cells costs no more by weights than the cells do.
fn is_cheap(ground: &RoadRasters, cells: &[Cell], spent: &[i64], (a, b): (usize, usize)) -> bool {
    let dearer = |weights: &Weights| weights.cost(cells[a], cells[b]) > spent[b] - spent[a];
    !ground.weights.as_deref().is_some_and(dearer)
}

/// The ends and the corners: cells in a straight row vanish.
pub fn corners(cells: &[Cell]) -> Vec<Cell> {
    let mut kept: Vec<Cell> = Vec::new();
    for &cell in cells {
        if let [.., a, b] = kept[..] {
            let (ux, uy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
            let (vx, vy) = (i64::from(cell.x - b.x), i64::from(cell.y - b.y));
            if ux * vy == uy * vx && ux * vx + uy * vy >= 0 {
                kept.pop();
            }
        }
        kept.push(cell);
    }
    kept
}
