//! Cost profiles: what a driver minds, by name.

use crate::json;

/// A named cost profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Profile {
    /// As `shortest`, and a metre in reverse more than ten metres from both start and goal costs half as much again:
    /// the car does not reverse across a whole lot to save a few metres. Each gear change after the second costs four
    /// metres more: a driver goes a little farther rather than back and forth again and again.
    #[default]
    Practical,
    /// As set one by one, by default length and a metre per gear change: the parking paper's measure.
    Shortest,
    /// Away from obstacles, few gear changes, a steady wheel.
    Comfort,
    /// As in the program that the parking paper started from.
    Classic,
}

json::words!(Profile: "practical" = Practical, "shortest" = Shortest, "comfort" = Comfort, "classic" = Classic);

impl Profile {
    /// Extra weight of a metre in reverse more than ten metres from both ends.
    pub(super) fn far_reverse(self) -> f64 {
        match self {
            Self::Practical | Self::Comfort => 0.5,
            Self::Shortest | Self::Classic => 0.0,
        }
    }

    /// Extra cost of each gear change after the second, metres.
    pub(super) fn many_changes(self) -> f64 {
        match self {
            Self::Practical | Self::Comfort => MANY_CHANGES_COST,
            Self::Shortest | Self::Classic => 0.0,
        }
    }
}

/// Gear changes of a path that has few of them, at most.
pub(super) const FEW_CHANGES: u32 = 2;
/// Price of each more, metres: with the usual metre it is about what a car could drive meanwhile.
pub(super) const MANY_CHANGES_COST: f64 = 4.0;
