//! A position in a line of text: four signs a piece, `x y z` of cell 1 and a letter `a` to `x` for how it is
//! turned, the first of [`ROTATIONS`] being `a`.

use super::position::{CsangoCube, ROTATIONS};
use super::shape::PIECES;
use std::fmt;
use std::str::FromStr;

/// Why a text is no position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StateError {
    /// It has another length than four signs for each piece.
    Length(usize),
    /// A sign is wrong, counted from 0.
    Sign(usize),
    /// The pieces cannot lie so.
    Impossible(String),
}

impl fmt::Display for StateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StateError::Length(found) => {
                write!(f, "{found} signs; a position of the Csángó cube has {}", 4 * PIECES)
            }
            StateError::Sign(at) => {
                let right = if at % 4 == 3 { "a letter a to x" } else { "a digit" };
                write!(f, "sign {} of the position should be {right}", at + 1)
            }
            StateError::Impossible(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for StateError {}

impl fmt::Display for CsangoCube {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for piece in &self.pieces {
            let [x, y, z] = piece.cell;
            let turned = ROTATIONS.iter().position(|rotation| *rotation == piece.rotation);
            let letter =
                turned.and_then(|index| u8::try_from(index).ok()).map_or('?', |k| char::from(b'a' + k));
            write!(f, "{x}{y}{z}{letter}")?;
        }
        Ok(())
    }
}

impl FromStr for CsangoCube {
    type Err = StateError;

    fn from_str(text: &str) -> Result<CsangoCube, StateError> {
        let signs: Vec<char> = text.trim().chars().collect();
        if signs.len() != 4 * PIECES {
            return Err(StateError::Length(signs.len()));
        }
        let mut cube = CsangoCube::start();
        for (number, (piece, own)) in cube.pieces.iter_mut().zip(signs.chunks_exact(4)).enumerate() {
            for (at, (sign, value)) in own.iter().zip(&mut piece.cell).enumerate() {
                // A digit fits.
                *value = sign.to_digit(10).ok_or(StateError::Sign(4 * number + at))? as i8;
            }
            let index = own.last().map_or(usize::MAX, |&sign| (sign as usize).wrapping_sub('a' as usize));
            piece.rotation = *ROTATIONS.get(index).ok_or(StateError::Sign(4 * number + 3))?;
        }
        cube.fault().map_or(Ok(cube), |fault| Err(StateError::Impossible(fault.to_string())))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Rules;
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_start_in_a_line() {
        let text = CsangoCube::start().to_string();
        assert_eq!(text, "680a140a840a080a900a600a120a860a380a160a820a000a980a300a");
        assert_eq!(text.parse(), Ok(CsangoCube::start()));
        let wrong = |text: &str| text.parse::<CsangoCube>().unwrap_err().to_string();
        assert_eq!(wrong("680a"), "4 signs; a position of the Csángó cube has 56");
        assert_eq!(
            wrong(&text.replacen("680a", "680y", 1)),
            "sign 4 of the position should be a letter a to x"
        );
        assert_eq!(wrong(&text.replacen("140a", "840a", 1)), "piece 3: piece 2 is at [8, 4, 0] as well");
    }

    proptest! {
        #[test]
        fn positions_read_back(seed in any::<u64>()) {
            let cube = CsangoCube::start().scrambled(seed, 200, Rules::Book);
            prop_assert_eq!(cube.to_string().parse(), Ok(cube));
        }

        #[test]
        fn any_text_is_read_or_refused(text in "\\PC{50,60}") {
            let _ = text.parse::<CsangoCube>();
        }
    }
}
