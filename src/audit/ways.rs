//! The ways into a bay and out of it, which help each other.
//!
//! What is hard about a bay is the manoeuvre before it, and a car can drive every manoeuvre backwards. So a way out
//! holds a way in, and the other way round: its part at the bay, driven backwards, and from there an ordinary way
//! through the lot. Such a *joined* way passes the same check as a planned one.
//!
//! Both ways are asked with some patience first. One that is not found by then is joined from the other; only where
//! that is not possible, or takes many moves, its search goes through its whole budget. A way that takes more moves than
//! the other is held against the joined one as well, and the better of both is the answer.
//!
//! All of it depends on the question alone: patience counts expansions, and a way in is asked for its way out even where
//! the rows leave that out.

use std::ops::ControlFlow;

use super::row::Way;
use crate::geometry::Pose;
use crate::plan::{self, Ends, Planner};

/// Expansions after which the other way is asked: the first level's budget and the portfolio's first slices.
const PATIENCE: u32 = 32_768;
/// Expansions of the way between a joint and the far end: both have room around them.
const JOINT_PATIENCE: u32 = 1500;
/// Distances from the bay at which ways are joined, metres: behind most manoeuvres, and before the aisle ends.
const JOINTS: [f64; 3] = [8.0, 12.0, 20.0];
/// A way with so many moves needs no better one.
const FEW_MOVES: u32 = 4;
/// A way is held against a joined one where it takes so many moves more than the other way.
const MORE_MOVES: u32 = 3;

/// The question of a bay: the far ends of both ways, and the pose in the bay.
#[derive(Clone, Copy)]
pub(super) struct Question {
    pub(super) start: Pose,
    pub(super) bay: Pose,
    pub(super) exit: Pose,
}

/// Which of the two ways.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    In,
    Out,
}

/// A path: what a plan has of it.
#[derive(Clone)]
struct Path {
    poses: Vec<Pose>,
    gears: Vec<i8>,
    curvatures: Vec<f64>,
}

/// An answer and its path; empty where there is none.
struct Asked {
    way: Way,
    path: Path,
    /// True if patience ended before the search did: more of it may find a way, or another one.
    is_unfinished: bool,
}

/// The planners of ways in and out, for one vehicle among the obstacles of a scene.
pub(super) struct Ways {
    pub(super) way_in: Planner,
    pub(super) way_out: Planner,
}

impl Ways {
    /// The way in and, where `is_out_asked`, the way out.
    pub(super) fn ask(&mut self, question: Question, is_out_asked: bool) -> (Way, Option<Way>) {
        let mut way_in = self.find(question, Side::In, Some(PATIENCE));
        if !is_out_asked && way_in.way.reachable && way_in.way.moves <= FEW_MOVES && !way_in.is_unfinished {
            return (way_in.way, None);
        }
        let mut way_out = self.find(question, Side::Out, Some(PATIENCE));
        way_in = self.settle(question, Side::In, way_in, &way_out);
        let is_new = way_out.is_unfinished;
        way_out = self.settle(question, Side::Out, way_out, &way_in);
        if is_new {
            way_in = self.settle(question, Side::In, way_in, &way_out);
        }
        (way_in.way, is_out_asked.then_some(way_out.way))
    }

    /// A way by its planner, within so many expansions.
    fn find(&mut self, question: Question, side: Side, patience: Option<u32>) -> Asked {
        match side {
            Side::In => find(&mut self.way_in, [question.start, question.bay], patience),
            Side::Out => find(&mut self.way_out, [question.bay, question.exit], patience),
        }
    }

    /// The answer for one way where the other is known: its own, searched to the end if need be, or a joined one.
    fn settle(&mut self, question: Question, side: Side, own: Asked, other: &Asked) -> Asked {
        let has_many = own.way.moves > FEW_MOVES && own.way.moves >= other.way.moves + MORE_MOVES;
        let is_worse = own.is_unfinished || !own.way.reachable || has_many;
        if !is_worse {
            return own;
        }
        let mut joined = other.way.reachable.then(|| self.join(question, side, &other.path)).flatten();
        if let Some(joined) = joined.take_if(|joined| joined.way.moves <= FEW_MOVES && own.is_unfinished) {
            return joined;
        }
        let own = if own.is_unfinished { self.find(question, side, None) } else { own };
        joined.filter(|joined| is_better(&joined.way, &own.way)).unwrap_or(own)
    }

    /// The best way with the part of the other way that lies at the bay, driven backwards.
    fn join(&mut self, question: Question, side: Side, other: &Path) -> Option<Asked> {
        let Question { start, bay, exit } = question;
        let outward = if side == Side::In { other.clone() } else { other.reversed() };
        let mut best: Option<Asked> = None;
        for distance in JOINTS {
            let is_there = |pose: &Pose| (pose.point() - bay.point()).norm() >= distance;
            let Some(at) = outward.poses.iter().position(is_there) else { break };
            let (joint, part) = (outward.poses[at], outward.until(at));
            let (planner, ends, parts) = match side {
                Side::In => {
                    let way = find(&mut self.way_in, [start, joint], Some(JOINT_PATIENCE));
                    (&mut self.way_in, [start, bay], [way.path, part.reversed()])
                }
                Side::Out => {
                    let way = find(&mut self.way_out, [joint, exit], Some(JOINT_PATIENCE));
                    (&mut self.way_out, [bay, exit], [part, way.path])
                }
            };
            if parts.iter().any(|part| part.poses.is_empty()) {
                continue;
            }
            let [first, second] = parts;
            let path = first.then(second);
            let known = (path.poses.clone(), path.gears.clone(), path.curvatures.clone());
            let plan = planner.plan_along(ends, known);
            let way = Way { detail: Some("joined"), ..Way::of(planner, &plan) };
            if way.reachable && best.as_ref().is_none_or(|best| is_better(&way, &best.way)) {
                best = Some(Asked { way, path, is_unfinished: false });
            }
            if best.as_ref().is_some_and(|best| best.way.moves <= FEW_MOVES) {
                break;
            }
        }
        best
    }
}

/// True if a way that is there takes fewer moves and less time than another, or the other is not there.
fn is_better(way: &Way, other: &Way) -> bool {
    let time = |way: &Way| way.drive_time.unwrap_or(f64::INFINITY);
    !other.reachable || (way.moves < other.moves && time(way) < time(other))
}

/// The plan between two poses, which start and goal of the scene do not influence. A question that the planner refuses
/// is a way out of reach with the error as its reason; it does not end the audit.
fn find(planner: &mut Planner, [start, goal]: [Pose; 2], patience: Option<u32>) -> Asked {
    let ends = Ends { start: Some(start), goal: Some(goal) };
    let mut is_unfinished = false;
    let mut watch = |expanded: u32| {
        is_unfinished = patience.is_some_and(|most| expanded >= most);
        if is_unfinished { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let options = plan::Options { progress: Some(&mut watch), ..plan::Options::default() };
    let planned = planner.plan_between(ends, options);
    match planned {
        Ok(plan) => {
            let way = Way::of(planner, &plan);
            let path = Path { poses: plan.path, gears: plan.directions, curvatures: plan.curvatures };
            Asked { path: if way.reachable { path } else { Path::none() }, way, is_unfinished }
        }
        Err(error) => Asked { way: Way::refused(error.to_string()), path: Path::none(), is_unfinished },
    }
}

impl Path {
    fn none() -> Self {
        Self { poses: Vec::new(), gears: Vec::new(), curvatures: Vec::new() }
    }

    /// Up to pose `at`.
    fn until(&self, at: usize) -> Self {
        // The last item of gears and curvatures repeats the one before.
        let ways = |end: usize| (0..=end).map(move |i| i.min(end.saturating_sub(1)));
        Self {
            poses: self.poses[..=at].to_vec(),
            gears: ways(at).map(|i| self.gears[i]).collect(),
            curvatures: ways(at).map(|i| self.curvatures[i]).collect(),
        }
    }

    /// The same way, driven from its end to its start.
    fn reversed(&self) -> Self {
        let count = self.poses.len();
        let ways = || (0..count).map(|i| (count - 1 - i).saturating_sub(1));
        Self {
            poses: self.poses.iter().rev().copied().collect(),
            gears: ways().map(|i| -self.gears[i]).collect(),
            curvatures: ways().map(|i| self.curvatures[i]).collect(),
        }
    }

    /// This path and then another, which begins where it ends.
    fn then(mut self, next: Self) -> Self {
        self.poses.pop();
        self.gears.pop();
        self.curvatures.pop();
        self.poses.extend(next.poses);
        self.gears.extend(next.gears);
        self.curvatures.extend(next.curvatures);
        self
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Map, json};

    use super::*;
    use crate::audit::{Options, Row, audit, turned};
    use crate::metrics::Verdict;
    use crate::scenario::lot::Lot;
    use crate::scenario::{Entry, Scenario, catalog};

    fn path_of(plan: &plan::Plan) -> Path {
        Path { poses: plan.path.clone(), gears: plan.directions.clone(), curvatures: plan.curvatures.clone() }
    }

    /// A path with gear changes, driven backwards, is one that the validator accepts between the same ends; cut anywhere
    /// and joined again it is what it was.
    #[test]
    fn paths_are_reversed_cut_and_joined() {
        let scene = catalog::scenario("perpendicular").unwrap();
        let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
        let plan = planner.plan(plan::Options::default());
        let (path, ends) = (path_of(&plan), [planner.geometry().start, planner.geometry().goal]);
        let Path { poses, gears, curvatures } = path.reversed();
        let back = planner.plan_along([ends[1], ends[0]], (poses, gears, curvatures));
        assert_eq!(back.check.verdict, Verdict::Ok);
        assert!(plan.metrics.direction_changes > 0);
        assert_eq!(back.metrics.direction_changes, plan.metrics.direction_changes);
        let last = path.poses.len() - 1;
        for at in 1..last {
            let rest = path.reversed().until(last - at).reversed();
            let whole = path.until(at).then(rest);
            assert_eq!((&whole.poses, &whole.gears), (&path.poses, &path.gears), "cut at {at}");
            assert_eq!(whole.curvatures, path.curvatures, "cut at {at}");
        }
    }

    fn only_row(scene: &Scenario, out: bool) -> Row {
        let fields = json!({ "bays": ["A4"], "entries": ["head-in"], "out": out });
        let options = Options::of(scene, &fields).unwrap();
        audit(scene, &options, &mut |_| ControlFlow::Continue(())).unwrap().remove(0)
    }

    /// The search alone finds a way out with more moves than that with the way in's manoeuvre; whether the way out is
    /// asked for does not change the way in.
    #[test]
    fn a_way_out_of_many_moves_is_joined_from_the_way_in() {
        let fields = json!({ "seed": 106, "rows": 4, "bays": 15 });
        let mut scene = Lot::from_json(&fields).unwrap().draw().unwrap().scene;
        let bay = scene.slots.iter().position(|slot| slot.id.as_deref() == Some("A4")).unwrap();
        scene.slots[bay].occupied = false;
        let row = only_row(&scene, true);
        let out = row.out.as_ref().unwrap();
        assert_eq!((out.reachable, out.detail), (true, Some("joined")));
        let mut alone = Planner::new("hybrid-forward", &scene, &Map::new()).unwrap();
        let vehicle = alone.geometry().vehicle;
        let ends = Ends {
            start: Some(scene.slots[bay].pose(Entry::HeadIn, &vehicle)),
            goal: Some(turned(scene.start, &vehicle)),
        };
        let alone = alone.plan_between(ends, plan::Options::default()).unwrap();
        assert!(out.moves < alone.metrics.direction_changes + 1);
        assert_eq!(only_row(&scene, false).way, row.way);
    }
}
