//! The validator on paths made for each of its rules.

use super::*;
use crate::geometry::Point;
use crate::scenario::resolve::{Form, Shape};
use crate::vehicle::Vehicle;

fn scene(goal: Pose, wall: Option<(Point, Point)>) -> Geometry {
    let boundary = [(-20.0, -20.0), (40.0, -20.0), (40.0, 40.0), (-20.0, 40.0)];
    Geometry {
        start: Pose::new(0.0, 0.0, 0.0),
        goal,
        goals: None,
        vehicle: Vehicle::PAPER,
        boundary: boundary.map(|(x, y)| Point::new(x, y)).to_vec(),
        shapes: wall
            .map(|(a, b)| Shape { owner: Owner::Obstacle(0), form: Form::Segment(a, b) })
            .into_iter()
            .collect(),
        parked: Vec::new(),
    }
}

fn arc(curvature: f64, length: f64) -> Vec<Pose> {
    let n = (length / 0.1).ceil();
    (0..=n as u32).map(|i| Pose::default().advance(curvature, length * f64::from(i) / n)).collect()
}

fn run(geometry: &Geometry, path: &[Pose], direction: i8) -> Check {
    check(geometry, &Body::new(geometry), path, &vec![direction; path.len()], 0.01)
}

#[test]
fn the_tightest_circle_is_fine_and_a_tighter_one_is_not() {
    let limit = Vehicle::PAPER.max_curvature();
    let path = arc(limit, 5.0);
    let good = run(&scene(path[path.len() - 1], None), &path, 1);
    assert_eq!((good.verdict, good.tight_turns, good.slips), (Verdict::Ok, 0, 0));
    assert!((good.tightest_radius - 1.0 / limit).abs() < 1e-6);
    let path = arc(limit * 1.01, 5.0);
    let bad = run(&scene(path[path.len() - 1], None), &path, 1);
    assert_eq!((bad.verdict, bad.tight_turns), (Verdict::TooTight, 1));
}

#[test]
fn a_corner_and_a_wrong_gear_cannot_be_driven() {
    let corner = [Pose::default(), Pose::new(3.0, 0.0, 0.0), Pose::new(3.0, 0.0, 1.0)];
    let checked = run(&scene(corner[2], None), &corner, 1);
    assert_eq!((checked.verdict, checked.tight_turns, checked.tightest_radius), (Verdict::TooTight, 1, 0.0));
    let straight = arc(0.0, 3.0);
    let backwards = run(&scene(straight[straight.len() - 1], None), &straight, -1);
    assert_eq!(backwards.verdict, Verdict::TooTight);
    assert!(backwards.slips > 0);
}

/// The same motion in steps from a metre down to a tenth of a micrometre.
#[test]
fn how_finely_a_path_is_sampled_changes_no_verdict() {
    let radius = Vehicle::PAPER.min_turning_radius();
    for step in [1.0, 1e-2, 9e-5, 2e-5, 1e-6, 3e-7, 1e-7] {
        let each =
            |at: &dyn Fn(f64) -> Pose| -> Vec<Pose> { (0..=60).map(|i| at(step * f64::from(i))).collect() };
        let ahead = each(&|s| Pose::new(s, 0.0, 0.0));
        let round = each(&|s| Pose::default().advance(1.0 / radius, s));
        let sideways = each(&|s| Pose::new(0.0, s, 0.0));
        let oblique = each(&|s| Pose::new(s, s * 0.03, 0.0));
        let pivot = each(&|s| Pose::new(0.0, 0.0, (s / 60.0).min(0.04)));
        let tight = each(&|s| Pose::default().advance(1.02 / radius, s));
        let length = 60.0 * step;
        for (name, path, slides, turns) in [
            ("ahead", ahead, false, false),
            ("round", round, false, false),
            ("sideways", sideways, length > 1e-4, false),
            ("oblique", oblique, length > 1e-4, false),
            ("pivot", pivot, false, length / 60.0 > 1e-6),
            ("tight", tight, false, length > 2e-6),
        ] {
            let checked = run(&scene(path[path.len() - 1], None), &path, 1);
            assert_eq!((checked.slips > 0, checked.tight_turns > 0), (slides, turns), "{name} {step}");
        }
        let back = each(&|s| Pose::new(-s, 0.0, 0.0));
        let checked = run(&scene(back[back.len() - 1], None), &back, 1);
        assert_eq!(checked.slips > 0, length > 1e-4, "backwards {step}");
        let (aside, gears) = (each(&|s| Pose::new(0.0, s, 0.0)), [1, -1].repeat(31));
        let geometry = scene(aside[aside.len() - 1], None);
        let checked = check(&geometry, &Body::new(&geometry), &aside, &gears, 0.01);
        assert_eq!(checked.slips > 0, length > 1e-4, "sideways in both gears {step}");
    }
}

/// A million kilometres from the origin poses are a tenth of a micrometre apart.
#[test]
fn where_the_world_begins_changes_no_verdict() {
    let radius = Vehicle::PAPER.min_turning_radius();
    for (first, tighter, verdict) in [
        (5e-6, 1.0, Verdict::Ok),
        (4e-5, 1.0, Verdict::Ok),
        (3e-4, 1.0, Verdict::Ok),
        (1.0, 1.01, Verdict::TooTight),
    ] {
        for away in [0.0, 1e3, 1e6, 1e9] {
            let start = Pose::new(away, -away, 0.3);
            let turned = start.advance(tighter / radius, first);
            let path = [start, turned, turned.advance(0.0, 3.0)];
            let mut geometry = scene(path[2], None);
            geometry.start = start;
            for corner in &mut geometry.boundary {
                *corner = Point::new(corner.x + away, corner.y - away);
            }
            assert_eq!(run(&geometry, &path, 1).verdict, verdict, "{first} m, {away} m away");
        }
    }
}

#[test]
fn a_path_that_begins_elsewhere_cannot_be_driven() {
    let path: Vec<Pose> = arc(0.0, 5.0).into_iter().map(|p| Pose { y: p.y + 0.5, ..p }).collect();
    let checked = run(&scene(path[path.len() - 1], None), &path, 1);
    assert_eq!((checked.verdict, checked.slips), (Verdict::TooTight, 1));
}

#[test]
fn a_thin_wall_between_two_poses_is_seen() {
    let path = [Pose::default(), Pose::new(20.0, 0.0, 0.0)];
    let wall = Some((Point::new(12.0, 1.0), Point::new(12.0, 1.31)));
    let checked = run(&scene(path[1], wall), &path, 1);
    assert_eq!((checked.verdict, checked.hit_poses), (Verdict::Collides, vec![1]));
    assert_eq!(checked.first_hit.map(|h| h.0), Some(Owner::Obstacle(0)));
}

/// Steps that are left out for the room around the body hit nothing: the first hit is that of every step asked.
#[test]
fn room_hides_no_hit() {
    let mut state = 11_u64;
    let mut random = move |from: f64, to: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * ((state >> 11) as f64 / (1_u64 << 53) as f64)
    };
    let (mut hits, mut free) = (0, 0);
    for round in 0..3000 {
        let a = Point::new(random(-9.0, 9.0), random(-9.0, 9.0));
        let wall = (a, a + nalgebra::Vector2::new(random(-2.0, 2.0), random(-2.0, 2.0)));
        let body = Body::new(&scene(Pose::default(), Some(wall)));
        let from = Pose::new(0.0, 0.0, random(-3.0, 3.0));
        let turn = random(-2.5, 2.5);
        let (curvature, length) = [(0.0, 0.0), (turn / 8.0, 7.99), (0.0, 8.99)][round % 3];
        let at = |t: f64| match length {
            0.0 => Pose { heading: from.heading + turn * t, ..from },
            _ => from.advance(curvature, length * t),
        };
        if body.hit(from).is_some() {
            continue;
        }
        let steps = (length.max(turn.abs()) / STEP).ceil();
        let every = (1..steps as u32).map(|k| at(f64::from(k) / steps)).find(|&p| body.hit(p).is_some());
        let asked = hit_between(&body, (from, body.clearance(from)), at(1.0), 1);
        assert_eq!(asked.is_some(), every.is_some(), "round {round}");
        if let (Some((_, found)), Some(want)) = (asked, every) {
            assert!((found.point() - want.point()).norm() < 1e-6, "round {round}");
            assert!(math::turn(found.heading, want.heading).abs() < 1e-6, "round {round}");
        }
        hits += usize::from(asked.is_some());
        free += usize::from(asked.is_none());
    }
    assert!(hits > 150 && free > 1000, "{hits} {free}");
}

#[test]
fn arriving_tail_in_is_said() {
    let path = arc(0.0, 5.0);
    let mut goal = path[path.len() - 1];
    goal.heading = math::PI;
    let checked = run(&scene(goal, None), &path, 1);
    assert_eq!(checked.verdict, Verdict::ArrivesTurned);
    assert!(checked.drivable());
}
