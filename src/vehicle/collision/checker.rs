//! Questions of one car to the obstacles: is a pose free, how far along an arc is it free, how much room is there.
//!
//! A pose passes two cheap tests before the exact one. Discs that cover the body are looked up in the distance
//! field; where all have room the pose is free. Otherwise the edges in the buckets around the body are tested by
//! separating axes. Tests are counted: besides expansions they are the planners' measure of work.
//!
//! The margin: where a question has one, the body is grown by it on every side to a larger rectangle. A corner of
//! that rectangle is √2 times the margin away from the body's corner, so the answer is on the safe side.
//! [`CollisionChecker::clearance`] measures the true distance instead.

use std::cell::Cell as Counter;

use super::Corridor;
use super::Obstacles;
use super::edge::{Edge, point_square};
use crate::IS_COMPLETE;
use crate::geometry::arcs::Arc;
use crate::geometry::{Point, Pose, Vector, math};
use crate::map::WeightMap;
use crate::vehicle::Vehicle;

/// Overlaps shallower than this are contact, which is free, metres.
pub(super) const CONTACT: f64 = 1e-6;
/// How far around the body edges are looked for to know how far it can go on, metres.
const LOOK: f64 = 0.25;

/// A place of the body: the rear axle's middle and the heading's sine and cosine.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placement {
    x: f64,
    y: f64,
    pub(super) sin: f64,
    pub(super) cos: f64,
}

impl Placement {
    pub(super) fn of(pose: Pose) -> Self {
        let (sin, cos) = math::sin_cos(pose.heading);
        Self { x: pose.x, y: pose.y, sin, cos }
    }

    /// The place after an arc of signed `length`, at whose end the heading has this sine and cosine.
    #[inline(always)]
    pub(super) fn along(self, curvature: f64, length: f64, sin: f64, cos: f64) -> Self {
        let (x, y) = if curvature == 0.0 {
            (self.x + length * self.cos, self.y + length * self.sin)
        } else {
            (self.x + (sin - self.sin) / curvature, self.y - (cos - self.cos) / curvature)
        };
        Self { x, y, sin, cos }
    }

    /// The place after an arc of signed `length` from here, where the heading is `heading`; to the bit that of
    /// [`Pose::advance`].
    pub(super) fn after(self, heading: f64, curvature: f64, length: f64) -> Self {
        if curvature == 0.0 {
            return self.along(curvature, length, self.sin, self.cos);
        }
        let heading = heading + curvature * length;
        let (sin, cos) = math::sin_cos(heading);
        let place = self.along(curvature, length, sin, cos);
        let wrapped = math::wrap(heading);
        let (sin, cos) = if wrapped == heading { (sin, cos) } else { math::sin_cos(wrapped) };
        Self { sin, cos, ..place }
    }

    /// The place so many metres to the east and to the north.
    #[cfg(test)]
    pub(super) fn moved(self, x: f64, y: f64) -> Self {
        Self { x: self.x + x, y: self.y + y, ..self }
    }

    pub(super) fn local(self, p: Point) -> Point {
        let (dx, dy) = (p.x - self.x, p.y - self.y);
        Point::new(dx * self.cos + dy * self.sin, dy * self.cos - dx * self.sin)
    }

    /// A vector of the body's frame in the world's.
    pub(super) fn turn(self, v: Vector) -> Vector {
        Vector::new(v.x * self.cos - v.y * self.sin, v.x * self.sin + v.y * self.cos)
    }
}

/// Collision queries of one car, counted. All poses are local to the obstacles.
#[derive(Debug, Clone)]
pub struct CollisionChecker<'a> {
    obstacles: &'a Obstacles,
    vehicle: Vehicle,
    /// Centres of the discs that cover the body, along its axis, metres ahead of the rear axle.
    discs: Vec<f64>,
    /// Half the length that one disc covers.
    half_part: f64,
    slack: f64,
    /// The corridor that arcs may not leave.
    corridor: Option<&'a Corridor>,
    checks: Counter<u32>,
    /// The edge that was met last.
    met: Counter<Option<Edge>>,
}

impl<'a> CollisionChecker<'a> {
    /// Weights of the floor in local coordinates; `None` if all cells cost the same.
    pub fn paint(&self) -> Option<&'a WeightMap> {
        self.obstacles.paint()
    }

    /// Queries of `vehicle` among `obstacles`.
    pub fn new(obstacles: &'a Obstacles, vehicle: &Vehicle) -> Self {
        let length = vehicle.length();
        let count = (length / vehicle.width).ceil().clamp(1.0, 8.0);
        let part = length / count;
        let discs = (0..count as u32).map(|i| (f64::from(i) + 0.5) * part - vehicle.rear_to_back).collect();
        // A point may be half a diagonal away from its cell's centre.
        let slack = obstacles.frame().resolution * core::f64::consts::FRAC_1_SQRT_2 + 1e-5;
        Self {
            obstacles,
            vehicle: *vehicle,
            discs,
            half_part: part / 2.0,
            slack,
            corridor: None,
            checks: Counter::new(0),
            met: Counter::new(None),
        }
    }

    /// The same queries, but arcs are free only within a corridor.
    #[must_use]
    pub fn within(&self, corridor: &'a Corridor) -> Self {
        Self { corridor: Some(corridor), ..self.clone() }
    }

    /// Poses asked about so far; stays at the largest number.
    pub fn checks(&self) -> u32 {
        self.checks.get()
    }

    pub(super) fn count(&self, checks: u32) {
        self.checks.set(self.checks.get().saturating_add(checks));
    }

    /// The obstacle that the body, grown by `margin` metres on every side, overlaps; `None` if it is free.
    pub fn hit(&self, pose: Pose, margin: f64) -> Option<u32> {
        self.count(1);
        let place = Placement::of(pose);
        // Which of several obstacles is told may not depend on what was asked before.
        self.met.set(None);
        if self.has_room(place, margin) { None } else { self.exact(place, margin - CONTACT) }
    }

    /// True if the body, grown by `margin` metres on every side or shrunk where that is negative, meets nothing with
    /// its rear axle at `at` and a heading of this sine and cosine.
    pub fn fits(&self, at: Point, (sin, cos): (f64, f64), margin: f64) -> bool {
        self.count(1);
        let place = Placement { x: at.x, y: at.y, sin, cos };
        self.has_room(place, margin.max(0.0)) || self.exact(place, margin - CONTACT).is_none()
    }

    /// True if an arc stays within the corridor, if there is one.
    pub(super) fn corridor_holds(&self, from: Pose, arc: &Arc) -> bool {
        !IS_COMPLETE || self.corridor.is_none_or(|corridor| corridor.holds_arc(from, arc))
    }

    /// True if nothing is near the body with `margin` around it.
    /// A cheap test that errs on one side: true is certain, false means that something may be near. Not counted.
    pub fn clear_by(&self, pose: Pose, margin: f64) -> bool {
        self.has_room(Placement::of(pose), margin)
    }

    /// How far a disc's centre moves per metre of an arc, at most.
    pub(super) fn max_disc_speed(&self, curvature: f64) -> f64 {
        let farthest = self.discs.iter().fold(0.0_f64, |far, d| far.max(d.abs()));
        let swing = curvature * farthest;
        (1.0 + swing * swing).sqrt()
    }

    /// How far a point of the body with `margin` around it moves per metre of an arc, at most.
    pub(super) fn max_body_speed(&self, curvature: f64, margin: f64) -> f64 {
        let [front, back, side, _] = self.sides(margin);
        let (along, across) = (1.0 + curvature.abs() * side, curvature * front.max(-back));
        (along * along + across * across).sqrt()
    }

    /// Radius of a disc that covers its part of the grown body.
    pub(super) fn disc_radius(&self, margin: f64) -> f64 {
        let (along, across) = (self.half_part + margin, self.vehicle.width / 2.0 + margin);
        (along * along + across * across).sqrt()
    }

    /// True if the discs that cover the body with `margin` around it are certain to meet nothing.
    #[inline(never)]
    fn has_room(&self, at: Placement, margin: f64) -> bool {
        self.spare(at, self.disc_radius(margin)) > 0.0
    }

    /// How much farther than `radius` all edges are from the discs' centres at least; 0 where that is not certain.
    #[inline(always)]
    pub(super) fn spare(&self, at: Placement, radius: f64) -> f64 {
        let mut least = f64::INFINITY;
        for d in &self.discs {
            let field = self.obstacles.field_at(at.x + d * at.cos, at.y + d * at.sin);
            let spare = field - self.slack - radius;
            if spare <= 0.0 {
                return 0.0;
            }
            least = least.min(spare);
        }
        least
    }

    /// The answer of [`CollisionChecker::hit`] as a truth value, for a place whose sine and cosine are known; not
    /// counted.
    pub(super) fn is_free_at(&self, at: Placement, margin: f64) -> bool {
        self.has_room(at, margin) || self.exact(at, margin - CONTACT).is_none()
    }

    /// The owner of an edge that the body with `margin` around it meets, by the edges themselves: of the one that was
    /// met last, if it is met again. It often is, as poses are asked about one beside another.
    pub(super) fn exact(&self, at: Placement, margin: f64) -> Option<u32> {
        let sides = self.sides(margin);
        let (low, high) = self.bounds(at, margin);
        let is_met = |edge: &Edge| segment_meets_box(at.local(edge.a), at.local(edge.b), sides);
        if IS_COMPLETE
            && let Some(edge) = self.met.get()
            && edge.reaches(low, high)
            && is_met(&edge)
        {
            return Some(edge.owner);
        }
        self.obstacles.find(low, high, |edge| {
            let is_met = is_met(edge);
            if is_met {
                self.met.set(Some(*edge));
            }
            is_met
        })
    }

    /// A lower bound on the distance from the body with `margin` around it to the nearest edge, metres; nothing where
    /// [`CollisionChecker::exact`] finds one that it meets.
    pub(super) fn gap(&self, at: Placement, margin: f64) -> Option<f64> {
        let sides = self.sides(margin);
        let (low, high) = self.bounds(at, margin + LOOK);
        let mut gap = LOOK;
        let met = self.obstacles.find(low, high, |edge| {
            let (a, b) = (at.local(edge.a), at.local(edge.b));
            let beside = gap_beside(a, b, sides);
            let apart = if beside > 0.0 { beside } else { gap_from_line(a, b, sides) };
            gap = if apart < gap { apart } else { gap };
            apart <= 0.0
        });
        // More than rounding adds.
        if met.is_none() { Some(gap - CONTACT) } else { None }
    }

    /// Distance from the body to the nearest edge, metres, at most `limit`; 0 where it overlaps.
    pub fn clearance(&self, pose: Pose, limit: f64) -> f64 {
        let at = Placement::of(pose);
        if self.has_room(at, limit) {
            return limit;
        }
        self.count(1);
        if self.exact(at, -CONTACT).is_some() {
            return 0.0;
        }
        let sides = self.sides(0.0);
        let (low, high) = self.bounds(at, limit);
        let mut square = f64::INFINITY;
        self.edges_near((low, high), |edge| {
            let (a, b) = (at.local(edge.a), at.local(edge.b));
            // Less than the distance, whatever rounding adds.
            let beside = gap_beside(a, b, sides) - CONTACT;
            if !IS_COMPLETE || beside <= 0.0 || beside * beside < square {
                square = square.min(square_distance(a, b, sides));
            }
        });
        // Contact leaves rounding errors, which are no room.
        let best = square.sqrt().min(limit);
        if best <= CONTACT { 0.0 } else { best }
    }

    /// Calls `see` with all edges that come near a box along the axes.
    pub(super) fn edges_near(&self, (low, high): (Point, Point), mut see: impl FnMut(&Edge)) {
        self.obstacles.find(low, high, |edge| {
            see(edge);
            false
        });
    }

    /// Front, back, left and right of the grown body in its own frame.
    pub(super) fn sides(&self, margin: f64) -> [f64; 4] {
        let v = &self.vehicle;
        let side = v.width / 2.0 + margin;
        [v.rear_to_front + margin, -v.rear_to_back - margin, side, -side]
    }

    /// The box along the axes around the grown body.
    pub(super) fn bounds(&self, at: Placement, margin: f64) -> (Point, Point) {
        let v = &self.vehicle;
        let (half, side) = (v.length() / 2.0 + margin, v.width / 2.0 + margin);
        let ahead = (v.rear_to_front - v.rear_to_back) / 2.0;
        let (x, y) = (at.x + ahead * at.cos, at.y + ahead * at.sin);
        let dx = half * at.cos.abs() + side * at.sin.abs();
        let dy = half * at.sin.abs() + side * at.cos.abs();
        (Point::new(x - dx, y - dy), Point::new(x + dx, y + dy))
    }
}

/// Separating axes of a segment and an upright box: the box's two, then the segment's normal.
fn segment_meets_box(a: Point, b: Point, sides: [f64; 4]) -> bool {
    gap_beside(a, b, sides) <= 0.0 && !is_beside_line(corners_beside(a, b, sides))
}

/// How far a segment is beside an upright box, along the box's axes; not above 0 where it is beside none of its sides.
#[inline(always)]
pub(super) fn gap_beside(a: Point, b: Point, [front, back, left, right]: [f64; 4]) -> f64 {
    let sorted = |a: f64, b: f64| if a < b { (a, b) } else { (b, a) };
    let larger = |a: f64, b: f64| if a < b { b } else { a };
    let ((near, far), (low, high)) = (sorted(a.x, b.x), sorted(a.y, b.y));
    larger(larger(near - front, back - far), larger(low - left, right - high))
}

/// How far an upright box is from the line through a segment; 0 where the line meets it.
#[inline(always)]
fn gap_from_line(a: Point, b: Point, sides: [f64; 4]) -> f64 {
    let corners = corners_beside(a, b, sides);
    if !is_beside_line(corners) {
        return 0.0;
    }
    corners.iter().fold(f64::INFINITY, |least, s| least.min(s.abs())) / (b - a).norm_squared().sqrt()
}

/// How far the corners of an upright box are to the left of the line through a segment, times the segment's length.
#[inline(always)]
fn corners_beside(a: Point, b: Point, [front, back, left, right]: [f64; 4]) -> [f64; 4] {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let side = |x: f64, y: f64| dx * (y - a.y) - dy * (x - a.x);
    [side(front, left), side(back, left), side(back, right), side(front, right)]
}

/// True if all corners lie on one side of a line.
#[inline(always)]
fn is_beside_line(corners: [f64; 4]) -> bool {
    corners.iter().all(|&s| s > 0.0) || corners.iter().all(|&s| s < 0.0)
}

/// Distance of a segment from an upright box that it does not cross, squared.
fn square_distance(a: Point, b: Point, [front, back, left, right]: [f64; 4]) -> f64 {
    let mut least = f64::INFINITY;
    for end in [a, b] {
        let nearest = Point::new(end.x.max(back).min(front), end.y.max(right).min(left));
        least = least.min((end - nearest).norm_squared());
    }
    for (x, y) in [(front, left), (back, left), (back, right), (front, right)] {
        least = least.min(point_square(Point::new(x, y), a, b));
    }
    least
}

#[cfg(test)]
mod tests;
