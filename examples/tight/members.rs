//! Single searches: with a far larger budget than the planner's own, which should solve what they solve, and with no
//! more work than it took, which tell how much of that the best of them needs.

use parkade::planners::hybrid::{Config, SearchFrom};

use crate::answer::Answer;
use crate::tight_scenes::Scene;

/// Twenty times the expansions of one of the planner's fine levels.
const BUDGET: u32 = 20 * 60_000;

/// Cells in metres; heading bins in degrees; steps in metres; steering angles per side; weight: the planner's levels.
pub(crate) const LEVELS: [(f64, f64, f64, u32, f64); 5] = [
    (0.5, 5.0, 0.8, 2, 1.0),
    (0.15, 2.0, 0.25, 1, 2.0),
    (0.1, 1.0, 0.15, 1, 2.0),
    (0.07, 0.6, 0.1, 1, 2.0),
    (0.05, 0.5, 0.06, 1, 2.0),
];

/// Name; cells in metres; heading bins in degrees; steps and margin in metres.
const MEMBERS: [(&str, SearchFrom, f64, f64, f64, f64); 4] = [
    ("from the goal at 0.1 m with 5 mm", SearchFrom::Goal, 0.1, 1.0, 0.15, 0.005),
    ("from the start at 0.1 m with 5 mm", SearchFrom::Start, 0.1, 1.0, 0.15, 0.005),
    ("from the goal at 0.06 m with 3 cm", SearchFrom::Goal, 0.06, 0.75, 0.1, 0.03),
    ("from the start at 0.06 m with 3 cm", SearchFrom::Start, 0.06, 0.75, 0.1, 0.03),
];

/// The first of these searches that finds a path.
pub(crate) fn solver(scene: &Scene) -> Option<(&'static str, Answer)> {
    let answers = MEMBERS.into_iter().map(|(name, search_from, xy, degrees, step, margin)| {
        let config = Config {
            search_from,
            margin,
            xy_resolution: Some(xy),
            heading_resolution: Some(degrees.to_radians()),
            motion_primitive_length: Some(step),
            steer_samples: Some(1),
            heuristic_weight: Some(2.0),
            ladder: false,
            max_expansions: Some(BUDGET),
            ..Config::default()
        };
        (name, Answer::of(scene, &config))
    });
    answers.into_iter().find(|(_, answer)| answer.is_solved())
}

/// Collision checks of the planner for each of the best single search that finds a path with as much margin; 1 where
/// none finds one with as many expansions. A search ends after as many as the best one so far took.
pub(crate) fn work(scene: &Scene, answer: &Answer) -> f64 {
    let (mut least, mut most) = (answer.checks, answer.expanded.max(1));
    for (xy, degrees, step, steers, weight) in LEVELS {
        for search_from in [SearchFrom::Goal, SearchFrom::Start, SearchFrom::Both] {
            let config = Config {
                search_from,
                margin: answer.margin,
                xy_resolution: Some(xy),
                heading_resolution: Some(degrees.to_radians()),
                motion_primitive_length: Some(step),
                steer_samples: Some(steers),
                heuristic_weight: Some(weight),
                ladder: false,
                max_expansions: Some(most),
                ..Config::default()
            };
            let alone = Answer::of(scene, &config);
            if alone.is_solved() && alone.margin >= answer.margin {
                least = least.min(alone.checks);
                most = most.min(alone.expanded.max(1));
            }
        }
    }
    f64::from(answer.checks) / f64::from(least.max(1))
}
