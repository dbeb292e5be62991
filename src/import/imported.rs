//! What an import gives.

use crate::geometry::Pose;
use crate::scenario::Scenario;

/// The scenes and queries of the imported files.
/// A `movingai` or `ros-map` import has one scene, a `tpcap` file one, a file of lots one for each question.
#[derive(Debug, Clone)]
pub struct Imported {
    /// `movingai`, `ros-map`, `tpcap`, `lots` or `scene`.
    pub format: &'static str,
    /// The scenes, at least one.
    pub scenes: Vec<Scenario>,
    /// The questions that come with the map.
    pub queries: Vec<Question>,
    /// Remarks for people about how the files were read.
    pub notes: Vec<String>,
}

/// A start, a goal and the length of the shortest path between them.
/// Lengths and poses are in metres of the scene, whatever unit the file counts in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// The group of questions of about the same length that it is in.
    pub bucket: u32,
    /// The centre of the start's cell; the heading points to the goal.
    pub start: Pose,
    /// The centre of the goal's cell; the heading points away from the start.
    pub goal: Pose,
    /// Length of the shortest eight-connected path that touches no corner of a blocked cell, metres.
    pub length: f64,
}
