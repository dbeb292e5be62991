//! Quantiles.

use serde::Serialize;

use crate::geometry::math;

/// Statistics over many maps.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Spread {
    /// Half of the maps give no more.
    pub median: f64,
    /// 95 of 100 maps give no more.
    pub p95: f64,
    /// The largest.
    pub worst: f64,
}

impl Spread {
    /// The spread of at least one value.
    pub(super) fn of(values: &[f64]) -> Self {
        let sorted = math::sorted_by(values, |&v| v);
        let at = |q: f64| sorted[((sorted.len() - 1) as f64 * q).round() as usize];
        Self { median: at(0.5), p95: at(0.95), worst: at(1.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_a_hundred_and_one() {
        let values: Vec<f64> = (0..=100).rev().map(f64::from).collect();
        assert_eq!(Spread::of(&values), Spread { median: 50.0, p95: 95.0, worst: 100.0 });
        assert_eq!(Spread::of(&[7.0]).worst, 7.0);
    }
}
