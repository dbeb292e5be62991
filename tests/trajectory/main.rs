//! Trajectories: the referee on files that are damaged.
#![cfg(feature = "complete")]

mod files;
