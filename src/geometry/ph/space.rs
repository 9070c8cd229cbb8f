//! PH quintics in space with given end points and end derivatives (Farouki, al-Kandari and Sakkalis 2002).

use super::bernstein::{derivative, eval};
use super::quadrature::integral;
use super::quaternion::{Basis, Quaternion};
use crate::geometry::method::Closure;
use crate::geometry::param::clipped;
use crate::geometry::point::{add_scaled, check_points, norm, scaled_difference, within_limit};
use crate::geometry::{Bezier, GeometryError, Point, cross, dot};

/// A PH quintic in space on [0, 1]: `r' = A i A*` with a quadratic quaternion polynomial `A`, so its speed `|A|^2` is
/// a polynomial of degree 4. Speed and derivatives are by the segment's own parameter `u`.
#[derive(Clone, Debug, PartialEq)]
pub struct SpacePhSegment {
    /// The coefficients of `A`, in the standard position.
    a: [Quaternion; 3],
    basis: Basis,
    curve: Bezier<3>,
    speed: Vec<f64>,
}

impl SpacePhSegment {
    /// The quintic from `points[0]` to `points[1]` with the derivatives `tangents` there.
    ///
    /// There is a family of them with two free angles, and the angles depend on the axes. So the data are turned into
    /// a standard position, where the sum of the end directions is the x axis, and there both angles are 0. Data in a
    /// plane give a curve in that plane.
    ///
    /// # Errors
    /// A bad coordinate (points and tangents counted from 1), [`GeometryError::EqualNeighbours`] where points are
    /// equal and tangents zero, so that there is no curve, [`GeometryError::Overflow`].
    pub fn hermite(points: [Point<3>; 2], tangents: [Point<3>; 2]) -> Result<Self, GeometryError> {
        check_points(&points)?;
        check_points(&tangents)?;
        quintic(0, points, tangents)
    }

    /// The six Bézier control points.
    #[must_use]
    pub fn control(&self) -> &[Point<3>] {
        self.curve.points()
    }

    /// The Bernstein coefficients of the speed `|r'|`, of degree 4.
    #[must_use]
    pub fn speed_coefficients(&self) -> &[f64] {
        &self.speed
    }

    /// The speed `|r'|` at `u` in [0, 1], never negative.
    #[must_use]
    pub fn speed(&self, u: f64) -> f64 {
        let a = self.preimage(u);
        a.dot(a)
    }

    /// The curvature `|r' x r''| / |r'|^3` at `u`, not negative. `None` where the speed is zero.
    #[must_use]
    pub fn curvature(&self, u: f64) -> Option<f64> {
        let [_, first, second] = self.at(u);
        let speed = self.speed(u);
        let curvature = norm(cross(first.map(|x| x / speed), second.map(|x| x / speed))) / speed;
        (speed > 0.0 && curvature.is_finite()).then_some(curvature)
    }

    /// The torsion `(r' x r'') . r''' / |r' x r''|^2` at `u`. `None` where the curvature is zero or not defined.
    #[must_use]
    pub fn torsion(&self, u: f64) -> Option<f64> {
        let [_, first, second] = self.at(u);
        let control = self.curve.points();
        let legs: Vec<Point<3>> = control.windows(2).map(|p| scaled_difference(5.0, p[0], p[1])).collect();
        let third: Point<3> = std::array::from_fn(|d| {
            let axis: Vec<f64> = legs.iter().map(|leg| leg[d]).collect();
            eval(&derivative(&derivative(&axis)), clipped(u))
        });
        let binormal = cross(first, second);
        let size = norm(binormal);
        let torsion = dot(binormal.map(|x| x / size), third.map(|x| x / size));
        (size > 0.0 && torsion.is_finite()).then_some(torsion)
    }

    /// The Euler-Rodrigues frame at `u`: the unit tangent, and two unit vectors `A j A* / |A|^2` and `A k A* / |A|^2`
    /// across it. It is rational, and defined at inflections too. `None` where the speed is zero.
    #[must_use]
    pub fn frame(&self, u: f64) -> Option<[Point<3>; 3]> {
        let a = self.preimage(u);
        let length = a.dot(a).sqrt();
        let a = a * (1.0 / length);
        let frame = [0, 1, 2].map(|axis| self.basis.vector(a.axis(axis)));
        (length > 0.0 && frame.iter().flatten().all(|x| x.is_finite())).then_some(frame)
    }

    /// How fast the Euler-Rodrigues frame turns about the tangent, by `u`: `e_3 . e_2'`. `None` at zero speed.
    #[must_use]
    pub fn twist(&self, u: f64) -> Option<f64> {
        let u = clipped(u);
        let now = self.preimage(u);
        let [first, second] = [0, 1].map(|k| (self.a[k + 1] - self.a[k]) * 2.0);
        let slope = first * (1.0 - u) + second * u;
        let ([a, b, c, e], [da, db, dc, de]) = (now.0, slope.0);
        let twist = 2.0 * (a * db - da * b - c * de + dc * e) / now.dot(now);
        twist.is_finite().then_some(twist)
    }

    /// The angle by which the Euler-Rodrigues frame has turned about the tangent from 0 to `u`, in radians.
    pub(super) fn twisted(&self, u: f64) -> f64 {
        let twist = |u: f64| self.twist(u).unwrap_or(0.0);
        integral(&twist, [0.0, clipped(u)], 1e-14)
    }

    /// The bending energy: the integral of the squared curvature over the length, in 1/unit. `None` where it is
    /// infinite.
    #[must_use]
    pub fn energy(&self) -> Option<f64> {
        if [0.0, 1.0].iter().any(|u| self.speed(*u) == 0.0) && self.curvature(0.5) != Some(0.0) {
            return None;
        }
        let density = |u: f64| self.curvature(u).map_or(0.0, |it| it * it * self.speed(u));
        Some(integral(&density, [0.0, 1.0], 0.0)).filter(|energy| energy.is_finite())
    }

    /// The point, the first and the second derivative at `u`, which is clipped to [0, 1].
    #[must_use]
    pub fn at(&self, u: f64) -> [Point<3>; 3] {
        [self.curve.eval(u), self.curve.derivative(u), self.curve.second_derivative(u)]
    }

    fn preimage(&self, u: f64) -> Quaternion {
        let u = clipped(u);
        let [first, middle, last] = self.a;
        first * ((1.0 - u) * (1.0 - u)) + middle * (2.0 * u * (1.0 - u)) + last * (u * u)
    }
}

/// The quintic of a span.
pub(super) fn quintic(
    span: usize,
    points: [Point<3>; 2],
    tangents: [Point<3>; 2],
) -> Result<SpacePhSegment, GeometryError> {
    let chord = scaled_difference(1.0, points[0], points[1]);
    if norm(chord).max(norm(tangents[0])).max(norm(tangents[1])) == 0.0 {
        return Err(GeometryError::EqualNeighbours { number: span + 1, next: span + 2 });
    }
    let basis = standard_position(tangents);
    let [from, to] = tangents.map(|tangent| basis.coordinates(tangent));
    let chord = basis.coordinates(chord);
    let (first, last) = (Quaternion::root(from), Quaternion::root(to));
    let between = first.mixed(last);
    // c = 120 (P_1 - P_0) - 15 (d_0 + d_1) + 5 (A_0 i A_2* + A_2 i A_0*), A_1 = (root(c) - 3 (A_0 + A_2)) / 4.
    let c = std::array::from_fn(|d| 120.0 * chord[d] - 15.0 * (from[d] + to[d]) + 10.0 * between[d]);
    let middle = (Quaternion::root(c) - (first + last) * 3.0) * 0.25;
    segment(span, [first, middle, last], basis, points)
}

/// The segment of these coefficients.
fn segment(
    span: usize,
    a: [Quaternion; 3],
    basis: Basis,
    [start, end]: [Point<3>; 2],
) -> Result<SpacePhSegment, GeometryError> {
    let [first, middle, last] = a;
    // Products of Bernstein coefficients of degree 2.
    let (outer, inner) = (first.mixed(last), middle.axis(0));
    let hodograph = [
        first.axis(0),
        first.mixed(middle),
        std::array::from_fn(|d| (outer[d] + 2.0 * inner[d]) / 3.0),
        middle.mixed(last),
        last.axis(0),
    ];
    let speed = vec![
        first.dot(first),
        first.dot(middle),
        (2.0 * middle.dot(middle) + first.dot(last)) / 3.0,
        middle.dot(last),
        last.dot(last),
    ];
    let mut control = vec![start];
    for leg in hodograph {
        let before = control.last().copied().unwrap_or(start);
        control.push(add_scaled(before, 0.2, basis.vector(leg)));
    }
    if let Some(last) = control.last_mut() {
        *last = end;
    }
    if !control.iter().all(within_limit) || !speed.iter().all(|speed| within_limit(&[*speed])) {
        return Err(GeometryError::Overflow { span });
    }
    let curve = Bezier::new(Closure::Open, &control)?;
    Ok(SpacePhSegment { a, basis, curve, speed })
}

/// The axes of the standard position: the first one halfway between the end directions. Where these are opposite, it
/// is perpendicular to both; a zero tangent takes no part.
fn standard_position(tangents: [Point<3>; 2]) -> Basis {
    let directions = tangents.map(|tangent| {
        let length = norm(tangent);
        if length > 0.0 { tangent.map(|x| x / length) } else { [0.0; 3] }
    });
    let sum = add_scaled(directions[0], 1.0, directions[1]);
    let length = norm(sum);
    if length > 1e-12 {
        return Basis::along(sum.map(|x| x / length));
    }
    if norm(directions[0]) == 0.0 {
        return Basis::STANDARD;
    }
    let Basis([_, across, _]) = Basis::along(directions[0]);
    Basis::along(across)
}

#[cfg(test)]
mod tests {
    use super::super::PhSegment;
    use super::super::testing::{distance, point};
    use super::*;
    use crate::geometry::arclen::integrate;
    use proptest::prelude::*;

    fn spatial() -> impl Strategy<Value = Point<3>> {
        [-100.0..100.0_f64, -100.0..100.0_f64, -100.0..100.0_f64]
    }

    fn quintic() -> impl Strategy<Value = SpacePhSegment> {
        (spatial(), spatial(), spatial(), spatial()).prop_filter_map("little speed", |(a, b, c, d)| {
            let segment = SpacePhSegment::hermite([a, b], [c, d]).ok()?;
            let speeds = (0..=100).map(|k| segment.speed(f64::from(k) / 100.0));
            let mean = segment.speed_coefficients().iter().sum::<f64>() / 5.0;
            (speeds.fold(f64::INFINITY, f64::min) > 0.02 * mean).then_some(segment)
        })
    }

    proptest! {
        #[test]
        fn the_data_are_kept_and_the_speed_is_the_length_of_the_derivative(
            a in spatial(), b in spatial(), c in spatial(), d in spatial(), u in 0.0..1.0,
        ) {
            let segment = SpacePhSegment::hermite([a, b], [c, d]).unwrap();
            let ([start, first, _], [end, last, _]) = (segment.at(0.0), segment.at(1.0));
            prop_assert_eq!((start, end), (a, b));
            prop_assert!(distance(first, c) < 1e-11 && distance(last, d) < 1e-11);
            // The derivative at the end shows that the integral ends at the point.
            let [_, slope, _] = segment.at(u);
            prop_assert!((norm(slope) - segment.speed(u)).abs() < 1e-11 * 400.0);
            let polynomial = eval(segment.speed_coefficients(), u);
            prop_assert!((polynomial - segment.speed(u)).abs() < 1e-12 * 400.0);
        }

        #[test]
        fn frames_are_orthonormal_and_their_twist_is_a_derivative(segment in quintic(), u in 0.01..0.99) {
            let frame = segment.frame(u).unwrap();
            let [_, slope, _] = segment.at(u);
            prop_assert!(distance(frame[0], slope.map(|x| x / norm(slope))) < 1e-11);
            for i in 0..3 {
                for j in 0..3 {
                    let want = if i == j { 1.0 } else { 0.0 };
                    prop_assert!((dot(frame[i], frame[j]) - want).abs() < 1e-14 * 10.0);
                }
            }
            prop_assert!(distance(cross(frame[0], frame[1]), frame[2]) < 1e-13);
            let h = 1e-6;
            let [before, after] = [u - h, u + h].map(|u| segment.frame(u).unwrap()[1]);
            let change = scaled_difference(0.5 / h, before, after);
            let twist = segment.twist(u).unwrap();
            prop_assert!((dot(frame[2], change) - twist).abs() < 1e-5 * twist.abs().max(1.0));
            let turned = integrate(&|u| segment.twist(u).unwrap(), [0.0, u], 1e-12);
            prop_assert!((segment.twisted(u) - turned).abs() < 1e-9);
        }

        #[test]
        fn curvature_and_torsion_agree_with_differences_of_the_tangent(segment in quintic(), u in 0.05..0.95) {
            let h = 1e-5;
            let speed = segment.speed(u);
            let [before, after] = [u - h, u + h].map(|u| segment.frame(u).unwrap()[0]);
            let by_tangents = norm(scaled_difference(0.5 / h / speed, before, after));
            let curvature = segment.curvature(u).unwrap();
            prop_assert!((curvature - by_tangents).abs() < 1e-4 * curvature.max(1.0 / speed));
            let bend = |u: f64| { let [_, first, second] = segment.at(u); cross(first, second) };
            // Away from inflections the binormal turns by the torsion.
            prop_assume!(curvature * speed > 0.1);
            let binormal = |u: f64| { let b = bend(u); b.map(|x| x / norm(b)) };
            let turned = scaled_difference(0.5 / h / speed, binormal(u - h), binormal(u + h));
            let torsion = segment.torsion(u).unwrap();
            prop_assert!((torsion.abs() - norm(turned)).abs() < 1e-3 * torsion.abs().max(1.0 / speed));
            let density = |u: f64| segment.curvature(u).unwrap().powi(2) * segment.speed(u);
            let energy = segment.energy().unwrap();
            prop_assert!((energy - integrate(&density, [0.0, 1.0], 1e-10 * energy)).abs() < 1e-8 * energy);
        }

        #[test]
        fn plane_data_give_a_curve_in_the_plane(a in point(), b in point(), c in point(), d in point()) {
            let lift = |p: Point<2>| [p[0], p[1], 7.0];
            let flat = |v: Point<2>| [v[0], v[1], 0.0];
            let segment = SpacePhSegment::hermite([lift(a), lift(b)], [flat(c), flat(d)]).unwrap();
            // One of the four planar solutions, unless a root had to leave the plane to pass the opposite of x.
            let (four, _) = PhSegment::hermite([a, b], [c, d]).unwrap();
            let off = |plane: &PhSegment| {
                (0..=8).map(|k| f64::from(k) / 8.0).fold(0.0_f64, |off, u| {
                    off.max(distance(lift(plane.at(u)[0]), segment.at(u)[0]))
                })
            };
            let least = four.iter().map(off).fold(f64::INFINITY, f64::min);
            prop_assert!(least < 1e-8 * 300.0, "{}", least);
        }
    }

    #[test]
    fn ends_without_or_with_opposite_directions() {
        let points = [[0.0; 3], [100.0, 20.0, -30.0]];
        for tangents in [
            [[0.0; 3], [0.0; 3]],
            [[0.0; 3], [50.0, 0.0, 0.0]],
            [[40.0, 10.0, 0.0], [-40.0, -10.0, 0.0]],
            [[0.0, 90.0, 0.0], [0.0, -90.0, 0.0]],
            [[-60.0, 0.0, 0.0], [-60.0, 0.0, 0.0]],
        ] {
            let segment = SpacePhSegment::hermite(points, tangents).unwrap();
            let ([_, first, _], [_, last, _]) = (segment.at(0.0), segment.at(1.0));
            assert!(distance(first, tangents[0]) < 1e-12 && distance(last, tangents[1]) < 1e-12);
            let speed = |u: f64| segment.speed(u);
            let length = segment.speed_coefficients().iter().sum::<f64>() / 5.0;
            assert!((length - integrate(&speed, [0.0, 1.0], 1e-11)).abs() < 1e-9);
            assert!(segment.energy().is_none_or(f64::is_finite) && segment.twisted(1.0).is_finite());
        }
        let nothing = SpacePhSegment::hermite([[1.0; 3]; 2], [[0.0; 3]; 2]);
        assert_eq!(nothing, Err(GeometryError::EqualNeighbours { number: 1, next: 2 }));
        let stop = SpacePhSegment::hermite(points, [[0.0; 3], [50.0, 0.0, 0.0]]).unwrap();
        assert_eq!((stop.frame(0.0), stop.curvature(0.0), stop.torsion(0.0)), (None, None, None));
        let bad = SpacePhSegment::hermite([[0.0; 3], [0.0, f64::INFINITY, 0.0]], [[1.0; 3]; 2]);
        assert_eq!(bad, Err(GeometryError::NotFinite { number: 2 }));
    }
}
