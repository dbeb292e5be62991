//! The first seeds of every target.

use parkade_fuzz::TARGETS;

#[test]
fn answers_are_right() {
    for target in TARGETS {
        for seed in 0..target.sample {
            if let Err(wrong) = target.ask(seed) {
                panic!("{} {seed}: {wrong}", target.name);
            }
        }
    }
}
