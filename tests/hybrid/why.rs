//! What a search shows of itself: its tree, the connections that failed, and where it fails when there is no path.

use std::f64::consts::PI;

use parkade::geometry::{Pose, math};
use parkade::planners::hybrid::{Config, Query, Report, Scratch, SearchFrom, Status, plan};
use parkade::planners::{Obstruction, Region};

use super::lot::{BORDER, CAR, Lot, pose};

/// As [`Lot::plan`], with the trace.
fn traced(lot: &Lot, config: &Config) -> Report {
    let obstacles = lot.obstacles();
    let (start, goal) = (pose(lot.start), pose(lot.goal));
    let query = Query { obstacles: &obstacles, vehicle: &CAR, start, goal };
    plan(&query, config, &mut Scratch::default(), true, &mut None)
}

fn pose_of(numbers: &[f64]) -> Pose {
    Pose::new(numbers[0], numbers[1], numbers[2])
}

fn near(a: Pose, b: Pose) -> bool {
    (a.point() - b.point()).norm() < 1e-6 && math::turn(a.heading, b.heading).abs() < 1e-6
}

/// The search's poses: the root and the far ends of the tree's arcs.
fn reached(report: &Report, root: Pose, mirrored: bool) -> Vec<Pose> {
    let ends = report.tree.chunks(5).map(|arc| {
        let from = pose_of(arc);
        if mirrored { from } else { from.advance(arc[3], arc[4]) }
    });
    core::iter::once(root).chain(ends).collect()
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn failed_connections_lead_from_the_tree_to_what_they_hit() {
    for search_from in [SearchFrom::Goal, SearchFrom::Start] {
        let config = Config { search_from, max_expansions: Some(300), ladder: false, ..Config::default() };
        let lot = Lot::of("L2");
        let report = traced(&lot, &config);
        let plain = lot.plan(&config);
        assert_eq!((&plain.arcs, plain.collision_checks), (&report.arcs, report.collision_checks));
        assert!(plain.tree.is_empty() && plain.failed_expansions.first.is_empty());

        let mirrored = search_from == SearchFrom::Goal;
        let poses = reached(&report, pose(if mirrored { lot.goal } else { lot.start }), mirrored);
        let gears = [1.0, -1.0].map(|gear| report.tree.chunks(5).filter(|arc| arc[4] * gear > 0.0).count());
        assert!(gears[0] > 10 && (!mirrored || gears[1] > 10), "{gears:?}");

        let failed = &report.failed_expansions;
        let count = failed.first.len();
        assert!(count > 10 && failed.dropped == 0, "{count}");
        assert_eq!(
            (failed.hits.len(), failed.owners.len(), failed.expansions.len()),
            (3 * count, count, count)
        );
        for k in 0..count {
            let end = failed.first.get(k + 1).map_or(failed.arcs.len() / 5, |&f| f as usize);
            let mut at = poses[failed.expansions[k] as usize];
            for arc in failed.arcs[5 * failed.first[k] as usize..5 * end].chunks(5) {
                let (from, to) = (pose_of(arc), pose_of(arc).advance(arc[3], arc[4]));
                assert!(near(at, if mirrored { to } else { from }), "{k}");
                at = if mirrored { from } else { to };
            }
            let hit = pose_of(&failed.hits[3 * k..]);
            assert!((hit.point() - at.point()).norm() < 0.02, "{k}: {at:?} {hit:?}");
            // What is hit is within the margin, and nothing else stands in this lot.
            assert_eq!(failed.owners[k], BORDER);
            let obstacles = lot.obstacles();
            let checker = parkade::vehicle::collision::CollisionChecker::new(&obstacles, &CAR);
            assert!(checker.hit(obstacles.local(hit), 0.1).is_some(), "{k}");
            assert!(checker.hit(obstacles.local(at), 0.1 - 1e-6).is_none(), "{k}");
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn two_trees_show_their_failed_connections() {
    let report = traced(&Lot::of("L2"), &Config::bidirectional());
    assert!(report.failed_expansions.first.len() > 5);
    assert!(
        report.failed_expansions.expansions.windows(2).all(|w| w[0] < w[1]),
        "one an expansion, in order"
    );
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_failure_has_a_place() {
    let ask = |lot: &Lot| lot.plan(&Config::default());
    let lot = Lot::of("P3");
    assert_eq!(ask(&lot).obstruction, None);
    let block = [[13.0, 17.0], [15.0, 17.0], [15.0, 19.0], [13.0, 19.0]];
    let blocked = ask(&lot.clone().with(&block)).obstruction;
    assert_eq!(blocked, Some(Obstruction::Contact { at_start: true, owner: 1 }));

    // A wall right across: the goal's side is the smaller one.
    let wall = [[-25.0, 11.0], [25.0, 11.0], [25.0, 11.2], [-25.0, 11.2]];
    let walled = ask(&lot.clone().with(&wall)).obstruction;
    let Some(Obstruction::Enclosed { at_start: false, region: Region { cell, runs } }) = walled else {
        panic!("{walled:?}")
    };
    let area: f64 = runs.iter().map(|run| f64::from(run.1) * cell * cell).sum();
    // A disc of 1.4 m has its centre in 47.2 m × 3.2 m above the bay and reaches into it.
    assert!((150.0..260.0).contains(&area), "{area}");
    assert!(runs.iter().all(|(at, n)| at.y + cell <= 11.0 && at.x + f64::from(*n) * cell <= 25.0));

    // The same with a gap of two metres for a car of 2.6 m.
    let [left, right] =
        [(-25.0, 4.0), (6.0, 25.0)].map(|(x0, x1)| [[x0, 11.0], [x1, 11.0], [x1, 11.2], [x0, 11.2]]);
    let narrow = ask(&lot.with(&left).with(&right)).obstruction;
    let Some(Obstruction::Gap(gap)) = narrow else { panic!("{narrow:?}") };
    assert!((gap.width - 2.0).abs() < 0.1 && (gap.at.x - 5.0).abs() < 0.7 && (gap.at.y - 11.1).abs() < 0.7);

    // A slot that is too small for any shuffling names what stands before and behind.
    let mut boxed = Lot::of("P0").between([10.0, 8.5, PI], [0.0, 2.0, PI]);
    boxed.solids.push(vec![[1.05, 0.7], [6.0, 0.7], [6.0, 3.3], [1.05, 3.3]]);
    boxed.solids.push(vec![[-9.0, 0.7], [-4.55, 0.7], [-4.55, 3.3], [-9.0, 3.3]]);
    let report = ask(&boxed);
    assert!(matches!(report.status, Status::BoxedIn { at_start: false, .. }), "{:?}", report.status);
    let Some(Obstruction::BoxedIn { at_start: false, stops }) = report.obstruction else {
        panic!("{:?}", report.obstruction)
    };
    assert_eq!(stops.iter().map(|s| s.1).collect::<Vec<_>>(), [2, 2, 2, 1, 1, 1], "ahead, then back");
    for (stop, _) in stops {
        assert!(boxed.hit([stop.x, stop.y, stop.heading]).is_none() && (stop.point().x - 0.0).abs() < 0.1);
    }

    // Searched in vain: the place where it came nearest.
    let spent = Config { max_expansions: Some(30), ladder: false, ..Config::default() };
    let report = Lot::of("par-7.2").plan(&Config {
        motion_primitive_length: Some(0.2),
        xy_resolution: Some(0.1),
        heading_resolution: Some(0.026),
        ..spent
    });
    let at = report.closest.expect("it expanded something");
    let nearest = Obstruction::Nearest { at: at.point(), heading: Some(at.heading) };
    assert_eq!(report.obstruction, Some(nearest));
}
