//! Best-first search over any [`Domain`]; knows nodes and costs, nothing else.
//!
//! A best-first search keeps an *open list* of nodes that it has reached and not yet expanded. It takes the one
//! with the smallest priority
//!
//! ```text
//! f(n) = g(n) + h(n)
//! ```
//!
//! where g is the cost of the best known path from the root and h estimates the cost that remains. Expanding a node
//! emits its moves, and a move that improves its target enters the open list. With h = 0 this is Dijkstra's search,
//! with an estimate that never exceeds the true cost it is A\*.
//!
//! There are two cores, which agree in order, counters and result:
//!
//! * [`best_first()`] works on any [`Domain`]: costs of any ordered type, a label per node (a pose in hybrid A\*),
//!   and completions beyond the last node.
//! * [`lattice`] is for graphs whose nodes all have the same numbered moves and integer costs. It keeps a node in
//!   eight bytes, which grids need.
//!
//! Invariants that both rely on:
//!
//! * A node is expanded once and never reopened (moves that a lattice defers are a second part of it), so a path is
//!   the cheapest only where h is consistent: h(a) ≤ cost(a, b) + h(b) for every move.
//! * The open list is a total order ([`Order`]): f, then on grids h, then the age of the entry. The same input
//!   therefore gives the same expansions on every machine.
//! * Memory belongs to the caller ([`Scratch`], [`PackedScratch`]) and is not cleared between searches. Generation
//!   numbers tell old entries from new ones, so a query costs what it touches, not the size of the map.
//! * An [`Observer`] is a type parameter. `()` compiles to nothing; [`Trace`] keeps the order of expansions for
//!   drawing.
//! * A budget counts expansions, never time.

mod best_first;
mod bidirectional;
mod bidirectional_best_first;
mod bucket_queue;
mod bucket_sort;
mod budget;
mod cost;
mod domain;
mod entry;
mod frontier;
pub mod lattice;
mod node_table;
mod observer;
mod one_way;
mod open_list;
mod recorded;
mod recorded_both;
mod recorded_domain;
mod recording;
#[cfg(test)]
mod reference;
mod stats;
#[cfg(test)]
mod tests;
mod tree;

pub use best_first::{Limits, Report, best_first};
pub use bidirectional::{Stop, bidirectional};
pub use bidirectional_best_first::{Join, Summary, Trees, bidirectional_best_first};
pub(crate) use budget::Budget;
pub use cost::{Cost, NodeId};
pub use domain::{Domain, End, Finish, Relax, Visit};
pub use entry::{Entry, PackedEntry, WideEntry};
pub use frontier::PackedScratch;
pub use node_table::Scratch;
pub use observer::{ExpansionCallback, Expansions};
pub use observer::{Observer, Observers, Progress, ProgressCallback, Trace};
pub use one_way::{Found, one_way, one_way_deferring};
pub use open_list::Order;
pub use recorded::{Considered, Legality, Part, record_deferring, record_one_way};
pub use recorded_both::record_bidirectional;
pub use recorded_domain::{
    Ground, Labelled, Told, Watched, record_best_first, record_bidirectional_best_first,
};
pub use recording::{BACKWARD, Fate, PAST, Recording, StepKind};
pub use stats::SearchStats;
pub use tree::Tree;
