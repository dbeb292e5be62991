//! The shape of the path: time, smoothness and the wheel's rate against defects, obstacles and the largest steering
//! angle.
//!
//! Gauss–Newton steps with Levenberg–Marquardt damping on an augmented Lagrangian of the defects. Inequalities are
//! squared where they are violated; which ones are is found anew within each step from their linear forms, at no cost
//! but that of a further factorisation.
//!
//! # The problem
//!
//! Unknowns are x, y, θ, φ and the step h to the next node, for each node. With F the end of the segment from a node
//! ([`drive`]) the following is minimised:
//!
//! ```text
//! Σ runs   T(length)                          time from rest to rest, linearised
//! Σ links  extra time that the wheel takes    |Δφ|/ω_max beyond the driving time
//! Σ links  w₁·∫ω² dt + w₂·∫φ² ds              smoothness
//! Σ links  (hₖ₊₁ − hₖ)²                       evenly spaced nodes
//! subject to   F(node k) − node k + 1 = 0     the path is one that the car drives
//!              distance ≥ margin, |φ| ≤ φ_max, h ≥ 0
//! ```
//!
//! # Equalities
//!
//! The defects c = F − next are weighted by ρ and shifted by multipliers: ρ/2·|c + λ/ρ|², with λ ← λ + ρ·c after each
//! round. So c goes to zero without ρ going to infinity, which would leave the system without digits. ρ grows over
//! three rounds all the same: while it is small the path may cheat a little and find a better shape; when it is stiff
//! the cheating has to end.
//!
//! # Inequalities
//!
//! A violated inequality r > 0 costs w/2·r², a kept one nothing. Which are violated after a step is not known before
//! it. So the step is solved with those that are violated now, then with those that its linear forms violate, three
//! sets at most. Clearance is therefore met up to a small violation, for which the caller adds a reserve to the margin.
//!
//! # Steps
//!
//! A step is accepted if the true cost falls; damping then falls by four, otherwise it grows by six. A round keeps
//! features, speeds and time slopes as they are, so its cost is one function; 16 rounds of six steps are the most,
//! which bounds the work in any case. A step takes time linear in nodes and near features.

use super::banded::{BLOCK, Banded};
use super::path::{Link, Path};
use super::round::{Round, Task};
use super::segment::{ANGLE, HEADING, STEP, X, Y, drive};

/// Weight of a metre's or radian's defect, squared, round by round, the last one from then on: stiff enough in the end
/// that many small defects do not add up to a way.
const DEFECTS: [f64; 3] = [2e4, 1e5, 5e5];
/// Of a metre's lack of clearance, of a radian beyond the largest steering angle, and of a negative step.
const ROOM: f64 = 2e4;
const LOCK: f64 = 2e4;
const BACKWARD: f64 = 1e6;
/// Of the wheel's motion, ∫ω² dt, and of its angle, ∫φ² ds.
const WHEEL: f64 = 0.02;
const BENT: f64 = 0.001;
/// Of the differences of neighbouring steps.
const EVEN: f64 = 30.0;
/// Costs of time that is lost to the wheel are rounded off below this, seconds, and dear by this factor: to brake and
/// speed up takes time as well.
const LOST: f64 = 0.02;
const DEARER: f64 = 1.5;
/// Turns at standstill are rounded off below this, radians.
const STILL: f64 = 0.02;
/// Rounds, each with features and speeds looked up anew, and steps in a round.
const ROUNDS: usize = 16;
const STEPS: usize = 6;
/// Active sets in one step.
const SETS: usize = 3;
/// Damping in the unknowns' own sizes.
const DAMPING: [f64; BLOCK] = [1.0, 1.0, 6.0, 0.3, 10.0];
/// Features in reach of a step are in the problem, metres.
const REACH: f64 = 0.35;
/// Runs shorter than this vanish, metres.
const VANISHING: f64 = 0.12;
/// No unknown moves farther in one step.
const FARTHEST: f64 = 0.4;
/// Converged where no unknown moves farther.
const STEADY: f64 = 2e-4;

/// A squared inequality: active where `residual + slopes·δ` is above 0.
///
/// `count` of the slopes are in use; six are two nodes' positions and headings.
struct Hinge {
    slopes: [(usize, f64); 6],
    count: usize,
    residual: f64,
    weight: f64,
    is_active: bool,
}

impl Hinge {
    /// Active at first where it is violated now.
    fn new(slopes: &[(usize, f64)], residual: f64, weight: f64) -> Self {
        let mut all = [(0, 0.0); 6];
        all[..slopes.len()].copy_from_slice(slopes);
        Self { slopes: all, count: slopes.len(), residual, weight, is_active: residual > 0.0 }
    }

    fn slopes(&self) -> &[(usize, f64)] {
        &self.slopes[..self.count]
    }
}

/// The optimiser of one path.
///
/// `base` has all terms but the inequalities, `system` is a copy with the active ones. `multipliers` are λ for x, y and
/// heading of each link, `defect` is ρ.
pub(super) struct PathStage<'a> {
    task: &'a Task<'a>,
    base: Banded,
    system: Banded,
    hinges: Vec<Hinge>,
    multipliers: Vec<[f64; 3]>,
    defect: f64,
    /// Least steps from the nodes; 0 where there are none.
    least: Vec<f64>,
}

/// A quadratic near 0 that becomes a straight line beyond `round`.
///
/// Huber's function over `round`: a smooth stand-in for |r|, whose corner at 0 a Newton step cannot handle.
fn rounded(r: f64, round: f64) -> f64 {
    if r.abs() < round { r * r / 2.0 / round } else { r.abs() - round / 2.0 }
}

impl<'a> PathStage<'a> {
    pub(super) fn new(task: &'a Task<'a>) -> Self {
        Self {
            task,
            base: Banded::default(),
            system: Banded::default(),
            hinges: Vec::new(),
            multipliers: Vec::new(),
            defect: DEFECTS[0],
            least: Vec::new(),
        }
    }

    /// Optimises the path; the number of steps taken.
    pub(super) fn run(&mut self, path: &mut Path) -> u32 {
        self.multipliers = vec![[0.0; 3]; path.links.len()];
        if self.task.keeps_runs {
            self.least = path.nodes.iter().map(|node| node[STEP] / 2.0).collect();
        }
        let (mut damping, mut taken) = (0.1, 0);
        for round in 0..ROUNDS {
            if round > 1 && !self.task.keeps_runs && path.drop_short(VANISHING) {
                self.multipliers = vec![[0.0; 3]; path.links.len()];
                damping = 0.1;
            }
            let stiffness = if self.task.keeps_runs { DEFECTS.len() } else { round };
            self.defect = DEFECTS[stiffness.min(DEFECTS.len() - 1)];
            let facts = Round::new(self.task, path);
            let mut moved: f64 = 0.0;
            let mut cost = self.cost(path, &facts);
            for _ in 0..STEPS {
                taken += 1;
                let Some((next, by, value)) = self.step(path, &facts, cost, &mut damping) else { break };
                *path = next;
                cost = value;
                moved = moved.max(by);
                if by < STEADY {
                    break;
                }
            }
            self.multiply(path);
            if round > 2 && moved < STEADY && path.runs().iter().all(|&run| path.length_of(run) >= VANISHING)
            {
                break;
            }
        }
        taken
    }

    /// The least step from a node, metres: half the first guess where runs are kept, else 0.
    fn least_step(&self, node: usize) -> f64 {
        self.least.get(node).copied().unwrap_or(0.0)
    }

    /// The value of what is minimised. It must be the function whose model [`PathStage::assemble`] builds; otherwise
    /// good steps would be refused.
    fn cost(&self, path: &Path, facts: &Round) -> f64 {
        let (mut cost, task) = (0.0, self.task);
        let above = |value: f64, weight: f64| if value > 0.0 { weight / 2.0 * value * value } else { 0.0 };
        for (k, link) in path.links.iter().enumerate() {
            let (node, next) = (&path.nodes[k], &path.nodes[k + 1]);
            let turn = next[ANGLE] - node[ANGLE];
            let end = match *link {
                Link::Turn => {
                    cost += rounded(turn, STILL) / task.car.max_rate;
                    [node[X], node[Y], node[HEADING]]
                }
                Link::Drive(gear) => {
                    cost += facts.time_slopes[k] * node[STEP];
                    cost += WHEEL / 2.0 * facts.speeds[k] / facts.steps[k] * turn * turn;
                    cost += BENT / 2.0 * facts.steps[k] * node[ANGLE] * node[ANGLE];
                    let lost = turn.abs() / task.car.max_rate - node[STEP] / facts.speeds[k];
                    if lost > 0.0 {
                        cost += DEARER * rounded(lost, LOST);
                    }
                    cost += above(self.least_step(k) - node[STEP], BACKWARD);
                    if matches!(path.links.get(k + 1), Some(Link::Drive(_))) {
                        cost += EVEN / 2.0 * (next[STEP] - node[STEP]) * (next[STEP] - node[STEP]);
                    }
                    drive(node, next[ANGLE], gear, task.car.vehicle.wheelbase).pose
                }
            };
            for i in 0..3 {
                let defect = end[i] - next[i] + self.multipliers[k][i] / self.defect;
                cost += self.defect / 2.0 * defect * defect;
            }
        }
        for node in &path.nodes {
            cost += above(node[ANGLE].abs() - task.car.max_angle, LOCK);
        }
        for sample in &facts.samples {
            let (car, near) = (sample.car(path), &sample.features);
            task.features
                .distances(&car, near, task.margin, &mut |d| cost += above(task.margin - d.value, ROOM));
        }
        cost
    }

    /// The normal equations of all but the inequalities, and those as a list.
    ///
    /// Absolute values |r| become squares weighted by 1/max(|r|, ε) at the current r, which have the same slope there.
    fn assemble(&mut self, path: &Path, facts: &Round) {
        let task = self.task;
        let (n, base, hinges) = (path.nodes.len(), &mut self.base, &mut self.hinges);
        base.clear(n);
        hinges.clear();
        for (k, link) in path.links.iter().enumerate() {
            let (node, next) = (&path.nodes[k], &path.nodes[k + 1]);
            let (own, other) = (k * BLOCK, (k + 1) * BLOCK);
            let turn = next[ANGLE] - node[ANGLE];
            let turned = [(own + ANGLE, -1.0), (other + ANGLE, 1.0)];
            let multiplier = self.multipliers[k];
            match *link {
                Link::Turn => {
                    base.square(&turned, turn, 1.0 / task.car.max_rate / turn.abs().max(STILL));
                    for i in 0..3 {
                        let defect = node[i] - next[i] + multiplier[i] / self.defect;
                        base.square(&[(own + i, 1.0), (other + i, -1.0)], defect, self.defect);
                    }
                }
                Link::Drive(gear) => {
                    let (speed, step) = (facts.speeds[k], facts.steps[k]);
                    base.slope(own + STEP, facts.time_slopes[k]);
                    base.square(&turned, turn, WHEEL * speed / step);
                    base.square(&[(own + ANGLE, 1.0)], node[ANGLE], BENT * step);
                    if matches!(path.links.get(k + 1), Some(Link::Drive(_))) {
                        let steps = [(own + STEP, -1.0), (other + STEP, 1.0)];
                        base.square(&steps, next[STEP] - node[STEP], EVEN);
                    }
                    let lost = turn.abs() / task.car.max_rate - node[STEP] / speed;
                    let sign = turn.signum() / task.car.max_rate;
                    let slopes = [(own + ANGLE, -sign), (own + STEP, -1.0 / speed), (other + ANGLE, sign)];
                    hinges.push(Hinge::new(&slopes, lost, DEARER / lost.max(LOST)));
                    let least = self.least.get(k).copied().unwrap_or(0.0);
                    hinges.push(Hinge::new(&[(own + STEP, -1.0)], least - node[STEP], BACKWARD));
                    let end = drive(node, next[ANGLE], gear, task.car.vehicle.wheelbase);
                    for i in 0..3 {
                        let defect = end.pose[i] - next[i] + multiplier[i] / self.defect;
                        let [heading, angle, by_step, last] = end.slopes[i];
                        let slopes = [
                            (own + i, 1.0),
                            (own + HEADING, heading),
                            (own + ANGLE, angle),
                            (own + STEP, by_step),
                            (other + i, -1.0),
                            (other + ANGLE, last),
                        ];
                        base.square(if i == HEADING { &slopes[1..] } else { &slopes }, defect, self.defect);
                    }
                }
            }
        }
        for (k, node) in path.nodes.iter().enumerate() {
            let beyond = node[ANGLE].abs() - task.car.max_angle;
            hinges.push(Hinge::new(&[(k * BLOCK + ANGLE, node[ANGLE].signum())], beyond, LOCK));
        }
        for sample in &facts.samples {
            let (car, own, share) = (sample.car(path), sample.node * BLOCK, sample.share);
            task.features.distances(&car, &sample.features, task.margin + REACH, &mut |d| {
                let [x, y, heading] = d.slopes.map(|slope| -slope);
                let at = |node: usize, share: f64| {
                    [(node + X, share * x), (node + Y, share * y), (node + HEADING, share * heading)]
                };
                let [a, b] = [at(own, 1.0 - share), at(own + BLOCK, share)];
                let slopes = [a[0], a[1], a[2], b[0], b[1], b[2]];
                let count = if share == 0.0 { 3 } else { 6 };
                hinges.push(Hinge::new(&slopes[..count], task.margin - d.value, ROOM));
            });
        }
    }

    /// A step that lowers the cost: the new path, how far its farthest unknown moved, and its cost.
    fn step(&mut self, path: &Path, facts: &Round, cost: f64, damping: &mut f64) -> Option<(Path, f64, f64)> {
        self.assemble(path, facts);
        for _ in 0..6 {
            if let Some(by) = self.solve(path, *damping)
                && by.iter().all(|by| by.abs() < FARTHEST)
            {
                let mut next = path.clone();
                for (node, by) in next.nodes.iter_mut().zip(by.chunks_exact(BLOCK)) {
                    for (value, by) in node.iter_mut().zip(by) {
                        *value += by;
                    }
                }
                let value = self.cost(&next, facts);
                if value < cost {
                    *damping = (*damping / 4.0).max(1e-7);
                    let moved = by.iter().fold(0.0, |most: f64, by| most.max(by.abs()));
                    return Some((next, moved, value));
                }
            }
            *damping *= 6.0;
        }
        None
    }

    /// The unknowns' changes, with the inequalities that are violated after them.
    ///
    /// `None` where a factorisation fails. Where the sets do not settle, the last one's answer is taken, and the cost
    /// decides about it.
    fn solve(&mut self, path: &Path, damping: f64) -> Option<Vec<f64>> {
        let mut found = None;
        for hinge in &mut self.hinges {
            hinge.is_active = hinge.residual > 0.0;
        }
        for _ in 0..SETS {
            self.system.copy(&self.base);
            for hinge in self.hinges.iter().filter(|h| h.is_active) {
                self.system.square(hinge.slopes(), hinge.residual, hinge.weight);
            }
            fix(&mut self.system, path);
            let by = self.system.solve(DAMPING.map(|d| d * damping))?;
            let mut is_same = true;
            for hinge in &mut self.hinges {
                let after =
                    hinge.slopes().iter().fold(hinge.residual, |sum, (i, slope)| sum + slope * by[*i]);
                is_same &= hinge.is_active == (after > 0.0);
                hinge.is_active = after > 0.0;
            }
            found = Some(by);
            if is_same {
                break;
            }
        }
        found
    }

    /// Moves the multipliers by what is left of the defects: the end of a round of the augmented Lagrangian.
    fn multiply(&mut self, path: &Path) {
        for (k, link) in path.links.iter().enumerate() {
            let (node, next) = (&path.nodes[k], &path.nodes[k + 1]);
            let end = match *link {
                Link::Turn => [node[X], node[Y], node[HEADING]],
                Link::Drive(gear) => drive(node, next[ANGLE], gear, self.task.car.vehicle.wheelbase).pose,
            };
            for i in 0..3 {
                self.multipliers[k][i] += self.defect * (end[i] - next[i]);
            }
        }
    }
}

/// Start and goal, with straight wheels, and steps that are none.
fn fix(system: &mut Banded, path: &Path) {
    let last = path.nodes.len() - 1;
    for unknown in [X, Y, HEADING, ANGLE] {
        system.fix(unknown);
        system.fix(last * BLOCK + unknown);
    }
    for (k, _) in path.nodes.iter().enumerate() {
        if !matches!(path.links.get(k), Some(Link::Drive(_))) {
            system.fix(k * BLOCK + STEP);
        }
    }
}
