//! A scene as plain geometry in metres.
//!
//! References become poses, parked cars and kerbs become shapes, and each shape remembers its owner, so that a
//! collision can be told by the name of what is hit. Everything is in world coordinates; the boundary is the
//! floor's outline, and what lies outside it is blocked.
//!
//! Exactness: a wall without thickness stays a segment, a rectangle its four corners, a parked car the outline of its
//! body. Nothing is rasterised here, so checks do not depend on the map's resolution. Brushed cells are the exception
//! by nature; runs that stand above each other become one rectangle, which saves most of their edges.
//!
//! Order: shapes come as obstacles are listed, then kerbs, then parked cars. Their numbers, from 1 on, are the owners
//! of collision checks; 0 is the border.

use std::ops::Range;

use super::Goals;
use super::checks::{bad, finite_pose};
use super::road_obstacle::kerbs;
use super::{Entry, Goal, MAX_CELLS, Obstacle, Road, Scenario, Slot};
use crate::IS_COMPLETE;
use crate::error::Error;
use crate::geometry::math;
use crate::geometry::{Point, Pose, Vector};
use crate::vehicle::Vehicle;

/// The owner of a shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// The map's border or boundary.
    Border,
    /// `obstacles[i]`.
    Obstacle(usize),
    /// The parked car in `slots[i]`.
    Slot(usize),
}

impl Owner {
    /// Its index in the scene's obstacles, or -1.
    pub fn index(self) -> i32 {
        match self {
            Self::Obstacle(i) => i as i32,
            Self::Border | Self::Slot(_) => -1,
        }
    }
}

/// The exact form of something that blocks.
/// In world coordinates, metres. Both forms have no inside that is drivable: a segment is two-sided, a polygon is
/// full.
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
///
/// ```
/// use parkade::scenario::catalog;
/// use parkade::scenario::resolve::Owner;
///
/// let scene = catalog::scenario("reverse-in").unwrap();
/// let geometry = scene.geometry().unwrap();
/// // Two obstacles and the cars in four occupied slots.
/// assert_eq!(geometry.shapes.len(), 6);
/// assert_eq!(geometry.parked.len(), 4);
/// assert_eq!(scene.name_of(geometry.owner(0)), "border");
/// assert_eq!(geometry.owner(1), Owner::Obstacle(0));
/// ```
#[derive(Debug, Clone)]
pub struct Geometry {
    /// Start pose.
    pub start: Pose,
    /// Goal pose: the first of several goals, or the start if none can be reached.
    pub goal: Pose,
    /// The goals, where the scene has a set of them.
    pub goals: Option<Goals>,
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

    /// The goal that a path which ends at `last` is held against; of several the nearest, `None` where none can be met.
    pub fn goal_for(&self, last: Pose) -> Option<Pose> {
        if IS_COMPLETE && let Some(goals) = &self.goals {
            return goals.nearest(last);
        }
        Some(self.goal)
    }
}

/// The car that stands in occupied slots.
pub const PARKED: Vehicle = Vehicle::SEDAN;

impl Scenario {
    /// Resolves the scene to geometry, validating it first.
    ///
    /// O(corners), and O(roads²) for the openings of kerbs.
    ///
    /// # Errors
    /// As [`Scenario::validate`].
    pub fn geometry(&self) -> Result<Geometry, Error> {
        self.validate()?;
        let vehicle = self.vehicle.resolve()?;
        let goals = match &self.goal {
            Goal::Set(set) if IS_COMPLETE => Some(set.resolve(&self.slots, vehicle)?),
            _ => None,
        };
        let goal = match &goals {
            Some(goals) => goals.poses.first().map_or(self.start, |goal| goal.pose),
            None => self.goal_pose(&self.goal)?,
        };
        let mut shapes = Vec::new();
        let mut known = Known::of(self.obstacles.len());
        for (i, obstacle) in self.obstacles.iter().enumerate() {
            let from = shapes.len();
            self.forms(obstacle, |form| shapes.push(Shape { owner: Owner::Obstacle(i), form }));
            if IS_COMPLETE && known.has(&shapes, from) {
                shapes.truncate(from);
            }
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
        Ok(Geometry { start: self.start, goal, goals, vehicle, boundary: self.boundary(), shapes, parked })
    }

    /// The pose of a goal in this scene: its own, or that of the scene's car in the slot.
    ///
    /// An occupied slot has a pose, too: whether the car may stand there is found by planning.
    ///
    /// # Errors
    /// The pose's number that is out of range, the slot's id that no slot has, or what is wrong with the car.
    pub fn goal_pose(&self, goal: &Goal) -> Result<Pose, Error> {
        let goal = match goal {
            Goal::Pose(pose) => return finite_pose(*pose).map(|()| *pose),
            Goal::Slot(goal) => goal,
            Goal::Set(_) => {
                return bad("", "must be one pose or slot, got a set of goals".into());
            }
        };
        match self.slots.iter().find(|slot| slot.id.as_ref() == Some(&goal.slot)) {
            Some(slot) => Ok(slot.pose(goal.entry, &self.vehicle.resolve()?)),
            None => bad("slot", message!("must be the id of a slot, got \"{}\"", goal.slot)),
        }
    }

    /// The name of a thing for people: its id, or its kind if it has none.
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

    /// The floor's outline: the scene's own or, without one, the map's rectangle.
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

    /// Emits the shapes of one obstacle, in world coordinates.
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

    /// The corners of a block of cells, metres.
    fn cell_rectangle(&self, x: u32, y: u32, w: u32, h: u32) -> Vec<Point> {
        let at = |x: u32, y: u32| {
            let [x0, y0] = self.map.origin;
            Point::new(x0 + f64::from(x) * self.map.resolution, y0 + f64::from(y) * self.map.resolution)
        };
        vec![at(x, y), at(x + w, y), at(x + w, y + h), at(x, y + h)]
    }
}

/// The shapes of obstacles, in a hash table with open addressing. An obstacle that lies exactly on an earlier one
/// blocks nothing more, but every collision check would pay for it again.
struct Known(Vec<Range<usize>>);

impl Known {
    /// Room for as many obstacles, half of it empty.
    fn of(obstacles: usize) -> Self {
        Self(vec![0..0; (2 * obstacles).next_power_of_two()])
    }

    /// True if the shapes from `from` on repeat those of an earlier obstacle; otherwise they are known from now on.
    fn has(&mut self, shapes: &[Shape], from: usize) -> bool {
        let mut key = 0xcbf2_9ce4_8422_2325_u64;
        let mut add = |p: &Point| {
            for number in [p.x, p.y] {
                key = (key ^ number.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                key ^= key >> 32;
            }
        };
        for shape in &shapes[from..] {
            match &shape.form {
                Form::Segment(a, b) => [a, b].into_iter().for_each(&mut add),
                Form::Polygon(outline) => outline.iter().for_each(&mut add),
            }
        }
        let forms = |range: Range<usize>| shapes[range].iter().map(|shape| &shape.form);
        let last = self.0.len() - 1;
        let mut place = key as usize & last;
        while !self.0[place].is_empty() {
            if forms(self.0[place].clone()).eq(forms(from..shapes.len())) {
                return true;
            }
            place = (place + 1) & last;
        }
        self.0[place] = from..shapes.len();
        false
    }
}

/// Where the car of an occupied slot stands: tail first, in the middle of the slot.
fn parked_pose(slot: &Slot) -> Pose {
    slot.pose(Entry::ReverseIn, &PARKED)
}

/// Pairs of numbers as points.
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
    fn an_obstacle_on_an_earlier_one_is_left_out_and_one_beside_it_is_not() {
        let block = |id: &str, x: f64| Obstacle::Rectangle {
            id: Some(id.to_owned()),
            center: [x, 12.75],
            size: [1.0, 1.0],
            heading: 0.0,
        };
        let mut scene = crate::scenario::catalog::scenario("perpendicular").unwrap();
        let before = scene.geometry().unwrap().shapes.len();
        scene.obstacles.extend([block("a", 3.0), block("b", 3.0), block("c", 3.0 + 1e-9), block("d", 3.0)]);
        let shapes = scene.geometry().unwrap().shapes;
        let names: Vec<_> = shapes.iter().map(|shape| scene.name_of(shape.owner)).collect();
        assert_eq!(shapes.len(), before + 2);
        assert!(["a", "c"].iter().all(|id| names.contains(&(*id).to_owned())));
    }

    #[test]
    fn a_thick_wall_has_square_caps() {
        let corners = thick(Point::new(0.0, 0.0), Point::new(4.0, 0.0), 1.0).unwrap();
        assert_eq!(corners[0], Point::new(-0.5, -0.5));
        assert_eq!(corners[2], Point::new(4.5, 0.5));
        assert!(thick(Point::origin(), Point::new(1.0, 0.0), 0.0).is_none());
    }
}
