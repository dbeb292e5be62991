//! The first seeds of every target, and what guided fuzzers begin with and have found.

use std::fs;
use std::path::Path;

use parkade_fuzz::{TARGETS, guided};

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

#[test]
fn seeds_of_the_guided_fuzzers_are_answered() {
    let seeds = Path::new(env!("CARGO_MANIFEST_DIR")).join("guided/seeds");
    let mut asked = 0;
    for parser in ["lots", "movingai", "rosmap", "scene", "tpcap"] {
        for file in fs::read_dir(seeds.join(parser)).expect("a folder of seeds") {
            guided(parser, &fs::read(file.expect("a file").path()).expect("a readable file"));
            asked += 1;
        }
    }
    assert!(asked >= 13, "{asked}");
}
