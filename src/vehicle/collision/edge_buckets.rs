//! Edges sorted into square buckets: those near a box are found without a look at the others.
//!
//! Each bucket keeps the boxes around its edges beside each other and in few digits. Most edges of the buckets around a
//! body are far from it, and are passed over without a look at the edges themselves.

use super::edge::{Edge, bounds, point_distance};
use crate::geometry::{Point, Vector};

/// Side of a bucket, metres.
const BUCKET: f64 = 2.0;
/// Buckets along the longer side of the floor, at most.
const MAX_BUCKETS: f64 = 1024.0;
/// Edges that are remembered while others are looked at.
const RECENT: usize = 16;

/// The buckets of one list of edges. Making them is linear in edges and buckets.
#[derive(Debug)]
pub(super) struct EdgeBuckets {
    side: f64,
    /// Buckets per metre.
    per_metre: f64,
    columns: usize,
    rows: usize,
    /// `first[b]..first[b + 1]` are the places in `members` of bucket b's edges.
    first: Vec<u32>,
    members: Vec<Member>,
}

/// An edge in a bucket.
#[derive(Debug, Clone, Copy, Default)]
struct Member {
    /// Left, bottom, −right and −top of the box around the edge. Rounding keeps the order of numbers, so no edge is
    /// lost to fewer digits.
    sides: [f32; 4],
    edge: u32,
}

impl EdgeBuckets {
    /// Sorts edges on a floor of this size into buckets by counting. An edge goes only into buckets that it comes near,
    /// not into all of its box.
    pub(super) fn new(edges: &[Edge], size: Vector) -> Self {
        let side = BUCKET.max(size.x.max(size.y) / MAX_BUCKETS);
        let (columns, rows) = ((size.x / side) as usize + 1, (size.y / side) as usize + 1);
        let (first, members) = (vec![0; columns * rows + 1], Vec::new());
        let mut this = Self { side, per_metre: 1.0 / side, columns, rows, first, members };
        let pairs = this.pairs(edges);
        for &(bucket, _) in &pairs {
            this.first[bucket + 1] += 1;
        }
        for b in 1..this.first.len() {
            this.first[b] += this.first[b - 1];
        }
        let mut next = this.first.clone();
        this.members = vec![Member::default(); pairs.len()];
        for (bucket, member) in pairs {
            let place = &mut next[bucket];
            this.members[*place as usize] = member;
            *place += 1;
        }
        this
    }

    /// Each edge with each bucket that it comes near.
    fn pairs(&self, edges: &[Edge]) -> Vec<(usize, Member)> {
        let mut pairs = Vec::new();
        let half_diagonal = self.side * core::f64::consts::FRAC_1_SQRT_2 * 1.001;
        // Edges off the boundary are kept in the outermost buckets.
        let is_last = |k: usize, n: usize| k == 0 || k + 1 == n;
        for (i, edge) in (0..).zip(edges) {
            let (low, high) = bounds([edge.a, edge.b]);
            for y in self.place(low.y, self.rows)..=self.place(high.y, self.rows) {
                for x in self.place(low.x, self.columns)..=self.place(high.x, self.columns) {
                    let is_outer = is_last(x, self.columns) || is_last(y, self.rows);
                    let [center_x, center_y] = [x, y].map(|k| (k as f64 + 0.5) * self.side);
                    let center = Point::new(center_x, center_y);
                    if is_outer || point_distance(center, edge.a, edge.b) <= half_diagonal {
                        pairs.push((y * self.columns + x, Member::new(i, low, high)));
                    }
                }
            }
        }
        pairs
    }

    /// Bytes held.
    pub(super) fn bytes(&self) -> u64 {
        (size_of_val(&self.first[..]) + size_of_val(&self.members[..])) as u64
    }

    /// The owner of the first edge that satisfies `wanted`, of those whose own box meets a box. `edges` are those from
    /// which the buckets were made. Few of them come twice.
    #[inline(always)]
    pub(super) fn find(
        &self,
        edges: &[Edge],
        low: Point,
        high: Point,
        mut wanted: impl FnMut(&Edge) -> bool,
    ) -> Option<u32> {
        let (left, right) = (self.place(low.x, self.columns), self.place(high.x, self.columns));
        let sides = [high.x as f32, high.y as f32, -low.x as f32, -low.y as f32];
        // Long edges lie in many buckets.
        let mut recent = [u32::MAX; RECENT];
        for y in self.place(low.y, self.rows)..=self.place(high.y, self.rows) {
            // The buckets of a row are neighbours, and so are their members.
            let row = y * self.columns;
            let members = self.first[row + left] as usize..self.first[row + right + 1] as usize;
            for member in &self.members[members] {
                let recent = &mut recent[member.edge as usize % RECENT];
                if !member.may_reach(sides) || *recent == member.edge {
                    continue;
                }
                *recent = member.edge;
                let edge = &edges[member.edge as usize];
                if edge.reaches(low, high) && wanted(edge) {
                    return Some(edge.owner);
                }
            }
        }
        None
    }

    /// The bucket, of `count` beside each other, that holds a coordinate; the outermost ones hold what lies beyond.
    #[inline(always)]
    fn place(&self, coordinate: f64, count: usize) -> usize {
        (coordinate * self.per_metre).clamp(0.0, (count - 1) as f64) as u32 as usize
    }
}

impl Member {
    fn new(edge: u32, low: Point, high: Point) -> Self {
        Self { sides: [low.x as f32, low.y as f32, -high.x as f32, -high.y as f32], edge }
    }

    /// True if the box may have a point in common with another one, of which these are right, top, −left and −bottom.
    #[inline(always)]
    #[expect(
        clippy::needless_bitwise_bool,
        reason = "nobody could foresee which way a branch for each side goes"
    )]
    fn may_reach(&self, other: [f32; 4]) -> bool {
        let [left, bottom, right, top] = self.sides;
        (left <= other[0]) & (bottom <= other[1]) & (right <= other[2]) & (top <= other[3])
    }
}

impl Edge {
    /// True if the boxes around the edge and from `low` to `high` have a point in common.
    #[inline(always)]
    #[expect(
        clippy::needless_bitwise_bool,
        reason = "nobody could foresee which way a branch for each side goes"
    )]
    pub(super) fn reaches(&self, low: Point, high: Point) -> bool {
        let [left, right] = if self.a.x < self.b.x { [self.a.x, self.b.x] } else { [self.b.x, self.a.x] };
        let [bottom, top] = if self.a.y < self.b.y { [self.a.y, self.b.y] } else { [self.b.y, self.a.y] };
        (right >= low.x) & (left <= high.x) & (top >= low.y) & (bottom <= high.y)
    }
}
