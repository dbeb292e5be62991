//! Whether more freedom costs more: pairs of settings on random scenes, each answer against the other settings' path
//! under the same measure. Prints for each pair how many answers cost over 1 % more, and by how much; and how many of
//! these still do after a search for better paths, as `alternatives` asks for.
//!
//! ```sh
//! cargo run --release --example freedom [count] [first seed] [verbose] [random|KIND …]
//! ```

#[path = "../../tests/freedom/mod.rs"]
mod freedom;
#[path = "../../tests/random_scenes/mod.rs"]
#[expect(dead_code, reason = "scenes are planned with other settings")]
mod random_scenes;
#[path = "../../tests/tight_scenes/mod.rs"]
#[expect(dead_code, reason = "scenes are planned as they are drawn")]
mod tight_scenes;

use freedom::{Answers, Compared, MARGINS, OTHERS, PRICES, Pair, Question};
use parkade::planners::hybrid::{Config, obstacles};
use parkade::vehicle::Vehicle;
use tight_scenes::KINDS;

/// More than this is a loss.
const LOSS: f64 = 1.01;

fn pairs() -> impl Iterator<Item = Pair> {
    PRICES.into_iter().chain(MARGINS).chain(OTHERS)
}

/// Of one pair: how many comparisons, and the ratios above 1 %, of the coarsest level's answers and of others.
#[derive(Clone, Default)]
struct Tally {
    count: u32,
    coarse: Vec<f64>,
    fine: Vec<f64>,
    /// What is left above 1 % after a search for better paths.
    left: Vec<f64>,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number =
        |at: usize, default: u64| words.get(at).and_then(|word| word.parse().ok()).unwrap_or(default);
    let is_verbose = words.iter().any(|word| word == "verbose");
    let kinds: Vec<&str> =
        words.iter().skip(2).map(String::as_str).filter(|&word| word != "verbose").collect();
    let is_asked = |kind: &str| kinds.is_empty() || kinds.contains(&kind);
    let mut tallies = vec![Tally::default(); pairs().count()];
    for seed in number(1, 1)..number(1, 1) + number(0, 20) {
        let (scene, _) = random_scenes::scene(seed);
        let geometry = scene.geometry().expect("a valid scene");
        let around = obstacles(&geometry);
        let (start, goal) = (geometry.start, geometry.goal);
        let question = Question { obstacles: &around, vehicle: geometry.vehicle, start, goal };
        if is_asked("random") {
            ask(&format!("random, seed {seed}"), question, &mut tallies, is_verbose);
        }
        let car = [Vehicle::SEDAN, Vehicle::PAPER][seed as usize % 2];
        for (_, make) in KINDS.into_iter().filter(|(kind, _)| is_asked(kind)) {
            let scene = make(&car, seed);
            let (start, goal) = (scene.start, scene.goal);
            let question = Question { obstacles: &scene.obstacles, vehicle: scene.vehicle, start, goal };
            ask(&format!("{}, seed {seed}", scene.name), question, &mut tallies, is_verbose);
        }
    }
    println!(
        "| asked for | compared | over 1 % dearer, coarsest level | worst | other levels | worst \
         | after a search | worst |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for (pair, tally) in pairs().zip(&tallies) {
        let worst = |ratios: &[f64]| ratios.iter().copied().fold(1.0, f64::max);
        let (coarse, fine) = (&tally.coarse, &tally.fine);
        println!(
            "| {} | {} | {} | {:.3} | {} | {:.3} | {} | {:.3} |",
            pair.name,
            tally.count,
            coarse.len(),
            worst(coarse),
            fine.len(),
            worst(fine),
            tally.left.len(),
            worst(&tally.left)
        );
    }
}

fn ask(name: &str, question: Question, tallies: &mut [Tally], is_verbose: bool) {
    let answers = Answers::new(question);
    for (pair, tally) in pairs().zip(tallies) {
        let Some(Compared { ratio, levels }) = pair.compare(&answers, Config::default()) else { continue };
        tally.count += 1;
        if ratio > LOSS {
            if levels == [0, 0] { &mut tally.coarse } else { &mut tally.fine }.push(ratio);
            let left =
                if ratio.is_finite() { pair.ratio_after_search(&answers, Config::default()) } else { ratio };
            if left > LOSS {
                tally.left.push(left);
            }
            if is_verbose {
                println!("{name}: {}: {ratio:.3}, levels {levels:?}, after a search {left:.3}", pair.name);
            }
        }
    }
}
