//! How often a path ends in a collision when nobody drives exactly along it.
//!
//! In each trial the car is beside the line of its middle by e(s) = b + a(s): b from N(0, 0.10²) for the whole drive,
//! a(s) a stationary first-order autoregression of standard deviation 0.12 m and correlation length 10 m, e within ±1
//! m, the heading untouched. Room is told at 21 offsets of every station and interpolated between. Trial k of a seed is
//! the same however trials are grouped.
//!
//! The recursion a(s + Δ) = ρ·a(s) + σ·√(1 − ρ²)·z with ρ = exp(−Δ/10 m) and z from N(0, 1) keeps the standard
//! deviation σ for any step Δ, so the risk does not depend on how stations are spaced.
//!
//! Measuring the room for each offset of each trial would take trials × stations queries; measured once per station and
//! offset it takes 21 × stations, and a trial is then arithmetic. Offsets are metres to the left of the line.

use serde_json::{Map, Value};

use super::road::Line;
use super::{Body, FAR};
use crate::error::{Error, ErrorCode};
use crate::geometry::{Pose, math};
use crate::json;
use crate::scenario::generate::SplitMix64;
use crate::scenario::resolve::Geometry;

/// Standard deviation of the offset of a whole drive, metres.
const BIAS: f64 = 0.10;
/// Of what changes along it, metres.
const SWAY: f64 = 0.12;
/// Over which the latter is forgotten, metres.
const MEMORY: f64 = 10.0;
/// Offsets are at most this, metres.
const MOST: f64 = 1.0;
/// Room beyond this is not looked for: at the next offset there is some, too, metres.
const NEAR: f64 = 0.2;
/// Offsets at which room is measured, a tenth of a metre apart.
const OFFSETS: usize = 21;

/// Metres that all trials together may drive.
pub const MAX_DRIVEN: f64 = 1e9;

/// Which trials to run.
///
/// Results of slices `from..from + trials` of one seed add up to those of the whole, on any number of workers.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// How many, 1 to 1 000 000, and so few that together they drive no more than [`MAX_DRIVEN`].
    pub trials: u32,
    /// The number of the first one: slices of trials add up.
    pub from: u32,
    /// Of the random numbers.
    pub seed: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self { trials: 1000, from: 0, seed: 20_260_101 }
    }
}

json::settings! {
    Options:
    "trials" = trials,
    "from" = from,
    "seed" = seed,
}

impl Options {
    /// Of an object; fields that are absent keep their defaults.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] with the field and the rule.
    pub fn from_json(fields: &Map<String, Value>) -> Result<Self, Error> {
        let input = |e: Error| e.with_code(ErrorCode::Input);
        let options = Self::default().with(fields).map_err(input)?;
        if !(1..=1_000_000).contains(&options.trials) {
            let message = message!("must be between 1 and 1000000, got {}", options.trials);
            return Err(Error::new(ErrorCode::Input, "trials", message));
        }
        Ok(options)
    }

    /// The numbers of the trials.
    fn numbers(&self) -> std::ops::Range<u32> {
        self.from..self.from.saturating_add(self.trials)
    }
}

/// How many trials collide.
///
/// The standard error of the share p = hits/trials is √(p·(1 − p)/trials): 0.7 % for 1000 trials with p = 5 %.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Risk {
    /// Trials run.
    pub trials: u32,
    /// Those in which the body overlaps something, 5 m at the ends left out.
    pub hits: u32,
    /// The same for a disc of the car's width about its middle.
    pub disc_hits: u32,
}

/// Rooms of one station by offset, metres; where the neighbours' signs are the same, only the sign counts.
type Rooms = [f64; OFFSETS];

/// Measures only where the sign changes: elsewhere interpolation cannot change it.
fn rooms(hits: impl Fn(usize) -> bool, exact: impl Fn(usize) -> f64) -> Rooms {
    let hit: [bool; OFFSETS] = std::array::from_fn(hits);
    let edge = |k: usize| hit[k.saturating_sub(1)] != hit[k] || hit[(k + 1).min(OFFSETS - 1)] != hit[k];
    std::array::from_fn(|k| match (edge(k), hit[k]) {
        (true, _) => exact(k),
        (false, true) => -1.0,
        (false, false) => 1.0,
    })
}

/// Runs trials along a path of rear-axle poses.
///
/// # Examples
/// ```
/// use parkade::metrics::Body;
/// use parkade::metrics::random_drives::{Options, collision_risk};
///
/// let geometry = parkade::scenario::catalog::scenario("road-straight").unwrap().geometry().unwrap();
/// let body = Body::new(&geometry);
/// let path = [geometry.start, geometry.start.advance(0.0, 50.0)];
/// let hits = |from, trials| {
///     let options = Options { trials, from, ..Options::default() };
///     collision_risk(&geometry, &body, &path, &options).hits
/// };
/// assert_eq!(hits(0, 20) + hits(20, 30), hits(0, 50));
/// ```
pub fn collision_risk(geometry: &Geometry, body: &Body, path: &[Pose], options: &Options) -> Risk {
    let line = Line::new(geometry, path);
    let side = geometry.vehicle.width / 2.0;
    let offset = |k: usize| k as f64 / 10.0 - MOST;
    let inner: Vec<usize> = line.inner().collect();
    let rooms_of = |i: usize| {
        let pose = |k: usize| line.pose(i, offset(k));
        rooms(|k| body.hit(pose(k)).is_some(), |k| body.signed_clearance(pose(k), FAR))
    };
    let bodies: Vec<Rooms> = inner.iter().map(|&i| rooms_of(i)).collect();
    let disc = |i: usize, k: usize| body.point_clearance(line.middle(i, offset(k)), side + NEAR) - side;
    let discs: Vec<Rooms> = inner.iter().map(|&i| std::array::from_fn(|k| disc(i, k))).collect();
    let mut risk = Risk { trials: options.trials, hits: 0, disc_hits: 0 };
    for trial in options.numbers() {
        let mut drive = Drive::new(options, trial, line.step);
        let (mut hit, mut disc_hit) = (false, false);
        for (body, disc) in bodies.iter().zip(&discs) {
            let place = (drive.offset() + MOST) * 10.0;
            hit |= between(body, place) < 0.0;
            disc_hit |= between(disc, place) < 0.0;
            if hit && disc_hit {
                break;
            }
            drive.go_on();
        }
        risk.hits += u32::from(hit);
        risk.disc_hits += u32::from(disc_hit);
    }
    risk
}

/// The band that the middles of all trials stay in: per station of the path the points farthest to the left and to the
/// right, x, y, x, y; 5 m at the ends left out.
pub fn drive_envelope(geometry: &Geometry, path: &[Pose], options: &Options) -> Vec<f64> {
    let line = Line::new(geometry, path);
    let inner: Vec<usize> = line.inner().collect();
    let mut widest = vec![[f64::NEG_INFINITY, f64::INFINITY]; inner.len()];
    for trial in options.numbers() {
        let mut drive = Drive::new(options, trial, line.step);
        for [left, right] in &mut widest {
            let offset = drive.offset();
            (*left, *right) = (left.max(offset), right.min(offset));
            drive.go_on();
        }
    }
    let points = |(&i, offsets): (&usize, [f64; 2])| offsets.map(|offset| line.middle(i, offset));
    inner.iter().zip(widest).flat_map(points).flat_map(|p| [p.x, p.y]).collect()
}

/// One trial: how far to the left of the path the car is, station by station.
struct Drive {
    normal: Normal,
    bias: f64,
    sway: f64,
    memory: f64,
    fresh: f64,
}

impl Drive {
    /// `step` is the distance of stations, metres.
    fn new(options: &Options, trial: u32, step: f64) -> Self {
        let seed = SplitMix64::new(u64::from(options.seed) << 32 | u64::from(trial)).next();
        let mut normal = Normal { random: SplitMix64::new(seed), spare: None };
        let memory = math::exp(-step / MEMORY);
        let (bias, sway) = (BIAS * normal.next(), SWAY * normal.next());
        Self { normal, bias, sway, memory, fresh: SWAY * (1.0 - memory * memory).sqrt() }
    }

    fn offset(&self) -> f64 {
        (self.bias + self.sway).clamp(-MOST, MOST)
    }

    fn go_on(&mut self) {
        self.sway = self.memory * self.sway + self.fresh * self.normal.next();
    }
}

/// The room at a place between two offsets, linear; `place` counts offsets from the rightmost.
fn between(rooms: &Rooms, place: f64) -> f64 {
    let low = (place as usize).min(OFFSETS - 2);
    let share = place - low as f64;
    rooms[low] * (1.0 - share) + rooms[low + 1] * share
}

/// Normal deviates by Box and Muller.
struct Normal {
    random: SplitMix64,
    spare: Option<f64>,
}

impl Normal {
    /// A normally distributed number by Box and Muller (1958), which makes two at a time: the second is kept. The half
    /// bit keeps the logarithm's argument above 0.
    fn next(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        let unit = |bits: u64| ((bits >> 11) as f64 + 0.5) / 9_007_199_254_740_992.0;
        let radius = (-2.0 * math::ln(unit(self.random.next()))).sqrt();
        let (sin, cos) = math::sin_cos(math::TAU * unit(self.random.next()));
        self.spare = Some(radius * sin);
        radius * cos
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deviates_are_normal() {
        let mut normal = Normal { random: SplitMix64::new(1), spare: None };
        let values: Vec<f64> = (0..100_000).map(|_| normal.next()).collect();
        let mean = values.iter().sum::<f64>() / 1e5;
        let variance = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / 1e5;
        let far = values.iter().filter(|v| v.abs() > 1.96).count();
        assert!(mean.abs() < 0.01 && (variance - 1.0).abs() < 0.015, "{mean} {variance}");
        assert!((4700..5300).contains(&far), "{far}");
    }

    #[test]
    fn rooms_are_interpolated() {
        let rooms: Rooms = std::array::from_fn(|k| k as f64);
        for place in [0.0, 0.25, 7.5, 19.99, 20.0] {
            assert!((between(&rooms, place) - place).abs() < 1e-12);
        }
    }

    #[test]
    fn wrong_options_are_named() {
        let with = |fields: Value| Options::from_json(fields.as_object().unwrap());
        assert_eq!(with(serde_json::json!({})).unwrap(), Options::default());
        for (fields, path) in [
            (serde_json::json!({ "trials": 0 }), "trials"),
            (serde_json::json!({ "seed": -1 }), "seed"),
            (serde_json::json!({ "slice": 1 }), "slice"),
        ] {
            let error = with(fields).unwrap_err();
            assert_eq!((error.code, error.path.as_str()), (ErrorCode::Input, path));
        }
    }
}
