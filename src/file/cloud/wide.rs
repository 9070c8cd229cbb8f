//! Text in UTF-16, as the shell of another system writes it, in pieces.

/// Turns UTF-16 into UTF-8.
#[derive(Debug)]
pub(super) struct Wide {
    big_endian: bool,
    /// The first byte of a unit whose second one is still to come.
    half: Option<u8>,
    /// The first unit of a pair.
    high: Option<u16>,
}

impl Wide {
    /// For a file that begins with the byte order mark of UTF-16.
    pub(super) fn of(head: &[u8]) -> Option<Wide> {
        let big_endian = match head {
            [0xff, 0xfe, ..] => false,
            [0xfe, 0xff, ..] => true,
            _ => return None,
        };
        Some(Wide { big_endian, half: None, high: None })
    }

    /// The letters that end in a piece.
    pub(super) fn decode(&mut self, piece: &[u8]) -> Vec<u8> {
        let mut units: Vec<u16> = self.high.take().into_iter().collect();
        for &byte in piece {
            match self.half.take() {
                None => self.half = Some(byte),
                Some(first) if self.big_endian => units.push(u16::from_be_bytes([first, byte])),
                Some(first) => units.push(u16::from_le_bytes([first, byte])),
            }
        }
        self.high = units.pop_if(|unit| (0xd800..0xdc00).contains(unit));
        let letters = char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER));
        letters.collect::<String>().into_bytes()
    }
}
