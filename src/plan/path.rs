//! Paths as callers hand them over: numbers, checked, and the figures of such paths.
//!
//! The boundary of the library for paths that it did not make: from JavaScript, the command line or a file. Poses come
//! as flat numbers x, y, heading, …, in metres and radians of the world frame, with a gear (±1) and perhaps a curvature
//! (1/m) of the way on from each. Here they are checked once (number, finite, range, equal lengths), so that the code
//! behind needs no checks of its own. An error names the list and the index of its first wrong number.

use super::measured::NEAR;
use crate::error::{Error, ErrorCode, Message};
use crate::geometry::Pose;
use crate::metrics::random_drives::{self, Risk};
use crate::metrics::road::{Figures, figures};
use crate::metrics::{Body, Check, check};
use crate::scenario::Scenario;
use crate::scenario::resolve::Geometry;

fn refused<T>(path: impl Into<String>, message: Message) -> Result<T, Error> {
    Err(Error::new(ErrorCode::Input, path, message))
}

/// The poses of x, y, heading, ….
pub(super) fn poses(path: &[f64]) -> Result<Vec<Pose>, Error> {
    if !path.len().is_multiple_of(3) {
        return refused("path", message!("must be x, y, heading for each pose, got {} numbers", path.len()));
    }
    if let Some(i) = path.iter().position(|v| !v.is_finite()) {
        return refused(format!("path[{i}]"), message!("must be a finite number, got {}", path[i]));
    }
    Ok(path.chunks_exact(3).map(|p| Pose::new(p[0], p[1], p[2])).collect())
}

/// Metres of the longest path that is driven or measured along its way, and of the longest side of a map on which a
/// car's way is looked for: time and memory grow with it.
pub(super) const MAX_LENGTH: f64 = 100_000.0;

/// Along the chords between poses.
pub(super) fn length(poses: &[Pose]) -> f64 {
    poses.windows(2).map(|pair| (pair[1].point() - pair[0].point()).norm()).sum()
}

/// The poses of x, y, heading, …, along a way that is not too long.
fn way(path: &[f64]) -> Result<Vec<Pose>, Error> {
    let poses = poses(path)?;
    let length = length(&poses);
    if length > MAX_LENGTH {
        return refused("path", message!("must be at most {} m long, got {} m", MAX_LENGTH, length));
    }
    Ok(poses)
}

/// The poses of x, y, heading, ….
///
/// # Errors
/// [`ErrorCode::Input`] when the numbers are not poses, or are a way of more than 100 km.
///
/// # Examples
/// ```
/// use parkade::plan::path_poses;
///
/// assert_eq!(path_poses(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0]).unwrap().len(), 2);
/// assert!(path_poses(&[0.0, 0.0]).is_err());
/// assert!(path_poses(&[0.0, f64::NAN, 0.0]).unwrap_err().to_string().starts_with("path[1]"));
/// ```
pub fn path_poses(path: &[f64]) -> Result<Vec<Pose>, Error> {
    way(path)
}

/// The same, at least one.
pub(super) fn some_poses(path: &[f64]) -> Result<Vec<Pose>, Error> {
    let poses = way(path)?;
    if poses.is_empty() {
        return refused("path", "must have poses; there is nothing to measure".into());
    }
    Ok(poses)
}

/// Gears of a path of so many poses, forward where absent.
pub(super) fn gears(directions: Option<&[i8]>, poses: usize) -> Result<Vec<i8>, Error> {
    let directions = directions.map_or_else(|| vec![1; poses], <[i8]>::to_vec);
    if directions.len() != poses {
        return refused("directions", message!("must be one per pose ({}), got {}", poses, directions.len()));
    }
    match directions.iter().position(|d| d.abs() != 1) {
        Some(i) => refused(format!("directions[{i}]"), message!("must be 1 or -1, got {}", directions[i])),
        None => Ok(directions),
    }
}

/// The way along a path, to be driven: x, y, heading, …; the gear (forward where absent) and, where known, the
/// curvature of the way on from each pose.
///
/// # Errors
/// [`ErrorCode::Input`] when the numbers are not poses, the gears not ±1, or no car of these dimensions can drive it.
pub fn route(
    geometry: &crate::scenario::resolve::Geometry,
    path: &[f64],
    directions: Option<&[i8]>,
    curvatures: Option<&[f64]>,
) -> Result<crate::drive::Route, Error> {
    let poses = way(path)?;
    let directions = gears(directions, poses.len())?;
    if let Some(curvatures) = curvatures.filter(|k| k.len() != poses.len()) {
        let message = message!("must be one per pose ({}), got {}", poses.len(), curvatures.len());
        return refused("curvatures", message);
    }
    crate::drive::Route::new(&geometry.vehicle, &poses, &directions, curvatures)
}

/// Optimises a path that a car can drive from its first pose to its last; speed limits of the scene hold.
///
/// The scene gives obstacles and speed limits; its own start and goal play no part. The path must be drivable first,
/// because the optimiser improves a path locally and does not look for another one.
///
/// # Errors
/// As [`route`] and [`crate::optimise::optimise`]; [`ErrorCode::Input`] for a path that fails its check.
pub fn optimise(
    scene: &crate::scenario::Scenario,
    (path, directions, curvatures): (&[f64], Option<&[i8]>, Option<&[f64]>),
    options: &crate::optimise::Options,
) -> Result<crate::optimise::Optimised, Error> {
    options.validate()?;
    let mut geometry = scene.geometry()?;
    let within = |e: Error| e.within("plan");
    let route = route(&geometry, path, directions, curvatures).map_err(within)?;
    let poses = way(path)?;
    let gears = gears(directions, poses.len())?;
    (geometry.start, geometry.goal, geometry.goals) = (poses[0], poses[poses.len() - 1], None);
    let body = Body::new(&geometry);
    let check = check(&geometry, &body, &poses, &gears, NEAR);
    if !check.drivable() {
        let message = message!("must pass its check, got \"{}\"", check.verdict.as_str());
        return refused("plan.path", message);
    }
    let route = route.with_speed_limits(&scene.all_speed_limits());
    crate::optimise::optimise(&geometry, &route, check.min_clearance, options)
}

/// Re-checks any path against a scene: x, y, heading, … and the gear of the way on from each pose (forward where
/// absent).
///
/// A path of any origin is judged as a plan's own is: collisions, turning radius, sliding, start and goal. It must end
/// within a millimetre of the goal to arrive.
///
/// # Examples
/// ```
/// use parkade::metrics::Verdict;
/// use parkade::plan::check_path;
///
/// let geometry = parkade::scenario::catalog::scenario("perpendicular").unwrap().geometry().unwrap();
/// let start = geometry.start;
/// let ahead = start.advance(0.0, 0.5);
/// let path = [start, ahead].map(|p| [p.x, p.y, p.heading]).concat();
/// assert_eq!(check_path(&geometry, &path, None).unwrap().verdict, Verdict::ArrivesTurned);
/// ```
///
/// # Errors
/// [`ErrorCode::Input`] when the numbers are not poses or the gears not ±1.
pub fn check_path(geometry: &Geometry, path: &[f64], directions: Option<&[i8]>) -> Result<Check, Error> {
    let poses = poses(path)?;
    let directions = gears(directions, poses.len())?;
    Ok(check(geometry, &Body::new(geometry), &poses, &directions, NEAR))
}

/// Figures of any path on a scene's road: x, y, heading, ….
///
/// The lanes are those on the right of the way from the scene's start to its goal. A path with corners can be measured,
/// too.
///
/// # Errors
/// [`ErrorCode::Input`] when the numbers are not poses, or none.
pub fn road_figures(scenario: &Scenario, path: &[f64]) -> Result<Figures, Error> {
    let (geometry, poses) = (scenario.geometry()?, some_poses(path)?);
    let lanes = scenario.lanes_between(geometry.start.point(), geometry.goal.point());
    Ok(figures(&geometry, &Body::new(&geometry), &lanes, &poses))
}

/// How often any path ends in a collision when nobody drives exactly along it: x, y, heading, ….
///
/// The seed and the numbers of the trials decide everything, so parts of the trials can run anywhere and be added.
///
/// # Errors
/// [`ErrorCode::Input`] when the numbers are not poses, or none, or too many metres would be driven.
pub fn collision_risk(
    scenario: &Scenario,
    path: &[f64],
    options: &random_drives::Options,
) -> Result<Risk, Error> {
    let (geometry, poses) = drivable(scenario, path, options)?;
    Ok(random_drives::collision_risk(&geometry, &Body::new(&geometry), &poses, options))
}

/// The band that the car's middle stays in during the drives of [`collision_risk`]: [`random_drives::drive_envelope`].
///
/// # Errors
/// As [`collision_risk`].
pub fn drive_envelope(
    scenario: &Scenario,
    path: &[f64],
    options: &random_drives::Options,
) -> Result<Vec<f64>, Error> {
    let (geometry, poses) = drivable(scenario, path, options)?;
    Ok(random_drives::drive_envelope(&geometry, &poses, options))
}

/// The poses of a path that is short enough for all trials.
fn drivable(
    scenario: &Scenario,
    path: &[f64],
    options: &random_drives::Options,
) -> Result<(Geometry, Vec<Pose>), Error> {
    let (geometry, poses) = (scenario.geometry()?, some_poses(path)?);
    let driven = f64::from(options.trials) * length(&poses);
    if driven > random_drives::MAX_DRIVEN {
        let message =
            message!("must drive at most {} m together, got {} m", random_drives::MAX_DRIVEN, driven);
        return Err(Error::new(ErrorCode::Input, "trials", message));
    }
    Ok((geometry, poses))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_without_end_are_refused() {
        let refused = |path: &[f64]| some_poses(path).unwrap_err().to_string();
        assert_eq!(
            refused(&[0.0, 0.0, 0.0, 1e6, 0.0, 0.0]),
            "path: must be at most 100000 m long, got 1000000 m"
        );
        assert_eq!(
            refused(&[1e308, 0.0, 0.0, -1e308, 0.0, 0.0]),
            "path: must be at most 100000 m long, got inf m"
        );
        assert!(some_poses(&[0.0, 0.0, 0.0, 1e5, 0.0, 0.0]).is_ok());
    }
}
