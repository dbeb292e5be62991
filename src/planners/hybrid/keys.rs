//! Names for states: a dense number for every lattice key that the search meets.

/// Open addressing, insertion only; the numbers follow the order of first meeting, so nothing depends on the hash.
#[derive(Debug, Default)]
pub(super) struct Keys {
    slots: Vec<(u64, u32)>,
    count: u32,
}

const FREE: u32 = u32::MAX;

impl Keys {
    /// Forgets all keys, keeping the memory.
    pub(super) fn clear(&mut self) {
        self.slots.fill((0, FREE));
        self.count = 0;
    }

    /// The number of a key.
    pub(super) fn id(&mut self, key: u64) -> u32 {
        if self.count as usize * 2 >= self.slots.len() {
            self.grow();
        }
        let at = self.find(key);
        if self.slots[at].1 == FREE {
            self.slots[at] = (key, self.count);
            self.count += 1;
        }
        self.slots[at].1
    }

    fn find(&self, key: u64) -> usize {
        let mask = self.slots.len() - 1;
        let mut at = (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as usize & mask;
        while self.slots[at].1 != FREE && self.slots[at].0 != key {
            at = (at + 1) & mask;
        }
        at
    }

    fn grow(&mut self) {
        let size = (self.slots.len() * 2).max(4096);
        let old = core::mem::replace(&mut self.slots, vec![(0, FREE); size]);
        for (key, id) in old.into_iter().filter(|slot| slot.1 != FREE) {
            let at = self.find(key);
            self.slots[at] = (key, id);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_dense_and_stable() {
        let mut keys = Keys::default();
        let first: Vec<u32> = (0..10_000_u64).map(|k| keys.id(k * k)).collect();
        assert_eq!(first, (0..10_000).collect::<Vec<u32>>());
        assert_eq!(keys.id(49), 7);
        keys.clear();
        assert_eq!(keys.id(49), 0);
    }
}
