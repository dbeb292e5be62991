//! Driving in time: trajectories, closed-loop tracking, and waiting for moving obstacles.

mod following;
mod row;
mod times;
mod vectors;
mod waiting;
