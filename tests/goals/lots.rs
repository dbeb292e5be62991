//! Lots by seed: two aisles joined at both ends, with rows of slots on either side, most of them taken.

use parkade::scenario::Scenario;
use parkade::scenario::generate::SplitMix64;
use serde_json::{Value, json};

const HALF_TURN: f64 = std::f64::consts::PI;

pub(crate) struct Random(SplitMix64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(SplitMix64::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x60a1))
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, count: usize) -> usize {
        self.0.below(count as u32) as usize
    }
}

/// Slots from `from` to `to` along the aisle's side at height `y`, pointing up or down.
fn row(random: &mut Random, slots: &mut Vec<Value>, [from, to]: [f64; 2], y: f64, up: bool) {
    let kind = ["perpendicular", "perpendicular", "angled", "parallel"][random.below(4)];
    let (width, length) = match kind {
        "parallel" => (random.between(2.1, 2.5), random.between(6.2, 7.2)),
        _ => (random.between(2.4, 2.8), random.between(4.9, 5.3)),
    };
    let angle = random.between(0.8, 1.2);
    let lean = ["left", "right"][random.below(2)];
    let pitch = match kind {
        "parallel" => length,
        "angled" => width / parkade::geometry::math::sin_cos(angle).0,
        _ => width,
    };
    let shift = if kind == "angled" { 2.5 } else { 0.0 };
    let mut x = from + shift + pitch / 2.0;
    while x + pitch / 2.0 <= to - shift {
        let mut slot = json!({
            "id": format!("slot-{}", slots.len() + 1), "kind": kind, "x": x, "y": y,
            "heading": if up { HALF_TURN / 2.0 } else { -HALF_TURN / 2.0 },
            "width": width, "length": length, "occupied": true,
        });
        if kind == "angled" {
            (slot["angle"], slot["lean"]) = (json!(angle), json!(lean));
        }
        slots.push(slot);
        x += pitch;
    }
}

/// A lot with so many free slots.
pub(crate) fn lot(seed: u64, free: usize) -> Scenario {
    let mut random = Random::new(seed);
    let length = random.between(30.0, 50.0);
    let (lane, aisles) = (random.between(5.5, 7.0), [random.between(5.5, 7.0), random.between(5.5, 7.0)]);
    let depth = 5.4;
    let ends = [lane, lane + length];
    let lows = [depth, depth + aisles[0] + 2.0 * depth];
    let mut slots = Vec::new();
    for (low, wide) in lows.into_iter().zip(aisles) {
        row(&mut random, &mut slots, ends, low, false);
        row(&mut random, &mut slots, ends, low + wide, true);
    }
    let mut taken: Vec<usize> = (0..slots.len()).collect();
    for _ in 0..free.min(slots.len()) {
        let at = taken.swap_remove(random.below(taken.len()));
        slots[at]["occupied"] = json!(false);
    }
    let aisle = random.below(2);
    let turned = if random.below(2) == 0 { 0.0 } else { HALF_TURN };
    let start = json!({
        "x": random.between(lane + 5.0, lane + length - 5.0),
        "y": lows[aisle] + aisles[aisle] / 2.0 + random.between(-0.6, 0.6),
        "heading": turned + random.between(-0.1, 0.1),
    });
    let size = [2.0 * lane + length, lows[1] + aisles[1] + depth];
    let cells = size.map(|side| (side / 0.5).ceil());
    Scenario::from_json(&json!({
        "version": 1,
        "map": { "origin": [0.0, 0.0], "width": cells[0] as u32, "height": cells[1] as u32, "resolution": 0.5 },
        "slots": slots,
        "vehicle": "sedan",
        "start": start,
        "goal": { "slots": "free", "entry": "either" },
    }))
    .unwrap()
}
