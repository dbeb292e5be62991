//! The cells of a map with the moves of a neighbourhood, as a lattice to search.
//!
//! A node is the index of its cell, row by row; a move is a number, its place in [`Neighbourhood::moves`]. The eight
//! single steps come first and are handled together: one byte has the free cells around a node (the map keeps it up to
//! date), tables give the legal steps of every byte, and only steps that would improve their target are looked at.
//!
//! Most steps need no look at all. A cell that was reached by a step from p has neighbours that p has seen at no higher
//! cost, so these are left out (`unseen`). For a step to the east, with `.` left out and `?` kept only beside a wall:
//!
//! ```text
//! straight        diagonal (north-east)
//! . ? +           + + +
//! . n +           . n +
//! . ? +           . . +
//! ```
//!
//! A diagonal step leads to `+` on the far side, a straight one ahead, and to a side only where the cell half behind is
//! blocked. What is left out never had a lower cost, so g, order and counters do not change.
//!
//! Longer moves (sixteen neighbours and more) test every cell that their line crosses: one 64-bit mask over the 7 × 7
//! window around the node against the mask of the move.

use std::cell::Cell as Counter;

use super::heuristics::Estimate;
use super::moves::{D, DIRECTIONS, LEGAL, Move, Neighbourhood, R2, cost};
use super::query::Query;
use crate::map::{Cell, Corner, Occupancy, line_of_sight};
use crate::search::lattice::{Edge, EdgeSink, Lattice, Reversible};
use crate::search::{Considered, Legality, Part};
use crate::search::{NodeId, PackedEntry};

/// A step to one of the cells around. The offset is constant, because rows have one width.
struct Single {
    /// How much larger the target's number is.
    offset: i32,
    dx: i32,
    dy: i32,
    /// As the search from the start takes it, and the one from the goal, which goes against its direction.
    edges: [Edge; 2],
}

/// Any move of the neighbourhood.
struct Step {
    /// How much larger the target's number is.
    offset: i32,
    cost: i64,
    /// Number of the move back.
    opposite: u32,
    dx: i32,
    dy: i32,
    /// Cells that must be free, as in [`Occupancy::window`].
    needs: u64,
    target: u64,
}

/// The lattice. The estimate is a type parameter, so a search is compiled for each and calls none through a pointer.
pub(super) struct Grid<'a, E> {
    map: &'a Occupancy,
    /// Targets of the search from the start and of the search from the goal.
    aims: [Cell; 2],
    estimate: E,
    steps: Vec<Step>,
    /// The single steps by their direction, those that there are not as well.
    single_steps: [Single; 8],
    /// True if there are diagonal steps.
    diagonals: bool,
    corner: Corner,
    /// The legal single steps by the free cells around.
    legal: &'static [u8; 256],
    /// The single steps worth a look, by the direction of the last one and the free cells around.
    onward: &'static [[u8; 256]; 8],
    los_calls: Counter<u32>,
}

impl<'a, E: Estimate> Grid<'a, E> {
    /// The lattice of a query's map. Offsets and masks of all moves are computed once: they depend on the map's width
    /// and the rule for corners, not on the node.
    pub(super) fn new(query: &Query<'a>, neighbourhood: Neighbourhood, corner: Corner, estimate: E) -> Self {
        let moves = neighbourhood.moves();
        let width = query.map.width() as i32;
        let step = |m: &Move| Step {
            offset: m.dy * width + m.dx,
            cost: cost(m.dx, m.dy),
            opposite: moves.iter().position(|o| (o.dx, o.dy) == (-m.dx, -m.dy)).unwrap_or(0) as u32,
            dx: m.dx,
            dy: m.dy,
            needs: crossed(m.dx, m.dy, corner),
            target: bit(m.dx, m.dy),
        };
        let diagonals = neighbourhood != Neighbourhood::Four;
        let single = |direction: usize| {
            let (dx, dy) = DIRECTIONS[direction];
            let edge = |number: usize| Edge::new(number as u32 >> u32::from(!diagonals), cost(dx, dy));
            Single { offset: dy * width + dx, dx, dy, edges: [edge(direction), edge(direction ^ 4)] }
        };
        Self {
            map: query.map,
            aims: [query.goal, query.start],
            estimate,
            steps: moves.iter().map(step).collect(),
            single_steps: std::array::from_fn(single),
            diagonals,
            corner,
            legal: &LEGAL[corner as usize],
            onward: &UNSEEN,
            los_calls: Counter::new(0),
        }
    }

    /// Leaves out the steps, too, that lead to no cell at its lowest cost. The path costs the same; fewer cells enter
    /// the open lists, so that they are counted otherwise.
    pub(super) fn on_shortest_ways(mut self) -> Self {
        self.onward = &SHORTEST;
        self
    }

    pub(super) fn los_calls(&self) -> u32 {
        self.los_calls.get()
    }

    /// Offers the moves of a node, eight single steps at once: one byte each for what is free, what is not known to be
    /// useless, what improves its target and what the rule for corners allows. Their conjunction is usually empty or
    /// has one bit.
    #[inline]
    fn offer<S: EdgeSink>(&self, node: NodeId, last: Option<u32>, back: bool, sink: &mut S) {
        // The search from the goal takes steps against their direction.
        let turned = if back { 4 } else { 0 };
        let free = self.map.free_around_index(node);
        let row = self.map.width() as usize;
        // First look at all, then move: processors guess badly which steps are worth it.
        let mut worth = if self.diagonals {
            let direction = last.filter(|&number| number < 8);
            let onward = match direction {
                Some(direction) => self.onward[(direction ^ turned) as usize & 7][usize::from(free)],
                None => 0xff,
            };
            u32::from(free & onward) & sink.improves_around(node, row, D, R2)
        } else {
            let before = last.map_or(0, |number| 1 << ((2 * number) & 7 ^ 4 ^ turned));
            u32::from(free & 0b0101_0101) & !before & sink.improves_beside(node, row, D)
        };
        let mut calls = worth.count_ones();
        worth &= u32::from(self.legal[usize::from(free)]);
        if worth != 0 {
            let (cell, aim) = (self.map.cell(node), self.aims[usize::from(back)]);
            let (columns, rows) = (aim.x - cell.x, aim.y - cell.y);
            while worth != 0 {
                let step = &self.single_steps[worth.trailing_zeros() as usize & 7];
                worth &= worth - 1;
                let h = self.estimate.over(columns - step.dx, rows - step.dy);
                sink.relax(step.edges[usize::from(back)], node.wrapping_add_signed(step.offset), h);
            }
        }
        if self.steps.len() > 8 {
            calls += self.offer_long(node, back, sink);
        }
        self.los_calls.set(self.los_calls.get() + calls);
    }

    /// Offers the moves beyond the eight single steps, and returns how many improve their target. A move is legal if
    /// the cells around the node that block have none in common with those that it needs: one comparison of masks.
    fn offer_long<S: EdgeSink>(&self, node: NodeId, back: bool, sink: &mut S) -> u32 {
        let cell = self.map.cell(node);
        let window = self.map.window(cell);
        let mut calls = 0;
        for (number, step) in self.steps.iter().enumerate().skip(8) {
            if window & step.target != 0 {
                continue;
            }
            let target = node.wrapping_add_signed(step.offset);
            if sink.improves(target, step.cost) {
                calls += 1;
                let to = || cell.offset(step.dx, step.dy);
                if window & step.needs == 0
                    && (self.corner != Corner::NoSqueeze || line_of_sight(self.map, cell, to(), self.corner))
                {
                    let number = if back { step.opposite } else { number as u32 };
                    sink.relax(Edge::new(number, step.cost), target, self.ahead(to(), back));
                }
            }
        }
        calls
    }

    /// The estimate from a cell to where the search goes.
    #[inline]
    fn ahead(&self, cell: Cell, back: bool) -> i64 {
        let to = self.aims[usize::from(back)];
        self.estimate.over(to.x - cell.x, to.y - cell.y)
    }
}

impl<E: Estimate> Lattice for Grid<'_, E> {
    type Entry = PackedEntry;

    fn node_count(&self) -> usize {
        self.map.len()
    }

    fn padding(&self) -> usize {
        self.map.width() as usize + 1
    }

    fn successors<S: EdgeSink>(&self, node: NodeId, last: Option<u32>, sink: &mut S) {
        self.offer(node, last, false, sink);
    }

    fn before(&self, node: NodeId, number: u32) -> NodeId {
        node.wrapping_add_signed(-self.steps[number as usize].offset)
    }

    fn to_goal(&self, node: NodeId) -> i64 {
        self.ahead(self.map.cell(node), false)
    }
}

impl<E: Estimate> Reversible for Grid<'_, E> {
    fn predecessors<S: EdgeSink>(&self, node: NodeId, last: Option<u32>, sink: &mut S) {
        self.offer(node, last, true, sink);
    }

    fn after(&self, node: NodeId, number: u32) -> NodeId {
        node.wrapping_add_signed(self.steps[number as usize].offset)
    }

    fn to_start(&self, node: NodeId) -> i64 {
        self.ahead(self.map.cell(node), true)
    }
}

impl<E: Estimate> Considered for Grid<'_, E> {
    fn consider(&self, node: NodeId, _: Option<u32>, _: Part, tell: &mut dyn FnMut(NodeId, i64, Legality)) {
        let cell = self.map.cell(node);
        for step in &self.steps {
            let to = cell.offset(step.dx, step.dy);
            if self.map.contains(to) {
                tell(self.map.index(to), step.cost, legality(self.map, cell, to, self.corner));
            }
        }
    }
}

/// Whether a straight move between two cells of a map can be made.
pub(super) fn legality(map: &Occupancy, from: Cell, to: Cell, corner: Corner) -> Legality {
    match (map.blocked(to), line_of_sight(map, from, to, corner)) {
        (true, _) => Legality::Blocked,
        (false, false) => Legality::Corner,
        (false, true) => Legality::Free,
    }
}

/// [`unseen`] by the direction of the last step and the free cells around.
static UNSEEN: [[u8; 256]; 8] = onward(false);
/// The same, without the steps that are [`longer`].
static SHORTEST: [[u8; 256]; 8] = onward(true);

/// For each direction of the last step and each byte of free cells the steps worth a look, as drawn at the head of this
/// file. It is computed by the compiler.
const fn onward(is_shortest: bool) -> [[u8; 256]; 8] {
    let mut table = [[0; 256]; 8];
    let mut direction = 0;
    while direction < 8 {
        let mut free = 0;
        while free < 256 {
            let left_out = if is_shortest { longer(free as u8, direction as u32) } else { 0 };
            table[direction][free] = unseen(free as u8, direction as u32) & !left_out;
            free += 1;
        }
        direction += 1;
    }
    table
}

/// The single steps that may lead on from a cell whose free neighbours are `free` and which was reached in a direction,
/// where there are diagonals: the cell before has been there at no higher cost where such a cell is also its neighbour.
const fn unseen(free: u8, direction: u32) -> u8 {
    let seen = match direction % 2 {
        0 => 0b0011_1000 | beside_free(free, direction),
        _ => 0b0011_1000,
    };
    !u8::rotate_left(seen, direction)
}

/// The diagonal steps at a right angle to a diagonal one: two straight steps around the corner cost less, where it is
/// free.
const fn longer(free: u8, direction: u32) -> u8 {
    let longer = if direction % 2 == 1 { beside_free(free, direction) } else { 0 };
    longer.rotate_left(direction)
}

/// The steps to both sides of a direction beside which the cell half behind is free, turned so that the direction is
/// the lowest bit.
const fn beside_free(free: u8, direction: u32) -> u8 {
    let free = free.rotate_right(direction);
    (free & 0b1000) >> 1 | (free & 0b10_0000) << 1
}

/// The bit of a cell in [`Occupancy::window`].
const fn bit(dx: i32, dy: i32) -> u64 {
    1 << (8 * (dy + 3) + dx + 3)
}

/// The cells that [`line_of_sight`] along a move asks to be free; with [`Corner::NoSqueeze`], which asks for one *or*
/// another, only those that it asks for in any case.
fn crossed(dx: i32, dy: i32, corner: Corner) -> u64 {
    let (ax, ay, sx, sy) = (dx.abs(), dy.abs(), dx.signum(), dy.signum());
    let (mut i, mut j, mut cells) = (0, 0, 0);
    while i < ax || j < ay {
        let side = (2 * i + 1) * ay - (2 * j + 1) * ax;
        if side == 0 && corner == Corner::Strict {
            cells |= bit(sx * (i + 1), sy * j) | bit(sx * i, sy * (j + 1));
        }
        i += i32::from(side <= 0);
        j += i32::from(side >= 0);
        cells |= bit(sx * i, sy * j);
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planners::moves::{D, R2};

    /// Asks about every step onward from a cell, by the free cells around, the direction in which it was reached, and
    /// the corner rule: `check(map, before, centre, target, free, direction, c, corner)`.
    fn each_step(mut check: impl FnMut(&Occupancy, [Cell; 3], (u8, u32, usize), Corner)) {
        let centre = Cell::new(2, 2);
        for (free, direction) in (0..=255_u8).flat_map(|free| (0..8_u32).map(move |d| (free, d))) {
            let (dx, dy) = DIRECTIONS[direction as usize];
            let before = centre.offset(-dx, -dy);
            let mut map = Occupancy::new(5, 5);
            for (c, &(dx, dy)) in DIRECTIONS.iter().enumerate() {
                map.set(centre.offset(dx, dy), free >> c & 1 == 0);
            }
            for corner in [Corner::Strict, Corner::NoSqueeze, Corner::Free] {
                if map.blocked(before) || !line_of_sight(&map, before, centre, corner) {
                    continue;
                }
                for c in (0..8).filter(|c| free >> c & 1 == 1) {
                    let target = centre.offset(DIRECTIONS[c].0, DIRECTIONS[c].1);
                    if target != before {
                        check(&map, [before, centre, target], (free, direction, c), corner);
                    }
                }
            }
        }
    }

    fn price(from: Cell, to: Cell) -> i64 {
        if from.x == to.x || from.y == to.y { D } else { R2 }
    }

    /// Every step that is left out leads to where the cell before could go itself, legally and at no higher cost.
    #[test]
    fn only_what_the_cell_before_has_seen_is_left_out() {
        each_step(|map, [before, centre, target], (free, direction, c), corner| {
            if unseen(free, direction) >> c & 1 == 1 {
                return;
            }
            let near = (target.x - before.x).abs().max((target.y - before.y).abs()) == 1;
            assert!(near, "{free:b} {direction} {c}");
            assert!(line_of_sight(map, before, target, corner), "{free:b} {direction} {c}");
            assert!(price(before, target) <= price(before, centre) + price(centre, target));
        });
    }

    /// … or is one of two diagonal steps that cost more than two straight ones, which are legal; all of those are left
    /// out.
    #[test]
    fn only_what_is_on_no_shortest_way_is_left_out_beyond() {
        let mut count = 0;
        each_step(|map, [before, centre, target], (free, direction, c), corner| {
            let around = DIRECTIONS.map(|(dx, dy)| before.offset(dx, dy)).into_iter().any(|over| {
                over != centre
                    && [(before, over), (over, target)].into_iter().all(|(from, to)| {
                        !map.blocked(to)
                            && (from.x - to.x).abs().max((from.y - to.y).abs()) == 1
                            && line_of_sight(map, from, to, corner)
                    })
                    && price(before, over) + price(over, target)
                        < price(before, centre) + price(centre, target)
            });
            let is_left_out = longer(free, direction) >> c & 1 == 1;
            assert!(!is_left_out || around, "{free:b} {direction} {c}");
            if around
                && line_of_sight(map, centre, target, corner)
                && SHORTEST[direction as usize][free as usize] >> c & 1 == 1
            {
                panic!("{free:b} {direction} {c} {corner:?} is on no shortest way");
            }
            count += u32::from(is_left_out);
        });
        assert!(count > 500, "{count}");
    }
}
