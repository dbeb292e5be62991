//! The maps that a grid planner searches: safety space blocked, dead ends closed, as bits.
//!
//! Up to three maps lie over each other, each blocked where the one below is: the *occupancy* (cells that obstacles
//! overlap), the *necessary* safety space (cells from which a disc as wide as the car would touch something) and the
//! *redundant* one (passages and pockets that settings close, which depends on start and goal). The search runs on the
//! topmost; smoothing and clearances use the one below, since closing a pocket makes nothing solid.
//!
//! Each is made at most once for a map: the first two with the planner, the last when its ends are first asked for.

use super::world::World;
use crate::map::{Bits, Layer, Redundant, RedundantSettings, redundant};
use crate::map::{Cell, Occupancy, inflation};
use crate::planners::grid_planner::Prepared;
use crate::planners::query::Query;
use crate::planners::settings::Common;

/// Absent maps are equal to the one below and take no memory.
pub(super) struct Rasters {
    /// The map with necessary safety space blocked, where there is any.
    inflated: Option<Occupancy>,
    extra: Extra,
}

/// Rasters that only the complete module has.
struct Extra {
    /// The radius of necessary safety space, cells, where there is any.
    radius: Option<f64>,
    closing: Option<RedundantSettings>,
    /// The redundant space that is closed between these two cells.
    closed: Option<(Cell, Cell, Redundant)>,
    bits: Option<Bits>,
}

impl Rasters {
    /// The rasters of a planner's settings that do not depend on the ends; redundant space does, and waits for them.
    pub(super) fn new(world: &World, settings: &Common) -> Self {
        let vehicle = &world.geometry.vehicle;
        let radius = settings
            .inflation
            .radius(vehicle.length(), vehicle.width, settings.margin)
            .map(|radius| radius / world.frame.resolution);
        Self {
            inflated: radius.map(|radius| inflation::necessary(&world.occupancy, radius)),
            extra: Extra::new(radius, settings),
        }
    }

    /// Bytes of what is searched.
    pub(super) fn bytes(&self, world: &World) -> usize {
        self.map(world).bytes() + self.extra.bits.as_ref().map_or(0, Bits::bytes)
    }

    /// Real obstacles and necessary safety space.
    pub(super) fn solid<'a>(&'a self, world: &'a World) -> &'a Occupancy {
        self.inflated.as_ref().unwrap_or(&world.occupancy)
    }

    /// The occupancy map that the search runs on.
    pub(super) fn map<'a>(&'a self, world: &'a World) -> &'a Occupancy {
        if let Some((_, _, redundant)) = &self.extra.closed {
            return &redundant.map;
        }
        self.solid(world)
    }

    /// A query on that map, with its jump bitmaps if there are any.
    pub(super) fn query<'a>(&'a self, world: &'a World, [start, goal]: [Cell; 2]) -> Prepared<'a> {
        Prepared { query: Query { map: self.map(world), start, goal }, bits: self.extra.bits.as_ref() }
    }
}

impl Extra {
    /// Passages and mouths of one cell are no restriction.
    fn new(radius: Option<f64>, settings: &Common) -> Self {
        let (min_passage, trap_mouth) = (settings.min_passage, settings.trap_mouth);
        let closes = min_passage > 1 || trap_mouth > 1;
        let closing = closes.then_some(RedundantSettings { min_passage, trap_mouth });
        Self { radius, closing, closed: None, bits: None }
    }
}

impl Rasters {
    /// Brings the map between these ends up to date.
    pub(super) fn prepare(&mut self, world: &World, [start, goal]: [Cell; 2]) {
        let Some(settings) = self.extra.closing else { return };
        if self.extra.closed.as_ref().is_none_or(|known| (known.0, known.1) != (start, goal)) {
            self.extra.closed = Some((start, goal, redundant(self.solid(world), start, goal, settings)));
            self.extra.bits = None;
        }
    }

    /// Makes sure that there are jump bitmaps of the searched map.
    pub(super) fn prepare_bits(&mut self, world: &World) {
        if self.extra.bits.is_none() {
            self.extra.bits = Some(Bits::new(self.map(world)));
        }
    }

    /// The closed redundant space, if the settings ask for it.
    pub(super) fn redundant(&self) -> Option<&Redundant> {
        self.extra.closed.as_ref().map(|closed| &closed.2)
    }

    /// Each cell's [`inflation::Safety`] between these ends, as a number.
    pub(super) fn layer(&self, world: &World, [start, goal]: [Cell; 2]) -> Layer<u8> {
        let solid = self.solid(world);
        match self.extra.closing.map(|settings| redundant(solid, start, goal, settings)) {
            Some(closed) => inflation::layers(&world.occupancy, solid, &closed.map),
            None => inflation::layer(&world.occupancy, solid),
        }
    }

    /// The map has changed in one cell.
    ///
    /// Costs what the cell's surroundings cost; only closed redundant space is thrown away, because it can change
    /// anywhere.
    pub(super) fn change(&mut self, world: &World, cell: Cell) {
        let extra = &mut self.extra;
        if let (Some(inflated), Some(radius)) = (&mut self.inflated, extra.radius) {
            inflation::update(&world.occupancy, inflated, radius, cell, extra.bits.as_mut());
        } else if let Some(bits) = &mut extra.bits {
            bits.follow(&world.occupancy, cell);
        }
        if extra.closed.take().is_some() {
            extra.bits = None;
        }
    }
}
