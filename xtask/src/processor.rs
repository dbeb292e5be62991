//! Processor time: unlike the clock, it says what a suite costs while others run beside it.

use std::fs;

/// Linux counts in ticks of this many a second, on every processor.
const TICKS: f64 = 100.0;
/// Fields of `/proc/self/stat` after the program's name: user and system time of programs waited for.
const OF_CHILDREN: [usize; 2] = [13, 14];

/// Seconds that all programs took that this one started and saw end; nothing where the system does not tell.
pub(crate) fn seconds() -> Option<f64> {
    children(&fs::read_to_string("/proc/self/stat").ok()?)
}

fn children(stat: &str) -> Option<f64> {
    // The name is in brackets and may hold blanks.
    let fields: Vec<_> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = OF_CHILDREN.map(|at| fields.get(at).and_then(|field| field.parse::<f64>().ok()));
    Some((ticks[0]? + ticks[1]?) / TICKS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_with_blanks_and_brackets_moves_no_field() {
        let stat = "7 (a (b) c) S 1 7 7 0 -1 4194304 100 200 0 0 11 12 1300 250 20 0 1";
        assert_eq!(children(stat), Some(15.5));
        assert_eq!(children("7 (a) S 1"), None);
    }
}
