//! Driving in time: trajectories, closed-loop tracking, and waiting for moving obstacles.
#![cfg(feature = "complete")]

mod following;
#[path = "../outlines/mod.rs"]
mod outlines;
mod row;
mod times;
mod vectors;
mod waiting;
