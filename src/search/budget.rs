//! How far a search may go.
//!
//! Budgets count expansions instead of seconds, so that a search ends at the same node on a fast and on a slow
//! machine. The observer is asked at the same counts: progress and cancellation do not change the order of a
//! search.
//!
//! Let the budget be N expansions, and let the observer ask to be told at P. The loop compares its count with min(N,
//! P) alone, and only when it is reached finds out which of the two it was.

use super::Observer;

/// The number of nodes that a search may expand, of which its observer is told now and then.
///
/// One comparison a node serves both.
pub(crate) struct Budget {
    most: u32,
    stop: u32,
}

impl Budget {
    /// A budget of as many nodes.
    #[inline(always)]
    pub(crate) fn new<C, L, O: Observer<C, L>>(most: u32, observer: &mut O) -> Self {
        Self { most, stop: observer.due(0).min(most) }
    }

    /// True if a search that has expanded so many nodes is over.
    #[inline(always)]
    pub(crate) fn is_spent<C, L, O: Observer<C, L>>(&mut self, expanded: u32, observer: &mut O) -> bool {
        if expanded < self.stop {
            return false;
        }
        self.stop = observer.due(expanded).min(self.most);
        expanded >= self.stop
    }
}
