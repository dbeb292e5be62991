//! Shortest paths without obstacles for a car that drives both ways (Reeds and Shepp 1990).
//!
//! Names and words follow the paper: C and its L, R are circles of the tightest curvature, S is a straight line; lengths
//! t, u, v are in units of the turning radius, negative in reverse. Each word is tried under time flip (driving the
//! other way), reflection (L for R) and, where that gives something new, backwards.

use super::Pose;
use super::arcs::Arc;
use super::math::{self, FRAC_PI_2, PI, TAU};

/// A segment's kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Turn {
    L,
    S,
    R,
}
use Turn::{L, R, S};

const EPS: f64 = 1e-10;

/// A Reeds–Shepp path: at most five arcs, lengths in turning radii.
#[derive(Debug, Clone, Copy)]
pub struct Word {
    turns: [Turn; 5],
    lengths: [f64; 5],
    count: usize,
    total: f64,
}

impl Word {
    /// Length, metres, for turning radius `radius`.
    pub fn length(&self, radius: f64) -> f64 {
        self.total * radius
    }

    /// Its arcs, metres, for turning radius `radius`.
    pub fn arcs(&self, radius: f64) -> impl Iterator<Item = Arc> + use<> {
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

/// All words from `from` to `to` for turning radius `radius`, unordered, handed to `each`.
pub fn words(from: Pose, to: Pose, radius: f64, each: impl FnMut(Word)) {
    let (x, y, phi) = normalise(from, to, radius);
    Families { each }.all(x, y, phi);
}

/// Length of the shortest word, metres.
pub fn distance(from: Pose, to: Pose, radius: f64) -> f64 {
    let mut best = f64::INFINITY;
    words(from, to, radius, |word| best = best.min(word.total));
    best * radius
}

fn normalise(from: Pose, to: Pose, radius: f64) -> (f64, f64, f64) {
    let local = from.to_local(to.point());
    (local.x / radius, local.y / radius, math::turn(from.heading, to.heading))
}

/// A word's family as it is solved: lengths for its turns, or nothing.
type Solve<const N: usize> = fn(f64, f64, f64) -> Option<[f64; N]>;

struct Families<F> {
    each: F,
}

impl<F: FnMut(Word)> Families<F> {
    fn all(&mut self, x: f64, y: f64, phi: f64) {
        self.symmetric(x, y, phi, [L, S, L], lsl, false);
        self.symmetric(x, y, phi, [L, S, R], lsr, false);
        self.symmetric(x, y, phi, [L, R, L], lrl, false);
        self.symmetric(x, y, phi, [L, R, L, R], lrlr_same, false);
        self.symmetric(x, y, phi, [L, R, L, R], lrlr_cusps, false);
        self.symmetric(x, y, phi, [L, R, S, L], lrsl, false);
        self.symmetric(x, y, phi, [L, R, S, R], lrsr, false);
        self.symmetric(x, y, phi, [L, R, S, L, R], lrslr, false);
        let (sin, cos) = math::sin_cos(phi);
        let (xb, yb) = (x * cos + y * sin, x * sin - y * cos);
        self.symmetric(xb, yb, phi, [L, R, L], lrl, true);
        self.symmetric(xb, yb, phi, [L, R, S, L], lrsl, true);
        self.symmetric(xb, yb, phi, [L, R, S, R], lrsr, true);
    }

    fn symmetric<const N: usize>(
        &mut self,
        x: f64,
        y: f64,
        phi: f64,
        turns: [Turn; N],
        solve: Solve<N>,
        backwards: bool,
    ) {
        for (flip, reflect) in [(false, false), (true, false), (false, true), (true, true)] {
            let sx = if flip { -x } else { x };
            let sy = if reflect { -y } else { y };
            let sphi = if flip == reflect { phi } else { -phi };
            let Some(mut lengths) = solve(sx, sy, sphi) else { continue };
            let mut turns = turns;
            if flip {
                lengths = lengths.map(|l| -l);
            }
            if reflect {
                turns = turns.map(mirrored);
            }
            if backwards {
                lengths.reverse();
                turns.reverse();
            }
            (self.each)(word(turns, lengths));
        }
    }
}

fn mirrored(turn: Turn) -> Turn {
    match turn {
        L => R,
        S => S,
        R => L,
    }
}

fn word<const N: usize>(turns: [Turn; N], lengths: [f64; N]) -> Word {
    let mut word = Word { turns: [S; 5], lengths: [0.0; 5], count: N, total: 0.0 };
    word.turns[..N].copy_from_slice(&turns);
    word.lengths[..N].copy_from_slice(&lengths);
    word.total = lengths.iter().map(|l| l.abs()).sum();
    word
}

/// An angle in [−π, π], with −π for both of its ends only where rounding says so.
fn modulo(angle: f64) -> f64 {
    let a = angle % TAU;
    if a < -PI {
        a + TAU
    } else if a > PI {
        a - TAU
    } else {
        a
    }
}

fn polar(x: f64, y: f64) -> (f64, f64) {
    ((x * x + y * y).sqrt(), math::atan2(y, x))
}

/// The vectors A and B of the formulas.
fn centres(x: f64, y: f64, phi: f64) -> ([f64; 2], [f64; 2]) {
    let (sin, cos) = math::sin_cos(phi);
    ([x - sin, y - 1.0 + cos], [x + sin, y - 1.0 - cos])
}

fn positive(v: f64) -> bool {
    v >= -EPS
}

fn negative(v: f64) -> bool {
    v <= EPS
}

fn lsl(x: f64, y: f64, phi: f64) -> Option<[f64; 3]> {
    let (a, _) = centres(x, y, phi);
    let (u, t) = polar(a[0], a[1]);
    let v = modulo(phi - t);
    (positive(t) && positive(v)).then_some([t, u, v])
}

fn lsr(x: f64, y: f64, phi: f64) -> Option<[f64; 3]> {
    let (_, b) = centres(x, y, phi);
    let (u1, t1) = polar(b[0], b[1]);
    let square = u1 * u1 - 4.0;
    if square < 0.0 {
        return None;
    }
    let u = square.sqrt();
    let t = modulo(t1 + math::atan2(2.0, u));
    let v = modulo(t - phi);
    (positive(t) && positive(v)).then_some([t, u, v])
}

fn lrl(x: f64, y: f64, phi: f64) -> Option<[f64; 3]> {
    let (a, _) = centres(x, y, phi);
    let (u1, theta) = polar(a[0], a[1]);
    if u1 > 4.0 {
        return None;
    }
    let u = -2.0 * math::asin(u1 / 4.0);
    let t = modulo(theta + u / 2.0 + PI);
    let v = modulo(phi - t + u);
    (positive(t) && negative(u)).then_some([t, u, v])
}

/// The paper's τ and ω.
fn tau_omega(u: f64, v: f64, xi: f64, eta: f64, phi: f64) -> (f64, f64) {
    let delta = modulo(u - v);
    let a = math::sin(u) - math::sin(delta);
    let b = math::cos(u) - math::cos(delta) - 1.0;
    let t1 = math::atan2(eta * a - xi * b, xi * a + eta * b);
    let t2 = 2.0 * (math::cos(delta) - math::cos(v) - math::cos(u)) + 3.0;
    let tau = if t2 < 0.0 { modulo(t1 + PI) } else { modulo(t1) };
    (tau, modulo(tau - u + v - phi))
}

fn lrlr_same(x: f64, y: f64, phi: f64) -> Option<[f64; 4]> {
    let (_, [xi, eta]) = centres(x, y, phi);
    let rho = (2.0 + (xi * xi + eta * eta).sqrt()) / 4.0;
    if rho > 1.0 {
        return None;
    }
    let u = math::acos(rho);
    let (t, v) = tau_omega(u, -u, xi, eta, phi);
    (positive(t) && negative(v)).then_some([t, u, -u, v])
}

fn lrlr_cusps(x: f64, y: f64, phi: f64) -> Option<[f64; 4]> {
    let (_, [xi, eta]) = centres(x, y, phi);
    let rho = (20.0 - xi * xi - eta * eta) / 16.0;
    if !(0.0..=1.0).contains(&rho) {
        return None;
    }
    let u = -math::acos(rho);
    if u < -FRAC_PI_2 {
        return None;
    }
    let (t, v) = tau_omega(u, u, xi, eta, phi);
    (positive(t) && positive(v)).then_some([t, u, u, v])
}

fn lrsl(x: f64, y: f64, phi: f64) -> Option<[f64; 4]> {
    let (a, _) = centres(x, y, phi);
    let (rho, theta) = polar(a[0], a[1]);
    if rho < 2.0 {
        return None;
    }
    let r = (rho * rho - 4.0).sqrt();
    let u = 2.0 - r;
    let t = modulo(theta + math::atan2(r, -2.0));
    let v = modulo(phi - FRAC_PI_2 - t);
    (positive(t) && negative(u) && negative(v)).then_some([t, -FRAC_PI_2, u, v])
}

fn lrsr(x: f64, y: f64, phi: f64) -> Option<[f64; 4]> {
    let (_, b) = centres(x, y, phi);
    let (rho, t) = polar(-b[1], b[0]);
    if rho < 2.0 {
        return None;
    }
    let u = 2.0 - rho;
    let v = modulo(t + FRAC_PI_2 - phi);
    (positive(t) && negative(u) && negative(v)).then_some([t, -FRAC_PI_2, u, v])
}

fn lrslr(x: f64, y: f64, phi: f64) -> Option<[f64; 5]> {
    let (_, [xi, eta]) = centres(x, y, phi);
    let (rho, _) = polar(xi, eta);
    if rho < 2.0 {
        return None;
    }
    let u = 4.0 - (rho * rho - 4.0).sqrt();
    if u > 0.0 {
        return None;
    }
    let t = modulo(math::atan2((4.0 - u) * xi - 2.0 * eta, -2.0 * xi + (u - 4.0) * eta));
    let v = modulo(t - phi);
    (positive(t) && positive(v)).then_some([t, -FRAC_PI_2, u, -FRAC_PI_2, v])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::arcs;

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

    #[test]
    fn every_word_ends_at_the_goal() {
        let mut state = 1_u64;
        let mut random = |low: f64, high: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            low + (high - low) * (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut families = 0;
        for _ in 0..20_000 {
            let from = Pose::new(random(-9.0, 9.0), random(-9.0, 9.0), random(-PI, PI));
            let to = Pose::new(random(-9.0, 9.0), random(-9.0, 9.0), random(-PI, PI));
            words(from, to, RADIUS, |word| {
                families += 1;
                let path: Vec<Arc> = word.arcs(RADIUS).collect();
                let end = arcs::end(from, &path);
                assert!((end.point() - to.point()).norm() < 1e-6, "{word:?}");
                assert!(math::turn(end.heading, to.heading).abs() < 1e-6, "{word:?}");
            });
            let (there, back) = (distance(from, to, RADIUS), distance(to, from, RADIUS));
            assert!((there - back).abs() < 1e-6, "{there} {back}");
            assert!(there >= (to.point() - from.point()).norm() - 1e-9);
        }
        assert!(families > 100_000, "{families}");
    }
}
