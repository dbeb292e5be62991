//! The fewest gear changes: what `prefer` finds against the best of many single searches.

use std::ops::ControlFlow;

use parkade::geometry::arcs;
use parkade::planners::hybrid::{Config, Prefer, Query, Scratch, SearchFrom, choices, plan};

use crate::answer::Answer;
use crate::members::LEVELS;
use crate::tight_scenes::Scene;
use crate::{Kind, Run, clock};

/// Lattices besides the planner's levels: cells in metres, heading bins in degrees, steps in metres.
const OTHERS: [(f64, f64, f64, u32, f64); 2] = [(0.06, 0.75, 0.1, 1, 2.0), (0.04, 0.6, 0.1, 1, 2.0)];
const MARGINS: [f64; 3] = [0.1, 0.03, 0.01];
/// Cost of a gear change in a single search, metres: what the planner's fine levels have.
const CHANGE_COST: f64 = 3.0;
const EXPANSIONS: u32 = 60_000;

/// Prints how often a single search finds fewer changes than `prefer`, and how often `prefer` takes more than the
/// ordinary answer, which must not be.
pub(crate) fn print(run: &Run, kinds: &[Kind], cars: &[crate::Car]) {
    let [mut count, mut lost, mut worse, mut saved, mut most, mut many] = [0_u32; 6];
    let (mut spent, mut first_spent) = (0.0, 0.0);
    for (at, (_, car)) in cars.iter().enumerate() {
        for seed in run.seeds.clone().filter(|seed| *seed as usize % cars.len() == at) {
            for &(_, make) in kinds {
                let scene = make(car, seed);
                let Some([first, fewest, time, all]) = preferred(&scene, &run.config) else { continue };
                let (first, fewest) = (first as u32, fewest as u32);
                (spent, first_spent) = (spent + all, first_spent + time);
                let best = best(&scene, fewest);
                count += 1;
                saved += first - first.min(fewest);
                worse += u32::from(fewest > first);
                many += u32::from(first > fewest + 2);
                if run.is_verbose {
                    println!("{}, seed {seed}: {fewest} of {first}", scene.name);
                }
                if let Some((changes, who)) = best {
                    lost += 1;
                    most = most.max(fewest - changes);
                    println!("{}, seed {seed}: {fewest} of {first}; {who}: {changes}", scene.name);
                }
            }
        }
    }
    println!(
        "{count} answers: {saved} changes saved, more than two in {many}; more than the ordinary answer {worse} times; \
         a single search takes fewer {lost} times, by {most} at most; {:.0} ms a scene, the ordinary answer {:.0} ms",
        spent / f64::from(count.max(1)),
        first_spent / f64::from(count.max(1))
    );
}

/// Changes of the ordinary answer and of the one with the fewest, and the milliseconds of both.
fn preferred(scene: &Scene, config: &Config) -> Option<[f64; 4]> {
    let Scene { vehicle, obstacles, start, goal, .. } = scene;
    let query = Query { obstacles, vehicle, start: *start, goal: *goal };
    let mut scratch = Scratch::default();
    let begin = clock::now();
    let first = plan(&query, config, &mut scratch, false, &mut None);
    let time = clock::now() - begin;
    if first.arcs.is_empty() {
        return None;
    }
    let changes = arcs::direction_changes(&first.arcs);
    let mut fewest = changes;
    let mut offer = |report: parkade::planners::hybrid::Report| {
        fewest = fewest.min(arcs::direction_changes(&report.arcs));
        ControlFlow::Continue(())
    };
    choices(
        &query,
        (config, &[]),
        (&first, Some(Prefer::FewestChanges)),
        (&mut scratch, &mut None),
        &mut offer,
    );
    let all = clock::now() - begin;
    Some([f64::from(changes), f64::from(fewest), time, all])
}

/// The single search with fewer changes than these, and with the fewest of all.
fn best(scene: &Scene, known: u32) -> Option<(u32, String)> {
    let mut best = (known, String::new());
    for margin in MARGINS {
        for search_from in [SearchFrom::Goal, SearchFrom::Start] {
            for (xy, degrees, step, steers, weight) in LEVELS.into_iter().chain(OTHERS) {
                if best.0 == 0 {
                    break;
                }
                let config = Config {
                    search_from,
                    margin,
                    xy_resolution: Some(xy),
                    heading_resolution: Some(degrees.to_radians()),
                    motion_primitive_length: Some(step),
                    steer_samples: Some(steers),
                    heuristic_weight: Some(weight),
                    direction_change_cost: CHANGE_COST,
                    ladder: false,
                    max_expansions: Some(EXPANSIONS),
                    ..Config::default()
                };
                let alone = Answer::of(scene, &config);
                if alone.is_solved() && alone.changes < best.0 {
                    let end = if search_from == SearchFrom::Goal { "goal" } else { "start" };
                    let who = format!(
                        "from the {end} at {xy} m with {margin} m ({} expansions, {} checks)",
                        alone.expanded, alone.checks
                    );
                    best = (alone.changes, who);
                }
            }
        }
    }
    (best.0 < known).then_some(best)
}
