//! The filters of the checker against its exact tests, and what is counted.

use super::super::Solid;
use super::super::obstacles::tests::hall;
use super::*;

/// A block, so many metres to the east of where it is otherwise.
fn block(shift: f64, owner: u32) -> Solid {
    let corners = [(12.0, 8.0), (13.0, 8.5), (12.6, 9.4), (11.8, 9.0)];
    Solid { outline: corners.map(|(x, y)| Point::new(x + shift, y)).to_vec(), owner }
}

fn hall_with_block() -> Obstacles {
    hall(&[block(0.0, 1)])
}

/// The k-th of poses all over the hall.
fn somewhere(k: u32) -> Pose {
    let t = f64::from(k);
    Pose::new((t * 0.618).fract() * 30.0, (t * 0.414).fract() * 20.0, t * 0.1)
}

#[test]
fn touching_a_wall_is_free_and_a_margin_is_kept() {
    let hall = hall(&[]);
    let checker = CollisionChecker::new(&hall, &Vehicle::PAPER);
    assert_eq!(checker.hit(Pose::new(1.0, 10.0, 0.0), 0.0), None);
    assert_eq!(checker.hit(Pose::new(0.9, 10.0, 0.0), 0.0), Some(9));
    assert_eq!(checker.hit(Pose::new(1.05, 10.0, 0.0), 0.1), Some(9));
    assert!((checker.clearance(Pose::new(1.25, 10.0, 0.0), 1.0) - 0.25).abs() < 1e-9);
    assert_eq!(checker.checks(), 4, "the last one has no room");
}

#[test]
fn more_checks_than_can_be_counted_are_the_largest_number() {
    let hall = hall(&[]);
    let checker = CollisionChecker::new(&hall, &Vehicle::PAPER);
    let start = Pose::new(15.0, 10.0, 0.0);
    checker.checks.set(u32::MAX - 1);
    for _ in 0..3 {
        assert_eq!(checker.hit(start, 0.0), None);
        assert!(checker.arc_free(start, &Arc { curvature: 0.0, length: 1.0 }, 0.1, 0.0));
        assert!(checker.free_length(start, &Arc { curvature: 0.0, length: 1.0 }, 0.1, 0.0) > 0.9);
        assert_eq!(checker.checks(), u32::MAX);
    }
}

#[test]
fn the_filters_never_change_the_answer() {
    let hall = hall_with_block();
    let checker = CollisionChecker::new(&hall, &Vehicle::PAPER);
    let mut hits = 0;
    for k in 0..20_000_u32 {
        let pose = somewhere(k);
        let exact = checker.exact(Placement::of(pose), 0.1 - CONTACT);
        assert_eq!(checker.hit(pose, 0.1), exact, "{pose:?}");
        hits += u32::from(exact.is_some());
    }
    assert!(hits > 2000, "{hits}");
}

#[test]
fn what_was_asked_before_changes_no_answer() {
    let hall = hall(&[block(0.0, 1), block(1.5, 2)]);
    let asked = CollisionChecker::new(&hall, &Vehicle::PAPER);
    let mut others = 0;
    for k in 0..4000_u32 {
        let t = f64::from(k);
        let pose = Pose::new(9.0 + (t * 0.618).fract() * 7.0, 6.0 + (t * 0.414).fract() * 6.0, t * 0.1);
        let met = asked.exact(Placement::of(pose), 0.1 - CONTACT);
        let fresh = CollisionChecker::new(&hall, &Vehicle::PAPER).hit(pose, 0.1);
        assert_eq!(met.is_some(), fresh.is_some(), "{pose:?}");
        others += u32::from(met != fresh);
        assert_eq!(asked.hit(pose, 0.1), fresh, "{pose:?}");
        asked.exact(Placement::of(somewhere(k)), 0.1 - CONTACT);
    }
    assert!(others > 20, "{others}");
}

#[test]
fn discs_cover_the_grown_body_and_no_more_than_its_corners_need() {
    let hall = hall(&[]);
    for (vehicle, margin) in [(Vehicle::PAPER, 0.0), (Vehicle::PAPER, 0.3), (Vehicle::SEDAN, 0.1)] {
        let checker = CollisionChecker::new(&hall, &vehicle);
        let [front, back, left, right] = checker.sides(margin);
        let mut needed = 0.0_f64;
        for (i, j) in (0..=60).flat_map(|i| (0..=20).map(move |j| (f64::from(i) / 60.0, f64::from(j) / 20.0)))
        {
            let (x, y) = (back + i * (front - back), right + j * (left - right));
            let nearest = checker
                .discs
                .iter()
                .map(|d| ((x - d) * (x - d) + y * y).sqrt())
                .fold(f64::INFINITY, f64::min);
            needed = needed.max(nearest);
        }
        assert!((checker.disc_radius(margin) - needed).abs() < 1e-9, "{needed} m");
    }
}

#[test]
fn no_disc_moves_faster_than_the_pace_and_one_moves_at_it() {
    let hall = hall(&[]);
    let checker = CollisionChecker::new(&hall, &Vehicle::PAPER);
    for curvature in [0.0, 0.05, -0.185] {
        let (step, from) = (1e-5, Pose::new(0.0, 0.0, 0.0));
        let to = Placement::of(from.advance(curvature, step));
        let moved = |d: &f64| {
            let (x, y) = (to.x + d * to.cos - d, to.y + d * to.sin);
            (x * x + y * y).sqrt() / step
        };
        let fastest = checker.discs.iter().map(moved).fold(0.0, f64::max);
        assert!((checker.max_disc_speed(curvature) - fastest).abs() < 1e-4, "{curvature}: {fastest}");
    }
}

#[test]
fn a_free_arc_is_free_at_every_pose() {
    let hall = hall_with_block();
    let checker = CollisionChecker::new(&hall, &Vehicle::PAPER);
    let mut free = 0;
    for k in 0..4000_u32 {
        let t = f64::from(k);
        let from = somewhere(k);
        let arc = Arc { curvature: f64::from(k % 5) * 0.09 - 0.18, length: (t * 0.23).fract() * 16.0 - 8.0 };
        let steps = (arc.length.abs() / 0.1).ceil().max(1.0);
        let all = (1..=steps as u32).all(|i| {
            let at = from.advance(arc.curvature, arc.length * f64::from(i) / steps);
            checker.hit(at, 0.1).is_none()
        });
        assert_eq!(checker.arc_free(from, &arc, 0.1, 0.1), all, "{from:?} {arc:?}");
        free += u32::from(all);
    }
    assert!(free > 200, "{free}");
}

#[test]
fn a_free_length_is_free_all_along_and_ends_at_what_is_met() {
    let hall = hall_with_block();
    let checker = CollisionChecker::new(&hall, &Vehicle::PAPER);
    let (spacing, margin) = (0.05, 0.1);
    let mut met = 0;
    for k in 0..6000_u32 {
        let from = somewhere(k);
        if checker.hit(from, margin).is_some() {
            continue;
        }
        let arc = Arc { curvature: f64::from(k % 5) * 0.09 - 0.18, length: [-9.0, 9.0][k as usize % 2] };
        let free = checker.free_length(from, &arc, spacing, margin);
        let hit = |way: f64, margin: f64| {
            checker.hit(from.advance(arc.curvature, way.copysign(arc.length)), margin).is_some()
        };
        // Between two places that are free a corner may come nearer, by less than the way between them.
        let grazed = (0..(free / 0.02) as u32).find(|&i| hit(f64::from(i) * 0.02, margin - spacing));
        assert_eq!(grazed, None, "{from:?} {arc:?}: {free}");
        assert!(!hit(free, margin), "{from:?} {arc:?}: {free}");
        if free < 9.0 {
            assert!(hit(f64::min(free + spacing / 16.0, 9.0), margin), "{from:?} {arc:?}: {free}");
            met += 1;
        }
    }
    assert!(met > 1000, "{met}");
}
