//! Bodies among random edges, against oracles that look at every edge.

use std::sync::Arc as Shared;

use super::{CollisionChecker, Edge, Obstacles, Solid};
use crate::geometry::arcs::Arc;
use crate::geometry::{Point, Pose, Vector};
use crate::map::{Frame, WeightMap, Weights};
use crate::vehicle::Vehicle;

/// Numbers from 0 to 1 that fill squares and cubes evenly.
fn spread(k: u32) -> [f64; 4] {
    [0.618_034, 0.414_214, 0.732_051, 0.236_068].map(|step| (f64::from(k) * step).fract())
}

/// The boundary's lower left corner in the world.
const CORNER: Point = Point::new(-7.0, 3.0);
const WIDE: f64 = 30.0;
const HIGH: f64 = 20.0;

struct World {
    obstacles: Obstacles,
    /// All edges, in the frame of queries.
    edges: Vec<Edge>,
}

/// A hall with short walls all over it, some of them across its border or beyond.
fn world(walls: u32) -> World {
    let wall = |k: u32| {
        let [x, y, dx, dy] = spread(k + 1);
        let a = Point::new(x * (WIDE + 10.0) - 5.0, y * (HIGH + 10.0) - 5.0);
        let b = Point::new(a.x + 2.0 * dx - 1.0, a.y + 2.0 * dy - 1.0);
        Edge { a, b, owner: k }
    };
    let mut edges: Vec<Edge> = (0..walls).map(wall).collect();
    let world = |p: Point| p + CORNER.coords;
    let walls: Vec<Edge> =
        edges.iter().map(|e| Edge { a: world(e.a), b: world(e.b), owner: e.owner }).collect();
    let corners = [(0.0, 0.0), (WIDE, 0.0), (WIDE, HIGH), (0.0, HIGH)].map(|(x, y)| Point::new(x, y));
    let boundary = Solid { outline: corners.map(world).to_vec(), owner: 9999 };
    edges.extend((0..4).map(|i| Edge { a: corners[i], b: corners[(i + 1) % 4], owner: 9999 }));
    World { obstacles: Obstacles::new(&walls, &[], &boundary), edges }
}

/// True if some of a segment is in an upright box, by cutting off what is beyond each side.
fn in_box(a: Point, b: Point, [front, back, left, right]: [f64; 4]) -> bool {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (start, end, low, high) in [(a.x, b.x, back, front), (a.y, b.y, right, left)] {
        let way = end - start;
        if way == 0.0 {
            if start < low || start > high {
                return false;
            }
            continue;
        }
        let (one, other) = ((low - start) / way, (high - start) / way);
        from = from.max(one.min(other));
        to = to.min(one.max(other));
    }
    from <= to
}

/// Least distance of points of a segment, of which it is a convex function.
fn least(a: Point, b: Point, distance: impl Fn(Point) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let at = |t: f64| distance(a + (b - a) * t);
    for _ in 0..100 {
        let third = (high - low) / 3.0;
        if at(low + third) < at(high - third) { high -= third } else { low += third }
    }
    at(low).min(at(0.0)).min(at(1.0))
}

fn sides(car: &Vehicle, margin: f64) -> [f64; 4] {
    let side = car.width / 2.0 + margin;
    [car.rear_to_front + margin, -car.rear_to_back - margin, side, -side]
}

/// Places in the hall, at its border and outside.
fn pose(k: u32) -> Pose {
    let [x, y, turn, _] = spread(k);
    Pose::new(x * (WIDE + 8.0) - 4.0, y * (HIGH + 8.0) - 4.0, turn * std::f64::consts::TAU)
}

#[test]
fn a_body_hits_what_is_in_its_box() {
    let (world, car) = (world(12), Vehicle::PAPER);
    let checker = CollisionChecker::new(&world.obstacles, &car);
    let mut hits = 0;
    for k in 0..5000 {
        let (pose, margin) = (pose(k), f64::from(k % 3) * 0.2);
        let met = |margin: f64| -> Vec<u32> {
            let meets = |e: &&Edge| in_box(pose.to_local(e.a), pose.to_local(e.b), sides(&car, margin));
            world.edges.iter().filter(meets).map(|e| e.owner).collect()
        };
        let (surely, perhaps) = (met(margin - 1.1e-6), met(margin - 0.9e-6));
        match checker.hit(pose, margin) {
            Some(owner) => assert!(perhaps.contains(&owner), "{pose:?}"),
            None => assert!(surely.is_empty(), "{pose:?}"),
        }
        hits += u32::from(!surely.is_empty());
    }
    assert!((1000..4000).contains(&hits), "{hits}");
}

#[test]
fn clearance_is_the_distance_to_the_nearest_edge() {
    let (world, car) = (world(12), Vehicle::SEDAN);
    let checker = CollisionChecker::new(&world.obstacles, &car);
    let [front, back, left, right] = sides(&car, 0.0);
    let mut measured = 0;
    for k in 0..3000 {
        let pose = pose(k);
        let limit = [0.3, 1.0, 4.0][k as usize % 3];
        let away = |p: Point| {
            let p = pose.to_local(p);
            let (x, y) = ((back - p.x).max(p.x - front).max(0.0), (right - p.y).max(p.y - left).max(0.0));
            (x * x + y * y).sqrt()
        };
        let nearest = world.edges.iter().map(|e| least(e.a, e.b, away)).fold(limit, f64::min);
        let told = checker.clearance(pose, limit);
        assert!((told - nearest).abs() < 1e-5, "{pose:?}: {told} {nearest}");
        measured += u32::from(told > 0.0 && told < limit);
        // Room enough is what surely is free, and is seen where there is plenty.
        assert!(!checker.clear_by(pose, 0.2) || told >= limit.min(0.2), "{pose:?}");
        let within = world.obstacles.inside(pose.point()).is_none();
        assert!(!within || told < 1.5 || checker.clear_by(pose, 0.2), "{pose:?}");
    }
    assert!(measured > 500, "{measured}");
}

/// The nearest contact is as far as the body has room; moved away from it by a little, the body has so much more, where
/// no other is as near.
#[test]
fn contacts_tell_the_distance_and_the_way_off() {
    let (world, car) = (world(12), Vehicle::SEDAN);
    let checker = CollisionChecker::new(&world.obstacles, &car);
    let (mut found, mut alone) = (Vec::new(), 0);
    for k in 0..3000 {
        let pose = pose(k);
        let room = checker.clearance(pose, 1.0);
        if room == 0.0 {
            continue;
        }
        checker.contacts(pose, 1.0, &mut found);
        let nearest = found.iter().map(|contact| contact.distance).fold(1.0, f64::min);
        assert!((room - nearest).abs() < 1e-9, "{pose:?}: {room} {nearest}");
        assert!(found.iter().all(|contact| contact.distance < 1.0));
        let near: Vec<_> = found.iter().filter(|contact| contact.distance < nearest + 0.01).collect();
        if let [one] = near[..] {
            assert!((one.away.norm_squared() - 1.0).abs() < 1e-9);
            let off = pose.point() + one.away * 1e-4;
            let then = checker.clearance(Pose::new(off.x, off.y, pose.heading), 2.0);
            assert!((then - room - 1e-4).abs() < 1e-6, "{pose:?}: {room} {then}");
            alone += 1;
        }
    }
    assert!(alone > 100, "{alone}");
}

#[test]
fn points_are_as_far_as_the_nearest_edge() {
    let world = world(40);
    for k in 0..2000 {
        let [x, y, limit, _] = spread(k);
        let (point, limit) = (Point::new(x * 40.0 - 5.0, y * 30.0 - 5.0), 3.0 * limit);
        let away = |e: &Edge| least(e.a, e.b, |p| (p - point).norm());
        let nearest = world.edges.iter().map(away).fold(limit, f64::min);
        let told = world.obstacles.distance(point, limit);
        assert!((told - nearest).abs() < 1e-6, "{point}: {told} {nearest}");
    }
}

#[test]
fn an_arc_is_free_until_a_sixteenth_of_a_spacing_before_a_hit() {
    let (world, spacing) = (world(8), 0.4);
    let checker = CollisionChecker::new(&world.obstacles, &Vehicle::SEDAN);
    let (mut stopped, mut whole) = (0, 0);
    for k in 0..2000 {
        let (from, [.., bend, length]) = (pose(k), spread(k));
        let arc = Arc { curvature: [0.0, 0.36 * bend - 0.18][k as usize % 2], length: 12.0 * length - 6.0 };
        let at = |way: f64| from.advance(arc.curvature, way.copysign(arc.length));
        if checker.hit(from, 0.1).is_some() {
            continue;
        }
        let free = checker.free_length(from, &arc, spacing, 0.1);
        assert!(free <= arc.length.abs() && checker.hit(at(free), 0.1).is_none(), "{from:?} {arc:?}");
        if free < arc.length.abs() {
            stopped += 1;
            let next = (free + spacing / 16.0).min(arc.length.abs());
            assert!(checker.hit(at(next), 0.1).is_some(), "{from:?} {arc:?}: {free}");
        } else {
            whole += 1;
        }
    }
    assert!(stopped > 100 && whole > 100, "{stopped} {whole}");
}

#[test]
fn where_there_is_room_one_look_settles_an_arc() {
    let world = world(0);
    let checker = CollisionChecker::new(&world.obstacles, &Vehicle::SEDAN);
    let from = Pose::new(12.0, 10.0, 0.0);
    let looks = |length: f64| {
        let before = checker.checks();
        let free = checker.arc_free(from, &Arc { curvature: 0.05, length }, 0.1, 0.1);
        (free, checker.checks() - before)
    };
    assert_eq!(looks(1.5), (true, 1));
    // Long ones are looked at in the middle, too.
    assert_eq!(looks(5.0), (true, 2));
    assert_eq!(looks(40.0), (false, 12));
    let before = checker.checks();
    assert!((checker.free_length(from, &Arc { curvature: 0.0, length: 3.0 }, 0.5, 0.1) - 3.0).abs() < 1e-12);
    assert_eq!(checker.checks() - before, 1);
}

#[test]
fn only_edges_nearby_are_asked() {
    let world = world(2000);
    let mut most = 0;
    for k in 0..200 {
        let [x, y, ..] = spread(k);
        let low = Point::new(2.0 + x * 25.0, 2.0 + y * 15.0);
        let (mut asked, middle) = (0, low + Vector::new(0.5, 0.5));
        world.obstacles.find(low, low + Vector::new(1.0, 1.0), |edge| {
            asked += 1;
            // The circles around the buckets of 2 m that the box touches are a little wider than their diagonals.
            assert!(least(edge.a, edge.b, |p| (p - middle).norm()) < 1.5 * 2.0_f64.sqrt() + 1.42);
            false
        });
        most = most.max(asked);
    }
    assert!(most < 200, "{most}");
}

#[test]
fn the_frame_begins_at_the_boundary() {
    let obstacles = world(3).obstacles;
    let local = obstacles.local(Pose::new(CORNER.x + 2.0, CORNER.y + 5.0, 7.0));
    assert_eq!((local.x, local.y), (2.0, 5.0));
    assert!((local.heading - (7.0 - std::f64::consts::TAU)).abs() < 1e-12);
    let frame = obstacles.frame();
    assert_eq!((frame.origin, frame.resolution), (Point::new(-0.25, -0.25), 0.25));
    assert_eq!((frame.width, frame.height), (123, 83));
    // A square of 20 m divided into at most 100 cells, and what is around it.
    let (coarse, field) = obstacles.lattice(0.5, 150.0);
    assert_eq!((coarse.resolution, coarse.width, coarse.height), (2.0, 18, 13));
    assert_eq!(field.data.len(), 18 * 13);
    let weights = Shared::new(Weights::new(2, 2));
    let placed = Frame { origin: Point::new(CORNER.x + 1.0, CORNER.y + 2.0), ..*frame };
    let painted = obstacles.painted(Some(WeightMap { frame: placed, weights }));
    assert_eq!(painted.paint().unwrap().frame.origin, Point::new(1.0, 2.0));
    assert!(CollisionChecker::new(&painted, &Vehicle::PAPER).paint().is_some());
}

#[test]
fn other_edges_have_another_fingerprint() {
    let square = |x: f64, y: f64| {
        let outline = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (x, y)].map(|(x, y)| Point::new(x, y)).to_vec();
        Obstacles::new(&[], &[], &Solid { outline, owner: 1 }).fingerprint()
    };
    let mut all: Vec<u64> =
        (0..300).map(|k| square(f64::from(k % 20) * 0.01, 9.0 - f64::from(k / 20) * 0.01)).collect();
    assert_eq!(square(0.0, 9.0), all[0]);
    all.sort_unstable();
    all.dedup();
    assert_eq!(all.len(), 300);
}

#[test]
fn inside_is_told_of_outlines_with_dents() {
    // A U, open above.
    let corners = [(2.0, 2.0), (14.0, 2.0), (14.0, 12.0), (10.0, 12.0), (10.0, 6.0), (6.0, 6.0), (4.0, 12.0)];
    let outline = corners.map(|(x, y)| Point::new(x, y)).to_vec();
    let corners = [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)].map(|(x, y)| Point::new(x, y));
    let boundary = Solid { outline: corners.to_vec(), owner: 9 };
    let obstacles = Obstacles::new(&[], &[Solid { outline, owner: 1 }], &boundary);
    for (x, y, owner) in [
        (3.0, 4.0, Some(1)),
        (12.0, 11.0, Some(1)),
        (8.0, 4.0, Some(1)),
        (8.0, 9.0, None),
        (5.1, 9.5, None),
        (4.9, 8.5, Some(1)),
        (1.9, 2.5, None),
        (14.1, 4.0, None),
        (12.0, 13.0, None),
        (8.0, 1.9, None),
        (-1.0, 5.0, Some(9)),
        (5.0, 21.0, Some(9)),
    ] {
        assert_eq!(obstacles.inside(Point::new(x, y)), owner, "{x} {y}");
    }
}

#[test]
fn contact_is_free_along_the_way() {
    let hall = world(0).obstacles;
    let car = Vehicle::PAPER;
    let checker = CollisionChecker::new(&hall, &car);
    let along = |y: f64, length: f64| {
        let (from, arc) = (Pose::new(5.0, y, 0.0), Arc { curvature: 0.0, length });
        (checker.arc_free(from, &arc, 0.1, 0.0), checker.free_length(from, &arc, 0.1, 0.0))
    };
    let side = car.width / 2.0;
    assert_eq!(along(side, 5.0), (true, 5.0));
    assert_eq!(along(side - 0.01, 5.0), (false, 0.0));
    let (free, length) = along(10.0, 22.0);
    let front = WIDE - 5.0 - car.rear_to_front;
    assert!(!free && length <= front + 1e-6 && length > front - 0.1 / 16.0, "{length}");
}

#[test]
fn a_wall_may_be_a_point() {
    let corners = [(0.0, 0.0), (WIDE, 0.0), (WIDE, HIGH), (0.0, HIGH)].map(|(x, y)| Point::new(x, y));
    let post = Point::new(10.0, 10.0);
    let boundary = Solid { outline: corners.to_vec(), owner: 9 };
    let hall = Obstacles::new(&[Edge { a: post, b: post, owner: 1 }], &[], &boundary);
    assert_eq!(hall.distance(Point::new(13.0, 14.0), 6.0), 5.0);
    let checker = CollisionChecker::new(&hall, &Vehicle::PAPER);
    assert_eq!(checker.hit(Pose::new(8.0, 10.0, 0.0), 0.0), Some(1));
    assert!((checker.clearance(Pose::new(8.0, 12.0, 0.0), 3.0) - 0.7).abs() < 1e-12);
}

#[test]
fn memory_is_told() {
    // Cells of 0.25 m, four edges, buckets of 2 m: 16 × 11 and an end, of which 2·(16 + 11) hold an edge and its box.
    let bytes = 123 * 83 * 4 + 4 * size_of::<Edge>() + (16 * 11 + 1) * 4 + 54 * 20;
    assert_eq!(world(0).obstacles.bytes(), bytes as u64);
}
