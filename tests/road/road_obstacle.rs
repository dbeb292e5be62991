//! Roads as they are drawn: kerbs, lanes, limits, junctions.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::geometry::{Point, Pose, math};
use parkade::metrics::{Body, Verdict};
use parkade::plan::{Detail, Options, Outcome, Plan, Planner};
use parkade::scenario::Scenario;
use parkade::scenario::resolve::Form;
use serde_json::{Map, Value, json};

/// A bend to the left with a lane each way, and what stands on it.
fn scene(road: &Value, others: &[Value]) -> Value {
    let mut first = json!({ "type": "road", "id": "road-1", "points": [[4, 20], [60, 20], [60, 76]] });
    for (name, value) in road.as_object().unwrap() {
        first[name] = value.clone();
    }
    let obstacles: Vec<Value> = std::iter::once(first).chain(others.iter().cloned()).collect();
    json!({
        "version": 1,
        "map": { "origin": [0, 0], "width": 160, "height": 160, "resolution": 0.5 },
        "obstacles": obstacles,
        "vehicle": "sedan",
        "start": { "x": 12, "y": 18.25, "heading": 0 },
        "goal": { "x": 61.75, "y": 60, "heading": std::f64::consts::FRAC_PI_2 },
    })
}

fn read(value: &Value) -> Scenario {
    Scenario::from_json(value).unwrap()
}

fn planned(value: &Value, id: &str) -> Plan {
    Planner::new(id, &read(value), &Map::new()).unwrap().plan(Options::default())
}

fn cone(x: f64, y: f64) -> Value {
    let corner = |k: u32| {
        let (sin, cos) = math::sin_cos(f64::from(k) * math::FRAC_PI_4);
        json!([x + 0.2 * cos, y + 0.2 * sin])
    };
    json!({ "type": "polygon", "points": (0..8).map(corner).collect::<Vec<_>>() })
}

#[test]
fn a_drawn_road_is_driven_in_its_lane_past_cones() {
    let free = planned(&scene(&json!({}), &[]), "cost-map");
    assert_eq!((free.outcome, free.check.verdict), (Outcome::Found, Verdict::Ok));
    assert_ne!(free.detail, Some(Detail::SmoothingFellBack));
    let figures = free.metrics.road.clone().unwrap().figures;
    assert!(figures.body_clearance_min > 0.4, "{figures:?}");
    let cones = [cone(30.0, 19.5), cone(30.0, 18.0), cone(59.0, 45.0)];
    let past = planned(&scene(&json!({}), &cones), "cost-map");
    assert_eq!(
        (past.outcome, past.check.verdict),
        (Outcome::Found, Verdict::Ok),
        "{:?}",
        past.check.first_hit
    );
    let room = past.metrics.road.clone().unwrap().figures.body_clearance_min;
    assert!(room > 0.2, "{room}");
    assert_ne!(past.hash(), free.hash());
    // With weight, the right-hand lane is kept to, whichever way one goes.
    let astray = |value: &Value, weight: f64| {
        let settings = json!({ "laneWeight": weight });
        let mut planner = Planner::new("cost-map", &read(value), settings.as_object().unwrap()).unwrap();
        let plan = planner.plan(Options::default());
        plan.metrics.road.unwrap().figures.lane_deviation_mean.unwrap()
    };
    let mut back = scene(&json!({}), &[]);
    back["start"] = json!({ "x": 58.25, "y": 66, "heading": -std::f64::consts::FRAC_PI_2 });
    back["goal"] = json!({ "x": 12, "y": 21.75, "heading": std::f64::consts::PI });
    for value in [scene(&json!({}), &[]), back] {
        let (with, without) = (astray(&value, 3.0), astray(&value, 0.0));
        println!("{with:.2} m from the lane's middle, {without:.2} m without weight");
        assert!(with < 0.5 && with < 0.8 * without, "{with} {without}");
    }
}

#[test]
fn kerbs_hold_every_planner_and_open_where_roads_meet() {
    let kerbs = |value: &Value| {
        let shapes = read(value).geometry().unwrap().shapes;
        let length = |form: &Form| if let Form::Segment(a, b) = form { (b - a).norm() } else { 0.0 };
        shapes.iter().map(|s| length(&s.form)).sum::<f64>()
    };
    // Two sides of two straights and a quarter of a circle, whose sides have radii of 16.5 and 23.5 m.
    let alone = kerbs(&scene(&json!({}), &[]));
    let exact = 2.0 * (36.0 + 36.0) + 40.0 * std::f64::consts::FRAC_PI_2;
    assert!((alone - exact).abs() < 0.02, "{alone}");
    assert_eq!(kerbs(&scene(&json!({ "kerbs": false }), &[])), 0.0);
    // A road from the north onto the first straight: its mouth opens one kerb by its width, and its own end is open.
    let side = json!({ "type": "road", "points": [[25, 60], [25, 20]] });
    let joined = kerbs(&scene(&json!({}), std::slice::from_ref(&side)));
    assert!((joined - (exact - 7.0 + 2.0 * 36.5)).abs() < 0.02, "{joined}");
    let body = |value: &Value| Body::new(&read(value).geometry().unwrap());
    let across = Pose::new(23.0, 23.5, 0.0);
    assert!(body(&scene(&json!({}), &[])).hit(across).is_some());
    assert!(body(&scene(&json!({}), &[side])).hit(across).is_none());
    let wall = |x: f64| json!({ "type": "wall", "points": [[x, 16.5], [x, 23.5]], "thickness": 0.2 });
    for id in ["eight", "hybrid", "cost-map"] {
        let mut value = scene(&json!({}), &[wall(5.0), wall(30.0)]);
        assert_ne!(planned(&value, id).outcome, Outcome::Found, "{id}");
        value["obstacles"][0]["kerbs"] = false.into();
        assert_eq!(planned(&value, id).outcome, Outcome::Found, "{id}");
    }
}

#[test]
fn limits_hold_on_the_whole_surface() {
    let limits = read(&scene(&json!({ "speed": 5.0 }), &[])).all_speed_limits();
    assert_eq!((limits.len(), limits[0].speed), (1, 5.0));
    assert!(read(&scene(&json!({}), &[])).all_speed_limits().is_empty());
    let lanes = read(&scene(&json!({ "lanes": [2, 0] }), &[]))
        .lanes_between(Point::new(60.0, 70.0), Point::new(5.0, 20.0));
    // One way is one way, also for those who want the other.
    assert_eq!(lanes.len(), 2);
    assert_eq!((lanes[0].start.y, lanes[1].start.y), (18.25, 21.75));
    assert_eq!(lanes[0].pieces.len(), 3);
}

#[test]
fn thin_things_between_centres_are_seen() {
    // Walls of 0.2 m across the whole road, between two columns of centres.
    let wall = |x: f64| json!({ "type": "rectangle", "center": [x, 20.0], "size": [0.2, 7.0] });
    let plan = planned(&scene(&json!({}), &[wall(5.0), wall(30.0)]), "cost-map");
    assert_eq!(plan.outcome, Outcome::NoPath);
}

#[test]
fn roads_read_and_write_back_and_impossible_ones_are_refused() {
    let scenario = read(&scene(&json!({ "speed": 8.0, "kerbs": false }), &[]));
    let written = serde_json::to_value(&scenario).unwrap();
    assert_eq!(written["obstacles"][0]["type"], "road");
    assert_eq!(written["obstacles"][0]["laneWidth"], 3.5);
    assert_eq!(read(&written), scenario);
    for (road, expected) in [
        (json!({ "points": [[4, 20]] }), "obstacles[0].points: must have 2 to 2000 points, got 1"),
        (
            json!({ "points": [[4, 20], [4, 20]] }),
            "obstacles[0].points[1]: must differ from the point before it",
        ),
        (
            json!({ "radius": 3.0 }),
            "obstacles[0].points[1]: must turn less or have longer ways beside it: the middle's radius is 3.00 m, \
             half the road 3.50 m wide",
        ),
        (json!({ "lanes": [0, 0] }), "obstacles[0].lanes: must be 0 to 8 each, one at least, got [0, 0]"),
        (json!({ "lanes": [1] }), "obstacles[0].lanes: must"),
        (json!({ "laneWidth": 0 }), "obstacles[0].laneWidth: must be positive"),
        (json!({ "speed": -1 }), "obstacles[0].speed: must be positive"),
        (json!({ "width": 1 }), "obstacles[0].width: "),
    ] {
        let error = Scenario::from_json(&scene(&road, &[])).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{error}");
    }
}
