//! Whether a car fits into a small square with its margin, in any direction.

use std::cell::Cell;

use super::world::World;
use crate::geometry::{Point, Pose, math};

/// Boxes of places and directions are divided until none of their poses differs from the middle one by more than
/// this, metres.
const FINEST: f64 = 0.02;
/// Bodies measured before everything counts as possible.
const BUDGET: u32 = 100_000;

/// The question, with what is kept between askings.
pub(super) struct Fit<'a> {
    world: &'a World,
    margin: f64,
    /// Half the body's diagonal, metres.
    lever: f64,
    /// The direction that did last.
    heading: Cell<f64>,
    left: Cell<u32>,
}

impl<'a> Fit<'a> {
    pub(super) fn new(world: &'a World, margin: f64) -> Self {
        let vehicle = &world.geometry.vehicle;
        let lever = math::hypot(vehicle.length(), vehicle.width) / 2.0;
        Self { world, margin, lever, heading: Cell::new(0.0), left: Cell::new(BUDGET) }
    }

    /// False only if the body keeps the margin nowhere with its middle in the square of half side `half` around
    /// `place`: no point of the body is farther from the middle of a box of poses than the box is large.
    pub(super) fn may_be_in(&self, place: Point, half: f64) -> bool {
        // The body is the same when it is turned round.
        let quarter = math::FRAC_PI_2;
        self.room(place, self.heading.get()) >= self.margin || self.holds(place, half, quarter, quarter)
    }

    fn holds(&self, place: Point, half: f64, heading: f64, turn: f64) -> bool {
        let room = self.room(place, heading);
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

    fn room(&self, place: Point, heading: f64) -> f64 {
        self.left.set(self.left.get().saturating_sub(1));
        let middle = Pose::new(place.x, place.y, heading);
        self.world.body.clearance(middle.advance(0.0, -self.world.geometry.vehicle.middle()))
    }
}
