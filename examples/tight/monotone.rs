//! Whether more room ever means more gear changes.

use parkade::vehicle::Vehicle;

use crate::Run;
use crate::answer::Answer;
use crate::tight_scenes::kerb;

/// Slot less car: the least, the most and the steps between, metres.
const SLACK: (f64, f64, f64) = (0.85, 2.5, 0.05);
/// Width of the street, metres.
const STREET: (f64, f64) = (4.2, 6.5);

/// Prints the gear changes of each slot by its length, and in how many a shorter one needs fewer, by more than one.
pub(crate) fn print(run: &Run) {
    let steps = ((SLACK.1 - SLACK.0) / SLACK.2).round() as u32;
    let (mut all, mut worse, mut worst) = (0, [0; 2], [0; 2]);
    for seed in run.seeds.clone() {
        let answer = |step: u32| {
            let slack = SLACK.0 + SLACK.2 * f64::from(step);
            Answer::of(&kerb(&Vehicle::SEDAN, seed, (slack, slack), STREET), &run.config)
        };
        let answers: Vec<Answer> = (0..=steps).map(answer).filter(Answer::is_solved).collect();
        for (at, long) in answers.iter().enumerate() {
            let keeps = |short: &&Answer| short.margin >= long.margin;
            let fewest = |changes: Option<u32>| long.changes.saturating_sub(changes.unwrap_or(u32::MAX));
            let shorter = &answers[..at];
            let more = [
                fewest(shorter.iter().map(|short| short.changes).min()),
                fewest(shorter.iter().filter(keeps).map(|short| short.changes).min()),
            ];
            all += 1;
            for (kind, more) in more.into_iter().enumerate() {
                worse[kind] += u32::from(more > 1);
                worst[kind] = worst[kind].max(more);
            }
        }
        if run.is_verbose {
            let each = |a: &Answer| format!("{}/{:.0}/{}", a.changes, a.margin * 100.0, a.checks);
            println!(
                "seed {seed}, changes/cm/checks: {}",
                answers.iter().map(each).collect::<Vec<_>>().join(" ")
            );
        }
    }
    println!(
        "of {all} slots {} take two or more changes more than a shorter one, {} than one with as much margin, at most \
         {} and {} more",
        worse[0], worse[1], worst[0], worst[1]
    );
}
