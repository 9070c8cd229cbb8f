//! Sine and cosine by turns.

use std::f64::consts::TAU;

/// Sine and cosine of `u` turns. Whole and quarter turns are taken off first, without rounding, so
/// that no accuracy is lost in many turns, and quarters have their exact values.
pub(super) fn turn(u: f64) -> [f64; 2] {
    let part = u - u.round();
    let quarters = (4.0 * part).round();
    let (sin, cos) = (TAU * (part - 0.25 * quarters)).sin_cos();
    match quarters as i32 {
        0 => [sin, cos],
        1 => [cos, -sin],
        -1 => [-cos, sin],
        _ => [-sin, -cos],
    }
}
