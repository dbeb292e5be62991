//! Whether a car fits into a small square with its margin, in any direction.

use std::cell::Cell;

use super::world::World;
use crate::geometry::{Point, Pose, math};
use crate::planners::cost_map::Exact;

/// Boxes of places and directions are divided until none of their poses differs from the middle one by more than
/// this, metres.
const FINEST: f64 = 0.02;
/// Room that is asked for beyond what rounding may hide, metres.
const ROUNDING: f64 = 1e-9;
/// Bodies measured thoroughly before everything counts as possible.
const BUDGET: u32 = 100_000;

/// The question, with what is kept between askings.
pub(super) struct Fit<'a> {
    world: &'a World,
    margin: f64,
    /// Half the body's diagonal, metres.
    lever: f64,
    /// The direction that did last; the scene's ends have the others that are tried first.
    heading: Cell<f64>,
    left: Cell<u32>,
}

impl<'a> Fit<'a> {
    pub(super) fn new(world: &'a World, margin: f64) -> Self {
        let vehicle = &world.geometry.vehicle;
        let lever = math::hypot(vehicle.length(), vehicle.width) / 2.0;
        Self { world, margin, lever, heading: Cell::new(0.0), left: Cell::new(BUDGET) }
    }

    /// False only if the body keeps the margin in no direction within `turn` of `heading` with its middle in the square
    /// of half side `half` around `place`: no point of the body is farther from the middle of a box of poses than the
    /// box is large.
    fn holds(&self, place: Point, half: f64, heading: f64, turn: f64) -> bool {
        self.left.set(self.left.get().saturating_sub(1));
        let room = self.body_room(place, heading, self.margin);
        if room >= self.margin {
            self.heading.set(heading);
            return true;
        }
        let (away, swept) = (half * core::f64::consts::SQRT_2, turn * self.lever);
        if room + away + swept < self.margin {
            return false;
        }
        if away + swept <= FINEST || self.left.get() == 0 {
            return true;
        }
        if swept > away {
            let next = turn / 2.0;
            return self.holds(place, half, heading - next, next)
                || self.holds(place, half, heading + next, next);
        }
        let next = half / 2.0;
        let quarters = [(-next, -next), (next, -next), (-next, next), (next, next)];
        quarters.iter().any(|(x, y)| self.holds(Point::new(place.x + x, place.y + y), next, heading, turn))
    }

    /// Directions that are tried first.
    fn likely(&self) -> [f64; 3] {
        let ends = &self.world.geometry;
        [self.heading.get(), ends.start.heading, ends.goal.heading]
    }

    /// The body's room, at most `most`; 0 where it overlaps anything.
    fn body_room(&self, place: Point, heading: f64, most: f64) -> f64 {
        let middle = Pose::new(place.x, place.y, heading);
        self.world.body.clearance_within(middle.advance(0.0, -self.world.geometry.vehicle.middle()), most)
    }
}

impl Exact for Fit<'_> {
    fn room(&self, place: Point) -> f64 {
        let needed = self.margin + self.world.geometry.vehicle.width / 2.0;
        self.world.body.point_clearance(place, needed + 1.0)
    }

    fn fits_around(&self, place: Point, reach: f64) -> bool {
        // No point of the body moves farther than its middle.
        let needed = self.margin + reach + ROUNDING;
        self.body_room(place, self.heading.get(), needed) >= needed
    }

    fn fits_easily(&self, place: Point, half: f64) -> bool {
        let corners = [(-half, -half), (half, -half), (-half, half), (half, half)];
        self.likely().into_iter().any(|heading| {
            let room = self.body_room(place, heading, self.margin);
            let corner = |by: &(f64, f64)| Point::new(place.x + by.0, place.y + by.1);
            room >= self.margin
                || room + half * core::f64::consts::SQRT_2 >= self.margin
                    && corners
                        .iter()
                        .any(|by| self.body_room(corner(by), heading, self.margin) >= self.margin)
        })
    }

    fn may_fit(&self, place: Point, half: f64) -> bool {
        // The body is the same when it is turned round.
        let quarter = math::FRAC_PI_2;
        self.holds(place, half, quarter, quarter)
    }
}
