use super::*;
use crate::geometry::arcs::Arc;

/// A path with a margin, so many gear changes and a cost.
fn path(margin: f64, changes: u32, cost: f64) -> Report {
    let arc = |n: u32| Arc { curvature: 0.0, length: if n.is_multiple_of(2) { 1.0 } else { -1.0 } };
    Report { margin, cost, arcs: (0..=changes).map(arc).collect(), ..Report::empty(0.0) }
}

fn known(paths: &[(f64, u32, f64)]) -> KnownPaths {
    let mut known = KnownPaths::default();
    for &(margin, changes, cost) in paths {
        known.offer(path(margin, changes, cost));
    }
    known
}

/// The better of some paths, in the order in which they are found.
fn better(paths: &[(f64, u32, f64)]) -> (f64, u32) {
    let better = known(paths).take_better().unwrap();
    (better.margin, changes(&better))
}

#[test]
fn less_margin_is_better_where_it_saves_enough_gear_changes() {
    // Two of three or four, and one of more, or where no more than 5 cm are given up.
    assert_eq!(better(&[(0.03, 2, 10.0), (0.05, 3, 15.0)]), (0.03, 2));
    assert_eq!(better(&[(0.03, 2, 10.0), (0.1, 3, 15.0)]), (0.1, 3));
    assert_eq!(better(&[(0.03, 2, 10.0), (0.1, 4, 20.0)]), (0.03, 2));
    assert_eq!(better(&[(0.03, 4, 20.0), (0.1, 5, 25.0)]), (0.03, 4));
    // Less than is comfortable never is, nor what costs more.
    assert_eq!(better(&[(0.01, 2, 10.0), (0.1, 9, 50.0)]), (0.1, 9));
    assert_eq!(better(&[(0.03, 2, 60.0), (0.1, 9, 50.0)]), (0.1, 9));
    // Of several the one with the fewest changes, and then with the most margin.
    assert_eq!(better(&[(0.03, 2, 10.0), (0.05, 2, 11.0), (0.1, 6, 40.0)]), (0.05, 2));
    assert_eq!(better(&[(0.03, 2, 10.0), (0.05, 3, 11.0), (0.1, 6, 40.0)]), (0.03, 2));
    // With the same margin the cheaper one counts, whichever comes first.
    assert_eq!(better(&[(0.1, 6, 40.0), (0.1, 5, 30.0)]), (0.1, 5));
    assert_eq!(better(&[(0.1, 5, 30.0), (0.1, 6, 40.0)]), (0.1, 5));
    assert!(known(&[]).take_better().is_none() && known(&[]).is_empty());
}

#[test]
fn the_next_best_path_is_kept_beside_the_better_one() {
    let next_best = |paths: &[(f64, u32, f64)]| {
        let mut known = known(paths);
        known.take_better();
        known.next_best().map(changes)
    };
    assert_eq!(next_best(&[(0.03, 2, 10.0), (0.1, 4, 20.0)]), Some(4));
    assert_eq!(next_best(&[(0.03, 3, 10.0), (0.1, 4, 20.0)]), Some(3));
    assert_eq!(next_best(&[(0.1, 6, 40.0), (0.1, 5, 30.0)]), Some(6));
    // One that keeps less than is comfortable is no answer beside another.
    assert_eq!(next_best(&[(0.01, 2, 10.0), (0.1, 4, 20.0)]), None);
    assert_eq!(next_best(&[(0.03, 2, 10.0)]), None);
}

#[test]
fn a_search_for_more_margin_is_short_of_what_would_not_be_the_answer() {
    assert_eq!(known(&[]).most_changes(0.1), None);
    assert_eq!(known(&[(0.01, 2, 10.0)]).most_changes(0.1), None);
    assert_eq!(known(&[(0.1, 2, 10.0)]).most_changes(0.1), None);
    for (fewest, margin) in (0..12).flat_map(|fewest| [0.05, 0.1].map(|margin| (fewest, margin))) {
        let most = known(&[(0.03, fewest, 10.0)]).most_changes(margin).unwrap() - SAVED_BY_SHORTCUT;
        let is_answer = |changes: u32| better(&[(0.03, fewest, 10.0), (margin, changes, 90.0)]).0 == margin;
        assert!(is_answer(most) && !is_answer(most + 1), "{fewest}, {margin}: {most}");
    }
}
