#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| parkade_fuzz::guided("scene", bytes));
