//! Scenes in which something crosses the car's way: the parking paper's figure 16 and what it takes to make it wait.
//!
//! A box that crosses matters only if it and the car are at the same place at the same time. On the shortest path
//! through the figure's scene they are not; the other scenes change the box's way or its speed so that they are.
//!
//! All of them are row L0 of the parking paper with one box of 5 m by 1 m.

use super::paper_lot::paper_row;
use super::scene_info::{Info, info};
use super::{MovingObstacle, Scenario};

/// The scenes in the order of the page's menu.
pub(super) const SCENES: [Info; 5] = [
    info(
        "fig16",
        "moving",
        ["Figure 16 of the paper", "论文图 16"],
        [
            "The paper waits for this box. Does a shorter path have to?",
            "论文在此等待该障碍物。更短的路径还需要等吗？",
        ],
    ),
    info(
        "fig16-conflict",
        "moving",
        ["Box across the way", "横穿的障碍物"],
        ["A box crosses at 2 m/s: where is it safe to wait?", "障碍物以 2 m/s 横穿：在哪里等待才安全？"],
    ),
    info(
        "fig16-oncoming",
        "moving",
        ["Box beside the start", "起点旁的障碍物"],
        ["A box passes 4 m from the start: can the car set off?", "障碍物从起点旁 4 米处驶过：能否起步？"],
    ),
    info(
        "fig16-fast",
        "moving",
        ["Oncoming box, 4 m/s", "迎面而来的障碍物，4 m/s"],
        ["A box twice as fast: why is this wait the longest?", "障碍物快一倍：为何等待反而最久？"],
    ),
    info(
        "fig16-low",
        "moving",
        ["Box near the slot", "车位旁的障碍物"],
        ["A box crosses near the slot: why is this wait the shortest?", "障碍物在车位旁横穿：为何等待最短？"],
    ),
];

/// From x, to x, y and speed of each scene's box.
const BOXES: [(&str, [f64; 4]); 5] = [
    ("fig16", [-20.0, 5.0, 15.0, 2.0]),
    ("fig16-conflict", [25.0, -20.0, 12.0, 2.0]),
    ("fig16-oncoming", [25.0, -20.0, 15.0, 2.0]),
    ("fig16-fast", [-20.0, 25.0, 12.0, 4.0]),
    ("fig16-low", [25.0, -20.0, 10.0, 2.0]),
];

/// The scene of an id; `None` for ids of other groups.
pub(super) fn build(id: &str) -> Option<Scenario> {
    let (_, [from, to, y, speed]) = BOXES.into_iter().find(|b| b.0 == id)?;
    let mut scene = paper_row("L0")?;
    scene.moving = vec![MovingObstacle {
        id: Some("box".to_owned()),
        points: vec![[from, y], [to, y]],
        size: [5.0, 1.0],
        speed,
        start: 0.0,
    }];
    Some(scene)
}
