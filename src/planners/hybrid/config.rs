//! Settings of hybrid A*.

use crate::error::{Error, ErrorCode};
use crate::json;

/// Which end the search tree grows from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SearchFrom {
    /// From the goal, the paper's improvement: leaving a slot is easier than finding it. From the start where the car can
    /// hardly move there and less than at the goal.
    #[default]
    Goal,
    /// From the start, the traditional way.
    Start,
    /// From both ends, the paper's flowchart.
    #[cfg(feature = "complete")]
    Both,
}

#[cfg(not(feature = "complete"))]
json::words!(SearchFrom: "goal" = Goal, "start" = Start);
#[cfg(feature = "complete")]
json::words!(SearchFrom: "goal" = Goal, "start" = Start, "both" = Both);

/// How the way still to go is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Heuristic {
    /// The larger of the Reeds–Shepp length and the way around obstacles for a point.
    #[default]
    Max,
    /// The Reeds–Shepp length.
    ReedsShepp,
    /// The straight line.
    Euclid,
}

json::words!(Heuristic: "max" = Max, "reeds-shepp" = ReedsShepp, "euclid" = Euclid);

/// What driving costs, by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Profile {
    /// As `shortest`, and a metre in reverse more than ten metres from both start and goal costs half as much again: the car
    /// does not reverse across a whole lot to save a few metres.
    #[default]
    Practical,
    /// As set one by one, by default length and a metre per gear change: the parking paper's measure.
    Shortest,
    /// Away from obstacles, few gear changes, a steady wheel.
    Comfort,
    /// As in the program that the parking paper started from.
    Classic,
}

json::words!(Profile: "practical" = Practical, "shortest" = Shortest, "comfort" = Comfort, "classic" = Classic);

impl Profile {
    /// Extra weight of a metre in reverse more than ten metres from both ends.
    pub(super) fn far_reverse(self) -> f64 {
        match self {
            Self::Practical | Self::Comfort => 0.5,
            Self::Shortest | Self::Classic => 0.0,
        }
    }
}

/// Settings of hybrid A*.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Config {
    /// Which end the search tree grows from.
    pub search_from: SearchFrom,
    /// Kept free around the body while planning, metres; less where start or goal have less.
    pub margin: f64,
    /// Gear changes of an analytic connection, at most.
    pub max_direction_changes: u32,
    /// Length of a motion primitive, metres; by the level where absent.
    pub motion_primitive_length: Option<f64>,
    /// Side of a position cell, metres; by the level where absent.
    pub xy_resolution: Option<f64>,
    /// Width of a heading bin, radians; by the level where absent.
    pub heading_resolution: Option<f64>,
    /// Steering angles per side, besides straight; by the level where absent.
    pub steer_samples: Option<u32>,
    /// How the way still to go is estimated.
    pub heuristic: Heuristic,
    /// Factor on the estimate; absent: 1, and 1.2 on the finer levels.
    pub heuristic_weight: Option<f64>,
    /// What driving costs; `comfort` and `classic` replace the six costs below.
    pub profile: Profile,
    /// Weight of a metre in reverse.
    pub reverse_cost: f64,
    /// Cost of a gear change, metres.
    pub direction_change_cost: f64,
    /// Weight of a metre at full lock, besides its length.
    pub steer_cost: f64,
    /// Cost of moving the wheel from straight to full lock, metres.
    pub steer_change_cost: f64,
    /// Weight of a metre in contact with an obstacle.
    pub obstacle_cost: f64,
    /// Distance at which that weight begins, metres.
    pub obstacle_distance: f64,
    /// Whether stretches are replaced by shorter curves afterwards.
    pub shortcut: bool,
    /// Whether the first connection ends the search, as in the paper.
    pub first_shot: bool,
    /// Whether finer levels are tried when the coarse one finds nothing.
    pub ladder: bool,
    /// The finest level that is tried, 0 to 6; from 5 on, for cars that can hardly move, smaller margins are tried too.
    pub finest_level: u32,
    /// Expansions per level; by the level where absent.
    pub max_expansions: Option<u32>,
}

json::settings! {
    Config:
    "searchFrom" = search_from,
    "margin" = margin,
    "maxDirectionChanges" = max_direction_changes,
    "motionPrimitiveLength" = motion_primitive_length,
    "xyResolution" = xy_resolution,
    "headingResolution" = heading_resolution,
    "steerSamples" = steer_samples,
    "heuristic" = heuristic,
    "heuristicWeight" = heuristic_weight,
    "profile" = profile,
    "reverseCost" = reverse_cost,
    "directionChangeCost" = direction_change_cost,
    "steerCost" = steer_cost,
    "steerChangeCost" = steer_change_cost,
    "obstacleCost" = obstacle_cost,
    "obstacleDistance" = obstacle_distance,
    "shortcut" = shortcut,
    "firstShot" = first_shot,
    "ladder" = ladder,
    "finestLevel" = finest_level,
    "maxExpansions" = max_expansions,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            search_from: SearchFrom::Goal,
            margin: 0.1,
            max_direction_changes: 3,
            motion_primitive_length: None,
            xy_resolution: None,
            heading_resolution: None,
            steer_samples: None,
            heuristic: Heuristic::Max,
            heuristic_weight: None,
            profile: Profile::Practical,
            reverse_cost: 1.0,
            direction_change_cost: 1.0,
            steer_cost: 0.0,
            steer_change_cost: 0.0,
            obstacle_cost: 0.0,
            obstacle_distance: 0.5,
            shortcut: true,
            first_shot: false,
            ladder: true,
            finest_level: LEVELS - 1,
            max_expansions: None,
        }
    }
}

impl Config {
    /// The traditional planner: the same, searched from the start.
    pub fn forward() -> Self {
        Self { search_from: SearchFrom::Start, ..Self::default() }
    }

    /// The tree of both ends.
    #[cfg(feature = "complete")]
    pub fn both_ways() -> Self {
        Self { search_from: SearchFrom::Both, ..Self::default() }
    }

    /// As coarse and greedy as the program that the parking paper started from, for comparison: 2 m, 15°, one level, the
    /// first connection, no shortcut.
    #[cfg(feature = "complete")]
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
        let own = [
            self.reverse_cost,
            self.direction_change_cost,
            self.steer_cost,
            self.steer_change_cost,
            self.obstacle_cost,
            self.obstacle_distance,
        ];
        let [
            reverse_cost,
            direction_change_cost,
            steer_cost,
            steer_change_cost,
            obstacle_cost,
            obstacle_distance,
        ] = match self.profile {
            Profile::Practical | Profile::Shortest => own,
            Profile::Comfort => [1.0, 2.0, 0.0, 0.1, 1.0, 0.5],
            Profile::Classic => [1.5, 0.0, 0.25, 0.9, 0.0, 0.5],
        };
        Self {
            reverse_cost,
            direction_change_cost,
            steer_cost,
            steer_change_cost,
            obstacle_cost,
            obstacle_distance,
            ..self
        }
    }

    /// Checks every setting.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        let within = |path: &str, value: f64, low: f64, high: f64| {
            if (low..=high).contains(&value) {
                return Ok(());
            }
            Err(Error::new(ErrorCode::Config, path, format!("must be between {low} and {high}, got {value}")))
        };
        within("margin", self.margin, 0.0, 10.0)?;
        within("maxDirectionChanges", f64::from(self.max_direction_changes), 0.0, 10.0)?;
        within("motionPrimitiveLength", self.motion_primitive_length.unwrap_or(1.0), 0.02, 20.0)?;
        within("xyResolution", self.xy_resolution.unwrap_or(1.0), 0.02, 20.0)?;
        within("headingResolution", self.heading_resolution.unwrap_or(0.1), 0.005, 1.6)?;
        within("steerSamples", f64::from(self.steer_samples.unwrap_or(2)), 1.0, 50.0)?;
        within("heuristicWeight", self.heuristic_weight.unwrap_or(1.0), 0.0, 100.0)?;
        within("reverseCost", self.reverse_cost, 1.0, 100.0)?;
        within("directionChangeCost", self.direction_change_cost, 0.0, 1000.0)?;
        within("steerCost", self.steer_cost, 0.0, 100.0)?;
        within("steerChangeCost", self.steer_change_cost, 0.0, 1000.0)?;
        within("obstacleCost", self.obstacle_cost, 0.0, 1000.0)?;
        within("finestLevel", f64::from(self.finest_level), 0.0, f64::from(LEVELS - 1))?;
        within("obstacleDistance", self.obstacle_distance, 0.01, 20.0)?;
        within("maxExpansions", f64::from(self.max_expansions.unwrap_or(1)), 1.0, 10_000_000.0)
    }
}

/// Levels from this one on are for cars that can hardly move.
pub(super) const SHUFFLING: u32 = 5;

/// One resolution of the lattice.
#[derive(Debug, Clone, Copy)]
pub(super) struct Level {
    pub(super) xy: f64,
    pub(super) yaw: f64,
    pub(super) step: f64,
    pub(super) steer_samples: u32,
    /// Spacing of collision checks along an arc, metres.
    pub(super) spacing: f64,
    pub(super) max_expansions: u32,
    pub(super) weight: f64,
    /// Extra weight of a metre in reverse away from both ends while searching.
    pub(super) far_reverse: f64,
    /// Extra cost of a gear change while searching, metres.
    pub(super) extra_change: f64,
    /// Whether nearness to obstacles costs nothing while searching.
    pub(super) plain: bool,
    /// What costs as much is left out.
    #[cfg(feature = "complete")]
    pub(super) bound: f64,
    /// Whether a car that can hardly move drives as far as it can each time, `step` at most.
    pub(super) shuffle: bool,
}

const DEGREE: f64 = core::f64::consts::PI / 180.0;

/// How many levels there are.
const LEVELS: u32 = 7;

impl Config {
    /// How many levels these settings allow.
    pub(super) fn levels(&self) -> u32 {
        if self.ladder { self.finest_level.min(LEVELS - 1) + 1 } else { 1 }
    }

    /// Side of a position cell, metres, and width of a heading bin, radians, of a level.
    #[cfg(feature = "complete")]
    pub fn resolution(&self, level: u32) -> (f64, f64) {
        let Level { xy, yaw, .. } = self.level(level);
        (xy, yaw)
    }

    /// One of the levels, coarse ones first.
    pub(super) fn level(&self, number: u32) -> Level {
        let (xy, yaw, step, steer_samples, spacing, max_expansions, weight) = match number {
            0 => (0.5, 5.0, 0.8, 2, 0.1, 20_000, 1.0),
            1 => (0.15, 2.0, 0.25, 1, 0.05, 60_000, 2.0),
            2 => (0.1, 1.0, 0.15, 1, 0.05, 60_000, 2.0),
            3 => (0.07, 0.6, 0.1, 1, 0.05, 100_000, 2.0),
            4 => (0.05, 0.5, 0.06, 1, 0.05, 100_000, 2.0),
            5 => (0.05, 1.0, 1.0, 1, 0.05, 10_000, 1.2),
            _ => (0.03, 0.5, 1.0, 1, 0.05, 10_000, 1.2),
        };
        let shuffle = number >= SHUFFLING;
        let level = Level {
            xy,
            yaw: yaw * DEGREE,
            step,
            steer_samples,
            spacing,
            max_expansions: self.max_expansions.unwrap_or(max_expansions),
            weight: self.heuristic_weight.unwrap_or(weight),
            far_reverse: 0.0,
            extra_change: if number > 0 && !shuffle { 2.0 } else { 0.0 },
            plain: false,
            #[cfg(feature = "complete")]
            bound: f64::INFINITY,
            shuffle,
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
