//! Slots, their corners, and the poses of a car parked in it.
//!
//! A slot is told by the middle of its mouth, on the aisle's side, and the heading that leads straight into it from
//! there. In that frame, x inwards and y to the left:
//!
//! ```text
//! perpendicular   width across the mouth, length inwards
//! parallel        length along the aisle, width inwards
//! angled          the axis leans by π/2 − angle; the mouth is width / cos of that lean
//! ```

use serde::Serialize;

use crate::geometry::math::{self, FRAC_PI_2, FRAC_PI_4, PI};
use crate::geometry::{Point, Pose, Vector};
use crate::vehicle::Vehicle;

/// A parking slot. `(x, y)` is the middle of its open side, `heading` points from the aisle into the slot, at right
/// angles to the aisle.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Slot {
    /// Name for messages, selection and [`super::Goal::Slot`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// How the car stands to the aisle.
    pub kind: SlotKind,
    /// Middle of the open side, metres.
    pub x: f64,
    /// Middle of the open side, metres.
    pub y: f64,
    /// Radians, from the aisle into the slot.
    pub heading: f64,
    /// Clear width for the car: across the car's axis, for `parallel` too (its depth from the aisle). Metres.
    pub width: f64,
    /// Clear length for the car along its axis, metres.
    pub length: f64,
    /// `angled` only: the angle between the aisle and the car's axis, radians, in (0, π/2); default π/4.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// `angled` only: to which side of `heading` the car's axis leans.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lean: Option<Lean>,
    /// True if a parked `sedan` stands in it, centred, nose to the aisle.
    pub occupied: bool,
}

/// How a car in a slot stands to the aisle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SlotKind {
    /// At right angles.
    Perpendicular,
    /// Along it.
    Parallel,
    /// At another angle.
    Angled,
}

/// A side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Lean {
    /// To the left of the slot's heading.
    Left,
    /// To the right of the slot's heading.
    Right,
}

/// A slot of the scene and how to stand in it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct SlotGoal {
    /// The slot's id.
    pub slot: String,
    /// Which way the nose points.
    pub entry: Entry,
}

/// Which way the nose points in a slot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Entry {
    /// Nose to the aisle; in a parallel slot, with the slot on the car's right.
    ReverseIn,
    /// Nose away from the aisle; in a parallel slot, with the slot on the car's left.
    HeadIn,
}

impl Slot {
    /// The heading of the car's axis, pointing into the slot; along the aisle for a parallel slot.
    fn axis(&self) -> f64 {
        match self.kind {
            SlotKind::Perpendicular => self.heading,
            SlotKind::Parallel => math::wrap(self.heading + FRAC_PI_2),
            SlotKind::Angled => {
                let lean = FRAC_PI_2 - self.angle.unwrap_or(FRAC_PI_4);
                let sign = if self.lean == Some(Lean::Right) { -1.0 } else { 1.0 };
                math::wrap(self.heading + sign * lean)
            }
        }
    }

    /// The four corners, metres: near left, near right, far right, far left, seen from the aisle. Counter-clockwise,
    /// and a parallelogram where the slot is angled.
    pub fn outline(&self) -> [Point; 4] {
        let inward = Pose::new(self.x, self.y, self.heading).direction();
        let left = Vector::new(-inward.y, inward.x);
        let mouth = Point::new(self.x, self.y);
        let (opening, side) = match self.kind {
            SlotKind::Perpendicular => (self.width, inward * self.length),
            SlotKind::Parallel => (self.length, inward * self.width),
            SlotKind::Angled => {
                let axis = Pose::new(0.0, 0.0, self.axis()).direction();
                (self.width / axis.dot(&inward), axis * self.length)
            }
        };
        let half = left * (opening / 2.0);
        [mouth + half, mouth - half, mouth - half + side, mouth + half + side]
    }

    /// How far `vehicle`, centred in the slot, sticks out of it at either end or side: metres along the lines or across
    /// them, the larger. The ends of an angled slot run askew to the body, which therefore needs longer lines.
    pub fn overhang(&self, vehicle: &Vehicle) -> f64 {
        let skew = match self.kind {
            SlotKind::Angled => vehicle.width / math::tan(self.angle.unwrap_or(FRAC_PI_4)),
            SlotKind::Perpendicular | SlotKind::Parallel => 0.0,
        };
        let excess = |body: f64, room: f64| ((body - room) / 2.0).max(0.0);
        excess(vehicle.length() + skew, self.length).max(excess(vehicle.width, self.width))
    }

    /// The pose of `vehicle` centred in the slot.
    /// The body's middle is the slot's middle; the pose is the rear axle's, so it depends on the vehicle and on the
    /// entry. Whether the body fits is not asked.
    ///
    /// ```
    /// use std::f64::consts::FRAC_PI_2;
    ///
    /// use parkade::scenario::{Entry, Slot, SlotKind};
    /// use parkade::vehicle::Vehicle;
    ///
    /// // A slot south of its aisle: the mouth at y = 5, the far end at y = 0.
    /// let slot = Slot {
    ///     id: None,
    ///     kind: SlotKind::Perpendicular,
    ///     x: 0.0,
    ///     y: 5.0,
    ///     heading: -FRAC_PI_2,
    ///     width: 2.8,
    ///     length: 5.0,
    ///     angle: None,
    ///     lean: None,
    ///     occupied: false,
    /// };
    /// // The body's middle is at y = 2.5, the rear axle 1.4 m behind it.
    /// let nose_in = slot.pose(Entry::HeadIn, &Vehicle::SEDAN);
    /// assert!((nose_in.y - 3.9).abs() < 1e-9);
    /// let nose_out = slot.pose(Entry::ReverseIn, &Vehicle::SEDAN);
    /// assert!((nose_out.y - 1.1).abs() < 1e-9);
    /// ```
    #[inline(never)]
    pub fn pose(&self, entry: Entry, vehicle: &Vehicle) -> Pose {
        let [a, _, c, _] = self.outline();
        let center = nalgebra::center(&a, &c);
        let nose_in = entry == Entry::HeadIn;
        let heading = match self.kind {
            SlotKind::Parallel if nose_in => math::wrap(self.axis() + PI),
            SlotKind::Parallel => self.axis(),
            _ if nose_in => self.axis(),
            _ => math::wrap(self.axis() + PI),
        };
        let ahead = (vehicle.rear_to_front - vehicle.rear_to_back) / 2.0;
        let at = center - Pose::new(0.0, 0.0, heading).direction() * ahead;
        Pose::new(at.x, at.y, heading)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slot(kind: SlotKind) -> Slot {
        Slot {
            id: None,
            kind,
            x: 10.0,
            y: 5.0,
            heading: -FRAC_PI_2,
            width: 2.5,
            length: 5.0,
            angle: None,
            lean: None,
            occupied: false,
        }
    }

    #[test]
    fn a_perpendicular_slot_south_of_the_aisle() {
        let [near_left, near_right, far_right, _] = slot(SlotKind::Perpendicular).outline();
        assert!((near_left - Point::new(11.25, 5.0)).norm() < 1e-12);
        assert!((near_right - Point::new(8.75, 5.0)).norm() < 1e-12);
        assert!((far_right - Point::new(8.75, 0.0)).norm() < 1e-12);
        let pose = slot(SlotKind::Perpendicular).pose(Entry::ReverseIn, &Vehicle::PAPER);
        assert!((pose.heading - FRAC_PI_2).abs() < 1e-12);
        assert!((pose.y - (2.5 - 1.75)).abs() < 1e-12);
    }

    /// Against the corners of the body: none is in front of the mouth where nothing sticks out, and one is on it where
    /// the lines are just long enough.
    #[test]
    fn what_sticks_out_of_an_angled_slot_is_measured_along_its_lines() {
        let car = Vehicle::SEDAN;
        let ahead = |slot: &Slot| {
            let corners = car.outline(slot.pose(Entry::HeadIn, &car));
            corners.into_iter().map(|corner| corner.y - slot.y).fold(f64::NEG_INFINITY, f64::max)
        };
        let long_enough = car.length() + car.width / math::tan(1.0);
        for (length, overhang) in [(long_enough, 0.0), (long_enough + 0.4, 0.0), (long_enough - 0.4, 0.2)] {
            let slot = Slot { length, angle: Some(1.0), ..slot(SlotKind::Angled) };
            assert!((slot.overhang(&car) - overhang).abs() < 1e-12, "{length}");
            let sine = math::sin_cos(1.0).0;
            assert!((ahead(&slot) - (long_enough - length) / 2.0 * sine).abs() < 1e-9, "{length}");
        }
        assert!(
            (slot(SlotKind::Perpendicular).overhang(&car) - (car.length() - 5.0).max(0.0) / 2.0).abs()
                < 1e-12
        );
    }

    #[test]
    fn reversing_into_a_parallel_slot_keeps_it_on_the_right() {
        let pose = slot(SlotKind::Parallel).pose(Entry::ReverseIn, &Vehicle::PAPER);
        assert!(pose.heading.abs() < 1e-12);
        assert!((pose.point() - Point::new(10.0 - 1.75, 3.75)).norm() < 1e-12);
    }

    #[test]
    fn an_angled_slot_keeps_its_clear_width() {
        let [near_left, near_right, far_right, _] = slot(SlotKind::Angled).outline();
        let side = (far_right - near_right).normalize();
        let across = near_left - near_right;
        assert!(((across - side * across.dot(&side)).norm() - 2.5).abs() < 1e-12);
    }
}
