//! `MovingAI` grid maps and their questions (Sturtevant 2012): `.map` and `.scen`.
//!
//! A map's first line is the northern row; `.`, `G` and `S` are free, `@`, `O`, `T` and `W` are blocked. Questions
//! count rows from the north; a cell is a metre, and the centre of the south-western one is the origin, unless asked
//! otherwise.
//!
//! The benchmark's rule for corners is strict: a diagonal step needs both side cells to be free. Its lengths count √2
//! a diagonal and 1 a straight step, in cells; they come with the questions as [`Question::length`], so that a
//! planner's path can be compared with the optimum.
//!
//! Errors name the line: a row of another length, a letter that stands for no terrain, a question about another map
//! or a cell off the map. Nothing is allocated for the size in the head before as many rows have been seen.
//!
//! Coordinates: the scene's y grows to the north and the file's rows grow to the south, so row r of h rows is y = h −
//! 1 − r. With cells of s metres the centre of cell (x, y) is at (s·x, s·y), because the map's lower left corner is
//! at (−s/2, −s/2).

use super::cell_map::{Raster, lattice, poses};
use super::file::{File, base};
use super::imported::{Imported, Question};
use super::line_reader::{Line, Lines, at, quoted};
use super::options::Options;
use crate::error::{Error, ErrorCode};
use crate::map::{Cell, Frame, Occupancy};
use crate::scenario::generate::CART;
use crate::scenario::{MAX_CELLS, MapFrame, VehicleSpec};
use crate::vehicle::Vehicle;

/// Most questions of one file; the largest published ones have some ten thousand.
const MAX_QUESTIONS: usize = 1_000_000;

/// Reads a map and, where there is one, its file of questions; the question of the options gives start and goal.
///
/// # Errors
/// A map that is missing, anything in the files that the format does not allow, or the number of a question
/// that there is not.
pub(super) fn read(map: Option<File>, scen: Option<File>, options: &Options) -> Result<Imported, Error> {
    let Some(map_file) = map else {
        let name = scen.map_or("files", |f| f.name);
        return Err(Error::new(ErrorCode::Import, name, "must come with the .map file that it names"));
    };
    let map = read_map(map_file)?;
    let side = options.resolution.unwrap_or(1.0);
    let origin = [-0.5 * side; 2];
    let frame =
        MapFrame { origin, width: map.width(), height: map.height(), resolution: side, boundary: None };
    let questions = match scen {
        Some(scen) => read_questions(scen, map_file.name, &map, &lattice(&frame))?,
        None => Vec::new(),
    };
    let ends = match questions.get(options.query) {
        Some(question) => Some(question.ends),
        None if questions.is_empty() && options.query == 0 => None,
        None => {
            let rule = message!("must be below {}, got {}", questions.len(), options.query);
            return Err(Error::new(ErrorCode::Input, "query", rule));
        }
    };
    let vehicle = options.vehicle.clone().unwrap_or_else(|| VehicleSpec::Custom(cart(side)));
    let scene = Raster { map, frame, vehicle }.scene(ends, map_file.name)?;
    let queries = questions.into_iter().map(|q| q.question).collect();
    Ok(Imported { format: "movingai", scenes: vec![scene], queries, notes: Vec::new() })
}

/// A car that fits between cells of `side` metres.
/// The same proportions at every size, so that a map is as tight at half a metre a cell as at one.
fn cart(side: f64) -> Vehicle {
    Vehicle {
        wheelbase: CART.wheelbase * side,
        width: CART.width * side,
        rear_to_front: CART.rear_to_front * side,
        rear_to_back: CART.rear_to_back * side,
        ..CART
    }
}

/// The cells of a `.map` file.
/// Lines before `map` may come in any order; after the last row only blank lines may follow.
fn read_map(file: File) -> Result<Occupancy, Error> {
    let mut lines = Lines::new(file);
    let first = lines.need("\"type octile\"")?;
    match first.text()?.split_ascii_whitespace().collect::<Vec<_>>()[..] {
        ["type", "octile" | "tile"] => {}
        _ => return Err(first.error(message!("must be \"type octile\", got {}", quoted(first.text()?)))),
    }
    let (mut width, mut height) = (None, None);
    let body = loop {
        let line = lines.need("\"height\", \"width\" or \"map\"")?;
        let words: Vec<&str> = line.text()?.split_ascii_whitespace().collect();
        match words[..] {
            ["height", text] => height = Some(side(&line, "height", text)?),
            ["width", text] => width = Some(side(&line, "width", text)?),
            ["map"] => break line,
            _ => {
                let rule = message!("must be \"height\", \"width\" or \"map\", got {}", quoted(line.text()?));
                return Err(line.error(rule));
            }
        }
    };
    let (Some(width), Some(height)) = (width, height) else {
        let missing = if width.is_none() { "width" } else { "height" };
        return Err(body.error(message!("must come after the map's {}", missing)));
    };
    // Room for the map is made once all of its rows are known to be there.
    let row = |number: u32| {
        let line = lines.need(&format!("row {number} of {height}"))?;
        if line.bytes.len() == width as usize {
            return Ok(line);
        }
        Err(line.error(message!("must have {} characters, got {}", width, line.bytes.len())))
    };
    let rows = (1..=height).map(row).collect::<Result<Vec<_>, Error>>()?;
    let mut map = Occupancy::new(width, height);
    for (y, line) in (0..height).rev().zip(&rows) {
        for (x, &terrain) in line.bytes.iter().enumerate() {
            match terrain {
                b'.' | b'G' | b'S' => {}
                b'@' | b'O' | b'T' | b'W' => map.set(Cell::new(x as i32, y as i32), true),
                _ => {
                    let got = char::from(terrain);
                    return Err(line.error(message!(
                        "column {}: must be one of .GS@OTW, got {}",
                        x + 1,
                        format_args!("{:?}", got)
                    )));
                }
            }
        }
    }
    match lines.find(|line| !line.is_blank()) {
        Some(line) => Err(line.error(message!("must be the end, after {} rows", height))),
        None => Ok(map),
    }
}

/// A number of cells from the head of a map.
fn side(line: &Line, name: &str, text: &str) -> Result<u32, Error> {
    let what = format!("1 to {MAX_CELLS}");
    let cells: u32 = line.number(name, text, &what)?;
    if (1..=MAX_CELLS).contains(&cells) {
        Ok(cells)
    } else {
        Err(line.error(message!("{} must be {}, got {}", name, what, cells)))
    }
}

/// A question, and its ends as cells.
struct Read {
    /// Start and goal, rows counted from the south.
    ends: [Cell; 2],
    /// The same in metres, as it is handed out.
    question: Question,
}

/// Reads all questions: the version's line, then one question a line, at least one.
fn read_questions(scen: File, map_name: &str, map: &Occupancy, frame: &Frame) -> Result<Vec<Read>, Error> {
    let mut lines = Lines::new(scen);
    let first = lines.need("\"version 1\"")?;
    let mut words = first.text()?.split_ascii_whitespace();
    let version = (words.next(), words.next().and_then(|v| v.parse::<f64>().ok()), words.next());
    if version != (Some("version"), Some(1.0), None) {
        return Err(first.error(message!("must be \"version 1\", got {}", quoted(first.text()?))));
    }
    let mut questions = Vec::new();
    for line in lines.filter(|line| !line.is_blank()) {
        if questions.len() == MAX_QUESTIONS {
            return Err(line.error(message!("must be the end, after {} questions", MAX_QUESTIONS)));
        }
        questions.push(read_question(&line, map_name, map, frame)?);
    }
    if questions.is_empty() {
        return Err(at(scen.name, 2, "must hold a question"));
    }
    Ok(questions)
}

/// Reads nine fields: group, map, its width and height, start, goal, length. Rows count from the north in the file
/// and from the south in the result.
fn read_question(line: &Line, map_name: &str, map: &Occupancy, frame: &Frame) -> Result<Read, Error> {
    let fields: Vec<&str> = line.text()?.split_ascii_whitespace().collect();
    let [bucket, name, width, height, x0, y0, x1, y1, length] = fields[..] else {
        return Err(line.error(message!("must have 9 fields, got {}", fields.len())));
    };
    if base(name) != base(map_name) {
        return Err(line.error(message!("must be about {}, got {}", quoted(base(map_name)), quoted(name))));
    }
    for (what, text, cells) in [("width", width, map.width()), ("height", height, map.height())] {
        if line.number::<u32>(what, text, "a whole number")? != cells {
            return Err(line.error(message!("{} must be the map's {}, got {}", what, cells, quoted(text))));
        }
    }
    let cell = |what: [&str; 2], x: &str, y: &str| {
        let (columns, rows) = (map.width(), map.height());
        let inside = |name: &str, text: &str, count: u32| {
            let rule = format!("0 to {}", count - 1);
            let value: u32 = line.number(name, text, &rule)?;
            let outside = || line.error(message!("{} must be {}, got {}", name, rule, value));
            (value < count).then_some(value).ok_or_else(outside)
        };
        let (x, y) = (inside(what[0], x, columns)?, inside(what[1], y, rows)?);
        Ok(Cell::new(x as i32, (rows - 1 - y) as i32))
    };
    let ends = [cell(["start x", "start y"], x0, y0)?, cell(["goal x", "goal y"], x1, y1)?];
    let bucket = line.number("bucket", bucket, "a whole number from 0")?;
    let cells: f64 = line.number("length", length, "a number")?;
    if !(cells.is_finite() && cells >= 0.0) {
        return Err(line.error(message!("length must be a number from 0, got {}", quoted(length))));
    }
    let [start, goal] = poses(frame, ends[0], ends[1]);
    Ok(Read { ends, question: Question { bucket, start, goal, length: cells * frame.resolution } })
}
