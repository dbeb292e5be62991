//! Rasters of a planner's maps, for drawing.
//!
//! Layers are made when they are asked for and never kept: a planner that nobody draws spends no memory on them. Each
//! takes time linear in the cells, but for `redundant` and the fields, which are as dear as preparing a search. Values
//! are in row-major order from the south-western cell, x fastest: cell (x, y) is item `y * width + x`, as in the map.

use super::Planner;
use super::engine::LayerData;
use super::world::World;
use crate::IS_COMPLETE;
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
        let data = match name {
            "occupancy" => LayerData::Bytes(cells(&self.world)),
            "safety" => {
                let radius = self.world.geometry.vehicle.width / 2.0 / self.world.frame.resolution;
                let inflated = inflation::necessary(map, radius);
                LayerData::Bytes(inflation::layer(map, &inflated).data)
            }
            "clearance" => LayerData::Floats(distance::clearance(map, self.world.frame.resolution).data),
            _ => self.engine.layer(&self.world, name, every).ok_or_else(|| self.no_layer(name))?,
        };
        Ok(Layer { width: map.width() / every, height: map.height() / every, data })
    }

    /// The error where this planner has no raster of a name.
    fn no_layer(&self, name: &str) -> Error {
        const KNOWN: &str = if IS_COMPLETE {
            "occupancy, safety, redundant, clearance, risk, potential or cost"
        } else {
            "occupancy, safety, clearance or risk"
        };
        let id = self.kind.id();
        let message = match name {
            "risk" => message!("{} has no risk field; risk-field has", id),
            "potential" if IS_COMPLETE => message!("{} has no risk field; risk-field has", id),
            "redundant" if IS_COMPLETE => message!("{} closes no redundant cells; grid planners do", id),
            "cost" if IS_COMPLETE => message!("{} has no cost map; cost-map has", id),
            _ => message!("must be {}, got \"{}\"", KNOWN, name),
        };
        Error::new(ErrorCode::Input, "name", message)
    }
}

/// 1 where the map is blocked, else 0.
fn cells(world: &World) -> Vec<u8> {
    let map = &world.occupancy;
    (0..map.len() as u32).map(|i| u8::from(map.blocked(map.cell(i)))).collect()
}
