//! `MovingAI`'s `.map` and `.scen`.

use parkade::error::ErrorCode;
use parkade::import::{File, MAX_BYTES, Options, import};
use parkade::map::Occupancy;
use parkade::scenario::Goal;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::{MAP, SCEN, cells, file, read, refused};

#[test]
fn a_map_stands_upright_and_its_questions_are_in_metres() {
    let imported = read(&[("maps/room.map", MAP), ("room.map.scen", SCEN)]);
    assert_eq!((imported.format, imported.scenes[0].name.as_deref()), ("movingai", Some("room")));
    assert_eq!(cells(&imported.scenes[0]), Occupancy::parse(".#.#\n....\n#..#"));
    let first = imported.queries[0];
    assert_eq!((first.bucket, first.length), (0, 3.414_213_56));
    assert_eq!((first.start.x, first.start.y, first.goal.x, first.goal.y), (0.0, 2.0, 2.0, 2.0));
    assert_eq!(imported.scenes[0].start, first.start);
    assert_eq!(imported.scenes[0].goal, Goal::Pose(first.goal));
    let second = imported.queries[1];
    assert_eq!((second.start.x, second.start.y, second.goal.x, second.goal.y), (1.0, 0.0, 3.0, 1.0));

    let windows = MAP.replace('\n', "\r\n");
    assert_eq!(read(&[("room.map", &windows)]).scenes[0].obstacles, imported.scenes[0].obstacles);
    assert_eq!(read(&[("room.map", MAP.trim_end())]).scenes[0].obstacles, imported.scenes[0].obstacles);
}

#[test]
fn options_choose_the_question_the_cell_and_the_car() {
    let files = [file("room.map", MAP), file("room.scen", SCEN)];
    let options = |value: serde_json::Value| Options::from_json(value.as_object().unwrap());
    let asked = options(serde_json::json!({ "resolution": 0.5, "query": 1, "vehicle": "sedan" })).unwrap();
    let imported = import(&files, &asked).unwrap();
    assert_eq!((imported.scenes[0].start.x, imported.scenes[0].map.origin), (0.5, [-0.25, -0.25]));
    assert!((imported.queries[1].length - 2.41421 / 2.0).abs() < 1e-12);
    let far = options(serde_json::json!({ "query": 2 })).unwrap();
    assert_eq!(import(&files, &far).unwrap_err().to_string(), "query: must be below 2, got 2");
    for (value, message) in [
        (serde_json::json!({ "query": -1 }), "query: must be a whole number from 0, got -1"),
        (serde_json::json!({ "resolution": 0 }), "resolution: must be 0.001 to 1000 m, got 0"),
        (serde_json::json!({ "unknown": "grey" }), "unknown: must be blocked or free, got \"grey\""),
        (serde_json::json!({ "vehicle": "truck" }), "vehicle: must be paper, sedan or dimensions"),
        (serde_json::json!({ "size": 3 }), "size: no option of importScene"),
    ] {
        let error = options(value).unwrap_err();
        assert_eq!(error.code, ErrorCode::Input);
        assert!(error.to_string().starts_with(message), "{error}");
    }
}

#[test]
fn without_questions_the_way_leads_through_the_largest_room() {
    let imported = read(&[("room.map", MAP)]);
    assert!(imported.queries.is_empty());
    let Goal::Pose(goal) = imported.scenes[0].goal else { panic!("a pose") };
    assert_eq!(
        (imported.scenes[0].start.x, imported.scenes[0].start.y, goal.x, goal.y),
        (1.0, 0.0, 2.0, 2.0)
    );
}

#[test]
fn without_questions_the_car_stands_free_where_there_is_room() {
    let yaml = "image: hall.pgm\nresolution: 0.5\norigin: [-10.0, -5.0, 0.0]\nnegate: 0\noccupied_thresh: \
        0.65\nfree_thresh: 0.196\n";
    let turned = yaml.replace("-5.0, 0.0]", "-5.0, 0.4]");
    // A hall of 40 m × 30 m with a wall into it from below.
    let wall = |x: u32, y: u32| x == 0 || y == 0 || x == 79 || y == 59 || (x / 4 == 9 && y > 30);
    let pixels: Vec<&str> =
        (0..60).flat_map(|y| (0..80).map(move |x| if wall(x, y) { "0" } else { "254" })).collect();
    let pgm = format!("P2\n80 60\n255\n{}\n", pixels.join(" "));
    for yaml in [yaml, &turned] {
        let scene = read(&[("hall.yaml", yaml), ("hall.pgm", &pgm)]).scenes.remove(0);
        let mut planner = parkade::plan::Planner::new("hybrid", &scene, &serde_json::Map::new()).unwrap();
        let plan = planner.plan(parkade::plan::Options::default());
        assert_eq!(plan.outcome, parkade::plan::Outcome::Found, "{:?}", plan.reason);
        assert!(plan.metrics.length > 15.0, "{}", plan.metrics.length);
    }
}

#[test]
fn broken_maps_are_refused_by_line() {
    let map = |from: &str, to: &str| refused(&[("room.map", &MAP.replacen(from, to, 1))]);
    let scen =
        |from: &str, to: &str| refused(&[("room.map", MAP), ("room.scen", &SCEN.replacen(from, to, 1))]);
    let cases = [
        (map("octile", "hex"), "room.map:1: must be \"type octile\", got \"type hex\""),
        (map("height 3", "height -3"), "room.map:2: height must be 1 to 4096, got \"-3\""),
        (map("height 3", "height 0"), "room.map:2: height must be 1 to 4096, got 0"),
        (map("width 4", "width 40000"), "room.map:3: width must be 1 to 4096, got 40000"),
        (map("width 4", "width 4 4"), "room.map:3: must be \"height\", \"width\" or \"map\""),
        (map("width 4\n", ""), "room.map:3: must come after the map's width"),
        (map("height 3\n", ""), "room.map:3: must come after the map's height"),
        (map("height 3", "height 4000"), "room.map:8: must be row 4 of 4000, got the end of the file"),
        (map("\nO..W\n", ""), "room.map:7: must be row 3 of 3, got the end of the file"),
        (map("width 4", "width 4096"), "room.map:5: must have 4096 characters, got 4"),
        (map("S...", "S.x."), "room.map:6: column 3: must be one of .GS@OTW, got 'x'"),
        (map("S...\n", "S..\n."), "room.map:6: must have 4 characters, got 3"),
        (map("O..W\n", "O..W\n\n....\n"), "room.map:9: must be the end, after 3 rows"),
        (map(MAP, ""), "room.map:1: must be \"type octile\", got the end of the file"),
        (
            map(MAP, "type octile\nheight 3\n"),
            "room.map:3: must be \"height\", \"width\" or \"map\", got the end",
        ),
        (map(".@GT\nS...\nO..W", "@@@@\n@@@@\n@@@@"), "room.map: must have a free cell"),
        (map("type", &"x".repeat(2000)), "room.map:1: must have at most 1000 bytes, got 2007"),
        (scen("version 1", "version 2"), "room.scen:1: must be \"version 1\", got \"version 2\""),
        (scen("\t0\t0\t2", "\t0\t-1\t2"), "room.scen:2: start y must be 0 to 2, got \"-1\""),
        (scen("3 1 2.4", "4 1 2.4"), "room.scen:3: goal x must be 0 to 3, got 4"),
        (scen("2.41421", "NaN"), "room.scen:3: length must be a number from 0, got \"NaN\""),
        (scen("2.41421", ""), "room.scen:3: must have 9 fields, got 8"),
        (scen("\t4\t3", "\t5\t3"), "room.scen:2: width must be the map's 4, got \"5\""),
        (scen("maps/room.map", "hall.map"), "room.scen:2: must be about \"room.map\", got \"hall.map\""),
        (refused(&[("room.map", MAP), ("room.scen", "version 1\n")]), "room.scen:2: must hold a question"),
        (refused(&[("room.scen", SCEN)]), "room.scen: must come with the .map file that it names"),
        (refused(&[("a.map", MAP), ("b.map", MAP)]), "b.map: must be the only .map file"),
        (refused(&[("room.txt", MAP)]), "room.txt: must end in .map"),
        (refused(&[]), "files: must hold a file"),
    ];
    for (got, expected) in cases {
        assert!(got.starts_with(expected), "{got}\nis not\n{expected}");
    }
}

#[test]
fn junk_is_refused_by_its_size() {
    let junk = vec![b'.'; MAX_BYTES + 1];
    let error = import(&[File { name: "junk.map", bytes: &junk }], &Options::default()).unwrap_err();
    assert_eq!((error.code, error.path.as_str()), (ErrorCode::Import, "junk.map:1"));
    for name in ["junk.map", "junk.pgm", "junk.yaml"] {
        let files = [File { name, bytes: &junk[1..] }];
        assert_eq!(import(&files, &Options::default()).unwrap_err().code, ErrorCode::Import);
    }
}

/// Where the published maps lie, and where to get them.
#[cfg(not(target_arch = "wasm32"))]
fn published(name: &str) -> Option<Vec<u8>> {
    let folder = std::env::var("PARKADE_DATA").unwrap_or_else(|_| "../shared/data".to_owned());
    let path = std::path::Path::new(&folder).join("movingai").join(name);
    let bytes = std::fs::read(&path);
    if bytes.is_err() {
        println!("skipped: {} is not there; get it from movingai.com/benchmarks", path.display());
    }
    bytes.ok()
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn eight_neighbours_are_as_short_as_published() {
    use parkade::planners::grid_astar::{self, Config};
    use parkade::planners::heuristics::Heuristic;
    use parkade::planners::moves::Neighbourhood;
    use parkade::planners::query::{GridScratch, Query};

    use super::frame;

    for (name, questions) in [
        ("Berlin_0_256", 930),
        ("brc202d", 2519),
        ("maze512-4-0", 9730),
        ("random512-25-0", 1840),
        ("London_1_1024", 3410),
    ] {
        let (map, scen) = (format!("{name}.map"), format!("{name}.map.scen"));
        let (Some(map_bytes), Some(scen_bytes)) = (published(&map), published(&scen)) else { continue };
        let files = [File { name: &map, bytes: &map_bytes }, File { name: &scen, bytes: &scen_bytes }];
        let imported = import(&files, &Options::default()).unwrap();
        assert_eq!(imported.queries.len(), questions, "{name}");
        let (map, frame) = (cells(&imported.scenes[0]), frame(&imported.scenes[0]));
        let mut scratch = GridScratch::new();
        for question in imported.queries.iter().step_by(questions / 12) {
            let cell = |pose: parkade::geometry::Pose| frame.cell_at(pose.point()).unwrap();
            let query = Query { map: &map, start: cell(question.start), goal: cell(question.goal) };
            let eight = Neighbourhood::Eight;
            let config = Config { heuristic: Heuristic::Octile, ..Config::new(eight) };
            let report = grid_astar::plan(query, eight, &config, &mut scratch, &mut ());
            let length = parkade::metrics::grid::length(&report.cells);
            let slack = 2e-5 * question.length + 0.006;
            assert!((length - question.length).abs() < slack, "{name} {question:?}: {length}");
        }
    }
}
