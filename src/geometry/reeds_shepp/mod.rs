//! Shortest paths without obstacles for a car that drives both ways (Reeds and Shepp 1990).
//!
//! A car with turning radius R that may reverse gets from any pose to any other, and one of 48 kinds of path, the
//! *words*, is the shortest. A word has at most five segments, each on the tightest circle to one side or straight, and
//! at most two cusps. Hybrid A\* uses them twice: their length is an estimate of the cost that remains (a lower bound,
//! because obstacles only lengthen paths), and a free one from an expanded pose to the target completes the path.
//!
//! Names and words follow the paper: C and its L, R are circles of the tightest curvature, S is a straight line;
//! lengths t, u, v are in units of the turning radius, negative in reverse. Nine families of formulas are enough. Each
//! is tried under time flip (driving the other way: every gear changes), reflection (L for R) and, where that gives
//! something new, backwards (the segments in the opposite order).
//!
//! All words together take some 20 inverse trigonometric functions and no allocation. A caller that has a bound passes
//! it, and words that cannot be shorter are not solved.
//!
//! # Examples
//! ```
//! use parkade::geometry::{Pose, reeds_shepp};
//!
//! // Parking sideways: 2 m to the left, same heading, with a radius of 5 m.
//! let (from, to) = (Pose::default(), Pose::new(0.0, 2.0, 0.0));
//! let words = reeds_shepp::list_below(from, to, 5.0, f64::INFINITY);
//! let shortest = words.iter().min_by(|a, b| a.length(5.0).total_cmp(&b.length(5.0))).unwrap();
//! assert_eq!(shortest.length(5.0), reeds_shepp::distance(from, to, 5.0));
//! assert!(shortest.direction_changes() > 0 && shortest.length(5.0) > 2.0);
//! ```

mod families;
mod word;

pub use word::Word;

use super::Pose;
use families::{All, Least, visit, visit_in_one_gear};

/// All words from `from` to `to` for turning radius `radius`, metres, unordered, handed to `each`.
///
/// Words of the same family under different symmetries can be the same curve; they are not sorted out.
pub fn words(from: Pose, to: Pose, radius: f64, each: impl FnMut(Word)) {
    words_below(from, to, radius, f64::INFINITY, each);
}

/// The words shorter than `bound` metres from `from` to `to` for turning radius `radius`, unordered.
pub fn words_below(from: Pose, to: Pose, radius: f64, bound: f64, each: impl FnMut(Word)) {
    visit(from, to, radius, &mut All { bound: bound / radius, each });
}

/// The same as a list: one piece of code for all to whom a list costs nothing.
#[inline(never)]
pub fn list_below(from: Pose, to: Pose, radius: f64, bound: f64) -> Vec<Word> {
    let mut list = Vec::new();
    words_below(from, to, radius, bound, |word| list.push(word));
    list
}

/// Those of [`list_below`] that change no gear: a circle, a straight line and a circle.
#[inline(never)]
pub fn list_in_one_gear(from: Pose, to: Pose, radius: f64, bound: f64) -> Vec<Word> {
    let mut list = Vec::new();
    visit_in_one_gear(from, to, radius, &mut All { bound: bound / radius, each: |word| list.push(word) });
    list
}

/// Length of the shortest word, metres: the distance for a car without obstacles. It is a metric, symmetric because
/// every word can be driven backwards.
pub fn distance(from: Pose, to: Pose, radius: f64) -> f64 {
    distance_or(from, to, radius, 0.0)
}

/// Length of the shortest word, metres, or of any word that is at most `enough` long: the caller has a better bound.
///
/// The estimate of hybrid A\* is the larger of this length and of the way around obstacles. Where the latter is larger,
/// it does not matter which short word is found, and the formulas of the others are saved.
pub fn distance_or(from: Pose, to: Pose, radius: f64, enough: f64) -> f64 {
    let mut least = Least { best: f64::INFINITY, enough: enough / radius };
    visit(from, to, radius, &mut least);
    least.best * radius
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::geometry::arcs::{self, Arc};
    use crate::geometry::math::{self, FRAC_PI_2, PI};

    const RADIUS: f64 = 5.408_275_004_188_978;

    fn shortest(from: Pose, to: Pose) -> Word {
        let mut best: Option<Word> = None;
        words(from, to, RADIUS, |w| {
            if best.is_none_or(|b| w.total < b.total) {
                best = Some(w);
            }
        });
        best.unwrap()
    }

    #[test]
    fn the_papers_rows() {
        let rows = [
            ([22.0, 8.19, PI], [2.5, 5.0, -FRAC_PI_2], 22.686_906, 1),
            ([24.0, 8.4, PI], [2.5, 5.0, -FRAC_PI_2], 24.662_625, 1),
            ([-20.0, 14.5, PI], [-7.0, 5.0, -FRAC_PI_2], 22.099_197, 1),
            ([16.0, 18.0, PI], [-2.0, 5.0, -FRAC_PI_2], 23.198_558, 0),
            ([-16.0, 7.5, PI], [7.0, 5.0, -FRAC_PI_2], 27.206_142, 1),
            ([20.0, 19.06, PI], [-3.0, 2.0, PI], 29.199_063, 0),
            ([18.0, 15.7, PI], [-3.0, 2.0, PI], 25.497_961, 0),
            ([16.0, 14.7, PI], [2.0, 2.0, PI], 19.965_808, 0),
            ([19.0, 15.5, PI], [-4.0, 3.0, PI], 26.438_377, 0),
            ([-8.0, 14.2, PI], [7.0, 3.0, PI], 19.383_835, 0),
        ];
        for (a, b, length, changes) in rows {
            let word = shortest(Pose::new(a[0], a[1], a[2]), Pose::new(b[0], b[1], b[2]));
            assert!((word.length(RADIUS) - length).abs() < 1e-6, "{a:?}: {}", word.length(RADIUS));
            assert_eq!(word.direction_changes(), changes, "{a:?}");
        }
    }

    fn random_poses() -> impl FnMut() -> Pose {
        let mut state = 1_u64;
        let mut random = move |low: f64, high: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            low + (high - low) * (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        move || Pose::new(random(-9.0, 9.0), random(-9.0, 9.0), random(-PI, PI))
    }

    /// The word's turns and gears, such as `L+R-L+`.
    fn kind(word: Word) -> String {
        let arc = |i: usize| format!("{:?}{}", word.turns[i], if word.lengths[i] < 0.0 { '-' } else { '+' });
        (0..word.count).map(arc).collect()
    }

    #[test]
    fn every_word_ends_at_the_goal() {
        let mut random = random_poses();
        let mut kinds = BTreeMap::new();
        for _ in 0..20_000 {
            let (from, to) = (random(), random());
            words(from, to, RADIUS, |word| {
                *kinds.entry(kind(word)).or_insert(0) += 1;
                let path: Vec<Arc> = word.arcs(RADIUS).collect();
                let end = arcs::end(from, &path);
                assert!((end.point() - to.point()).norm() < 1e-6, "{word:?}");
                assert!(math::turn(end.heading, to.heading).abs() < 1e-6, "{word:?}");
                assert!((arcs::length(&path) - word.length(RADIUS)).abs() < 1e-6, "{word:?}");
            });
            let (there, back) = (distance(from, to, RADIUS), distance(to, from, RADIUS));
            assert!((there - back).abs() < 1e-6, "{there} {back}");
            assert!(there >= (to.point() - from.point()).norm() - 1e-9);
        }
        // The paper's, each in both directions and on both sides: 48.
        let base = "L+S+L+ L+S+R+ L+R-L+ L+R-L- L-R-L+ L+R+L-R- L+R-L-R+ L+R-S-L- L+R-S-R- L+S+R+L- R+S+R+L- \
            L+R-S-L-R+";
        let swap = |kind: &str, a: char, b: char| -> String {
            kind.chars()
                .map(|c| {
                    if c == a {
                        b
                    } else if c == b {
                        a
                    } else {
                        c
                    }
                })
                .collect()
        };
        let mut all: Vec<String> = Vec::new();
        for kind in base.split(' ') {
            let flipped = swap(kind, '+', '-');
            all.extend([swap(kind, 'L', 'R'), swap(&flipped, 'L', 'R'), kind.to_owned(), flipped]);
        }
        all.sort_unstable();
        assert_eq!(all.len(), 48);
        assert_eq!(kinds.keys().collect::<Vec<_>>(), all.iter().collect::<Vec<_>>());
        assert_eq!(kinds.values().sum::<u32>(), 148_835, "{kinds:?}");
    }

    #[test]
    fn a_bound_leaves_out_what_is_not_shorter() {
        let mut random = random_poses();
        for radius in [0.3, RADIUS] {
            for _ in 0..1000 {
                let (from, to) = (random(), random());
                let mut all = Vec::new();
                words(from, to, radius, |word| all.push(word.length(radius)));
                let sorted = math::sorted_by(&all, |&l| l);
                assert_eq!(distance(from, to, radius), sorted[0]);
                for bound in [sorted[0], sorted[1], sorted[sorted.len() / 2]].map(|length| length + 1e-9) {
                    let mut below = Vec::new();
                    words_below(from, to, radius, bound, |word| below.push(word.length(radius)));
                    let want: Vec<f64> = sorted.iter().copied().filter(|&l| l < bound).collect();
                    assert_eq!(math::sorted_by(&below, |&l| l), want);
                    let enough = distance_or(from, to, radius, bound);
                    assert!(enough <= bound && sorted.contains(&enough), "{enough} {bound}");
                }
                assert_eq!(distance_or(from, to, radius, 0.9 * sorted[0]), sorted[0]);
            }
        }
    }

    #[test]
    fn words_in_one_gear_are_those_without_a_cusp() {
        let mut random = random_poses();
        for _ in 0..2000 {
            let (from, to) = (random(), random());
            for bound in [f64::INFINITY, 20.0] {
                let mut all = list_below(from, to, RADIUS, bound);
                all.retain(|word| word.direction_changes() == 0);
                let letters = |words: &[Word]| -> Vec<(String, u64)> {
                    words.iter().map(|word| (word.letters(), word.total.to_bits())).collect()
                };
                assert_eq!(letters(&list_in_one_gear(from, to, RADIUS, bound)), letters(&all));
            }
        }
    }

    #[test]
    fn where_families_meet_all_have_their_words() {
        // Ahead, along the circle, turned on the spot, to the other lane and round to it; in radii.
        for (x, y, turn, length, count) in [
            (2.5, 0.0, 0.0, 2.5, 10),
            (1.0, 1.0, FRAC_PI_2, FRAC_PI_2, 17),
            (0.0, 0.0, PI, PI, 8),
            (2.0, 2.0, 0.0, PI, 14),
            (0.0, 2.0, PI, PI, 22),
        ] {
            let (from, to) = (Pose::default(), Pose::new(x, y, turn));
            let mut found = 0;
            words(from, to, 1.0, |_| found += 1);
            assert_eq!(found, count, "{to:?}");
            assert!((distance(from, to, 1.0) - length).abs() < 1e-12, "{to:?}");
        }
    }
}
