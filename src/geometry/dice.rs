//! Random numbers that are the same for a seed everywhere: problems of puzzles, clouds of points, learning nets.

use super::portable::ln;

/// A small generator of random numbers (SplitMix64; Steele, Lea, Flood 2014).
#[derive(Clone, Debug)]
pub struct Dice(u64);

impl Dice {
    /// The dice of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Dice {
        Dice(seed)
    }

    /// 64 random bits.
    fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        word ^ (word >> 31)
    }

    /// A number below a bound; 0 if that is 0.
    pub fn below(&mut self, bound: usize) -> usize {
        // The upper half of a product of 128 bits is below the bound; its unevenness is below 2^-58.
        ((u128::from(self.word()) * bound as u128) >> 64) as usize
    }

    /// A number in [-1, 1).
    pub fn signed(&mut self) -> f64 {
        // 53 bits are what a double holds.
        (self.word() >> 11) as f64 * (2.0 / (1_u64 << 53) as f64) - 1.0
    }

    /// A point of the disc of radius 1 without its centre, and the square of its distance from there.
    fn in_disc(&mut self) -> ([f64; 2], f64) {
        loop {
            let point = [self.signed(), self.signed()];
            let square = point[0] * point[0] + point[1] * point[1];
            if square > 0.0 && square <= 1.0 {
                return (point, square);
            }
        }
    }

    /// A direction in the plane: cosine and sine of an angle.
    pub fn direction(&mut self) -> [f64; 2] {
        let (point, square) = self.in_disc();
        point.map(|x| x / square.sqrt())
    }

    /// Two independent numbers of the normal distribution with deviation 1 (Marsaglia's polar method).
    pub fn normal(&mut self) -> [f64; 2] {
        let (point, square) = self.in_disc();
        let length = (-2.0 * ln(square) / square).sqrt();
        point.map(|x| x * length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_of_a_seed_never_change() {
        let mut dice = Dice::new(1);
        assert_eq!([dice.below(1000), dice.below(1000), dice.below(1000)], [566, 745, 971]);
        assert_eq!(Dice::new(0).below(0), 0);
    }

    #[test]
    fn normal_numbers_have_the_moments_of_their_distribution() {
        let mut dice = Dice::new(7);
        let count = 20_000;
        let numbers: Vec<f64> = (0..count).flat_map(|_| dice.normal()).collect();
        let moment = |power: i32| numbers.iter().map(|x| x.powi(power)).sum::<f64>() / numbers.len() as f64;
        // Their own deviations are 1 / 200, sqrt(2) / 200 and sqrt(96) / 200.
        assert!(moment(1).abs() < 0.02 && (moment(2) - 1.0).abs() < 0.03 && (moment(4) - 3.0).abs() < 0.2);
    }

    #[test]
    fn directions_go_all_round() {
        let mut dice = Dice::new(7);
        let mut quarters = [0; 4];
        for _ in 0..4000 {
            let [x, y] = dice.direction();
            assert!((x * x + y * y - 1.0).abs() < 1e-15);
            quarters[usize::from(x > 0.0) + 2 * usize::from(y > 0.0)] += 1;
        }
        assert!(quarters.iter().all(|count| (900..1100).contains(count)), "{quarters:?}");
    }
}
