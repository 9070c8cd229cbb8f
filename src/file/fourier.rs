//! Coefficients of a Fourier curve: `.GBP`.
//!
//! Four rows a, p, b, q of 21 6-byte reals, columns k = 0..20; p0 and q0 are not used.

use super::{FileError, Format, check};
use crate::geometry::{self, GeometryError, Wave};
use crate::pascal::{Reader, Writer};
use serde::{Deserialize, Serialize};

/// Harmonics 0..20.
pub const HARMONICS: usize = 21;

/// The plane curve x(t) = a0 + sum a_k sin(kt + p_k pi), y(t) = b0 + sum b_k sin(kt + q_k pi), t in 0..2pi
/// (2.8), in pixels, y upwards. Column 0 of `p` and `q` is not used.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fourier {
    /// Amplitudes of x in pixels.
    pub a: [f64; HARMONICS],
    /// Phases of x in units of pi.
    pub p: [f64; HARMONICS],
    /// Amplitudes of y in pixels.
    pub b: [f64; HARMONICS],
    /// Phases of y in units of pi.
    pub q: [f64; HARMONICS],
}

impl Fourier {
    /// The curve (2.8).
    ///
    /// # Errors
    /// [`GeometryError::Coefficient`] and [`GeometryError::Overflow`].
    pub fn curve(&self) -> Result<geometry::Fourier<2>, GeometryError> {
        let wave =
            |a: &[f64; HARMONICS], p: &[f64; HARMONICS], k: usize| Wave { amplitude: a[k], phase: p[k] };
        let rows = (1..HARMONICS).map(|k| [wave(&self.a, &self.p, k), wave(&self.b, &self.q, k)]);
        geometry::Fourier::new([self.a[0], self.b[0]], &rows.collect::<Vec<_>>())
    }

    /// The coefficients of a curve, without harmonics that no file can hold. Amplitudes that are only rounding errors
    /// become 0, with phase 0.
    #[must_use]
    pub fn of_curve(curve: &geometry::Fourier<2>) -> Self {
        /// Pixels.
        const NOTHING: f64 = 1e-9;
        let [x, y] = curve.offset();
        let mut fourier = Self::default();
        (fourier.a[0], fourier.b[0]) = (x, y);
        for (k, row) in (1..HARMONICS).zip(curve.waves()) {
            let [x, y] = row.map(|wave| if wave.amplitude < NOTHING { Wave::default() } else { wave });
            (fourier.a[k], fourier.p[k], fourier.b[k], fourier.q[k]) =
                (x.amplitude, x.phase, y.amplitude, y.phase);
        }
        fourier
    }

    fn rows(&self) -> [(&'static str, &[f64; HARMONICS]); 4] {
        [("a", &self.a), ("p", &self.p), ("b", &self.b), ("q", &self.q)]
    }

    /// # Errors
    /// [`FileError::Invalid`] when a coefficient is not finite.
    pub(super) fn check(&self) -> Result<(), FileError> {
        for (name, row) in self.rows() {
            if let Some((k, value)) = row.iter().enumerate().find(|(_, v)| !v.is_finite()) {
                return Err(FileError::Invalid(format!("{name}{k} = {value} is not a finite number")));
            }
        }
        Ok(())
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let mut lines = vec!["coefficients of a Fourier curve".to_owned()];
        for k in 0..HARMONICS {
            let given = self.rows().into_iter().filter(|(_, row)| row[k] != 0.0); // k is below the length
            let values: Vec<_> =
                given.map(|(name, row)| format!("{name}{k} = {}", check::number(row[k]))).collect();
            if !values.is_empty() {
                lines.push(values.join(", "));
            }
        }
        lines
    }

    pub(super) fn read(bytes: &[u8]) -> Result<Self, FileError> {
        let mut reader = Reader::new(bytes);
        let mut fourier = Self::default();
        for row in [&mut fourier.a, &mut fourier.p, &mut fourier.b, &mut fourier.q] {
            for value in row {
                *value = reader.real()?;
            }
        }
        fourier.p[0] = 0.0;
        fourier.q[0] = 0.0;
        Ok(fourier)
    }

    /// Coefficients become the nearest 6-byte reals (40 significant bits).
    pub(super) fn write(&self) -> Result<Vec<u8>, FileError> {
        let mut writer = Writer::default();
        for (name, row) in self.rows() {
            for (k, &value) in row.iter().enumerate() {
                let problem = |e| FileError::misfit(Format::Gbp, format!("{name}{k} = {e}"));
                writer.real(value).map_err(problem)?;
            }
        }
        Ok(writer.into_bytes())
    }
}
