//! How tight it can be: what becomes of scenes over two of their sizes.

use std::num::NonZero;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use parkade::planners::hybrid::Config;
use parkade::vehicle::Vehicle;
use serde_json::{Value, json};

use crate::CARS;
use crate::answer::{Answer, Ending};
use crate::tally::Tally;
use crate::tight_scenes::{Scene, bay, corner, kerb};

/// A scene for a car, by seed, of exactly these two sizes in metres.
type Make = fn(&Vehicle, u64, f64, f64) -> Scene;

/// Sizes from the first on, so many, this far apart.
type Axis = (f64, usize, f64);

struct Family {
    name: &'static str,
    make: Make,
    /// Along the map and up, for each car.
    axes: fn(&Vehicle) -> [Axis; 2],
}

const FAMILIES: [Family; 3] = [
    Family {
        name: "kerb",
        make: |car, seed, x, y| kerb(car, seed, (x, x), (y, y)),
        axes: |_| [(0.3, 12, 0.2), (3.5, 7, 0.5)],
    },
    Family {
        name: "bay",
        make: |car, seed, x, y| bay(car, seed, (x, x), (y, y)),
        axes: |_| [(0.3, 10, 0.1), (3.5, 8, 0.5)],
    },
    Family {
        name: "corner",
        make: |car, seed, x, y| corner(car, seed, (x, x), (y, y)),
        axes: |car| [(car.width + 0.4, 8, 0.4); 2],
    },
];

/// Every family for every car, `count` scenes a cell; every so-many-th cell only. Maps are shared out to threads: a
/// thread counts its own time.
pub(crate) fn measure(count: u64, every: u64) -> Vec<Value> {
    let asked: Vec<_> = FAMILIES.iter().flat_map(|family| CARS.map(|car| (family, car))).collect();
    let (next, maps) = (AtomicUsize::new(0), asked.iter().map(|_| OnceLock::new()).collect::<Vec<_>>());
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, NonZero::get) {
            scope.spawn(|| {
                loop {
                    let at = next.fetch_add(1, Ordering::Relaxed);
                    let Some((&(family, car), made)) = asked.get(at).zip(maps.get(at)) else { break };
                    made.get_or_init(|| map(family, car, count, every.max(1)));
                }
            });
        }
    });
    maps.into_iter().filter_map(OnceLock::into_inner).collect()
}

fn map(family: &Family, (car, vehicle): (&str, Vehicle), count: u64, every: u64) -> Value {
    let [along, up] = (family.axes)(&vehicle).map(sizes);
    let mut all = Tally::default();
    let mut cells = Vec::new();
    let mut number = 0;
    for &y in &up {
        let mut row = Vec::new();
        for &x in &along {
            number += 1;
            let is_chosen = number % every == 0;
            let mut tally = Tally::default();
            if is_chosen {
                let scenes = (1..=count).map(|seed| (family.make)(&vehicle, seed, x, y));
                tally.answers = scenes.map(|scene| Answer::of(&scene, &Config::default())).collect();
            }
            row.push(if is_chosen { cell(&tally) } else { Value::Null });
            all.add(tally);
        }
        cells.push(row);
    }
    let milliseconds = [0.5, 0.95].map(|share| all.milliseconds(share));
    let (length, width) = (vehicle.length(), vehicle.width);
    json!({
        "family": family.name, "vehicle": car, "length": length, "width": width,
        "x": along, "y": up, "cells": cells, "milliseconds": milliseconds,
    })
}

fn cell(tally: &Tally) -> Value {
    json!([tally.count(Ending::Solved), tally.undecided(), tally.changes(0.5)])
}

fn sizes((first, count, step): Axis) -> Vec<f64> {
    // Rounded to whole centimetres.
    (0..count).map(|at| ((first + at as f64 * step) * 100.0).round() / 100.0).collect()
}
