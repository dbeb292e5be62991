//! A stretch of a drive with one jerk.
//!
//! Every motion is a list of these. Station, speed and acceleration are those at the beginning; at time t of it they
//! follow from Taylor's polynomial, which is exact for a constant jerk.

/// A time of constant jerk.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Phase {
    pub(super) time: f64,
    pub(super) duration: f64,
    pub(super) station: f64,
    pub(super) speed: f64,
    pub(super) acceleration: f64,
    pub(super) jerk: f64,
    pub(super) run: usize,
}

impl Phase {
    /// Station, speed and acceleration after `t` seconds of it.
    pub(super) fn after(&self, t: f64) -> (f64, f64, f64) {
        let (v, a, j) = (self.speed, self.acceleration, self.jerk);
        let station = self.station + t * (v + t * (a / 2.0 + t * j / 6.0));
        (station, (v + t * (a + t * j / 2.0)).max(0.0), a + t * j)
    }
}
