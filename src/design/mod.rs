//! Which curve or surface a document describes, and the named edits that change it.
//!
//! A design is control points *and* the recipe: method, closure, parameters, shapes of joints. It is what the
//! editors change, undo, keep and save, and what `sample` and `render` draw. No pixels and no words here.

mod arcs;
pub mod ec;
mod edit;
mod error;
pub mod fourier;
mod influence;
mod joined;
pub mod knots;
mod net;
pub mod nets;
mod normals;
pub mod offset;
pub mod ph;
pub mod shaped;
mod sketch;
pub mod skin;

pub use edit::{Edit, Place};
pub use error::DesignError;
pub use net::{Index, NetDesign, Part};
pub use normals::NORMALS_SIZE;
pub(crate) use sketch::follow;
pub use sketch::{Sketch, USUAL_DEGREE};

use crate::file::ec::EcDocument;
use crate::file::{
    Circles, CurveSettings, Document, FamilyName, Format, KnotNet, KnotPoints, Method, NetSettings, Patches,
    Places, RationalSpans, ShapedPoints, SpacePoints,
};
use crate::geometry::ph::Knots;
use crate::geometry::skin::{Clearing, Outline};
use crate::geometry::{Closure, ParamCurve, ParamSurface, Point};

/// What a document describes.
#[derive(Debug)]
pub enum Design {
    /// A curve by control points of the plane.
    Plane(Sketch<2>),
    /// A curve by control points in space.
    Space(Sketch<3>),
    /// A curve by Fourier coefficients.
    Fourier(Box<crate::file::Fourier>),
    /// A surface by a control net.
    Net(NetDesign),
    /// Curves and patches over extended Chebyshev spaces.
    Ec(Box<EcDocument>),
    /// A rational curve of the plane, such as an exact offset.
    Rational(Box<RationalSpans>),
    /// A surface of rational Bézier patches.
    Patches(Box<Patches>),
    /// A curve by its knots.
    Knots(Box<KnotPoints>),
    /// A surface by its knots.
    KnotNet(Box<KnotNet>),
    /// A curve with shape parameters.
    Shaped(Box<ShapedPoints>),
    /// The skin of circles.
    Skin(Box<Circles>),
}

/// A curve or a surface.
#[derive(Debug)]
pub enum Shape {
    /// A curve of the plane.
    Plane(Box<dyn ParamCurve<2>>),
    /// A curve in space.
    Space(Box<dyn ParamCurve<3>>),
    /// A surface.
    Surface(Box<dyn ParamSurface>),
    /// Arcs and patches, which need not meet.
    Parts(ec::EcShapes),
    /// The outlines of a skin.
    Outlines(Vec<Outline>),
}

impl Design {
    /// The design of a document.
    ///
    /// # Errors
    /// [`DesignError::NoShape`] for a document that holds no curve and no surface.
    pub fn of_document(document: Document) -> Result<Design, DesignError> {
        match document {
            Document::PlanePoints(plane) => Ok(Design::Plane(plane.into())),
            Document::SpacePoints(space) => Ok(Design::Space(space.into())),
            Document::Fourier(fourier) => Ok(Design::Fourier(fourier)),
            Document::Net(net) => Ok(Design::Net(NetDesign::new(net))),
            Document::Ec(document) => Ok(Design::Ec(document)),
            Document::Rational(spans) => Ok(Design::Rational(spans)),
            Document::Patches(patches) => Ok(Design::Patches(patches)),
            Document::Knots(knots) => Ok(Design::Knots(knots)),
            Document::KnotNet(net) => Ok(Design::KnotNet(net)),
            Document::Shaped(shaped) => Ok(Design::Shaped(shaped)),
            Document::Circles(circles) => Ok(Design::Skin(circles)),
            Document::Tangents(_)
            | Document::BeadWheel(_)
            | Document::CsangoCube(_)
            | Document::Billiards(_)
            | Document::Som(_)
            | Document::Spheres(_)
            | Document::Cloud(_) => Err(DesignError::NoShape),
        }
    }

    /// The curve or surface that it describes.
    ///
    /// # Errors
    /// Why there is none: no method, or what [`Sketch::curve`] and [`NetDesign::surface`] say.
    pub fn shape(&self) -> Result<Shape, DesignError> {
        Ok(match self {
            Design::Plane(sketch) => Shape::Plane(sketch.curve()?),
            Design::Space(sketch) => Shape::Space(sketch.curve()?),
            Design::Fourier(coefficients) => Shape::Plane(Box::new(coefficients.curve()?)),
            Design::Net(net) => Shape::Surface(net.surface()?),
            Design::Patches(patches) => Shape::Surface(Box::new(normals::patches(patches)?)),
            Design::Ec(document) => Shape::Parts(ec::Bases::default().shapes(document)?),
            Design::Rational(spans) => Shape::Plane(Box::new(offset::curve(spans)?)),
            Design::Knots(points) => match knots::curve(points)? {
                knots::Curve::Plane(curve) => Shape::Plane(Box::new(curve)),
                knots::Curve::Space(curve) => Shape::Space(Box::new(curve)),
            },
            Design::KnotNet(net) => Shape::Surface(Box::new(net.surface()?)),
            Design::Shaped(points) => match shaped::curve(points)? {
                shaped::Curve::Plane(curve) => Shape::Plane(Box::new(curve)),
                shaped::Curve::Space(curve) => Shape::Space(Box::new(curve)),
            },
            Design::Skin(circles) => Shape::Outlines(skin::circles(circles)?.skin(Clearing::Scaled).loops),
        })
    }
}

/// The control points of a curve.
#[derive(Clone, Debug, PartialEq)]
pub enum Controls {
    /// Of the plane.
    Plane(Vec<Point<2>>),
    /// In space.
    Space(Vec<Point<3>>),
    /// It has none, or is no curve.
    None,
}

impl Design {
    /// The control points of a single curve.
    #[must_use]
    pub fn controls(&self) -> Controls {
        let places = match self {
            Design::Plane(sketch) => return Controls::Plane(sketch.points.clone()),
            Design::Space(sketch) => return Controls::Space(sketch.points.clone()),
            Design::Knots(knots) => &knots.points,
            Design::Shaped(shaped) => &shaped.points,
            _ => return Controls::None,
        };
        match places {
            Places::Plane(points) => Controls::Plane(points.clone()),
            Places::Space(points) => Controls::Space(points.clone()),
        }
    }
}

/// The closure in settings; open if they name none.
pub(crate) fn closure(settings: &CurveSettings) -> Closure {
    if settings.closed == Some(true) { Closure::Closed } else { Closure::Open }
}

/// The document, with the method that a program draws by if it names none.
#[must_use]
pub fn naming(document: Document, implied: Option<Method>) -> Document {
    match document {
        Document::PlanePoints(mut plane) => {
            plane.settings.method = plane.settings.method.or(implied);
            Document::PlanePoints(plane)
        }
        Document::SpacePoints(mut space) => {
            space.settings.method = space.settings.method.or(implied);
            Document::SpacePoints(space)
        }
        Document::Net(mut net) => {
            net.settings.method = net.settings.method.or(implied);
            Document::Net(net)
        }
        other => other,
    }
}

/// What files of a DOS format cannot hold of a document, by its names in JSON. Values that are drawn anyway, such as a
/// bias of 1 or the program's `implied` method, do not count.
pub fn lost(document: &Document, format: Format, implied: Option<Method>) -> Vec<String> {
    if format.size().is_none() {
        // JSON holds everything.
        return Vec::new();
    }
    let controls = match document {
        Document::Knots(_) | Document::Shaped(_) => without_points(document),
        _ => Vec::new(),
    };
    if !controls.is_empty() {
        return if format == Format::Gbp { Vec::new() } else { controls };
    }
    let document = match document.clone() {
        Document::PlanePoints(mut plane) => {
            forget_usual(&mut plane.settings, implied);
            Document::PlanePoints(plane)
        }
        Document::SpacePoints(mut space) => {
            forget_usual(&mut space.settings, implied);
            Document::SpacePoints(space)
        }
        Document::Net(mut net) => {
            let NetSettings {
                method,
                k0,
                bias,
                tension,
                extended,
                distance,
                joint: _,
                ratio,
                free_poles,
                inner,
            } = &mut net.settings;
            *method = method.filter(|method| Some(*method) != implied);
            *k0 = k0.filter(|k0| *k0 != [0.5; 2]);
            *bias = bias.filter(|bias| *bias != [1.0; 2]);
            *tension = tension.filter(|tension| *tension != [0.0; 2]);
            *extended = extended.filter(|extended| *extended);
            *distance = distance.filter(|distance| *distance != 0.0);
            *ratio = ratio.filter(|ratio| *ratio != 1.0);
            *free_poles = free_poles.filter(|free| *free);
            *inner = inner.filter(|inner| *inner);
            Document::Net(net)
        }
        other => other,
    };
    let mut lost = document.settings();
    if let Document::PlanePoints(plane) = &document {
        let twins = [Format::Ic2, Format::Ec2];
        let joints = plane.joints.iter().map(|_| "joints");
        let tangents = plane.tangents.iter().filter(|_| !twins.contains(&format)).map(|_| "tangents");
        let points = plane.points.iter().take(1).filter(|_| format == Format::Ec2).map(|_| "points");
        lost.extend(joints.chain(tangents).chain(points).map(str::to_owned));
    }
    if let Document::SpacePoints(SpacePoints { tangents: Some(_), .. }) = &document {
        lost.push("tangents".to_owned());
    }
    lost
}

/// The names of what curves by knots and curves with shape parameters have besides control points.
#[must_use]
pub fn without_points(document: &Document) -> Vec<String> {
    let names = match document {
        Document::Knots(knots) => vec![
            ("order", true),
            ("knots", true),
            ("weights", knots.weights.is_some()),
            ("closed", knots.closed),
        ],
        Document::Shaped(shaped) => vec![
            ("family", true),
            ("parameters", !shaped.points.is_empty() && shaped.family != FamilyName::Cyclic),
            ("blend", shaped.blend.is_some()),
            ("through", shaped.through),
            ("closed", shaped.closed),
        ],
        _ => Vec::new(),
    };
    names.into_iter().filter(|(_, given)| *given).map(|(name, _)| name.to_owned()).collect()
}

/// Removes the settings that are drawn anyway.
fn forget_usual(settings: &mut CurveSettings, implied: Option<Method>) {
    let drawn = settings.method.or(implied);
    let CurveSettings { method, closed, k0, bias, tension, degree, knots, start: _, end: _, smooth: _ } =
        settings;
    *method = method.filter(|method| Some(*method) != implied);
    *closed = closed.filter(|closed| *closed);
    *k0 = k0.filter(|k0| *k0 != 0.5);
    *bias = bias.filter(|bias| *bias != 1.0);
    *tension = tension.filter(|tension| *tension != 0.0);
    *degree = degree.filter(|degree| *degree != USUAL_DEGREE);
    let usual = match drawn {
        Some(Method::Spline | Method::BSpline) => Knots::Uniform,
        _ => Knots::default(),
    };
    *knots = knots.take().filter(|knots| *knots != usual.into());
}
