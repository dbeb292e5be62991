//! Settings that the grid planners share.
//!
//! Each is declared once, with its default, range, unit and the words for the page; types, checks, the inspector and
//! the tables of the documentation are made of that. A planner may leave out a setting that makes no sense for it.

use serde_json::Value;

use super::parameters::{EXPANSIONS, Form, parameters, spec};
use crate::error::Error;
use crate::json::{self, Setting, bad};
use crate::map::Corner;
use crate::post::SmoothMode;

/// Expansions after which a grid search gives up, unless told otherwise.
pub const MAX_EXPANSIONS: u32 = 20_000_000;

/// Space that the map keeps free beside the path for the car.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Inflation {
    /// None: the car is a point.
    #[default]
    None,
    /// Half its width: enough while it drives straight.
    Width,
    /// Half its diagonal: enough in every heading.
    HalfDiagonal,
}

json::words!(Inflation: "none" = None, "width" = Width, "half-diagonal" = HalfDiagonal);

impl Inflation {
    /// The radius in metres for a car of this length and width (metres), and extra `margin`; `None` for no inflation.
    pub fn radius(self, length: f64, width: f64, margin: f64) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Width => Some(width / 2.0 + margin),
            Self::HalfDiagonal => Some((length * length + width * width).sqrt() / 2.0 + margin),
        }
    }
}

/// Post-processing of the raw path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Post {
    /// Nothing.
    #[default]
    None,
    /// Skip cells that are not needed, in one pass (the paper).
    Prune,
    /// The shortest way over the path's own cells.
    PruneDp,
    /// Prune, then round the corners with tangent arcs.
    Smooth,
}

json::words!(Post: "none" = None, "prune" = Prune, "prune-dp" = PruneDp, "smooth" = Smooth);

/// The tightest arc that smoothing may put in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MinRadius {
    /// A radius in cells.
    Cells(f64),
    /// The car's own minimum turning radius.
    Vehicle,
}

impl MinRadius {
    /// The radius in cells, for a car that turns in `vehicle` metres on cells of `resolution` metres.
    pub fn in_cells(self, vehicle: f64, resolution: f64) -> f64 {
        match self {
            Self::Cells(radius) => radius,
            Self::Vehicle => vehicle / resolution,
        }
    }
}

impl Setting for MinRadius {
    fn read(&mut self, value: &Value) -> Result<(), Error> {
        *self = match (value.as_f64(), value.as_str()) {
            (Some(radius), _) => Self::Cells(radius),
            (_, Some("vehicle")) => Self::Vehicle,
            _ => return bad("", message!("must be a number of cells or \"vehicle\", got {}", value)),
        };
        Ok(())
    }

    fn write(&self) -> Value {
        match *self {
            Self::Cells(radius) => radius.into(),
            Self::Vehicle => "vehicle".into(),
        }
    }

    fn number(&self) -> Option<f64> {
        match *self {
            Self::Cells(radius) => Some(radius),
            Self::Vehicle => None,
        }
    }
}

parameters! {
    /// Settings of the map and of the path that all grid planners share.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Common {
        /// The rule for moves at corners of blocked cells.
        corner: Corner = Corner::Strict,
            spec("corner", Form::Choice(&["strict", "no-squeeze", "free"]), "1", false,
                 ["Corners", "转角规则"],
                 ["Strict: a path may not touch a blocked cell.", "严格：路径不得触碰障碍格。"]);
        /// Room for the car.
        inflation: Inflation = Inflation::None,
            spec("inflation", Form::Choice(&["none", "width", "half-diagonal"]), "1", true,
                 ["Safety space", "安全空间"],
                 ["Keeps the path this far from obstacles: nothing, half the car's width, half its diagonal.",
                  "与障碍保持的距离：零、半车宽或半对角线。"]);
        /// Extra room, metres.
        margin: f64 = 0.0,
            spec("margin", Form::Number(0.0, 2.0, 0.05), "m", true,
                 ["Extra margin", "额外余量"], ["Added to the safety space.", "加在安全空间之外。"]).within(0.0, 10.0);
        /// Passages through which no square of this many cells fits are closed; 1 closes none.
        min_passage: u32 = 1,
            spec("minPassage", Form::Integer(1.0, 8.0), "cells", false,
                 ["Narrowest passage", "最窄通道"],
                 ["Closes passages narrower than this many cells; 1 closes none. Start and goal stay connected.",
                  "封闭窄于此格数的通道；1 为不封闭。起终点保持连通。"]).within(1.0, 64.0).complete_only();
        /// Pockets into which no square of this many cells fits are closed; 1 closes none.
        trap_mouth: u32 = 1,
            spec("trapMouth", Form::Integer(1.0, 16.0), "cells", false,
                 ["Pockets", "陷阱填充"],
                 ["Closes dead ends into which no square of this many cells fits; 1 closes none.",
                  "封闭容不下此边长方块的死胡同；1 为不封闭。"]).within(1.0, 64.0).complete_only();
        /// Post-processing of the raw path.
        post: Post = Post::None,
            spec("post", Form::Choice(&["none", "prune", "prune-dp", "smooth"]), "1", true,
                 ["Post-processing", "后处理"], ["Removes spare cells; rounds corners.", "删去多余格点；圆滑转角。"]);
        /// How corners share the segment between them.
        smooth_mode: SmoothMode = SmoothMode::Dynamic,
            spec("smoothMode", Form::Choice(&["dynamic", "paper"]), "1", false,
                 ["Smoothing", "平滑方式"],
                 ["Dynamic shrinks an arc until it is free; the paper tries once.",
                  "动态：缩小圆弧直至无碰；论文：只试一次。"]);
        /// Tightest arc of smoothing, cells.
        min_radius: MinRadius = MinRadius::Cells(1.0),
            spec("minRadius", Form::NumberOr(0.0, 40.0, 0.5, &["vehicle"]), "cells", true,
                 ["Smallest arc", "最小圆弧"],
                 ["Arcs tighter than this stay corners; \"vehicle\" is the car's own limit.",
                  "更小的圆弧保留为折角；vehicle 为车辆极限。"]).within(0.0, 1000.0);
        /// Expansions after which the search gives up.
        max_expansions: u32 = MAX_EXPANSIONS,
            EXPANSIONS;
    }
}

impl Common {
    /// No safety space, no processing of the path.
    pub const PLAIN: Self = Self::DEFAULT;
}
