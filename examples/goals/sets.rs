//! What a set of goals costs against the goal that is taken, planned for alone: lots by seed with ten free slots,
//! each of which may be entered either way.

use parkade::plan::{Ends, Options, Plan, Planner};
use parkade::scenario::GoalPose;
use serde_json::Map;

use crate::clock;
use crate::lots::lot;

/// Slots of each lot that are free.
const FREE: usize = 10;
/// The clock of a thread may be a few milliseconds late: so long is measured at least.
const LEAST_MILLIS: f64 = 60.0;

/// One lot's answer.
#[derive(Clone, Copy)]
struct Measured {
    seed: u64,
    /// Milliseconds of the processor, for the set and for the goal taken alone, by planners that know nothing yet …
    millis: [f64; 2],
    /// … and by planners that have answered the same before.
    again: [f64; 2],
    /// Collision checks of the same, …
    checks: [u32; 2],
    /// … and expansions.
    expanded: [u32; 2],
    /// Cost of the path against the cheapest of all goals planned for one by one, …
    share: f64,
    /// … and against that of the goal taken.
    own_share: f64,
    margin: f64,
}

/// Prints quantiles over so many lots; with `verbose` a line a lot.
pub(crate) fn print(count: u64, first: u64, is_verbose: bool) {
    let mut lots: Vec<Measured> = (first..first + count).filter_map(measure).collect();
    if is_verbose {
        for one in &lots {
            let [set, alone] = one.millis;
            println!(
                "lot {}: {set:.2} ms, alone {alone:.2} ms, {:.2} times, again {:.2} times; checks {:?}; expanded {:?}; \
                 cost {:.3}; margin {:.3} m",
                one.seed,
                set / alone,
                one.again[0] / one.again[1],
                one.checks,
                one.expanded,
                one.share,
                one.margin
            );
        }
    }
    let near = lots.iter().filter(|one| one.share <= 1.05).count();
    let dearest = lots.iter().map(|one| one.own_share).fold(0.0, f64::max);
    println!(
        "{} of {count} lots from seed {first}; within 5 % of the cheapest: {near}; cost against the goal taken, alone, \
         at most {dearest:.3}",
        lots.len()
    );
    print_quantiles("the first time", &mut lots, |one| one.millis);
    print_quantiles("again", &mut lots, |one| one.again);
}

fn print_quantiles(what: &str, lots: &mut [Measured], millis: impl Fn(&Measured) -> [f64; 2]) {
    let ratio = |one: &Measured| millis(one)[0] / millis(one)[1];
    lots.sort_by(|a, b| ratio(a).total_cmp(&ratio(b)));
    let at = |share: f64| lots[((lots.len() - 1) as f64 * share).round() as usize];
    let [p50, p90, max] = [0.5, 0.9, 1.0].map(|share| ratio(&at(share)));
    let [set, alone] =
        [0, 1].map(|which| lots.iter().map(|one| millis(one)[which]).sum::<f64>() / lots.len() as f64);
    println!(
        "time against the goal taken, alone, {what}: p50 {p50:.2}, p90 {p90:.2}, max {max:.2}; set {set:.2} ms, alone \
         {alone:.2} ms a lot, {:.2} times",
        set / alone
    );
}

fn measure(seed: u64) -> Option<Measured> {
    let scene = lot(seed, FREE);
    let fresh = || Planner::new("hybrid", &scene, &Map::new()).expect("a valid lot");
    let plan = once(&mut fresh(), None).0;
    let taken = plan.goal.as_ref()?;
    let own = once(&mut fresh(), Some(taken)).0;
    let goals = scene.geometry().expect("a valid lot").goals.expect("a set of goals").poses;
    let costs = goals.iter().map(|goal| cost(&once(&mut fresh(), Some(goal)).0));
    let cheapest = costs.fold(cost(&own), f64::min);
    let questions = [None, Some(taken)];
    let counted = |count: fn(&Plan) -> u32| [&plan, &own].map(count);
    Some(Measured {
        seed,
        millis: questions.map(|goal| mean(|| once(&mut fresh(), goal).1)),
        again: questions.map(|goal| {
            let mut planner = fresh();
            once(&mut planner, goal);
            mean(|| once(&mut planner, goal).1)
        }),
        checks: counted(|plan| plan.stats.collision_checks.unwrap_or(0)),
        expanded: counted(|plan| plan.stats.expanded),
        share: cost(&plan) / cheapest,
        own_share: cost(&plan) / cost(&own),
        margin: plan.metrics.hybrid.as_ref().map_or(f64::NAN, |hybrid| hybrid.margin),
    })
}

fn cost(plan: &Plan) -> f64 {
    plan.metrics.hybrid.as_ref().map_or(f64::INFINITY, |hybrid| hybrid.cost)
}

/// The mean of as many runs as the clock needs.
fn mean(mut run: impl FnMut() -> f64) -> f64 {
    let (mut sum, mut runs) = (0.0, 0.0);
    while sum < LEAST_MILLIS {
        sum += run();
        runs += 1.0;
    }
    sum / runs
}

/// A plan and how long it takes, milliseconds.
fn once(planner: &mut Planner, goal: Option<&GoalPose>) -> (Plan, f64) {
    let ends = Ends { start: None, goal: goal.map(|goal| goal.pose) };
    let begin = clock::now();
    let plan = planner.plan_between(ends, Options::default()).expect("a pose of the lot");
    (plan, clock::now() - begin)
}
