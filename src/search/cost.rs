//! Nodes are numbers, and costs are totally ordered.

/// Index of a node. Indices are dense: the search's memory grows with the largest.
pub type NodeId = u32;

/// A totally ordered path cost, never NaN: `i64` micro-cells on grids, `f64` metres in hybrid A*.
pub trait Cost:
    Copy + PartialOrd + Default + std::ops::Add<Output = Self> + std::ops::Sub<Output = Self> + std::fmt::Debug
{
    /// Larger than every cost of a path.
    const MAX: Self;

    /// A coarse measure of a cost that grows with it, for sorting the open list in advance; 0 below zero.
    fn bucket(self) -> usize;
}

impl Cost for i64 {
    const MAX: Self = Self::MAX;

    fn bucket(self) -> usize {
        usize::try_from(self.max(0) >> 12).unwrap_or(usize::MAX)
    }
}

impl Cost for f64 {
    const MAX: Self = Self::INFINITY;

    fn bucket(self) -> usize {
        (self * 256.0) as usize
    }
}
