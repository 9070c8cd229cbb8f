//! Moves and positions as texts that one can say on the telephone.
//!
//! A position is the bead in the centre and then every arm from the inside out, `0-1111-2222-3333-4444-5555-6666`
//! when it is solved. How far the drawers are out follows from the number of beads.

use super::{ARMS, Move, RINGS, Wheel, WheelError};
use std::fmt;
use std::str::FromStr;

/// The moves of a text of letters; blanks do not count.
///
/// # Errors
/// [`WheelError::Letter`] with the first letter that is no move.
pub fn moves_from_text(text: &str) -> Result<Vec<Move>, WheelError> {
    let letters = text.chars().enumerate().filter(|(_, letter)| !letter.is_whitespace());
    letters
        .map(|(index, letter)| Move::from_letter(letter).ok_or(WheelError::Letter { letter, at: index + 1 }))
        .collect()
}

/// Moves as their letters.
#[must_use]
pub fn moves_to_text(moves: &[Move]) -> String {
    moves.iter().map(|a_move| a_move.letter()).collect()
}

impl fmt::Display for Wheel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.centre())?;
        for arm in 1..=ARMS {
            f.write_str("-")?;
            (1..=RINGS)
                .filter_map(|ring| self.bead(ring, arm))
                .try_for_each(|colour| write!(f, "{colour}"))?;
        }
        Ok(())
    }
}

impl FromStr for Wheel {
    type Err = WheelError;

    /// Reads what [`Wheel`] writes.
    fn from_str(text: &str) -> Result<Wheel, WheelError> {
        let solved = Wheel::solved();
        let problem = |text: String| WheelError::Position(format!("{text}; the solved wheel is {solved}"));
        let digit = |letter: char| {
            let digit = letter.to_digit(7).and_then(|digit| u8::try_from(digit).ok());
            digit.ok_or_else(|| problem(format!("{letter:?} is no colour, 0 to 6")))
        };
        let groups: Vec<Vec<u8>> = text
            .trim()
            .split('-')
            .map(|group| group.chars().map(digit).collect())
            .collect::<Result<_, _>>()?;
        let Some(([centre], arms)) = groups.split_first().map(|(centre, arms)| (centre.as_slice(), arms))
        else {
            return Err(problem("one bead should stand in the centre, before the first -".to_string()));
        };
        let count = arms.len();
        let arms: &[Vec<u8>; ARMS] =
            arms.try_into().map_err(|_| problem(format!("number of arms: {count}, must be 6")))?;
        Wheel::from_beads(*centre, arms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn moves_read_back() {
        let moves = moves_from_text(" mc Em\n").unwrap();
        assert_eq!(moves_to_text(&moves), "MCEM");
        assert_eq!(moves_from_text("AXB"), Err(WheelError::Letter { letter: 'X', at: 2 }));
    }

    #[test]
    fn wrong_positions_are_told() {
        assert_eq!("0-1111-2222-3333-4444-5555-6666".parse(), Ok(Wheel::solved()));
        for wrong in [
            "",
            "0",
            "-",
            "7-1111-2222-3333-4444-5555-6666",
            "1-1111-2222-3333-4444-5555-6666",
            "0-1111-2222-3333-4444-5555",
            "0-1111-2222-3333-4444-5555-6666-",
            "0-11111-2222-3333-4444-5555-6666",
            "0-111-2222-3333-4444-5555-6666",
            "0-11111-2222-3333-444-5555-6666",
            "0-11-2222-3333-444444-5555-6666",
            "0-1111-2222-3333-4444-5555-666é",
        ] {
            assert!(wrong.parse::<Wheel>().is_err(), "{wrong}");
        }
    }

    proptest! {
        #[test]
        fn positions_read_back(moves in prop::collection::vec(0usize..12, 0..60)) {
            let moves: Vec<Move> = moves.into_iter().map(|index| Move::ALL[index]).collect();
            let wheel = Wheel::solved().after_all(&moves);
            prop_assert_eq!(wheel.to_string().parse(), Ok(wheel));
        }

        #[test]
        fn no_text_does_harm(text in "[0-7\\-é]{0,40}") {
            if let Ok(wheel) = text.parse::<Wheel>() {
                prop_assert_eq!(wheel.to_string(), text);
            }
        }
    }
}
