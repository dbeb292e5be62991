//! Rasters of a planner's maps, for drawing.
//!
//! Layers are made when they are asked for and never kept: a planner that nobody draws spends no memory on them. Each
//! takes time linear in the cells, but for `redundant` and the fields, which are as dear as preparing a search. Values
//! are in row-major order from the south-western cell, x fastest: cell (x, y) is item `y * width + x`, as in the map.

use super::world::World;
use super::{Engine, Planner};
use crate::error::{Error, ErrorCode};
use crate::map::{distance, inflation};

/// A raster for drawing, row-major from the south-western cell.
#[derive(Debug, Clone)]
pub struct Layer {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The values.
    pub data: LayerData,
}

/// The values of a [`Layer`].
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

impl Planner {
    /// A raster: `occupancy`, `safety`, `redundant` (safety under this planner's own settings), `clearance`, `risk`,
    /// `potential` or `cost`; the ends are those of the last plan.
    ///
    /// `every` is 1, or for `risk` the side of squares of cells whose middle ones alone are told; squares that the
    /// map's border cuts through are left out.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] for another name, for `risk` and `potential` of a planner without a field, for `redundant`
    /// of one that is not a grid planner, for `cost` of one without a cost map, and for another `every`.
    ///
    /// # Examples
    /// ```
    /// use parkade::plan::{LayerData, Planner};
    ///
    /// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
    /// let planner = Planner::new("eight", &scene, &Default::default()).unwrap();
    /// let layer = planner.layer("clearance", 1).unwrap();
    /// let LayerData::Floats(metres) = &layer.data else { unreachable!() };
    /// assert_eq!(metres.len(), (layer.width * layer.height) as usize);
    /// assert!(planner.layer("risk", 1).is_err());
    /// ```
    pub fn layer(&self, name: &str, every: u32) -> Result<Layer, Error> {
        if every == 0 || (every > 1 && name != "risk") {
            let rule = if name == "risk" { "a whole number from 1" } else { "1 but for risk" };
            return Err(Error::new(ErrorCode::Input, "every", message!("must be {}, got {}", rule, every)));
        }
        let map = &self.world.occupancy;
        let data = match (name, &self.engine) {
            ("occupancy", _) => LayerData::Bytes(cells(&self.world)),
            ("safety", _) => {
                let radius = self.world.geometry.vehicle.width / 2.0 / self.world.frame.resolution;
                let inflated = inflation::necessary(map, radius);
                LayerData::Bytes(inflation::layer(map, &inflated).data)
            }
            ("clearance", _) => LayerData::Floats(distance::clearance(map, self.world.frame.resolution).data),
            #[cfg(feature = "complete")]
            ("redundant", Engine::Grid(engine)) => LayerData::Bytes(engine.safety(&self.world)),
            #[cfg(feature = "complete")]
            ("redundant", _) => {
                let message = message!("{} closes no redundant cells; grid planners do", self.kind.id());
                return Err(Error::new(ErrorCode::Input, "name", message));
            }
            #[cfg(feature = "complete")]
            ("cost", Engine::Road(engine)) => LayerData::Floats(engine.costs()),
            #[cfg(feature = "complete")]
            ("cost", _) => {
                let message = message!("{} has no cost map; cost-map has", self.kind.id());
                return Err(Error::new(ErrorCode::Input, "name", message));
            }
            #[cfg(feature = "complete")]
            ("potential", engine) => {
                let potential =
                    if let Engine::Grid(engine) = engine { engine.potential(&self.world) } else { None };
                let message = || message!("{} has no risk field; risk-field has", self.kind.id());
                LayerData::Floats(potential.ok_or_else(|| Error::new(ErrorCode::Input, "name", message()))?)
            }
            ("risk", engine) => {
                let field =
                    if let Engine::Grid(engine) = engine { engine.field(&self.world, every) } else { None };
                let message = || message!("{} has no risk field; risk-field has", self.kind.id());
                LayerData::Floats(field.ok_or_else(|| Error::new(ErrorCode::Input, "name", message()))?)
            }
            _ => {
                #[cfg(feature = "complete")]
                let known = "occupancy, safety, redundant, clearance, risk, potential or cost";
                #[cfg(not(feature = "complete"))]
                let known = "occupancy, safety, clearance or risk";
                let message = message!("must be {}, got \"{}\"", known, name);
                return Err(Error::new(ErrorCode::Input, "name", message));
            }
        };
        Ok(Layer { width: map.width() / every, height: map.height() / every, data })
    }
}

/// 1 where the map is blocked, else 0.
fn cells(world: &World) -> Vec<u8> {
    let map = &world.occupancy;
    (0..map.len() as u32).map(|i| u8::from(map.blocked(map.cell(i)))).collect()
}
