//! Random scenes and tight ones by seed.

use std::ops::Range;

use parkade::geometry::math;
use parkade::optimise::{Options, Stage, slow_duration};
use parkade::referee::MotionLimits;
use parkade::vehicle::Vehicle;
use serde_json::Map;

use crate::made::{Made, dips, made_with, make, median, strays};
use crate::{random_scenes, tight_scenes};

/// Plans and trajectories of scenes of one kind.
#[derive(Default)]
struct Seeded {
    plans: u32,
    optimised: u32,
    passing: u32,
    /// Durations above those of `slow`, and above those of `slow` with the wheel straightened at the goal.
    longer: (u32, u32),
    /// Durations as shares of `slow`'s.
    shares: Vec<f64>,
    /// How far a simulated car strays at most, metres.
    strays: f64,
    /// How often a car brakes and speeds up again without a stop.
    dips: Vec<f64>,
    /// Of optimising.
    millis: Vec<f64>,
    /// Of planning and optimising.
    both: Vec<f64>,
}

impl Seeded {
    fn add(&mut self, name: &str, made: &Made, limits: &MotionLimits) {
        let (Some(route), Some(driven)) = (&made.route, &made.driven) else { return };
        let vehicle = &made.geometry.vehicle;
        let (slow, duration) = (slow_duration(vehicle, route, limits), driven.check.figures.duration);
        let straight = slow + straightening(made, limits);
        let is_optimised = driven.stage == Stage::Optimised;
        self.plans += 1;
        self.optimised += u32::from(is_optimised);
        self.passing += u32::from(driven.check.passes());
        self.longer.0 += u32::from(duration > slow);
        self.longer.1 += u32::from(duration > straight + 1e-9);
        self.shares.push(duration / slow);
        self.strays = self.strays.max(strays(&made.geometry, driven));
        self.dips.push(f64::from(dips(driven)));
        self.millis.push(made.millis.1);
        self.both.push(made.millis.0 + made.millis.1);
        if !is_optimised || !driven.check.passes() || duration > straight + 1e-9 {
            println!(
                "{name}: {}, {duration:.2} s, slow {slow:.2} s, with straight wheels {straight:.2} s, \
                 passes: {}, {} gear changes, clearance {:.3} m",
                driven.stage.as_str(),
                driven.check.passes(),
                made.plan.metrics.direction_changes,
                made.plan.metrics.min_clearance,
            );
        }
    }

    fn print(&mut self, kind: &str) {
        let worst = |millis: &[f64]| millis.iter().copied().fold(0.0, f64::max);
        let (optimise, both) = (worst(&self.millis), worst(&self.both));
        println!(
            "{kind}: {} plans, {} optimised, {} pass, {} longer than slow, {} also \
             where slow ends with straight wheels; of slow's time {:.2} in the median, {:.2} at most; a \
             car strays {:.1} mm at most; it brakes and speeds up again {} times in the median; optimise {:.1} ms in \
             the median, {optimise:.1} at most, with planning {:.1} and {both:.1}",
            self.plans,
            self.optimised,
            self.passing,
            self.longer.0,
            self.longer.1,
            median(&mut self.shares),
            self.shares.last().copied().unwrap_or(f64::NAN),
            1000.0 * self.strays,
            median(&mut self.dips),
            median(&mut self.millis),
            median(&mut self.both),
        );
    }
}

/// Seconds in which the wheel turns from where the plan ends to straight ahead.
fn straightening(made: &Made, limits: &MotionLimits) -> f64 {
    let vehicle = &made.geometry.vehicle;
    let last = made.plan.curvatures.iter().rev().find(|k| k.is_finite()).copied().unwrap_or(0.0);
    math::atan(vehicle.wheelbase * last).abs() / limits.steering_rate_of(vehicle)
}

pub(crate) fn print_random(seeds: Range<u64>, kind: &str) {
    let mut seeded = Seeded::default();
    for seed in seeds {
        let (scene, settings) = random_scenes::scene(seed);
        let limits = if kind == "limits" { some_limits(seed) } else { MotionLimits::default() };
        let options = Options { limits: limits.clone(), ..Options::default() };
        seeded.add(&format!("seed {seed}"), &made_with("hybrid", &scene, &settings, &options), &limits);
    }
    seeded.print(kind);
}

/// Limits of which some are as usual and the others anything from slow to fast.
fn some_limits(seed: u64) -> MotionLimits {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mut draw = |usual: f64, low: f64, high: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let share = (state >> 33) as f64 / f64::from(1_u32 << 31);
        if share < 0.5 { usual } else { low + (high - low) * (2.0 * share - 1.0) }
    };
    let lateral = draw(0.0, 0.2, 3.0);
    MotionLimits {
        speed: draw(2.5, 0.3, 6.0),
        acceleration: draw(1.0, 0.2, 4.0),
        deceleration: draw(1.0, 0.2, 4.0),
        steering_rate: draw(0.5, 0.1, 2.0),
        lateral_acceleration: (lateral > 0.0).then_some(lateral),
    }
}

/// The cars take the seeds in turn.
pub(crate) fn print_tight(seeds: &Range<u64>) {
    for (kind, draw) in tight_scenes::KINDS {
        let mut seeded = Seeded::default();
        for seed in seeds.clone() {
            let car = [Vehicle::SEDAN, Vehicle::PAPER][seed as usize % 2];
            let scene = draw(&car, seed).scenario();
            let made = make("hybrid", &scene, &Map::new());
            seeded.add(&format!("{kind} {seed}"), &made, &MotionLimits::default());
        }
        seeded.print(kind);
    }
}
