//! The coefficients by name: which there are, what may be typed for them, how they are written in
//! their windows and changed.

use crate::file::{Fourier, HARMONICS};
use std::ops::RangeInclusive;

/// A column of coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// Amplitudes of x.
    A,
    /// Phases of x.
    P,
    /// Amplitudes of y.
    B,
    /// Phases of y.
    Q,
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Pixels.
    Amplitude,
    /// Units of pi.
    Phase,
}

/// One coefficient: its column and number. The phases have no number 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coefficient {
    /// Its column.
    pub column: Column,
    /// Its number.
    pub k: usize,
}

impl Column {
    /// Every column from the left, with its name.
    pub const ALL: [(Column, &'static str); 4] =
        [(Column::A, "a"), (Column::P, "p"), (Column::B, "b"), (Column::Q, "q")];

    /// The column of a name in upper case.
    pub fn of_letter(letter: char) -> Option<Column> {
        Self::ALL.iter().find(|(_, name)| letter.to_lowercase().eq(name.chars())).map(|&(column, _)| column)
    }

    /// Its letter, in lower case.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(column, _)| *column == self).map_or("", |(_, name)| name)
    }

    /// What its coefficients measure.
    pub fn quantity(self) -> Quantity {
        match self {
            Column::A | Column::B => Quantity::Amplitude,
            Column::P | Column::Q => Quantity::Phase,
        }
    }

    /// The numbers of its coefficients.
    pub fn numbers(self) -> RangeInclusive<usize> {
        match self.quantity() {
            Quantity::Amplitude => 0..=HARMONICS - 1,
            Quantity::Phase => 1..=HARMONICS - 1,
        }
    }

    fn row(self, fourier: &Fourier) -> &[f64; HARMONICS] {
        match self {
            Column::A => &fourier.a,
            Column::P => &fourier.p,
            Column::B => &fourier.b,
            Column::Q => &fourier.q,
        }
    }

    fn row_mut(self, fourier: &mut Fourier) -> &mut [f64; HARMONICS] {
        match self {
            Column::A => &mut fourier.a,
            Column::P => &mut fourier.p,
            Column::B => &mut fourier.b,
            Column::Q => &mut fourier.q,
        }
    }
}

impl Quantity {
    /// How many characters its windows hold.
    pub fn width(self) -> usize {
        match self {
            Quantity::Amplitude => 3,
            Quantity::Phase => 4,
        }
    }

    /// What may be typed: all that the window can show.
    pub fn range(self) -> RangeInclusive<f64> {
        match self {
            Quantity::Amplitude => -99.0..=999.0,
            Quantity::Phase => -9.9..=9.99,
        }
    }

    fn decimals(self) -> usize {
        match self {
            Quantity::Amplitude => 0,
            Quantity::Phase => 2,
        }
    }

    /// The smallest change by the wheel and the arrow keys.
    fn step(self) -> f64 {
        match self {
            Quantity::Amplitude => 1.0,
            Quantity::Phase => 0.01,
        }
    }

    /// A value as shown in its window; if it does not fit, with fewer decimals, in scientific notation, or as stars.
    pub fn shown(self, value: f64) -> String {
        let width = self.width();
        let plain = (0..=self.decimals()).rev().map(|decimals| fixed(value, decimals));
        let power = std::iter::once(format!("{value:.0E}"));
        let text = plain.chain(power).find(|text| text.len() <= width).unwrap_or("*".repeat(width));
        format!("{text:>width$}")
    }
}

impl Coefficient {
    /// The coefficient of a column with the number nearest to `k`.
    pub fn new(column: Column, k: usize) -> Coefficient {
        let numbers = column.numbers();
        Coefficient { column, k: k.clamp(*numbers.start(), *numbers.end()) }
    }

    /// The coefficients of all windows.
    pub fn all() -> impl Iterator<Item = Coefficient> {
        Column::ALL
            .into_iter()
            .flat_map(|(column, _)| column.numbers().map(move |k| Coefficient { column, k }))
    }

    /// The one below, or the uppermost of its column.
    pub fn below(self) -> Coefficient {
        let k = if self.column.numbers().contains(&(self.k + 1)) { self.k + 1 } else { 0 };
        Coefficient::new(self.column, k)
    }

    /// The one that many columns to the right, wrapping around.
    pub fn beside(self, columns: usize) -> Coefficient {
        let all = Column::ALL;
        let index = all.iter().position(|(column, _)| *column == self.column).unwrap_or(0);
        // The remainder is below the length.
        Coefficient::new(all[(index + columns) % all.len()].0, self.k)
    }

    /// Its value; every constructor keeps `k` below the length.
    pub fn of(self, fourier: &Fourier) -> f64 {
        self.column.row(fourier).get(self.k).copied().unwrap_or(0.0)
    }

    /// The coefficients with another value in this place.
    pub fn changed(self, fourier: &Fourier, value: f64) -> Fourier {
        let mut changed = fourier.clone();
        if let Some(place) = self.column.row_mut(&mut changed).get_mut(self.k) {
            *place = value;
        }
        changed
    }

    /// The coefficients after so many steps up. Amplitudes stay in what the window can show, unless
    /// they were outside; phases go round.
    pub fn stepped(self, fourier: &Fourier, steps: i32) -> Fourier {
        let quantity = self.column.quantity();
        let old = self.of(fourier);
        // Removes rounding errors from adding hundredths.
        let clean = |value: f64| (value * 1e10).round() / 1e10;
        let new = old + quantity.step() * f64::from(steps);
        let new = match quantity {
            Quantity::Amplitude => {
                let range = quantity.range();
                clean(new).clamp(old.min(*range.start()), old.max(*range.end()))
            }
            Quantity::Phase => Some(clean(new.rem_euclid(2.0))).filter(|&phase| phase < 2.0).unwrap_or(0.0),
        };
        self.changed(fourier, new)
    }

    /// Name and value with what the window has no room for, in at most 20 characters.
    pub fn exact(self, fourier: &Fourier) -> String {
        let value = self.of(fourier);
        // Eleven digits: what a 6-byte real always keeps.
        let rounded: f64 = format!("{value:.10e}").parse().unwrap_or(value);
        let plain = rounded.to_string();
        let text = if plain.len() <= 13 { plain } else { format!("{value:.5e}") };
        format!("{}{} = {text}", self.column.name(), self.k)
    }
}

/// A number with the given decimals; halves round away from zero, and there is no minus zero.
fn fixed(value: f64, decimals: usize) -> String {
    let scale = 10f64.powi(decimals as i32);
    let rounded = (value * scale).round() / scale + 0.0;
    format!("{rounded:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn windows_show_what_fits() {
        let amplitudes = [
            (0.0, "  0"),
            (-0.2, "  0"),
            (2.5, "  3"),
            (-99.4, "-99"),
            (999.4, "999"),
            (1234.0, "1E3"),
            (1e30, "***"),
            (-1e5, "***"),
        ];
        for (value, text) in amplitudes {
            assert_eq!(Quantity::Amplitude.shown(value), text);
        }
        let phases =
            [(0.5, "0.50"), (1.125, "1.13"), (-0.5, "-0.5"), (-1.25, "-1.3"), (12.0, "12.0"), (1e5, " 1E5")];
        for (value, text) in phases {
            assert_eq!(Quantity::Phase.shown(value), text);
        }
    }

    #[test]
    fn exact_values_have_the_digits_of_the_file() {
        let p3 = Coefficient::new(Column::P, 3);
        let text = |value| p3.exact(&p3.changed(&Fourier::default(), value));
        assert_eq!(text(0.1 + 1e-13), "p3 = 0.1");
        assert_eq!(text(1.0 / 3.0), "p3 = 0.33333333333");
        assert_eq!(text(-1.7e38), "p3 = -1.70000e38");
    }

    #[test]
    fn coefficients_are_walked_through() {
        assert_eq!(Coefficient::all().count(), 82);
        let a0 = Coefficient::new(Column::A, 0);
        assert_eq!(a0.beside(1), Coefficient { column: Column::P, k: 1 });
        assert_eq!(a0.beside(3).beside(1), Coefficient { column: Column::A, k: 1 });
        assert_eq!(Coefficient::new(Column::Q, 20).below(), Coefficient { column: Column::Q, k: 1 });
        assert_eq!(Column::of_letter('B'), Some(Column::B));
        assert_eq!(Column::of_letter('X'), None);
    }

    #[test]
    fn steps_stay_in_the_window_and_phases_go_round() {
        let walk = |column, start: f64, steps| {
            let place = Coefficient::new(column, 1);
            place.of(&place.stepped(&place.changed(&Fourier::default(), start), steps))
        };
        assert_eq!(walk(Column::A, 998.5, 10), 999.0);
        assert_eq!(walk(Column::A, 5000.0, 10), 5000.0);
        assert_eq!(walk(Column::A, 5000.0, -10), 4990.0);
        assert_eq!(walk(Column::B, 0.0, -1000), -99.0);
        assert_eq!(walk(Column::P, 1.99, 1), 0.0);
        assert_eq!(walk(Column::P, 0.0, -1), 1.99);
        assert_eq!(walk(Column::Q, 0.1, 20), 0.3);
    }

    proptest! {
        #[test]
        fn texts_always_fit(value: f64) {
            for quantity in [Quantity::Amplitude, Quantity::Phase] {
                prop_assert_eq!(quantity.shown(value).len(), quantity.width());
            }
            let b20 = Coefficient::new(Column::B, 20);
            prop_assert!(b20.exact(&b20.changed(&Fourier::default(), value)).len() <= 20);
        }

        #[test]
        fn curves_and_coefficients_are_the_same(values in prop::array::uniform20(-100.0..100.0f64), u in 0.0..1.0) {
            let mut fourier = Fourier::default();
            for (k, value) in values.into_iter().enumerate() {
                (fourier.a[k], fourier.p[k + 1], fourier.b[k + 1], fourier.q[20 - k]) = (value, value / 40.0, -value, 0.3);
            }
            let [x, y] = fourier.curve().unwrap().eval(u);
            let [again_x, again_y] = Fourier::of_curve(&fourier.curve().unwrap()).curve().unwrap().eval(u);
            prop_assert!((x - again_x).abs() < 1e-10 && (y - again_y).abs() < 1e-10);
        }
    }
}
