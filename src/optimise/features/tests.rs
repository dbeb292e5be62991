//! Distances against those of the checker, and slopes against differences.

use super::*;
use crate::geometry::Pose;
use crate::scenario::resolve::{Owner, Shape};

fn scene(shapes: Vec<Form>) -> Features {
    let boundary = [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)].map(|(x, y)| Point::new(x, y));
    let shapes = shapes.into_iter().map(|form| Shape { owner: Owner::Obstacle(0), form }).collect();
    Features::new(
        &Geometry {
            start: Pose::default(),
            goal: Pose::default(),
            goals: None,
            vehicle: Vehicle::PAPER,
            boundary: boundary.to_vec(),
            shapes,
            parked: Vec::new(),
        },
        Point::origin(),
    )
}

fn least(features: &Features, node: &Node) -> Option<Distance> {
    let (mut near, mut least) = (Vec::new(), None::<Distance>);
    features.near(node, 1.0, &mut near);
    features.distances(node, &near, 1.0, &mut |d| {
        if least.is_none_or(|l| d.value < l.value) {
            least = Some(d);
        }
    });
    least
}

#[test]
fn a_wall_beside_which_a_car_turns_is_not_in_it() {
    // The middle is left of the wall's line, beyond its end; a corner is right of the line, beside the wall.
    let features = scene(vec![Form::Segment(Point::new(10.0, 4.0), Point::new(10.0, 9.0))]);
    let car = Vehicle::PAPER;
    let end = Pose::new(10.0, 9.0, -0.87);
    let beside = end.to_world(Point::new(-0.3 * car.length(), car.width / 2.0 + 0.15));
    let rear = Pose::new(beside.x, beside.y, end.heading).advance(0.0, -car.middle());
    let turned = least(&features, &[rear.x, rear.y, rear.heading, 0.0, 0.0]);
    let through = least(&features, &[10.5 - car.rear_to_front, 6.0, 0.0, 0.0, 0.0]);
    assert!(turned.is_none_or(|d| d.value > 0.0), "{turned:?}");
    assert!(through.is_some_and(|d| d.value < -0.4), "{through:?}");
}

#[test]
fn distances_are_those_of_the_checker_and_slopes_are_differences() {
    let blocks = [[3.0, 3.0, 6.0, 5.0], [9.0, 2.0, 9.4, 9.0], [12.0, 12.0, 16.0, 16.0]];
    let forms = blocks.map(|[l, b, r, t]| {
        Form::Polygon([(l, b), (r, b), (r, t), (l, t)].map(|(x, y)| Point::new(x, y)).to_vec())
    });
    let wall = Form::Segment(Point::new(2.0, 14.0), Point::new(7.0, 18.0));
    let features = scene([forms.to_vec(), vec![wall]].concat());
    let body = {
        let shapes =
            [forms.to_vec(), vec![Form::Segment(Point::new(2.0, 14.0), Point::new(7.0, 18.0))]].concat();
        crate::metrics::Body::new(&Geometry {
            start: Pose::default(),
            goal: Pose::default(),
            goals: None,
            vehicle: Vehicle::PAPER,
            boundary: [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)]
                .map(|(x, y)| Point::new(x, y))
                .to_vec(),
            shapes: shapes.into_iter().map(|form| Shape { owner: Owner::Obstacle(0), form }).collect(),
            parked: Vec::new(),
        })
    };
    let mut seed = 5_u64;
    let mut draw = |most: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        most * (seed >> 33) as f64 / f64::from(1_u32 << 31)
    };
    let (mut near, mut apart) = (0, 0);
    for _ in 0..4000 {
        let node = [draw(20.0), draw(20.0), draw(6.0), 0.0, 0.2];
        let pose = Pose::new(node[0], node[1], node[2]);
        if body.hit(pose).is_some() {
            continue;
        }
        let clearance = body.clearance(pose);
        let Some(found) = least(&features, &node) else {
            assert!(clearance >= 1.0 - 1e-9);
            apart += 1;
            continue;
        };
        assert!((found.value - clearance).abs() < 1e-9, "{node:?}: {} {clearance}", found.value);
        near += 1;
        for k in 0..3 {
            let moved = |by: f64| {
                let mut other = node;
                other[k] += by;
                least(&features, &other).map_or(1.0, |d| d.value)
            };
            let slope = (moved(1e-6) - moved(-1e-6)) / 2e-6;
            // Where two features are equally near there is no slope.
            let one_side = (moved(2e-6) - found.value) / 2e-6;
            if (slope - one_side).abs() < 1e-4 && found.value < 0.99 {
                assert!((slope - found.slopes[k]).abs() < 1e-3, "{node:?} {k}: {slope} {:?}", found.slopes);
            }
        }
    }
    assert!(near > 400 && apart > 100, "{near} near, {apart} apart");
}

#[test]
fn a_shallow_overlap_is_a_depth_to_the_nearest_side() {
    let block = Form::Polygon(
        [(9.0, 2.0), (9.4, 2.0), (9.4, 9.0), (9.0, 9.0)].map(|(x, y)| Point::new(x, y)).to_vec(),
    );
    let features = scene(vec![block]);
    // The nose is 5 cm inside the block.
    let found = least(&features, &[4.55, 5.0, 0.0, 0.0, 0.2]).unwrap();
    assert!((found.value + 0.05).abs() < 1e-9 && (found.slopes[0] + 1.0).abs() < 1e-9, "{found:?}");
    // The tail is 2 cm beyond the floor.
    let found = least(&features, &[0.98, 15.0, 0.0, 0.0, 0.2]).unwrap();
    assert!((found.value + 0.02).abs() < 1e-9 && (found.slopes[0] - 1.0).abs() < 1e-9, "{found:?}");
}
