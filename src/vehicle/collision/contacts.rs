//! Where the body comes near obstacles, and in which direction it would move away from them.

use super::CollisionChecker;
use super::checker::{CONTACT, Placement, gap_beside};
use crate::geometry::polygon::nearest_share;
use crate::geometry::{Point, Pose, Vector};

/// A point of the body and the point of an obstacle that it is near.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contact {
    /// From one to the other, metres.
    pub(crate) distance: f64,
    /// The body's, in local coordinates.
    pub(crate) point: Point,
    /// Unit vector from the obstacle's point to the body's.
    pub(crate) away: Vector,
}

impl CollisionChecker<'_> {
    /// All contacts nearer than `limit` metres of a body that overlaps nothing, in place of those in `found`: of each
    /// corner with each edge, and of the body with each end of an edge.
    pub(crate) fn contacts(&self, pose: Pose, limit: f64, found: &mut Vec<Contact>) {
        found.clear();
        let at = Placement::of(pose);
        let sides @ [front, back, left, right] = self.sides(0.0);
        let corners = [(front, left), (back, left), (back, right), (front, right)];
        let (low, high) = self.bounds(at, limit);
        let mut note = |body: Point, obstacle: Point| {
            let distance = (body - obstacle).norm_squared().sqrt();
            if 0.0 < distance && distance < limit {
                let away = at.turn((body - obstacle) / distance);
                found.push(Contact { distance, point: pose.point() + at.turn(body.coords), away });
            }
        };
        self.edges_near((low, high), |edge| {
            let (a, b) = (at.local(edge.a), at.local(edge.b));
            // Nothing of it is nearer, whatever rounding adds.
            if gap_beside(a, b, sides) - CONTACT > limit {
                return;
            }
            for corner in corners.map(|(x, y)| Point::new(x, y)) {
                note(corner, a + (b - a) * nearest_share(corner, a, b));
            }
            for end in [a, b] {
                note(Point::new(end.x.clamp(back, front), end.y.clamp(right, left)), end);
            }
        });
    }
}
