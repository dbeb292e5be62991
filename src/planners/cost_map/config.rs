//! Settings of cost-map A*.
//!
//! Two families of settings stand side by side: this crate's own (`metre`, `auto`, the line and the spline that the
//! car can follow) and the manuscript's (`paper`, `los`), which are kept so that its tables can be measured again.
//! Defaults are the former. Lengths are metres, and a margin is measured beside the body, not from its middle.

use crate::geometry::math;
use crate::json;
use crate::planners::parameters::{EXPANSIONS, Form, parameters, spec};

/// The cost formula.
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

/// The curve that replaces the chords.
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

parameters! {
    /// Settings of cost-map A*.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Config {
        /// The cost formula.
        costs: Costs = Costs::Metre,
            spec("costs", Form::Choice(&["metre", "paper", "steps"]), "1", true,
                 ["Costs", "代价"],
                 ["Metre: base, lane, kerb and speed costs per metre; paper: base cost once per cell; steps: plain A*.",
                  "metre：每米按基础、车道、路缘、速度加价；paper：每格计一次基础代价（论文）；steps：普通 A*。"]);
        /// How the base cost falls with the clearance.
        base: Base = Base::Inverse,
            spec("base", Form::Choice(&["inverse", "exponential"]), "1", true,
                 ["Base cost", "基础代价"],
                 ["Falls with clearance: K/(d+ε) or A·exp(−B·d).", "随间距下降的方式：K/(d+ε) 或 A·exp(−B·d)。"]);
        /// K of the inverse base cost, metres.
        factor: f64 = 0.8,
            spec("factor", Form::Number(0.2, 3.0, 0.1), "m", true,
                 ["K", "K"],
                 ["Inverse base cost; larger keeps farther away.",
                  "反比基础代价的系数；越大离障碍越远。"]).within(0.2, 3.0);
        /// ε of the inverse base cost, metres.
        epsilon: f64 = 0.2,
            spec("epsilon", Form::Number(0.05, 1.0, 0.05), "m", false,
                 ["ε", "ε"],
                 ["Inverse base cost; smaller is steeper at contact.",
                  "反比基础代价的偏移；越小贴近时越陡。"]).within(0.05, 1.0);
        /// A of the exponential base cost.
        amplitude: f64 = 4.0,
            spec("amplitude", Form::Number(1.0, 10.0, 0.5), "1", false,
                 ["A", "A"], ["Exponential base cost at contact.", "指数基础代价：接触处的值。"]).within(1.0, 10.0);
        /// B of the exponential base cost, 1/m.
        decay: f64 = 1.5,
            spec("decay", Form::Number(0.5, 4.0, 0.1), "1/m", false,
                 ["B", "B"], ["Decay of the exponential base cost.", "指数基础代价：衰减速度。"]).within(0.5, 4.0);
        /// Weight of the distance from the lane's middle.
        lane_weight: f64 = 0.3,
            spec("laneWeight", Form::Number(0.0, 3.0, 0.1), "1", true,
                 ["Lane α", "车道 α"],
                 ["Weight of the distance from the lane centre.", "偏离最近车道中心线的权重。"]).within(0.0, 3.0);
        /// Weight of the last metre to the kerb.
        kerb_weight: f64 = 0.5,
            spec("kerbWeight", Form::Number(0.0, 3.0, 0.1), "1", true,
                 ["Kerb β", "路缘 β"],
                 ["Weight of the last metre to the kerb.", "距路缘最后一米的权重。"]).within(0.0, 3.0);
        /// Weight of the time that slow places take.
        speed_weight: f64 = 0.5,
            spec("speedWeight", Form::Number(0.0, 3.0, 0.1), "1", true,
                 ["Speed γ", "速度 γ"],
                 ["Weight of time lost to limits and bends.", "限速与弯道耗时的权重。"]).within(0.0, 3.0);
        /// Kept free around the body wherever there is such a path, metres.
        margin: f64 = 0.8,
            spec("margin", Form::Number(0.0, 20.0, 0.05), "m", true,
                 ["Extra margin", "额外余量"],
                 ["Kept free around the car; where no path has that much room, the plan says how much it keeps.",
                  "车身周围须保持的空间；没有这样的路径时，结果注明实际保持多少。"]).within(0.0, 20.0);
        /// Which chords may replace cells.
        pruning: Pruning = Pruning::Auto,
            spec("pruning", Form::Choice(&["auto", "los", "none"]), "1", true,
                 ["Chords", "删减"],
                 ["Auto: chords keep most of the clearance; los: line of sight only (the paper).",
                  "auto：弦保留路径大部分间距；los：只要互相可见（论文）。"]);
        /// Share of the cells' smallest clearance that a chord keeps.
        prune_share: f64 = 0.8,
            spec("pruneShare", Form::Number(0.5, 1.0, 0.05), "1", false,
                 ["Kept share", "保留比例"],
                 ["Share of the cells' clearance a chord keeps.", "弦须保留的路径最小间距比例。"]).within(0.5, 1.0);
        /// Clearance of the body beyond which no chord has to keep more, metres.
        prune_cap: f64 = 0.8,
            spec("pruneCap", Form::Number(0.0, 1.5, 0.1), "m", false,
                 ["Enough room", "足够间距"],
                 ["Beside the car; chords need no more.", "车身旁达到此值后弦不再要求更多。"]).within(0.0, 1.5);
        /// The curve that replaces the chords.
        smoothing: Curves = Curves::Spline,
            spec("smoothing", Form::Choice(&["spline", "paper", "none"]), "1", true,
                 ["Curve", "平滑"],
                 ["Spline keeps clearance and steering limit; paper: within a metre of the chords.",
                  "spline：保持间距与转向极限；paper：允许偏离一米，不计后果（论文）。"]);
        /// Root mean square distance that a curve may keep from the chords, metres.
        residual: f64 = 0.12,
            spec("residual", Form::Number(0.02, 1.0, 0.01), "m", false,
                 ["Residual σ", "残差 σ"],
                 ["RMS distance of the curve from the chords.", "曲线与弦的均方根距离。"]).within(0.02, 1.0);
        /// True if the curve begins and ends in the car's headings at start and goal.
        headings: bool = false,
            spec("headings", Form::Flag, "1", false,
                 ["Keep headings", "保持朝向"],
                 ["The curve keeps the start and goal headings.", "曲线在起点和终点与车辆朝向一致。"]);
        /// Places of the curve, at least.
        smooth_points: u32 = 100,
            spec("smoothPoints", Form::Integer(50.0, 200.0), "1", false,
                 ["Samples", "采样点"],
                 ["Least number of tests; long paths: two a metre.",
                  "曲线检验点的最少个数；长路每米两个。"]).within(50.0, 200.0);
        /// K of the manuscript's inverse cost, metres.
        paper_factor: f64 = 5000.0,
            spec("paperFactor", Form::Number(50.0, 10_000.0, 50.0), "m", false,
                 ["K, paper", "K（论文）"],
                 ["It cancels: 500 to 8000 give the same path.",
                  "该系数会约去：500 至 8000 路径相同。"]).within(50.0, 10_000.0);
        /// ε of the manuscript's inverse cost, metres.
        paper_epsilon: f64 = 1.0,
            spec("paperEpsilon", Form::Number(0.5, 2.0, 0.1), "m", false,
                 ["ε, paper", "ε（论文）"], ["Of the paper's inverse cost.", "论文反比代价的偏移。"]).within(0.5, 2.0);
        /// A of the manuscript's exponential cost.
        paper_amplitude: f64 = 5000.0,
            spec("paperAmplitude", Form::Number(50.0, 10_000.0, 50.0), "1", false,
                 ["A, paper", "A（论文）"],
                 ["Of the paper's exponential cost.", "论文指数代价的幅值。"]).within(50.0, 10_000.0);
        /// B of the manuscript's exponential cost, 1/m.
        paper_decay: f64 = 0.05,
            spec("paperDecay", Form::Number(0.01, 0.1, 0.01), "1/m", false,
                 ["B, paper", "B（论文）"],
                 ["Of the paper's exponential cost.", "论文指数代价的衰减。"]).within(0.01, 0.1);
        /// Expansions after which the search gives up.
        max_expansions: u32 = 20_000_000,
            EXPANSIONS;
    }
}

impl Config {
    /// The margin that plans keep, metres: plain A* and the manuscript's curves know none.
    pub fn kept(&self) -> f64 {
        if self.costs == Costs::Steps || self.smoothing == Curves::Paper { 0.0 } else { self.margin }
    }

    /// Cost of a clearance of `clearance` metres beside the body, for a car of half width `radius`. Clearance beyond
    /// `enough` is not cheaper.
    pub(super) fn base_cost(&self, clearance: f64, radius: f64, enough: Option<f64>) -> f64 {
        let beside = |room: f64| match self.base {
            Base::Inverse => self.factor / (room + self.epsilon),
            Base::Exponential => self.amplitude * math::exp(-self.decay * room),
        };
        match (self.costs, self.base) {
            (Costs::Steps, _) => 0.0,
            (Costs::Metre, _) => {
                let spare = enough.map_or(0.0, |room| beside(room.max(0.0)));
                (beside(clearance - radius) - spare).max(0.0)
            }
            (Costs::Paper, Base::Inverse) => self.paper_factor / (clearance + self.paper_epsilon),
            (Costs::Paper, Base::Exponential) => {
                self.paper_amplitude * math::exp(-self.paper_decay * clearance)
            }
        }
    }

    /// The manuscript's costs, pruning and smoothing.
    pub fn paper() -> Self {
        Self { costs: Costs::Paper, pruning: Pruning::Los, smoothing: Curves::Paper, ..Self::default() }
    }

    /// Plain A*, to compare with.
    pub fn plain() -> Self {
        Self { costs: Costs::Steps, pruning: Pruning::None, smoothing: Curves::None, ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_costs_are_the_manuscripts() {
        let of = |costs, base| Config { costs, base, ..Config::default() };
        for clearance in [1.0, 1.75, 5.0, 17.0] {
            let cost = |costs, base| of(costs, base).base_cost(clearance, 0.95, None);
            let [inverse, exponential] =
                [Base::Inverse, Base::Exponential].map(|base| cost(Costs::Paper, base));
            assert!((inverse - 5000.0 / (clearance + 1.0)).abs() < 1e-9, "{clearance}");
            assert!((exponential - 5000.0 * math::exp(-0.05 * clearance)).abs() < 1e-9, "{clearance}");
            let beside = clearance - 0.95;
            let [inverse, exponential] =
                [Base::Inverse, Base::Exponential].map(|base| cost(Costs::Metre, base));
            assert!((inverse - 0.8 / (beside + 0.2)).abs() < 1e-9, "{clearance}");
            assert!((exponential - 4.0 * math::exp(-1.5 * beside)).abs() < 1e-9, "{clearance}");
        }
    }
}
