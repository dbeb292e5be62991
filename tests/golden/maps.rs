//! Maps, their inflation and their redundant space.

use parkade::map::{RedundantSettings, inflation, redundant};
use parkade::planners::query::Query;

use super::maps;

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn maps_are_drawn_bit_for_bit() {
    let maps = maps();
    assert_eq!(maps.maps.len(), 11);
    for golden in maps {
        golden.equal("/blocked_cells", golden.map.blocked_cells());
        golden.hash("/map_fnv1a64", &golden.map);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn inflation_blocks_the_same_cells() {
    for golden in maps() {
        let inflated = inflation::necessary(&golden.map, 0.9);
        golden.equal("/inflated_rho_0_9/blocked", inflated.blocked_cells());
        golden.hash("/inflated_rho_0_9/map_fnv1a64", &inflated);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn redundant_space_is_the_same() {
    for golden in maps() {
        let Query { map, start, goal } = golden.query();
        let closed = redundant(map, start, goal, RedundantSettings { min_passage: 2, trap_mouth: 5 });
        golden.equal("/safety_space_m2_q5/narrow", closed.narrow);
        golden.equal("/safety_space_m2_q5/pocket", closed.pocket);
        golden.equal("/safety_space_m2_q5/restored", closed.restored);
        golden.hash("/safety_space_m2_q5/map_fnv1a64_with_redundant_blocked", &closed.map);
    }
}
