//! Clouds as files: the fewest digits that read back as the same double, or the double itself.

use super::super::FileError;
use super::super::check::write_number;
use super::{Cloud, CloudFormat};

impl Cloud {
    /// The file with this cloud: XYZ, CSV with a header, PLY in little-endian doubles, OBJ. A plane cloud has two
    /// columns in XYZ and CSV.
    ///
    /// # Errors
    /// [`FileError::Misfit`] for STL, which holds triangles; those of [`Cloud::check`].
    pub fn write(&self, format: CloudFormat) -> Result<Vec<u8>, FileError> {
        self.check()?;
        let columns = if self.is_plane() { 2 } else { 3 };
        match format {
            CloudFormat::Xyz => Ok(self.text("", "", ' ', columns)),
            CloudFormat::Csv if columns == 2 => Ok(self.text("x,y\n", "", ',', columns)),
            CloudFormat::Csv => Ok(self.text("x,y,z\n", "", ',', columns)),
            CloudFormat::Obj => Ok(self.text("", "v ", ' ', 3)),
            CloudFormat::Ply => Ok(self.ply()),
            CloudFormat::Stl => {
                let problem = "the points of a cloud; it holds triangles".to_owned();
                Err(FileError::Misfit { format: "STL", problem })
            }
        }
    }

    fn text(&self, header: &str, begin: &str, delimiter: char, columns: usize) -> Vec<u8> {
        // Most numbers have up to 17 digits, a sign, a point and what separates them.
        let mut text = String::with_capacity(header.len() + self.points.len() * (begin.len() + 20 * columns));
        text.push_str(header);
        for point in &self.points {
            text.push_str(begin);
            for (at, &value) in point.iter().take(columns).enumerate() {
                if at > 0 {
                    text.push(delimiter);
                }
                write_number(&mut text, value);
            }
            text.push('\n');
        }
        text.into_bytes()
    }

    fn ply(&self) -> Vec<u8> {
        let header = format!(
            "ply\nformat binary_little_endian 1.0\ncomment grafika\nelement vertex {}\nproperty double x\n\
             property double y\nproperty double z\nend_header\n",
            self.points.len()
        );
        let mut bytes = Vec::with_capacity(header.len() + 24 * self.points.len());
        bytes.extend_from_slice(header.as_bytes());
        for value in self.points.iter().flatten() {
            bytes.extend_from_slice(&value.to_le_bytes());
        }
        bytes
    }
}
