//! Trajectories: the referee on files that are damaged, and plans that are optimised.
#![cfg(feature = "complete")]

mod encounters;
mod files;
mod optimised;
#[path = "../outlines/mod.rs"]
mod outlines;
#[path = "../random_scenes/mod.rs"]
#[expect(dead_code, reason = "plans are checked elsewhere")]
mod random_scenes;
#[path = "../tight_scenes/mod.rs"]
mod tight_scenes;
