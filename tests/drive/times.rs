//! Trajectories within limits.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::PI;

use parkade::drive::{
    Ending, Limits, Profile, Route, Steps, Trajectory, WaitOptions, stop_wait_go, trajectory,
};
use parkade::geometry::{Pose, math};
use parkade::vehicle::Vehicle;
use serde_json::{Value, json};

use super::row::{CAR, Row, drive, rows};

/// What every trajectory keeps.
fn sound(row: &Row, limits: &Limits, driven: &Trajectory) {
    let (id, rows) = (row.id, &driven.rows);
    let n = rows.t.len();
    let columns = [&rows.station, &rows.speed, &rows.acceleration, &rows.steering];
    assert!(columns.iter().all(|c| c.len() == n) && rows.poses.len() == n, "{id}");
    assert_eq!((rows.t[0], rows.t[n - 1]), (0.0, driven.duration), "{id}");
    assert!((rows.station[n - 1] - row.route.length()).abs() < 1e-9, "{id}");
    let end = rows.poses[n - 1];
    assert!((end.point() - row.goal.point()).norm() < 1e-6, "{id}");
    assert!(math::turn(end.heading, row.goal.heading).abs() < 1e-6, "{id}");
    for k in 1..n {
        let dt = rows.t[k] - rows.t[k - 1];
        assert!(dt > 0.0 && dt <= limits.dt + 1e-9, "{id}: {dt} before {}", rows.t[k]);
        let wheel = (rows.steering[k] - rows.steering[k - 1]).abs();
        assert!(wheel <= CAR.max_steer_rate * dt + 1e-9, "{id}: wheel at {}", rows.t[k]);
        assert!(rows.speed[k].abs() <= limits.speed + 1e-9, "{id}");
        let way = rows.station[k] - rows.station[k - 1];
        let moved = (rows.poses[k].point() - rows.poses[k - 1].point()).norm();
        assert!(way >= 0.0 && moved <= way + 1e-9 && moved >= way * 0.99 - 1e-6, "{id}: {moved} of {way}");
    }
}

/// ∫ |v| dt over the rows; exact for steady accelerations, and with `jerk` for steady jerks.
fn integral(driven: &Trajectory, jerk: bool) -> f64 {
    let rows = &driven.rows;
    (1..rows.t.len()).fold(0.0, |sum, k| {
        let dt = rows.t[k] - rows.t[k - 1];
        let (v0, v1) = (rows.speed[k - 1].abs(), rows.speed[k].abs());
        let gear = if rows.speed[k - 1] + rows.speed[k] < 0.0 { -1.0 } else { 1.0 };
        let bend = (rows.acceleration[k - 1] - rows.acceleration[k]) * gear * dt / 12.0;
        sum + dt * (f64::midpoint(v0, v1) + if jerk { bend } else { 0.0 })
    })
}

#[test]
fn a_limited_drive_keeps_all_limits() {
    rows(|row| {
        let limits = Limits::default();
        let driven = drive(row, &limits);
        sound(row, &limits, &driven);
        assert!((integral(&driven, false) - row.route.length()).abs() < 1e-6, "{}", row.id);
        let rows = &driven.rows;
        assert_eq!((rows.speed[0], rows.speed[rows.t.len() - 1]), (0.0, 0.0));
        for k in 1..rows.t.len() {
            let dt = rows.t[k] - rows.t[k - 1];
            let change = (rows.speed[k].abs() - rows.speed[k - 1].abs()) / dt;
            assert!(
                change <= limits.acceleration + 1e-6 && change >= -limits.deceleration - 1e-6,
                "{}",
                row.id
            );
            assert!(rows.speed[k] * rows.speed[k - 1] >= 0.0, "{}: no gear change on the move", row.id);
        }
        assert!(driven.max_lateral_acceleration <= limits.lateral_acceleration);
    });
}

#[test]
fn lateral_acceleration_slows_the_bends() {
    rows(|row| {
        let limits = Limits { lateral_acceleration: 0.3, ..Limits::default() };
        let driven = drive(row, &limits);
        sound(row, &limits, &driven);
        assert!(driven.max_lateral_acceleration <= 0.3 + 1e-9, "{}", driven.max_lateral_acceleration);
        assert!(driven.duration > drive(row, &Limits::default()).duration);
        assert!((integral(&driven, false) - row.route.length()).abs() < 1e-6, "{}", row.id);
    });
}

#[test]
fn the_wheel_turns_at_standstill_at_gear_changes() {
    rows(|row| {
        let driven = drive(row, &Limits::default());
        let rows = &driven.rows;
        let mut stood = Vec::new();
        for k in 1..rows.t.len() {
            if rows.station[k] == rows.station[k - 1] {
                match stood.last_mut() {
                    Some((station, time)) if *station == rows.station[k] => {
                        *time += rows.t[k] - rows.t[k - 1];
                    }
                    _ => stood.push((rows.station[k], rows.t[k] - rows.t[k - 1])),
                }
            }
        }
        let total: f64 = stood.iter().map(|s| s.1).sum();
        assert!((total - driven.dwell).abs() < 1e-9, "{}", row.id);
        if ["P2", "P4"].contains(&row.id) {
            // Full left to full right: 1.2 rad at 0.6 rad/s.
            let cusp = stood.iter().find(|s| s.0 > 0.0).unwrap();
            assert!((cusp.1 - 2.0).abs() < 1e-6, "{}: {cusp:?}", row.id);
        }
    });
}

#[test]
fn a_limited_jerk_is_kept() {
    rows(|row| {
        let limits = Limits { jerk: Some(2.0), ..Limits::default() };
        let driven = drive(row, &limits);
        sound(row, &limits, &driven);
        assert!((integral(&driven, true) - row.route.length()).abs() < 1e-6, "{}", row.id);
        let rows = &driven.rows;
        for k in 1..rows.t.len() {
            let jerk = (rows.acceleration[k] - rows.acceleration[k - 1]) / (rows.t[k] - rows.t[k - 1]);
            assert!(jerk.abs() <= 2.0 + 1e-5, "{}: {jerk} at {}", row.id, rows.t[k]);
            assert!(rows.acceleration[k].abs() <= 1.5 + 1e-9);
        }
        assert!(driven.duration > drive(row, &Limits::default()).duration);
    });
}

#[test]
fn a_short_run_lowers_its_peak() {
    for length in [0.01, 0.3, 2.0, 50.0] {
        let ahead = [Pose::default(), Pose::new(length, 0.0, 0.0)];
        let route = Route::new(&CAR, &ahead, &[1, 1], None).unwrap();
        let time = |jerk| trajectory(&CAR, &route, &Limits { jerk, ..Limits::default() }).unwrap();
        let (plain, smooth) = (time(None), time(Some(2.0)));
        assert!((smooth.rows.station[smooth.rows.t.len() - 1] - length).abs() < 1e-9);
        assert!((integral(&smooth, true) - length).abs() < 1e-6, "{length}");
        assert!(smooth.duration > plain.duration);
        // Triangle: √(2 L (1/a + 1/b)); else L/v + v (1/a + 1/b)/2.
        let inverse = 1.0 + 1.0 / 1.5;
        let triangle = length < 2.0 * inverse;
        let wanted = if triangle { (2.0 * length * inverse).sqrt() } else { length / 2.0 + inverse };
        assert!((plain.duration - wanted).abs() < 1e-9, "{length}: {} {wanted}", plain.duration);
    }
}

#[test]
fn slow_steps_are_slow() {
    rows(|row| {
        let limits = Limits { steps: Steps::Slow, ..Limits::default() };
        let driven = drive(row, &limits);
        sound(row, &limits, &driven);
        assert!((integral(&driven, false) - row.route.length()).abs() < 1e-6, "{}", row.id);
        let curvature = |k: usize| {
            let (a, b) = (driven.rows.poses[k - 1], driven.rows.poses[k]);
            math::turn(a.heading, b.heading) / (driven.rows.station[k] - driven.rows.station[k - 1])
        };
        // Where both neighbouring stretches move and differ, a step lies between them.
        for k in 2..driven.rows.t.len() {
            let moves = |k: usize| driven.rows.station[k] - driven.rows.station[k - 1] > 1e-6;
            let same_gear = driven.rows.speed[k] * driven.rows.speed[k - 1] > 0.0;
            if moves(k) && moves(k - 1) && same_gear && (curvature(k) - curvature(k - 1)).abs() > 0.01 {
                assert!(driven.rows.speed[k - 1].abs() <= 0.5 + 1e-9, "{}: {}", row.id, driven.rows.t[k]);
            }
        }
    });
}

#[test]
fn the_papers_time_is_length_by_speed() {
    rows(|row| {
        let driven = drive(row, &Limits::paper());
        sound(row, &Limits::paper(), &driven);
        assert!((driven.duration - row.route.length() / 2.0).abs() < 1e-9, "{}", row.id);
        assert!((integral(&driven, false) - row.route.length()).abs() < 1e-6, "{}", row.id);
        assert_eq!(driven.dwell, 0.0);
    });
}

#[test]
fn a_way_of_no_length_takes_no_time() {
    let route = Route::new(&CAR, &[Pose::new(1.0, 2.0, 0.3)], &[1], None).unwrap();
    let driven = trajectory(&CAR, &route, &Limits::default()).unwrap();
    assert_eq!((driven.rows.t.as_slice(), driven.duration), (&[0.0][..], 0.0));
    let met = stop_wait_go(&CAR, &route, &[], &WaitOptions::default()).unwrap();
    assert_eq!((met.ending, met.duration), (Ending::Arrived, 0.0));
}

#[test]
fn a_way_in_both_gears_is_driven_in_both() {
    let turn = Pose::default().advance(0.1, 5.0);
    let back = turn.advance(-0.1, -4.0);
    let path = [Pose::default(), Pose::default().advance(0.1, 2.5), turn, turn.advance(-0.1, -2.0), back];
    let route = Route::new(&CAR, &path, &[1, 1, -1, -1, -1], None).unwrap();
    let driven = trajectory(&CAR, &route, &Limits::default()).unwrap();
    let (fast, slow) = driven.rows.speed.iter().fold((0.0_f64, 0.0_f64), |(h, l), &v| (h.max(v), l.min(v)));
    assert!(
        fast > 1.0
            && slow < -1.0
            && math::turn(back.heading, driven.rows.poses[driven.rows.t.len() - 1].heading).abs() < PI * 1e-9
    );
}

#[test]
fn wrong_limits_are_named() {
    let with = |fields: Value| {
        let limits = Limits::default().with(fields.as_object().unwrap())?;
        limits.validate().map(|()| limits)
    };
    assert_eq!(with(json!({ "profile": "constant", "speed": 1 })).unwrap().profile, Profile::Constant);
    assert_eq!(with(json!({ "jerk": 2 })).unwrap().jerk, Some(2.0));
    for (fields, path) in [
        (json!({ "speed": 0 }), "speed"),
        (json!({ "acceleration": -1 }), "acceleration"),
        (json!({ "deceleration": "x" }), "deceleration"),
        (json!({ "lateralAcceleration": 1e9 }), "lateralAcceleration"),
        (json!({ "jerk": 0 }), "jerk"),
        (json!({ "startSpeed": -1 }), "startSpeed"),
        (json!({ "goalSpeed": 101 }), "goalSpeed"),
        (json!({ "dt": 0 }), "dt"),
        (json!({ "profile": "quick" }), "profile"),
        (json!({ "velocity": 1 }), "velocity"),
    ] {
        let error = with(fields).unwrap_err();
        assert_eq!((error.code.as_str(), error.path.as_str()), ("bad-config", path));
    }
    let wait =
        |fields: Value| WaitOptions::default().with(fields.as_object().unwrap()).and_then(|o| o.validate());
    for (fields, path) in [
        (json!({ "rule": "hopeful" }), "rule"),
        (json!({ "scope": "far" }), "scope"),
        (json!({ "margin": -1 }), "margin"),
        (json!({ "releaseMargin": 11 }), "releaseMargin"),
        (json!({ "maxTime": 1e9 }), "maxTime"),
        (json!({ "dt": 2 }), "dt"),
    ] {
        assert_eq!(wait(fields).unwrap_err().path, path);
    }
}

#[test]
fn drives_without_end_are_refused() {
    let poses: Vec<Pose> = [0.0, 2000.0].map(|x| Pose::new(x, 0.0, 0.0)).into();
    let route = Route::new(&CAR, &poses, &[1, 1], None).unwrap();
    let refused = |limits: Limits| trajectory(&CAR, &route, &limits).unwrap_err().to_string();
    let slow = Limits { speed: 0.01, ..Limits::default() };
    assert!(refused(slow.clone()).starts_with("path: must be driven within 100000 s, takes 2000"));
    let fine = Limits { speed: 0.5, dt: 0.001, ..Limits::default() };
    assert!(refused(fine).starts_with("dt: must be at least 0.004"));
    let idle = Vehicle { max_steer_rate: 1e-9, ..CAR };
    let bent: Vec<Pose> = [0.0, 1.0, 2.0].map(|s| Pose::new(0.0, 0.0, 0.0).advance(0.1, s)).into();
    let route = Route::new(&idle, &bent, &[1; 3], None).unwrap();
    let error = trajectory(&idle, &route, &Limits::default()).unwrap_err();
    assert_eq!(error.path, "path");
}

/// A way of arcs of any length, some of millimetres, as searches join them.
fn patched(random: &mut impl FnMut() -> f64) -> Route {
    let mut poses = vec![Pose::new(0.0, 0.0, 0.0)];
    let mut curvatures = vec![0.0];
    for _ in 0..60 {
        let curvature = CURVATURES[(random() * 5.0) as usize];
        let length = [0.002, 0.03, 0.2, 3.0, 20.0][(random() * 5.0) as usize] * (0.2 + random());
        let steps = (length / 0.1_f64).ceil();
        for _ in 0..steps as u32 {
            let from = poses[poses.len() - 1];
            poses.push(from.advance(curvature, length / steps));
            curvatures.push(curvature);
        }
    }
    let directions = vec![1; poses.len()];
    Route::new(&Vehicle::PAPER, &poses, &directions, Some(&curvatures)).unwrap()
}

const CURVATURES: [f64; 5] = [-0.18, -0.05, 0.0, 0.05, 0.18];

#[test]
fn short_arcs_let_no_drive_crawl() {
    let mut state = 7_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for round in 0..60 {
        let route = patched(&mut random);
        for speed in [2.0, 10.0] {
            let limits = Limits { speed, jerk: Some(2.0), dwell: false, ..Limits::road() };
            let time = trajectory(&Vehicle::PAPER, &route, &limits).unwrap().duration;
            let loose = Limits { jerk: None, ..limits };
            let least = route.length() / speed;
            let plain = trajectory(&Vehicle::PAPER, &route, &loose).unwrap().duration;
            assert!(
                time >= least && time <= 2.0 * plain + 10.0,
                "round {round}: {time} s, {plain} s without jerk"
            );
        }
    }
}
