//! The lattices on which the fewest gear changes are looked for.
//!
//! Layers by a price: let a gear change cost P metres more than any path is long. Then f orders states by gear
//! changes first and by length second, and one search goes through them layer by layer. `Level::bound` is P times the
//! changes that are known, so the search ends when nothing with fewer is left.

use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::lattices::{FIRST_SHUFFLING_LEVEL, Level};
use crate::planners::hybrid::portfolio::COMFORTABLE_MARGIN;
use crate::planners::hybrid::question::MIN_MARGIN;

/// Margins with which fewer are looked for beside the one kept, metres.
pub(super) const FEWER_CHANGES_MARGINS: [f64; 3] = [COMFORTABLE_MARGIN, 0.01, MIN_MARGIN];
/// The searches of a lattice where the car creeps: how many gear changes more its paths may take than must be saved,
/// for the shortcut takes some out, and the extra cost of a change, metres.
pub(super) const CREEPING_PASSES: [(u32, f64); 3] = [(0, 2.0), (4, 2.0), (4, 6.0)];
/// The price of a gear change where fewer are looked for: this many metres …
const CHANGE_PRICE: f64 = 100.0;
/// … and this many lengths of the first path. No way that is worth taking is as long.
const CHANGE_PRICE_LENGTHS: f64 = 3.0;

/// The lattices of a car that creeps, and their levels' numbers: those of the plain levels and two others.
pub(super) fn creeping_levels(config: &Config) -> impl Iterator<Item = (Level, u32)> + use<> {
    let finest = FIRST_SHUFFLING_LEVEL - 1;
    let [coarse, fine] = [0, finest].map(|number| config.level(number));
    let others = [(fine.beside(2), finest), (fine.refined(1, config), finest)];
    let plain: Vec<_> = (0..=finest).map(|number| (config.level(number), number)).collect();
    plain.into_iter().chain(others).map(move |(level, number)| {
        let weight = if number == 0 { coarse.weight } else { fine.weight };
        (Level { weight, ..level.cheaply_tried(&coarse) }, number)
    })
}

/// A level in which a gear change is dearer than any way, beside a path of some length, and short of so many changes.
pub(super) fn layered(level: Level, config: &Config, (length, changes): (f64, u32)) -> Level {
    let price = CHANGE_PRICE + CHANGE_PRICE_LENGTHS * length;
    Level {
        extra_change: price - config.with_profile().direction_change_cost,
        bound: price * f64::from(changes),
        ..level.trying_all()
    }
}
