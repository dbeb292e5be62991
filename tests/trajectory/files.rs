//! CSV that is damaged by a seed is refused by line and column, or judged.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::error::ErrorCode;
use parkade::referee::{MotionLimits, Submission, judge, read};
use parkade::scenario::catalog;

/// A small generator whose numbers are the same everywhere.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }
}

fn sound(timed: bool) -> String {
    let header = if timed { "t,x,y,theta,v,phi" } else { "x,y,theta,gear" };
    let row = |k: u32| {
        let t = f64::from(k) / 2.0;
        if timed {
            format!("{t},{},3.25,-0.125,{},0.01", 4.0 + t, t.min(6.5 - t))
        } else {
            format!("{},3.25,0,{}", 4.0 + t, if k < 9 { 1 } else { -1 })
        }
    };
    std::iter::once(header.to_owned()).chain((0..=13).map(row)).collect::<Vec<_>>().join("\n")
}

/// The text with one thing wrong.
fn damaged(text: &str, r: &mut Random) -> String {
    const JUNK: [&str; 16] = [
        "", "nan", "inf", "-", "1e999", "0x10", "\"1\"", "1,2", "1;2", " ", "\u{fffd}", "1.2.3", "--1", "\t",
        "１", "-1e8",
    ];
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let (line, junk) = (r.below(lines.len()), JUNK[r.below(JUNK.len())]);
    match r.below(6) {
        0 => {
            lines.remove(line);
        }
        1 => lines[line] = lines[line].chars().take(r.below(12)).collect(),
        2 => lines[line] += junk,
        3 => {
            let copy = lines[line].clone();
            lines.insert(line, copy);
        }
        4 => lines[line] = String::new(),
        _ => {
            let mut fields: Vec<&str> = lines[line].split(',').collect();
            let field = r.below(fields.len());
            fields[field] = junk;
            lines[line] = fields.join(",");
        }
    }
    lines.join("\n")
}

#[test]
fn damaged_files_are_refused_by_line_and_column_or_judged() {
    let geometry = catalog::scenario("perpendicular").unwrap().geometry().unwrap();
    let (mut refused, mut judged) = (0, 0);
    for seed in 0..1000 {
        let mut r = Random(seed * 7919 + 1);
        let text = damaged(&sound(seed % 2 == 0), &mut r);
        match read(&text) {
            Err(error) => {
                assert_eq!(error.code, ErrorCode::Import, "seed {seed}");
                let (line, column) = error.path.split_once(':').expect("a line and a column");
                let line: usize = line.parse().unwrap();
                let column: usize = column.parse().unwrap();
                let there = text.lines().nth(line - 1).unwrap_or_default();
                assert!(line >= 1 && line <= text.lines().count().max(1), "seed {seed}: {error}");
                assert!(
                    (1..=there.chars().count() + 1).contains(&column),
                    "seed {seed}: {error} in {there:?}"
                );
                assert!(error.message().contains("must"), "seed {seed}: {error}");
                refused += 1;
            }
            Ok(submission) => {
                match judge(&geometry, &submission, &MotionLimits::default()) {
                    Ok(found) => assert!(found.figures.duration.is_finite() && found.contacts.frames > 0),
                    // A path may turn more than the car can, or on the spot, or lead around the world.
                    Err(error) => {
                        assert!(matches!(submission, Submission::Path { .. }), "seed {seed}: {error}");
                        assert!(error.path.starts_with("path"), "seed {seed}: {error}");
                    }
                }
                judged += 1;
            }
        }
    }
    assert!(refused > 500 && judged > 50, "{refused} refused, {judged} judged");
}

#[test]
fn sound_files_are_judged() {
    let geometry = catalog::scenario("perpendicular").unwrap().geometry().unwrap();
    for timed in [true, false] {
        let found = judge(&geometry, &read(&sound(timed)).unwrap(), &MotionLimits::default()).unwrap();
        assert!(!found.attained && found.figures.duration > 6.0);
    }
}
