//! A word: its segments, and what follows from them.
//!
//! A word is up to five arcs and straight lines, at full lock or straight, in either gear. Nine shapes are enough:
//! all other words are these driven backwards in time (every gear turned round), mirrored (left for right), or both.
//! Lengths are in radii, that is radians on an arc, with the gear as their sign.

use crate::geometry::arcs::Arc;

/// Lengths and angles this far on the wrong side of a bound are on it.
pub(super) const EPS: f64 = 1e-10;

/// A segment's kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Turn {
    L,
    S,
    R,
}
use Turn::{L, R, S};

/// A word's turns, before reflection.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    Lsl,
    Lsr,
    Lrl,
    Lrlr,
    Lrsl,
    Lsrl,
    Lrsr,
    Rsrl,
    Lrslr,
}

impl Shape {
    /// The shape's arcs as left, straight and right, padded to five, and how many count.
    const fn turns(self) -> ([Turn; 5], usize) {
        match self {
            Self::Lsl => ([L, S, L, S, S], 3),
            Self::Lsr => ([L, S, R, S, S], 3),
            Self::Lrl => ([L, R, L, S, S], 3),
            Self::Lrlr => ([L, R, L, R, S], 4),
            Self::Lrsl => ([L, R, S, L, S], 4),
            Self::Lsrl => ([L, S, R, L, S], 4),
            Self::Lrsr => ([L, R, S, R, S], 4),
            Self::Rsrl => ([R, S, R, L, S], 4),
            Self::Lrslr => ([L, R, S, L, R], 5),
        }
    }
}

/// A Reeds–Shepp path: at most five segments, lengths in turning radii, negative in reverse.
///
/// It is small and `Copy`: a search makes dozens per expansion and keeps the one that completes its path.
#[derive(Debug, Clone, Copy)]
pub struct Word {
    pub(super) turns: [Turn; 5],
    pub(super) lengths: [f64; 5],
    pub(super) count: usize,
    pub(super) total: f64,
}

impl Word {
    /// A word of a shape's signed lengths, whose sum without signs is `total`. `flip` drives the mirror image in time,
    /// with every gear the other one; `reflect` the mirror image in space, with left and right exchanged.
    pub(super) fn new(shape: Shape, flip: bool, reflect: bool, lengths: [f64; 5], total: f64) -> Self {
        let (turns @ [a, b, c, d, e], count) = shape.turns();
        let [t, u, v, w, x] = lengths;
        Self {
            turns: if reflect {
                [mirrored(a), mirrored(b), mirrored(c), mirrored(d), mirrored(e)]
            } else {
                turns
            },
            lengths: if flip { [-t, -u, -v, -w, -x] } else { lengths },
            count,
            total,
        }
    }

    /// Length, metres, for turning radius `radius`.
    pub fn length(&self, radius: f64) -> f64 {
        self.total * radius
    }

    /// Its arcs, metres, for turning radius `radius`.
    pub fn arcs(&self, radius: f64) -> impl DoubleEndedIterator<Item = Arc> + use<> {
        let (turns, lengths) = (self.turns, self.lengths);
        (0..self.count).filter(move |&i| lengths[i].abs() > EPS).map(move |i| {
            let curvature = match turns[i] {
                L => 1.0 / radius,
                S => 0.0,
                R => -1.0 / radius,
            };
            Arc { curvature, length: lengths[i] * radius }
        })
    }

    /// Its arcs as letters: `L` left, `S` straight, `R` right, each with `+` ahead or `-` in reverse.
    pub fn letters(&self) -> String {
        let driven = self.turns.iter().zip(&self.lengths).take(self.count).filter(|(_, l)| l.abs() > EPS);
        driven.fold(String::new(), |mut text, (turn, &length)| {
            text.push(match turn {
                L => 'L',
                S => 'S',
                R => 'R',
            });
            text.push(if length < 0.0 { '-' } else { '+' });
            text
        })
    }

    /// Gear changes within it.
    pub fn direction_changes(&self) -> u32 {
        let mut gear = 0.0_f64;
        let mut changes = 0;
        for &length in self.lengths[..self.count].iter().filter(|l| l.abs() > EPS) {
            changes += u32::from(gear * length < 0.0);
            gear = length;
        }
        changes
    }
}

/// The length of a word, in radii.
#[inline(always)]
pub(super) fn total(lengths: [f64; 5]) -> f64 {
    lengths.iter().map(|l| l.abs()).sum()
}

fn mirrored(turn: Turn) -> Turn {
    match turn {
        L => R,
        S => S,
        R => L,
    }
}
