//! A position of the wheel in three planes of bits, and what the moves do to it.
//!
//! Bit 6 ring + arm (both from 0) is a place, bit 30 the centre. A place holds 0 (nothing), 1 to 6 (the colour
//! of that home arm) or 7 (the bead at home in the centre); bit b of these numbers is plane b.

use super::WheelError;
use super::moves::{Action, Move};
use serde::{Deserialize, Serialize};

/// Rings of beads round the centre.
pub const RINGS: usize = 5;
/// Arms, each with a drawer; arm l and l + 3 are opposite.
pub const ARMS: usize = 6;

/// The bit of the centre.
const CENTRE: u32 = 1 << 30;
/// Lowest bit of every ring.
const RING_STARTS: u32 = 1 | 1 << 6 | 1 << 12 | 1 << 18 | 1 << 24;
/// Beads of one colour.
const OF_A_COLOUR: u32 = 4;

/// A position of the wheel: one that the moves can lead to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Wheel {
    pub(super) planes: [u32; 3],
}

impl From<Wheel> for String {
    fn from(wheel: Wheel) -> String {
        wheel.to_string()
    }
}

impl TryFrom<String> for Wheel {
    type Error = WheelError;

    fn try_from(text: String) -> Result<Wheel, WheelError> {
        text.parse()
    }
}

/// What a move does to one plane of bits.
pub(super) fn moved(plane: u32, action: Action) -> u32 {
    match action {
        Action::Push(arm) => {
            let opposite = (arm + 3) % ARMS;
            let [inwards, outwards] = [RING_STARTS << arm, RING_STARTS << opposite];
            let centre = plane >> 30 & 1;
            plane & !(inwards | outwards | CENTRE)
                | (plane & inwards) >> 6 & inwards
                | (plane & outwards) << 6 & outwards
                | centre << opposite
                | (plane >> arm & 1) << 30
        }
        Action::Turn { ring, clockwise } => {
            let ring = 6 * ring;
            let bits = plane >> ring & 63;
            let turned = if clockwise { bits >> 1 | bits << 5 } else { bits << 1 | bits >> 5 };
            plane & !(63 << ring) | (turned & 63) << ring
        }
    }
}

/// A plane with every arm moved on by some arms, 0 to 5.
pub(super) fn turned(plane: u32, arms: usize) -> u32 {
    // The lowest `arms` bits of every ring, in a multiplication without carries.
    let low = RING_STARTS * ((1 << arms) - 1);
    let rings = plane & !CENTRE;
    plane & CENTRE | (rings << arms) & (CENTRE - 1) & !low | rings >> (ARMS - arms) & low
}

/// A plane with arm l in the place of arm -l (modulo 6).
pub(super) fn mirrored(plane: u32) -> u32 {
    let arm = |arm: usize| RING_STARTS << arm;
    plane & (arm(0) | arm(3) | CENTRE)
        | (plane & arm(1)) << 4
        | (plane & arm(5)) >> 4
        | (plane & arm(2)) << 2
        | (plane & arm(4)) >> 2
}

impl Wheel {
    /// The solved wheel: every bead of colour l in arm l, the drawers at home.
    #[must_use]
    pub fn solved() -> Wheel {
        let mut wheel = Wheel { planes: [CENTRE; 3] };
        for arm in 0..ARMS {
            (0..4).for_each(|ring| wheel.put(1 << (6 * ring + arm), arm as u32 + 1));
        }
        wheel
    }

    /// Whether this is the solved wheel.
    #[must_use]
    pub fn is_solved(&self) -> bool {
        *self == Wheel::solved()
    }

    /// A position from its beads: the colour in the centre, and those of every arm from the inside out.
    ///
    /// # Errors
    /// [`WheelError::Position`] when opposite arms do not hold eight beads, three to five each, or the beads
    /// are not the 25 of the wheel.
    pub fn from_beads<T: AsRef<[u8]>>(centre: u8, arms: &[T; ARMS]) -> Result<Wheel, WheelError> {
        let problem = |text: String| Err(WheelError::Position(text));
        let lengths = arms.each_ref().map(|arm| arm.as_ref().len());
        for (index, (&length, &opposite)) in lengths.iter().zip(lengths.iter().cycle().skip(3)).enumerate() {
            if !(3..=RINGS).contains(&length) || length + opposite != 8 {
                return problem(format!(
                    "number of beads in arm {}: {length}, opposite {opposite}; an arm holds 3 to 5, with the one opposite 8",
                    index + 1
                ));
            }
        }
        let mut wheel = Wheel { planes: [0; 3] };
        let place = |ring: usize, arm: usize| 1 << (6 * ring + arm);
        let beads = arms.iter().enumerate().flat_map(|(arm, beads)| {
            beads.as_ref().iter().enumerate().map(move |(ring, &colour)| (place(ring, arm), colour))
        });
        for (bit, colour) in beads.chain([(CENTRE, centre)]) {
            match colour {
                0 => wheel.put(bit, 7),
                1..=6 => wheel.put(bit, colour.into()),
                _ => return problem(format!("colour {colour}; the colours are 0 to 6")),
            }
        }
        for colour in 0..ARMS {
            let count = wheel.colour(colour).count_ones();
            if count != OF_A_COLOUR {
                return problem(format!("number of beads of colour {}: {count}, must be 4", colour + 1));
            }
        }
        // 25 places are filled, 24 by the six colours, so the last one holds 0.
        Ok(wheel)
    }

    fn put(&mut self, bit: u32, code: u32) {
        for (index, plane) in self.planes.iter_mut().enumerate() {
            *plane |= bit * (code >> index & 1);
        }
    }

    fn at(&self, bit: u32) -> Option<u8> {
        let code = (0..).zip(self.planes).map(|(index, plane)| u8::from(plane & bit != 0) << index).sum();
        match code {
            0 => None,
            7 => Some(0),
            colour => Some(colour),
        }
    }

    /// The colour of the bead in a ring of an arm, both counted from 1, innermost first; `None` where there
    /// is none.
    #[must_use]
    pub fn bead(&self, ring: usize, arm: usize) -> Option<u8> {
        let inside = (1..=RINGS).contains(&ring) && (1..=ARMS).contains(&arm);
        inside.then(|| self.at(1 << (6 * (ring - 1) + arm - 1))).flatten()
    }

    /// The colour of the bead in the centre.
    #[must_use]
    pub fn centre(&self) -> u8 {
        self.at(CENTRE).unwrap_or(0) // the centre is never empty
    }

    /// How far the drawer of an arm is out, counted from 1: 1 at home, 3 out, -1 in.
    #[must_use]
    pub fn drawer(&self, arm: usize) -> i8 {
        match (self.bead(4, arm), self.bead(5, arm)) {
            (None, _) => -1,
            (_, None) => 1,
            _ => 3,
        }
    }

    /// Whether a move changes anything: a drawer that is in cannot be pushed.
    #[must_use]
    pub fn allows(&self, a_move: Move) -> bool {
        match a_move.action() {
            Action::Push(arm) => self.occupied() >> (18 + arm) & 1 == 1,
            Action::Turn { .. } => true,
        }
    }

    /// The position after a move; `None` if the move is not possible.
    #[must_use]
    pub fn after(&self, a_move: Move) -> Option<Wheel> {
        let action = a_move.action();
        self.allows(a_move).then(|| Wheel { planes: self.planes.map(|plane| moved(plane, action)) })
    }

    /// The position after some moves; those that are not possible do nothing, as in the program.
    #[must_use]
    pub fn after_all(&self, moves: &[Move]) -> Wheel {
        moves.iter().fold(*self, |wheel, &a_move| wheel.after(a_move).unwrap_or(wheel))
    }

    /// The position after some moves, all of which must be possible.
    ///
    /// # Errors
    /// [`WheelError::Blocked`] with the first one that is not.
    pub fn replay(&self, moves: &[Move]) -> Result<Wheel, WheelError> {
        moves.iter().enumerate().try_fold(*self, |wheel, (index, &a_move)| {
            wheel.after(a_move).ok_or(WheelError::Blocked { letter: a_move.letter(), at: index + 1 })
        })
    }

    /// The places that hold a bead.
    pub(super) fn occupied(&self) -> u32 {
        self.planes[0] | self.planes[1] | self.planes[2]
    }

    /// The places of a colour, counted from 0.
    pub(super) fn colour(&self, colour: usize) -> u32 {
        let bit = |plane: usize| {
            let set = (colour + 1) >> plane & 1 == 1;
            if set { self.planes[plane] } else { !self.planes[plane] }
        };
        bit(0) & bit(1) & bit(2)
    }

    /// The place of the bead that is at home in the centre.
    pub(super) fn grey(&self) -> u32 {
        self.planes[0] & self.planes[1] & self.planes[2]
    }

    /// The same number for the twelve positions that are this one turned or mirrored together with its
    /// colours, and for no other; below 2^93. All of them are equally far from solved.
    pub(super) fn orbit(&self) -> u128 {
        let colours: [u32; ARMS] = std::array::from_fn(|colour| self.colour(colour));
        let grey = self.grey();
        let [c0, c1, c2, c3, c4, c5] = colours.map(mirrored);
        let mirror = [c0, c5, c4, c3, c2, c1];
        let (grey_mirror, mut least) = (mirrored(grey), [u32::MAX; 3]);
        for (colours, grey) in [(&colours, grey), (&mirror, grey_mirror)] {
            for arms in 0..ARMS {
                // The colour that becomes `code - 1`.
                let was = |code: usize| colours[(code + 5 + ARMS - arms) % ARMS];
                let first = turned(was(1) | was(3) | was(5) | grey, arms);
                if first <= least[0] {
                    let second = turned(was(2) | was(3) | was(6) | grey, arms);
                    let third = turned(was(4) | was(5) | was(6) | grey, arms);
                    least = least.min([first, second, third]);
                }
            }
        }
        u128::from(least[0]) | u128::from(least[1]) << 31 | u128::from(least[2]) << 62
    }

    /// How many different positions this one is turned and mirrored.
    #[cfg(test)]
    pub(super) fn orbit_size(&self) -> usize {
        let mut images = std::collections::HashSet::new();
        for mirror in [false, true] {
            for arms in 0..ARMS {
                let mut image = Wheel { planes: [0; 3] };
                for bit in (0..31).map(|bit| 1 << bit) {
                    let place = turned(if mirror { mirrored(bit) } else { bit }, arms);
                    let code = match self.at(bit).map(usize::from) {
                        None => 0,
                        Some(0) => 7,
                        Some(colour) if mirror => (7 - colour + arms) % ARMS + 1,
                        Some(colour) => (colour - 1 + arms) % ARMS + 1,
                    };
                    image.put(place, code as u32);
                }
                images.insert(image);
            }
        }
        images.len()
    }

    /// The position that [`Wheel::orbit`] gives: one of the twelve.
    pub(super) fn of_orbit(number: u128) -> Wheel {
        let plane = |index: u32| (number >> (31 * index)) as u32 & (CENTRE | (CENTRE - 1));
        Wheel { planes: [plane(0), plane(1), plane(2)] }
    }
}

#[cfg(test)]
mod tests {
    use super::super::moves_from_text;
    use super::*;
    use proptest::prelude::*;

    fn wheel(text: &str) -> Wheel {
        Wheel::solved().after_all(&moves_from_text(text).unwrap())
    }

    /// The rules once more, on a table of colours as the book's description has it: the independent route.
    #[derive(Clone, PartialEq, Debug)]
    struct Table {
        a: [[u8; 7]; 6],
        a0: u8,
        h: [i8; 7],
    }

    impl Table {
        fn of(wheel: &Wheel) -> Table {
            let a = std::array::from_fn(|k| std::array::from_fn(|l| wheel.bead(k, l).unwrap_or(15)));
            let h = std::array::from_fn(|l| if l == 0 { 0 } else { wheel.drawer(l) });
            Table { a, a0: wheel.centre(), h }
        }

        fn make(&mut self, letter: char) {
            if let Some(p) = "ABCDEF".find(letter).map(|p| p + 1) {
                let q = if p > 3 { p - 3 } else { p + 3 };
                if self.h[p] > -1 {
                    self.h[p] -= 2;
                    self.h[q] += 2;
                    (1..=4).rev().for_each(|k| self.a[k + 1][q] = self.a[k][q]);
                    self.a[1][q] = self.a0;
                    self.a0 = self.a[1][p];
                    (1..=4).for_each(|k| self.a[k][p] = self.a[k + 1][p]);
                    self.a[5][p] = 15;
                }
                return;
            }
            let turn = "IJKLMN".find(letter).unwrap();
            let before = self.a[turn / 2 + 1];
            for (l, bead) in before.into_iter().enumerate().skip(1) {
                let to = if turn.is_multiple_of(2) { l % 6 + 1 } else { (l + 4) % 6 + 1 };
                self.a[turn / 2 + 1][to] = bead;
            }
        }
    }

    proptest! {
        #[test]
        fn moves_do_what_the_book_says(moves in prop::collection::vec(0usize..12, 0..60)) {
            let mut wheel = Wheel::solved();
            let mut table = Table::of(&wheel);
            for index in moves {
                let a_move = Move::ALL[index];
                let before = wheel;
                wheel = wheel.after_all(&[a_move]);
                table.make(a_move.letter());
                prop_assert_eq!(&Table::of(&wheel), &table);
                if before.allows(a_move) {
                    prop_assert_eq!(wheel.after(a_move.inverse()), Some(before));
                } else {
                    prop_assert_eq!(wheel, before);
                }
                prop_assert_eq!(wheel.occupied().count_ones(), 25);
            }
        }

        #[test]
        fn an_orbit_is_twelve_positions(moves in prop::collection::vec(0usize..12, 0..40)) {
            let moves: Vec<Move> = moves.into_iter().map(|index| Move::ALL[index]).collect();
            let number = Wheel::solved().after_all(&moves).orbit();
            prop_assert_eq!(Wheel::of_orbit(number).orbit(), number);
            // A turn by one arm: A becomes B and so on, the rings stay; the mirror image: arm l becomes -l.
            let turn = |a_move: Move| match a_move.action() {
                Action::Push(arm) => Move::ALL[(arm + 1) % 6],
                Action::Turn { .. } => a_move,
            };
            let mirror = |a_move: Move| match a_move.action() {
                Action::Push(arm) => Move::ALL[(6 - arm) % 6],
                Action::Turn { .. } => a_move.inverse(),
            };
            let [turned, mirrored]: [Vec<Move>; 2] =
                [moves.iter().map(|&it| turn(it)).collect(), moves.iter().map(|&it| mirror(it)).collect()];
            prop_assert_eq!(Wheel::solved().after_all(&turned).orbit(), number);
            prop_assert_eq!(Wheel::solved().after_all(&mirrored).orbit(), number);
        }
    }

    #[test]
    fn a_drawer_that_is_in_stays_in() {
        let wheel = wheel("AA");
        let drawers: Vec<i8> = (1..=6).map(|arm| wheel.drawer(arm)).collect();
        assert_eq!(drawers, [-1, 1, 1, 3, 1, 1]);
        assert_eq!(wheel, self::wheel("A"));
        assert!(!wheel.allows(Move::A) && wheel.allows(Move::D));
        let error = Wheel::solved().replay(&[Move::I, Move::A, Move::A]).unwrap_err();
        assert_eq!(error, WheelError::Blocked { letter: 'A', at: 3 });
    }

    #[test]
    fn six_turns_are_none() {
        for letters in ["IIIIII", "JJJJJJ", "KKKKKK", "IJ", "AD", "LK", "IKMJLN"] {
            assert!(wheel(letters).is_solved(), "{letters}");
        }
        assert!(!wheel("III").is_solved());
    }

    /// Numbers of positions at so many moves, without symmetries or tables.
    #[test]
    fn positions_by_distance() {
        let mut seen = std::collections::HashSet::from([Wheel::solved()]);
        let mut layer = vec![Wheel::solved()];
        for count in [1, 12, 114, 1007, 8316, 65118] {
            assert_eq!(layer.len(), count);
            let next = |wheel: &Wheel| Move::ALL.map(|a_move| wheel.after(a_move));
            layer = layer.iter().flat_map(next).flatten().filter(|&wheel| seen.insert(wheel)).collect();
        }
    }
}
