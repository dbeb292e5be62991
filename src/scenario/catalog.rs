//! Built-in scenes: the page's presets, the parking paper's rows and the tight slots beyond it.
//!
//! A built-in scene is a function of its id: nothing is stored but the numbers that it is built from. Ids are stable,
//! because links, benchmarks and golden values name them. Each scene asks a question that its planners answer
//! differently; the question is told with the scene.
//!
//! Frame: metres, x east and y north. The parking scenes are bays below an aisle whose kerb lies at y = 5; grid
//! scenes have one metre per cell.
//!
//! The complete module has more scenes than `core`: those with moving boxes, with roads, and those of the papers'
//! figures.

use super::paper_lot::{PAPER_ROWS, lot, nose_in, paper_row, tail_in};
pub use super::scene_info::Info;
use super::scene_info::info;
use super::{Entry, Goal, Lean, Obstacle, Scenario, Slot, SlotGoal, SlotKind, VehicleSpec};
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::geometry::math::{FRAC_PI_2, FRAC_PI_4, PI};
use crate::scenario::generate::{Family, generate};

const PAPER_QUESTION: [&str; 2] = [
    "A row of the parking paper's tables: shorter, or with fewer gear changes?",
    "停车论文表格中的一行：能否更短、换挡更少？",
];

/// All built-in scenes, in the order of the page's menu.
/// The same scenes in the same order on every call; `core` lists the first 23 of them.
///
/// # Examples
/// ```
/// let ids: Vec<&str> = parkade::scenario::catalog::scenes().map(|scene| scene.id).collect();
/// assert_eq!(ids[..2], ["perpendicular", "reverse-in"]);
/// ```
pub fn scenes() -> impl Iterator<Item = &'static Info> {
    let mut all: Vec<_> = SCENES.iter().collect();
    if IS_COMPLETE {
        all.extend(&super::moving_scenes::SCENES);
        all.extend(&super::road_scenes::SCENES);
        all.extend(&super::figure_scenes::SCENES);
    }
    all.into_iter()
}

/// The scenes of both modules, by groups.
const SCENES: [Info; 23] = [
    info(
        "perpendicular",
        "parking",
        ["Perpendicular", "垂直车位"],
        ["Two planners hit something, one arrives turned: who parks?", "两种碰撞，一种朝向不符：谁能停好？"],
    ),
    info(
        "reverse-in",
        "parking",
        ["Perpendicular, reverse in", "垂直车位，倒车入库"],
        ["One gear change to face the aisle: who can make it?", "车头朝外须换挡一次：谁能做到？"],
    ),
    info(
        "parallel",
        "parking",
        ["Parallel", "侧方车位"],
        ["A bay of 20 m needs no gear change: who touches nothing?", "20 米车位无须换挡：谁不碰撞？"],
    ),
    info(
        "angled",
        "parking",
        ["Angled, 45°", "斜列车位，45°"],
        ["One move into an angled slot: whose turns suit the car?", "一把驶入斜列车位：谁的转弯适合该车？"],
    ),
    info(
        "narrow-gap",
        "parking",
        ["Narrow gap", "窄口"],
        ["The gap is 10 cm narrower than the car: who notices?", "缺口比车窄 10 厘米：谁能发现？"],
    ),
    info(
        "regular-60",
        "grid",
        ["Regular blocks", "规则障碍"],
        [
            "The risk field expands the fewest cells: can the car follow?",
            "风险场扩展的栅格最少：车能跟上吗？",
        ],
    ),
    info(
        "random-60",
        "grid",
        ["Random blocks", "随机障碍"],
        ["The shortest paths scrape the blocks: whose path is free?", "最短的路径擦碰障碍：谁的路径无碰？"],
    ),
    info(
        "trap-60",
        "grid",
        ["Traps", "陷阱"],
        ["Who searches the dead ends before going around them?", "谁先搜遍死胡同才绕行？"],
    ),
    info(
        "par-8.0",
        "tight",
        ["Parallel, 8.0 m", "侧方，8.0 m"],
        ["2.5 m longer than the car: how few gear changes?", "比车长 2.5 米：最少换挡几次？"],
    ),
    info(
        "par-7.2",
        "tight",
        ["Parallel, 7.2 m", "侧方，7.2 m"],
        ["1.7 m longer than the car: how many more gear changes?", "比车长 1.7 米：要多换挡几次？"],
    ),
    info(
        "par-6.6",
        "tight",
        ["Parallel, 6.6 m", "侧方，6.6 m"],
        ["Only 1.1 m longer than the car: is it enough?", "只比车长 1.1 米：够不够？"],
    ),
    info(
        "perp-tail-3.2",
        "tight",
        ["Reverse in, 3.2 m", "倒车入库，3.2 m"],
        ["0.3 m on each side: enough to back in?", "两侧各 0.3 米，能倒入吗？"],
    ),
    info(
        "perp-nose-3.2",
        "tight",
        ["Head in, 3.2 m", "车头入库，3.2 m"],
        ["0.3 m on each side: enough to drive in?", "两侧各 0.3 米，能驶入吗？"],
    ),
    info("P0", "paper", ["Paper row P0", "论文 P0"], PAPER_QUESTION),
    info("P1", "paper", ["Paper row P1", "论文 P1"], PAPER_QUESTION),
    info("P2", "paper", ["Paper row P2", "论文 P2"], PAPER_QUESTION),
    info("P3", "paper", ["Paper row P3", "论文 P3"], PAPER_QUESTION),
    info("P4", "paper", ["Paper row P4", "论文 P4"], PAPER_QUESTION),
    info("L0", "paper", ["Paper row L0", "论文 L0"], PAPER_QUESTION),
    info("L1", "paper", ["Paper row L1", "论文 L1"], PAPER_QUESTION),
    info("L2", "paper", ["Paper row L2", "论文 L2"], PAPER_QUESTION),
    info("L3", "paper", ["Paper row L3", "论文 L3"], PAPER_QUESTION),
    info("L4", "paper", ["Paper row L4", "论文 L4"], PAPER_QUESTION),
];

/// The built-in scene of this id. The road manuscript's scenes for its ship, ten times as large, are
/// `road-straight-ship`, `road-curve-ship`, `road-crossing-ship` and `road-narrow-ship`; no menu lists them.
///
/// # Errors
/// [`ErrorCode::UnknownScenario`].
///
/// # Examples
/// ```
/// use parkade::scenario::catalog::scenario;
///
/// assert_eq!(scenario("P0").unwrap().start.x, 22.0);
/// ```
pub fn scenario(id: &str) -> Result<Scenario, Error> {
    let mut scene = build(id).ok_or_else(|| {
        let known: Vec<_> = scenes().map(|s| s.id).collect();
        let message = message!("no scene \"{}\"; there are {}", id, known.join(", "));
        Error::new(ErrorCode::UnknownScenario, "", message)
    })?;
    scene.name = Some(id.to_owned());
    Ok(scene)
}

/// A scene without its name, or `None` for an unknown id.
fn build(id: &str) -> Option<Scenario> {
    if let Some(row) = paper_row(id) {
        return Some(row);
    }
    if IS_COMPLETE
        && let Some(scene) = super::moving_scenes::build(id)
            .or_else(|| super::road_scenes::build(id))
            .or_else(|| super::figure_scenes::build(id))
    {
        return Some(scene);
    }
    Some(match id {
        "perpendicular" => perpendicular(),
        "reverse-in" => reverse_in(),
        "parallel" => parallel(),
        "angled" => angled(),
        "narrow-gap" => narrow_gap(),
        "regular-60" => return generate(Family::Regular, 60, 7).ok(),
        "random-60" => return generate(Family::RANDOM, 60, 13).ok(),
        "trap-60" => return generate(Family::Trap, 60, 7).ok(),
        "par-8.0" => lot(-8.0, 0.0, 3.0, [10.0, 8.0, PI], [-2.25, 3.5, PI]),
        "par-7.2" => lot(-8.0, -0.8, 3.0, [10.0, 8.0, PI], [-2.65, 3.5, PI]),
        "par-6.6" => lot(-8.0, -1.4, 3.0, [10.0, 8.0, PI], [-2.95, 3.5, PI]),
        "perp-tail-3.2" => tail_in(3.2),
        "perp-nose-3.2" => nose_in(3.2),
        _ => return None,
    })
}

/// A row of perpendicular slots in the bay, south of the aisle, numbered from the west.
fn bay_slots(centers: &[f64], occupied: &[usize]) -> Vec<Slot> {
    let slot = |(i, &x): (usize, &f64)| Slot {
        id: Some(format!("slot-{}", i + 1)),
        kind: SlotKind::Perpendicular,
        x,
        y: 5.0,
        heading: -FRAC_PI_2,
        width: 2.8,
        length: 5.0,
        angle: None,
        lean: None,
        occupied: occupied.contains(&i),
    };
    centers.iter().enumerate().map(slot).collect()
}

/// A polygon with a name.
fn island(id: &str, points: &[[f64; 2]]) -> Obstacle {
    Obstacle::Polygon { id: Some(id.to_owned()), points: points.to_vec() }
}

/// A rectangle about its centre.
fn block(id: &str, center: [f64; 2], size: [f64; 2], heading: f64) -> Obstacle {
    Obstacle::Rectangle { id: Some(id.to_owned()), center, size, heading }
}

/// The page's first scene: of its planners four directions drive into the planter, eight into a parked car, the risk
/// field arrives tail-in, and hybrid A* parks with one gear change.
///
fn perpendicular() -> Scenario {
    let mut scene = lot(-7.25, 12.25, 6.25, [-7.125, 10.625, 29.0 * PI / 36.0], [0.0; 3]);
    scene.map.origin[0] = -14.0;
    (scene.map.width, scene.map.height) = (112, 66);
    for [x, y] in scene.map.boundary.iter_mut().flatten() {
        *x = x.clamp(-14.0, 14.0);
        *y = y.min(15.25);
    }
    scene.slots = bay_slots(&[-5.625, -2.375, 0.875, 4.125, 7.375, 10.625], &[0, 1, 3, 4]);
    for slot in &mut scene.slots {
        (slot.width, slot.length) = (3.25, 6.25);
    }
    scene.goal = Goal::Slot(SlotGoal { slot: "slot-3".to_owned(), entry: Entry::HeadIn });
    scene.obstacles = vec![
        island("planter", &[[-11.45, 7.65], [-9.05, 7.25], [-7.75, 8.35], [-8.45, 9.55], [-10.85, 9.45]]),
        block("kiosk", [3.25, 12.75], [4.2, 2.0], -0.25),
    ];
    scene
}

/// A row of perpendicular slots of 2.80 m; the car must leave it nose first.
fn reverse_in() -> Scenario {
    let mut scene = lot(-10.0, 10.0, 5.0, [14.0, 9.0, PI], [0.0; 3]);
    scene.slots = bay_slots(&[-8.5, -5.75, -3.0, -0.25, 2.5, 5.25, 8.0], &[0, 1, 3, 5]);
    scene.goal = Goal::Slot(SlotGoal { slot: "slot-5".to_owned(), entry: Entry::ReverseIn });
    scene.vehicle = VehicleSpec::Profile("sedan".to_owned());
    scene.obstacles = vec![
        island("planter", &[[-9.0, 14.2], [-5.6, 14.8], [-4.9, 12.7], [-7.0, 11.6], [-9.2, 12.3]]),
        block("kiosk", [8.0, 16.5], [4.4, 2.0], 0.3),
    ];
    scene
}

/// The paper's parallel bay, with row L0's start and goal and two obstacles in the aisle.
fn parallel() -> Scenario {
    let mut scene = lot(-10.0, 10.0, 5.0, PAPER_ROWS[5].1, PAPER_ROWS[5].2);
    scene.obstacles = vec![
        island("planter", &[[-14.0, 18.2], [-10.6, 18.8], [-9.9, 16.7], [-12.0, 15.6], [-14.2, 16.3]]),
        block("kiosk", [-2.0, 20.0], [5.0, 2.2], 0.35),
    ];
    scene
}

/// Seven slots at 45°, four of them occupied, on an aisle that is driven from the west.
fn angled() -> Scenario {
    let mut scene = lot(-10.0, 10.0, 5.0, [-18.0, 12.0, 0.0], [0.0; 3]);
    scene.map.boundary = None;
    let slot = |i: u32| Slot {
        id: Some(format!("slot-{}", i + 1)),
        kind: SlotKind::Angled,
        x: -10.0 + 3.96 * f64::from(i),
        y: 6.0,
        heading: -FRAC_PI_2,
        width: 2.8,
        length: 5.6,
        angle: Some(FRAC_PI_4),
        lean: Some(Lean::Left),
        occupied: [1, 2, 4, 5].contains(&i),
    };
    scene.slots = (0..7).map(slot).collect();
    scene.vehicle = VehicleSpec::Profile("sedan".to_owned());
    scene.goal = Goal::Slot(SlotGoal { slot: "slot-4".to_owned(), entry: Entry::HeadIn });
    scene.obstacles = vec![
        block("kiosk", [-4.0, 18.0], [6.0, 2.0], 0.0),
        island("planter", &[[9.0, 17.5], [12.4, 18.1], [13.1, 16.0], [11.0, 14.9], [8.8, 15.6]]),
    ];
    scene
}

/// A wall with a gap of 2.50 m; the car is 2.60 m wide.
fn narrow_gap() -> Scenario {
    let mut scene = lot(-10.0, 10.0, 5.0, [-15.0, 15.0, 0.0], [8.0, 15.0, 0.0]);
    scene.map.boundary = None;
    scene.obstacles = vec![
        block("wall south", [0.0, 6.875], [1.0, 13.75], 0.0),
        block("wall north", [0.0, 23.125], [1.0, 13.75], 0.0),
    ];
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_is_listed_and_valid() {
        for info in scenes() {
            let scene = scenario(info.id).unwrap();
            assert!(scene.geometry().is_ok(), "{}", info.id);
        }
    }

    #[test]
    fn an_unknown_scene_is_named() {
        let error = scenario("moon").unwrap_err();
        assert_eq!(error.code, ErrorCode::UnknownScenario);
        assert!(error.message().starts_with("no scene \"moon\"; there are perpendicular"));
    }
}
