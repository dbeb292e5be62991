//! Some places of many, numbered: a bit each, and counts to find them by.
//!
//! A road is a narrow strip of a large map. Numbering only its cells keeps the search's tables as small as the road.
//! The number of a place is the count of bits before it (*rank*): one stored count and one `count_ones`. The place of a
//! number (*select*) is found by looking on from the nearest stored word.

/// The places that are in, numbered from 0 in their order. Takes a quarter of a byte a place, less for the rest.
#[derive(Debug, Clone)]
pub(super) struct RankBitmap {
    words: Vec<u64>,
    /// Per word: how many places are in before it.
    before: Vec<u32>,
    /// Of every 64th number, the word it is in.
    words_of: Vec<u32>,
    len: u32,
}

impl RankBitmap {
    /// Marks the places for which the iterator is true.
    pub(super) fn new(places: impl ExactSizeIterator<Item = bool>) -> Self {
        let mut words = vec![0; places.len().div_ceil(64)];
        for (i, _) in places.enumerate().filter(|place| place.1) {
            words[i / 64] |= 1_u64 << (i % 64);
        }
        let (mut before, mut words_of, mut len) = (Vec::with_capacity(words.len()), Vec::new(), 0);
        for (at, word) in words.iter().enumerate() {
            before.push(len);
            len += word.count_ones();
            while words_of.len() * 64 < len as usize {
                words_of.push(at as u32);
            }
        }
        Self { words, before, words_of, len }
    }

    /// How many places are in.
    pub(super) const fn len(&self) -> usize {
        self.len as usize
    }

    /// Bytes held.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.words[..]) + size_of_val(&self.before[..]) + size_of_val(&self.words_of[..])
    }

    /// True if a place is in. O(1); the place must be one of those that the bitmap was made of.
    pub(super) fn has(&self, place: usize) -> bool {
        self.words[place / 64] >> (place % 64) & 1 == 1
    }

    /// The number of a place that is in.
    /// `None` for a place that is not in. O(1).
    pub(super) fn of(&self, place: usize) -> Option<u32> {
        let below = self.words[place / 64] & ((1 << (place % 64)) - 1);
        self.has(place).then(|| self.before[place / 64] + below.count_ones())
    }

    /// The place with a number.
    /// The inverse of [`RankBitmap::of`], for numbers below [`RankBitmap::len`]; a few words are looked at on
    /// average.
    pub(super) fn place(&self, number: u32) -> usize {
        let mut at = self.words_of[number as usize / 64] as usize;
        while at + 1 < self.before.len() && self.before[at + 1] <= number {
            at += 1;
        }
        let (mut word, mut rest, mut place) = (self.words[at], number - self.before[at], at * 64);
        for half in [32, 16, 8, 4, 2, 1] {
            let low = (word & ((1 << half) - 1)).count_ones();
            if rest >= low {
                (word, rest, place) = (word >> half, rest - low, place + half);
            }
        }
        place
    }
}

#[cfg(test)]
mod tests {
    use super::RankBitmap;
    use crate::scenario::generate::SplitMix64;

    #[test]
    fn numbers_lead_to_places_and_back() {
        let mut random = SplitMix64::new(9);
        for (len, share) in [(1, 1), (64, 1), (65, 2), (1000, 3), (5000, 700), (5000, 1), (300, 100_000)] {
            let places: Vec<bool> = (0..len).map(|_| random.below(share) == 0).collect();
            let numbers = RankBitmap::new(places.iter().copied());
            let mut count = 0;
            for (place, &is_in) in places.iter().enumerate() {
                assert_eq!((numbers.has(place), numbers.of(place)), (is_in, is_in.then_some(count)));
                if is_in {
                    assert_eq!(numbers.place(count), place);
                    count += 1;
                }
            }
            assert_eq!(numbers.len(), count as usize);
        }
    }
}
