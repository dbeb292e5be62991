//! Settings of hybrid A*.

use super::{EXPANSIONS, Form, Row, row};

/// Settings of hybrid A*.
pub(super) const HYBRID: [Row; 19] = [
    row("margin", Form::Number(0.0, 0.5, 0.05), "m", true, ["Safety margin", "安全余量"], ["Kept free around the whole car.", "车身四周保持的空隙。"]),
    row("maxDirectionChanges", Form::Integer(0.0, 5.0), "1", true, ["Gear changes", "换挡次数"], ["Longer chains of switches are not tried.", "更长的换挡序列不再尝试。"]),
    row("motionPrimitiveLength", Form::Number(0.1, 4.0, 0.1), "m", true, ["Primitive length", "基元长度"], ["Short steps fit tight slots but take longer.", "短步适合窄位，但更慢。"]),
    row("headingResolution", Form::Number(0.01, 0.35, 0.01), "rad", true, ["Heading bins", "航向分格"], ["Closer headings count as one state.", "更接近的航向视为同一状态。"]),
    row("directionChangeCost", Form::Number(0.0, 10.0, 0.5), "m", true, ["Gear-change cost", "换挡代价"], ["The detour one switch is worth.", "一次换挡相当的绕行。"]),
    row("searchFrom", Form::Choice(&["goal", "start"]), "1", true, ["Search from", "搜索起点"], ["Leaving a slot is easier than finding it.", "驶出车位比驶入更易搜索。"]),
    row("reverseCost", Form::Number(1.0, 5.0, 0.1), "1", true, ["Reverse cost", "倒车代价"], ["How much a metre in reverse weighs.", "倒车一米的权重。"]),
    row("xyResolution", Form::Number(0.05, 2.0, 0.05), "m", false, ["Position cells", "位置分格"], ["Closer positions count as one state.", "更接近的位置视为同一状态。"]),
    row("steerSamples", Form::Integer(1.0, 10.0), "1", false, ["Steering angles", "转角采样"], ["Per side, besides straight.", "每侧的采样数，直行除外。"]),
    row("heuristic", Form::Choice(&["max", "reeds-shepp", "euclid"]), "1", false, ["Heuristic", "启发函数"], ["Max: the larger of the free-space curve and the way around obstacles.", "max：自由曲线与绕障路程取大者。"]),
    row("heuristicWeight", Form::Number(0.5, 5.0, 0.1), "1", false, ["Heuristic weight", "启发权重"], ["Above 1: faster, not always cheapest.", "大于 1：更快，但未必最优。"]),
    row("steerCost", Form::Number(0.0, 5.0, 0.1), "1", false, ["Steering cost", "转向代价"], ["How much turning weighs.", "转弯的权重。"]),
    row("steerChangeCost", Form::Number(0.0, 5.0, 0.1), "m", false, ["Steering-change cost", "转角变化代价"], ["How much moving the wheel weighs.", "打方向的权重。"]),
    row("obstacleCost", Form::Number(0.0, 10.0, 0.5), "1", false, ["Obstacle cost", "近障代价"], ["How much driving close to obstacles weighs.", "贴近障碍行驶的权重。"]),
    row("obstacleDistance", Form::Number(0.1, 3.0, 0.1), "m", false, ["Obstacle distance", "近障距离"], ["Where that cost begins.", "该代价开始的距离。"]),
    row("shortcut", Form::Flag, "1", false, ["Shortcut", "捷径"], ["Replaces stretches by shorter curves afterwards.", "事后以更短曲线替换路段。"]),
    row("firstShot", Form::Flag, "1", false, ["First connection", "首次连接即止"], ["Stops at the first way found, as the paper does.", "找到第一条路即停，如论文所述。"]),
    row("ladder", Form::Flag, "1", false, ["Finer levels", "逐级细化"], ["Tries finer steps when the coarse ones find nothing.", "粗步无解时尝试更细的步长。"]),
    EXPANSIONS,
];
