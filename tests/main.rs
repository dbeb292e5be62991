//! All of the crate's integration tests in one program: it is linked once, and in WebAssembly it is bound once.

mod acceptance;
mod comparators;
mod costs;
mod drive;
#[cfg(not(target_arch = "wasm32"))]
#[expect(dead_code, reason = "some pairs are only measured")]
mod freedom;
mod goals;
mod golden;
mod grid;
mod hybrid;
mod import;
#[cfg(not(target_arch = "wasm32"))]
mod layers;
mod opening;
mod outlines;
mod papers;
mod parity;
mod queries;
mod random_maps;
mod random_scenes;
mod rasters;
mod recorded;
mod recorded_poses;
mod recorded_road;
mod recorded_samples;
mod recordings;
mod road;
mod tight_scenes;
mod trajectory;
