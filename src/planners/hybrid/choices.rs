//! Paths to choose between, beside the ordinary answer: with fewer gear changes, shorter, quicker, with more room.

use core::ops::ControlFlow;

use super::config::{Config, Level, Profile, SearchFrom};
use super::level::{Search, Work};
use super::portfolio::{COMFORTABLE_MARGIN, Floods};
use super::widest::{self, GAP_PARTS};
use super::{Query, Report, Scratch, Status};
use crate::geometry::{Pose, arcs};
use crate::json;
use crate::search::Progress;
use crate::vehicle::collision::CollisionChecker;

/// The preference by which a path is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Prefer {
    /// The shortest.
    Shortest,
    /// The one with the fewest gear changes, and of those the shortest.
    FewestChanges,
    /// The one that stays farthest from every obstacle.
    Widest,
    /// The one that takes the least time to drive.
    Fastest,
}

json::words!(Prefer: "shortest" = Shortest, "fewest-changes" = FewestChanges, "widest" = Widest, "fastest" = Fastest);

/// More room than this is room enough, metres.
const ENOUGH_CLEARANCE: f64 = 1.0;
/// Margins that are tried for more room, as shares of the room at the ends.
pub(super) const MARGIN_SHARES: [f64; 5] = [0.95, 0.8, 0.65, 0.5, 0.35];
/// Expansions of each level's search with one margin.
const WIDER_EXPANSIONS: [u32; 2] = [3000, 8000];
/// Expansions of each level's search for fewer gear changes in layers.
const LAYER_EXPANSIONS: [u32; 3] = [5000, 20_000, 40_000];
/// The finest level on which fewer are looked for.
const FINEST_LAYER_LEVEL: u32 = 3;
/// Extra cost of a gear change there, metres, …
const EXTRA_CHANGE_COST: f64 = 5.0;
/// … and expansions of each such search.
const PRICED_EXPANSIONS: u32 = 20_000;
/// Expansions of each level's search for a shorter or a quicker path.
const BETTER_EXPANSIONS: [u32; 2] = [10_000, 20_000];
/// The price of a gear change where fewer are looked for: this many metres …
const CHANGE_PRICE: f64 = 100.0;
/// … and this many lengths of the first path. No way that is worth taking is as long.
const CHANGE_PRICE_LENGTHS: f64 = 3.0;
/// Time of a gear change, expressed in metres at full speed.
const CHANGE_TIME: f64 = 6.0;
/// Time to turn the wheel from straight to full lock, expressed in metres at full speed.
const STEER_TIME: f64 = 0.3;

/// Searches for paths that are better than `first` by `prefer`, or in any way where nothing is preferred; with several
/// `goals` to any of them. Each is given to `offer`, which answers whether to go on. The counters in each, and in the
/// empty report returned, count everything so far, `first` included.
pub fn choices(
    query: &Query,
    (config, goals): (&Config, &[Pose]),
    (first, prefer): (&Report, Option<Prefer>),
    (scratch, progress): (&mut Scratch, &mut Option<Progress>),
    offer: &mut dyn FnMut(Report) -> ControlFlow<()>,
) -> Report {
    let probe = CollisionChecker::new(query.obstacles, query.vehicle);
    let [start, goal] = [query.start, query.goal].map(|pose| query.obstacles.local(pose));
    let locals: Vec<Pose> = goals.iter().map(|&pose| query.obstacles.local(pose)).collect();
    let is_inside = |goal: &Pose| query.obstacles.inside(goal.point()).is_none();
    let free = |goal: &Pose| is_inside(goal) && probe.hit(*goal, 0.0).is_none();
    let goals: Vec<Pose> = locals.into_iter().filter(free).collect();
    let goals = if goals.len() > 1 { &goals[..] } else { &[] };
    let widest = if goals.is_empty() { 0.0 } else { widest::clearance(&probe, start, &first.arcs) };
    let mut margins = if goals.is_empty() {
        let room = probe.clearance(start, ENOUGH_CLEARANCE).min(probe.clearance(goal, ENOUGH_CLEARANCE));
        MARGIN_SHARES.map(|share| share * room).to_vec()
    } else {
        widest::margins(&probe, start, goals, widest)
    };
    margins.retain(|&margin| margin > first.margin);
    let parts = if goals.is_empty() { 1 } else { GAP_PARTS };
    let kept = margins.len();
    margins.extend([first.margin, COMFORTABLE_MARGIN]);
    let mirrored = !goals.is_empty() || first.from_goal || config.search_from == SearchFrom::Both;
    let [root, target] = if mirrored { [goal, start] } else { [start, goal] };
    let floods = Floods::with(query, [target, root], margins);
    let config = &Config { search_from: SearchFrom::Goal, ..*config };
    let flood = floods.get(kept, false);
    let (tight, trace) = (false, false);
    let search = Search {
        query,
        config,
        probe: &probe,
        flood,
        root,
        target,
        mirrored,
        start,
        goal,
        tight,
        trace,
        goals,
    };
    let mut report = first.counters();
    let work = Work { report: &mut report, scratch, progress };
    let changes = arcs::direction_changes(&first.arcs);
    let mut run = Run { search, floods: &floods, kept, parts, widest, changes, first, work, offer };
    let wants = |one| prefer.is_none_or(|prefer| prefer == one);
    let _ = run.all(&wants);
    report.collision_checks += probe.checks();
    report
}

/// Whether the search goes on (true), and the arcs found.
type Goes<T = ()> = ControlFlow<(), T>;

/// The searches for paths beside the first.
struct Run<'a, 'p> {
    search: Search<'a>,
    floods: &'a Floods<'a>,
    /// Which margin the first path keeps; those before it are larger.
    kept: usize,
    /// Every how many of those are tried before the ones between.
    parts: usize,
    /// Clearance of the widest path so far to one of several goals, metres.
    widest: f64,
    /// Gear changes of the path with the fewest so far.
    changes: u32,
    first: &'a Report,
    work: Work<'a, 'p>,
    offer: &'a mut dyn FnMut(Report) -> Goes,
}

impl Run<'_, '_> {
    fn all(&mut self, wants: &dyn Fn(Prefer) -> bool) -> Goes {
        if wants(Prefer::FewestChanges) {
            self.fewer_changes()?;
        }
        if wants(Prefer::Shortest) {
            self.cheaper(0.0, 0.0)?;
        }
        if wants(Prefer::Fastest) {
            self.cheaper(CHANGE_TIME, STEER_TIME)?;
        }
        if wants(Prefer::Widest) {
            self.wider()?;
        }
        Goes::Continue(())
    }

    /// The fewest gear changes, and of those paths the shortest, with the margin kept and with 3 cm. In layers on
    /// coarse lattices, from both ends on the coarsest; on fine ones, which would spend all they have on the first
    /// layers, by a price that is worth a detour. From the other end fine steps only spend their budget: it is the one
    /// with room.
    fn fewer_changes(&mut self) -> Goes {
        let last = self.kept + usize::from(self.first.margin > COMFORTABLE_MARGIN);
        for margin in self.kept..=last {
            self.layers(0, margin, false)?;
            if self.work.report.status != Status::NoPath {
                self.layers(0, margin, true)?;
            }
            for number in 1..=FINEST_LAYER_LEVEL {
                self.fewer_by_price(number, margin)?;
                self.layers(number, margin, false)?;
            }
        }
        Goes::Continue(())
    }

    /// All that can be reached without a gear change, then with one, and so on, short of as many as are known: layers
    /// of one search, in which a change is dearer than any way.
    fn layers(&mut self, number: u32, margin: usize, is_swapped: bool) -> Goes {
        let config = *self.search.config;
        // Fine steps find nothing without changes that coarse ones do not. From the start a search leads to one goal.
        if (is_swapped && !self.search.goals.is_empty())
            || number >= config.levels()
            || number as usize >= LAYER_EXPANSIONS.len()
            || self.changes < number.max(1)
        {
            return Goes::Continue(());
        }
        let price = CHANGE_PRICE + CHANGE_PRICE_LENGTHS * arcs::length(&self.first.arcs);
        let level = Level {
            extra_change: price - config.with_profile().direction_change_cost,
            bound: price * f64::from(self.changes),
            ..config.level(number)
        };
        let most = LAYER_EXPANSIONS[number as usize];
        self.attempt(&config, (level, number, most), margin, is_swapped)?;
        if number == 0 && !is_swapped && self.changes > 0 {
            // The order of the search decides which pose stands for a cell. Without an estimate it goes through each
            // layer as an exhaustive search does, and misses nothing that this one finds.
            let all = Level { weight: 0.0, bound: price * f64::from(self.changes), ..level };
            self.attempt(&config, (all, number, most), margin, false)?;
        }
        Goes::Continue(())
    }

    fn fewer_by_price(&mut self, number: u32, margin: usize) -> Goes {
        let config = *self.search.config;
        if number >= config.levels() || self.changes < 2 {
            return Goes::Continue(());
        }
        let level = Level { extra_change: EXTRA_CHANGE_COST, ..config.level(number) };
        self.attempt(&config, (level, number, PRICED_EXPANSIONS), margin, false)?;
        Goes::Continue(())
    }

    /// Paths that cost less by these prices of a gear change and of turning the wheel, and nothing else.
    fn cheaper(&mut self, change: f64, steer_change: f64) -> Goes {
        let config = Config {
            profile: Profile::Shortest,
            reverse_cost: 1.0,
            direction_change_cost: change,
            steer_cost: 0.0,
            steer_change_cost: steer_change,
            obstacle_cost: 0.0,
            ..*self.search.config
        };
        for (number, most) in (0..config.levels()).zip(BETTER_EXPANSIONS) {
            let level = Level { extra_change: 0.0, ..config.level(number) };
            self.attempt(&config, (level, number, most), self.kept, false)?;
        }
        Goes::Continue(())
    }

    /// A path with the largest margin that there is one with, and with that margin a path to each goal that has more
    /// room.
    fn wider(&mut self) -> Goes {
        let tried = (0..self.kept).step_by(self.parts);
        let (mut found, mut failed) = (self.kept, self.kept);
        for margin in tried {
            if self.with_margin(margin)? {
                (found, failed) = (margin, margin.saturating_sub(self.parts));
                break;
            }
        }
        while found > failed + 1 {
            let middle = usize::midpoint(found, failed);
            if self.with_margin(middle)? {
                found = middle;
            } else {
                failed = middle;
            }
        }
        self.wider_to_each(found)
    }

    /// A path with one of the margins to each goal that has more room than any path so far, those with the most room
    /// first.
    fn wider_to_each(&mut self, margin: usize) -> Goes {
        let goals = self.search.goals;
        for (room, at) in widest::by_room(self.search.probe, self.search.start, goals) {
            if room <= self.widest {
                break;
            }
            self.search.goals = &goals[at..=at];
            self.with_margin(margin)?;
        }
        self.search.goals = goals;
        Goes::Continue(())
    }

    /// A path with one of the margins; tells whether there is one.
    fn with_margin(&mut self, margin: usize) -> Goes<bool> {
        let config = *self.search.config;
        for (number, most) in (0..config.levels()).zip(WIDER_EXPANSIONS) {
            if self.attempt(&config, (config.level(number), number, most), margin, false)? {
                return Goes::Continue(true);
            }
        }
        Goes::Continue(false)
    }

    /// One search with at most so many expansions; tells whether there is a path, which is offered.
    fn attempt(
        &mut self,
        config: &Config,
        (level, number, most): (Level, u32, u32),
        margin: usize,
        is_swapped: bool,
    ) -> Goes<bool> {
        self.work.report.status = Status::NoPath;
        let flood = self.floods.get(margin, is_swapped);
        let search = Search { config, ..self.search };
        let search = if is_swapped { search.swapped(flood) } else { Search { flood, ..search } };
        let reaches = |pose: Pose| flood.distance(pose).is_finite();
        if !reaches(search.root) && !search.goals.iter().any(|&goal| reaches(goal)) {
            return Goes::Continue(false);
        }
        let level = Level { max_expansions: most.min(level.max_expansions), ..level };
        (self.work.report.margin, self.work.report.level) = (self.floods.margin(margin), number);
        let found = search.level(level, &mut self.work);
        if self.work.progress.as_ref().is_some_and(Progress::is_stopped) {
            return Goes::Break(());
        }
        if found {
            let counters = self.work.report.counters();
            let mut path = core::mem::replace(self.work.report, counters);
            self.changes = self.changes.min(arcs::direction_changes(&path.arcs));
            if !self.search.goals.is_empty() {
                let clearance = widest::clearance(self.search.probe, self.search.start, &path.arcs);
                self.widest = self.widest.max(clearance);
            }
            let costs = self.search.arrived(&path.arcs).costs();
            path.cost = costs.path(self.search.probe, self.search.start, &path.arcs);
            path.status = Status::Suboptimal;
            self.work.report.status = Status::Suboptimal;
            (self.offer)(path)?;
        }
        Goes::Continue(found)
    }
}

#[cfg(test)]
mod tests {
    use core::cell::RefCell;
    use std::cmp::Ordering;
    use std::collections::{BinaryHeap, HashMap, HashSet};

    use super::super::domain::{Setting, State, StateLattice};
    use super::super::obstacle_heuristic::ObstacleHeuristic;
    use super::super::state_index::StateIndex;
    use super::*;
    use crate::geometry::Point;
    use crate::search::{self, Domain, End, Limits, NodeId, Relax, Visit, best_first};
    use crate::vehicle::Vehicle;
    use crate::vehicle::collision::{Obstacles, Solid};

    const CHANGE_PRICE: f64 = 1000.0;
    const CART: Vehicle = Vehicle {
        wheelbase: 1.2,
        width: 0.9,
        rear_to_front: 1.6,
        rear_to_back: 0.4,
        max_steer: 0.6,
        max_steer_rate: 0.5,
    };

    /// Numbers that are the same everywhere, from 0 to 1.
    fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5bf0_3635;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1_u64 << 31) as f64
        }
    }

    fn rectangle(x: f64, y: f64, width: f64, height: f64, owner: u32) -> Solid {
        let corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)];
        Solid { outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(), owner }
    }

    /// A small room with boxes in it and two poses without contact.
    fn room(seed: u64) -> Option<(Obstacles, [Pose; 2])> {
        let mut next = numbers(seed);
        let (width, height) = (5.0 + 4.0 * next(), 4.0 + 3.0 * next());
        let mut boxes = Vec::new();
        for owner in 1..=(4.0 * next()) as u32 {
            boxes.push(rectangle(width * next(), height * next(), 0.3 + next(), 0.3 + next(), owner));
        }
        let obstacles = Obstacles::new(&[], &boxes, &rectangle(-0.5, -0.5, width + 1.0, height + 1.0, 0));
        let probe = CollisionChecker::new(&obstacles, &CART);
        let mut pose = || {
            Pose::new(
                width * next(),
                height * next(),
                core::f64::consts::TAU * next() - core::f64::consts::PI,
            )
        };
        let ends = [pose(), pose()].map(|pose| obstacles.local(pose));
        let is_free =
            |&pose: &Pose| probe.hit(pose, 0.0).is_none() && obstacles.inside(pose.point()).is_none();
        ends.iter().all(is_free).then_some((obstacles, ends))
    }

    /// With `weight` 0 both searches expand in the same order, so that each cell has the same pose in both.
    fn lattice<'a>(
        probe: &'a CollisionChecker<'a>,
        flood: &'a ObstacleHeuristic,
        keys: &'a RefCell<StateIndex>,
        target: Pose,
        weight: f64,
        bound: f64,
    ) -> StateLattice<'a> {
        let config = Config { profile: Profile::Shortest, max_direction_changes: 1, ..Config::default() };
        let level = Level {
            xy: 0.5,
            yaw: 0.35,
            step: 0.7,
            extra_change: CHANGE_PRICE - config.direction_change_cost,
            weight,
            bound,
            ..config.level(1)
        };
        let radius = CART.min_turning_radius();
        let costs =
            super::super::cost::CostModel::driven(&config, radius, [target, target]).searching(&level);
        let setting = Setting { probe, flood, keys, costs, mirrored: false, watch: None, roots: &[] };
        StateLattice::new(setting, &CART, &config, level, target, 0.02)
    }

    struct Moves(Vec<(NodeId, f64, State)>);

    impl Relax<f64, State> for Moves {
        fn improves(&self, _: NodeId, _: f64) -> bool {
            true
        }

        fn emit(&mut self, target: NodeId, cost: f64, label: State) {
            self.0.push((target, cost, label));
        }
    }

    struct Waiting(f64, u32, NodeId, State);

    impl PartialEq for Waiting {
        fn eq(&self, other: &Self) -> bool {
            self.cmp(other) == Ordering::Equal
        }
    }

    impl Eq for Waiting {}

    impl Ord for Waiting {
        fn cmp(&self, other: &Self) -> Ordering {
            other.0.total_cmp(&self.0).then(other.1.cmp(&self.1))
        }
    }

    impl PartialOrd for Waiting {
        fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
            Some(self.cmp(other))
        }
    }

    /// The fewest changes, by going through everything that can be reached with none, then with one, and so on.
    fn exhaustive(lattice: &mut StateLattice, root: Pose) -> Option<u32> {
        let node = lattice.node(root, 0);
        let mut layers =
            vec![BinaryHeap::from([Waiting(0.0, 0, node, State { pose: root, ..State::default() })])];
        let (mut closed, mut shortest) = (HashSet::new(), HashMap::from([(node, (0, 0.0))]));
        let (mut best, mut ticket): (Option<u32>, u32) = (None, 0);
        for changes in 0.. {
            if changes >= layers.len() || best.is_some_and(|best| best <= changes as u32) {
                return best;
            }
            while let Some(Waiting(length, _, node, label)) = layers[changes].pop() {
                if shortest[&node] != (changes, length) || !closed.insert(node) {
                    continue;
                }
                let at = Visit { node, label, g: length, parent: None };
                if let Some(finish) = lattice.finish(at, f64::INFINITY) {
                    let all = changes as u32 + (finish.cost / CHANGE_PRICE) as u32;
                    best = Some(best.map_or(all, |best| best.min(all)));
                }
                let mut moves = Moves(Vec::new());
                lattice.successors(at, &mut moves);
                for (target, cost, label) in moves.0 {
                    let is_change = cost >= CHANGE_PRICE;
                    let layer = changes + usize::from(is_change);
                    let length = length + if is_change { cost - CHANGE_PRICE } else { cost };
                    let is_better =
                        shortest.get(&target).is_none_or(|&(least, way)| (layer, length) < (least, way));
                    if closed.contains(&target)
                        || !is_better
                        || lattice.heuristic(target, label) == f64::INFINITY
                    {
                        continue;
                    }
                    shortest.insert(target, (layer, length));
                    ticket += 1;
                    if layers.len() <= layer {
                        layers.resize_with(layer + 1, BinaryHeap::new);
                    }
                    layers[layer].push(Waiting(length, ticket, target, label));
                }
            }
        }
        best
    }

    #[test]
    fn a_price_above_every_way_finds_the_fewest_changes() {
        let limits = Limits { max_expansions: 1_000_000, first: false };
        let (mut rooms, mut tally, mut alike, mut fewer) = (0, [0; 6], 0, 0);
        for (obstacles, [root, target]) in (0..).filter_map(room) {
            let (probe, keys) =
                (CollisionChecker::new(&obstacles, &CART), RefCell::new(StateIndex::default()));
            let flood = ObstacleHeuristic::new(&obstacles, &CART, target, 0.02, None);
            if flood.distance(root).is_infinite() {
                continue;
            }
            let fewest = exhaustive(&mut lattice(&probe, &flood, &keys, target, 0.0, f64::INFINITY), root);
            let searched = |weight: f64, bound: f64| {
                let mut lattice = lattice(&probe, &flood, &keys, target, weight, bound);
                let begin = (lattice.node(root, 0), State { pose: root, ..State::default() });
                let found = best_first(&mut lattice, begin, limits, &mut search::Scratch::default(), &mut ());
                assert_ne!(found.end, End::BudgetSpent);
                found.found.map(|found| (found.1 / CHANGE_PRICE) as u32)
            };
            assert_eq!(searched(0.0, f64::INFINITY), fewest);
            // As the planner asks: with the estimate, then without it for fewer.
            let quick = searched(1.0, f64::INFINITY);
            alike += u32::from(quick == fewest);
            let bound = quick.map_or(f64::INFINITY, |quick| CHANGE_PRICE * f64::from(quick));
            let asked = searched(0.0, bound).or(quick);
            let none = u32::MAX;
            assert!(asked.unwrap_or(none) <= fewest.unwrap_or(none), "{asked:?}, exhaustive {fewest:?}");
            fewer += u32::from(asked != fewest);
            if let Some(fewest) = fewest {
                assert_eq!(searched(0.0, CHANGE_PRICE * f64::from(fewest)), None, "none with fewer");
                assert_eq!(searched(0.0, CHANGE_PRICE * f64::from(fewest + 1)), Some(fewest));
            }
            tally[fewest.map_or(5, |fewest| fewest.min(4) as usize)] += 1;
            rooms += 1;
            if rooms == 200 {
                break;
            }
        }
        println!(
            "changes 0 to 4, none: {tally:?}; with the estimate alone as many {alike} times of 200, as asked fewer {fewer} times"
        );
        assert!(tally[..3].iter().all(|&rooms| rooms >= 20) && tally[5] >= 5, "{tally:?}");
        // Where the order differs, so may the pose that stands for a cell, by which a path may also save a change.
        assert!(alike >= 180 && fewer <= 20, "{alike} {fewer}");
    }
}
