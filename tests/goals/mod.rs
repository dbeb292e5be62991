//! Scenes with several goals: which one is taken, what that costs in work, and what is refused.

mod lots;
mod planning;
#[cfg(not(target_arch = "wasm32"))]
mod quality;
mod scenes;
