//! Floods that were made before, for questions and planners that share them.
//!
//! A flood depends on obstacles, margin and source alone, so whoever asks for the same one may take it over. A planner
//! keeps the last one. The planners of an audit share more: ways in and out have the same ground, bays the same
//! entrance, and the obstacles of a bay that is taken for free differ in one car from those of the scene. There only
//! the cells around the car are looked at again, and only what the opened bay makes nearer is flooded again.

use std::sync::{Arc, Mutex, PoisonError};

use super::flood::{Flood, Room};
use crate::IS_COMPLETE;
use crate::map::Cell;

/// Floods that several planners share, from ways in and out of each of two entrances: those of the scene and of one
/// variant.
const SHARED: usize = 8;

/// Some floods that were made before, the one used last behind the others. A copy is the same memory.
#[derive(Debug, Clone)]
pub struct FloodMemory {
    most: usize,
    floods: Arc<Mutex<Vec<Flood>>>,
}

impl Default for FloodMemory {
    /// Keeps one flood.
    fn default() -> Self {
        Self { most: 1, floods: Arc::default() }
    }
}

impl FloodMemory {
    /// A memory for several planners.
    pub fn shared() -> Self {
        Self { most: SHARED, ..Self::default() }
    }

    /// The flood from a source, for a disc among obstacles; kept from now on.
    pub(super) fn flood(&self, room: &Room, source: Option<Cell>) -> Flood {
        let known = self.find(&|flood| flood.ground.serves(room) && flood.source == source);
        if let Some(known) = known {
            return known;
        }
        let ground = self.find(&|flood| flood.ground.serves(room)).map(|flood| flood.ground);
        if IS_COMPLETE && let Some(original) = room.obstacles.original() {
            let known = self.flood(&Room { obstacles: &original.obstacles, ..*room }, source);
            let ground = ground.unwrap_or_else(|| Arc::new(room.ground_from(&known.ground, original.change)));
            return self.kept(if original.is_freer {
                known.onto(ground)
            } else {
                Flood::new(ground, source)
            });
        }
        self.kept(Flood::new(ground.unwrap_or_else(|| room.ground().into()), source))
    }

    /// The flood of which this is true.
    #[inline(never)]
    fn find(&self, is_wanted: &dyn Fn(&Flood) -> bool) -> Option<Flood> {
        let mut floods = self.floods.lock().unwrap_or_else(PoisonError::into_inner);
        let at = floods.iter().rposition(is_wanted)?;
        let found = floods.remove(at);
        floods.push(found.clone());
        Some(found)
    }

    /// Keeps a flood in place of the one that was used longest ago.
    #[inline(never)]
    fn kept(&self, flood: Flood) -> Flood {
        let mut floods = self.floods.lock().unwrap_or_else(PoisonError::into_inner);
        if floods.len() >= self.most {
            floods.remove(0);
        }
        floods.push(flood.clone());
        flood
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::vehicle::collision::{Obstacles, Solid};

    fn rectangle(x: f64, y: f64, w: f64, h: f64) -> Vec<Point> {
        [(x, y), (x + w, y), (x + w, y + h), (x, y + h)].map(|(x, y)| Point::new(x, y)).to_vec()
    }

    /// A row of cars beside an aisle, from whose middle some are missing.
    fn row(missing: &[usize]) -> Obstacles {
        let cars = (0..12).filter(|k| !missing.contains(k));
        let solids: Vec<Solid> = cars
            .map(|k| Solid { outline: rectangle(0.37 + 2.45 * k as f64, 6.1, 1.83, 4.6), owner: k as u32 })
            .collect();
        Obstacles::new(&[], &solids, &Solid { outline: rectangle(0.0, 0.0, 31.0, 14.0), owner: 99 })
    }

    #[test]
    fn what_is_derived_from_other_obstacles_is_what_is_made_anew() {
        let memory = FloodMemory::shared();
        let original = Arc::new(row(&[]));
        let same = |obstacles: &Obstacles, radius: f64, source: Cell| {
            let room = Room { obstacles, radius };
            let made = Flood::new(room.ground().into(), Some(source));
            let derived = memory.flood(&room, Some(source));
            assert_eq!(made.ground.costs, derived.ground.costs);
            assert_eq!(made.steps, derived.steps);
        };
        for (radius, source) in [(1.0, Cell::new(9, 13)), (0.902, Cell::new(117, 51))] {
            for missing in [&[5][..], &[0], &[11, 2], &[]] {
                same(&row(missing).variant_of(&original), radius, source);
            }
            same(&row(&[]).variant_of(&Arc::new(row(&[4]))), radius, source);
        }
    }

    #[test]
    fn the_flood_that_was_used_longest_ago_gives_way() {
        let (obstacles, memory) = (row(&[3]), FloodMemory::shared());
        let room = Room { obstacles: &obstacles, radius: 0.9 };
        let cell = |k: usize| Some(Cell::new(8 + k as i32, 8));
        let first = memory.flood(&room, cell(0));
        for k in 1..=SHARED {
            let known = memory.flood(&room, cell(0));
            assert!(Arc::ptr_eq(&first.steps, &known.steps));
            memory.flood(&room, cell(k));
        }
        for k in 2..=SHARED {
            memory.flood(&room, cell(SHARED + k));
        }
        assert!(!Arc::ptr_eq(&first.steps, &memory.flood(&room, cell(0)).steps));
    }
}
