//! Driving in time: trajectories, closed-loop tracking, and waiting for moving obstacles.
#![cfg(feature = "complete")]

mod following;
mod row;
mod times;
mod vectors;
mod waiting;
