//! What `run.mjs` measures: the decoding of the files of the race, in WebAssembly.

#[path = "../../src/lines.rs"]
#[allow(dead_code)]
mod lines;

use std::cell::RefCell;
use std::hint::black_box;
use wheelover_core::nmea;

thread_local! {
    static TEXT: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Makes a file of so many lines: 0 is GNSS, 1 the bridge.
#[unsafe(no_mangle)]
pub extern "C" fn prepare(file: u32, count: u32) {
    let mut random = lines::Random(0x5EED_0183);
    TEXT.with_borrow_mut(|text| {
        text.clear();
        for _ in 0..count {
            let body = if file == 0 {
                lines::gnss(&mut random)
            } else {
                lines::bridge(&mut random)
            };
            text.push_str(&nmea::with_checksum(&body));
            text.push_str("\r\n");
        }
    });
}

/// Decodes the file, every field typed and every checksum verified; gives how many lines are right.
#[unsafe(no_mangle)]
pub extern "C" fn decode() -> u32 {
    TEXT.with_borrow(|text| {
        let mut right = 0;
        let mut faults = Vec::new();
        for line in text.as_bytes().split_inclusive(|&b| b == b'\n') {
            let sentence = nmea::decode(line);
            sentence.walk(|item| _ = black_box(item.value), &mut faults);
            right += u32::from(sentence.checksum.is_right() && faults.is_empty());
            faults.clear();
        }
        right
    })
}
