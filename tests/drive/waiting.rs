//! Moving obstacles.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::drive::{Ending, Mover, Route, Rule, Scope, WaitOptions};
use parkade::geometry::Pose;
use parkade::scenario::MovingObstacle;

use super::row::{CAR, Row, crossing, meet, row};

#[test]
fn the_papers_figure_needs_no_wait() {
    let (row, movers) = crossing("fig16");
    for rule in [Rule::Predictive, Rule::Reactive] {
        let met = meet(&row, &movers, &WaitOptions { rule, ..WaitOptions::default() });
        assert_eq!((met.ending, met.waits.len()), (Ending::Arrived, 0));
        assert!((met.duration - row.route.length() / 2.0).abs() < 1e-9);
        assert!((14.7..=15.0).contains(&met.duration), "{}", met.duration);
    }
}

/// The box of the figure, and a way as long as the paper's: our car stops, waits and goes on, by either rule, and is
/// not touched where the box ends.
#[test]
fn the_papers_figure_is_waited_for_where_a_barrier_makes_the_way_long() {
    let (row, movers) = crossing("fig16-wait");
    assert!((40.0..50.0).contains(&row.route.length()), "{}", row.route.length());
    for rule in [Rule::Predictive, Rule::Reactive] {
        let met = meet(&row, &movers, &WaitOptions { rule, ..WaitOptions::default() });
        assert_eq!((met.ending, met.waits.len(), met.contact), (Ending::Arrived, 1, None), "{rule:?}");
        let wait = met.waits[0];
        assert!(wait.to - wait.from > 1.0 && wait.pose.y > 16.8, "{rule:?}: {wait:?}");
        assert!((met.duration - met.free_duration - (wait.to - wait.from)).abs() < 0.11, "{rule:?}");
    }
}

#[test]
fn a_conflict_is_waited_for_once_where_it_is_safe() {
    // Waits from, to, arrives: seconds.
    let expected = [
        ("fig16-conflict", [2.25, 7.60, 20.15]),
        ("fig16-oncoming", [0.80, 6.80, 20.80]),
        ("fig16-fast", [2.25, 9.10, 21.65]),
        ("fig16-low", [3.65, 8.60, 19.75]),
    ];
    for (id, [from, to, arrival]) in expected {
        let (row, movers) = crossing(id);
        let met = meet(&row, &movers, &WaitOptions::default());
        assert_eq!((met.ending, met.waits.len(), met.contact), (Ending::Arrived, 1, None), "{id}");
        let wait = met.waits[0];
        for (got, wanted) in [(wait.from, from), (wait.to, to), (met.duration, arrival)] {
            assert!((got - wanted).abs() <= 0.3 + 1e-9, "{id}: {got}, not {wanted}");
        }
        assert!(met.clearances.iter().all(|&c| c > 0.2), "{id}");
        let least = met.times_to_collision.iter().fold(f64::INFINITY, |least, &time| least.min(time));
        assert!(least > 0.0 && met.times_to_collision.len() == met.rows.t.len(), "{id}: {least}");
        if id == "fig16-conflict" {
            assert!((wait.pose.x - 16.0).abs() < 0.4 && (wait.pose.y - 17.3).abs() < 0.4, "{:?}", wait.pose);
            assert!((wait.station - 4.5).abs() < 0.5);
        }
    }
}

#[test]
fn the_reactive_rule_is_run_into() {
    let (row, movers) = crossing("fig16-conflict");
    let met = meet(&row, &movers, &WaitOptions { rule: Rule::Reactive, ..WaitOptions::default() });
    assert_eq!(met.ending, Ending::Hit);
    let wait = met.waits[0];
    assert!((wait.from - 4.65).abs() < 0.4 && (wait.to - 9.45).abs() < 0.4, "{wait:?}");
    assert!((wait.pose.x - 12.7).abs() < 0.5 && (wait.pose.y - 13.8).abs() < 0.5, "{wait:?}");
    let contact = met.contact.unwrap();
    assert!(contact.t >= wait.from - 0.1 && contact.t <= wait.to && contact.obstacle == 0, "{contact:?}");
    // A short look ahead does not save it.
    let window = WaitOptions { rule: Rule::Reactive, scope: Scope::Window, ..WaitOptions::default() };
    assert!(!meet(&row, &movers, &window).waits.is_empty());
}

fn obstacle(points: &[[f64; 2]], size: [f64; 2], speed: f64, start: f64) -> Mover {
    Mover::new(&MovingObstacle { id: None, points: points.to_vec(), size, speed, start })
}

/// Forty metres straight ahead.
fn straight() -> Row {
    let (start, goal) = (Pose::default(), Pose::new(40.0, 0.0, 0.0));
    let route = Route::new(&CAR, &[start, goal], &[1, 1], None).unwrap();
    Row { id: "straight", route, geometry: row("P3").geometry, goal }
}

#[test]
fn what_parks_on_the_path_blocks_it() {
    let parks = [obstacle(&[[20.0, 20.0], [20.0, 0.0]], [4.0, 2.0], 2.0, 0.0)];
    let met = meet(&straight(), &parks, &WaitOptions::default());
    assert_eq!((met.ending, met.contact), (Ending::Blocked, None));
    // The front stops half a metre before the place that keeps 0.3 m.
    let end = met.rows.poses[met.rows.t.len() - 1].x + CAR.rear_to_front;
    assert!((19.0 - 0.3 - 0.5 - end).abs() < 0.15, "{end}");
    assert!(met.duration > 10.0 && met.duration < 12.0);
}

#[test]
fn what_comes_from_behind_is_unavoidable() {
    let rams = [obstacle(&[[-10.0, 0.0], [60.0, 0.0]], [4.0, 2.0], 5.0, 0.0)];
    let met = meet(&straight(), &rams, &WaitOptions::default());
    assert_eq!(met.ending, Ending::Unavoidable);
    // 10 m − 2 m − 1 m apart, 3 m/s faster.
    assert!((met.contact.unwrap().t - 7.0 / 3.0).abs() < 0.05, "{:?}", met.contact);
}

#[test]
fn a_car_goes_on_when_the_whole_way_is_free() {
    let cross = |x: f64, start: f64| obstacle(&[[x, 15.0], [x, -30.0]], [4.0, 2.0], 3.0, start);
    let one = meet(&straight(), &[cross(12.0, 0.0)], &WaitOptions::default());
    let two = meet(&straight(), &[cross(12.0, 0.0), cross(30.0, 14.0)], &WaitOptions::default());
    for met in [&one, &two] {
        assert_eq!((met.ending, met.waits.len(), met.contact), (Ending::Arrived, 1, None), "{:?}", met.waits);
    }
    assert!(two.waits[0].station == one.waits[0].station && two.waits[0].to > one.waits[0].to + 2.0);
    let patient = WaitOptions { max_time: 5.0, ..WaitOptions::default() };
    assert_eq!(meet(&straight(), &[cross(12.0, 0.0)], &patient).ending, Ending::OutOfTime);
}

#[test]
fn a_waiting_car_drives_on_only_with_more_room_than_it_stopped_for() {
    let (row, movers) = crossing("fig16-conflict");
    let equal = WaitOptions { release_margin: 0.3, ..WaitOptions::default() };
    let (more, same) = (meet(&row, &movers, &WaitOptions::default()), meet(&row, &movers, &equal));
    assert!(more.waits.len() == 1 && same.waits.len() >= more.waits.len());
    assert!(more.duration >= same.duration);
}

/// A thin box crosses the way so fast that it overlaps a corner of the car for a hundredth of a tick.
#[test]
fn a_graze_between_two_ticks_is_seen() {
    let length = 300.0;
    let goal = Pose::new(length, 0.0, 0.0);
    let route = Route::new(&CAR, &[Pose::default(), goal], &[1, 1], None).unwrap();
    let row = Row { id: "straight", route, geometry: row("P3").geometry, goal };
    let (speed, depth) = (50.0, 0.03);
    let options =
        WaitOptions { rule: Rule::Reactive, scope: Scope::Window, speed, dt: 1.0, ..WaitOptions::default() };
    for k in 0..200 {
        // The box's tip reaches the car's side when the car's rear has all but passed.
        let t = 2.0 + 0.005 * f64::from(k);
        let x = speed * t - CAR.rear_to_back + depth;
        let y = CAR.width / 2.0;
        let thrown =
            obstacle(&[[x - 0.05, y + 100.0 * t + 0.05], [x - 0.05, -200.0]], [0.1, 0.1], 100.0, 0.0);
        let met = meet(&row, &[thrown], &options);
        assert_eq!(met.ending, Ending::Hit, "{t} s");
    }
}
