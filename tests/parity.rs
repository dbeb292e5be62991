//! Every planner's plan on every preset has the hash in `data/plan-hashes.json`, here natively and in wasm; the same
//! file is held by the tests of the built package in Node and of the page in a browser.

use parkade::plan::{Options, Planner};
use parkade::scenario::catalog;
use serde_json::{Map, Value};

fn expected() -> Map<String, Value> {
    let all: Value = serde_json::from_str(include_str!("data/plan-hashes.json")).unwrap();
    all.as_object().cloned().unwrap()
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn plans_have_the_same_hash_everywhere() {
    let expected = expected();
    assert_eq!(expected.len(), 8);
    for (id, hashes) in expected {
        let scene = catalog::scenario(&id).unwrap();
        for (planner, hash) in hashes.as_object().unwrap() {
            let mut session = Planner::new(planner, &scene, &Map::new()).unwrap();
            let plan = session.plan(Options::default());
            assert_eq!(hash.as_str(), Some(plan.hash().as_str()), "{planner} on {id}");
            let again = session.plan(Options { trace: true, ..Options::default() });
            assert_eq!(again.hash(), plan.hash(), "{planner} on {id}, a second time and traced");
            assert_eq!(plan.check.clearances.len(), plan.path.len());
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn random_scenes_are_answered_the_same_everywhere() {
    let expected: Vec<String> = serde_json::from_str(include_str!("data/random-scene-hashes.json")).unwrap();
    assert_eq!(expected.len(), 40);
    for (seed, hash) in (0..).zip(expected) {
        assert_eq!(crate::random_scenes::plan(seed).hash(), hash, "seed {seed}");
    }
}
