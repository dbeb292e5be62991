//! A scene as plain geometry in metres.

use super::drawn::kerbs;
use super::{Entry, Goal, MAX_CELLS, Obstacle, Road, Scenario, Slot};
use crate::error::Error;
use crate::geometry::math;
use crate::geometry::{Point, Pose, Vector};
use crate::vehicle::Vehicle;

/// What a shape belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// The map's border or boundary.
    Border,
    /// `obstacles[i]`.
    Obstacle(usize),
    /// The parked car in `slots[i]`.
    Slot(usize),
}

/// The exact form of something that blocks.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// A wall without thickness, from end to end.
    Segment(Point, Point),
    /// A simple polygon, in either direction.
    Polygon(Vec<Point>),
}

/// Something that blocks, and whose it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Whose it is.
    pub owner: Owner,
    /// Its exact form.
    pub form: Form,
}

/// A validated scene, resolved.
#[derive(Debug, Clone)]
pub struct Geometry {
    /// Where the car stands.
    pub start: Pose,
    /// Where it shall go.
    pub goal: Pose,
    /// The car.
    pub vehicle: Vehicle,
    /// The floor's outline; outside is blocked.
    pub boundary: Vec<Point>,
    /// Everything that blocks inside the boundary.
    pub shapes: Vec<Shape>,
    /// Cars in occupied slots: slot, pose.
    pub parked: Vec<(usize, Pose)>,
}

impl Geometry {
    /// Whose a number is: 0 the border's, k that of shape k − 1.
    pub fn owner(&self, number: u32) -> Owner {
        let shape = (number as usize).checked_sub(1).and_then(|k| self.shapes.get(k));
        shape.map_or(Owner::Border, |s| s.owner)
    }
}

/// The car that stands in occupied slots.
pub const PARKED: Vehicle = Vehicle::SEDAN;

impl Scenario {
    /// Resolves the scene to geometry, validating it first.
    ///
    /// # Errors
    /// As [`Scenario::validate`].
    pub fn geometry(&self) -> Result<Geometry, Error> {
        self.validate()?;
        let vehicle = self.vehicle.resolve()?;
        let goal = match &self.goal {
            Goal::Pose(pose) => *pose,
            Goal::Slot(goal) => self
                .slots
                .iter()
                .find(|s| s.id.as_ref() == Some(&goal.slot))
                .map_or(self.start, |s| s.pose(goal.entry, &vehicle)),
        };
        let mut shapes = Vec::new();
        for (i, obstacle) in self.obstacles.iter().enumerate() {
            self.forms(obstacle, |form| shapes.push(Shape { owner: Owner::Obstacle(i), form }));
        }
        let roads: Vec<(usize, &Road)> = self
            .obstacles
            .iter()
            .enumerate()
            .filter_map(|(i, o)| if let Obstacle::Road(road) = o { Some((i, road)) } else { None })
            .collect();
        let all: Vec<&Road> = roads.iter().map(|r| r.1).collect();
        for (k, (i, _)) in roads.iter().enumerate() {
            let kerb = |(a, b)| Shape { owner: Owner::Obstacle(*i), form: Form::Segment(a, b) };
            shapes.extend(kerbs(&all, k).into_iter().map(kerb));
        }
        let parked: Vec<_> = self
            .slots
            .iter()
            .enumerate()
            .filter(|(_, s)| s.occupied)
            .map(|(i, s)| (i, parked_pose(s)))
            .collect();
        for &(i, pose) in &parked {
            shapes.push(Shape { owner: Owner::Slot(i), form: Form::Polygon(PARKED.outline(pose).to_vec()) });
        }
        Ok(Geometry { start: self.start, goal, vehicle, boundary: self.boundary(), shapes, parked })
    }

    /// What people call a thing: its id, else its kind.
    pub fn name_of(&self, owner: Owner) -> String {
        let (id, kind) = match owner {
            Owner::Border => (None, "border"),
            Owner::Slot(i) => (self.slots.get(i).and_then(|s| s.id.as_deref()), "parked car"),
            Owner::Obstacle(i) => match self.obstacles.get(i) {
                Some(Obstacle::Cells { id, .. }) => (id.as_deref(), "brush"),
                Some(Obstacle::Wall { id, .. }) => (id.as_deref(), "wall"),
                Some(Obstacle::Polygon { id, .. }) => (id.as_deref(), "polygon"),
                Some(Obstacle::Rectangle { id, .. }) => (id.as_deref(), "rectangle"),
                Some(Obstacle::Road(road)) => (road.id.as_deref(), "kerb"),
                Some(Obstacle::Car { id, .. }) => (id.as_deref(), "parked car"),
                None => (None, "obstacle"),
            },
        };
        id.unwrap_or(kind).to_owned()
    }

    fn boundary(&self) -> Vec<Point> {
        let map = &self.map;
        if let Some(boundary) = &map.boundary {
            return points(boundary);
        }
        let [x0, y0] = map.origin;
        let (x1, y1) =
            (x0 + f64::from(map.width) * map.resolution, y0 + f64::from(map.height) * map.resolution);
        vec![Point::new(x0, y0), Point::new(x1, y0), Point::new(x1, y1), Point::new(x0, y1)]
    }

    fn forms(&self, obstacle: &Obstacle, mut emit: impl FnMut(Form)) {
        match obstacle {
            Obstacle::Cells { runs, .. } => {
                for [x, y, w, h] in merge_runs(runs) {
                    emit(Form::Polygon(self.cell_rectangle(x, y, w, h)));
                }
            }
            Obstacle::Wall { points: line, thickness, .. } => {
                for pair in points(line).windows(2) {
                    match thick(pair[0], pair[1], *thickness) {
                        Some(corners) => emit(Form::Polygon(corners)),
                        None => emit(Form::Segment(pair[0], pair[1])),
                    }
                }
            }
            Obstacle::Polygon { points: corners, .. } => emit(Form::Polygon(points(corners))),
            Obstacle::Rectangle { center, size, heading, .. } => {
                let frame = Pose::new(center[0], center[1], *heading);
                let (a, b) = (size[0] / 2.0, size[1] / 2.0);
                let corners = [(a, b), (-a, b), (-a, -b), (a, -b)];
                emit(Form::Polygon(corners.map(|(x, y)| frame.to_world(Point::new(x, y))).to_vec()));
            }
            // Kerbs depend on other roads.
            Obstacle::Road(_) => {}
            Obstacle::Car { pose, vehicle, .. } => {
                let vehicle = vehicle.resolve().unwrap_or(PARKED);
                emit(Form::Polygon(vehicle.outline(*pose).to_vec()));
            }
        }
    }

    fn cell_rectangle(&self, x: u32, y: u32, w: u32, h: u32) -> Vec<Point> {
        let at = |x: u32, y: u32| {
            let [x0, y0] = self.map.origin;
            Point::new(x0 + f64::from(x) * self.map.resolution, y0 + f64::from(y) * self.map.resolution)
        };
        vec![at(x, y), at(x + w, y), at(x + w, y + h), at(x, y + h)]
    }
}

fn parked_pose(slot: &Slot) -> Pose {
    slot.pose(Entry::ReverseIn, &PARKED)
}

fn points(list: &[[f64; 2]]) -> Vec<Point> {
    list.iter().map(|p| Point::new(p[0], p[1])).collect()
}

/// A wall of some thickness: its rectangle with square caps, so that pieces join without a notch.
fn thick(a: Point, b: Point, thickness: f64) -> Option<Vec<Point>> {
    let along = (b - a).try_normalize(0.0).unwrap_or_else(Vector::x);
    (thickness > 0.0).then(|| {
        let cap = along * (thickness / 2.0);
        let side = Vector::new(-cap.y, cap.x);
        vec![a - cap - side, b + cap - side, b + cap + side, a - cap + side]
    })
}

/// Joins runs that stand exactly above each other: [x, y, width, height].
fn merge_runs(runs: &[[u32; 3]]) -> Vec<[u32; 4]> {
    let side = f64::from(MAX_CELLS + 1);
    let column = |&[x, y, count]: &[u32; 3]| (f64::from(x) * side + f64::from(count)) * side + f64::from(y);
    let mut sorted = math::sorted_by(runs, column);
    sorted.dedup();
    let mut merged: Vec<[u32; 4]> = Vec::new();
    for [x, y, count] in sorted {
        match merged.last_mut() {
            Some(last) if last[0] == x && last[2] == count && last[1] + last[3] == y => last[3] += 1,
            _ => merged.push([x, y, count, 1]),
        }
    }
    merged
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_above_each_other_become_one_rectangle() {
        let merged = merge_runs(&[[2, 1, 3], [2, 0, 3], [7, 0, 1], [2, 2, 4]]);
        assert_eq!(merged, [[2, 0, 3, 2], [2, 2, 4, 1], [7, 0, 1, 1]]);
    }

    #[test]
    fn a_thick_wall_has_square_caps() {
        let corners = thick(Point::new(0.0, 0.0), Point::new(4.0, 0.0), 1.0).unwrap();
        assert_eq!(corners[0], Point::new(-0.5, -0.5));
        assert_eq!(corners[2], Point::new(4.5, 0.5));
        assert!(thick(Point::origin(), Point::new(1.0, 0.0), 0.0).is_none());
    }
}
