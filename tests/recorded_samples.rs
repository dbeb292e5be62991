//! Recordings of the planners without an open list, RRT and the genetic algorithm, against their own events and the
//! map.

use crate::random_maps::random_map;
use parkade::map::{Cell, Occupancy, line_of_sight};
use parkade::planners::moves::cost;
use parkade::planners::query::{GridScratch, Query};
use parkade::planners::settings::Common;
use parkade::planners::{Outcome, genetic, rrt};
use parkade::scenario::generate::SplitMix64;
use parkade::search::{Fate, Observer, Recording, StepKind};

const MAPS: u64 = 100;
const EXPANSIONS: u32 = 400;

/// A planner's own expansions.
#[derive(Default)]
struct Expanded(Vec<(u32, i64)>);

impl<L> Observer<i64, L> for Expanded {
    fn expanded(&mut self, node: u32, _: L, g: i64) {
        self.0.push((node, g));
    }
}

fn on_random_maps(seed: u64, mut check: impl FnMut(Query, Common)) {
    let mut random = SplitMix64::new(seed);
    let mut searched = 0;
    while searched < MAPS {
        let (map, start, goal) = random_map(&mut random, [4, 26], 40);
        if start != goal {
            check(Query { map: &map, start, goal }, Common { max_expansions: EXPANSIONS, ..Common::PLAIN });
            searched += 1;
        }
    }
}

fn between(map: &Occupancy, a: u32, b: u32) -> i64 {
    let [a, b] = [a, b].map(|node| map.cell(node));
    cost(b.x - a.x, b.y - a.y)
}

/// Per step the targets, fates and costs of its moves.
fn moves(r: &Recording, step: usize) -> Vec<(u32, u8, i64)> {
    let all = r.first[step] as usize..r.first[step + 1] as usize;
    all.map(|at| (r.targets[at], r.fates[at], r.target_g[at] as i64)).collect()
}

#[test]
fn trees_are_recorded_as_they_grow() {
    let (mut found, mut fates) = (0, [0; 10]);
    on_random_maps(31, |query, common| {
        let config = rrt::Config { common, step: 4.0, ..rrt::Config::DEFAULT };
        let mut events = Expanded::default();
        let report = rrt::plan(query, &config, &mut GridScratch::new(), &mut events);
        let r = rrt::record(query, &config, usize::MAX);
        assert_eq!(
            [r.stats.expanded, r.stats.generated, r.stats.pushes, r.stats.open_peak],
            [report.stats.expanded, report.stats.generated, report.stats.pushes, report.stats.open_peak]
        );
        let map = query.map;
        let start = map.index(query.start);
        let mut tree = vec![(start, 0)];
        let draws = r.nodes.len() - usize::from(r.kinds.last() == Some(&(StepKind::Goal as u8)));
        for (step, &expanded) in events.0.iter().enumerate().take(draws) {
            assert_eq!((r.nodes[step], r.g[step] as i64), expanded);
            let [(towards, drawn, _), (to, fate, g)] = moves(&r, step)[..] else { panic!("two moves") };
            assert_eq!(drawn, Fate::Drawn as u8);
            let squared = |node: u32| {
                let [a, b] = [node, towards].map(|node| map.cell(node));
                (a.x - b.x).pow(2) + (a.y - b.y).pow(2)
            };
            let &nearest = tree.iter().min_by_key(|one| squared(one.0)).unwrap();
            assert_eq!(nearest, expanded);
            assert_eq!(r.h[step] as i64, between(map, nearest.0, towards));
            assert_eq!(g, nearest.1 + between(map, nearest.0, to));
            let [from, at]: [Cell; 2] = [nearest.0, to].map(|node| map.cell(node));
            let expected = if map.blocked(at) {
                Fate::Blocked
            } else if tree.iter().any(|one| one.0 == to) {
                Fate::Closed
            } else if line_of_sight(map, from, at, common.corner) {
                Fate::Kept
            } else {
                Fate::Corner
            };
            assert_eq!(fate, expected as u8);
            fates[fate as usize] += 1;
            if expected == Fate::Kept {
                tree.push((to, g));
            }
        }
        assert_eq!(draws, events.0.len());
        if report.outcome == Outcome::Found {
            found += 1;
            assert_eq!(tree.last(), Some(&(map.index(query.goal), report.cost_micro)));
            assert_eq!(r.kinds.last(), Some(&(StepKind::Goal as u8)));
            assert_eq!(r.nodes.last(), Some(&map.index(query.goal)));
        }
    });
    assert!(found > 50 && [0, 3, 4, 5].iter().all(|&fate| fates[fate] > 100), "{found} {fates:?}");
}

#[test]
fn candidates_are_recorded_with_their_legs() {
    let mut found = 0;
    on_random_maps(32, |query, common| {
        let config = genetic::Config { common, ..genetic::Config::DEFAULT };
        let mut events = Expanded::default();
        let report = genetic::plan(query, &config, &mut GridScratch::new(), &mut events);
        let r = genetic::record(query, &config, usize::MAX);
        assert_eq!([r.stats.expanded, r.stats.open_peak], [report.stats.expanded, report.stats.open_peak]);
        let fitness: Vec<_> = r.f.iter().map(|&f| f as i64).collect();
        assert_eq!(fitness, events.0.iter().map(|one| one.1).collect::<Vec<_>>());
        let mut best = None;
        for (step, &fitness) in fitness.iter().enumerate() {
            assert_eq!(r.kinds[step], StepKind::Candidate as u8);
            let (mut at, mut length, mut is_free) = (query.map.index(query.start), 0, true);
            assert_eq!(r.nodes[step], at);
            for (to, fate, g) in moves(&r, step) {
                length += between(query.map, at, to);
                assert_eq!(g, length);
                let [a, b] = [at, to].map(|node| query.map.cell(node));
                let free = line_of_sight(query.map, a, b, common.corner);
                assert_eq!(fate, if free { Fate::Drawn } else { Fate::Blocked } as u8);
                is_free &= free;
                at = to;
            }
            assert_eq!(at, query.map.index(query.goal));
            assert!(if is_free { fitness == length } else { fitness > length });
            if is_free {
                best = Some(best.map_or(fitness, |best: i64| best.min(fitness)));
            }
        }
        let answer = (report.outcome == Outcome::Found).then_some(report.cost_micro);
        assert_eq!(best, answer);
        found += u32::from(answer.is_some());
    });
    assert!(found > 50, "{found}");
}

#[test]
fn a_limit_cuts_them() {
    let map = Occupancy::new(20, 20);
    let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(19, 19) };
    let [part, whole] = [5, usize::MAX].map(|limit| {
        (
            rrt::record(query, &rrt::Config::DEFAULT, limit),
            genetic::record(query, &genetic::Config::DEFAULT, limit),
        )
    });
    for (part, whole) in [(&part.0, &whole.0), (&part.1, &whole.1)] {
        assert!(part.is_cut && !whole.is_cut);
        assert_eq!((&part.nodes[..], part.stats.expanded), (&whole.nodes[..5], whole.stats.expanded));
        assert_eq!(part.first.last().copied(), Some(part.targets.len() as u32));
    }
}
