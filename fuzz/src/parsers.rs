//! Readers on files that are almost right: a scene that planners take, or an error that says where and what.

use parkade::error::ErrorCode;
use parkade::import::{File, Options as Reading, import};
use parkade::plan::{Options, Planner};
use parkade::scenario::{Scenario, catalog};
use serde_json::{Map, Value, json};

use crate::mutate::{altered, mutated};
use crate::random::Random;
use crate::{Outcome, configs};

const MAP: &str = "type octile\nheight 4\nwidth 5\nmap\n.@GT.\nS...@\nO..W.\n.....\n";
const SCEN: &str = "version 1\n0\troom.map\t5\t4\t0\t0\t2\t0\t3.41421356\n1 room.map 5 4 1 2 3 1 2.41421\n";
const YAML: &str = "image: lot.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.3]\nnegate: 0\noccupied_thresh: \
    0.65\nfree_thresh: 0.196\n";
const P2: &str = "P2\n# drawn by hand\n4 3\n255\n0 254 254 205\n205 254 0 254\n254 254 254 254\n";
const P5: &[u8] = b"P5 4 3 255\n\x00\xfe\xfe\xcd\xfe\xfe\x00\xfe\xfe\xfe\xfe\xfe";
const CASE: &str = "5,2,0.1,16,9,3.14,2,4,3,10,10,12,10,12,11,15,2,17,2,16,4.5,13,3";
const LOT: &str = concat!(
    r#"{"lots":[{"id":"lot","vehicle":{"wheelbase":2.7,"rear_axle_to_front":3.7,"#,
    r#""rear_axle_to_rear":1.0,"width":2.0,"max_steer":0.6},"#,
    r#""lines":[[0,0,20,0],[20,0,20,12],[0,12,20,12]],"#,
    r#""polygons":[[[4,4],[6,4],[6,6]],[[9,2],[9,3],[12,3],[12,2]]],"#,
    r#""start":[3,9,0],"goal":[15,9,1.57],"alternatives":[{"start":[4,5,0],"goal":[16,5,1]}]}]}"#
);

pub(crate) fn scene(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    let scenes: Vec<_> = catalog::scenes().collect();
    let scenario = catalog::scenario(r.pick(&scenes).id).map_err(|e| e.to_string())?;
    let whole = json!(scenario);
    let mut value = whole.clone();
    for _ in 0..=r.below(3) {
        altered(r, &mut value, &whole);
    }
    match Scenario::from_json(&value) {
        Ok(scene) => taken(r, &scene),
        Err(error) if [ErrorCode::Scenario, ErrorCode::Vehicle].contains(&error.code) => {
            said(&error.path, &error.message())
        }
        Err(error) => Err(format!("{:?}: {error}", error.code)),
    }
}

pub(crate) fn movingai(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    let (map, scen) = (mutated(r, MAP.as_bytes()), mutated(r, SCEN.as_bytes()));
    read(r, &[("room.map", &map), ("room.map.scen", &scen)])
}

pub(crate) fn rosmap(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    let picture = if r.one_in(2) { P2.as_bytes() } else { P5 };
    let (yaml, picture) = (mutated(r, YAML.as_bytes()), mutated(r, picture));
    read(r, &[("lot.yaml", &yaml), ("lot.pgm", &picture)])
}

pub(crate) fn tpcap(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    let case = mutated(r, CASE.as_bytes());
    read(r, &[("case.csv", &case)])
}

pub(crate) fn lots(seed: u64) -> Outcome {
    let r = &mut Random::new(seed);
    if r.one_in(3) {
        let text = mutated(r, LOT.as_bytes());
        return read(r, &[("lot.json", &text)]);
    }
    let whole: Value = serde_json::from_str(LOT).expect("the lot is JSON");
    let mut lot = whole.clone();
    for _ in 0..r.below(4) {
        altered(r, &mut lot, &whole);
    }
    read(r, &[("lot.json", lot.to_string().as_bytes())])
}

/// What a guided fuzzer found, as these files; where there are two, the first byte 1 parts them.
pub(crate) fn guided(names: &[&str], bytes: &[u8]) -> Outcome {
    let mut parts = bytes.splitn(names.len(), |&byte| byte == 1);
    let files: Vec<(&str, &[u8])> =
        names.iter().map(|&name| (name, parts.next().unwrap_or_default())).collect();
    read(&mut Random::new(bytes.len() as u64), &files)
}

/// The same of a scene.
pub(crate) fn guided_scene(bytes: &[u8]) -> Outcome {
    let Ok(value) = serde_json::from_slice::<Value>(bytes) else { return Ok("no JSON") };
    match Scenario::from_json(&value) {
        Ok(scene) => taken(&mut Random::new(bytes.len() as u64), &scene),
        Err(error) => said(&error.path, &error.message()),
    }
}

fn read(r: &mut Random, files: &[(&str, &[u8])]) -> Outcome {
    let files: Vec<File> = files.iter().map(|&(name, bytes)| File { name, bytes }).collect();
    match import(&files, &Reading::default()) {
        Ok(imported) => {
            let Some(scene) = imported.scenes.first() else { return Err("nothing was read".to_owned()) };
            for scene in &imported.scenes {
                scene.validate().map_err(|e| format!("an imported scene is invalid: {e}"))?;
            }
            taken(r, scene)
        }
        Err(error) if error.code == ErrorCode::Import => said(&error.path, &error.message()),
        Err(error) => Err(format!("{:?}: {error}", error.code)),
    }
}

/// A scene that was read is one that planners take, and the same when it is written and read again.
fn taken(r: &mut Random, scene: &Scenario) -> Outcome {
    let again = Scenario::from_json(&json!(scene)).map_err(|e| format!("written and read again: {e}"))?;
    if again != *scene {
        return Err("the scene differs when it is written and read again".to_owned());
    }
    let cells = u64::from(scene.map.width) * u64::from(scene.map.height);
    if cells > 250_000 {
        return Ok("large");
    }
    let id = *r.pick(&["four", "eight", "risk-field", "hybrid"]);
    let mut settings = Map::new();
    settings.insert("maxExpansions".to_owned(), 300.into());
    match Planner::new(id, scene, &settings) {
        Ok(mut planner) => configs::answered(&planner.plan(Options::default())),
        Err(error) => said(&error.path, &error.message()),
    }
}

fn said(path: &str, message: &str) -> Outcome {
    if message.len() < 4 { Err(format!("no rule: {path:?}: {message:?}")) } else { Ok("refused") }
}
