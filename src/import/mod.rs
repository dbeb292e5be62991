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

mod line_reader;
pub mod lots;
mod movingai;
mod options;
mod pgm;
mod rosmap;
pub mod tpcap;

use serde_json::Value;

use crate::error::{Error, ErrorCode};
use crate::geometry::{Point, Pose, math};
use crate::map::{Cell, Frame, Occupancy, distance, raster};
use crate::scenario::{Goal, MapFrame, Obstacle, Scenario, VehicleSpec};

pub use options::{Options, Unknown};

/// Largest file that is read, bytes: room for the largest map, 4096 × 4096 cells, as decimal numbers.
pub const MAX_BYTES: usize = 80_000_000;

/// A file to import.
#[derive(Debug, Clone, Copy)]
pub struct File<'a> {
    /// Its name, with or without folders; its ending names its format.
    pub name: &'a str,
    /// Contents.
    pub bytes: &'a [u8],
}

/// The scenes and queries of the imported files.
/// A `movingai` or `ros-map` import has one scene, a `tpcap` file one, a file of lots one for each question.
#[derive(Debug, Clone)]
pub struct Imported {
    /// `movingai`, `ros-map`, `tpcap`, `lots` or `scene`.
    pub format: &'static str,
    /// The scenes, at least one.
    pub scenes: Vec<Scenario>,
    /// The questions that come with the map.
    pub queries: Vec<Question>,
    /// Remarks for people about how the files were read.
    pub notes: Vec<String>,
}

/// A start, a goal and the length of the shortest path between them.
/// Lengths and poses are in metres of the scene, whatever unit the file counts in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// The group of questions of about the same length that it is in.
    pub bucket: u32,
    /// The centre of the start's cell; the heading points to the goal.
    pub start: Pose,
    /// The centre of the goal's cell; the heading points away from the start.
    pub goal: Pose,
    /// Length of the shortest eight-connected path that touches no corner of a blocked cell, metres.
    pub length: f64,
}

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

/// True if the file's name ends in one of these, in small letters or capitals.
fn has(file: &File, endings: &[&str]) -> bool {
    ending(file.name).is_some_and(|e| endings.contains(&e.as_str()))
}

/// What follows the last dot of a name, in small letters.
fn ending(name: &str) -> Option<String> {
    name.rsplit_once('.').map(|(_, e)| e.to_ascii_lowercase())
}

/// A file's name without its folders.
fn base(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name)
}

/// A file's name without folders and endings.
fn stem(name: &str) -> &str {
    let base = base(name);
    base.split_once('.').map_or(base, |(stem, _)| stem)
}

/// The only file with one of these endings, if there is any.
///
/// # Errors
/// A second file of the same kind: which of them is meant would be a guess.
fn the_one<'a>(files: &[File<'a>], endings: &[&str]) -> Result<Option<File<'a>>, Error> {
    let mut fitting = files.iter().filter(|f| has(f, endings));
    let first = fitting.next().copied();
    match fitting.next() {
        Some(second) => {
            let rule = message!("must be the only .{} file", endings[0]);
            Err(Error::new(ErrorCode::Import, second.name, rule))
        }
        None => Ok(first),
    }
}

/// A map of cells as a scene without slots.
/// The map's first row is the southern one, as in all frames of this crate.
struct Raster {
    map: Occupancy,
    frame: MapFrame,
    vehicle: VehicleSpec,
}

impl Raster {
    /// The scene that goes from one cell to another, or along the farthest way of the largest room when none are given.
    ///
    /// # Errors
    /// No free cell, or a scene that [`Scenario::validate`] refuses.
    fn scene(self, ends: Option<[Cell; 2]>, file: &str) -> Result<Scenario, Error> {
        let frame = lattice(&self.frame);
        let car = self.vehicle.resolve()?;
        let room = || {
            let mut inside = self.map.clone();
            if let Some(outline) = &self.frame.boundary {
                let outline: Vec<Point> = outline.iter().map(|&[x, y]| Point::new(x, y)).collect();
                raster::fill_outside(&mut inside, &frame, &outline);
            }
            // Where the car can stand in every direction, if there is such a place.
            let reach = car.reach();
            let roomy = largest_room(&inner(&inside, reach / frame.resolution));
            roomy.filter(|[start, goal]| start != goal).or_else(|| largest_room(&inside))
        };
        let Some([start, goal]) = ends.or_else(room) else {
            return Err(Error::new(ErrorCode::Import, file, "must have a free cell"));
        };
        let [start, goal] = poses(&frame, start, goal);
        let scene = Scenario {
            version: 1,
            name: Some(stem(file).to_owned()),
            map: self.frame,
            obstacles: vec![Obstacle::Cells { id: None, runs: raster::to_runs(&self.map) }],
            slots: Vec::new(),
            costs: Vec::new(),
            moving: Vec::new(),
            lanes: Vec::new(),
            speed_limits: Vec::new(),
            vehicle: self.vehicle,
            start,
            goal: Goal::Pose(goal),
            planners: std::collections::BTreeMap::new(),
        };
        // A file may place its map beyond every scene.
        scene.validate().map_err(|e| e.within(file).with_code(ErrorCode::Import))?;
        Ok(scene)
    }
}

/// The map's frame as the rasters use it.
fn lattice(map: &MapFrame) -> Frame {
    let [x, y] = map.origin;
    Frame { origin: Point::new(x, y), width: map.width, height: map.height, resolution: map.resolution }
}

/// The poses in the middle of two cells, both along the line from the first to the second.
/// The heading is that of the straight line, so that a question without headings is one that a car can start from.
fn poses(frame: &Frame, start: Cell, goal: Cell) -> [Pose; 2] {
    let (dx, dy) = (f64::from(goal.x - start.x), f64::from(goal.y - start.y));
    let heading = math::atan2(dy, dx);
    [start, goal].map(|cell| {
        let at = frame.center(cell);
        Pose::new(at.x, at.y, heading)
    })
}

/// The map without the cells that lie less than `reach` cells from a blocked cell or the border.
/// What remains is where the middle of a disc of that radius may be.
fn inner(map: &Occupancy, reach: f64) -> Occupancy {
    let mut inner = map.clone();
    // From centre to centre; a cell's corner may be that much nearer.
    let apart = distance::to_centers(map, |d| (d as f64).sqrt() as f32 / 2.0);
    let (far, edge) = (reach + core::f64::consts::FRAC_1_SQRT_2, reach.ceil() as i32);
    for (index, &d) in apart.data.iter().enumerate() {
        let Cell { x, y } = map.cell(index as u32);
        let border = x.min(y).min(map.width() as i32 - 1 - x).min(map.height() as i32 - 1 - y);
        if border < edge || f64::from(d) < far {
            inner.set(Cell { x, y }, true);
        }
    }
    inner
}

/// The first and the last cell of the largest set of free cells that share edges, row by row.
/// `None` where every cell is blocked. A flood over the cells: O(cells).
fn largest_room(map: &Occupancy) -> Option<[Cell; 2]> {
    let mut seen = vec![false; map.len()];
    let mut largest = (0, None);
    let mut stack = Vec::new();
    for index in 0..map.len() as u32 {
        let first = map.cell(index);
        if map.blocked(first) || seen[index as usize] {
            continue;
        }
        let (mut size, mut last) = (0_u32, index);
        seen[index as usize] = true;
        stack.push(first);
        while let Some(cell) = stack.pop() {
            size += 1;
            last = last.max(map.index(cell));
            for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1)] {
                let next = cell.offset(dx, dy);
                if !map.blocked(next) && !std::mem::replace(&mut seen[map.index(next) as usize], true) {
                    stack.push(next);
                }
            }
        }
        if size > largest.0 {
            largest = (size, Some([first, map.cell(last)]));
        }
    }
    largest.1
}
