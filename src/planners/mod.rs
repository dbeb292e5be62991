//! planners.
