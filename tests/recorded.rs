//! Recorded searches against the planners' own events, and against a plain open list that is looked through.

use std::collections::BTreeMap;

use crate::random_maps::random_map;
use crate::recordings::{follows_the_rules, offers};
use parkade::map::{Bits, Cell, Corner, Occupancy, line_of_sight};
use parkade::planners::moves::Neighbourhood;
use parkade::planners::query::{GridReport, GridScratch, Query};
use parkade::planners::risk_field::Fallback;
use parkade::planners::settings::Common;
use parkade::planners::{any_angle, bidirectional, dijkstra_greedy, grid_astar, jump_point, risk_field};
use parkade::scenario::generate::SplitMix64;
use parkade::search::{BACKWARD, Fate, Observer, PAST, Recording, StepKind, Stop};

const MAPS: u64 = 100;
/// The least and the additional cells of a random map's sides.
const SIDES: [u32; 2] = [2, 26];
const CORNERS: [Corner; 3] = [Corner::Strict, Corner::NoSqueeze, Corner::Free];

/// A planner's own events.
struct Events<C = i64> {
    expanded: Vec<(u32, C)>,
    relaxed: Vec<(u32, u32, C)>,
}

impl<C> Default for Events<C> {
    fn default() -> Self {
        Self { expanded: Vec::new(), relaxed: Vec::new() }
    }
}

impl<C, L> Observer<C, L> for Events<C> {
    fn expanded(&mut self, node: u32, _: L, g: C) {
        self.expanded.push((node, g));
    }

    fn relaxed(&mut self, node: u32, parent: u32, _: L, g: C) {
        self.relaxed.push((node, parent, g));
    }
}

fn is(fate: u8, one: Fate) -> bool {
    fate == one as u8
}

/// The recording has the planner's own expansions, relaxed moves and counters, in its own order.
fn equals_the_planner(report: &GridReport, events: &Events, r: &Recording) {
    let rejected = |kind: u8| kind % BACKWARD == StepKind::Rejected as u8;
    let steps: Vec<_> = (0..r.nodes.len()).filter(|&step| !rejected(r.kinds[step])).collect();
    let expanded: Vec<_> = steps.iter().map(|&step| (r.nodes[step], r.g[step] as i64)).collect();
    assert_eq!(expanded, events.expanded);
    let mut relaxed = Vec::new();
    for step in steps.into_iter().filter(|&step| r.kinds[step] != StepKind::Goal as u8) {
        let kept = offers(r, step).filter(|one| is(one.1, Fate::Kept) || is(one.1, Fate::Improved));
        relaxed.extend(kept.map(|one| (one.0, r.nodes[step], one.2 as i64)));
    }
    assert_eq!(relaxed, events.relaxed);
    assert_eq!(
        (r.stats.expanded, r.stats.generated, r.stats.pushes, r.stats.open_peak),
        (report.stats.expanded, report.stats.generated, report.stats.pushes, report.stats.open_peak)
    );
}

/// Blocked and corner are told of the map, and all moves of a neighbourhood are told of.
fn knows_the_map(r: &Recording, query: Query, around: Neighbourhood, corner: Corner) {
    for step in 0..r.nodes.len() {
        if !matches!(r.kinds[step] % BACKWARD, 0 | 1) {
            continue;
        }
        let at = query.map.cell(r.nodes[step]);
        let mut told: Vec<u32> =
            offers(r, step).filter(|one| !is(one.1, Fate::Requeued)).map(|one| one.0).collect();
        told.sort_unstable();
        let mut all: Vec<u32> = around
            .moves()
            .into_iter()
            .map(|m| at.offset(m.dx, m.dy))
            .filter(|&to| query.map.contains(to))
            .map(|to| query.map.index(to))
            .collect();
        all.sort_unstable();
        assert_eq!(told, all);
        for (target, fate, ..) in offers(r, step) {
            let to = query.map.cell(target);
            assert_eq!(is(fate, Fate::Blocked), query.map.blocked(to));
            let is_cut = !query.map.blocked(to) && !line_of_sight(query.map, at, to, corner);
            assert_eq!(is(fate, Fate::Corner), is_cut);
        }
    }
}

fn roots(query: Query) -> [u32; 2] {
    [query.start, query.goal].map(|cell| query.map.index(cell))
}

/// Runs a check on random maps, with a different corner rule on each.
fn on_random_maps(seed: u64, mut check: impl FnMut(Query, Corner)) {
    let mut random = SplitMix64::new(seed);
    let mut searched = 0;
    while searched < MAPS {
        let (map, start, goal) = random_map(&mut random, SIDES, 45);
        if start != goal {
            check(Query { map: &map, start, goal }, CORNERS[searched as usize % 3]);
            searched += 1;
        }
    }
}

#[test]
fn grid_searches_are_recorded_as_they_are() {
    for around in Neighbourhood::ALL {
        on_random_maps(11, |query, corner| {
            let common = Common { corner, ..Common::PLAIN };
            let config = grid_astar::Config { common, ..grid_astar::Config::new(around) };
            let mut events = Events::default();
            let report = grid_astar::plan(query, around, &config, &mut GridScratch::new(), &mut events);
            let r = grid_astar::record(query, around, &config, usize::MAX);
            equals_the_planner(&report, &events, &r);
            follows_the_rules(&r, roots(query));
            knows_the_map(&r, query, around, corner);
        });
    }
}

#[test]
fn risk_fields_are_recorded_with_what_they_hold_back() {
    let fallbacks = [Fallback::Penalty, Fallback::Lexicographic, Fallback::StuckOnly, Fallback::None];
    for preset in [risk_field::Config::PAPER, risk_field::Config::PLUS] {
        let (mut held, mut requeued) = (0, 0);
        for fallback in fallbacks {
            on_random_maps(12, |query, corner| {
                let config =
                    risk_field::Config { fallback, common: Common { corner, ..preset.common }, ..preset };
                let mut events = Events::default();
                let report = risk_field::plan(query, &config, &mut GridScratch::new(), &mut events);
                let r = risk_field::record(query, &config, usize::MAX);
                // Where a rule may lose the way, the planner asks plain A* whether there is one: not watched.
                equals_the_planner(&report, &events, &r);
                follows_the_rules(&r, roots(query));
                held += r.fates.iter().filter(|&&fate| is(fate, Fate::HeldBack)).count();
                requeued += r.fates.iter().filter(|&&fate| is(fate, Fate::Requeued)).count();
            });
        }
        assert!(held > 100 && requeued > 100, "{held} {requeued}");
    }
}

#[test]
fn searches_from_both_ends_are_recorded_until_they_meet() {
    for stop in [Stop::First, Stop::Best, Stop::Optimal, Stop::Naive] {
        let mut met = 0;
        on_random_maps(13, |query, corner| {
            let common = Common { corner, ..Common::PLAIN };
            let config = bidirectional::Config { stop, common, ..bidirectional::Config::default() };
            let mut events = Events::default();
            let report = bidirectional::plan(query, &config, &mut GridScratch::new(), &mut events);
            let r = bidirectional::record(query, &config, usize::MAX);
            equals_the_planner(&report, &events, &r);
            follows_the_rules(&r, roots(query));
            let rejected =
                r.kinds.iter().filter(|&&kind| kind % BACKWARD == StepKind::Rejected as u8).count();
            assert_eq!(rejected, report.rejected.unwrap_or_default() as usize);
            met += usize::from(r.kinds.last().is_some_and(|kind| kind % BACKWARD == StepKind::Meet as u8));
        });
        assert_eq!(met > 20, stop != Stop::Optimal, "{stop:?} {met}");
    }
}

#[test]
fn jumps_and_plain_searches_are_recorded_as_they_are() {
    on_random_maps(14, |query, _| {
        let config = jump_point::Config::default();
        let bits = Bits::new(query.map);
        let mut events = Events::default();
        let report = jump_point::plan(query, &bits, &config, &mut GridScratch::new(), &mut events);
        let r = jump_point::record(query, &bits, &config, usize::MAX);
        equals_the_planner(&report, &events, &r);
        follows_the_rules(&r, roots(query));
        let config = dijkstra_greedy::Config::default();
        let mut events = Events::default();
        let report = dijkstra_greedy::greedy(query, &config, &mut GridScratch::new(), &mut events);
        let r = dijkstra_greedy::record_greedy(query, &config, usize::MAX);
        equals_the_planner(&report, &events, &r);
        follows_the_rules(&r, roots(query));
        let report = dijkstra_greedy::dijkstra(query, &config, &mut GridScratch::new(), &mut ());
        let r = dijkstra_greedy::record_dijkstra(query, &config, usize::MAX);
        follows_the_rules(&r, roots(query));
        knows_the_map(&r, query, config.neighbours, config.common.corner);
        assert_eq!((r.stats.expanded, r.stats.generated), (report.stats.expanded, report.stats.generated));
    });
}

/// Theta* as one writes it down: a cell hangs on its parent's parent where that sees it.
fn parents_see_their_cells(r: &Recording, query: Query, corner: Corner) {
    let far = |a: Cell, b: Cell| {
        let [x, y] = [b.x - a.x, b.y - a.y].map(f64::from);
        (x * x + y * y).sqrt()
    };
    let mut known = BTreeMap::from([(query.map.index(query.start), (0.0, None::<u32>))]);
    for step in 0..r.nodes.len() {
        let (node, at) = (r.nodes[step], query.map.cell(r.nodes[step]));
        let (g, parent) = known[&node];
        assert_eq!((g, r.h[step]), (r.g[step], far(at, query.goal)));
        for move_ in r.first[step] as usize..r.first[step + 1] as usize {
            let (target, to) = (r.targets[move_], query.map.cell(r.targets[move_]));
            if matches!(r.fates[move_] % PAST, 3..=5) {
                continue;
            }
            let sees = |parent: &u32| line_of_sight(query.map, query.map.cell(*parent), to, corner);
            let past = parent.filter(sees);
            assert_eq!(past.is_some(), r.fates[move_] >= PAST);
            let from = past.unwrap_or(node);
            let expected = known[&from].0 + far(query.map.cell(from), to);
            assert!((r.target_g[move_] - expected).abs() < 1e-9);
            if r.fates[move_] % PAST < 2 {
                known.insert(target, (r.target_g[move_], Some(from)));
            }
        }
    }
}

#[test]
fn any_angle_searches_are_recorded_as_they_are() {
    let mut past = 0;
    on_random_maps(15, |query, corner| {
        let config = any_angle::Config { common: Common { corner, ..Common::PLAIN } };
        let mut events = Events::default();
        let report = any_angle::plan(query, &config, &mut GridScratch::new(), &mut events);
        let r = any_angle::record(query, &config, usize::MAX);
        let steps: Vec<_> = r.nodes.iter().copied().zip(r.g.iter().copied()).collect();
        assert_eq!(steps, events.expanded);
        let taken = r.fates.iter().filter(|&&fate| fate % PAST < 2).count();
        assert_eq!(taken, events.relaxed.len());
        assert_eq!(
            (r.stats.expanded, r.stats.generated, r.stats.pushes, r.stats.open_peak),
            (report.stats.expanded, report.stats.generated, report.stats.pushes, report.stats.open_peak)
        );
        follows_the_rules(&r, roots(query));
        knows_the_map(&r, query, Neighbourhood::Eight, corner);
        parents_see_their_cells(&r, query, corner);
        past += r.fates.iter().filter(|&&fate| fate >= PAST).count();
    });
    assert!(past > 1000, "{past}");
}

#[test]
fn a_limit_cuts_the_recording_and_says_so() {
    let map = Occupancy::new(20, 20);
    let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(19, 19) };
    let config = dijkstra_greedy::Config::default();
    let whole = dijkstra_greedy::record_dijkstra(query, &config, usize::MAX);
    let part = dijkstra_greedy::record_dijkstra(query, &config, 50);
    assert!(part.is_cut && !whole.is_cut);
    assert_eq!(part.nodes, whole.nodes[..50]);
    assert_eq!(part.first.last().copied(), Some(part.targets.len() as u32));
}
