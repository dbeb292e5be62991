//! The order of the open list against a plain sort.

use super::*;

fn push(open: &mut OpenList<i64>, order: Order, f: i64, h: i64) {
    open.push(order, f, h, 0, EntryKind::Fresh);
}

/// The numbers of the pushes in the order in which they come out.
fn drain(order: Order, entries: &[(i64, i64)]) -> Vec<u32> {
    let mut open = OpenList::default();
    for &(f, h) in entries {
        push(&mut open, order, f, h);
    }
    std::iter::from_fn(|| open.pop(order)).map(|e| e.ticket / TICKET - 1).collect()
}

#[test]
fn ties_go_to_smaller_h_then_to_the_newest() {
    assert_eq!(drain(Order::Newest, &[(5, 3), (5, 1), (4, 4), (5, 1), (9, 0)]), [2, 3, 1, 0, 4]);
}

#[test]
fn ties_go_to_the_oldest() {
    assert_eq!(drain(Order::Oldest, &[(5, 3), (5, 1), (4, 4), (5, 1), (9, 0)]), [2, 0, 1, 3, 4]);
}

/// Pushes and pops mixed, priorities in and across buckets, before the origin and beyond the last bucket.
#[test]
fn the_order_is_exact_whatever_is_pushed() {
    let mut state = 7_u64;
    let mut random = move |n: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 33) % n
    };
    let mut open = OpenList::default();
    for round in 0..40 {
        open.reset(1_000_000);
        let begin = open.ticket();
        let mut held: Vec<(i64, i64, u32)> = Vec::new();
        let (mut number, mut last) = (0, 1_000_000);
        let steps = if round % 2 == 0 { 2000 } else { 300 };
        for _ in 0..steps {
            if random(3) < 2 {
                let f = match (random(50), round / 2 % 4) {
                    (0, _) => 1 << 50,
                    (1, _) => -5,
                    (_, 0) => random(40) as i64 * 100_003,
                    (_, 1) => last + random(5) as i64 * 1_414_214,
                    (_, 2) => last + random(70_000) as i64,
                    _ => last + random(20) as i64,
                };
                let h = random(8) as i64;
                push(&mut open, Order::Newest, f, h);
                held.push((f, h, number));
                number += 1;
            } else {
                let first = held.iter().enumerate().min_by_key(|(_, e)| (e.0, e.1, std::cmp::Reverse(e.2)));
                let want = first.map(|(i, _)| i).map(|i| held.swap_remove(i));
                assert_eq!(open.least(Order::Newest), want.map(|(f, ..)| f));
                let got = open.pop(Order::Newest).map(|e| (e.f, e.h, (e.ticket - begin) / TICKET));
                assert_eq!(got, want);
                last = got.map_or(last, |(f, ..)| f.clamp(1_000_000, 1 << 40));
            }
        }
    }
}
