//! A small map with a start and a goal, and plain searches on it that share no code with the planners.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

use parkade::scenario::Scenario;
use serde_json::json;

use crate::random::Random;

pub(crate) type Cell = (i32, i32);

#[derive(Clone)]
pub(crate) struct GridModel {
    pub(crate) width: i32,
    pub(crate) height: i32,
    blocked: Vec<bool>,
    pub(crate) start: Cell,
    pub(crate) goal: Cell,
    origin: [f64; 2],
    resolution: f64,
}

impl GridModel {
    pub(crate) fn random(r: &mut Random) -> Self {
        let (width, height) = (2 + r.below(22) as i32, 2 + r.below(22) as i32);
        let density = r.between(0.0, 0.5);
        let blocked = (0..width * height).map(|_| r.between(0.0, 1.0) < density).collect();
        let mut any = || (r.below(width as usize) as i32, r.below(height as usize) as i32);
        let (start, goal) = (any(), any());
        let mut field = Self { width, height, blocked, start, goal, origin: [0.0, 0.0], resolution: 1.0 };
        field.origin = *r.pick(&[[0.0, 0.0], [-7.5, 3.25], [1e6, -1e6]]);
        field.resolution = *r.pick(&[1.0, 0.25, 2.0]);
        // Most ends shall be free, not all.
        if !r.one_in(20) {
            field.set(start, false);
            field.set(goal, false);
        }
        field
    }

    pub(crate) fn set(&mut self, (x, y): Cell, blocked: bool) {
        self.blocked[(y * self.width + x) as usize] = blocked;
    }

    pub(crate) fn blocked(&self, (x, y): Cell) -> bool {
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        !inside || self.blocked[(y * self.width + x) as usize]
    }

    pub(crate) fn reversed(&self) -> Self {
        Self { start: self.goal, goal: self.start, ..self.clone() }
    }

    /// Start and goal so many metres further east.
    pub(crate) fn ahead(&self, by: f64) -> Self {
        let cells = (0.5 + by / self.resolution).floor() as i32;
        let ahead = |(x, y): Cell| (x + cells, y);
        Self { start: ahead(self.start), goal: ahead(self.goal), ..self.clone() }
    }

    pub(crate) fn moved(&self, by: f64) -> Self {
        Self { origin: self.origin.map(|at| at + by), ..self.clone() }
    }

    /// A quarter turn to the left.
    pub(crate) fn turned(&self) -> Self {
        let turn = |(x, y): Cell| (self.height - 1 - y, x);
        let (width, height) = (self.height, self.width);
        let mut field =
            Self { width, height, start: turn(self.start), goal: turn(self.goal), ..self.clone() };
        for y in 0..self.height {
            for x in 0..self.width {
                field.set(turn((x, y)), self.blocked((x, y)));
            }
        }
        field
    }

    pub(crate) fn scene(&self) -> Scenario {
        let runs: Vec<[i32; 3]> = (0..self.height)
            .flat_map(|y| (0..self.width).filter(move |&x| self.blocked((x, y))).map(move |x| [x, y, 1]))
            .collect();
        let pose = |(x, y): Cell| {
            let [x, y] = [(x, self.origin[0]), (y, self.origin[1])]
                .map(|(cell, origin)| origin + (f64::from(cell) + 0.5) * self.resolution);
            json!({ "x": x, "y": y, "heading": 0.0 })
        };
        let scene = json!({
            "version": 1,
            "map": { "origin": self.origin, "width": self.width, "height": self.height, "resolution": self.resolution },
            "obstacles": [{ "type": "cells", "runs": runs }],
            "vehicle": "paper",
            "start": pose(self.start),
            "goal": pose(self.goal),
        });
        Scenario::from_json(&scene).expect("a valid scene")
    }

    /// The cell that a point in metres is in.
    pub(crate) fn cell(&self, x: f64, y: f64) -> Cell {
        let index = |at: f64, origin: f64| ((at - origin) / self.resolution).floor() as i32;
        (index(x, self.origin[0]), index(y, self.origin[1]))
    }

    /// True if the straight line between two cells' centres touches no blocked cell, corners included.
    pub(crate) fn sees(&self, a: Cell, b: Cell) -> bool {
        let (low, high) = ((a.0.min(b.0), a.1.min(b.1)), (a.0.max(b.0), a.1.max(b.1)));
        let touched = |x: i32, y: i32| {
            let side = |corner: Cell| {
                let (dx, dy) = (b.0 - a.0, b.1 - a.1);
                (dx * (corner.1 - 2 * a.1) - dy * (corner.0 - 2 * a.0)).signum()
            };
            let corners = [(-1, -1), (1, -1), (-1, 1), (1, 1)].map(|(i, j)| side((2 * x + i, 2 * y + j)));
            !(corners.iter().all(|&s| s > 0) || corners.iter().all(|&s| s < 0))
        };
        (low.1..=high.1).all(|y| (low.0..=high.0).all(|x| !self.blocked((x, y)) || !touched(x, y)))
    }

    /// Cost of the cheapest path over these moves, millionths of a cell.
    pub(crate) fn dijkstra(&self, moves: &[Cell]) -> Option<i64> {
        if self.blocked(self.start) || self.blocked(self.goal) {
            return None;
        }
        let index = |(x, y): Cell| (y * self.width + x) as usize;
        let mut best = vec![i64::MAX; self.blocked.len()];
        let mut open = BinaryHeap::from([Reverse((0, self.start))]);
        best[index(self.start)] = 0;
        while let Some(Reverse((cost, at))) = open.pop() {
            if at == self.goal {
                return Some(cost);
            }
            if cost > best[index(at)] {
                continue;
            }
            for &(dx, dy) in moves {
                let to = (at.0 + dx, at.1 + dy);
                if self.blocked(to) || !self.sees(at, to) {
                    continue;
                }
                let next = cost + price((dx, dy));
                if next < best[index(to)] {
                    best[index(to)] = next;
                    open.push(Reverse((next, to)));
                }
            }
        }
        None
    }

    /// True if the goal can be reached at all: without cut corners, over the edges of cells.
    pub(crate) fn connected(&self) -> bool {
        if self.blocked(self.start) || self.blocked(self.goal) {
            return false;
        }
        let mut seen = vec![false; self.blocked.len()];
        let mut open = VecDeque::from([self.start]);
        while let Some(at) = open.pop_front() {
            if at == self.goal {
                return true;
            }
            for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1)] {
                let to = (at.0 + dx, at.1 + dy);
                if !self.blocked(to)
                    && !std::mem::replace(&mut seen[(to.1 * self.width + to.0) as usize], true)
                {
                    open.push_back(to);
                }
            }
        }
        false
    }
}

/// All moves to cells at most `reach` away, or the four to neighbours by an edge for 0; `knights` leaves out what other
/// moves add up to.
pub(crate) fn moves(reach: i32, knights: bool) -> Vec<Cell> {
    if reach == 0 {
        return vec![(1, 0), (0, 1), (-1, 0), (0, -1)];
    }
    (-reach..=reach)
        .flat_map(|y| (-reach..=reach).map(move |x| (x, y)))
        .filter(|&(x, y)| (x, y) != (0, 0) && (!knights || gcd(x, y) == 1))
        .collect()
}

/// Length of a move in millionths of a cell, rounded up for a primitive one.
pub(crate) fn price((dx, dy): Cell) -> i64 {
    let k = gcd(dx, dy);
    let square = i64::from((dx / k).pow(2) + (dy / k).pow(2)) * 1_000_000_000_000;
    let root = square.isqrt();
    i64::from(k) * (root + i64::from(root * root < square))
}

fn gcd(a: i32, b: i32) -> i32 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}
