//! Which states are tried with a curve to the target, and which curves will do.

use super::StateLattice;
use crate::geometry::Pose;
use crate::geometry::reeds_shepp::Word;
use crate::planners::hybrid::cost::Motion;

/// Collision checks that a word may take on average …
const CHECKS_PER_WORD: u32 = 1000;
/// … once so many have been spent: past this, words that need more are skipped.
const FREE_CHECKS: u32 = 1_000_000;
/// So many states are all tried with a connection: where the way is simple, one of them has it.
const FIRST_TRIED: u32 = 32;
/// States that are passed over between two that are tried, at most.
const MOST_PASSED: f64 = 15.0;

impl StateLattice<'_> {
    /// Every so-many-th state as far from the target as this one is tried with a curve to it. From afar nearly all
    /// curves hit something, and neighbours see the same.
    pub(super) fn connect_every(&self, at: Pose) -> u32 {
        let least = u32::from(self.level.connect_every);
        if self.asked <= FIRST_TRIED {
            return least;
        }
        let passed = self.flood.distance(at) / self.level.connect_distance;
        least.max(1 + passed.min(MOST_PASSED) as u32)
    }

    /// True if a path by this word changes gear no more often than the level allows.
    pub(super) fn has_changes_left(&self, motion: Motion, word: &Word) -> bool {
        let most = self.level.most_changes;
        most == u8::MAX
            || word.arcs(self.costs.radius).fold(motion, |motion, arc| motion.then(&arc)).changes <= most
    }

    /// True if a word can be driven; not, too, where words have taken too much work.
    pub(in crate::planners::hybrid) fn word_free(&self, from: Pose, word: &Word) -> bool {
        let (words, checks) = self.tried.get();
        if checks > FREE_CHECKS.saturating_add(words.saturating_mul(CHECKS_PER_WORD)) {
            self.tried.set((words + 1, checks));
            return false;
        }
        let before = self.checker.checks();
        let [ahead, back] = &self.reach;
        let free = self.ahead(ahead, from).is_word_free(
            &mut back.borrow_mut(),
            self.checker,
            word,
            self.costs.radius,
        );
        self.tried.set((words + 1, checks.saturating_add(self.checker.checks() - before)));
        free
    }
}
