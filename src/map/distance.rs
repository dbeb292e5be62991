//! Exact Euclidean distance transforms, in integers.
//!
//! Two passes (Felzenszwalb & Huttenlocher 2012): the nearest blocked cell in each column, then the lower envelope of
//! one parabola per column in each row. All numbers are squared half-cells, which makes both distances below exact.
//! The transform takes O(cells) whatever is blocked: each parabola enters the envelope once and leaves it at most once.

use super::{Layer, Occupancy};

/// The value of a cell on a map where nothing is blocked; larger than any squared distance.
pub const NONE: i64 = i64::MAX / 4;

/// `value` of four times the squared distance, in cells, from each cell's centre to the nearest blocked cell's centre;
/// of [`NONE`] where the map has no blocked cell. Takes no more room than its result.
pub fn to_centers(map: &Occupancy, value: impl Fn(i64) -> f32) -> Layer<f32> {
    let mut columns = column_distances(map, u32::MAX, |d| d);
    let width = map.width() as usize;
    let mut envelope = Envelope::default();
    let mut source = vec![NONE; width];
    for row in columns.data.chunks_mut(width.max(1)) {
        for (square, &d) in source.iter_mut().zip(&*row) {
            *square = if d == u32::MAX { NONE } else { 4 * i64::from(d) * i64::from(d) };
        }
        envelope.build(source.iter().enumerate().map(|(x, &v)| (2 * x as i64, v)));
        envelope.sample(row, |known, _| value(known).to_bits());
    }
    let data = columns.data.into_iter().map(f32::from_bits).collect();
    Layer { width: columns.width, height: columns.height, data }
}

/// Four times the squared distance, in cells, from each cell's centre to the nearest blocked cell's closed square: 0
/// in a blocked cell, 1 beside one; [`NONE`] where the map has no blocked cell.
pub fn to_squares(map: &Occupancy) -> Layer<i64> {
    let square = |d: u32| if d == 0 { 0 } else { (2 * i64::from(d) - 1) * (2 * i64::from(d) - 1) };
    let mut columns = column_distances(map, NONE, square);
    let width = map.width() as usize;
    let mut envelope = Envelope::default();
    let mut edges = vec![NONE; width + 1];
    for row in columns.data.chunks_mut(width.max(1)) {
        // Seen from another column, a square begins at its edge: the parabolas stand on the edges between columns.
        edges.fill(NONE);
        for (x, &v) in row.iter().enumerate() {
            edges[x] = edges[x].min(v);
            edges[x + 1] = edges[x + 1].min(v);
        }
        envelope.build(edges.iter().enumerate().map(|(x, &v)| (2 * x as i64 - 1, v)));
        envelope.sample(row, Ord::min);
    }
    columns
}

/// Metres from each cell's centre to the nearest blocked cell's square; infinity where nothing is blocked.
pub fn clearance(map: &Occupancy, resolution: f64) -> Layer<f32> {
    let squares = to_squares(map);
    let metres = |&d: &i64| {
        if d >= NONE { f32::INFINITY } else { ((d as f64).sqrt() * 0.5 * resolution) as f32 }
    };
    Layer { width: squares.width, height: squares.height, data: squares.data.iter().map(metres).collect() }
}

/// `cost(distance)`, which grows with it, to the nearest blocked cell in the same column; `none` where there is none.
fn column_distances<T: Copy + Ord>(map: &Occupancy, none: T, cost: impl Fn(u32) -> T) -> Layer<T> {
    let (width, height) = (map.width() as usize, map.height() as usize);
    let mut costs = Layer::filled(map.width(), map.height(), none);
    let mut near = vec![u32::MAX; width];
    for upward in [true, false] {
        near.fill(u32::MAX);
        for k in 0..height {
            let y = if upward { k } else { height - 1 - k };
            let row = map.row(y as u32);
            for (x, least) in costs.data[y * width..][..width].iter_mut().enumerate() {
                near[x] = if row[x] != 0 { 0 } else { near[x].saturating_add(1) };
                if near[x] != u32::MAX {
                    *least = cost(near[x]).min(*least);
                }
            }
        }
    }
    costs
}

/// The lower envelope of parabolas `(x - p)² + v`.
#[derive(Default)]
struct Envelope {
    /// Position, height, first position from which the parabola is the lowest.
    parabolas: Vec<(i64, i64, i64)>,
}

impl Envelope {
    /// Makes the envelope of parabolas whose positions increase (Felzenszwalb, Huttenlocher 2012). Each is added once
    /// and removed at most once: O(n).
    fn build(&mut self, parabolas: impl Iterator<Item = (i64, i64)>) {
        self.parabolas.clear();
        for (p, v) in parabolas.filter(|&(_, v)| v < NONE) {
            let mut from = i64::MIN;
            while let Some(&(q, w, begin)) = self.parabolas.last() {
                // The new one is at most as high from where (x-p)² + v <= (x-q)² + w.
                from = (v + p * p - w - q * q + 2 * (p - q) - 1).div_euclid(2 * (p - q));
                if from > begin {
                    break;
                }
                self.parabolas.pop();
                from = i64::MIN;
            }
            self.parabolas.push((p, v, from));
        }
    }

    /// Writes `combine(envelope, old value)` to each cell of a row, cell x at position 2x.
    fn sample<T: Copy>(&self, row: &mut [T], combine: impl Fn(i64, T) -> T) {
        let mut k = 0;
        for (x, value) in row.iter_mut().enumerate() {
            let x = 2 * x as i64;
            while self.parabolas.get(k + 1).is_some_and(|next| next.2 <= x) {
                k += 1;
            }
            let lowest = self.parabolas.get(k).map_or(NONE, |&(p, v, _)| (x - p) * (x - p) + v);
            *value = combine(lowest, *value);
        }
    }
}
