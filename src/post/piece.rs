//! Straight pieces and arcs, of which a smoothed path is made.
//!
//! Arcs are stored by centre, start angle and sweep, because each query is then one sine and one cosine: a point of the
//! arc at share u is `centre + R·(cos(α + u·sweep), sin(α + u·sweep))`. Angles are counter-clockwise from +x, as
//! headings are.

use crate::geometry::math;

/// A piece of a path. Cells, radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Piece {
    /// A straight piece.
    Line {
        /// Start point, cells.
        from: [f64; 2],
        /// End point, cells.
        to: [f64; 2],
    },
    /// A piece of a circle.
    Arc {
        /// The circle's centre.
        center: [f64; 2],
        /// The circle's radius.
        radius: f64,
        /// Direction from the centre to where the arc begins.
        start_angle: f64,
        /// Angle it covers, positive to the left.
        sweep: f64,
    },
}

impl Piece {
    /// The straight pieces along a row of points.
    ///
    /// A row of n points gives n − 1 pieces; none for fewer than two points.
    pub fn lines(points: &[[f64; 2]]) -> Vec<Self> {
        points.windows(2).map(|pair| Self::Line { from: pair[0], to: pair[1] }).collect()
    }

    /// The points of pieces that join, those of arcs at most `step` apart.
    ///
    /// The ends of every piece are among the points. A straight piece adds its end only, so `step` (cells, positive)
    /// bounds the distance on arcs alone. The chords of an arc of radius R stray by step²/(8R) cells at most.
    ///
    /// # Examples
    /// ```
    /// use parkade::post::Piece;
    ///
    /// let sweep = std::f64::consts::FRAC_PI_2;
    /// let quarter = Piece::Arc { center: [0.0, 0.0], radius: 2.0, start_angle: 0.0, sweep };
    /// let points = Piece::polyline(&[quarter], 0.5);
    /// assert_eq!(points.len(), 8);
    /// assert!((points[7][1] - 2.0).abs() < 1e-12);
    /// ```
    pub fn polyline(pieces: &[Self], step: f64) -> Vec<[f64; 2]> {
        let mut points: Vec<_> = pieces.first().map(|first| first.point(0.0)).into_iter().collect();
        for piece in pieces {
            let parts = match piece {
                Self::Line { .. } => 1,
                Self::Arc { .. } => (piece.length() / step).ceil().max(1.0) as u32,
            };
            points.extend((1..=parts).map(|k| piece.point(f64::from(k) / f64::from(parts))));
        }
        points
    }

    /// Its length. Cells.
    pub fn length(&self) -> f64 {
        match *self {
            Self::Line { from, to } => distance(from, to),
            Self::Arc { radius, sweep, .. } => radius * sweep.abs(),
        }
    }

    /// Signed curvature, 1/cells, left positive; 0 on a line.
    pub fn curvature(&self) -> f64 {
        match *self {
            Self::Line { .. } => 0.0,
            Self::Arc { radius, sweep, .. } => sweep.signum() / radius,
        }
    }

    /// The point at a share of its length, 0 at the beginning and 1 at the end.
    pub fn point(&self, share: f64) -> [f64; 2] {
        match *self {
            Self::Line { from, to } => {
                [from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share]
            }
            Self::Arc { center, radius, start_angle, sweep } => {
                let (sin, cos) = math::sin_cos(start_angle + sweep * share);
                [center[0] + radius * cos, center[1] + radius * sin]
            }
        }
    }

    /// The heading at a share of its length, radians in (−π, π].
    ///
    /// On an arc it is the tangent in the direction of travel: a quarter turn to the left of the radius where the arc
    /// turns left, to the right otherwise.
    pub fn heading(&self, share: f64) -> f64 {
        match *self {
            Self::Line { from, to } => math::atan2(to[1] - from[1], to[0] - from[0]),
            Self::Arc { start_angle, sweep, .. } => {
                math::wrap(start_angle + sweep * share + math::FRAC_PI_2.copysign(sweep))
            }
        }
    }
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_circle_to_the_right() {
        let arc = Piece::Arc {
            center: [0.0, 0.0],
            radius: 2.0,
            start_angle: math::FRAC_PI_2,
            sweep: -math::FRAC_PI_2,
        };
        assert!((arc.length() - math::PI).abs() < 1e-12);
        assert_eq!((arc.curvature(), arc.heading(0.0)), (-0.5, 0.0));
        assert!((arc.heading(1.0) + math::FRAC_PI_2).abs() < 1e-12);
        assert!(distance(arc.point(1.0), [2.0, 0.0]) < 1e-12);
    }

    #[test]
    fn pieces_become_points() {
        let lines = Piece::lines(&[[0.0, 0.0], [3.0, 4.0], [3.0, 0.0]]);
        assert_eq!(lines.iter().map(Piece::length).collect::<Vec<_>>(), [5.0, 4.0]);
        let arc = Piece::Arc {
            center: [3.0, 2.0],
            radius: 2.0,
            start_angle: -math::FRAC_PI_2,
            sweep: math::FRAC_PI_2,
        };
        let points = Piece::polyline(&[lines[0], lines[1], arc], 0.9);
        assert_eq!(points[..3], [[0.0, 0.0], [3.0, 4.0], [3.0, 0.0]]);
        assert_eq!(points.len(), 3 + 4);
        for (k, point) in points[2..].iter().enumerate() {
            assert!(distance(*point, arc.point(k as f64 / 4.0)) < 1e-12);
        }
        assert!(Piece::polyline(&[], 0.9).is_empty());
    }
}
