//! ROS's `.yaml` and `.pgm`.

use parkade::geometry::{Point, math};
use parkade::import::{File, Options, Unknown, import};
use parkade::map::{Occupancy, raster};
use parkade::scenario::generate::SplitMix64;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::{P2, YAML, cells, file, frame, read, refused};

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
