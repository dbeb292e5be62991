//! Every planner on random scenes with random settings.

use parkade::error::ErrorCode;
use parkade::plan::{Options, Outcome as Answer, Plan, Planner};
use parkade::planners::registry::{Parameter, planners as all};
use parkade::scenario::Scenario;
use serde_json::{Map, Value, json};

use crate::Outcome;
use crate::grid_model::GridModel;
use crate::random::Random;
use crate::random_scenes;
use crate::trajectories;

/// A planner's id, a scene, and settings for it.
pub(crate) struct Question {
    pub(crate) planner: &'static str,
    pub(crate) scene: Scenario,
    pub(crate) settings: Map<String, Value>,
    /// True if every setting is one that it may have.
    good: bool,
}

pub(crate) fn question(r: &mut Random, seed: u64) -> Question {
    let planners = all();
    let planner = r.pick(&planners);
    let scene = if r.one_in(3) { GridModel::random(r).scene() } else { random_scenes::scene(seed).0 };
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
    Question { planner: planner.id, scene, settings, good }
}

pub(crate) fn planners(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    let Question { planner, scene, settings, good } = question(r, seed);
    let wrong = |what: String| Err(format!("{planner} {settings:?}: {what}"));
    match Planner::new(planner, &scene, &settings) {
        Ok(_) if !good => wrong("taken".to_owned()),
        Ok(mut ready) => {
            answered(&ready.plan(Options { trace: r.one_in(4), ..Options::default() })).or_else(wrong)
        }
        Err(error) if good && error.path.is_empty() => wrong(format!("no field: {error}")),
        Err(error) if error.code == ErrorCode::Config => Ok("refused"),
        Err(error) => wrong(format!("{:?}: {error}", error.code)),
    }
}

/// A random question as JSON, with the hash of its plan or the error's words.
pub(crate) fn asked(seed: u64) -> Value {
    let Question { planner, scene, settings, .. } = question(&mut Random::new(seed), seed);
    answer(planner, &scene, &settings)
}

pub(crate) fn answer(planner: &str, scene: &Scenario, settings: &Map<String, Value>) -> Value {
    let question = json!({ "planner": planner, "scene": scene, "settings": settings });
    match Planner::new(planner, scene, settings) {
        Ok(mut ready) => with_answers(question, scene, &ready.plan(Options::default())),
        Err(error) => with(question, "answer", error.to_string()),
    }
}

/// The question with the hash of its plan and, where a car can drive that, of the trajectory that is made of it and of
/// its drive among the scene's boxes.
pub(crate) fn with_answers(question: Value, scene: &Scenario, plan: &Plan) -> Value {
    let mut question = with(question, "answer", plan.hash());
    if plan.metrics.hybrid.is_some() && plan.path.len() > 1 && plan.check.drivable() {
        for (field, answer) in ["trajectory", "encounter"].into_iter().zip(trajectories::hashes(scene, plan))
        {
            question = with(question, field, answer);
        }
    }
    question
}

fn with(mut question: Value, field: &str, answer: String) -> Value {
    question[field] = answer.into();
    question
}

/// A value, and whether it alone is one that the setting may have.
fn value(r: &mut Random, parameter: &Parameter) -> (Value, bool) {
    if r.one_in(12) {
        let wrong = [json!(-1_000_000_000_i64), json!(1e300), json!("?"), json!([]), json!({})];
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
