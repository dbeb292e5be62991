//! Figures 4 and 5 of the parking paper: three volumes around the car, their speed and their wrong answers.

use std::fmt::Write as _;
use std::time::Instant;

use parkade::papers::volumes::{Comparison, SCENES, compare};

const POSES: u32 = 100_000;
const SEED: u64 = 1;
/// Rounds of which the fastest counts.
const ROUNDS: u32 = 5;

pub(crate) fn print(as_json: bool) {
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64() * 1e3;
    let all: Vec<Comparison> = SCENES
        .iter()
        .map(|scene| compare(scene, POSES, SEED, ROUNDS, &mut clock).expect("a scene of the list"))
        .collect();
    if as_json {
        println!("{:#}", serde_json::json!(all));
    } else {
        print!("{}", markdown(&all));
    }
}

fn markdown(all: &[Comparison]) -> String {
    let mut text = format!(
        "# Bounding volumes, figures 4 and 5 of the parking paper\n\n{POSES} poses at random on each map (seed \
         {SEED}), each volume against all lines, one after the other, and the exact body beside it.\nA false alarm is \
         a hit where the body is free; missed is a body wholly behind a line, which no line tells.\n\n| scene | lines \
         | collisions | volume | hits | false alarms | of free poses | missed | area, bodies | µs a pose |\n| --- | \
         --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
    );
    for found in all {
        let free = f64::from(found.poses - found.collisions);
        for line in &found.volumes {
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {} | {:.1} % | {} | {:.2} | {:.3} |",
                found.scene,
                found.lines,
                found.collisions,
                line.volume,
                line.hits,
                line.false_alarms,
                100.0 * f64::from(line.false_alarms) / free,
                line.missed,
                line.area,
                line.micros
            );
        }
    }
    text
}
