//! Edits of a planner's map that cost what they touch, not the size of the map.
//!
//! Painting walls by hand sends an edit with every frame, so an edit must not prepare the map again. The planner keeps
//! two occupancy maps: the cells that other obstacles block, and those under the brush. A cell of the searched map is
//! blocked where either is, so taking the brush away restores exactly what was below. Each changed cell updates the
//! rasters around it: the safety space in its radius, and the jump bitmaps of its row and column.
//!
//! The exact geometry (the body's outlines, the scene's runs) is needed only for a plan. It follows once at the next
//! one, however many strokes came before.

use super::Planner;
use super::brush::Brush;
use crate::error::{Error, ErrorCode};
use crate::map::{Cell, raster};
use crate::metrics::Body;
use crate::scenario::Obstacle;

impl Planner {
    /// Blocks runs of cells (column of the first, row, number of cells eastward) in this planner's map, or takes the
    /// brush away from them; what other obstacles block stays blocked.
    ///
    /// Rasters change only where the runs touch them. The scene and its exact geometry follow at the next plan.
    ///
    /// Overlapping runs count once, and a cell that already is as asked costs one look. The plan afterwards is the same
    /// as that of a planner made anew for the edited scene.
    ///
    /// # Examples
    /// ```
    /// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
    /// let mut planner = parkade::plan::Planner::new("eight", &scene, &Default::default()).unwrap();
    /// let before = planner.plan(Default::default()).hash();
    /// planner.brush(&[[40, 30, 3]], true).unwrap();
    /// planner.brush(&[[40, 30, 3]], false).unwrap();
    /// assert_eq!(planner.plan(Default::default()).hash(), before);
    /// assert!(planner.brush(&[[1_000_000, 0, 1]], true).is_err());
    /// ```
    ///
    /// # Errors
    /// [`ErrorCode::Input`] when a run is not on the map.
    pub fn brush(&mut self, runs: &[[u32; 3]], blocked: bool) -> Result<(), Error> {
        let dab = Obstacle::Cells { id: None, runs: runs.to_vec() };
        dab.validate(&self.scenario.map).map_err(|e| e.with_code(ErrorCode::Input))?;
        let Self { scenario, world, engine, brush, .. } = self;
        let brush = brush.get_or_insert_with(|| Brush::new(scenario, world));
        for cell in runs.iter().flat_map(|&[x, y, count]| (x..x + count).map(move |x| (x, y))) {
            let cell = Cell::new(cell.0 as i32, cell.1 as i32);
            if brush.covered.blocked(cell) == blocked {
                continue;
            }
            brush.covered.set(cell, blocked);
            brush.stale = true;
            if !brush.others.blocked(cell) {
                world.occupancy.set(cell, blocked);
                engine.cell_changed(world, cell);
            }
        }
        Ok(())
    }

    /// Brings the scene and its exact geometry up to date with the brush.
    pub(super) fn sync(&mut self) {
        let Some(brush) = self.brush.as_mut().filter(|brush| brush.stale) else { return };
        brush.stale = false;
        let mut covered = raster::to_runs(&brush.covered);
        for obstacle in &mut self.scenario.obstacles {
            if let Obstacle::Cells { runs, .. } = obstacle {
                // The first brush takes it all.
                *runs = std::mem::take(&mut covered);
            }
        }
        if !covered.is_empty() {
            self.scenario.obstacles.push(Obstacle::Cells { id: None, runs: covered });
        }
        // Runs on the map cannot make a valid scene invalid.
        if let Ok(geometry) = self.scenario.geometry() {
            self.world.body = Body::new(&geometry);
            self.world.geometry = geometry;
        }
        self.engine.obstacles_changed(&self.scenario, &self.world);
    }
}
