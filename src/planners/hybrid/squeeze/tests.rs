use super::*;
use crate::geometry::math;
use crate::planners::hybrid::descent::tests::{is_free, rocking};

/// A move can be squeezed from each way of a car that rocks. The end stays, the path is free, costs less and has fewer
/// gear changes. Nothing is tried where nothing may be.
#[test]
fn moves_are_squeezed_out_of_a_path_that_rocks() {
    let paths = rocking(|rules, start, arcs| {
        assert!(squeeze(rules, start, arcs, &mut 0).is_none());
        let better = squeeze(rules, start, arcs, &mut 8).unwrap();
        let [got, end] = [&better, arcs].map(|arcs| arcs::end(start, arcs));
        assert!((got.point() - end.point()).norm() < 1e-6);
        assert!(math::turn(got.heading, end.heading).abs() < 1e-6);
        assert!(is_free(rules, start, &better));
        assert!(arcs::direction_changes(&better) < arcs::direction_changes(arcs));
        let [before, after] = [arcs, &better].map(|arcs| rules.costs.path(rules.checker, start, arcs));
        assert!(after < before, "{before} {after}");
    });
    assert!(paths > 20, "{paths}");
}
