//! Goals that can be met in several ways: one of some slots, one of some poses, or any place inside a region.
//!
//! A set is resolved to a list of poses before planning. Which of them is reached is the planner's choice, by cost;
//! which of them a finished path has reached is decided here, by distance ([`Goals::nearest`]).
//!
//! ```text
//! "goal": { "slots": "free", "entry": "either" }                    any free slot, nose in or out
//! "goal": { "slots": ["a1", "a2"], "entry": "head-in" }             one of two slots
//! "goal": [{ "x": 5, "y": 5, "heading": 0 }, …]                     one of some poses
//! "goal": { "region": [[0, 0], [9, 0], [9, 6]], "heading": 1.57 }   anywhere inside
//! ```

use serde::{Serialize, Serializer};
use serde_json::Value;

use super::checks::{bad, finite_pose};
use super::goal_region::GoalRegion;
use super::places;
use super::slot::{Entry, Slot};
use crate::error::Error;
use crate::geometry::{Pose, math};
use crate::json::{Fields, list, owned, word};
use crate::vehicle::Vehicle;

/// Most items of a list of poses or slots: each pose is tested for contact in each plan.
const MAX_ITEMS: usize = 1000;
/// Distance that one radian of heading counts for when the goal nearest to a path's end is chosen, metres.
const METRES_PER_RADIAN: f64 = 1.0;

/// A goal that can be met in several ways; the cheapest to reach is taken.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum GoalSet {
    /// Into one of some slots.
    Slots(SlotsGoal),
    /// To one of some poses.
    Poses(Vec<Pose>),
    /// Anywhere into a region.
    Region(GoalRegion),
}

/// Slots of the scene, and how the car may stand in them.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct SlotsGoal {
    /// Which slots; occupied ones are left out.
    pub slots: SlotChoice,
    /// Which way the nose may point.
    pub entry: EntryChoice,
}

/// Which slots of the scene may be taken.
#[derive(Debug, Clone, PartialEq)]
pub enum SlotChoice {
    /// Every free one.
    Free,
    /// Those with one of these ids.
    Named(Vec<String>),
}

/// Which way the nose may point in a slot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EntryChoice {
    /// Either way.
    Either,
    /// As [`Entry::ReverseIn`].
    ReverseIn,
    /// As [`Entry::HeadIn`].
    HeadIn,
}

/// One way to meet a goal.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct GoalPose {
    /// Index of the pose in the goal's list, or of the slot in the scene's; 0 in a region.
    pub index: usize,
    /// The slot's id, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub slot: Option<String>,
    /// Which way the nose points in the slot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub entry: Option<Entry>,
    /// Pose of the parked car.
    pub pose: Pose,
}

/// A goal set in its scene.
/// An empty list is valid: all slots may be occupied, or the car may not fit into the region. Planning then ends with
/// a reason, not with an error.
#[derive(Debug, Clone)]
pub struct Goals {
    /// The ways to meet it, whether or not the car has room there. In a region, a sample of them.
    pub poses: Vec<GoalPose>,
    region: Option<GoalRegion>,
    vehicle: Vehicle,
}

impl Serialize for SlotChoice {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Free => serializer.serialize_str("free"),
            Self::Named(ids) => ids.serialize(serializer),
        }
    }
}

impl EntryChoice {
    /// The ways that a choice allows, in the order in which they are tried.
    const fn entries(self) -> &'static [Entry] {
        match self {
            Self::Either => &[Entry::ReverseIn, Entry::HeadIn],
            Self::ReverseIn => &[Entry::ReverseIn],
            Self::HeadIn => &[Entry::HeadIn],
        }
    }
}

impl GoalSet {
    /// Reads a goal that is a list or has the field `slots` or `region`; `None` for every other.
    pub(super) fn read(value: &Value) -> Result<Option<Self>, Error> {
        if value.is_array() {
            return list(places::pose)(value).map(|poses| Some(Self::Poses(poses)));
        }
        if value.get("region").is_some() {
            return GoalRegion::read(value).map(|region| Some(Self::Region(region)));
        }
        if value.get("slots").is_none() {
            return Ok(None);
        }
        let entries = word(&[
            ("either", EntryChoice::Either),
            ("reverse-in", EntryChoice::ReverseIn),
            ("head-in", EntryChoice::HeadIn),
        ]);
        let f = Fields::of(value, &["slots", "entry"])?;
        let (slots, entry) = (f.need("slots", slot_choice)?, f.need("entry", entries)?);
        Ok(Some(Self::Slots(SlotsGoal { slots, entry })))
    }

    /// 1 to 1000 poses or ids, each id of a slot and named once, or a region that is valid.
    pub(super) fn validate(&self, slots: &[Slot]) -> Result<(), Error> {
        match self {
            Self::Slots(SlotsGoal { slots: SlotChoice::Free, .. }) => Ok(()),
            Self::Slots(SlotsGoal { slots: SlotChoice::Named(ids), .. }) => {
                named(slots, ids).map(|_| ()).map_err(|e| e.within("slots"))
            }
            Self::Poses(poses) => {
                bounded(poses)?;
                let finite = |(i, &pose)| finite_pose(pose).map_err(|e| e.within(&format!("[{i}]")));
                poses.iter().enumerate().try_for_each(finite)
            }
            Self::Region(region) => region.validate(),
        }
    }

    /// The ways to meet it in a validated scene.
    pub(super) fn resolve(&self, all: &[Slot], vehicle: Vehicle) -> Result<Goals, Error> {
        let (mut poses, mut region) = (Vec::new(), None);
        match self {
            Self::Poses(list) => {
                for (index, &pose) in list.iter().enumerate() {
                    poses.push(GoalPose { index, slot: None, entry: None, pose });
                }
            }
            Self::Region(own) => {
                region = Some(own.clone());
                own.sample(&vehicle, |pose| poses.push(GoalPose { index: 0, slot: None, entry: None, pose }));
            }
            Self::Slots(SlotsGoal { slots, entry }) => {
                let indices = match slots {
                    SlotChoice::Free => (0..all.len()).collect(),
                    SlotChoice::Named(ids) => named(all, ids)?,
                };
                for index in indices {
                    let slot = &all[index];
                    for &entry in entry.entries().iter().filter(|_| !slot.occupied) {
                        let pose = slot.pose(entry, &vehicle);
                        poses.push(GoalPose { index, slot: slot.id.clone(), entry: Some(entry), pose });
                    }
                }
            }
        }
        Ok(Goals { poses, region, vehicle })
    }
}

impl Goals {
    /// The goal that a path which ends at `last` is held against: the nearest; `None` where none can be met.
    /// A radian of heading counts as much as a metre. In a region every pose inside is as good as another, so the end
    /// of the path itself is the goal.
    ///
    /// ```
    /// use parkade::geometry::Pose;
    /// use parkade::scenario::{Goal, GoalSet, catalog};
    ///
    /// let mut scene = catalog::scenario("perpendicular").unwrap();
    /// let goals = [Pose::new(0.0, 8.0, 0.0), Pose::new(9.0, 8.0, 0.0)];
    /// scene.goal = Goal::Set(GoalSet::Poses(goals.to_vec()));
    /// let goals = scene.geometry().unwrap().goals.unwrap();
    /// assert_eq!(goals.nearest(Pose::new(8.0, 8.1, 0.1)).unwrap().x, 9.0);
    /// ```
    pub fn nearest(&self, last: Pose) -> Option<Pose> {
        if self.region.as_ref().is_some_and(|region| region.holds(&self.vehicle, last)) {
            return Some(last);
        }
        let apart = |pose: Pose| {
            (pose.point() - last.point()).norm()
                + METRES_PER_RADIAN * math::turn(pose.heading, last.heading).abs()
        };
        self.poses.iter().map(|goal| goal.pose).min_by(|&a, &b| apart(a).total_cmp(&apart(b)))
    }

    /// True if the poses are a sample of more, of which those with little room may be left out.
    pub(crate) const fn is_sample(&self) -> bool {
        self.region.is_some()
    }

    /// Why there is no way to meet it, whatever stands in the scene.
    pub(crate) fn empty_reason(&self) -> &'static str {
        if self.region.is_some() {
            "The car does not fit into the goal's region. Make the region larger."
        } else {
            "None of the goal's slots is free. Free one, or name another."
        }
    }
}

/// Reads `"free"` or a list of ids.
fn slot_choice(value: &Value) -> Result<SlotChoice, Error> {
    match value {
        Value::String(word) if word == "free" => Ok(SlotChoice::Free),
        Value::Array(_) => list(owned)(value).map(SlotChoice::Named),
        _ => bad("", message!("must be \"free\" or a list of slots' ids, got {}", value)),
    }
}

/// An error unless a list has 1 to [`MAX_ITEMS`] items.
fn bounded<T>(items: &[T]) -> Result<(), Error> {
    if (1..=MAX_ITEMS).contains(&items.len()) {
        return Ok(());
    }
    bad("", message!("must have 1 to {} items, got {}", MAX_ITEMS, items.len()))
}

/// The indices of slots by their ids.
fn named(slots: &[Slot], ids: &[String]) -> Result<Vec<usize>, Error> {
    bounded(ids)?;
    let mut indices = Vec::new();
    for (i, id) in ids.iter().enumerate() {
        let message = match slots.iter().position(|slot| slot.id.as_ref() == Some(id)) {
            None => message!("must be the id of a slot, got \"{}\"", id),
            Some(index) if indices.contains(&index) => message!("must be named once, got \"{}\" again", id),
            Some(index) => {
                indices.push(index);
                continue;
            }
        };
        return bad(&format!("[{i}]"), message);
    }
    Ok(indices)
}
