//! The vertices in Wavefront OBJ.

use super::super::FileError;
use super::gathered::{Gathered, Spot};
use super::lines::{point, words};

/// Reads a line: the point of `v x y z`; everything else does not count.
///
/// # Errors
/// [`FileError::Text`] for a coordinate that is no number, [`FileError::Invalid`] for too many points.
pub(super) fn read_line(gathered: &mut Gathered, number: usize, line: &[u8]) -> Result<(), FileError> {
    let mut words = words(line);
    if words.next() != Some(b"v") {
        return Ok(());
    }
    match point(words, number, 1)? {
        Some(point) => gathered.push(point, Spot::Line(number)),
        None => {
            gathered.short(number);
            Ok(())
        }
    }
}
