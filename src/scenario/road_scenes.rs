//! The road scenes: a lane, a curve, a crossing, a narrow road, a roundabout, a junction with a turn ban. Every
//! road goes on for 5 m before the start and beyond the goal, so that the car stands on it.
//!
//! S1 to S4 are the manuscript's scenes at a car's scale: lengths, widths and obstacles are its numbers, where it
//! states them. The roundabout and the junction are this crate's and ask what S1 to S4 do not: whether lanes are kept
//! that are not the shortest way.
//!
//! Coordinates of starts, goals and lanes are places of the car's *middle*, as the planner for roads counts them;
//! `scene` moves the poses back to the rear axle. The map's boundary is the kerb, and a lattice of half a metre lies
//! over it.

use serde_json::json;

use super::road::{Lane, LanePiece, SpeedLimit};
use super::scene_info::{Info, info};
use super::{Goal, MapFrame, Obstacle, Scenario, VehicleSpec};
use crate::geometry::Pose;
use crate::geometry::math::{FRAC_PI_2, PI, asin, sin_cos};
use crate::vehicle::Vehicle;

/// The scenes in the order of the page's menu.
pub(super) const SCENES: [Info; 6] = [
    info(
        "road-straight",
        "road",
        ["Straight lane, 1 km", "直线车道，1 公里"],
        ["Nothing stands in this lane: who searches the least?", "车道上没有障碍：谁搜索得最少？"],
    ),
    info(
        "road-curve",
        "road",
        ["Two-way curve", "双向弯道"],
        [
            "Two bends, a parked car and a box: who stays on the road?",
            "两个弯、一辆停车和一个箱子：谁不驶出道路？",
        ],
    ),
    info(
        "road-crossing",
        "road",
        ["Left turn at a crossing", "路口左转"],
        ["Five barriers around a left turn: who passes them all?", "左转前后五道路障：谁能全部绕过？"],
    ),
    info(
        "road-narrow",
        "road",
        ["Narrow road, eight obstacles", "窄路，八个障碍物"],
        [
            "Each obstacle leaves 3.5 m of road: who weaves through?",
            "每个障碍物旁只剩 3.5 米：谁能蛇行通过？",
        ],
    ),
    info(
        "road-roundabout",
        "road",
        ["Roundabout, third exit", "环岛，第三出口"],
        [
            "The ring may only be driven counter-clockwise: who finds the third exit?",
            "环岛只能逆时针行驶：谁能找到第三出口？",
        ],
    ),
    info(
        "road-turn-ban",
        "road",
        ["Junction without left turns", "禁止左转的路口"],
        [
            "Left turns are banned: who turns right and back around the median?",
            "禁止左转：谁会先右转，再绕过中央隔离带掉头？",
        ],
    ),
];

/// How far a road goes on before the start and beyond the goal, metres; ten cells.
const RUN_OUT: f64 = 5.0;
/// Side of a cell, metres: the manuscript's lattice.
const RESOLUTION: f64 = 0.5;
/// The manuscript's ship has cells of 5 m.
const SHIP_SCALE: f64 = 10.0;

/// The scene of an id; `None` for ids of other groups. S1 to S4 with the ship have names, too, but are in no menu.
pub(super) fn build(id: &str) -> Option<Scenario> {
    match id {
        "road-straight" => Some(straight()),
        "road-curve" => Some(curve()),
        "road-crossing" => Some(crossing()),
        "road-narrow" => Some(narrow()),
        "road-roundabout" => Some(roundabout()),
        "road-turn-ban" => Some(turn_ban()),
        "road-straight-ship" => Some(ship(straight())),
        "road-curve-ship" => Some(ship(curve())),
        "road-crossing-ship" => Some(ship(crossing())),
        "road-narrow-ship" => Some(ship(narrow())),
        _ => None,
    }
}

/// Ten times a scene, with the manuscript's ship on it, and its planner with the manuscript's costs.
/// The ship's middle takes the place of the car's middle, so that the same lanes and clearances are compared at
/// another scale.
fn ship(mut scene: Scenario) -> Scenario {
    let scale = |value: f64| value * SHIP_SCALE;
    let point = |p: [f64; 2]| p.map(scale);
    let (car, ship) = (Vehicle::SEDAN, Vehicle::SHIP);
    let pose = |pose: Pose| {
        let middle = pose.advance(0.0, car.middle());
        Pose::new(scale(middle.x), scale(middle.y), pose.heading).advance(0.0, -ship.middle())
    };
    scene.map.origin = point(scene.map.origin);
    scene.map.resolution = scale(scene.map.resolution);
    scene.map.boundary = scene.map.boundary.map(|outline| outline.into_iter().map(point).collect());
    for obstacle in &mut scene.obstacles {
        if let Obstacle::Rectangle { center, size, .. } = obstacle {
            (*center, *size) = (point(*center), point(*size));
        }
    }
    for lane in &mut scene.lanes {
        (lane.start.x, lane.start.y) = (scale(lane.start.x), scale(lane.start.y));
        lane.width = scale(lane.width);
        for piece in &mut lane.pieces {
            (piece.length, piece.curvature) = (scale(piece.length), piece.curvature / SHIP_SCALE);
        }
    }
    for limit in &mut scene.speed_limits {
        limit.points = limit.points.iter().map(|p| point(*p)).collect();
    }
    scene.vehicle = VehicleSpec::Profile("ship".to_owned());
    scene.start = pose(scene.start);
    if let Goal::Pose(goal) = &mut scene.goal {
        *goal = pose(*goal);
    }
    // A margin and a residual to the ship's size, metres.
    let settings = [("costs", json!("paper")), ("margin", json!(9)), ("residual", json!(1))];
    let settings = settings.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    scene.planners = [("cost-map".to_owned(), settings)].into();
    scene
}

/// A scene whose start and goal are places of the car's middle.
/// The map's lower left corner, its cells and the kerb's outline are given; obstacles and lanes are added by the
/// caller.
fn scene(origin: [f64; 2], cells: [u32; 2], boundary: Vec<[f64; 2]>, start: Pose, goal: Pose) -> Scenario {
    let car = Vehicle::SEDAN;
    let behind = -car.middle();
    let [width, height] = cells;
    Scenario::new(
        MapFrame { origin, width, height, resolution: RESOLUTION, boundary: Some(boundary) },
        VehicleSpec::Profile("sedan".to_owned()),
        start.advance(0.0, behind),
        goal.advance(0.0, behind),
    )
}

/// A lane of lines and arcs: length in metres, curvature in 1/m.
fn lane(id: &str, start: Pose, pieces: &[(f64, f64)], width: f64) -> Lane {
    let pieces = pieces.iter().map(|&(length, curvature)| LanePiece { length, curvature }).collect();
    Lane { id: Some(id.to_owned()), start, pieces, width }
}

/// A rectangle along the axes between two x and two y.
fn block(id: &str, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> Obstacle {
    Obstacle::Rectangle {
        id: Some(id.to_owned()),
        center: [f64::midpoint(x0, x1), f64::midpoint(y0, y1)],
        size: [x1 - x0, y1 - y0],
        heading: 0.0,
    }
}

/// A straight road from x = −5 to `end` + 5, y = 0 to `width`, with a metre around it.
/// One lane fills the width; callers may narrow it.
fn along_x(end: f64, width: f64, start: Pose, goal: Pose) -> Scenario {
    let (low, high) = (-RUN_OUT, end + RUN_OUT);
    let boundary = vec![[low, 0.0], [high, 0.0], [high, width], [low, width]];
    let cells = [((high - low) / RESOLUTION) as u32, ((width + 2.0) / RESOLUTION) as u32];
    let mut scene = scene([low, -1.0], cells, boundary, start, goal);
    let y = width / 2.0;
    scene.lanes = vec![lane("lane", Pose::new(low, y, 0.0), &[(high - low, 0.0)], width)];
    scene
}

/// S1: one lane of 3.5 m, a kilometre long, without obstacles.
fn straight() -> Scenario {
    along_x(1000.5, 3.5, Pose::new(0.25, 1.75, 0.0), Pose::new(1000.25, 1.75, 0.0))
}

/// S4: a road of 6.5 m with eight obstacles on alternate sides, 55 m apart.
fn narrow() -> Scenario {
    let mut scene = along_x(500.5, 6.5, Pose::new(0.25, 3.25, 0.0), Pose::new(500.25, 3.25, 0.0));
    scene.lanes[0].width = 3.25;
    let obstacle = |i: u32| {
        let x = 43.0 + 55.0 * f64::from(i);
        let y = if i.is_multiple_of(2) { [0.0, 3.0] } else { [3.5, 6.5] };
        block(&format!("obstacle-{}", i + 1), [x, x + 4.5], y)
    };
    scene.obstacles = (0..8).map(obstacle).collect();
    scene
}

/// S2: two lanes with a bend to the left and one to the right, 120 m in radius, a parked car and a box.
fn curve() -> Scenario {
    let bend = 120.0 * PI / 3.0;
    let rest = 800.0 - 250.0 - 2.0 * bend;
    let k = 1.0 / 120.0;
    let pieces = [(150.0 + RUN_OUT, 0.0), (bend, k), (100.0, 0.0), (bend, -k), (rest + RUN_OUT, 0.0)];
    let middle = lane("middle", Pose::new(-RUN_OUT, 0.0, 0.0), &pieces, 7.0);
    let at = |station: f64, left: f64| middle.point(station + RUN_OUT, left);
    // A metre of arc bulges by a millimetre.
    let stations: Vec<f64> = [-RUN_OUT]
        .into_iter()
        .chain((0..=126).map(|i| 150.0 + bend * f64::from(i) / 126.0))
        .chain((0..=126).map(|i| 250.0 + bend + bend * f64::from(i) / 126.0))
        .chain([800.0 + RUN_OUT])
        .collect();
    let side = |left: f64| stations.iter().map(move |&s| at(s, left)).map(|p| [p.x, p.y]);
    let mut boundary: Vec<[f64; 2]> = side(3.5).collect();
    boundary.reverse();
    boundary.splice(0..0, side(-3.5));
    // Centres from two metres before the middle's westernmost place and eight below its lowest.
    let end = at(800.0, 0.0);
    let cells =
        [((end.x + 4.0) / RESOLUTION).floor() as u32 + 21, ((end.y + 16.0) / RESOLUTION).floor() as u32 + 1];
    let mut scene = scene([-2.25 - RUN_OUT, -8.25], cells, boundary, at(1.0, -1.75), at(799.0, -1.75));
    let start = at(-RUN_OUT, -1.75);
    let beside = |&(length, k): &(f64, f64)| (length * (1.0 + 1.75 * k), k / (1.0 + 1.75 * k));
    scene.lanes = vec![lane("lane", start, &pieces.iter().map(beside).collect::<Vec<_>>(), 3.5)];
    let obstacle = |id: &str, station: f64, left: f64, size: [f64; 2]| {
        let pose = at(station, left);
        Obstacle::Rectangle { id: Some(id.to_owned()), center: [pose.x, pose.y], size, heading: pose.heading }
    };
    scene.obstacles =
        vec![obstacle("car", 330.0, -2.5, [4.7, 1.9]), obstacle("box", 560.0, -1.75, [1.0, 1.0])];
    scene
}

/// S3: a left turn at a crossing of two roads with two lanes each way, hatched areas and five barriers.
fn crossing() -> Scenario {
    let (low, high, half) = (-360.0 - RUN_OUT, 40.0, 7.5);
    let boundary = vec![
        [-half, low],
        [half, low],
        [half, -half],
        [high, -half],
        [high, half],
        [half, half],
        [half, high],
        [-half, high],
        [-half, half],
        [low, half],
        [low, -half],
        [-half, -half],
    ];
    let (start, goal) = (Pose::new(2.25, -359.75, FRAC_PI_2), Pose::new(-359.75, 2.25, PI));
    let cells = ((high - low) / RESOLUTION) as u32;
    let mut scene = scene([low, low], [cells, cells], boundary, start, goal);
    scene.obstacles = vec![
        block("hatch south", [-0.5, 0.5], [low, -20.0]),
        block("hatch west", [low, -20.0], [-0.5, 0.5]),
        block("barrier-1", [0.5, 4.0], [-281.0, -279.0]),
        block("barrier-2", [4.0, 7.5], [-191.0, -189.0]),
        block("barrier-3", [0.5, 4.0], [-101.0, -99.0]),
        block("barrier-4", [-131.0, -129.0], [4.0, 7.5]),
        block("barrier-5", [-241.0, -239.0], [0.5, 4.0]),
    ];
    let way = -12.0 - low;
    let north = |id: &str, x: f64| lane(id, Pose::new(x, low, FRAC_PI_2), &[(way, 0.0)], 3.5);
    let west = |id: &str, y: f64| lane(id, Pose::new(-12.0, y, PI), &[(way, 0.0)], 3.5);
    let guide = [(14.25 * FRAC_PI_2, 1.0 / 14.25)];
    scene.lanes = vec![
        north("north inner", 2.25),
        north("north outer", 5.75),
        lane("turn", Pose::new(2.25, -12.0, FRAC_PI_2), &guide, 3.5),
        west("west inner", 2.25),
        west("west outer", 5.75),
    ];
    let walk = |[x0, x1]: [f64; 2], [y0, y1]: [f64; 2]| SpeedLimit {
        points: vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]],
        speed: 5.56,
    };
    scene.speed_limits = vec![walk([-half, half], [-18.5, -15.5]), walk([-18.5, -15.5], [-half, half])];
    scene
}

/// A place at a distance and an angle from the origin.
/// Angles in radians, counter-clockwise from east.
fn polar(radius: f64, angle: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(angle);
    [radius * cos, radius * sin]
}

/// Four roads of 7 m and a ring around an island. A barrier closes the ring between the road in and the third exit,
/// so that the way there is the one that the direction of the ring allows. The lane around the ring is one arc of
/// 250°, between the lanes in and out.
fn roundabout() -> Scenario {
    const OUTER: f64 = 17.0;
    const ISLAND: f64 = 9.0;
    const HALF: f64 = 3.5;
    let (middle, end) = (f64::midpoint(OUTER, ISLAND), 65.0 + RUN_OUT);
    let mouth = asin(HALF / OUTER);
    let mut boundary = Vec::new();
    for arm in 0..4 {
        let turn = FRAC_PI_2 * f64::from(arm);
        let far = (end * end + HALF * HALF).sqrt();
        boundary.extend([-1.0, 1.0].map(|side| polar(far, turn + side * asin(HALF / far))));
        let kerb = |i: i32| turn + mouth + (FRAC_PI_2 - 2.0 * mouth) * f64::from(i) / 8.0;
        boundary.extend((0..=8).map(|i| polar(OUTER, kerb(i))));
    }
    let (start, goal) = (Pose::new(-65.0, -1.75, 0.0), Pose::new(1.75, 65.0, FRAC_PI_2));
    let cells = (2.0 * (end + 1.0) / RESOLUTION) as u32;
    let mut scene = scene([-end - 1.0; 2], [cells; 2], boundary, start, goal);
    let points = (0..24).map(|i| polar(ISLAND, f64::from(i) * PI / 12.0)).collect();
    scene.obstacles = vec![
        Obstacle::Polygon { id: Some("island".to_owned()), points },
        Obstacle::Rectangle {
            id: Some("against the ring".to_owned()),
            center: polar(middle, 0.75 * PI),
            size: [OUTER - ISLAND + 1.0, 0.4],
            heading: 0.75 * PI,
        },
    ];
    let (from, to) = (PI * 19.0 / 18.0, PI * 44.0 / 18.0);
    let [x, y] = polar(middle, from);
    let ring = [(middle * (to - from), 1.0 / middle)];
    scene.lanes = vec![
        lane("in", Pose::new(-end, -1.75, 0.0), &[(end - 16.0, 0.0)], 3.5),
        lane("ring", Pose::new(x, y, from + FRAC_PI_2), &ring, 4.0),
        lane("out", Pose::new(1.75, 16.0, FRAC_PI_2), &[(end - 16.0, 0.0)], 3.5),
    ];
    scene
}

/// A road from the south meets one with a median, which bans the left turn: the way west is to the right and back
/// around the median's end. The lane leads around the median's end with a radius of 6.75 m, which the sedan can turn.
fn turn_ban() -> Scenario {
    const HALF: f64 = 10.5;
    const MEDIAN_END: f64 = 46.0;
    /// Radius of the way around the median's end, and distance of the lanes from the road's middle.
    const LANE: f64 = 6.75;
    let (low, west, east) = (-60.0, -80.0, 74.0);
    let kerb = |i: i32| {
        let [x, y] = polar(9.0, PI * (1.0 - f64::from(i) / 16.0));
        [12.75 + x, y - HALF - 9.0]
    };
    let mut boundary = vec![[west, -HALF], [-3.75, -HALF], [-3.75, low], [3.75, low]];
    boundary.extend((0..=8).map(kerb));
    boundary.extend([[east, -HALF], [east, HALF], [west, HALF]]);
    let (start, goal) =
        (Pose::new(1.9, low + RUN_OUT + 1.0, FRAC_PI_2), Pose::new(west + RUN_OUT + 1.0, LANE, PI));
    let cells = [((east - west + 2.0) / RESOLUTION) as u32, ((HALF - low + 2.0) / RESOLUTION) as u32];
    let mut scene = scene([west - 1.0, low - 1.0], cells, boundary, start, goal);
    scene.obstacles = vec![block("no left turn", [west, MEDIAN_END], [-3.0, 3.0])];
    let around = [(MEDIAN_END - 8.0, 0.0), (PI * LANE, 1.0 / LANE), (MEDIAN_END - west, 0.0)];
    scene.lanes = vec![
        lane("north", Pose::new(1.9, low, FRAC_PI_2), &[(-low - HALF - 4.0, 0.0)], 3.75),
        lane("around", Pose::new(8.0, -LANE, 0.0), &around, 3.5),
    ];
    scene
}
