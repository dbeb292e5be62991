//! Files of any kind, whole and broken.

use parkade::error::ErrorCode;
use parkade::import::{Options, import};
use parkade::scenario::generate::SplitMix64;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::{MAP, P2, SCEN, YAML, file, read, refused};

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
                assert!(error.message().chars().count() < 200, "{error}");
                errors += 1;
            }
        }
    }
    assert!(scenes > 500 && errors > 5000, "{scenes} {errors}");
}
