//! Options of a plan as JSON, native only: in wasm they come with callbacks.
//!
//! Callbacks have no JSON; a caller sets them on the result. `null` counts as absent, so that a caller may pass a field
//! on that it does not have.

use serde_json::{Map, Value};

use super::{Ends, Options, Prefer};
use crate::error::{Error, ErrorCode};
use crate::json::{self, Words as _};
use crate::scenario::{Scenario, parse};

impl Options<'_> {
    /// Reads the options of the JS API's `plan` but for callbacks: `trace`, `prefer`, `alternatives`, `stickiness`, and
    /// `start` and `goal`, which are poses or slots, as the scene's own goal may be one.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] for another field, for a value that breaks its rule, and for a slot that the scene does not
    /// have.
    ///
    /// # Examples
    /// ```
    /// use parkade::plan::Options;
    ///
    /// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
    /// let fields = serde_json::json!({ "trace": true, "start": { "x": 2, "y": 3, "heading": 0 } });
    /// let (options, ends) = Options::from_json(&scene, fields.as_object().unwrap()).unwrap();
    /// assert!(options.trace && ends.start.is_some() && ends.goal.is_none());
    /// ```
    pub fn from_json(scene: &Scenario, fields: &Map<String, Value>) -> Result<(Self, Ends), Error> {
        let (mut options, mut ends) = (Self::default(), Ends::default());
        for (name, value) in fields.iter().filter(|field| !field.1.is_null()) {
            let wrong = |e: Error| e.within(name).with_code(ErrorCode::Input);
            match name.as_str() {
                "trace" => options.trace = json::flag(value).map_err(wrong)?,
                "alternatives" => options.alternatives = json::flag(value).map_err(wrong)?,
                "prefer" => options.prefer = Some(json::word(Prefer::WORDS)(value).map_err(wrong)?),
                "stickiness" => {
                    let share = json::number(value).ok().filter(|share| (0.0..=1.0).contains(share));
                    let rule = message!("must be between 0 and 1, got {}", value);
                    options.stickiness = share.ok_or_else(|| Error::new(ErrorCode::Input, name, rule))?;
                }
                "start" | "goal" => {
                    let pose = parse::goal(value).and_then(|goal| scene.goal_pose(&goal));
                    let end = if name == "start" { &mut ends.start } else { &mut ends.goal };
                    *end = Some(pose.map_err(wrong)?);
                }
                _ => {
                    let message =
                        "no option of plan; there are trace, start, goal, prefer, alternatives, stickiness";
                    return Err(Error::new(ErrorCode::Input, name, message));
                }
            }
        }
        Ok((options, ends))
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::plan::Options;
    use crate::scenario::catalog;

    #[test]
    fn wrong_options_are_named() {
        let scene = catalog::scenario("perpendicular").unwrap();
        let refused = |fields: serde_json::Value| {
            let error = Options::from_json(&scene, fields.as_object().unwrap()).map(|_| ()).unwrap_err();
            assert_eq!(error.code.as_str(), "bad-input");
            error.to_string()
        };
        assert_eq!(refused(json!({ "trace": 1 })), "trace: must be true or false, got 1");
        assert_eq!(refused(json!({ "stickiness": 2 })), "stickiness: must be between 0 and 1, got 2");
        assert_eq!(refused(json!({ "start": { "x": 1 } })), "start.y: missing field");
        assert!(refused(json!({ "prefer": "short" })).starts_with("prefer: must be shortest"));
        assert!(
            refused(json!({ "goal": { "slot": "none", "entry": "reverse-in" } }))
                .contains("must be the id of a slot")
        );
        assert!(refused(json!({ "traces": true })).starts_with("traces: no option of plan; there are"));
        assert!(Options::from_json(&scene, json!({ "goal": null }).as_object().unwrap()).is_ok());
    }
}
