//! Which searches are tried, in what order, and how much work each gets.
//!
//! The members stand in one list, what a driver likes best in front. They take turns: whoever has spent a slice and may
//! still find a way leaves a quarter of it to the next in the list, and slices grow fourfold with each round (Levin's
//! universal search, 1973; Gomes and Selman, Algorithm portfolios, 2001). Nobody waits long behind a member that is
//! lost, and all together work a few times as much as the best one would alone. Work is counted in expansions, never in
//! time.
//!
//! The schedule: in round r = 1, 2, … the member at place k = 0 … r may expand 8192·4^(r − k) nodes. A member that is
//! alone in the list gets slices that grow fourfold; its neighbour gets a quarter of that. If the member at place k
//! would need E expansions alone, the total is at most a constant times E, which depends on k only. A slice starts its
//! search anew, which costs at most a third more than one long search would, since slices grow geometrically.
//!
//! Members leave the list when they prove something. A search that ends with an empty open list shows that its
//! lattice holds no path with its margin. That counts for coarser lattices and larger margins as well, whose members
//! are dropped unasked.

mod floods;
mod known_paths;
mod members;
mod open_space;
mod scouts;
mod second_look;
mod slices;
mod turns;

pub(super) use floods::Floods;
pub(super) use members::{COMFORTABLE_MARGIN, MANY_CHANGES};

use super::config::SearchFrom;
use super::level::First;
use super::question::{Search, Work};
use crate::IS_COMPLETE;
use crate::geometry::arcs;
use turns::Turns;

/// Finds a path with the largest margin that some member keeps, or why there is none. `widest` is the largest margin to
/// try.
pub(super) fn plan(search: Search, floods: &Floods, widest: usize, work: &mut Work) {
    let levels = search.config.levels();
    let may_swap = search.config.search_from == SearchFrom::Goal && levels > 1;
    let other = || may_swap.then(|| search.swapped(floods.get(widest, true)));
    let first = search.first(&other, search.config.level(0), work);
    if first == First::Found || levels == 1 {
        if IS_COMPLETE && arcs::direction_changes(&work.report.arcs) >= MANY_CHANGES {
            second_look::save_moves(search, floods, None, work);
        }
        return;
    }
    let mut turns = Turns::new(search, floods, widest, first == First::Cramped);
    turns.take(work);
    if IS_COMPLETE {
        second_look::look_again(search, floods, turns.known.next_best(), work);
    }
}
