//! A simulated car on the planned path.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::drive::{Controller, Limits, Profile, Steps, Tracking, track};
use parkade::metrics::Body;

use super::row::{CAR, Row, rows};

pub(crate) fn follow(row: &Row, limits: &Limits, controller: Controller) -> Tracking {
    track(&CAR, &Body::new(&row.geometry), &row.route, limits, controller).unwrap()
}

fn steady(speed: f64) -> Limits {
    Limits { speed, profile: Profile::Constant, ..Limits::default() }
}

#[test]
fn paths_are_followed_as_closely_as_measured() {
    // Largest lateral error at 2, 1 and 0.5 m/s; the paths here differ a little from the measured ones.
    let measured = [
        ("P0", [0.067, 0.028, 0.019]),
        ("P2", [0.061, 0.032, 0.021]),
        ("P3", [0.041, 0.018, 0.014]),
        ("P4", [0.062, 0.027, 0.018]),
        ("L0", [0.043, 0.046, 0.029]),
        ("L3", [0.042, 0.017, 0.008]),
        ("L4", [0.041, 0.017, 0.011]),
    ];
    rows(|row| {
        for (k, speed) in [2.0, 1.0, 0.5].into_iter().enumerate() {
            let got = follow(row, &steady(speed), Controller::Feedback);
            if let Some((_, figures)) = measured.iter().find(|m| m.0 == row.id) {
                assert!(got.max_lateral <= figures[k] + 0.015, "{} at {speed}: {}", row.id, got.max_lateral);
                assert!(got.max_heading <= 0.060, "{} at {speed}: {}", row.id, got.max_heading);
            }
            // L2's steps of the curvature follow each other too closely for the wheel.
            assert!(got.passes() || row.id == "L2", "{} at {speed}", row.id);
        }
        assert!(
            follow(row, &Limits::default(), Controller::Feedback).passes() || row.id == "L2",
            "{}",
            row.id
        );
        let slow = follow(row, &Limits { steps: Steps::Slow, ..Limits::default() }, Controller::Feedback);
        assert!(slow.passes() && slow.max_lateral < 0.05, "{}", row.id);
    });
}

#[test]
fn without_standstill_at_gear_changes_the_way_is_lost() {
    let moving = Limits { dwell: false, ..steady(2.0) };
    rows(|row| {
        let got = follow(row, &moving, Controller::Feedback);
        match row.id {
            "P2" => assert!(got.end_distance > 2.0 && got.end_distance < 4.0, "{}", got.end_distance),
            "P4" => assert!((got.end_distance - 0.35).abs() < 0.15, "{}", got.end_distance),
            _ => {}
        }
    });
}

#[test]
fn other_controllers_follow_too() {
    rows(|row| {
        let pursued = follow(row, &steady(1.0), Controller::PurePursuit);
        assert!(pursued.max_lateral < 0.13 && pursued.end_distance < 0.13, "{}", row.id);
        let stanley = follow(row, &steady(1.0), Controller::Stanley);
        assert!(stanley.max_lateral < 0.13 && stanley.end_distance < 0.13, "{}", row.id);
    });
}

#[test]
fn what_is_hit_while_following_is_named() {
    rows(|row| {
        if row.id != "P2" {
            return;
        }
        let got = follow(row, &Limits::paper(), Controller::Feedback);
        assert!(got.hit.is_some() && !got.passes());
    });
}
