//! The dice of problems: random numbers that are the same for a seed everywhere.

/// A small generator of random numbers (SplitMix64; Steele, Lea, Flood 2014).
pub(super) struct Dice(u64);

impl Dice {
    /// The dice of a seed.
    pub(super) fn new(seed: u64) -> Dice {
        Dice(seed)
    }

    /// A number below a bound; 0 if that is 0.
    pub(super) fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        word ^= word >> 31;
        // The upper half of a product of 128 bits is below the bound; its unevenness is below 2^-58.
        ((u128::from(word) * bound as u128) >> 64) as usize
    }
}
