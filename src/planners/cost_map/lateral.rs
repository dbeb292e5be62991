//! A line beside a curve that costs the least: the search's own costs, without its eight directions.
//!
//! Every two metres of the curve have places to both sides of it. The cheapest row of them, one at each, is found by
//! dynamic programming. A way that turns away from the curve costs more, so that lanes are changed gently.
//!
//! The state of the programme is a place and the slope by which it was reached, because the price of curvature needs
//! three places in a row. With n rows of m places and s slopes it takes O(n·m·s), as a slope changes by few places at a
//! time.

use super::smooth::bilinear;
use super::{CostMap, RoadRasters};
use crate::geometry::{Point, Vector};

/// Places are this far apart along the curve and across, metres.
const ALONG: f64 = 2.0;
const ACROSS: f64 = 0.1;
/// So many places lie on either side of a curve that may be far from the cheapest, and of one that is near it.
const SIDES: [usize; 2] = [40, 12];
/// From one station to the next the line moves by this many places at most, and so it does at `SLOPES` slopes.
const SLOPE: usize = 6;
const SLOPES: usize = 2 * SLOPE + 1;
/// From one step to the next the slope changes by this many places at most.
const CHANGE: usize = 2;
/// A way of curvature 1/m is dearer by this factor times its square: a lane is changed in some 18 m then, m². Lanes are
/// changed later and left for a shorter way the smaller it is, and bends are tighter.
const BENDING: f64 = 15.0;
/// At so many stations near either end a bend counts this many times as much: the rear axle shall be on its way by
/// then.
const END: usize = 10;
const AT_ENDS: f64 = 20.0;
/// Dearer than any way: a metre on which none of the room is left that is asked for.
const SHORT: f64 = 1e6;
/// Where a place has too little room, those around it are tried so many to either side, this far apart, metres.
const FINE: i32 = 9;
const CLOSE: f64 = 0.01;
/// Places with so little more room than asked shall be passed exactly, metres.
const NARROW: f64 = 0.1;
/// Nearer to the middle of a bend than this share of its radius no place lies.
const INNER: f64 = 0.3;

/// A place of a curve.
#[derive(Debug, Clone, Copy)]
pub struct Station {
    /// Position, metres.
    pub point: Point,
    /// Of length 1.
    pub way: Vector,
    /// 1/m, positive to the left.
    pub curvature: f64,
}

/// The cheapest places.
#[derive(Debug, Clone)]
pub struct Row {
    /// One at every station.
    pub points: Vec<Point>,
    /// True where a place has hardly the room that is asked for.
    pub firm: Vec<bool>,
}

/// The costs by which lines are chosen.
/// Places are given by a station and an offset across, positive to the left of the curve's direction.
#[derive(Clone, Copy)]
pub struct Lateral<'a> {
    /// The road's raster.
    pub ground: &'a RoadRasters,
    /// Costs on it.
    pub costs: &'a CostMap,
    /// Half the car's width, metres.
    pub radius: f64,
    /// Half the car's length, metres.
    pub half_length: f64,
    /// How many times as large as a car.
    pub scale: f64,
    /// The exact room at a place for a disc of the car's width, metres.
    pub room: &'a dyn Fn(Point) -> f64,
}

impl Lateral<'_> {
    /// How far apart stations shall be, metres.
    pub fn step(&self) -> f64 {
        ALONG * self.scale
    }

    /// Cost of a metre at a place, regardless of clearance; infinity if blocked.
    pub fn metre(&self, point: Point) -> f64 {
        self.costs.soft_metre(self.ground, point).unwrap_or(f64::INFINITY)
    }

    /// By the raster where that is sure to be more or less than what is asked.
    fn room_at(&self, point: Point, asked: f64) -> f64 {
        let rough = bilinear(self.ground, point) - self.radius;
        if (rough - asked).abs() < self.ground.frame.resolution { (self.room)(point) } else { rough }
    }

    /// The cheapest line along a curve, from its first to its last point; at every station the room asked for, metres,
    /// is kept around the car, as far as that goes. It begins and ends in the directions `ways` as far as its slopes
    /// go. Near the curve alone if that `is_near`.
    pub fn line(&self, stations: &[Station], asked: &[f64], ways: [Vector; 2], is_near: bool) -> Row {
        let side = SIDES[usize::from(is_near)];
        let places = 2 * side + 1;
        let prices = self.prices(stations, asked, side);
        let last = stations.len() - 1;
        // Per slope of the step to it and place: the cost of the way there.
        let mut spent = vec![f64::INFINITY; places * SLOPES];
        let end = |at: usize, way: Vector, length: f64| {
            let own = stations[at].way;
            let slope = own.perp(&way) / own.dot(&way).max(0.1) * length / (ACROSS * self.scale);
            (SLOPE as f64 + slope.round().clamp(-(SLOPE as f64), SLOPE as f64)) as usize
        };
        let length = |i: usize| (stations[i].point - stations[i - 1].point).norm();
        let ends = [end(0, ways[0], length(1)), end(last, ways[1], length(last))];
        spent[ends[0] * places + side] = 0.0;
        // And the slope of the step before.
        let mut before: Vec<Vec<u8>> = vec![Vec::new()];
        let mut steps: Vec<f64> = Vec::with_capacity(places);
        for i in 1..=last {
            let length = length(i);
            let slope = |d: usize| (d as f64 - SLOPE as f64) * ACROSS * self.scale / length;
            let bend = |from: usize, to: usize| {
                let curvature = (stations[i - 1].curvature + (slope(to) - slope(from)) / length) * self.scale;
                let is_end = i <= END || i + END > last;
                1.0 + if is_end { AT_ENDS } else { 1.0 } * BENDING * curvature * curvature
            };
            let mut next = vec![f64::INFINITY; places * SLOPES];
            let mut from = vec![0_u8; places * SLOPES];
            for d in 0..SLOPES {
                let longer = slope(d) * slope(d) / 2.0;
                // Place k is reached from place k + SLOPE − d.
                let reached = d.saturating_sub(SLOPE)..places.min(places + d - SLOPE);
                let origin = reached.start + SLOPE - d;
                let origins = origin..origin + reached.len();
                let pairs = prices[i - 1][origins.clone()].iter().zip(&prices[i][reached.clone()]);
                steps.clear();
                steps.extend(pairs.map(|(a, b)| 0.5 * (a + b) + longer));
                let row = d * places + reached.start..d * places + reached.end;
                for e in d.saturating_sub(CHANGE)..=(d + CHANGE).min(SLOPES - 1) {
                    let factor = length * bend(e, d);
                    let spent = &spent[e * places + origins.start..e * places + origins.end];
                    let found = next[row.clone()].iter_mut().zip(&mut from[row.clone()]);
                    for ((best, before), (spent, step)) in found.zip(spent.iter().zip(&steps)) {
                        let cost = spent + factor * step;
                        if cost < *best {
                            (*best, *before) = (cost, e as u8);
                        }
                    }
                }
            }
            before.push(from);
            spent = next;
        }
        let cost = |d: usize| spent[d * places + side];
        let nearest = (0..SLOPES).filter(|&d| cost(d) < f64::INFINITY).min_by_key(|d| d.abs_diff(ends[1]));
        let Some(slope) = nearest else {
            let points = stations.iter().map(|s| s.point).collect();
            return Row { points, firm: vec![false; stations.len()] };
        };
        let (mut k, mut d) = (side, slope);
        let mut line = Vec::with_capacity(stations.len());
        for i in (0..=last).rev() {
            // The ends stay where they are.
            let is_end = i == 0 || i == last;
            let across = self.across(k, side);
            let fine = if is_end { (across, false) } else { self.widest(&stations[i], across, asked[i]) };
            line.push((Self::place(&stations[i], fine.0), fine.1));
            if i > 0 {
                let e = usize::from(before[i][d * places + k]);
                (k, d) = (k + SLOPE - d, e);
            }
        }
        line.reverse();
        let (points, firm) = line.into_iter().unzip();
        Row { points, firm }
    }

    /// The nearest place to the one `across` that has the room asked for, or most of it, and whether that is little.
    fn widest(&self, station: &Station, across: f64, asked: f64) -> (f64, bool) {
        let mut best = (across, self.room_beside(station, across, asked));
        for j in (1..=FINE).flat_map(|j| [-j, j]) {
            if best.1 >= asked {
                break;
            }
            let next = across + f64::from(j) * CLOSE * self.scale;
            let room = self.room_beside(station, next, asked);
            if room > best.1 {
                best = (next, room);
            }
        }
        (best.0, best.1 < asked + NARROW * self.scale)
    }

    fn across(&self, k: usize, side: usize) -> f64 {
        (k as f64 - side as f64) * ACROSS * self.scale
    }

    fn place(station: &Station, across: f64) -> Point {
        station.point + Vector::new(-station.way.y, station.way.x) * across
    }

    /// How wide a way beside a station's is for one along it.
    fn inner(station: &Station, across: f64) -> f64 {
        1.0 - station.curvature * across
    }

    /// The room of the car beside a station, where it stands as it does on the curve: that of a disc at either end and
    /// of one between.
    fn room_beside(&self, station: &Station, across: f64, asked: f64) -> f64 {
        if Self::inner(station, across) <= INNER {
            return -self.radius;
        }
        let ahead = self.half_length - self.radius / 2.0;
        let at = Self::place(station, across);
        [0.0, -ahead, ahead].into_iter().fold(f64::INFINITY, |least, by| {
            // What is short anyway is not looked at any closer.
            if least < asked - ahead { least } else { least.min(self.room_at(at + station.way * by, asked)) }
        })
    }

    /// Per station and place: what a metre costs there, and the price of too little room.
    fn prices(&self, stations: &[Station], asked: &[f64], side: usize) -> Vec<Vec<f64>> {
        let places = 2 * side + 1;
        let price = |i: usize, k: usize| {
            let (station, across) = (&stations[i], self.across(k, side));
            let metre = self.metre(Self::place(station, across)).min(SHORT);
            let short =
                (asked[i] - self.room_beside(station, across, asked[i])).max(0.0) / asked[i].max(0.05);
            metre * Self::inner(station, across).max(INNER) + SHORT * short
        };
        (0..stations.len()).map(|i| (0..places).map(|k| price(i, k)).collect()).collect()
    }
}
