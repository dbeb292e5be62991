//! Settings of cost-map A*.

use crate::error::Error;
#[cfg(doc)]
use crate::error::ErrorCode;
use crate::json;
use crate::planners::settings::within;

/// What a way costs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Costs {
    /// Its length, each metre dearer by base, lane, kerb and speed terms.
    #[default]
    Metre,
    /// The manuscript's: the base cost once per cell entered, however long the step.
    Paper,
    /// Its length alone: plain A*.
    Steps,
}

json::words!(Costs: "metre" = Metre, "paper" = Paper, "steps" = Steps);

/// How the base cost falls with the clearance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Base {
    /// K / (d + ε).
    #[default]
    Inverse,
    /// A·exp(−B·d).
    Exponential,
}

json::words!(Base: "inverse" = Inverse, "exponential" = Exponential);

/// Which chords may replace cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pruning {
    /// Those that keep most of the room that the cells have.
    #[default]
    Auto,
    /// The manuscript's: those that see each other.
    Los,
    /// None.
    None,
}

json::words!(Pruning: "auto" = Auto, "los" = Los, "none" = None);

/// What becomes of the chords.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Curves {
    /// The smoothest spline that keeps its distance.
    #[default]
    Spline,
    /// The manuscript's: a spline up to a metre away, wherever that leads.
    Paper,
    /// They stay.
    None,
}

json::words!(Curves: "spline" = Spline, "paper" = Paper, "none" = None);

/// Settings of cost-map A*.
#[derive(Debug, Clone, PartialEq)]
pub struct Config {
    /// What a way costs.
    pub costs: Costs,
    /// How the base cost falls with the clearance.
    pub base: Base,
    /// K of the inverse base cost, metres.
    pub factor: f64,
    /// ε of the inverse base cost, metres.
    pub epsilon: f64,
    /// A of the exponential base cost.
    pub amplitude: f64,
    /// B of the exponential base cost, 1/m.
    pub decay: f64,
    /// K of the manuscript's inverse cost, metres.
    pub paper_factor: f64,
    /// ε of the manuscript's inverse cost, metres.
    pub paper_epsilon: f64,
    /// A of the manuscript's exponential cost.
    pub paper_amplitude: f64,
    /// B of the manuscript's exponential cost, 1/m.
    pub paper_decay: f64,
    /// Weight of the distance from the lane's middle.
    pub lane_weight: f64,
    /// Weight of the last metre to the kerb.
    pub kerb_weight: f64,
    /// Weight of the time that slow places take.
    pub speed_weight: f64,
    /// Kept free beside the body, metres.
    pub margin: f64,
    /// Which chords may replace cells.
    pub pruning: Pruning,
    /// Share of the cells' smallest clearance that a chord keeps.
    pub prune_share: f64,
    /// Clearance of the body beyond which no chord has to keep more, metres.
    pub prune_cap: f64,
    /// What becomes of the chords.
    pub smoothing: Curves,
    /// Root mean square distance that a curve may keep from the chords, metres.
    pub residual: f64,
    /// Whether the curve begins and ends in the car's headings at start and goal.
    pub headings: bool,
    /// Places of the curve, at least.
    pub smooth_points: u32,
    /// Expansions after which the search gives up.
    pub max_expansions: u32,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            costs: Costs::Metre,
            base: Base::Inverse,
            factor: 0.8,
            epsilon: 0.2,
            amplitude: 4.0,
            decay: 1.5,
            paper_factor: 5000.0,
            paper_epsilon: 1.0,
            paper_amplitude: 5000.0,
            paper_decay: 0.05,
            lane_weight: 0.3,
            kerb_weight: 0.5,
            speed_weight: 0.5,
            margin: 0.0,
            pruning: Pruning::Auto,
            prune_share: 0.8,
            prune_cap: 0.8,
            smoothing: Curves::Spline,
            residual: 0.12,
            headings: false,
            smooth_points: 100,
            max_expansions: 20_000_000,
        }
    }
}

json::settings! {
    Config:
    "costs" = costs,
    "base" = base,
    "factor" = factor,
    "epsilon" = epsilon,
    "amplitude" = amplitude,
    "decay" = decay,
    "paperFactor" = paper_factor,
    "paperEpsilon" = paper_epsilon,
    "paperAmplitude" = paper_amplitude,
    "paperDecay" = paper_decay,
    "laneWeight" = lane_weight,
    "kerbWeight" = kerb_weight,
    "speedWeight" = speed_weight,
    "margin" = margin,
    "pruning" = pruning,
    "pruneShare" = prune_share,
    "pruneCap" = prune_cap,
    "smoothing" = smoothing,
    "residual" = residual,
    "headings" = headings,
    "smoothPoints" = smooth_points,
    "maxExpansions" = max_expansions,
}

impl Config {
    /// The manuscript's costs, pruning and smoothing.
    pub fn paper() -> Self {
        Self { costs: Costs::Paper, pruning: Pruning::Los, smoothing: Curves::Paper, ..Self::default() }
    }

    /// Plain A*, to compare with.
    pub fn plain() -> Self {
        Self { costs: Costs::Steps, pruning: Pruning::None, smoothing: Curves::None, ..Self::default() }
    }

    /// Checks every setting.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        [
            ("factor", self.factor, 0.2, 3.0),
            ("epsilon", self.epsilon, 0.05, 1.0),
            ("amplitude", self.amplitude, 1.0, 10.0),
            ("decay", self.decay, 0.5, 4.0),
            ("paperFactor", self.paper_factor, 50.0, 10_000.0),
            ("paperEpsilon", self.paper_epsilon, 0.5, 2.0),
            ("paperAmplitude", self.paper_amplitude, 50.0, 10_000.0),
            ("paperDecay", self.paper_decay, 0.01, 0.1),
            ("laneWeight", self.lane_weight, 0.0, 3.0),
            ("kerbWeight", self.kerb_weight, 0.0, 3.0),
            ("speedWeight", self.speed_weight, 0.0, 3.0),
            ("margin", self.margin, 0.0, 20.0),
            ("pruneShare", self.prune_share, 0.5, 1.0),
            ("pruneCap", self.prune_cap, 0.0, 1.5),
            ("residual", self.residual, 0.02, 1.0),
            ("smoothPoints", f64::from(self.smooth_points), 50.0, 200.0),
            ("maxExpansions", f64::from(self.max_expansions), 1.0, 100_000_000.0),
        ]
        .into_iter()
        .try_for_each(|(path, value, low, high)| within(path, value, low, high))
    }
}
