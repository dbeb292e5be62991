//! The counters of a search.

/// What a search did; exact, and equal on every platform.
///
/// A type for all layers: the cores count it, planners add up those of their searches, a plan tells it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct SearchStats {
    /// Nodes taken from the open list and processed, the goal and second expansions included.
    pub expanded: u32,
    /// Distinct nodes that ever entered the open list, the root included; once per list.
    pub generated: u32,
    /// All insertions into the open list.
    pub pushes: u32,
    /// Largest size of the open list; of several lists that are open at once, the sum.
    pub open_peak: u32,
    /// Bytes of what was kept of the nodes and of the open list at its largest; 0 where the search does not know them.
    pub bytes: u64,
}

impl SearchStats {
    /// Adds a search that came before or after: its work, and its memory where that was larger.
    ///
    /// ```
    /// use parkade::search::SearchStats;
    ///
    /// let mut both = SearchStats { expanded: 5, open_peak: 9, ..SearchStats::default() };
    /// both.add(SearchStats { expanded: 2, open_peak: 7, ..SearchStats::default() });
    /// assert_eq!((both.expanded, both.open_peak), (7, 9));
    /// ```
    pub fn add(&mut self, other: Self) {
        self.expanded = self.expanded.saturating_add(other.expanded);
        self.generated = self.generated.saturating_add(other.generated);
        self.pushes = self.pushes.saturating_add(other.pushes);
        self.open_peak = self.open_peak.max(other.open_peak);
        self.bytes = self.bytes.max(other.bytes);
    }
}
