//! A planner whose map is brushed, against one that is made anew.

use parkade::plan::{Options, Planner};
use parkade::planners::registry::{Family, planners};
use serde_json::Map;

use crate::Outcome;
use crate::grid_model::GridModel;
use crate::random::Random;

pub(crate) fn edits(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    let field = GridModel::random(r);
    let all = planners();
    let id = loop {
        let info = r.pick(&all);
        if info.family != Family::Hybrid {
            break info.id;
        }
    };
    let mut brushed = Planner::new(id, &field.scene(), &Map::new()).map_err(|e| e.to_string())?;
    for step in 0..6 {
        let (x, y) = (r.below(field.width as usize) as u32, r.below(field.height as usize) as u32);
        let count = 1 + r.below((field.width as u32 - x) as usize) as u32;
        brushed.brush(&[[x, y, count]], r.one_in(2)).map_err(|e| e.to_string())?;
        if r.one_in(2) {
            continue;
        }
        let plan = brushed.plan(Options::default());
        let anew = Planner::new(id, brushed.scenario(), &Map::new())
            .map_err(|e| e.to_string())?
            .plan(Options::default());
        if plan.hash() != anew.hash() {
            return Err(format!(
                "{id}, stroke {step}: {:?} {}, anew {:?} {}",
                plan.outcome,
                plan.hash(),
                anew.outcome,
                anew.hash()
            ));
        }
    }
    Ok(id)
}
