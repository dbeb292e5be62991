//! The formulas of all words, from two pairs of turning circles.
//!
//! Frame and units: the start is the origin with heading 0, the target is (x, y, φ), lengths are divided by the radius.
//! A car on its left circle turns about (0, 1), on its right one about (0, −1).
//!
//! Reeds and Shepp's formulas see the target through two vectors: A, from the left circle at the start to the left one
//! at the end, and B, from the left one to the right one:
//!
//! ```text
//! A = (x − sin φ, y − 1 + cos φ)        B = (x + sin φ, y − 1 − cos φ)
//! ```
//!
//! Time flip mirrors both across the y axis, and seen backwards A is only turned by φ, and B is the reflected B turned
//! by φ. So four lengths and four angles serve all 48 words.
//!
//! The straight part of a word follows from |A| or |B| alone. A word whose straight part is no shorter than the
//! caller's bound is skipped before its arctangents are taken.

use core::cell::OnceCell;

use super::word::{self, EPS, Shape, Word};
use crate::geometry::Pose;
use crate::geometry::math::{self, FRAC_PI_2, PI, TAU};

/// A little below 1: what a bound that is computed in another way may lose to rounding.
const LESS: f64 = 1.0 - 1e-9;

/// Takes words as they are found.
pub(super) trait Visit {
    /// Words that are surely not shorter than this many radii need not be solved.
    fn bound(&self) -> f64;
    /// Takes a word: its arcs in radii, under time flip and reflection if told so.
    fn take(&mut self, shape: Shape, flip: bool, reflect: bool, lengths: [f64; 5]);
}

/// Every word.
pub(super) struct All<F> {
    pub(super) bound: f64,
    pub(super) each: F,
}

impl<F: FnMut(Word)> Visit for All<F> {
    fn bound(&self) -> f64 {
        self.bound
    }

    fn take(&mut self, shape: Shape, flip: bool, reflect: bool, lengths: [f64; 5]) {
        let total = word::total(lengths);
        if total < self.bound {
            (self.each)(Word::new(shape, flip, reflect, lengths, total));
        }
    }
}

/// The least length; once it is at most `enough`, the rest is not looked at.
pub(super) struct Least {
    pub(super) best: f64,
    pub(super) enough: f64,
}

impl Visit for Least {
    fn bound(&self) -> f64 {
        if self.best <= self.enough { 0.0 } else { self.best }
    }

    fn take(&mut self, _: Shape, _: bool, _: bool, lengths: [f64; 5]) {
        self.best = self.best.min(word::total(lengths));
    }
}

/// The target in the frame of one turning direction: left as it is, right by reflection.
struct Side {
    reflect: bool,
    phi: f64,
    a: Polar,
    b: Polar,
}

/// A vector by its length and, once somebody asks, its angle.
struct Polar {
    vector: [f64; 2],
    length: f64,
    angle: OnceCell<f64>,
}

impl Polar {
    fn new(vector @ [x, y]: [f64; 2]) -> Self {
        Self { vector, length: (x * x + y * y).sqrt(), angle: OnceCell::new() }
    }

    #[inline(never)]
    fn angle(&self) -> f64 {
        *self.angle.get_or_init(|| math::atan2(self.vector[1], self.vector[0]))
    }
}

/// Solves all words from `from` to `to`.
pub(super) fn visit(from: Pose, to: Pose, radius: f64, visitor: &mut impl Visit) {
    let sides = sides(from, to, radius);
    for side in &sides {
        side.straight(visitor);
    }
    for side in &sides {
        side.same_turn(visitor);
        side.other_turn(visitor);
    }
}

/// Solves the words without a cusp: of the families only CSC has none.
pub(super) fn visit_in_one_gear(from: Pose, to: Pose, radius: f64, visitor: &mut impl Visit) {
    for side in &sides(from, to, radius) {
        side.straight(visitor);
    }
}

/// The target as a car sees it that turns to the left first, and one that turns to the right.
fn sides(from: Pose, to: Pose, radius: f64) -> [Side; 2] {
    let local = from.to_local(to.point());
    let (x, y) = (local.x / radius, local.y / radius);
    let phi = math::turn(from.heading, to.heading);
    let (sin, cos) = math::sin_cos(phi);
    let side = |reflect: bool| {
        let (y, sin, phi) = if reflect { (-y, -sin, -phi) } else { (y, sin, phi) };
        let (a, b) = (Polar::new([x - sin, y - 1.0 + cos]), Polar::new([x + sin, y - 1.0 - cos]));
        Side { reflect, phi, a, b }
    };
    [side(false), side(true)]
}

impl Side {
    /// Both time directions: (flip, angle, φ).
    fn ways(&self, angle: f64) -> [(bool, f64, f64); 2] {
        [(false, angle, self.phi), (true, PI - angle, -self.phi)]
    }

    /// CSC: LSL along the outer tangent of two circles (u = |A|), LSR along the inner one (u² = |B|² − 4). Circles that
    /// overlap have no inner tangent.
    fn straight(&self, to: &mut impl Visit) {
        let (a, b) = (self.a.length, self.b.length);
        // The arcs turn the car by φ at least.
        let turn = self.phi.abs() - EPS;
        if a.max(a + turn) < to.bound() {
            for (flip, angle, phi) in self.ways(self.a.angle()) {
                let (t, v) = (modulo(angle), modulo(phi - angle));
                if t >= -EPS && v >= -EPS {
                    to.take(Shape::Lsl, flip, self.reflect, [t, a, v, 0.0, 0.0]);
                }
            }
        }
        let square = b * b - 4.0;
        if square < 0.0 {
            return;
        }
        let u = square.sqrt();
        if u.max(u + turn) < to.bound() {
            let lead = math::atan2(2.0, u);
            for (flip, angle, phi) in self.ways(self.b.angle()) {
                let t = modulo(angle + lead);
                let v = modulo(t - phi);
                if t >= -EPS && v >= -EPS {
                    to.take(Shape::Lsr, flip, self.reflect, [t, u, v, 0.0, 0.0]);
                }
            }
        }
    }

    /// Words that start and end on the same side: LRL and LRSL, both ways round.
    ///
    /// LRL needs a third circle that touches both, so |A| ≤ 4; LRSL turns back a quarter circle before its straight
    /// line, which needs |A| ≥ 2.
    fn same_turn(&self, to: &mut impl Visit) {
        let a = self.a.length;
        // An arcsine is not less than its sine.
        if a <= 4.0 && a / 2.0 * LESS < to.bound() {
            let u = -2.0 * math::asin(a / 4.0);
            // None is shorter than its middle arc.
            let ways = if -u < to.bound() { &self.ways(self.a.angle())[..] } else { &[] };
            for &(flip, angle, phi) in ways {
                for (backwards, angle) in [(false, angle), (true, phi - angle)] {
                    let t = modulo(angle + u / 2.0 + PI);
                    let v = modulo(phi - t + u);
                    if t >= -EPS {
                        let lengths = if backwards { [v, u, t, 0.0, 0.0] } else { [t, u, v, 0.0, 0.0] };
                        to.take(Shape::Lrl, flip, self.reflect, lengths);
                    }
                }
            }
        }
        if a < 2.0 {
            return;
        }
        let straight = (a * a - 4.0).sqrt();
        let u = 2.0 - straight;
        if u > EPS || FRAC_PI_2 - u >= to.bound() {
            return;
        }
        let lead = math::atan2(straight, -2.0);
        for (flip, angle, phi) in self.ways(self.a.angle()) {
            for (backwards, angle) in [(false, angle), (true, phi - angle)] {
                let t = modulo(angle + lead);
                let v = modulo(phi - FRAC_PI_2 - t);
                if t >= -EPS && v <= EPS {
                    if backwards {
                        to.take(Shape::Lsrl, flip, self.reflect, [v, u, -FRAC_PI_2, t, 0.0]);
                    } else {
                        to.take(Shape::Lrsl, flip, self.reflect, [t, -FRAC_PI_2, u, v, 0.0]);
                    }
                }
            }
        }
    }

    /// Words that start and end on different sides: LRLR, LRSR both ways round, LRSLR.
    fn other_turn(&self, to: &mut impl Visit) {
        let b = self.b.length;
        self.four_circles(to);
        if b < 2.0 {
            return;
        }
        let u = 2.0 - b;
        if FRAC_PI_2 - u < to.bound() {
            for (flip, angle, phi) in self.ways(self.b.angle()) {
                let t = modulo(angle + FRAC_PI_2);
                let v = modulo(t + FRAC_PI_2 - phi);
                if t >= -EPS && v <= EPS {
                    to.take(Shape::Lrsr, flip, self.reflect, [t, -FRAC_PI_2, u, v, 0.0]);
                }
                // Backwards, the same circles belong to the other side.
                let t = modulo(angle - phi + FRAC_PI_2);
                let v = modulo(t + FRAC_PI_2 + phi);
                if t >= -EPS && v <= EPS {
                    to.take(Shape::Rsrl, flip, !self.reflect, [v, u, -FRAC_PI_2, t, 0.0]);
                }
            }
        }
        let u = 4.0 - (b * b - 4.0).sqrt();
        if u > EPS || PI - u >= to.bound() {
            return;
        }
        let lead = PI - math::atan2(4.0 - u, 2.0);
        for (flip, angle, phi) in self.ways(self.b.angle()) {
            let t = modulo(angle + lead);
            let v = modulo(t - phi);
            if t >= -EPS && v >= -EPS {
                to.take(Shape::Lrslr, flip, self.reflect, [t, -FRAC_PI_2, u, -FRAC_PI_2, v]);
            }
        }
    }

    /// LRLR with one cusp in the middle (lengths t, u, −u, v), or with two around the middle (t, u, u, v); the two
    /// middle arcs are equally long.
    fn four_circles(&self, to: &mut impl Visit) {
        let b = self.b.length;
        let rho = (2.0 + b) / 4.0;
        // An arc is not shorter than its chord.
        if rho <= 1.0 && (8.0 - 8.0 * rho).sqrt() * LESS < to.bound() {
            let u = math::acos(rho);
            if 2.0 * u < to.bound() {
                // sin u, cos u, sin 2u and cos 2u without another angle.
                let (sin, cos) = ((1.0 - rho * rho).sqrt(), rho);
                let lead = math::atan2(cos - (cos * cos - sin * sin) - 1.0, sin - 2.0 * sin * cos);
                for (flip, angle, phi) in self.ways(self.b.angle()) {
                    let t = modulo(angle - lead);
                    let v = modulo(t - 2.0 * u - phi);
                    if t >= -EPS && v <= EPS {
                        to.take(Shape::Lrlr, flip, self.reflect, [t, u, -u, v, 0.0]);
                    }
                }
            }
        }
        let rho = (20.0 - b * b) / 16.0;
        if (0.0..=1.0).contains(&rho) && (8.0 - 8.0 * rho).sqrt() * LESS < to.bound() {
            let u = -math::acos(rho);
            if -2.0 * u < to.bound() {
                let lead = math::atan2(rho - 2.0, -(1.0 - rho * rho).sqrt());
                for (flip, angle, phi) in self.ways(self.b.angle()) {
                    let t = modulo(angle - lead);
                    let v = modulo(t - phi);
                    if t >= -EPS && v >= -EPS {
                        to.take(Shape::Lrlr, flip, self.reflect, [t, u, u, v, 0.0]);
                    }
                }
            }
        }
    }
}

/// The angle in [−π, π]; sums of a few angles only.
fn modulo(angle: f64) -> f64 {
    let mut a = angle;
    while a > PI {
        a -= TAU;
    }
    while a < -PI {
        a += TAU;
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_brought_to_half_a_turn_either_way() {
        for (angle, want) in [(PI, PI), (-PI, -PI), (1.5 * PI, -0.5 * PI), (-4.5 * PI, -0.5 * PI), (0.5, 0.5)]
        {
            assert!((modulo(angle) - want).abs() < 1e-12, "{angle}");
        }
    }
}
