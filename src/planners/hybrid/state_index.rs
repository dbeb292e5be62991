//! A dense number for every lattice key that the search meets.
//!
//! The lattice of a large lot has some 10¹⁰ states, of which a search meets thousands. They are numbered in the order
//! in which they are met, so that the search can keep its nodes in an array. A look-up is O(1) on average. The table
//! doubles when it is half full. Clearing it between searches is O(1): entries of earlier searches have an old stamp.
//!
//! The hash is multiplication by 2⁶⁴/φ, of which the upper half is used, with linear probing. Keys of neighbouring
//! cells differ in few bits and land far apart.

/// Slots of the smallest table.
const MIN_SLOTS: u32 = 4096;

/// Open addressing, insertion only; the numbers follow the order of first meeting, so nothing depends on the hash.
#[derive(Debug, Default)]
pub(super) struct StateIndex {
    slots: Vec<Slot>,
    count: u32,
    stamp: u32,
}

/// A key and its number, taken only if the stamp is the present one.
#[derive(Debug, Clone, Copy, Default)]
struct Slot {
    key: u64,
    id: u32,
    stamp: u32,
}

impl StateIndex {
    /// Forgets all keys, keeping the memory.
    pub(super) fn clear(&mut self) {
        if self.stamp == u32::MAX {
            self.slots.fill(Slot::default());
            self.stamp = 0;
        }
        self.stamp += 1;
        self.count = 0;
    }

    /// Bytes that this many keys take.
    pub(super) fn bytes(&self) -> u64 {
        let slots = (2 * self.count).next_power_of_two().max(MIN_SLOTS);
        u64::from(slots) * size_of::<Slot>() as u64
    }

    /// The number of a key.
    /// The first key that is met gets 0, the next new one 1, and so on: the numbers are those of the search's nodes.
    pub(super) fn id(&mut self, key: u64) -> u32 {
        if self.count as usize * 2 >= self.slots.len() {
            self.grow();
        }
        let at = self.find(key);
        if self.slots[at].stamp != self.stamp {
            self.slots[at] = Slot { key, id: self.count, stamp: self.stamp };
            self.count += 1;
        }
        self.slots[at].id
    }

    /// The number of a key, if it was met.
    pub(super) fn get(&self, key: u64) -> Option<u32> {
        let slot = self.slots.get(self.find(key))?;
        (slot.stamp == self.stamp).then_some(slot.id)
    }

    /// The slot of a key, or the free one where it belongs.
    fn find(&self, key: u64) -> usize {
        let mask = self.slots.len() - 1;
        let mut at = (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as usize & mask;
        while self.slots[at].stamp == self.stamp && self.slots[at].key != key {
            at = (at + 1) & mask;
        }
        at
    }

    /// Doubles the table and enters the present keys again; their numbers stay.
    fn grow(&mut self) {
        self.stamp = self.stamp.max(1);
        let size = (self.slots.len() * 2).max(MIN_SLOTS as usize);
        let old = core::mem::replace(&mut self.slots, vec![Slot::default(); size]);
        for slot in old.into_iter().filter(|slot| slot.stamp == self.stamp) {
            let at = self.find(slot.key);
            self.slots[at] = slot;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_dense_and_stable() {
        let mut keys = StateIndex::default();
        let first: Vec<u32> = (0..10_000_u64).map(|k| keys.id(k * k)).collect();
        assert_eq!(first, (0..10_000).collect::<Vec<u32>>());
        assert_eq!(keys.id(49), 7);
        keys.clear();
        assert_eq!(keys.id(49), 0);
    }
}
