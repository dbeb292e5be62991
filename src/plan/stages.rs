//! A grid path after each post-processing step, as the risk-field paper's figures 5 to 7 draw it.
//!
//! Kept only with a trace, because a plan answers one path and the others are for the eye. The arcs are told by their
//! tangent points, which a drawing needs: an arc of radius R over the change of heading β begins R·tan(β/2) before the
//! corner.

use serde::Serialize;

use crate::geometry::{Point, math};
use crate::map::{Cell, Frame};
use crate::post::{Piece, Smoothed};

/// Corners nearer to each other than this are one, cells.
const SAME: f64 = 1e-6;

/// A path's stages after the search; [`super::Plan::raw_path`] is what they begin with. Metres.
///
/// World frame. `sharp` and the corners of `arcs` together are all corners of `pruned`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stages {
    /// Corners that remain after pruning, ends included.
    pub pruned: Vec<[f64; 2]>,
    /// The shortest way over the same cells.
    pub shortest: Vec<[f64; 2]>,
    /// The arcs of smoothing, in the order of the path.
    pub arcs: Vec<TangentArc>,
    /// Corners of the pruned path that no arc rounds.
    pub sharp: Vec<[f64; 2]>,
}

/// An arc in the place of a corner: it touches both segments.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TangentArc {
    /// The corner that it rounds.
    pub corner: [f64; 2],
    /// Point at which the arc leaves the previous segment.
    pub from: [f64; 2],
    /// Point at which the arc meets the next segment.
    pub to: [f64; 2],
    /// The circle's centre.
    pub center: [f64; 2],
    /// The circle's radius.
    pub radius: f64,
}

impl Stages {
    /// The stages in metres. A corner is sharp if the path turns there and no arc rounds it.
    pub(super) fn new(frame: &Frame, pruned: &[Cell], shortest: &[Cell], smoothed: &Smoothed) -> Self {
        let pair = |p: Point| [p.x, p.y];
        let points = |cells: &[Cell]| cells.iter().map(|&c| pair(frame.center(c))).collect();
        let arcs: Vec<_> = smoothed.pieces.iter().filter_map(|piece| tangent(frame, piece)).collect();
        let is_rounded =
            |p: &Point| arcs.iter().any(|arc| (Point::from(arc.corner) - p).norm() < SAME * frame.resolution);
        // Pruning may keep a cell in the middle of a straight line.
        let turns = |w: &&[Cell]| {
            let [(ax, ay), (bx, by)] =
                [(w[1].x - w[0].x, w[1].y - w[0].y), (w[2].x - w[1].x, w[2].y - w[1].y)];
            ax * by != ay * bx || ax * bx + ay * by < 0
        };
        let corners = pruned.windows(3).filter(turns).map(|w| frame.center(w[1]));
        let sharp = corners.filter(|p| !is_rounded(p)).map(pair).collect();
        Self { pruned: points(pruned), shortest: points(shortest), arcs, sharp }
    }
}

/// The arc of a piece in metres; `None` for a straight one. The corner is where the tangents at both ends meet.
fn tangent(frame: &Frame, piece: &Piece) -> Option<TangentArc> {
    let &Piece::Arc { center, radius, sweep, .. } = piece else { return None };
    let (from, (sin, cos)) = (piece.point(0.0), math::sin_cos(piece.heading(0.0)));
    let tangent = radius * math::tan(sweep.abs() / 2.0);
    let world = |p: [f64; 2]| {
        let p = frame.world(p);
        [p.x, p.y]
    };
    Some(TangentArc {
        corner: world([from[0] + tangent * cos, from[1] + tangent * sin]),
        from: world(from),
        to: world(piece.point(1.0)),
        center: world(center),
        radius: radius * frame.resolution,
    })
}

#[cfg(test)]
mod tests {
    use crate::geometry::Point;
    use crate::plan::{Options, Planner};
    use crate::scenario::catalog;

    /// Every arc touches both of its segments at right angles to its radius, and every corner is rounded or told.
    #[test]
    fn arcs_touch_their_segments_and_no_corner_is_lost() {
        for id in ["fig8-30", "fig9-60", "P4", "regular-60"] {
            let scene = catalog::scenario(id).unwrap();
            let mut planner = Planner::new("risk-field", &scene, &serde_json::Map::new()).unwrap();
            assert!(planner.plan(Options::default()).stages.is_none());
            let plan = planner.plan(Options { trace: true, ..Options::default() });
            let stages = plan.stages.unwrap();
            let grid = plan.metrics.grid.unwrap();
            assert_eq!(
                (stages.arcs.len(), stages.sharp.len()),
                (grid.arcs as usize, grid.sharp_corners as usize),
                "{id}"
            );
            assert!(stages.pruned.len() >= stages.arcs.len() + stages.sharp.len() + 2, "{id}");
            let at = |p: [f64; 2]| Point::new(p[0], p[1]);
            let length =
                |points: &[[f64; 2]]| points.windows(2).map(|w| (at(w[1]) - at(w[0])).norm()).sum::<f64>();
            let scale = scene.map.resolution;
            assert!((length(&stages.pruned) - grid.length_pruned * scale).abs() < 1e-9, "{id}");
            assert!((length(&stages.shortest) - grid.length_dp * scale).abs() < 1e-9, "{id}");
            for arc in &stages.arcs {
                assert!(
                    stages.pruned.iter().any(|p| (at(*p) - at(arc.corner)).norm() < 1e-6 * scale),
                    "{id} {arc:?}"
                );
                for end in [arc.from, arc.to] {
                    assert!(((at(end) - at(arc.center)).norm() - arc.radius).abs() < 1e-9, "{id} {arc:?}");
                    assert!(
                        (at(end) - at(arc.center)).dot(&(at(end) - at(arc.corner))).abs() < 1e-6,
                        "{id} {arc:?}"
                    );
                }
            }
        }
    }
}
