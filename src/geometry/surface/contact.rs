//! How smoothly two patches meet in their common border, as measured.

use super::{Derivatives, Joined, ParamSurface};
use crate::geometry::{Point, cross, dot, norm};
use serde::Serialize;
use std::f64::consts::{FRAC_PI_2, PI};

/// Steps along the border.
const STEPS: usize = 32;
/// Angles and differences below these are rounding; normals are known to about 1e-8 where they are limits.
const ANGLE: f64 = 1e-6;
const DIFFERENCE: f64 = 1e-9;

/// How two patches meet.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Order {
    /// In the border, with a break of the tangent plane.
    C0,
    /// With a common tangent plane, in which the second patch turns back over the first.
    Fold,
    /// With a common tangent plane, the first derivatives across the border are different.
    Plane,
    /// The first derivatives are the same, the second are not.
    C1,
    /// First and second derivatives are the same.
    C2,
}

/// The largest deviation of something along the border, and where it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Deviation {
    /// How large it is.
    pub most: f64,
    /// The parameter along the border.
    pub at: f64,
}

impl Deviation {
    fn take(&mut self, value: f64, at: f64) {
        if value > self.most {
            *self = Self { most: value, at };
        }
    }
}

/// The order of contact along the common border of two patches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Contact {
    /// The best order that holds all along the border.
    pub order: Order,
    /// The angle between the tangent planes, in radians, at most pi/2; `None` where the border has no normals.
    pub angle: Option<Deviation>,
    /// The difference of the first derivatives across the border, by the largest of them.
    pub first: Deviation,
    /// The difference of the second derivatives across the border, by the largest first or second one.
    pub second: Deviation,
}

impl Contact {
    /// Measures two joined patches at 33 places along their border.
    #[must_use]
    pub fn of(surface: &Joined) -> Self {
        let places = (0..=STEPS).map(|step| step as f64 / STEPS as f64);
        let sides = |v: f64| -> Option<(f64, [Derivatives; 2])> {
            Some((v, [surface.at([0, 0], [1.0, v])?, surface.at([1, 0], [0.0, v])?]))
        };
        let along: Vec<(f64, [Derivatives; 2])> = places.filter_map(sides).collect();
        let largest = |of: fn(&Derivatives) -> Point<3>| {
            along.iter().flat_map(|(_, sides)| sides).map(|side| norm(of(side))).fold(0.0, f64::max)
        };
        let size = largest(|side| side.u);
        let (mut first, mut second) = (Deviation::default(), Deviation::default());
        let by = [size, size.max(largest(|side| side.uu))];
        let (mut angle, mut back) = (None::<Deviation>, false);
        for (v, [one, other]) in &along {
            first.take(relative(one.u, other.u, by[0]), *v);
            second.take(relative(one.uu, other.uu, by[1]), *v);
            let normals = (surface.normal([0, 0], [1.0, *v]), surface.normal([1, 0], [0.0, *v]));
            if let (Some(one), Some(other)) = normals {
                let turn = norm(cross(one, other)).atan2(dot(one, other));
                back |= turn > FRAC_PI_2;
                angle.get_or_insert_default().take(turn.min(PI - turn), *v);
            }
        }
        let order = match angle {
            Some(Deviation { most, .. }) if most > ANGLE => Order::C0,
            Some(_) if back => Order::Fold,
            _ if first.most > DIFFERENCE && angle.is_none() => Order::C0,
            _ if first.most > DIFFERENCE => Order::Plane,
            _ if second.most > DIFFERENCE => Order::C1,
            _ => Order::C2,
        };
        Self { order, angle, first, second }
    }
}

/// How far two vectors are apart, as a part of a length; 0 where there is none.
fn relative(one: Point<3>, other: Point<3>, by: f64) -> f64 {
    let apart = norm(std::array::from_fn::<f64, 3, _>(|axis| one[axis] - other[axis]));
    if by > 0.0 && apart.is_finite() { apart / by } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Joint;
    use proptest::prelude::*;

    type Values = [Point<3>; 7];

    /// A value of a cubic by its values at 0, 1/3, 2/3, 1 gives its derivatives at an end exactly: by differences of
    /// four points, without any formula of the surface.
    fn differences(value: impl Fn(f64) -> Point<3>, end: bool) -> [Point<3>; 2] {
        let h = 0.25;
        let points: [Point<3>; 4] = std::array::from_fn(|k| {
            let t = h * k as f64;
            value(if end { 1.0 - t } else { t })
        });
        let combine = |factors: [f64; 4], by: f64| {
            std::array::from_fn(|axis| factors.iter().zip(points).map(|(k, p)| k * p[axis]).sum::<f64>() / by)
        };
        let first: Point<3> = combine([-11.0, 18.0, -9.0, 2.0], 6.0 * h);
        let first = if end { first.map(|x| -x) } else { first };
        [first, combine([2.0, -5.0, 4.0, -1.0], h * h)]
    }

    /// Bernstein polynomials written out.
    fn bezier(points: &[Point<3>], u: f64) -> Point<3> {
        let w = 1.0 - u;
        let weights = [w * w * w, 3.0 * u * w * w, 3.0 * u * u * w, u * u * u];
        std::array::from_fn(|axis| weights.iter().zip(points).map(|(k, p)| k * p[axis]).sum())
    }

    /// Hermite polynomials (2.12) written out.
    fn hermite([p, q, s, t]: [Point<3>; 4], u: f64) -> Point<3> {
        let (square, cube) = (u * u, u * u * u);
        let weights = [
            2.0 * cube - 3.0 * square + 1.0,
            3.0 * square - 2.0 * cube,
            cube - 2.0 * square + u,
            cube - square,
        ];
        std::array::from_fn(|axis| weights.iter().zip([p, q, s, t]).map(|(k, p)| k * p[axis]).sum())
    }

    fn holds(joint: Joint, ratio: f64, [one, other]: [[Point<3>; 2]; 2]) -> Result<(), TestCaseError> {
        let near = |a: Point<3>, b: Point<3>| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-8);
        let scaled = one[0].map(|x| x * if joint == Joint::Plane { ratio } else { 1.0 });
        prop_assert!(joint == Joint::C0 || near(scaled, other[0]), "{joint:?} {one:?} {other:?}");
        prop_assert!(joint != Joint::C2 || near(one[1], other[1]), "{joint:?} {one:?} {other:?}");
        Ok(())
    }

    fn point() -> impl Strategy<Value = Point<3>> {
        prop::array::uniform3(-100.0..100.0)
    }

    fn joint() -> impl Strategy<Value = Joint> {
        prop::sample::select(&Joint::ALL[..])
    }

    proptest! {
        #[test]
        fn a_kept_condition_of_bezier_patches_holds_after_every_move(
            mut column in prop::array::uniform7(point()), joint in joint(), ratio in 0.2..4.0_f64,
            moves in prop::collection::vec((0_usize..7, point()), 1..6),
        ) {
            let derivatives = |column: &Values| {
                [differences(|u| bezier(&column[..4], u), true), differences(|u| bezier(&column[3..], u), false)]
            };
            joint.impose_bezier(ratio, &mut column);
            holds(joint, ratio, derivatives(&column))?;
            for (moved, to) in moves {
                let from = column[moved];
                let before = column;
                column[moved] = to;
                joint.keep_bezier(ratio, &mut column, moved, from);
                prop_assert_eq!(column[moved], to);
                holds(joint, ratio, derivatives(&column))?;
                // What lies outside of the condition stays.
                if moved == 0 || moved == 6 || joint == Joint::C0 {
                    prop_assert_eq!(&column[1..6], &before.map(|p| p)[1..6].iter().enumerate()
                        .map(|(k, p)| if k + 1 == moved { to } else { *p }).collect::<Vec<_>>()[..]);
                }
            }
        }

        #[test]
        fn a_kept_condition_of_hermite_patches_holds_after_every_change(
            mut column in prop::array::uniform7(point()), joint in joint(), ratio in 0.2..4.0_f64,
            moves in prop::collection::vec((0_usize..7, point()), 1..6),
        ) {
            let derivatives = |&[p0, p1, p2, u0, u1, v1, u2]: &Values| {
                [differences(|u| hermite([p0, p1, u0, u1], u), true), differences(|u| hermite([p1, p2, v1, u2], u), false)]
            };
            joint.impose_hermite(ratio, &mut column);
            holds(joint, ratio, derivatives(&column))?;
            for (moved, to) in moves {
                column[moved] = to;
                joint.keep_hermite(ratio, &mut column, moved);
                prop_assert_eq!(column[moved], to);
                holds(joint, ratio, derivatives(&column))?;
            }
        }

        #[test]
        fn what_is_kept_is_measured(
            mut net in prop::array::uniform7(prop::array::uniform4(point())), joint in joint(), ratio in 1.5..4.0_f64,
            hermite in any::<bool>(),
        ) {
            for l in 0..4 {
                let mut column = net.map(|row| row[l]);
                match hermite {
                    true => joint.impose_hermite(ratio, &mut column),
                    false => joint.impose_bezier(ratio, &mut column),
                }
                net.iter_mut().zip(column).for_each(|(row, point)| row[l] = point);
            }
            let surface = match hermite {
                true => Joined::hermite(&net),
                false => Joined::bezier(&net.map(|row| row.to_vec())),
            };
            let contact = Contact::of(&surface.unwrap());
            let order = match joint {
                Joint::C0 => Order::C0, Joint::Plane => Order::Plane, Joint::C1 => Order::C1, Joint::C2 => Order::C2,
            };
            prop_assert_eq!(contact.order, order, "{:?}", contact);
        }
    }

    fn flat(across: impl Fn(usize) -> [f64; 2]) -> Joined {
        let row = |k: usize| {
            let [x, z] = across(k);
            (0..4).map(|l| [x, l as f64, z]).collect()
        };
        Joined::bezier(&(0..7).map(row).collect::<Vec<Vec<Point<3>>>>()).unwrap()
    }

    #[test]
    fn an_angle_a_fold_and_a_plane_are_told_apart() {
        let roof = Contact::of(&flat(|k| [k as f64, if k > 3 { k as f64 - 3.0 } else { 0.0 }]));
        assert_eq!(roof.order, Order::C0);
        assert!((roof.angle.unwrap().most.to_degrees() - 45.0).abs() < 1e-6);
        let fold = Contact::of(&flat(|k| [if k > 3 { 6.0 - k as f64 } else { k as f64 }, 0.0]));
        assert_eq!(fold.order, Order::Fold);
        let plane = Contact::of(&flat(|k| [if k > 3 { 2.0 * k as f64 - 3.0 } else { k as f64 }, 0.0]));
        assert_eq!(plane.order, Order::Plane);
        assert!((plane.first.most - 0.5).abs() < 1e-12);
        assert_eq!(Contact::of(&flat(|k| [k as f64, 0.0])).order, Order::C2);
        // Without any extent there is nothing that could break.
        assert_eq!(Contact::of(&Joined::hermite(&[[[0.0; 3]; 4]; 7]).unwrap()).order, Order::C2);
    }
}
