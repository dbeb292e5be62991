//! Figures 4 and 5 of the parking paper: the car's box along the axes (AABB), the turned box (OBB) and the ball, held
//! against the exact body on poses at random.
//!
//! All three are tested against the same lines, one after the other, as the paper tests them: what differs is the
//! volume. The paper takes the box along the axes for the cheapest and turns it with the car, which makes it the turned
//! box.

use serde::Serialize;

use crate::error::{Error, ErrorCode};
use crate::geometry::polygon::nearest_share;
use crate::geometry::{Point, Pose, math};
use crate::metrics::Body;
use crate::scenario::generate::SplitMix64;
use crate::scenario::resolve::{Form, Geometry};
use crate::scenario::{Scenario, catalog};
use crate::vehicle::Vehicle;

/// Most poses of one comparison.
const MAX_POSES: u32 = 1_000_000;

/// A volume around the car.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Volume {
    /// The smallest box along the axes that holds the car.
    Aabb,
    /// The car's own rectangle.
    Obb,
    /// The smallest disc that holds the car.
    Ball,
}

/// The volumes, in the paper's order.
pub const VOLUMES: [Volume; 3] = [Volume::Aabb, Volume::Obb, Volume::Ball];

impl Volume {
    /// `aabb`, `obb` or `ball`.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Aabb => "aabb",
            Self::Obb => "obb",
            Self::Ball => "ball",
        }
    }

    /// True if the volume around a car at `pose` meets one of these lines.
    pub fn meets(self, vehicle: &Vehicle, pose: Pose, lines: &[[Point; 2]]) -> bool {
        match self {
            Self::Aabb => {
                let [low, high] = bounds(&vehicle.outline(pose));
                let (middle, half) = (low + (high - low) / 2.0, (high - low) / 2.0);
                lines.iter().any(|&[a, b]| crosses([half.x, half.y], a - middle.coords, b - middle.coords))
            }
            Self::Obb => {
                let (sin, cos) = math::sin_cos(pose.heading);
                let half = [vehicle.length() / 2.0, vehicle.width / 2.0];
                let own = |p: Point| {
                    let (x, y) = (p.x - pose.x, p.y - pose.y);
                    Point::new(x * cos + y * sin - vehicle.middle(), y * cos - x * sin)
                };
                lines.iter().any(|&[a, b]| crosses(half, own(a), own(b)))
            }
            Self::Ball => {
                let middle = pose.advance(0.0, vehicle.middle());
                let reach = radius(vehicle);
                lines.iter().any(|&[a, b]| squared(middle.point(), a, b) < reach * reach)
            }
        }
    }

    /// Area around a car of this heading, square metres.
    pub fn area(self, vehicle: &Vehicle, heading: f64) -> f64 {
        match self {
            Self::Aabb => {
                let [low, high] = bounds(&vehicle.outline(Pose::new(0.0, 0.0, heading)));
                (high.x - low.x) * (high.y - low.y)
            }
            Self::Obb => vehicle.length() * vehicle.width,
            Self::Ball => math::PI * radius(vehicle) * radius(vehicle),
        }
    }
}

/// Of the smallest disc that holds the car, metres.
fn radius(vehicle: &Vehicle) -> f64 {
    math::hypot(vehicle.length() / 2.0, vehicle.width / 2.0)
}

fn bounds(corners: &[Point; 4]) -> [Point; 2] {
    let fold =
        |pick: fn(f64, f64) -> f64, of: fn(&Point) -> f64| corners.iter().map(of).fold(of(&corners[0]), pick);
    [
        Point::new(fold(f64::min, |p| p.x), fold(f64::min, |p| p.y)),
        Point::new(fold(f64::max, |p| p.x), fold(f64::max, |p| p.y)),
    ]
}

/// True if a line enters the box of these half sides around the origin, by separating axes; contact is free.
fn crosses(half: [f64; 2], a: Point, b: Point) -> bool {
    let [x, y] = half;
    if a.x.min(b.x) >= x || a.x.max(b.x) <= -x || a.y.min(b.y) >= y || a.y.max(b.y) <= -y {
        return false;
    }
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    (a.x * dy - a.y * dx).abs() < x * dy.abs() + y * dx.abs()
}

fn squared(p: Point, a: Point, b: Point) -> f64 {
    (p - a - (b - a) * nearest_share(p, a, b)).norm_squared()
}

/// Answers of one volume on all poses.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Line {
    /// `aabb`, `obb` or `ball`.
    pub volume: &'static str,
    /// Poses at which it meets a line.
    pub hits: u32,
    /// Of those, poses at which the exact body is free.
    pub false_alarms: u32,
    /// Poses at which it meets no line although the body hits something: the car is wholly behind a line.
    pub missed: u32,
    /// Its mean area over the body's.
    pub area: f64,
    /// Microseconds of a pose, the fastest of the rounds.
    pub micros: f64,
}

/// The volumes on one scene.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Comparison {
    /// The scene.
    pub scene: &'static str,
    /// Poses at random on the map.
    pub poses: u32,
    /// Lines that each volume is tested against.
    pub lines: usize,
    /// Poses at which the exact body hits something.
    pub collisions: u32,
    /// One for each of [`VOLUMES`].
    pub volumes: Vec<Line>,
}

/// Scenes of a comparison: the paper's lot, the obstacle of its figure 13, and a full car park.
pub const SCENES: [&str; 3] = ["P0", "park-fig13", "reverse-in"];

/// The lines that block on a scene: its border, walls and the edges of everything solid.
pub fn lines(geometry: &Geometry) -> Vec<[Point; 2]> {
    let ring = |outline: &[Point]| {
        let next = outline.iter().cycle().skip(1);
        outline.iter().zip(next).map(|(&a, &b)| [a, b]).collect::<Vec<_>>()
    };
    let mut lines = ring(&geometry.boundary);
    for shape in &geometry.shapes {
        match &shape.form {
            Form::Segment(a, b) => lines.push([*a, *b]),
            Form::Polygon(outline) => lines.extend(ring(outline)),
        }
    }
    lines
}

/// Compares the volumes on `poses` poses of a seed; `clock` tells milliseconds, 0 throughout where nobody measures.
///
/// # Errors
/// [`ErrorCode::Input`] for another scene than those of [`SCENES`], no pose or too many, and no round.
///
/// # Examples
/// ```
/// use parkade::papers::volumes::compare;
///
/// let found = compare("P0", 1000, 1, 1, &mut || 0.0).unwrap();
/// assert_eq!(found.volumes[1].false_alarms, 0);
/// assert!(found.volumes[2].false_alarms > found.volumes[0].false_alarms);
/// ```
pub fn compare(
    scene: &str,
    poses: u32,
    seed: u64,
    rounds: u32,
    clock: &mut dyn FnMut() -> f64,
) -> Result<Comparison, Error> {
    let within = |name, value, most| {
        let rule = message!("must be 1 to {}, got {}", most, value);
        if (1..=most).contains(&value) { Ok(()) } else { Err(Error::new(ErrorCode::Input, name, rule)) }
    };
    within("poses", poses, MAX_POSES)?;
    within("rounds", rounds, 1000)?;
    let scene = SCENES.into_iter().find(|id| *id == scene).ok_or_else(|| {
        let rule = message!("must be one of {}, got {}", SCENES.join(", "), format_args!("{:?}", scene));
        Error::new(ErrorCode::Input, "scene", rule)
    })?;
    let scenario = catalog::scenario(scene)?;
    let geometry = scenario.geometry()?;
    let (vehicle, lines) = (geometry.vehicle, lines(&geometry));
    let at = places(&scenario, poses, seed);
    let body = Body::new(&geometry);
    let truth: Vec<bool> = at.iter().map(|&pose| body.hit(pose).is_some()).collect();
    let measured = VOLUMES.map(|volume| {
        let (mut micros, mut met) = (f64::INFINITY, Vec::new());
        for _ in 0..rounds {
            let before = clock();
            met = at.iter().map(|&pose| volume.meets(&vehicle, pose, &lines)).collect();
            micros = micros.min((clock() - before) * 1e3 / f64::from(poses));
        }
        let count =
            |wanted: [bool; 2]| met.iter().zip(&truth).filter(|&(a, b)| [*a, *b] == wanted).count() as u32;
        let area: f64 = at.iter().map(|pose| volume.area(&vehicle, pose.heading)).sum();
        Line {
            volume: volume.as_str(),
            hits: met.iter().filter(|hit| **hit).count() as u32,
            false_alarms: count([true, false]),
            missed: count([false, true]),
            area: area / f64::from(poses) / Volume::Obb.area(&vehicle, 0.0),
            micros,
        }
    });
    let collisions = truth.iter().filter(|hit| **hit).count() as u32;
    Ok(Comparison { scene, poses, lines: lines.len(), collisions, volumes: measured.into() })
}

/// Poses anywhere on the map, headed anywhere.
fn places(scene: &Scenario, count: u32, seed: u64) -> Vec<Pose> {
    let mut random = SplitMix64::new(seed);
    let mut unit = || (random.next() >> 11) as f64 / (1_u64 << 53) as f64;
    let map = &scene.map;
    let size = |cells: u32| f64::from(cells) * map.resolution;
    let place = |_| {
        let (x, y, turn) = (unit(), unit(), unit());
        let heading = (2.0 * turn - 1.0) * math::PI;
        Pose::new(map.origin[0] + x * size(map.width), map.origin[1] + y * size(map.height), heading)
    };
    (0..count).map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn still() -> f64 {
        0.0
    }

    #[test]
    fn no_volume_misses_a_line_that_the_body_meets() {
        for scene in SCENES {
            let found = compare(scene, 4000, 7, 1, &mut still).unwrap();
            let [aabb, obb, ball] = &found.volumes[..] else { panic!() };
            assert!(found.collisions > 400 && obb.false_alarms == 0, "{found:?}");
            // What is wholly outside meets no line; the larger a volume, the rarer that is.
            assert!(obb.missed >= aabb.missed && aabb.hits >= obb.hits && ball.hits >= obb.hits, "{found:?}");
            assert!(aabb.false_alarms > 0 && ball.false_alarms > aabb.false_alarms, "{found:?}");
            assert_eq!(obb.hits + obb.missed, found.collisions);
        }
    }

    /// Against points along every line, which no separating axis sees.
    #[test]
    fn each_volume_meets_what_holds_a_point_of_a_line() {
        let mut random = SplitMix64::new(11);
        let mut unit = || (random.next() >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0;
        let car = Vehicle::PAPER;
        for _ in 0..2000 {
            let pose = Pose::new(3.0 * unit(), 3.0 * unit(), math::PI * unit());
            let line = [Point::new(8.0 * unit(), 8.0 * unit()), Point::new(8.0 * unit(), 8.0 * unit())];
            let corners = car.outline(pose);
            let [low, high] = bounds(&corners);
            let middle = pose.advance(0.0, car.middle()).point();
            let inside = |volume: Volume, p: Point| match volume {
                Volume::Aabb => p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y,
                Volume::Ball => (p - middle).norm() < radius(&car),
                Volume::Obb => (0..4).all(|i| {
                    let (a, b) = (corners[i], corners[(i + 1) % 4]);
                    (b - a).perp(&(p - a)) > 0.0
                }),
            };
            for volume in VOLUMES {
                let sampled = (0..=4000)
                    .any(|k| inside(volume, line[0] + (line[1] - line[0]) * (f64::from(k) / 4000.0)));
                let met = volume.meets(&car, pose, &[line]);
                // A line that cuts off a millimetre of a corner lies between two points.
                assert!(met || !sampled, "{volume:?} {pose:?} {line:?}");
                if met && !sampled {
                    let near = (0..=4000).any(|k| {
                        let p = line[0] + (line[1] - line[0]) * (f64::from(k) / 4000.0);
                        [[4e-3, 0.0], [-4e-3, 0.0], [0.0, 4e-3], [0.0, -4e-3]]
                            .iter()
                            .any(|d| inside(volume, Point::new(p.x + d[0], p.y + d[1])))
                    });
                    assert!(near, "{volume:?} {pose:?} {line:?}");
                }
            }
        }
    }

    #[test]
    fn bad_questions_are_refused() {
        let refused =
            |scene, poses, rounds| compare(scene, poses, 1, rounds, &mut still).unwrap_err().to_string();
        assert_eq!(refused("P9", 1, 1), "scene: must be one of P0, park-fig13, reverse-in, got \"P9\"");
        assert_eq!(refused("P0", 0, 1), "poses: must be 1 to 1000000, got 0");
        assert_eq!(refused("P0", 1, 0), "rounds: must be 1 to 1000, got 0");
    }
}
