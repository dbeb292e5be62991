//! Maps of other programs: what they say is what the scene says, and no file, however broken, does worse than an error.
#![cfg(feature = "complete")]

use parkade::error::ErrorCode;
use parkade::geometry::{Point, math};
use parkade::import::{File, Imported, MAX_BYTES, Options, Unknown, import};
use parkade::map::{Frame, Occupancy, raster};
use parkade::scenario::generate::SplitMix64;
use parkade::scenario::{Goal, Obstacle, Scenario};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const MAP: &str = "type octile\nheight 3\nwidth 4\nmap\n.@GT\nS...\nO..W\n";
const SCEN: &str =
    "version 1\n0\tmaps/room.map\t4\t3\t0\t0\t2\t0\t3.41421356\n1 room.map 4 3 1 2 3 1 2.41421\n";
const YAML: &str = "image: lot.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
const P2: &str = "P2\n# drawn by hand\n3 2\n255\n0 254 254\n205 254 0\n";

fn file<'a>(name: &'a str, text: &'a str) -> File<'a> {
    File { name, bytes: text.as_bytes() }
}

fn read(files: &[(&str, &str)]) -> Imported {
    let files: Vec<File> = files.iter().map(|&(name, text)| file(name, text)).collect();
    import(&files, &Options::default()).unwrap()
}

fn refused(files: &[(&str, &str)]) -> String {
    let files: Vec<File> = files.iter().map(|&(name, text)| file(name, text)).collect();
    let error = import(&files, &Options::default()).unwrap_err();
    assert_eq!(error.code, ErrorCode::Import);
    error.to_string()
}

fn frame(scene: &Scenario) -> Frame {
    let map = &scene.map;
    Frame {
        origin: Point::new(map.origin[0], map.origin[1]),
        width: map.width,
        height: map.height,
        resolution: map.resolution,
    }
}

fn cells(scene: &Scenario) -> Occupancy {
    let mut map = Occupancy::new(scene.map.width, scene.map.height);
    let Obstacle::Cells { runs, .. } = &scene.obstacles[0] else { panic!("cells") };
    raster::runs(&mut map, runs);
    map
}

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
    let yaml = "image: hall.pgm\nresolution: 0.5\norigin: [-10.0, -5.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
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

#[test]
fn a_ros_map_lies_where_its_origin_says() {
    let imported = read(&[("maps/lot.yaml", YAML), ("lot.pgm", P2)]);
    let scene = &imported.scenes[0];
    assert_eq!((imported.format, scene.map.origin, scene.map.resolution), ("ros-map", [-1.0, 2.0], 0.5));
    // 205 of 255 is neither free nor occupied.
    assert_eq!(cells(scene), Occupancy::parse("#..\n#.#"));
    assert_eq!(imported.notes, ["1 unknown cells count as blocked."]);
    let options = Options { unknown: Unknown::Free, ..Options::default() };
    let free = import(&[file("lot.yaml", YAML), file("lot.pgm", P2)], &options).unwrap();
    assert_eq!(cells(&free.scenes[0]), Occupancy::parse("#..\n..#"));
}

#[test]
fn pictures_as_bytes_and_as_text_are_the_same() {
    let text = cells(&read(&[("lot.yaml", YAML), ("lot.pgm", P2)]).scenes[0]);
    let bytes = |head: &str, values: &[u8]| {
        let picture = [head.as_bytes(), values].concat();
        let files = [file("lot.yaml", YAML), File { name: "lot.pgm", bytes: &picture }];
        cells(&import(&files, &Options::default()).unwrap().scenes[0])
    };
    assert_eq!(bytes("P5\n#x\n3 2 255\n", &[0, 254, 254, 205, 254, 0]), text);
    assert_eq!(bytes("P5\r\n3 2\r\n255\r\n", &[0, 254, 254, 205, 254, 0]), text);
    // A first pixel that looks like a line's end.
    assert_eq!(bytes("P5\n3 2\n255\n", &[10, 254, 254, 205, 254, 0]), text);
    let wide = [0, 0, 4, 0, 4, 0, 3, 51, 4, 0, 0, 0];
    assert_eq!(bytes("P5 3 2 1024\n", &wide), text);
}

#[test]
fn thresholds_modes_and_negate_are_kept() {
    let with = |yaml: &str, values: &str| {
        let picture = format!("P2 4 1 255 {values}");
        let imported = read(&[("lot.yaml", yaml), ("lot.pgm", &picture)]);
        (raster::to_runs(&cells(&imported.scenes[0])), imported.notes.len())
    };
    let yaml = |more: &str| format!("image: lot.pgm\nresolution: 1\norigin: [0, 0, 0]\n{more}");
    // Shares occupied: 0.647, between the thresholds, then 0.66, 0.2 and 0.1.
    let values = "90 86 204 230";
    assert_eq!(with(&yaml(""), values), (vec![[0, 0, 2]], 1));
    let dark = "90 86 20 230";
    assert_eq!(with(&yaml("negate: 1"), dark), (vec![[0, 0, 2], [3, 0, 1]], 1));
    assert_eq!(with(&yaml("negate: true\nfree_thresh: 0.34"), dark), (vec![[0, 0, 1], [3, 0, 1]], 1));
    assert_eq!(with(&yaml("mode: scale"), values), (vec![[1, 0, 1]], 1));
    assert_eq!(with(&yaml("mode: raw"), "0 65 66 255"), (vec![[2, 0, 2]], 1));
    let listed = "image: 'lot.pgm' \nresolution: 1 # metres\norigin:\n- 0\n  - 0\n- 0.0\nfloor: 3\n";
    assert_eq!(with(listed, values), (vec![[0, 0, 2]], 1));
}

/// Every pixel of a turned picture is found again where it lies in the world.
#[test]
fn a_turned_map_keeps_its_places() {
    let (width, height) = (23, 17);
    let mut random = SplitMix64::new(7);
    let values: Vec<u8> = (0..width * height).map(|_| if random.below(5) == 0 { 0 } else { 255 }).collect();
    let picture = [format!("P5 {width} {height} 255\n").as_bytes(), &values[..]].concat();
    for yaw in [0.0, 0.3, -1.1, math::FRAC_PI_2, math::PI, 2.5] {
        let yaml = format!("image: lot.pgm\nresolution: 0.2\norigin: [3.5, -7.25, {yaw}]\n");
        let files = [file("lot.yaml", &yaml), File { name: "lot.pgm", bytes: &picture }];
        let scene = import(&files, &Options::default()).unwrap().scenes.remove(0);
        assert!(scene.geometry().is_ok());
        let (map, frame) = (cells(&scene), frame(&scene));
        let (sin, cos) = math::sin_cos(yaw);
        let world =
            |x: f64, y: f64| Point::new(3.5 + 0.2 * (cos * x - sin * y), -7.25 + 0.2 * (sin * x + cos * y));
        for (index, &value) in values.iter().enumerate() {
            let (x, y) = ((index % width) as f64, (height - 1 - index / width) as f64);
            let cell = frame.cell_at(world(x + 0.5, y + 0.5)).unwrap();
            assert!(value != 0 || map.blocked(cell), "{yaw} {x} {y}");
        }
        // No cell is blocked without a blocked pixel beside it.
        for index in 0..map.len() as u32 {
            let cell = map.cell(index);
            let near = values.iter().enumerate().any(|(i, &value)| {
                let (x, y) = ((i % width) as f64, (height - 1 - i / width) as f64);
                value == 0 && (world(x + 0.5, y + 0.5) - frame.center(cell)).norm() < 0.2 * 1.42
            });
            assert!(!map.blocked(cell) || near, "{yaw} {cell:?}");
        }
        if yaw == math::PI {
            assert_eq!((frame.width, frame.height), (23, 17));
            assert_eq!(map.blocked_cells(), values.split(|&v| v == 0).count() - 1);
        }
    }
}

#[test]
fn broken_ros_maps_are_refused_by_line() {
    let yaml = |from: &str, to: &str| refused(&[("lot.yaml", &YAML.replacen(from, to, 1)), ("lot.pgm", P2)]);
    let pgm = |text: &str| refused(&[("lot.yaml", YAML), ("lot.pgm", text)]);
    let cases = [
        (yaml("resolution: 0.5\n", ""), "lot.yaml: must say its resolution"),
        (yaml("0.5", "-0.5"), "lot.yaml:2: resolution must be 0.001 to 1000 m, got -0.5"),
        (yaml("0.5", "inf"), "lot.yaml:2: resolution must be finite, got inf"),
        (yaml("[-1.0, 2.0, 0.0]", "[-1.0, 2.0]"), "lot.yaml: origin must have 3 numbers, got 2"),
        (yaml("[-1.0, 2.0, 0.0]", "[1, 2, 3, 4]"), "lot.yaml:3: origin must have 3 numbers, has more"),
        (yaml("[-1.0, 2.0, 0.0]", "here"), "lot.yaml:3: origin must be [x, y, yaw], got \"here\""),
        (yaml("[-1.0,", "[x,"), "lot.yaml:3: origin must be a number, got \"x\""),
        (yaml("[-1.0,", "[1e300,"), "lot.yaml.map.origin: must be finite"),
        (yaml("negate: 0", "negate: 2"), "lot.yaml:4: negate must be 0 or 1, got \"2\""),
        (yaml("0.65", "65"), "lot.yaml:5: occupied_thresh must be 0 to 1, got 65"),
        (yaml("0.196", "0.7"), "lot.yaml: free_thresh must be at most occupied_thresh, got 0.7 and 0.65"),
        (yaml("negate: 0", "mode: grey"), "lot.yaml:4: mode must be trinary, scale or raw, got \"grey\""),
        (yaml("negate: 0", "negate"), "lot.yaml:4: must be \"key: value\", got \"negate\""),
        (refused(&[("lot.yaml", YAML)]), "lot.yaml: must come with its picture \"lot.pgm\" as a .pgm file"),
        (refused(&[("lot.pgm", P2)]), "lot.pgm: must come with the .yaml file that describes it"),
        (pgm("P6\n1 1\n255\n000"), "lot.pgm:1: must begin with P2 or P5"),
        (pgm("P2\n# x\n0 2\n255\n"), "lot.pgm:3: width must be 1 to 4096, got \"0\""),
        (pgm("P2 3 5000 255 0"), "lot.pgm:1: height must be 1 to 4096, got \"5000\""),
        (pgm("P2 3 2 70000 0"), "lot.pgm:1: largest value must be 1 to 65535, got \"70000\""),
        (pgm("P2\n3 2\n255\n0 1 2\n3 4"), "lot.pgm:3: must hold 3 × 2 values, only 10 bytes are left"),
        (pgm("P2\n3 2\n255\n00 1 2\n3 4   "), "lot.pgm:5: value must be 0 to 255, got the end of the file"),
        (pgm("P2\n3 2\n255\n0 1 2\n3 400 5"), "lot.pgm:5: value must be 0 to 255, got \"400\""),
        (pgm("P2\n3 2\n255\n0 1 2\n3 -4 5"), "lot.pgm:5: value must be 0 to 255, got \"-4\""),
        (pgm("P5\n3 2\n255\n12345"), "lot.pgm:3: must hold 3 × 2 values, only 6 bytes are left"),
        (pgm("P5\n3 2\n50\n12345X"), "lot.pgm:4: values must be 0 to 50, got 51 at 2"),
        (pgm("P5\n4096 4096\n255\n"), "lot.pgm:3: must hold 4096 × 4096 values, only 1 bytes are left"),
    ];
    for (got, expected) in cases {
        assert!(got.starts_with(expected), "{got}\nis not\n{expected}");
    }
}

#[test]
fn scenes_and_lots_are_read_too() {
    let scene = parkade::scenario::catalog::scenario("parallel").unwrap();
    let text = serde_json::to_string_pretty(&scene).unwrap();
    let imported = read(&[("mine.json", &text)]);
    assert_eq!((imported.format, &imported.scenes[0]), ("scene", &scene));
    let case = read(&[("TPCAP/Case1.csv", "0,0,0, 8,0,0, 1,4, 3,2,5,2,5,3,3,3")]);
    assert_eq!((case.format, case.scenes[0].name.as_deref()), ("tpcap", Some("Case1")));
    let cases = [
        (
            refused(&[("mine.json", &text.replace("\"version\": 1", "\"version\": 2"))]),
            "mine.json.version: must be 1, got 2",
        ),
        (refused(&[("mine.json", &text[..90])]), "mine.json:"),
        (refused(&[("mine.json", "[]")]), "mine.json: must be a scene with its version, or hold lots"),
        (refused(&[("mine.json", "{\"lots\": [{}]}")]), "mine.json.lots[0]: missing field"),
        (refused(&[("case.csv", "0,0,0,x")]), "case.csv:1: number 4"),
        (refused(&[("room.map", MAP), ("case.csv", "0")]), "case.csv: must belong to room.map"),
    ];
    for (got, expected) in cases {
        assert!(got.starts_with(expected), "{got}\nis not\n{expected}");
    }
    let options = Options { resolution: Some(1.0), ..Options::default() };
    let error = import(&[file("mine.json", &text)], &options).unwrap_err();
    assert_eq!(error.to_string(), "resolution: must be left out: the file says its own");
}

/// Cuts, repeats and scribbles over a file.
fn mutated(random: &mut SplitMix64, file: &[u8]) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() as u32 + 1) as usize;
        let to = (at + random.below(12) as usize).min(bytes.len());
        match random.below(6) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..to)),
            2 => bytes
                .splice(
                    at..at,
                    [b"-1", &b"\n"[..], b"99999999999", b"\xff\xfe", b" "][random.below(5) as usize].to_vec(),
                )
                .for_each(drop),
            3 => bytes[at..to].fill(random.below(256) as u8),
            4 => bytes.extend_from_within(at..to),
            _ => bytes[at..to].reverse(),
        }
    }
    bytes
}

#[test]
fn mutated_files_are_scenes_or_errors() {
    let mut random = SplitMix64::new(2026);
    let sets: [[(&str, &str); 2]; 2] =
        [[("room.map", MAP), ("room.scen", SCEN)], [("lot.yaml", YAML), ("lot.pgm", P2)]];
    let p5 = ("lot.pgm", "P5\n3 2\n255\n012345");
    let (mut scenes, mut errors) = (0, 0);
    for round in 0..20_000 {
        let mut set = sets[round % 2];
        if round % 4 == 1 {
            set[1] = p5;
        }
        let broken = mutated(&mut random, set[round / 2 % 2].1.as_bytes());
        let mut files = set.map(|(name, text)| file(name, text));
        files[round / 2 % 2].bytes = &broken;
        match import(&files, &Options::default()) {
            Ok(imported) => {
                imported.scenes[0].validate().unwrap();
                scenes += 1;
            }
            Err(error) => {
                assert!(error.code == ErrorCode::Import && !error.path.is_empty(), "{error:?}");
                assert!(error.message.chars().count() < 200, "{error}");
                errors += 1;
            }
        }
    }
    assert!(scenes > 500 && errors > 5000, "{scenes} {errors}");
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
