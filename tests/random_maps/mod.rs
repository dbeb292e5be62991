//! Small maps by seed.

use parkade::map::{Cell, Occupancy};
use parkade::scenario::generate::SplitMix64;

/// A map with cells blocked at random, start and goal free: `least` to `least + more - 1` cells a side, fewer than
/// `densest` per cent of them blocked.
pub(crate) fn random_map(
    random: &mut SplitMix64,
    [least, more]: [u32; 2],
    densest: u32,
) -> (Occupancy, Cell, Cell) {
    let (width, height) = (least + random.below(more), least + random.below(more));
    let density = random.below(densest);
    let mut map = Occupancy::new(width, height);
    for index in 0..map.len() as u32 {
        map.set(map.cell(index), random.below(100) < density);
    }
    let ends = [0, 1].map(|_| map.cell(random.below(map.len() as u32)));
    for cell in ends {
        map.set(cell, false);
    }
    (map, ends[0], ends[1])
}
