//! Settings of hybrid A*, and what the named cost profiles make of them.

use super::profile::Profile;
use crate::IS_COMPLETE;
use crate::json;
use crate::planners::parameters::{Form, parameters, spec};

/// How many levels there are.
pub(super) const LEVEL_COUNT: u32 = 7;

const ENDS: &[&str] = if IS_COMPLETE { &["goal", "start", "both"] } else { &["goal", "start"] };

/// Which end the first search grows from. Where it finds nothing, finer ones grow from the end that is hard to leave.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SearchFrom {
    /// From the goal, the paper's improvement: leaving a slot is easier than finding it. From the start where the car
    /// can hardly move there and less than at the goal.
    #[default]
    Goal,
    /// From the start, the traditional way.
    Start,
    /// From both ends, the paper's flowchart.
    Both,
}

json::words!(SearchFrom: "goal" = Goal, "start" = Start; complete: "both" = Both);

/// How the way still to go is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Heuristic {
    /// The larger of the Reeds–Shepp length and the way around obstacles for a disc as wide as the car. Where that
    /// finds no way out of open space, a coarse search of the car's poses.
    #[default]
    Max,
    /// The Reeds–Shepp length.
    ReedsShepp,
    /// The straight line.
    Euclid,
}

json::words!(Heuristic: "max" = Max, "reeds-shepp" = ReedsShepp, "euclid" = Euclid);

parameters! {
    /// Settings of hybrid A*.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
        /// Kept free around the body while planning, metres; less where start or goal have less.
        margin: f64 = 0.1,
            spec("margin", Form::Number(0.0, 0.5, 0.05), "m", true,
                 ["Safety margin", "安全余量"],
                 ["Kept free around the whole car.", "车身四周保持的空隙。"]).within(0.0, 10.0);
        /// Gear changes of an analytic connection, at most.
        max_direction_changes: u32 = 3,
            spec("maxDirectionChanges", Form::Integer(0.0, 5.0), "1", true,
                 ["Final gear changes", "末段换挡数"],
                 ["Gear changes allowed in the final curve.", "结束搜索的曲线最多换挡几次。"]).within(0.0, 10.0);
        /// Length of a motion primitive, metres; by the level where absent.
        motion_primitive_length: Option<f64> = None,
            spec("motionPrimitiveLength", Form::Number(0.1, 4.0, 0.1), "m", true,
                 ["Primitive length", "基元长度"],
                 ["Short steps fit tight slots but take longer.", "短步适合窄位，但更慢。"]).within(0.02, 20.0);
        /// Width of a heading bin, radians; by the level where absent.
        heading_resolution: Option<f64> = None,
            spec("headingResolution", Form::Number(0.01, 0.35, 0.01), "rad", true,
                 ["Heading bins", "航向分格"],
                 ["Closer headings count as one state.", "更接近的航向视为同一状态。"]).within(0.005, 1.6);
        /// Cost of a gear change, metres.
        direction_change_cost: f64 = 1.0,
            spec("directionChangeCost", Form::Number(0.0, 10.0, 0.5), "m", true,
                 ["Gear-change cost", "换挡代价"],
                 ["Extra metres accepted to avoid one gear change.",
                  "为避免一次换挡可接受的绕行米数。"]).within(0.0, 1000.0);
        /// Which end the search tree grows from.
        search_from: SearchFrom = SearchFrom::Goal,
            spec("searchFrom", Form::Choice(ENDS), "1", true,
                 ["Search from", "搜索起点"],
                 ["Leaving a slot is easier than finding it.", "驶出车位比驶入更易搜索。"]);
        /// Cost profile; `comfort` and `classic` replace the six costs.
        profile: Profile = Profile::Practical,
            spec("profile", Form::Choice(&["practical", "shortest", "comfort", "classic"]), "1", false,
                 ["Cost profile", "代价方案"],
                 ["Practical avoids long reversing and many gear changes; comfort and classic replace the costs below.",
                  "practical 避免长距离倒车和频繁换挡；comfort 与 classic 取代以下各项代价。"]);
        /// Weight of a metre in reverse.
        reverse_cost: f64 = 1.0,
            spec("reverseCost", Form::Number(1.0, 5.0, 0.1), "1", true,
                 ["Reverse cost", "倒车代价"], ["Cost of a metre in reverse.", "倒车一米的权重。"]).within(1.0, 100.0);
        /// Side of a position cell, metres; by the level where absent.
        xy_resolution: Option<f64> = None,
            spec("xyResolution", Form::Number(0.05, 2.0, 0.05), "m", false,
                 ["Position cells", "位置分格"],
                 ["Closer positions count as one state.", "更接近的位置视为同一状态。"]).within(0.02, 20.0);
        /// Steering angles per side, besides straight; by the level where absent.
        steer_samples: Option<u32> = None,
            spec("steerSamples", Form::Integer(1.0, 10.0), "1", false,
                 ["Steering angles", "转角采样"],
                 ["Per side, besides straight.", "每侧的采样数，直行除外。"]).within(1.0, 50.0);
        /// How the way still to go is estimated.
        heuristic: Heuristic = Heuristic::Max,
            spec("heuristic", Form::Choice(&["max", "reeds-shepp", "euclid"]), "1", false,
                 ["Heuristic", "启发函数"],
                 ["Max: the larger of the free-space curve and the way around obstacles.",
                  "max：自由曲线与绕障路程取大者。"]);
        /// Factor on the estimate; absent: 1, and 1.2 on the finer levels.
        heuristic_weight: Option<f64> = None,
            spec("heuristicWeight", Form::Number(0.5, 5.0, 0.1), "1", false,
                 ["Heuristic weight", "启发权重"],
                 ["Above 1: faster, not always cheapest.", "大于 1：更快，但未必最优。"]).within(0.0, 100.0);
        /// Weight of a metre at full lock, besides its length.
        steer_cost: f64 = 0.0,
            spec("steerCost", Form::Number(0.0, 5.0, 0.1), "1", false,
                 ["Steering cost", "转向代价"], ["Cost of turning.", "转弯的权重。"]).within(0.0, 100.0);
        /// Cost of moving the wheel from straight to full lock, metres.
        steer_change_cost: f64 = 0.0,
            spec("steerChangeCost", Form::Number(0.0, 5.0, 0.1), "m", false,
                 ["Steering-change cost", "转角变化代价"],
                 ["Cost of turning the wheel.", "转动方向盘的代价。"]).within(0.0, 1000.0);
        /// Weight of a metre in contact with an obstacle.
        obstacle_cost: f64 = 0.0,
            spec("obstacleCost", Form::Number(0.0, 10.0, 0.5), "1", false,
                 ["Obstacle cost", "近障代价"],
                 ["Cost of driving close to obstacles.", "贴近障碍行驶的权重。"]).within(0.0, 1000.0);
        /// Distance at which that weight begins, metres.
        obstacle_distance: f64 = 0.5,
            spec("obstacleDistance", Form::Number(0.1, 3.0, 0.1), "m", false,
                 ["Obstacle distance", "近障距离"],
                 ["Distance where that cost begins.", "该代价开始的距离。"]).within(0.01, 20.0);
        /// True if stretches are replaced by shorter curves afterwards.
        shortcut: bool = true,
            spec("shortcut", Form::Flag, "1", false,
                 ["Shortcut", "捷径"], ["Shortens the finished path with curves.", "规划后以更短的曲线替换路段。"]);
        /// True if the first connection ends the search, as in the paper.
        first_shot: bool = false,
            spec("firstShot", Form::Flag, "1", false,
                 ["First connection", "首次连接即止"],
                 ["Stops at the first path found (the paper).", "找到第一条路径即停（论文）。"]);
        /// True if finer levels are tried when the coarse one finds nothing.
        ladder: bool = true,
            spec("ladder", Form::Flag, "1", false,
                 ["Finer levels", "逐级细化"],
                 ["Tries finer steps if coarse ones fail.", "粗步无解时尝试更细的步长。"]);
        /// The finest level that is tried, 0 to 6; from 5 on, for cars that can hardly move, smaller margins are tried
        /// too.
        finest_level: u32 = LEVEL_COUNT - 1,
            spec("finestLevel", Form::Integer(0.0, 6.0), "1", false,
                 ["Finest level", "最细级别"],
                 ["5 and 6: very tight spaces, many gear changes.",
                  "5 和 6 用于极窄空间，换挡很多。"]).within(0.0, 6.0);
        /// Expansions per level; by the level where absent.
        max_expansions: Option<u32> = None,
            spec("maxExpansions", Form::Integer(1.0, 1e7), "1", false,
                 ["Expansion budget", "扩展上限"],
                 ["Stops after this many.", "超过此数即放弃。"]).within(1.0, 10_000_000.0);
    }
}

impl Config {
    /// The traditional planner: the same, searched from the start.
    pub fn forward() -> Self {
        Self { search_from: SearchFrom::Start, ..Self::default() }
    }

    /// The tree of both ends.
    pub fn bidirectional() -> Self {
        Self { search_from: SearchFrom::Both, ..Self::default() }
    }

    /// As coarse and greedy as the program that the parking paper started from, for comparison: 2 m, 15°, one level,
    /// the first connection, no shortcut.
    pub fn classic() -> Self {
        Self {
            search_from: SearchFrom::Start,
            motion_primitive_length: Some(3.1),
            xy_resolution: Some(2.0),
            heading_resolution: Some(15_f64.to_radians()),
            steer_samples: Some(2),
            heuristic_weight: Some(5.0),
            profile: Profile::Classic,
            shortcut: false,
            first_shot: true,
            ladder: false,
            ..Self::default()
        }
    }

    /// These settings with the profile's costs.
    pub(super) fn with_profile(self) -> Self {
        match self.profile {
            Profile::Practical | Profile::Shortest => self,
            Profile::Comfort => Self {
                reverse_cost: 1.0,
                direction_change_cost: 2.0,
                steer_cost: 0.0,
                steer_change_cost: 0.1,
                obstacle_cost: 1.0,
                obstacle_distance: 0.5,
                ..self
            },
            Profile::Classic => Self {
                reverse_cost: 1.5,
                direction_change_cost: 0.0,
                steer_cost: 0.25,
                steer_change_cost: 0.9,
                obstacle_cost: 0.0,
                obstacle_distance: 0.5,
                ..self
            },
        }
    }
}
