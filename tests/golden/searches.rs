//! Costs and counters of the searches, lengths of what is made of their paths.

use parkade::map::{Bits, Corner};
use parkade::metrics::any_angle_length;
use parkade::metrics::grid::length;
use parkade::planners::Outcome;
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::Neighbourhood;
use parkade::planners::query::{GridScratch, Query};
use parkade::planners::{any_angle, bidirectional, jump_point, risk_field};
use parkade::post::SmoothMode;
use parkade::post::{prune, prune_dp, smooth};
use parkade::search::Stop;

use super::maps;

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn grid_searches_count_and_cost_the_same() {
    let planners = [
        ("a4_manhattan", "a4", Neighbourhood::Four, Heuristic::Manhattan),
        ("a8_euclid", "a8", Neighbourhood::Eight, Heuristic::Euclid),
        ("a8_octile", "a8", Neighbourhood::Eight, Heuristic::Octile),
        ("a16", "a16", Neighbourhood::Sixteen, Heuristic::Gauge),
        ("a24", "a24", Neighbourhood::TwentyFour, Heuristic::Gauge),
        ("a48", "a48", Neighbourhood::FortyEight, Heuristic::Gauge),
    ];
    for golden in maps() {
        for (name, cost, neighbourhood, heuristic) in planners {
            let report = golden.astar(neighbourhood, heuristic);
            golden.equal(&format!("/optimal_cost_micro/{cost}"), report.cost_micro);
            golden.equal(&format!("/expanded/{name}"), report.stats.expanded);
            if !matches!(name, "a24" | "a48") {
                golden.equal(&format!("/generated/{name}"), report.stats.generated);
            }
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn searches_from_both_ends_cost_the_same() {
    for golden in maps() {
        for (name, stop) in [("nba", Stop::Optimal), ("first", Stop::First), ("best", Stop::Best)] {
            let config = bidirectional::Config { stop, ..bidirectional::Config::default() };
            let report = bidirectional::plan(golden.query(), &config, &mut GridScratch::new(), &mut ());
            assert_eq!(report.outcome, Outcome::Found);
            golden.equal(&format!("/bidirectional16_cost_micro/{name}"), report.cost_micro);
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn jump_points_expand_the_same() {
    for golden in maps() {
        for prune in [false, true] {
            let config = jump_point::Config { prune, ..jump_point::Config::default() };
            let bits = Bits::new(&golden.map);
            let report = jump_point::plan(golden.query(), &bits, &config, &mut GridScratch::new(), &mut ());
            golden.equal("/optimal_cost_micro/a8", report.cost_micro);
            if !prune {
                golden.equal("/jps_expanded", report.stats.expanded);
            }
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn any_angle_paths_are_as_long() {
    for golden in maps() {
        let config = any_angle::Config::default();
        let report = any_angle::plan(golden.query(), &config, &mut GridScratch::new(), &mut ());
        golden.near("/theta_star_length", length(&report.cells));
        let Query { map, start, goal } = golden.query();
        golden.near("/yardstick_L_aa", any_angle_length(map, start, goal).unwrap());
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn risk_searches_count_and_cost_the_same() {
    let planners = [("risk", risk_field::Config::PAPER), ("risk_plus", risk_field::Config::PLUS)];
    for golden in maps() {
        for (name, config) in planners {
            config.validate().unwrap();
            let report = risk_field::plan(golden.query(), &config, &mut GridScratch::new(), &mut ());
            assert_eq!(report.outcome, Outcome::Found);
            golden.equal(&format!("/{name}/cost_micro"), report.cost_micro);
            golden.equal(&format!("/{name}/expanded"), report.stats.expanded);
            golden.equal(&format!("/{name}/generated"), report.stats.generated);
            if name == "risk" {
                golden.equal("/risk/deferred", report.deferred);
            }
            let shortest = prune_dp(&golden.map, &report.cells, Corner::Strict);
            golden.near(&format!("/{name}/length_dp"), length(&shortest));
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn pruned_and_smoothed_paths_are_as_long() {
    for golden in maps() {
        let eight = golden.astar(Neighbourhood::Eight, Heuristic::Euclid);
        let pruned = prune(&golden.map, &eight.cells, Corner::Strict);
        golden.near("/a8_euclid_length_pruned", length(&pruned));

        let config = risk_field::Config::PAPER;
        let risk = risk_field::plan(golden.query(), &config, &mut GridScratch::new(), &mut ());
        let pruned = prune(&golden.map, &risk.cells, Corner::Strict);
        golden.near("/risk/length_pruned", length(&pruned));

        let dynamic = smooth(&golden.map, &pruned, 1.0, SmoothMode::Dynamic);
        golden.near("/risk_smoothed/dynamic_rmin1/length", dynamic.length);
        golden.near("/risk_smoothed/dynamic_rmin1/min_radius", dynamic.min_radius.unwrap());
        golden.equal("/risk_smoothed/dynamic_rmin1/arcs", dynamic.arcs);
        golden.equal("/risk_smoothed/dynamic_rmin1/sharp", dynamic.sharp);
        let paper = smooth(&golden.map, &pruned, 0.0, SmoothMode::Paper);
        golden.near("/risk_smoothed/paper_mode_rmin0/length", paper.length);
        golden.equal("/risk_smoothed/paper_mode_rmin0/arcs", paper.arcs);
    }
}
