//! Time of the processor, for the examples that measure.

use std::sync::LazyLock;
use std::time::Instant;

/// Milliseconds of the processor for this thread; of the clock where the system does not tell.
pub(crate) fn now() -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| BEGIN.elapsed().as_secs_f64() * 1e3, |n| n / 1e6)
}

static BEGIN: LazyLock<Instant> = LazyLock::new(Instant::now);
