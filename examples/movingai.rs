//! Runs a `MovingAI` map's questions.
//!
//! ```sh
//! cargo run --release --example movingai -- check FOLDER     # every question of every map, by eight and jump-point
//! cargo run --release --example movingai -- time MAP eight   # milliseconds per question on stdin, the fastest of 15
//! ```
//!
//! `check` compares every length with the printed one and walks every path again.

use std::io::Read as _;
use std::path::Path;
use std::time::Instant;

use parkade::map::{Bits, Cell, Occupancy};
use parkade::planners::bidirectional;
use parkade::planners::grid_astar::{self, Config};
use parkade::planners::heuristics::Heuristic;
use parkade::planners::jump_point;
use parkade::planners::moves::Neighbourhood;
use parkade::planners::query::{GridReport, GridScratch, Query};
use parkade::planners::risk_field;
use parkade::search::Stop;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["check", folder] => check(Path::new(folder)),
        ["time", map, id] => time(Path::new(map), id),
        _ => eprintln!("movingai check FOLDER | movingai time MAP PLANNER"),
    }
}

/// The cells from the north, as the questions count them.
struct Maze {
    map: Occupancy,
    bits: Bits,
    scratch: GridScratch,
}

impl Maze {
    fn read(path: &Path) -> Self {
        let text = std::fs::read(path).expect("a readable map");
        let text = String::from_utf8_lossy(&text);
        let rows: Vec<&str> = text.lines().skip(4).filter(|l| !l.is_empty()).collect();
        let mut map = Occupancy::new(rows[0].len() as u32, rows.len() as u32);
        for (y, row) in rows.iter().enumerate() {
            for (x, _) in row.bytes().enumerate().filter(|(_, c)| !b".GS".contains(c)) {
                map.set(Cell::new(x as i32, y as i32), true);
            }
        }
        Self { bits: Bits::new(&map), map, scratch: GridScratch::new() }
    }

    fn ask(&mut self, id: &str, start: Cell, goal: Cell) -> GridReport {
        let query = Query { map: &self.map, start, goal };
        if id == "jump-point" {
            let config = jump_point::Config::default();
            return jump_point::plan(query, &self.bits, &config, &mut self.scratch, &mut ());
        }
        let eight = Neighbourhood::Eight;
        if id == "both-ends" {
            let config =
                bidirectional::Config { neighbours: eight, stop: Stop::Optimal, ..Default::default() };
            return bidirectional::plan(query, &config, &mut self.scratch, &mut ());
        }
        if id == "risk-field" {
            return risk_field::plan(query, &risk_field::Config::PAPER, &mut self.scratch, &mut ());
        }
        let config = Config { heuristic: Heuristic::Octile, ..Config::new(eight) };
        grid_astar::plan(query, eight, &config, &mut self.scratch, &mut ())
    }

    /// The path's length, every step checked.
    fn walk(&self, path: &[Cell]) -> f64 {
        let mut length = 0.0;
        for pair in path.windows(2) {
            let (dx, dy) = (pair[1].x - pair[0].x, pair[1].y - pair[0].y);
            assert!(dx.abs().max(dy.abs()) == 1 && !self.map.blocked(pair[1]));
            if dx != 0 && dy != 0 {
                assert!(!self.map.blocked(pair[0].offset(dx, 0)) && !self.map.blocked(pair[0].offset(0, dy)));
                length += std::f64::consts::SQRT_2;
            } else {
                length += 1.0;
            }
        }
        length
    }
}

fn check(folder: &Path) {
    let mut names: Vec<_> = std::fs::read_dir(folder)
        .expect("a folder")
        .filter_map(|entry| entry.ok().map(|e| e.path()))
        .filter(|path| path.extension().is_some_and(|e| e == "map"))
        .collect();
    names.sort();
    for path in names {
        let mut maze = Maze::read(&path);
        let questions = std::fs::read_to_string(path.with_extension("map.scen")).expect("its questions");
        for id in ["eight", "jump-point"] {
            let (mut asked, mut right) = (0, 0);
            for line in questions.lines().skip(1).filter(|l| !l.trim().is_empty()) {
                let words: Vec<&str> = line.split_whitespace().collect();
                let number = |k: usize| words[k].parse::<i32>().expect("a number");
                let (start, goal) = (Cell::new(number(4), number(5)), Cell::new(number(6), number(7)));
                let printed: f64 = words[8].parse().expect("a length");
                let report = maze.ask(id, start, goal);
                let ends = (report.cells.first(), report.cells.last()) == (Some(&start), Some(&goal));
                let length = maze.walk(&report.cells);
                asked += 1;
                right += u32::from(ends && (length - printed).abs() <= printed * 2e-5 + 0.006);
            }
            println!("{}: {id} has the printed length on {right} of {asked}", path.display());
            assert_eq!(right, asked);
        }
    }
}

fn time(path: &Path, id: &str) {
    let mut maze = Maze::read(path);
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).expect("questions");
    let number = |w: &str| w.parse::<i32>().expect("a number");
    let mut total = 0.0;
    for line in text.lines() {
        let q: Vec<i32> = line.split_whitespace().map(number).collect();
        let (start, goal) = (Cell::new(q[0], q[1]), Cell::new(q[2], q[3]));
        let times = (0..15).map(|_| {
            let clock = Instant::now();
            std::hint::black_box(maze.ask(id, start, goal));
            clock.elapsed().as_secs_f64() * 1e3
        });
        total += times.fold(f64::INFINITY, f64::min);
    }
    println!("{total}");
}
