//! Proves that the body cannot get from one end to the other even if it could move in any direction, and turn
//! on the spot. Where it could not, no car of its shape gets there, however many gear changes it takes.
//!
//! The poses are cut into boxes. A box is closed when the body, shrunk by as much as a point of it moves within the
//! box, meets something in the box's middle; then no pose in the box is free. A way passes through neighbouring open
//! boxes, so where the boxes that can be reached from one end do not hold the other end, that is a proof.
//!
//! The converse does not hold: open boxes may join where no way leads, and a way for a holonomic body may be none for a
//! car. So the answer is "proven apart" or "not known", never "there is a path". Boxes of three sizes are tried, coarse
//! ones first, because a coarse proof costs a hundredth of a fine one.
//!
//! Why this is a proof. Let a box have side a in x and y and the turn φ, and let r be the distance from the body's
//! middle to a corner. Between the box's middle and any pose in it no point of the body moves farther than
//!
//! ```text
//! a/√2 + r·φ/2
//! ```
//!
//! Shrink the body by that much. If the shrunk body at the middle meets an obstacle, then the whole body meets it at
//! every pose of the box. A continuous motion passes from box to box through shared faces, so it stays within the
//! open boxes that are joined to the first one.
//!
//! The order of the flood does not matter for the proof; it decides which open box is reported as the nearest, and
//! how soon the other end is reached where there is a way. Each box is looked at once, with one collision check.

use super::obstacle_heuristic::ObstacleHeuristic;
use super::state_index::StateIndex;
use crate::geometry::{Point, Pose, Vector, math};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::CollisionChecker;

/// Sides of the boxes that are tried in turn, in widths of the body; their turn moves a corner of it as far.
const BOX_SIDES: [f64; 3] = [1.0 / 16.0, 1.0 / 32.0, 1.0 / 64.0];
/// Boxes looked at with each, at most.
const MAX_BOXES: [u32; 3] = [100_000, 200_000, 400_000];
/// Width of a class of boxes by their way to the target, metres.
const BUCKET_WIDTH: f64 = 0.25;
/// Shrunk by this much more, so that a touch on a box's face counts for both sides, metres.
const FACE_OVERLAP: f64 = 1e-4;

/// How the boxes from one end were searched.
enum Search {
    /// The other end is among them.
    Reached,
    /// They came to an end; the one nearest to the target.
    Closed(Pose),
    /// Too many.
    Unknown,
}

/// Proves that the body cannot get from `root` to `target`, whichever way it moves, with `margin` metres around it:
/// tells the pose nearest to the target that it may reach.
///
/// Poses are local. `None` means "not known": the boxes join, or too many would have to be looked at. At most 700 000
/// checks.
#[inline(never)]
pub(super) fn proven_apart(
    car: (&CollisionChecker, &Vehicle),
    flood: &ObstacleHeuristic,
    [root, target]: [Pose; 2],
    margin: f64,
    keys: &mut StateIndex,
) -> Option<Pose> {
    for (side, most) in BOX_SIDES.into_iter().zip(MAX_BOXES) {
        match Boxes::new(car, flood, root, side * car.1.width, margin).search(target, most, keys) {
            Search::Reached => {}
            Search::Closed(nearest) => return Some(nearest),
            Search::Unknown => return None,
        }
    }
    None
}

/// A box: steps from the root's along both axes and round.
type Box3 = [i32; 3];

/// The boxes about one pose.
struct Boxes<'a> {
    checker: &'a CollisionChecker<'a>,
    flood: &'a ObstacleHeuristic,
    root: Pose,
    /// Middle of the body at the root.
    origin: Point,
    /// From the rear axle to the middle of the body, metres.
    ahead: f64,
    side: f64,
    /// Sine and cosine of each heading, from the root's on all the way round.
    headings: Vec<(f64, f64)>,
    /// Added around the body: less than nothing.
    margin: f64,
}

impl<'a> Boxes<'a> {
    /// Boxes of so many metres about a root. Headings are as many as keep the body's corners within a box's side from
    /// one to the next; the margin is what the body may be too large by, so that a box is closed only if no pose in
    /// it is free.
    fn new(
        (checker, vehicle): (&'a CollisionChecker<'a>, &Vehicle),
        flood: &'a ObstacleHeuristic,
        root: Pose,
        side: f64,
        margin: f64,
    ) -> Self {
        let corner = math::hypot(vehicle.length(), vehicle.width) / 2.0;
        let count = (math::TAU * corner / side).ceil();
        let heading = |k: u32| math::sin_cos(root.heading + math::TAU * f64::from(k) / count);
        let moved = side * core::f64::consts::FRAC_1_SQRT_2 + corner * math::PI / count;
        let ahead = vehicle.middle();
        Self {
            checker,
            flood,
            root,
            origin: root.to_world(Point::new(ahead, 0.0)),
            ahead,
            side,
            headings: (0..count as u32).map(heading).collect(),
            margin: margin - moved - FACE_OVERLAP,
        }
    }

    /// Turn of a box, radians: a corner of the body moves about as far in it as the side of a box.
    fn turn(&self) -> f64 {
        math::TAU / self.headings.len() as f64
    }

    /// The box of a pose.
    fn at(&self, pose: Pose) -> Box3 {
        let way = pose.to_world(Point::new(self.ahead, 0.0)) - self.origin;
        let turn = (math::turn(self.root.heading, pose.heading) / self.turn()).round() as i32;
        let steps = |metres: f64| (metres / self.side).round() as i32;
        [steps(way.x), steps(way.y), turn.rem_euclid(self.headings.len() as i32)]
    }

    /// The pose in the middle of a box, and the sine and cosine of its heading.
    fn middle(&self, [x, y, turn]: Box3) -> (Pose, (f64, f64)) {
        let (sin, cos) = self.headings[turn as usize];
        let middle = self.origin + Vector::new(f64::from(x), f64::from(y)) * self.side;
        let heading = self.root.heading + self.turn() * f64::from(turn);
        (Pose::new(middle.x - self.ahead * cos, middle.y - self.ahead * sin, heading), (sin, cos))
    }

    /// The six boxes that share a face with this one; headings are cyclic.
    fn around(&self, [x, y, turn]: Box3) -> [Box3; 6] {
        let count = self.headings.len() as i32;
        let (left, right) = ((turn + 1) % count, (turn + count - 1) % count);
        [[x + 1, y, turn], [x - 1, y, turn], [x, y + 1, turn], [x, y - 1, turn], [x, y, left], [x, y, right]]
    }

    /// Goes through the boxes that can be reached from the root, those nearest to the target by the flood first.
    fn search(&self, target: Pose, most: u32, keys: &mut StateIndex) -> Search {
        keys.clear();
        let wanted = self.at(target);
        let mut boxes: Vec<Box3> = Vec::new();
        let mut classes: Vec<Vec<u32>> = Vec::new();
        let mut enter = |one: Box3, boxes: &mut Vec<Box3>| {
            let key = one.iter().fold(0, |key, &step| key << 21 | u64::from((step + (1 << 20)) as u32));
            let is_new = keys.id(key) as usize == boxes.len();
            if is_new {
                boxes.push(one);
            }
            is_new
        };
        let mut nearest = (usize::MAX, self.root);
        let mut low = self.open(&mut classes, 0, self.root);
        enter([0; 3], &mut boxes);
        while low < classes.len() {
            let Some(index) = classes[low].pop() else {
                low += 1;
                continue;
            };
            let at = boxes[index as usize];
            if at == wanted {
                return Search::Reached;
            }
            if low < nearest.0 {
                nearest = (low, self.middle(at).0);
            }
            for one in self.around(at) {
                if !enter(one, &mut boxes) {
                    continue;
                }
                if boxes.len() as u32 > most {
                    return Search::Unknown;
                }
                let (pose, heading) = self.middle(one);
                if one == wanted || self.checker.fits(pose.point(), heading, self.margin) {
                    low = low.min(self.open(&mut classes, boxes.len() as u32 - 1, pose));
                }
            }
        }
        Search::Closed(nearest.1)
    }

    /// Notes an open box under its way to the target; tells its class.
    fn open(&self, classes: &mut Vec<Vec<u32>>, index: u32, pose: Pose) -> usize {
        let far = self.flood.distance(pose);
        let class = if far.is_finite() { (far / BUCKET_WIDTH) as usize } else { classes.len() };
        if class >= classes.len() {
            classes.resize_with(class + 1, Vec::new);
        }
        classes[class].push(index);
        class
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::collision::{Edge, Obstacles, Solid};

    const CART: Vehicle = Vehicle {
        wheelbase: 1.2,
        width: 0.9,
        rear_to_front: 1.6,
        rear_to_back: 0.4,
        max_steer: 0.6,
        max_steer_rate: 0.5,
    };

    fn is_apart(walls: &[[f64; 4]], floor: &[(f64, f64)], ends: [Pose; 2]) -> bool {
        let edge = |&[x, y, u, v]: &[f64; 4]| Edge { a: Point::new(x, y), b: Point::new(u, v), owner: 1 };
        let walls: Vec<Edge> = walls.iter().map(edge).collect();
        let outline = floor.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let obstacles = Obstacles::new(&walls, &[], &Solid { outline, owner: 0 });
        let checker = CollisionChecker::new(&obstacles, &CART);
        let [root, target] = ends.map(|pose| obstacles.local(pose));
        assert!([root, target].iter().all(|&pose| checker.hit(pose, 0.0).is_none()));
        let flood = ObstacleHeuristic::new(&obstacles, &CART, target, 0.0, None);
        proven_apart((&checker, &CART), &flood, [root, target], 0.0, &mut StateIndex::default()).is_some()
    }

    #[test]
    fn a_door_is_passed_by_what_is_narrower() {
        let floor = [(0.0, 0.0), (9.0, 0.0), (9.0, 1.6), (0.0, 1.6)];
        for turn in [0.0, 0.2, math::PI] {
            let ends = [Pose::new(2.0, 0.8, turn), Pose::new(6.5, 0.7, turn - 0.1)];
            for (door, closed) in [(0.8, true), (0.86, true), (0.901, false), (1.1, false)] {
                let walls = [[4.5, 0.0, 4.5, 0.3], [4.5, 0.3 + door, 4.5, 1.6]];
                assert_eq!(is_apart(&walls, &floor, ends), closed, "{door} m, turned {turn}");
            }
        }
    }

    /// Round a right angle between lanes of one width a rectangle gets where that is (length / 2 + width) / √2.
    #[test]
    fn a_corner_is_passed_by_what_can_turn_in_it() {
        let needed = (CART.length() / 2.0 + CART.width) * core::f64::consts::FRAC_1_SQRT_2;
        for (more, closed) in [(-0.15, true), (-0.06, true), (0.001, false), (0.2, false)] {
            let a = needed + more;
            let floor = [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (6.0 - a, 6.0), (6.0 - a, a), (0.0, a)];
            let ends = [Pose::new(1.0, a / 2.0, 0.0), Pose::new(6.0 - a / 2.0, 4.0, math::FRAC_PI_2)];
            assert_eq!(is_apart(&[], &floor, ends), closed, "{a} m");
            assert_eq!(is_apart(&[], &floor, [ends[1], ends[0]]), closed, "{a} m, the other way");
        }
    }
}
