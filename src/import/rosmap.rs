//! Maps of the ROS map servers: a `.yaml` file that describes a `.pgm` picture.
//!
//! A picture's first row is the northern one. Its lower left corner lies at `origin` of the world, turned by the
//! origin's third number. A turned picture is laid on a lattice along the world's axes: a cell is blocked where a
//! blocked pixel overlaps it, and the picture's outline becomes the floor's boundary.
//!
//! The server's rule for a pixel of value v, where white is m: its occupancy is p = 1 − v/m, or v/m with `negate`. In
//! the mode `trinary`
//!
//! ```text
//! p > occupied_thresh      blocked
//! p < free_thresh          free
//! otherwise                unknown: blocked, unless the options say free
//! ```
//!
//! `scale` has grades of occupancy between the thresholds instead of unknown pixels, and `raw` takes the value itself
//! as a percentage. Files are read by hand, as flat mappings of words; a YAML library would be larger than the
//! importer.

use super::cell_map::{Raster, lattice};
use super::file::{File, base, ending};
use super::imported::Imported;
use super::line_reader::{Line, Lines, quoted};
use super::options::{Options, Unknown};
use super::pgm;
use crate::error::{Error, ErrorCode, Message};
use crate::geometry::{Point, Pose};
use crate::map::{Cell, Occupancy, raster};
use crate::scenario::{MAX_CELLS, MapFrame};

/// How a pixel's lightness becomes free, blocked or unknown.
/// The names are the map servers' own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mode {
    /// Free below one threshold, blocked above the other, unknown between them.
    Trinary,
    /// As `Trinary`, but a cost between the thresholds, never unknown.
    Scale,
    /// The value is a percentage; unknown above 100.
    Raw,
}

/// The contents of a `.yaml` file.
/// Defaults are those of the map servers: thresholds of 0.65 and 0.25, the mode `trinary`.
struct Description<'a> {
    /// The picture's file as the description names it.
    image: Option<&'a str>,
    /// Side of a pixel, metres.
    resolution: f64,
    /// Lower left corner of the picture in the world, metres, and its turn, radians.
    origin: [f64; 3],
    /// True if dark pixels are free.
    negate: bool,
    /// Occupancy above which a pixel is blocked, 0 to 1.
    occupied: f64,
    /// Occupancy below which it is free, 0 to 1.
    free: f64,
    /// How values between the two are read.
    mode: Mode,
}

/// What a pixel says of its cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Class {
    Free,
    Between,
    Unknown,
    Blocked,
}

/// Reads a map and its picture. The notes of the result say how many cells are unknown or between the thresholds.
///
/// # Errors
/// An option that the file decides itself, a file or picture that the format does not allow, or a turned map
/// that is too large.
pub(super) fn read(yaml: File, files: &[File], options: &Options) -> Result<Imported, Error> {
    options.refuse_question()?;
    if options.resolution.is_some() {
        return Err(Error::new(
            ErrorCode::Input,
            "resolution",
            "must be left out: a .yaml file says its own",
        ));
    }
    let description = describe(yaml)?;
    let picture = pgm::read(picture_of(&description, yaml, files)?)?;
    let classes: Vec<Class> = (0..=picture.max).map(|v| description.class(v, picture.max)).collect();
    let mut map = Occupancy::new(picture.width, picture.height);
    let (mut unknown, mut between) = (0_u32, 0_u32);
    for (index, &value) in picture.values.iter().enumerate() {
        let (x, row) = (index % picture.width as usize, index / picture.width as usize);
        let class = classes[usize::from(value)];
        unknown += u32::from(class == Class::Unknown);
        between += u32::from(class == Class::Between);
        if class == Class::Blocked || class == Class::Unknown && options.unknown == Unknown::Blocked {
            map.set(Cell::new(x as i32, (picture.height as usize - 1 - row) as i32), true);
        }
    }
    let mut notes = Vec::new();
    if unknown > 0 {
        let word = if options.unknown == Unknown::Blocked { "blocked" } else { "free" };
        notes.push(format!("{unknown} unknown cells count as {word}."));
    }
    if between > 0 {
        notes
            .push(format!("{between} cells between the thresholds count as free; their costs are not kept."));
    }
    let (map, frame) = if description.origin[2] == 0.0 {
        let frame = MapFrame {
            origin: [description.origin[0], description.origin[1]],
            width: map.width(),
            height: map.height(),
            resolution: description.resolution,
            boundary: None,
        };
        (map, frame)
    } else {
        notes.push(format!(
            "Turned by {:.1}°: laid on a lattice along the axes.",
            description.origin[2].to_degrees()
        ));
        turned(&map, &description, yaml)?
    };
    let vehicle = options.vehicle.clone().unwrap_or_default();
    let scene = Raster { map, frame, vehicle }.scene(None, yaml.name)?;
    Ok(Imported { format: "ros-map", scenes: vec![scene], queries: Vec::new(), notes })
}

/// The picture on a lattice along the world's axes.
/// Blocked pixels are filled as turned rectangles, run by run, so that no cell that one of them overlaps stays free.
fn turned(map: &Occupancy, description: &Description, yaml: File) -> Result<(Occupancy, MapFrame), Error> {
    let side = description.resolution;
    let [x, y, yaw] = description.origin;
    let corner = Pose::new(x, y, yaw);
    let at = |x: u32, y: u32| corner.to_world(Point::new(f64::from(x) * side, f64::from(y) * side));
    let rectangle = |x: u32, y: u32, w: u32, h: u32| [at(x, y), at(x + w, y), at(x + w, y + h), at(x, y + h)];
    let outline = rectangle(0, 0, map.width(), map.height());
    let low = outline.iter().fold(outline[0], |low, p| Point::new(low.x.min(p.x), low.y.min(p.y)));
    let high = outline.iter().fold(outline[0], |high, p| Point::new(high.x.max(p.x), high.y.max(p.y)));
    // A quarter turn is not a cell wider for the last digit of its cosine.
    let cells = |length: f64| (length / side - 1e-9).ceil().max(1.0);
    let (width, height) = (cells(high.x - low.x), cells(high.y - low.y));
    if width > f64::from(MAX_CELLS) || height > f64::from(MAX_CELLS) {
        let rule = message!(
            "must have at most {} cells a side, has {} × {} when turned upright",
            MAX_CELLS,
            width,
            height
        );
        return Err(Error::new(ErrorCode::Import, yaml.name, rule));
    }
    let frame = MapFrame {
        origin: [low.x, low.y],
        width: width as u32,
        height: height as u32,
        resolution: side,
        boundary: Some(outline.iter().map(|p| [p.x, p.y]).collect()),
    };
    let upright = lattice(&frame);
    let mut laid = Occupancy::new(frame.width, frame.height);
    for [x, y, count] in raster::to_runs(map) {
        raster::fill(&mut laid, &upright, &rectangle(x, y, count, 1));
    }
    Ok((laid, frame))
}

impl Description<'_> {
    /// What a value says, by mode and thresholds; `max` is the value of white.
    fn class(&self, value: u16, max: u16) -> Class {
        let shade = f64::from(value) / f64::from(max);
        let occupied = match self.mode {
            Mode::Raw => {
                let percent = (shade * 255.0).round();
                if percent > 100.0 {
                    return Class::Unknown;
                }
                return if percent / 100.0 > self.occupied { Class::Blocked } else { Class::Free };
            }
            Mode::Trinary | Mode::Scale if self.negate => shade,
            Mode::Trinary | Mode::Scale => 1.0 - shade,
        };
        if occupied > self.occupied {
            Class::Blocked
        } else if occupied < self.free {
            Class::Free
        } else if self.mode == Mode::Scale {
            Class::Between
        } else {
            Class::Unknown
        }
    }
}

/// The picture that the description names, or the only one there is.
/// Names are compared without folders, since a description may name a path of another machine.
fn picture_of<'a>(description: &Description, yaml: File, files: &[File<'a>]) -> Result<File<'a>, Error> {
    let pictures = || files.iter().filter(|f| ending(f.name).is_some_and(|e| e == "pgm"));
    let named = description.image.and_then(|image| pictures().find(|f| base(f.name) == base(image)));
    if let Some(file) = named {
        return Ok(*file);
    }
    let image = quoted(description.image.unwrap_or_default());
    let error = |message: Message| Err(Error::new(ErrorCode::Import, yaml.name, message));
    let mut all = pictures();
    match (all.next(), all.next()) {
        (Some(only), None) => Ok(*only),
        (None, _) => error(message!("must come with its picture {} as a .pgm file", image)),
        _ => error(message!("must come with its picture {}; there are others", image)),
    }
}

/// Reads the flat mappings that map servers write: `key: value`, the origin in brackets or as a list below its key.
/// Keys that are not known are skipped, because map servers keep settings of their own beside these.
fn describe(file: File) -> Result<Description, Error> {
    let mut description = Description {
        image: None,
        resolution: 0.0,
        origin: [0.0; 3],
        negate: false,
        occupied: 0.65,
        free: 0.25,
        mode: Mode::Trinary,
    };
    let mut origin: Vec<f64> = Vec::new();
    let mut listing = false;
    for line in Lines::new(file) {
        let text = content(line.text()?);
        if text.is_empty() || text == "---" || text == "..." || text.starts_with('%') {
            continue;
        }
        if let (true, Some(item)) = (listing, text.trim_start().strip_prefix('-')) {
            push(&line, &mut origin, item.trim())?;
            continue;
        }
        listing = false;
        let Some((key, value)) = text.split_once(':') else {
            return Err(line.error(message!("must be \"key: value\", got {}", quoted(text))));
        };
        let (key, value) = (unquoted(key.trim()), value.trim());
        match key {
            "image" => description.image = Some(unquoted(value)),
            "resolution" => {
                description.resolution = number(&line, key, value)?;
                if !(0.001..=1000.0).contains(&description.resolution) {
                    return Err(line.error(message!("resolution must be 0.001 to 1000 m, got {}", value)));
                }
            }
            "origin" => {
                origin.clear();
                listing = value.is_empty();
                if !listing {
                    let inner = value.strip_prefix('[').and_then(|v| v.strip_suffix(']'));
                    let Some(inner) = inner else {
                        return Err(line.error(message!("origin must be [x, y, yaw], got {}", quoted(value))));
                    };
                    inner.split(',').try_for_each(|item| push(&line, &mut origin, item.trim()))?;
                }
            }
            "negate" => {
                description.negate = match value {
                    "0" | "false" | "False" | "no" => false,
                    "1" | "true" | "True" | "yes" => true,
                    _ => return Err(line.error(message!("negate must be 0 or 1, got {}", quoted(value)))),
                }
            }
            "occupied_thresh" => description.occupied = share(&line, key, value)?,
            "free_thresh" => description.free = share(&line, key, value)?,
            "mode" => {
                description.mode = match unquoted(value) {
                    "trinary" => Mode::Trinary,
                    "scale" => Mode::Scale,
                    "raw" => Mode::Raw,
                    _ => {
                        let rule = message!("mode must be trinary, scale or raw, got {}", quoted(value));
                        return Err(line.error(rule));
                    }
                }
            }
            // Other programs keep settings of their own here.
            _ => {}
        }
    }
    let error = |message: Message| Err(Error::new(ErrorCode::Import, file.name, message));
    if description.resolution == 0.0 {
        return error("must say its resolution".into());
    }
    let Ok(origin) = <[f64; 3]>::try_from(&origin[..]) else {
        return error(message!("origin must have 3 numbers, got {}", origin.len()));
    };
    description.origin = origin;
    if description.free > description.occupied {
        let (free, occupied) = (description.free, description.occupied);
        return error(message!("free_thresh must be at most occupied_thresh, got {} and {}", free, occupied));
    }
    Ok(description)
}

/// A line without its comment and the blanks behind it.
/// A `#` begins a comment only at the beginning of a word; lines with quotes are kept whole.
fn content(text: &str) -> &str {
    let quoted = text.contains(['"', '\'']);
    let end =
        if quoted { None } else { text.match_indices('#').map(|m| m.0).find(|&i| starts_word(text, i)) };
    text[..end.unwrap_or(text.len())].trim_end()
}

/// True if a word begins at this byte: a `#` within a word begins no comment.
fn starts_word(text: &str, index: usize) -> bool {
    index == 0 || text.as_bytes()[index - 1].is_ascii_whitespace()
}

/// A value without the quotes around it, if it has any.
fn unquoted(value: &str) -> &str {
    let strip = |quote| value.strip_prefix(quote).and_then(|v| v.strip_suffix(quote));
    strip('"').or_else(|| strip('\'')).unwrap_or(value)
}

/// A finite number behind a key.
fn number(line: &Line, key: &str, value: &str) -> Result<f64, Error> {
    let value: f64 = line.number(key, value, "a number")?;
    if value.is_finite() {
        Ok(value)
    } else {
        Err(line.error(message!("{} must be finite, got {}", key, value)))
    }
}

/// A number from 0 to 1 behind a key.
fn share(line: &Line, key: &str, value: &str) -> Result<f64, Error> {
    let share = number(line, key, value)?;
    if (0.0..=1.0).contains(&share) {
        Ok(share)
    } else {
        Err(line.error(message!("{} must be 0 to 1, got {}", key, share)))
    }
}

/// Adds a number to the origin, which has three.
fn push(line: &Line, origin: &mut Vec<f64>, item: &str) -> Result<(), Error> {
    if origin.len() == 3 {
        return Err(line.error("origin must have 3 numbers, has more"));
    }
    origin.push(number(line, "origin", item)?);
    Ok(())
}
