//! Which rows of an audit an edit of the scene can touch.
//!
//! Any edit can change which path a search finds. What an audit promises is less, and can be kept cheaply. A reachable
//! row stays *true* while its swept body is clear of all changes, because the path that was found is still free. An
//! unreachable row stays true while nothing was removed, because more obstacles open no way. These two rules need no
//! search; a row that satisfies neither is asked again.

use serde_json::Value;

use super::{Options, Row};
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::metrics::Body;
use crate::scenario::resolve::{Geometry, Shape};
use crate::scenario::{Scenario, Slot};
use crate::vehicle::Vehicle;

/// A body that comes this near to what changed is touched, metres. On the way it is a quarter of a metre from a swept
/// pose at most, and its corners move one and a half times as far as its axle on the tightest arcs.
const NEAR: f64 = 0.45;

/// A border that far outside the floor is near nothing, metres.
const RIM: f64 = 100.0;

/// What is known of a row from an earlier audit.
#[derive(Debug, Clone, PartialEq)]
pub struct Known {
    /// The bay's index.
    pub bay: usize,
    /// The index of the vehicle in the options.
    pub vehicle: usize,
    /// True if the way in, and the way out if it was asked for, was found.
    pub reachable: bool,
    /// The swept poses of both.
    pub swept: Vec<Pose>,
}

impl Known {
    /// Of a row of an audit with these options.
    pub fn of(row: &Row, options: &Options) -> Self {
        let ways = || [Some(&row.way), row.out.as_ref()].into_iter().flatten();
        Self {
            bay: row.index,
            vehicle: options.vehicles.iter().position(|one| one.id == row.vehicle).unwrap_or_default(),
            reachable: ways().all(|way| way.reachable),
            swept: ways().flat_map(|way| way.swept.iter().copied()).collect(),
        }
    }
}

/// For each row of the audit of `before`, true if its answer may be another one in `after`: its swept body comes near
/// what was added or removed, it was out of reach and something was removed, or its bay changed. Where more than
/// obstacles and slots changed, all are. Rows that are not may become shorter by other ways; what they say stays true.
///
/// Takes time linear in the swept poses, with one clearance query each against the changed shapes alone. `rows` may be
/// in any order; the answers are in the same one. A row of a vehicle that `options` does not have is affected.
///
/// # Errors
/// Of a wrong scene.
///
/// # Examples
/// ```
/// use parkade::audit::{Known, Options, affected};
///
/// let before = parkade::scenario::catalog::scenario("perpendicular").unwrap();
/// let mut after = before.clone();
/// after.obstacles.clear();
/// let options = Options::of(&before, &serde_json::json!({})).unwrap();
/// let row = Known { bay: 0, vehicle: 0, reachable: false, swept: vec![before.start] };
/// let is_freer = affected(&before, &after, &options, &[row.clone()]).unwrap()[0];
/// assert!(is_freer && !affected(&before, &before, &options, &[row]).unwrap()[0]);
/// ```
pub fn affected(
    before: &Scenario,
    after: &Scenario,
    options: &Options,
    rows: &[Known],
) -> Result<Vec<bool>, Error> {
    let (old, new) = (before.geometry()?, after.geometry()?);
    if frame_of(before) != frame_of(after) {
        return Ok(vec![true; rows.len()]);
    }
    let (removed, added) = (difference(&old, &new), difference(&new, &old));
    let is_freer = !removed.is_empty();
    let shapes: Vec<Shape> = removed.into_iter().chain(added).cloned().collect();
    let bodies: Vec<Body> =
        options.vehicles.iter().map(|one| Body::new(&changed_alone(&new, &shapes, one.vehicle))).collect();
    let mut answers = Vec::new();
    for row in rows {
        let slot = |scene: &Scenario| scene.slots.get(row.bay).map(place_of);
        let near = || {
            bodies
                .get(row.vehicle)
                .is_none_or(|body| row.swept.iter().any(|&pose| body.clearance(pose) < NEAR))
        };
        let is_other = slot(before) != slot(after) || (!row.reachable && is_freer);
        answers.push(is_other || (!shapes.is_empty() && near()));
    }
    Ok(answers)
}

/// A slot without whether it is occupied: that is an obstacle's matter, as is the car in it.
fn place_of(slot: &Slot) -> Slot {
    Slot { occupied: false, ..slot.clone() }
}

/// Everything but obstacles, slots and names.
fn frame_of(scene: &Scenario) -> Value {
    let bare = Scenario {
        name: None,
        obstacles: Vec::new(),
        slots: Vec::new(),
        goal: crate::scenario::Goal::Pose(scene.start),
        ..scene.clone()
    };
    serde_json::to_value(bare).unwrap_or_default()
}

/// The shapes of `one` that `other` lacks. A shape that moved by any amount is both removed and added.
///
/// Most shapes stand where they stood in the list, or as many places away as the one before; only for the others is
/// the whole list gone through.
fn difference<'a>(one: &'a Geometry, other: &Geometry) -> Vec<&'a Shape> {
    let mut next = 0;
    let is_new = |shape: &&Shape| {
        let is_at = |at: usize| other.shapes.get(at).is_some_and(|known| known.form == shape.form);
        let found = if is_at(next) { Some(next) } else { (0..other.shapes.len()).find(|&at| is_at(at)) };
        next = found.unwrap_or(next) + 1;
        found.is_none()
    };
    one.shapes.iter().filter(is_new).collect()
}

/// A floor on which only these shapes stand: its border is too far away to matter.
fn changed_alone(geometry: &Geometry, shapes: &[Shape], vehicle: Vehicle) -> Geometry {
    let inf = f64::INFINITY;
    let (low, high) = geometry
        .boundary
        .iter()
        .fold((Point::new(inf, inf), Point::new(-inf, -inf)), |(low, high), p| (low.inf(p), high.sup(p)));
    let (left, bottom, right, top) = (low.x - RIM, low.y - RIM, high.x + RIM, high.y + RIM);
    let corners = [(left, bottom), (right, bottom), (right, top), (left, top)];
    Geometry {
        vehicle,
        boundary: corners.map(|(x, y)| Point::new(x, y)).to_vec(),
        shapes: shapes.to_vec(),
        parked: Vec::new(),
        ..geometry.clone()
    }
}
