//! The twelve moves and which of them may follow each other in a shortest way.

use super::ARMS;

/// A move: A to F push the drawer of arm 1 to 6 in by one bead; I, K, M turn ring 1, 2, 3 counter-clockwise,
/// J, L, N clockwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the letters are explained above")]
#[repr(u8)]
pub enum Move {
    A,
    B,
    C,
    D,
    E,
    F,
    I,
    J,
    K,
    L,
    M,
    N,
}

/// What a move does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    /// Pushes the drawer of an arm, counted from 0.
    Push(usize),
    /// Turns a ring, counted from 0.
    Turn { ring: usize, clockwise: bool },
}

impl Move {
    /// Every move in the order of the letters.
    pub const ALL: [Move; 12] = [
        Move::A,
        Move::B,
        Move::C,
        Move::D,
        Move::E,
        Move::F,
        Move::I,
        Move::J,
        Move::K,
        Move::L,
        Move::M,
        Move::N,
    ];

    /// The move's letter.
    #[must_use]
    pub fn letter(self) -> char {
        // The numbers are 0 to 11.
        char::from(b"ABCDEFIJKLMN"[self as usize])
    }

    /// The move of a letter in either case.
    #[must_use]
    pub fn from_letter(letter: char) -> Option<Move> {
        let letter = letter.to_ascii_uppercase();
        Move::ALL.into_iter().find(|known| known.letter() == letter)
    }

    /// The move that undoes this one.
    #[must_use]
    pub fn inverse(self) -> Move {
        // 0 to 5 are drawers, opposite ones three apart; then rings in pairs. All stay below 12.
        let number = self as usize;
        Move::ALL[if number < ARMS { (number + 3) % ARMS } else { number ^ 1 }]
    }

    /// What the move does.
    pub(super) fn action(self) -> Action {
        let number = self as usize;
        match number.checked_sub(ARMS) {
            None => Action::Push(number),
            Some(turn) => Action::Turn { ring: turn / 2, clockwise: turn % 2 == 1 },
        }
    }
}

/// The end of a sequence of moves: the last move and how often it was made in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(super) struct Tail {
    last: Option<Move>,
    run: u8,
}

impl Tail {
    /// The end after one more move; `None` if the sequence is needless, because the same position is
    /// reached by another one that is no longer: turns of different rings commute, so they come in the order
    /// of the rings; three turns of a ring are the same in either direction, so they are counter-clockwise;
    /// nothing is undone at once.
    pub(super) fn then(self, next: Move) -> Option<Tail> {
        let Some(last) = self.last else { return Some(Tail { last: Some(next), run: 1 }) };
        if next == last.inverse() {
            return None;
        }
        let run = if next == last { self.run.saturating_add(1) } else { 1 };
        if let (Action::Turn { ring: before, .. }, Action::Turn { ring, clockwise }) =
            (last.action(), next.action())
        {
            let most = if clockwise { 2 } else { 3 };
            if ring < before || run > most {
                return None;
            }
        }
        Some(Tail { last: Some(next), run })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_and_inverses() {
        for a_move in Move::ALL {
            assert_eq!(Move::from_letter(a_move.letter()), Some(a_move));
            assert_eq!(a_move.inverse().inverse(), a_move);
        }
        let inverse = |letter| Move::from_letter(letter).map(|it| it.inverse().letter());
        for (a, b) in [('A', 'D'), ('B', 'E'), ('C', 'F'), ('I', 'J'), ('K', 'L'), ('M', 'N')] {
            assert_eq!((inverse(a), inverse(b)), (Some(b), Some(a)));
        }
        for nonsense in ['G', 'H', 'O', '1', ' ', 'Á'] {
            assert_eq!(Move::from_letter(nonsense), None);
        }
    }
}
