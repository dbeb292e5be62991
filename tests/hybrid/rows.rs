//! The parking paper's rows.

use parkade::planners::hybrid::{Config, Profile, SearchFrom};

use super::lot::Lot;

/// Reeds–Shepp bound, and what must be reached: metres, direction changes.
pub(super) const MUST_REACH: [(&str, f64, f64, u32); 10] = [
    ("P0", 22.69, 22.80, 0),
    ("P1", 24.66, 24.75, 0),
    ("P2", 22.10, 22.20, 1),
    ("P3", 23.20, 23.25, 0),
    ("P4", 27.21, 27.30, 1),
    ("L0", 29.20, 30.10, 0),
    ("L1", 25.50, 26.30, 0),
    ("L2", 19.97, 24.80, 1),
    ("L3", 26.44, 26.50, 0),
    ("L4", 19.38, 19.45, 0),
];

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_papers_rows_are_reached() {
    for (id, bound, length, changes) in MUST_REACH {
        let (got, got_changes, report) = Lot::of(id).solve(id, &Config::default());
        println!("{id}: {got:.2} m, {got_changes} changes, {} expansions", report.stats.expanded);
        assert!(got <= length && got_changes <= changes, "{id}: {got} m, {got_changes} changes");
        assert!((report.rs_bound - bound).abs() < 0.005, "{id}: bound {}", report.rs_bound);
        assert_eq!(report.margin, if id == "P1" { 0.0 } else { 0.1 }, "{id}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_papers_rows_are_reached_from_the_start_too() {
    let config = Config { search_from: SearchFrom::Start, ..Config::default() };
    for id in ["P0", "P3", "L3", "L4"] {
        Lot::of(id).solve(id, &config);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn two_trees_reach_the_papers_rows() {
    for (id, _, length, changes) in MUST_REACH {
        let (got, got_changes, report) = Lot::of(id).solve(id, &Config::bidirectional());
        println!("{id}: {got:.2} m, {got_changes} changes, {} expansions", report.stats.expanded);
        assert!(got <= length * 1.05 && got_changes <= changes, "{id}: {got} m, {got_changes} changes");
    }
    let boxed = Lot::of("par-6.6");
    let report = boxed.plan(&Config { finest_level: 4, ..Config::bidirectional() });
    assert!(report.arcs.is_empty(), "{:?}", report.status);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_classic_planner_is_as_poor_as_its_forerunner() {
    let rows = [("P0", 22.77, 0), ("P1", 24.72, 0), ("P3", 23.20, 0), ("L3", 26.44, 0), ("L4", 19.38, 0)];
    for (id, length, changes) in rows {
        let (got, got_changes, _) = Lot::of(id).solve(id, &Config::classic());
        assert!(
            (got - length).abs() < 0.01 && got_changes == changes,
            "{id}: {got} m, {got_changes} changes"
        );
    }
    for (id, length) in [("P2", 23.14), ("P4", 27.35), ("L0", 36.6), ("L1", 32.0), ("L2", 37.3)] {
        let (got, got_changes, _) = Lot::of(id).solve(id, &Config::classic());
        println!("{id}: {got:.2} m, {got_changes} changes; {length} m measured before");
        assert!(got >= length * 0.8 && got <= length * 1.35, "{id}: {got} m");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn comfort_keeps_away_from_walls() {
    let config = Config { profile: Profile::Comfort, ..Config::default() };
    for (id, length, clear) in [("P4", 27.8, 0.3), ("L2", 26.0, 0.18)] {
        let lot = Lot::of(id);
        let (got, changes, report) = lot.solve(id, &config);
        let clearance = lot.clearance(&report.arcs);
        println!("{id}: {got:.2} m, {changes} changes, {clearance:.2} m clear");
        assert!(
            got <= length && changes <= 1 && clearance >= clear,
            "{id}: {got} m, {changes}, {clearance} m"
        );
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_box_in_the_aisle_is_passed() {
    let lot = Lot::of("P0").with(&[[11.0, 8.5], [13.0, 8.5], [13.0, 10.5], [11.0, 10.5]]);
    let (length, changes, _) = lot.solve("box", &Config::default());
    assert!(length <= 23.9 && changes == 0, "{length} {changes}");
}
