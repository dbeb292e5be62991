//! Published tables, computed again: what is printed, what is flagged, and slices that add up.

use parkade::papers::grid::{COLUMNS, PLANNERS, ROWS, Row, WIDTH, measure, row, summary};
use parkade::papers::{claims, road};
use parkade::scenario::generate::{Family, occupancy};
use serde_json::Value;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn still() -> f64 {
    0.0
}

fn figures(row: &Row, from: u64, to: u64) -> Vec<f64> {
    measure(row, from, to, &mut still).unwrap()
}

#[test]
fn printed_values_and_flags_are_the_records() {
    let file: Value = serde_json::from_str(include_str!("data/paper-tables-grid.json")).unwrap();
    let records = file["hu2024"]["rows"].as_array().unwrap();
    assert_eq!(records.len(), ROWS.len());
    for (row, record) in ROWS.iter().zip(records) {
        assert_eq!(row.id, format!("{}-{}", record["environment"].as_str().unwrap(), record["grid"]));
        assert_eq!(Some(u64::from(row.table)), record["table"].as_u64());
        for (k, name) in ["a4_manhattan", "a8_euclid", "improved"].into_iter().enumerate() {
            assert_eq!(Some(row.nodes[k]), record["nodes"][name].as_f64());
            assert_eq!(Some(row.lengths[k]), record["length"][name].as_f64());
            let impossible = row.lengths[k] < row.straight();
            let flagged =
                record["violates_straight_line_bound"].as_array().unwrap().iter().any(|v| v == name);
            assert_eq!(impossible, flagged, "{} {name}", row.id);
        }
        assert!((row.straight() - record["straight_line_lower_bound"].as_f64().unwrap()).abs() < 1e-4);
        let table = summary(row, &figures(row, 1, 2)).unwrap();
        let shown = |figure, over| {
            table
                .ratios
                .iter()
                .find(|r| r.figure == figure && r.over == over && r.planner == "risk-field")
                .unwrap()
                .printed
        };
        for (figure, over, name) in [
            ("generated", "eight", "nodes_improved_over_a8"),
            ("generated", "four", "nodes_improved_over_a4"),
            ("lengthPruned", "eight", "length_improved_over_a8"),
        ] {
            let derived = record["derived"][name].as_f64().unwrap();
            assert!((shown(figure, over).unwrap() - derived).abs() < 1e-4, "{} {name}", row.id);
        }
    }
}

#[test]
fn slices_add_up_and_are_the_golden_figures() {
    let row = row("random-30").unwrap();
    let whole = figures(row, 1, 5);
    assert_eq!(whole, [figures(row, 1, 2), figures(row, 3, 5)].concat());
    let of = |map: usize, planner: &str, name: &str| {
        let planner = PLANNERS.iter().position(|p| *p == planner).unwrap();
        whole[map * WIDTH + planner * COLUMNS.len() + COLUMNS.iter().position(|c| *c == name).unwrap()]
    };
    // The first map is a golden one.
    let file: Value = serde_json::from_str(include_str!("data/grid-golden-vectors.json")).unwrap();
    for (map, seed) in [(0, 1)] {
        let golden = file["maps"]
            .as_array()
            .unwrap()
            .iter()
            .find(|m| m["family"] == "random" && m["n"] == 30 && m["seed"] == seed)
            .unwrap();
        let drawn = occupancy(Family::RANDOM, 30, seed).unwrap();
        assert_eq!(golden["blocked_cells"].as_u64().unwrap() as usize, drawn.blocked_cells());
        for (planner, name) in [
            ("four", "a4_manhattan"),
            ("eight", "a8_euclid"),
            ("eight-octile", "a8_octile"),
            ("sixteen", "a16"),
        ] {
            assert_eq!(golden["generated"][name].as_f64(), Some(of(map, planner, "generated")), "{planner}");
            assert_eq!(golden["expanded"][name].as_f64(), Some(of(map, planner, "expanded")), "{planner}");
        }
        assert_eq!(golden["risk"]["generated"].as_f64(), Some(of(map, "risk-field", "generated")));
        assert_eq!(golden["risk_plus"]["generated"].as_f64(), Some(of(map, "risk-field-plus", "generated")));
        let near = |name: &str, got: f64| (golden["risk"][name].as_f64().unwrap() - got).abs() < 1e-6;
        assert!(near("length_pruned", of(map, "risk-field", "lengthPruned")));
        assert!(near("length_dp", of(map, "risk-field", "lengthDp")));
    }
}

#[test]
fn bad_slices_are_named() {
    let row = row("regular-30").unwrap();
    assert!(
        parkade::papers::grid::row("regular-31")
            .unwrap_err()
            .to_string()
            .starts_with("row: must be one of regular-30")
    );
    let wrong = |from, to| measure(row, from, to, &mut still).unwrap_err().to_string();
    assert_eq!(wrong(3, 2), "to: must be 3 to 10002, got 2");
    assert_eq!(wrong(1, 20_000), "to: must be 1 to 10000, got 20000");
    assert_eq!(wrong(u64::MAX, 0).as_str(), format!("to: must be {0} to {0}, got 0", u64::MAX));
    assert!(
        summary(row, &[])
            .unwrap_err()
            .to_string()
            .starts_with("figures: must have 143 figures per map, got 0")
    );
    assert!(
        summary(row, &[f64::NAN; WIDTH]).unwrap_err().to_string().starts_with("figures[0]: must be a finite")
    );
}

/// A machine under load measures any time for any planner: counted work decides.
#[test]
fn no_clock_turns_a_verdict() {
    let judged = |clock: &mut dyn FnMut() -> f64| {
        let tables: Vec<_> = ROWS
            .iter()
            .map(|row| summary(row, &measure(row, 1, 3, &mut || clock()).unwrap()).unwrap())
            .collect();
        claims(&tables).iter().map(|claim| claim.holds).collect::<Vec<_>>()
    };
    let (mut now, mut pause) = (0.0, 1.0);
    let mut loaded = || {
        pause = (pause * 7.0) % 101.0;
        now += pause;
        now
    };
    let mut steady_now = 0.0;
    let mut steady = || {
        steady_now += 1.0;
        steady_now
    };
    let want = judged(&mut still);
    assert_eq!(judged(&mut loaded), want);
    assert_eq!(judged(&mut steady), want);
}

/// What the tables say is what the acceptance tests hold: nodes fit the column "generated", not "expanded".
#[test]
fn claims_are_judged_on_all_rows_only() {
    let tables: Vec<_> = ROWS.iter().map(|row| summary(row, &figures(row, 1, 30)).unwrap()).collect();
    assert!(claims(&tables[..2]).iter().all(|claim| claim.holds == "unknown"));
    let all = claims(&tables);
    let holds = |id: &str| all.iter().find(|c| c.id == id).unwrap().holds;
    assert_eq!(
        ["H1", "H2", "H3", "Y1", "Y2", "Y3", "Y4", "Y5", "Y6"].map(holds),
        ["partly", "partly", "partly", "yes", "partly", "partly", "yes", "partly", "yes"]
    );
    for table in &tables {
        let line = table.lines.iter().find(|l| l.planner == "risk-field").unwrap();
        let generated = line.figures[0].median;
        assert!((generated / line.printed_nodes.unwrap() - 1.0).abs() < 0.15, "{} {generated}", table.row.id);
    }
}

#[test]
fn the_road_manuscripts_printed_values_are_the_records() {
    let file: Value = serde_json::from_str(include_str!("data/paper-tables-road.json")).unwrap();
    for row in &road::ROWS {
        let p = &row.printed;
        for (name, values) in [
            ("path_length", p.length),
            ("turning_points", p.turns),
            ("safety_distance", p.safety),
            ("time", p.time),
            ("memory", p.memory),
            ("collisions_per_1000", p.collisions),
        ] {
            let record = &file["tables"][name][&row.id[..2]];
            assert_eq!([record[0].as_f64(), record[1].as_f64()], values.map(Some), "{} {name}", row.id);
        }
    }
}

#[test]
fn roads_keep_what_is_promised() {
    for row in road::ROWS.iter().filter(|row| !row.ship) {
        let table = road::measure(row, 1, &mut still).unwrap();
        for promise in &table.promises {
            assert!(promise.kept, "{}: {promise:?}", row.id);
        }
        let bytes = table.promises.iter().find(|p| p.figure == "bytesPerCell").unwrap();
        assert!(bytes.bound == 16.0 && bytes.found > 1.0, "{}: {bytes:?}", row.id);
        assert_eq!((table.lines[1].verdict, table.lines[1].fell_back), ("ok", false), "{}", row.id);
    }
    assert_eq!(road::row("S5").unwrap_err().path, "row");
    assert_eq!(road::measure(&road::ROWS[0], 0, &mut still).unwrap_err().path, "rounds");
}

/// Half of 16 m and a margin of 9 m make the manuscript's safety distance of 17 m. Cells keep it; where a curve swings
/// into the margin, the ship itself stays clear.
#[test]
fn the_ship_sails_all_four_scenes() {
    for row in road::ROWS.iter().filter(|row| row.ship) {
        let table = road::measure(row, 1, &mut still).unwrap();
        assert!(table.promises.is_empty());
        let (plain, literal) = (&table.lines[0], table.lines.last().unwrap());
        for line in &table.lines[1..3] {
            println!("{} {}: {:?} {}", row.id, line.id, line.metrics.figures, line.verdict);
            assert_eq!(
                (line.verdict, line.fell_back, line.risk.hits),
                ("ok", false, 0),
                "{} {}",
                row.id,
                line.id
            );
            assert!(line.metrics.figures.side_clearance_min >= 5.0, "{}: {:?}", row.id, line.metrics.figures);
            assert!(line.metrics.figures.middle_length <= plain.metrics.figures.middle_length + 1e-6);
        }
        let straight = row.id == "S1-ship";
        assert_eq!(
            (literal.verdict, literal.risk.hits),
            if straight { ("ok", 0) } else { ("collides", 1000) }
        );
    }
}
