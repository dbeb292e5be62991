//! How planning ended, in one word for all planners.

use crate::json::{self, Words as _};
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

json::words!(Outcome: "found" = Found, "no-path" = NoPath, "budget-spent" = BudgetSpent,
    "start-blocked" = StartBlocked, "goal-blocked" = GoalBlocked, "start-outside" = StartOutside,
    "goal-outside" = GoalOutside);

impl Outcome {
    /// The word of the JS API.
    pub fn as_str(self) -> &'static str {
        self.word()
    }
}

/// A finer word for an [`Outcome`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Detail {
    /// No path: on the map there is none; for a car, some gap on every way is narrower than the car and its margin.
    Unreachable,
    /// No path: there is one, but this planner's moves do not lead to it.
    Incomplete,
    /// No path: a place on every way is narrower than the body.
    TooNarrow,
    /// No path: the body would not fit through if it moved in any direction and turned on the spot.
    NoRoom,
    /// No path: the car can hardly move where it starts or arrives.
    BoxedIn,
    /// No path: every path found touches something between two checks.
    VerificationFailed,
    /// Found, but the budget ended before the path was proven the cheapest.
    Suboptimal,
    /// Found, but the car follows the chords, for no curve was good enough.
    SmoothingFellBack,
    /// Found, but the path keeps less than the margin.
    LessMargin,
}

json::words!(Detail: "unreachable" = Unreachable, "incomplete" = Incomplete, "too-narrow" = TooNarrow,
    "no-room" = NoRoom, "boxed-in" = BoxedIn, "verification-failed" = VerificationFailed,
    "suboptimal" = Suboptimal, "smoothing-fell-back" = SmoothingFellBack, "less-margin" = LessMargin);

impl Detail {
    /// The word of the JS API.
    pub fn as_str(self) -> &'static str {
        self.word()
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The words of a union of strings in the package's types.
    fn union(name: &str) -> Vec<String> {
        let types = concat!(env!("CARGO_MANIFEST_DIR"), "/packages/parkade/types/plan.d.ts");
        let types = std::fs::read_to_string(types).unwrap();
        let union = types.split(&format!("export type {name} =")).nth(1).unwrap();
        let words = union.split(';').next().unwrap().split('"').skip(1).step_by(2);
        words.map(str::to_owned).collect()
    }

    #[test]
    fn the_types_have_the_same_words() {
        fn same<T: json::Words>(name: &str) {
            let (mut types, mut own) = (union(name), T::WORDS.iter().map(|word| word.0).collect::<Vec<_>>());
            types.sort_unstable();
            own.sort_unstable();
            assert_eq!(types, own, "{name}");
        }
        same::<Outcome>("Outcome");
        same::<Detail>("Detail");
    }
}
