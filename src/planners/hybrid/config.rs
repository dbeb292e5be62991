//! Settings of hybrid A*.
//!
//! A level is one resolution of the state lattice. Coarse levels are fast and answer ordinary questions; fine ones
//! find the way out of slots that the coarse ones cannot leave, because in a narrow slot no step of 0.8 m is free.
//! Levels 1 to 4 make the position cell, the heading bin and the step smaller together: a step must leave its cell,
//! or else a move leads back to the state that it came from, and a bin must be narrower than the turn of a step at
//! full lock, or else turning shows no progress.
//!
//! Finer levels weigh the estimate with 2 instead of 1. They have many more states, and the shortest path is not what
//! they are for.

use super::profile::Profile;
use crate::IS_COMPLETE;
use crate::json;
use crate::planners::parameters::{Form, parameters, spec};

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
            heading_resolution: Some(15.0 * DEGREE),
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

/// Levels from this one on are for cars that can hardly move.
pub(super) const FIRST_SHUFFLING_LEVEL: u32 = 5;

/// One resolution of the lattice.
#[derive(Debug, Clone, Copy)]
pub(super) struct Level {
    /// Side of a position cell, metres.
    pub(super) xy: f64,
    /// Width of a heading bin, radians.
    pub(super) yaw: f64,
    /// Length of a motion primitive, metres.
    pub(super) step: f64,
    /// Steering angles to either side, besides straight.
    pub(super) steer_samples: u32,
    /// Spacing of collision checks along an arc, metres.
    pub(super) spacing: f64,
    /// Expansions after which this level gives up.
    pub(super) max_expansions: u32,
    /// Factor on the estimate; above 1 the path may cost as many times more.
    pub(super) weight: f64,
    /// Extra weight of a metre in reverse away from both ends while searching.
    pub(super) far_reverse: f64,
    /// The same along connections: at the coarsest level they are compared by what the path will be charged.
    pub(super) tail_far_reverse: f64,
    /// Extra cost of a gear change while searching, metres.
    pub(super) extra_change: f64,
    /// States whose cost reaches this bound are left out.
    pub(super) bound: f64,
    /// States that took more gear changes than this are left out.
    pub(super) most_changes: u8,
    /// Every so-many-th state is tried with a curve to the target: on a fine lattice neighbours see the same.
    pub(super) connect_every: u32,
    /// One more of them is passed over for each so many metres to the target; none where this is infinite.
    pub(super) connect_distance: f64,
    /// True if a car that can hardly move drives as far as it can each time, `step` at most.
    pub(super) shuffle: bool,
    /// Turn of a rock, radians; 0 where the car does not rock.
    pub(super) rock: f64,
    /// True if two trees grow, one from each end.
    pub(super) is_from_both: bool,
}

impl Level {
    /// The same where every state is tried with a curve to the target: the last gear change is often the one that a
    /// curve saves.
    pub(super) fn trying_all(self) -> Self {
        Self { connect_every: 1, connect_distance: f64::INFINITY, ..self }
    }

    /// The same with cells, bins and steps of half the size.
    pub(super) fn halved(self) -> Self {
        Self { xy: self.xy / 2.0, yaw: self.yaw / 2.0, step: self.step / 2.0, ..self }
    }

    /// The same with the wide spacing of the coarsest level, and a curve from every state. Most such searches find
    /// nothing, so they are to be cheap; the check of a path tells what a wide spacing misses.
    pub(super) fn cheaply_tried(self, coarsest: &Self) -> Self {
        Self { spacing: coarsest.spacing, connect_every: 1, ..self }
    }

    /// The same where the car may rock. Gear changes cost little, or else everything would be tried before; and
    /// there are hardly any connections, as a way out of every slot is known and the way to the target is not.
    pub(super) fn rocking(self, config: &Config) -> Self {
        let level = self.with_change(CHEAP_CHANGE_COST, config);
        Self { connect_every: ROCKING_CONNECT_EVERY, rock: ROCK_BINS * self.yaw, ..level }
    }

    /// The same where a path takes at most so many gear changes.
    pub(super) fn with_changes(self, most: u32) -> Self {
        Self { most_changes: most.min(u32::from(u8::MAX)) as u8, ..self }
    }

    /// The same where a gear change costs this at most, metres.
    pub(super) fn with_change(self, most: f64, config: &Config) -> Self {
        let change = config.with_profile().direction_change_cost;
        Self { extra_change: change.min(most) - change, ..self }
    }

    /// The same with this weight and so many expansions, unless the settings say others.
    pub(super) fn within(self, (weight, expansions): (f64, u32), config: &Config) -> Self {
        let weight = config.heuristic_weight.unwrap_or(weight);
        Self { weight, max_expansions: config.max_expansions.unwrap_or(expansions), ..self }
    }

    /// One of the finer lattices, from 1 on.
    pub(super) fn refined(self, number: usize, config: &Config) -> Self {
        let (xy, degrees, step) = REFINED[number - 1];
        let weight = config.heuristic_weight.unwrap_or(REFINED_WEIGHT);
        Self { xy, yaw: degrees * DEGREE, step, weight, ..self }
    }

    /// The finer lattice that rocks. With less weight there are too many states to go through.
    pub(super) fn fine_rocking(self, config: &Config) -> Self {
        let (xy, degrees, step, weight) = FINE_ROCKING;
        let yaw = degrees * DEGREE;
        let weight = config.heuristic_weight.unwrap_or(weight);
        Self { xy, yaw, step, weight, rock: ROCK_BINS * yaw, ..self }
    }

    /// The same lattice for a car that does not rock: one between the plain levels.
    pub(super) fn between(self, config: &Config) -> Self {
        Self { rock: 0.0, ..self.fine_rocking(config) }
    }
}

/// Finer lattices for a car that gains millimetres with each gear change: metres, degrees, metres.
const REFINED: [(f64, f64, f64); REFINEMENTS] =
    [(0.04, 0.6, 0.1), (0.03, 0.4, 0.1), (0.02, 0.25, 0.1), (0.02, 0.4, 0.08)];
/// How many they are.
pub(super) const REFINEMENTS: usize = 4;
/// Weight of the estimate on them.
const REFINED_WEIGHT: f64 = 1.3;
/// Cost of a gear change where the car may rock or the tree grows from the other end, metres.
pub(super) const CHEAP_CHANGE_COST: f64 = 0.2;
/// Turn of a rock, in heading bins: it leaves the bin.
const ROCK_BINS: f64 = 2.0;
/// The finer lattice of those that rock: metres, degrees, metres, and the weight of the estimate.
const FINE_ROCKING: (f64, f64, f64, f64) = (0.06, 0.75, 0.1, 3.0);
/// Every so-many-th state is tried with a curve to the target while the car may rock.
const ROCKING_CONNECT_EVERY: u32 = 16;

/// One more state is passed over for each so many metres to the target before the next is tried with a curve to it.
const CONNECT_DISTANCE: f64 = 5.0;

const DEGREE: f64 = core::f64::consts::PI / 180.0;

/// How many levels there are.
const LEVEL_COUNT: u32 = 7;

impl Config {
    /// How many levels these settings allow.
    /// From 1, where the ladder is off, to [`LEVEL_COUNT`].
    pub(super) fn levels(&self) -> u32 {
        if self.ladder { self.finest_level.min(LEVEL_COUNT - 1) + 1 } else { 1 }
    }

    /// One of the levels, coarse ones first.
    /// Settings of resolution replace the level's own on every level but those that shuffle.
    pub(super) fn level(&self, number: u32) -> Level {
        let (xy, yaw, step, steer_samples, spacing, max_expansions, weight) = match number {
            0 => (0.5, 5.0, 0.8, 2, 0.1, 20_000, 1.0),
            1 => (0.15, 2.0, 0.25, 1, 0.05, 60_000, 2.0),
            2 => (0.1, 1.0, 0.15, 1, 0.05, 60_000, 2.0),
            3 => (0.07, 0.6, 0.1, 1, 0.05, 100_000, 2.0),
            4 => (0.05, 0.5, 0.06, 1, 0.05, 100_000, 2.0),
            5 => (0.05, 1.0, 1.0, 1, 0.05, 8_000, 1.2),
            _ => (0.03, 0.5, 1.0, 1, 0.05, 8_000, 1.2),
        };
        let shuffle = number >= FIRST_SHUFFLING_LEVEL;
        let connect_every = if shuffle { 1 } else { (2 * number).max(1) };
        let level = Level {
            xy,
            yaw: yaw * DEGREE,
            step,
            steer_samples,
            spacing,
            max_expansions: self.max_expansions.unwrap_or(max_expansions),
            weight: self.heuristic_weight.unwrap_or(weight),
            far_reverse: 0.0,
            tail_far_reverse: if number == 0 { self.profile.far_reverse() } else { 0.0 },
            extra_change: if number > 0 && !shuffle { 2.0 } else { 0.0 },
            bound: f64::INFINITY,
            most_changes: u8::MAX,
            connect_every,
            connect_distance: if self.first_shot { f64::INFINITY } else { CONNECT_DISTANCE },
            shuffle,
            rock: 0.0,
            is_from_both: self.search_from == SearchFrom::Both,
        };
        if shuffle {
            return level;
        }
        Level {
            xy: self.xy_resolution.unwrap_or(level.xy),
            yaw: self.heading_resolution.unwrap_or(level.yaw),
            step: self.motion_primitive_length.unwrap_or(level.step),
            steer_samples: self.steer_samples.unwrap_or(level.steer_samples),
            ..level
        }
    }
}
