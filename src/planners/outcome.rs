//! How planning ended, in one word for all planners.

use crate::search::End;

/// How planning ended; no path is an outcome, not an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// There is a path.
    Found,
    /// There is none at these settings.
    NoPath,
    /// The expansion budget was spent first.
    BudgetSpent,
    /// The start is inside an obstacle.
    StartBlocked,
    /// The goal is inside an obstacle.
    GoalBlocked,
    /// The start is off the map.
    StartOutside,
    /// The goal is off the map.
    GoalOutside,
}

impl Outcome {
    /// The word of the JS API.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Found => "found",
            Self::NoPath => "no-path",
            Self::BudgetSpent => "budget-spent",
            Self::StartBlocked => "start-blocked",
            Self::GoalBlocked => "goal-blocked",
            Self::StartOutside => "start-outside",
            Self::GoalOutside => "goal-outside",
        }
    }
}

impl From<End> for Outcome {
    fn from(end: End) -> Self {
        match end {
            End::Found => Self::Found,
            End::Exhausted => Self::NoPath,
            End::BudgetSpent => Self::BudgetSpent,
        }
    }
}
