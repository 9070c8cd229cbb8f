//! One type over all contents, and the way between it and DOS files.

use super::ec::EcDocument;
use super::{
    BeadWheel, Circles, Cloud, CloudFormat, CsangoCube, FileError, FileKind, Format, Fourier, KnotNet,
    KnotPoints, Net, NetKind, NetSettings, Patches, PlanePoints, RationalSpans, ShapedPoints, SomNet,
    SpacePoints, Spheres, Tangents, billiards, settings,
};
use crate::table::Game;

/// What a data file holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Document {
    /// `.IP2`, `.IC2`: control points in the plane, perhaps with tangents.
    PlanePoints(PlanePoints),
    /// `.EC2` without its twin.
    Tangents(Tangents),
    /// `.GBP`: coefficients of a Fourier curve; boxed, for it is far larger than the others.
    Fourier(Box<Fourier>),
    /// `.IP3`: control points in space.
    SpacePoints(SpacePoints),
    /// `.FHC` to `.ZYP`: a control net.
    Net(Net),
    /// `.GYK`: a position of the bead wheel.
    BeadWheel(BeadWheel),
    /// `.CSK`: a position of the Csángó cube.
    CsangoCube(CsangoCube),
    /// `.BIL`: a game of billiards.
    Billiards(Box<Game>),
    /// `.KCT` to `.KCJ`: spaces, curves, surfaces and scenes of KC_TER.
    Ec(Box<EcDocument>),
    /// `.RBC`: a rational curve of the plane.
    Rational(Box<RationalSpans>),
    /// `.RBS`: rational Bézier patches, as offsets are written.
    Patches(Box<Patches>),
    /// `.CSM`: a B-spline curve by its knots.
    Knots(Box<KnotPoints>),
    /// `.CSF`: a B-spline surface by its knots.
    KnotNet(Box<KnotNet>),
    /// `.ALP`: a curve with shape parameters.
    Shaped(Box<ShapedPoints>),
    /// `.SOM`: the neurons of a net.
    Som(Box<SomNet>),
    /// `.KOR`: circles of the plane.
    Circles(Box<Circles>),
    /// `.GOM`: spheres.
    Spheres(Box<Spheres>),
    /// `.XYZ` to `.STL`: a cloud of points.
    Cloud(Cloud),
}

impl Document {
    /// The document in the bytes of a data file.
    ///
    /// # Errors
    /// [`FileError`] when the size is wrong or a value that means something cannot be; fields that the
    /// programs compute again are not looked at.
    pub fn read(format: Format, bytes: &[u8]) -> Result<Self, FileError> {
        if let Some(format) = CloudFormat::of(format) {
            return Cloud::read(format, bytes).map(Self::Cloud);
        }
        let Some(size) = format.size() else {
            let document = Self::decode(FileKind::Json, bytes)?;
            let found = document.format();
            let problem = || format!("this is {}, not {}", found.english(), format.english());
            return if found == format { Ok(document) } else { Err(FileError::Invalid(problem())) };
        };
        if bytes.len() != size {
            return Err(FileError::Size { format, found: bytes.len() });
        }
        if let Some(kind) = NetKind::of(format) {
            return Net::read(kind, bytes).map(Self::Net);
        }
        match format {
            Format::Ec2 => Tangents::read(bytes).map(Self::Tangents),
            Format::Gbp => Fourier::read(bytes).map(Box::new).map(Self::Fourier),
            Format::Ip3 => SpacePoints::read(bytes).map(Self::SpacePoints),
            Format::Gyk => BeadWheel::read(bytes).map(Self::BeadWheel),
            Format::Csk => CsangoCube::read(bytes).map(Self::CsangoCube),
            // The nets are done.
            _ => PlanePoints::read(bytes).map(Self::PlanePoints),
        }
    }

    /// The bytes of a data file with this document. Fields that only cache something are filled as the
    /// original programs would; those that nobody uses are zero.
    ///
    /// # Errors
    /// [`FileError`] when the values do not belong together or the format cannot hold them.
    pub fn write(&self, format: Format) -> Result<Vec<u8>, FileError> {
        if let (Self::Cloud(cloud), Some(format)) = (self, CloudFormat::of(format)) {
            return cloud.write(format);
        }
        self.check()?;
        match (self, format) {
            (Self::PlanePoints(points), Format::Ip2 | Format::Ic2) => points.write(format),
            (Self::PlanePoints(points), Format::Ec2) => points.write_tangents(),
            (Self::Tangents(tangents), Format::Ec2) => tangents.write(),
            (Self::Fourier(fourier), Format::Gbp) => fourier.write(),
            (Self::SpacePoints(points), Format::Ip3) => points.write(),
            (Self::BeadWheel(wheel), Format::Gyk) => Ok(wheel.write()),
            (Self::CsangoCube(cube), Format::Csk) => cube.write(),
            // No cloud comes this far.
            _ if format.size().is_none() && self.format() == format => self.encode(FileKind::Json),
            (Self::Net(net), _) if NetKind::of(format).is_some_and(|kind| net.kind.goes_into(kind)) => {
                net.write(NetKind::of(format).unwrap_or(net.kind))
            }
            _ => {
                let content = self.format().english();
                Err(FileError::misfit(format, format!("{content}; it holds {}", format.english())))
            }
        }
    }

    /// The DOS format that this document is at home in. Points with tangents belong into `.IC2`, and a
    /// second file [`Format::Ec2`] with the tangents beside it.
    #[must_use]
    pub fn format(&self) -> Format {
        match self {
            Self::PlanePoints(points) if points.tangents.is_some() => Format::Ic2,
            Self::PlanePoints(_) => Format::Ip2,
            Self::Tangents(_) => Format::Ec2,
            Self::Fourier(_) => Format::Gbp,
            Self::SpacePoints(_) => Format::Ip3,
            Self::Net(net) => net.kind.format(),
            Self::BeadWheel(_) => Format::Gyk,
            Self::CsangoCube(_) => Format::Csk,
            Self::Billiards(_) => Format::Bil,
            Self::Ec(document) => document.format(),
            Self::Rational(_) => Format::Rbc,
            Self::Patches(_) => Format::Rbs,
            Self::Knots(_) => Format::Csm,
            Self::KnotNet(_) => Format::Csf,
            Self::Shaped(_) => Format::Alp,
            Self::Som(_) => Format::Som,
            Self::Circles(_) => Format::Kor,
            Self::Spheres(_) => Format::Gom,
            Self::Cloud(_) => Format::Xyz,
        }
    }

    /// Checks what every document must keep, wherever it goes: finite numbers, matching lengths, possible
    /// positions.
    ///
    /// # Errors
    /// [`FileError::Invalid`] with what is wrong and where.
    pub fn check(&self) -> Result<(), FileError> {
        match self {
            Self::PlanePoints(points) => points.check(),
            Self::Tangents(_) => Ok(()),
            Self::Fourier(fourier) => fourier.check(),
            Self::SpacePoints(points) => points.check(),
            Self::Net(net) => net.check(),
            Self::BeadWheel(wheel) => wheel.check(),
            Self::CsangoCube(cube) => cube.check(),
            Self::Billiards(game) => game.check().map_err(|error| FileError::Invalid(error.to_string())),
            Self::Ec(document) => document.check(),
            Self::Rational(spans) => spans.check(),
            Self::Patches(patches) => patches.check(),
            Self::Knots(knots) => knots.check(),
            Self::KnotNet(net) => net.check(),
            Self::Shaped(shaped) => shaped.check(),
            Self::Som(net) => net.check(),
            Self::Circles(circles) => circles.check(),
            Self::Spheres(spheres) => spheres.check(),
            Self::Cloud(cloud) => cloud.check(),
        }
    }

    /// Facts about the document, one a line: what it is and how many, the box around it, all values.
    #[must_use]
    pub fn describe(&self) -> Vec<String> {
        match self {
            Self::PlanePoints(points) => points.describe(),
            Self::Tangents(tangents) => tangents.describe(),
            Self::Fourier(fourier) => fourier.describe(),
            Self::SpacePoints(points) => points.describe(),
            Self::Net(net) => net.describe(),
            Self::BeadWheel(wheel) => wheel.describe(),
            Self::CsangoCube(cube) => cube.describe(),
            Self::Billiards(game) => billiards::describe(game),
            Self::Ec(document) => document.describe(),
            Self::Rational(spans) => spans.describe(),
            Self::Patches(patches) => patches.describe(),
            Self::Knots(knots) => knots.describe(),
            Self::KnotNet(net) => net.describe(),
            Self::Shaped(shaped) => shaped.describe(),
            Self::Som(net) => net.describe(),
            Self::Circles(circles) => circles.describe(),
            Self::Spheres(spheres) => spheres.describe(),
            Self::Cloud(cloud) => cloud.describe(),
        }
    }

    /// The names of the settings that it has: what JSON remembers, and no DOS file.
    #[must_use]
    pub fn settings(&self) -> Vec<String> {
        match self {
            Self::PlanePoints(points) => settings::given(&points.settings),
            Self::SpacePoints(points) => settings::given(&points.settings),
            Self::Net(net) => settings::given(&net.settings),
            _ => Vec::new(),
        }
    }

    /// The document without the settings that no DOS file holds.
    #[must_use]
    pub fn without_settings(mut self) -> Self {
        match &mut self {
            Self::PlanePoints(points) => points.settings = Default::default(),
            Self::SpacePoints(points) => points.settings = Default::default(),
            // Whether a net is that of two patches is no way of drawing it.
            Self::Net(net) => {
                net.settings = NetSettings { joint: net.settings.joint, ..NetSettings::default() };
            }
            _ => {}
        }
        self
    }
}
