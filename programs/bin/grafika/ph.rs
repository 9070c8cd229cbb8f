//! What the commands tell about PH curves: the curve of a design, and its exact quantities.

use crate::curve::failure;
use grafika::design::{Design, DesignError};
use grafika::file::Method;
use grafika::geometry::ph::{PhCurve, Place, SpacePhCurve};
use grafika::geometry::{MAX_SAMPLES, ParamCurve};
use grafika::launch::Failure;

/// A PH curve of a document.
pub(crate) enum PhShape {
    Plane(PhCurve),
    Space(SpacePhCurve),
}

impl PhShape {
    /// The PH curve that a design describes.
    pub(crate) fn of(design: &Design, name: &str) -> Result<PhShape, Failure> {
        let shape = match design {
            Design::Plane(sketch) => sketch.ph_curve().map(PhShape::Plane),
            Design::Space(sketch) => sketch.space_ph_curve().map(PhShape::Space),
            Design::Fourier(_) => Err(DesignError::NoPh(Method::Fourier)),
            Design::Net(_)
            | Design::Ec(_)
            | Design::Rational(_)
            | Design::Patches(_)
            | Design::Knots(_)
            | Design::KnotNet(_)
            | Design::Shaped(_)
            | Design::Skin(_) => {
                return Err(Failure::usage(format!("{name} holds no control points of a PH curve")));
            }
        };
        shape.map_err(|error| failure(name, &error))
    }

    /// The PH curve of the plane that a design describes.
    pub(crate) fn plane(design: &Design, name: &str, what: &str) -> Result<PhCurve, Failure> {
        match PhShape::of(design, name)? {
            PhShape::Plane(curve) => Ok(curve),
            PhShape::Space(_) => Err(Failure::usage(format!(
                "{what} is for curves of the plane; {name} holds points in space"
            ))),
        }
    }

    fn spans(&self) -> usize {
        match self {
            PhShape::Plane(curve) => curve.spans(),
            PhShape::Space(curve) => curve.spans(),
        }
    }

    /// Places at `u = 0, 1/steps, ... 1` of every span.
    pub(crate) fn by_parameter(&self, steps: usize) -> Result<impl Iterator<Item = Place> + use<>, Failure> {
        let most = (MAX_SAMPLES / self.spans().max(1)).saturating_sub(1);
        if steps > most {
            return Err(Failure::work(grafika::geometry::GeometryError::Samples { per_span: steps, most }));
        }
        let of_span = move |span| (0..=steps).map(move |k| Place { span, u: k as f64 / steps as f64 });
        Ok((0..self.spans()).flat_map(of_span))
    }

    /// Places at equal lengths.
    pub(crate) fn by_length(&self, steps: usize) -> Result<Vec<Place>, Failure> {
        match self {
            PhShape::Plane(curve) => curve.equal_lengths(steps),
            PhShape::Space(curve) => curve.equal_lengths(steps),
        }
        .map_err(Failure::work)
    }

    /// The names of the columns; fewer without the quantities.
    pub(crate) fn header(&self, quantities: bool) -> Vec<&'static str> {
        let (point, rest): (&[&str], &[&str]) = match self {
            PhShape::Plane(_) => (&["span", "u", "x", "y"], &["s", "speed", "kappa", "nx", "ny"]),
            PhShape::Space(_) => (
                &["span", "u", "x", "y", "z"],
                &["s", "speed", "kappa", "tx", "ty", "tz", "e2x", "e2y", "e2z", "e3x", "e3y", "e3z"],
            ),
        };
        if quantities { [point, rest].concat() } else { point.to_vec() }
    }

    /// The numbers of a place in the order of the columns; curvature and directions do not exist where the curve stops.
    pub(crate) fn row(&self, place: Place, quantities: bool) -> Vec<Option<f64>> {
        let Place { span, u } = place;
        let mut row = vec![Some(span as f64), Some(u)];
        match self {
            PhShape::Plane(curve) => {
                row.extend(coordinates(curve.eval(span, u)));
                if quantities {
                    row.extend([curve.length_at(place), curve.speed(place), curve.curvature(place)]);
                    row.extend(coordinates(curve.normal(place)));
                }
            }
            PhShape::Space(curve) => {
                row.extend(coordinates(curve.eval(span, u)));
                if quantities {
                    row.extend([curve.length_at(place), curve.speed(place), curve.curvature(place)]);
                    let frame = curve.frame(place);
                    row.extend((0..3).flat_map(|k| coordinates(frame.map(|frame| frame[k]))));
                }
            }
        }
        row
    }
}

/// The coordinates of a point, or as many holes.
fn coordinates<const D: usize>(point: Option<[f64; D]>) -> [Option<f64>; D] {
    std::array::from_fn(|d| point.map(|point| point[d]))
}
