//! One search of the lattice at one resolution, with one margin, from one end.
//!
//! The steps of one search:
//!
//! 1. grow a tree from `root` until a Reeds–Shepp curve from some state to `target` is free and nothing open is
//!    cheaper;
//! 2. turn the path round if the tree grew from the goal;
//! 3. straighten it with the shortcut, by the same costs, margin and spacing of checks;
//! 4. check the whole path every centimetre: it must keep the margin, but for a millimetre.
//!
//! Collision checks are samples along arcs. A spacing of a few centimetres is fast, and it misses now and then how two
//! corners pass each other: where samples are 10 cm apart, a margin of 10 cm may be short of three. Step 4 finds that.
//! Then the shortcut is tried again with half the spacing, or the search where its own path is at fault, twice at most.
//! A path that is returned has always passed step 4.
//!
//! The first level spends its budget in three parts. A thousand expansions answer most questions. Where they do not,
//! 250 expansions from the other end show whether that end is the hard one to leave. The rest is spent with the
//! estimate times 1.3: weighted A\*, which no longer explores every detour of equal promise. Its path may cost 1.3
//! times as much as the cheapest. A path with many gear changes is then held against further searches: with a dearer
//! change, with half the steps and on the second level; the last only where that before saw all that it might.

use core::cell::RefCell;

use super::analytic_expansion::Recorder;
use super::domain::{Setting, StateLattice};
use super::improvement;
use super::lattices::Level;
use super::profile::FEW_CHANGES;
use super::question::{MIN_MARGIN, Search, Work};
use super::recording::PoseRecording;
use super::report::{Report, Status};
use super::shortcut::Rules;
use super::state::{self, State};
use super::tree::Tree;
use crate::IS_COMPLETE;
use crate::geometry::arcs::{self, Arc};
use crate::geometry::math;
use crate::search::record_best_first;
use crate::search::{End, Limits, SearchStats, best_first};

/// Spacing of the last check of a path, metres.
pub(super) const VERIFY_SPACING: f64 = 0.01;
/// How often the spacing of a search's checks is halved where that one fails.
const HALVINGS: i32 = 2;
/// It may keep so much less than its margin there, metres.
pub(super) const MARGIN_TOLERANCE: f64 = 0.001;
/// Expansions from the other end, to see whether anything leads out of there.
const OTHER_END_EXPANSIONS: u32 = 250;
/// Expansions after which the estimate gets more weight.
const FIRST_BUDGET: u32 = 1000;
/// Its weight then.
const RETRY_WEIGHT: f64 = 1.3;
/// The first level's weight then.
const TIGHT_RETRY_WEIGHT: f64 = 1.2;
/// A path whose reverse driving away from both ends costs more than this extra is searched again: ten metres of it.
const FAR_REVERSE_PRICE: f64 = 5.0;
/// Extra weight of a metre of it then. The price itself spends the budget on detours of equal promise.
const FAR_REVERSE_WEIGHT: f64 = 2.0;
/// Expansions of that search for each metre that it may save.
const FAR_REVERSE_EFFORT: f64 = 50.0;
/// Expansions of a search that looks for a cheaper path, at most: so many in all, and so many for each metre that the
/// known one costs more than any must. With a dearer gear change, …
const FEWER_CHANGES: (u32, f64) = (10_000, 400.0);
/// … with half the steps, …
const HALF_STEPS: (u32, f64) = (3000, 100.0);
/// … and on the second level.
const SECOND_LEVEL: (u32, f64) = (5000, 200.0);
/// The first of them gets no more than so many for each that the path took.
const FEWER_CHANGES_EFFORT: u32 = 2;
/// On another lattice a path may cost so many times what is left of it after the shortcut.
const BEFORE_SHORTCUT: f64 = 1.3;

/// How the first level ended.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum First {
    Found,
    Failed,
    /// The other end is the one that is hard to leave.
    Cramped,
}

fn changes(work: &Work) -> u32 {
    arcs::direction_changes(&work.report.arcs)
}

/// Expansions of a search with finer steps: as many as the plan took, for each gear change beyond a few.
fn finer_steps_effort(work: &Work) -> u32 {
    work.report.stats.expanded.saturating_mul(changes(work).saturating_sub(FEW_CHANGES))
}

/// The same level with the spacing of its checks halved so often.
fn finer(level: Level, halvings: i32) -> Level {
    Level { spacing: level.spacing / f64::from(1 << halvings), ..level }
}

impl Search<'_> {
    /// Searches the first level; tells whether there is a path. `other` is the same question from the other end.
    pub(super) fn first(&self, other: &dyn Fn() -> Option<Self>, level: Level, work: &mut Work) -> First {
        let weight = self.config.heuristic_weight.unwrap_or(if self.tight {
            TIGHT_RETRY_WEIGHT
        } else {
            level.weight
        });
        let level = Level { weight, ..level };
        let soon = Level { max_expansions: level.max_expansions.min(FIRST_BUDGET), ..level };
        let mut found = self.level(soon, work);
        let is_unfinished = matches!(work.report.status, Status::Suboptimal | Status::BudgetExhausted(_));
        if is_unfinished && soon.max_expansions < level.max_expansions {
            if let Some(other) = if found { None } else { other() } {
                let soon = Level { max_expansions: soon.max_expansions.min(OTHER_END_EXPANSIONS), ..soon };
                if other.level(soon, work) {
                    other.reconsider(level, work);
                    return First::Found;
                }
                if work.report.status == Status::NoPath {
                    return First::Cramped;
                }
            }
            found = self.retry(self.patient(level), 0, work);
        }
        if !found {
            return First::Failed;
        }
        self.reconsider(level, work);
        First::Found
    }

    /// The first level with what the first try leaves of its budget. On long cluttered ways the plain estimate spends
    /// all of it on detours of equal promise.
    fn patient(&self, level: Level) -> Level {
        let weight = self.config.heuristic_weight.unwrap_or(RETRY_WEIGHT);
        Level { weight, max_expansions: level.max_expansions - FIRST_BUDGET, ..level }
    }

    /// Searches once more where the path found reverses far: for one that hardly does. Such a path turns round on the
    /// way. An estimate that does not tell what turning costs would spend the budget around the root.
    ///
    /// A path that turns round takes gear changes for that, so it is not asked to save them: what saves them reverses.
    #[inline(never)]
    fn reconsider(&self, level: Level, work: &mut Work) {
        let this = self.arrived(&work.report.arcs);
        let without = this.costs().with_far_reverse(0.0);
        let price = work.report.cost - without.path(self.checker, self.start, &work.report.arcs);
        let weight = self.config.heuristic_weight.unwrap_or(RETRY_WEIGHT);
        let mut level = Level { weight, ..level };
        if price > FAR_REVERSE_PRICE {
            level.far_reverse = FAR_REVERSE_WEIGHT;
            let most = level.max_expansions.min((price * FAR_REVERSE_EFFORT) as u32);
            let before = work.report.cost;
            this.retry(Level { max_expansions: most, ..level }, 0, work);
            if work.report.cost < before {
                return;
            }
        }
        this.fewer_changes(level, work);
        this.with_finer_steps(weight, work);
    }

    /// Searches once more where the path changes gear often: for one that is cheaper with the price of that.
    fn fewer_changes(&self, mut level: Level, work: &mut Work) {
        let price = self.config.profile.many_changes();
        if price == 0.0 || changes(work) <= FEW_CHANGES {
            return;
        }
        level.extra_change = price;
        let most = FEWER_CHANGES_EFFORT * work.report.stats.expanded;
        level.max_expansions = level.max_expansions.min(most);
        self.cheaper(level, 0, (FEWER_CHANGES, 1.0), work);
    }

    /// Searches once more where the path still changes gear often: with half the steps and, where that has seen all and
    /// did not help, on the second level. Shorter steps fit where long ones take another change. The more of them there
    /// are, the more work that is worth. The small module does without.
    fn with_finer_steps(&self, weight: f64, work: &mut Work) {
        let is_asked = IS_COMPLETE && self.config.levels() > 1 && !self.config.first_shot;
        if !is_asked || changes(work) <= FEW_CHANGES {
            return;
        }
        let mut level = self.config.level(0).halved();
        (level.weight, level.connect_every) = (weight, 2);
        level.max_expansions = level.max_expansions.min(finer_steps_effort(work));
        let is_spent = self.cheaper(level, 0, (HALF_STEPS, BEFORE_SHORTCUT), work);
        if !is_spent && changes(work) > FEW_CHANGES {
            let mut level = self.config.level(1);
            level.extra_change = self.config.profile.many_changes();
            level.max_expansions = level.max_expansions.min(finer_steps_effort(work));
            self.cheaper(level, 1, (SECOND_LEVEL, BEFORE_SHORTCUT), work);
        }
    }

    /// Searches for a cheaper path with no more gear changes; tells whether all that it may spend was spent. What costs
    /// `slack` times as much as the known path, by the prices of the search, is left out.
    #[inline(never)]
    fn cheaper(
        &self,
        mut level: Level,
        number: u32,
        (effort, slack): ((u32, f64), f64),
        work: &mut Work,
    ) -> bool {
        let root = if self.mirrored { self.goal } else { self.start };
        let least = work.report.rs_bound.max(self.flood.distance(root));
        let most = effort.0.min((effort.1 * (work.report.cost - least)) as u32);
        let cost = self.costs().searching(&level).path(self.checker, self.start, &work.report.arcs);
        level.bound = slack * cost;
        level.max_expansions = level.max_expansions.min(most);
        level.most_changes = changes(work).min(u32::from(u8::MAX)) as u8;
        let before = work.report.stats.expanded;
        self.retry(level, number, work);
        work.report.stats.expanded - before >= level.max_expansions
    }

    /// Searches a level and keeps the cheaper answer: its own, or the earlier one; tells whether there is a path.
    #[inline(never)]
    fn retry(&self, level: Level, number: u32, work: &mut Work) -> bool {
        // A search that the caller ends before it begins leaves the status as it is.
        let Report { margin, status, .. } = *work.report;
        let counters = Report { level: number, margin, status, ..work.report.counters() };
        let known = core::mem::replace(work.report, counters);
        let is_known = !known.arcs.is_empty();
        let limit = if is_known { known.cost } else { f64::INFINITY };
        let is_better = self.level_below((u32::MAX, limit), level, work);
        if is_known && !is_better {
            *work.report = work.report.with_path_of(known);
        }
        is_known || is_better
    }

    /// Searches one level, with finer collision checks where verification fails; tells whether there is a path.
    pub(super) fn level(&self, level: Level, work: &mut Work) -> bool {
        self.level_below((u32::MAX, f64::INFINITY), level, work)
    }

    /// The same for a path with so many gear changes at most that costs less than so much, metres. For another one the
    /// search is not repeated with finer checks.
    #[inline(never)]
    pub(super) fn level_below(&self, limits: (u32, f64), level: Level, work: &mut Work) -> bool {
        for halvings in 0..=HALVINGS {
            let Some((arcs, status)) = self.search(finer(level, halvings), work) else { return false };
            work.report.status = status;
            if let Some(is_taken) = self.arrived(&arcs).improve(&arcs, limits, level, halvings, work.report) {
                return is_taken;
            }
            work.report.status = Status::VerificationFailed;
        }
        false
    }

    /// Takes a path after the shortcut for the answer, unless it exceeds the limits; tells whether it does not. Nothing
    /// where it hits something between two checks of the search. Where only the shortcut's curves do, finer checks of
    /// these are enough.
    fn improve(
        &self,
        arcs: &[Arc],
        (most_changes, limit): (u32, f64),
        level: Level,
        halvings: i32,
        report: &mut Report,
    ) -> Option<bool> {
        let costs = self.costs();
        for halvings in halvings..=HALVINGS {
            let better = self.straightened(arcs, finer(level, halvings), report.margin);
            let cost = costs.path(self.checker, self.start, &better);
            if cost >= limit || (IS_COMPLETE && arcs::direction_changes(&better) > most_changes) {
                return Some(false);
            }
            if self.verified(&better, report.margin) {
                (report.arcs, report.cost) = (better, cost);
                return Some(true);
            }
            if !self.config.shortcut || !self.verified(arcs, report.margin) {
                break;
            }
        }
        None
    }

    /// Grows the tree of one level; returns the path as driven, and whether it is proven the cheapest. Without a path
    /// the report's status says whether the level was exhausted or its budget spent.
    #[inline(never)]
    fn search(&self, level: Level, work: &mut Work) -> Option<(Vec<Arc>, Status)> {
        if let Some(progress) = work.progress.as_mut() {
            if progress.is_stopped() {
                return None;
            }
            progress.follow(work.report.stats.expanded);
        }
        let tree = self.trace.then(|| Tree::new(self, work.progress.as_ref()));
        let recorder = self.trace.then(|| RefCell::new(Recorder::new(self.origin())));
        (work.report.from_goal, work.report.resolution) = (self.mirrored, (level.xy, level.yaw));
        if IS_COMPLETE && level.is_from_both && !level.shuffles() && self.goals.is_empty() {
            let mut tree = tree;
            let found = super::bidirectional::search(self, level, work, &mut tree, recorder.as_ref());
            work.report.keep(tree, recorder.as_ref());
            return found;
        }
        let Work { report, scratch, progress } = work;
        let radius = self.query.vehicle.min_turning_radius();
        let driven = self.costs().searching(&level);
        let costs = if self.mirrored { driven.mirrored() } else { driven };
        let setting = Setting {
            checker: self.checker,
            flood: self.flood,
            keys: &scratch.keys,
            costs,
            mirrored: self.mirrored,
            recorder: recorder.as_ref(),
            poses: self.poses,
            roots: self.goals,
        };
        let mut lattice =
            StateLattice::new(setting, self.query.vehicle, self.config, level, self.target, report.margin);
        let limits = Limits {
            max_expansions: level.max_expansions,
            first: self.config.first_shot || level.shuffles(),
        };
        let root = lattice.root(self.root);
        let mut observer = (tree, progress.as_mut());
        let found = if IS_COMPLETE && let Some(limit) = scratch.recorded_steps {
            let (found, recorded) =
                record_best_first(&mut lattice, root, limits, &mut scratch.search, &mut observer, limit);
            let poses = PoseRecording::new(&[(&lattice, root.1.pose)], self.origin(), recorded);
            report.recorded = Some(poses.into());
            found
        } else {
            best_first(&mut lattice, root, limits, &mut scratch.search, &mut observer)
        };
        report.keep(observer.0, recorder.as_ref());
        let SearchStats { generated, open_peak, .. } = found.stats;
        let nodes = crate::search::Scratch::<f64, State>::bytes(generated as usize, open_peak);
        let bytes = nodes as u64 + scratch.keys.borrow().bytes();
        report.stats.add(SearchStats { bytes, ..found.stats });
        let closest = scratch.search.label(found.closest.1).map(|s| s.pose);
        report.closest = closest.map(|p| self.world(p));
        let Some((last, _, tail)) = found.found else {
            report.status = match found.end {
                End::BudgetSpent => Status::BudgetExhausted(found.closest.0 / level.weight.max(1e-9)),
                _ => Status::NoPath,
            };
            return None;
        };
        let arcs = state::path(&scratch.search.chain(last), &tail, radius);
        let arcs = if self.mirrored { arcs::reversed(&arcs) } else { arcs };
        let unproven = level.shuffles() || found.end == End::BudgetSpent;
        let status = if unproven { Status::Suboptimal } else { Status::Found };
        Some((arcs, status))
    }

    /// The path after the shortcut, where the settings ask for one.
    pub(super) fn straightened(&self, arcs: &[Arc], level: Level, margin: f64) -> Vec<Arc> {
        if !self.config.shortcut {
            return arcs.to_vec();
        }
        let costs = self.costs().with_far_reverse(level.far_reverse);
        let rules = Rules { checker: self.checker, costs: &costs, spacing: level.spacing, margin };
        improvement::improved(rules, self.start, arcs.to_vec(), level.effort)
    }

    /// True if the path is free at the finest spacing, keeps its margin and ends at the goal. The least margin is what
    /// passes unseen between two checks, so it is not looked for.
    pub(super) fn verified(&self, arcs: &[Arc], margin: f64) -> bool {
        let mut pose = self.start;
        let free = arcs.iter().all(|arc| {
            let free = if margin > MIN_MARGIN {
                self.checker.keeps_clearance(pose, arc, VERIFY_SPACING, (margin, MARGIN_TOLERANCE))
            } else {
                self.checker.arc_free(pose, arc, VERIFY_SPACING, 0.0)
            };
            pose = pose.advance(arc.curvature, arc.length);
            free
        });
        let off = (pose.point() - self.goal.point()).norm();
        free && off < 1e-6 && math::turn(pose.heading, self.goal.heading).abs() < 1e-6
    }
}
