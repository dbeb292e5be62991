//! Distances that go on below zero where something is overlapped.
//!
//! Outside obstacles the value is the distance to the nearest edge, inside it is the same with a minus sign. The sign
//! lets a mean or an interpolation tell a slight overlap from a deep one, which a clearance of 0 does not.

use super::Body;
use super::outlines::squared_to_segment;
use crate::geometry::{Point, Pose};

/// Points of the body's outline are at most this far apart where it overlaps something, metres; farther on bodies so
/// large that they would be more than [`POINTS`].
const SPACING: f64 = 0.24;
/// A car has fewer.
const POINTS: f64 = 64.0;

impl Body {
    /// Signed distance from a point to the nearest obstacle or kerb, metres, at most `most`; below zero inside an
    /// obstacle and off the floor.
    pub fn point_clearance(&self, point: Point, most: f64) -> f64 {
        let at = Point::from(point - self.origin);
        let mut reach = self.buckets.side.min(most);
        let distance = loop {
            let margin = nalgebra::Vector2::new(reach, reach);
            let mut best = most;
            for bucket in self.buckets.range(at - margin, at + margin) {
                for &i in &self.buckets.edges[bucket] {
                    let edge = &self.edges[i as usize];
                    if edge.apart_from(at, at) < best * best {
                        best = best.min(squared_to_segment(at, edge.a, edge.b).sqrt());
                    }
                }
            }
            if best <= reach || reach >= most {
                break best;
            }
            reach = (reach * 2.0).min(most);
        };
        let solid =
            |bucket: usize| self.buckets.solids[bucket].iter().any(|&i| self.solids[i as usize].holds(at));
        let blocked = self.buckets.range(at, at).any(solid) || !self.on_floor(at);
        if blocked { -distance } else { distance }
    }

    /// Signed distance from the body's outline to the nearest obstacle or kerb, metres, between `-most` and `most`:
    /// exact where it overlaps nothing, otherwise that of the deepest of points of the outline at most 0.24 m
    /// apart, of a ship's a 64th of it. `most` may be infinite, for every floor has an edge.
    ///
    /// An overlap that no point of the outline shows (a thin obstacle across the body) counts as one nanometre.
    ///
    /// # Examples
    /// ```
    /// use parkade::geometry::Pose;
    /// use parkade::metrics::Body;
    ///
    /// let geometry = parkade::scenario::catalog::scenario("perpendicular").unwrap().geometry().unwrap();
    /// let body = Body::new(&geometry);
    /// assert_eq!(body.signed_clearance(geometry.start, 10.0), body.clearance(geometry.start));
    /// let outside = Pose { x: geometry.start.x - 100.0, ..geometry.start };
    /// assert!(body.signed_clearance(outside, f64::INFINITY) < -80.0);
    /// ```
    pub fn signed_clearance(&self, pose: Pose, most: f64) -> f64 {
        if self.hit(pose).is_none() {
            return self.room(pose, self.buckets.side, most);
        }
        let corners = self.outline(pose, 0.0).map(|p| p + self.origin.coords);
        let around = 2.0 * ((corners[1] - corners[0]).norm() + (corners[2] - corners[1]).norm());
        let spacing = SPACING.max(around / POINTS);
        let mut deepest = -1e-9_f64;
        for (i, &a) in corners.iter().enumerate() {
            let way = corners[(i + 1) % 4] - a;
            let parts = (way.norm() / spacing).ceil().max(1.0);
            for k in 0..parts as u32 {
                deepest = deepest.min(self.point_clearance(a + way * (f64::from(k) / parts), most));
            }
        }
        deepest
    }
}
