//! The way of the car among obstacles, from a coarse search of its poses: an estimate for places where the way of a
//! disc misleads.
//!
//! The flood of a disc knows every gap that is wide enough, and none that the car cannot turn into. Among clutter it
//! leads the search into one such gap after another, and each costs ten thousand expansions. A coarse lattice of the
//! car's own moves learns that in a few hundred states: it knows turning radius, heading, length and gear changes.
//! What it does not know is whether a gap can be passed to the centimetre. So the body is shrunk by as much as the
//! lattice errs, and the result guides the search without bounding it.
//!
//! The search goes from the target backwards: the cost of a state is that of the way on from there. A state has a
//! cell, a bin of headings and the direction in which the car leaves; it keeps the pose that reached it at the least
//! cost, as those of hybrid A\* do. The moves are arcs that turn the car by one bin at full lock, and straights of the
//! same length. States are ranked by their cost and the flood's way to the root, as in A\*, and the search ends when
//! what is left lies far off every good way. Each state takes a collision check, about a third of an expansion's work.

use super::obstacle_heuristic::ObstacleHeuristic;
use super::state_index::StateIndex;
use crate::geometry::{Pose, math};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::CollisionChecker;

/// Side of a cell, metres, and bins of headings all round.
const CELL: f64 = 0.25;
const BINS: u32 = 48;
/// Shorter moves could end in the cell in which they begin, metres.
const MIN_STEP: f64 = 1.5 * CELL;
/// The body is shrunk by so much on each side, metres.
const SHRINK: f64 = 0.05;
/// Width of a class of states by their cost, metres.
const CLASS_WIDTH: f64 = 0.05;
/// States are looked at up to so much more than the root's cost: a share of it and metres.
const BEYOND: (f64, f64) = (1.1, 2.0);
/// States looked at, at most, where they are to guide a search.
pub(super) const MAX_STATES: usize = 300_000;
/// Added to another estimate where the car did not get, metres: there is hardly a way.
const UNREACHED_COST: f64 = 20.0;

/// Costs from poses to one pose.
pub(super) struct PoseHeuristic {
    index: StateIndex,
    /// By the number of cell and heading: where the car leaves ahead, and back.
    costs: Vec<[f64; 2]>,
    change: f64,
    /// True if the search came to its end without the root.
    is_closed: bool,
}

/// A pose with the cost of the way from it to the target.
struct Entry {
    pose: Pose,
    cost: f64,
    id: u32,
    /// The direction in which the car leaves: 0 ahead, 1 back.
    leaves: usize,
}

impl PoseHeuristic {
    /// Searches from `target` towards `root`, to which `flood` tells the way. A gear change costs `change` metres, and
    /// `most` states are looked at.
    #[inline(never)]
    pub(super) fn new(
        (checker, vehicle): (&CollisionChecker, &Vehicle),
        flood: &ObstacleHeuristic,
        [root, target]: [Pose; 2],
        (margin, change): (f64, f64),
        most: usize,
    ) -> Self {
        let mut this = Self { index: StateIndex::default(), costs: Vec::new(), change, is_closed: false };
        this.index.clear();
        let radius = vehicle.min_turning_radius();
        let step = (radius * math::TAU / f64::from(BINS)).max(MIN_STEP);
        let margin = margin - SHRINK;
        let mut classes = Classes::default();
        let wanted = this.id(root);
        let id = this.id(target);
        for leaves in 0..2 {
            this.costs[id as usize][leaves] = 0.0;
            classes.push(flood.distance(target), Entry { pose: target, cost: 0.0, id, leaves });
        }
        let mut limit = f64::INFINITY;
        while let Some((rank, Entry { pose, cost, id, leaves })) = classes.pop() {
            if cost > this.costs[id as usize][leaves] {
                continue;
            }
            if rank > limit || this.costs.len() > most {
                return this;
            }
            if id == wanted && limit == f64::INFINITY {
                limit = rank * BEYOND.0 + BEYOND.1;
            }
            // The states before this one arrive in one direction and go on in the other, or in the same.
            for (before, sign) in [(0, -1.0), (1, 1.0)] {
                let cost = cost + step + if before == leaves { 0.0 } else { change };
                for curvature in [-1.0 / radius, 0.0, 1.0 / radius] {
                    let pose = pose.advance(curvature, sign * step);
                    let id = this.id(pose);
                    let known = &mut this.costs[id as usize][before];
                    if cost >= *known || !checker.fits(pose.point(), math::sin_cos(pose.heading), margin) {
                        continue;
                    }
                    *known = cost;
                    classes.push(cost + flood.distance(pose), Entry { pose, cost, id, leaves: before });
                }
            }
        }
        this.is_closed = limit == f64::INFINITY;
        this
    }

    /// True if all was searched, and no way leads from the root.
    pub(super) fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// States looked at.
    pub(super) fn states(&self) -> usize {
        self.costs.len()
    }

    /// Bytes held.
    pub(super) fn bytes(&self) -> u64 {
        size_of_val(&self.costs[..]) as u64 + self.index.bytes()
    }

    /// The number of a pose's cell and heading.
    fn id(&mut self, pose: Pose) -> u32 {
        let id = self.index.id(key(pose));
        if id as usize == self.costs.len() {
            self.costs.push([f64::INFINITY; 2]);
        }
        id
    }

    /// The costs of a pose's cell and heading or, where the car did not get to those, of the nearest around them.
    fn known(&self, pose: Pose) -> Option<[f64; 2]> {
        let at = |x: f64, y: f64, turn: f64| {
            let id = self.index.get(key(Pose::new(pose.x + x, pose.y + y, pose.heading + turn)))?;
            Some(self.costs[id as usize]).filter(|&costs| least(costs).is_finite())
        };
        let turn = math::TAU / f64::from(BINS);
        let around = [(0.0, 0.0, turn), (CELL, 0.0, 0.0), (0.0, CELL, 0.0)];
        let around =
            around.into_iter().flat_map(|(x, y, turn)| [at(x, y, turn), at(-x, -y, -turn)]).flatten();
        at(0.0, 0.0, 0.0).or_else(|| around.min_by(|&a, &b| least(a).total_cmp(&least(b))))
    }

    /// Cost of the way from a pose to which the car came in this gear (0: it stands there), or else what another
    /// estimate tells and a price for being off every way known.
    pub(super) fn cost(&self, pose: Pose, gear: i8, estimate: f64) -> f64 {
        let [ahead, back] = self.known(pose).unwrap_or([f64::INFINITY; 2]);
        let cost = match gear {
            0 => least([ahead, back]),
            1 => ahead.min(back + self.change),
            _ => back.min(ahead + self.change),
        };
        if cost.is_finite() { cost.max(estimate) } else { estimate + UNREACHED_COST }
    }
}

/// The cost of the cheaper direction.
fn least([ahead, back]: [f64; 2]) -> f64 {
    ahead.min(back)
}

/// The cell and heading of a pose.
fn key(pose: Pose) -> u64 {
    // The offset keeps what lies left of or below the origin positive.
    let cell = |metres: f64| (metres / CELL + f64::from(1 << 20)) as u64 & 0x1f_ffff;
    let turn = math::TAU / f64::from(BINS);
    let heading = ((pose.heading + math::TAU) / turn).round() as u64 % u64::from(BINS);
    cell(pose.x) << 43 | cell(pose.y) << 22 | heading
}

/// Entries by classes of their rank; those of a class newest first.
#[derive(Default)]
struct Classes {
    entries: Vec<Vec<Entry>>,
    lowest: usize,
}

impl Classes {
    /// Enters what can reach the other end: its rank is finite.
    fn push(&mut self, rank: f64, entry: Entry) {
        if rank.is_infinite() {
            return;
        }
        let class = (rank / CLASS_WIDTH) as usize;
        if class >= self.entries.len() {
            self.entries.resize_with(class + 1, Vec::new);
        }
        self.entries[class].push(entry);
        self.lowest = self.lowest.min(class);
    }

    /// The entry of the lowest rank, and that rank.
    fn pop(&mut self) -> Option<(f64, Entry)> {
        while let Some(class) = self.entries.get_mut(self.lowest) {
            if let Some(entry) = class.pop() {
                return Some((self.lowest as f64 * CLASS_WIDTH, entry));
            }
            self.lowest += 1;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, reeds_shepp};
    use crate::vehicle::collision::{Edge, Obstacles, Solid};

    /// Poses in a hall of 20 m by 12 m with these walls: the obstacles and the estimate to a pose near the right end.
    fn hall(
        walls: &[[f64; 4]],
        test: impl Fn(&CollisionChecker, &PoseHeuristic, &dyn Fn(f64, f64, f64) -> Pose),
    ) {
        let edge = |&[x, y, u, v]: &[f64; 4]| Edge { a: Point::new(x, y), b: Point::new(u, v), owner: 1 };
        let walls: Vec<Edge> = walls.iter().map(edge).collect();
        let corners = [(0.0, 0.0), (20.0, 0.0), (20.0, 12.0), (0.0, 12.0)];
        let floor = Solid { outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(), owner: 0 };
        let obstacles = Obstacles::new(&walls, &[], &floor);
        let car = Vehicle::SEDAN;
        let checker = CollisionChecker::new(&obstacles, &car);
        let pose = |x: f64, y: f64, heading: f64| obstacles.local(Pose::new(x, y, heading));
        let [root, target] = [pose(2.0, 2.0, 0.0), pose(15.0, 6.0, 0.0)];
        let flood = ObstacleHeuristic::new(&obstacles, &car, root, 0.0, None);
        let poses = PoseHeuristic::new((&checker, &car), &flood, [root, target], (0.0, 1.0), MAX_STATES);
        test(&checker, &poses, &pose);
    }

    #[test]
    fn in_an_open_hall_it_is_about_the_curve_of_the_car() {
        hall(&[], |_, poses, pose| {
            let (target, radius) = (pose(15.0, 6.0, 0.0), Vehicle::SEDAN.min_turning_radius());
            let (mut known, mut excess) = (0, 0.0);
            for step in 0..400 {
                let along = f64::from(step) / 400.0;
                let from = pose(2.0 + 12.0 * along, 2.0 + 4.0 * along, math::sin_cos(9.0 * along).0 * 0.4);
                let (curve, cost) = (reeds_shepp::distance(from, target, radius), poses.cost(from, 1, 0.0));
                if cost < UNREACHED_COST {
                    // A cell's pose lies anywhere in it and its neighbours.
                    assert!(cost > curve - 1.0, "{from:?}: {cost}, curve {curve}");
                    excess += cost - curve;
                    known += 1;
                }
                assert!(poses.cost(from, 1, 50.0) >= 50.0, "never less than another estimate");
            }
            assert!(known > 300, "{known} of 400 poses");
            assert!(excess / f64::from(known) < 2.5, "{excess} m in {known} poses");
        });
    }

    /// A disc passes the gap between the walls; a car that comes along the first cannot turn into it.
    #[test]
    fn a_gap_that_a_car_cannot_turn_into_is_no_way() {
        let gap = [[9.0, 0.0, 9.0, 9.0], [11.2, 3.0, 11.2, 12.0]];
        hall(&gap, |checker, poses, pose| {
            let from = pose(2.0, 2.0, 0.0);
            assert!(checker.hit(from, 0.0).is_none());
            assert!(poses.cost(from, 0, 0.0) >= UNREACHED_COST, "{}", poses.cost(from, 0, 0.0));
        });
    }
}
