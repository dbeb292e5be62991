//! What each family of planners does with a scene.
//!
//! An engine is made once for a scene and settings. It keeps what can be prepared before a question is known, and the
//! memory of its searches. The calls are virtual: there is one for a plan, an edit or a raster, and none inside a
//! search.
//!
//! Only a plan has to be answered. A family that lacks an ability keeps the default, which answers `None` or changes
//! nothing, and the caller says so in its error.

use super::choices::Wish;
use super::outcome::Plan;
use super::world::World;
use crate::scenario::Scenario;
use crate::search::ExpansionCallback;
use crate::search::{Observers, Progress, Trace};
use crate::{
    geometry::{Point, Pose},
    map::Cell,
    planners::{hybrid::Last, query::GridReport, risk_field::Explanation},
};

/// Events that a trace keeps.
const TRACE: usize = 1_000_000;

/// What a caller wants of a plan besides its path.
pub(super) struct Ask<'a> {
    /// True to keep the search trace.
    pub(super) is_traced: bool,
    pub(super) progress: Option<Progress<'a>>,
    /// Steps of the search to write down.
    pub(super) record: Option<usize>,
    pub(super) expansions: Option<ExpansionCallback<'a>>,
    pub(super) wish: Wish<'a>,
}

impl<'a> Ask<'a> {
    /// The observer of a search over cells; it takes the progress.
    pub(super) fn observers(&mut self) -> Observers<'a> {
        let trace = self.is_traced.then(|| Trace::new(TRACE));
        (trace.map(|trace| trace.telling(self.expansions)), self.progress.take())
    }
}

/// The values of a [`Layer`](super::Layer).
///
/// Bytes are 0 or 1 in `occupancy` and a [`Safety`](crate::map::inflation::Safety) elsewhere. Floats are metres in
/// `clearance`, and two numbers per cell (east, north) in `risk`.
#[derive(Debug, Clone)]
pub enum LayerData {
    /// One byte per cell.
    Bytes(Vec<u8>),
    /// One or two numbers per cell.
    Floats(Vec<f32>),
}

/// A family's planner on one scene.
pub(super) trait Engine: Send {
    /// Plans between the ends of `world`. With several [goals](Engine::aim) its goal becomes the one that was reached.
    fn plan(&mut self, scenario: &Scenario, world: &mut World, ask: Ask) -> Plan;

    /// One of the rasters that only some families have ([`super::Planner::layer`]).
    fn layer(&self, world: &World, name: &str, every: u32) -> Option<LayerData> {
        let _ = (world, name, every);
        None
    }

    /// The occupancy map of `world` has changed in one cell.
    fn cell_changed(&mut self, world: &World, cell: Cell) {
        let _ = (world, cell);
    }

    /// The exact obstacles of `world` have changed.
    fn obstacles_changed(&mut self, scenario: &Scenario, world: &World) {
        let _ = (scenario, world);
    }

    /// Takes several goals for the next plan and returns true, or false if the family has to try one after another. Of
    /// a sample of goals those that lack the margin are left out, but not all of them.
    fn aim(&mut self, world: &World, goals: &[Pose], is_sample: bool) -> bool {
        let _ = (world, goals, is_sample);
        false
    }

    /// The search over cells alone.
    fn search(&mut self, world: &World, ends: [Pose; 2]) -> Option<GridReport> {
        let _ = (world, ends);
        None
    }

    /// The any-angle yardstick between the ends of `world`, metres.
    fn any_angle_length(&self, world: &World) -> Option<f64> {
        let _ = world;
        None
    }

    /// The risk field at the cell of a point; also `None` off the map and in blocked cells.
    fn explain(&self, world: &World, at: Point) -> Option<Explanation> {
        let _ = (world, at);
        None
    }

    /// The path that the next plan may stay with.
    fn last(&mut self) -> Option<&mut Option<Last>> {
        None
    }

    /// Makes a path the last one: its poses, one at least, their gears and curvatures.
    fn continue_along(&mut self, poses: &[Pose], gears: &[i8], curvatures: &[f64]) {
        let _ = (poses, gears, curvatures);
    }
}
