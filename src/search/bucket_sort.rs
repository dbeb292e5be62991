//! Sorts a bucket of the [open list](super::bucket_queue).
//!
//! Entries come in long runs, mostly from the last one of the order to the first or just the other way round, so that
//! turning runs and merging a few of them does for most buckets. Equal entries keep the order in which they came.
//!
//! Three ways, chosen by what the bucket holds: insertion for few entries, merging for long runs, and otherwise, where
//! all entries share f, spreading them by h over as many steps as there are entries, like one pass of a radix sort.
//! All are stable, and linear in the number of entries on the buckets that grids produce.
//!
//! The order within a bucket is f, then h, then age, the youngest first. Age is not stored: among equal entries the
//! one that was pushed last lies last, so a stable sort keeps it. The sorted bucket is a stack whose top is the first
//! entry of the order, which makes taking an entry and pushing a new first one cost the same: one write.

use super::entry::Entry;

/// So many entries are sorted by insertion.
const FEW: usize = 16;
/// Runs are merged where they are at least so long on average.
const LONG: usize = 8;
/// As a power of two, how many times as many steps as entries there are where they are sorted by steps: with more of
/// them fewer entries share one and are still out of order, which costs a wrong guess each.
const STEPS: u32 = 2;

/// Room for sorting.
/// Both lists keep their room between buckets, so that sorting allocates only while buckets still grow.
#[derive(Debug)]
pub(super) struct Sorter<E> {
    spare: Vec<E>,
    places: Vec<u32>,
}

impl<E> Default for Sorter<E> {
    fn default() -> Self {
        Self { spare: Vec::new(), places: Vec::new() }
    }
}

impl<E: Entry> Sorter<E> {
    /// Sorts entries so that the first one of the order comes last.
    #[inline(never)]
    pub(super) fn sort(&mut self, entries: &mut Vec<E>) {
        let mut end = run(entries);
        if end == entries.len() {
            return;
        }
        if entries.len() <= FEW {
            return insertion(entries, end, E::before);
        }
        self.places.clear();
        self.places.push(end as u32);
        while end < entries.len() && end >= LONG * (self.places.len() - 1) {
            end += run(&mut entries[end..]);
            self.places.push(end as u32);
        }
        if end < entries.len() {
            // Runs are short.
            if self.spread(entries) {
                return;
            }
            while end < entries.len() {
                end += run(&mut entries[end..]);
                self.places.push(end as u32);
            }
        }
        self.merge(entries);
    }

    /// Merges runs that end at `places`.
    fn merge(&mut self, entries: &mut Vec<E>) {
        while self.places.len() > 1 {
            self.spare.clear();
            let mut start = 0;
            for pair in 0..self.places.len().div_ceil(2) {
                let middle = self.places[2 * pair] as usize;
                let end = self.places.get(2 * pair + 1).map_or(middle, |&end| end as usize);
                let (mut a, mut b) = (&entries[start..middle], &entries[middle..end]);
                while let ([first, rest @ ..], [second, others @ ..]) = (a, b) {
                    if second.before(*first) {
                        self.spare.push(*first);
                        a = rest;
                    } else {
                        self.spare.push(*second);
                        b = others;
                    }
                }
                self.spare.extend_from_slice(a);
                self.spare.extend_from_slice(b);
                self.places[pair] = end as u32;
                start = end;
            }
            self.places.truncate(self.places.len().div_ceil(2));
            std::mem::swap(entries, &mut self.spare);
        }
    }

    /// Sorts entries that are like each other: by a few times as many steps of their ranks as there are entries, then
    /// within these. Tells whether it has.
    fn spread(&mut self, entries: &mut Vec<E>) -> bool {
        let first = entries[0];
        let (mut like, mut least, mut most) = (true, first.rank(), first.rank());
        for entry in &*entries {
            like &= entry.is_like(first);
            (least, most) = (least.min(entry.rank()), most.max(entry.rank()));
        }
        if !like {
            return false;
        }
        let bits = |number: u32| u32::BITS - number.leading_zeros();
        let shift = bits(most - least).saturating_sub(bits(entries.len() as u32) + STEPS);
        let step = |entry: E| ((most - entry.rank()) >> shift) as usize;
        self.places.clear();
        self.places.resize(((most - least) >> shift) as usize + 1, 0);
        for &entry in &*entries {
            self.places[step(entry)] += 1;
        }
        let mut sum = 0;
        for place in &mut self.places {
            sum += std::mem::replace(place, sum);
        }
        // What it holds is overwritten.
        self.spare.resize(entries.len(), first);
        for &entry in &*entries {
            let place = &mut self.places[step(entry)];
            self.spare[*place as usize] = entry;
            *place += 1;
        }
        std::mem::swap(entries, &mut self.spare);
        if shift > 0 {
            insertion(entries, 1, |entry, older| entry.rank() <= older.rank());
        }
        true
    }
}

/// The length of the run that the entries begin with; one from the first of the order to the last is turned.
fn run<E: Entry>(entries: &mut [E]) -> usize {
    let [first, second, ..] = entries else { return entries.len() };
    let ordered = second.before(*first);
    let same = entries.windows(2).take_while(|pair| pair[1].before(pair[0]) == ordered).count();
    if !ordered {
        entries[..=same].reverse();
    }
    same + 1
}

/// Sorts short or nearly sorted entries, the first ones of which are sorted.
fn insertion<E: Entry>(entries: &mut [E], sorted: usize, before: impl Fn(E, E) -> bool) {
    let mut last = entries[sorted - 1];
    for place in sorted..entries.len() {
        let entry = entries[place];
        if before(entry, last) {
            last = entry;
            continue;
        }
        let mut hole = place;
        while hole > 0 && !before(entry, entries[hole - 1]) {
            entries[hole] = entries[hole - 1];
            hole -= 1;
        }
        entries[hole] = entry;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::PackedEntry;

    /// Runs of both ways and of all lengths, with one f and with several, with many equal entries and with few.
    #[test]
    fn any_runs_are_sorted_and_equal_entries_stay_in_order() {
        let mut state = 3_u64;
        let mut random = move |n: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) % n
        };
        let mut sorter = Sorter::default();
        for round in 0..2000 {
            let (kinds, longest, scale) =
                ([1, 3][round % 2], 1 + random(80), [1, 1_000_003, 1 << 30][round % 3]);
            let mut entries: Vec<PackedEntry> = Vec::new();
            for _ in 0..random(12) {
                let (f, h, length) = (random(kinds) as i64, random(200) as i64 * scale, 1 + random(longest));
                let step = (random(3) as i64 - 1) * scale;
                for k in 0..length as i64 {
                    let (f, h) = (1000 + f, 100 * scale + h + k * step);
                    entries.push(PackedEntry::new(f, h, entries.len() as u32));
                }
            }
            let mut want = entries.clone();
            want.sort_by_key(|entry| std::cmp::Reverse((entry.f(), entry.h())));
            sorter.sort(&mut entries);
            assert_eq!(entries, want, "round {round}");
        }
    }
}
