//! Chords instead of cells, where they keep their distance.

use super::{Config, Ground, Pruning};
use crate::map::Cell;
use crate::planners::weighted_cost;

/// Around each corner of the cells this many to either side may become corners of the chords.
const AROUND: usize = 4;
/// The best chords are looked for among at most this many cells.
const MOST: usize = 400;

/// The cells that stay: from each one the last that can be reached before the first that cannot; or, where that takes
/// fewer, the best among the cells near corners.
pub fn prune(ground: &Ground, cells: &[Cell], radius: f64, config: &Config) -> Vec<Cell> {
    if config.pruning == Pruning::None || cells.len() < 3 {
        return cells.to_vec();
    }
    let greedy = greedy(ground, cells, radius, config);
    if config.pruning == Pruning::Los {
        return greedy;
    }
    match fewest(ground, cells, radius, config) {
        Some(fewest) if fewest.len() < greedy.len() => fewest,
        _ => greedy,
    }
}

/// The clearance that a chord over cells of this clearance has to keep.
fn needed(config: &Config, radius: f64, least: f64) -> f64 {
    match config.pruning {
        Pruning::Auto => (config.prune_share * least).clamp(radius, radius + config.prune_cap),
        _ => f64::MIN_POSITIVE,
    }
}

/// Per cell what the way to it costs by weights; empty where all cells cost the same.
fn spent(ground: &Ground, cells: &[Cell]) -> Vec<i64> {
    let Some(weights) = &ground.weights else { return Vec::new() };
    let mut spent = vec![0];
    spent.extend(cells.windows(2).scan(0, |sum, pair| {
        *sum += weighted_cost(weights, pair[0], pair[1]);
        Some(*sum)
    }));
    spent
}

/// Whether a chord between two of the cells costs no more than the cells do.
fn is_cheap(ground: &Ground, cells: &[Cell], spent: &[i64], (a, b): (usize, usize)) -> bool {
    let dearer = |weights| weighted_cost(weights, cells[a], cells[b]) > spent[b] - spent[a];
    !ground.weights.as_deref().is_some_and(dearer)
}

fn greedy(ground: &Ground, cells: &[Cell], radius: f64, config: &Config) -> Vec<Cell> {
    let spent = spent(ground, cells);
    let mut kept = vec![cells[0]];
    let mut from = 0;
    while from + 1 < cells.len() {
        let mut least = ground.at(cells[from]).min(ground.at(cells[from + 1]));
        let mut to = from + 1;
        while to + 1 < cells.len() {
            least = least.min(ground.at(cells[to + 1]));
            if !clear(ground, cells[from], cells[to + 1], needed(config, radius, least))
                || !is_cheap(ground, cells, &spent, (from, to + 1))
            {
                break;
            }
            to += 1;
        }
        kept.push(cells[to]);
        from = to;
    }
    kept
}

/// The fewest chords, the shortest of those, between cells near corners; `None` where there are too many of these.
fn fewest(ground: &Ground, cells: &[Cell], radius: f64, config: &Config) -> Option<Vec<Cell>> {
    let step = |i: usize| (cells[i].x - cells[i - 1].x, cells[i].y - cells[i - 1].y);
    let end = cells.len() - 1;
    let mut near = vec![false; cells.len()];
    for i in (1..end).filter(|&i| step(i) != step(i + 1)) {
        near[i.saturating_sub(AROUND)..=(i + AROUND).min(end)].fill(true);
    }
    (near[0], near[end]) = (true, true);
    let places: Vec<usize> = (0..=end).filter(|&i| near[i]).collect();
    if places.len() > MOST {
        return None;
    }
    let spent = spent(ground, cells);
    // Per place: chords so far, their length, the place before.
    let mut best = vec![(u32::MAX, f64::INFINITY, 0); places.len()];
    best[0] = (0, 0.0, 0);
    for a in 0..places.len() {
        let (chords, length, _) = best[a];
        let mut least = f64::INFINITY;
        for b in a + 1..places.len() {
            least = (places[b - 1]..=places[b]).fold(least, |least, i| least.min(ground.at(cells[i])));
            let (from, to) = (cells[places[a]], cells[places[b]]);
            let (dx, dy) = (f64::from(to.x - from.x), f64::from(to.y - from.y));
            let total = length + (dx * dx + dy * dy).sqrt();
            if chords != u32::MAX
                && (chords + 1, total) < (best[b].0, best[b].1)
                && (places[b] == places[a] + 1 || clear(ground, from, to, needed(config, radius, least)))
                && is_cheap(ground, cells, &spent, (places[a], places[b]))
            {
                best[b] = (chords + 1, total, a);
            }
        }
    }
    let mut kept = vec![cells[end]];
    let mut at = places.len() - 1;
    while at > 0 {
        at = best[at].2;
        kept.push(cells[places[at]]);
    }
    kept.reverse();
    Some(kept)
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

/// Whether every cell of Bresenham's line has this clearance.
fn clear(ground: &Ground, a: Cell, b: Cell, needed: f64) -> bool {
    let (dx, dy) = ((b.x - a.x).abs(), -(b.y - a.y).abs());
    let (sx, sy) = ((b.x - a.x).signum(), (b.y - a.y).signum());
    let (mut at, mut error) = (a, dx + dy);
    loop {
        if ground.at(at) < needed {
            return false;
        }
        if at == b {
            return true;
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
