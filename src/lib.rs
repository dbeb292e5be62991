//! Vehicle path planners: grid A*, risk-field A*, hybrid A* — one scene, many answers.

pub mod error;
pub mod geometry;
pub mod map;
pub mod metrics;
pub mod plan;
pub mod planners;
pub mod post;
pub mod scenario;
pub mod search;
pub mod vehicle;
#[cfg(target_arch = "wasm32")]
mod wasm;

pub use error::Error;
