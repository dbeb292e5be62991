//! Trajectories: the referee on files that are damaged, and plans that are optimised.
#![cfg(feature = "complete")]

mod files;
mod optimised;
#[path = "../random_scenes/mod.rs"]
#[expect(dead_code, reason = "plans are checked elsewhere")]
mod random_scenes;
