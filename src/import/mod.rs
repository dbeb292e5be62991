//! Maps of other programs as scenes.
//!
//! Which format a file has is told by its name: `.map` and `.scen` (`MovingAI`), `.yaml` and `.pgm` (ROS maps), `.csv`
//! (TPCAP cases), `.json` (scenes, and lots of lines and polygons). Files that belong together are given together.
//! Every file is distrusted: sizes are compared with the bytes that are there before anything is allocated for them,
//! and what is wrong is said with the file's name and line.
//!
//! What a map of cells does not say is added by one rule: the car by [`Options::vehicle`], start and goal, where no
//! question gives them, as the two ends of the largest connected room in which the car has space to turn. The result
//! is a valid scene; what would not be one is an import error.
//!
//! Complexity is linear in the bytes of the files and the cells of the map.

mod cell_map;
mod file;
mod imported;
mod line_reader;
pub mod lots;
mod movingai;
mod options;
mod pgm;
mod rosmap;
pub mod tpcap;

use serde_json::Value;

use crate::error::{Error, ErrorCode};
use crate::scenario::Scenario;
use file::{has, stem, the_one};

pub use file::{File, MAX_BYTES};
pub use imported::{Imported, Question};
pub use options::{Options, Unknown};

/// Reads files as a scene.
///
/// # Errors
/// [`ErrorCode::Import`] with `file:line` as its path; [`ErrorCode::Input`] for the options.
///
/// # Examples
/// ```
/// use parkade::import::{File, Options, import};
///
/// let map = File { name: "room.map", bytes: b"type octile\nheight 2\nwidth 3\nmap\n..@\n...\n" };
/// let imported = import(&[map], &Options::default()).unwrap();
/// assert_eq!((imported.format, imported.scenes[0].map.width), ("movingai", 3));
///
/// let short = File { name: "room.map", bytes: b"type octile\nheight 2\nwidth 3\nmap\n..@\n..\n" };
/// let error = import(&[short], &Options::default()).unwrap_err();
/// assert_eq!(error.to_string(), "room.map:6: must have 3 characters, got 2");
/// ```
pub fn import(files: &[File], options: &Options) -> Result<Imported, Error> {
    const MAIN: [&[&str]; 4] = [&["map", "scen"], &["yaml", "yml", "pgm"], &["csv"], &["json"]];
    for file in files {
        if file.bytes.len() > MAX_BYTES {
            let line = file.bytes[..MAX_BYTES].split(|&b| b == b'\n').count();
            let rule = message!(
                "must end the file, which may have {} bytes and has {}",
                MAX_BYTES,
                file.bytes.len()
            );
            return Err(line_reader::at(file.name, line, rule));
        }
        if !MAIN.iter().any(|kind| has(file, kind)) {
            return Err(Error::new(
                ErrorCode::Import,
                file.name,
                "must end in .map, .scen, .yaml, .pgm, .csv or .json",
            ));
        }
    }
    let Some(kind) = files.first().and_then(|first| MAIN.into_iter().find(|kind| has(first, kind))) else {
        return Err(Error::new(ErrorCode::Import, "files", "must hold a file"));
    };
    if let Some(stranger) = files.iter().find(|f| !has(f, kind)) {
        let rule = message!("must belong to {}", files[0].name);
        return Err(Error::new(ErrorCode::Import, stranger.name, rule));
    }
    match kind[0] {
        "map" => movingai::read(the_one(files, &["map"])?, the_one(files, &["scen"])?, options),
        "yaml" => match the_one(files, &["yaml", "yml"])? {
            Some(yaml) => rosmap::read(yaml, files, options),
            None => Err(Error::new(
                ErrorCode::Import,
                files[0].name,
                "must come with the .yaml file that describes it",
            )),
        },
        _ => match the_one(files, kind)? {
            Some(file) => options.refuse_for_scenes().and_then(|()| read_scenes(file)),
            None => Err(Error::new(ErrorCode::Import, files[0].name, "must be given")),
        },
    }
}

/// Scenes that need no options: a TPCAP case, lots, or a scene as this crate writes it.
/// A `.json` file with a `version` is a scene; one with `lots` is a list of lots. Anything else is an error that says
/// so.
fn read_scenes(file: File) -> Result<Imported, Error> {
    let inside = |e: Error| e.within(file.name).with_code(ErrorCode::Import);
    let text = std::str::from_utf8(file.bytes)
        .map_err(|_| Error::new(ErrorCode::Import, file.name, "must be text in UTF-8"))?;
    let text = text.trim_start_matches('\u{feff}');
    let done = |format, scenes| Imported { format, scenes, queries: Vec::new(), notes: Vec::new() };
    if has(&file, &["csv"]) {
        let numbered = |e: Error| match e.path.strip_prefix("line ") {
            Some(line) => {
                let path = format!("{}:{line}", file.name);
                e.with_path(path)
            }
            None => inside(e),
        };
        return Ok(done("tpcap", vec![tpcap::scene(stem(file.name), text).map_err(numbered)?]));
    }
    let value: Value = serde_json::from_str(text)
        .map_err(|e| line_reader::at(file.name, e.line(), message!("is not JSON: {}", e)))?;
    if value.get("version").is_some() {
        return Ok(done("scene", vec![Scenario::from_json(&value).map_err(inside)?]));
    }
    let Some(all) = value.get("lots").and_then(Value::as_array).filter(|lots| !lots.is_empty()) else {
        return Err(Error::new(
            ErrorCode::Import,
            file.name,
            "must be a scene with its version, or hold lots",
        ));
    };
    let mut scenes = Vec::new();
    for (i, lot) in all.iter().enumerate() {
        scenes.extend(lots::scenes(lot).map_err(|e| inside(e.within(&format!("lots[{i}]"))))?);
    }
    Ok(done("lots", scenes))
}
