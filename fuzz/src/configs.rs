//! Every planner on random scenes with random settings.

use parkade::error::ErrorCode;
use parkade::plan::{Options, Outcome as Answer, Plan, Planner};
use parkade::planners::registry::{Parameter, planners as all};
use serde_json::{Map, Value, json};

use crate::Outcome;
use crate::field::Field;
use crate::random::Random;
use crate::strewn;

pub(crate) fn planners(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    let planners = all();
    let planner = r.pick(&planners);
    let scene = if r.one_in(3) { Field::random(r).scene() } else { strewn::scene(seed).0 };
    let mut settings = Map::new();
    let mut good = true;
    for parameter in &planner.parameters {
        if parameter.name != "maxExpansions" && r.one_in(2) {
            let (value, fits) = value(r, parameter);
            good &= fits;
            settings.insert(parameter.name.to_owned(), value);
        }
    }
    settings.insert("maxExpansions".to_owned(), (1 + r.below(400)).into());
    match Planner::new(planner.id, &scene, &settings) {
        Ok(_) if !good => Err(format!("{} took {settings:?}", planner.id)),
        Ok(mut ready) => answered(&ready.plan(Options { trace: r.one_in(4) }))
            .map_err(|e| format!("{} {settings:?}: {e}", planner.id)),
        Err(error) if good && error.path.is_empty() => {
            Err(format!("{} {settings:?}: no field: {error}", planner.id))
        }
        Err(error) if error.code == ErrorCode::Config => Ok("refused"),
        Err(error) => Err(format!("{} {settings:?}: {:?}: {error}", planner.id, error.code)),
    }
}

/// A value, and whether it alone is one that the setting may have.
fn value(r: &mut Random, parameter: &Parameter) -> (Value, bool) {
    if r.one_in(12) {
        let wrong = [json!(-1e9), json!(1e300), json!("?"), json!([]), json!({})];
        return (r.pick(&wrong).clone(), false);
    }
    let (low, high) = (parameter.min.unwrap_or(0.0), parameter.max.unwrap_or(1.0));
    let value = match parameter.kind {
        "number" => json!(r.between(low, high)),
        "integer" => json!(r.between(low, (high + 1.0).min(low + 2000.0)).floor().min(high) as i64),
        "boolean" => json!(r.one_in(2)),
        _ => json!(*r.pick(parameter.choices)),
    };
    (value, true)
}

/// An answer that says what it found, or why it found nothing.
pub(crate) fn answered(plan: &Plan) -> Outcome {
    let found = plan.outcome == Answer::Found;
    if !found && plan.reason.as_ref().is_none_or(|reason| reason.len() < 10) {
        return Err(format!("{:?} without a reason", plan.outcome));
    }
    if found == plan.path.is_empty() {
        return Err(format!("{:?} with {} poses", plan.outcome, plan.path.len()));
    }
    if found && !(plan.metrics.length.is_finite() && plan.metrics.length >= 0.0) {
        return Err(format!("a path of {} m", plan.metrics.length));
    }
    Ok(plan.outcome.as_str())
}
