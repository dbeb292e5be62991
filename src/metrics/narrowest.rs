//! The narrowest place of a path.
//!
//! The nearest points of two segments that do not cross include an end of one of them. So all pairs of a corner with an
//! edge, both ways around, are enough to find both points exactly.

use super::Body;
use super::footprint_distance::FAR;
use crate::geometry::polygon::nearest_share;
use crate::geometry::{Point, Pose};
use crate::scenario::resolve::Owner;

/// More than rounding takes from a distance, metres.
const ROUNDING: f64 = 1e-6;

/// The narrowest place of a path.
///
/// Both points are in the world frame, metres; their distance is the path's least clearance. The page draws it as a
/// dimension line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Narrowest {
    /// Of the path's poses.
    pub index: usize,
    /// The body's point.
    pub body: Point,
    /// The obstacle's point nearest to it.
    pub obstacle: Point,
    /// Whose point that is.
    pub owner: Owner,
}

impl Body {
    /// The narrowest place of `path` by its `clearances`; `None` if no obstacle is near.
    pub(super) fn narrowest(&self, path: &[Pose], clearances: &[f64]) -> Option<Narrowest> {
        let (index, &room) = clearances.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        if room >= FAR {
            return None;
        }
        let corners = self.outline(path[index], 0.0);
        let reach = nalgebra::Vector2::new(room + ROUNDING, room + ROUNDING);
        let (low, high) =
            corners.iter().fold((corners[0], corners[0]), |(low, high), p| (low.inf(p), high.sup(p)));
        let mut best = (f64::INFINITY, None);
        for &edge in
            self.buckets.range(low - reach, high + reach).flat_map(|bucket| &self.buckets.edges[bucket])
        {
            let edge = &self.edges[edge as usize];
            for (i, &corner) in corners.iter().enumerate() {
                let side = [corner, corners[(i + 1) % 4]];
                for (body, obstacle) in [
                    (corner, closest(corner, [edge.a, edge.b])),
                    (closest(edge.a, side), edge.a),
                    (closest(edge.b, side), edge.b),
                ] {
                    let apart = (body - obstacle).norm_squared();
                    if apart < best.0 {
                        let [body, obstacle] = [body, obstacle].map(|p| p + self.origin.coords);
                        best = (apart, Some(Narrowest { index, body, obstacle, owner: edge.owner }));
                    }
                }
            }
        }
        best.1
    }
}

/// The point of a segment that is closest to `p`.
fn closest(p: Point, [a, b]: [Point; 2]) -> Point {
    a + (b - a) * nearest_share(p, a, b)
}

#[cfg(test)]
mod tests {
    use serde_json::Map;

    use crate::geometry::Point;
    use crate::metrics::Body;
    use crate::plan::{Options, Planner};
    use crate::scenario::catalog;

    #[test]
    fn the_narrowest_place_is_as_far_from_its_obstacle_as_the_path_keeps() {
        for id in ["perpendicular", "parallel", "angled", "P1", "par-8.0"] {
            let scene = catalog::scenario(id).unwrap();
            let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
            let plan = planner.plan(Options::default());
            let place = plan.check.narrowest.unwrap();
            assert!(((place.body - place.obstacle).norm() - plan.metrics.min_clearance).abs() < 1e-6, "{id}");
            assert_eq!(plan.check.clearances[place.index], plan.metrics.min_clearance, "{id}");
            // The body's point is on its outline, the other one on an obstacle.
            let pose = plan.path[place.index];
            let body = Body::new(planner.geometry());
            assert!(body.point_clearance(place.obstacle, 1.0).abs() < 1e-9, "{id}");
            let vehicle = &planner.geometry().vehicle;
            let (along, across) = {
                let (sin, cos) = crate::geometry::math::sin_cos(pose.heading);
                let off = place.body - pose.point();
                (off.x * cos + off.y * sin, off.y * cos - off.x * sin)
            };
            let beyond = (along - vehicle.rear_to_front)
                .max(-vehicle.rear_to_back - along)
                .max(across.abs() - vehicle.width / 2.0);
            assert!(beyond.abs() < 1e-9, "{id}: {beyond}");
        }
    }

    #[test]
    fn a_segment_that_is_a_point_has_that_point() {
        let p = Point::new(1.0, 2.0);
        assert_eq!(super::closest(Point::new(5.0, 5.0), [p, p]), p);
    }
}
