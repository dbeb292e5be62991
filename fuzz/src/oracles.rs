//! Grid planners against plain searches and against themselves on changed maps.

use parkade::plan::{Found, Options, Outcome as Answer, Planner};
use serde_json::{Map, Value, json};

use crate::Outcome;
use crate::grid_model::{Cell, GridModel, moves, price};
use crate::random::Random;

/// A neighbourhood's planner, its name as a setting, and its moves.
const NEIGHBOURHOODS: [(&str, i32, bool); 5] = [
    ("four", 0, false),
    ("eight", 1, false),
    ("sixteen", 2, true),
    ("twenty-four", 2, false),
    ("forty-eight", 3, false),
];

/// Metres from the rear axle of the car "paper" to its middle.
const MIDDLE: f64 = 1.75;

pub(crate) fn grid(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    let field = GridModel::random(r);
    let &(id, reach, knights) = r.pick(&NEIGHBOURHOODS);
    let legal = moves(reach, knights);
    let cheapest = field.dijkstra(&legal);
    if cheapest.is_some() != field.connected() {
        return Err("the oracles disagree on whether there is a path".to_owned());
    }

    let cost = optimal(&field, id, &json!({}), &legal, cheapest)?;
    for stop in ["nba", "best", "first", "naive"] {
        let settings = json!({ "neighbours": id, "stop": stop });
        let found = search(&field, "sixteen-bidirectional", &settings)?;
        walked(&field, &found, Some(&legal))?;
        let wrong = match (cheapest, found.outcome) {
            (Some(cheapest), Answer::Found) => {
                if stop == "nba" {
                    found.cost_micro != cheapest
                } else {
                    found.cost_micro < cheapest
                }
            }
            (None, answer) => answer == Answer::Found,
            // The one rule that may miss a path.
            (Some(_), _) => stop != "naive",
        };
        if wrong {
            return Err(format!("{id} from both sides, {stop}: {found:?}, Dijkstra {cheapest:?}"));
        }
    }
    if id == "eight" {
        for prune in [true, false] {
            optimal(&field, "jump-point", &json!({ "prune": prune }), &legal, cheapest)?;
        }
        optimal(&field, "eight", &json!({ "heuristic": "octile" }), &legal, cheapest)?;
    }
    changed(r, &field, id, cost)?;
    other(r, &field)
}

/// A planner that promises the cheapest path.
fn optimal(
    field: &GridModel,
    id: &str,
    settings: &Value,
    legal: &[Cell],
    cheapest: Option<i64>,
) -> Result<Option<i64>, String> {
    let found = search(field, id, settings)?;
    let steps = (id != "jump-point").then_some(legal);
    walked(field, &found, steps)?;
    let cost = (found.outcome == Answer::Found).then_some(found.cost_micro);
    if cost == cheapest {
        return Ok(cost);
    }
    Err(format!("{id} {settings}: {:?} {cost:?}, Dijkstra {cheapest:?}", found.outcome))
}

/// The same question on a map that is reversed, moved, turned or filled further.
fn changed(r: &mut Random, field: &GridModel, id: &str, cost: Option<i64>) -> Result<(), String> {
    let costs = |field: &GridModel| {
        search(field, id, &json!({}))
            .map(|found| (found.outcome == Answer::Found).then_some(found.cost_micro))
    };
    for (what, other) in
        [("reversed", field.reversed()), ("moved", field.moved(1e6)), ("turned", field.turned())]
    {
        let other = costs(&other)?;
        if other != cost {
            return Err(format!("{id}: {cost:?}, but {other:?} {what}"));
        }
    }
    let mut filled = field.clone();
    for _ in 0..4 {
        filled.set((r.below(field.width as usize) as i32, r.below(field.height as usize) as i32), true);
    }
    let filled = costs(&filled)?;
    match (cost, filled) {
        (None, Some(_)) => Err(format!("{id}: a path only when there is more in the way")),
        (Some(before), Some(after)) if after < before => {
            Err(format!("{id}: {before}, but {after} with more in the way"))
        }
        _ => Ok(()),
    }
}

/// The planners that promise no cheapest path.
fn other(r: &mut Random, field: &GridModel) -> Outcome {
    let id = *r.pick(&["any-angle", "risk-field", "risk-field-plus", "cost-map"]);
    let mut planner = Planner::new(id, &field.scene(), &Map::new()).map_err(|e| e.to_string())?;
    let plan = planner.plan(Options::default());
    let found = plan.outcome == Answer::Found;
    if !found && plan.reason.as_ref().is_none_or(|reason| reason.len() < 10) {
        return Err(format!("{id}: {:?} without a reason", plan.outcome));
    }
    // The planner for roads leads the middle of the car, the others its rear axle.
    let led = if id == "cost-map" { field.ahead(MIDDLE) } else { field.clone() };
    if found && !led.connected() {
        return Err(format!("{id}: a path where there is none"));
    }
    if id == "any-angle" {
        if found != field.connected() {
            return Err(format!("{id}: {:?}", plan.outcome));
        }
        let bare = search(field, id, &json!({}))?;
        walked(field, &bare, None)?;
        if let Some(bound) = planner.any_angle_length() {
            let length: f64 = bare.path.windows(2).map(|ends| (ends[1] - ends[0]).norm()).sum();
            // The yardstick's paths turn beside convex corners only, which on small crowded maps costs up to a
            // hundredth.
            if length < 0.99 * bound {
                return Err(format!("any-angle: {length} is below the yardstick's {bound}"));
            }
        }
    }
    Ok(plan.outcome.as_str())
}

fn search(field: &GridModel, id: &str, settings: &Value) -> Result<Found, String> {
    let settings = settings.as_object().cloned().unwrap_or_default();
    let scene = field.scene();
    let mut planner = Planner::new(id, &scene, &settings).map_err(|e| e.to_string())?;
    let (start, goal) = (planner.geometry().start.point(), planner.geometry().goal.point());
    planner.search(start, goal).map_err(|e| e.to_string())
}

/// Walks a path again: from start to goal, every step a legal one, and as dear as it says.
fn walked(field: &GridModel, found: &Found, legal: Option<&[Cell]>) -> Result<(), String> {
    if found.outcome != Answer::Found {
        return if found.path.is_empty() { Ok(()) } else { Err(format!("a path with {:?}", found.outcome)) };
    }
    let cells: Vec<Cell> = found.path.iter().map(|point| field.cell(point.x, point.y)).collect();
    if cells.first() != Some(&field.start) || cells.last() != Some(&field.goal) {
        return Err(format!("{cells:?} does not lead from {:?} to {:?}", field.start, field.goal));
    }
    let mut cost = 0;
    for ends in cells.windows(2) {
        let step = (ends[1].0 - ends[0].0, ends[1].1 - ends[0].1);
        if legal.is_some_and(|legal| !legal.contains(&step)) {
            return Err(format!("{step:?} is no move"));
        }
        if !field.sees(ends[0], ends[1]) {
            return Err(format!("{:?} to {:?} touches a blocked cell", ends[0], ends[1]));
        }
        cost += price(step);
    }
    if legal.is_some() && cost != found.cost_micro {
        return Err(format!("the path costs {cost}, not {}", found.cost_micro));
    }
    Ok(())
}
