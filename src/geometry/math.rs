//! Transcendental functions that give the same bits natively and in wasm (libm), and angles.
//!
//! The sine of the standard library is the platform's, and platforms differ in the last bit. A search compares costs,
//! so one bit can change the order of two nodes and with it the path. `libm` is plain Rust: square roots, sums and
//! products of `f64` are exact to the rule everywhere, and everything else here is made of them. Clippy refuses the
//! methods of `f64`.

pub use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};
pub use libm::{atan, atan2, exp, hypot, log as ln, sincos as sin_cos, tan};

/// The sine of an angle.
pub fn sin(a: f64) -> f64 {
    sin_cos(a).0
}

/// The cosine of an angle.
pub fn cos(a: f64) -> f64 {
    sin_cos(a).1
}

/// The angle in [0, π] with this cosine, which lies in [−1, 1].
///
/// That of `libm` takes a square root, and on WebAssembly without the instruction for it.
pub fn acos(cos: f64) -> f64 {
    2.0 * atan(((1.0 - cos) / (1.0 + cos)).sqrt())
}

/// The angle in [−π/2, π/2] with this sine, which lies in [−1, 1].
pub fn asin(sin: f64) -> f64 {
    atan(sin / ((1.0 - sin) * (1.0 + sin)).sqrt())
}

/// The same direction in (−π, π]. Angles that lie there already keep their bits.
pub fn wrap(angle: f64) -> f64 {
    if angle > -PI && angle <= PI {
        return angle;
    }
    let a = angle.rem_euclid(TAU);
    if a > PI { a - TAU } else { a }
}

/// The smallest turn from heading `from` to heading `to`, in (−π, π]; positive to the left.
///
/// # Examples
/// ```
/// use parkade::geometry::math::{PI, turn};
///
/// // Across the seam at ±π the short way is taken.
/// assert!((turn(PI - 0.1, -PI + 0.1) - 0.2).abs() < 1e-12);
/// ```
pub fn turn(from: f64, to: f64) -> f64 {
    wrap(to - from)
}

/// The items by ascending key, equal ones in their old order.
///
/// One sort serves all types; each further instance of the standard one would add 8 kB to the wasm file.
pub fn sorted_by<T: Copy>(items: &[T], key: impl Fn(&T) -> f64) -> Vec<T> {
    // Flipping the sign bit, or all bits of negative numbers, makes the bits of a number sort like the number.
    let ordered = |v: f64| {
        let bits = v.to_bits();
        if bits >> 63 == 1 { !bits } else { bits | 1 << 63 }
    };
    let mut keys: Vec<(u64, u32)> = items.iter().zip(0..).map(|(item, i)| (ordered(key(item)), i)).collect();
    keys.sort_unstable();
    keys.into_iter().map(|(_, i)| items[i as usize]).collect()
}

/// The index of the least of some numbers, the first of several; 0 where there are none.
pub fn argmin(values: &[f64]) -> usize {
    let mut least = 0;
    for (i, &value) in values.iter().enumerate() {
        if value < values[least] {
            least = i;
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorting_is_stable_and_knows_signs() {
        let items = [(2.0, 'a'), (-1.0, 'b'), (2.0, 'c'), (-3.5, 'd'), (0.0, 'e')];
        let order: String = sorted_by(&items, |i| i.0).into_iter().map(|i| i.1).collect();
        assert_eq!(order, "dbeac");
    }

    #[test]
    fn angles_of_sines_and_cosines_are_those_of_libm() {
        for part in -1000..=1000 {
            let x = f64::from(part) / 1000.0;
            assert!((acos(x) - libm::acos(x)).abs() < 1e-15, "acos {x}");
            assert!((asin(x) - libm::asin(x)).abs() < 1e-15, "asin {x}");
        }
        assert_eq!((acos(1.0), acos(-1.0), asin(1.0), asin(-1.0)), (0.0, PI, FRAC_PI_2, -FRAC_PI_2));
    }

    #[test]
    fn wrap_keeps_pi_and_moves_minus_pi() {
        assert_eq!(wrap(PI), PI);
        assert_eq!(wrap(-PI), PI);
        assert_eq!(wrap(0.5), 0.5);
        assert!((wrap(3.0 * PI) - PI).abs() < 1e-12);
        assert!((wrap(-7.0) - (TAU - 7.0)).abs() < 1e-12);
    }
}
