//! Shells: the solid between a surface and an offset, as a closed mesh.

use super::PnSurface;
use crate::geometry::{GeometryError, MAX_SAMPLES, ParamSurface, Point};

/// The solid between a surface and its offset: two sheets and the walls along the four borders, as a closed
/// mesh of triangles. Seen from outside the vertices of a triangle go round counterclockwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Shell {
    /// The vertices: those of the surface, then those of the offset.
    pub vertices: Vec<Point<3>>,
    /// The indices of the vertices of every triangle.
    pub triangles: Vec<[usize; 3]>,
}

impl PnSurface {
    /// The shell between this surface and its offset at a distance, every span in `per_span` steps. The outside
    /// is right where both are without folds ([`PnSurface::safe_distances`]).
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for a distance that is 0, not finite or too large,
    /// [`GeometryError::Samples`] for no steps or too many points.
    pub fn shell(&self, distance: f64, per_span: usize) -> Result<Shell, GeometryError> {
        if distance == 0.0 {
            let wanted = "different from 0, as it is the thickness of the shell";
            return Err(GeometryError::Parameter { name: "distance", value: distance, wanted });
        }
        let (near, far) = (self.grid(per_span)?, self.offset(distance)?.grid(per_span)?);
        let (rows, columns) = (near.rows(), near.columns());
        let count = near.points().len();
        if count > MAX_SAMPLES / 2 {
            return Err(GeometryError::Samples { per_span, most: per_span.saturating_sub(1) });
        }
        // Counterclockwise as seen from the side of r_u x r_v.
        let sheet: Vec<[usize; 3]> = near.cells().flat_map(|[a, b, c, d]| [[c, b, a], [c, a, d]]).collect();
        let outer = self.looks_along_normals();
        let mut triangles = Vec::with_capacity(2 * sheet.len() + 4 * (rows + columns));
        // Outside is along the normals at the sheet that they point to, and against them at the other.
        let far_is_outer = distance > 0.0;
        for triangle in &sheet {
            let turned = |offset: usize, along: bool| {
                let [a, b, c] = triangle.map(|vertex| vertex + offset);
                if along == outer { [a, b, c] } else { [a, c, b] }
            };
            triangles.push(turned(0, !far_is_outer));
            triangles.push(turned(count, far_is_outer));
        }
        walls(&mut triangles, [rows, columns], count, outer == far_is_outer);
        Ok(Shell { vertices: near.points().iter().chain(far.points()).copied().collect(), triangles })
    }

    /// Whether r_u x r_v has the direction of the data's normals, in the middle of the first patch.
    fn looks_along_normals(&self) -> bool {
        let middle = [0.5, 0.5];
        let pair = self.normal([0, 0], middle).zip(self.place([0, 0], middle));
        pair.is_none_or(|(normal, place)| crate::geometry::dot(normal, place.normal) > 0.0)
    }
}

/// The walls between the borders of two sheets; `plain` when the sheet of higher indices is the one whose
/// triangles go round counterclockwise as seen from the side of r_u x r_v.
fn walls(triangles: &mut Vec<[usize; 3]>, [rows, columns]: [usize; 2], count: usize, plain: bool) {
    let index = |k: usize, l: usize| k * columns + l;
    // Once round the border so that the sheet lies to the left as seen from the side of r_u x r_v.
    let round = (0..rows)
        .map(|k| index(k, 0))
        .chain((1..columns).map(|l| index(rows - 1, l)))
        .chain((0..rows.saturating_sub(1)).rev().map(|k| index(k, columns - 1)))
        .chain((0..columns.saturating_sub(1)).rev().map(|l| index(0, l)));
    let round: Vec<usize> = round.collect();
    for pair in round.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        for [x, y, z] in [[a, b, b + count], [a, b + count, a + count]] {
            triangles.push(if plain { [x, y, z] } else { [x, z, y] });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::pn::examples::{Example, data, paraboloid, saddle, sphere};
    use crate::geometry::{PnData, PnMethod, cross, dot};
    use std::collections::HashMap;

    fn volume(shell: &Shell) -> f64 {
        let corners = shell.triangles.iter().map(|triangle| triangle.map(|k| shell.vertices[k]));
        corners.map(|[a, b, c]| dot(a, cross(b, c)) / 6.0).sum()
    }

    /// Every edge is there once in each direction.
    fn is_closed(shell: &Shell) -> bool {
        let mut edges: HashMap<[usize; 2], i32> = HashMap::new();
        for [a, b, c] in &shell.triangles {
            for edge in [[*a, *b], [*b, *c], [*c, *a]] {
                *edges.entry(edge).or_default() += 1;
            }
        }
        let once = edges.iter().all(|([a, b], count)| *count == 1 && edges.get(&[*b, *a]) == Some(&1));
        let euler = shell.vertices.len() as i64 - edges.len() as i64 / 2 + shell.triangles.len() as i64;
        once && euler == 2
    }

    #[test]
    fn shells_are_closed_and_turned_outside() {
        for (example, d) in [(paraboloid as Example, 2.0), (paraboloid, -2.0), (saddle, 0.3), (saddle, -0.3)]
        {
            let plain = data(example, 3, 4);
            // The same with rows and columns exchanged: r_u x r_v points to the other side.
            let exchanged = |all: &dyn Fn(usize, usize) -> Point<3>| -> Vec<Vec<Point<3>>> {
                (0..4).map(|j| (0..3).map(|i| all(i, j)).collect()).collect()
            };
            let points = exchanged(&|i, j| plain.point(i, j).unwrap());
            let other = PnData::new(&points, &exchanged(&|i, j| plain.normal(i, j).unwrap())).unwrap();
            for data in [plain, other] {
                let shell = PnSurface::new(&data, PnMethod::Normalised).unwrap().shell(d, 6).unwrap();
                assert!(is_closed(&shell));
                assert!(volume(&shell) > 0.0);
            }
        }
    }

    #[test]
    fn volume_is_that_of_the_sphere() {
        let surface = PnSurface::new(&data(sphere, 3, 3), PnMethod::Normalised).unwrap();
        let thick = volume(&surface.shell(3.0, 24).unwrap());
        let thin = volume(&surface.shell(-3.0, 24).unwrap());
        // Shells of the same solid angle: (33³ - 30³) : (30³ - 27³).
        let expected = (33.0_f64.powi(3) - 30.0_f64.powi(3)) / (30.0_f64.powi(3) - 27.0_f64.powi(3));
        assert!((thick / thin - expected).abs() < 1e-3, "{thick} {thin}");
    }

    #[test]
    fn wrong_shells_are_named() {
        let surface = PnSurface::new(&data(saddle, 3, 3), PnMethod::Normalised).unwrap();
        for distance in [0.0, f64::NAN, 1e200] {
            let error = surface.shell(distance, 4);
            assert!(matches!(error, Err(GeometryError::Parameter { name: "distance", .. })), "{error:?}");
        }
        assert!(matches!(surface.shell(1.0, 0), Err(GeometryError::Samples { .. })));
        assert!(matches!(surface.shell(1.0, 1 << 20), Err(GeometryError::Samples { .. })));
    }
}
