//! What is known from a gap, against an exact test of every pose: the same answers and the same number of checks.

use super::super::{Edge, Obstacles, Reach, Sampling, Solid};
use super::*;
use crate::geometry::Point;
use crate::vehicle::Vehicle;

/// The k-th of halls with walls all over them. Every other one has a block, and the one before it is the same without.
fn hall(k: u32) -> Obstacles {
    let number = |step: f64, i: u32| (f64::from(31 * (k / 2) + i + 1) * step).fract();
    let wall = |i: u32| {
        let a = Point::new(30.0 * number(0.618_034, i), 20.0 * number(0.414_214, i));
        let b = Point::new(a.x + 6.0 * number(0.732_051, i) - 3.0, a.y + 6.0 * number(0.236_068, i) - 3.0);
        Edge { a, b, owner: i }
    };
    let walls: Vec<Edge> = (0..2 + k / 2 % 7).map(wall).collect();
    let low = Point::new(3.0 + 20.0 * number(0.618_034, 99), 3.0 + 10.0 * number(0.414_214, 99));
    let block = [(0.0, 0.0), (4.7, 0.0), (4.7, 1.8), (0.0, 1.8)];
    let block = block.map(|(x, y)| Point::new(low.x + x, low.y + y)).to_vec();
    let corners = [(0.0, 0.0), (30.0, 0.0), (30.0, 20.0), (0.0, 20.0)].map(|(x, y)| Point::new(x, y));
    let solids = [Solid { outline: block, owner: 100 }];
    Obstacles::new(&walls, &solids[..(k % 2) as usize], &Solid { outline: corners.to_vec(), owner: 101 })
}

/// The k-th of poses all over a hall, some of them along its walls.
fn somewhere(k: u32) -> Pose {
    let t = f64::from(k);
    let heading = if k.is_multiple_of(5) { f64::from(k % 4) * math::FRAC_PI_2 } else { t * 0.1 };
    Pose::new((t * 0.618).fract() * 30.0, (t * 0.414).fract() * 20.0, math::wrap(heading))
}

#[test]
fn a_body_that_moves_less_than_its_gap_meets_nothing() {
    let (mut free, mut wide) = (0, 0);
    for number in 0..120 {
        let hall = hall(number);
        let checker = CollisionChecker::new(&hall, &Vehicle::SEDAN);
        for k in 0..1000 {
            let (place, margin) =
                (Placement::of(somewhere(1000 * number + k)), [0.0, 0.1, -0.05][k as usize % 3]);
            let gap = checker.gap(place, margin);
            assert_eq!(gap.is_none(), checker.exact(place, margin).is_some(), "{place:?}");
            let Some(gap) = gap.filter(|&gap| gap > 0.0) else { continue };
            free += 1;
            wide += u32::from(gap > 0.1);
            for (x, y) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (0.7, 0.7), (-0.7, 0.7)] {
                let moved = place.moved(gap * x, gap * y);
                assert_eq!(checker.exact(moved, margin), None, "{place:?} {gap}");
            }
        }
    }
    assert!(free > 30_000 && wide > 20_000, "{free} {wide}");
}

/// [`CollisionChecker::arc_free`] with an exact test of every pose that it looks at, and how many these are.
fn arc_free_by_poses(checker: &CollisionChecker, from: Pose, arc: &Arc, spacing: f64) -> (bool, u32) {
    let steps = (arc.length.abs() / spacing).ceil().max(1.0);
    let part = arc.length / steps;
    let (start, turn) = (Placement::of(from), arc.curvature * part);
    let (radius, step) = (checker.disc_radius(0.1), part.abs() * checker.max_disc_speed(arc.curvature));
    let (turn_sin, turn_cos) = math::sin_cos(turn);
    let turned = |k: u32| math::sin_cos(from.heading + turn * f64::from(k));
    let at = |k: u32, (sin, cos): (f64, f64)| start.along(arc.curvature, part * f64::from(k), sin, cos);
    let met = |place: Placement| checker.exact(place, 0.1 - CONTACT).is_some();
    let (mut k, mut checks) = (steps as u32, 0);
    let mut far = k;
    while far > STRIDE {
        far -= STRIDE;
        checks += 1;
        let place = at(far, turned(far));
        if met(place) {
            return (false, checks);
        }
        far = far.saturating_sub((checker.spare(place, radius) / step) as u32);
    }
    let (mut sin, mut cos) = turned(k);
    loop {
        checks += 1;
        let place = at(k, (sin, cos));
        if met(place) {
            return (false, checks);
        }
        let settled = ((checker.spare(place, radius) / step) as u32).saturating_add(1);
        if settled >= k {
            return (true, checks);
        }
        k -= settled;
        (sin, cos) = if settled == 1 {
            (sin * turn_cos - cos * turn_sin, cos * turn_cos + sin * turn_sin)
        } else {
            turned(k)
        };
    }
}

/// What [`Reach::is_free`] tells of one arc when an exact test is made of every pose that it looks at.
fn reach_by_poses(checker: &CollisionChecker, from: Pose, arc: &Arc, spacing: f64) -> (bool, u32) {
    let (start, radius) = (Placement::of(from), checker.disc_radius(0.1));
    let sign = 1.0_f64.copysign(arc.length);
    let (turn_sin, turn_cos) = math::sin_cos(spacing * arc.curvature * sign);
    let (mut sin, mut cos) = (start.sin, start.cos);
    let (mut free, mut checks) = (0.0, 0);
    while free < arc.length.abs() {
        let next = free + spacing;
        (sin, cos) = (sin * turn_cos + cos * turn_sin, cos * turn_cos - sin * turn_sin);
        let place = start.along(arc.curvature, next * sign, sin, cos);
        checks += 1;
        if checker.exact(place, 0.1 - CONTACT).is_some() {
            // The end itself is nearer than the pose that is not free.
            let (sin, cos) = math::sin_cos(from.heading + arc.curvature * arc.length);
            let end = start.along(arc.curvature, arc.length, sin, cos);
            let is_short = arc.length.abs() < next;
            return (is_short && checker.exact(end, 0.1 - CONTACT).is_none(), checks + u32::from(is_short));
        }
        let spare = checker.spare(place, radius);
        free = next + spare / checker.max_disc_speed(arc.curvature);
        if spare > 0.0 {
            (sin, cos) = math::sin_cos(from.heading + arc.curvature * free * sign);
        }
    }
    (true, checks)
}

#[test]
fn what_a_gap_tells_is_what_every_pose_tells() {
    let car = Vehicle::SEDAN;
    let (mut poses, mut free, mut blocked) = (0, 0, 0);
    for number in 0..120 {
        let hall = hall(number);
        let checker = CollisionChecker::new(&hall, &car);
        for k in 0..400 {
            let from = somewhere(400 * number + k);
            let turn = [0.0, 1.0, -1.0, 0.4][k as usize % 4] / car.min_turning_radius();
            let arc = Arc { curvature: turn, length: f64::from(k) * 0.03 - 6.0 };
            let spacing = [0.05, 0.1][k as usize % 2];
            let count = |asked: &mut dyn FnMut() -> bool| {
                let before = checker.checks();
                (asked(), checker.checks() - before)
            };
            let want = arc_free_by_poses(&checker, from, &arc, spacing);
            assert_eq!(count(&mut || checker.arc_free(from, &arc, spacing, 0.1)), want, "{from:?} {arc:?}");
            (poses, free, blocked) = (poses + want.1, free + u32::from(want.0), blocked + u32::from(!want.0));
            if k % 4 == 3 {
                continue;
            }
            let want = reach_by_poses(&checker, from, &arc, spacing);
            let mut reach = Reach::new(from, Sampling::new(spacing, 0.1, car.min_turning_radius()));
            assert_eq!(count(&mut || reach.is_free(&checker, &arc)), want, "{from:?} {arc:?}");
            poses += want.1;
            // The body is free as far as it is said to go, and blocked a sixteenth of the spacing on.
            let far = reach.free_length(&checker, &arc);
            let [end, behind] =
                [far, far + spacing / 16.0].map(|far| Arc { length: far.copysign(arc.length), ..arc });
            assert!(far == 0.0 || reach.is_free(&checker, &end), "{from:?} {arc:?} {far}");
            assert_eq!(far < arc.length.abs(), !want.0, "{from:?} {arc:?} {far}");
            assert!(want.0 || !reach.is_free(&checker, &behind), "{from:?} {arc:?} {far}");
        }
    }
    assert!(poses > 150_000 && free > 5000 && blocked > 5000, "{poses} {free} {blocked}");
}

#[test]
fn a_clearance_that_is_kept_is_kept_at_every_millimetre() {
    let (tolerance, unseen) = (0.001, 0.002);
    let (mut kept, mut lost) = (0, 0);
    for number in 0..60 {
        let hall = hall(number);
        let checker = CollisionChecker::new(&hall, &Vehicle::SEDAN);
        for k in 0..200 {
            let from = somewhere(1000 * number + k);
            let curvature = [0.0, 0.25, -0.17][k as usize % 3];
            let arc = Arc { curvature, length: [3.0, -2.0, 0.3][k as usize / 3 % 3] };
            let clearance = [0.1, 0.03][k as usize % 2];
            let millimetres = (arc.length.abs() * 1000.0) as u32;
            let along = |n: u32| from.advance(curvature, arc.length * f64::from(n) / f64::from(millimetres));
            let least = (0..=millimetres).map(|n| checker.clearance(along(n), 0.3)).fold(0.3, f64::min);
            if checker.keeps_clearance(from, &arc, 0.01, (clearance, tolerance)) {
                kept += u32::from(least < 0.3);
                assert!(least >= clearance - tolerance - unseen, "{from:?} {arc:?}: {least} of {clearance}");
            } else {
                lost += 1;
                assert!(least < clearance, "{from:?} {arc:?}: {least} of {clearance}");
            }
        }
    }
    assert!(kept > 500 && lost > 500, "{kept} {lost}");
}
