//! Where a point is on lanes, and how fast it may be passed.
//!
//! A lane is a chain of lines and arcs. The distance from a point to one of them is closed form: along a line the
//! point's ordinate, along an arc of radius r about the centre c the difference ||p − c| − r|, beyond their ends the
//! distance to an end point. Lateral positions are signed, positive to the left of the lane's direction.
//!
//! A look-up is O(pieces). Rasters ask for each cell once, and keep the answers.

use super::{Lane, SpeedLimit};
use crate::geometry::{Point, Pose, Vector, math, polygon};

/// A piece of a lane's middle at its place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LaneLeg {
    from: Pose,
    /// Metres.
    length: f64,
    /// 1/m, positive to the left.
    pub(crate) curvature: f64,
    /// Half the lane's width, metres.
    pub(crate) half_width: f64,
}

impl LaneLeg {
    /// The pieces of all lanes.
    pub(crate) fn all(lanes: &[Lane]) -> Vec<Self> {
        let legs = |lane: &Lane| {
            let half_width = lane.width / 2.0;
            lane.legs().into_iter().map(move |(from, piece)| Self {
                from,
                length: piece.length,
                curvature: piece.curvature,
                half_width,
            })
        };
        lanes.iter().flat_map(legs).collect()
    }

    /// The leg whose middle is nearest to a point, and how far it is, metres.
    pub(crate) fn nearest(legs: &[Self], point: Point) -> Option<(&Self, f64)> {
        let mut best: Option<(&Self, f64)> = None;
        for leg in legs {
            let away = leg.distance(point);
            if best.is_none_or(|b| away < b.1) {
                best = Some((leg, away));
            }
        }
        best
    }

    /// How far to the left of its middle a point is, metres; below zero to the right.
    /// Only meaningful beside the leg, not beyond its ends.
    pub(crate) fn left(&self, point: Point) -> f64 {
        let local = self.from.to_local(point);
        if self.curvature == 0.0 {
            return local.y;
        }
        let radius = self.curvature.recip();
        radius - self.curvature.signum() * Point::new(local.x, local.y - radius).coords.norm()
    }

    /// The distance from a point to the leg, metres.
    fn distance(&self, point: Point) -> f64 {
        let &Self { from, length, curvature, .. } = self;
        if curvature == 0.0 {
            let local = from.to_local(point);
            let ahead = local.x.clamp(0.0, length);
            return (local - Point::new(ahead, 0.0)).norm();
        }
        let center = from.to_world(Point::new(0.0, 1.0 / curvature));
        let (a, b): (Vector, Vector) = (from.point() - center, point - center);
        // How far round, along the arc.
        let turned = math::atan2(a.perp(&b), a.dot(&b)) * curvature.signum();
        let turned = if turned < 0.0 { turned + math::TAU } else { turned };
        if turned * curvature.abs().recip() <= length {
            return (b.norm() - 1.0 / curvature.abs()).abs();
        }
        let end = from.advance(curvature, length);
        (point - from.point()).norm().min((point - end.point()).norm())
    }
}

impl SpeedLimit {
    /// The lowest limit at a point, m/s; infinite without one.
    pub(crate) fn lowest_at(limits: &[Self], point: Point) -> f64 {
        let here = limits.iter().filter(|limit| polygon::contains(&limit.points, point));
        here.fold(f64::INFINITY, |low, limit| low.min(limit.speed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bend_is_as_far_as_its_nearest_point() {
        let quarter = 10.0 * math::FRAC_PI_2;
        let left =
            LaneLeg { from: Pose::new(0.0, 0.0, 0.0), length: quarter, curvature: 0.1, half_width: 2.0 };
        assert!((left.distance(Point::new(0.0, 3.0)) - 3.0).abs() < 1e-12);
        let diagonal = Point::new(20.0 * math::sin(0.5), 10.0 - 20.0 * math::cos(0.5));
        assert!((left.distance(diagonal) - 10.0).abs() < 1e-12);
        assert!((left.distance(Point::new(-3.0, 0.0)) - 3.0).abs() < 1e-12);
        let right = LaneLeg { curvature: -0.1, ..left };
        assert!((right.distance(Point::new(10.0, -12.0)) - 2.0).abs() < 1e-9);
        // Outside of a left bend is to its right.
        assert!((left.left(diagonal) + 10.0).abs() < 1e-12);
        assert!((right.left(Point::new(0.0, 3.0)) - 3.0).abs() < 1e-12);
    }
}
