//! Where the data are worked with: turned, moved, and in which unit.
//!
//! The method as printed depends on the place, the unit and the axes of its data. The normalised one first
//! takes the data to a standard position; then a similarity of the data is the same similarity of the surface,
//! an offset of the data is an offset of the surface, and the data of a sphere give the sphere.

use super::PnData;
use crate::geometry::point::{add_scaled, norm, scaled_difference};
use crate::geometry::{BoundingBox, GeometryError, Point, cross, dot};

/// How a surface goes through points with normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum PnMethod {
    /// The thesis's method on data in standard position, which makes it independent of the coordinates.
    #[default]
    Normalised,
    /// The thesis's method on the data as they are.
    Thesis,
}

impl PnMethod {
    /// Its name on the command line and in files: `pn`, `pn-thesis`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Normalised => "pn",
            Self::Thesis => "pn-thesis",
        }
    }
}

/// The largest z of a normal in the chart, whose projection goes out from +z.
const HIGHEST: f64 = 0.9;
/// Normals that differ by no more than this in the mean square are all the same.
const EQUAL: f64 = 1e-9;
/// Points that are a sphere but for this part of their size.
const SPHERE: f64 = 1e-9;

/// The length that the derivatives of r are measured by when they are projected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Projection {
    /// Orthogonally, with lengths in this unit.
    Orthogonal(f64),
    /// Along r, as the data are a sphere and there is no length.
    Vertical,
}

/// The data in their chart, and the way back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chart {
    /// Rows of the rotation from space to the chart.
    rotation: [Point<3>; 3],
    /// The point of space that is the origin before `shift` is added.
    centre: Point<3>,
    /// The length in space of the chart's unit, a power of two.
    unit: f64,
    /// What is added in the chart, in its unit: the centre of the best sphere.
    shift: Point<3>,
    /// The radius of the best sphere in the chart's unit; points are moved along normals by it.
    pub(super) radius: f64,
    /// How derivatives are projected.
    pub(super) projection: Projection,
}

/// The largest power of two up to a size, away from the ends of the range.
fn power_of_two(size: f64) -> f64 {
    if size > 0.0 { size.log2().floor().clamp(-1000.0, 1000.0).exp2() } else { 1.0 }
}

fn mean(vectors: &[Point<3>]) -> Point<3> {
    let share = 1.0 / vectors.len().max(1) as f64;
    vectors.iter().fold([0.0; 3], |sum, vector| add_scaled(sum, share, *vector))
}

/// The sum of the squares of the distances from a point.
fn spread(vectors: &[Point<3>], from: Point<3>) -> f64 {
    vectors.iter().map(|vector| scaled_difference(1.0, from, *vector)).map(|it| dot(it, it)).sum()
}

/// The rows of the smallest rotation that takes a unit vector to (0, 0, -1); the half turn about x for
/// (0, 0, 1).
fn rotation_to_minus_z(from: Point<3>) -> [Point<3>; 3] {
    let to = [0.0, 0.0, -1.0];
    let (axis, cosine) = (cross(from, to), dot(from, to));
    let sine = norm(axis);
    if sine == 0.0 {
        let turn = if cosine < 0.0 { -1.0 } else { 1.0 };
        return [[1.0, 0.0, 0.0], [0.0, turn, 0.0], [0.0, 0.0, turn]];
    }
    let [x, y, z] = axis.map(|component| component / sine);
    // Rodrigues' formula 1 + sin K + (1 - cos) K² with K v = axis x v.
    let k = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let square = |i: usize, j: usize| (0..3).map(|l| k[i][l] * k[l][j]).sum::<f64>();
    std::array::from_fn(|i| {
        std::array::from_fn(|j| f64::from(i == j) + sine * k[i][j] + (1.0 - cosine) * square(i, j))
    })
}

fn rotated(rotation: &[Point<3>; 3], vector: Point<3>) -> Point<3> {
    rotation.map(|row| dot(row, vector))
}

/// The rotation after which all normals stay away from +z: by their mean, else by the best of the axes.
fn rotation_of(normals: &[Point<3>]) -> Result<[Point<3>; 3], GeometryError> {
    let fits = |rotation: &[Point<3>; 3]| normals.iter().all(|normal| dot(rotation[2], *normal) < HIGHEST);
    let mean = mean(normals);
    let length = norm(mean);
    if length > EQUAL {
        let rotation = rotation_to_minus_z(mean.map(|x| x / length));
        if fits(&rotation) {
            return Ok(rotation);
        }
    }
    let least =
        |axis: Point<3>| normals.iter().map(|normal| dot(*normal, axis)).fold(f64::INFINITY, f64::min);
    let axes = [0, 1, 2].into_iter().flat_map(|d| {
        [1.0, -1.0].map(|sign| std::array::from_fn(|other| if other == d { sign } else { 0.0 }))
    });
    let best = axes.max_by(|a, b| least(*a).total_cmp(&least(*b))).map(rotation_to_minus_z);
    best.filter(fits).ok_or(GeometryError::NormalsTooWide)
}

impl Chart {
    /// The chart of some data with their points and normals in it.
    ///
    /// # Errors
    /// [`GeometryError::NormalsEqual`], [`GeometryError::NormalsTooWide`], [`GeometryError::NormalUp`].
    pub(super) fn of(
        data: &PnData,
        method: PnMethod,
    ) -> Result<(Self, Vec<Point<3>>, Vec<Point<3>>), GeometryError> {
        let middle = mean(data.normals());
        let turning = spread(data.normals(), middle);
        if turning <= EQUAL * EQUAL * data.normals().len() as f64 {
            return Err(GeometryError::NormalsEqual);
        }
        match method {
            PnMethod::Normalised => Self::normalised(data, turning),
            PnMethod::Thesis => Self::plain(data),
        }
    }

    /// The data as they are, but for the unit, which makes no difference as derivatives are measured by 1.
    fn plain(data: &PnData) -> Result<(Self, Vec<Point<3>>, Vec<Point<3>>), GeometryError> {
        if let Some(index) = data.normals().iter().position(|normal| normal[2] >= HIGHEST) {
            let columns = data.size()[1];
            return Err(GeometryError::NormalUp { row: index / columns, column: index % columns });
        }
        let largest = data.points().iter().flatten().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        let unit = power_of_two(largest);
        let chart = Self {
            rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            centre: [0.0; 3],
            unit,
            shift: [0.0; 3],
            radius: 0.0,
            projection: Projection::Orthogonal(1.0 / unit),
        };
        let points = data.points().iter().map(|point| point.map(|x| x / unit)).collect();
        Ok((chart, points, data.normals().to_vec()))
    }

    /// The data turned so that the mean normal is -z, less the best sphere; derivatives are measured by what is
    /// left.
    fn normalised(
        data: &PnData,
        turning: f64,
    ) -> Result<(Self, Vec<Point<3>>, Vec<Point<3>>), GeometryError> {
        let rotation = rotation_of(data.normals())?;
        let centre = mean(data.points());
        let unit = power_of_two(BoundingBox::of_points(data.points()).map_or(1.0, |bounds| bounds.extent()));
        let local = |point: &Point<3>| scaled_difference(1.0, centre, *point).map(|x| x / unit);
        let points: Vec<_> = data.points().iter().map(|point| rotated(&rotation, local(point))).collect();
        let normals: Vec<_> = data.normals().iter().map(|normal| rotated(&rotation, *normal)).collect();
        let (x_mean, n_mean) = (mean(&points), mean(&normals));
        let products = points.iter().zip(&normals);
        let products = products
            .map(|(x, n)| dot(scaled_difference(1.0, x_mean, *x), scaled_difference(1.0, n_mean, *n)));
        let radius = products.sum::<f64>() / turning;
        let shift = add_scaled(x_mean, -radius, n_mean);
        let reduce =
            |(x, n): (&Point<3>, &Point<3>)| add_scaled(scaled_difference(1.0, shift, *x), -radius, *n);
        let reduced: Vec<_> = points.iter().zip(&normals).map(reduce).collect();
        let count = points.len() as f64;
        let size = (spread(&points, x_mean) / count).sqrt() + radius.abs();
        let length = (spread(&reduced, mean(&reduced)) / turning).sqrt();
        let projection =
            if length <= SPHERE * size { Projection::Vertical } else { Projection::Orthogonal(length) };
        Ok((Self { rotation, centre, unit, shift, radius, projection }, reduced, normals))
    }

    /// A distance of space in the chart's unit.
    pub(super) fn to_chart(self, distance: f64) -> f64 {
        distance / self.unit
    }

    /// A length of the chart in space.
    pub(super) fn length(self, length: f64) -> f64 {
        length * self.unit
    }

    /// A direction of the chart in space.
    pub(super) fn direction(&self, [x, y, z]: Point<3>) -> Point<3> {
        let [a, b, c] = self.rotation;
        std::array::from_fn(|d| a[d] * x + b[d] * y + c[d] * z)
    }

    /// A point of the chart, given by `weight` times its coordinates there, in space, also times the weight.
    pub(super) fn point(&self, point: Point<3>, weight: f64) -> Point<3> {
        let turned = self.direction(add_scaled(point, weight, self.shift));
        std::array::from_fn(|d| self.unit * turned[d] + weight * self.centre[d])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn is_rotation(rows: [Point<3>; 3]) -> bool {
        let product = |i: usize, j: usize| dot(rows[i], rows[j]) - f64::from(i == j);
        let orthonormal = (0..9).all(|k| product(k / 3, k % 3).abs() < 4e-15);
        orthonormal && dot(cross(rows[0], rows[1]), rows[2]) > 0.0
    }

    #[test]
    fn half_turn_and_no_turn() {
        assert_eq!(rotated(&rotation_to_minus_z([0.0, 0.0, 1.0]), [1.0, 2.0, 3.0]), [1.0, -2.0, -3.0]);
        assert_eq!(rotated(&rotation_to_minus_z([0.0, 0.0, -1.0]), [1.0, 2.0, 3.0]), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn normals_all_round_are_refused() {
        let axes = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
        assert!(rotation_of(&axes).is_ok(), "z is free");
        let all = [&axes[..], &[[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]].concat();
        assert_eq!(rotation_of(&all), Err(GeometryError::NormalsTooWide));
    }

    proptest! {
        #[test]
        fn smallest_rotation_takes_the_vector_to_minus_z(
            x in -1.0..1.0_f64,
            y in -1.0..1.0_f64,
            z in prop::sample::select(vec![-1e9, -1.0, -1e-3, 0.5, 1.0, 1e9]),
        ) {
            let length = norm([x, y, z]);
            let unit = [x, y, z].map(|c| c / length);
            let rotation = rotation_to_minus_z(unit);
            prop_assert!(is_rotation(rotation));
            let [a, b, c] = rotated(&rotation, unit);
            prop_assert!(a.abs() < 2e-15 && b.abs() < 2e-15 && (c + 1.0).abs() < 2e-15);
        }
    }
}
