//! Whether more freedom costs more: the same scene planned under settings that are asked for and under others whose
//! path is allowed there too. The answer should cost no more, by the asked measure, than that path.

use core::cell::RefCell;
use core::ops::ControlFlow;

use parkade::geometry::arcs::{self, Arc};
use parkade::geometry::{Pose, math};
use parkade::planners::hybrid::{Config, Profile, Query, Report, Scratch, choices, plan};
use parkade::vehicle::Vehicle;
use parkade::vehicle::collision::{CollisionChecker, Obstacles};

/// A question without settings.
#[derive(Clone, Copy)]
pub(crate) struct Question<'a> {
    pub(crate) obstacles: &'a Obstacles,
    pub(crate) vehicle: Vehicle,
    pub(crate) start: Pose,
    pub(crate) goal: Pose,
}

/// A question with the answers to it so far: many pairs ask for the same settings.
pub(crate) struct Answers<'a> {
    question: Question<'a>,
    known: RefCell<Vec<(Config, Vehicle, Report)>>,
    /// The cheapest after a search for better paths.
    bettered: RefCell<Vec<(Config, Vehicle, Report)>>,
}

impl<'a> Answers<'a> {
    pub(crate) fn new(question: Question<'a>) -> Self {
        Self { question, known: RefCell::default(), bettered: RefCell::default() }
    }

    fn get(&self, config: Config, vehicle: Vehicle) -> Report {
        remembered(&self.known, config, vehicle, &|| {
            plan(&self.query(&vehicle), &config, &mut Scratch::default(), false, &mut None)
        })
    }

    /// The cheapest path with as much margin as the first, after a search for better ones.
    fn better(&self, config: Config, vehicle: Vehicle) -> Report {
        remembered(&self.bettered, config, vehicle, &|| {
            let first = self.get(config, vehicle);
            let mut best = first.clone();
            let mut offer = |path: Report| {
                if path.margin >= first.margin && path.cost < best.cost {
                    best = path;
                }
                ControlFlow::Continue(())
            };
            let memory = (&mut Scratch::default(), &mut None);
            choices(&self.query(&vehicle), (&config, &[]), (&first, None), memory, &mut offer);
            best
        })
    }

    fn query<'q>(&'q self, vehicle: &'q Vehicle) -> Query<'q> {
        let Question { obstacles, start, goal, .. } = self.question;
        Query { obstacles, vehicle, start, goal }
    }
}

/// The answer to some settings, made once.
fn remembered(
    known: &RefCell<Vec<(Config, Vehicle, Report)>>,
    config: Config,
    vehicle: Vehicle,
    make: &dyn Fn() -> Report,
) -> Report {
    let is_same = |one: &&(Config, Vehicle, Report)| one.0 == config && one.1 == vehicle;
    if let Some((_, _, report)) = known.borrow().iter().find(is_same) {
        return report.clone();
    }
    let report = make();
    known.borrow_mut().push((config, vehicle, report.clone()));
    report
}

/// What is asked for, and whose path is allowed there too.
#[derive(Clone, Copy)]
pub(crate) struct Pair {
    pub(crate) name: &'static str,
    asked: fn(Config, Vehicle) -> (Config, Vehicle),
    rival: fn(Config, Vehicle) -> (Config, Vehicle),
}

const fn pair(
    name: &'static str,
    asked: fn(Config, Vehicle) -> (Config, Vehicle),
    rival: fn(Config, Vehicle) -> (Config, Vehicle),
) -> Pair {
    Pair { name, asked, rival }
}

/// Settings and car as they are by default.
fn usual(config: Config, car: Vehicle) -> (Config, Vehicle) {
    (config, car)
}

/// Prices and profiles against the usual ones: at most 1 % dearer.
pub(crate) const PRICES: [Pair; 8] = [
    pair("obstacleCost 1 against none", |c, v| (Config { obstacle_cost: 1.0, ..c }, v), usual),
    pair("obstacleCost 5 against none", |c, v| (Config { obstacle_cost: 5.0, ..c }, v), usual),
    pair("comfort against practical", |c, v| (Config { profile: Profile::Comfort, ..c }, v), usual),
    pair("classic against practical", |c, v| (Config { profile: Profile::Classic, ..c }, v), usual),
    pair("reverseCost 2 against 1", |c, v| (Config { reverse_cost: 2.0, ..c }, v), usual),
    pair("directionChangeCost 5 against 1", |c, v| (Config { direction_change_cost: 5.0, ..c }, v), usual),
    pair("steerChangeCost 1 against none", |c, v| (Config { steer_change_cost: 1.0, ..c }, v), usual),
    pair("shortest against practical", |c, v| (Config { profile: Profile::Shortest, ..c }, v), usual),
];

/// Less margin: at most 1 % dearer.
pub(crate) const MARGINS: [Pair; 2] = [
    pair("margin 0 against 10 cm", |c, v| (Config { margin: 0.0, ..c }, v), usual),
    pair("margin 3 cm against 10 cm", |c, v| (Config { margin: 0.03, ..c }, v), usual),
];

/// What no first answer to the asked settings is held against, but a search for better ones is.
pub(crate) const OTHERS: [Pair; 9] = [
    pair("margin 10 cm against 30 cm", usual, |c, v| (Config { margin: 0.3, ..c }, v)),
    pair("practical against shortest", usual, |c, v| (Config { profile: Profile::Shortest, ..c }, v)),
    pair("practical against comfort", usual, |c, v| (Config { profile: Profile::Comfort, ..c }, v)),
    pair("obstacleCost 0 against 1", usual, |c, v| (Config { obstacle_cost: 1.0, ..c }, v)),
    pair("obstacleCost 0 against 5", usual, |c, v| (Config { obstacle_cost: 5.0, ..c }, v)),
    pair("reverseCost 1 against 2", usual, |c, v| (Config { reverse_cost: 2.0, ..c }, v)),
    pair("steerChangeCost 0 against 1", usual, |c, v| (Config { steer_change_cost: 1.0, ..c }, v)),
    pair(
        "maxDirectionChanges 5 against 1",
        |c, v| (Config { max_direction_changes: 5, ..c }, v),
        |c, v| (Config { max_direction_changes: 1, ..c }, v),
    ),
    pair("maxSteer a tenth larger", |c, v| (c, Vehicle { max_steer: v.max_steer * 1.1, ..v }), usual),
];

/// What became of one pair in one scene.
pub(crate) struct Compared {
    /// Cost of the answer for each metre that the rival's path costs under the same settings; infinite without one.
    pub(crate) ratio: f64,
    /// Levels of the portfolio that gave both.
    pub(crate) levels: [u32; 2],
}

impl Pair {
    /// Plans both; nothing where the rival has no path, or one that the asked settings do not allow.
    pub(crate) fn compare(&self, answers: &Answers, base: Config) -> Option<Compared> {
        let question = answers.question;
        let (config, vehicle) = (self.rival)(base, question.vehicle);
        let rival = answers.get(config, vehicle);
        if rival.arcs.is_empty() {
            return None;
        }
        let (config, vehicle) = (self.asked)(base, question.vehicle);
        let own = answers.get(config, vehicle);
        if rival.margin + 1e-9 < config.margin.min(own.margin) {
            return None;
        }
        let levels = [own.level, rival.level];
        let paid = |report: &Report| cost(&config, &vehicle, question, &report.arcs);
        if own.arcs.is_empty() {
            return Some(Compared { ratio: f64::INFINITY, levels });
        }
        let counted = paid(&own);
        assert!((counted - own.cost).abs() < 1e-6 * own.cost, "{}: {counted}, told {}", self.name, own.cost);
        // What keeps more than it was asked for is no loss.
        let keeps_more = own.margin > rival.margin + 1e-9;
        (!keeps_more).then(|| Compared { ratio: own.cost / paid(&rival), levels })
    }

    /// The same for the cheapest path after a search for better ones; both have a path.
    pub(crate) fn ratio_after_search(&self, answers: &Answers, base: Config) -> f64 {
        let question = answers.question;
        let (config, vehicle) = (self.rival)(base, question.vehicle);
        let rival = answers.get(config, vehicle);
        let (config, vehicle) = (self.asked)(base, question.vehicle);
        answers.better(config, vehicle).cost / cost(&config, &vehicle, question, &rival.arcs)
    }
}

/// Sampling of a path's places, metres.
const STEP: f64 = 0.5;
/// Reverse driving nearer to an end belongs to the manoeuvre there, metres.
const MANOEUVRE: f64 = 10.0;

/// What a path costs under some settings, by the formula in the documentation of hybrid A*.
fn cost(config: &Config, vehicle: &Vehicle, question: Question, path: &[Arc]) -> f64 {
    let Question { obstacles, start, goal, .. } = question;
    let ([reverse, change, steer, steer_change, obstacle, distance], has_extras) = match config.profile {
        Profile::Comfort => ([1.0, 2.0, 0.0, 0.1, 1.0, 0.5], true),
        Profile::Classic => ([1.5, 0.0, 0.25, 0.9, 0.0, 0.5], false),
        profile => {
            let Config { reverse_cost, direction_change_cost, steer_cost, steer_change_cost, .. } = *config;
            let places = [config.obstacle_cost, config.obstacle_distance];
            (
                [reverse_cost, direction_change_cost, steer_cost, steer_change_cost, places[0], places[1]],
                profile == Profile::Practical,
            )
        }
    };
    let [far_reverse, many_changes] = if has_extras { [0.5, 4.0] } else { [0.0; 2] };
    let radius = vehicle.min_turning_radius();
    let checker = CollisionChecker::new(obstacles, vehicle);
    let [start, goal] = [start, goal].map(|pose| obstacles.local(pose));
    let (mut pose, mut before) = (start, 0.0);
    let changes = arcs::direction_changes(path);
    let mut sum = f64::from(changes) * change + f64::from(changes.saturating_sub(2)) * many_changes;
    for arc in path {
        let is_reverse = arc.length < 0.0;
        let weight = if is_reverse { reverse } else { 1.0 };
        sum += arc.length.abs() * (weight + steer * arc.curvature.abs() * radius);
        sum += steer_change * (arc.curvature - before).abs() * radius;
        let steps = (arc.length.abs() / STEP).ceil().max(1.0);
        for k in 1..=steps as u32 {
            let at = pose.advance(arc.curvature, arc.length / steps * f64::from(k));
            let near = (1.0 - checker.clearance(at, distance) / distance).max(0.0);
            let is_far = [start, goal].iter().all(|end| {
                let apart = at.point() - end.point();
                math::hypot(apart.x, apart.y) > MANOEUVRE
            });
            let far = if is_far && is_reverse { far_reverse } else { 0.0 };
            sum += (obstacle * near * near + far) * arc.length.abs() / steps;
        }
        pose = pose.advance(arc.curvature, arc.length);
        before = arc.curvature;
    }
    sum
}
