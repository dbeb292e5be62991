//! Bad questions, settings, walls.

use std::f64::consts::{FRAC_PI_2, PI};

use parkade::geometry::{Point, Pose, Vector, arcs};
use parkade::planners::hybrid::{Config, Query, Scratch, SearchFrom, Status, plan};
use parkade::vehicle::Vehicle;
use parkade::vehicle::collision::{Edge, Obstacles, Solid};

use super::lot::{BORDER, CAR, Lot, pose};

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn bad_questions_are_answered_with_the_reason() {
    let lot = Lot::of("P3");
    let ask = |lot: &Lot| lot.plan(&Config::default());
    let block =
        |x: f64, y: f64| [[x - 1.0, y - 1.0], [x + 1.0, y - 1.0], [x + 1.0, y + 1.0], [x - 1.0, y + 1.0]];
    assert_eq!(ask(&lot.clone().with(&block(14.0, 18.0))).status, Status::StartInCollision(1));
    assert_eq!(ask(&lot.clone().with(&block(-2.0, 3.0))).status, Status::GoalInCollision(1));
    let cliff = [[-30.0, 4.0], [30.0, 4.0], [30.0, 31.0], [-30.0, 31.0]];
    assert_eq!(ask(&lot.clone().with(&cliff)).status, Status::StartInCollision(1), "wholly inside a solid");
    let away = Lot { start: [100.0, 18.0, PI], ..lot.clone() };
    assert_eq!(ask(&away).status, Status::StartInCollision(BORDER), "wholly outside");
    let wall = [[-25.0, 11.0], [25.0, 11.0], [25.0, 11.2], [-25.0, 11.2]];
    let walled = ask(&lot.clone().with(&wall));
    assert_eq!((walled.status, walled.stats.expanded), (Status::Unreachable, 0));
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        let report = ask(&Lot { start: [bad, 18.0, PI], ..lot.clone() });
        assert!(!report.status.is_found(), "{bad}");
        let report = ask(&Lot { goal: [0.0, 18.0, bad], ..lot.clone() });
        assert!(bad == 1e300 || !report.status.is_found(), "{bad}");
    }
    let stay = ask(&Lot { goal: lot.start, ..lot.clone() });
    assert_eq!((stay.status, stay.arcs.len(), stay.cost), (Status::Found, 0, 0.0));
    let turn = Lot { goal: [16.0, 18.0, 0.0], ..lot.clone() };
    turn.solve("about turn", &Config::default());
    let config = Config {
        motion_primitive_length: Some(0.2),
        xy_resolution: Some(0.1),
        heading_resolution: Some(0.026),
        max_expansions: Some(10),
        ladder: false,
        ..Config::default()
    };
    let spent = Lot::of("par-7.2").plan(&config);
    assert!(matches!(spent.status, Status::BudgetExhausted(left) if left > 1.0), "{:?}", spent.status);
    assert_eq!(spent.stats.expanded, 10);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn settings_are_checked() {
    let error = Config { margin: f64::NAN, ..Config::default() }.validate().unwrap_err();
    assert_eq!((error.path.as_str(), error.message().ends_with("got NaN")), ("margin", true));
    let with = |text: &str| Config::default().with(&serde_json::from_str(text).unwrap());
    let config = with(r#"{ "searchFrom": "start", "xyResolution": 0.4 }"#).unwrap();
    assert_eq!((config.search_from, config.xy_resolution), (SearchFrom::Start, Some(0.4)));
    let refused = |text: &str| with(text).unwrap_err().to_string();
    assert!(refused(r#"{ "stepLength": 1 }"#).starts_with("stepLength: no such setting; there are margin,"));
    assert_eq!(
        refused(r#"{ "steerSamples": "many" }"#),
        "steerSamples: must be a whole number from 0 to 4294967295, got \"many\""
    );
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_wall_is_no_solid_but_stops_the_car() {
    let point = |x, y| Point::new(x, y);
    let outline = vec![point(0.0, 0.0), point(40.0, 0.0), point(40.0, 20.0), point(0.0, 20.0)];
    let floor = Solid { outline, owner: 0 };
    let wall = Edge { a: point(20.0, 0.0), b: point(20.0, 14.0), owner: 7 };
    let obstacles = Obstacles::new(&[wall], &[], &floor);
    let ask = |start: Pose| {
        let query = Query { obstacles: &obstacles, vehicle: &CAR, start, goal: Pose::new(34.0, 4.0, 0.0) };
        plan(&query, &Config::default(), &mut Scratch::default(), false, &mut None)
    };
    assert_eq!(ask(Pose::new(18.0, 5.0, 0.0)).status, Status::StartInCollision(7));
    let around = ask(Pose::new(8.0, 4.0, FRAC_PI_2));
    assert_eq!(around.status, Status::Found);
    assert!(arcs::length(&around.arcs) > 36.0);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_coarse_level_alone_ends_without_a_path() {
    // More than a metre to move, so the car is not boxed in; but no primitive of 0.8 m fits.
    let slot = Lot::of("par-7.2");
    let report = slot.plan(&Config { ladder: false, ..Config::default() });
    assert_eq!((report.status, report.level), (Status::NoPath, 0));
    assert!(report.arcs.is_empty() && report.stats.expanded < 100 && report.closest.is_some());
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_path_that_touches_between_two_checks_is_refused() {
    // P1 starts on a wall, so it is planned without margin. A needle reaches 3 mm into what the outer front corner
    // sweeps, which lasts less than the finest checks of a level are apart.
    let lot = Lot::of("P1");
    let plain = lot.plan(&Config::default()).arcs;
    let turn = plain.iter().position(|arc| arc.curvature != 0.0 && arc.length.abs() > 4.0).expect("a bend");
    let from = plain[..turn].iter().fold(pose(lot.start), |at, arc| at.advance(arc.curvature, arc.length));
    let arc = plain[turn];
    let mut refused = 0;
    for k in 0..12_u32 {
        let at = from.advance(arc.curvature, (2.0 + 0.031 * f64::from(k)).copysign(arc.length));
        let centre = at.to_world(Point::new(0.0, 1.0 / arc.curvature));
        let corner = at.to_world(Point::new(CAR.rear_to_front, -(CAR.width / 2.0).copysign(arc.curvature)));
        let out = (corner - centre).normalize();
        let across = Vector::new(-out.y, out.x) * 0.001;
        let (tip, foot) = (corner - out * 0.003, corner + out * 0.2);
        let needle = [tip, foot + across, foot - across].map(|p| [p.x, p.y]);
        let config = Config { ladder: false, ..Config::default() };
        let report = lot.clone().with(&needle).plan(&config);
        match report.status {
            Status::VerificationFailed => {
                assert!(report.arcs.is_empty());
                refused += 1;
            }
            // Seen in time, and passed.
            status => assert_eq!(status, Status::Found, "{k}"),
        }
    }
    assert!(refused > 0);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn impossible_cars_are_refused_by_field() {
    type Setter = fn(&mut Vehicle, f64);
    let cases: [(&str, Setter); 6] = [
        ("wheelbase", |car, v| car.wheelbase = v),
        ("width", |car, v| car.width = v),
        ("rearToFront", |car, v| car.rear_to_front = v),
        ("rearToBack", |car, v| car.rear_to_back = v),
        ("maxSteer", |car, v| car.max_steer = v),
        ("maxSteerRate", |car, v| car.max_steer_rate = v),
    ];
    for (field, set) in cases {
        let beyond = if field == "maxSteer" { FRAC_PI_2 } else { f64::INFINITY };
        for bad in [0.0, -1.0, f64::NAN, beyond] {
            let mut car = CAR;
            set(&mut car, bad);
            let error = car.validate().unwrap_err();
            assert_eq!((error.code.as_str(), error.path.as_str()), ("bad-vehicle", field), "{bad}");
        }
    }
}
