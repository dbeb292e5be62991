//! The scene as people write it: plain data, checked once by [`Scenario::validate`].
//!
//! A scene is the JSON that files, links and the page exchange: metres and radians, x east, y north, headings
//! counter-clockwise from east. A pose is the middle of the rear axle. Obstacles are walls, polygons, rectangles,
//! parked cars, roads and brushed cells; slots may hold parked cars, which block as obstacles do.
//!
//! The data stay as they were written: relative goals such as a slot stay a slot. [`resolve`] turns a valid scene
//! into outlines and poses in metres ([`resolve::Geometry`]), which is what planners and the check use. [`catalog`]
//! has the built-in scenes, [`generate`] seeded grid maps.

use serde::Serialize;
use std::collections::BTreeMap;

use crate::IS_COMPLETE;
use crate::geometry::Point;
use crate::geometry::Pose;
use crate::json;
pub use goal_region::{GoalRegion, HEADING_TOLERANCE};
pub use goal_set::{EntryChoice, GoalPose, GoalSet, Goals, SlotChoice, SlotsGoal};
pub(crate) use lane_position::LaneLeg;
pub use moving::MovingObstacle;
pub use road::{Lane, LanePiece, SpeedLimit};
pub use road_obstacle::Road;
pub use slot::{Entry, Lean, Slot, SlotGoal, SlotKind};
pub use vehicle_spec::VehicleSpec;

pub mod catalog;
pub(crate) mod checks;
mod figure_scenes;
pub mod generate;
mod goal_region;
mod goal_set;
mod lane_position;
pub mod lot;
mod moving;
mod moving_scenes;
mod paper_lot;
pub(crate) mod parse;
pub(crate) mod places;
pub mod resolve;
mod road;
mod road_obstacle;
mod road_scenes;
pub mod run_length;
mod scene_info;
pub mod slot;
pub(crate) mod validate;
pub(crate) mod vehicle_spec;

/// Largest number of cells on a side of the map.
pub const MAX_CELLS: u32 = 4096;

/// A scene: the map's frame, what stands in it, the car, where it is and where it shall go.
///
/// ```
/// use parkade::scenario::Scenario;
///
/// let scene = Scenario::from_json(&serde_json::json!({
///     "version": 1,
///     "map": { "origin": [0, 0], "width": 80, "height": 40, "resolution": 0.25 },
///     "obstacles": [{ "type": "wall", "points": [[10, 0], [10, 6]] }],
///     "vehicle": "sedan",
///     "start": { "x": 4, "y": 5, "heading": 0 },
///     "goal": { "x": 15, "y": 5, "heading": 0 }
/// }))
/// .unwrap();
/// assert_eq!(scene.obstacles.len(), 1);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Scenario {
    /// Format version, 1.
    pub version: u32,
    /// Id or file name; shown, never interpreted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The lattice and its place in the world.
    pub map: MapFrame,
    /// Everything that blocks, besides the border.
    pub obstacles: Vec<Obstacle>,
    /// Parking slots; an occupied one holds a parked car.
    pub slots: Vec<Slot>,
    /// Cells that cost more than their length.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub costs: Vec<CostArea>,
    /// Moving obstacles. Planners ignore them; a drive along a path waits for them.
    #[serde(skip_serializing_if = "json::is_left_out")]
    pub moving: Vec<MovingObstacle>,
    /// Lanes of a road, for planners that keep to them.
    #[serde(skip_serializing_if = "json::is_left_out")]
    pub lanes: Vec<Lane>,
    /// Areas with a speed limit, for planners that know speeds.
    #[serde(skip_serializing_if = "json::is_left_out")]
    pub speed_limits: Vec<SpeedLimit>,
    /// The car that plans.
    pub vehicle: VehicleSpec,
    /// Start pose.
    pub start: Pose,
    /// Goal.
    pub goal: Goal,
    /// Settings per planner id, laid over that planner's defaults.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub planners: BTreeMap<String, serde_json::Map<String, serde_json::Value>>,
}

impl Scenario {
    /// A scene of the map and its border alone, with one goal. What else it has is laid over it:
    ///
    /// ```
    /// use parkade::geometry::Pose;
    /// use parkade::scenario::{MapFrame, Scenario, VehicleSpec};
    ///
    /// let map = MapFrame { origin: [0.0, 0.0], width: 80, height: 40, resolution: 0.25, boundary: None };
    /// let (start, goal) = (Pose::new(4.0, 5.0, 0.0), Pose::new(15.0, 5.0, 0.0));
    /// let bare = Scenario::new(map, VehicleSpec::default(), start, goal);
    /// let named = Scenario { name: Some("Floor".to_owned()), ..bare };
    /// assert!(named.validate().is_ok() && named.obstacles.is_empty());
    /// ```
    pub fn new(map: MapFrame, vehicle: VehicleSpec, start: Pose, goal: Pose) -> Self {
        Self {
            version: 1,
            name: None,
            map,
            obstacles: Vec::new(),
            slots: Vec::new(),
            costs: Vec::new(),
            moving: Vec::new(),
            lanes: Vec::new(),
            speed_limits: Vec::new(),
            vehicle,
            start,
            goal: Goal::Pose(goal),
            planners: BTreeMap::new(),
        }
    }
}

/// A lattice of square cells. Cell (0, 0) is the south-western one; its lower left corner is at `origin`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct MapFrame {
    /// Lower left corner of the map, metres.
    pub origin: [f64; 2],
    /// Cells from west to east.
    pub width: u32,
    /// Cells from south to north.
    pub height: u32,
    /// Side of a cell, metres.
    pub resolution: f64,
    /// Outline of the drivable floor, metres; the map's rectangle where absent. Its edges are walls for the car.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary: Option<Vec<[f64; 2]>>,
}

/// Something that blocks.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "kebab-case", rename_all_fields = "camelCase")]
pub enum Obstacle {
    /// Brushed cells of the map.
    Cells {
        /// Name for messages and selection.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        /// Runs of blocked cells: x of the first, y, number of cells eastward.
        runs: Vec<[u32; 3]>,
    },
    /// A wall along a line.
    Wall {
        /// Name for messages and selection.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        /// Corners of the line, metres.
        points: Vec<[f64; 2]>,
        /// Full thickness, metres; 0 is a mathematical line.
        thickness: f64,
    },
    /// A simple polygon, convex or not, in either direction.
    Polygon {
        /// Name for messages and selection.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        /// Corners, metres.
        points: Vec<[f64; 2]>,
    },
    /// A rectangle, rotated about its centre.
    Rectangle {
        /// Name for messages and selection.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        /// Centre, metres.
        center: [f64; 2],
        /// Length along the heading and width across it, metres.
        size: [f64; 2],
        /// Radians.
        heading: f64,
    },
    /// A parked car.
    Car {
        /// Name for messages and selection.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        /// Middle of its rear axle.
        pose: Pose,
        /// Its dimensions.
        vehicle: VehicleSpec,
    },
    /// A road: its kerbs block, its lanes are to be kept to.
    #[serde(untagged)]
    Road(Road),
}

/// Cells that cost more to cross than others. Where areas overlap the heaviest counts.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct CostArea {
    /// Name for messages and selection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// Runs of cells: x of the first, y, number of cells eastward.
    pub runs: Vec<[u32; 3]>,
    /// Cost of a metre there, in metres: 1 to 10.
    pub weight: u32,
}

/// The goal of the car.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Goal {
    /// To a pose.
    Pose(Pose),
    /// Into a slot of the scene.
    Slot(SlotGoal),
    /// To whichever of several places is the cheapest to reach.
    #[serde(serialize_with = "write_set")]
    Set(GoalSet),
}

/// Writes a set of goals, which no scene of the small module has.
fn write_set<S: serde::Serializer>(set: &GoalSet, serializer: S) -> Result<S::Ok, S::Error> {
    if IS_COMPLETE { set.serialize(serializer) } else { serializer.serialize_unit() }
}

impl Scenario {
    /// Lanes to keep to between two points: the scene's, and those of its drawn roads in the direction of travel.
    ///
    /// ```
    /// use parkade::geometry::Point;
    /// use parkade::scenario::Scenario;
    ///
    /// let scene = Scenario::from_json(&serde_json::json!({
    ///     "version": 1,
    ///     "map": { "origin": [-10, -10], "width": 60, "height": 20, "resolution": 2 },
    ///     "obstacles": [{ "type": "road", "points": [[0, 0], [100, 0]] }],
    ///     "start": { "x": 5, "y": -1.75, "heading": 0 },
    ///     "goal": { "x": 90, "y": -1.75, "heading": 0 }
    /// }))
    /// .unwrap();
    /// // Traffic keeps to the right: eastwards south of the middle, westwards north of it.
    /// let [west, east] = [Point::new(5.0, 0.0), Point::new(90.0, 0.0)];
    /// assert_eq!(scene.lanes_between(west, east)[0].start.y, -1.75);
    /// assert_eq!(scene.lanes_between(east, west)[0].start.y, 1.75);
    /// ```
    pub fn lanes_between(&self, start: Point, goal: Point) -> Vec<Lane> {
        let drawn = self.roads().flat_map(|road| road.lanes_between(start, goal));
        self.lanes.iter().cloned().chain(drawn).collect()
    }

    /// All limits, those of drawn roads included.
    /// They are areas and have no direction; where two overlap, the lower one counts.
    pub fn all_speed_limits(&self) -> Vec<SpeedLimit> {
        self.speed_limits.iter().cloned().chain(self.roads().filter_map(Road::limit)).collect()
    }

    /// The scene's drawn roads in their order.
    fn roads(&self) -> impl Iterator<Item = &Road> {
        self.obstacles.iter().filter_map(|o| if let Obstacle::Road(road) = o { Some(road) } else { None })
    }
}
