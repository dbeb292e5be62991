//! Settings of risk-field A*.
//!
//! Two sets of defaults are named: the paper's ([`Config::PAPER`], the planner `risk-field`) and this crate's
//! ([`Config::PLUS`], `risk-field-plus`). Where the paper's formulas can be read in two ways, both are choices here,
//! and the meant one is the default.

use crate::json;
use crate::map::risk::{Attraction, FieldSettings, ObstacleSet, PotentialField};
use crate::planners::parameters::{Form, parameters, spec};
use crate::planners::query::Query;
use crate::planners::settings::{Common, Post};
use crate::search::lattice::Deferral;

/// The estimate before the distance weight.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Heuristic {
    /// The paper's equations 10 and 11 as meant: w1 times the longer part plus w2 times the shorter.
    #[default]
    Corrected,
    /// The equations as printed, which scale the diagonal part twice and jump where the parts are equal.
    Printed,
    /// Unweighted: straight and diagonal steps over an empty map.
    Octile,
}

json::words!(Heuristic: "corrected" = Corrected, "printed" = Printed, "octile" = Octile);

/// Treatment of the five directions that the field does not pick.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fallback {
    /// Tried when the three improve nothing, else later, at a penalty: complete.
    #[default]
    Penalty,
    /// Tried when the three improve nothing, else only when nothing else is left: complete.
    Lexicographic,
    /// Tried only when the three improve nothing: may lose the way.
    StuckOnly,
    /// Never tried, the paper to the letter: loses the way on some maps.
    None,
}

json::words!(Fallback: "penalty" = Penalty, "lexicographic" = Lexicographic, "stuck-only" = StuckOnly, "none" = None);

parameters! {
    /// Settings of risk-field A*.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
        /// Weight of the longer part of the estimate. Thousandths count.
        w1: f64 = 2.0,
            spec("w1", Form::Number(0.5, 4.0, 0.1), "1", true,
                 ["Weight w1", "权重 w1"],
                 ["Of the longer axis distance to the goal.", "到目标较长轴向距离的权重。"]).within(0.0, 10.0);
        /// Weight of the shorter part of the estimate. Thousandths count.
        w2: f64 = 1.0,
            spec("w2", Form::Number(0.5, 4.0, 0.1), "1", true,
                 ["Weight w2", "权重 w2"], ["Of the shorter one.", "较短轴向距离的权重。"]).within(0.0, 10.0);
        /// Strength of the distance weight 1 + wbar · d(n)/d(s); 1 is the paper. Thousandths count.
        wbar: f64 = 1.0,
            spec("wbar", Form::Number(0.0, 4.0, 0.1), "1", false,
                 ["Dynamic weight", "动态权重"],
                 ["How strongly goal distance speeds up the search; paper: 1.",
                  "目标距离对搜索的加速程度；论文取 1。"]).within(0.0, 10.0);
        /// The estimate before the distance weight.
        heuristic: Heuristic = Heuristic::Corrected,
            spec("heuristic", Form::Choice(&["corrected", "printed", "octile"]), "1", false,
                 ["Heuristic", "启发函数"],
                 ["Corrected removes the printed formula's jump.", "修正式消除论文公式的跳变。"]);
        /// Gain of the goal's attraction.
        k1: f64 = 1.0,
            spec("k1", Form::Number(0.1, 10.0, 0.1), "1", false,
                 ["Attraction k1", "引力 k1"], ["Attraction gain.", "目标引力增益。"]).within(0.0, 1e6);
        /// Reach of the obstacles' repulsion, cells.
        rho0: f64 = 3.0,
            spec("rho0", Form::Number(1.0, 10.0, 0.5), "cells", true,
                 ["Reach of the field", "斥力范围"],
                 ["Obstacles farther away do not repel.", "更远的障碍不产生斥力。"]).within(1.0, 20.0);
        /// Gain of the repulsion; `null`: half of k1 times the distance from start to goal in cells.
        k2: Option<f64> = None,
            spec("k2", Form::Number(0.0, 1000.0, 0.5), "cells", false,
                 ["Repulsion k2", "斥力 k2"],
                 ["Repulsion gain; empty: half of k1 times the distance.",
                  "障碍斥力增益；空：k1 × 距离之半。"]).within(0.0, 1e6);
        /// How the pull depends on the distance.
        attraction: Attraction = Attraction::Linear,
            spec("attraction", Form::Choice(&["linear", "conic"]), "1", false,
                 ["Attraction law", "引力形式"],
                 ["Linear grows with the distance (the paper).", "线性随距离增大（论文）。"]);
        /// Which obstacles repel.
        obstacle_set: ObstacleSet = ObstacleSet::NearestMean,
            spec("obstacleSet", Form::Choice(&["nearest-mean", "nearest-first", "sum"]), "1", false,
                 ["Repelling cells", "斥力来源"],
                 ["The nearest, or all within reach.", "最近的障碍格，或范围内全部。"]);
        /// Longest extension beyond a step, in steps; 1 is the paper's double step.
        ext_len: u32 = 1,
            spec("extLen", Form::Integer(0.0, 16.0), "cells", false,
                 ["Extension", "扩展长度"],
                 ["How far diagonal moves may be stretched.", "斜向移动可延伸的格数。"]).within(0.0, 16.0);
        /// True if diagonal extensions that lead away from the goal are left out.
        goal_side: bool = false,
            spec("goalSide", Form::Flag, "1", false,
                 ["Goal side only", "仅目标侧"],
                 ["Drops extensions that lead away from the goal.", "去除背离目标的延伸格。"]);
        /// Treatment of the directions that the field does not pick.
        fallback: Fallback = Fallback::Penalty,
            spec("fallback", Form::Choice(&["penalty", "lexicographic", "stuck-only", "none"]), "1", false,
                 ["Deferred moves", "延后扩展"],
                 ["When the other five directions are tried; none: as in the paper, may get stuck.",
                  "其余五方向何时尝试；none 为论文原式，可能卡住。"]);
        /// How far `fallback: "penalty"` puts them back, cells.
        penalty: f64 = 4.0,
            spec("penalty", Form::Number(0.0, 40.0, 1.0), "cells", false,
                 ["Deferral cost", "延后代价"],
                 ["Cost added to deferred moves.", "延后扩展附加的代价。"]).within(0.0, 10_000.0);
        /// True if the search ends as soon as the goal is in sight.
        goal_shot: bool = false,
            spec("goalShot", Form::Flag, "1", false,
                 ["Direct finish", "直达目标"], ["Finishes as soon as the goal is in sight.", "目标可见即完成。"]);
    }
    /// The settings that all grid planners share.
    shared common: Common = Common { post: Post::Smooth, ..Common::PLAIN };
}

impl Config {
    /// The paper's planner, with this crate's answers where the paper is silent.
    pub const PAPER: Self = Self::DEFAULT;

    /// Settings that give shorter paths from fewer cells than the paper's.
    pub const PLUS: Self = Self {
        heuristic: Heuristic::Octile,
        wbar: 0.5,
        attraction: Attraction::Conic,
        k2: Some(1.0),
        goal_side: true,
        ext_len: 3,
        goal_shot: true,
        common: Common { post: Post::PruneDp, ..Common::PLAIN },
        ..Self::PAPER
    };

    /// The potential field of a query.
    pub fn field<'a>(&self, query: &Query<'a>) -> PotentialField<'a> {
        let (dx, dy) = (f64::from(query.goal.x - query.start.x), f64::from(query.goal.y - query.start.y));
        let settings = FieldSettings {
            k1: self.k1,
            rho0: self.rho0,
            k2: self.k2.unwrap_or(0.5 * self.k1 * (dx * dx + dy * dy).sqrt()),
            attraction: self.attraction,
            obstacle_set: self.obstacle_set,
        };
        PotentialField::new(query.map, query.goal, settings)
    }

    /// How the directions that the field does not pick are put back.
    pub(super) fn deferral(&self) -> Deferral {
        match self.fallback {
            Fallback::Penalty => Deferral::Penalty((self.penalty * 1e6).round() as i64),
            // Beyond every real priority, yet far from overflow.
            Fallback::Lexicographic => Deferral::Penalty(1 << 61),
            Fallback::StuckOnly => Deferral::IfStuck,
            Fallback::None => Deferral::Never,
        }
    }
}

/// A weight in thousandths.
pub(super) fn permille(weight: f64) -> i64 {
    (weight * 1000.0).round() as i64
}
