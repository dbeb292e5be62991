//! Grid planners of other crates behind five C functions: `alloc`, `init`, `query`, `path`, `path_len`.

use grid_pathfinding::PathingGrid;
use grid_util::{point::Point, ValueGrid};
use std::cell::RefCell;

/// A straight and a diagonal step; their ratio is √2 to 10⁻⁸.
const STRAIGHT: u32 = 5741;
const DIAGONAL: u32 = 8119;

struct Peers {
    width: i32,
    height: i32,
    blocked: Vec<u8>,
    jumps: PathingGrid,
    path: Vec<u32>,
}

impl Peers {
    fn new(width: i32, height: i32, blocked: Vec<u8>) -> Self {
        let mut jumps = PathingGrid::new(width as usize, height as usize, true);
        for y in 0..height {
            for x in 0..width {
                jumps.grid.set(x, y, blocked[(y * width + x) as usize] != 0);
            }
        }
        jumps.initialize();
        jumps.generate_components();
        Self { width, height, blocked, jumps, path: Vec::new() }
    }

    fn free(&self, x: i32, y: i32) -> bool {
        x >= 0 && y >= 0 && x < self.width && y < self.height && self.blocked[(y * self.width + x) as usize] == 0
    }

    fn astar(&self, start: (i32, i32), goal: (i32, i32)) -> Option<Vec<(i32, i32)>> {
        const STEPS: [(i32, i32); 8] = [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)];
        let next = |&(x, y): &(i32, i32)| {
            STEPS.iter().filter_map(move |&(dx, dy)| {
                let straight = dx == 0 || dy == 0;
                let legal = self.free(x + dx, y + dy) && (straight || self.free(x + dx, y) && self.free(x, y + dy));
                legal.then_some(((x + dx, y + dy), if straight { STRAIGHT } else { DIAGONAL }))
            })
        };
        let estimate = |&(x, y): &(i32, i32)| {
            let (dx, dy) = ((x - goal.0).unsigned_abs(), (y - goal.1).unsigned_abs());
            STRAIGHT * dx.abs_diff(dy) + DIAGONAL * dx.min(dy)
        };
        pathfinding::prelude::astar(&start, next, estimate, |&at| at == goal).map(|found| found.0)
    }

    fn query(&mut self, which: u32, start: (i32, i32), goal: (i32, i32)) -> bool {
        let cells = if which == 0 {
            self.astar(start, goal)
        } else {
            self.jumps.improved_pruning = which == 1;
            let ends = [start, goal].map(|(x, y)| Point::new(x, y));
            let found = self.jumps.get_path_single_goal(ends[0], ends[1], false);
            found.map(|path| path.iter().map(|p| (p.x, p.y)).collect())
        };
        self.path.clear();
        self.path.extend(cells.iter().flatten().flat_map(|&(x, y)| [x as u32, y as u32]));
        cells.is_some()
    }
}

thread_local!(static PEERS: RefCell<Option<Peers>> = const { RefCell::new(None) });
thread_local!(static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) });

/// Room for the map.
#[no_mangle]
pub extern "C" fn alloc(size: usize) -> *mut u8 {
    INPUT.with(|input| {
        *input.borrow_mut() = vec![0; size];
        input.borrow_mut().as_mut_ptr()
    })
}

/// Takes the map: 1 is blocked, row by row.
#[no_mangle]
pub extern "C" fn init(width: i32, height: i32) {
    let blocked = INPUT.with(|input| std::mem::take(&mut *input.borrow_mut()));
    PEERS.with(|peers| *peers.borrow_mut() = Some(Peers::new(width, height, blocked)));
}

/// 0: A* of crate `pathfinding`; 1 and 2: jump points of crate `grid_pathfinding` with and without better pruning.
#[no_mangle]
pub extern "C" fn query(which: u32, x0: i32, y0: i32, x1: i32, y1: i32) -> bool {
    PEERS.with(|peers| peers.borrow_mut().as_mut().is_some_and(|p| p.query(which, (x0, y0), (x1, y1))))
}

/// The path of the last query: x, y, ….
#[no_mangle]
pub extern "C" fn path() -> *const u32 {
    PEERS.with(|peers| peers.borrow().as_ref().map_or(std::ptr::null(), |p| p.path.as_ptr()))
}

/// Numbers in that path.
#[no_mangle]
pub extern "C" fn path_len() -> usize {
    PEERS.with(|peers| peers.borrow().as_ref().map_or(0, |p| p.path.len()))
}

// A dependency asks for random numbers, which nothing here draws.
fn no_random(_: &mut [u8]) -> Result<(), getrandom::Error> {
    Err(getrandom::Error::UNSUPPORTED)
}
getrandom::register_custom_getrandom!(no_random);
