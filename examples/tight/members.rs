//! Single searches with a far larger budget than the planner's own: what they solve, it should solve.

use parkade::planners::hybrid::{Config, SearchFrom};

use crate::answer::Answer;
use crate::tight_scenes::Scene;

/// Twenty times the expansions of one of the planner's fine levels.
const BUDGET: u32 = 20 * 60_000;

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
