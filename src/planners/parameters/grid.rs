//! Settings of the grid planners.

use super::{EXPANSIONS, Form, Row, row};

/// The heuristics: of four neighbours, of eight, of more.
pub(in crate::planners) const GRID_HEURISTICS: [Row; 3] = [
    row(
        "heuristic",
        Form::Choice(&["manhattan", "euclid", "octile"]),
        "1",
        false,
        ["Heuristic", "启发函数"],
        ["The paper's baseline uses Manhattan.", "论文基线为曼哈顿距离。"],
    ),
    row(
        "heuristic",
        Form::Choice(&["euclid", "octile"]),
        "1",
        true,
        ["Heuristic", "启发函数"],
        ["Octile is exact on an empty map, so it expands less.", "空地图上八方距离精确，扩展更少。"],
    ),
    row(
        "heuristic",
        Form::Choice(&["euclid", "gauge"]),
        "1",
        false,
        ["Heuristic", "启发函数"],
        ["The gauge is exact on an empty map for these moves.", "对这些移动，规范距离在空地图上精确。"],
    ),
];

/// Settings of the search from both ends alone.
#[cfg(feature = "complete")]
pub(in crate::planners) const BIDIRECTIONAL: [Row; 2] = [
    row(
        "neighbours",
        Form::Choice(&["four", "eight", "sixteen", "twenty-four", "forty-eight"]),
        "1",
        true,
        ["Neighbours", "邻域"],
        ["Cells reachable in one step.", "一步可达的格子。"],
    ),
    row(
        "stop",
        Form::Choice(&["first", "best", "nba"]),
        "1",
        true,
        ["Stop", "停止规则"],
        [
            "First: where the two meet (the paper); best: the best connection until then; nba: the cheapest path.",
            "first：相遇即停（论文）；best：其间最佳连接；nba：最短路径。",
        ],
    ),
];

/// Settings of jump point search alone.
#[cfg(feature = "complete")]
pub(in crate::planners) const JUMP_POINT: [Row; 1] = [row(
    "prune",
    Form::Flag,
    "1",
    false,
    ["Skip free turns", "跳过自由转折"],
    [
        "Expands only cells where an obstacle forces a turn: the same cost from fewer expansions.",
        "只扩展被障碍迫使转向的格子：代价相同，扩展更少。",
    ],
)];

/// Settings of every grid planner; the first is not one of the risk field's.
pub(in crate::planners) const GRID: &[Row] = &[
    row(
        "weight",
        Form::Choice(&["none", "distance"]),
        "1",
        true,
        ["Dynamic weight", "动态权重"],
        ["Faster far from the goal, but not optimal.", "远离目标时加速，放弃最优性。"],
    ),
    row(
        "corner",
        Form::Choice(&["strict", "no-squeeze", "free"]),
        "1",
        false,
        ["Corners", "转角规则"],
        ["Strict: a path may not touch a blocked cell.", "严格：路径不得触碰障碍格。"],
    ),
    row(
        "inflation",
        Form::Choice(&["none", "width", "half-diagonal"]),
        "1",
        true,
        ["Safety space", "安全空间"],
        [
            "Keeps the path this far from obstacles: nothing, half the car's width, half its diagonal.",
            "与障碍保持的距离：零、半车宽或半对角线。",
        ],
    ),
    row(
        "margin",
        Form::Number(0.0, 2.0, 0.05),
        "m",
        true,
        ["Extra margin", "额外余量"],
        ["Added to the safety space.", "加在安全空间之外。"],
    ),
    #[cfg(feature = "complete")]
    row(
        "minPassage",
        Form::Integer(1.0, 8.0),
        "cells",
        false,
        ["Narrowest passage", "最窄通道"],
        [
            "Closes passages narrower than this many cells; 1 closes none. Start and goal stay connected.",
            "封闭窄于此格数的通道；1 为不封闭。起终点保持连通。",
        ],
    ),
    #[cfg(feature = "complete")]
    row(
        "trapMouth",
        Form::Integer(1.0, 16.0),
        "cells",
        false,
        ["Pockets", "陷阱填充"],
        [
            "Closes dead ends into which no square of this many cells fits; 1 closes none.",
            "封闭容不下此边长方块的死胡同；1 为不封闭。",
        ],
    ),
    row(
        "post",
        Form::Choice(&["none", "prune", "prune-dp", "smooth"]),
        "1",
        true,
        ["Post-processing", "后处理"],
        ["Removes spare cells; rounds corners.", "删去多余格点；圆滑转角。"],
    ),
    row(
        "smoothMode",
        Form::Choice(&["dynamic", "paper"]),
        "1",
        false,
        ["Smoothing", "平滑方式"],
        [
            "Dynamic shrinks an arc until it is free; the paper tries once.",
            "动态：缩小圆弧直至无碰；论文：只试一次。",
        ],
    ),
    row(
        "minRadius",
        Form::NumberOr(0.0, 40.0, 0.5, &["vehicle"]),
        "cells",
        true,
        ["Smallest arc", "最小圆弧"],
        [
            "Arcs tighter than this stay corners; \"vehicle\" is the car's own limit.",
            "更小的圆弧保留为折角；vehicle 为车辆极限。",
        ],
    ),
    EXPANSIONS,
];

/// Settings of the risk field alone.
pub(in crate::planners) const RISK: [Row; 14] = [
    row(
        "w1",
        Form::Number(0.5, 4.0, 0.1),
        "1",
        true,
        ["Weight w1", "权重 w1"],
        ["Of the longer axis distance to the goal.", "到目标较长轴向距离的权重。"],
    ),
    row(
        "w2",
        Form::Number(0.5, 4.0, 0.1),
        "1",
        true,
        ["Weight w2", "权重 w2"],
        ["Of the shorter one.", "较短轴向距离的权重。"],
    ),
    row(
        "wbar",
        Form::Number(0.0, 4.0, 0.1),
        "1",
        false,
        ["Dynamic weight", "动态权重"],
        [
            "How strongly goal distance speeds up the search; paper: 1.",
            "目标距离对搜索的加速程度；论文取 1。",
        ],
    ),
    row(
        "heuristic",
        Form::Choice(&["corrected", "printed", "octile"]),
        "1",
        false,
        ["Heuristic", "启发函数"],
        ["Corrected removes the printed formula's jump.", "修正式消除论文公式的跳变。"],
    ),
    row(
        "k1",
        Form::Number(0.1, 10.0, 0.1),
        "1",
        false,
        ["Attraction k1", "引力 k1"],
        ["Attraction gain.", "目标引力增益。"],
    ),
    row(
        "rho0",
        Form::Number(1.0, 10.0, 0.5),
        "cells",
        true,
        ["Reach of the field", "斥力范围"],
        ["Obstacles farther away do not repel.", "更远的障碍不产生斥力。"],
    ),
    row(
        "k2",
        Form::Number(0.0, 1000.0, 0.5),
        "cells",
        false,
        ["Repulsion k2", "斥力 k2"],
        ["Repulsion gain; empty: half of k1 times the distance.", "障碍斥力增益；空：k1 × 距离之半。"],
    ),
    row(
        "attraction",
        Form::Choice(&["linear", "conic"]),
        "1",
        false,
        ["Attraction law", "引力形式"],
        ["Linear grows with the distance (the paper).", "线性随距离增大（论文）。"],
    ),
    row(
        "obstacleSet",
        Form::Choice(&["nearest-mean", "nearest-first", "sum"]),
        "1",
        false,
        ["Repelling cells", "斥力来源"],
        ["The nearest, or all within reach.", "最近的障碍格，或范围内全部。"],
    ),
    row(
        "extLen",
        Form::Integer(0.0, 16.0),
        "cells",
        false,
        ["Extension", "扩展长度"],
        ["How far diagonal moves may be stretched.", "斜向移动可延伸的格数。"],
    ),
    row(
        "goalSide",
        Form::Flag,
        "1",
        false,
        ["Goal side only", "仅目标侧"],
        ["Drops extensions that lead away from the goal.", "去除背离目标的延伸格。"],
    ),
    row(
        "fallback",
        Form::Choice(&["penalty", "lexicographic", "stuck-only", "none"]),
        "1",
        false,
        ["Deferred moves", "延后扩展"],
        [
            "When the other five directions are tried; none: as in the paper, may get stuck.",
            "其余五方向何时尝试；none 为论文原式，可能卡住。",
        ],
    ),
    row(
        "penalty",
        Form::Number(0.0, 40.0, 1.0),
        "cells",
        false,
        ["Deferral cost", "延后代价"],
        ["Cost added to deferred moves.", "延后扩展附加的代价。"],
    ),
    row(
        "goalShot",
        Form::Flag,
        "1",
        false,
        ["Direct finish", "直达目标"],
        ["Finishes as soon as the goal is in sight.", "目标可见即完成。"],
    ),
];
