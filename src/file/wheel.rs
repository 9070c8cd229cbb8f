//! Positions of the bead wheel: `.GYK`.
//!
//! 37 bytes: the colours of the beads ring by ring (byte 6 (k - 1) + l - 1), the bead in the centre (byte
//! 30) and the displacement of each drawer (byte 30 + l, signed).

use super::FileError;
use crate::pascal::{Reader, Writer};
use crate::puzzle::wheel::Wheel;
use serde::{Deserialize, Serialize};

/// Rings of beads round the centre.
pub const RINGS: usize = 5;
/// Arms, each with a drawer; arm l and l + 3 are opposite.
pub const ARMS: usize = 6;
/// The colour that stands for no bead.
pub const EMPTY: u8 = 15;

/// The colour of the one bead without equals, in the centre of the solved wheel.
const CENTRE_COLOUR: u8 = 7;
/// The colours of four beads each; arm l of the solved wheel has colour 8 + l.
const ARM_COLOURS: std::ops::RangeInclusive<u8> = 9..=14;

/// A position of the bead wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BeadWheel {
    /// Colours by ring (innermost first) and arm; [`EMPTY`] where there is no bead.
    pub rings: [[u8; ARMS]; RINGS],
    /// The colour of the bead in the centre.
    pub centre: u8,
    /// How far each drawer is out: 1 at home, 3 out, -1 in.
    pub drawers: [i8; ARMS],
}

impl From<&Wheel> for BeadWheel {
    fn from(wheel: &Wheel) -> BeadWheel {
        let color = |bead: u8| if bead == 0 { CENTRE_COLOUR } else { 8 + bead };
        let ring =
            |ring: usize| std::array::from_fn(|arm| wheel.bead(ring + 1, arm + 1).map_or(EMPTY, color));
        BeadWheel {
            rings: std::array::from_fn(ring),
            centre: color(wheel.centre()),
            drawers: std::array::from_fn(|arm| wheel.drawer(arm + 1)),
        }
    }
}

impl TryFrom<&BeadWheel> for Wheel {
    type Error = FileError;

    /// The position that can be played.
    ///
    /// # Errors
    /// [`FileError::Invalid`] if it cannot be reached.
    fn try_from(wheel: &BeadWheel) -> Result<Wheel, FileError> {
        wheel.check()?;
        // Every colour is 7 or 9 to 14 by now.
        let bead = |color: u8| color.saturating_sub(8);
        let arm = |arm: usize| -> Vec<u8> {
            let colors = wheel.rings.iter().filter_map(|ring| ring.get(arm).copied());
            colors.filter(|&color| color != EMPTY).map(bead).collect()
        };
        let arms: [Vec<u8>; ARMS] = std::array::from_fn(arm);
        Wheel::from_beads(bead(wheel.centre), &arms).map_err(|error| FileError::Invalid(error.to_string()))
    }
}

/// Where in the file a field stands, and its name.
#[derive(Clone, Copy)]
struct Place {
    name: &'static str,
    arm: usize,
    offset: usize,
}

impl BeadWheel {
    /// The solved wheel.
    #[must_use]
    pub fn solved() -> Self {
        let ring = [9, 10, 11, 12, 13, 14];
        Self { rings: [ring, ring, ring, ring, [EMPTY; ARMS]], centre: CENTRE_COLOUR, drawers: [1; ARMS] }
    }

    /// Checks that the position can be reached: opposite drawers agree, arms hold as many beads as
    /// their drawers say and without gaps, and the beads are the 25 of the wheel.
    ///
    /// # Errors
    /// [`FileError::Invalid`] with what is wrong.
    pub fn check(&self) -> Result<(), FileError> {
        self.problem().map_or(Ok(()), |(place, problem)| {
            let arm = if place.arm == 0 { String::new() } else { format!(" {}", place.arm) };
            Err(FileError::Invalid(format!("{}{arm}: {problem}", place.name)))
        })
    }

    /// The first thing that makes the position impossible.
    fn problem(&self) -> Option<(Place, String)> {
        self.drawer_problem().or_else(|| self.gap_problem()).or_else(|| self.colour_problem())
    }

    fn drawer_problem(&self) -> Option<(Place, String)> {
        for (index, &drawer) in self.drawers.iter().enumerate() {
            let place = Place { name: "drawer", arm: index + 1, offset: 31 + index };
            if ![-1, 1, 3].contains(&drawer) {
                return Some((place, format!("{drawer}; it must be -1, 1 or 3")));
            }
            let opposite = (index + ARMS / 2) % ARMS;
            let other = self.drawers.get(opposite).copied().unwrap_or(1); // always there
            if other != 2 - drawer {
                let problem = format!(
                    "{drawer}, and drawer {} opposite {other}; the two must add up to 2",
                    opposite + 1
                );
                return Some((place, problem));
            }
        }
        None
    }

    fn gap_problem(&self) -> Option<(Place, String)> {
        for (arm, &drawer) in self.drawers.iter().enumerate() {
            let beads = usize::try_from(4 + (drawer - 1) / 2).unwrap_or(0); // 3, 4 or 5 by now
            for (ring, colours) in self.rings.iter().enumerate() {
                let colour = colours.get(arm).copied().unwrap_or(EMPTY); // always there
                let place = Place { name: "arm", arm: arm + 1, offset: ARMS * ring + arm };
                if (colour == EMPTY) != (ring >= beads) {
                    let found = if colour == EMPTY { "is empty" } else { "holds a bead" };
                    let problem = format!(
                        "ring {} {found}; with the drawer at {drawer} rings 1 to {beads} hold beads",
                        ring + 1
                    );
                    return Some((place, problem));
                }
            }
        }
        None
    }

    fn colour_problem(&self) -> Option<(Place, String)> {
        let beads = self.rings.iter().flatten().copied().chain([self.centre]);
        let mut count = [0u8; 16];
        for (offset, colour) in beads.enumerate() {
            let arm = if offset < ARMS * RINGS { offset % ARMS + 1 } else { 0 };
            let place = Place { name: if arm == 0 { "centre" } else { "arm" }, arm, offset };
            let most = match colour {
                EMPTY if arm != 0 => continue,
                CENTRE_COLOUR => 1,
                _ if ARM_COLOURS.contains(&colour) => 4,
                _ => return Some((place, format!("colour {colour}; beads have the colours 7 and 9 to 14"))),
            };
            let count = count.get_mut(usize::from(colour))?; // at most 14 here
            *count += 1;
            if *count > most {
                let problem = format!("bead {count} of colour {colour}; the wheel has {most}");
                return Some((place, problem));
            }
        }
        // 25 places are filled by now and no colour is too many, so none is too few.
        None
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let state = if *self == Self::solved() { "solved" } else { "not solved" };
        let mut lines =
            vec![format!("position of the bead wheel, {state}"), format!("centre: {}", self.centre)];
        for arm in 0..ARMS {
            let colours = self.rings.iter().filter_map(|ring| ring.get(arm)).filter(|&&c| c != EMPTY);
            let colours: Vec<_> = colours.map(u8::to_string).collect();
            let drawer = self.drawers.get(arm).copied().unwrap_or(1); // always there
            lines.push(format!("arm {}: {}; drawer {drawer}", arm + 1, colours.join(" ")));
        }
        lines
    }

    pub(super) fn read(bytes: &[u8]) -> Result<Self, FileError> {
        let mut reader = Reader::new(bytes);
        let mut wheel = Self::solved();
        for colour in wheel.rings.iter_mut().flatten() {
            *colour = reader.u8()?;
        }
        wheel.centre = reader.u8()?;
        for drawer in &mut wheel.drawers {
            *drawer = reader.i8()?;
        }
        match wheel.problem() {
            None => Ok(wheel),
            Some((Place { name, arm: 0, offset }, problem)) => Err(FileError::value(name, offset, problem)),
            Some((Place { name, arm, offset }, problem)) => {
                Err(FileError::value(format!("{name} {arm}"), offset, problem))
            }
        }
    }

    pub(super) fn write(&self) -> Vec<u8> {
        let mut writer = Writer::default();
        self.rings.iter().flatten().for_each(|&colour| writer.u8(colour));
        writer.u8(self.centre);
        self.drawers.iter().for_each(|&drawer| writer.i8(drawer));
        writer.into_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::wheel::{Difficulty, Scramble};

    #[test]
    fn the_puzzle_and_the_file_have_the_same_positions() {
        assert_eq!(BeadWheel::from(&Wheel::solved()), BeadWheel::solved());
        for number in 0..100 {
            for difficulty in [Difficulty::Sixteen, Difficulty::Any] {
                let wheel = Scramble::new(difficulty, number).wheel;
                let written = BeadWheel::from(&wheel);
                assert_eq!(written.check(), Ok(()));
                assert_eq!(Wheel::try_from(&written), Ok(wheel));
            }
        }
        let wrong = BeadWheel { centre: 9, ..BeadWheel::solved() };
        assert!(Wheel::try_from(&wrong).is_err());
    }
}
