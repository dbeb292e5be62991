//! Recorded searches followed by the rules of a search as one writes it down.

use std::collections::BTreeMap;

use parkade::search::{BACKWARD, Fate, PAST, Recording, StepKind};

/// The moves of each step: target, fate, g, h.
pub(crate) fn offers(r: &Recording, step: usize) -> impl Iterator<Item = (u32, u8, f64, f64)> {
    let all = r.first[step] as usize..r.first[step + 1] as usize;
    all.map(|at| (r.targets[at], r.fates[at] % PAST, r.target_g[at], r.target_h[at]))
}

/// An entry of the plain open list: f, h, age, node, whether it waits for deferred moves.
type Entry = (f64, f64, usize, u32, bool);

/// Steps and fates follow from the recording's own moves by the rules of a search as one writes it down.
pub(crate) fn follows_the_rules(r: &Recording, roots: [u32; 2]) {
    let mut known: [BTreeMap<u32, (f64, bool)>; 2] = Default::default();
    let mut open: [Vec<Entry>; 2] = Default::default();
    for (side, root) in roots.into_iter().enumerate() {
        known[side].insert(root, (0.0, false));
        if let Some(first) = (0..r.nodes.len()).find(|&step| usize::from(r.kinds[step] / BACKWARD) == side) {
            assert_eq!((r.nodes[first], r.g[first]), (root, 0.0));
            open[side].push((r.f[first], r.h[first], 0, root, false));
        }
    }
    let mut age = 1;
    let is_nba = r.kinds.iter().any(|kind| kind % BACKWARD == StepKind::Rejected as u8);
    for step in 0..r.nodes.len() {
        let side = usize::from(r.kinds[step] / BACKWARD);
        let (node, kind) = (r.nodes[step], r.kinds[step] % BACKWARD);
        open[side].retain(|one| one.4 || !known[side][&one.3].1);
        let ties = |a: &Entry, b: &Entry| {
            if r.oldest_first { a.2.cmp(&b.2) } else { a.1.total_cmp(&b.1).then(b.2.cmp(&a.2)) }
        };
        let least = |a: &&Entry, b: &&Entry| a.0.total_cmp(&b.0).then(ties(a, b));
        let &first = open[side].iter().min_by(least).unwrap();
        assert_eq!((first.0, first.1, first.3), (r.f[step], r.h[step], node), "step {step}");
        assert_eq!(first.4, kind == StepKind::Deferred as u8);
        open[side].retain(|one| one.2 != first.2);
        assert_eq!(known[side][&node].0, r.g[step]);
        if !first.4 {
            assert_eq!(r.f[step], r.g[step] + r.h[step]);
        }
        known[side].insert(node, (r.g[step], true));
        if is_nba {
            known[1 - side].entry(node).or_insert((0.0, true)).1 = true;
        }
        if kind == StepKind::Goal as u8 || kind == StepKind::Meet as u8 {
            assert_eq!(step + 1, r.nodes.len());
            return;
        }
        for (target, fate, g, h) in offers(r, step) {
            let before = known[side].get(&target).copied();
            match (fate, before) {
                (0, None) => {}
                (1, Some((old, false))) => assert!(g < old),
                (2, Some((old, false))) => assert!(g >= old),
                (3, Some((_, true))) | (4 | 5, _) => continue,
                (6 | 8, before) => assert!(before.is_none_or(|(old, closed)| !closed && g < old)),
                (7, _) => assert_eq!(target, node),
                other => panic!("step {step}: {other:?}"),
            }
            if fate < 2 {
                known[side].insert(target, (g, false));
                open[side].push((g + h, h, age, target, false));
                age += 1;
            } else if fate == Fate::Requeued as u8 {
                open[side].push((g + h + r.penalty, h, age, node, true));
                age += 1;
            }
        }
    }
}
