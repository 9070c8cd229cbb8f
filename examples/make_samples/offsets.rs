//! The samples of PH_GORBE: a cam, a bay, an arc of Tschirnhausen's cubic, a screw.

use grafika::file::{CurveSettings, Document, FileError, FileKind, Format, Method, PlanePoints, SpacePoints};

/// Every file: its name and its bytes.
pub(crate) fn samples() -> Result<Vec<(&'static str, Vec<u8>)>, FileError> {
    let cam = [(430, 190), (395, 290), (290, 330), (190, 300), (150, 200), (185, 105), (270, 60), (350, 85)];
    let bay = [(60, 120), (150, 300), (250, 170), (330, 110), (420, 190), (500, 320)];
    let points = |points: &[(i32, i32)]| {
        let points = points.iter().map(|&(x, y)| [f64::from(x), f64::from(y)]).collect();
        Document::PlanePoints(PlanePoints::new(points))
    };
    let arc = PlanePoints {
        tangents: Some(vec![[150.0, -225.0], [150.0, 225.0]]),
        ..PlanePoints::new(vec![[200.0, 300.0], [360.0, 300.0]])
    };
    let arc = Document::PlanePoints(arc);
    Ok(vec![
        ("K.IP2", points(&cam).write(Format::Ip2)?),
        ("O.IP2", points(&bay).write(Format::Ip2)?),
        ("T.IC2", arc.write(Format::Ic2)?),
        ("T.EC2", arc.write(Format::Ec2)?),
        ("H.IP3", Document::SpacePoints(SpacePoints::new(SCREW.to_vec())).write(Format::Ip3)?),
        ("H.JSON", screw().encode(FileKind::Json)?),
    ])
}

/// Half a turn of a screw.
const SCREW: [[f64; 3]; 3] = [[100.0, 0.0, 0.0], [0.0, 100.0, 50.0], [-100.0, 0.0, 100.0]];

/// The screw with its tangents, which the DOS format cannot hold.
fn screw() -> Document {
    let tangents = vec![[0.0, 150.0, 50.0], [-150.0, 0.0, 50.0], [0.0, -150.0, 50.0]];
    Document::SpacePoints(SpacePoints {
        tangents: Some(tangents),
        settings: CurveSettings { method: Some(Method::PhHermite), ..CurveSettings::default() },
        ..SpacePoints::new(SCREW.to_vec())
    })
}
