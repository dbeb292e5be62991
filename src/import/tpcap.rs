//! Cases of the Trajectory Planning Competition for Automated Parking (TPCAP, 2022).
//!
//! One line of numbers: start and goal (x, y, heading), the number of obstacles, the number of corners of each, then
//! all corners. Metres and radians, poses of the rear axle's middle; outlines in either direction, convex or not;
//! headings beyond ±π and coordinates of 1e9 m occur. The cases state no border: the map is the box around start and
//! goal, grown by [`AROUND`] metres.
//!
//! The format counts on the reader to know how many numbers follow, so a missing or surplus number shifts all that
//! comes after it. Errors therefore count the numbers from 1, and the last corner must end the file.

use crate::error::{Error, ErrorCode, Message};
use crate::geometry::Pose;
use crate::scenario::{MAX_CELLS, MapFrame, Obstacle, Scenario, VehicleSpec};
use crate::vehicle::Vehicle;

/// The competition's car (4.69 m × 1.94 m, turns in 3.01 m).
pub const CAR: Vehicle = Vehicle {
    wheelbase: 2.8,
    width: 1.942,
    rear_to_front: 3.76,
    rear_to_back: 0.929,
    max_steer: 0.75,
    max_steer_rate: 0.5,
};

/// How far the map reaches beyond start and goal, metres.
pub const AROUND: f64 = 15.0;

/// Side of a map cell on cases that are small enough, metres.
const CELL: f64 = 0.2;

fn bad<T>(message: Message) -> Result<T, Error> {
    Err(Error::new(ErrorCode::Import, "line 1", message))
}

/// Reads a case; `name` becomes the scene's name.
///
/// # Errors
/// [`ErrorCode::Import`] where a number is missing, is none, or there are too many; then what [`Scenario::validate`]
/// says.
///
/// # Examples
/// ```
/// let case = "0,0,0, 8,0,0, 1,4, 3,2,5,2,5,3,3,3";
/// let scene = parkade::import::tpcap::scene("mine", case).unwrap();
/// assert_eq!(scene.obstacles.len(), 1);
/// ```
pub fn scene(name: &str, text: &str) -> Result<Scenario, Error> {
    let mut numbers = NumberReader { items: text.trim().trim_end_matches(',').split(','), read: 0 };
    let start = numbers.pose()?;
    let goal = numbers.pose()?;
    let count = numbers.count("the number of obstacles", 0.0)?;
    // Not reserved beforehand: the file may claim any number.
    let mut corners = Vec::new();
    for i in 1..=count {
        corners.push(numbers.count(&format!("the corners of obstacle {i}"), 3.0)?);
    }
    let mut obstacles = Vec::new();
    for (i, n) in (1..).zip(corners) {
        let mut points = Vec::new();
        for _ in 0..n {
            points.push([numbers.number()?, numbers.number()?]);
        }
        // Some outlines repeat corners, the first one at the end included.
        points.dedup();
        while points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        obstacles.push(Obstacle::Polygon { id: Some(format!("obstacle {i}")), points });
    }
    if numbers.items.next().is_some() {
        return bad(message!("must end after {} numbers, the last corner", numbers.read));
    }
    let scene = Scenario {
        name: Some(name.to_owned()),
        obstacles,
        ..Scenario::new(frame([start, goal]), VehicleSpec::Custom(CAR), start, goal)
    };
    scene.validate()?;
    Ok(scene)
}

/// The box around two poses, grown.
/// In cells of 0.2 m, or larger where the box has more than [`MAX_CELLS`] of them a side. A box wider than 1000 km is
/// cut.
fn frame(poses: [Pose; 2]) -> MapFrame {
    let [a, b] = poses;
    let side = |a: f64, b: f64| ((a - b).abs() + 2.0 * AROUND).min(1e6);
    let (width, height) = (side(a.x, b.x), side(a.y, b.y));
    let resolution = CELL.max(width.max(height) / f64::from(MAX_CELLS));
    let cells = |length: f64| ((length / resolution).ceil() as u32).min(MAX_CELLS);
    MapFrame {
        origin: [a.x.min(b.x) - AROUND, a.y.min(b.y) - AROUND],
        width: cells(width),
        height: cells(height),
        resolution,
        boundary: None,
    }
}

/// The file's numbers one after another; errors count them from 1.
struct NumberReader<'a> {
    items: core::str::Split<'a, char>,
    read: usize,
}

impl NumberReader<'_> {
    /// The next number, which must be there and finite.
    fn number(&mut self) -> Result<f64, Error> {
        self.read += 1;
        let Some(item) = self.items.next() else {
            return bad(message!("number {} is missing", self.read));
        };
        match item.trim().parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => bad(message!("number {} must be a finite number, got \"{}\"", self.read, item.trim())),
        }
    }

    /// The next three numbers: x, y, heading.
    fn pose(&mut self) -> Result<Pose, Error> {
        Ok(Pose::new(self.number()?, self.number()?, self.number()?))
    }

    /// The next number as a count from `least` to a million.
    fn count(&mut self, what: &str, least: f64) -> Result<u32, Error> {
        let value = self.number()?;
        if value.fract() == 0.0 && (least..=1e6).contains(&value) {
            return Ok(value as u32);
        }
        bad(message!("number {}, {}, must be a whole number from {}, got {}", self.read, what, least, value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_is_read_as_it_stands() {
        let text = "4484378811.25,-3.5,-6.1,4484378813.5,9,1.8,2,3,5,1,1,2,1,2,2,5,5,6,5,6,6,5,6,5,5\r\n";
        let scene = scene("case", text).unwrap();
        assert_eq!(scene.start, Pose::new(4_484_378_811.25, -3.5, -6.1));
        assert_eq!(scene.map.origin, [4_484_378_796.25, -18.5]);
        assert_eq!((scene.map.width, scene.map.height), (162, 213));
        let Obstacle::Polygon { points, .. } = &scene.obstacles[1] else { panic!() };
        assert_eq!(points.as_slice(), [[5.0, 5.0], [6.0, 5.0], [6.0, 6.0], [5.0, 6.0]]);
    }

    #[test]
    fn every_fault_is_named() {
        let fault = |text: &str| scene("", text).unwrap_err().to_string();
        assert_eq!(fault(""), "line 1: number 1 must be a finite number, got \"\"");
        assert_eq!(fault("0,0,0,9,0,0"), "line 1: number 7 is missing");
        assert_eq!(fault("0,0,x,9,0,0,0"), "line 1: number 3 must be a finite number, got \"x\"");
        assert_eq!(fault("0,0,inf,9,0,0,0"), "line 1: number 3 must be a finite number, got \"inf\"");
        assert!(fault("0,0,0,9,0,0,1.5").contains("must be a whole number from 0, got 1.5"));
        assert!(
            fault("0,0,0,9,0,0,1,2").contains("the corners of obstacle 1, must be a whole number from 3")
        );
        assert_eq!(fault("0,0,0,9,0,0,1,3,1,1,2,1,2"), "line 1: number 14 is missing");
        assert_eq!(fault("0,0,0,9,0,0,0,7"), "line 1: must end after 7 numbers, the last corner");
        assert!(fault("0,0,0,9,0,0,1,4,0,0,1,1,1,0,0,1").starts_with("obstacles[0].points"));
    }
}
