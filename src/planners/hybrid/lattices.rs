//! The lattices on which hybrid A* searches: its levels, and those between and beyond them.
//!
//! A level is one resolution of the state lattice. Coarse levels are fast and answer ordinary questions; fine ones
//! find the way out of slots that the coarse ones cannot leave, because in a narrow slot no step of 0.8 m is free.
//! Levels 1 to 4 make the position cell, the heading bin and the step smaller together: a step must leave its cell,
//! or else a move leads back to the state that it came from, and a bin must be narrower than the turn of a step at
//! full lock, or else turning shows no progress.
//!
//! Finer levels weigh the estimate with 2 instead of 1. They have many more states, and the shortest path is not what
//! they are for.

use super::config::{Config, LEVEL_COUNT, SearchFrom};

/// Levels from this one on are for cars that can hardly move.
pub(super) const FIRST_SHUFFLING_LEVEL: u32 = 5;

/// How far a move leads along its primitive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Lengths {
    /// To its end; a move that something blocks is left out.
    Fixed,
    /// To its end, or as far as it is free where something blocks it.
    Shortened,
    /// For a car that can hardly move: until something is in the way, to its end at most, and half as far.
    Shuffling,
}

/// How much is tried to make a path cheaper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Effort {
    /// Only the shortcut: the path stays as far from obstacles as its curves lead.
    Shortcut,
    /// The shortcut, the descent and longer moves.
    Descent,
}

/// One resolution of the lattice.
#[derive(Debug, Clone, Copy)]
pub(super) struct Level {
    /// Side of a position cell, metres.
    pub(super) xy: f64,
    /// Width of a heading bin, radians.
    pub(super) yaw: f64,
    /// Length of a motion primitive, metres.
    pub(super) step: f64,
    /// Steering angles to either side, besides straight.
    pub(super) steer_samples: u32,
    /// Spacing of collision checks along an arc, metres.
    pub(super) spacing: f64,
    /// Expansions after which this level gives up.
    pub(super) max_expansions: u32,
    /// Factor on the estimate; above 1 the path may cost as many times more.
    pub(super) weight: f64,
    /// Extra weight of a metre in reverse away from both ends while searching.
    pub(super) far_reverse: f64,
    /// The same along connections: at the coarsest level they are compared by what the path will be charged.
    pub(super) tail_far_reverse: f64,
    /// Extra cost of a gear change while searching, metres.
    pub(super) extra_change: f64,
    /// States whose cost reaches this bound are left out.
    pub(super) bound: f64,
    /// States that took more gear changes than this are left out.
    pub(super) most_changes: u8,
    /// Every so-many-th state is tried with a curve to the target: on a fine lattice neighbours see the same.
    pub(super) connect_every: u8,
    /// One more of them is passed over for each so many metres to the target; none where this is infinite.
    pub(super) connect_distance: f64,
    /// How far a move leads, `step` at most.
    pub(super) lengths: Lengths,
    /// Turn of a rock, radians; 0 where the car does not rock.
    pub(super) rock: f64,
    /// True if two trees grow, one from each end.
    pub(super) is_from_both: bool,
    /// What is tried to make its paths cheaper.
    pub(super) effort: Effort,
}

impl Level {
    /// The same where every state is tried with a curve to the target: the last gear change is often the one that a
    /// curve saves.
    pub(super) fn trying_all(self) -> Self {
        Self { connect_every: 1, connect_distance: f64::INFINITY, ..self }
    }

    /// The same where moves that something blocks end before that. With moves of one length the last before a
    /// neighbour leaves some room unused, now more and now less.
    pub(super) fn shortening(self) -> Self {
        Self { lengths: Lengths::Shortened, ..self }
    }

    /// True if it is for a car that can hardly move.
    pub(super) fn shuffles(&self) -> bool {
        self.lengths == Lengths::Shuffling
    }

    /// The same with cells, bins and steps of half the size.
    pub(super) fn halved(self) -> Self {
        Self { xy: self.xy / 2.0, yaw: self.yaw / 2.0, step: self.step / 2.0, ..self }
    }

    /// The same with the wide spacing of the coarsest level, and a curve from every state. Most such searches find
    /// nothing, so they are to be cheap; the check of a path tells what a wide spacing misses.
    pub(super) fn cheaply_tried(self, coarsest: &Self) -> Self {
        Self { spacing: coarsest.spacing, connect_every: 1, ..self }
    }

    /// The same where the car may rock. Gear changes cost little, or else everything would be tried before; and
    /// there are hardly any connections, as a way out of every slot is known and the way to the target is not.
    pub(super) fn rocking(self, config: &Config) -> Self {
        let level = self.with_change(CHEAP_CHANGE_COST, config);
        Self { connect_every: ROCKING_CONNECT_EVERY, rock: ROCK_BINS * self.yaw, ..level }
    }

    /// The same where a path takes at most so many gear changes.
    pub(super) fn with_changes(self, most: u32) -> Self {
        Self { most_changes: most.min(u32::from(u8::MAX)) as u8, ..self }
    }

    /// The same where a gear change costs this at most, metres.
    pub(super) fn with_change(self, most: f64, config: &Config) -> Self {
        let change = config.with_profile().direction_change_cost;
        Self { extra_change: change.min(most) - change, ..self }
    }

    /// The same with this weight and so many expansions, unless the settings say others.
    pub(super) fn within(self, (weight, expansions): (f64, u32), config: &Config) -> Self {
        let weight = config.heuristic_weight.unwrap_or(weight);
        Self { weight, max_expansions: config.max_expansions.unwrap_or(expansions), ..self }
    }

    /// One of the finer lattices, from 1 on.
    pub(super) fn refined(self, number: usize, config: &Config) -> Self {
        let (xy, degrees, step) = REFINED[number - 1];
        let weight = config.heuristic_weight.unwrap_or(REFINED_WEIGHT);
        Self { xy, yaw: degrees * DEGREE, step, weight, ..self }
    }

    /// The finer lattice that rocks. With less weight there are too many states to go through.
    pub(super) fn fine_rocking(self, config: &Config) -> Self {
        let level = self.beside(BESIDE.len());
        let weight = config.heuristic_weight.unwrap_or(FINE_ROCKING_WEIGHT);
        Self { weight, rock: ROCK_BINS * level.yaw, ..level }
    }

    /// The lattice with moves up to contact.
    pub(super) fn up_to_contact(self) -> Self {
        let (xy, degrees, step) = UP_TO_CONTACT;
        Self { xy, yaw: degrees * DEGREE, step, lengths: Lengths::Shuffling, ..self }
    }

    /// One of the lattices beside the plain levels, from 1 on.
    pub(super) fn beside(self, number: usize) -> Self {
        let (xy, degrees, step) = BESIDE[number - 1];
        Self { xy, yaw: degrees * DEGREE, step, ..self }
    }
}

/// Lattices beside levels 2 and 3, for cars that find a way but change gear often: metres, degrees, metres. The last
/// one rocks as well.
const BESIDE: [(f64, f64, f64); 2] = [(0.1, 1.2, 0.15), (0.06, 0.75, 0.1)];

/// A lattice on which a car goes on until something is in the way, coarser than those for cars that can hardly move:
/// metres, degrees, metres.
const UP_TO_CONTACT: (f64, f64, f64) = (0.1, 2.0, 1.0);

/// Finer lattices for a car that gains millimetres with each gear change: metres, degrees, metres.
const REFINED: [(f64, f64, f64); REFINEMENTS] =
    [(0.04, 0.6, 0.1), (0.035, 0.5, 0.08), (0.02, 0.25, 0.1), (0.02, 0.4, 0.08), (0.02, 0.2, 0.06)];
/// How many they are.
pub(super) const REFINEMENTS: usize = 5;
/// Weight of the estimate on them.
const REFINED_WEIGHT: f64 = 1.3;
/// Cost of a gear change where the car may rock or the tree grows from the other end, metres.
pub(super) const CHEAP_CHANGE_COST: f64 = 0.2;
/// Turn of a rock, in heading bins: it leaves the bin.
const ROCK_BINS: f64 = 2.0;
/// Weight of the estimate on the finer lattice of those that rock.
const FINE_ROCKING_WEIGHT: f64 = 3.0;
/// Every so-many-th state is tried with a curve to the target while the car may rock.
const ROCKING_CONNECT_EVERY: u8 = 16;

/// One more state is passed over for each so many metres to the target before the next is tried with a curve to it.
const CONNECT_DISTANCE: f64 = 5.0;

const DEGREE: f64 = core::f64::consts::PI / 180.0;

impl Config {
    /// How many levels these settings allow.
    /// From 1, where the ladder is off, to [`LEVEL_COUNT`].
    pub(super) fn levels(&self) -> u32 {
        if self.ladder { self.finest_level.min(LEVEL_COUNT - 1) + 1 } else { 1 }
    }

    /// One of the levels, coarse ones first.
    /// Settings of resolution replace the level's own on every level but those that shuffle.
    pub(super) fn level(&self, number: u32) -> Level {
        let (xy, yaw, step, steer_samples, spacing, max_expansions, weight) = match number {
            0 => (0.5, 5.0, 0.8, 2, 0.1, 20_000, 1.0),
            1 => (0.15, 2.0, 0.25, 1, 0.05, 60_000, 2.0),
            2 => (0.1, 1.0, 0.15, 1, 0.05, 60_000, 2.0),
            3 => (0.07, 0.6, 0.1, 1, 0.05, 100_000, 2.0),
            4 => (0.05, 0.5, 0.06, 1, 0.05, 100_000, 2.0),
            5 => (0.05, 1.0, 1.0, 1, 0.05, 8_000, 1.2),
            _ => (0.03, 0.5, 1.0, 1, 0.05, 8_000, 1.2),
        };
        let shuffle = number >= FIRST_SHUFFLING_LEVEL;
        let connect_every = if shuffle { 1 } else { (2 * number).max(1) as u8 };
        let level = Level {
            xy,
            yaw: yaw * DEGREE,
            step,
            steer_samples,
            spacing,
            max_expansions: self.max_expansions.unwrap_or(max_expansions),
            weight: self.heuristic_weight.unwrap_or(weight),
            far_reverse: 0.0,
            tail_far_reverse: if number == 0 { self.profile.far_reverse() } else { 0.0 },
            extra_change: if number > 0 && !shuffle { 2.0 } else { 0.0 },
            bound: f64::INFINITY,
            most_changes: u8::MAX,
            connect_every,
            connect_distance: if self.first_shot { f64::INFINITY } else { CONNECT_DISTANCE },
            lengths: if shuffle { Lengths::Shuffling } else { Lengths::Fixed },
            rock: 0.0,
            is_from_both: self.search_from == SearchFrom::Both,
            effort: Effort::Descent,
        };
        if shuffle {
            return level;
        }
        Level {
            xy: self.xy_resolution.unwrap_or(level.xy),
            yaw: self.heading_resolution.unwrap_or(level.yaw),
            step: self.motion_primitive_length.unwrap_or(level.step),
            steer_samples: self.steer_samples.unwrap_or(level.steer_samples),
            ..level
        }
    }
}
