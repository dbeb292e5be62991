//! Transcendental functions that give the same bits natively and in wasm (libm), and angles.

pub use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};
pub use libm::{acos, asin, atan, atan2, cos, exp, hypot, log as ln, sin, tan};

/// `(sin a, cos a)`.
pub fn sin_cos(a: f64) -> (f64, f64) {
    (sin(a), cos(a))
}

/// The same direction in (−π, π].
pub fn wrap(angle: f64) -> f64 {
    if angle > -PI && angle <= PI {
        return angle;
    }
    let a = angle.rem_euclid(TAU);
    if a > PI { a - TAU } else { a }
}

/// The smallest turn from `from` to `to`, in (−π, π].
pub fn turn(from: f64, to: f64) -> f64 {
    wrap(to - from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrap_keeps_pi_and_moves_minus_pi() {
        assert_eq!(wrap(PI), PI);
        assert_eq!(wrap(-PI), PI);
        assert_eq!(wrap(0.5), 0.5);
        assert!((wrap(3.0 * PI) - PI).abs() < 1e-12);
        assert!((wrap(-7.0) - (TAU - 7.0)).abs() < 1e-12);
    }
}
