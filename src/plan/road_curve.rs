//! The curve of a road plan: smooth, as cheap as the search's costs allow, and with the margin around the whole car.
//!
//! Smoothing chords and then checking would waste most curves: a curve strays from its chords where they turn, and the
//! towed car strays from the curve. So the curve is found by iteration:
//!
//! 1. a spline near the chords, in the car's headings at the ends where it can take them;
//! 2. along it, stations with places to either side; dynamic programming over places and slopes picks the cheapest row,
//!    with a price for room that lacks ([`Lateral`]);
//! 3. a spline through that row, closer than the first;
//! 4. the car is towed along it and the room around its exact body measured;
//! 5. where the margin is missing, more room is asked for at the nearest stations, and 2 to 4 repeat, [`ROUNDS`] times
//!    at most;
//! 6. where the best curve still lacks room, its control points are moved: they shift or turn the car by what it lacks.
//!
//! Of all curves the best is kept by three criteria in this order: it arrives in the goal's direction, it has more of
//! the margin, it costs less. So a further round never makes the answer worse.

use std::ops::Range;

use super::tractrix::tractrix;
use super::world::World;
use crate::geometry::bspline::{CurvePoint, Spline};
use crate::geometry::{Point, Pose, Vector, math};
use crate::metrics::check::HEADING_TOLERANCE;
use crate::planners::cost_map::{CostMap, Lateral, RoadRasters, Smooth, Smoothing, Station, dense, smooth};

/// The body is tested at places of a curve this far apart, metres.
const STATION: f64 = 0.25;
/// The room around it at this.
const ROOMS: f64 = 0.5;
/// How much more a curve may cost by weights than its chords. Chords are the cheapest by the weights; a curve cannot
/// keep to them exactly.
const DEARER: f64 = 1.05;
/// Nearer to the ends of a curve only its raster clearance counts, metres.
pub(super) const ENDS: f64 = 5.0;
/// Cosine of the angle up to which a curve takes the car's heading at an end.
const ALIGNED: f64 = 0.7;
/// The same of the angle between the heading and the first chord.
const FORWARD: f64 = 0.5;
/// A curve strays from a line that is smooth already by this share of what it may stray from chords.
const CLOSER: f64 = 0.7;
/// Rows of places tried for a curve that keeps the margin. Few roads need more, which moves do in less time: of 120
/// roads by seed 88 keep it after eight rows without moves, 101 after six and moves.
const ROUNDS: u32 = 6;
/// Curves tried by moving the best of them, and the least share of a move that is tried.
const MOVES: u32 = 16;
const LEAST_SHARE: f64 = 0.1;
/// Room that moves ask for beyond what lacks, metres.
const SPARE_MOVE: f64 = 2e-3;
/// So near to the ends moved curves keep the margin: the check begins between two places, metres.
const NEAR_ENDS: f64 = ENDS - ROOMS;
/// Beyond the car's ends moves fade out over this distance, metres.
const FADE: f64 = 8.0;
/// Clearances this much below the margin count as keeping it, metres.
const MARGIN_TOLERANCE: f64 = 1e-3;
/// Extra clearance requested at a station that lacked clearance, metres.
const SPARE: f64 = 0.02;
/// And not only there but at so many stations around.
const AROUND: usize = 1;
/// But no more than this beyond the margin, metres.
const MOST_MORE: f64 = 0.5;

/// The input of a curve.
pub(super) struct Curve<'a> {
    pub(super) world: &'a World,
    pub(super) ground: &'a RoadRasters,
    pub(super) costs: &'a CostMap,
    pub(super) how: Smoothing,
}

/// A curve and what it is worth.
///
/// Candidates are compared by [`Candidate::is_better_than`], which is no total order because of the tolerance.
#[derive(Clone)]
struct Candidate {
    spline: Spline,
    /// True if the car ends in the direction that is asked for.
    arrives: bool,
    /// Room around the towed car, at most the margin, metres.
    kept: f64,
    cost: f64,
}

impl Candidate {
    /// Room that differs by less than the tolerance is equal, and the cost decides.
    fn is_better_than(&self, other: &Self) -> bool {
        if self.arrives != other.arrives {
            return self.arrives;
        }
        let more = self.kept - other.kept;
        more > MARGIN_TOLERANCE || (more > -MARGIN_TOLERANCE && self.cost < other.cost)
    }
}

impl Curve<'_> {
    /// A curve near the chords' ends; `None` where none is good enough, or where a straight line is.
    ///
    /// The second item is true if smoothing gave up, and the chords have to serve.
    pub(super) fn along(&self, chords: &[Point], is_straight: bool) -> (Option<Spline>, bool) {
        let accept = |spline: &Spline| self.is_clear(spline) && self.is_cheap(chords, spline);
        let first = self.first(chords, &accept);
        if first.fell_back || is_straight && self.rooms(&straight(chords)).0.iter().all(|r| self.is_kept(r.1))
        {
            return (first.spline, first.fell_back);
        }
        let room = |point: Point| {
            self.world.body.point_clearance(point, self.how.radius + self.how.margin + 2.0) - self.how.radius
        };
        let lateral = Lateral {
            room: &room,
            ground: self.ground,
            costs: self.costs,
            radius: self.how.radius,
            half_length: self.world.geometry.vehicle.length() / 2.0,
            scale: self.how.scale,
        };
        let mut stations = stations(first.spline.as_ref(), chords, lateral.step());
        let sigma = self.how.sigma * CLOSER;
        let ways = self.ways(&stations);
        let how = Smoothing { ways: ways.map(Some), close: true, sigma, ..self.how };
        let mut asked = vec![self.how.margin; stations.len()];
        let mut best = first.spline.map(|spline| self.candidate(spline, &lateral).0);
        for round in 0..ROUNDS {
            let line = lateral.line(&stations, &asked, ways, round > 0);
            let Some(spline) = smooth(self.ground, &line.points, &line.firm, &how, accept).spline else {
                break;
            };
            // The next line is looked for beside this one, on which the car stands as it will there.
            stations = along_curve(&spline, lateral.step());
            let (next, rooms) = self.candidate(spline, &lateral);
            let is_done = self.is_done(&next);
            if best.as_ref().is_none_or(|best| next.is_better_than(best)) {
                best = Some(next);
            }
            if is_done {
                break;
            }
            asked = self.asked(&asked, &stations, &rooms);
        }
        let moved = |best: Candidate| self.moved(best.spline, &lateral, &accept);
        (best.map(moved), false)
    }

    /// A curve moved and turned where the car on it lacks room, [`MOVES`] times at most, as far as less room
    /// lacks in all; else the moves are made smaller. The best of all these curves.
    fn moved(&self, spline: Spline, lateral: &Lateral, accept: &dyn Fn(&Spline) -> bool) -> Spline {
        let (mut best, mut rooms) = self.measured(spline, lateral);
        let mut last = best.clone();
        let mut share = 1.0;
        for _ in 0..MOVES {
            if self.is_done(&best) || share < LEAST_SHARE {
                break;
            }
            let moves = self.moves(&last.spline, &rooms);
            let (next, around) = self.measured(last.spline.moved(|i| moves[i] * share), lateral);
            if self.lacking(&around) >= self.lacking(&rooms) {
                share /= 4.0;
                continue;
            }
            if last.arrives && !next.arrives || !self.bends(&next.spline) || !accept(&next.spline) {
                share /= 2.0;
                continue;
            }
            if next.is_better_than(&best) {
                best = next.clone();
            }
            (last, rooms) = (next, around);
            share = (share * 2.0).min(1.0);
        }
        best.spline
    }

    /// Room that lacks along a curve, summed over its places, metres.
    fn lacking(&self, rooms: &[(Point, f64)]) -> f64 {
        rooms[inner(rooms, NEAR_ENDS)].iter().map(|room| (self.how.margin - room.1).max(0.0)).sum()
    }

    /// True if no place of a curve is too tight for the car.
    fn bends(&self, spline: &Spline) -> bool {
        let count = spline.places().len() * 4;
        (0..=count).all(|k| spline.at(k as f64 / count as f64).curvature().abs() <= self.how.max_curvature)
    }

    /// Per control point of a curve, how far it shall move for the car to have the margin, metres. Where the car lacks
    /// room it is shifted or turned about its middle by as much, whichever gains the most.
    fn moves(&self, spline: &Spline, rooms: &[(Point, f64)]) -> Vec<Vector> {
        let vehicle = &self.world.geometry.vehicle;
        let half = vehicle.length() / 2.0;
        let reach = half + FADE * self.how.scale;
        let places = along(spline, ROOMS * self.how.scale);
        let towed = tractrix(&self.world.geometry, &places);
        let room = |middle: Point, heading: f64| {
            let pose = Pose::new(middle.x, middle.y, heading).advance(0.0, -vehicle.middle());
            self.world.body.signed_clearance(pose, self.how.margin)
        };
        let controls = spline.places();
        let mut moves = vec![0.0_f64; controls.len()];
        for i in inner(rooms, NEAR_ENDS) {
            let (middle, now) = rooms[i];
            let short = self.how.margin - now;
            if short <= 0.0 {
                continue;
            }
            let heading = towed.poses[i].heading;
            let way = towed.poses[i].direction();
            let tries = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)].map(|(shift, turn)| {
                let middle = middle + Vector::new(-way.y, way.x) * (shift * short);
                (room(middle, heading + turn * short / half), shift, turn)
            });
            let (_, shift, turn) = tries
                .into_iter()
                .fold((now, 0.0, 0.0), |best, next| if next.0 > best.0 { next } else { best });
            for (control, moved) in controls.iter().zip(&mut moves) {
                let away = control.point - middle;
                if away.norm() > reach {
                    continue;
                }
                let ahead = away.dot(&way) / half;
                let fade = ((reach - away.norm()) / (reach - half)).min(1.0);
                let by = (short + SPARE_MOVE) * fade * (shift + turn * ahead.clamp(-1.0, 1.0));
                if by.abs() > moved.abs() {
                    *moved = by;
                }
            }
        }
        let left = |(place, by): (&CurvePoint, f64)| {
            let way = place.first.normalize();
            Vector::new(-way.y, way.x) * by
        };
        controls.iter().zip(moves).map(left).collect()
    }

    /// True if a curve arrives and keeps the margin.
    fn is_done(&self, candidate: &Candidate) -> bool {
        candidate.arrives && self.is_kept(candidate.kept)
    }

    /// A curve with its figures and rooms, as near to the ends as the check counts them.
    fn measured(&self, spline: Spline, lateral: &Lateral) -> (Candidate, Vec<(Point, f64)>) {
        self.candidate_at(spline, lateral, NEAR_ENDS)
    }

    /// In the car's headings at the ends where that is possible.
    fn first(&self, chords: &[Point], accept: &dyn Fn(&Spline) -> bool) -> Smooth {
        let is_bent = chords.len() > 2 && self.how.ways == [None; 2];
        let ends = [self.world.geometry.start, self.world.geometry.goal].map(Pose::direction);
        let own = [chords[1] - chords[0], chords[chords.len() - 1] - chords[chords.len() - 2]];
        let ways = [0, 1].map(|i| (ends[i].dot(&own[i].normalize()) > FORWARD).then_some(ends[i]));
        if is_bent && ways != [None; 2] {
            let curve = smooth(self.ground, chords, &[], &Smoothing { ways, ..self.how }, accept);
            if !curve.fell_back {
                return curve;
            }
        }
        smooth(self.ground, chords, &[], &self.how, accept)
    }

    /// The directions at the ends: the car's where the curve hardly turns from them, else the curve's.
    fn ways(&self, stations: &[Station]) -> [Vector; 2] {
        let ends = [self.world.geometry.start, self.world.geometry.goal].map(Pose::direction);
        let own = [stations[0].way, stations[stations.len() - 1].way];
        [0, 1].map(|i| if ends[i].dot(&own[i]) > ALIGNED { ends[i] } else { own[i] })
    }

    /// True if a room is the margin, within [`MARGIN_TOLERANCE`].
    fn is_kept(&self, room: f64) -> bool {
        room >= self.how.margin - MARGIN_TOLERANCE
    }

    /// A curve with its figures, and the rooms along it for the next round. The cost is the integral of the cost per
    /// metre, by the middles of short chords.
    fn candidate(&self, spline: Spline, lateral: &Lateral) -> (Candidate, Vec<(Point, f64)>) {
        self.candidate_at(spline, lateral, ENDS)
    }

    /// Drives the towed car along a spline and measures the room that it keeps, the heading in which it arrives, and
    /// the cost of its metres by the lateral costs.
    fn candidate_at(&self, spline: Spline, lateral: &Lateral, ends: f64) -> (Candidate, Vec<(Point, f64)>) {
        let places = along(&spline, ROOMS * self.how.scale);
        let (rooms, last) = self.rooms(&places);
        let off = math::turn(last, self.world.geometry.goal.heading).abs();
        let kept = rooms[inner(&rooms, ends)].iter().fold(self.how.margin, |least, room| least.min(room.1));
        let metre = |w: &[(Point, Vector)]| {
            (w[1].0 - w[0].0).norm() * lateral.metre(nalgebra::center(&w[0].0, &w[1].0))
        };
        let cost = places.windows(2).map(metre).sum();
        (Candidate { spline, arrives: off <= HEADING_TOLERANCE, kept, cost }, rooms)
    }

    /// Positions of the car's middle with the clearance of the car there, and its heading at last.
    fn rooms(&self, places: &[(Point, Vector)]) -> (Vec<(Point, f64)>, f64) {
        let towed = tractrix(&self.world.geometry, places);
        // More than the margin is not asked for.
        let most = self.how.margin + MOST_MORE;
        let room = |pose: &Pose| self.world.body.signed_clearance(*pose, most);
        let rooms = places.iter().zip(&towed.poses).map(|(place, pose)| (place.0, room(pose))).collect();
        (rooms, towed.poses.last().map_or(0.0, |pose| pose.heading))
    }

    /// Clearances to request at new stations: those of the last round, raised where they were not reached.
    fn asked(&self, before: &[f64], stations: &[Station], rooms: &[(Point, f64)]) -> Vec<f64> {
        let mut short = vec![0.0_f64; stations.len()];
        let mut near = 0;
        for (point, room) in rooms[inner(rooms, ENDS)].iter().filter(|room| !self.is_kept(room.1)) {
            let away = |i: usize| (stations[i].point - point).norm();
            while near + 1 < stations.len() && away(near + 1) <= away(near) {
                near += 1;
            }
            short[near] = short[near].max(self.how.margin - room + SPARE);
        }
        let scale = before.len() as f64 / stations.len() as f64;
        let ask = |i: usize| {
            let around = &short[i.saturating_sub(AROUND)..(i + AROUND + 1).min(short.len())];
            let missing = around.iter().fold(0.0, |most: f64, s| most.max(*s));
            let old = before[((i as f64 * scale) as usize).min(before.len() - 1)];
            (old + missing).min(self.how.margin + MOST_MORE)
        };
        (0..stations.len()).map(ask).collect()
    }

    /// True if the curve costs hardly more than the chords, where cells have weights: it strays from them by
    /// decimetres.
    fn is_cheap(&self, chords: &[Point], spline: &Spline) -> bool {
        let Some(paint) = self.world.paint() else { return true };
        let cost = |points: &[Point]| points.windows(2).fold(0.0, |sum, w| sum + paint.along(w[0], w[1]));
        let places: Vec<Point> = along(spline, STATION).into_iter().map(|place| place.0).collect();
        cost(&places) <= DEARER * cost(chords)
    }

    /// True if the towed car touches nothing but at the ends.
    fn is_clear(&self, spline: &Spline) -> bool {
        let world = self.world;
        let towed = tractrix(&world.geometry, &along(spline, STATION));
        let middle = |pose: &Pose| pose.advance(0.0, world.geometry.vehicle.middle()).point();
        let mut stations = vec![0.0];
        for pair in towed.poses.windows(2) {
            stations.push(stations[stations.len() - 1] + (middle(&pair[1]) - middle(&pair[0])).norm());
        }
        let inner = ENDS..=stations[stations.len() - 1] - ENDS;
        let inside =
            |(pose, station): (&Pose, &f64)| !inner.contains(station) || world.body.hit(*pose).is_none();
        towed.poses.iter().zip(&stations).all(inside)
    }
}

/// Places of a curve about `step` apart, and the direction there.
pub(super) fn along(spline: &Spline, step: f64) -> Vec<(Point, Vector)> {
    let rough: Vec<Point> = (0..=200).map(|k| spline.at(f64::from(k) / 200.0).point).collect();
    let length = rough.windows(2).fold(0.0, |sum, w| sum + (w[1] - w[0]).norm());
    // Parameters are not quite lengths.
    let count = (length * 1.25 / step).ceil().max(2.0) as u32;
    let place = |k: u32| {
        let CurvePoint { point, first, .. } = spline.at(f64::from(k) / f64::from(count));
        (point, first)
    };
    (0..=count).map(place).collect()
}

/// Without the places near the ends, where the car stands as it does.
fn inner(rooms: &[(Point, f64)], ends: f64) -> Range<usize> {
    let near = |end: Point| move |room: &(Point, f64)| (room.0 - end).norm() < ends;
    let (first, last) = (rooms[0].0, rooms[rooms.len() - 1].0);
    let from = rooms.iter().take_while(|room| near(first)(room)).count();
    let to = rooms.len() - rooms.iter().rev().take_while(|room| near(last)(room)).count();
    if from < to { from..to } else { 0..rooms.len() }
}

/// Places along the straight line of the chords, all in its direction.
fn straight(chords: &[Point]) -> Vec<(Point, Vector)> {
    let points = dense(chords, ROOMS);
    let way = chords[chords.len() - 1] - chords[0];
    points.into_iter().map(|point| (point, way)).collect()
}

/// Of a curve, or of the straight line that is one. `step` is their distance in metres, about.
fn stations(spline: Option<&Spline>, chords: &[Point], step: f64) -> Vec<Station> {
    let Some(spline) = spline else {
        let way = (chords[chords.len() - 1] - chords[0]).normalize();
        return dense(chords, step).into_iter().map(|point| Station { point, way, curvature: 0.0 }).collect();
    };
    along_curve(spline, step)
}

/// Stations of a curve, equally spaced in its parameter.
fn along_curve(spline: &Spline, step: f64) -> Vec<Station> {
    let length = along(spline, step).windows(2).fold(0.0, |sum, w| sum + (w[1].0 - w[0].0).norm());
    let count = (length / step).ceil().max(2.0) as u32;
    let station = |k: u32| {
        let place = spline.at(f64::from(k) / f64::from(count));
        Station { point: place.point, way: place.first.normalize(), curvature: place.curvature() }
    };
    (0..=count).map(station).collect()
}
