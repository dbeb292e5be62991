//! Seeded roads with lanes: bends, one to three lanes a direction, and what stands on them.

use std::collections::BTreeMap;

use parkade::geometry::{Pose, math};
use parkade::scenario::generate::SplitMix64;
use parkade::scenario::{Goal, Lane, LanePiece, MapFrame, Obstacle, Scenario, SpeedLimit, VehicleSpec};

/// Metres of road before the start and beyond the goal.
const RUN_OUT: f64 = 5.0;
/// Metres between the map's border and the road.
const RIM: f64 = 2.0;
const RESOLUTION: f64 = 0.5;

struct Random(SplitMix64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, n: u32) -> u32 {
        self.0.below(n)
    }
}

/// The road of a seed: 150 to 500 m with up to four bends, one to three lanes along and up to two against. What stands
/// on it leaves 3.5 m free.
pub(crate) fn road(seed: u64) -> Scenario {
    let mut r = Random(SplitMix64::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
    let [along, against] = [[1, 1], [1, 1], [2, 2], [2, 0], [1, 0], [3, 1]][r.below(6) as usize];
    let width = [3.25, 3.5, 3.75][r.below(3) as usize];
    let half = width * f64::from(along + against) / 2.0;
    let pieces = pieces(&mut r, half);
    let middle = Lane { id: None, start: Pose::new(-RUN_OUT, 0.0, 0.0), pieces, width };
    let length: f64 = middle.pieces.iter().map(|p| p.length).sum();
    // Lane k from the right-hand kerb on.
    let left = |k: u32| width * (f64::from(k) + 0.5) - half;
    let lane = |k: u32| {
        let beside = |p: &LanePiece| LanePiece {
            length: p.length * (1.0 - left(k) * p.curvature),
            curvature: p.curvature / (1.0 - left(k) * p.curvature),
        };
        let start = middle.point(0.0, left(k));
        Lane { id: None, start, pieces: middle.pieces.iter().map(beside).collect(), width }
    };
    let outline = outline(&middle, half);
    let low = [0, 1].map(|i| outline.iter().fold(f64::INFINITY, |m: f64, p| m.min(p[i])) - RIM);
    let high = [0, 1].map(|i| outline.iter().fold(f64::NEG_INFINITY, |m: f64, p| m.max(p[i])) + RIM);
    let (from, to) = (r.below(along), r.below(along));
    let behind = |pose: Pose| pose.advance(0.0, -1.4);
    let obstacles = obstacles(&mut r, &middle, length, (along, against), half);
    Scenario {
        version: 1,
        name: Some(format!("road {seed}")),
        map: MapFrame {
            origin: low,
            width: ((high[0] - low[0]) / RESOLUTION).ceil() as u32,
            height: ((high[1] - low[1]) / RESOLUTION).ceil() as u32,
            resolution: RESOLUTION,
            boundary: Some(outline),
        },
        obstacles,
        slots: Vec::new(),
        costs: Vec::new(),
        moving: Vec::new(),
        lanes: (0..along).map(lane).collect(),
        speed_limits: Vec::<SpeedLimit>::new(),
        vehicle: VehicleSpec::Profile("sedan".to_owned()),
        start: behind(middle.point(RUN_OUT, left(from))),
        goal: Goal::Pose(behind(middle.point(length - RUN_OUT, left(to)))),
        planners: BTreeMap::new(),
    }
}

/// Straight parts and bends in turns; the road never turns back, so it meets itself nowhere.
fn pieces(r: &mut Random, half: f64) -> Vec<LanePiece> {
    let mut pieces = vec![LanePiece { length: RUN_OUT + r.between(40.0, 110.0), curvature: 0.0 }];
    let mut heading: f64 = 0.0;
    for _ in 0..r.below(5) {
        let target = r.between(-1.2, 1.2);
        let turn = target - heading;
        let radius = r.between(half + 15.0, 120.0);
        pieces.push(LanePiece { length: radius * turn.abs(), curvature: turn.signum() / radius });
        pieces.push(LanePiece { length: r.between(40.0, 120.0), curvature: 0.0 });
        heading = target;
    }
    if let Some(last) = pieces.last_mut() {
        last.length += RUN_OUT;
    }
    pieces
}

/// A metre of a bend at most from point to point; the ends of straight parts alone.
fn outline(middle: &Lane, half: f64) -> Vec<[f64; 2]> {
    let mut stations = vec![0.0];
    for piece in &middle.pieces {
        let from = stations[stations.len() - 1];
        let count = if piece.curvature == 0.0 { 1 } else { piece.length.ceil().max(1.0) as u32 };
        stations.extend((1..=count).map(|k| from + piece.length * f64::from(k) / f64::from(count)));
    }
    let side = |left: f64| {
        let point = |&s: &f64| middle.point(s, left);
        stations.iter().map(point).map(|p| [p.x, p.y]).collect::<Vec<_>>()
    };
    let mut outline = side(-half);
    outline.extend(side(half).into_iter().rev());
    outline
}

/// Cars at the kerb, boxes in lanes and closed lanes, 35 to 90 m apart.
fn obstacles(
    r: &mut Random,
    middle: &Lane,
    length: f64,
    (along, against): (u32, u32),
    half: f64,
) -> Vec<Obstacle> {
    let mut obstacles = Vec::new();
    let mut station = RUN_OUT + r.between(25.0, 80.0);
    while station < length - RUN_OUT - 25.0 && along + against > 1 {
        let lane = middle.width * (f64::from(r.below(along)) + 0.5) - half;
        let (left, size) = match r.below(3) {
            0 => (1.05 - half, [4.7, 1.9]),
            1 => (lane, [1.0, 1.0]),
            _ if along + against == 2 => (lane - 0.3, [2.0, 2.0]),
            _ => (lane, [2.0, middle.width]),
        };
        let pose = middle.point(station, left);
        obstacles.push(Obstacle::Rectangle {
            id: Some(format!("obstacle-{}", obstacles.len() + 1)),
            center: [pose.x, pose.y],
            size,
            heading: math::wrap(pose.heading),
        });
        station += r.between(35.0, 90.0);
    }
    obstacles
}
