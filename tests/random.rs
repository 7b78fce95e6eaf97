//! A small seeded generator, the one of all tests: the same numbers everywhere and each time.
#![allow(dead_code, reason = "each test asks for some of it")]

/// SplitMix64 (Steele, Lea and Flood 2014); any seed will do.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// A generator for the test of that name; its seed is printed, so that a failure can be looked for.
    pub(crate) fn seeded(name: &str) -> Self {
        let seed = name.bytes().fold(0x5EED_0183, |sum: u64, byte| {
            sum.wrapping_mul(31).wrapping_add(u64::from(byte))
        });
        std::println!("{name}: seed {seed:#x}");
        Self(seed)
    }

    /// The next 64 bits.
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `limit`; 0 where that is 0.
    pub(crate) fn below<T: TryInto<u64> + TryFrom<u64>>(&mut self, limit: T) -> T {
        let limit = limit.try_into().unwrap_or(0);
        let Ok(number) = T::try_from(self.next() % limit.max(1)) else {
            unreachable!("less than a number of that type")
        };
        number
    }

    /// A whole number, both ends included.
    pub(crate) fn from(&mut self, low: i64, high: i64) -> i64 {
        low + self.below(high - low + 1)
    }

    /// One of a list.
    pub(crate) fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    /// The bytes with a mistake in two hundred: another byte, one less, or one more.
    pub(crate) fn spoil(&mut self, whole: &[u8], spoilt: &mut impl Extend<u8>) {
        let mut from = 0;
        while from < whole.len() {
            let to = (from + self.below(400)).min(whole.len());
            spoilt.extend(whole[from..to].iter().copied());
            match self.below(3) {
                0 => spoilt.extend([self.next() as u8]),
                1 => spoilt.extend([whole[to.min(whole.len() - 1)], self.next() as u8]),
                _ => {}
            }
            from = to + 1;
        }
    }
}
