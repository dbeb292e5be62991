//! What bounds the work.

use parkade::geometry::arcs;
use parkade::planners::Obstruction;
use parkade::planners::hybrid::{Config, Report, SearchFrom, Status};

use super::lot::Lot;

/// A corridor of so many metres, hardly wider than the car, behind a yard with a block in the middle of the way. From
/// before the block, connections are free down to the block: each takes thousands of checks for nothing.
fn corridor(far: f64) -> Lot {
    let floor = vec![[0.0, 0.0], [far, 0.0], [far, 3.0], [60.0, 3.0], [60.0, 12.0], [0.0, 12.0]];
    let lot = Lot { floor, solids: Vec::new(), start: [4.0, 1.5, 0.0], goal: [far - 6.0, 1.5, 0.0] };
    lot.with(&[[25.0, 0.0], [26.0, 0.0], [26.0, 3.0], [25.0, 3.0]])
}

fn plan(lot: &Lot, expansions: u32) -> Report {
    lot.plan(&Config {
        ladder: false,
        shortcut: false,
        search_from: SearchFrom::Start,
        max_expansions: Some(expansions),
        ..Config::default()
    })
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn long_connections_take_a_million_checks_and_a_thousand_each() {
    let lot = corridor(1_000_000.0);
    // 1 955 000 without a limit.
    let spent = plan(&lot, 40);
    assert!((1_250_000..1_450_000).contains(&spent.collision_checks), "{}", spent.collision_checks);
    assert_eq!((spent.stats.expanded, spent.arcs.len()), (40, 0));
    assert!(matches!(spent.status, Status::BudgetExhausted(left) if left > 999_900.0), "{:?}", spent.status);
    assert!(matches!(spent.obstruction, Some(Obstruction::Nearest { at, .. }) if at.x > 20.0 && at.x < 60.0));
    // With more expansions the search goes round the block and on, until a connection is worth its checks again.
    let lot = corridor(50_000.0);
    let found = plan(&lot, 150);
    assert!(found.status.is_found(), "{:?}", found.status);
    assert!((49_990.0..50_000.0).contains(&arcs::length(&found.arcs)), "{}", arcs::length(&found.arcs));
    lot.check_every("beyond the limit", &found.arcs, 0.5);
}
