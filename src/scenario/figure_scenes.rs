//! Scenes of the papers' figures and the widths of tight bays that the other groups leave out.
//!
//! The figures show scenes that the papers do not publish as data. Where a text states numbers, the scene has them;
//! maps of cells are seeded ones of the same kind and size. Ratios and shapes can therefore be compared with a
//! figure, lengths cannot.
//!
//! The tight bays are those of the catalogue at other widths: the paper's car is 2.60 m wide, so a bay of 3.0 m
//! leaves 0.2 m on either side and one of 3.6 m leaves 0.5 m.

use super::generate::{Family, generate};
use super::paper_lot::{nose_in, paper_row, tail_in};
use super::scene_info::{Info, info};
use super::{MapFrame, MovingObstacle, Obstacle, Scenario};

/// The scenes in the order of the page's menu.
pub(super) const SCENES: [Info; 13] = [
    info(
        "perp-tail-3.6",
        "tight",
        ["Reverse in, 3.6 m", "倒车入库，3.6 m"],
        ["0.5 m on each side: does one gear change do?", "两侧各 0.5 米，换挡一次够吗？"],
    ),
    info(
        "perp-tail-3.0",
        "tight",
        ["Reverse in, 3.0 m", "倒车入库，3.0 m"],
        ["0.2 m on each side: can it still back in?", "两侧各 0.2 米，还能倒入吗？"],
    ),
    info(
        "perp-nose-3.6",
        "tight",
        ["Head in, 3.6 m", "车头入库，3.6 m"],
        ["0.5 m on each side: how far does it swing out?", "两侧各 0.5 米，要绕开多远？"],
    ),
    info(
        "perp-nose-3.0",
        "tight",
        ["Head in, 3.0 m", "车头入库，3.0 m"],
        ["0.2 m on each side: can it still drive in?", "两侧各 0.2 米，还能驶入吗？"],
    ),
    info(
        "park-free",
        "figures",
        ["Figure 12: no obstacles", "图 12：无障碍"],
        [
            "The parking paper's figure 12 has no walls: is its path the shortest?",
            "停车论文图 12 没有墙：其路径是否最短？",
        ],
    ),
    info(
        "park-fig13",
        "figures",
        ["Figure 13: one obstacle", "图 13：一个障碍物"],
        [
            "The parking paper's figure 13 adds an obstacle: does the path change?",
            "停车论文图 13 增加了障碍物：路径会变吗？",
        ],
    ),
    info(
        "fig16-wait",
        "moving",
        ["Figure 16: stop, wait, go", "图 16：停车、等待、通行"],
        [
            "A barrier leads the way through the box's strip: where does the car wait?",
            "路障使路径穿过移动障碍的区间：车在哪里等？",
        ],
    ),
    info(
        "fig8-30",
        "figures",
        ["Figure 8: regular, 30 × 30", "图 8：规则障碍，30 × 30"],
        [
            "Safety space closes gaps: how many nodes does each planner need?",
            "安全空间封闭窄缝：各需多少节点？",
        ],
    ),
    info(
        "fig8-60",
        "figures",
        ["Figure 8: regular, 60 × 60", "图 8：规则障碍，60 × 60"],
        ["Twice as wide: do the nodes double, too?", "边长加倍：节点也加倍吗？"],
    ),
    info(
        "fig8-100",
        "figures",
        ["Figure 8: regular, 100 × 100", "图 8：规则障碍，100 × 100"],
        ["The largest regular map: whose nodes grow slowest?", "最大的规则地图：谁的节点增长最慢？"],
    ),
    info(
        "fig9-30",
        "figures",
        ["Figure 9: random, 30 × 30", "图 9：随机障碍，30 × 30"],
        ["Random blocks with safety space: who stays short?", "随机障碍加安全空间：谁的路径短？"],
    ),
    info(
        "fig9-60",
        "figures",
        ["Figure 9: random, 60 × 60", "图 9：随机障碍，60 × 60"],
        ["Which corners become arcs among random blocks?", "随机障碍之间，哪些拐角变成圆弧？"],
    ),
    info(
        "fig9-100",
        "figures",
        ["Figure 9: random, 100 × 100", "图 9：随机障碍，100 × 100"],
        ["The largest random map: what does the risk field save?", "最大的随机地图：风险场节省多少？"],
    ),
];

/// The barrier of `fig16-wait`. The paper's path of 41.8 m runs through the strip that the box sweeps, the shortest
/// path of 30 m does not. The barrier forces a way around its west end, which crosses the strip away from where the box
/// stops.
const BARRIER: [[f64; 2]; 4] = [[2.0, 15.8], [25.0, 15.8], [25.0, 16.8], [2.0, 16.8]];

/// The scene of an id; `None` for ids of other groups.
pub(super) fn build(id: &str) -> Option<Scenario> {
    Some(match id {
        "perp-tail-3.6" => tail_in(3.6),
        "perp-tail-3.0" => tail_in(3.0),
        "perp-nose-3.6" => nose_in(3.6),
        "perp-nose-3.0" => nose_in(3.0),
        "park-free" => without_walls(paper_row("P0")?),
        "park-fig13" => {
            let mut scene = paper_row("P0")?;
            scene.obstacles = vec![polygon("box", [[11.0, 8.5], [13.0, 8.5], [13.0, 10.5], [11.0, 10.5]])];
            scene
        }
        "fig16-wait" => {
            let mut scene = paper_row("L0")?;
            scene.obstacles = vec![polygon("barrier", BARRIER)];
            scene.moving = vec![MovingObstacle {
                id: Some("box".to_owned()),
                points: vec![[-20.0, 15.0], [5.0, 15.0]],
                size: [5.0, 1.0],
                speed: 2.0,
                start: 0.0,
            }];
            scene
        }
        "fig8-30" => return seeded(Family::Regular, 30, 1),
        "fig8-60" => return seeded(Family::Regular, 60, 7),
        "fig8-100" => return seeded(Family::Regular, 100, 42),
        "fig9-30" => return seeded(Family::RANDOM, 30, 9),
        "fig9-60" => return seeded(Family::RANDOM, 60, 13),
        "fig9-100" => return seeded(Family::RANDOM, 100, 42),
        _ => return None,
    })
}

/// An obstacle of four corners.
fn polygon(id: &str, points: [[f64; 2]; 4]) -> Obstacle {
    Obstacle::Polygon { id: Some(id.to_owned()), points: points.to_vec() }
}

/// The same question where nothing stands and the ground goes on for ten metres beyond the paper's walls.
fn without_walls(mut scene: Scenario) -> Scenario {
    scene.map =
        MapFrame { origin: [-35.0, -10.0], width: 280, height: 200, resolution: 0.25, boundary: None };
    scene
}

/// A map of the risk-field paper's kind with its safety space, necessary and redundant, for the planners of its
/// figures.
fn seeded(family: Family, size: u32, seed: u64) -> Option<Scenario> {
    let mut scene = generate(family, size, seed).ok()?;
    let space = serde_json::json!({ "inflation": "width", "margin": 0.2, "minPassage": 2, "trapMouth": 5 });
    let space = space.as_object().cloned().unwrap_or_default();
    for planner in ["four", "eight", "risk-field"] {
        scene.planners.insert(planner.to_owned(), space.clone());
    }
    Some(scene)
}

#[cfg(test)]
mod tests {
    use super::super::catalog::{scenario, scenes};
    use super::*;
    use crate::geometry::Point;
    use crate::geometry::math::{FRAC_PI_2, PI};
    use crate::plan::{LayerData, Options, Outcome, Planner};

    /// Every scene that the papers' specification names, where its car starts and ends, and how long the best known
    /// path is.
    const NAMED: [(&str, [f64; 3], [f64; 3]); 21] = [
        ("P0", [22.0, 8.19, PI], [2.5, 5.0, -FRAC_PI_2]),
        ("P1", [24.0, 8.4, PI], [2.5, 5.0, -FRAC_PI_2]),
        ("P2", [-20.0, 14.5, PI], [-7.0, 5.0, -FRAC_PI_2]),
        ("P3", [16.0, 18.0, PI], [-2.0, 5.0, -FRAC_PI_2]),
        ("P4", [-16.0, 7.5, PI], [7.0, 5.0, -FRAC_PI_2]),
        ("L0", [20.0, 19.06, PI], [-3.0, 2.0, PI]),
        ("L1", [18.0, 15.7, PI], [-3.0, 2.0, PI]),
        ("L2", [16.0, 14.7, PI], [2.0, 2.0, PI]),
        ("L3", [19.0, 15.5, PI], [-4.0, 3.0, PI]),
        ("L4", [-8.0, 14.2, PI], [7.0, 3.0, PI]),
        ("park-free", [22.0, 8.19, PI], [2.5, 5.0, -FRAC_PI_2]),
        ("park-fig13", [22.0, 8.19, PI], [2.5, 5.0, -FRAC_PI_2]),
        ("par-8.0", [10.0, 8.0, PI], [-2.25, 3.5, PI]),
        ("par-7.2", [10.0, 8.0, PI], [-2.65, 3.5, PI]),
        ("par-6.6", [10.0, 8.0, PI], [-2.95, 3.5, PI]),
        ("perp-tail-3.6", [16.0, 9.0, PI], [1.8, 0.4, FRAC_PI_2]),
        ("perp-tail-3.2", [16.0, 9.0, PI], [1.6, 0.4, FRAC_PI_2]),
        ("perp-tail-3.0", [16.0, 9.0, PI], [1.5, 0.4, FRAC_PI_2]),
        ("perp-nose-3.6", [16.0, 9.0, PI], [1.8, 3.9, -FRAC_PI_2]),
        ("perp-nose-3.2", [16.0, 9.0, PI], [1.6, 3.9, -FRAC_PI_2]),
        ("perp-nose-3.0", [16.0, 9.0, PI], [1.5, 3.9, -FRAC_PI_2]),
    ];

    #[test]
    fn every_scene_of_the_specification_is_listed_by_name() {
        for (id, start, goal) in NAMED {
            let scene = scenario(id).unwrap();
            let super::super::Goal::Pose(end) = scene.goal else { panic!("{id}") };
            for (pose, [x, y, heading]) in [(scene.start, start), (end, goal)] {
                assert_eq!((pose.x, pose.y, pose.heading), (x, y, heading), "{id}");
            }
        }
        let moving = ["fig16", "fig16-conflict", "fig16-oncoming", "fig16-fast", "fig16-low", "fig16-wait"];
        let roads = ["road-straight", "road-curve", "road-crossing", "road-narrow"];
        let grids = ["fig8-30", "fig8-60", "fig8-100", "fig9-30", "fig9-60", "fig9-100"];
        let named = NAMED.iter().map(|row| row.0).chain(moving).chain(roads).chain(grids);
        for id in named {
            assert!(scenes().any(|info| info.id == id), "{id} is in no menu");
        }
    }

    /// Length and gear changes.
    fn driven(planner: &str, scene: &Scenario) -> (f64, u32) {
        let settings = serde_json::json!({ "profile": "shortest" });
        let mut planner = Planner::new(planner, scene, settings.as_object().unwrap()).unwrap();
        let metrics = planner.plan(Options::default()).metrics;
        (metrics.length, metrics.direction_changes)
    }

    #[test]
    fn paths_of_figures_8_and_9_keep_out_of_both_safety_spaces() {
        let mut kinds = [0; 4];
        for id in ["fig8-30", "fig8-60", "fig8-100", "fig9-30", "fig9-60", "fig9-100"] {
            let scene = scenario(id).unwrap();
            for planner in ["four", "eight", "risk-field"] {
                let mut planner = Planner::new(planner, &scene, &serde_json::Map::new()).unwrap();
                let LayerData::Bytes(space) = planner.layer("redundant", 1).unwrap().data else { panic!() };
                for &kind in &space {
                    kinds[usize::from(kind)] += 1;
                }
                let plan = planner.plan(Options::default());
                assert!(plan.outcome == Outcome::Found && plan.raw_path.len() > 14, "{id}");
                // A cell is a metre, and the first one's centre is the origin.
                let cell = |p: &Point| (p.y.round() * f64::from(scene.map.width) + p.x.round()) as usize;
                assert!(plan.raw_path.iter().all(|p| space[cell(p)] == 0), "{id}");
            }
        }
        assert!(kinds.iter().all(|&count| count > 3000), "{kinds:?}");
    }

    #[test]
    fn figure_12_is_the_free_optimum_and_figure_13_goes_around_its_obstacle() {
        let (free, changes) = driven("hybrid", &scenario("park-free").unwrap());
        assert!((free - 22.768).abs() < 1e-3 && changes == 0, "{free}, {changes} changes");
        let (around, changes) = driven("hybrid", &scenario("park-fig13").unwrap());
        assert!((23.5..=23.82 * 1.02).contains(&around) && changes == 0, "{around}, {changes} changes");
    }

    #[test]
    fn the_ring_of_ground_without_walls_holds_the_free_path() {
        let scene = scenario("park-free").unwrap();
        assert!(scene.obstacles.is_empty() && scene.map.boundary.is_none());
        let plan = Planner::new("hybrid", &scene, &serde_json::Map::new()).unwrap().plan(Options::default());
        let [x, y] = scene.map.origin;
        assert!(plan.path.iter().all(|p| p.x > x + 10.0 && p.y > y + 5.0), "the border is near");
    }
}
