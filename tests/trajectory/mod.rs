//! Trajectories: the referee on files that are damaged, and plans that are optimised.

mod encounters;
mod files;
mod optimised;
